//! Response of rolling contact to small harmonic oscillations, at the frequency itself.

use num_complex::Complex64;

use super::Grid;
use super::forcing::Forcing;
use super::friction::{Slip, State, halves};
use super::influence::Convolution;
use super::partial_slip::slipping_shares;
use super::patch::Field;
use super::strips::{Diagonal, Strips};
use crate::contact::{Creepages, GridError};

/// Complex amplitudes per unit of the input.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Response {
    /// Creep force along and across the rail \[N\].
    pub(super) force: [Complex64; 2],
    /// Energy dissipated per metre rolled, in the patch at this moment \[J/m\].
    pub(super) dissipation: Complex64,
    /// Energy dissipated per metre at a point of the rail over the whole passage \[J/m\], relative to the
    /// input at the moment when the centre of the patch is over that point.
    pub(super) rail_dissipation: Complex64,
}

impl Response {
    /// That of elements of no size, from this one and one with elements of twice the length: the error goes with the
    /// length to the power of log₂(7/3) = 1.22, between the orders 1 of the boundary of slip and 3/2 of the edge.
    pub(super) fn extrapolated(self, coarse: Self) -> Self {
        let extrapolated = |fine: Complex64, coarse: Complex64| 1.75 * fine - 0.75 * coarse;
        Self {
            force: [0, 1].map(|part| extrapolated(self.force[part], coarse.force[part])),
            dissipation: extrapolated(self.dissipation, coarse.dissipation),
            rail_dissipation: extrapolated(self.rail_dissipation, coarse.rail_dissipation),
        }
    }

    /// What an extrapolated response may err by: the largest relative difference of the two grids, and a third of an
    /// element as a share of the patch for what both have in common. Energy that vanishes by symmetry is measured by
    /// the force and a creepage.
    pub(super) fn error(self, fine: Self, coarse: Self, creepage: f64, across: usize) -> GridError {
        let size = |force: [Complex64; 2]| force[0].norm().hypot(force[1].norm());
        let force = size(self.force);
        let at_wheel_and_rail = self.dissipation.norm().max(self.rail_dissipation.norm());
        let energy = at_wheel_and_rail.max(creepage * force);
        let of = |difference: f64, whole: f64| if whole > 0.0 { difference / whole } else { 0.0 };
        let differences = [
            of(size([0, 1].map(|part| fine.force[part] - coarse.force[part])), force),
            of((fine.dissipation - coarse.dissipation).norm(), energy),
            of((fine.rail_dissipation - coarse.rail_dissipation).norm(), energy),
        ];
        let share = differences.into_iter().fold(0.0, f64::max) + 1.0 / (3 * across) as f64;
        GridError { force: share * force, energy: share * energy }
    }
}

/// Rolling contact about a steady state, linear.
///
/// An element that slips keeps its traction on the bound, p₁ = g₁ŝ + (g/|S|)(1 − ŝŝᵀ)S₁, one that sticks has S₁ = 0.
/// Both are p₁ = dΠ(p₁ + rS₁) + g₁ŝ with the projection Π of [`State`]; along the slip, an element that slips in part
/// takes its [share](slipping_shares) of the one and the rest of the other.
pub(super) struct Tangent<'a> {
    pub(super) grid: &'a Grid,
    pub(super) steady: &'a Slip,
    pub(super) creepages: Creepages,
    /// The factor r \[Pa/m\].
    weight: f64,
    states: Vec<State>,
    /// The steady displacement u(x), u(x + dx) and ∂u/∂y at every step of the material.
    pub(super) here: Field<f64>,
    pub(super) ahead: Field<f64>,
    pub(super) across: Field<Complex64>,
}

impl<'a> Tangent<'a> {
    /// About a steady state at these creepages.
    pub(super) fn new(grid: &'a Grid, steady: &'a Slip, creepages: Creepages) -> Self {
        let (patch, influence) = (&grid.patch, &grid.influence);
        let weight = influence.own.recip();
        let shares = slipping_shares(patch, steady, &grid.bound, weight);
        let state = |(index, share): (usize, f64)| {
            let trial = [0, 1].map(|part| {
                let slip = if steady.slips[index] { steady.distance[part][index] } else { 0.0 };
                steady.tractions[part][index] + weight * slip
            });
            State::new(trial, grid.bound[index]).slipping_in_part(share)
        };
        let mut convolution = Convolution::new(influence, patch);
        let tractions = [0, 1].map(|part: usize| steady.tractions[part].as_slice());
        let complex =
            tractions.map(|part| -> Vec<Complex64> { part.iter().map(|&traction| traction.into()).collect() });
        Self {
            grid,
            steady,
            creepages,
            weight,
            states: shares.into_iter().enumerate().map(state).collect(),
            here: convolution.real(tractions, [1.0, 0.0]),
            ahead: convolution.real(tractions, [0.0, 1.0]),
            across: convolution.slope_across([complex[0].as_slice(), complex[1].as_slice()]),
        }
    }

