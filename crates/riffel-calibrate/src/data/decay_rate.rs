//! Measured track decay rates.

use std::path::Path;

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel::receptance::DecayRate;
use riffel_case::Case;
use riffel_keys::{CaseError, say};
use riffel_noise::FrequencyBand;
use riffel_numerics::matrix::Matrix;
use riffel_numerics::random_numbers::uniform;
use statrs::distribution::{Continuous, ContinuousCDF, StudentsT};

use super::{Block, Conditional, Group, Observable, Place, table};
use crate::file::Kind;
use crate::gaussian::Density;
use crate::model::Trial;

/// Frequencies of a band.
const LINES: u32 = 16;
/// Frequencies of a band for slopes.
const FEW_LINES: u32 = 4;

/// Decay rates of one-third octaves: ln DR_b ~ t_ν(ln DR_b of the model, √(s_b² + σ²)), bands independent. Where the grid of
/// the measurement is too short for the rate, it is an upper bound, and its probability stands in the place of the density.
pub(crate) struct DecayRates {
    view: usize,
    centre: Vec<f64>,
    /// ln of the rates \[ln dB/m\].
    rate: Vec<f64>,
    error: Vec<f64>,
    upper_bound: Vec<bool>,
    student: StudentsT,
}

/// Standard error of ln DR of one curve where nothing is said of it.
fn usual_error(frequency: f64) -> f64 {
    match (190.0..=3200.0).contains(&frequency) {
        true => 0.12,
        false => 0.2,
    }
}

impl DecayRates {
    /// ln of the density of the rate of a band, or of the probability that its bound holds, t scales off the prediction.
    fn log_density(&self, band: usize, t: f64, scale: f64) -> f64 {
        match self.upper_bound[band] {
            true => self.student.cdf(t).ln(),
            false => self.student.ln_pdf(t) - scale.ln(),
        }
    }

    /// Scale of the error of a band, with what the model misses.
    fn scale(&self, band: usize, sizes: &[f64]) -> f64 {
        self.error[band].hypot(sizes[0])
    }

    /// ln of the rates of the model by so many frequencies a band.
    fn rates(&self, trial: &Trial<'_>, lines: u32) -> Result<Vec<f64>, String> {
        let case = trial.case(self.view)?;
        let structure = case.track.structure.as_deref();
        let structure = structure.ok_or("the track has no places along it")?;
        let rates = self.centre.iter();
        Ok(rates.map(|centre| DecayRate::of_band(structure, *centre, lines).ln()).collect())
    }

    pub(crate) fn read(path: &Path, view: (usize, &Case), student: StudentsT) -> Result<Self, CaseError> {
        let numbers = table::Numbers::of(path, Kind::DecayRate)?;
        let [frequency, rate] = [0, 1].map(|column| &numbers.needed[column]);
        let rule = "must be greater than zero";
        numbers.check(path, "decay_rate_db_per_m", rate, rule, |rate| rate > 0.0)?;
        if view.1.track.structure.is_none() {
            let message = "the track of the case is no model with places along it, and has no decay rates";
            return Err(numbers.refuse(path, 0, message));
        }
        let mut centre = Vec::new();
        for (row, f) in frequency.iter().enumerate() {
            let band = FrequencyBand::containing(*f).filter(|band| (f / band.centre() - 1.0).abs() <= 0.05);
            let band = band.map(FrequencyBand::centre).ok_or_else(|| {
                let message = format!("`frequency_hz` is {f}, but must be the centre of a one-third octave");
                numbers.refuse(path, row, &message)
            })?;
            centre.push(band);
        }
        numbers.unless_doubled(path, &centre, |one, other| one == other)?;
        let [of_ln, of_rate, bound] = [0, 1, 2].map(|column| &numbers.others[column]);
        for (name, error) in Kind::DecayRate.other_columns().iter().zip([of_ln, of_rate]) {
            let error = error.as_deref().unwrap_or_default();
            numbers.check(path, name, error, rule, |error| error > 0.0)?;
        }
        let error = match (of_ln, of_rate) {
            (Some(_), Some(_)) => return Err(numbers.refuse(path, 0, say!(two_errors_of_a_rate))),
            (Some(error), None) => error.clone(),
            // To first order.
            (None, Some(error)) => error.iter().zip(rate).map(|(error, rate)| error / rate).collect(),
            (None, None) => frequency.iter().map(|f| usual_error(*f)).collect(),
        };
        let upper_bound = match bound {
            Some(values) => values.iter().map(|value| *value != 0.0).collect(),
            None => vec![false; rate.len()],
        };
        Ok(Self {
            view: view.0,
            centre,
            rate: rate.iter().map(|rate| rate.ln()).collect(),
            error,
            upper_bound,
            student,
        })
    }
}

