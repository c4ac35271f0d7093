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

    /// First and last position of some rails \[m\].
    pub(crate) fn ends(rails: &[Self]) -> [f64; 2] {
        let all = || rails.iter().flat_map(|rail| &rail.stretches);
        let last = |stretch: &Profile| stretch.position(stretch.heights().len() - 1);
        let from = all().map(Profile::start).fold(f64::INFINITY, f64::min);
        [from, all().map(last).fold(f64::NEG_INFINITY, f64::max)]
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
