//! What it is worth to know more: one value, or another measurement.

use riffel_numerics::least_squares::least_squares;
use riffel_numerics::matrix::Matrix;

use super::Worth;
use crate::error::CalibrationError;
use crate::information::{mean, of_a_measurement};
use crate::plan::Plan;
use crate::plan::decision::{Choices, Planned, PlannedData};

/// Mean, covariance and costs of draws, linear in the parameters.
pub(super) struct LinearDraws {
    place: Vec<f64>,
    covariance: Matrix,
    means: Vec<f64>,
    /// Of the cost of each action by each parameter.
    slopes: Vec<Vec<f64>>,
}

impl LinearDraws {
    pub(super) fn of(places: &[Vec<f64>], costs: &[Vec<f64>]) -> Self {
        let (place, covariance) = moments_of(places);
        let columns: Vec<Vec<f64>> =
            (0..place.len()).map(|index| places.iter().map(|place| place[index]).collect()).collect();
        let inverse = inverse(&covariance);
        let slopes = costs.iter().map(|costs| {
            let along: Vec<f64> = columns.iter().map(|column| product(column, costs)).collect();
            inverse.times(&along)
        });
        Self { slopes: slopes.collect(), means: costs.iter().map(|costs| mean(costs)).collect(), place, covariance }
    }
}

fn product(one: &[f64], other: &[f64]) -> f64 {
    let (a, b) = (mean(one), mean(other));
    let pairs = one.iter().zip(other);
    pairs.map(|(x, y)| (x - a) * (y - b)).sum::<f64>() / (one.len() - 1) as f64
}

/// Mean and covariance of draws.
pub(crate) fn moments_of(places: &[Vec<f64>]) -> (Vec<f64>, Matrix) {
    let size = places[0].len();
    let column = |index: usize| places.iter().map(|place| place[index]).collect::<Vec<f64>>();
    let columns: Vec<Vec<f64>> = (0..size).map(column).collect();
    let covariance = Matrix::of(size, |i, j| product(&columns[i], &columns[j]));
    (columns.iter().map(|column| mean(column)).collect(), covariance)
}

/// Inverse of a covariance; what does not vary at all stays at zero.
fn inverse(covariance: &Matrix) -> Matrix {
    let (values, vectors) = covariance.eigenvectors();
    let largest = values.iter().copied().fold(0.0, f64::max);
    let scaled = Matrix::of(covariance.size, |row, column| match values[row] > 1e-12 * largest {
        true => vectors.at(row, column) / values[row],
        false => 0.0,
    });
    vectors.transposed().product(&scaled)
}

/// What it is worth to know each parameter: costs regressed on a polynomial of third degree in it.
///
/// Source: Strong, Oakley & Brennan (2014), Medical Decision Making 34.
pub(super) fn worth_of_values(plan: &Plan, places: &[Vec<f64>], costs: &[Vec<f64>]) -> Vec<Worth> {
    let least = costs.iter().map(|costs| mean(costs)).fold(f64::INFINITY, f64::min);
    let parameters = plan.posterior.parameters().iter().enumerate();
    let mut worth: Vec<Worth> = parameters
        .map(|(index, parameter)| {
            let z: Vec<f64> = places.iter().map(|place| place[index]).collect();
            let middle = mean(&z);
            let size = (z.iter().map(|z| (z - middle).powi(2)).sum::<f64>() / z.len() as f64).sqrt();
            let columns =
                [0, 1, 2, 3].map(|power| z.iter().map(|z| ((z - middle) / size).powi(power)).collect::<Vec<f64>>());
            let fitted: Vec<Vec<f64>> = costs.iter().map(|costs| fit(&columns, costs)).collect();
            let of_draw = |draw: usize| fitted.iter().map(|costs| costs[draw]).fold(f64::INFINITY, f64::min);
            let best = mean(&(0..z.len()).map(of_draw).collect::<Vec<f64>>());
            Worth { title: parameter.name.clone(), per_year: (least - best).max(0.0), price: None, net: None }
        })
        .collect();
    worth.sort_by(|a, b| b.per_year.total_cmp(&a.per_year));
    worth
}

/// Least squares of a column by some others.
fn fit(columns: &[Vec<f64>], values: &[f64]) -> Vec<f64> {
    let weights = least_squares(&mut columns.to_vec(), values);
    let row = |row: usize| columns.iter().zip(&weights).map(|(column, weight)| weight * column[row]).sum();
    (0..values.len()).map(row).collect()
}

/// What measurements are worth, beside the worth of knowing each value: Σ′ = (Σ⁻¹ + JᵀR⁻¹J)⁻¹ at the mean of the posterior.
pub(super) fn worth_of_measurements(
    plan: &Plan,
    choices: &Choices,
    linear: &LinearDraws,
    values: &[Worth],
) -> Result<Vec<Worth>, CalibrationError> {
    let before = inverse(&linear.covariance);
    let mut worth = Vec::new();
    for measurement in &choices.measurements {
        let information = information(plan, measurement, &linear.place).map_err(CalibrationError::Refused)?;
        let size = before.size;
        let sum = Matrix::of(size, |i, j| before.at(i, j) + information.at(i, j));
        let after = inverse(&sum);
        let difference = Matrix::of(size, |i, j| linear.covariance.at(i, j) - after.at(i, j));
        let per_year = of_a_measurement(&linear.means, &linear.slopes, &difference);
        // To measure one value cannot be worth more than to know it, which is told without costs that are linear in it.
        let known = match measurement.of {
            PlannedData::Parameter(index, _) => {
                let name = &plan.posterior.parameters()[index].name;
                values.iter().find(|value| value.title == *name)
            }
            PlannedData::Block(_) => None,
        };
        let per_year = known.map_or(per_year, |known| per_year.min(known.per_year));
        worth.push(Worth {
            title: measurement.title.clone(),
            per_year,
            price: Some(measurement.price),
            net: Some(per_year * choices.present - measurement.price),
        });
    }
    let net = |worth: &Worth| worth.net.unwrap_or(0.0);
    worth.sort_by(|a, b| net(b).total_cmp(&net(a)));
    Ok(worth)
}

/// JᵀR⁻¹J that a measurement adds.
fn information(plan: &Plan, measurement: &Planned, place: &[f64]) -> Result<Matrix, String> {
    let posterior = &plan.posterior;
    match measurement.of {
        PlannedData::Block(block) => {
            let named = &posterior.blocks[block];
            let (block, sizes, touched_by) = named.parts();
            let now = posterior.information((block, sizes, touched_by), place, 1.0)?;
            let then = match block.once_more() {
                Some(more) => posterior.information((&*more, sizes, touched_by), place, 1.0)?,
                None => posterior.information((block, sizes, touched_by), place, 2.0)?,
            };
            Ok(Matrix::of(place.len(), |i, j| then.at(i, j) - now.at(i, j)))
        }
        PlannedData::Parameter(index, error) => {
            const STEP: f64 = 1e-4;
            let prior = &posterior.parameters()[index].prior;
            let z = place[index];
            let slope = (prior.value(z + STEP) - prior.value(z - STEP)) / (2.0 * STEP);
            let precision = (slope / (error * prior.value(z))).powi(2);
            let is_own = |i: usize, j: usize| i == index && j == index;
            Ok(Matrix::of(place.len(), |i, j| if is_own(i, j) { precision } else { 0.0 }))
        }
    }
}
