//! Growth under a mix of vehicles.

use super::{LINES_PER_BAND, MeanGrowth, SpeedDistribution, band_lines};
use crate::feedback::Loop;
use crate::growth::{Axis, GrowthCourse};
use crate::roughness::ThirdOctave;
use crate::{Error, STANDARD_GRAVITY};

/// One kind of vehicle in the mix.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct VehicleGrowth {
    /// Its name.
    pub name: String,
    /// Its share of the axle passages \[-\], of all one.
    pub share: f64,
    /// Normal load P₀ of a wheel \[N\].
    pub wheel_load: f64,
    /// Its speeds.
    pub speeds: SpeedDistribution,
    /// Growth by line.
    pub growth: MeanGrowth,
    /// Growth with its narrow lines, where the vehicle runs at a few speeds: a distribution makes broad lines of them.
    pub course: Option<GrowthCourse>,
}

impl VehicleGrowth {
    /// A vehicle over the lines of some bands. `places` as in [`MeanGrowth::compute`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless share and load are above zero.
    pub fn compute(
        name: &str,
        share: f64,
        places: &[(Loop, f64)],
        bands: &[ThirdOctave],
        speeds: SpeedDistribution,
    ) -> Result<Self, Error> {
        Error::unless_positive("share of the axle passages", share, "")?;
        let wheel_load = places
            .first()
            .map_or(0.0, |(feedback, _)| feedback.steady().normal_force);
        Error::unless_positive("wheel load", wheel_load, "N")?;
        Ok(Self {
            name: name.to_owned(),
            share,
            wheel_load,
            growth: MeanGrowth::compute(places, &band_lines(bands), &speeds),
            speeds,
            course: None,
        })
    }

    /// The vehicle with its narrow lines of growth over a window of wavelengths, where it runs at no more than
    /// [`FEW`](Self::FEW) speeds. `places` as in [`MeanGrowth::compute`].
    pub fn with_course(mut self, places: &[(Loop, f64)], window: Axis) -> Self {
        let few = self
            .speeds
            .listed()
            .filter(|speeds| speeds.len() <= Self::FEW);
        self.course = few.map(|speeds| {
            GrowthCourse::of(window, |wavelength| {
                let of = |(speed, share): &(f64, f64)| {
                    let rates = places.iter().map(|(feedback, weight)| {
                        weight * feedback.complex_growth_rate(wavelength, *speed).re
                    });
                    share * rates.sum::<f64>()
                };
                speeds.iter().map(of).sum()
            })
        });
        self
    }

    /// Speeds at which narrow lines are looked for; more of them blur what is narrow.
    pub const FEW: usize = 3;

    /// The vehicle with traction on a share of its axles \[-\] from 0 to 1, while the others roll free.
    ///
    /// An axle that rolls free leaves the profile as it is to first order: e₁ = ξ₀Q₁ + Q₀ξ₁, and both ξ₀ and Q₀
    /// are zero. In the mean over the axles the growth rate is thus the share times that under traction. The
    /// normal force does not depend on traction.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a share outside 0–1.
    pub fn with_traction_on(mut self, share: f64) -> Result<Self, Error> {
        if !(0.0..=1.0).contains(&share) {
            return Err(Error::OutOfRange {
                quantity: "share of axles under traction",
                value: share,
                unit: "",
                rule: "must be between 0 and 1",
            });
        }
        for rate in &mut self.growth.rates {
            *rate *= share;
        }
        self.growth.rate_error *= share;
        let course = self.course.iter_mut();
        for rate in course.flat_map(|course| &mut course.rates) {
            *rate *= share;
        }
        Ok(self)
    }

    /// Mass of an axle \[kg\], two wheels.
    pub fn axle_mass(&self) -> f64 {
        2.0 * self.wheel_load / STANDARD_GRAVITY
    }

    /// Mean growth rate of the amplitude per passage in a band \[-\], by its place among the bands.
    pub fn band_rate(&self, band: usize) -> f64 {
        mean(&self.growth.rates[lines_of(band)])
    }
}

/// Growth rates of the lines of some bands under a mix of vehicles.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct TrafficGrowth {
    bands: Vec<ThirdOctave>,
    vehicles: Vec<VehicleGrowth>,
    rates: Vec<f64>,
}

impl TrafficGrowth {
    /// The mix of vehicles over the bands for which each was computed; shares are scaled to sum to one.
    ///
    /// The rate of a passage of the mix is g = Σ_v share_v g_v: wheels change the amplitude one after
    /// the other, so their exponents add.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there is a vehicle and a band, and every vehicle has the lines of the
    /// bands.
    pub fn new(bands: Vec<ThirdOctave>, mut vehicles: Vec<VehicleGrowth>) -> Result<Self, Error> {
        let lines = LINES_PER_BAND * bands.len();
        let wrong = |quantity, value: usize, rule| Error::OutOfRange {
            quantity,
            value: value as f64,
            unit: "",
            rule,
        };
        if bands.is_empty() {
            return Err(wrong("number of bands", 0, "must be one or more"));
        }
        if vehicles.is_empty() {
            return Err(wrong("number of vehicles", 0, "must be one or more"));
        }
        if let Some(other) = vehicles
            .iter()
            .find(|vehicle| vehicle.growth.rates.len() != lines)
        {
            let count = other.growth.rates.len();
            return Err(wrong(
                "number of lines of a vehicle",
                count,
                "must be that of the bands",
            ));
        }
        let sum: f64 = vehicles.iter().map(|vehicle| vehicle.share).sum();
        Error::unless_positive("sum of the shares of the axle passages", sum, "")?;
        for vehicle in &mut vehicles {
            vehicle.share /= sum;
        }
        let rate = |line: usize| {
            let rates = vehicles
                .iter()
                .map(|vehicle| vehicle.share * vehicle.growth.rates[line]);
            rates.sum()
        };
        Ok(Self {
            rates: (0..lines).map(rate).collect(),
            bands,
            vehicles,
        })
    }

