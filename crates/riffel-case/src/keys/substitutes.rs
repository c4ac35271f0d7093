//! Structures that are given with the case, not by it.

use std::sync::Arc;

use riffel::receptance::{MeasuredReceptance, TrackMemory};
use riffel::{Receptance, RollingContact};
use riffel_keys::{CaseError, Message};
use riffel_rail::response::{self, UniversalFunction};

use crate::curve::SharedProfiles;
use crate::file::MeasuredWear;
use crate::parts::shared::Shared;
use crate::parts::track::Origin;
use crate::parts::wheelset::BuiltWheelset;
use crate::parts::window::Window;

/// A vertical receptance that takes the place of the model of the case: a finite-element track, a flexible
/// wheelset, a measurement in memory.
#[derive(Clone)]
pub struct SubstituteReceptance {
    pub(crate) receptance: Arc<dyn Receptance>,
    /// Table of the receptance, if it is one.
    pub(crate) table: Option<Arc<MeasuredReceptance>>,
    pub(crate) remarks: Vec<Message>,
}

impl SubstituteReceptance {
    /// Any receptance \[m/N\], time factor exp(+iωt), downward.
    pub fn new(receptance: Arc<dyn Receptance>) -> Self {
        Self { receptance, table: None, remarks: Vec::new() }
    }

    /// A frequency response that another program read from a universal file. Displacement, velocity or acceleration
    /// per force; what stands at 0 Hz is left out.
    ///
    /// # Errors
    /// [`CaseError::Data`] for another function, a unit that does not fit, or frequencies with gaps.
    pub fn of_universal(function: &UniversalFunction) -> Result<Self, CaseError> {
        let measured = response::of_universal(function).map_err(|error| CaseError::Data {
            path: function.title.clone().into(),
            line: None,
            message: error.message,
            help: None,
        })?;
        Ok(Self::of_table(measured.receptance, measured.remarks))
    }

    /// A table, with remarks where it is not passive, delayed or of two hits.
    ///
    /// # Errors
    /// The sentence for one with the wrong signs.
    pub fn measured(receptance: MeasuredReceptance) -> Result<Self, Message> {
        let remarks = response::doubts(&receptance, response::Remedy::Values)?;
        Ok(Self::of_table(receptance, remarks))
    }

    /// A table that was measured on a rail, with remarks as of [`measured`](Self::measured) and where it is not like a rail.
    ///
    /// # Errors
    /// The sentence for one that no rail has.
    pub fn measured_on_rail(receptance: MeasuredReceptance) -> Result<Self, Message> {
        let remarks = response::doubts_about_rail(&receptance)?;
        Ok(Self::of_table(receptance, remarks))
    }

    fn of_table(receptance: MeasuredReceptance, remarks: Vec<Message>) -> Self {
        let table = Arc::new(receptance);
        Self { receptance: table.clone(), table: Some(table), remarks }
    }

    /// Where it comes from.
    pub(crate) fn origin(&self) -> Origin {
        self.table.clone().map_or(Origin::Given, Origin::Measured)
    }
}

/// A structure of a case that a receptance may take the place of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CaseStructure {
    /// The track.
    Track,
    /// The wheel.
    Wheel,
}

/// What goes with the keys of a case.
#[derive(Clone, Default)]
pub(crate) struct Substitutes {
    /// In place of the model of the track.
    pub(crate) track: Option<SubstituteReceptance>,
    /// In place of the wheel.
    pub(crate) wheel: Option<SubstituteReceptance>,
    /// The wear coefficient \[kg/J\] that gives the wear measured, where that is still what the case has.
    pub(crate) wear: Option<(MeasuredWear, f64)>,
    /// Tables of the exact contact that other cases have, too: each costs a second.
    pub(crate) tables: Shared<Arc<dyn RollingContact>>,
    /// Wheelsets that other cases have, too: of a vehicle in its curve every wheel at every speed has a case of its own.
    pub(crate) wheelsets: Shared<BuiltWheelset>,
    /// Memories of tracks that differ from those of other cases in their points of contact alone.
    pub(crate) tracks: Shared<Arc<TrackMemory>>,
    /// Profiles on their track that other cases have, too.
    pub(crate) profiles: SharedProfiles,
    /// Whether it is one of many cases, without the remarks that cost time.
    pub(crate) quick: bool,
}

impl Substitutes {
    /// Substitutes for a case in another window: a vehicle and a variant keep the wear coefficient of their case, another case has its
    /// own.
    #[must_use]
    pub(crate) fn within(mut self, window: Window) -> Self {
        self.wear.take_if(|_| window == Window::Map);
        self
    }
}
