//! The source model of the European directive: roughness and tables of transfer functions.

use riffel::Error;
use riffel::roughness::level;

use super::{FrequencyBand, REFERENCE_POWER};

/// Transfer function L_H \[dB\] by band: the level of sound power of one wheelset, re 1 pW, less that of the roughness
/// between wheel and rail, re 1 µm.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferFunction {
    levels: Vec<(FrequencyBand, f64)>,
}

impl TransferFunction {
    /// A transfer function by band, in any order.
    ///
    /// # Errors
    /// [`Error::Measurement`] where there is no band, a level is not finite, or a band is there twice.
    pub fn new(levels: impl IntoIterator<Item = (FrequencyBand, f64)>) -> Result<Self, Error> {
        let mut levels: Vec<(FrequencyBand, f64)> = levels.into_iter().collect();
        let wrong = |index, rule| Err(Error::Measurement { index, rule });
        if levels.is_empty() {
            return wrong(0, "a transfer function must have a band");
        }
        if let Some(index) = levels.iter().position(|(_, level)| !level.is_finite()) {
            return wrong(index, "a level must be finite");
        }
        levels.sort_by_key(|(band, _)| *band);
        match levels.windows(2).position(|pair| pair[0].0 == pair[1].0) {
            Some(index) => wrong(index + 1, "a band must be there once"),
            None => Ok(Self { levels }),
        }
    }

    /// L_H \[dB\] in a band, if the table has it.
    pub fn level(&self, band: FrequencyBand) -> Option<f64> {
        let place = self.levels.binary_search_by_key(&band, |level| level.0);
        place.ok().map(|index| self.levels[index].1)
    }

    /// Sound power of one wheelset \[W\] that roughness of some mean square \[m²\] in a band makes.
    pub fn power(&self, band: FrequencyBand, roughness: f64) -> Option<f64> {
        let sum = self.level(band)? + level(roughness);
        Some(REFERENCE_POWER * 10f64.powf(0.1 * sum))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_add_up() -> Result<(), Error> {
        let band = FrequencyBand::new(30);
        let table = TransferFunction::new([(band, 100.0)])?;
        // 1 µm is 0 dB, and 100 dB re 1 pW are 10 mW.
        assert!((table.power(band, 1e-12).unwrap() - 0.01).abs() < 1e-9);
        assert!((table.power(band, 1e-11).unwrap() - 0.1).abs() < 1e-8);
        assert_eq!(table.power(FrequencyBand::new(31), 1e-12), None);
        assert!(TransferFunction::new([(band, 1.0), (band, 2.0)]).is_err());
        assert!(TransferFunction::new([]).is_err());
        Ok(())
    }
}
