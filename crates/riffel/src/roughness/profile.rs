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
            return Err(Error::Measurement { index: heights.len(), rule: "a profile must have at least two heights" });
        }
        match heights.iter().position(|height| !height.is_finite()) {
            Some(index) => Err(Error::Measurement { index, rule: "a height must be finite" }),
            None => Ok(Self { start, spacing, heights }),
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

    /// The heights at positions from `from` up to but without `to` \[m\]; `None` if these are fewer than two.
    pub fn between(&self, from: f64, to: f64) -> Option<Self> {
        /// Part of a step by which rounding may move a position.
        const ROUNDING: f64 = 1e-3;
        let count = self.heights.len();
        // Numbers below zero become zero.
        let index = |position: f64| (((position - self.start) / self.spacing - ROUNDING).ceil() as usize).min(count);
        let heights = self.heights.get(index(from)..index(to))?;
        Self::new(self.position(index(from)), self.spacing, heights.to_vec()).ok()
    }

    /// Position \[m\] of the height `index`.
    pub fn position(&self, index: usize) -> f64 {
        self.start + index as f64 * self.spacing
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_has_the_heights_between_its_ends() {
        let heights: Vec<f64> = (0..1000).map(f64::from).collect();
        let profile = Profile::new(12_450.0, 1e-3, heights).unwrap();
        let part = profile.between(12_450.1, 12_450.3).unwrap();
        assert_eq!(part.heights().len(), 200);
        assert_eq!(part.heights()[0], 100.0);
        assert!((part.start() - 12_450.1).abs() < 1e-9);
        assert_eq!(profile.between(0.0, f64::INFINITY).unwrap(), profile);
        assert_eq!(profile.between(12_450.5, 12_450.2), None);
        assert_eq!(profile.between(12_460.0, 12_470.0), None);
    }
}
