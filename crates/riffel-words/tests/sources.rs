//! The catalogue against the sources that speak.

use std::fs;
use std::path::{Path, PathBuf};

use riffel_case::{Badge, presets};
use riffel_rail::LimitTable;
use riffel_words::{in_german, wordings};

/// Files of which every sentence must have its German. Paths in `crates`; a folder stands for all of its files.
const WHOLE: &[&str] = &[
    "riffel/src",
    "riffel-answers/src/diagnose/finding.rs",
    "riffel-answers/src/forecast/mod.rs",
    "riffel-answers/src/forecast/wear_report.rs",
    "riffel-answers/src/noise/course.rs",
    "riffel-answers/src/noise/measure.rs",
    "riffel-answers/src/roughness/verdict.rs",
    "riffel-keys/src",
    "riffel-network/src",
    "riffel-plot/src",
    "riffel-rail/src",
    "riffel-study/src",
    "riffel-web/src",
];

/// Files in folders of [`WHOLE`] that say nothing to people, or say it in both languages themselves.
const SILENT: &[&str] = &[
    // Where the ends of ranges come from: for the documentation.
    "riffel-keys/src/range/table.rs",
    // Has the German of its sentences itself, and short wordings that German does without.
    "riffel-keys/src/sentence.rs",
];

/// What has no German there, and why.
const LEFT: &[&str] = &[
    // Of headers and policies, for browsers.
    "max-age",
    "// What Riffel says",
    "default-src",
    "text/",
    "camera=()",
    "a request must be JSON",
    "send the header",
    "only the page itself may ask",
    "the header Origin",
    "this page is not served",
    "there is nothing here",
    "open it by the address",
    "a request about a file must say",
    // Defects, told in English to those who mend them.
    "cannot be run",
    "is not known",
    "cannot be written",
    "cannot be stored",
    "cannot be drawn",
    "cannot be read",
    "is too long",
    "there is no place",
    "there is no table of blocks",
    "there is no report",
    "printed something else",
    "there is no such nominal profile",
    "tiles of a map",
    "{next} after {last} at step",
    // Said on the command line that starts the page.
    "cannot listen on",
    "cannot make a private",
    "cannot start the server",
    "the paper has no figure",
    // Words of another reader, which are put into our own.
    "missing field",
    "unknown field",
    "unknown variant",
    "expected struct",
    "expected a sequence",
    "invalid type",
    "invalid value",
    // Sources of nominal profiles.
    "Wheel of EN",
    "Cone of 1:40",
    "Rail of BS",
    // Descriptions of arrays in a store, for those who open it with other programs.
    "why the sample has no results",
    "speed of the vehicle",
    "wavelength of the corrugation",
    "over a wave of",
    "first harmonic of the normal force",
    "least normal force",
    "largest normal force",
    "share of the time without contact",
    "mean creepage along the rail",
    "mean energy dissipated",
    "amplitude of the wave",
    " worn by {passages}",
    "of a cell along the line",
    "in the logarithm of wavelength",
    "wavelength of the band",
    "RMS of roughness in a band",
    "that the strongest branch of the ridge follows",
    "highest growth",
    "sits at an end of the window",
    "growth rate per passage",
    "growth where its real part is negative",
    // Layouts and drawing.
    "body{margin",
    "panels stacked",
    "{said:?}",
    "the drawing library failed",
    // Files that the page writes for the program.
    "the curve of the page",
    "title = ",
    "contact.friction={",
    "standard_deviation",
];

/// Heading of the section of the catalogue whose English is that of the TOML reader and of the system.
const OF_OTHERS: &str = "# Words of the TOML reader and of the system";

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
        let calls = [".expect(", "unreachable!(", "panic!("];
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
                        text.push(if letters[at] == 'n' { ' ' } else { letters[at] });
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

