//! The gap between a wheel and its rail about a place of contact.

use std::sync::Arc;

use riffel::Rail;
use riffel::contact::GapStrip;

use super::wheelset_on_track::{SampledWheel, Stand};
use super::{Profile, ProfileError, ProfilePoint, ShapeFault};

/// Gap where the surfaces of one of the bodies end \[m\]: far beyond any approach.
const BEYOND: f64 = 0.05;
/// Most Newton steps to the point of the wheel above a place; three or four are usual.
const MOST_STEPS: usize = 30;
/// Strips of a gap.
const STRIPS: usize = 400;

/// The gap z between the undeformed surfaces of a wheel and its rail that touch, in the contact plane.
///
/// The rail is prismatic, the wheel a surface of revolution with its profile, shifted, yawed and rolled as its wheelset
/// stands. The contact plane touches the rail at the origin; x points along the track, y lies in the plane across it, to
/// the right. z ≥ 0 is the distance of the surfaces along the normal of that plane, zero where they touch.
///
/// Method: no surface is approximated by its curvatures. With the wheel's radius ρ at the profile's coordinate, its
/// points at the distance X along the track have the forward part F = (X + Y sin ψ)/cos ψ and the depth √(ρ² − F²) in the
/// frame of the wheelset, and roll follows yaw; the point above y is found by Newton's method. Accuracy: that of the
/// profiles and rounding, 1e-12 m. Cost: three or four evaluations of the profile a place. Range of validity: inclinations of both surfaces against the contact
/// plane well below 90°, and patches flat enough to have one normal, see [`inclination_over`](Self::inclination_over).
#[derive(Debug, Clone)]
pub struct ContactGap {
    /// The rail in the plane: y outward, height along the normal, the origin in the origin.
    rail: Profile,
    wheel: Arc<SampledWheel>,
    stand: Stand,
    /// Place of the origin: across the track from its middle, outward, and height above the crowns \[m\].
    origin: [f64; 2],
    /// Along the track from the axle's middle \[m\].
    ahead: f64,
    /// Sine and cosine of the inclination of the plane.
    plane: (f64, f64),
    side: f64,
}

/// A point of the wheel in the contact plane.
struct OnWheel {
    y: f64,
    height: f64,
    /// dy by the coordinate of the profile.
    y_slope: f64,
}

impl ContactGap {
    /// The origin is the point of the rail at `place`: along the track from the axle's middle, and across it from its own,
    /// outward \[m\]; none beside the rail. `inclination` is that of the plane \[rad\], of the rail there unless given.
    pub(super) fn new(
        rail: Rail,
        placed: &Profile,
        wheel: Arc<SampledWheel>,
        stand: Stand,
        place: [f64; 2],
        inclination: Option<f64>,
    ) -> Option<Self> {
        let [ahead, across] = place;
        let point = placed.at(across)?;
        let angle = inclination.unwrap_or_else(|| point.slope.atan());
        Some(Self {
            rail: placed.moved([-across, -point.height]).turned(-angle),
            wheel,
            stand,
            origin: [across, point.height],
            ahead,
            plane: angle.sin_cos(),
            side: rail.sign(),
        })
    }

    /// Contact angle γ of the plane \[rad\], positive where the normal force pushes the rail outward.
    pub fn contact_angle(&self) -> f64 {
        self.plane.0.atan2(self.plane.1)
    }

    /// Place of the origin on the track: ahead of the axle's middle, to the right of the track's, below the crowns \[m\].
    pub fn on_track(&self) -> [f64; 3] {
        [self.ahead, self.side * self.origin[0], -self.origin[1]]
    }

    /// Lateral coordinate in the profile of the wheel above the place y \[m\]; none beside the wheel.
    pub fn x_wheel(&self, y: f64) -> Option<f64> {
        self.wheel_above(self.ahead, self.side * y).map(|(x, _)| x)
    }

    /// Distance from the track's middle, outward \[m\], of the rail below the place y \[m\]; none beside the rail.
    pub fn on_rail(&self, y: f64) -> Option<f64> {
        let y = self.side * y;
        let point = self.rail.at(y)?;
        let (sine, cosine) = self.plane;
        Some(self.origin[0] + y * cosine - point.height * sine)
    }

