//! Growth under the wheels of one vehicle.

use crate::feedback::Loop;
use crate::forecast::cracks::Cracks;
use crate::forecast::hardening_wheel::HardeningWheel;
use crate::forecast::{LINES_PER_BAND, MeanGrowth, SpeedDistribution, band_lines};
use crate::growth::{Axis, GrowthSpectrum};
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
    /// Mass of an axle, two wheels \[kg\].
    pub axle_mass: f64,
    /// Its speeds.
    pub speeds: SpeedDistribution,
    /// Growth by line.
    pub growth: MeanGrowth,
    /// Growth with its narrow lines, where the vehicle runs at a few speeds: a distribution makes broad lines of them.
    pub spectrum: Option<GrowthSpectrum>,
    /// Mean depth worn off the rail per passage \[m\].
    pub wear_depth: f64,
    /// Rates by line at rising amplitudes of the wave \[m\], without flow that hardens; empty if they do not depend on it.
    pub(super) by_amplitude: Vec<(f64, Vec<f64>)>,
    /// Its wheels under which the rail flows and hardens.
    pub(super) hardening: Vec<HardeningWheel>,
    /// Cracks along the waves of the bands, where they are among its laws.
    pub(super) cracks: Option<Cracks>,
    /// Whether that depth bounds its rates.
    pub(super) bounded_by_wear: bool,
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

    /// Growth under a wheel whose mean state depends on its speed, as [`MeanGrowth::between`]; load and wear are those of the
    /// state nearest to the mean of its speeds.
    ///
    /// # Errors
    /// Errors of [`compute`](Self::compute).
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
        let wheel_load = places.first().map_or(0.0, |(feedback, _)| feedback.steady().normal_force);
        Error::unless_positive("wheel load", wheel_load, "N")?;
        let depths = places.iter();
        let depths = depths.map(|(feedback, weight)| weight * feedback.mean_wear().depth);
        let lines = band_lines(bands);
        let hardening = HardeningWheel::of(states, &lines, &speeds);
        let by_amplitude = match hardening {
            None => rates_by_amplitude(states, &lines, &speeds)?,
            Some(_) => {
                let others = states.iter().map(|(speed, places)| {
                    let places =
                        places.iter().map(|(feedback, weight)| (feedback.clone().without_flow_that_hardens(), *weight));
                    (*speed, places.collect::<Vec<_>>())
                });
                let others: Vec<_> = others.collect();
                let others: Vec<_> = others.iter().map(|(at, places)| (*at, &places[..])).collect();
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
            axle_mass: 2.0 * wheel_load / STANDARD_GRAVITY,
            growth: MeanGrowth::between(states, &lines, &speeds),
            wear_depth: depths.sum(),
            by_amplitude,
            hardening: hardening.into_iter().collect(),
            cracks: Cracks::of(states, bands, &speeds),
            bounded_by_wear: places.iter().all(|(feedback, _)| feedback.mean_wear().bounds_growth),
            speeds,
            spectrum: None,
        })
    }

    /// The vehicle with its narrow lines of growth over a window of wavelengths, where it runs at no more than
    /// [`FEW`](Self::FEW) speeds. `places` as in [`MeanGrowth::compute`].
    pub fn with_spectrum(mut self, places: &[(Loop, f64)], window: Axis) -> Self {
        let few = self.speeds.listed().filter(|speeds| speeds.len() <= Self::FEW);
        self.spectrum = few.map(|speeds| {
            GrowthSpectrum::of(window, |wavelength| {
                let of = |(speed, share): &(f64, f64)| {
                    let rates = places
                        .iter()
                        .map(|(feedback, weight)| weight * feedback.complex_growth_rate(wavelength, *speed).re);
                    share * rates.sum::<f64>()
                };
                speeds.iter().map(of).sum()
            })
        });
        self
    }

    /// Its course with the lines \[m\] beside the window of that; the lines alone where it has none.
    pub(super) fn spectrum_over(&self, lines: &[f64]) -> GrowthSpectrum {
        let mut over = GrowthSpectrum { wavelengths: Vec::new(), rates: Vec::new() };
        let mut add = |wavelengths: &[f64], rates: &[f64]| {
            over.wavelengths.extend(wavelengths);
            over.rates.extend(rates);
        };
        let rates = &self.growth.rates;
        match &self.spectrum {
            None => add(lines, rates),
            Some(spectrum) => {
                let last = spectrum.wavelengths.len() - 1;
                let before = lines.partition_point(|line| *line < spectrum.wavelengths[0]);
                let after = lines.partition_point(|line| *line <= spectrum.wavelengths[last]);
                add(&lines[..before], &rates[..before]);
                add(&spectrum.wavelengths, &spectrum.rates);
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
        let mean_of = |value: &dyn Fn(&Self) -> f64| -> f64 { parts.iter().map(|(part, it)| part * value(it)).sum() };
        let wheel_load = mean_of(&|it| it.wheel_load);
        let axle_mass = mean_of(&|it| it.axle_mass);
        let lines = parts.first().map_or(0, |part| part.1.growth.rates.len());
        let force = |line: usize| {
            let ratios =
                parts.iter().map(|(_, it)| it.growth.squared_force_per_amplitude[line] / it.wheel_load.powi(2));
            ratios.fold(0.0, f64::max) * wheel_load.powi(2)
        };
        let growth = MeanGrowth {
            rates: (0..lines).map(|line| mean_of(&|it| it.growth.rates[line])).collect(),
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
            return Ok(Self { name: name.to_owned(), share, speeds, ..alone.clone() });
        }
        Ok(Self {
            name: name.to_owned(),
            share,
            wheel_load,
            axle_mass,
            speeds,
            growth,
            spectrum: None,
            wear_depth,
            by_amplitude,
            hardening,
            cracks,
            bounded_by_wear,
        })
    }

    /// Rate of a line at one of the amplitudes at which rates are known.
    pub(super) fn rate_at(&self, index: usize, line: usize) -> f64 {
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
        let spectrum = self.spectrum.iter_mut();
        let spectrum = spectrum.flat_map(|spectrum| &mut spectrum.rates);
        let by_amplitude = self.by_amplitude.iter_mut();
        let by_amplitude = by_amplitude.flat_map(|(_, rates)| rates);
        let rates = self.growth.rates.iter_mut().chain(spectrum);
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

    /// Mean growth rate of the amplitude per passage in a band \[-\], by its place among the bands.
    pub fn band_rate(&self, band: usize) -> f64 {
        mean(&self.growth.rates[lines_of(band)])
    }
}

/// Rates of lines at amplitudes from that of a smooth rail to one that no rail bears; empty if they do not depend on it.
pub(super) fn rates_by_amplitude(
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
            let places =
                places.iter().map(|(feedback, weight)| Ok((feedback.clone().with_amplitude(amplitude)?, *weight)));
            Ok((*speed, places.collect::<Result<Vec<_>, Error>>()?))
        });
        let states = states.collect::<Result<Vec<_>, Error>>()?;
        let states: Vec<_> = states.iter().map(|(at, places)| (*at, &places[..])).collect();
        Ok((amplitude, MeanGrowth::between(&states, lines, speeds).rates))
    };
    (0..=STEPS).map(at).collect()
}

/// Places of the lines of a band.
pub(in crate::forecast) fn lines_of(band: usize) -> std::ops::Range<usize> {
    LINES_PER_BAND * band..LINES_PER_BAND * (band + 1)
}

pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
