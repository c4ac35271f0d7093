//! The wheelset of a case.

use std::f64::consts::TAU;
use std::sync::Arc;

use riffel::wheelset::{
    ContactReceptances, FlexibleWheelset, MeasuredWheelset, ModalWheelset, RememberingWheelset, RigidWheelset,
    Wheelset, WheelsetWithHubs,
};
use riffel_keys::{Message, fixed, say};

/// A wheelset of any of the models of a case.
#[derive(Debug, Clone)]
pub enum CaseWheelset {
    /// One rigid body.
    Rigid(RigidWheelset),
    /// A flexible axle with rigid discs.
    Flexible(Box<FlexibleWheelset>),
    /// Elastic modes from a file, and the rigid body that they deform.
    Modal(Box<ModalWheelset>, RigidWheelset),
    /// Receptances from a file.
    Measured(MeasuredWheelset),
}

impl Wheelset for CaseWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        match self {
            Self::Rigid(wheelset) => wheelset.receptances(angular_frequency),
            Self::Flexible(wheelset) => wheelset.receptances(angular_frequency),
            Self::Modal(wheelset, _) => wheelset.receptances(angular_frequency),
            Self::Measured(wheelset) => wheelset.receptances(angular_frequency),
        }
    }

    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        match self {
            Self::Rigid(wheelset) => wheelset.free_at_contacts(),
            Self::Flexible(wheelset) => wheelset.free_at_contacts(),
            Self::Modal(wheelset, _) => wheelset.free_at_contacts(),
            Self::Measured(wheelset) => wheelset.free_at_contacts(),
        }
    }
}

impl CaseWheelset {
    /// The wheelset with the receptances of its hubs; `None` if its model does not describe them.
    pub(crate) fn with_hubs(&self) -> Option<Arc<dyn WheelsetWithHubs>> {
        match self {
            Self::Rigid(wheelset) => Some(Arc::new(*wheelset)),
            Self::Flexible(wheelset) => Some(Arc::new((**wheelset).clone())),
            Self::Modal(..) | Self::Measured(_) => None,
        }
    }

    /// Lowest and highest frequency \[Hz\] at which it is known; from zero to infinity but for a measured one.
    pub fn frequency_range(&self) -> (f64, f64) {
        match self {
            Self::Measured(wheelset) => {
                let (lowest, highest) = wheelset.frequency_range();
                (lowest / TAU, highest / TAU)
            }
            Self::Rigid(_) | Self::Flexible(_) | Self::Modal(..) => (0.0, f64::INFINITY),
        }
    }

    /// Mass \[kg\] that the vertical motion of one contact feels of the body without suspension and bending, where the other wheel
    /// is free: 1/(1/M + s²/J_x), with s \[m\] the half distance of the contacts. None of a measured one.
    pub(crate) fn mass_at_contact(&self, half_spacing: f64) -> Option<f64> {
        let body = match self {
            Self::Rigid(rigid) | Self::Modal(_, rigid) => rigid.body(),
            Self::Flexible(flexible) => flexible.rigid_body(),
            Self::Measured(_) => return None,
        };
        Some((body.mass.recip() + half_spacing.powi(2) / body.roll_inertia).recip())
    }

    /// A sentence where frequencies up to one \[Hz\] leave those that the modes of a file describe.
    pub(crate) fn beyond_its_modes(&self, highest: f64) -> Option<Message> {
        let Self::Modal(modal, _) = self else {
            return None;
        };
        let last = modal.modes().iter().map(|mode| mode.angular_frequency / TAU).fold(0.0, f64::max);
        // Without them the compliance of the modes left out is missing, which is some of the whole from there on.
        let up_to = if modal.has_residual() { last } else { 0.5 * last };
        (highest > up_to).then(|| say!(modes_of_wheelset_end, up_to = fixed(up_to, 0), highest = fixed(highest, 0)))
    }
}

/// A wheelset, and beside it, where cases share their parts, the same with a memory of what it answered.
pub(crate) type BuiltWheelset = (Arc<CaseWheelset>, Option<Arc<RememberingWheelset>>);
