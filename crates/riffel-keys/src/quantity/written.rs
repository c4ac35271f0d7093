//! A quantity as it was written.

use super::Kind;

/// A quantity as it was written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WrittenQuantity {
    /// The number.
    pub(crate) number: f64,
    /// Its unit, empty for a bare number.
    pub(crate) unit: String,
    /// The value in SI.
    pub(crate) si: f64,
}

impl WrittenQuantity {
    /// A bare number in SI.
    pub(crate) fn bare(si: f64) -> Self {
        Self { number: si, unit: String::new(), si }
    }

    /// Number and unit; a bare number with the unit in which it is read.
    pub(crate) fn in_words(&self, kind: &Kind) -> String {
        let unit = match self.unit.as_str() {
            "" => kind.unit,
            unit => unit,
        };
        match self.number.abs() {
            size if size != 0.0 && !(1e-6..1e12).contains(&size) => {
                format!("{:e} {unit}", self.number)
            }
            _ => format!("{} {unit}", self.number),
        }
        .trim_end()
        .to_owned()
    }
}
