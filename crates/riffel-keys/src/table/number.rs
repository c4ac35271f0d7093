//! Numbers in cells of text.

use std::borrow::Cow;

use riffel::Complex64;

use crate::text_file::text_of;

/// Powers of ten that a double holds exactly.
const EXACT: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
/// Metres of a foot and of a mile.
const FOOT: f64 = 0.3048;
const MILE: f64 = 5280.0 * FOOT;

/// The number that a cell holds which is [`plain`] to its end.
fn wholly_plain(cell: &[u8], decimal: u8) -> Option<f64> {
    plain(cell, decimal).filter(|&(_, length)| length == cell.len()).map(|(value, _)| value)
}

/// A number at the beginning of `text` written in plain digits, and the bytes it takes. `None` if there
/// is none, or where it needs more care than [`number`] of the whole cell gives: exponents, more digits
/// than a double holds.
///
/// An integer below 2⁵³ over an exact power of ten is rounded once, so the result is the nearest double
/// (Clinger, *How to read floating point numbers accurately*, 1990).
#[inline]
pub(super) fn plain(text: &[u8], decimal: u8) -> Option<(f64, usize)> {
    let negative = text.first() == Some(&b'-');
    let sign = usize::from(negative || text.first() == Some(&b'+'));
    let mut mantissa = 0u64;
    let mut at = sign;
    let mut point = None;
    while let Some(&byte) = text.get(at) {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
        } else if byte == decimal && point.is_none() {
            point = Some(at);
        } else {
            break;
        }
        at += 1;
    }
    let digits = at - sign - usize::from(point.is_some());
    // 15 digits are below 2⁵³.
    if digits == 0 || digits > 15 {
        return None;
    }
    let decimals = point.map_or(0, |point| at - point - 1);
    let value = mantissa as f64 / EXACT[decimals];
    Some((if negative { -value } else { value }, at))
}

/// The number that a whole cell holds; NaN for a word that says it is missing, and for what a double cannot hold. None for
/// anything else.
///
/// Quotes around it or an apostrophe before it, exponents with E or D, thousands apart (12.400,123, 12'400, 12 400,5), the
/// signs − and –, and a minus behind (0.45-) are understood; a [`chainage`] is in metres.
pub(super) fn number(cell: &[u8], decimal: u8) -> Option<f64> {
    let cell = unquoted(cell.trim_ascii());
    if let Some(value) = wholly_plain(cell, decimal) {
        return Some(value);
    }
    if is_missing(cell) {
        return Some(f64::NAN);
    }
    let text = written(cell);
    let (text, sign) = match text.strip_suffix('-') {
        Some(size) if size.starts_with(|c: char| c.is_ascii_digit()) => (size, -1.0),
        _ => (&*text, 1.0),
    };
    let value = floating(text, decimal).or_else(|| grouped(text, decimal)).or_else(|| chainage(text, decimal));
    value.map(|value| sign * value)
}

/// How a cell is written that looks like one number, beginning with its first digit, but is none that [`number`] reads.
pub(super) fn oddity(cell: &[u8]) -> Option<Oddity> {
    let text = text_of(cell);
    let text = text.trim();
    let begin = text.find(char::is_numeric)?;
    let (before, rest) = text.split_at(begin);
    let digits = rest.find(|c: char| !c.is_numeric() && !".,'’".contains(c)).unwrap_or(rest.len());
    let (digits, behind) = rest.split_at(digits);
    let behind = behind.trim();
    let is_one = !before.contains(char::is_alphabetic)
        && !behind.contains(char::is_numeric)
        && behind.chars().count() <= LONGEST_BEHIND
        && ['.', ','].into_iter().all(|mark| {
            let groups: Vec<&str> = digits.split(mark).collect();
            groups.len() < 3 || groups[1..].iter().all(|group| group.len() == 3)
        });
    is_one.then_some(match behind {
        _ if before.contains('(') => Oddity::Brackets,
        behind if behind.contains(|c: char| c.is_alphabetic() || "°%‰".contains(c)) => Oddity::Unit,
        _ => Oddity::Mark,
    })
}

/// How a number is written that is not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Oddity {
    /// In round brackets.
    Brackets,
    /// With letters behind it.
    Unit,
    /// With any other sign.
    Mark,
}

/// Signs that may stand behind a number.
const LONGEST_BEHIND: usize = 12;

