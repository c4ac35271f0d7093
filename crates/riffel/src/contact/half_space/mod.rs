//! Kalker's exact theory of rolling contact: two elastic half-spaces of one material.
//!
//! Wheel and rail are alike elastic, so that tangential tractions do not change the pressure, which is
//! that of Hertz. Coulomb friction bounds the traction everywhere. What remains is to find where the
//! patch sticks and where it slips.

mod forcing;
mod friction;
mod gmres;
mod grid_sweep;
mod influence;
mod input;
mod normal;
mod on_waves;
mod partial_slip;
mod patch;
mod patch_rolling;
mod response;
mod response_sweep;
mod scalar;
mod steady;
mod strips;
mod transform;
mod transient;
mod true_gap;
mod wavy_patch;

pub use self::normal::{ContactGrid, NormalContact, NormalState};
pub use self::patch_rolling::{PatchRolling, PatchTractions};
pub use self::transient::{TransientRolling, TransientStep};
pub use self::true_gap::PressedOnRail;

use self::friction::Slip;
use self::influence::Influence;
use self::input::Input;
use self::patch::{Field, Patch};
pub(super) use self::response_sweep::{FoundResponses, ResponseSweep};
use super::{
    Carter3d, ContactResponse, CreepForces, Creepages, HertzContact, MeanRolling, MeanState, Oscillating,
    OscillatingCreepages, QuasiStatic, RollingContact,
};
use crate::{ElasticMaterial, Error};
use riffel_numerics::bisection::fallible_bisection;

/// What to try where rolling does not converge.
pub(super) const REMEDY: &str = "try another grid (contact.grid) or a creepage further from full slip";

/// A Hertz contact as half-spaces with Coulomb friction.
///
/// Method: the ellipse is cut into n × n rectangles of constant traction and solved on two grids, n
/// and n/2 elements across; forces are extrapolated, 2·fine − coarse, since the error of one grid is
/// proportional to the size of its elements (see the test `error_is_of_first_order`). Steady rolling:
/// semismooth Newton, 1e-6 of the tractions; linear equations by GMRES with the rows of elements as
/// preconditioner. Dissipation takes the traction on the way of each step of the
/// material, which makes it balance the work of the creep force to rounding, also where the slip zone
/// is thinner than an element.
///
/// Source: Kalker (1990), *Three-dimensional elastic bodies in rolling contact*, for the theory;
/// Cerruti (1882) for the influence of a traction; the frequency response is derived in the book.
/// Range of validity: bodies much larger than the patch, one material, dry friction of one
/// coefficient. Accuracy with n = 60: creep force within 0.5 % of CONTACT; frequency response within 2 % of finer
/// grids for λ ≥ 2a and τ up to 0.99, as a share of its modulus; the energy at the rail by load, which passes zero, as a
/// share of its quasi-static value. Cost with n = 60: some 20 ms for a steady state, 0.15 s for a wavelength and all
/// inputs, 1 s for any number of them.
pub struct HalfSpace {
    hertz: HertzContact,
    friction: f64,
    fine: Grid,
    coarse: Grid,
}

/// One discretisation.
struct Grid {
    /// Of the ellipse along and across the rail \[m\].
    semi_axes: (f64, f64),
    patch: Patch,
    material: ElasticMaterial,
    influence: Influence,
    /// Largest traction of each element \[Pa\].
    bound: Vec<f64>,
}

impl Grid {
    fn new(hertz: HertzContact, friction: f64, across: usize) -> Result<Self, Error> {
        let (a, b) = (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral());
        let patch = Patch::new(a, b, across)?;
        Ok(Self {
            semi_axes: (a, b),
            material: hertz.material(),
            influence: Influence::new(hertz.material(), &patch),
            bound: patch.traction_bound(hertz, friction),
            patch,
        })
    }

    fn roll(&self, creepages: Creepages, start: Option<&Field<f64>>) -> Result<Slip, Error> {
        let slip = steady::rigid_slip(&self.patch, |x, y| creepages.rigid_slip(x, y));
        steady::solve(&self.patch, &self.influence, &slip, &self.bound, start).map_err(|residual| Error::NotConverged {
            problem: "steady rolling",
            residual,
            tolerance: steady::TOLERANCE,
            remedy: REMEDY,
        })
    }

