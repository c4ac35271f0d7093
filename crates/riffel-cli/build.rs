//! The version that `riffel --version` prints: with the commit and its date where they are known.

use std::path::Path;
use std::process::Command;

fn main() {
    let version = env!("CARGO_PKG_VERSION");
    println!("cargo::rerun-if-changed=build.rs");
    let long = match commit() {
        Some(commit) => format!("{version} ({commit})"),
        None => version.to_owned(),
    };
    println!("cargo::rustc-env=RIFFEL_VERSION={long}");
}

/// Commit and date, as in `1a2b3c4d5 2026-01-31`; `None` if this is no checkout of the project or git is not there.
fn commit() -> Option<String> {
    // A published package may lie in the repository of somebody else, whose commit says nothing.
    if Path::new(".cargo_vcs_info.json").exists() {
        return None;
    }
    git(&["ls-files", "--error-unmatch", "build.rs"])?;
    // Written by every commit and every change of branch, and by nothing else.
    let log = git(&["rev-parse", "--git-path", "logs/HEAD"])?;
    if Path::new(&log).exists() {
        println!("cargo::rerun-if-changed={log}");
    }
    git(&["show", "--no-patch", "--format=%h %cs", "--abbrev=9", "HEAD"])
}

/// What git prints, if it succeeds and prints anything.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    (output.status.success() && !text.is_empty()).then_some(text)
}