/// The complex number that a whole cell holds, as NumPy, MATLAB or a spreadsheet writes it, (1.5e-8-2e-9j), 1.5-2i,
/// 1.5+j2, or as Fortran does, (1.5,-2.0). None for a real one and anything else.
pub(super) fn complex(cell: &[u8], decimal: u8) -> Option<Complex64> {
    let text = written(unquoted(cell.trim_ascii()));
    let in_brackets = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
    let part = |text: &str| floating(text, decimal);
    if let Some((real, imaginary)) = in_brackets.and_then(|pair| pair.split_once(',')) {
        return Some(Complex64::new(part(real.trim())?, part(imaginary.trim())?));
    }
    let text = in_brackets.unwrap_or(&text);
    let is_unit = |c: char| matches!(c, 'i' | 'j' | 'I' | 'J');
    if text.matches(is_unit).count() != 1 {
        return None;
    }
    let kept = text.chars().filter(|&c| !is_unit(c) && c != '*' && !c.is_whitespace());
    let parts: String = kept.collect();
    // The sign between the parts is no sign of an exponent.
    let bytes = parts.as_bytes();
    let sign = (1..bytes.len())
        .rev()
        .find(|&at| matches!(bytes[at], b'+' | b'-') && !matches!(bytes[at - 1], b'e' | b'E' | b'd' | b'D'));
    let (real, imaginary) = parts.split_at(sign.unwrap_or(0));
    let real = if real.is_empty() { 0.0 } else { part(real)? };
    Some(Complex64::new(real, part(imaginary)?))
}

/// The text of a cell with a plain minus for every sign that looks like one, without the apostrophe by which a spreadsheet
/// makes it text.
fn written(cell: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(cell) {
        Ok(text) if text.is_ascii() => Cow::Borrowed(text.strip_prefix('\'').unwrap_or(text)),
        _ => {
            let text = text_of(cell).replace(['\u{2212}', '\u{2013}'], "-");
            Cow::Owned(text.trim().trim_start_matches(['\'', '’']).to_owned())
        }
    }
}

/// A number with or without an exponent.
fn floating(text: &str, decimal: u8) -> Option<f64> {
    let is_exponent = |c: char| matches!(c, 'd' | 'D');
    let mut bytes = text.bytes();
    if !bytes.all(|byte| byte.is_ascii_digit() || byte == decimal || b"+-eEdD".contains(&byte)) {
        return None;
    }
    let value: f64 = match decimal {
        b'.' if !text.contains(is_exponent) => text.parse().ok()?,
        _ => text.replace(',', ".").replace(is_exponent, "e").parse().ok()?,
    };
    Some(if value.is_finite() { value } else { f64::NAN })
}

/// Without the quotes around it.
fn unquoted(cell: &[u8]) -> &[u8] {
    match cell {
        [b'"', inner @ .., b'"'] | [b'\'', inner @ .., b'\''] => inner.trim_ascii(),
        _ => cell,
    }
}

/// A number with its thousands apart: only where an apostrophe or a blank divides them, or a decimal mark leaves no doubt
/// that the other mark does.
fn grouped(text: &str, decimal: u8) -> Option<f64> {
    let is_alone = |c: char| matches!(c, '\'' | '’' | ' ' | '\u{a0}' | '\u{202f}');
    let (integer, decimals) = match text.split_once(char::from(decimal)) {
        Some((integer, decimals)) => (integer, decimals),
        None if text.contains(is_alone) => (text, ""),
        None => return None,
    };
    let divider = match (integer.chars().find(|&c| is_alone(c)), decimal) {
        (Some(divider), _) => divider,
        (None, b',') => '.',
        (None, _) => ',',
    };
    let unsigned = integer.strip_prefix(['-', '+']).unwrap_or(integer);
    let groups: Vec<&str> = unsigned.split(divider).collect();
    let whole = groups.len() > 1
        && (1..=3).contains(&groups[0].len())
        && groups[1..].iter().all(|group| group.len() == 3)
        && groups.iter().all(|group| are_digits(group))
        && are_digits(decimals);
    whole.then(|| format!("{}.{decimals}0", integer.replace(divider, "")).parse().ok())?
}

