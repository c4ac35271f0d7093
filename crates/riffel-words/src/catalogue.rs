//! The catalogue, and what finds a sentence in it.

use std::collections::HashMap;
use std::sync::LazyLock;

use riffel_keys::quantity::names;

use crate::numbers::with_comma;
use crate::wording::{Wording, sentence_end};

/// Sentences of English alone where they are made: an English wording, the German one below it, an empty line; lines with
/// `#` are headings.
const FILE: &str = include_str!("german.txt");

/// Those of messages.
static OF_MESSAGES: LazyLock<Vec<(String, String)>> =
    LazyLock::new(|| riffel_keys::message::wordings().collect());

/// All wordings, each English one with the German one: those of the file, and those that have both languages where they
/// are made ([`riffel_keys::quantity::named`], [`riffel_keys::Message`]).
pub fn wordings() -> impl Iterator<Item = (&'static str, &'static str)> {
    let is_wording = |line: &&str| !line.is_empty() && !line.starts_with('#');
    let english = FILE.lines().filter(is_wording).step_by(2);
    let german = FILE.lines().filter(is_wording).skip(1).step_by(2);
    // Parts that are put together, such as " and ", are no sentences.
    let whole = |wording: &(&str, &str)| {
        !wording.0.starts_with([' ', ',', ';']) && !wording.0.ends_with(' ')
    };
    let of_messages = OF_MESSAGES
        .iter()
        .map(|(english, german)| (&**english, &**german));
    let of_messages = of_messages.filter(whole);
    english.zip(german).chain(names()).chain(of_messages)
}

/// Name of a value that must be a sentence of the catalogue.
const SENTENCE: &str = "sentence";

/// Names of values that stand as they are: a file may be called as something is that the catalogue knows.
const AS_WRITTEN: [&str; 11] = [
    "case",
    "title",
    "path",
    "file",
    "folder",
    "key",
    "names",
    "url",
    "choices",
    "version",
    "assignment",
];

/// Name of a value that somebody gave: a number, or a word that stands as it is.
const GIVEN: &str = "value";

/// What is longer [bytes] is data and no sentence.
const LONGEST: usize = 2000;

/// Sentences are sought in sentences so deep.
const DEEPEST: usize = 8;

/// An English wording with the German one.
type Entry = (Wording<'static>, Wording<'static>);

struct Catalogue {
    /// Those with values and words of their own, the longest first.
    of_words: Vec<Entry>,
    /// Those whose own are marks alone, as in "{what}: {sentence}", which fits nearly everything.
    of_marks: Vec<Entry>,
    /// Those without values, by their English wording.
    whole: HashMap<&'static str, &'static str>,
}

static READ: LazyLock<Catalogue> = LazyLock::new(|| {
    let (mut entries, mut whole) = (Vec::new(), HashMap::new());
    for (english, german) in wordings() {
        if english.contains('{') {
            entries.push((Wording::new(english), Wording::new(german)));
        } else {
            whole.entry(english).or_insert(german);
        }
    }
    entries.sort_by_key(|(english, _)| std::cmp::Reverse(english.own));
    let (of_words, of_marks) = entries
        .into_iter()
        .partition(|(english, _)| english.has_words());
    Catalogue {
        of_words,
        of_marks,
        whole,
    }
});

/// The German of a sentence or of words that the program says; none of what the catalogue does not have.
///
/// A text of several sentences is translated sentence by sentence, and wholly or not at all. Cost, without
/// optimisation: 0.2 to 3 ms for the sentences and captions of a report.
pub fn in_german(english: &str) -> Option<String> {
    let inner = english.trim();
    if inner.len() > LONGEST {
        return None;
    }
    let german = sought(inner, DEEPEST)?;
    let start = english.len() - english.trim_start().len();
    Some([&english[..start], &german, &english[start + inner.len()..]].concat())
}

fn sought(english: &str, depth: usize) -> Option<String> {
    if english.is_empty() || depth == 0 {
        return None;
    }
    // A value of the last sentence must not swallow those that follow.
    let sentences = || parts(english, sentence_end(english)?, depth);
    let clauses = || parts(english, english.find("; ").map(|at| [at, at + 2])?, depth);
    sentences()
        .or_else(|| one(english, depth, &READ.of_words))
        .or_else(clauses)
        .or_else(|| one(english, depth, &READ.of_marks))
}

