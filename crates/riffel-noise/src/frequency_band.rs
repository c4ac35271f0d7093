//! One-third octaves of frequency.

use riffel::roughness::{NOMINAL_OF_DECADE, ThirdOctave};

/// A base-ten one-third octave: centre 10^(n/10) Hz, edges 10^(±1/20) about it (IEC 61260-1:2014).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FrequencyBand {
    index: i32,
}

impl FrequencyBand {
    /// 100 Hz, the lowest band of measured track decay rates.
    pub const LOWEST: Self = Self::new(20);
    /// 5 kHz, the highest of them.
    pub const HIGHEST: Self = Self::new(37);

    /// The band whose centre is 10^(`index`/10) Hz.
    pub const fn new(index: i32) -> Self {
        Self { index }
    }

    /// The 18 bands 100–5000 Hz, the lowest first.
    pub fn all() -> impl Iterator<Item = Self> {
        (Self::LOWEST.index..=Self::HIGHEST.index).map(Self::new)
    }

    /// The band in which a frequency \[Hz\] lies; none unless it is finite and above zero.
    pub fn containing(frequency: f64) -> Option<Self> {
        (frequency > 0.0 && frequency.is_finite()).then(|| Self::new((10.0 * frequency.log10()).round() as i32))
    }

    /// The n of the centre 10^(n/10) Hz.
    pub const fn index(self) -> i32 {
        self.index
    }

    /// Exact centre \[Hz\].
    pub fn centre(self) -> f64 {
        10f64.powf(0.1 * f64::from(self.index))
    }

    /// Lowest and highest frequency \[Hz\].
    pub fn range(self) -> (f64, f64) {
        let half = 10f64.powf(ThirdOctave::HALF_WIDTH_DECADES);
        (self.centre() / half, self.centre() * half)
    }

    /// Nominal centre \[Hz\]: 3150 for 3162 Hz.
    pub fn nominal(self) -> f64 {
        let (decade, place) = (self.index.div_euclid(10), self.index.rem_euclid(10));
        NOMINAL_OF_DECADE[place as usize] * 10f64.powi(decade)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nominal_frequencies_lie_in_their_bands() {
        let nominal: Vec<f64> = FrequencyBand::all().map(FrequencyBand::nominal).collect();
        assert_eq!(nominal, riffel::receptance::DecayRate::NOMINAL_FREQUENCIES.to_vec());
        for band in FrequencyBand::all() {
            assert_eq!(FrequencyBand::containing(band.nominal()), Some(band));
            let (low, high) = band.range();
            assert!((high / low - 10f64.powf(0.1)).abs() < 1e-12);
        }
        assert_eq!(FrequencyBand::containing(0.0), None);
    }
}
