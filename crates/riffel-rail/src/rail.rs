//! A measured rail.

use jiff::civil::Date;
use riffel::roughness::Profile;

/// One rail, or one line of measurement.
#[derive(Debug, Clone, PartialEq)]
pub struct Rail {
    /// Its name.
    pub name: String,
    /// Its stretches without gaps, by position.
    pub stretches: Vec<Profile>,
}

impl Rail {
    /// Length of all stretches \[m\].
    pub fn length(&self) -> f64 {
        self.stretches.iter().map(Profile::length).sum()
    }
}

/// Rails as they were at a date before the last.
#[derive(Debug, Clone, PartialEq)]
pub struct EarlierRails {
    /// The date.
    pub date: Date,
    /// The rails.
    pub rails: Vec<Rail>,
}
