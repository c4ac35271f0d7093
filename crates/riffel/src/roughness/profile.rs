//! A longitudinal profile.

use crate::Error;

/// Heights of the rail's running surface at equal steps along it, without a gap.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    start: f64,
    spacing: f64,
    pub(super) heights: Vec<f64>,
}

impl Profile {
    /// A profile that begins at the position `start` \[m\], with heights \[m\] positive upward every
    /// `spacing` \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the spacing is above zero; [`Error::Measurement`] for fewer than two
    /// heights or one that is not finite.
    pub fn new(start: f64, spacing: f64, heights: Vec<f64>) -> Result<Self, Error> {
        Error::unless_positive("sample spacing", spacing, "m")?;
        if heights.len() < 2 {
            return Err(Error::Measurement {
                index: heights.len(),
                rule: "a profile must have at least two heights",
            });
        }
        match heights.iter().position(|height| !height.is_finite()) {
            Some(index) => Err(Error::Measurement {
                index,
                rule: "a height must be finite",
            }),
            None => Ok(Self {
                start,
                spacing,
                heights,
            }),
        }
    }

    /// Position of the first height \[m\].
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Step between two heights \[m\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// The heights \[m\], positive upward.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Length of rail that the heights stand for \[m\]: their number times their step.
    pub fn length(&self) -> f64 {
        self.heights.len() as f64 * self.spacing
    }

    /// Position \[m\] of the height `index`.
    pub fn position(&self, index: usize) -> f64 {
        self.start + index as f64 * self.spacing
    }
}
