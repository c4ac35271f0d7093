//! The few numbers by which wear of wheels and rails is judged.

use riffel_numerics::bisection::bisection;

use super::wear::{depth, tip};
use super::{Profile, ProfileError, ProfileWear, ShapeFault};

/// Below the tread of a wheel, towards the tip, where the flange is measured \[m\].
const FLANGE_MEASURE: f64 = 0.010;
/// Before the tip where qR is measured \[m\].
const BEFORE_TIP: f64 = 0.002;

/// Dimensions of a wheel in its own coordinates, as EN 15313 defines them.
///
/// The tread is that on the datum circle at x = 0; flanges are measured 10 mm beyond it. A worn tread raises the height of the flange, a
/// worn flange lowers its thickness, and a small qR is a steep flange. What lies in a gap of the points is none. Source: EN 15313; the distances of 2, 70 and 10 mm as
/// Greenwood Engineering publishes them for its devices.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WheelDimensions {
    /// Height of the flange Sh \[m\], from the datum circle to the tip.
    pub flange_height: Option<f64>,
    /// Thickness of the flange Sd \[m\], from the flange back to its flank 10 mm beyond the datum circle.
    pub flange_thickness: Option<f64>,
    /// qR \[m\], across the track from there to the flank 2 mm before the tip.
    pub flange_gradient: Option<f64>,
}

impl WheelDimensions {
    /// The dimensions of a wheel whose flange back lies at `flange_back_position` \[m\] in its coordinates.
    ///
    /// # Errors
    /// [`ProfileError::Shape`] where the datum circle or the flange is not on the profile.
    pub fn new(wheel: &Profile, flange_back_position: f64) -> Result<Self, ProfileError> {
        let tip = tip(wheel, ShapeFault::NoTip)?;
        let datum = wheel.at(0.0).ok_or(ProfileError::Shape(ShapeFault::NoDatumCircle))?;
        // Between the tip and the datum circle the profile rises.
        let flank = |height: f64| {
            if height < tip.height || height > datum.height || tip.x > 0.0 {
                return Err(ProfileError::Shape(ShapeFault::NoFlank));
            }
            let is_above = |x: f64| wheel.at(x).is_none_or(|point| point.height >= height);
            let [low, high] = bisection([tip.x, 0.0], 0.0, is_above);
            Ok(0.5 * (low + high))
        };
        let [measure, steep] = [datum.height - FLANGE_MEASURE, tip.height + BEFORE_TIP];
        let (flank_at_measure, steep_flank) = (flank(measure)?, flank(steep)?);
        let measured = |places: &[[f64; 2]], value: f64| {
            let all = places.iter().all(|place| wheel.is_measured(*place));
            all.then_some(value)
        };
        let (tip, datum) = ([tip.x, tip.height], [0.0, datum.height]);
        let (measure, steep) = ([flank_at_measure, measure], [steep_flank, steep]);
        Ok(Self {
            flange_height: measured(&[tip, datum], datum[1] - tip[1]),
            flange_thickness: measured(&[datum, measure], measure[0] - flange_back_position),
            flange_gradient: measured(&[tip, datum, measure, steep], measure[0] - steep[0]),
        })
    }

    /// Wear of the tread against a nominal wheel \[m\], by which the flange is higher.
    pub fn tread_wear(&self, nominal: &Self) -> Option<f64> {
        Some(self.flange_height? - nominal.flange_height?)
    }
}

/// Wear of a rail at three places of its nominal profile; `None` if nothing is measured, as in a gap of the points.
///
/// Devices have a depth of their own for W2 (MiniProf 12 mm by default, as Greenwood Engineering publishes): the depth is told with it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RailWear {
    /// W1 \[m\], downward at the crown.
    pub vertical: Option<f64>,
    /// W2 \[m\], across the track at the gauge face, `gauge_height` below the nominal crown.
    pub lateral: Option<f64>,
    /// W3 \[m\], under 45° at the gauge corner.
    pub diagonal: Option<f64>,
}

impl RailWear {
    /// The wear of a rail that was laid on its nominal profile, at the gauge face `gauge_height` \[m\] below the crown of the latter.
    pub fn new(wear: &ProfileWear, nominal: &Profile, gauge_height: f64) -> Self {
        let crown = nominal.crown();
        let face = crown.height - gauge_height;
        let corner = wear
            .points
            .iter()
            .map(|point| point.nominal)
            .filter(|point| point.x < crown.x)
            .min_by(|one, other| (one.slope - 1.0).abs().total_cmp(&(other.slope - 1.0).abs()));
        Self {
            vertical: wear
                .measured
                .at(crown.x)
                .filter(|point| wear.measured.is_measured([point.x, point.height]))
                .map(|point| crown.height - point.height),
            lateral: (wear.measured.inner_face(face))
                .filter(|across| wear.measured.is_measured([*across, face]))
                .zip(nominal.inner_face(face))
                .map(|(measured, nominal)| measured - nominal),
            diagonal: corner.and_then(|corner| depth(&wear.measured, &corner, false)),
        }
    }
}
