//! Numbers with the decimal comma.

/// Words with the decimal comma in their numbers. What stands in quotation marks or code, names of files and keys stay:
/// only a point between digits, in a word without a point before a letter, is that of a number.
pub fn with_comma(words: &str) -> String {
    let mut written = String::with_capacity(words.len());
    let mut quoted = None;
    for word in words.split_inclusive(' ') {
        let letter_after_point = word
            .as_bytes()
            .windows(2)
            .any(|pair| pair[0] == b'.' && pair[1].is_ascii_alphabetic());
        let whole = letter_after_point || word.contains(['_', '/', '=']);
        let mut before = None;
        let mut letters = word.chars().peekable();
        while let Some(letter) = letters.next() {
            match (letter, quoted) {
                ('"' | '`', None) => quoted = Some(letter),
                (mark, Some(open)) if mark == open => quoted = None,
                _ => {}
            }
            let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
            let is_point = letter == '.' && digit(before) && digit(letters.peek().copied());
            written.push(if is_point && !whole && quoted.is_none() {
                ','
            } else {
                letter
            });
            before = Some(letter);
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::with_comma;

    #[test]
    fn names_and_what_is_quoted_stay() {
        assert_eq!(
            with_comma("14.8 dB, 2.35e-5 m4, ±0.5"),
            "14,8 dB, 2,35e-5 m4, ±0,5"
        );
        let kept = "u2.1.csv net-0.5/a x=0.5 `a.1.2` \"5.0 kg, 1.5\" spacing_0.5";
        assert_eq!(with_comma(kept), kept);
        assert_eq!(with_comma("\"5.0 kg\" or 1.5"), "\"5.0 kg\" or 1,5");
    }
}
