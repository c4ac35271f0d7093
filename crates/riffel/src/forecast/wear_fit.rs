//! The wear coefficient from two dated measurements.

use super::jackknife::Variance;
use super::{GrowingSum, TrafficGrowth};
use crate::Error;
use crate::diagnosis::{FALL_BY_GRINDING, fall_of_bands};
use crate::roughness::{Spectrum, ThirdOctave, level, mean_square};

/// Fewest records on a side of which an interval is told: two have one degree of freedom, and t is 13.
const FEWEST: usize = 3;
/// Growth of a band \[dB\] from which the model must explain it. A choice: energy means of eight records of the
/// Niederwangen spectra scatter by about 1 dB.
pub const LARGE_CHANGE: f64 = 2.0;
/// Steps of the Gauss–Newton method.
const MOST_STEPS: usize = 200;

/// Fewest axle passages between two measurements of which growth can be told: no rail changes in fewer, and a count of 2 or 4 is of
/// millions. Riffel's choice.
pub const LEAST_PASSAGES: f64 = 1e4;

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
    /// The bands that should grow have fallen: the interval of the factor lies below zero or, where there are too few records for one,
    /// a band has fallen by 2 dB or more.
    Against,
    /// Their growth cannot be told from none: the interval holds zero, or the best factor without one is not above it.
    Indistinct,
    /// They grow, but there are too few records to say how surely.
    WithoutInterval,
    /// They grow.
    Fitted,
    /// Of the bands that have grown, the best factor leaves more than half unexplained.
    Unexplained,
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
    /// 95 % interval of the measured change \[dB\]; none with fewer than three records on a side.
    pub interval: Option<(f64, f64)>,
    /// Change of level by the model with the wear coefficient of the case \[dB\].
    pub predicted: f64,
    /// Change of level by the model with the best coefficient \[dB\].
    pub fitted: f64,
    /// Whether the model says that it grows, so that it was fitted.
    pub grows: bool,
}

impl FittedBand {
    /// Measured less fitted change \[dB\].
    pub fn residual(&self) -> f64 {
        self.measured - self.fitted
    }

    /// Whether it has grown on the rail by 2 dB or more, and more than its scatter.
    pub fn has_grown(&self) -> bool {
        self.measured >= LARGE_CHANGE && self.interval.is_none_or(|(low, _)| low > 0.0)
    }

    /// Whether it has fallen on the rail by more than its scatter or, where that is unknown, by 2 dB or more.
    pub fn has_fallen(&self) -> bool {
        match self.interval {
            Some((_, high)) => high < 0.0,
            None => self.measured <= -LARGE_CHANGE,
        }
    }

    /// Whether it has grown, and the model explains less than half of it and less than its interval.
    pub fn is_unexplained(&self) -> bool {
        let beyond = self.interval.is_none_or(|(low, _)| self.fitted < low);
        self.has_grown() && beyond && self.fitted < 0.5 * self.measured
    }
}

/// The wear coefficient that fits best, as a factor of that of the case.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct WearFit {
    /// Factor of the wear coefficient \[-\]; not above zero where the bands have not grown.
    pub factor: f64,
    /// 95 % interval of the factor by the scatter of the records; none with fewer than three on a side.
    pub interval: Option<(f64, f64)>,
    /// Every band measured twice, the shortest wavelength first.
    pub bands: Vec<FittedBand>,
    /// Whether records were taken in pairs of the same place.
    pub paired: bool,
    /// What to make of it.
    pub verdict: WearVerdict,
}

