//! Measurements and their likelihoods.

mod decay_rate;
mod frequency_response;
mod levels;
pub(crate) mod table;

pub(crate) use decay_rate::DecayRates;
pub(crate) use frequency_response::FrequencyResponses;
pub(crate) use levels::{AxleBoxRun, DatedLevels, Levels};

use rand_xoshiro::Xoshiro256PlusPlus;

use crate::gaussian::Density;
use crate::matrix::Matrix;
use crate::model::Trial;

/// Data that share errors: they are likely or not together.
pub(crate) trait Block: Send + Sync {
    /// What the model says of each datum, in the order of the data.
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String>;

    /// The same by fewer evaluations of the model, where that is good enough for the slopes by which a sampler steers; none where
    /// [`predict`](Self::predict) is as quick.
    fn predict_coarsely(&self, _trial: &Trial<'_>) -> Option<Result<Vec<f64>, String>> {
        None
    }

    /// ln of the density of the data for predictions and sizes of what the model misses; none where these are beyond numbers.
    fn density(&self, predicted: &[f64], sizes: &[f64]) -> Option<Density>;

    /// Where the model looks at its case.
    fn views(&self) -> Vec<usize>;

    /// The data, in the order of the predictions.
    fn observed(&self) -> Vec<f64>;

    /// ln of the density of each datum given all others of the block; none where it is beyond numbers.
    fn of_each(&self, predicted: &[f64], sizes: &[f64]) -> Option<Vec<f64>>;

    /// Data as they might have been measured: predictions with errors that are drawn.
    fn replicate(
        &self,
        predicted: &[f64],
        sizes: &[f64],
        random: &mut Xoshiro256PlusPlus,
    ) -> Option<Vec<f64>>;

    /// Covariance of the errors of the data, what the model misses among them, where each datum is the mean of so many
    /// measurements.
    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix;

    /// The data with what one measurement more adds; none where it repeats the same, so that their mean counts.
    fn once_more(&self) -> Option<Box<dyn Block>> {
        None
    }

    /// These data, if they tell of a rail that grows.
    fn as_levels(&self) -> Option<&Levels> {
        None
    }
}

fn differences(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter()
        .zip(other)
        .map(|(one, other)| one - other)
        .collect()
}

fn sums(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter()
        .zip(other)
        .map(|(one, other)| one + other)
        .collect()
}

/// How much a model misses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Size {
    Known(f64),
    /// That of a parameter.
    Unknown(usize),
}
