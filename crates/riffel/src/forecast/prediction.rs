//! The spectrum after some passages.

use super::traffic::lines_of;
use super::{GrowingSum, LINES_PER_BAND, TrafficGrowth};
use crate::Error;
use crate::roughness::{BandLevel, LevelLimit, Spectrum, mean_square};

/// A spectrum under traffic.
///
/// What decays in the model keeps today's level: nothing in it makes the roughness that traffic makes on a real rail, so
/// that waves would sink without end.
///
/// Range of validity: the loop is linear. It holds while the wheel stays on the rail, see
/// [`valid_to`](Self::valid_to), and while track, friction and traffic stay as they are. Levels beyond are what
/// the exponentials say and nothing more: real corrugation slows down.
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
}

/// The amplitude up to which the loop is linear: |P₁| < P₀, wheel and rail in contact.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearRange {
    /// |P₁|/P₀ now \[-\].
    pub force_ratio: f64,
    /// Axle passages until it is one; none where it never is.
    pub passages: Option<f64>,
    /// The vehicle that parts first, by its place in the mix; where none does, the one of the largest ratio.
    pub vehicle: usize,
}

impl ForecastBand {
    /// Level after some axle passages \[dB re 1 µm\] by the exponentials, within the linear range and beyond.
    pub fn level(&self, passages: f64) -> f64 {
        self.now.level + self.sum.level_change(passages)
    }

    /// Axle passages until a level is reached \[dB re 1 µm\].
    pub fn passages_to(&self, level: f64) -> Option<f64> {
        self.sum.passages_to(mean_square(level))
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
                let now = BandLevel {
                    band,
                    level: spectrum.level(band)?,
                };
                let line = now.mean_square() / LINES_PER_BAND as f64;
                let rates = traffic.forecast_lines(place);
                let sum = GrowingSum::new(rates.map(|rate| (line, rate)));
                Some(ForecastBand { now, sum, place })
            })
            .collect();
        if bands.is_empty() {
            return Err(Error::Measurement {
                index: 0,
                rule: "no band of the spectrum lies in the wavelengths of the forecast",
            });
        }
        let linear = force_range(&traffic, bands.iter());
        Ok(Self {
            traffic,
            bands,
            linear,
        })
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
        let beyond = reaches
            .iter()
            .any(|(_, _, reach)| *reach == Reach::BeyondLinearRange);
        match passages.min_by(f64::total_cmp) {
            Some(passages) => Reach::After(passages),
            None if beyond => Reach::BeyondLinearRange,
            None => Reach::Never,
        }
    }

    /// Where the forces of some bands together leave the linear range.
    ///
    /// |P₁|² is Σ_j A_j² ⟨|P₁/Δ|²⟩ over the lines, with A_j² twice the mean square of a line and the mean over
    /// the speeds of a vehicle: the amplitude of a sinusoid that has the RMS of the force. A broad
    /// spectrum parts wheel and rail for moments before.
    pub fn linear_range<'a>(
        &self,
        bands: impl IntoIterator<Item = &'a ForecastBand>,
    ) -> LinearRange {
        force_range(&self.traffic, bands)
    }
}

/// [`Forecast::linear_range`] of bands under a traffic.
fn force_range<'a>(
    traffic: &TrafficGrowth,
    bands: impl IntoIterator<Item = &'a ForecastBand>,
) -> LinearRange {
    let bands: Vec<&ForecastBand> = bands.into_iter().collect();
    let of_vehicle = |(vehicle, growth): (usize, &super::VehicleGrowth)| {
        let force = GrowingSum::new(bands.iter().flat_map(|band| {
            let square = 2.0 * band.now.mean_square() / LINES_PER_BAND as f64;
            let lines = lines_of(band.place).zip(traffic.forecast_lines(band.place));
            lines.map(move |(line, rate)| {
                let per_amplitude = growth.growth.squared_force_per_amplitude[line];
                (square * per_amplitude / growth.wheel_load.powi(2), rate)
            })
        }));
        LinearRange {
            force_ratio: force.mean_square(0.0).sqrt(),
            passages: force.passages_to(1.0),
            vehicle,
        }
    };
    let ranges = traffic.vehicles().iter().enumerate().map(of_vehicle);
    ranges
        .min_by(|a, b| {
            let passages = |range: &LinearRange| range.passages.unwrap_or(f64::INFINITY);
            passages(a)
                .total_cmp(&passages(b))
                .then(b.force_ratio.total_cmp(&a.force_ratio))
        })
        // There is a vehicle in every mix.
        .unwrap_or(LinearRange {
            force_ratio: 0.0,
            passages: None,
            vehicle: 0,
        })
}
