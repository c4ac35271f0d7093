//! How likely values are after all that was measured.

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel_numerics::matrix::{Matrix, dot};
use riffel_numerics::random_numbers::uniform;

use crate::data::{Block, Size};
use crate::draw::Draw;
use crate::gaussian::Density;
use crate::model::{Model, Trial};
use crate::nuts::Statistics;

/// Step in z of differences of the predictions. Forward differences: rounding of 1e-13 and curvature leave derivatives with
/// some six digits, and decay rates are taken from a quarter of their frequencies. A sampler's steps may use any force that follows from the place alone, for they stay volume-preserving
/// and reversible; which states are kept follows from the density itself.
const STEP: f64 = 1e-6;

/// Most draws of the priors until the case takes one.
pub(crate) const MOST_TRIALS: u64 = 200;

/// Data with the sizes of what the model misses of them.
pub(crate) struct Named {
    /// Of the data in the block.
    pub(crate) names: Vec<String>,
    pub(crate) block: Box<dyn Block>,
    pub(crate) sizes: Vec<Size>,
    /// Parameters that its predictions depend on.
    pub(crate) touched_by: Vec<usize>,
}

/// The posterior of the parameters of a model, in z.
pub struct Posterior {
    pub(crate) model: Model,
    pub(crate) blocks: Vec<Named>,
}

/// A place in z with ln of the density of the prior and of the likelihood.
#[derive(Debug, Clone)]
pub(crate) struct Placed {
    pub(crate) at: Vec<f64>,
    pub(crate) log_prior: f64,
    pub(crate) log_likelihood: f64,
}

/// ln of the density at a place, and its gradient.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// ln likelihood, normalised, and ln of the density of the prior in z.
    pub log_density: f64,
    /// Of the whole, by z.
    pub gradient: Vec<f64>,
}

impl Posterior {
    /// What is uncertain.
    pub fn parameters(&self) -> &[crate::Parameter] {
        &self.model.parameters
    }

    /// Values in SI of a place in z.
    pub fn values(&self, place: &[f64]) -> Vec<f64> {
        let parameters = self.model.parameters.iter().zip(place);
        parameters.map(|(parameter, z)| parameter.prior.value(*z)).collect()
    }

    /// One z of a place as a [smooth coordinate](crate::Prior), with its derivative.
    pub(crate) fn smooth(&self, place: &[f64], index: usize) -> (f64, f64) {
        self.model.parameters[index].prior.smooth(place[index])
    }

    /// Place in z of values in SI.
    pub fn place(&self, values: &[f64]) -> Vec<f64> {
        let parameters = self.model.parameters.iter().zip(values);
        parameters.map(|(parameter, x)| parameter.prior.place(*x)).collect()
    }

    /// ln likelihood of each block of data for values in SI, with the names of its data.
    ///
    /// # Errors
    /// Why the case refuses the values.
    pub fn log_likelihood(&self, values: &[f64]) -> Result<Vec<(String, f64)>, String> {
        let trial = self.model.trial(values);
        let blocks = self.blocks.iter();
        blocks
            .map(|named| {
                let predicted = named.block.predict(&trial)?;
                let density = named.density(&predicted, values);
                let value = density.map_or(f64::NEG_INFINITY, |density| density.value);
                Ok((named.names.join(" + "), value))
            })
            .collect()
    }

    /// ln likelihood of all data for values in SI; `None` if the case refuses them.
    pub(crate) fn log_likelihood_of_all(&self, values: &[f64]) -> Option<f64> {
        let blocks = self.log_likelihood(values).ok()?;
        Some(blocks.iter().map(|(_, value)| value).sum())
    }

    /// Values in SI that are drawn from the priors.
    pub(crate) fn drawn_from_priors(&self, random: &mut Xoshiro256PlusPlus) -> Vec<f64> {
        let parameters = self.model.parameters.iter();
        parameters.map(|parameter| parameter.prior.quantile(uniform(random))).collect()
    }

    /// What the model says of each datum for values in SI, block by block: ln |H| and arg H; ln of decay rates; levels over the
    /// first of each band \[dB\].
    ///
    /// # Errors
    /// Why the case refuses the values.
    pub fn predictions(&self, values: &[f64]) -> Result<Vec<Vec<f64>>, String> {
        self.predictions_of(&self.model.trial(values))
    }

    fn predictions_of(&self, trial: &Trial<'_>) -> Result<Vec<Vec<f64>>, String> {
        let blocks = self.blocks.iter();
        blocks.map(|named| named.block.predict(trial)).collect()
    }

