//! The wheelset of a case.

use std::f64::consts::TAU;

use riffel::wheelset::{
    ContactReceptances, FlexibleWheelset, ModeName, NaturalMode, RigidWheelset, Wheelset,
};
use riffel_keys::CaseError;

use crate::Case;

/// A wheelset of any of the models of a case.
#[derive(Debug, Clone)]
pub enum CaseWheelset {
    /// One rigid body.
    Rigid(RigidWheelset),
    /// A flexible axle with rigid discs.
    Flexible(Box<FlexibleWheelset>),
}

impl Wheelset for CaseWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        match self {
            Self::Rigid(wheelset) => wheelset.receptances(angular_frequency),
            Self::Flexible(wheelset) => wheelset.receptances(angular_frequency),
        }
    }
}

/// A natural frequency of a wheelset.
#[derive(Debug, Clone)]
pub struct WheelsetMode {
    /// Without damping \[Hz\].
    pub frequency: f64,
    /// What moves.
    pub name: ModeName,
    /// Its shape, where the axle is elastic.
    pub shape: Option<NaturalMode>,
}

impl Case {
    /// The wheelset; none for a lone wheel.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn wheelset(&self) -> Result<Option<CaseWheelset>, CaseError> {
        let keys = self.keys.general()?.and_then(|keys| keys.wheelset);
        keys.map(|keys| self.keys.wheelset(&keys, self.hertz.rolling_radius()))
            .transpose()
    }

    /// Natural frequencies of a wheelset of the case up to one \[Hz\], lowest first.
    ///
    /// # Errors
    /// [`CaseError`] where they cannot be told apart so high.
    pub fn wheelset_modes(
        &self,
        wheelset: &CaseWheelset,
        highest: f64,
    ) -> Result<Vec<WheelsetMode>, CaseError> {
        match wheelset {
            CaseWheelset::Rigid(rigid) => {
                let frequencies = rigid.natural_frequencies().into_iter();
                let modes = frequencies.map(|(angular_frequency, motion)| WheelsetMode {
                    frequency: angular_frequency / TAU,
                    name: ModeName::RigidBody(motion),
                    shape: None,
                });
                Ok(modes.filter(|mode| mode.frequency <= highest).collect())
            }
            CaseWheelset::Flexible(flexible) => {
                let modes = flexible.natural_modes(TAU * highest);
                let modes = self.keys.physics("wheelset.axle", modes)?;
                let modes = modes.into_iter().map(|mode| WheelsetMode {
                    frequency: mode.angular_frequency / TAU,
                    name: mode.name,
                    shape: Some(mode),
                });
                Ok(modes.collect())
            }
        }
    }
}