    /// Tractions of a grid of half as many elements across, as the same shares of the bounds here.
    fn refined(&self, coarse: &Self, tractions: &Field<f64>) -> Field<f64> {
        let mut shares = vec![[0.0; 2]; coarse.patch.across.pow(2)];
        for (index, &(column, row)) in coarse.patch.places.iter().enumerate() {
            shares[row * coarse.patch.across + column] =
                [0, 1].map(|part| tractions[part][index] / coarse.bound[index]);
        }
        [0, 1].map(|part| {
            let share = |&(column, row): &(usize, usize)| shares[row / 2 * coarse.patch.across + column / 2][part];
            let places = self.patch.places.iter().map(share).zip(&self.bound);
            places.map(|(share, bound)| share * bound).collect()
        })
    }
}

/// Steady rolling of a [`HalfSpace`].
pub struct HalfSpaceRolling {
    creepages: Creepages,
    forces: CreepForces,
    spin_moment: f64,
    fine: Slip,
    coarse: Slip,
}

impl HalfSpaceRolling {
    /// Longitudinal creepage ξ \[-\].
    pub fn creepage(&self) -> f64 {
        self.creepages.longitudinal
    }

    /// Creep force along the rail, Q \[N\].
    pub fn tangential_force(&self) -> f64 {
        self.forces.longitudinal
    }

    /// Creep forces along and across the rail \[N\].
    pub fn forces(&self) -> CreepForces {
        self.forces
    }

    /// Whether the patch slips everywhere.
    fn slips(&self) -> bool {
        let mut elements = self.fine.slips.iter().chain(&self.coarse.slips);
        elements.all(|slips| *slips)
    }

    /// Moment of the creep tractions about the normal \[Nm\]; its work per metre is φM.
    pub fn spin_moment(&self) -> f64 {
        self.spin_moment
    }
}

/// One element of the patch in steady rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct ContactElement {
    /// Centre \[m\]; x along the direction of rolling, material enters at x = +a.
    pub centre: (f64, f64),
    /// Tangential traction along and across the rail \[Pa\].
    pub traction: (f64, f64),
    /// Traction bound μp \[Pa\].
    pub bound: f64,
    /// True where the surfaces slip.
    pub slips: bool,
}

impl HalfSpace {
    /// Elements over a diameter for a response within 2 %, by default of the case file.
    pub const DEFAULT_ELEMENTS: usize = 60;

    /// Largest tractive ratio with a slope to go by: nearer to full slip it vanishes, and the creepage is found by halves.
    pub const LARGEST_TRACTIVE_RATIO: f64 = 0.99;

    /// A contact with the coefficient of friction μ, cut into `across` elements over a diameter, an even
    /// number from 16 to 200.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the friction is not positive or the number of elements out of range.
    pub fn new(hertz: HertzContact, friction: f64, across: usize) -> Result<Self, Error> {
        Error::unless_positive("coefficient of friction", friction, "")?;
        if !across.is_multiple_of(2) {
            return Err(Error::OutOfRange {
                quantity: "number of elements across the contact",
                value: across as f64,
                unit: "",
                rule: "must be even: a grid of half as many is solved as well",
            });
        }
        Ok(Self {
            fine: Grid::new(hertz, friction, across)?,
            coarse: Grid::new(hertz, friction, across / 2)?,
            hertz,
            friction,
        })
    }

    /// Steady rolling at the longitudinal creepage ξ ≥ 0 \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if ξ is negative, [`Error::NotConverged`].
    pub fn roll(&self, creepage: f64) -> Result<HalfSpaceRolling, Error> {
        Error::unless_not_negative("creepage", creepage, "")?;
        self.roll_from(Creepages::longitudinal(creepage), None)
    }

    /// Steady rolling, begun with the tractions of another creepage nearby: on fine grids near full slip it may converge where
    /// [`roll`](Self::roll) does not.
    ///
    /// # Errors
    /// Errors of [`roll`](Self::roll).
    pub fn roll_near(&self, creepage: f64, near: &HalfSpaceRolling) -> Result<HalfSpaceRolling, Error> {
        Error::unless_not_negative("creepage", creepage, "")?;
        self.roll_from(Creepages::longitudinal(creepage), Some(near))
    }

