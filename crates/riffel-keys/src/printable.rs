//! Texts of anybody as they may be shown on a terminal and in messages.

use std::borrow::Cow;

/// A text as it may be shown: characters that command a terminal or turn the direction of writing are written as
/// `\u{1b}`; line ends and tabulators stay.
pub fn printable(text: &str) -> Cow<'_, str> {
    escaped(text, commands(text))
}

/// A text as it may stand in a message: as [`printable`], with tabulators and carriage returns written out as well, so
/// that of the control characters only line feeds stay.
pub fn in_a_message(text: &str) -> Cow<'_, str> {
    let unseen = |&(_, character): &(usize, char)| is_command(character) || matches!(character, '\t' | '\r');
    escaped(text, text.char_indices().filter(unseen))
}

/// The text with these characters of it written out.
fn escaped(text: &str, characters: impl Iterator<Item = (usize, char)>) -> Cow<'_, str> {
    let mut shown = String::new();
    let mut done = 0;
    for (at, character) in characters {
        shown.push_str(&text[done..at]);
        match character {
            '\t' => shown.push_str("\\t"),
            other => shown.extend(other.escape_unicode()),
        }
        done = at + character.len_utf8();
    }
    if done == 0 {
        return Cow::Borrowed(text);
    }
    shown.push_str(&text[done..]);
    Cow::Owned(shown)
}

/// The text with other signs in place of those that [`printable`] escapes, each as many bytes as before: for an
/// excerpt in which places are counted in bytes.
pub(crate) fn printable_in_place(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut done = 0;
    for (at, command) in commands(text) {
        shown.push_str(&text[done..at]);
        shown.push(match command.len_utf8() {
            1 => '?',
            2 => '¿',
            _ => char::REPLACEMENT_CHARACTER,
        });
        done = at + command.len_utf8();
    }
    shown.push_str(&text[done..]);
    shown
}

/// The first character of a text that [`printable`] would escape.
pub(crate) fn command_in(text: &str) -> Option<char> {
    commands(text).next().map(|(_, command)| command)
}

/// Characters that [`printable`] escapes, and where they stand. A carriage return before a line feed is none.
fn commands(text: &str) -> impl Iterator<Item = (usize, char)> {
    text.char_indices()
        .filter(|&(at, character)| is_command(character) && !(character == '\r' && text[at + 1..].starts_with('\n')))
}

/// Whether a terminal obeys a character, or it turns the direction of writing.
fn is_command(character: char) -> bool {
    match character {
        '\n' | '\t' => false,
        '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        character => character.is_control(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_to_a_terminal_are_written_out() {
        assert_eq!(printable("a\u{1b}[2Jb\n"), "a\\u{1b}[2Jb\n");
        assert_eq!(printable("Höhe µm"), "Höhe µm");
        assert_eq!(printable("a\r\nb\rc"), "a\r\nb\\u{d}c");
        assert_eq!(printable("a\u{9b}\u{202e}"), "a\\u{9b}\\u{202e}");
        assert_eq!(printable("a\tb"), "a\tb");
        assert_eq!(in_a_message("a\tb\r\n\u{1b}c"), "a\\tb\\u{d}\n\\u{1b}c");
        let text = "a\u{1b}\u{9b}\u{202e}b";
        let shown = printable_in_place(text);
        assert_eq!((shown.len(), &shown[..]), (text.len(), "a?¿\u{fffd}b"));
    }
}
