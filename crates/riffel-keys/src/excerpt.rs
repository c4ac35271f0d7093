//! Texts of any length in messages of bounded length: a key or a line may be a megabyte long.

use std::borrow::Cow;
use std::ops::Range;

use crate::printable::{printable, printable_in_place};

/// Most characters of what a user wrote in a message.
const IN_A_MESSAGE: usize = 600;
/// Most bytes of a line of a file that is shown; marks are drawn below it, at most 65 535 columns wide.
const IN_A_LINE: usize = 400;
/// Bytes before what is wrong that are kept of a longer line.
const BEFORE: usize = 80;

/// The text as it may be shown, its middle left out where it is too long for a message.
pub fn clipped(text: &str) -> Cow<'_, str> {
    let shown = printable(text);
    let text = &*shown;
    let length = text.chars().count();
    if length <= IN_A_MESSAGE {
        return shown;
    }
    let (begin, end) = (IN_A_MESSAGE * 2 / 3, IN_A_MESSAGE / 3);
    let beginning: String = text.chars().take(begin).collect();
    let ending: String = text.chars().skip(length - end).collect();
    Cow::Owned(format!("{beginning} … {ending}"))
}

/// The text as it may be shown, with its overlong lines cut, as many as before, and where the range in it has gone.
pub(crate) fn excerpt(text: &str, range: Range<usize>) -> (String, Range<usize>) {
    let text = &*printable_in_place(text);
    if text.split('\n').all(|line| line.len() <= IN_A_LINE) {
        return (text.to_owned(), range);
    }
    let mut cut = String::new();
    let (mut from, mut to) = (0, 0);
    let mut begin = 0;
    for line in text.split_inclusive('\n') {
        let end = begin + line.len();
        let holds_it = (begin..end).contains(&range.start) || (range.start == text.len() && end == text.len());
        let mut kept = begin..end;
        if line.len() > IN_A_LINE {
            if holds_it {
                kept.start = begin.max(range.start.saturating_sub(BEFORE));
            }
            kept.end = end.min(kept.start + IN_A_LINE);
            while !text.is_char_boundary(kept.start) {
                kept.start -= 1;
            }
            while !text.is_char_boundary(kept.end) {
                kept.end -= 1;
            }
        }
        if holds_it {
            from = cut.len() + range.start - kept.start;
            to = cut.len() + range.end.clamp(range.start, kept.end.max(range.start)) - kept.start;
        }
        cut.push_str(&text[kept.clone()]);
        if kept.end < end && line.ends_with('\n') {
            cut.push('\n');
        }
        begin = end;
    }
    (cut, from..to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_texts_stay_as_they_are() {
        assert_eq!(clipped("friction"), "friction");
        assert_eq!(excerpt("a = 1\nb = 2\n", 6..7), ("a = 1\nb = 2\n".to_owned(), 6..7));
    }

    #[test]
    fn long_texts_keep_both_ends() {
        let long = format!("begin{}end", "ä".repeat(100_000));
        let short = clipped(&long);
        assert!(short.starts_with("begin") && short.ends_with("end") && short.contains(" … "));
        assert!(short.chars().count() < 700);
    }

    /// What is pointed at is still pointed at, in a line of the same number.
    #[test]
    fn long_lines_are_cut_around_what_is_wrong() {
        let long = "ü".repeat(50_000);
        let text = format!("# {long}\nfirst = 1\n{long} wrong {long}\nlast = 2\n");
        let at = text.find("wrong").unwrap();
        let (cut, range) = excerpt(&text, at..at + 5);
        assert_eq!(&cut[range.clone()], "wrong");
        assert_eq!(cut[..range.start].matches('\n').count(), 2);
        assert_eq!(cut.lines().count(), 4);
        assert!(cut.len() < 2000);
        // A range that is itself too long is shown from its beginning; one at the end of the text is kept.
        let (cut, range) = excerpt(&text, 0..text.len() - 3);
        assert!(range.start == 0 && range.end <= cut.len());
        let (cut, range) = excerpt(&long, long.len()..long.len());
        assert!(range.end <= cut.len() && cut.is_char_boundary(range.start));
    }
}
