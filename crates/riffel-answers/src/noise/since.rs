//! What has changed since an earlier roughness, and how far sums of bands reach.

use riffel_keys::{Message, fixed, number, say};
use riffel_noise::{Energies, Part};
use serde::Serialize;

use super::nominal;

/// Frequency that a sum must reach to count as the level of a train \[Hz\]: chosen, as rolling noise is loudest below it.
const WHOLE: f64 = 2000.0;

/// The level before and now over the bands that both have.
#[derive(Debug, Serialize)]
pub struct Since {
    /// Nominal centres of the bands that both have \[Hz\].
    pub frequency_hz: Vec<f64>,
    /// Levels before in these bands \[dB\].
    pub before_db: Vec<Option<f64>>,
    /// Level before \[dB(A)\].
    pub before_dba: f64,
    /// Level now \[dB(A)\].
    pub now_dba: f64,
    /// Level now less that before \[dB\].
    pub change_db: f64,
    #[serde(skip)]
    is_all: bool,
}

impl Since {
    /// The change between two states; `None` if no band is known of both.
    pub(super) fn between(before: &Energies, now: &Energies) -> Option<Self> {
        let common = [before.within(now), now.within(before)];
        let [then, after] = common.each_ref().map(|it| it.a_weighted(Part::Total));
        let (before_dba, now_dba) = then.zip(after)?;
        let frequency_hz = nominal(&common[0]);
        Some(Self {
            is_all: frequency_hz == nominal(before) && frequency_hz == nominal(now),
            frequency_hz,
            before_db: common[0].levels(Part::Total),
            before_dba,
            now_dba,
            change_db: now_dba - before_dba,
        })
    }

    /// The change in a sentence without its full stop.
    pub fn in_words(&self) -> Message {
        let up_to = lower_bound_up_to(&self.frequency_hz);
        let said = say!(
            noise_before_and_after,
            before = at_least(self.before_dba, up_to),
            after = at_least(self.now_dba, up_to),
            change = number(format_args!("{:+.1}", self.change_db))
        );
        match self.is_all {
            true => said,
            false => say!(over_common_bands, count = self.frequency_hz.len(), said),
        }
    }
}

/// The highest band of a sum that ends below 2 kHz \[Hz\]: such a sum is a lower bound.
pub(super) fn lower_bound_up_to(frequencies: &[f64]) -> Option<f64> {
    let highest = frequencies.last().copied();
    highest.filter(|highest| *highest < WHOLE)
}

/// A level, which may be a lower bound.
pub(crate) fn at_least(level: f64, up_to: Option<f64>) -> Message {
    let level = say!(level_a_weighted, level = fixed(level, 1));
    match up_to {
        None => level,
        Some(hertz) => say!(level_at_least, level, hertz = number(hertz)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_that_ends_below_2_khz_is_a_lower_bound() {
        for (frequencies, up_to, said) in [
            (&[800.0, 1000.0][..], Some(1000.0), "≥ 71.0 dB(A) (up to 1000 Hz)"),
            (&[800.0, 2000.0], None, "71.0 dB(A)"),
        ] {
            assert_eq!(lower_bound_up_to(frequencies), up_to);
            assert_eq!(at_least(71.0, up_to).to_string(), said);
        }
    }
}
