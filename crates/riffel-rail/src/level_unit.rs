//! The reference of levels, from the name of their column.

use riffel_keys::table::{foreign_unit, is_one_of, length_in, words};
use riffel_keys::{Exponents, Unit};

/// Words for a size that may be in any unit, unless a word for a level stands beside them.
const SIZE: &str = "amplitude|amplitudes|magnitude|magnitudes|amplituden|amplitud|ampiezza|rms|effektivwert|efficace|eficaz|roughness|rauheit|\
                    rauhigkeit|rugosité|rugosidad|rugosità|ruwheid|height|höhe|hoehe|hauteur|altura|altezza|depth|tiefe|\
                    peak|p2p|psd";
const LEVEL: &str = "level|levels|l|lr|pegel|niveau|nivel|livello";

/// What is added to the levels of a column to have them in dB re 1 µm: 0 for a name without a reference, as in
/// `level_db`, -60 for `level [dB re 1 nm]`.
///
/// # Errors
/// A sentence where the name gives another unit than decibels, or a reference that is no length.
pub(super) fn level_shift(name: &str) -> Result<f64, String> {
    let wrong = |what: &str| {
        Err(format!(
            "column `{name}` is {what}; a table of spectra has levels in dB re 1 µm, or of a length that is named as in \
             level [dB re 1 nm]"
        ))
    };
    let Some(behind) = behind_decibel(name) else {
        let unit = foreign_unit(name).or_else(|| length_in(name).map(str::to_owned));
        let own = words(name);
        let has = |known: &str| own.iter().any(|word| is_one_of(word, known));
        return match unit {
            Some(unit) => wrong(&format!("in {unit}")),
            None if has(SIZE) && !has(LEVEL) => wrong("a size, and its unit is not said"),
            None => Ok(0.0),
        };
    };
    let words = behind.replace('_', " ");
    let words = words.trim_matches(|c: char| c.is_whitespace() || "[](),;:".contains(c));
    let (reference, is_said) = behind_re(words);
    let digits = reference.find(|c: char| !(c.is_ascii_digit() || "eE.+-".contains(c))).unwrap_or(reference.len());
    let (number, unit) = reference.split_at(digits);
    let factor = if number.is_empty() { Some(1.0) } else { number.parse::<f64>().ok() };
    let unit = Unit::parse(unit).ok().filter(|_| !unit.trim().is_empty());
    let length = unit.filter(|unit| unit.exponents == Exponents::new(0, 1, 0));
    let has_number = !number.is_empty();
    match (factor, length) {
        (Some(factor), Some(length)) if factor > 0.0 => Ok(decibels_of_micrometres(factor * length.factor)),
        // "dB left" names a rail; "dB(A)" weighs sound.
        _ if !is_said && !has_number && unit.is_none() && !reference.eq_ignore_ascii_case("a") => Ok(0.0),
        _ if is_said && reference.is_empty() => Ok(0.0),
        _ => wrong(&format!("in dB {words}")),
    }
}

/// 20 lg(l/1 µm), without the digits that powers of ten do not have.
fn decibels_of_micrometres(length: f64) -> f64 {
    let level = 20.0 * (length / 1e-6).log10();
    (1e9 * level).round() / 1e9
}

/// What stands behind the word "dB" of a name.
fn behind_decibel(name: &str) -> Option<&str> {
    let is_word = |at: usize| {
        let before = name[..at].chars().next_back();
        !before.is_some_and(char::is_alphanumeric)
    };
    let ends = |at: usize| {
        let behind = name[at + 2..].chars().next();
        !behind.is_some_and(char::is_alphabetic)
    };
    name.char_indices()
        .map(|(at, _)| at)
        .find(|&at| name[at..].get(..2).is_some_and(|word| word.eq_ignore_ascii_case("db")) && is_word(at) && ends(at))
        .map(|at| &name[at + 2..])
}

/// What follows a word for "relative to", and whether there was one.
fn behind_re(words: &str) -> (&str, bool) {
    for word in ["re.", "re", "ref.", "ref", "rel.", "bez.", "//"] {
        if let Some(head) = words.get(..word.len())
            && head.eq_ignore_ascii_case(word)
            && !words[word.len()..].starts_with(char::is_alphabetic)
        {
            return (words[word.len()..].trim_start_matches([' ', ':']), true);
        }
    }
    (words, false)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_lengths() {
        for (name, shift) in [
            ("level_db", 0.0),
            ("L", 0.0),
            ("Pegel [dB]", 0.0),
            ("L [dB re 1 um]", 0.0),
            ("level_db_re_1_um", 0.0),
            ("level_db_left", 0.0),
            ("roughness level", 0.0),
            ("rms_db", 0.0),
            ("dB right", 0.0),
            ("level [dB re 1 nm]", -60.0),
            ("level (dB ref 1nm)", -60.0),
            ("level [dB re 1e-9 m]", -60.0),
            ("level [dB re 1 mm]", 60.0),
            ("level [dB re 1 m]", 120.0),
            ("level [dB(1 nm)]", -60.0),
        ] {
            assert_eq!(level_shift(name), Ok(shift));
        }
    }

    #[test]
    fn other_units_are_refused() {
        for (name, what) in [
            ("level [dB re 20 uPa]", "in dB re 20 uPa"),
            ("level [dB re 1 furlong]", "in dB re 1 furlong"),
            ("level [dB(A)]", "in dB A"),
            ("level_nm", "in nm"),
            ("amplitude_um", "in um"),
            ("magnitude [um]", "in um"),
            ("amplitude", "a size, and its unit is not said"),
            ("rms left", "a size, and its unit is not said"),
            ("roughness", "a size, and its unit is not said"),
            ("speed_kmh", "in kmh"),
            ("level [%]", "in %"),
        ] {
            let sentence = level_shift(name).unwrap_err();
            assert!(sentence.starts_with(&format!("column `{name}` is {what};")), "{sentence}");
        }
    }
}
