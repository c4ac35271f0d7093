//! The catalogue against the sources that speak.

mod lists;

use std::fs;
use std::path::{Path, PathBuf};

use riffel_case::descriptions;
use riffel_keys::Language;
use riffel_words::wordings;

use lists::{IN_ENGLISH, LEFT, WITHOUT};

const FILE: &str = include_str!("../../src/german.txt");

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Whether a file holds tests alone: `tests.rs`, `tests_of_vehicles.rs`, `tests/mod.rs`.
fn is_test(path: &Path) -> bool {
    let name = |path: &Path| {
        let stem = path.file_stem().unwrap_or_default();
        let stem = stem.to_str().unwrap_or_default();
        stem == "tests" || stem.starts_with("tests_") || stem.ends_with("_tests")
    };
    name(path) || path.parent().is_some_and(name)
}

/// All Rust files below a path.
fn files(path: &Path, found: &mut Vec<PathBuf>) {
    if path.is_dir() {
        let entries = fs::read_dir(path).unwrap();
        let mut entries: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        entries.sort();
        entries.iter().for_each(|entry| files(entry, found));
    } else if path.extension().is_some_and(|end| end == "rs") && !is_test(path) {
        found.push(path.to_owned());
    }
}

/// The source files of all crates but some.
fn sources(without: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let all = fs::read_dir(crates())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    all.filter(|path| !without.iter().any(|without| path.ends_with(without)))
        .for_each(|path| files(&path.join("src"), &mut found));
    found
}

/// The texts of a source file, its tests aside.
fn texts(source: &str) -> Vec<String> {
    let source = source.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = source
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let letters: Vec<char> = lines.flat_map(|line| line.chars().chain(['\n'])).collect();
    // What only those who mend a defect see.
    let told = |at: usize| {
        let before: String = letters[at.saturating_sub(20)..at].iter().collect();
        let call = before.trim_end();
        let calls = [".expect(", "unreachable!(", "panic!(", "reason ="];
        !calls.iter().any(|end| call.ends_with(end))
    };
    let (mut found, mut at) = (Vec::new(), 0);
    while at < letters.len() {
        match letters[at] {
            '\'' if letters.get(at + 2) == Some(&'\'') => at += 3,
            '"' => {
                let mut text = String::new();
                let is_told = told(at);
                at += 1;
                while letters[at] != '"' {
                    if letters[at] != '\\' {
                        text.push(letters[at]);
                    } else if letters[at + 1] == '\n' {
                        at += 1;
                        while letters[at + 1].is_whitespace() {
                            at += 1;
                        }
                    } else {
                        at += 1;
                        text.push(match letters[at] {
                            // Lines are said one by one.
                            'n' => '\n',
                            'u' => {
                                let end = letters[at..].iter().position(|&c| c == '}').unwrap();
                                let digits: String = letters[at + 2..at + end].iter().collect();
                                at += end;
                                char::from_u32(u32::from_str_radix(&digits, 16).unwrap()).unwrap()
                            }
                            letter => letter,
                        });
                    }
                    at += 1;
                }
                if is_told {
                    found.push(text);
                }
                at += 1;
            }
            _ => at += 1,
        }
    }
    found
}

/// What stands between the values of a wording.
fn between_values(wording: &str) -> impl Iterator<Item = &str> {
    wording
        .split('{')
        .enumerate()
        .map(|(k, part)| match (k, part.split_once('}')) {
            (1.., Some((_, words))) => words,
            _ => part,
        })
}

/// The parts of a text that the catalogue may have in wordings of their own: what stands between values, quotation marks and
/// markup, lines and sentences; a rule and what it is of.
fn parts(text: &str) -> Vec<&str> {
    const JOINTS: [&str; 6] = [
        "note: ",
        "warning: ",
        "next: ",
        "but must be ",
        "left out: ",
        ". ",
    ];
    let marks = ['"', '`', '<', '>', '\n'];
    let mut parts: Vec<&str> = between_values(text)
        .flat_map(|words| words.split(marks))
        .collect();
    for joint in JOINTS {
        parts = parts.iter().flat_map(|words| words.split(joint)).collect();
    }
    parts
}

/// What stands between numbers: `must lie between 8 and 2048` says what `must lie between {low} and {high}` does.
fn between_numbers(words: &str) -> Vec<String> {
    let mut pieces = vec![String::new()];
    for word in words.split_inclusive(' ') {
        let bare = word.trim_matches(|c: char| ", ;:.()".contains(c));
        match bare.parse::<f64>() {
            Ok(_) => pieces.push(String::new()),
            Err(_) => pieces.last_mut().expect("there is a piece").push_str(word),
        }
    }
    pieces
}

