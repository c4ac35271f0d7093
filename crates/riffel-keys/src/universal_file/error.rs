//! What can be wrong with a universal file.

use thiserror::Error;

/// A universal file that cannot be read, and why, in a sentence that begins with the line.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "fields are what the sentences say")]
pub enum UniversalFileError {
    /// Nothing in it.
    #[error("the file holds no dataset, which would begin with -1 in columns 5 and 6")]
    NoDataset,
    /// Text before, between or after the datasets.
    #[error(
        "line {line}: this stands outside of the datasets, which begin and end with -1 in columns \
         5 and 6"
    )]
    Outside { line: usize },
    /// A dataset that the end of the file cuts short.
    #[error("line {line}: the dataset that begins here is cut short by the end of the file")]
    Truncated { line: usize },
    /// A dataset that ends in its header.
    #[error("line {line}: the dataset ends where its {record} must stand")]
    RecordMissing { line: usize, record: &'static str },
    /// A number of a dataset with a letter that has no meaning.
    #[error("line {line}: column 7 must be blank, or \"b\" in a dataset 58, not \"{text}\"")]
    UnknownForm { line: usize, text: String },
    /// Not an integer, or too large a one.
    #[error("line {line}: {what} must be a whole number within 32 bits, not \"{text}\"")]
    Integer {
        line: usize,
        what: &'static str,
        text: String,
    },
    /// Not a number, or not a finite one.
    #[error("line {line}: {what} must be a finite number, not \"{text}\"")]
    Number {
        line: usize,
        what: &'static str,
        text: String,
    },
    /// An integer that has no meaning where it stands.
    #[error("line {line}: {what} must be {allowed}, not {value}")]
    Choice {
        line: usize,
        what: &'static str,
        value: i32,
        allowed: String,
    },
    /// Zero or negative.
    #[error("line {line}: {what} must be positive, not {value}")]
    NotPositive {
        line: usize,
        what: &'static str,
        value: f64,
    },
    /// Something in a column between two fields.
    #[error("line {line}: column {column} must be blank, as it lies between two fields")]
    Gap { line: usize, column: usize },
    /// Units that contradict those before.
    #[error("line {line}: the file states its units a second time, and differently")]
    OtherUnits { line: usize },
    /// Fewer values than announced.
    #[error(
        "line {line}: the number of points is {points}, which takes {numbers} numbers, but the \
         dataset holds {held}"
    )]
    TooFew {
        line: usize,
        points: usize,
        numbers: usize,
        held: usize,
    },
    /// More values than announced.
    #[error(
        "line {line}: the number of points is {points}, which takes {numbers} numbers, but the \
         dataset goes on after them"
    )]
    TooMany {
        line: usize,
        points: usize,
        numbers: usize,
    },
    /// A line that is not full although others follow.
    #[error("line {line}: this line must hold {needed} numbers, not {held}")]
    ShortLine {
        line: usize,
        needed: usize,
        held: usize,
    },
    /// Text after the last field of a line.
    #[error("line {line}: the numbers of this line end in column {column}, but text follows")]
    LongLine { line: usize, column: usize },
    /// Binary data of another length than announced, or cut short.
    #[error(
        "line {line}: the number of points is {points}, which takes {bytes} bytes, but the closing \
         -1 does not follow them"
    )]
    BinaryEnd {
        line: usize,
        points: usize,
        bytes: usize,
    },
    /// Two announcements that contradict each other.
    #[error("line {line}: the number of bytes is {declared}, but the points take {bytes}")]
    ByteCount {
        line: usize,
        declared: i32,
        bytes: usize,
    },
}
