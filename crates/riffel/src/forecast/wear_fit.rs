//! The wear coefficient from two dated measurements.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

use super::{GrowingSum, TrafficGrowth};
use crate::Error;
use crate::roughness::{Spectrum, ThirdOctave, level, mean_square};

/// Resamples of the bootstrap. The ends of the interval are then uncertain by a twentieth of its width.
const RESAMPLES: usize = 2000;
/// Share of the resamples outside the interval, half at either end.
const OUTSIDE: f64 = 0.05;
/// Seed of the resampling: the same records give the same interval on every machine.
const SEED: u64 = 0x5249_4646_454c;
/// Steps of the Gauss–Newton method.
const MOST_STEPS: usize = 200;

/// Spectra of the same rail at two dates with the axle passages between.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredChange {
    earlier: Vec<Spectrum>,
    later: Vec<Spectrum>,
    paired: bool,
    passages: f64,
}

/// Whether the measurements speak of a wear coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WearVerdict {
    /// The model says of no band that was measured twice that it grows.
    NothingGrows,
    /// The bands that should grow have fallen, by the sign of the best factor.
    Against,
    /// Their growth cannot be told from none: the interval holds zero.
    Indistinct,
    /// They grow, but there are too few records to say how surely.
    WithoutInterval,
    /// They grow.
    Fitted,
}

impl WearVerdict {
    /// Whether a coefficient may be taken from the fit.
    pub fn is_fit(self) -> bool {
        matches!(self, Self::Fitted | Self::WithoutInterval)
    }
}

/// A band measured twice.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct FittedBand {
    /// The band.
    pub band: ThirdOctave,
    /// Measured change of level \[dB\], of the energy means.
    pub measured: f64,
    /// Change of level by the model with the wear coefficient of the case \[dB\].
    pub predicted: f64,
    /// The same with the best coefficient \[dB\].
    pub fitted: f64,
    /// Whether the model says that it grows, so that it was fitted.
    pub grows: bool,
}

impl FittedBand {
    /// Measured less fitted change \[dB\].
    pub fn residual(&self) -> f64 {
        self.measured - self.fitted
    }
}

/// The wear coefficient that fits best, as a factor of that of the case.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct WearFit {
    /// Factor of the wear coefficient \[-\]; not above zero where the bands have fallen.
    pub factor: f64,
    /// 95 % interval of the factor by bootstrap over the records; none with fewer than three on a side.
    pub interval: Option<(f64, f64)>,
    /// Every band measured twice, the shortest wavelength first.
    pub bands: Vec<FittedBand>,
    /// Whether records were resampled in pairs of the same place.
    pub paired: bool,
    /// What to make of it.
    pub verdict: WearVerdict,
}

impl MeasuredChange {
    /// Records at the same places on both dates, in the same order, with the axle passages between.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there are as many of both, one at least, and passages above zero.
    pub fn paired(
        earlier: Vec<Spectrum>,
        later: Vec<Spectrum>,
        passages: f64,
    ) -> Result<Self, Error> {
        if earlier.len() != later.len() {
            return Err(Error::OutOfRange {
                quantity: "number of later records",
                value: later.len() as f64,
                unit: "",
                rule: "must be that of the earlier ones for pairs",
            });
        }
        Self::new(earlier, later, passages, true)
    }

    /// Records of two dates that do not belong together one by one, with the axle passages between.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there is one of each at least, and passages above zero.
    pub fn groups(
        earlier: Vec<Spectrum>,
        later: Vec<Spectrum>,
        passages: f64,
    ) -> Result<Self, Error> {
        Self::new(earlier, later, passages, false)
    }

    fn new(
        earlier: Vec<Spectrum>,
        later: Vec<Spectrum>,
        passages: f64,
        paired: bool,
    ) -> Result<Self, Error> {
        Error::unless_positive("axle passages between two measurements", passages, "")?;
        for count in [earlier.len(), later.len()] {
            Error::unless_positive("number of records", count as f64, "")?;
        }
        Ok(Self {
            earlier,
            later,
            paired,
            passages,
        })
    }

    /// Axle passages between the two.
    pub fn passages(&self) -> f64 {
        self.passages
    }

    /// Change of the energy mean of a band \[dB\] over the records of some indices.
    fn change(&self, band: &Measured, earlier: &[usize], later: &[usize]) -> f64 {
        let mean = |squares: &[f64], indices: &[usize]| {
            indices.iter().map(|&index| squares[index]).sum::<f64>() / indices.len() as f64
        };
        level(mean(&band.later, later)) - level(mean(&band.earlier, earlier))
    }

    /// The mean squares of a band, if every record has it.
    fn measured(&self, band: ThirdOctave) -> Option<Measured> {
        let squares = |spectra: &[Spectrum]| -> Option<Vec<f64>> {
            let levels = spectra.iter().map(|spectrum| spectrum.level(band));
            levels.map(|level| level.map(mean_square)).collect()
        };
        Some(Measured {
            earlier: squares(&self.earlier)?,
            later: squares(&self.later)?,
        })
    }
}

/// Mean squares of one band by record.
struct Measured {
    earlier: Vec<f64>,
    later: Vec<f64>,
}

