//! Where the mean state of a case comes from.

use std::sync::Arc;

use riffel_keys::Message;

use crate::curve::Equilibrium;
use crate::file::FromCurve;
use crate::keys::checked_keys::CheckedKeys;

/// Where the mean state comes from.
#[derive(Clone)]
pub(crate) enum Mean {
    /// The keys.
    Given,
    /// A wheel of a vehicle balanced in its curve, for all that the keys do not say.
    OfWheel(Arc<MeanOfWheel>),
}

/// What a wheel of a vehicle in its curve gave the keys of a case, and what there is to say of it.
pub(crate) struct MeanOfWheel {
    pub(crate) equilibrium: Arc<Equilibrium>,
    /// The wheel.
    pub(crate) from: FromCurve,
    pub(crate) remarks: Vec<Message>,
    /// |Q|/μP of its contact, where the case has no value of its own.
    pub(crate) tractive_ratio: Option<f64>,
    /// Where its contact runs on the rail: from the axis of the profile to the field side \[m\].
    pub(crate) outward: Option<f64>,
}

impl Mean {
    /// The wheel, if the keys do not say all.
    pub(crate) fn wheel(&self) -> Option<&MeanOfWheel> {
        match self {
            Self::Given => None,
            Self::OfWheel(wheel) => Some(wheel),
        }
    }
}

impl CheckedKeys {
    /// Mass of an axle of the bogie \[kg\], whose wheels share its load unevenly in a curve; `None` without a bogie, or if the case has
    /// a load of its own.
    pub(crate) fn axle_mass(&self) -> Option<f64> {
        if self.text.keys.has("contact.normal_load") {
            return None;
        }
        let bogie = self.mean.wheel()?.equilibrium.curving.file.bogie.as_ref()?;
        Some(bogie.mass_per_axle.si())
    }
}
