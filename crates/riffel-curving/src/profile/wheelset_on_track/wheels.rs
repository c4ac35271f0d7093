//! The two wheels of a wheelset, sampled across.

use std::sync::Arc;

use crate::profile::{Profile, ProfileError, ProfilePoint, ShapeFault};

/// Distance of the samples of a wheel \[m\] among which minima of the gap are looked for.
const WHEEL_STEP: f64 = 2e-4;

/// The wheels of a rigid wheelset.
#[derive(Debug, Clone)]
pub struct Wheels {
    /// Left, right; both as right wheels.
    pub(super) wheels: [Arc<SampledWheel>; 2],
    /// Distance of the origins of the profiles from the middle of the axle \[m\].
    pub(super) half_spacing: f64,
}

#[derive(Debug)]
pub(in crate::profile) struct SampledWheel {
    pub(in crate::profile) profile: Profile,
    pub(in crate::profile) rolling_radius: f64,
    pub(in crate::profile) samples: Vec<ProfilePoint>,
}

impl Wheels {
    /// Wheels of two profiles, left and right, with their radii on the datum circle \[m\]; the flange backs lie
    /// `flange_back_distance` \[m\] apart and at `flange_back_position` \[m\] in the coordinates of a wheel.
    ///
    /// # Errors
    /// [`ProfileError`] for a wheel without a flange at x below zero, as a mirrored one, and for one whose datum circle
    /// is not on the profile.
    pub fn new(
        profiles: [&Profile; 2],
        rolling_radii: [f64; 2],
        flange_back_distance: f64,
        flange_back_position: f64,
    ) -> Result<Self, ProfileError> {
        let sampled = |index: usize| -> Result<Arc<SampledWheel>, ProfileError> {
            let profile: &Profile = profiles[index];
            check_wheel(profile)?;
            Ok(Arc::new(SampledWheel {
                rolling_radius: rolling_radii[index],
                samples: profile.sampled(WHEEL_STEP),
                profile: profile.clone(),
            }))
        };
        Ok(Self { wheels: [sampled(0)?, sampled(1)?], half_spacing: 0.5 * flange_back_distance - flange_back_position })
    }

    /// Distance of the datum circles \[m\].
    pub fn spacing(&self) -> f64 {
        2.0 * self.half_spacing
    }
}

fn check_wheel(profile: &Profile) -> Result<(), ProfileError> {
    let origin = profile.at(0.0).ok_or(ProfileError::Shape(ShapeFault::NoDatumCircle))?;
    // A flange hangs 25 mm or more below the datum circle; trams have 15.
    const LEAST_FLANGE: f64 = 5e-3;
    let samples = profile.sampled(WHEEL_STEP);
    let lowest = |side: f64| {
        let there = samples.iter().filter(|point| point.x * side > 0.0);
        there.fold(origin.height, |least: f64, point| least.min(point.height))
    };
    let highest = samples.iter().fold(origin.height, |most: f64, point| most.max(point.height));
    let (inside, outside) = (origin.height - lowest(-1.0), origin.height - lowest(1.0));
    if inside > LEAST_FLANGE && inside > outside {
        return Ok(());
    }
    let why = if outside > LEAST_FLANGE {
        ShapeFault::Mirrored
    } else if highest - origin.height > LEAST_FLANGE {
        ShapeFault::UpsideDown
    } else {
        ShapeFault::NoFlange
    };
    Err(ProfileError::Shape(why))
}
