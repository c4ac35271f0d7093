//! The wheelset at the contact: how it answers the forces there, along the rail, across it and downward.
//!
//! One wheel alone is a [`RigidMass`] downward and a [`RigidInertia`] along the rail; a [`SprungMass`]
//! is a vehicle on its spring. A [`Wheelset`] joins two
//! wheels on both rails: [`RigidWheelset`], [`FlexibleWheelset`], [`ModalWheelset`], [`MeasuredWheelset`].

mod consistency;
mod flexible;
mod free_motion;
mod measured;
mod modal;
mod modal_names;
mod motion;
mod port;
mod remembering;
mod rigid;
mod rigid_inertia;
mod rigid_mass;
mod rigid_motions;
mod section;
mod sprung_mass;
mod suspension;

pub use consistency::{passivity_error, reciprocity_error};
pub use flexible::{
    Axle, BendingPlane, CoupledInertia, Disc, DiscMotion, FlexibleWheelset, ModeName, NaturalMode, RigidMotion,
    SectionMotion, Segment,
};
pub use measured::{MeasuredEntry, MeasuredWheelset, Violation};
pub use modal::{ElasticMode, ModalWheelset};
pub use motion::Motion;
pub use port::{ContactReceptances, HubReceptances, Port, Wheelset, WheelsetWithHubs};
pub use remembering::RememberingWheelset;
pub use rigid::{RigidBody, RigidWheelset};
pub use rigid_inertia::RigidInertia;
pub use rigid_mass::RigidMass;
pub use section::ContactGeometry;
pub use sprung_mass::SprungMass;
pub use suspension::Suspension;