    /// Names of the data that depend on a parameter.
    pub fn data_of(&self, name: &str) -> Vec<String> {
        let place = self.model.parameters.iter().position(|parameter| parameter.name == name);
        let Some(place) = place else {
            return Vec::new();
        };
        let touched = self
            .blocks
            .iter()
            .filter(|named| named.touched_by.contains(&place) || named.sizes.contains(&Size::Unknown(place)));
        touched.map(|named| named.names.join(" + ")).collect()
    }

    /// The data of [`predictions`](Self::predictions).
    pub fn observed(&self) -> Vec<Vec<f64>> {
        self.blocks.iter().map(|named| named.block.observed()).collect()
    }

    /// ln of the density of the prior in z, and its derivatives.
    fn prior(&self, place: &[f64]) -> (f64, Vec<f64>) {
        let parameters = self.model.parameters.iter().zip(place);
        let (values, slopes): (Vec<f64>, Vec<f64>) =
            parameters.map(|(parameter, z)| parameter.prior.log_density(*z)).unzip();
        (values.iter().sum(), slopes)
    }

    /// ln of the density at a place in z, up to a constant; none outside the priors and where the case refuses its values.
    pub fn log_density(&self, place: &[f64]) -> Option<f64> {
        Some(self.log_parts(place)?.iter().sum())
    }

    /// ln of the density of the prior and of the likelihood, whose sum that is.
    fn log_parts(&self, place: &[f64]) -> Option<[f64; 2]> {
        let prior = self.prior(place).0;
        let values = self.values(place);
        let likelihood = || self.log_likelihood_of_all(&values);
        let likelihood = prior.is_finite().then(likelihood)??;
        likelihood.is_finite().then_some([prior, likelihood])
    }

    /// A place in z with what [`log_density`](Self::log_density) is the sum of.
    pub(crate) fn placed(&self, at: Vec<f64>) -> Option<Placed> {
        let [log_prior, log_likelihood] = self.log_parts(&at)?;
        Some(Placed { at, log_prior, log_likelihood })
    }

    /// A draw of the priors that the case takes.
    pub(crate) fn begin(&self, random: &mut Xoshiro256PlusPlus) -> Option<Placed> {
        let mut draws = (0..MOST_TRIALS).map(|_| self.drawn_from_priors(random));
        draws.find_map(|values| self.placed(self.place(&values)))
    }

    /// What the model says of each datum at a place in z, block by block; none outside the priors and where the case refuses its
    /// values.
    pub(crate) fn predictions_at(&self, place: &[f64]) -> Option<Vec<Vec<f64>>> {
        let is_within = self.prior(place).0.is_finite();
        is_within.then(|| self.predictions(&self.values(place)).ok())?
    }

    /// ln of the density for predictions of all blocks, with its gradient but for what the predictions change by, and the
    /// densities of the blocks; none outside the priors.
    pub(crate) fn with_predictions(&self, place: &[f64], predicted: &[Vec<f64>]) -> Option<(Point, Vec<Density>)> {
        let (mut log_density, mut gradient) = self.prior(place);
        if !log_density.is_finite() {
            return None;
        }
        let values = self.values(place);
        let mut densities = Vec::new();
        for (named, predicted) in self.blocks.iter().zip(predicted) {
            let density = named.density(predicted, &values)?;
            log_density += density.value;
            for (size, slope) in named.sizes.iter().zip(&density.by_size) {
                if let Size::Unknown(index) = size {
                    gradient[*index] += slope * values[*index];
                }
            }
            densities.push(density);
        }
        let point = Point { log_density, gradient };
        Some((point, densities))
    }

    /// Value of [`log_density`](Self::log_density) with its gradient.
    pub fn at(&self, place: &[f64]) -> Option<Point> {
        if !self.prior(place).0.is_finite() {
            return None;
        }
        let values = self.values(place);
        let trial = self.model.trial(&values);
        let predicted = self.predictions_of(&trial).ok()?;
        let (mut point, densities) = self.with_predictions(place, &predicted)?;
        let known = self.blocks.iter().zip(predicted).zip(densities);
        let known = known.map(|((named, predicted), density)| {
            let coarse = named.block.predict_coarsely(&trial).transpose().ok()?;
            Some((coarse.unwrap_or(predicted), density))
        });
        let known: Vec<(Vec<f64>, Density)> = known.collect::<Option<_>>()?;
        for (index, gradient) in point.gradient.iter_mut().enumerate() {
            let touched: Vec<usize> =
                (0..self.blocks.len()).filter(|block| self.blocks[*block].touched_by.contains(&index)).collect();
            if touched.is_empty() {
                continue;
            }
            let slope = |step| self.slope((place, &trial), (index, step), &touched, &known);
            *gradient += slope(STEP).or_else(|| slope(-STEP))?;
        }
        point.is_finite().then_some(point)
    }

