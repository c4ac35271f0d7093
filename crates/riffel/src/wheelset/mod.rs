//! The wheelset at the contact: its vertical receptance, and how it turns.

mod rigid_mass;
mod rotation;

pub use rigid_mass::RigidMass;
pub use rotation::{
    ConstantCreepage, ConstantTangentialForce, RigidInertia, RotationRatio, WheelRotation,
};
