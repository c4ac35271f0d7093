//! The two rails of a track, placed in its plane.

use std::sync::Arc;

use riffel::Rail;

use crate::profile::{Profile, ProfileError, ShapeFault};

/// Distance of the samples of a rail \[m\].
const RAIL_STEP: f64 = 2e-5;

/// Both rails in their places.
#[derive(Debug, Clone)]
pub struct Track {
    /// Left, right; both as right rails: x across the track from its middle outward, height above the crown.
    pub(super) rails: [Arc<PlacedRail>; 2],
}

#[derive(Debug)]
pub(super) struct PlacedRail {
    pub(super) profile: Profile,
    /// Heights a step apart from the inner end.
    heights: Vec<f64>,
}

impl PlacedRail {
    pub(super) fn new(profile: Profile) -> Self {
        let [low, high] = profile.range();
        let count = ((high - low) / RAIL_STEP) as usize;
        let heights = (0..=count).filter_map(|index| profile.at(low + RAIL_STEP * index as f64));
        Self { heights: heights.map(|point| point.height).collect(), profile }
    }

    /// Height between samples; none beside the rail.
    pub(super) fn height(&self, x: f64) -> Option<f64> {
        let place = (x - self.profile.range()[0]) / RAIL_STEP;
        if place < 0.0 || place.is_nan() {
            return None;
        }
        let index = place as usize;
        let [one, other] = self.heights.get(index..index + 2)?.try_into().ok()?;
        Some(one + (place - index as f64) * (other - one))
    }
}

impl Track {
    /// Rails of two profiles, left and right, both drawn as right ones, inclined by tan α towards each other; their inner
    /// faces are `gauge` \[m\] apart `gauge_height` \[m\] below their crowns.
    ///
    /// # Errors
    /// [`ProfileError`] for a rail that ends above the height of the gauge or is drawn upside down, and a gauge that
    /// makes the rails overlap.
    pub fn new(rails: [&Profile; 2], gauge: f64, gauge_height: f64, inclination: f64) -> Result<Self, ProfileError> {
        let [left, right] = rails.map(|rail| placed(rail, gauge, gauge_height, inclination));
        Ok(Self { rails: [Arc::new(left?), Arc::new(right?)] })
    }
}

pub(super) fn placed(
    rail: &Profile,
    gauge: f64,
    gauge_height: f64,
    inclination: f64,
) -> Result<PlacedRail, ProfileError> {
    let turned = rail.turned(inclination.atan());
    let crown = turned.crown();
    let [low, high] = turned.range();
    if crown.x - low < 1e-3 || high - crown.x < 1e-3 {
        return Err(ProfileError::Shape(ShapeFault::CrownAtEnd));
    }
    let inner = turned.inner_face(crown.height - gauge_height).ok_or(ProfileError::GaugeHeight { gauge_height })?;
    if 0.5 * gauge + low - inner <= 0.0 {
        return Err(ProfileError::Gauge { gauge });
    }
    Ok(PlacedRail::new(turned.moved([0.5 * gauge - inner, -crown.height])))
}

pub(super) fn place(rail: Rail) -> usize {
    match rail {
        Rail::Left => 0,
        Rail::Right => 1,
    }
}
