//! The closed forms of `validation/calibration/conjugate.json`, for tests.

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel_numerics::distribution::Distribution;
use riffel_numerics::matrix::Matrix;
use riffel_numerics::random_numbers::normal;
use serde_json::Value;

use crate::data::{Block, Conditional, Group, Place, sums};
use crate::gaussian::{Density, Gaussian};
use crate::linear::{Known, Normal};
use crate::model::{Model, Parameter, Role, Trial};
use crate::posterior::{Named, Posterior};
use crate::prior::Prior;

fn at(pointer: &str) -> Value {
    let text = include_str!("../../../validation/calibration/conjugate.json");
    let document: Value = serde_json::from_str(text).unwrap();
    document.pointer(pointer).unwrap().clone()
}

pub(crate) fn number(pointer: &str) -> f64 {
    at(pointer).as_f64().unwrap()
}

pub(crate) fn numbers(pointer: &str) -> Vec<f64> {
    let list = at(pointer);
    let list = list.as_array().unwrap().iter();
    list.map(|number| number.as_f64().unwrap()).collect()
}

/// Three bands at three dates that grow by κ times a slope: y = L_b + κ s_b N + c_t + ε, errors 0.5 dB and 0.3 dB for all of a
/// date.
pub(crate) struct U1 {
    pub(crate) slopes: Vec<f64>,
    passages: Vec<f64>,
    levels: Vec<Vec<f64>>,
}

impl U1 {
    pub(crate) fn read() -> Self {
        let levels = (0..3).map(|date| numbers(&format!("/U1/levels_db/{date}")));
        Self {
            slopes: numbers("/U1/slopes_db_per_1e6"),
            passages: numbers("/U1/passages_1e6"),
            levels: levels.collect(),
        }
    }

    pub(crate) fn numbers(&self, pointer: &str) -> Vec<f64> {
        numbers(&format!("/U1{pointer}"))
    }

    /// κ ~ N(1, 1), L_b ~ N(0, 10²).
    pub(crate) fn proper(&self) -> Vec<Known> {
        self.known(1e-2)
    }

    /// κ ~ N(1, 1), nothing known of L_b.
    pub(crate) fn flat(&self) -> Vec<Known> {
        self.known(0.0)
    }

    fn known(&self, of_levels: f64) -> Vec<Known> {
        let growth = Known { mean: 1.0, precision: 1.0 };
        let level = Known { mean: 0.0, precision: of_levels };
        vec![growth, level, level, level]
    }

    /// Columns of κ and of the levels, covariance of the errors and data of some dates.
    pub(crate) fn equations(&self, dates: &[usize]) -> (Vec<Vec<f64>>, Matrix, Vec<f64>) {
        let rows: Vec<(usize, usize)> = dates.iter().flat_map(|date| (0..3).map(move |band| (*date, band))).collect();
        let growth = rows.iter();
        let growth = growth.map(|(date, band)| self.slopes[*band] * self.passages[*date]);
        let mut columns = vec![growth.collect()];
        columns.extend((0..3).map(|own| {
            let is_own = rows.iter().map(|(_, band)| f64::from(u8::from(*band == own)));
            is_own.collect::<Vec<f64>>()
        }));
        let errors = Matrix::of(rows.len(), |i, j| {
            let own = if i == j { 0.25 } else { 0.0 };
            own + if rows[i].0 == rows[j].0 { 0.09 } else { 0.0 }
        });
        let data = rows.iter().map(|(date, band)| self.levels[*date][*band]);
        (columns, errors, data.collect())
    }

    pub(crate) fn after(&self, known: &[Known]) -> Normal {
        self.after_dates(known, &[0, 1, 2])
    }

    pub(crate) fn after_dates(&self, known: &[Known], dates: &[usize]) -> Normal {
        let (columns, errors, data) = self.equations(dates);
        Normal::after(known, &columns, &errors.cholesky().unwrap(), &data).unwrap()
    }
}

