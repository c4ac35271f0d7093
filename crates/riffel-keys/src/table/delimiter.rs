//! What stands between cells, and before decimals.

use crate::{Message, say};
use serde::{Deserialize, Serialize};

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Delimiter {
    /// A comma.
    Comma,
    /// A semicolon.
    Semicolon,
    /// A tabulator.
    Tab,
    /// One or more blanks or tabulators.
    Space,
}

/// What stands before the decimals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DecimalMark {
    /// A point.
    #[default]
    Point,
    /// A comma.
    Comma,
}

impl Delimiter {
    /// The byte that it is.
    pub const fn byte(self) -> u8 {
        match self {
            Self::Comma => b',',
            Self::Semicolon => b';',
            Self::Tab => b'\t',
            Self::Space => b' ',
        }
    }

    /// In words, as in "separated by semicolons".
    pub fn words(self) -> Message {
        match self {
            Self::Comma => say!(commas),
            Self::Semicolon => say!(semicolons),
            Self::Tab => say!(tabs),
            Self::Space => say!(blanks),
        }
    }
}

impl DecimalMark {
    /// The byte that it is.
    pub const fn byte(self) -> u8 {
        match self {
            Self::Point => b'.',
            Self::Comma => b',',
        }
    }

    /// The one that it is not.
    pub const fn other(self) -> Self {
        match self {
            Self::Point => Self::Comma,
            Self::Comma => Self::Point,
        }
    }

    /// In words.
    pub fn words(self) -> Message {
        match self {
            Self::Point => say!(decimal_point),
            Self::Comma => say!(decimal_comma),
        }
    }
}
