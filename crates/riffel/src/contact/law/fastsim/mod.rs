//! Kalker's simplified theory of rolling contact.

mod distribution;
mod grid;

pub use distribution::{ContactCell, TractionDistribution};

use std::f64::consts::PI;
use std::sync::{Arc, LazyLock};

use grid::{Grid, Loading};

use super::{CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages, ForceLimit};
use crate::Error;

/// How the bound of traction μp is spread over the ellipse; its integral is μP either way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TractionBound {
    /// p = (2P/πab) (1 − x²/a² − y²/b²), Kalker's choice: with elastic deformation in proportion to
    /// the traction it puts the border of stick and slip where exact theory has it.
    #[default]
    Parabolic,
    /// p = (3P/2πab) √(1 − x²/a² − y²/b²), the pressure of Hertz.
    Elliptic,
}

/// FASTSIM: longitudinal and lateral creepage and spin on an ellipse cut into strips.
///
/// A point of the rail yields in proportion to the traction on it, u_x = L₁p_x, u_y = L₂p_y, with
/// L₁ = 8a/(3C₁₁G), L₂ = 8a/(3C₂₂G) and, for the part of spin, L₃ = πa √(a/b)/(4C₂₃G). From the
/// leading edge of a strip backwards the traction grows by (ξ/L₁ − φy/L₃, η/L₂ + φx/L₃) per metre;
/// where it would exceed the bound μp it slips and is shortened to it.
///
/// The ellipse is cut into n strips of equal width and each strip into n cells of equal length. The
/// traction is taken at the middle of a cell, so that the slope at zero creepage is Kalker's
/// C₁₁Gab, C₂₂Gab on every grid (along the strip exactly, across it to 1/n^{5/2}), and the bound is
/// scaled so that full slip gives μP. In pure longitudinal creepage Q/μP at n = 50 is within 3·10⁻⁴
/// of the limit n → ∞; with spin the error falls with 1/n and is 0.5 % in a published case.
///
/// Source: Kalker (1982, Vehicle System Dynamics 11, 1–13); flexibilities of Kalker (1990). Range of
/// validity: any combination of creepages on a Hertzian ellipse. Largest deviations of Q/μP in pure
/// longitudinal creepage from CONTACT, parabolic bound: −3.4 % at a/b = 1.59 (elliptic bound: −5.2 %
/// to +6.9 %), −5.5 % at a/b = 0.5. CONTACT's own FASTSIM is up to 3 % higher, because its cells are
/// first order; on them this theory gives the same to 0.1 %. Tests:
/// `deviation_from_exact_theory_is_as_documented`, `published_traction_curve`.
///
/// [`derivatives`](CreepLaw::derivatives) by creepage are central differences over the change of
/// creepage that moves the border of stick and slip by one cell, 1/2n of full slip to either side: on
/// a finite grid the slope itself moves in steps, as one cell after the other begins to slip, and this
/// is its mean over one step. At n = 50 ∂Q/∂ξ is within 10⁻³ of the slope at zero; below 1/2n of
/// full slip it may be 1/2n low. Test: `default_grid_is_fine_enough`. The derivative by load follows
/// without a further error. Cost at n = 50: 10–13 µs for the forces, five times that for the derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct Fastsim {
    ellipse: CreepEllipse,
    friction: f64,
    grid: Arc<Grid>,
}

/// The usual grid under Kalker's bound: equilibria in curves ask for a law of their own at each step.
static USUAL_GRID: LazyLock<Arc<Grid>> =
    LazyLock::new(|| Arc::new(Grid::new(TractionBound::default(), Fastsim::DEFAULT_DIVISIONS)));

impl Fastsim {
    /// Strips, and cells of a strip, that resolve a creep force to a few 10⁻⁴.
    pub const DEFAULT_DIVISIONS: usize = 50;

