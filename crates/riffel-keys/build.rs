//! A struct for each message of `messages/en.ftl`, with a field for each of its values: what [`say!`] fills in.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

const ENGLISH: &str = "messages/en.ftl";

fn main() {
    println!("cargo::rerun-if-changed={ENGLISH}");
    let english = fs::read_to_string(ENGLISH).expect("the English messages are part of the crate");
    let mut code = String::new();
    // What the page says by itself is said by its scripts.
    for entry in entries(&english).iter().filter(|entry| !entry.starts_with("web-")) {
        write_struct(&mut code, entry).expect("a string takes everything");
    }
    let folder = env::var_os("OUT_DIR").expect("cargo sets it");
    fs::write(Path::new(&folder).join("wording.rs"), code).expect("cargo's folder can be written");
}

/// Messages with their indented lines; comments and empty lines are left out.
fn entries(english: &str) -> Vec<String> {
    let mut entries: Vec<String> = Vec::new();
    for line in english.lines() {
        match entries.last_mut() {
            _ if line.is_empty() || line.starts_with('#') => {}
            Some(entry) if line.starts_with(' ') => {
                entry.push('\n');
                entry.push_str(line);
            }
            _ => entries.push(line.to_owned()),
        }
    }
    entries
}

fn write_struct(code: &mut String, entry: &str) -> std::fmt::Result {
    let (id, text) = entry.split_once(" = ").expect("a message is `id = text`");
    let name = id.replace('-', "_");
    let values: BTreeSet<&str> = entry
        .match_indices('$')
        .map(|(at, _)| {
            let rest = &entry[at + 1..];
            let end = rest.find(|c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'));
            &rest[..end.unwrap_or(rest.len())]
        })
        .collect();
    // As code: brackets in it are no links.
    let first_line = format!("`` {} ``", text.lines().next().unwrap_or_default());
    writeln!(code, "#[doc = {first_line:?}]\npub struct {name} {{")?;
    for value in &values {
        writeln!(code, "    #[doc = \"The value.\"]\n    pub {value}: Value,")?;
    }
    writeln!(code, "}}\nimpl From<{name}> for Message {{")?;
    let unused = if values.is_empty() { "_" } else { "" };
    writeln!(code, "    fn from({unused}values: {name}) -> Self {{")?;
    write!(code, "        Self::new({id:?}, vec![")?;
    for value in &values {
        write!(code, "({value:?}, values.{value}), ")?;
    }
    writeln!(code, "])\n    }}\n}}")
}
