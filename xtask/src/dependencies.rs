//! The packages that Riffel is built of: whether `deny.toml` allows them, and the text of their licences.

mod licences;

use std::collections::BTreeSet;
use std::path::Path;

use cargo_metadata::{MetadataCommand, Package};

use crate::step::{cargo, run};
use crate::{Outcome, output, root};

pub(crate) use licences::third_party_licences;

/// The packages of others that are built with the features in use, by name and version: tests apart, and what runs
/// while building included.
///
/// `selection` says of what and for which system, as arguments of `cargo tree`.
fn built_of(selection: &[&str]) -> Result<Vec<Package>, String> {
    let tree = ["tree", "--locked", "--edges", "normal,build", "--prefix", "none"];
    let lines = ["--format", "{p}"];
    let tree = output(Path::new(env!("CARGO")), &[&tree[..], &lines, selection].concat())?;
    let tree = String::from_utf8_lossy(&tree);
    // "name v1.2.3 (proc-macro)"
    let built: BTreeSet<_> = tree
        .lines()
        .filter_map(|line| line.split_once(" v"))
        .filter_map(|(name, rest)| Some((name, rest.split(' ').next()?)))
        .collect();
    // The tree knows the features in use; the metadata, which does not, knows folders and sources.
    let metadata = MetadataCommand::new()
        .cargo_path(env!("CARGO"))
        .current_dir(root())
        .other_options(["--locked".to_owned()])
        .exec()
        .map_err(|error| format!("cargo metadata failed: {error}"))?;
    let mut packages = metadata.packages;
    packages.retain(|package| {
        let version = package.version.to_string();
        package.source.is_some() && built.contains(&(package.name.as_str(), version.as_str()))
    });
    packages.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
    Ok(packages)
}

/// Hold what the workspace is built of against `deny.toml`, where cargo-deny is installed; advisories, which ask for a
/// network, are left to CI.
pub(crate) fn check() -> Outcome {
    let deny = |arguments: &[&str]| cargo(&[&["deny"], arguments].concat());
    let installed = deny(&["--version"]).output();
    if installed.is_ok_and(|output| output.status.success()) {
        return run(&mut deny(&["--offline", "check", "licenses", "bans", "sources"]));
    }
    println!("# deny.toml is not checked: `cargo install --locked cargo-deny` installs what does");
    Ok(())
}