    /// The law on an ellipse with the coefficient of friction μ \[-\], cut into `divisions` strips of
    /// `divisions` cells.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all values are positive and there are at least two divisions.
    pub fn new(ellipse: CreepEllipse, friction: f64, bound: TractionBound, divisions: usize) -> Result<Self, Error> {
        ellipse.check()?;
        Error::unless_positive("coefficient of friction", friction, "")?;
        if divisions < 2 {
            return Err(Error::OutOfRange {
                quantity: "number of strips",
                value: divisions as f64,
                unit: "",
                rule: "must be at least 2",
            });
        }
        let grid = match (bound, divisions) == (TractionBound::default(), Self::DEFAULT_DIVISIONS) {
            true => USUAL_GRID.clone(),
            false => Arc::new(Grid::new(bound, divisions)),
        };
        Ok(Self { ellipse, friction, grid })
    }

    /// Tractions, slip and dissipation cell by cell under the normal force P > 0 \[N\].
    pub fn distribution(&self, normal_force: f64, creepages: Creepages) -> TractionDistribution {
        TractionDistribution::new(&self.flexibility(normal_force), &self.grid, creepages)
    }

    fn flexibility(&self, normal_force: f64) -> Flexibility {
        let ellipse = self.ellipse.under(normal_force);
        let a = ellipse.semi_axis_longitudinal;
        let b = ellipse.semi_axis_lateral;
        let modulus = ellipse.shear_modulus;
        Flexibility {
            a,
            b,
            longitudinal: 8.0 * a / (3.0 * ellipse.c11 * modulus),
            lateral: 8.0 * a / (3.0 * ellipse.c22 * modulus),
            spin: PI * a * (a / b).sqrt() / (4.0 * ellipse.c23 * modulus),
            traction: self.friction * normal_force / (a * b * self.grid.bound_integral()),
        }
    }
}

/// The patch at one load: semi-axes \[m\], flexibilities L₁, L₂, L₃ \[m/Pa\] and the bound of traction
/// at the centre \[Pa\].
#[derive(Debug, Clone, Copy)]
struct Flexibility {
    a: f64,
    b: f64,
    longitudinal: f64,
    lateral: f64,
    spin: f64,
    traction: f64,
}

impl Flexibility {
    /// Growth of traction per half-length a, over the bound at the centre.
    fn loading(&self, creepages: Creepages) -> Loading {
        let scale = self.a / self.traction;
        Loading {
            longitudinal: scale * creepages.longitudinal / self.longitudinal,
            lateral: scale * creepages.lateral / self.lateral,
            longitudinal_by_y: -scale * self.b * creepages.spin / self.spin,
            lateral_by_x: scale * self.a * creepages.spin / self.spin,
        }
    }
}

impl CreepLaw for Fastsim {
    fn friction(&self) -> f64 {
        self.friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let loading = self.flexibility(normal_force).loading(creepages);
        let [longitudinal, lateral] = self.grid.forces(loading);
        let limit = self.friction * normal_force;
        CreepForces { longitudinal: limit * longitudinal, lateral: limit * lateral }
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let patch = self.flexibility(normal_force);
        let step = patch.traction / (patch.a * self.grid.strips().len() as f64);
        let slope = |longitudinal: f64, lateral: f64| {
            let at = |sign: f64| {
                let shifted = Creepages {
                    longitudinal: creepages.longitudinal + sign * longitudinal,
                    lateral: creepages.lateral + sign * lateral,
                    spin: creepages.spin,
                };
                self.forces(normal_force, shifted)
            };
            let width = 2.0 * (longitudinal + lateral);
            at(1.0).combine(1.0 / width, at(-1.0), -1.0 / width)
        };
        CreepDerivatives::of_ellipse(
            normal_force,
            creepages,
            self.forces(normal_force, creepages),
            slope(step * patch.longitudinal, 0.0),
            slope(0.0, step * patch.lateral),
        )
    }

    /// Full slip of this grid. As it is refined the limit tends to u = 32/3π for the parabolic bound,
    /// u as in [`JohnsonVermeulen`](super::JohnsonVermeulen), and to infinity for the elliptic one,
    /// which is infinitely steep at the edge.
    fn limit(&self, normal_force: f64) -> ForceLimit {
        let patch = self.flexibility(normal_force);
        ForceLimit::FullSlip(self.grid.full_slip() * patch.longitudinal * patch.traction / patch.a)
    }
}

#[cfg(test)]
mod tests;