/// Metres of a chainage: kilometres (km 12.4) or miles (mi:12.3); kilometres and metres (12+400.123, km 12+400) if three
/// digits stand between plus and decimal mark; American stations of a hundred feet and feet (123+45.67) if two do; the
/// board of a hundred metres and metres beyond it (26.0+100.005), as German lines have them.
fn chainage(text: &str, decimal: u8) -> Option<f64> {
    let (unit, text) = match text.get(..2).map(str::to_ascii_lowercase).as_deref() {
        Some("km") => (Some(1e3), text[2..].trim_start_matches([' ', ':', '.'])),
        Some("mi") => (Some(MILE), text[2..].trim_start_matches([' ', ':', '.'])),
        _ => (None, text),
    };
    let Some((posts, behind)) = text.split_once('+') else {
        return Some(unit? * floating(text, decimal)?);
    };
    let (whole, decimals) = behind.split_once(char::from(decimal)).unwrap_or((behind, ""));
    let (posts, board) = posts.split_once(['.', ',']).unwrap_or((posts, ""));
    let are_digits = [posts, board, whole, decimals].into_iter().all(are_digits);
    if !are_digits || unit == Some(MILE) || !(1..=5).contains(&posts.len()) {
        return None;
    }
    let (unit, post) = match (board.len(), whole.len()) {
        (0, 3) | (1, 1..=4) => (1.0, 1000),
        (0, 2) => (FOOT, 100),
        _ => return None,
    };
    let number = |text: &str| text.parse::<u64>().ok();
    let whole = post * number(posts)? + 100 * number(board).unwrap_or(0) + number(whole)?;
    let length: Option<f64> = format!("{whole}.{decimals}0").parse().ok();
    length.map(|length| unit * length)
}

/// Seconds since midnight of a time of day, 02:59:54.00025, with or without a date before it; NaN for a word that says it is
/// missing.
pub fn clock(cell: &[u8]) -> Option<f64> {
    let cell = unquoted(cell.trim_ascii());
    if is_missing(cell) {
        return Some(f64::NAN);
    }
    let text = written(cell);
    let text = text.strip_suffix(['Z', 'z']).unwrap_or(&text);
    let time = match text.rsplit_once([' ', 'T', 't', '_']) {
        Some((date, time)) => {
            let is_of_date = |c: char| c.is_ascii_digit() || "-./".contains(c);
            (!date.is_empty() && date.chars().all(is_of_date)).then_some(time)?
        }
        None => text,
    };
    let [hours, minutes, seconds] = time.split(':').collect::<Vec<&str>>()[..] else {
        return None;
    };
    let (whole, decimals) = seconds.split_once(['.', ',']).unwrap_or((seconds, ""));
    let part = |text: &str, width: std::ops::RangeInclusive<usize>, below: u32| {
        let is_part = width.contains(&text.len()) && are_digits(text);
        text.parse::<u32>().ok().filter(|&number| is_part && number < below)
    };
    let minutes = 60 * part(hours, 1..=2, 24)? + part(minutes, 2..=2, 60)?;
    // A leap second is the 61st.
    let whole = part(whole, 2..=2, 61)?;
    let seconds: f64 = format!("{whole}.{decimals}0").parse().ok()?;
    are_digits(decimals).then(|| f64::from(60 * minutes) + seconds)
}