/// The German of one wording, with or without a stop, in the middle of a sentence or at its beginning.
fn one(english: &str, depth: usize, entries: &[Entry]) -> Option<String> {
    let stopped = |text: &str| {
        let without = || Some(exact(text.strip_suffix('.')?, depth, entries)? + ".");
        exact(text, depth, entries).or_else(without)
    };
    let small = || {
        let mut letters = english.chars();
        let first = letters.next().filter(|first| first.is_uppercase())?;
        let small: String = first.to_lowercase().chain(letters).collect();
        let german = stopped(&small)?;
        let mut letters = german.chars();
        Some(letters.next()?.to_uppercase().chain(letters).collect())
    };
    stopped(english).or_else(small)
}

/// The German of one wording.
fn exact(english: &str, depth: usize, entries: &[Entry]) -> Option<String> {
    if let Some(german) = READ.whole.get(english) {
        return Some((*german).to_owned());
    }
    // The one with the most words of its own first.
    entries.iter().find_map(|(wording, german)| {
        let values = wording.values(english)?;
        let mut found = Vec::new();
        for ((name, value), is_quoted) in values.into_iter().zip(wording.quoted()) {
            // A word in quotation marks is one that somebody wrote.
            if AS_WRITTEN.contains(&name) || is_quoted && !value.contains(' ') {
                found.push((name, value.to_owned()));
                continue;
            }
            if name == GIVEN && !is_quoted {
                found.push((name, with_comma(value)));
                continue;
            }
            let known = sought(value.trim(), depth - 1)
                .map(|german| value.replacen(value.trim(), &german, 1));
            found.push((
                name,
                match (known, name) {
                    (Some(german), _) => german,
                    (None, SENTENCE) => return None,
                    (None, _) if is_quoted => value.to_owned(),
                    (None, _) => of_value(value, depth - 1),
                },
            ));
        }
        Some(german.filled(|name| {
            let value = found.iter().find(|(own, _)| *own == name);
            value.map_or_else(String::new, |(_, value)| value.clone())
        }))
    })
}

/// A value that is no sentence of the catalogue: a row of those, or what stays.
fn of_value(value: &str, depth: usize) -> String {
    let parts = value.split(", ");
    let parts: Vec<String> = parts
        .map(|part| sought(part, depth).unwrap_or_else(|| with_comma(part)))
        .collect();
    parts.join(", ")
}