    /// Gap z \[m\] at a place \[m\]; 50 mm where one of the bodies ends.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        let y = self.side * y;
        let rail = self.rail.at(y);
        let wheel = self.wheel_above(self.ahead + x, y);
        match (rail, wheel) {
            (Some(rail), Some((_, wheel))) => wheel.height - rail.height,
            _ => BEYOND,
        }
    }

    /// Depth of the rail below the contact plane \[m\] and its inclination to it \[rad\], positive as
    /// [`contact_angle`](Self::contact_angle), at a place y \[m\]; none beside the rail.
    pub(super) fn below(&self, y: f64) -> Option<(f64, f64)> {
        let point = self.rail.at(self.side * y)?;
        Some((-point.height, point.slope.atan()))
    }

    /// Gap \[m\] along the normal of the rail at a place; 50 mm where one of the bodies ends.
    ///
    /// Method: Newton's with the slope of the rail for that of the wheel, which under pressure are nearly one; to 1e-12 m.
    pub(super) fn along_normal(&self, x: f64, y: f64) -> f64 {
        let y = self.side * y;
        let Some(rail) = self.rail.at(y) else {
            return BEYOND;
        };
        let (sine, cosine) = rail.slope.atan().sin_cos();
        let mut gap = 0.0;
        for _ in 0..MOST_STEPS {
            let Some((_, wheel)) = self.wheel_above(self.ahead + x, y - gap * sine) else {
                return BEYOND;
            };
            let step = cosine * (wheel.height - rail.height - gap * cosine);
            gap += step;
            if step.abs() < 1e-12 {
                return gap;
            }
        }
        BEYOND
    }

    /// Strips along the track where the gap is below a limit \[m\], some beyond at both ends, by increasing y; evenly over the
    /// coordinate of the wheel's profile.
    pub fn strips(&self, limit: f64) -> Vec<GapStrip> {
        let samples = &self.wheel.samples;
        let is_near = |point: &ProfilePoint| self.strip(point).is_some_and(|strip| strip.gap < limit);
        let (Some(first), Some(last)) = (samples.iter().position(is_near), samples.iter().rposition(is_near)) else {
            return Vec::new();
        };
        let low = samples[first.saturating_sub(1)].x;
        let high = samples[(last + 1).min(samples.len() - 1)].x;
        let mut strips: Vec<GapStrip> = Vec::with_capacity(STRIPS + 1);
        for index in 0..=STRIPS {
            let x = low + (high - low) * index as f64 / STRIPS as f64;
            let Some(strip) = self.wheel.profile.at(x).and_then(|point| self.strip(&point)) else {
                continue;
            };
            // What the wheel hangs over is hidden by the strips before it.
            if strips.last().is_none_or(|last| strip.y > last.y) {
                strips.push(strip);
            }
        }
        for strip in &mut strips {
            strip.y *= self.side;
        }
        if self.side < 0.0 {
            strips.reverse();
        }
        strips
    }

    /// The strip under a point of the wheel's profile, y outward.
    fn strip(&self, point: &ProfilePoint) -> Option<GapStrip> {
        let outline = self.stand.outline(point, self.wheel.rolling_radius)?;
        let (y, height) = self.in_plane(outline.across, outline.down);
        let rail = self.rail.at(y)?;
        let (sine, cosine) = self.plane;
        // Going along, the wheel rises by x²/2ρ; at its slope s against the plane that opens the gap by cos α + s sin α.
        let upward = -outline.slope;
        let slope = (upward * cosine - sine) / (cosine + upward * sine);
        Some(GapStrip {
            y,
            x: outline.ahead - self.ahead,
            gap: height - rail.height,
            curvature: (cosine + slope * sine) / (self.wheel.rolling_radius - point.height),
        })
    }

    /// Inclination of the rail against the track at a place y \[rad\], positive as [`contact_angle`](Self::contact_angle); none
    /// beside the rail.
    pub fn inclination_at(&self, y: f64) -> Option<f64> {
        Some(self.rail.at(self.side * y)?.slope.atan() + self.contact_angle())
    }

    /// Change of the rail's inclination from one place y \[m\] to another \[rad\]: what a flat patch leaves out; none beside
    /// the rail.
    pub fn inclination_over(&self, ends: [f64; 2]) -> Option<f64> {
        Some((self.inclination_at(ends[1])? - self.inclination_at(ends[0])?).abs())
    }

    /// +1 on the right rail, −1 on the left one.
    pub(super) fn side(&self) -> f64 {
        self.side
    }

    /// From distances across the track, outward from its middle without the shift of the wheelset, and below the axle's
    /// middle to y outward and height in the plane.
    fn in_plane(&self, across: f64, down: f64) -> (f64, f64) {
        let (sine, cosine) = self.plane;
        let (across, up) =
            (self.stand.lateral_shift + across - self.origin[0], -(self.stand.height + down) - self.origin[1]);
        (across * cosine + up * sine, up * cosine - across * sine)
    }

    /// The point of the wheel of a profile coordinate, at a distance along the track from the axle's middle.
    fn on_wheel(&self, x_wheel: f64, along: f64) -> Option<OnWheel> {
        let point = self.wheel.profile.at(x_wheel)?;
        let (yaw_sine, yaw_cosine) = self.stand.yaw;
        let (roll_sine, roll_cosine) = self.stand.roll;
        let radius = self.wheel.rolling_radius - point.height;
        let lateral = self.stand.half_spacing + x_wheel;
        let forward = (along + lateral * yaw_sine) / yaw_cosine;
        let down_square = radius * radius - forward * forward;
        if down_square <= 0.0 {
            return None;
        }
        let down = down_square.sqrt();
        let down_slope = (-radius * point.slope - forward * yaw_sine / yaw_cosine) / down;
        let (across, across_slope) = (forward * yaw_sine + lateral * yaw_cosine, yaw_cosine.recip());
        let (y, height) =
            self.in_plane(across * roll_cosine - down * roll_sine, across * roll_sine + down * roll_cosine);
        let (sine, cosine) = self.plane;
        Some(OnWheel {
            y,
            height,
            y_slope: (across_slope * roll_cosine - down_slope * roll_sine) * cosine
                - (across_slope * roll_sine + down_slope * roll_cosine) * sine,
        })
    }

    /// Profile coordinate and point of the wheel above y outward.
    fn wheel_above(&self, along: f64, y: f64) -> Option<(f64, OnWheel)> {
        let [low, high] = self.wheel.profile.range();
        let begin = (self.origin[0] + y * self.plane.1 - self.stand.lateral_shift) - self.stand.half_spacing;
        let mut x_wheel = begin.clamp(low, high);
        for _ in 0..MOST_STEPS {
            let point = self.on_wheel(x_wheel, along)?;
            let step = (y - point.y) / point.y_slope;
            if step.abs() < 1e-12 {
                return Some((x_wheel, point));
            }
            // Outside the profile there is nothing above the place.
            let next = x_wheel + step.clamp(-2e-3, 2e-3);
            if !(low..=high).contains(&next) && (x_wheel == low || x_wheel == high) {
                return None;
            }
            x_wheel = next.clamp(low, high);
        }
        None
    }
}

impl super::WheelsetOnTrack {
    /// The gap between wheel and rail of a contact, seen in a plane through the rail at a place: along the track from
    /// the axle's middle and across it from its own, outward \[m\]; inclined by an angle outward \[rad\], without one as the rail
    /// there.
    ///
    /// # Errors
    /// [`ProfileError::Shape`] if the place lies beside the rail.
    pub fn gap_at(
        &self,
        contact: &super::WheelsetContact,
        rail: Rail,
        place: [f64; 2],
        inclination: Option<f64>,
    ) -> Result<ContactGap, ProfileError> {
        let (placed, wheel, stand) = self.standing(contact, rail);
        ContactGap::new(rail, placed, wheel, stand, place, inclination)
            .ok_or(ProfileError::Shape(ShapeFault::BesideRail(rail)))
    }
}
