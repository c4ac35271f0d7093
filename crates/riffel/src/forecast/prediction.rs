//! The spectrum after some passages.

use super::bend::Bend;
use super::marched::Marched;
use super::passages_until::passages_until;
use super::traffic::lines_of;
use super::{CrackedPhase, GrowingSum, HardeningEnd, LINES_PER_BAND, TrafficGrowth, VehicleGrowth};
use crate::Error;
use crate::roughness::{BandLevel, LevelLimit, Spectrum, level, mean_square};

/// A spectrum under traffic.
///
/// What decays in the model keeps today's level: nothing in it makes the roughness that traffic makes on a real rail, so
/// that waves would sink without end.
///
/// Range of validity: the loop is linear. It holds while the wheel stays on the rail, see
/// [`valid_to`](Self::valid_to), and while track, friction and traffic stay as they are. Levels beyond are what
/// the exponentials say and nothing more: real corrugation slows down. A band whose rate would need more than the mean wear of
/// the rail bends over before, see [`ForecastBand::bends_after`].
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Forecast {
    traffic: TrafficGrowth,
    bands: Vec<ForecastBand>,
    linear: LinearRange,
}

/// When a level is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reach {
    /// After so many axle passages; 0 where it is there now.
    After(f64),
    /// Not before the wheel leaves the rail: the linear loop cannot say when.
    BeyondLinearRange,
    /// Never: the level falls, or stays.
    Never,
}

impl Reach {
    /// Name of the kind: after, beyond-linear-range, never.
    pub fn name(self) -> &'static str {
        match self {
            Self::After(_) => "after",
            Self::BeyondLinearRange => "beyond-linear-range",
            Self::Never => "never",
        }
    }

    /// Axle passages, if they are known.
    pub fn passages(self) -> Option<f64> {
        match self {
            Self::After(passages) => Some(passages),
            Self::BeyondLinearRange | Self::Never => None,
        }
    }
}

/// One band of a forecast.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct ForecastBand {
    /// The band with its level now.
    pub now: BandLevel,
    /// Its lines.
    pub sum: GrowingSum,
    /// Its place among the bands of the traffic.
    place: usize,
    /// Where its rate needs all the wear of the rail; `None` if it never does, and for a measured rate.
    bend: Option<Bend>,
    /// Its course where its rates depend on its amplitude.
    marched: Option<Marched>,
    /// Where flow that hardens takes it by itself; `None` if nothing hardens.
    hardening: Option<HardeningEnd>,
}

/// The amplitude up to which the loop is linear: |P₁| < P₀, wheel and rail in contact.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearRange {
    /// |P₁|/P₀ now \[-\].
    pub force_ratio: f64,
    /// Axle passages until it is one; `None` if it never is.
    pub passages: Option<f64>,
    /// The vehicle that parts first, by its place in the mix; where none does, the one of the largest ratio.
    pub vehicle: usize,
}

impl ForecastBand {
    /// Level after some axle passages \[dB re 1 µm\], within the linear range and beyond: by the exponentials, and from where
    /// they would need more than the mean wear of the rail along with that.
    pub fn level(&self, passages: f64) -> f64 {
        if let Some(marched) = &self.marched {
            let change = marched.ln_at(passages) - marched.ln_at(0.0);
            return self.now.level + 10.0 / std::f64::consts::LN_10 * change;
        }
        match self.bend.filter(|bend| passages > bend.passages) {
            Some(bend) => level(bend.mean_square(passages)),
            None => self.now.level + self.sum.level_change(passages),
        }
    }

    /// Axle passages until a level is reached \[dB re 1 µm\].
    pub fn passages_to(&self, level: f64) -> Option<f64> {
        if let Some(marched) = &self.marched {
            return marched.passages_to(mean_square(level).ln());
        }
        let passages = self.sum.passages_to(mean_square(level))?;
        match self.bend.filter(|bend| passages > bend.passages) {
            Some(bend) => bend.passages_to(mean_square(level)),
            None => Some(passages),
        }
    }

    /// Where flow that hardens takes its waves by itself; `None` if nothing flows and hardens.
    pub fn hardening(&self) -> Option<HardeningEnd> {
        self.hardening
    }

    /// Axle passages after which its level has come to rest, but for a twentieth of its way; `None` if it goes on.
    pub fn rests_after(&self) -> Option<f64> {
        self.marched.as_ref().and_then(Marched::rests_after)
    }

    /// Axle passages after which its rate no longer lasts, for it would need more than the mean wear of the rail; `None` if it
    /// lasts on, or was measured.
    pub fn bends_after(&self) -> Option<f64> {
        self.bend.map(|bend| bend.passages)
    }
}