    /// The same traffic where a band grows as it was measured to, in place of what the model says: by a change of level
    /// \[dB\] over some axle passages. Every vehicle has its share in it.
    pub fn as_measured(mut self, changes: &[(ThirdOctave, f64)], passages: f64) -> Self {
        for (place, band) in self.bands.iter().enumerate() {
            let Some((_, change)) = changes.iter().find(|(own, _)| own == band) else {
                continue;
            };
            let rate = change * std::f64::consts::LN_10 / 20.0 / passages;
            self.rates[lines_of(place)].fill(rate);
            for vehicle in &mut self.vehicles {
                vehicle.growth.rates[lines_of(place)].fill(rate);
                // What was measured does not tell lines apart.
                vehicle.course = None;
            }
        }
        self
    }

    /// The bands.
    pub fn bands(&self) -> &[ThirdOctave] {
        &self.bands
    }

    /// The vehicles, shares summing to one.
    pub fn vehicles(&self) -> &[VehicleGrowth] {
        &self.vehicles
    }

    /// Wavelengths of all lines \[m\].
    pub fn wavelengths(&self) -> Vec<f64> {
        band_lines(&self.bands)
    }

    /// Growth rate of the amplitude per axle passage \[-\] of every line.
    pub fn rates(&self) -> &[f64] {
        &self.rates
    }

    /// The wavelength \[m\] within a range that grows fastest, its growth rate per axle passage \[-\], and whether a shorter or
    /// longer one may grow faster. Of vehicles with a [course](VehicleGrowth::course) narrow lines count; none where no line lies
    /// in the range.
    pub fn fastest(&self, range: [f64; 2]) -> Option<(f64, f64, bool)> {
        let lines = self.wavelengths();
        let of_lines = |vehicle: &VehicleGrowth| GrowthCourse {
            wavelengths: lines.clone(),
            rates: vehicle.growth.rates.clone(),
        };
        let courses: Vec<(f64, GrowthCourse)> = (self.vehicles.iter())
            .map(|vehicle| {
                let course = vehicle.course.clone();
                (vehicle.share, course.unwrap_or_else(|| of_lines(vehicle)))
            })
            .collect();
        let inside = |wavelength: &&f64| (range[0]..=range[1]).contains(*wavelength);
        let places = courses.iter().flat_map(|(_, course)| &course.wavelengths);
        let mut places: Vec<f64> = places.filter(inside).copied().collect();
        places.sort_by(f64::total_cmp);
        let rate = |wavelength: f64| {
            let rates = courses.iter();
            rates
                .map(|(share, course)| share * course.at(wavelength))
                .sum::<f64>()
        };
        let rates = places
            .iter()
            .map(|&wavelength| (wavelength, rate(wavelength)));
        let (wavelength, rate) = rates.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let at_edge = [places.first(), places.last()].contains(&Some(&wavelength));
        Some((wavelength, rate, at_edge))
    }

    /// Growth rates of the lines of a band \[-\], by its place among the bands.
    pub fn lines(&self, band: usize) -> &[f64] {
        &self.rates[lines_of(band)]
    }

    /// The same as a forecast takes them: lines that decay keep their level.
    pub(super) fn forecast_lines(&self, band: usize) -> impl Iterator<Item = f64> {
        self.lines(band).iter().map(|rate| rate.max(0.0))
    }

    /// Mean growth rate of the amplitude per axle passage in a band \[-\], by its place among the bands: that
    /// of the RMS of a band whose energy is spread evenly.
    pub fn band_rate(&self, band: usize) -> f64 {
        mean(self.lines(band))
    }

    /// Mean mass of an axle \[kg\].
    pub fn axle_mass(&self) -> f64 {
        let masses = self.vehicles.iter().map(|v| v.share * v.axle_mass());
        masses.sum()
    }

    /// Gross mass over the track \[million tonnes, MGT\] after some axle passages.
    pub fn mgt(&self, passages: f64) -> f64 {
        1e-9 * passages * self.axle_mass()
    }

    /// Axle passages of a gross mass \[million tonnes, MGT\].
    pub fn passages(&self, mgt: f64) -> f64 {
        1e9 * mgt / self.axle_mass()
    }

    /// The least accurate rate of any vehicle by its share: change on halving the step in speed \[-\].
    pub fn rate_error(&self) -> f64 {
        let errors = self.vehicles.iter().map(|v| v.share * v.growth.rate_error);
        errors.sum()
    }
}

/// Places of the lines of a band.
pub(super) fn lines_of(band: usize) -> std::ops::Range<usize> {
    LINES_PER_BAND * band..LINES_PER_BAND * (band + 1)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