/// Of several words in small letters: a sentence or a part of one.
fn is_said(words: &str) -> bool {
    let is_word = |word: &&str| word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase());
    let punctuation = |c: char| matches!(c, ',' | '.' | ':' | ';' | '(' | ')' | '"');
    words
        .split(' ')
        .map(|word| word.trim_matches(punctuation))
        .filter(is_word)
        .count()
        >= 2
}

/// A remark has both languages where it is made.
fn is_german(text: &str) -> bool {
    const ITS_WORDS: [&str; 13] = [
        "als", "den", "der", "die", "das", "ihrer", "inneren,", "ist", "quer", "sind", "stehen",
        "und", "zum",
    ];
    text.split(' ').any(|word| ITS_WORDS.contains(&word)) || text.contains(['ä', 'ö', 'ü', 'ß'])
}

fn english() -> Vec<&'static str> {
    wordings().map(|(english, _)| english).collect()
}

#[test]
fn no_sentence_lacks_its_german() {
    let keys = descriptions(Language::German);
    let catalogue: Vec<&str> = english()
        .into_iter()
        .chain(keys.keys().map(|key| &**key))
        .collect();
    let mut sources = sources(&WITHOUT);
    let in_english: Vec<PathBuf> = IN_ENGLISH.iter().map(|path| crates().join(path)).collect();
    sources.retain(|source| !in_english.iter().any(|path| source.starts_with(path)));
    let mut missing = Vec::new();
    for source in &sources {
        for text in texts(&fs::read_to_string(source).unwrap()) {
            let known = |words: &str| {
                let words =
                    words.trim_matches(|c: char| c.is_whitespace() || ".,;:()}".contains(c));
                let small = words
                    .chars()
                    .take(1)
                    .flat_map(char::to_lowercase)
                    .chain(words.chars().skip(1))
                    .collect::<String>();
                catalogue.iter().any(|wording| {
                    between_values(wording)
                        .any(|part| part.contains(words) || part.contains(&small))
                })
            };
            let lacks = parts(&text)
                .into_iter()
                .filter(|words| is_said(words) && !known(words))
                .flat_map(between_numbers)
                .any(|words| is_said(&words) && !known(&words));
            let mut left = LEFT
                .iter()
                .filter(|(file, _)| source.ends_with(file))
                .flat_map(|(_, texts)| *texts);
            if lacks && !is_german(&text) && !left.any(|left| text.contains(left)) {
                missing.push(format!("{}: {text}", source.display()));
            }
        }
    }
    assert!(missing.is_empty(), "no German of\n{}", missing.join("\n"));
}

#[test]
fn no_sentence_is_left_that_nobody_says() {
    let sources = sources(&WITHOUT[..1]);
    let mut said = String::new();
    for source in &sources {
        for text in texts(&fs::read_to_string(source).unwrap()) {
            between_values(&text).for_each(|words| said.extend([words, "\n"]));
        }
    }
    said += &fs::read_to_string(crates().join("riffel-web/assets/faults.js")).unwrap();
    said += &fs::read_to_string(crates().join("riffel-keys/messages/en.ftl")).unwrap();
    // What others say is no concern of the sources.
    let others = FILE
        .split("\n# ")
        .filter(|section| section.starts_with("What others say"));
    others.for_each(|section| said += section);
    // A long sentence may be put together of parts: of its pairs of words a third must stand somewhere. Of a short one each word.
    let is_said = |wording: &str| {
        let is_word = |word: &&str| {
            word.chars()
                .all(|c| c.is_alphabetic() || ",.:;".contains(c))
        };
        let parts: Vec<Vec<&str>> = between_values(wording)
            .map(|part| part.split_whitespace().filter(is_word).collect())
            .collect();
        let pairs: Vec<String> = parts
            .iter()
            .flat_map(|words| words.windows(2))
            .map(|pair| pair.join(" "))
            .collect();
        let said_pairs = pairs
            .iter()
            .filter(|pair| said.contains(pair.as_str()))
            .count();
        match pairs.len() {
            ..4 => parts
                .iter()
                .flatten()
                .all(|word| said.contains(word.trim_end_matches([':', ',', '.', ';']))),
            count => 3 * said_pairs >= count,
        }
    };
    let unsaid: Vec<&str> = english()
        .into_iter()
        .filter(|wording| !is_said(wording))
        .collect();
    assert!(unsaid.is_empty(), "nobody says\n{}", unsaid.join("\n"));
}
