//! Growth of a rail by what was measured of it at several dates.

use super::jackknife::Variance;
use super::passages_until::passages_until;
use crate::Error;
use crate::diagnosis::first_since_ground;
use crate::roughness::{Spectrum, ThirdOctave, level, mean_square};

/// Fewest records of a date of which a scatter is told.
const FEWEST: usize = 3;
/// Scatter of the level of a date \[dB\] where neither records nor dates tell it. A choice: energy means of eight records of the
/// Niederwangen spectra scatter by about 1 dB.
const UNKNOWN_SCATTER: f64 = 1.0;
/// Time beyond which no limit is looked for, in spans of the dates.
const MOST_SPANS: f64 = 1e4;

/// How the bands of a rail grow, by its dates since it was last ground.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredGrowth {
    bands: Vec<MeasuredBand>,
}

/// How a band grows by its dates: a straight line through its levels.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct MeasuredBand {
    /// The band.
    pub band: ThirdOctave,
    /// Change of its level \[dB\] per unit of time.
    pub slope: f64,
    /// The dates, the last one is now.
    times: Vec<f64>,
    /// What the level of a date is off by chance.
    scatter: Variance,
}

/// The mean squares of a band, date by date.
struct Dated {
    times: Vec<f64>,
    squares: Vec<Vec<f64>>,
}

/// Mean, and weights of the slope of a straight line through values at some times.
fn weights(times: &[f64]) -> Vec<f64> {
    let mean = times.iter().sum::<f64>() / times.len() as f64;
    let spread: f64 = times.iter().map(|time| (time - mean).powi(2)).sum();
    times.iter().map(|time| (time - mean) / spread).collect()
}

impl Dated {
    /// A band of the records at dates that rise, since its level last fell as by grinding; `None` if that is one date.
    fn new(dates: &[(f64, Vec<Spectrum>)], band: ThirdOctave) -> Option<Self> {
        let known = dates.iter().filter_map(|(time, records)| {
            let levels = records.iter().map(|record| record.level(band));
            let squares: Option<Vec<f64>> = levels.map(|own| own.map(mean_square)).collect();
            squares.filter(|squares| !squares.is_empty()).map(|squares| (*time, squares))
        });
        let (times, squares): (Vec<f64>, Vec<Vec<f64>>) = known.unzip();
        let all = Self { times, squares };
        let levels: Vec<f64> = (0..all.times.len()).map(|date| all.level(date, None)).collect();
        let since = first_since_ground(levels.windows(2).map(|pair| pair[0] - pair[1]));
        let begins_now = all.times.last().copied() == dates.last().map(|date| date.0);
        (begins_now && all.times.len() >= since + 2)
            .then(|| Self { times: all.times[since..].to_vec(), squares: all.squares[since..].to_vec() })
    }

    /// Level of a date over all records but one.
    fn level(&self, date: usize, without: Option<usize>) -> f64 {
        let squares = self.squares[date].iter().enumerate();
        let kept = squares.filter(|(record, _)| Some(*record) != without);
        let (count, sum) = kept.fold((0.0, 0.0), |(count, sum), (_, square)| (count + 1.0, sum + square));
        level(sum / count)
    }

    /// Slope of the levels over all records but one, of every date or of one.
    fn slope(&self, without: Option<usize>, of: Option<usize>) -> f64 {
        let weights = weights(&self.times).into_iter().enumerate();
        let parts = weights.map(|(date, weight)| {
            let left_out = without.filter(|_| of.is_none_or(|of| of == date));
            weight * self.level(date, left_out)
        });
        parts.sum()
    }

    /// Variance of the level of a date by its records, in pairs of the same place or not; `None` if they are too few.
    fn scatter(&self, paired: bool) -> Option<Variance> {
        let counts: Vec<usize> = self.squares.iter().map(Vec::len).collect();
        if counts.iter().any(|count| *count < FEWEST) {
            return None;
        }
        let all = self.slope(None, None);
        let of_slope = match paired {
            true => {
                let without = (0..counts[0]).map(|place| self.slope(Some(place), None));
                Variance::jackknife(all, without, true)
            }
            false => {
                let dates = counts.iter().enumerate().map(|(date, count)| {
                    let without = (0..*count).map(|record| self.slope(Some(record), Some(date)));
                    Variance::jackknife(all, without, false)
                });
                dates.reduce(Variance::and)?
            }
        };
        let squares: f64 = weights(&self.times).iter().map(|weight| weight.powi(2)).sum();
        Some(of_slope.times(squares.recip()))
    }

    /// Sum of the squares that the levels are off their line, with its degrees of freedom.
    fn off_line(&self) -> (f64, f64) {
        let count = self.times.len();
        let level = |date: usize| self.level(date, None);
        let mean = (0..count).map(level).sum::<f64>() / count as f64;
        let middle = self.times.iter().sum::<f64>() / count as f64;
        let slope = self.slope(None, None);
        let off = (0..count).map(|date| level(date) - mean - slope * (self.times[date] - middle));
        (off.map(|off| off.powi(2)).sum(), count as f64 - 2.0)
    }
}

