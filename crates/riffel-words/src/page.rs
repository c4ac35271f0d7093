//! A report in German.

use crate::catalogue::in_german;
use crate::numbers::with_comma;

/// An HTML page of ours with its words in German, as far as the catalogue has them; markup, styles and values stay.
pub fn page_in_german(html: &str) -> String {
    let mut page = String::with_capacity(html.len() + html.len() / 8);
    let mut rest = html;
    while let Some((words, after)) = rest.split_once('<') {
        page.push_str(&of_words(words));
        let end = match after.split_once(['>', ' ']) {
            Some(("style" | "code", _)) => after.find("</").unwrap_or(after.len()),
            _ => after.find('>').map_or(after.len(), |end| end + 1),
        };
        page.push('<');
        page.push_str(&after[..end]);
        rest = &after[end..];
    }
    page.push_str(&of_words(rest));
    page.replacen("<html lang=\"en\">", "<html lang=\"de\">", 1)
}

/// The words between two tags; a sentence that markup divides begins or ends with a comma or a colon.
fn of_words(escaped: &str) -> String {
    let plain = escaped
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&amp;", "&");
    let inner = plain.trim_matches(|c: char| c.is_whitespace() || c == ',' || c == ':');
    if inner.is_empty() {
        return escaped.to_owned();
    }
    // As in "rail left: EN 1: <b>over the limit</b>": the rest is a name, which stays.
    let place = || {
        let (place, _) = inner.split_once(": ")?;
        let divided = plain.trim_end().ends_with(':');
        divided.then(|| Some(plain.replacen(place, &in_german(place)?, 1)))?
    };
    let german = in_german(&plain)
        .or_else(|| Some(plain.replacen(inner, &in_german(inner)?, 1)))
        .or_else(place);
    match german {
        Some(german) => german
            .replace('&', "&amp;")
            .replace('<', "&lt;")
            .replace('>', "&gt;")
            .replace('"', "&quot;"),
        None if is_of_numbers(inner) => with_comma(escaped),
        None => escaped.to_owned(),
    }
}

/// Whether words are numbers and units alone, as of a cell or an axis; a version or a date is none.
fn is_of_numbers(words: &str) -> bool {
    const UNITS: [&str; 6] = ["mm", "µm", "Hz", "km/h", "km/h:", "dB(A)"];
    let is_number = |word: &str| {
        word.chars()
            .all(|c| c.is_ascii_digit() || "+-−±.e%".contains(c))
            && word.matches('.').count() < 2
    };
    words
        .split([' ', '–'])
        .all(|word| UNITS.contains(&word) || is_number(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_german_and_markup_stays() {
        let page = page_in_german(
            "<html lang=\"en\"><style>left {}</style><h2>3 Growth forecast of none</h2><li>rail left: EN 1: <span class=\"bad\">over the limit</span>, \
             3 of 12 bands, at worst by 1.5 dB at 40 mm</li><td>-8.2 dB(A)</td><td>37.8–75.6</td><td>0.1.0</td><p>&quot;a&quot; is not one of its choices</p>",
        );
        assert_eq!(
            page,
            "<html lang=\"de\"><style>left {}</style><h2>3 Growth forecast of none</h2><li>Schiene links: EN 1: <span class=\"bad\">über der Grenze</span>, \
             3 von 12 Bändern, am meisten um 1,5 dB bei 40 mm</li><td>-8,2 dB(A)</td><td>37,8–75,6</td><td>0.1.0</td><p>&quot;a&quot; steht nicht zur Wahl</p>"
        );
    }
}
