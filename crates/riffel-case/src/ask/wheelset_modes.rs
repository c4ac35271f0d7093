//! Natural frequencies of the wheelset of a case.

use std::f64::consts::TAU;

use riffel::wheelset::{ModeName, NaturalMode, RigidWheelset};
use riffel_keys::CaseError;

use crate::Case;
use crate::parts::wheelset::CaseWheelset;

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

/// Natural frequencies of a wheelset of the case up to one \[Hz\], lowest first; none of a measured one.
///
/// # Errors
/// [`CaseError`] where they cannot be told apart so high.
pub fn wheelset_modes(case: &Case, wheelset: &CaseWheelset, highest: f64) -> Result<Vec<WheelsetMode>, CaseError> {
    match wheelset {
        CaseWheelset::Rigid(rigid) => Ok(rigid_modes(rigid, highest)),
        CaseWheelset::Modal(modal, rigid) => {
            let mut modes = rigid_modes(rigid, highest);
            let elastic = modal.modes().iter().zip(modal.mode_names());
            let elastic =
                elastic.map(|(mode, name)| WheelsetMode { frequency: mode.angular_frequency / TAU, name, shape: None });
            modes.extend(elastic.filter(|mode| mode.frequency <= highest));
            modes.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
            Ok(modes)
        }
        // They are the peaks of its receptances, which it shows.
        CaseWheelset::Measured(_) => Ok(Vec::new()),
        CaseWheelset::Flexible(flexible) => {
            let modes = flexible.natural_modes(TAU * highest);
            let modes = case.keys.physics("wheelset.axle", modes)?;
            let modes = modes.into_iter().map(|mode| WheelsetMode {
                frequency: mode.angular_frequency / TAU,
                name: mode.name,
                shape: Some(mode),
            });
            Ok(modes.collect())
        }
    }
}

/// A rigid wheelset on its suspension.
fn rigid_modes(rigid: &RigidWheelset, highest: f64) -> Vec<WheelsetMode> {
    let frequencies = rigid.natural_frequencies().into_iter();
    let modes = frequencies.map(|(angular_frequency, motion)| WheelsetMode {
        frequency: angular_frequency / TAU,
        name: ModeName::RigidBody(motion),
        shape: None,
    });
    modes.filter(|mode| mode.frequency <= highest).collect()
}