/// Two parts, of which each must be known.
fn parts(english: &str, [end, begin]: [usize; 2], depth: usize) -> Option<String> {
    let (first, rest) = (
        sought(&english[..end], depth)?,
        sought(&english[begin..], depth)?,
    );
    Some([&first, &english[end..begin], &rest].concat())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn german(english: &str) -> String {
        in_german(english).unwrap_or_else(|| panic!("no German of {english:?}"))
    }

    /// Headings aside, the catalogue is pairs; both have the same names, and no wording is there twice.
    #[test]
    fn languages_have_no_gaps() {
        let mut known = BTreeSet::new();
        for block in FILE.split("\n\n") {
            let lines: Vec<&str> = block
                .lines()
                .filter(|line| !line.starts_with('#'))
                .collect();
            if lines.is_empty() {
                continue;
            }
            let [english, german] = lines[..] else {
                panic!("not a wording in two languages: {block}");
            };
            assert!(known.insert(english), "twice: {english}");
            let names = |text| {
                Wording::new(text)
                    .names()
                    .map(str::to_owned)
                    .collect::<BTreeSet<_>>()
            };
            assert_eq!(names(english), names(german), "{english}");
        }
    }

    #[test]
    fn sentences_are_found_with_their_values() {
        assert_eq!(
            german(
                "growth ridge leads with a share of 0.62, next is grinding mark with 0.21. There is one record only: whether it grows is not known."
            ),
            "Wachstumsgrat führt mit einem Anteil von 0,62, dann folgt Schleifspur mit 0,21. Es gibt nur eine Messung: Ob sie wächst, ist nicht bekannt."
        );
        assert_eq!(german("Growth ridge"), "Wachstumsgrat");
        assert_eq!(
            german(
                "rail left has 2 welds, joints or squats: 10.0 m (-302 µm), 30.3 m (-299 µm); they count in levels and limits, but are no corrugation"
            ),
            "Schiene links hat 2 Schweißungen, Stöße oder Squats: 10,0 m (-302 µm), 30,3 m (-299 µm); sie zählen in Pegeln und Grenzwerten, sind aber keine Riffeln"
        );
        assert_eq!(
            german(
                "rail left: EN ISO 3095:2013: over the limit, 3 of 12 bands, at worst by 4.2 dB at 40 mm"
            ),
            "Schiene links: EN ISO 3095:2013: über der Grenze, 3 von 12 Bändern, am meisten um 4,2 dB bei 40 mm"
        );
        assert_eq!(
            german(
                "`contact.normal_load`: \"50 kg\" is in kg, not a force in N; write it as in \"50 kN\""
            ),
            "`contact.normal_load`: \"50 kg\" ist in kg, nicht eine Kraft in N; man schreibt es wie \"50 kN\""
        );
        assert_eq!(in_german("no sentence of Riffel"), None);
    }

    #[test]
    fn what_somebody_wrote_stays_and_no_beginning_is_left_in_english() {
        for (english, told) in [
            (
                "\"limit\" is not one of its choices",
                "\"limit\" steht nicht zur Wahl",
            ),
            (
                "--set a.b=[1.5, 2]: `a.b` is missing",
                "--set a.b=[1.5, 2]: `a.b` fehlt",
            ),
            (
                "cannot write to limit: there is no folder left",
                "in limit lässt sich nicht schreiben: es gibt keinen Ordner left",
            ),
            (
                "`profiles.wheel` is \"a\", but a cannot be read: b; nominal profiles: S1002",
                "`profiles.wheel` ist \"a\", a ist aber nicht zu lesen: b; Sollprofile: S1002",
            ),
        ] {
            assert_eq!(german(english), told);
        }
    }

    /// No wording is taken for another one, whatever is said before it.
    #[test]
    fn each_wording_has_its_own_german() {
        let filled = |wording: &str, sentence: &str| {
            Wording::new(wording).filled(|name| {
                let value = match name {
                    "count" | "number" => "7",
                    SENTENCE => sentence,
                    _ => "qz",
                };
                value.to_owned()
            })
        };
        let mut others = Vec::new();
        for (english, expected) in wordings() {
            // Where two values stand side by side, the first one is as short as it can be.
            if english.contains("}{") {
                continue;
            }
            let (said, german) = (
                filled(english, "the file is empty"),
                filled(expected, "die Datei ist leer"),
            );
            let places = [("", ""), ("a.toml, line 3: ", "a.toml, Zeile 3: ")];
            for (place, ort) in places {
                // A place before a place is not said.
                let begins = english.split_once('}').map(|(_, rest)| rest);
                let has_place =
                    english.starts_with('{') && begins.is_some_and(|rest| rest.starts_with(": "));
                let is_place = ["{file}", "{line}"]
                    .iter()
                    .any(|own| english.starts_with(own));
                if !place.is_empty() && (has_place || is_place) {
                    continue;
                }
                let (told, expected) = (
                    in_german(&format!("{place}{said}")),
                    format!("{ort}{german}"),
                );
                if told.as_deref() != Some(&expected) {
                    others.push(format!("{place}{said}\n  {expected}\n  {told:?}"));
                }
            }
        }
        assert!(
            others.is_empty(),
            "another German of\n{}",
            others.join("\n")
        );
    }

    /// A key may be called as a word of the catalogue is, and a decimal point in code is no comma.
    #[test]
    fn what_is_quoted_stays() {
        for (english, expected) in [
            (
                "`wheel` is not a table of keys, as it must be",
                "`wheel` ist keine Tabelle, wie es sein muss",
            ),
            (
                "unknown unit \"%%\" in \"0.3 %%\"; write a ratio as in \"0.4 %\"",
                "unbekannte Einheit \"%%\" in \"0.3 %%\"; ein Verhältnis schreibt man wie \"0.4 %\"",
            ),
            (
                "cannot read the case file left 0.5: No such file or directory (os error 2)",
                "die Falldatei left 0.5 ist nicht zu lesen: Datei oder Ordner nicht gefunden (os error 2)",
            ),
        ] {
            assert_eq!(german(english), expected);
        }
    }
}
