//! Measurements and their likelihoods.

mod decay_rate;
mod frequency_response;
mod joined_lines;
mod levels;
mod profiles;
pub(crate) mod table;
mod wear;

pub(crate) use decay_rate::DecayRates;
pub(crate) use frequency_response::FrequencyResponses;
pub(crate) use levels::{AxleBoxRun, DatedLevels, Levels, MeasuredRail, PassBys, Passage, SinceGround, Train};
pub(crate) use profiles::{Comparison, DatedProfiles, Travel};
pub(crate) use wear::Wear;

use rand_xoshiro::Xoshiro256PlusPlus;

use riffel::forecast::LEAST_PASSAGES;
use riffel_keys::{Message, say};
use riffel_numerics::matrix::Matrix;
use riffel_numerics::random_numbers::normal;
use serde::Serialize;

pub(crate) use crate::gaussian::Conditional;
use crate::gaussian::{Density, Gaussian, given_others};
use crate::model::Trial;

/// Passages of the unit of what the model misses of growth.
const UNIT: f64 = 1e6;

/// Data that share errors: they are likely or not together.
pub(crate) trait Block: Send + Sync {
    /// What the model says of each datum, in the order of the data.
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String>;

    /// Prediction by fewer evaluations of the model, good enough for the slopes by which a sampler steers; `None` if
    /// [`predict`](Self::predict) is as quick.
    fn predict_coarsely(&self, _trial: &Trial<'_>) -> Option<Result<Vec<f64>, String>> {
        None
    }

    /// The errors of the data, where they are normal whatever the model says.
    fn gaussian(&self) -> Option<&Gaussian> {
        None
    }

    /// ln of the density of the data for predictions and sizes of what the model misses; `None` if these are beyond numbers.
    fn density(&self, predicted: &[f64], sizes: &[f64]) -> Option<Density> {
        self.gaussian()?.density(&differences(&self.observed(), predicted), sizes)
    }

    /// Where the model looks at its case.
    fn views(&self) -> Vec<usize>;

    /// The data, in the order of the predictions.
    fn observed(&self) -> Vec<f64>;

    /// What each datum is and where it was measured, in the order of the predictions.
    fn places(&self) -> Vec<Place>;

    /// ln of the density of each datum given all others of the block; `None` if it is beyond numbers.
    fn of_each(&self, predicted: &[f64], sizes: &[f64]) -> Option<Vec<f64>> {
        self.gaussian()?.of_each(&differences(&self.observed(), predicted), sizes)
    }

    /// Data as they might have been measured: predictions with errors that are drawn.
    fn replicate(&self, predicted: &[f64], sizes: &[f64], random: &mut Xoshiro256PlusPlus) -> Option<Vec<f64>> {
        let errors = self.gaussian()?.draw(sizes, || normal(random))?;
        Some(sums(predicted, &errors))
    }

    /// Block with other data, in the order of the predictions; `None` if their errors are beyond numbers.
    fn with_data(&self, data: &[f64]) -> Option<Box<dyn Block>>;

    /// Covariance of the errors of the data, what the model misses among them, where each datum is the mean of so many
    /// measurements.
    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix;

    /// The data with what one measurement more adds; `None` if it repeats the same, so that their mean counts.
    fn once_more(&self) -> Option<Box<dyn Block>> {
        None
    }

    /// The parts of the data that can be left out to see how well the others predict them, each datum in one: never single
    /// lines of what is smooth.
    fn groups(&self) -> Vec<Group> {
        vec![Group::all(self.observed().len())]
    }

    /// What is left of the data without a group; none for nothing.
    fn without(&self, _held: Held) -> Option<Box<dyn Block>> {
        None
    }

