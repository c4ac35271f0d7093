//! The catalogue against the sources that speak.

use std::fs;
use std::path::{Path, PathBuf};

use riffel_case::{Badge, presets};
use riffel_rail::LimitTable;
use riffel_words::{in_german, wordings};

const FILE: &str = include_str!("../src/german.txt");

/// Crates that do not speak German: the catalogue itself, the Python package, whose errors are English as those of Python, and
/// calibration, whose plans are for those who read English manuals of statistics.
const WITHOUT: [&str; 3] = ["riffel-words", "riffel-python", "riffel-calibrate"];

/// What has no German, and why, file by file. Paths in `crates`.
const LEFT: &[(&str, &[&str])] = &[
    // For browsers, not for people.
    (
        "riffel-plot/src/page/html.rs",
        &["body{margin", "default-src", "panels stacked"],
    ),
    (
        "riffel-web/src/assets.rs",
        &["// What Riffel says", "max-age"],
    ),
    (
        "riffel-web/src/file.rs",
        &["default-src", "name=\"generator\""],
    ),
    (
        "riffel-web/src/guard.rs",
        &[
            "default-src",
            "this page is not served",
            "open it by the address",
            "only the page itself may ask",
            "the header Origin",
        ],
    ),
    (
        "riffel-web/src/request.rs",
        &[
            "a request about a file must say",
            "a request must be JSON",
            "send the header",
        ],
    ),
    ("riffel-answers/src/report/page.rs", &["name=\"generator\""]),
    // Defects, told in English to those who mend them.
    (
        "riffel/src/contact/law/checks.rs",
        &["{next} after {last} at step"],
    ),
    ("riffel/src/growth/map.rs", &["tiles of a map"]),
    (
        "riffel/src/passage/transient_contact.rs",
        &["beside a transient one", "must be none, under a free wheel"],
    ),
    (
        "riffel-keys/src/question.rs",
        &[
            "the question is",
            "the question has no such key",
            "the first column has",
        ],
    ),
    (
        "riffel-cli/src/error.rs",
        &[
            "the question on standard input",
            "riffel schema --question NAME",
        ],
    ),
    (
        "riffel-cli/src/question.rs",
        &[
            "standard input holds the question",
            "a list of them as",
            "riffel ask",
        ],
    ),
    (
        "riffel/src/growth/with_neighbours.rs",
        &["number of contacts of a wave", "of a wheel along one axis"],
    ),
    ("riffel-web/src/workspace.rs", &["cannot be stored"]),
    ("riffel-page/src/case_text.rs", &["cannot be written"]),
    ("riffel-page/src/fault.rs", &["cannot be drawn"]),
    ("riffel-page/src/figure.rs", &["the paper has no figure"]),
    (
        "riffel-page/src/reply.rs",
        &["is too long", "cannot be written"],
    ),
    ("riffel-page/src/table.rs", &["cannot be written"]),
    ("riffel-page/src/traffic.rs", &["cannot be written"]),
    ("riffel-plot/src/drawing/collision.rs", &["{said:?}"]),
    (
        "riffel-plot/src/error.rs",
        &["cannot be read", "the drawing library failed"],
    ),
    (
        "riffel-web/src/api/along.rs",
        &["cannot be read", "there is no place"],
    ),
    ("riffel-web/src/api/export.rs", &["cannot be drawn"]),
    ("riffel-web/src/api/report.rs", &["there is no place"]),
    (
        "riffel-web/src/api/roughness.rs",
        &["cannot be written", "cannot be stored"],
    ),
    (
        "riffel-web/src/program.rs",
        &["printed something else", "cannot be run", "is not known"],
    ),
    ("riffel-web/src/uploads.rs", &["cannot be stored"]),
    (
        "riffel-web/src/api/curve.rs",
        &[
            "there is no place",
            "the curve of the page",
            "there is no such nominal profile",
            "cannot be stored",
        ],
    ),
    // Said to those who build.
    ("riffel-page/src/lib.rs", &["answers of riffel"]),
    ("riffel-wasm/src/lib.rs", &["a name that"]),
    // Words of another reader, which are put into our own.
    (
        "riffel-keys/src/key_file.rs",
        &[
            "missing field",
            "unknown field",
            "unknown variant",
            "expected struct",
            "expected a sequence",
            "invalid type",
        ],
    ),
    // Sources of nominal profiles.
    (
        "riffel/src/profile/nominal.rs",
        &["Wheel of EN", "Cone of 1:40"],
    ),
    // Titles of schemas.
    ("riffel-case/src/file/curving.rs", &["case file of curving"]),
    ("riffel-case/src/file/mod.rs", &["Riffel case file"]),
    (
        "riffel-case/src/traffic/traffic_file.rs",
        &["Riffel traffic file"],
    ),
    // Descriptions of arrays in a store, for those who open it with other programs.
    (
        "riffel-network/src/ingest.rs",
        &["of a cell along the line"],
    ),
    (
        "riffel-arrays/src/band_axes.rs",
        &["in the logarithm of wavelength", "wavelength of the band"],
    ),
    (
        "riffel-network/src/store.rs",
        &["RMS of roughness in a band"],
    ),
    (
        "riffel-study/src/outputs/mod.rs",
        &[
            "that the strongest branch of the ridge follows",
            "growth rate per passage",
            "highest growth",
            "sits at an end of the window",
            "growth where its real part is negative",
        ],
    ),
    (
        "riffel-study/src/outputs/wave.rs",
        &[
            "first harmonic of the normal force",
            "least normal force",
            "largest normal force",
            "share of the time without contact",
            "mean creepage along the rail",
            "mean energy dissipated",
            "amplitude of the wave",
            " worn by {passages}",
            "over a wave of",
        ],
    ),
    (
        "riffel-study/src/results/arrays.rs",
        &["why the sample has no results"],
    ),
    // Words in drawings and tables on disk, beside sentences that are said.
    (
        "riffel-answers/src/map/bay.rs",
        &[
            "Growth over a sleeper bay",
            "distance from a support",
            "growth rate per passage [-]",
            "wheel at this place",
            "over wavelength at",
            "Quasi-static in position",
        ],
    ),
    (
        "riffel-answers/src/profile/under_load.rs",
        &[
            "Exact contact of the profiles",
            "lateral shift y",
            "peak pressure [MPa]",
            "contact stiffness [MN/m]",
            "largest pressure",
        ],
    ),
    (
        "riffel-answers/src/profile/wear.rs",
        &["lateral x, field side", "Depth is measured across"],
    ),
    (
        "riffel-answers/src/simulate/along_rail.rs",
        &["A passage at", "Wheel centre at x"],
    ),
    (
        "riffel-answers/src/simulate/sinusoid.rs",
        &[
            "of the exact contact",
            "The last wave",
            "A wave of",
            "wheel centre at x",
        ],
    ),
    (
        "riffel-answers/src/simulate/smooth_rail.rs",
        &["motion that has not settled", "A smooth rail at"],
    ),
    (
        "riffel-answers/src/wheels/table.rs",
        &["one for the", "Growth under the wheels"],
    ),
];

/// Files of what is English in every language: help, drawings and tables that are written to disk, and what a model of the
/// field is, in JSON. Paths in `crates`; a folder stands for all of its files.
const IN_ENGLISH: &[&str] = &[
    // Where the ends of ranges come from: for the documentation.
    "riffel-keys/src/range/table.rs",
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
    let catalogue = english();
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