    /// Derivative of the ln likelihood of some blocks by one z; `None` if a step leads out of the model.
    fn slope(
        &self,
        (place, here): (&[f64], &Trial<'_>),
        (index, step): (usize, f64),
        touched: &[usize],
        known: &[(Vec<f64>, Density)],
    ) -> Option<f64> {
        let mut moved = place.to_vec();
        moved[index] += step;
        let values = self.values(&moved);
        let trial = here.moved(&values);
        let mut slope = 0.0;
        for &block in touched {
            let (predicted, density) = &known[block];
            let block = &self.blocks[block].block;
            let there = block.predict_coarsely(&trial);
            let there = there.unwrap_or_else(|| block.predict(&trial)).ok()?;
            let differences = there.iter().zip(predicted).map(|(there, here)| there - here);
            let terms = differences.zip(&density.by_prediction);
            slope += terms.map(|(difference, by)| by * difference).sum::<f64>() / step;
        }
        Some(slope)
    }
}

impl Posterior {
    /// JᵀR⁻¹J of some data at a place in z, by central differences: what they tell of the parameters.
    pub(crate) fn information(
        &self,
        (block, sizes, touched_by): (&dyn Block, &[Size], &[usize]),
        place: &[f64],
        times: f64,
    ) -> Result<Matrix, String> {
        const STEP: f64 = 1e-4;
        let values = self.values(place);
        let sizes: Vec<f64> = sizes.iter().map(|size| size.of(&values)).collect();
        let lower = block.covariance(&sizes, times).cholesky();
        let lower = lower.ok_or("the errors of the data are zero within rounding")?;
        let mut columns = vec![Vec::new(); place.len()];
        for &index in touched_by {
            let moved = |sign: f64| {
                let mut place = place.to_vec();
                place[index] += sign * STEP;
                block.predict(&self.model.trial(&self.values(&place)))
            };
            let (behind, ahead) = (moved(-1.0)?, moved(1.0)?);
            let slopes = behind.iter().zip(&ahead);
            let slopes = slopes.map(|(behind, ahead)| (ahead - behind) / (2.0 * STEP));
            columns[index] = lower.forward(slopes.collect());
        }
        Ok(Matrix::of(place.len(), |i, j| dot(&columns[i], &columns[j])))
    }
}

impl Placed {
    pub(crate) fn log_density(&self) -> f64 {
        self.log_prior + self.log_likelihood
    }

    pub(crate) fn draw(&self, statistics: Statistics) -> Draw {
        Draw { place: self.at.clone(), log_density: self.log_density(), statistics, step: 0.0 }
    }

    pub(crate) fn numbers(&self) -> Vec<f64> {
        let densities = [self.log_prior, self.log_likelihood];
        self.at.iter().copied().chain(densities).collect()
    }

    /// States of [`numbers`](Self::numbers) one after the other, in a space of some dimensions.
    pub(crate) fn all(numbers: &[f64], size: usize) -> Option<Vec<Self>> {
        let placed = numbers.chunks_exact(size + 2);
        let of = |numbers: &[f64]| Self {
            at: numbers[..size].to_vec(),
            log_prior: numbers[size],
            log_likelihood: numbers[size + 1],
        };
        placed.remainder().is_empty().then(|| placed.map(of).collect())
    }
}

impl Point {
    pub(crate) fn is_finite(&self) -> bool {
        self.log_density.is_finite() && self.gradient.iter().all(|slope| slope.is_finite())
    }
}

impl Named {
    /// What [`Posterior::information`] asks of data.
    pub(crate) fn parts(&self) -> (&dyn Block, &[Size], &[usize]) {
        (&*self.block, &self.sizes, &self.touched_by)
    }

    pub(crate) fn sizes(&self, values: &[f64]) -> Vec<f64> {
        self.sizes.iter().map(|size| size.of(values)).collect()
    }

    fn density(&self, predicted: &[f64], values: &[f64]) -> Option<Density> {
        self.block.density(predicted, &self.sizes(values))
    }
}

impl Size {
    fn of(self, values: &[f64]) -> f64 {
        match self {
            Self::Known(size) => size,
            Self::Unknown(index) => values[index],
        }
    }
}
