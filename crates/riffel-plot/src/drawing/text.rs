//! Text: the width of words, line breaking, numbers.

use super::font::{self, Weight};

/// Font size of axis titles, pixels (96 per inch): 9.75 pt.
pub(crate) const TITLE_FONT: f64 = 13.0;
/// Font size of tick labels, pixels: 9 pt.
pub(crate) const TICK_FONT: f64 = 12.0;

/// Width of a text in pixels for a font size in pixels.
pub(crate) fn width(text: &str, size: f64, weight: Weight) -> f64 {
    font::set(text, size, weight).1
}

/// Breaks a text into lines no wider than `limit` pixels. Line breaks of the text are kept; a word wider than the
/// limit is broken too.
pub(crate) fn wrap(text: &str, size: f64, weight: Weight, limit: f64) -> Vec<String> {
    let fits = |words: &str| width(words, size, weight) <= limit;
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split(' ').filter(|word| !word.is_empty()) {
            let candidate = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            if fits(&candidate) {
                line = candidate;
                continue;
            }
            if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
            for character in word.chars() {
                line.push(character);
                if !fits(&line) && line.chars().count() > 1 {
                    line.pop();
                    lines.push(std::mem::replace(&mut line, character.to_string()));
                }
            }
        }
        if !line.is_empty() {
            lines.push(line);
        }
    }
    lines
}

/// A text without the characters that XML forbids.
pub(crate) fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') { ' ' } else { c }).collect()
}

/// A text for XML and HTML, in an element or in a quoted attribute.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in printable(text).chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            other => out.push(other),
        }
    }
    out
}

/// A number with a fixed count of decimals, a true minus sign, and no minus before zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| c == '0' || c == '.') => digits.to_owned(),
        Some(digits) => format!("\u{2212}{digits}"),
        None => text,
    }
}

/// A power of ten, `10⁻⁹`.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    let raised: String = exponent.to_string().chars().map(superscript).collect();
    format!("10{raised}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_in_print() {
        assert_eq!(fixed(20.0, 0), "20");
        assert_eq!(fixed(-0.25, 2), "−0.25");
        assert_eq!(fixed(-0.001, 2), "0.00");
        assert_eq!(power_of_ten(-9), "10⁻⁹");
        assert_eq!(power_of_ten(13), "10¹³");
    }

    #[test]
    fn lines_keep_within_the_limit() {
        let text = "Growth is negative Re Ŵ₁ in the sense of the paper, and the ridge is the strongest growth.";
        let lines = wrap(text, 12.0, Weight::Regular, 200.0);
        assert!(lines.len() > 2);
        assert!(lines.iter().all(|line| width(line, 12.0, Weight::Regular) <= 200.0));
        assert_eq!(lines.join(" "), text);
        assert_eq!(wrap("one\ntwo", 12.0, Weight::Regular, 200.0), ["one", "two"]);
        assert!(wrap("", 12.0, Weight::Regular, 200.0).is_empty());
        let word = "left_rail_".repeat(20);
        let lines = wrap(&word, 12.0, Weight::Regular, 200.0);
        assert!(lines.iter().all(|line| width(line, 12.0, Weight::Regular) <= 200.0));
        assert_eq!(lines.concat(), word);
    }

    #[test]
    fn markup_is_escaped_and_control_characters_vanish() {
        assert_eq!(escape("a<b & \"c\"\u{0}"), "a&lt;b &amp; &quot;c&quot; ");
    }
}
