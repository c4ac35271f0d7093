//! What can be wrong with a universal file.

use std::fmt;

use crate::{Message, Words, say};

/// A universal file that cannot be read, and why, in a sentence that begins with the line.
#[derive(Debug, Clone, PartialEq)]
#[expect(missing_docs, reason = "fields are what the sentences say")]
pub enum UniversalFileError {
    /// Nothing in it.
    NoDataset,
    /// Text before, between or after the datasets.
    Outside { line: usize },
    /// A dataset that the end of the file cuts short.
    Truncated { line: usize },
    /// A dataset that ends in its header.
    RecordMissing { line: usize, record: &'static str },
    /// A number of a dataset with a letter that has no meaning.
    UnknownForm { line: usize, text: String },
    /// Not an integer, or too large a one.
    Integer { line: usize, what: &'static str, text: String },
    /// Not a number, or not a finite one.
    Number { line: usize, what: &'static str, text: String },
    /// An integer that has no meaning where it stands.
    Choice { line: usize, what: &'static str, value: i32, allowed: Vec<i32> },
    /// Zero or negative.
    NotPositive { line: usize, what: &'static str, value: f64 },
    /// Something in a column between two fields.
    Gap { line: usize, column: usize },
    /// Units that contradict those before.
    OtherUnits { line: usize },
    /// Fewer values than announced.
    TooFew { line: usize, points: usize, numbers: usize, held: usize },
    /// More values than announced.
    TooMany { line: usize, points: usize, numbers: usize },
    /// A line that is not full although others follow.
    ShortLine { line: usize, needed: usize, held: usize },
    /// Text after the last field of a line.
    LongLine { line: usize, column: usize },
    /// Binary data of another length than announced, or cut short.
    BinaryEnd { line: usize, points: usize, bytes: usize },
    /// Two announcements that contradict each other.
    ByteCount { line: usize, declared: i32, bytes: usize },
}

/// In English.
impl fmt::Display for UniversalFileError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&Message::from(self).to_string())
    }
}

impl std::error::Error for UniversalFileError {}

impl From<&UniversalFileError> for Message {
    fn from(error: &UniversalFileError) -> Self {
        let (line, fault) = fault(error);
        match line {
            None => fault,
            Some(number) => fault.about(say!(at_line, number)),
        }
    }
}

fn in_words(what: &str) -> Words {
    Words::by_english("Field", what)
}

/// The line, and what is wrong there.
fn fault(error: &UniversalFileError) -> (Option<usize>, Message) {
    use UniversalFileError as Fault;
    let (line, said) = match error {
        Fault::NoDataset => return (None, say!(no_dataset)),
        Fault::Outside { line } => (line, say!(outside_of_datasets)),
        Fault::Truncated { line } => (line, say!(dataset_cut_short)),
        Fault::RecordMissing { line, record } => (line, say!(record_missing, record = in_words(record))),
        Fault::UnknownForm { line, text } => (line, say!(unknown_form_of_dataset, text)),
        Fault::Integer { line, what, text } => {
            let what = in_words(what);
            (line, say!(field_is_no_integer, what, text))
        }
        Fault::Number { line, what, text } => {
            let what = in_words(what);
            (line, say!(field_is_no_number, what, text))
        }
        Fault::Choice { line, what, value, allowed } => {
            let (what, value) = (in_words(what), f64::from(*value));
            let allowed = allowed.iter().map(|one| say!(number_alone, number = f64::from(*one)));
            let allowed = allowed.reduce(|one, other| say!(one_or_other, one, other));
            let allowed = allowed.unwrap_or_else(|| Message::verbatim(""));
            (line, say!(field_has_no_meaning, what, allowed, value))
        }
        Fault::NotPositive { line, what, value } => {
            let what = in_words(what);
            (line, say!(field_not_positive, what, value = *value))
        }
        Fault::Gap { line, column } => (line, say!(column_must_be_blank, column = *column)),
        Fault::OtherUnits { line } => (line, say!(units_stated_twice)),
        Fault::TooFew { line, points, numbers, held } => {
            (line, say!(too_few_numbers, points = *points, numbers = *numbers, held = *held))
        }
        Fault::TooMany { line, points, numbers } => {
            (line, say!(too_many_numbers, points = *points, numbers = *numbers))
        }
        Fault::ShortLine { line, needed, held } => (line, say!(line_lacks_numbers, needed = *needed, held = *held)),
        Fault::LongLine { line, column } => (line, say!(text_after_numbers, column = *column)),
        Fault::BinaryEnd { line, points, bytes } => {
            (line, say!(no_mark_behind_bytes, points = *points, bytes = *bytes))
        }
        Fault::ByteCount { line, declared, bytes } => {
            let declared = f64::from(*declared);
            (line, say!(other_count_of_bytes, declared, bytes = *bytes))
        }
    };
    (Some(*line), said)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Language;

    /// All literals of the readers that name a field or a record.
    #[test]
    fn every_field_and_record_has_its_german() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/universal_file");
        let mut count = 0;
        for file in ["ascii", "binary", "fields", "form", "mod", "signal"] {
            let source = std::fs::read_to_string(folder.join(format!("{file}.rs"))).unwrap();
            for literal in source.split('"').skip(1).step_by(2) {
                let is_field = ["the ", "a value", "record "].iter();
                if is_field.into_iter().any(|begin| literal.starts_with(begin)) {
                    assert!(in_words(literal).is_in(Language::German), "no German of {literal}");
                    count += 1;
                }
            }
        }
        assert!(count > 30, "{count}");
    }

    #[test]
    fn faults_are_said_in_german() {
        let fault = UniversalFileError::Choice { line: 7, what: "the byte order", value: 3, allowed: vec![1, 2] };
        let message = Message::from(&fault);
        assert_eq!(message.to_string(), "line 7: the byte order must be 1 or 2, not 3");
        let german = "Zeile 7: die Bytefolge muss 1 oder 2 sein, nicht 3";
        assert_eq!(message.text(Language::German), german);
    }
}
