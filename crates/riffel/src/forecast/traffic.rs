//! Growth under a mix of vehicles.

use super::cracks::{Cracks, WavePhase};
use super::hardening_wheel::HardeningWheel;
use super::marched::RatesByAmplitude;
use super::{LINES_PER_BAND, MeanGrowth, SpeedDistribution, band_lines};
use crate::feedback::Loop;
use crate::growth::{Axis, GrowthCourse};
use crate::roughness::ThirdOctave;
use crate::{Error, MeanWear, STANDARD_GRAVITY};

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
    /// Mean depth worn off the rail per passage \[m\].
    pub wear_depth: f64,
    /// Rates by line at rising amplitudes of the wave \[m\], without flow that hardens; none where they do not depend on it.
    by_amplitude: Vec<(f64, Vec<f64>)>,
    /// Its wheels under which the rail flows and hardens.
    hardening: Vec<HardeningWheel>,
    /// Cracks along the waves of the bands, where they are among its laws.
    cracks: Option<Cracks>,
    /// Whether that depth bounds its rates.
    bounded_by_wear: bool,
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
        let states = [(speeds.mean(), places)];
        Self::between(name, share, &states, bands, speeds)
    }

    /// The same for a wheel whose mean state depends on its speed, as [`MeanGrowth::between`]; load and wear are those of the
    /// state nearest to the mean of its speeds.
    ///
    /// # Errors
    /// As [`compute`](Self::compute).
    pub fn between(
        name: &str,
        share: f64,
        states: &[(f64, &[(Loop, f64)])],
        bands: &[ThirdOctave],
        speeds: SpeedDistribution,
    ) -> Result<Self, Error> {
        Error::unless_positive("share of the axle passages", share, "")?;
        let far = |state: &&(f64, &[(Loop, f64)])| (state.0 - speeds.mean()).abs();
        let nearest = states.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        let places = nearest.map_or(&[][..], |state| state.1);
        let wheel_load = places
            .first()
            .map_or(0.0, |(feedback, _)| feedback.steady().normal_force);
        Error::unless_positive("wheel load", wheel_load, "N")?;
        let depths = places.iter();
        let depths = depths.map(|(feedback, weight)| weight * feedback.mean_wear().depth);
        let lines = band_lines(bands);
        let hardening = HardeningWheel::of(states, &lines, &speeds);
        let by_amplitude = match hardening {
            None => rates_by_amplitude(states, &lines, &speeds)?,
            Some(_) => {
                let others = states.iter().map(|(speed, places)| {
                    let places = places.iter().map(|(feedback, weight)| {
                        (feedback.clone().without_flow_that_hardens(), *weight)
                    });
                    (*speed, places.collect::<Vec<_>>())
                });
                let others: Vec<_> = others.collect();
                let others: Vec<_> = others
                    .iter()
                    .map(|(at, places)| (*at, &places[..]))
                    .collect();
                let rates = rates_by_amplitude(&others, &lines, &speeds)?;
                match rates.is_empty() {
                    true => vec![(1.0, MeanGrowth::between(&others, &lines, &speeds).rates)],
                    false => rates,
                }
            }
        };
        Ok(Self {
            name: name.to_owned(),
            share,
            wheel_load,
            growth: MeanGrowth::between(states, &lines, &speeds),
            wear_depth: depths.sum(),
            by_amplitude,
            hardening: hardening.into_iter().collect(),
            cracks: Cracks::of(states, bands, &speeds),
            bounded_by_wear: places
                .iter()
                .all(|(feedback, _)| feedback.mean_wear().bounds_growth),
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

    /// Its course with the lines \[m\] beside the window of that; the lines alone where it has none.
    fn course_over(&self, lines: &[f64]) -> GrowthCourse {
        let mut over = GrowthCourse {
            wavelengths: Vec::new(),
            rates: Vec::new(),
        };
        let mut add = |wavelengths: &[f64], rates: &[f64]| {
            over.wavelengths.extend(wavelengths);
            over.rates.extend(rates);
        };
        let rates = &self.growth.rates;
        match &self.course {
            None => add(lines, rates),
            Some(course) => {
                let last = course.wavelengths.len() - 1;
                let before = lines.partition_point(|line| *line < course.wavelengths[0]);
                let after = lines.partition_point(|line| *line <= course.wavelengths[last]);
                add(&lines[..before], &rates[..before]);
                add(&course.wavelengths, &course.rates);
                add(&lines[after..], &rates[after..]);
            }
        }
        over
    }

    /// Speeds at which narrow lines are looked for; more of them blur what is narrow.
    pub const FEW: usize = 3;

    /// One vehicle of several of its wheels, loads or states, each with its share in the passages of the vehicle; shares are
    /// scaled to sum to one. One part alone is the vehicle itself.
    ///
    /// Rates and depths of wear are the means by share: exponents of passages add, whichever wheel they are of. The force per
    /// amplitude is, line by line, that of the part which parts from the rail first.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] without parts and for shares that are not above zero.
    pub fn of_parts(
        name: &str,
        share: f64,
        speeds: SpeedDistribution,
        mut parts: Vec<(f64, Self)>,
    ) -> Result<Self, Error> {
        let sum: f64 = parts.iter().map(|part| part.0).sum();
        Error::unless_positive("sum of the shares of the parts of a vehicle", sum, "")?;
        for (part, _) in &mut parts {
            Error::unless_positive("share of a part of a vehicle", *part, "")?;
            *part /= sum;
        }
        let mean_of = |value: &dyn Fn(&Self) -> f64| -> f64 {
            parts.iter().map(|(part, it)| part * value(it)).sum()
        };
        let wheel_load = mean_of(&|it| it.wheel_load);
        let lines = parts.first().map_or(0, |part| part.1.growth.rates.len());
        let force = |line: usize| {
            let ratios = parts
                .iter()
                .map(|(_, it)| it.growth.squared_force_per_amplitude[line] / it.wheel_load.powi(2));
            ratios.fold(0.0, f64::max) * wheel_load.powi(2)
        };
        let growth = MeanGrowth {
            rates: (0..lines)
                .map(|line| mean_of(&|it| it.growth.rates[line]))
                .collect(),
            squared_force_per_amplitude: (0..lines).map(force).collect(),
            rate_error: mean_of(&|it| it.growth.rate_error),
            speeds: parts.iter().map(|part| part.1.growth.speeds).sum(),
        };
        let wear_depth = mean_of(&|it| it.wear_depth);
        let bounded_by_wear = parts.iter().all(|(_, it)| it.bounded_by_wear);
        let amplitudes = parts.iter().map(|(_, it)| &it.by_amplitude);
        let amplitudes = amplitudes.max_by_key(|rates| rates.len());
        let amplitudes = amplitudes.into_iter().flatten().enumerate();
        let by_amplitude = amplitudes.map(|(index, (amplitude, _))| {
            let rates = (0..lines).map(|line| mean_of(&|it| it.rate_at(index, line)));
            (*amplitude, rates.collect())
        });
        let by_amplitude = by_amplitude.collect();
        let hardening = parts.iter().flat_map(|(part, it)| {
            let wheels = it.hardening.iter();
            wheels.map(move |wheel| wheel.part(0..lines, *part))
        });
        let hardening = hardening.collect();
        let cracks = Cracks::mean(parts.iter().map(|(part, it)| (*part, it.cracks.as_ref())));
        if let [(_, alone)] = &mut parts[..] {
            return Ok(Self {
                name: name.to_owned(),
                share,
                speeds,
                ..alone.clone()
            });
        }
        Ok(Self {
            name: name.to_owned(),
            share,
            wheel_load,
            speeds,
            growth,
            course: None,
            wear_depth,
            by_amplitude,
            hardening,
            cracks,
            bounded_by_wear,
        })
    }

    /// Rate of a line at one of the amplitudes at which rates are known.
    fn rate_at(&self, index: usize, line: usize) -> f64 {
        let known = self.by_amplitude.get(index).or(self.by_amplitude.last());
        known.map_or(self.growth.rates[line], |(_, rates)| rates[line])
    }

    /// Whether its rates depend on the amplitude of the wave.
    pub fn depends_on_amplitude(&self) -> bool {
        !self.by_amplitude.is_empty()
    }

    /// The vehicle where its contacts cover the line under study in a share of its passages \[-\], from 0 to 1, and run beside
    /// it in the others, which leave the line as it is.
    pub fn covering(mut self, share: f64) -> Self {
        let course = self.course.iter_mut();
        let course = course.flat_map(|course| &mut course.rates);
        let by_amplitude = self.by_amplitude.iter_mut();
        let by_amplitude = by_amplitude.flat_map(|(_, rates)| rates);
        let rates = self.growth.rates.iter_mut().chain(course);
        for rate in rates.chain(by_amplitude) {
            *rate *= share;
        }
        for wheel in &mut self.hardening {
            wheel.share *= share;
        }
        self.cracks = self.cracks.map(|cracks| cracks.covering(share));
        self.growth.rate_error *= share;
        self.wear_depth *= share;
        self
    }

    /// The vehicle with traction on a share of its axles \[-\] from 0 to 1, while the others roll free.
    ///
    /// An axle that rolls free leaves the profile as it is to first order: e₁ = ξ₀Q₁ + Q₀ξ₁, and both ξ₀ and Q₀
    /// are zero. In the mean over the axles the growth rate is thus the share times that under traction. The
    /// normal force does not depend on traction.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a share outside 0–1.
    pub fn with_traction_on(self, share: f64) -> Result<Self, Error> {
        if !(0.0..=1.0).contains(&share) {
            return Err(Error::OutOfRange {
                quantity: "share of axles under traction",
                value: share,
                unit: "",
                rule: "must be between 0 and 1",
            });
        }
        Ok(self.covering(share))
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
    /// Bands, by their places, that grow as they were measured to.
    measured: Vec<usize>,
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
            measured: Vec::new(),
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
            self.measured.push(place);
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

    /// The wavelength \[m\] from a shortest one on that grows fastest, its growth rate per axle passage \[-\], and whether a shorter or
    /// longer one may grow faster. Of vehicles with a [course](VehicleGrowth::course) narrow lines count; none where no line is so long.
    pub fn fastest(&self, shortest: f64) -> Option<(f64, f64, bool)> {
        let lines = self.wavelengths();
        let courses = self.vehicles.iter();
        let courses: Vec<(f64, GrowthCourse)> = courses
            .map(|vehicle| (vehicle.share, vehicle.course_over(&lines)))
            .collect();
        let inside = |wavelength: &&f64| **wavelength >= shortest;
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

    /// Rates of the lines of a band over the amplitude of the wave; none where they do not depend on it, or were measured.
    pub(super) fn rates_by_amplitude(&self, band: usize) -> Option<RatesByAmplitude> {
        let mut vehicles = self.vehicles.iter();
        let known = vehicles.find(|vehicle| vehicle.depends_on_amplitude())?;
        if !self.is_of_loop(band) {
            return None;
        }
        let rates = known.by_amplitude.iter().enumerate();
        let rates = rates.map(|(index, (amplitude, _))| {
            let mean = lines_of(band).map(|line| {
                let rates = self.vehicles.iter();
                rates
                    .map(|vehicle| vehicle.share * vehicle.rate_at(index, line))
                    .sum()
            });
            (*amplitude, mean.collect())
        });
        Some(RatesByAmplitude {
            rates: rates.collect(),
        })
    }

    /// Wheels under which a band of the loop, by its place, flows and hardens.
    pub(super) fn hardening(&self, band: usize) -> Vec<HardeningWheel> {
        if !self.is_of_loop(band) {
            return Vec::new();
        }
        let wheels = self.vehicles.iter().flat_map(|vehicle| {
            let wheels = vehicle.hardening.iter();
            wheels.map(|wheel| wheel.part(lines_of(band), vehicle.share))
        });
        wheels.collect()
    }

    /// Cracks per passage at the phases of a wave of some amplitude \[m\] in the middle of a band, by its place; none where no
    /// vehicle has fatigue among its laws.
    pub(super) fn cracks(&self, band: usize, amplitude: f64) -> Option<[WavePhase; 4]> {
        let vehicles = self.vehicles.iter();
        let each = vehicles.filter_map(|vehicle| {
            let phases = vehicle.cracks.as_ref()?.at(band, amplitude);
            Some(phases.map(|own| vehicle.share * own))
        });
        let sum = each.reduce(|sum, other| std::array::from_fn(|i| sum[i] + other[i]))?;
        Some(WavePhase::all(&sum))
    }

    /// Whether growth depends on the amplitude of the wave under any vehicle.
    pub fn depends_on_amplitude(&self) -> bool {
        let mut vehicles = self.vehicles.iter();
        vehicles.any(VehicleGrowth::depends_on_amplitude)
    }

    /// Whether the rates of a band, by its place, are those of the loop and not measured ones.
    pub(super) fn is_of_loop(&self, band: usize) -> bool {
        !self.measured.contains(&band)
    }

    /// Mean growth rate of the amplitude per axle passage in a band \[-\], by its place among the bands: that
    /// of the RMS of a band whose energy is spread evenly.
    pub fn band_rate(&self, band: usize) -> f64 {
        mean(self.lines(band))
    }

    /// Mean wear of the rail under the mix.
    pub fn mean_wear(&self) -> MeanWear {
        let depths = self.vehicles.iter().map(|v| v.share * v.wear_depth);
        MeanWear {
            depth: depths.sum(),
            axle_mass: self.axle_mass(),
            bounds_growth: self.vehicles.iter().all(|v| v.bounded_by_wear),
        }
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

/// Rates of lines at amplitudes from that of a smooth rail to one that no rail bears; none where they do not depend on it.
fn rates_by_amplitude(
    states: &[(f64, &[(Loop, f64)])],
    lines: &[f64],
    speeds: &SpeedDistribution,
) -> Result<Vec<(f64, Vec<f64>)>, Error> {
    /// From 1 µm on, ten to each power of ten: a threshold is blurred over a quarter of its amplitude.
    const FIRST: f64 = 1e-6;
    const STEPS: u32 = 40;
    let mut loops = states.iter().flat_map(|(_, places)| *places);
    if !loops.any(|(feedback, _)| feedback.depends_on_amplitude()) {
        return Ok(Vec::new());
    }
    let at = |step: u32| {
        let amplitude = FIRST * 10f64.powf(f64::from(step) / 10.0);
        let states = states.iter().map(|(speed, places)| {
            let places = places.iter().map(|(feedback, weight)| {
                Ok((feedback.clone().with_amplitude(amplitude)?, *weight))
            });
            Ok((*speed, places.collect::<Result<Vec<_>, Error>>()?))
        });
        let states = states.collect::<Result<Vec<_>, Error>>()?;
        let states: Vec<_> = states
            .iter()
            .map(|(at, places)| (*at, &places[..]))
            .collect();
        Ok((amplitude, MeanGrowth::between(&states, lines, speeds).rates))
    };
    (0..=STEPS).map(at).collect()
}

/// Places of the lines of a band.
pub(super) fn lines_of(band: usize) -> std::ops::Range<usize> {
    LINES_PER_BAND * band..LINES_PER_BAND * (band + 1)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
