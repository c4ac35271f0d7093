//! The stages of a run, as documents hold them.

use riffel::roughness::level;
use serde::Serialize;

use super::Stage;
use crate::simulate::Extremes;

/// Stages of the run, quantity by quantity.
#[derive(Serialize)]
pub(super) struct Stages {
    /// Wheels so far.
    pub(super) passages: Vec<u64>,
    /// Depth worn off everywhere.
    pub(super) mean_depth_m: Vec<f64>,
    /// Level of the waves that fit between two supports, d/n; left out on an even track.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) support_pattern_level_db: Option<Vec<f64>>,
    /// Share of the time without contact of the passage before; none before any.
    pub(super) contact_loss_fraction: Vec<Option<f64>>,
    /// Least normal force of that passage.
    pub(super) minimum_normal_force_n: Vec<Option<f64>>,
    /// Largest normal force of that passage.
    pub(super) maximum_normal_force_n: Vec<Option<f64>>,
}

impl Stages {
    pub(super) fn new(stages: &[Stage]) -> Self {
        let extremes = |of: fn(&Extremes) -> f64| {
            let each = stages.iter().map(|stage| stage.extremes.as_ref().map(of));
            each.collect()
        };
        Self {
            passages: stages.iter().map(|stage| stage.passages).collect(),
            mean_depth_m: stages.iter().map(|stage| stage.mean_depth_m).collect(),
            support_pattern_level_db: stages.iter().map(|stage| stage.bay_mean_square_m2.map(level)).collect(),
            contact_loss_fraction: extremes(|passage| passage.contact_loss_fraction),
            minimum_normal_force_n: extremes(|passage| passage.minimum_normal_force_n),
            maximum_normal_force_n: extremes(|passage| passage.maximum_normal_force_n),
        }
    }
}