impl WearFit {
    /// Fit the wear coefficient to the measured change under the traffic.
    ///
    /// All growth rates are proportional to it, so that with κ times the coefficient of the case the level of
    /// a band changes by D(κ) = 10 lg of the mean over its lines of exp(2κ g_j N). κ minimises
    /// Σ (measured − D(κ))² over the bands whose rate is above zero in the model; those that decay in it are
    /// predicted but not fitted, for there what smooths a rail need not be wear by this law. κ may come out
    /// negative: then the bands have fallen.
    ///
    /// Method: Gauss–Newton with halved steps, to rounding; 95 % interval between percentiles of 2000
    /// resamples of the records (Efron 1979), in pairs where the places are the same.
    /// Cost: some milliseconds.
    ///
    /// # Errors
    /// [`Error::Measurement`] where no band of the traffic is in every record.
    pub fn new(change: &MeasuredChange, traffic: &TrafficGrowth) -> Result<Self, Error> {
        let mut bands = Vec::new();
        for (place, &band) in traffic.bands().iter().enumerate() {
            if let Some(measured) = change.measured(band) {
                let grows = traffic.band_rate(place) > 0.0;
                bands.push((band, measured, Model::new(traffic.lines(place)), grows));
            }
        }
        if bands.is_empty() {
            return Err(Error::Measurement {
                index: 0,
                rule: "no band of the forecast is in every record of both dates",
            });
        }
        let passages = change.passages;
        let growing: Vec<&(ThirdOctave, Measured, Model, bool)> =
            bands.iter().filter(|band| band.3).collect();
        let models: Vec<&Model> = growing.iter().map(|band| &band.2).collect();
        let factor_of = |earlier: &[usize], later: &[usize]| {
            let changes = growing.iter();
            let changes: Vec<f64> = changes
                .map(|band| change.change(&band.1, earlier, later))
                .collect();
            fit(&models, &changes, passages)
        };
        let all = |spectra: &[Spectrum]| (0..spectra.len()).collect::<Vec<usize>>();
        let (earlier, later) = (all(&change.earlier), all(&change.later));
        let factor = if growing.is_empty() {
            0.0
        } else {
            factor_of(&earlier, &later)
        };
        /// Fewer records have too few different resamples for a percentile of 2.5.
        const FEWEST: usize = 3;
        let enough = earlier.len().min(later.len()) >= FEWEST && !growing.is_empty();
        let interval = enough.then(|| {
            let mut random = Xoshiro256PlusPlus::seed_from_u64(SEED);
            let mut factors: Vec<f64> = (0..RESAMPLES)
                .map(|_| {
                    let first = resample(&mut random, earlier.len());
                    let second = if change.paired {
                        first.clone()
                    } else {
                        resample(&mut random, later.len())
                    };
                    factor_of(&first, &second)
                })
                .collect();
            factors.sort_by(f64::total_cmp);
            let cut = (0.5 * OUTSIDE * RESAMPLES as f64) as usize;
            (factors[cut], factors[RESAMPLES - 1 - cut])
        });
        let verdict = match interval {
            _ if growing.is_empty() => WearVerdict::NothingGrows,
            _ if factor <= 0.0 => WearVerdict::Against,
            None => WearVerdict::WithoutInterval,
            Some((low, _)) if low <= 0.0 => WearVerdict::Indistinct,
            Some(_) => WearVerdict::Fitted,
        };
        let bands = bands
            .iter()
            .map(|(band, measured, model, grows)| FittedBand {
                band: *band,
                measured: change.change(measured, &earlier, &later),
                predicted: model.change(1.0, passages).0,
                fitted: model.change(factor, passages).0,
                grows: *grows,
            });
        Ok(Self {
            factor,
            interval,
            bands: bands.collect(),
            paired: change.paired,
            verdict,
        })
    }

    /// RMS of the residuals of the fitted bands \[dB\]; none without such a band.
    pub fn residual_rms(&self) -> Option<f64> {
        let residuals = self.bands.iter().filter(|band| band.grows);
        let squares: Vec<f64> = residuals.map(|band| band.residual().powi(2)).collect();
        (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
    }
}

/// A band as lines of equal energy.
struct Model {
    sum: GrowingSum,
}

impl Model {
    fn new(rates: &[f64]) -> Self {
        Self {
            sum: GrowingSum::new(rates.iter().map(|&rate| (1.0, rate))),
        }
    }

    /// Change of level with a factor of the wear coefficient \[dB\] and its derivative by the factor: growth
    /// depends on factor and passages by their product alone.
    fn change(&self, factor: f64, passages: f64) -> (f64, f64) {
        let worn = factor * passages;
        let slope = 20.0 / std::f64::consts::LN_10 * passages * self.sum.rate(worn);
        (self.sum.level_change(worn), slope)
    }
}

/// The factor of least squares.
fn fit(models: &[&Model], changes: &[f64], passages: f64) -> f64 {
    let at = |factor: f64| {
        let (mut squares, mut gradient, mut curvature) = (0.0, 0.0, 0.0);
        for (model, change) in models.iter().zip(changes) {
            let (predicted, slope) = model.change(factor, passages);
            let residual = change - predicted;
            squares += residual * residual;
            gradient += slope * residual;
            curvature += slope * slope;
        }
        (squares, gradient / curvature)
    };
    let mut factor = 0.0;
    let (mut squares, mut step) = at(factor);
    for _ in 0..MOST_STEPS {
        let next = factor + step;
        let (least, further) = at(next);
        if least <= squares {
            (factor, squares) = (next, least);
            step = further;
        } else {
            step *= 0.5;
        }
        if step.abs() <= 1e-12 * factor.abs() {
            break;
        }
    }
    factor
}

/// As many indices as there are, each any of them.
fn resample(random: &mut Xoshiro256PlusPlus, count: usize) -> Vec<usize> {
    (0..count)
        // The remainder of 64 bits by a few records is even to 1e-18.
        .map(|_| (random.next_u64() % count as u64) as usize)
        .collect()
}
