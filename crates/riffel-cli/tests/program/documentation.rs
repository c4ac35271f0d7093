//! Every command that README, book and `tests/commands` show is run, and its output compared.
//!
//! A `console` block holds command lines after `$ ` and what they print; `? N` after the output is an
//! exit status other than 0; `...` alone on a line stands for any lines, `[..]` for any text.
//! A `toml` block that is a whole case is read as one.
//! `UPDATE_DOCUMENTATION=1 cargo test` writes the present output into files whose blocks differ.

use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use crate::sandbox::{Sandbox, root};

/// README, book and the pages that exist only to be tested.
fn pages() -> Vec<PathBuf> {
    let mut pages = vec![root().join("README.md")];
    for folder in ["docs/src", "crates/riffel-cli/tests/commands"] {
        for entry in fs::read_dir(root().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "md") {
                pages.push(path);
            }
        }
    }
    pages.sort();
    pages
}

/// One command line with the output that the page shows.
struct Example {
    command: String,
    shown: String,
}

/// The examples of a `console` block.
fn examples(block: &str) -> Vec<Example> {
    let mut examples: Vec<Example> = Vec::new();
    for line in block.lines() {
        match (line.strip_prefix("$ "), examples.last_mut()) {
            (Some(command), _) => examples.push(Example { command: command.to_owned(), shown: String::new() }),
            (None, Some(example)) => {
                example.shown.push_str(line);
                example.shown.push('\n');
            }
            (None, None) => panic!("a console block begins with a command: {line}"),
        }
    }
    examples
}

/// Arguments for the program; the README calls it through cargo.
fn arguments(command: &str) -> Option<&str> {
    command.strip_prefix("riffel ").or_else(|| command.strip_prefix("cargo run --release -- "))
}

/// Run the examples of a block and return the block with what they print now.
fn run(sandbox: &Sandbox, block: &str, page: &Path) -> String {
    let mut written = String::new();
    for Example { command, shown } in examples(block) {
        written.push_str(&format!("$ {command}\n"));
        let Some(arguments) = arguments(&command) else {
            assert_eq!(command, "cargo xtask test", "{} shows a command no test runs", page.display());
            written.push_str(&shown);
            continue;
        };
        let outcome = sandbox.riffel(arguments);
        let mut printed = outcome.text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        printed = format!("{}\n", printed.trim_end());
        if outcome.status != Some(0) {
            printed.push_str(&format!("? {}\n", outcome.status.unwrap_or(-1)));
        }
        let pattern = format!("{}\n", shown.trim_end());
        written.push_str(&match is_shown_by(&printed, &pattern) {
            true => shown,
            false => keep_open_places(&shown, &printed),
        });
    }
    written
}

/// Whether a page shows what is printed, by its `...` and `[..]`.
fn is_shown_by(printed: &str, pattern: &str) -> bool {
    snapbox::Assert::new()
        .action_env("SNAPBOX_DOCUMENTATION")
        .try_eq(None, printed.to_owned().into(), pattern.to_owned().into())
        .is_ok()
}

/// Printed lines, with those of the page in place of the ones that its `[..]` stand for.
fn keep_open_places(shown: &str, printed: &str) -> String {
    let open: Vec<&str> = shown.lines().filter(|line| line.contains("[..]")).collect();
    let kept = printed.lines().map(|line| {
        let pattern = open.iter().find(|pattern| is_shown_by(line, pattern));
        format!("{}\n", pattern.copied().unwrap_or(line))
    });
    kept.collect()
}

#[test]
fn an_update_keeps_what_a_page_leaves_open() {
    assert_eq!(
        keep_open_places(
            "old 1\n1024 samples in [..], [..] a second\n",
            "new 2\n1024 samples in 4.3 s, 240 a second\n1024 other\n"
        ),
        "new 2\n1024 samples in [..], [..] a second\n1024 other\n"
    );
}

// Long: runs every command that README and book show.
#[test]
fn every_command_of_the_documentation_prints_what_is_shown() {
    // Threads that wait for programs are not those on which other tests compute.
    let pool = rayon::ThreadPoolBuilder::new().build().unwrap();
    let stale: Vec<String> = pool.install(|| pages().into_par_iter().filter_map(|page| stale(&page)).collect());
    assert!(stale.is_empty(), "these pages show old output:\n{}", stale.join("\n\n"));
}

/// Where a page shows old output; or the page is written anew.
fn stale(page: &Path) -> Option<String> {
    let text = fs::read_to_string(page).unwrap();
    let sandbox = Sandbox::named(&page.file_stem().unwrap().to_string_lossy());
    sandbox.copy("validation/reference/sbb-track-noise");
    let mut written = String::new();
    let mut rest = text.as_str();
    while let Some((before, after)) = rest.split_once("```console\n") {
        let (block, after) = after.split_once("```").unwrap();
        written.push_str(before);
        written.push_str("```console\n");
        written.push_str(&run(&sandbox, block, page));
        written.push_str("```");
        rest = after;
    }
    written.push_str(rest);
    if written == text {
        return None;
    }
    if std::env::var_os("UPDATE_DOCUMENTATION").is_some() {
        fs::write(page, &written).unwrap();
        return None;
    }
    let (place, (shown, printed)) = text
        .lines()
        .zip(written.lines())
        .enumerate()
        .find(|(_, (shown, printed))| shown != printed)
        .unwrap_or((text.lines().count(), ("", "")));
    let (page, line) = (page.display(), place + 1);
    Some(format!("{page}:{line}\nshown:   {shown}\nprinted: {printed}"))
}

#[test]
fn every_whole_case_of_the_documentation_is_valid() {
    let mut read = 0;
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        for block in text.split("```toml\n").skip(1) {
            let (block, _) = block.split_once("```").unwrap();
            if block.contains("[contact]") && block.contains("[wheel]") && block.contains("[track]") {
                let name = page.display().to_string();
                if let Err(error) = riffel_case::Case::parse(&name, block, &[]) {
                    panic!("{name}: {error}");
                }
                read += 1;
            }
        }
    }
    assert!(read > 0, "the book shows no whole case");
}
