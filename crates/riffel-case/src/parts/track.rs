//! The track of a case.

use std::sync::Arc;

use riffel::growth::Bay;
use riffel::receptance::{CrossReceptance, MeasuredReceptance, Resonance, ResonanceKind, Support};
use riffel::{Loop, Receptance};
use riffel_keys::Message;

/// Where the receptance of a track comes from.
#[derive(Clone)]
pub enum Origin {
    /// A model of rail and supports.
    Model,
    /// A table of lines.
    Measured(Arc<MeasuredReceptance>),
    /// A function that the caller gives.
    Given,
}

/// A track in one direction, and what its model knows of itself.
#[derive(Clone)]
pub struct Track {
    /// Receptance under the load, which a loop takes.
    pub receptance: Arc<dyn Receptance>,
    /// Where it comes from.
    pub origin: Origin,
    /// The track as one that answers at one place to a force at another; none for a load that moves
    /// and for a measurement.
    pub structure: Option<Arc<dyn CrossReceptance>>,
    /// What carries the rail, per metre; none for a free rail and for a measurement.
    pub support: Option<Support>,
    /// Mass of the rail per length \[kg/m\]; none for a measurement.
    pub rail_mass: Option<f64>,
    /// Angular frequency \[rad/s\] at which the rail bends with nodes at its supports; `None` if the
    /// model does not know it: without discrete supports, or without the shear of the rail.
    pub pinned_pinned: Option<f64>,
    /// What the reader of the case should know.
    pub remarks: Vec<Message>,
}

impl Track {
    /// Distance of the supports \[m\], where they are discrete.
    pub fn support_spacing(&self) -> Option<f64> {
        self.structure.as_ref()?.support_spacing()
    }

    /// A loop on this track at every place of its wheel that counts for a long profile, with weights that sum to one: over a
    /// bay where supports are discrete, else one.
    pub fn places(&self, feedback: &Loop) -> Vec<(Loop, f64)> {
        let structure = self.structure.clone();
        structure
            .and_then(|track| Bay::new(feedback, track))
            .map_or_else(|| vec![(feedback.clone(), 1.0)], |bay| bay.places())
    }

    /// Receptance under a load at a distance from a support \[m\]; none without discrete supports.
    pub fn at(&self, position: f64) -> Option<Arc<dyn Receptance>> {
        self.support_spacing()?;
        Some(self.structure.as_ref()?.under_load_at(position))
    }

    /// The resonances of a model that have a peak in the receptance of the rail, lowest first: full-track and
    /// rail on pad over a support, pinned-pinned in the middle of a bay.
    ///
    /// A peak belongs to the frequency that theory gives it, up to a factor 1.6, or 1.1 for
    /// pinned-pinned.
    pub fn resonances(&self) -> Vec<Resonance> {
        let over_support = self.at(0.0).unwrap_or_else(|| self.receptance.clone());
        let mut resonances = Vec::new();
        if let (Some(support), Some(rail_mass)) = (self.support, self.rail_mass) {
            let kinds = match support {
                Support::OneLayer { .. } => &[ResonanceKind::RailOnPad][..],
                Support::TwoLayer { .. } => &[ResonanceKind::FullTrack, ResonanceKind::RailOnPad],
            };
            let frequencies = support.cut_on_frequencies(rail_mass);
            resonances.extend(
                kinds
                    .iter()
                    .zip(frequencies)
                    .filter_map(|(&kind, cut_on)| Resonance::near(&*over_support, kind, cut_on, 1.6)),
            );
        }
        let mid_span = self.support_spacing().and_then(|d| self.at(0.5 * d));
        if let (Some(mid_span), Some(expected)) = (mid_span, self.pinned_pinned) {
            let kind = ResonanceKind::PinnedPinned;
            resonances.extend(Resonance::near(&*mid_span, kind, expected, 1.1));
        }
        resonances
    }
}

/// Lowest and highest frequency \[Hz\] at which a receptance is known.
pub(crate) fn known_range(receptance: &dyn Receptance) -> (f64, f64) {
    let (low, high) = receptance.frequency_range();
    (low / std::f64::consts::TAU, high / std::f64::consts::TAU)
}