impl MeasuredGrowth {
    /// The growth by records of a rail at dates that rise, in any unit of time, `paired` where the records of every date are of the
    /// same places in the same order. Bands that are not known of two dates since their level last fell by
    /// [more than 3 dB](crate::diagnosis::FALL_BY_GRINDING), or not now, are not in it.
    ///
    /// Method: least squares through the levels of the energy means; their scatter by the jackknife over the records (places, where
    /// they are paired), widened where levels of three dates and more are farther off their lines than that (ratio of Birge 1932, over
    /// all bands), as by an instrument that reads all of a date too high; never narrowed, for places that grow each at its own rate lie
    /// on their lines and scatter all the same. With fewer than three records of a date the scatter is what
    /// the levels of all bands are off their lines, and of two dates 1 dB.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for times that do not rise.
    pub fn new(dates: &[(f64, Vec<Spectrum>)], paired: bool) -> Result<Self, Error> {
        if let Some(pair) = dates.windows(2).find(|pair| pair[1].0 <= pair[0].0) {
            return Err(Error::OutOfRange {
                quantity: "date of a measurement",
                value: pair[1].0,
                unit: "",
                rule: "must be later than the one before",
            });
        }
        let now = dates.last().and_then(|(_, records)| records.first());
        let bands = now.into_iter().flat_map(|record| record.levels());
        let known = bands.filter_map(|now| {
            let dated = Dated::new(dates, now.band)?;
            Some((now.band, dated.scatter(paired), dated))
        });
        let known: Vec<(ThirdOctave, Option<Variance>, Dated)> = known.collect();
        let (mut off, mut freedom, mut expected) = (0.0, 0.0, 0.0);
        for (_, scatter, dated) in &known {
            let own = dated.off_line();
            (off, freedom) = (off + own.0, freedom + own.1);
            expected += own.1 * scatter.map_or(f64::NAN, Variance::size);
        }
        let by_dates = match freedom > 0.0 {
            true => Variance::new(off / freedom, freedom),
            false => Variance::new(UNKNOWN_SCATTER.powi(2), f64::INFINITY),
        };
        // Of two scatters that are alike the ratio is seldom more than this over one. A smaller ratio says nothing: places may grow each at its own
        // rate, off no line.
        let chance = 2.0 * (2.0 / freedom).sqrt();
        let widened = |scatter: Variance| match expected > 0.0 && off > (1.0 + chance) * expected {
            true => scatter.times(off / expected).known_less(freedom),
            false => scatter,
        };
        let bands = known.into_iter().map(|(band, scatter, dated)| MeasuredBand {
            band,
            slope: dated.slope(None, None),
            scatter: scatter.map_or(by_dates, widened),
            times: dated.times,
        });
        Ok(Self { bands: bands.collect() })
    }

    /// The growth of a rail with another unit of time, of which the present one has so many.
    #[must_use]
    pub fn in_unit(mut self, per_unit: f64) -> Self {
        for band in &mut self.bands {
            band.slope /= per_unit;
            band.times.iter_mut().for_each(|time| *time *= per_unit);
        }
        self
    }

    /// The growth where that of each band is so many times as large, as something else than the rail makes it.
    #[must_use]
    pub fn scaled(mut self, factor: impl Fn(ThirdOctave) -> f64) -> Self {
        for band in &mut self.bands {
            let factor = factor(band.band);
            band.slope *= factor;
            band.scatter = band.scatter.times(factor * factor);
        }
        self
    }

    /// The band that grows fastest.
    pub fn fastest(&self) -> Option<&MeasuredBand> {
        let bands = self.bands.iter();
        bands.max_by(|a, b| a.slope.total_cmp(&b.slope))
    }

    /// The bands, the shortest wavelength first.
    pub fn bands(&self) -> &[MeasuredBand] {
        &self.bands
    }

    /// The growth of a band, where it is known.
    pub fn band(&self, band: ThirdOctave) -> Option<&MeasuredBand> {
        self.bands.iter().find(|own| own.band == band)
    }
}

impl MeasuredBand {
    /// Time from the first of the dates to now.
    pub fn span(&self) -> f64 {
        self.times[self.times.len() - 1] - self.times[0]
    }

    /// Bands of 50 and 80 % of the slope \[dB\] per unit of time.
    pub fn slope_within(&self) -> [[f64; 2]; 2] {
        self.about(self.slope, |weight, _| weight)
    }

    /// Band of 80 % of the change of the level \[dB\] in some time from now, from what was `measured` now or from a level that is known;
    /// a level that falls stays, as in a [`Forecast`](super::Forecast).
    pub fn change_80(&self, ahead: f64, measured: bool) -> [f64; 2] {
        let last = self.times.len() - 1;
        let now = |date: usize| f64::from(u8::from(measured && date == last));
        let factor = |weight: f64, date: usize| ahead * weight + now(date);
        self.about(self.slope.max(0.0) * ahead, factor)[1]
    }

    /// Between what times the level rises by some decibels, by 80 %, from what was `measured` now or from a level that is known; none
    /// where it does not.
    pub fn time_80(&self, rise: f64, measured: bool) -> [Option<f64>; 2] {
        [1, 0].map(|end| {
            passages_until(0.0, MOST_SPANS * self.span(), |ahead| self.change_80(ahead, measured)[end] >= rise)
        })
    }

    /// Bands of 50 and 80 % about a sum of the levels of the dates, each with a factor of its weight in the slope and its place.
    fn about(&self, sum: f64, factor: impl Fn(f64, usize) -> f64) -> [[f64; 2]; 2] {
        let weights = weights(&self.times).into_iter().enumerate();
        let squares: f64 = weights.map(|(date, weight)| factor(weight, date).powi(2)).sum();
        self.scatter.times(squares).bands(sum)
    }
}