impl Forecast {
    /// A spectrum under the traffic, for the bands that both have; the energy of a band is spread evenly
    /// over its lines.
    ///
    /// # Errors
    /// [`Error::Measurement`] where they have no band in common.
    pub fn new(spectrum: &Spectrum, traffic: TrafficGrowth) -> Result<Self, Error> {
        let bands: Vec<ForecastBand> = traffic
            .bands()
            .iter()
            .enumerate()
            .filter_map(|(place, &band)| {
                let now = BandLevel { band, level: spectrum.level(band)? };
                let line = now.mean_square() / LINES_PER_BAND as f64;
                let rates = traffic.forecast_lines(place);
                let sum = GrowingSum::new(rates.map(|rate| (line, rate)));
                let of_loop = traffic.is_of_loop(place);
                let wheels = traffic.hardening(place);
                let lines = [line; LINES_PER_BAND];
                let marched = (traffic.rates_by_amplitude(place)).map(|rates| match &wheels[..] {
                    [] => Marched::new(&lines, &rates),
                    wheels => Marched::hardening(&lines, &rates, wheels),
                });
                let hardening = HardeningEnd::of_band(&wheels, LINES_PER_BAND);
                // Mean depths of flow follow the amplitude, too: no bound is known there.
                let bend = (of_loop && marched.is_none() && traffic.mean_wear().bounds_growth)
                    .then(|| Bend::of(&sum, traffic.mean_wear().depth));
                let bend = bend.flatten();
                Some(ForecastBand { now, sum, place, bend, marched, hardening })
            })
            .collect();
        if bands.is_empty() {
            return Err(Error::Measurement {
                index: 0,
                rule: "no band of the spectrum lies in the wavelengths of the forecast",
            });
        }
        let linear = force_range(&traffic, bands.iter());
        Ok(Self { traffic, bands, linear })
    }

    /// Axle passages up to which the forecast holds, where the forces of all bands together lift the wheel off
    /// the rail; 0 where they do now, infinite where they never do.
    pub fn valid_to(&self) -> f64 {
        self.linear.passages.unwrap_or(f64::INFINITY)
    }

    /// Level of a band after some axle passages \[dB re 1 µm\], within the linear range; what was measured is
    /// known anyhow.
    pub fn level(&self, band: &ForecastBand, passages: f64) -> Option<f64> {
        (passages == 0.0 || passages <= self.valid_to()).then(|| band.level(passages))
    }

    /// The traffic.
    pub fn traffic(&self) -> &TrafficGrowth {
        &self.traffic
    }

    /// The bands, the shortest wavelength first.
    pub fn bands(&self) -> &[ForecastBand] {
        &self.bands
    }

    /// Growth rate of the amplitude per axle passage in a band of the forecast by the model \[-\]; below zero it decays,
    /// and its level stays.
    pub fn growth_rate(&self, band: &ForecastBand) -> f64 {
        self.traffic.band_rate(band.place)
    }

    /// Growth rate under one vehicle of the mix \[-\].
    pub fn vehicle_rate(&self, band: &ForecastBand, vehicle: usize) -> f64 {
        self.traffic.vehicles()[vehicle].band_rate(band.place)
    }

    /// The spectrum after some axle passages; a level beyond all numbers is the largest there is.
    ///
    /// # Errors
    /// [`Error::Measurement`] for passages that are not a number.
    pub fn spectrum(&self, passages: f64) -> Result<Spectrum, Error> {
        let levels = self.bands.iter();
        Spectrum::new(levels.map(|band| (band.now.band, band.level(passages).min(f64::MAX))))
    }

    /// When each band that has a limit reaches it: the band and the limit \[dB re 1 µm\].
    pub fn reaches(&self, limit: &LevelLimit) -> Vec<(&ForecastBand, f64, Reach)> {
        let bands = self.bands.iter();
        bands
            .filter_map(|band| {
                let limit = limit.spectrum().level(band.now.band)?;
                let reach = match band.passages_to(limit) {
                    Some(passages) if passages <= self.valid_to() => Reach::After(passages),
                    Some(_) => Reach::BeyondLinearRange,
                    None => Reach::Never,
                };
                Some((band, limit, reach))
            })
            .collect()
    }

    /// The first time that a band reaches a limit, after which the rail must be ground.
    pub fn grinding_interval(&self, limit: &LevelLimit) -> Reach {
        let reaches = self.reaches(limit);
        let passages = reaches.iter().filter_map(|(_, _, reach)| reach.passages());
        let beyond = reaches.iter().any(|(_, _, reach)| *reach == Reach::BeyondLinearRange);
        match passages.min_by(f64::total_cmp) {
            Some(passages) => Reach::After(passages),
            None if beyond => Reach::BeyondLinearRange,
            None => Reach::Never,
        }
    }