    /// With everything oscillating at the wavenumber k \[rad/m\].
    pub(super) fn at(&self, wavenumber: f64) -> Oscillation<'_> {
        // A step of dx: the material was one element ahead, a phase k dx ago; both ends are seen from the
        // middle of the step.
        let half = Complex64::cis(0.5 * wavenumber * self.grid.patch.dx);
        Oscillation { tangent: self, wavenumber, half }
    }

    /// The projection's derivative dΠ of a change, x part first.
    pub(super) fn projected(&self, change: impl Fn(usize, usize) -> Complex64) -> Vec<Complex64> {
        let count = self.states.len();
        let mut image = vec![Complex64::ZERO; 2 * count];
        for (index, state) in self.states.iter().enumerate() {
            let projected = state.derivative([0, 1].map(|part| change(part, index)));
            image[index] = projected[0];
            image[count + index] = projected[1];
        }
        image
    }

    /// The factor r \[Pa/m\].
    pub(super) fn weight(&self) -> f64 {
        self.weight
    }
}

/// A [`Tangent`] at one wavenumber.
pub(super) struct Oscillation<'a> {
    pub(super) tangent: &'a Tangent<'a>,
    pub(super) wavenumber: f64,
    /// Phase from the middle of a step of the material to its front.
    half: Complex64,
}

impl Oscillation<'_> {
    /// The displacement over a step of the material: here less ahead.
    pub(super) fn difference(&self) -> [Complex64; 2] {
        [self.half, -self.half.conj()]
    }

    /// The right-hand side of the equations of the tractions.
    pub(super) fn right(&self, forcing: &Forcing) -> Vec<Complex64> {
        let tangent = self.tangent;
        let count = tangent.states.len();
        let mut right = tangent.projected(|part, index| tangent.weight * forcing.slip[part][index]);
        let Some(deformation) = &forcing.deformation else {
            return right;
        };
        for (index, state) in tangent.states.iter().enumerate() {
            let bounded = state.by_bound(deformation.bound[index] * tangent.grid.bound[index]);
            right[index] += bounded[0];
            right[count + index] += bounded[1];
        }
        right
    }

    /// The left-hand side for some tractions.
    pub(super) fn product(&self, tractions: &[Complex64], convolution: &mut Convolution) -> Vec<Complex64> {
        let field = halves(tractions);
        let moved = convolution.complex(field, self.difference());
        let weight = self.tangent.weight;
        let mut image = self.tangent.projected(|part, index| weight * moved[part][index] - field[part][index]);
        for (image, traction) in image.iter_mut().zip(tractions) {
            *image += traction;
        }
        image
    }

    /// Rows of elements by themselves, for an approximate inverse of [`product`](Self::product).
    pub(super) fn strips(&self) -> Strips<'_, Complex64> {
        let grid = self.tangent.grid;
        Strips::new(&grid.patch, &grid.influence, self.difference())
    }

    /// The term to keep of the equation of an element and part.
    pub(super) fn diagonal(&self, index: usize, part: usize) -> Diagonal {
        self.tangent.states[index].diagonal(part, self.tangent.weight)
    }

    /// What comes of the tractions and of the displacement that they cause over every step.
    pub(super) fn response(&self, forcing: &Forcing, tractions: &[Complex64], moved: &Field<Complex64>) -> Response {
        let (grid, steady) = (self.tangent.grid, self.tangent.steady);
        let (patch, half, wavenumber) = (&grid.patch, self.half, self.wavenumber);
        let deformation = forcing.deformation.as_ref();
        let field = halves(tractions);
        let mut result =
            Response { force: [Complex64::ZERO; 2], dissipation: Complex64::ZERO, rail_dissipation: Complex64::ZERO };
        let area = patch.area();
        let parts = field.iter().zip(&steady.tractions);
        for (force, (changes, means)) in result.force.iter_mut().zip(parts) {
            for (index, (change, mean)) in changes.iter().zip(means).enumerate() {
                let growth = deformation.map_or(Complex64::ZERO, |by| by.elements[index]);
                *force += area * (change + growth * mean);
            }
        }
        for (index, step) in patch.steps.iter().enumerate() {
            // The traction on the way is the mean of that at both ends of the step; so the sum over all
            // steps is the balance of energy to rounding, the release at the rear edge included.
            let (mut mean, mut change) = ([0.0; 2], [Complex64::ZERO; 2]);
            for (element, phase) in [(step.to, half), (step.from, half.conj())] {
                let Some(element) = element else { continue };
                for part in 0..2 {
                    mean[part] += 0.5 * steady.tractions[part][element];
                    change[part] += 0.5 * phase * field[part][element];
                }
            }
            let mut density = Complex64::ZERO;
            let mut steady_density = 0.0;
            for part in 0..2 {
                let slip = steady.distance[part][index] / patch.dx;
                let slip_change = (forcing.slip[part][index] - moved[part][index]) / patch.dx;
                steady_density += mean[part] * slip;
                density += mean[part] * slip_change + change[part] * slip;
            }
            let mut total = area * density;
            let mut displaced = Complex64::ZERO;
            let mut slower = Complex64::ZERO;
            if let Some(by) = deformation {
                total += area * by.steps[index] * steady_density;
                displaced = by.displaced[index] * area * steady_density;
                slower = by.slower * area * steady_density;
            }
            result.dissipation += total + slower;
            // What is displaced leaves its wear there.
            let x = step.middle.0;
            result.rail_dissipation += Complex64::cis(-wavenumber * x) * (total + displaced);
        }
        result
    }
}
