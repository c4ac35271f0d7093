//! A dipped weld.

use std::f64::consts::TAU;

use super::Profile;
use crate::Error;

/// A dip of a rail, −D/2 (1 − cos 2πx/L) over its length L: a versed sine, without a kink at its ends.
///
/// The shape is chosen: it has but two parameters. Its largest slope is πD/L, which measured forces at welds follow far better than
/// the depth (Steenbergen & Esveld, Journal of Rail and Rapid Transit 220 (2006), doi:10.1243/0954409JRRT87). Measured welds
/// also have short waves, and the rail ends of a joint a kink and a gap, which it has not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weld {
    /// Depth D \[m\].
    pub depth: f64,
    /// Length L \[m\].
    pub length: f64,
}

impl Weld {
    /// The weld in the middle of a smooth profile of about the given length, with heights every `spacing` or closer, both
    /// \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a depth or length that is not above zero, a spacing above an eighth of the length and a profile
    /// shorter than two of it.
    pub fn profile(self, length: f64, spacing: f64) -> Result<Profile, Error> {
        Error::unless_positive("depth of the weld", self.depth, "m")?;
        Error::unless_positive("length of the weld", self.length, "m")?;
        Error::unless_positive("sample spacing", spacing, "m")?;
        let refuse = |quantity, value, rule| Error::OutOfRange { quantity, value, unit: "m", rule };
        if spacing > self.length / 8.0 {
            let rule = "must be an eighth of the length of the weld or less";
            return Err(refuse("sample spacing", spacing, rule));
        }
        if length < 2.0 * self.length {
            let rule = "must be twice the length of the weld or more";
            return Err(refuse("length of the profile", length, rule));
        }
        let count = (length / spacing).ceil();
        let spacing = length / count;
        let height = |index: usize| {
            let place = (index as f64 * spacing - 0.5 * length) / self.length;
            match place.abs() < 0.5 {
                true => -0.5 * self.depth * (1.0 + (TAU * place).cos()),
                false => 0.0,
            }
        };
        Profile::new(0.0, spacing, (0..count as usize).map(height).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weld_has_its_depth_and_slope() -> Result<(), Error> {
        let weld = Weld { depth: 0.3e-3, length: 0.5 };
        let profile = weld.profile(4.0, 1e-3)?;
        let heights = profile.heights();
        assert_eq!(heights.len(), 4000);
        assert!((heights[2000] + 0.3e-3).abs() < 1e-15);
        assert_eq!((heights[1750], heights[2250]), (0.0, 0.0));
        let slopes = heights.windows(2).map(|pair| (pair[1] - pair[0]) / 1e-3);
        let steepest = slopes.fold(0.0, f64::max);
        let exact = std::f64::consts::PI * weld.depth / weld.length;
        assert!((steepest / exact - 1.0).abs() < 1e-4);
        assert!(weld.profile(0.9, 1e-3).is_err());
        assert!(weld.profile(4.0, 0.1).is_err());
        assert!(Weld { depth: 0.0, ..weld }.profile(4.0, 1e-3).is_err());
        Ok(())
    }
}
