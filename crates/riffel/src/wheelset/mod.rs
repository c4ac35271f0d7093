//! The wheelset at the contact: how it answers the forces there, along the rail and downward.

mod motion;
mod rigid_inertia;
mod rigid_mass;

pub use motion::Motion;
pub use rigid_inertia::RigidInertia;
pub use rigid_mass::RigidMass;