/// The same, with what stands in quotation marks or code and numbers as values: `must lie between 8 and 2048` says what
/// `must lie between {low} and {high}` does.
fn between_any_values(words: &str) -> Vec<String> {
    let mut pieces = vec![String::new()];
    let mut quoted = None;
    for word in words.split_inclusive(' ') {
        let bare = word.trim_matches(|c: char| ", ;:.()".contains(c));
        let is_number = bare.parse::<f64>().is_ok();
        if is_number && quoted.is_none() {
            pieces.push(String::new());
            continue;
        }
        for letter in word.chars() {
            let last = pieces.last_mut().expect("there is a piece");
            match (letter, quoted) {
                ('"' | '`', None) => {
                    quoted = Some(letter);
                    last.push(letter);
                }
                (mark, Some(open)) if mark == open => {
                    quoted = None;
                    pieces.push(mark.to_string());
                }
                (_, Some(_)) => {}
                (letter, None) => last.push(letter),
            }
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

fn english() -> Vec<&'static str> {
    wordings().map(|(english, _)| english).collect()
}

#[test]
fn no_sentence_of_the_page_lacks_its_german() {
    let catalogue = english();
    let mut sources = Vec::new();
    WHOLE
        .iter()
        .for_each(|path| files(&crates().join(path), &mut sources));
    sources.retain(|source| !SILENT.iter().any(|silent| source.ends_with(silent)));
    let mut missing = Vec::new();
    for source in &sources {
        for text in texts(&fs::read_to_string(source).unwrap()) {
            let known = |words: &str| {
                let words = words.trim_matches(|c: char| c.is_whitespace() || ".,;:()".contains(c));
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
            let lacks = between_values(&text)
                .filter(|words| is_said(words) && !known(words))
                .flat_map(between_any_values)
                .any(|words| is_said(&words) && !known(&words));
            if lacks && !LEFT.iter().any(|left| text.contains(left)) {
                missing.push(format!("{}: {text}", source.display()));
            }
        }
    }
    assert!(missing.is_empty(), "no German of\n{}", missing.join("\n"));
}

#[test]
fn no_sentence_is_left_that_nobody_says() {
    let mut sources = Vec::new();
    let all = fs::read_dir(crates())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    all.filter(|path| !path.ends_with("riffel-words"))
        .for_each(|path| files(&path.join("src"), &mut sources));
    let mut said = String::new();
    for source in &sources {
        for text in texts(&fs::read_to_string(source).unwrap()) {
            between_values(&text).for_each(|words| said.extend([words, "\n"]));
        }
    }
    said += &fs::read_to_string(crates().join("riffel-web/assets/faults.js")).unwrap();
    for preset in presets() {
        let sources = preset.values.iter().map(|value| value.source.as_str());
        sources
            .chain([preset.title.as_str()])
            .for_each(|text| said.extend([text, "\n"]));
    }
    LimitTable::all()
        .iter()
        .for_each(|table| said.extend([table.title.as_str(), "\n"]));
    // What a key is stands in the comment on it.
    for source in sources.iter().filter(|source| {
        source
            .parent()
            .is_some_and(|folder| folder.ends_with("riffel-case/src/file"))
    }) {
        let text = fs::read_to_string(source).unwrap();
        let comments = text
            .lines()
            .filter_map(|line| line.trim_start().strip_prefix("/// "));
        said.extend(comments.map(|line| line.replace('\\', "") + " "));
    }
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
    let catalogue = fs::read_to_string(crates().join("riffel-words/src/german.txt")).unwrap();
    let (_, others) = catalogue.split_once(OF_OTHERS).unwrap();
    let others = others.split("\n# ").next().unwrap();
    let is_of_others = |wording: &str| others.contains(&format!("\n\n{wording}\n"));
    let unsaid: Vec<&str> = english()
        .into_iter()
        .filter(|wording| !is_said(wording) && !is_of_others(wording))
        .collect();
    assert!(unsaid.is_empty(), "nobody says\n{}", unsaid.join("\n"));
}

/// Values that others have published name who did, and stay as they are.
#[test]
fn presets_have_their_german() {
    let mut missing = Vec::new();
    for preset in presets() {
        let own = preset
            .values
            .iter()
            .filter(|value| value.badge == Badge::Assumed)
            .map(|value| value.source.as_str());
        let words = own.chain([preset.title.as_str()]);
        missing.extend(words.filter(|words| in_german(words).is_none()));
    }
    let limits = LimitTable::all();
    let titles = limits.iter().map(|table| table.title.as_str());
    missing.extend(titles.filter(|title| in_german(title).is_none()));
    assert!(missing.is_empty(), "no German of\n{}", missing.join("\n"));
}