    /// What a passage does now at the four [phases](super::WavePhase::NAMES) of the wave in the middle of a band, and how long a crack is after
    /// some passages in which the wave grows as forecast; `None` if fatigue is not among the laws.
    ///
    /// Its amplitude is √2 of the RMS of the band. Method: steps of a hundredth of the passages, midpoints.
    pub fn cracks(&self, band: &ForecastBand, passages: f64) -> Option<[CrackedPhase; 4]> {
        const STEPS: usize = 100;
        let at = |passages: f64| {
            let amplitude = (2.0 * mean_square(band.level(passages))).sqrt();
            self.traffic.cracks(band.place, amplitude)
        };
        let mut phases = at(0.0)?.map(|now| CrackedPhase { now, length: 0.0 });
        let step = passages / STEPS as f64;
        for index in 0..STEPS {
            let middle = at((index as f64 + 0.5) * step)?;
            for (phase, then) in phases.iter_mut().zip(middle) {
                phase.length = (phase.length + step * then.crack_growth).max(0.0);
            }
        }
        Some(phases)
    }

    /// Where the forces of some bands together leave the linear range.
    ///
    /// |P₁|² is Σ_j A_j² ⟨|P₁/Δ|²⟩ over the lines, with A_j² twice the mean square of a line and the mean over
    /// the speeds of a vehicle: the amplitude of a sinusoid that has the RMS of the force. A broad
    /// spectrum parts wheel and rail for moments before.
    pub fn linear_range<'a>(&self, bands: impl IntoIterator<Item = &'a ForecastBand>) -> LinearRange {
        force_range(&self.traffic, bands)
    }
}

/// [`Forecast::linear_range`] of bands under a traffic.
fn force_range<'a>(traffic: &TrafficGrowth, bands: impl IntoIterator<Item = &'a ForecastBand>) -> LinearRange {
    let bands: Vec<&ForecastBand> = bands.into_iter().collect();
    let of_vehicle = |(vehicle, growth): (usize, &VehicleGrowth)| {
        let force =
            |bands: &[&ForecastBand]| GrowingSum::new(bands.iter().flat_map(|band| force_of(traffic, growth, band)));
        let all = force(&bands);
        if bands.iter().any(|band| band.marched.is_some()) {
            let each = bands.iter().map(|band| (*band, force(&[*band])));
            return LinearRange {
                force_ratio: all.mean_square(0.0).sqrt(),
                passages: parts_after(&each.collect::<Vec<_>>(), 0.0),
                vehicle,
            };
        }
        let passages = all.passages_to(1.0).and_then(|passages| {
            match bands.iter().any(|band| band.bend.is_some_and(|bend| bend.passages < passages)) {
                false => Some(passages),
                true => {
                    let each = bands.iter().map(|band| (*band, force(&[*band])));
                    parts_after(&each.collect::<Vec<_>>(), passages)
                }
            }
        });
        LinearRange { force_ratio: all.mean_square(0.0).sqrt(), passages, vehicle }
    };
    let ranges = traffic.vehicles().iter().enumerate().map(of_vehicle);
    ranges
        .min_by(|a, b| {
            let passages = |range: &LinearRange| range.passages.unwrap_or(f64::INFINITY);
            passages(a).total_cmp(&passages(b)).then(b.force_ratio.total_cmp(&a.force_ratio))
        })
        // There is a vehicle in every mix.
        .unwrap_or(LinearRange { force_ratio: 0.0, passages: None, vehicle: 0 })
}

/// |P₁|²/P₀² of the lines of a band under a vehicle, each with its growth rate.
fn force_of<'a>(
    traffic: &'a TrafficGrowth,
    vehicle: &'a VehicleGrowth,
    band: &ForecastBand,
) -> impl Iterator<Item = (f64, f64)> + use<'a> {
    let square = 2.0 * band.now.mean_square() / LINES_PER_BAND as f64;
    let lines = lines_of(band.place).zip(traffic.forecast_lines(band.place));
    lines.map(move |(line, rate)| {
        let per_amplitude = vehicle.growth.squared_force_per_amplitude[line];
        (square * per_amplitude / vehicle.wheel_load.powi(2), rate)
    })
}

/// Axle passages after which the forces of bands, some of which bend over, are P₀ together; by the exponentials that is after
/// `least`. `None` if it is never so, or beyond all traffic.
fn parts_after(bands: &[(&ForecastBand, GrowingSum)], least: f64) -> Option<f64> {
    const MOST: f64 = 1e15;
    let is_beyond = |passages: f64| {
        let squares = bands.iter().map(|(band, force)| {
            let by_rate = band.now.level + band.sum.level_change(passages);
            let decibels = force.level_change(passages) + band.level(passages) - by_rate;
            force.mean_square(0.0) * 10f64.powf(decibels / 10.0)
        });
        squares.sum::<f64>() >= 1.0
    };
    passages_until(least, MOST, is_beyond)
}
