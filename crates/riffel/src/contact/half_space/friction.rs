//! Coulomb friction over one step of the material: tractions, stick and slip.

use num_complex::Complex64;

use super::gmres::gmres;
use super::influence::{Convolution, Influence};
use super::patch::{Field, Patch};
use super::scalar::{Scalar, norm};
use super::strips::{Diagonal, Strips};

/// Residual of the linear equations of each step: an inexact Newton method (Dembo, Eisenstat & Steihaug
/// 1982), which wastes no products on a set of slipping elements that is not yet right.
const FORCING: f64 = 0.2;
const MOST_STEPS: usize = 60;
const MOST_PRODUCTS: usize = 200;

/// A friction problem: the slip of the material over a step is
/// S = forcing − here·u(x) − ahead·u(x + dx). An element sticks where S = 0 and |p| < g, and slips
/// where p = g S/|S|.
pub(super) struct Friction<'a> {
    pub(super) patch: &'a Patch,
    pub(super) influence: &'a Influence,
    /// Factors `here` and `ahead` \[-\].
    pub(super) operator: [f64; 2],
    /// x and y part of the slip of each step of the material without the unknown tractions \[m\].
    pub(super) forcing: &'a Field<f64>,
    /// Largest traction g of each element \[Pa\].
    pub(super) bound: &'a [f64],
    /// Displacement by a unit traction that balances both sides of the friction law \[m/Pa\].
    pub(super) compliance: f64,
    /// Residual of the friction law at which it counts as satisfied, as a share of the tractions.
    pub(super) tolerance: f64,
}

/// What solves a friction problem.
#[derive(Debug, Clone)]
pub(super) struct Slip {
    /// x and y part of the traction of each element \[Pa\].
    pub(super) tractions: Field<f64>,
    /// x and y part of the slip of each step of the material \[m\].
    pub(super) distance: Field<f64>,
    /// Whether each element slips.
    pub(super) slips: Vec<bool>,
}

impl Friction<'_> {
    /// Solve from the tractions `start`; the residual reached if it does not converge.
    ///
    /// Method: both cases of the law are one equation, p = Π(p + rS) with the projection Π on the disc
    /// of radius g, for any r > 0. Newton's method on it, which is semismooth (Alart & Curnier 1991),
    /// each step by [`gmres`].
    pub(super) fn solve(&self, start: &Field<f64>) -> Result<Slip, f64> {
        let count = self.patch.len();
        let weight = self.compliance.recip();
        let strips = Strips::new(self.patch, self.influence, self.operator);
        let mut convolution = Convolution::new(self.influence, self.patch);
        let mut tractions = start.concat();
        let mut reached = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let moved = convolution.real(halves(&tractions), self.operator);
            let slip = |part: usize, step: usize| self.forcing[part][step] - moved[part][step];
            let states: Vec<State> = (0..count)
                .map(|index| {
                    let w = [0, 1].map(|part| tractions[part * count + index] + weight * slip(part, index));
                    State::new(w, self.bound[index])
                })
                .collect();
            let projected: Vec<f64> =
                [0, 1].into_iter().flat_map(|part| states.iter().map(move |state| state.projected[part])).collect();
            let gaps: Vec<f64> =
                projected.iter().zip(&tractions).map(|(projected, traction)| projected - traction).collect();
            reached = norm(&gaps) / norm(&projected);
            // Nothing at all is a solution as well.
            if reached <= self.tolerance || norm(&gaps) == 0.0 {
                let slips = |step: usize| step >= count || states[step].slips;
                let distance = [0, 1].map(|part| {
                    (0..self.patch.steps.len()).map(|step| if slips(step) { slip(part, step) } else { 0.0 }).collect()
                });
                return Ok(Slip {
                    tractions: halves(&tractions).map(<[f64]>::to_vec),
                    distance,
                    slips: states.iter().map(|state| state.slips).collect(),
                });
            }
            let product = |change: &[f64]| {
                let moved = convolution.real(halves(change), self.operator);
                let mut image = vec![0.0; 2 * count];
                for (index, state) in states.iter().enumerate() {
                    let change = [change[index], change[count + index]];
                    let trial = [0, 1].map(|part| change[part] - weight * moved[part][index]);
                    let projected = state.derivative(trial);
                    image[index] = change[0] - projected[0];
                    image[count + index] = change[1] - projected[1];
                }
                image
            };
            let inverse = strips.inverse(|index, part| states[index].diagonal(part, weight));
            let inverse = |values: &mut [f64]| inverse.solve(values);
            let change = gmres(product, inverse, &gaps, FORCING, MOST_PRODUCTS).map_err(|_| reached)?;
            for (index, &bound) in self.bound.iter().enumerate() {
                let next = [index, count + index].map(|place| tractions[place] + change[place]);
                // Back onto the disc: from beyond it the next step goes astray.
                [tractions[index], tractions[count + index]] = State::new(next, bound).projected;
            }
        }
        Err(reached)
    }
}

/// The x part and the y part of a list of both.
pub(super) fn halves<T>(values: &[T]) -> [&[T]; 2] {
    let (x, y) = values.split_at(values.len() / 2);
    [x, y]
}

/// The projection of w = p + rS on the disc of admissible tractions, and its derivative.
pub(super) struct State {
    slips: bool,
    projected: [f64; 2],
    /// Unit vector of w.
    direction: [f64; 2],
    /// g/|w|, at most one.
    ratio: f64,
    /// Share of the element that slips \[-\].
    share: f64,
}

impl State {
    pub(super) fn new(w: [f64; 2], bound: f64) -> Self {
        let size = w[0].hypot(w[1]);
        // Where nothing presses, all slips.
        let slips = size > bound || bound == 0.0;
        let ratio = if size > bound { bound / size } else { 1.0 };
        Self {
            slips,
            projected: w.map(|w| w * ratio),
            direction: if size > 0.0 { w.map(|w| w / size) } else { [1.0, 0.0] },
            ratio: if slips && bound == 0.0 { 0.0 } else { ratio },
            share: if slips { 1.0 } else { 0.0 },
        }
    }

    /// Element with a share that slips, in place of all or nothing: along the slip, the rest resists it.
    pub(super) fn slipping_in_part(self, share: f64) -> Self {
        Self { share, ..self }
    }

    /// The traction of a change dg of the bound.
    pub(super) fn by_bound(&self, change: Complex64) -> [Complex64; 2] {
        self.direction.map(|part| self.share * change * part)
    }

    /// The diagonal of dp − dΠ in one part.
    pub(super) fn diagonal(&self, part: usize, weight: f64) -> Diagonal {
        let along = self.direction[part].powi(2);
        let turned = self.ratio * (1.0 - along) + (1.0 - self.share) * along;
        Diagonal { identity: 1.0 - turned, difference: turned * weight }
    }

    /// dΠ of a change dw.
    pub(super) fn derivative<T: Scalar>(&self, dw: [T; 2]) -> [T; 2] {
        if self.share == 0.0 && self.ratio == 1.0 {
            return dw;
        }
        let direction = self.direction.map(T::of);
        let along = direction[0] * dw[0] + direction[1] * dw[1];
        let (ratio, kept) = (T::of(self.ratio), T::of(1.0 - self.share));
        [0, 1].map(|part| {
            let own = direction[part] * along;
            ratio * (dw[part] - own) + kept * own
        })
    }
}