    /// A group given the rest of the data; `None` if its density is beyond numbers.
    fn given_rest(&self, group: &Group, predicted: &[f64], sizes: &[f64]) -> Option<Conditional> {
        let residuals = differences(&self.observed(), predicted);
        let covariance = self.covariance(sizes, 1.0);
        let inverse = covariance.of_sums(&group.basis).cholesky()?.inverse_of_square();
        let residuals = group.basis.iter().map(|terms| sum_of(&residuals, terms));
        let weighted = inverse.times(&residuals.collect::<Vec<f64>>());
        given_others(&inverse, &weighted, &group.own)
    }

    /// These data, if they tell of a rail that grows.
    fn as_levels(&self) -> Option<&Levels> {
        None
    }
}

/// What a datum is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Observable {
    /// |H| of the rail \[m/N\], over frequency \[Hz\], at a position \[m\].
    ReceptanceMPerN,
    /// arg H \[rad\], over the same.
    ReceptancePhaseRad,
    /// Decay of vibration along the rail, over frequency \[Hz\].
    DecayRateDbPerM,
    /// Rise of a level since its band was first measured, over wavelength \[m\], after so many passages.
    LevelRiseDb,
    /// Level of a run of an axle box over the first level of its band, over wavelength \[m\].
    AxleBoxLevelDb,
    /// A-weighted level beside the track over the first levels of its bands by their shares in it, over passages.
    PassByLevelDb,
    /// ln of what a wave has grown by since the first date \[Np\], over wavelength \[m\], after so many passages.
    WaveGrowthNp,
    /// How far a wave has moved along the direction of travel \[rad\], over the same.
    WaveDriftRad,
    /// Depth worn off the head per 100 million gross tonnes, over the gross tonnes under which it was \[million\].
    #[serde(rename = "wear_m_per_100_mgt")]
    WearMPer100Mgt,
}

impl Observable {
    /// A datum as it was measured, of the form in which it is compared.
    pub(crate) fn told(self, compared: f64) -> f64 {
        match self {
            Self::ReceptanceMPerN | Self::DecayRateDbPerM | Self::WearMPer100Mgt => compared.exp(),
            _ => compared,
        }
    }
}

/// Where a datum was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Place {
    pub(crate) measured: Observable,
    /// Frequency, wavelength or million gross tonnes.
    pub(crate) at: f64,
    /// Position or passages, where there are any.
    pub(crate) of: Option<f64>,
}

/// What is left out of some data.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Held {
    /// All of them.
    All,
    /// A date, by the passages since the first, with the runs of it.
    Date(f64),
    /// A place of the hammer \[m\].
    Place(f64),
}

/// Data that are left out together.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Group {
    pub(crate) held: Held,
    /// Sums of the data of the block by weights, as many as data: such that those of the rest lack the group.
    basis: Vec<Vec<(usize, f64)>>,
    /// Which of the sums are of the group.
    own: Vec<usize>,
}

impl Group {
    /// All of so many data.
    pub(crate) fn all(count: usize) -> Self {
        Self { held: Held::All, basis: (0..count).map(|datum| vec![(datum, 1.0)]).collect(), own: (0..count).collect() }
    }

    /// Some of so many data, for tests.
    #[cfg(test)]
    pub(crate) fn single(count: usize, own: &[usize]) -> Self {
        Self { own: own.to_vec(), ..Self::all(count) }
    }
}

/// The rule that passages from the first date to the last break; none if they do not.
fn too_few(passages: f64) -> Option<Message> {
    (passages < LEAST_PASSAGES).then(|| say!(too_few_passages, passages, least = LEAST_PASSAGES))
}

pub(crate) fn differences(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one - other).collect()
}

/// The sum of some values by their weights.
pub(crate) fn sum_of(values: &[f64], weights: &[(usize, f64)]) -> f64 {
    let weighted = weights.iter().map(|(place, weight)| weight * values[*place]);
    weighted.sum()
}

pub(crate) fn sums(one: &[f64], other: &[f64]) -> Vec<f64> {
    one.iter().zip(other).map(|(one, other)| one + other).collect()
}

/// How much a model misses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Size {
    Known(f64),
    /// That of a parameter.
    Unknown(usize),
}
