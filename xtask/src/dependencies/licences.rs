//! The licences of what a binary is made of, as one text to give along with it.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

use cargo_metadata::Package;
use spdx::{Expression, ParseMode};

use super::built_of;

/// How files with the terms of a package begin, in capitals.
const BEGINNINGS: [&str; 5] = ["LICENSE", "LICENCE", "COPYING", "UNLICENSE", "NOTICE"];

/// The licences of all packages of others that `package` of the workspace is made of on a system.
///
/// The text of each is that of its own files; where a package brings none, it is that of SPDX.
pub(crate) fn third_party_licences(package: &str, target: &str) -> Result<String, String> {
    let packages = built_of(&["--package", package, "--target", target])?;
    let mut text = String::from(
        "Riffel is made of the packages below and of Rust's standard library (MIT OR Apache-2.0).\n\
         Their licences follow; a text stands once for all packages that bring it.\n\n",
    );
    let mut owners: BTreeMap<String, (String, Vec<String>)> = BTreeMap::new();
    for package in &packages {
        let name = format!("{} {}", package.name, package.version);
        let licence = package.license.as_deref().unwrap_or_default();
        let _ = writeln!(text, "{name}: {licence}");
        for terms in terms(package)? {
            // Lines are broken and indented in many ways.
            let words: Vec<_> = terms.split_whitespace().collect();
            let (_, names) = owners.entry(words.join(" ")).or_insert((terms, Vec::new()));
            names.push(name.clone());
        }
    }
    let mut texts: Vec<_> = owners.into_values().map(|(text, names)| (names, text)).collect();
    texts.sort();
    for (names, terms) in texts {
        let line = "─".repeat(80);
        let _ = write!(text, "\n{line}\n{}\n{line}\n\n{}\n", names.join(", "), terms.trim_end());
    }
    Ok(text)
}

/// The texts that a package comes under.
fn terms(package: &Package) -> Result<Vec<String>, String> {
    let folder = package.manifest_path.parent().ok_or("a manifest without folder")?;
    let failed = |error| format!("cannot read {folder}: {error}");
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let name = entry.file_name().to_string_lossy().to_uppercase();
        let is_file = entry.file_type().map_err(failed)?.is_file();
        if is_file && BEGINNINGS.iter().any(|beginning| name.starts_with(beginning)) {
            paths.push(entry.path());
        }
    }
    paths.sort();
    if paths.is_empty() {
        return of_spdx(package);
    }
    let read = |path| fs::read(path).map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    paths.into_iter().map(|path| read(path).map_err(failed)).collect()
}

/// The texts of the licences that a package states, for one that brings none.
fn of_spdx(package: &Package) -> Result<Vec<String>, String> {
    let sentence = |what: String| format!("{} {} {what}", package.name, package.version);
    let stated = package.license.as_ref();
    let stated = stated.ok_or_else(|| sentence("states no licence".to_owned()))?;
    // Of old, `/` stands for `OR`.
    let licence = Expression::parse_mode(stated, ParseMode::LAX)
        .map_err(|error| sentence(format!("states no licence that is known: {}", error.reason)))?;
    let by = match package.authors.is_empty() {
        true => String::new(),
        false => format!(" by {}", package.authors.join(", ")),
    };
    let ids = licence.requirements().filter_map(|asked| asked.req.license.id());
    Ok(ids
        .map(|id| {
            let head = format!("{}{by} brings no text of its own; that of {} reads:", package.name, id.full_name);
            format!("{head}\n\n{}", id.text())
        })
        .collect())
}
