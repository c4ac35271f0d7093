//! Growth over a sleeper bay.

use std::sync::Arc;

use num_complex::Complex64;
use riffel_numerics::simpson::simpson;

use super::{Axis, GrowthMap, Ridge};
use crate::feedback::{Loop, LoopState};
use crate::receptance::{CrossReceptance, Uncoupled};

/// Nodes of Simpson's rule over half a bay, a support and mid-span among them.
const NODES: usize = 17;

/// The loop on discrete supports, where the receptance under the wheel depends on its place in the
/// bay between two of them.
///
/// Growth is taken at each place as if the wheel stayed there: quasi-static in position. That holds
/// for wavelengths much shorter than the bay; what the changing stiffness itself excites, once in
/// each bay, is left out. The mean of the growth rate over the bay is the growth of a long profile
/// of one wavelength, of which every part is worn at its own rate but at one phase.
///
/// Method of the mean: Simpson's rule with 17 places from a support to mid-span, to which the bay is
/// symmetric; 1e-4 relative, 1e-3 at the pinned-pinned resonance of a rail with a loss factor of 0.01,
/// see the test `bay_mean`.
#[derive(Clone)]
pub struct Bay {
    feedback: Loop,
    track: Arc<dyn CrossReceptance>,
    spacing: f64,
}

impl Bay {
    /// The loop on a track, which is the vertical one of a loop on all axes; `None` if supports are not discrete.
    pub fn new(feedback: impl Into<Loop>, track: Arc<dyn CrossReceptance>) -> Option<Self> {
        Some(Self { spacing: track.support_spacing()?, feedback: feedback.into(), track })
    }

    /// Distance of the supports \[m\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// The loop with the wheel at a distance from a support \[m\].
    pub fn at(&self, position: f64) -> Loop {
        let feedback = self.feedback.clone();
        match feedback.is_along_one_axis() {
            // Its track is a receptance, which knows no places.
            true => feedback.with_track(Arc::new(Uncoupled {
                vertical: Some(self.track.under_load_at(position)),
                ..Uncoupled::default()
            })),
            false => feedback.at_position(position),
        }
    }

    /// The state of the loop at equal steps from one support to the next, both included, with the
    /// position of each \[m\]; two points or more.
    pub fn states(&self, wavelength: f64, speed: f64, points: usize) -> Vec<(f64, LoopState)> {
        (0..points)
            .map(|index| {
                let position = self.spacing * index as f64 / (points - 1) as f64;
                (position, self.at(position).at(wavelength, speed))
            })
            .collect()
    }

    /// The loop at each place of the mean over the bay, with its weight; the weights sum to one.
    pub fn places(&self) -> Vec<(Loop, f64)> {
        self.nodes().map(|(position, weight)| (self.at(position), weight)).collect()
    }

    /// Mean of Ŵ₁ over the bay.
    pub fn mean_normalized_dissipation(&self, wavelength: f64, speed: f64) -> Complex64 {
        self.nodes()
            .map(|(position, weight)| {
                let feedback = self.at(position);
                let normalized = feedback.normalized_dissipation();
                weight * normalized(wavelength, speed)
            })
            .sum()
    }

    /// Maps over a support, in mid-span and of the mean over the bay.
    ///
    /// `progress` is called as by [`GrowthMap::compute`], for the rows of all places.
    pub fn maps(&self, wavelength: Axis, speed: Axis, progress: impl Fn(usize) + Sync) -> BayMaps {
        let map = |position: f64| GrowthMap::compute(self.at(position), wavelength, speed, &progress);
        let over_support = map(0.0);
        let mid_span = map(0.5 * self.spacing);
        let mut mean = over_support.scaled(0.0);
        for (index, (position, weight)) in self.nodes().enumerate() {
            match index {
                0 => mean.add(&over_support, weight),
                _ if index == NODES - 1 => mean.add(&mid_span, weight),
                _ => mean.add(&map(position), weight),
            }
        }
        BayMaps { over_support, mid_span, mean }
    }

    /// The ridge of the mean over a window of wavelengths.
    pub fn ridge(&self, mean: &GrowthMap, window: Axis) -> Ridge {
        Ridge::refined_from(mean, window, |wavelength, speed| self.mean_normalized_dissipation(wavelength, speed))
    }

    /// Number of maps behind [`maps`](Self::maps).
    pub const fn map_count() -> usize {
        NODES
    }

    /// Places from a support to mid-span \[m\] with their weights, which sum to one.
    fn nodes(&self) -> impl Iterator<Item = (f64, f64)> {
        let half = 0.5 * self.spacing;
        simpson(NODES - 1).map(move |(share, weight)| (half * share, weight))
    }
}

/// Growth maps at the places of a bay that matter.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct BayMaps {
    /// Wheel over a support.
    pub over_support: GrowthMap,
    /// Wheel halfway between two.
    pub mid_span: GrowthMap,
    /// Mean over the bay.
    pub mean: GrowthMap,
}
