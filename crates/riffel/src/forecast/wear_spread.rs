//! How well a wear coefficient is known, and what that makes of growth.

use riffel_numerics::normal_distribution::{HALF_OF_50, HALF_OF_80, HALF_OF_95};

/// A wear coefficient known to a factor: log-normal about the value in use.
///
/// Every growth rate by wear is in proportion to the coefficient, and every time to a level in inverse proportion, so that a band
/// of the coefficient is one of both, exactly. Nothing else of a case is in it: friction, pads and traction are taken as given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearSpread {
    /// Standard deviation of ln k_w \[-\].
    deviation: f64,
}

impl WearSpread {
    /// Of a rail whose wear was not measured: 80 % lies within a factor of three either way, as what rails in service lose.
    pub const UNMEASURED: Self = Self {
        // ln 3.
        deviation: 1.098_612_288_668_109_8 / HALF_OF_80,
    };

    /// Of a coefficient of which 80 % lies within a factor either way, one or more.
    #[must_use]
    pub fn of_factor(factor: f64) -> Self {
        Self { deviation: factor.ln() / HALF_OF_80 }
    }

    /// Of a coefficient fitted to two measurements, by its interval of 95 %; none unless all of that lies above zero.
    pub fn of_interval((low, high): (f64, f64)) -> Option<Self> {
        (low > 0.0 && high >= low).then(|| Self { deviation: (high / low).ln() / (2.0 * HALF_OF_95) })
    }

    /// Factor of one standard deviation either way \[-\].
    pub fn factor(self) -> f64 {
        self.deviation.exp()
    }

    /// Between what a value in proportion to the coefficient, or in inverse proportion, lies by 80 %: a tenth below the first, a
    /// tenth above the second.
    pub fn band_80(self, value: f64) -> [f64; 2] {
        self.within(HALF_OF_80, value)
    }

    /// Interval in which the value lies by half.
    pub fn band_50(self, value: f64) -> [f64; 2] {
        self.within(HALF_OF_50, value)
    }

    /// So many standard deviations of the normal distribution either way.
    fn within(self, deviations: f64, value: f64) -> [f64; 2] {
        let factor = (deviations * self.deviation).exp();
        let ends = [value / factor, value * factor];
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    }
}

#[cfg(test)]
mod tests {
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::{Rng, SeedableRng};

    use super::*;
    use riffel_numerics::random_numbers::unit;

    /// Of 40 000 coefficients drawn from the law, 80 and 50 % lie in the bands, to four standard errors; 80 % within the factor of
    /// three.
    #[test]
    fn the_bands_hold_their_shares() {
        let mut source = Xoshiro256PlusPlus::seed_from_u64(1);
        let mut uniform = || unit(source.next_u64());
        let draws = 40_000;
        let (eighty, fifty) = (WearSpread::UNMEASURED.band_80(1.0), WearSpread::UNMEASURED.band_50(1.0));
        let bands = [(eighty, 0.8), (fifty, 0.5), ([1.0 / 3.0, 3.0], 0.8)];
        let mut found = [0.0; 3];
        for _ in 0..draws {
            // Box & Muller.
            let size = (-2.0 * (1.0 - uniform()).ln()).sqrt();
            let factor = (WearSpread::UNMEASURED.deviation * size * (std::f64::consts::TAU * uniform()).cos()).exp();
            for (found, ([low, high], _)) in found.iter_mut().zip(bands) {
                *found += f64::from((low..=high).contains(&factor)) / f64::from(draws);
            }
        }
        for (found, (_, share)) in found.into_iter().zip(bands) {
            let error = 4.0 * (share * (1.0 - share) / f64::from(draws)).sqrt();
            assert!((found - share).abs() < error, "{found} for {share}");
        }
    }

    /// The interval of 95 % of a factor of 2 is 2^1.96 either way; an interval that reaches zero says nothing.
    #[test]
    fn an_interval_gives_back_its_spread() {
        let either_way = 2f64.powf(HALF_OF_95);
        let fitted = WearSpread::of_interval((3.0 / either_way, 3.0 * either_way)).unwrap();
        assert!((fitted.deviation - 2f64.ln()).abs() < 1e-15);
        assert_eq!(WearSpread::of_factor(3.0), WearSpread::UNMEASURED);
        assert_eq!(WearSpread::of_interval((0.0, 1.0)), None);
        assert_eq!(WearSpread::of_interval((-1.0, 1.0)), None);
    }
}
