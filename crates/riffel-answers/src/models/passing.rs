//! The speeds at which the wheels of a comparison of models pass.

use riffel::forecast::{SpeedDistribution, band_lines};
use riffel::growth::GrowthSpectrum;
use riffel_case::model::ModelOnCase;
use riffel_case::traffic::bands_of;
use riffel_case::{Case, ask};

use crate::highest::{Highest, over_the_window};

/// One speed, or all of a traffic.
pub(super) enum Passing {
    /// \[m/s\].
    Speed(f64),
    /// Growth is the mean over them, at the lines of the bands as in a forecast.
    Traffic(SpeedDistribution),
}

impl Passing {
    /// The speed, or the mean of the traffic \[m/s\].
    pub(super) fn mean(&self) -> f64 {
        match self {
            Self::Speed(speed) => *speed,
            Self::Traffic(speeds) => speeds.mean(),
        }
    }

    /// Lowest and highest frequency \[Hz\] of the wavelengths of the map.
    pub(super) fn frequencies(&self, case: &Case) -> [f64; 2] {
        let (slowest, fastest) = match self {
            Self::Speed(speed) => (*speed, *speed),
            Self::Traffic(speeds) => speeds.range(),
        };
        [slowest / case.wavelength.max(), fastest / case.wavelength.min()]
    }

    /// Growth rates per passage of a model at wavelengths \[m\].
    pub(super) fn rates(&self, on: &ModelOnCase, wavelengths: &[f64]) -> Vec<f64> {
        match self {
            Self::Speed(speed) => on.growth_rates(wavelengths, *speed),
            Self::Traffic(speeds) => on.mean_growth_rates(wavelengths, speeds),
        }
    }

    /// Growth over the wavelengths of the map, at one speed with its narrow lines, and the wavelength that grows fastest of those of
    /// which that is told: all, where growth is filtered by the contact.
    pub(super) fn course(&self, on: &ModelOnCase) -> (GrowthSpectrum, Option<Highest>) {
        match self {
            Self::Speed(speed) => {
                let rate = on.growth_rate(*speed);
                over_the_window(&on.case, on.has_filter(), *speed, rate)
            }
            Self::Traffic(speeds) => {
                let wavelengths = band_lines(&bands_of(&on.case));
                let rates = on.mean_growth_rates(&wavelengths, speeds);
                let course = GrowthSpectrum::of_values(wavelengths, rates);
                let shortest = match on.has_filter() {
                    true => 0.0,
                    false => ask::shortest_told(&on.case),
                };
                let highest = Highest::beyond(&course, shortest, self.mean());
                (course, highest)
            }
        }
    }
}
