//! Numbers in cells of text.

/// Powers of ten that a double holds exactly.
const EXACT: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// A number at the beginning of `text` written in plain digits, and the bytes it takes. None where there
/// is none, or where it needs more care than [`parse`] of the whole cell gives: exponents, more digits
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

/// The number that a whole cell holds; not a number for a word that says it is missing. None for
/// anything else.
pub(super) fn parse(cell: &[u8], decimal: u8) -> Option<f64> {
    let cell = unquoted(cell.trim_ascii());
    if let Some((value, length)) = plain(cell, decimal)
        && length == cell.len()
    {
        return Some(value);
    }
    if is_missing(cell) {
        return Some(f64::NAN);
    }
    let text = std::str::from_utf8(cell).ok()?;
    let looks_like_one = text
        .bytes()
        .all(|byte| byte.is_ascii_digit() || byte == decimal || b"+-eE".contains(&byte));
    if !looks_like_one {
        return grouped(text, decimal).or_else(|| kilometrage(text, decimal));
    }
    let value: Result<f64, _> = match decimal {
        b'.' => text.parse(),
        _ => text.replace(',', ".").parse(),
    };
    let Ok(value) = value else {
        return kilometrage(text, decimal);
    };
    // What overflows is no height.
    Some(if value.is_finite() { value } else { f64::NAN })
}

/// Without the quotes around it.
fn unquoted(cell: &[u8]) -> &[u8] {
    match cell {
        [b'"', inner @ .., b'"'] | [b'\'', inner @ .., b'\''] => inner.trim_ascii(),
        _ => cell,
    }
}

/// A number with its thousands apart, as 12.400,123 or 12'400: only where an apostrophe divides them, or a decimal mark
/// leaves no doubt that the other mark does.
fn grouped(text: &str, decimal: u8) -> Option<f64> {
    let mark = char::from(decimal);
    let (integer, decimals) = match text.split_once(mark) {
        Some((integer, decimals)) => (integer, decimals),
        None if text.contains('\'') => (text, ""),
        None => return None,
    };
    let divider = match (integer.contains('\''), decimal) {
        (true, _) => '\'',
        (false, b',') => '.',
        (false, _) => ',',
    };
    let unsigned = integer.strip_prefix(['-', '+']).unwrap_or(integer);
    let groups: Vec<&str> = unsigned.split(divider).collect();
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    let whole = groups.len() > 1
        && (1..=3).contains(&groups[0].len())
        && groups[1..].iter().all(|group| group.len() == 3)
        && groups.iter().all(|group| digits(group))
        && digits(decimals);
    whole.then(|| {
        format!("{}.{decimals}0", integer.replace(divider, ""))
            .parse()
            .ok()
    })?
}

/// Metres of a kilometrage as 12+400.123 or km 12+400, for which three digits stand between plus and decimal mark.
pub(super) fn kilometrage(text: &str, decimal: u8) -> Option<f64> {
    let text = match text.get(..2) {
        Some(start) if start.eq_ignore_ascii_case("km") => {
            text[2..].trim_start_matches([' ', ':', '.'])
        }
        _ => text,
    };
    let (kilometres, metres) = text.split_once('+')?;
    let (whole, decimals) = metres
        .split_once(char::from(decimal))
        .unwrap_or((metres, ""));
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    let is_chainage = (1..=5).contains(&kilometres.len())
        && whole.len() == 3
        && [kilometres, whole, decimals].into_iter().all(digits);
    if !is_chainage {
        return None;
    }
    format!("{kilometres}{whole}.{decimals}0").parse().ok()
}

/// Whether a cell holds a kilometrage, whose number is in metres.
pub(super) fn is_kilometrage(cell: &[u8], decimal: u8) -> bool {
    std::str::from_utf8(unquoted(cell.trim_ascii()))
        .is_ok_and(|text| kilometrage(text, decimal).is_some())
}

/// Whether a cell says that there is no value.
pub(super) fn is_missing(cell: &[u8]) -> bool {
    const WORDS: [&[u8]; 12] = [
        b"", b"nan", b"-nan", b"na", b"n/a", b"null", b"none", b"-", b"--", b"inf", b"-inf",
        b"#n/a",
    ];
    WORDS.iter().any(|word| cell.eq_ignore_ascii_case(word))
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
            prop_assert_eq!(parse(text.as_bytes(), b'.'), Some(expected));
            let comma = text.replace('.', ",");
            prop_assert_eq!(parse(comma.as_bytes(), b','), Some(expected));
        }

        #[test]
        fn no_text_panics(text in prop::collection::vec(any::<u8>(), 0..20)) {
            let _ = parse(&text, b'.');
            let _ = parse(&text, b',');
        }
    }

    #[test]
    fn cells_hold_numbers_or_nothing() {
        assert_eq!(parse(b" 1.5e-3 ", b'.'), Some(1.5e-3));
        assert_eq!(parse(b"1,5e-3", b','), Some(1.5e-3));
        assert_eq!(
            parse(b"123456789012345678.5", b'.'),
            Some(123_456_789_012_345_680.0)
        );
        assert!(parse(b"NaN", b'.').is_some_and(f64::is_nan));
        assert!(parse(b"", b'.').is_some_and(f64::is_nan));
        assert_eq!(parse(b"2,5", b'.'), None);
        assert_eq!(parse(b"2.5", b','), None);
        assert_eq!(parse(b"abc", b'.'), None);
        assert_eq!(parse(b".", b'.'), None);
        assert_eq!(parse(b"\"1.5\"", b'.'), Some(1.5));
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
        ] {
            assert_eq!(parse(text.as_bytes(), decimal), Some(metres), "{text}");
        }
        // What may be something else is no number.
        for (text, decimal) in [
            ("12.400", b','),
            ("12,400", b'.'),
            ("12+40.1", b'.'),
            ("12+4000", b'.'),
            ("1,24,3", b'.'),
            ("12.40,123", b','),
            ("+400", b'x'),
        ] {
            assert_eq!(
                parse(text.as_bytes(), decimal).filter(|_| decimal != b'x'),
                None,
                "{text}"
            );
        }
    }
}