/// The levels of some dates: over all first levels κ is their one value; else these are values, too.
struct Levels {
    gaussian: Gaussian,
    /// The data of one of each value.
    columns: Vec<Vec<f64>>,
    data: Vec<f64>,
    /// Factor of the errors of replicas.
    times: f64,
}

impl U1 {
    /// Levels of some dates with the covariance that errors and first levels give them.
    fn levels(&self, dates: &[usize]) -> Levels {
        let (columns, errors, data) = self.equations(dates);
        let known = self.proper();
        let covariance = Matrix::of(data.len(), |i, j| {
            let of_levels = columns.iter().zip(&known).skip(1);
            let of_levels = of_levels.map(|(a, known)| a[i] * a[j] / known.precision);
            errors.at(i, j) + of_levels.sum::<f64>()
        });
        Levels {
            gaussian: Gaussian::new(covariance, Vec::new()).unwrap(),
            columns: columns[..1].to_vec(),
            data,
            times: 1.0,
        }
    }

    /// What the sampler draws κ from.
    pub(crate) fn posterior(&self, dates: &[usize]) -> Posterior {
        self.posterior_of(self.levels(dates))
    }

    /// Posterior of all dates, whose data are simulated with errors so many times as large as those that are said of them.
    pub(crate) fn posterior_of_errors(&self, times: f64) -> Posterior {
        let levels = self.levels(&[0, 1, 2]);
        self.posterior_of(Levels { times, ..levels })
    }

    /// What the sampler draws κ and the first levels from.
    pub(crate) fn posterior_of_all(&self) -> Posterior {
        let (columns, errors, data) = self.equations(&[0, 1, 2]);
        self.posterior_of(Levels { gaussian: Gaussian::new(errors, Vec::new()).unwrap(), columns, data, times: 1.0 })
    }

    fn posterior_of(&self, levels: Levels) -> Posterior {
        let values = levels.columns.len();
        let known = self.proper().into_iter().take(values);
        let parameters = known.enumerate().map(|(place, known)| Parameter {
            name: format!("value {place}"),
            unit: String::new(),
            prior: Prior::Of(Distribution::normal(known.mean, known.precision.powf(-0.5))),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            role: Role::Size,
            in_data: None,
        });
        Posterior {
            model: Model { parameters: parameters.collect(), views: Vec::new(), vehicles: Vec::new(), speed: None },
            blocks: vec![Named {
                names: vec!["levels".to_owned()],
                block: Box::new(levels),
                sizes: Vec::new(),
                touched_by: (0..values).collect(),
            }],
        }
    }

    /// A date given the others, for one κ.
    pub(crate) fn given_rest(&self, growth: f64, date: usize) -> Conditional {
        let levels = self.levels(&[0, 1, 2]);
        let group = [0, 1, 2].map(|band| 3 * date + band);
        let group = Group::single(levels.data.len(), &group);
        let predicted = levels.predicted(&[growth]);
        levels.given_rest(&group, &predicted, &[]).unwrap()
    }
}

impl Levels {
    fn predicted(&self, values: &[f64]) -> Vec<f64> {
        let at = |place: usize| {
            let pairs = self.columns.iter().zip(values);
            pairs.map(|(column, value)| column[place] * value).sum()
        };
        (0..self.data.len()).map(at).collect()
    }
}

impl Block for Levels {
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        Ok(self.predicted(trial.values))
    }

    fn gaussian(&self) -> Option<&Gaussian> {
        Some(&self.gaussian)
    }

    fn views(&self) -> Vec<usize> {
        Vec::new()
    }

    fn observed(&self) -> Vec<f64> {
        self.data.clone()
    }

    fn places(&self) -> Vec<Place> {
        Vec::new()
    }

    fn replicate(&self, predicted: &[f64], sizes: &[f64], random: &mut Xoshiro256PlusPlus) -> Option<Vec<f64>> {
        let errors = self.gaussian.draw(sizes, || self.times * normal(random))?;
        Some(sums(predicted, &errors))
    }

    fn with_data(&self, data: &[f64]) -> Option<Box<dyn Block>> {
        Some(Box::new(Self {
            gaussian: self.gaussian.clone(),
            columns: self.columns.clone(),
            data: data.to_vec(),
            times: self.times,
        }))
    }

    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        self.gaussian.covariance_of_mean(sizes, times)
    }
}

