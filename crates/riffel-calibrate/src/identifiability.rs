//! What the data tell of the parameters together, and what they leave to the priors.

use riffel_numerics::matrix::Matrix;

use crate::chains::Chains;
use crate::decision::moments_of;
use crate::information::mean;
use crate::model::Role;
use crate::plan::Plan;

/// Least part of a value that is named, over the largest.
const NAMED: f64 = 0.3;
/// Correlation from which two values are said to be told only together.
const TOGETHER: f64 = 0.9;

/// What data tell of values together, sizes of what the model misses aside.
#[derive(Debug, Clone, PartialEq)]
pub struct Identifiability {
    /// Names of the values.
    pub names: Vec<String>,
    /// Directions that are independent in the prior, what the data tell best first.
    pub directions: Vec<Direction>,
    /// Correlations after the data of all pairs, sizes among them, on the whole lines of their priors.
    pub correlations: Vec<Correlation>,
}

/// A direction of the values.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// Variance before over that of the data: above one it is told by data, below by the prior.
    pub information: f64,
    /// Part of each value, in standard deviations of its prior.
    pub parts: Vec<f64>,
    /// Powers of the values whose product it is, that of the largest part first and one; empty if a value may be zero or below.
    pub powers: Vec<(String, f64)>,
    /// Standard deviation of ln of that product after the data.
    pub spread: f64,
}

/// How two values move together.
#[derive(Debug, Clone, PartialEq)]
pub struct Correlation {
    /// Their names.
    pub names: [String; 2],
    /// −1 to 1.
    pub correlation: f64,
}

impl Correlation {
    /// Whether the data tell the two values only together.
    pub fn is_close(&self) -> bool {
        self.correlation.abs() > TOGETHER
    }
}

impl Direction {
    /// Whether data tell it, and not the prior.
    pub fn is_told(&self) -> bool {
        self.information > 1.0
    }

    /// The product: `wear.coefficient × vehicle.traction_share^0.5 / wheel.mass`.
    pub fn words(&self) -> String {
        let mut words = String::new();
        for (place, (name, power)) in self.powers.iter().enumerate() {
            let sign = match (place, *power > 0.0) {
                (0, _) => "",
                (_, true) => " × ",
                (_, false) => " / ",
            };
            words += &format!("{sign}{name}");
            let size = power.abs();
            match size < 0.1 {
                true => words += &format!("^{size:.2}"),
                false if (size - 1.0).abs() >= 0.05 => words += &format!("^{size:.1}"),
                false => {}
            }
        }
        words
    }
}