    /// Steady rolling with lateral creepage and spin as well, of either sign.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn roll_with(&self, creepages: Creepages) -> Result<HalfSpaceRolling, Error> {
        self.roll_from(creepages, None)
    }

    fn roll_from(&self, creepages: Creepages, start: Option<&HalfSpaceRolling>) -> Result<HalfSpaceRolling, Error> {
        let coarse = start.map(|start| &start.coarse.tractions);
        let coarse = self.coarse.roll(creepages, coarse)?;
        let fine = match start {
            Some(start) => self.fine.roll(creepages, Some(&start.fine.tractions))?,
            None => {
                let start = self.fine.refined(&self.coarse, &coarse.tractions);
                self.fine.roll(creepages, Some(&start))?
            }
        };
        let (by_fine, by_coarse) =
            (self.fine.patch.forces(&fine.tractions), self.coarse.patch.forces(&coarse.tractions));
        let forces = by_fine.combine(2.0, by_coarse, -1.0);
        // Extrapolation may pass full slip by its own error.
        let limit = self.friction * self.hertz.normal_force();
        let share = (limit / forces.magnitude()).min(1.0);
        Ok(HalfSpaceRolling {
            creepages,
            forces: forces.combine(share, CreepForces::default(), 0.0),
            spin_moment: 2.0 * self.fine.patch.moment(&fine.tractions) - self.coarse.patch.moment(&coarse.tractions),
            fine,
            coarse,
        })
    }

    /// Steady rolling with the tractive ratio τ = Q/μP, 0 < τ < 1 \[-\], to 1e-6.
    ///
    /// Method: Newton's on the creepage, with the slope of the frequency response at zero
    /// frequency. From 0.99 on the least creepage, to 1e-6, at which the force is reached or the patch slips everywhere, by
    /// halving: so τ → 1 tends to the onset of full slip, where the force misses μP by the grid alone.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if τ is out of range, [`Error::NotConverged`].
    pub fn roll_at_tractive_ratio(&self, ratio: f64) -> Result<HalfSpaceRolling, Error> {
        MeanState::check_tractive_ratio(ratio)?;
        match ratio <= Self::LARGEST_TRACTIVE_RATIO {
            true => self.roll_by_slope(ratio),
            false => self.roll_near_full_slip(ratio),
        }
    }

    fn roll_near_full_slip(&self, ratio: f64) -> Result<HalfSpaceRolling, Error> {
        const TOLERANCE: f64 = 1e-6;
        /// In creepages at 0.99; full slip of the cubic of Johnson and Vermeulen begins at 1.3.
        const FARTHEST: f64 = 4.0;
        let force = ratio * self.friction * self.hertz.normal_force();
        let reached = |state: &HalfSpaceRolling| state.slips() || state.tangential_force() >= force;
        let mut near = self.roll_by_slope(Self::LARGEST_TRACTIVE_RATIO)?;
        let first = near.creepage();
        let (mut low, mut high) = (first, first);
        while !reached(&near) {
            if high > FARTHEST * first {
                return Err(Error::NotConverged {
                    problem: "creepage of full slip",
                    residual: ratio - near.tangential_force() * ratio / force,
                    tolerance: TOLERANCE,
                    remedy: REMEDY,
                });
            }
            (low, high) = (high, 1.1 * high);
            near = self.roll_near(high, &near)?;
        }
        fallible_bisection([low, high], TOLERANCE * low, |creepage| {
            let state = self.roll_near(creepage, &near)?;
            let is_beyond = reached(&state);
            if is_beyond {
                near = state;
            }
            Ok(is_beyond)
        })?;
        Ok(near)
    }

    fn roll_by_slope(&self, ratio: f64) -> Result<HalfSpaceRolling, Error> {
        const TOLERANCE: f64 = 1e-6;
        const MOST_STEPS: usize = 20;
        let limit = self.friction * self.hertz.normal_force();
        let load = self.hertz.normal_force();
        let law = Carter3d::new(self.hertz, self.friction)?;
        let start = QuasiStatic::new(law, load, MeanState::TractiveRatio(ratio))?.steady();
        let mut state = self.roll_from(start.creepages, None)?;
        let mut error = f64::NAN;
        for _ in 0..MOST_STEPS {
            error = state.tangential_force() / limit - ratio;
            if error.abs() <= TOLERANCE {
                return Ok(state);
            }
            let mut sweep = ResponseSweep::new(self, &state, &[Input::Longitudinal]);
            let (response, _) = sweep.extrapolated(0.0)?[0];
            let slope = response.force[0].re / limit;
            // Stay on the rising side of the creep curve.
            let creepage = state.creepage();
            let next = (creepage - error / slope).clamp(0.5 * creepage, 2.0 * creepage);
            state = self.roll_from(Creepages::longitudinal(next), Some(&state))?;
        }
        Err(Error::NotConverged {
            problem: "creepage for the tractive ratio",
            residual: error.abs(),
            tolerance: TOLERANCE,
            remedy: REMEDY,
        })
    }

    /// Shortest wavelength \[m\] that the grid resolves.
    pub fn shortest_wavelength(&self) -> f64 {
        /// A step of 2π/6 in phase from one element to the next on the coarse grid.
        const FEWEST_ELEMENTS: f64 = 6.0;
        FEWEST_ELEMENTS * self.coarse.patch.dx
    }

    /// `Ok` if the grid resolves a wavelength \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if it has fewer than six elements of the half grid.
    pub(super) fn check_wavelength(&self, wavelength: f64) -> Result<(), Error> {
        if wavelength >= self.shortest_wavelength() {
            return Ok(());
        }
        Err(Error::OutOfRange {
            quantity: "wavelength",
            value: wavelength,
            unit: "m",
            rule: "must be at least six elements of the half grid: refine the grid of the contact",
        })
    }

    /// Linear response to oscillations of load, creepages and spin and to waves of the rail, of the wavelength \[m\] about a steady state;
    /// infinite for the quasi-static derivatives.
    ///
    /// Method: both grids; elements on the boundary of slip slip in part; extrapolation by ¾ of the difference,
    /// since errors are of first order in the length of an element on that boundary and of order 3/2 at the edge.
    /// Every derivative comes with its [`GridError`](super::GridError).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the wavelength has fewer than six elements, [`Error::NotConverged`].
    pub fn response(&self, state: &HalfSpaceRolling, wavelength: f64) -> Result<ContactResponse, Error> {
        let all = OscillatingCreepages::All.on_waves();
        self.sweep(state, all).at(wavelength)
    }

    /// [`response`](Self::response) at many wavelengths \[m\], to the load and to what else is asked for; each in its
    /// place. `progress` is told of every one.
    ///
    /// Method: each wavelength begins with what the others have found, taken from the outside in: many cost little more
    /// than ten. Cost: proportional to the number of inputs; some 0.3 s for 60 elements across and each input.
    pub fn responses(
        &self,
        state: &HalfSpaceRolling,
        wavelengths: &[f64],
        oscillating: impl Into<Oscillating>,
        progress: impl Fn(),
    ) -> Vec<Result<ContactResponse, Error>> {
        let mut sweep = self.sweep(state, oscillating.into());
        let mut responses: Vec<_> = wavelengths.iter().map(|_| None).collect();
        for index in outside_in(wavelengths.len()) {
            responses[index] = Some(sweep.at(wavelengths[index]));
            progress();
        }
        responses.into_iter().flatten().collect()
    }

    /// [`response`](Self::response) at wavelengths one after the other.
    pub(super) fn sweep<'a>(&'a self, state: &'a HalfSpaceRolling, oscillating: Oscillating) -> ResponseSweep<'a> {
        use Input::{Lateral, Load, Longitudinal, Spin};
        let mut inputs = match oscillating.creepages {
            OscillatingCreepages::Longitudinal => vec![Load, Longitudinal],
            OscillatingCreepages::InPlane => vec![Load, Longitudinal, Lateral],
            OscillatingCreepages::All => vec![Load, Longitudinal, Lateral, Spin],
        };
        if oscillating.profile {
            inputs.push(Input::Profile);
        }
        ResponseSweep::new(self, state, &inputs)
    }

    /// The mean state for a loop.
    pub fn steady(&self, state: &HalfSpaceRolling) -> MeanRolling {
        MeanRolling {
            normal_force: self.hertz.normal_force(),
            friction: self.friction,
            creepages: state.creepages,
            forces: state.forces,
        }
    }

    /// The ellipse.
    pub fn hertz(&self) -> HertzContact {
        self.hertz
    }

    /// Coefficient of friction μ \[-\].
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Length and width \[m\] of an element of the fine grid.
    pub fn element_size(&self) -> [f64; 2] {
        [self.fine.patch.dx, self.fine.patch.dy]
    }

    /// The elements of the fine grid.
    pub fn elements<'a>(&'a self, state: &'a HalfSpaceRolling) -> impl Iterator<Item = ContactElement> + 'a {
        let centres = self.fine.patch.centres.iter().enumerate();
        centres.map(|(index, &centre)| ContactElement {
            centre,
            traction: (state.fine.tractions[0][index], state.fine.tractions[1][index]),
            bound: self.fine.bound[index],
            slips: state.fine.slips[index],
        })
    }
}

/// The numbers below a count: the ends, the middle, the middles of both halves, and so on.
fn outside_in(count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count.min(1)).chain((1..count).rev().take(1)).collect();
    let mut step = count.next_power_of_two();
    while step > 1 {
        order.extend((step / 2..count.saturating_sub(1)).step_by(step));
        step /= 2;
    }
    order
}

#[cfg(test)]
mod tests;
