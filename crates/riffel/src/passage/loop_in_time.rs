//! A loop of either kind in time.

use super::along_profile::felt;
use super::{GeneralPassage, Passage, PassageModel, Settled, Sinusoid};
use crate::Error;
use crate::contact::ContactFilter;
use crate::roughness::Profile;

/// A loop in time: of one wheel and longitudinal creepage, or of any number of contacts on all axes.
#[derive(Clone)]
pub enum LoopInTime {
    /// One wheel along one axis, which has contacts that answer late.
    Longitudinal(Box<PassageModel>),
    /// Any number of contacts on all axes.
    General(Box<GeneralPassage>),
}

impl LoopInTime {
    /// The settled state of every contact over a sinusoid, in `steps` steps to a wave, the first wheel first.
    ///
    /// # Errors
    /// Those of [`PassageModel::settle`] and [`GeneralPassage::settle`].
    pub fn settle(&self, profile: Sinusoid, steps: usize) -> Result<Vec<Settled>, Error> {
        match self {
            Self::Longitudinal(model) => Ok(vec![model.settle(profile, steps)?]),
            Self::General(model) => model.settle(profile, steps),
        }
    }

    /// All wheels along a profile, in steps of at most the length given \[m\].
    ///
    /// # Errors
    /// Those of [`PassageModel::pass`] and [`GeneralPassage::pass`].
    pub fn pass(&self, profile: &Profile, largest_step: f64) -> Result<Passage, Error> {
        match self {
            Self::Longitudinal(model) => model.pass(profile, largest_step),
            Self::General(model) => model.pass(profile, largest_step),
        }
    }

    /// Distance after which the rail is forgotten \[m\].
    ///
    /// # Errors
    /// Those of [`PassageModel::memory`] and [`GeneralPassage::memory`].
    pub fn memory(&self) -> Result<f64, Error> {
        match self {
            Self::Longitudinal(model) => model.memory(),
            Self::General(model) => model.memory(),
        }
    }

    /// What the patch leaves of a wave \[m\]: its contact filter, one without.
    pub fn felt(&self, wavelength: f64) -> f64 {
        felt(self.contact_filter(), wavelength)
    }

    /// The mean of the profile over the patch that wheels feel in the place of its height, if any.
    pub fn contact_filter(&self) -> Option<ContactFilter> {
        match self {
            Self::Longitudinal(model) => model.contact_filter,
            Self::General(model) => model.contact_filter,
        }
    }

    /// With another contact filter, or with none.
    pub fn set_contact_filter(&mut self, filter: Option<ContactFilter>) {
        match self {
            Self::Longitudinal(model) => model.contact_filter = filter,
            Self::General(model) => model.contact_filter = filter,
        }
    }

    /// Speed V \[m/s\].
    pub fn speed(&self) -> f64 {
        match self {
            Self::Longitudinal(model) => model.speed,
            Self::General(model) => model.speed,
        }
    }

    /// Distance of the supports \[m\] that pass under the wheels; none on a track that is even.
    pub fn support_spacing(&self) -> Option<f64> {
        match self {
            Self::Longitudinal(model) => model.track.support_spacing(),
            Self::General(model) => model.structures.support_spacing(),
        }
    }

    /// Mean square of the relative error of the track in time, with the wheels of a loop on all axes.
    pub fn share_cut(&self) -> f64 {
        match self {
            Self::Longitudinal(model) => model.track.share_cut(),
            Self::General(model) => model.structures.share_cut(),
        }
    }

    /// Numbers and places \[m\] of the contacts on the rail under study.
    pub(super) fn on_rail_under_study(&self) -> Vec<(usize, f64)> {
        match self {
            Self::Longitudinal(_) => vec![(0, 0.0)],
            Self::General(model) => {
                let contacts = model.contacts.iter().enumerate();
                contacts
                    .filter(|(_, contact)| contact.rail == model.contacts[0].rail)
                    .map(|(index, contact)| (index, contact.along))
                    .collect()
            }
        }
    }
}

impl From<PassageModel> for LoopInTime {
    fn from(model: PassageModel) -> Self {
        Self::Longitudinal(Box::new(model))
    }
}

impl From<GeneralPassage> for LoopInTime {
    fn from(model: GeneralPassage) -> Self {
        Self::General(Box::new(model))
    }
}
