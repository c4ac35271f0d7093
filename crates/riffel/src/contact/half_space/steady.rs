//! Steady rolling: tractions, stick and slip.

use num_complex::Complex64;

use super::gmres::gmres;
use super::influence::Influence;
use super::patch::Patch;
use super::strips::Strips;

/// Residual of the friction law at which it counts as satisfied, as a share of all traction bounds.
pub(super) const TOLERANCE: f64 = 1e-6;
/// Residual of the linear equations of each step: an inexact Newton method (Dembo, Eisenstat & Steihaug
/// 1982), which wastes no products on a set of slipping elements that is not yet right.
const FORCING: f64 = 0.2;
const MOST_STEPS: usize = 60;
const MOST_PRODUCTS: usize = 200;

/// Tractions of steady rolling, in units of the friction times the peak pressure.
#[derive(Debug, Clone)]
pub(super) struct SteadyTractions {
    /// x and y part of the traction of each element \[Pa\].
    pub(super) tractions: [Vec<f64>; 2],
    /// x and y part of the slip of each step of the material, per distance rolled \[-\].
    pub(super) slip: [Vec<f64>; 2],
    /// Largest traction of each element \[Pa\].
    pub(super) bound: Vec<f64>,
    /// Whether each element slips.
    pub(super) slips: Vec<bool>,
}

/// Solve the friction problem of steady rolling for rigid slips per distance rolled (x and y part of
/// each step) and traction bounds, from the tractions `start`; the residual reached if it does not
/// converge.
///
/// The slip of an element over the distance dx is S = c dx − (u(x) − u(x + dx)). It sticks where S = 0
/// and |p| < g, and slips where p = g S/|S|: p = Π(p + rS) with the projection Π on the disc of radius g,
/// for any r > 0. Newton's method on this equation, which is semismooth (Alart & Curnier 1991), each
/// step by [`gmres`].
pub(super) fn solve(
    patch: &Patch,
    influence: &Influence,
    rigid: &[[f64; 2]],
    bound: &[f64],
    start: Option<&[Vec<f64>; 2]>,
) -> Result<SteadyTractions, f64> {
    let count = patch.len();
    let weight = 1.0 / influence.own;
    let mut reached = f64::INFINITY;
    let mut tractions = start
        .cloned()
        .unwrap_or_else(|| [vec![0.0; count], vec![0.0; count]]);
    let size = bound.iter().map(|g| g * g).sum::<f64>().sqrt();
    for _ in 0..MOST_STEPS {
        let moved = influence.difference(patch, &tractions);
        // S, and w = p + rS.
        let slip = |part: usize, index: usize| rigid[index][part] * patch.dx - moved[part][index];
        let state: Vec<State> = (0..count)
            .map(|index| {
                let s = [slip(0, index), slip(1, index)];
                let w = [0, 1].map(|part| tractions[part][index] + weight * s[part]);
                State::new(w, bound[index])
            })
            .collect();
        let mut right = vec![Complex64::ZERO; 2 * count];
        let mut residual = 0.0;
        for (index, state) in state.iter().enumerate() {
            for part in 0..2 {
                let gap = state.projected[part] - tractions[part][index];
                residual += gap * gap;
                right[part * count + index] = Complex64::from(gap);
            }
        }
        if residual.sqrt() <= TOLERANCE * size {
            let slips = |step: usize| step >= count || state[step].slips;
            return Ok(SteadyTractions {
                slip: [0, 1].map(|part| {
                    (0..patch.steps.len())
                        .map(|step| {
                            if slips(step) {
                                slip(part, step) / patch.dx
                            } else {
                                0.0
                            }
                        })
                        .collect()
                }),
                slips: state.iter().map(|state| state.slips).collect(),
                bound: bound.to_vec(),
                tractions,
            });
        }
        let product = |change: &[Complex64]| {
            let part = |range: std::ops::Range<usize>| change[range].iter().map(|p| p.re).collect();
            let field = [part(0..count), part(count..2 * count)];
            let moved = influence.difference(patch, &field);
            let mut image = vec![Complex64::ZERO; 2 * count];
            for (index, state) in state.iter().enumerate() {
                let dp = [field[0][index], field[1][index]];
                let dw = [0, 1].map(|part| dp[part] - weight * moved[part][index]);
                let projected = state.derivative(dw);
                for part in 0..2 {
                    image[part * count + index] = Complex64::from(dp[part] - projected[part]);
                }
            }
            image
        };
        let strips = Strips::new(
            patch,
            influence,
            [1.0, -1.0],
            |value| value,
            |index, part| state[index].diagonal(part, weight),
        );
        let share = residual.sqrt() / size;
        let solved = strips.and_then(|strips| {
            gmres(
                product,
                |right| complex(strips.solve(&real(right))),
                &right,
                FORCING,
                MOST_PRODUCTS,
            )
        });
        let change = solved.ok_or(share)?;
        reached = share;
        for index in 0..count {
            for part in 0..2 {
                tractions[part][index] += change[part * count + index].re;
            }
        }
    }
    Err(reached)
}

fn real(values: &[Complex64]) -> Vec<f64> {
    values.iter().map(|value| value.re).collect()
}

fn complex(values: Vec<f64>) -> Vec<Complex64> {
    values.into_iter().map(Complex64::from).collect()
}

/// The projection of w = p + rS on the disc of admissible tractions, and its derivative.
struct State {
    slips: bool,
    projected: [f64; 2],
    /// Unit vector of w.
    direction: [f64; 2],
    /// g/|w|.
    ratio: f64,
}

impl State {
    fn new(w: [f64; 2], bound: f64) -> Self {
        let size = w[0].hypot(w[1]);
        let slips = size > bound;
        let ratio = if slips { bound / size } else { 1.0 };
        Self {
            slips,
            projected: w.map(|w| w * ratio),
            direction: if size > 0.0 {
                w.map(|w| w / size)
            } else {
                [1.0, 0.0]
            },
            ratio,
        }
    }

    /// Factors of dp and of the moved displacement in one part of the equation dp − dΠ = gap.
    fn diagonal(&self, part: usize, weight: f64) -> (f64, f64) {
        let turned = if self.slips {
            self.ratio * (1.0 - self.direction[part].powi(2))
        } else {
            1.0
        };
        (1.0 - turned, turned * weight)
    }

    fn derivative(&self, dw: [f64; 2]) -> [f64; 2] {
        if !self.slips {
            return dw;
        }
        let along = self.direction[0] * dw[0] + self.direction[1] * dw[1];
        [0, 1].map(|part| self.ratio * (dw[part] - self.direction[part] * along))
    }
}
