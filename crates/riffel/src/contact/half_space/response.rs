//! Response of rolling contact to small harmonic oscillations, at the frequency itself.

use num_complex::Complex64;

use super::Grid;
use super::friction::{Slip, halves};
use super::gmres::gmres;
use super::influence::{Convolution, Field};
use super::strips::{Diagonal, Strips};

/// Residual of the linear equations, as a share of their right-hand side.
pub(super) const TOLERANCE: f64 = 1e-5;
const MOST_PRODUCTS: usize = 400;

/// What oscillates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Input {
    /// Longitudinal creepage, per unit.
    Creepage,
    /// Normal load, per share of the mean load.
    Load,
}

/// Complex amplitudes per unit of the input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Response {
    /// Creep force along and across the rail \[N\].
    pub(super) force: [Complex64; 2],
    /// Energy dissipated per metre rolled, in the patch at this moment \[J/m\].
    pub(super) dissipation: Complex64,
    /// Energy dissipated per metre at a point of the rail over the whole passage \[J/m\], relative to the
    /// input at the moment when the centre of the patch is over that point.
    pub(super) rail_dissipation: Complex64,
}

/// The response at the wavenumber k = ω/V \[rad/m\]; the residual reached if it does not converge.
pub(super) fn response(
    grid: &Grid,
    steady: &Slip,
    input: Input,
    wavenumber: f64,
) -> Result<Response, f64> {
    let (patch, influence) = (&grid.patch, &grid.influence);
    let mut convolution = Convolution::new(influence, patch);
    let (count, steps) = (patch.len(), patch.steps.len());
    let weight = 1.0 / influence.own;
    // A step of dx: the material was one element ahead, a phase k dx ago; both ends are seen from the
    // middle of the step.
    let half = Complex64::cis(0.5 * wavenumber * patch.dx);
    let difference = [half, -half.conj()];

    // S₁ = forcing − (u₁ − u₁ ahead), bound₁.
    let mut forcing: Field<Complex64> =
        [vec![Complex64::ZERO; steps], vec![Complex64::ZERO; steps]];
    let bound: Vec<f64> = match input {
        Input::Creepage => {
            forcing[0].fill(Complex64::from(patch.dx));
            vec![0.0; count]
        }
        Input::Load => {
            // Lengths and pressures of the patch go like P^{1/3}. In coordinates that stretch with it
            // the edges stay, and what is left is smooth: u₁ = A₀p₁ + εu₀, the material passes slower
            // by ε, and is carried along by the stretching.
            let [x, y] = [0, 1].map(|part| -> Vec<Complex64> {
                let tractions = steady.tractions[part].iter();
                tractions.map(|&traction| traction.into()).collect()
            });
            let tractions = [x.as_slice(), y.as_slice()];
            let third = 1.0 / 3.0;
            let step = convolution.complex(tractions, [-Complex64::ONE, Complex64::ONE]);
            let stretched = convolution.complex(tractions, difference);
            let across = convolution.slope_across(tractions);
            for part in 0..2 {
                for index in 0..steps {
                    let (x, y) = patch.steps[index].middle;
                    let along = x * step[part][index] / patch.dx;
                    let carried = Complex64::new(0.0, wavenumber * patch.dx)
                        * (along + y * across[part][index]);
                    forcing[part][index] =
                        third * (carried - step[part][index] - stretched[part][index]);
                }
            }
            grid.bound.iter().map(|bound| third * bound).collect()
        }
    };

    // Slip elements: p₁ = g₁ŝ + (g/|S|)(1 − ŝŝᵀ) S₁; stick elements: S₁ = 0.
    let slip = |index: usize| [steady.distance[0][index], steady.distance[1][index]];
    let across_slip = |index: usize, value: [Complex64; 2]| -> [Complex64; 2] {
        let [x, y] = slip(index);
        let size = x.hypot(y);
        let unit = [x / size, y / size];
        let along = unit[0] * value[0] + unit[1] * value[1];
        let stiffness = grid.bound[index] / size;
        [0, 1].map(|part| stiffness * (value[part] - unit[part] * along))
    };
    let mut right = vec![Complex64::ZERO; 2 * count];
    for index in 0..count {
        let force = [forcing[0][index], forcing[1][index]];
        let row = if steady.slips[index] {
            let [x, y] = slip(index);
            let size = x.hypot(y);
            let turned = across_slip(index, force);
            [
                turned[0] + bound[index] * x / size,
                turned[1] + bound[index] * y / size,
            ]
        } else {
            force.map(|value| weight * value)
        };
        right[index] = row[0];
        right[count + index] = row[1];
    }
    let product = |tractions: &[Complex64]| {
        let field = halves(tractions);
        let moved = convolution.complex(field, difference);
        let mut image = vec![Complex64::ZERO; 2 * count];
        for index in 0..count {
            let moved = [moved[0][index], moved[1][index]];
            let row = if steady.slips[index] {
                let turned = across_slip(index, moved);
                [field[0][index] + turned[0], field[1][index] + turned[1]]
            } else {
                moved.map(|value| weight * value)
            };
            image[index] = row[0];
            image[count + index] = row[1];
        }
        image
    };
    let diagonal = |index: usize, part: usize| {
        if !steady.slips[index] {
            return Diagonal {
                identity: 0.0,
                difference: weight,
            };
        }
        let mut unit = [Complex64::ZERO; 2];
        unit[part] = Complex64::ONE;
        Diagonal {
            identity: 1.0,
            difference: across_slip(index, unit)[part].re,
        }
    };
    let strips = Strips::new(patch, influence, difference);
    let inverse = strips.inverse(diagonal);
    let inverse = |values: &mut [Complex64]| inverse.solve(values);
    let solution = gmres(product, inverse, &right, TOLERANCE, MOST_PRODUCTS)?;
    let field = halves(&solution);
    let moved = convolution.complex(field, difference);

    let mut result = Response {
        force: [Complex64::ZERO; 2],
        dissipation: Complex64::ZERO,
        rail_dissipation: Complex64::ZERO,
    };
    let area = patch.area();
    let growth = if input == Input::Load { 1.0 / 3.0 } else { 0.0 };
    let parts = field.iter().zip(&steady.tractions);
    for (force, (changes, means)) in result.force.iter_mut().zip(parts) {
        for (change, mean) in changes.iter().zip(means) {
            *force += area * (change + 2.0 * growth * mean);
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
            let slip_change = (forcing[part][index] - moved[part][index]) / patch.dx;
            steady_density += mean[part] * slip;
            density += mean[part] * slip_change + change[part] * slip;
        }
        let total = area * (density + 2.0 * growth * steady_density);
        result.dissipation += total;
        // A stretched patch leaves its wear further from its centre.
        let x = step.middle.0;
        let displaced = Complex64::new(0.0, -wavenumber * x) * growth * area * steady_density;
        result.rail_dissipation += Complex64::cis(-wavenumber * x) * (total + displaced);
    }
    Ok(result)
}