impl Block for DecayRates {
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        self.rates(trial, LINES)
    }

    fn predict_coarsely(&self, trial: &Trial<'_>) -> Option<Result<Vec<f64>, String>> {
        Some(self.rates(trial, FEW_LINES))
    }

    fn density(&self, predicted: &[f64], sizes: &[f64]) -> Option<Density> {
        let degrees = self.student.freedom();
        let mut density = Density::default();
        let mut by_size = 0.0;
        for (band, predicted) in predicted.iter().enumerate() {
            let scale = self.scale(band, sizes);
            let t = (self.rate[band] - predicted) / scale;
            let scale_by_size = sizes[0] / scale;
            let (by_t, by_scale) = match self.upper_bound[band] {
                true => (self.student.pdf(t) / self.student.cdf(t), 0.0),
                false => (-(degrees + 1.0) * t / (degrees + t * t), -1.0 / scale),
            };
            density.value += self.log_density(band, t, scale);
            density.by_prediction.push(-by_t / scale);
            by_size += (by_scale - by_t * t / scale) * scale_by_size;
        }
        density.by_size.push(by_size);
        density.value.is_finite().then_some(density)
    }

    fn of_each(&self, predicted: &[f64], sizes: &[f64]) -> Option<Vec<f64>> {
        let bands = predicted.iter().enumerate();
        Some(
            bands
                .map(|(band, predicted)| {
                    let scale = self.scale(band, sizes);
                    self.log_density(band, (self.rate[band] - predicted) / scale, scale)
                })
                .collect(),
        )
    }

    /// All bands, for they are independent; bounds have no share.
    fn given_rest(&self, _all: &Group, predicted: &[f64], sizes: &[f64]) -> Option<Conditional> {
        let bands = (0..self.rate.len()).filter(|band| !self.upper_bound[*band]);
        let shares = bands.map(|band| {
            let beside = self.rate[band] - predicted[band];
            self.student.cdf(beside / self.scale(band, sizes))
        });
        Some(Conditional { log_density: self.density(predicted, sizes)?.value, shares: shares.collect() })
    }

    fn replicate(&self, predicted: &[f64], sizes: &[f64], random: &mut Xoshiro256PlusPlus) -> Option<Vec<f64>> {
        let bands = predicted.iter().enumerate();
        let drawn = bands
            .map(|(band, predicted)| predicted + self.scale(band, sizes) * self.student.inverse_cdf(uniform(random)));
        Some(drawn.collect())
    }

    /// Where the grid is too short for more than some rate, a rate that is higher is known, and one that is lower is below it.
    fn with_data(&self, data: &[f64]) -> Option<Box<dyn Block>> {
        let bands = data.iter().enumerate();
        let below = |band: usize, rate: f64| self.upper_bound[band] && rate < self.rate[band];
        let known = bands.clone().map(|(band, rate)| match below(band, *rate) {
            true => self.rate[band],
            false => *rate,
        });
        Some(Box::new(Self {
            centre: self.centre.clone(),
            rate: known.collect(),
            error: self.error.clone(),
            upper_bound: bands.map(|(band, rate)| below(band, *rate)).collect(),
            ..*self
        }))
    }

    fn views(&self) -> Vec<usize> {
        vec![self.view]
    }

    fn observed(&self) -> Vec<f64> {
        self.rate.clone()
    }

    fn places(&self) -> Vec<Place> {
        let place = |centre: &f64| Place { measured: Observable::DecayRateDbPerM, at: *centre, of: None };
        self.centre.iter().map(place).collect()
    }

    /// Of a normal error that tells as much as Student's; bounds tell next to nothing.
    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        const NOTHING: f64 = 1e6;
        let degrees = self.student.freedom();
        let wider = (degrees + 3.0) / (degrees + 1.0);
        Matrix::of(self.rate.len(), |row, column| match row == column {
            false => 0.0,
            true if self.upper_bound[row] => NOTHING,
            true => wider * (self.error[row].powi(2) / times + sizes[0] * sizes[0]),
        })
    }
}