impl Identifiability {
    /// Eigenvectors of J̃ᵀR⁻¹J̃ at the mean of the draws, J̃ the slopes of the predictions by each value in standard deviations of its
    /// prior.
    ///
    /// # Errors
    /// Why the case refuses the mean.
    pub fn of(plan: &Plan, chains: &Chains) -> Result<Self, String> {
        let places: Vec<Vec<f64>> = chains.draws.iter().flatten().map(|draw| draw.place.clone()).collect();
        let (middle, covariance) = moments_of(&places);
        let parameters = plan.posterior.parameters();
        let correlations = (0..middle.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
        let correlation = |(i, j): (usize, usize)| Correlation {
            names: [i, j].map(|place| parameters[place].name.clone()),
            correlation: covariance.at(i, j) / (covariance.at(i, i) * covariance.at(j, j)).sqrt(),
        };
        let values: Vec<Vec<f64>> = places.iter().map(|place| plan.posterior.values(place)).collect();
        let own: Vec<usize> = (0..parameters.len()).filter(|it| parameters[*it].role != Role::Size).collect();
        let directions = directions(plan, &middle, &own)?;
        Ok(Self {
            names: own.iter().map(|place| parameters[*place].name.clone()).collect(),
            directions: directions
                .into_iter()
                .map(|(information, parts)| direction(plan, &middle, &values, &own, information, parts))
                .collect(),
            correlations: correlations.map(correlation).collect(),
        })
    }
}

/// Eigenvalues, the largest first, with their eigenvectors.
fn directions(plan: &Plan, middle: &[f64], own: &[usize]) -> Result<Vec<(f64, Vec<f64>)>, String> {
    let posterior = &plan.posterior;
    let mut sum = Matrix::of(middle.len(), |_, _| 0.0);
    for named in &posterior.blocks {
        let information = posterior.information(named.parts(), middle, 1.0)?;
        let pairs = sum.values.iter_mut().zip(information.values);
        pairs.for_each(|(sum, value)| *sum += value);
    }
    let parameters = posterior.parameters();
    let deviation: Vec<f64> = own.iter().map(|it| parameters[*it].prior.variance().sqrt()).collect();
    let scaled = Matrix::of(own.len(), |i, j| sum.at(own[i], own[j]) * deviation[i] * deviation[j]);
    let (values, vectors) = scaled.eigenvectors();
    let mut directions: Vec<(f64, Vec<f64>)> =
        values.into_iter().enumerate().map(|(row, value)| (value.max(0.0), vectors.row(row).to_vec())).collect();
    directions.sort_by(|a, b| b.0.total_cmp(&a.0));
    Ok(directions)
}

/// A direction as a product of powers.
fn direction(
    plan: &Plan,
    middle: &[f64],
    values: &[Vec<f64>],
    own: &[usize],
    information: f64,
    parts: Vec<f64>,
) -> Direction {
    const STEP: f64 = 1e-4;
    let parameters = plan.posterior.parameters();
    let largest = parts.iter().map(|part| part.abs()).fold(0.0, f64::max);
    let mut named: Vec<(usize, f64)> = own.iter().copied().zip(parts.iter().copied()).collect();
    named.retain(|(_, part)| part.abs() >= NAMED * largest);
    named.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    // d ln x/dz turns parts of z into powers of x.
    let mut powers: Vec<(usize, f64)> = named
        .into_iter()
        .map(|(place, part)| {
            let prior = &parameters[place].prior;
            let ln = |by: f64| prior.value(middle[place] + by).ln();
            let slope = (ln(STEP) - ln(-STEP)) / (2.0 * STEP);
            (place, part / prior.variance().sqrt() / slope)
        })
        .collect();
    let is_positive = |place: usize| values.iter().all(|values| values[place] > 0.0);
    if !powers.iter().all(|(place, power)| power.is_finite() && is_positive(*place)) {
        powers.clear();
    }
    let first = powers.first().map_or(1.0, |first| first.1);
    powers.iter_mut().for_each(|(_, power)| *power /= first);
    let logs: Vec<f64> =
        values.iter().map(|values| powers.iter().map(|(place, power)| power * values[*place].ln()).sum()).collect();
    let middle = mean(&logs);
    let squares: Vec<f64> = logs.iter().map(|ln| (ln - middle).powi(2)).collect();
    Direction {
        information,
        parts,
        spread: mean(&squares).sqrt(),
        powers: powers.into_iter().map(|(place, power)| (parameters[place].name.clone(), power)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Growth holds the wear coefficient and the share of traction as a product: one direction of set b is told by nothing, of these
    /// two alone, and along it the product stays.
    #[test]
    fn growth_leaves_the_share_of_traction_to_the_prior() {
        let plan = crate::fixtures::folder("b-three-dates").join("plan.toml");
        let plan = Plan::read(&plan).unwrap();
        let parameters = plan.posterior.parameters();
        let values: Vec<f64> = parameters.iter().map(|it| it.prior.quantile(0.5)).collect();
        let middle = plan.posterior.place(&values);
        let own: Vec<usize> = (0..7).collect();
        let found = directions(&plan, &middle, &own).unwrap();
        assert!(found[0].0 > 1.0, "{found:?}");
        let (least, parts) = found.last().unwrap();
        assert!(*least < 1e-9 * found[0].0, "{least}");
        assert!(parts[2..].iter().all(|part| part.abs() < 1e-5), "{parts:?}");
        let around: Vec<Vec<f64>> = vec![values.clone(), values];
        let direction = direction(&plan, &middle, &around, &own, *least, parts.clone());
        assert!(!direction.is_told());
        // ln of the product by a step along the parts: part · deviation · d ln x/dz each.
        let by = |place: usize, slope: f64| parts[place] * parameters[place].prior.variance().sqrt() * slope;
        // The share is 0.5 in 0.05 to 0.95: d ln x/dz = 0.9 · 0.25/0.5.
        let sum = by(0, 1.0) + by(1, 0.45);
        assert!(sum.abs() < 1e-4, "{sum}");
        assert_eq!(direction.words(), "wear.coefficient / vehicle.traction_share^0.7");
    }

    #[test]
    fn a_direction_is_said_as_a_product() {
        let direction = Direction {
            information: 2.0,
            parts: Vec::new(),
            powers: vec![
                ("a".to_owned(), 1.0),
                ("b".to_owned(), -1.02),
                ("c".to_owned(), 0.5),
                ("d".to_owned(), -0.04),
            ],
            spread: 0.1,
        };
        assert_eq!(direction.words(), "a / b × c^0.5 / d^0.04");
        assert!(direction.is_told());
    }
}
