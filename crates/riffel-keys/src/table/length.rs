//! Units of length in the names of columns, and other units that stand there.

use crate::Unit;

/// Units of length, each with the words for it.
const LENGTHS: [(&str, &str); 12] = [
    ("m", "m|meter|metre|meters|metres"),
    ("km", "km|kilometer|kilometre|kilometers|kilometres"),
    ("dm", "dm|decimeter|decimetre|dezimeter"),
    ("mm", "mm|millimeter|millimetre|millimeters|millimetres|millimètres"),
    ("cm", "cm|centimeter|centimetre"),
    ("um", "um|µm|μm|micron|microns|micrometer|micrometers|micrometre|micrometres|mikrometer|micromètres"),
    ("nm", "nm|nanometer|nanometre"),
    ("in", "inch|inches|zoll"),
    ("ft", "ft|foot|feet"),
    ("yd", "yd|yard|yards"),
    ("mi", "mi|mile|miles"),
    ("mil", "mil|mils|thou|thous"),
];
/// Units of other things at the end of a name, as in "t_s".
const AT_THE_END: &str = "s|sec|ms|min|hz|khz|db|dba|deg|rad|rpm|kmh|mph|kph|pa|upa|g|degc|degf|pct|percent";
/// Units that are no other word.
const ALWAYS: &str = "furlong|furlongs|fuss|fuß|hm|hectometre";

/// Words of a name, in small letters.
pub fn words(name: &str) -> Vec<String> {
    name.to_lowercase()
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_owned)
        .collect()
}

/// Whether a word is one of a list that is divided by bars.
pub fn is_one_of(word: &str, list: &str) -> bool {
    list.split('|').any(|known| known == word)
}

/// The unit of length that a word is, wherever it stands. "in" is one at the end of a name only.
pub fn length_word(word: &str) -> Option<&'static str> {
    let known = LENGTHS.iter().find(|(_, words)| is_one_of(word, words));
    known.map(|(unit, _)| *unit)
}

/// Whether a name ends in "in", as in "left [in]" or "height_in".
pub(super) fn ends_in_inches(words: &[String]) -> bool {
    words.last().is_some_and(|last| last == "in")
}

/// The unit of length in the name of a column or in a cell of a line of units: the last of several.
pub fn length_in(name: &str) -> Option<&'static str> {
    let words = words(name);
    if ends_in_inches(&words) {
        return Some("in");
    }
    words.iter().rev().find_map(|word| length_word(word))
}

/// What the name of a column gives as its unit and is no length known here, as it is written: what stands in brackets,
/// or a last word that is a unit.
pub fn foreign_unit(name: &str) -> Option<String> {
    let all = words(name);
    let other = |word: &String| is_one_of(word, AT_THE_END) || is_one_of(word, ALWAYS);
    for (open, close) in [('[', ']'), ('(', ')')] {
        let groups = name.split(open).skip(1);
        for (inside, _) in groups.filter_map(|group| group.split_once(close)) {
            let inside = inside.trim();
            let words = words(inside);
            let lengths = words.iter().filter(|word| length_word(word).is_some()).count();
            let is_product = inside.contains(|c: char| c.is_numeric() || "/·*^".contains(c));
            // "[mm]" and "(mm, filtered)", but not "[10 um]" nor "[µm/m]".
            if lengths == 1 && !is_product || words == ["in"] {
                continue;
            }
            let names_a_unit =
                lengths > 0 || words.iter().any(other) || !inside.is_empty() && Unit::parse(inside).is_ok();
            // Square brackets are for units; round ones are for remarks, too.
            let has_a_sign = inside.contains(|c: char| c.is_alphabetic() || "°%‰".contains(c));
            if has_a_sign && (open == '[' || names_a_unit) {
                return Some(inside.to_owned());
            }
        }
    }
    if length_in(name).is_some() {
        return None;
    }
    let last = all.last()?;
    let is_unit = is_one_of(last, ALWAYS) || all.len() > 1 && other(last);
    let written = name.trim_end_matches(|c: char| !c.is_alphanumeric());
    let begin = written.rfind(|c: char| !c.is_alphanumeric());
    is_unit.then(|| written[begin.map_or(0, |at| at + 1)..].to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heads_give_units() {
        for (name, length, foreign) in [
            ("x [ft]", Some("ft"), None),
            ("left_in", Some("in"), None),
            ("Höhe [Zoll]", Some("in"), None),
            ("height (thou)", Some("mil"), None),
            ("Miles", Some("mi"), None),
            ("x [dm]", Some("dm"), None),
            ("distance in metres", Some("m"), None),
            ("z (mm, filtered)", Some("mm"), None),
            ("height [furlong]", None, Some("furlong")),
            ("Weg [Fuss]", None, Some("Fuss")),
            ("x [hm]", None, Some("hm")),
            ("left [°]", None, Some("°")),
            ("left (dB)", None, Some("dB")),
            ("left [10 um]", Some("um"), Some("10 um")),
            ("slope [µm/m]", Some("m"), Some("µm/m")),
            ("t_s", None, Some("s")),
            ("s", None, None),
            ("rail (left)", None, None),
            ("z[0]", None, None),
            ("[2Jz um", Some("um"), None),
        ] {
            assert_eq!(length_in(name), length);
            assert_eq!(foreign_unit(name).as_deref(), foreign);
        }
    }
}