impl MeasuredChange {
    /// Records at the same places on both dates, in their order along the rail, with the axle passages between.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there are as many of both, one at least, and 10 000 passages or more.
    pub fn paired(earlier: Vec<Spectrum>, later: Vec<Spectrum>, passages: f64) -> Result<Self, Error> {
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
    /// [`Error::OutOfRange`] unless there is one of each at least, and 10 000 passages or more.
    pub fn groups(earlier: Vec<Spectrum>, later: Vec<Spectrum>, passages: f64) -> Result<Self, Error> {
        Self::new(earlier, later, passages, false)
    }

    fn new(earlier: Vec<Spectrum>, later: Vec<Spectrum>, passages: f64, paired: bool) -> Result<Self, Error> {
        if !(passages.is_finite() && passages >= LEAST_PASSAGES) {
            return Err(Error::OutOfRange {
                quantity: "axle passages between two measurements",
                value: passages,
                unit: "",
                rule: "must be finite and 10000 or more: in fewer no rail changes; are they millions?",
            });
        }
        for count in [earlier.len(), later.len()] {
            Error::unless_positive("number of records", count as f64, "")?;
        }
        Ok(Self { earlier, later, paired, passages })
    }

    /// Axle passages between the two.
    pub fn passages(&self) -> f64 {
        self.passages
    }

    /// 95 % interval of what `estimate` makes of the records but for one earlier and one later, if there are enough.
    fn interval(&self, estimate: impl Fn(Option<usize>, Option<usize>) -> f64) -> Option<(f64, f64)> {
        let (earlier, later) = (self.earlier.len(), self.later.len());
        if earlier.min(later) < FEWEST {
            return None;
        }
        let all = estimate(None, None);
        let variance = if self.paired {
            let pairs = (0..later).map(|one| estimate(Some(one), Some(one)));
            Variance::jackknife(all, pairs, true)
        } else {
            let before = (0..earlier).map(|one| estimate(Some(one), None));
            let after = (0..later).map(|one| estimate(None, Some(one)));
            Variance::jackknife(all, before, false).and(Variance::jackknife(all, after, false))
        };
        Some(variance.interval(all))
    }

    /// The mean squares of a band, if every record has it.
    fn measured(&self, band: ThirdOctave) -> Option<Measured> {
        let squares = |spectra: &[Spectrum]| -> Option<Vec<f64>> {
            let levels = spectra.iter().map(|spectrum| spectrum.level(band));
            levels.map(|level| level.map(mean_square)).collect()
        };
        Some(Measured { earlier: squares(&self.earlier)?, later: squares(&self.later)? })
    }
}

/// Mean squares of one band by record.
struct Measured {
    earlier: Vec<f64>,
    later: Vec<f64>,
}

impl Measured {
    /// Change of the energy mean \[dB\] over all records but one earlier and one later.
    fn change(&self, earlier: Option<usize>, later: Option<usize>) -> f64 {
        let mean = |squares: &[f64], without: Option<usize>| {
            let kept = squares.iter().enumerate();
            let kept = kept.filter(|(index, _)| Some(*index) != without);
            let count = squares.len() - usize::from(without.is_some());
            kept.map(|(_, square)| square).sum::<f64>() / count as f64
        };
        level(mean(&self.later, later)) - level(mean(&self.earlier, earlier))
    }
}

impl WearFit {
    /// Fit the wear coefficient to the measured change under the traffic.
    ///
    /// All growth rates are proportional to it, so that with κ times the coefficient of the case the level of
    /// a band changes by D(κ) = 10 lg of the mean over its lines of exp(2κ g_j N). κ minimises
    /// Σ (measured − D(κ))² over the bands whose rate is above zero in the model; those that decay in it are
    /// predicted but not fitted, for there what smooths a rail need not be wear by this law. κ may come out
    /// negative: then the bands have fallen. Bands that grow go as in a [`Forecast`](super::Forecast).
    ///
    /// The fit may fail: of the bands that have grown by 2 dB or more and more than their scatter, whether or not the
    /// model says so, it must leave no more than half, in the root of the mean squares.
    ///
    /// Method: Gauss–Newton with halved steps, to rounding; 95 % intervals by the jackknife over the records with
    /// Student's t, in pairs where the places are the same, neighbours together where they scatter together. They hold
    /// the truth in 93 to 97 of 100 cases at 3, 5, 8 and 20 records, and a coefficient is claimed where there is none in
    /// 3 of 100 or fewer (a test counts). Cost: a millisecond.
    ///
    /// # Errors
    /// [`Error::Measurement`] where no band of the traffic is in every record.
    pub fn new(change: &MeasuredChange, traffic: &TrafficGrowth) -> Result<Self, Error> {
        let mut bands = Vec::new();
        for (place, &band) in traffic.bands().iter().enumerate() {
            if let Some(measured) = change.measured(band) {
                let grows = traffic.band_rate(place) > 0.0;
                let model = match grows {
                    true => Model::new(traffic.forecast_lines(place)),
                    false => Model::new(traffic.lines(place).iter().copied()),
                };
                bands.push((band, measured, model, grows));
            }
        }
        if bands.is_empty() {
            return Err(Error::Measurement {
                index: 0,
                rule: "no band of the forecast is in every record of both dates",
            });
        }
        let passages = change.passages;
        let growing: Vec<&(ThirdOctave, Measured, Model, bool)> = bands.iter().filter(|band| band.3).collect();
        let models: Vec<&Model> = growing.iter().map(|band| &band.2).collect();
        let factor_without = |earlier: Option<usize>, later: Option<usize>| {
            let changes = growing.iter().map(|band| band.1.change(earlier, later));
            fit(&models, &changes.collect::<Vec<f64>>(), passages)
        };
        let (factor, interval) = match growing.is_empty() {
            true => (0.0, None),
            false => (factor_without(None, None), change.interval(factor_without)),
        };
        let fitted = bands.iter().map(|(band, measured, model, grows)| FittedBand {
            band: *band,
            measured: measured.change(None, None),
            interval: change.interval(|earlier, later| measured.change(earlier, later)),
            predicted: model.change(1.0, passages).0,
            fitted: model.change(factor, passages).0,
            grows: *grows,
        });
        let bands: Vec<FittedBand> = fitted.collect();
        let verdict = match interval {
            _ if fall_of_bands(bands.iter().map(|band| -band.measured)) > FALL_BY_GRINDING => WearVerdict::Against,
            _ if is_unexplained(&bands) => WearVerdict::Unexplained,
            _ if bands.iter().all(|band| !band.grows) => WearVerdict::NothingGrows,
            None if factor > 0.0 => WearVerdict::WithoutInterval,
            None if bands.iter().any(|band| band.grows && band.has_fallen()) => WearVerdict::Against,
            Some((_, high)) if high < 0.0 => WearVerdict::Against,
            Some((low, _)) if low > 0.0 => WearVerdict::Fitted,
            _ => WearVerdict::Indistinct,
        };
        Ok(Self { factor, interval, bands, paired: change.paired, verdict })
    }

    /// RMS of the residuals of the fitted bands \[dB\]; none without such a band.
    pub fn residual_rms(&self) -> Option<f64> {
        let residuals = self.bands.iter().filter(|band| band.grows);
        let squares: Vec<f64> = residuals.map(|band| band.residual().powi(2)).collect();
        (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
    }
}

/// Whether a fit leaves more than half of the growth on the rail unexplained, in the root of the mean squares over the bands
/// that have grown; one that decays in the model is explained by nothing.
fn is_unexplained(bands: &[FittedBand]) -> bool {
    let grown = || bands.iter().filter(|band| band.has_grown());
    let sum = |value: fn(&FittedBand) -> f64| grown().map(|band| value(band).powi(2)).sum::<f64>();
    bands.iter().any(FittedBand::is_unexplained)
        && sum(|band| band.measured - band.fitted.max(0.0)) > 0.25 * sum(|band| band.measured)
}

/// A band as lines of equal energy.
struct Model {
    sum: GrowingSum,
}

impl Model {
    fn new(rates: impl Iterator<Item = f64>) -> Self {
        Self { sum: GrowingSum::new(rates.map(|rate| (1.0, rate))) }
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
