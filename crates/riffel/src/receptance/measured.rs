//! A receptance that was measured.

use num_complex::Complex64;

use super::Receptance;
use crate::Error;

/// A receptance given at some frequencies, from a measurement or another program.
///
/// Between them it is interpolated linearly in the logarithm of frequency, real and imaginary part
/// alike, which keeps a passive receptance passive. Outside its frequencies it is not a number: ask
/// [`frequency_range`](Receptance::frequency_range) first.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredReceptance {
    /// ln ω.
    logarithms: Vec<f64>,
    receptances: Vec<Complex64>,
    range: (f64, f64),
}

impl MeasuredReceptance {
    /// Receptances \[m/N\] at angular frequencies ω \[rad/s\], as many as these.
    ///
    /// # Errors
    /// [`Error::Measurement`] unless there are two frequencies or more, all finite and positive and
    /// each above the one before, and every receptance is finite.
    pub fn new(angular_frequencies: &[f64], receptances: Vec<Complex64>) -> Result<Self, Error> {
        let wrong = |index: usize, rule: &'static str| Err(Error::Measurement { index, rule });
        if angular_frequencies.len() < 2 {
            return wrong(0, "a measured receptance needs two frequencies or more");
        }
        if receptances.len() != angular_frequencies.len() {
            return wrong(0, "there must be one receptance for each frequency");
        }
        let mut before = 0.0;
        for (index, (&w, h)) in angular_frequencies.iter().zip(&receptances).enumerate() {
            if !(w.is_finite() && w > 0.0) {
                return wrong(index, "a frequency must be finite and above zero");
            }
            if w <= before {
                return wrong(index, "frequencies must rise, each above the one before");
            }
            if !h.is_finite() {
                return wrong(index, "a receptance must be finite");
            }
            before = w;
        }
        Ok(Self {
            logarithms: angular_frequencies.iter().map(|w| w.ln()).collect(),
            receptances,
            range: (angular_frequencies[0], before),
        })
    }

    /// Angular frequencies \[rad/s\] at which the track would give energy away, Im H > 0: a passive
    /// structure cannot, so the phase of the measurement, its sign convention or its noise is at
    /// fault there.
    pub fn active(&self) -> impl Iterator<Item = f64> {
        self.logarithms.iter().zip(&self.receptances).filter(|(_, h)| h.im > 0.0).map(|(logarithm, _)| logarithm.exp())
    }

    /// Angular frequencies \[rad/s\] and receptances \[m/N\], as given.
    pub fn lines(&self) -> impl Iterator<Item = (f64, Complex64)> {
        self.logarithms.iter().map(|logarithm| logarithm.exp()).zip(self.receptances.iter().copied())
    }

    /// Receptance of the opposite sign, for a displacement that is counted the other way.
    pub fn negated(&self) -> Self {
        let mut negated = self.clone();
        for receptance in &mut negated.receptances {
            *receptance = -*receptance;
        }
        negated
    }

    /// Number of frequencies.
    pub fn points(&self) -> usize {
        self.receptances.len()
    }
}

impl Receptance for MeasuredReceptance {
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        /// A frequency on the edge of the range may come back from V/λ a rounding outside it.
        const ROUNDING: f64 = 1e-12;
        let (lowest, highest) = self.range;
        if !(angular_frequency >= lowest * (1.0 - ROUNDING) && angular_frequency <= highest * (1.0 + ROUNDING)) {
            return Complex64::new(f64::NAN, f64::NAN);
        }
        let logarithm = angular_frequency.ln();
        let last = self.logarithms.len() - 1;
        let above = self.logarithms.partition_point(|&other| other <= logarithm).clamp(1, last);
        let (low, high) = (self.logarithms[above - 1], self.logarithms[above]);
        let t = (logarithm - low) / (high - low);
        self.receptances[above - 1] * (1.0 - t) + self.receptances[above] * t
    }

    fn frequency_range(&self) -> (f64, f64) {
        self.range
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(frequencies: &[f64]) -> Result<MeasuredReceptance, Error> {
        let receptances = frequencies.iter().map(|&w| Complex64::new(w.ln(), -1.0 - 0.1 * w.ln())).collect();
        MeasuredReceptance::new(frequencies, receptances)
    }

    /// A line in ln ω is interpolated to rounding.
    #[test]
    fn linear_in_the_logarithm_of_frequency() {
        let track = measured(&[100.0, 250.0, 3000.0]).unwrap();
        for w in [100.0, 101.0, 250.0, 900.0, 3000.0] {
            let h = track.receptance(w, 0.0);
            assert!((h.re - w.ln()).abs() < 1e-13, "{w}: {h}");
        }
        assert_eq!(track.frequency_range(), (100.0, 3000.0));
    }

    #[test]
    fn nothing_outside_its_frequencies() {
        let track = measured(&[100.0, 3000.0]).unwrap();
        assert!(track.receptance(99.9, 0.0).is_nan());
        assert!(track.receptance(3000.1, 0.0).is_nan());
    }

    #[test]
    fn refuses_what_is_no_measurement() {
        assert!(measured(&[100.0]).is_err());
        for wrong in
            [[0.0, 1.0, 2.0], [1.0, 1.0, 2.0], [1.0, 3.0, 2.0], [1.0, 2.0, f64::NAN], [1.0, 2.0, f64::INFINITY]]
        {
            assert!(measured(&wrong).is_err(), "{wrong:?}");
        }
        let nan = Complex64::new(f64::NAN, 0.0);
        assert!(MeasuredReceptance::new(&[1.0, 2.0], vec![Complex64::ONE, nan]).is_err());
    }

    #[test]
    fn says_where_it_is_not_passive() {
        let receptances = vec![-Complex64::i(), Complex64::i(), -Complex64::i()];
        let track = MeasuredReceptance::new(&[1.0, 2.0, 3.0], receptances).unwrap();
        let active: Vec<f64> = track.active().collect();
        assert_eq!(active.len(), 1);
        assert!((active[0] - 2.0).abs() < 1e-15);
    }
}
