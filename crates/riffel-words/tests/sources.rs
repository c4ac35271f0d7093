//! The catalogue against the sources that speak.

use std::fs;
use std::path::{Path, PathBuf};

use riffel_case::{Badge, presets};
use riffel_rail::LimitTable;
use riffel_words::{in_german, wordings};

const FILE: &str = include_str!("../src/german.txt");

/// Files of which every sentence must have its German: what the page says of a measured rail and of a case. Paths in
/// `crates`; a folder stands for all of its files.
const WHOLE: &[&str] = &[
    "riffel/src/diagnosis",
    "riffel-answers/src",
    "riffel-case/src",
    "riffel-cli/src",
    "riffel-keys/src/quantity/error.rs",
    "riffel-page/src",
    "riffel-rail/src/chainage.rs",
    "riffel-rail/src/record.rs",
    "riffel-wasm/src",
    "riffel-web/src",
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
    // Said on the command line that starts the page.
    "cannot listen on",
    "cannot make a private",
    "cannot start the server",
    // Speeds that the page never sends.
    "weight of a speed",
    "sum of the weights",
    "the paper has no figure",
    // Files that the page writes for the program.
    "the curve of the page",
    "title = ",
    "contact.friction={",
    "standard_deviation",
];

/// The same of cases, answers and the command line.
const LEFT_IN_ANSWERS: &[&str] = &[
    // Words in drawings and tables on disk, beside sentences that are said.
    "Growth over a sleeper bay",
    "distance from a support",
    "wheel at this place",
    "over wavelength at",
    "growth rate per passage [-]",
    "Quasi-static in position",
    "Exact contact of the profiles",
    "lateral shift y",
    "lateral x, field side",
    "peak pressure [MPa]",
    "contact stiffness [MN/m]",
    "Depth is measured across",
    "A passage at",
    "Wheel centre at x",
    "wheel centre at x",
    "of the exact contact",
    "The last wave",
    "A wave of",
    "A smooth rail at",
    "motion that has not settled",
    "largest pressure",
    "wheelset, 1 leads",
    "one for the",
    "Growth under the wheels",
    // Titles of schemas, a name in the head of a report, reasons for the compiler, a sentence that cannot be reached.
    "case file of curving",
    "Riffel case file",
    "Riffel traffic file",
    "name=\"generator\"",
    // Said with bounds of its own.
    "must be between 8 and 200",
    "between 2 and",
    "answers of riffel",
    "a name that",
    "on either rail",
];

/// Files of what is English in every language: help, drawings and tables that are written to disk, and what a model of the
/// field is, in JSON. Paths in `crates`; a folder stands for all of its files.
const IN_ENGLISH: &[&str] = &[
    // Help with its examples.
    "riffel-cli/src/arguments",
    "riffel-cli/src/arguments.rs",
    // Drawings, and names of the columns of tables.
    "riffel-answers/src/axlebox/figure.rs",
    "riffel-answers/src/contact/creep_curves.rs",
    "riffel-answers/src/contact/frequency_response.rs",
    "riffel-answers/src/contact/mod.rs",
    "riffel-answers/src/contact/patch.rs",
    "riffel-answers/src/curve/over_radius.rs",
    "riffel-answers/src/growth_lines.rs",
    "riffel-answers/src/map/table.rs",
    "riffel-answers/src/models/figure.rs",
    "riffel-answers/src/profile/on_track.rs",
    "riffel-answers/src/profile/outline.rs",
    "riffel-answers/src/receptance",
    "riffel-answers/src/roughness/figure.rs",
    "riffel-answers/src/simulate/course.rs",
    "riffel-answers/src/simulate/evolution/figure.rs",
    "riffel-answers/src/simulate/evolution/table.rs",
    "riffel-answers/src/study/figure.rs",
    "riffel-answers/src/wheels/figure.rs",
    "riffel-answers/src/wheelset.rs",
    // What a model is, is the author's.
    "riffel-case/src/model/afferrante_ciavarella_2009.rs",
    "riffel-case/src/model/bhaskar_1997.rs",
    "riffel-case/src/model/both_2001.rs",
    "riffel-case/src/model/carson_johnson_1971.rs",
    "riffel-case/src/model/elkins_1998.rs",
    "riffel-case/src/model/frederick_1987.rs",
    "riffel-case/src/model/grassie_edwards_2008.rs",
    "riffel-case/src/model/grassie_johnson_1985.rs",
    "riffel-case/src/model/hempelmann_knothe_1996.rs",
    "riffel-case/src/model/riffel_exact.rs",
    "riffel-case/src/model/tassilly_vincent_1991.rs",
    "riffel-case/src/model/valdivia_1988.rs",
];

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All Rust files below a path.
fn files(path: &Path, found: &mut Vec<PathBuf>) {
    if path.is_dir() {
        let entries = fs::read_dir(path).unwrap();
        let mut entries: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        entries.sort();
        entries.iter().for_each(|entry| files(entry, found));
    } else if path.extension().is_some_and(|end| end == "rs") && !path.ends_with("tests.rs") {
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
    let (mut found, mut at) = (Vec::new(), 0);
    while at < letters.len() {
        match letters[at] {
            '\'' if letters.get(at + 2) == Some(&'\'') => at += 3,
            '"' => {
                let mut text = String::new();
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
                found.push(text);
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
fn no_sentence_of_the_page_lacks_its_german() {
    let catalogue = english();
    let mut sources = Vec::new();
    WHOLE
        .iter()
        .for_each(|path| files(&crates().join(path), &mut sources));
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
                .iter()
                .any(|words| is_said(words) && !known(words));
            let mut left = LEFT.iter().chain(LEFT_IN_ANSWERS);
            if lacks && !is_german(&text) && !left.any(|left| text.contains(left)) {
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
    // What others say is no concern of the sources.
    let others = FILE
        .split("\n# ")
        .find(|section| section.starts_with("What others say"));
    said += others.unwrap();
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
