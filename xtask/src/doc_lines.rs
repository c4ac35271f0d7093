//! Doc lines that stand alone.

use std::fs;

use crate::release::walk;
use crate::root;

/// Folders with Rust of the project.
const FOLDERS: [&str; 4] = ["benches", "crates", "validation", "xtask"];
/// Beginnings that lean on the item before.
const BEGINNINGS: [&str; 3] = ["The same", "Those of", "As "];

/// Whether a doc line begins with a noun or a verb of its own, and says `None` if there is nothing.
fn stands_alone(line: &str) -> bool {
    let Some(doc) = line.trim_start().strip_prefix("/// ") else { return true };
    !BEGINNINGS.iter().any(|beginning| doc.starts_with(beginning)) && !doc.to_lowercase().contains("none where")
}

#[test]
fn every_doc_line_stands_alone() {
    let mut paths = Vec::new();
    for folder in FOLDERS {
        walk(&root().join(folder), &mut paths).unwrap();
    }
    let sources = paths.iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    let leaning = sources.flat_map(|path| {
        let text = fs::read_to_string(path).unwrap();
        let lines = text.lines().enumerate().filter(|(_, line)| !stands_alone(line));
        lines.map(|(index, line)| format!("{}:{}: {}", path.display(), index + 1, line.trim())).collect::<Vec<_>>()
    });
    assert_eq!(leaning.collect::<Vec<_>>(), [""; 0], "name the subject, and write `None` if …");
}

#[test]
fn a_line_that_leans_on_another_is_found() {
    for line in [
        "/// The same at rest.",
        "    /// Those of a rail.",
        "/// As `new`.",
        "/// Its limit; none where there is no table.",
    ] {
        assert!(!stands_alone(line), "{line}");
    }
    for line in ["/// Limit of a rail; `None` if there is no table.", "// The same at rest.", "let the = \"same\";"] {
        assert!(stands_alone(line), "{line}");
    }
}
