//! Weights that turn draws of one distribution into draws of another, with their largest ones smoothed.
//!
//! Source: Vehtari, Simpson, Gelman, Yao & Gabry (2024), *Pareto smoothed importance sampling*, J. Mach. Learn. Res. 25; the
//! tail is fitted as by Zhang & Stephens (2009), Technometrics 51.

/// Largest shape k̂ of the tail for which the weights are to be trusted.
pub const MOST_SHAPE: f64 = 0.7;
/// Fewest weights that make a tail.
const LEAST_TAIL: usize = 5;

/// Smoothed weights.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Weights {
    /// One for each draw; their sum is one.
    pub(crate) of_draws: Vec<f64>,
    /// k̂ of the generalised Pareto distribution of the largest; infinite where there are too few.
    pub(crate) shape: f64,
}

impl Weights {
    /// From ln of the ratios of the two densities, each up to the same constant.
    pub(crate) fn smoothed(log_ratios: &[f64]) -> Self {
        let count = log_ratios.len();
        let highest = log_ratios.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut ratios: Vec<f64> = log_ratios.iter().map(|it| (it - highest).exp()).collect();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|one, other| ratios[*one].total_cmp(&ratios[*other]));
        let length = (0.2 * count as f64).min(3.0 * (count as f64).sqrt()).ceil() as usize;
        let mut shape = f64::INFINITY;
        if length >= LEAST_TAIL {
            let (body, tail) = order.split_at(count - length);
            let least = ratios[body[body.len() - 1]];
            let above: Vec<f64> = tail.iter().map(|draw| ratios[*draw] - least).collect();
            if above[0] < above[length - 1] {
                let scale;
                (shape, scale) = pareto(&above);
                for (place, draw) in tail.iter().enumerate() {
                    let share = (place as f64 + 0.5) / length as f64;
                    let quantile = scale * (-shape * (-share).ln_1p()).exp_m1() / shape;
                    ratios[*draw] = (least + quantile).min(1.0);
                }
            } else {
                // All the same: nothing is to be smoothed.
                shape = 0.0;
            }
        }
        let sum: f64 = ratios.iter().sum();
        ratios.iter_mut().for_each(|ratio| *ratio /= sum);
        Self {
            of_draws: ratios,
            shape,
        }
    }
}

/// Shape and scale of the generalised Pareto distribution of some values above zero, in order; the shape is drawn towards one
/// half as by ten values more.
fn pareto(values: &[f64]) -> (f64, f64) {
    const TOWARDS: f64 = 10.0;
    let count = values.len() as f64;
    let quarter = values[(count / 4.0 + 0.5) as usize - 1].max(f64::MIN_POSITIVE);
    let last = values[values.len() - 1];
    let trials = 30 + count.sqrt() as usize;
    let shape = |b: f64| values.iter().map(|x| (-b * x).ln_1p()).sum::<f64>() / count;
    let trial = |trial: usize| {
        let share = trials as f64 / (trial as f64 + 0.5);
        let b = last.recip() + (1.0 - share.sqrt()) / (3.0 * quarter);
        let shape = shape(b);
        (b, count * ((-b / shape).ln() - shape - 1.0))
    };
    let trials: Vec<(f64, f64)> = (0..trials)
        .map(trial)
        .filter(|(_, log)| log.is_finite())
        .collect();
    let highest = trials
        .iter()
        .map(|it| it.1)
        .fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = trials.iter().map(|it| (it.1 - highest).exp()).sum();
    let b: f64 = trials
        .iter()
        .map(|(b, log)| b * (log - highest).exp() / sum)
        .sum();
    let own = shape(b);
    ((count * own + 0.5 * TOWARDS) / (count + TOWARDS), -own / b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::random;
    use crate::nuts::uniform;

    /// Ratios u^−k have a tail of shape k and the mean 1/(1 − k): the mean of a quantity that is one for u below a tenth
    /// and zero else is 0.1^{1−k}.
    #[test]
    fn the_shape_of_a_tail_is_found() {
        for (shape, error) in [(0.2, 0.02), (0.5, 0.03), (0.9, f64::INFINITY)] {
            let mut random = random(5, 0, 0);
            let draws: Vec<f64> = (0..20_000).map(|_| uniform(&mut random)).collect();
            let logs: Vec<f64> = draws.iter().map(|u| -shape * u.ln()).collect();
            let weights = Weights::smoothed(&logs);
            assert!((weights.shape - shape).abs() < 0.12, "{}", weights.shape);
            assert_eq!(weights.shape > MOST_SHAPE, shape > MOST_SHAPE);
            let sum: f64 = weights.of_draws.iter().sum();
            assert!((sum - 1.0).abs() < 1e-12);
            let pairs = draws.iter().zip(&weights.of_draws);
            let below: f64 = pairs.filter(|(u, _)| **u < 0.1).map(|(_, w)| w).sum();
            assert!((below - 0.1f64.powf(1.0 - shape)).abs() < error, "{below}");
        }
    }

    /// Of equal ratios all weights are equal, and a few ratios have no tail.
    #[test]
    fn equal_ratios_have_equal_weights() {
        let weights = Weights::smoothed(&[3.0; 100]);
        assert_eq!(weights.shape, 0.0);
        assert!(weights.of_draws.iter().all(|it| (it - 0.01).abs() < 1e-15));
        assert_eq!(Weights::smoothed(&[0.0, 1.0, 2.0]).shape, f64::INFINITY);
    }
}
