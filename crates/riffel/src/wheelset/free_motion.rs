//! Motion of a wheelset as far as no suspension holds it.

use num_complex::Complex64;

use super::rigid_motions::{RigidMotions, RigidPlane};
use super::section::SectionReceptances;
use super::{ContactGeometry, RigidBody, Suspension};
use crate::Direction;

/// Part A \[1/kg\] of the receptances of a wheelset, H → −A/ω² for ω → 0, at its sections over the contacts.
///
/// In each plane of the axle A = M⁻¹ of the mass, the first moment about the middle and the moment of inertia; zero in a plane that
/// springs or dampers hold. Nothing holds the spin.
pub(super) struct FreeMotion {
    sections: SectionReceptances,
    rolling_radius: f64,
}

impl FreeMotion {
    /// Free motion of a body with a first moment of its mass about the middle of the axle \[kg m\].
    pub(super) fn new(
        body: RigidBody,
        first_moment: f64,
        suspension: Option<&Suspension>,
        contacts: ContactGeometry,
    ) -> Self {
        let is_held = |direction| suspension.is_some_and(|suspension| suspension.along(direction) != [0.0, 0.0]);
        let determinant = body.mass * body.roll_inertia - first_moment * first_moment;
        let plane = |direction| {
            let answer = |of: f64| Complex64::from(if is_held(direction) { 0.0 } else { of / determinant });
            RigidPlane { shift: answer(body.roll_inertia), coupling: answer(-first_moment), turn: answer(body.mass) }
        };
        let motions = RigidMotions {
            horizontal: plane(Direction::Longitudinal),
            sideward: Complex64::from(if is_held(Direction::Lateral) { 0.0 } else { body.mass.recip() }),
            vertical: plane(Direction::Vertical),
            spin: Complex64::from(body.spin_inertia.recip()),
        };
        Self { sections: motions.sections(contacts), rolling_radius: contacts.rolling_radius }
    }

    /// Part A of [`Wheelset::receptances`](super::Wheelset::receptances).
    pub(super) fn at_contacts(&self) -> [[f64; 6]; 6] {
        self.sections.at_contacts(self.rolling_radius).map(|row| row.map(|entry| entry.re))
    }

    /// Part A of [`WheelsetWithHubs::hubs`](super::WheelsetWithHubs::hubs).
    pub(super) fn of_hubs(&self) -> [[f64; 2]; 2] {
        self.sections.forward.map(|row| row.map(|entry| entry.re))
    }
}
