//! Motions of a rigid wheelset at its contacts.

use num_complex::Complex64;

use super::ContactGeometry;
use super::section::SectionReceptances;

/// Answers of the motions of a rigid wheelset to forces and moments.
pub(super) struct RigidMotions {
    /// Along the rail and about the vertical.
    pub(super) horizontal: RigidPlane,
    /// Across the track.
    pub(super) sideward: Complex64,
    /// Downward and about the direction of travel.
    pub(super) vertical: RigidPlane,
    /// About the axle.
    pub(super) spin: Complex64,
}

/// Answers in one plane of the axle at its middle: shift by force, shift by moment, which is turn by force, and turn by moment.
pub(super) struct RigidPlane {
    pub(super) shift: Complex64,
    pub(super) coupling: Complex64,
    pub(super) turn: Complex64,
}

impl RigidPlane {
    /// Shift at a distance from the middle by a force at another.
    fn between(&self, at: f64, from: f64) -> Complex64 {
        self.shift + (at + from) * self.coupling + at * from * self.turn
    }
}

impl RigidMotions {
    /// Answers of the sections over the contacts.
    pub(super) fn sections(&self, contacts: ContactGeometry) -> SectionReceptances {
        let Self { horizontal, sideward, vertical, spin } = self;
        let places = contacts.places();
        let between =
            |receptance: &dyn Fn(f64, f64) -> Complex64| places.map(|at| places.map(|from| receptance(at, from)));
        SectionReceptances {
            forward: between(&|at, from| horizontal.between(at, from)),
            downward: between(&|at, from| vertical.between(at, from)),
            downward_by_tilt: between(&|at, _| vertical.coupling + at * vertical.turn),
            tilt: between(&|_, _| vertical.turn),
            twist: between(&|_, _| *spin),
            sideward: between(&|_, _| *sideward),
        }
    }
}
