//! The most likely place near another.

use riffel_numerics::matrix::{Matrix, dot};

use crate::nuts::{Place, Potential};

/// Most steps of a search.
const MOST_STEPS: usize = 200;
/// Gain of ln density below which a search ends.
const GAIN: f64 = 1e-6;

/// Climb from a place; `scale` are standard deviations to begin with.
///
/// Method: Broyden, Fletcher, Goldfarb and Shanno with a line search that halves its step until Armijo's condition holds
/// (Nocedal & Wright 2006, algorithm 6.1).
pub(crate) fn climb(potential: &Potential<'_>, from: Place, scale: &[f64]) -> Place {
    let size = scale.len();
    let first = Matrix::of(size, |i, j| if i == j { scale[i].powi(2) } else { 0.0 });
    let mut inverse = first.clone();
    let mut place = from;
    let mut fresh = true;
    for _ in 0..MOST_STEPS {
        let mut way = inverse.times(&place.gradient);
        // No step of the first goes farther than the prior reaches.
        let far = way.iter().zip(scale).map(|(way, scale)| (way / scale).abs()).fold(0.0, f64::max);
        if far > 1.0 {
            way.iter_mut().for_each(|way| *way /= far);
        }
        let slope = dot(&way, &place.gradient);
        let Some(next) = line(potential, &place, &way, slope) else {
            if fresh {
                return place;
            }
            (inverse, fresh) = (first.clone(), true);
            continue;
        };
        let gain = next.log_density - place.log_density;
        let moved: Vec<f64> = next.at.iter().zip(&place.at).map(|(new, old)| new - old).collect();
        let turned: Vec<f64> = place.gradient.iter().zip(&next.gradient).map(|(old, new)| old - new).collect();
        let curvature = dot(&moved, &turned);
        if curvature > 1e-12 * dot(&moved, &moved) {
            let (image, rho) = (inverse.times(&turned), curvature.recip());
            let twice = (1.0 + dot(&turned, &image) * rho) * rho;
            let before = inverse;
            inverse = Matrix::of(size, |i, j| {
                before.at(i, j) - rho * (image[i] * moved[j] + moved[i] * image[j]) + twice * moved[i] * moved[j]
            });
        }
        (place, fresh) = (next, false);
        if gain < GAIN {
            break;
        }
    }
    place
}

/// The first of ever shorter steps that gains enough.
fn line(potential: &Potential<'_>, place: &Place, way: &[f64], slope: f64) -> Option<Place> {
    let mut share = 1.0;
    for _ in 0..30 {
        let at: Vec<f64> = place.at.iter().zip(way).map(|(at, way)| at + share * way).collect();
        if let Some((log_density, gradient)) = potential(&at)
            && log_density >= place.log_density + 1e-4 * share * slope
        {
            return Some(Place { at, log_density, gradient });
        }
        share *= 0.5;
    }
    None
}

/// Covariance of the normal distribution that touches the density at its top, from differences of the gradient; directions in
/// which it is hardly curved have the width of the prior.
pub(crate) fn covariance(potential: &Potential<'_>, top: &Place, scale: &[f64]) -> Matrix {
    const STEP: f64 = 1e-3;
    let size = scale.len();
    let column = |index: usize| -> Option<Vec<f64>> {
        let there = |sign: f64| {
            let mut at = top.at.clone();
            at[index] += sign * STEP * scale[index];
            potential(&at).map(|(_, gradient)| gradient)
        };
        let (up, down) = (there(1.0)?, there(-1.0)?);
        let differences = up.iter().zip(&down);
        Some(differences.map(|(up, down)| (down - up) / (2.0 * STEP * scale[index])).collect())
    };
    let columns: Option<Vec<Vec<f64>>> = (0..size).map(column).collect();
    // In units of the prior the curvature of the prior is about one.
    let curvature = Matrix::of(size, |i, j| match &columns {
        Some(columns) => 0.5 * (columns[i][j] + columns[j][i]) * scale[i] * scale[j],
        None => f64::from(u8::from(i == j)),
    });
    let (values, vectors) = curvature.eigenvectors();
    Matrix::of(size, |i, j| {
        let terms = (0..size).map(|k| vectors.at(k, i) * vectors.at(k, j) / values[k].max(0.5));
        scale[i] * scale[j] * terms.sum::<f64>()
    })
}