/// A likelihood with two modes over two values, each N(0, 1) before: 0.7 N(x; −1, s²) + 0.3 N(x; 1, s²) times N(y; 0.5, s²), s = 0.1.
pub(crate) struct Modes;

impl Modes {
    const WEIGHTS: [(f64, f64); 2] = [(0.7, -1.0), (0.3, 1.0)];
    const OTHER: f64 = 0.5;
    const SPREAD: f64 = 0.1;
    /// The share of the mode at x = 1: that of the likelihood, for the prior is even.
    pub(crate) const RIGHT: f64 = 0.3;
    /// ln of N(1; 0, 1 + s²) N(0.5; 0, 1 + s²): −ln 2π(1 + s²) − 1.25/2(1 + s²).
    pub(crate) const LOG_EVIDENCE: f64 = -2.466_639_278_450_632;

    pub(crate) fn posterior() -> Posterior {
        let prior = Distribution::normal(0.0, 1.0);
        let parameter = |name: &str| Parameter {
            name: name.to_owned(),
            unit: String::new(),
            prior: Prior::Of(prior),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            role: Role::Size,
            in_data: None,
        };
        Posterior {
            model: Model {
                parameters: vec![parameter("x"), parameter("y")],
                views: Vec::new(),
                vehicles: Vec::new(),
                speed: None,
            },
            blocks: vec![Named {
                names: vec!["modes".to_owned()],
                block: Box::new(Self),
                sizes: Vec::new(),
                touched_by: vec![0, 1],
            }],
        }
    }
}

impl Block for Modes {
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        Ok(trial.values.to_vec())
    }

    fn density(&self, predicted: &[f64], _: &[f64]) -> Option<Density> {
        let log = |x: f64, mean: f64| {
            let t = (x - mean) / Self::SPREAD;
            -0.5 * t * t - Self::SPREAD.ln() - 0.5 * std::f64::consts::TAU.ln()
        };
        let logs = Self::WEIGHTS.map(|(weight, mean)| weight.ln() + log(predicted[0], mean));
        let highest = logs[0].max(logs[1]);
        let parts = logs.map(|log| (log - highest).exp());
        let sum = parts[0] + parts[1];
        let pull = |mean: f64, x: f64| (mean - x) / Self::SPREAD.powi(2);
        let pulls = Self::WEIGHTS.iter().zip(parts);
        let by_x = pulls.map(|((_, mean), part)| part / sum * pull(*mean, predicted[0]));
        Some(Density {
            value: highest + sum.ln() + log(predicted[1], Self::OTHER),
            by_prediction: vec![by_x.sum(), pull(Self::OTHER, predicted[1])],
            by_size: Vec::new(),
        })
    }

    fn places(&self) -> Vec<Place> {
        Vec::new()
    }

    fn views(&self) -> Vec<usize> {
        Vec::new()
    }

    fn observed(&self) -> Vec<f64> {
        vec![0.0; 2]
    }

    fn of_each(&self, _: &[f64], _: &[f64]) -> Option<Vec<f64>> {
        None
    }

    fn replicate(&self, _: &[f64], _: &[f64], _: &mut Xoshiro256PlusPlus) -> Option<Vec<f64>> {
        None
    }

    fn with_data(&self, _: &[f64]) -> Option<Box<dyn Block>> {
        None
    }

    fn covariance(&self, _: &[f64], _: f64) -> Matrix {
        Matrix::of(2, |i, j| if i == j { Self::SPREAD.powi(2) } else { 0.0 })
    }
}