fn are_digits(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether a cell holds a chainage, whose number is in metres.
pub(super) fn is_chainage(cell: &[u8], decimal: u8) -> bool {
    let cell = unquoted(cell.trim_ascii());
    wholly_plain(cell, decimal).is_none() && chainage(&written(cell), decimal).is_some()
}

/// Whether a cell says that there is no value.
fn is_missing(cell: &[u8]) -> bool {
    const WORDS: [&[u8]; 12] =
        [b"nan", b"-nan", b"na", b"n/a", b"null", b"none", b"inf", b"-inf", b"#n/a", b"#nv", b"nodata", b"-"];
    WORDS.iter().any(|word| cell.eq_ignore_ascii_case(word))
        || cell.iter().all(|&byte| byte == b'*')
        || cell.iter().all(|&byte| byte == b'-')
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The short way gives the double that the standard library gives.
        #[test]
        fn plain_numbers_are_exact(text in "[+-]?[0-9]{1,12}(\\.[0-9]{0,6})?") {
            let expected: f64 = text.parse().unwrap();
            prop_assert_eq!(number(text.as_bytes(), b'.'), Some(expected));
            let comma = text.replace('.', ",");
            prop_assert_eq!(number(comma.as_bytes(), b','), Some(expected));
        }

        #[test]
        fn no_text_panics(text in prop::collection::vec(any::<u8>(), 0..20)) {
            let _ = number(&text, b'.');
            let _ = number(&text, b',');
        }
    }

    #[test]
    fn cells_hold_numbers_or_nothing() {
        assert_eq!(number(b" 1.5e-3 ", b'.'), Some(1.5e-3));
        assert_eq!(number(b"1,5e-3", b','), Some(1.5e-3));
        assert_eq!(number(b"123456789012345678.5", b'.'), Some(123_456_789_012_345_680.0));
        assert!(number(b"NaN", b'.').is_some_and(f64::is_nan));
        assert!(number(b"", b'.').is_some_and(f64::is_nan));
        assert_eq!(number(b"2,5", b'.'), None);
        assert_eq!(number(b"2.5", b','), None);
        assert_eq!(number(b"abc", b'.'), None);
        assert_eq!(number(b".", b'.'), None);
        assert_eq!(number(b"\"1.5\"", b'.'), Some(1.5));
    }

    #[test]
    fn chainage_is_read_as_engineers_write_it() {
        for (text, decimal, metres) in [
            ("12+400.123", b'.', 12_400.123),
            ("12+400,123", b',', 12_400.123),
            ("km 12+400", b'.', 12_400.0),
            ("KM 0+001.5", b'.', 1.5),
            ("12.400,123", b',', 12_400.123),
            ("1.012.400,5", b',', 1_012_400.5),
            ("12,400.123", b'.', 12_400.123),
            ("12'400.123", b'.', 12_400.123),
            ("-1.400,5", b',', -1_400.5),
            ("12 400,5", b',', 12_400.5),
            ("12\u{202f}400", b'.', 12_400.0),
            ("123+45.67", b'.', 0.3048 * 12_345.67),
            ("26.0+100.005", b'.', 26_100.005),
            ("km 26,1+5", b'.', 26_105.0),
            ("26,0+100,005", b',', 26_100.005),
            ("mi:12.5", b'.', 12.5 * 1609.344),
            ("km 12,4", b',', 12_400.0),
        ] {
            assert_eq!(number(text.as_bytes(), decimal), Some(metres), "{text}");
        }
        // What may be something else is no number.
        for (text, decimal) in [
            ("12.400", b','),
            ("12,400", b'.'),
            ("12+4.1", b'.'),
            ("12+4000", b'.'),
            ("1,24,3", b'.'),
            ("12.40,123", b','),
            ("26.00+100", b'.'),
            ("26.000+100", b'.'),
            ("mi:12+400", b'.'),
            ("+400", b'x'),
        ] {
            assert_eq!(number(text.as_bytes(), decimal).filter(|_| decimal != b'x'), None, "{text}");
        }
    }

    #[test]
    fn signs_and_exponents_of_other_programs_are_read() {
        for (text, value) in [
            ("-1.491436D+00", -1.491436),
            ("5d-3", 5e-3),
            ("\u{2212}1.5", -1.5),
            ("\u{2013}2", -2.0),
            ("\u{2212}1.5e\u{2212}3", -1.5e-3),
            ("'-1.5", -1.5),
            ("\u{2019}1.5\u{a0}", 1.5),
            ("0.45-", -0.45),
            ("1'200.5-", -1200.5),
        ] {
            assert_eq!(number(text.as_bytes(), b'.'), Some(value), "{text}");
        }
        assert_eq!(number(b"\x961.5", b'.'), Some(-1.5), "Windows-1252");
        assert!(number(b"****", b'.').is_some_and(f64::is_nan));
        assert_eq!(number(b"D", b'.'), None);
    }

    #[test]
    fn odd_numbers_are_told_from_words_dates_and_clocks() {
        for (text, oddity_of) in [
            ("(0.45)", Some(Oddity::Brackets)),
            ("-0.45 um", Some(Oddity::Unit)),
            ("1.234,5mm", Some(Oddity::Unit)),
            ("12 %", Some(Oddity::Unit)),
            ("0.45*", Some(Oddity::Mark)),
            ("<0.45", Some(Oddity::Mark)),
            ("-0,45", Some(Oddity::Mark)),
            ("2026-11-28", None),
            ("01.06.26", None),
            ("02:59:54.00025", None),
            ("R12", None),
            ("weld", None),
            ("0.000,1.31", None),
            ("2 welds near the station", None),
        ] {
            assert_eq!(oddity(text.as_bytes()), oddity_of, "{text}");
        }
    }

    #[test]
    fn complex_numbers_are_read_as_programs_write_them() {
        let expected = Some(Complex64::new(1.5e-8, -2e-9));
        for text in [
            "(1.5e-08-2e-09j)",
            "1.5e-08-2e-09i",
            "1.5E-8 - 2E-9*i",
            "1.5e-8-j2e-9",
            "(1.5D-08,-2.0D-09)",
            "\"1.5e-8\u{2212}2e-9i\"",
        ] {
            assert_eq!(complex(text.as_bytes(), b'.'), expected, "{text}");
        }
        assert_eq!(complex(b"0,5+0,25i", b','), Some(Complex64::new(0.5, 0.25)));
        assert_eq!(complex(b"-2.5j", b'.'), Some(Complex64::new(0.0, -2.5)));
        for text in ["1.5", "nan", "left", "i", "1+2", "Bi-1"] {
            assert_eq!(complex(text.as_bytes(), b'.'), None, "{text}");
        }
    }
}
