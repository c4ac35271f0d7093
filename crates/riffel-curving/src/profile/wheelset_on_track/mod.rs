//! A rigid wheelset on two rails.

mod outline;
mod track;
mod wheels;

use std::sync::Arc;

use outline::{Attitude, attitude, outline_of};
use rayon::prelude::*;
use riffel::Rail;
use riffel_numerics::bisection::fallible_bisection;
use track::place;

use super::{Profile, ProfileError, ProfilePoint};

pub(super) use outline::Outline;
pub use track::Track;
pub(super) use wheels::SampledWheel;
pub use wheels::Wheels;

/// Another local minimum of the gap within this distance is told \[m\].
const SECOND: f64 = 5e-5;
/// Where the gap is within this of its least \[m\], every sample is looked around.
const FLAT: f64 = 2e-7;
/// Samples whose gap is within this of the least \[m\] may touch at a roll within [`NEAR_ROLL`]: it moves the gap by at
/// most 2 m times its change, on the steepest flanks.
const REACH: f64 = 3e-3;
const NEAR_ROLL: f64 = 1e-3;
/// The roll is found to this difference of heights \[m\].
const LEVEL: f64 = 1e-14;
/// Most steps of the roll; near flanges some ten are needed.
const MOST_ROLLS: usize = 60;

/// Where a wheel touches its rail.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ProfileContact {
    /// Rolling radius r \[m\].
    pub rolling_radius: f64,
    /// Contact angle γ \[rad\], positive where the normal force pushes the rail outward.
    pub contact_angle: f64,
    /// Lateral coordinate in the profile of the wheel \[m\].
    pub x_wheel: f64,
    /// Place on the track: ahead of the axle's middle, to the right of the track's, below the crowns \[m\].
    pub on_track: [f64; 3],
    /// Curvature of the rail \[1/m\], positive for a convex head.
    pub rail_curvature: f64,
    /// Curvature of the wheel \[1/m\], positive for a hollow one.
    pub wheel_curvature: f64,
    /// Another local minimum of the vertical gap within 0.05 mm: gap and lateral coordinate on the wheel \[m\].
    pub second: Option<(f64, f64)>,
}

/// A wheelset that touches both rails.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WheelsetContact {
    /// Lateral shift y \[m\], positive to the right.
    pub lateral_shift: f64,
    /// Yaw ψ \[rad\], positive with the nose to the right.
    pub yaw: f64,
    /// Roll φ \[rad\], positive with the right side down.
    pub roll: f64,
    /// Lowering of the axle's middle from where wheels of the radius on the datum circle would have it on the crowns \[m\].
    pub centre_z: f64,
    /// Left, right.
    pub contacts: [ProfileContact; 2],
}

impl WheelsetContact {
    /// r of the right wheel less that of the left \[m\].
    pub fn rolling_radius_difference(&self) -> f64 {
        self.contacts[1].rolling_radius - self.contacts[0].rolling_radius
    }
}

/// A rigid wheelset on two rails.
#[derive(Debug, Clone)]
pub struct WheelsetOnTrack {
    /// The wheels.
    pub wheels: Wheels,
    /// The rails.
    pub track: Track,
}

/// How a wheel of a wheelset that touches stands, seen as a right one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand {
    pub(super) lateral_shift: f64,
    /// Sine and cosine.
    pub(super) yaw: (f64, f64),
    pub(super) roll: (f64, f64),
    /// Distance of the axle's middle below the crowns, below zero \[m\].
    pub(super) height: f64,
    /// Distance of the datum circle from the axle's middle \[m\].
    pub(super) half_spacing: f64,
}

impl Stand {
    /// The point of the outline of a point of the profile.
    pub(super) fn outline(&self, point: &ProfilePoint, rolling_radius: f64) -> Option<Outline> {
        let attitude = Attitude { lateral_shift: self.lateral_shift, yaw: self.yaw, roll: self.roll };
        outline_of(point, rolling_radius, self.half_spacing, &attitude)
    }
}

/// A local minimum of the gap.
#[derive(Clone, Copy)]
struct Touch {
    /// Lowering of the axle at which the wheel touches here \[m\].
    height: f64,
    x_wheel: f64,
}

/// Samples of each wheel that may touch at rolls close to one; empty before any were looked through.
#[derive(Default)]
struct Near {
    samples: [Vec<usize>; 2],
    roll: f64,
}

impl WheelsetOnTrack {
    /// Where the wheelset touches at a lateral shift \[m\] and a yaw \[rad\]; its roll is that at which both wheels touch.
    ///
    /// The wheel is seen along the track as the curve of those of its points whose normal has no component along it; roll
    /// follows yaw. Touch is the least vertical distance between that curve and the rail. Method: samples of the wheel
    /// every 0.2 mm, each local minimum of the distance refined where wheel and rail have one slope; Newton for the roll.
    /// Accuracy: that of the profiles. No elasticity. Cost: some 50 µs.
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where a wheel has left its rail.
    pub fn contact(&self, lateral_shift: f64, yaw: f64) -> Result<WheelsetContact, ProfileError> {
        self.rolled(|_| (lateral_shift, 0.0), yaw, &mut Near::default())
    }

    /// [`contact`](Self::contact) without yaw at a lateral shift \[m\] with each of some changes of it, all less than 1 µm. Cost: that of
    /// one contact, and half of that for each further one.
    pub fn contacts_beside(
        &self,
        lateral_shift: f64,
        changes: &[f64],
    ) -> impl Iterator<Item = Result<WheelsetContact, ProfileError>> {
        let mut near = Near::default();
        changes.iter().map(move |change| self.rolled(|_| (lateral_shift + change, 0.0), 0.0, &mut near))
    }

    /// [`contact`](Self::contact) at many lateral shifts \[m\] and yaws \[rad\], in their order, on all threads.
    pub fn contacts(&self, places: &[(f64, f64)]) -> Vec<Result<WheelsetContact, ProfileError>> {
        let contact = |(lateral_shift, yaw): &(f64, f64)| self.contact(*lateral_shift, *yaw);
        places.par_iter().map(contact).collect()
    }

    /// Rolling radius difference \[m\], right less left, at a lateral shift \[m\] of an axle that stays level: each wheel
    /// touches where the vertical distance to its rail is least, as EN 15302 has it.
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where a wheel has left its rail.
    pub fn level_radius_difference(&self, lateral_shift: f64) -> Result<f64, ProfileError> {
        let [left, right] = Rail::BOTH.map(|rail| {
            let attitude = attitude(rail, lateral_shift, 0.0, 0.0);
            let touch = *self.touches(rail, &attitude, &mut Vec::new())?.first()?;
            let wheel = self.wheel(rail);
            Some(wheel.rolling_radius - wheel.profile.at(touch.x_wheel)?.height)
        });
        let failed = |rail: Rail| ProfileError::NoContact { lateral_shift, yaw: 0.0, rail };
        Ok(right.ok_or_else(|| failed(Rail::Right))? - left.ok_or_else(|| failed(Rail::Left))?)
    }

    /// Where the wheelset touches if it is shifted by η \[m\] at the level of the rails: its axle has the lateral shift
    /// y = η + r₀ sin φ, with the radius r₀ of the right wheel on its datum circle.
    ///
    /// On a flange the wheelset rolls back as it climbs: dy/dη = 1 − r₀ tan γ/2s, so that where r₀ tan γ > 2s one lateral shift of
    /// the axle has several contacts, or none. η has one. Method, accuracy, cost and errors are those of
    /// [`contact`](Self::contact).
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where a wheel has left its rail.
    pub fn contact_at_rail_level(&self, shift: f64, yaw: f64) -> Result<WheelsetContact, ProfileError> {
        let radius = self.wheels.wheels[1].rolling_radius;
        let of_roll = |roll: f64| (shift + radius * roll.sin(), radius * roll.cos());
        self.rolled(of_roll, yaw, &mut Near::default())
    }

    /// Shift at the level of the rails \[m\], without sign, at which the wheel on one rail comes to stand on its flange, where its contact is
    /// steeper than 45°; yaw \[rad\] makes it smaller, for the flange then meets the rail ahead of the axle. `None` if no
    /// contact within 60 mm is so steep. Found to 1 µm in some 20 contacts.
    pub fn flange_shift(&self, rail: Rail, yaw: f64) -> Option<f64> {
        const STEEP: f64 = std::f64::consts::FRAC_PI_4;
        const STEP: f64 = 1e-3;
        let angle = |shift: f64| {
            let contact = self.contact_at_rail_level(rail.sign() * shift, yaw).ok()?;
            Some(contact.contacts[place(rail)].contact_angle)
        };
        let mut high = 0.0;
        while angle(high)? < STEEP {
            high += STEP;
            if high > 0.06 {
                return None;
            }
        }
        let low = f64::max(high - STEP, 0.0);
        let is_steep = |shift: f64| angle(shift).map(|angle| angle >= STEEP).ok_or(());
        fallible_bisection([low, high], 1e-6, is_steep).ok().map(|[_, high]| high)
    }

    /// Contact at the roll at which both wheels touch, with the lateral shift of the axle \[m\] and its slope over that roll.
    fn rolled(
        &self,
        shift_of_roll: impl Fn(f64) -> (f64, f64),
        yaw: f64,
        near: &mut Near,
    ) -> Result<WheelsetContact, ProfileError> {
        let shift_without_roll = shift_of_roll(0.0).0;
        let failed = |rail: Rail| ProfileError::NoContact { lateral_shift: shift_without_roll, yaw, rail };
        let mut roll = 0.0_f64;
        for _ in 0..MOST_ROLLS {
            if (roll - near.roll).abs() > NEAR_ROLL {
                *near = Near { roll, ..Near::default() };
            }
            let (lateral_shift, shift_slope) = shift_of_roll(roll);
            let [left, right] = Rail::BOTH.map(|rail| {
                let attitude = attitude(rail, lateral_shift, yaw, roll);
                self.touches(rail, &attitude, &mut near.samples[place(rail)])
            });
            let left = left.ok_or_else(|| failed(Rail::Left))?;
            let right = right.ok_or_else(|| failed(Rail::Right))?;
            let difference = right[0].height - left[0].height;
            // Of the height of touch over the roll, right side down, with the shift that goes with it.
            let rate = |rail: Rail, touch: &Touch| {
                let attitude = attitude(rail, lateral_shift, yaw, roll);
                let outline = self.outline(rail, touch.x_wheel, &attitude);
                outline.map(|outline| -outline.slope * outline.down - outline.across + outline.slope * shift_slope)
            };
            let slope = match (rate(Rail::Right, &right[0]), rate(Rail::Left, &left[0])) {
                (Some(right), Some(left)) => right + left,
                _ => return Err(failed(Rail::Right)),
            };
            let step = difference / slope;
            if difference.abs() < LEVEL || step.abs() < 1e-15 {
                let height = 0.5 * (right[0].height + left[0].height);
                return Ok(WheelsetContact {
                    lateral_shift,
                    yaw,
                    roll,
                    centre_z: height + self.wheels.wheels[1].rolling_radius,
                    contacts: [
                        self.describe(Rail::Left, lateral_shift, yaw, roll, height, &left)
                            .ok_or_else(|| failed(Rail::Left))?,
                        self.describe(Rail::Right, lateral_shift, yaw, roll, height, &right)
                            .ok_or_else(|| failed(Rail::Right))?,
                    ],
                });
            }
            // Flanges are steep: a step of the roll leaves the neighbourhood in which slopes hold.
            roll -= step.clamp(-5e-3, 5e-3);
            if roll.abs() > 0.2 {
                return Err(failed(if shift_without_roll > 0.0 { Rail::Left } else { Rail::Right }));
            }
        }
        Err(failed(if shift_without_roll > 0.0 { Rail::Right } else { Rail::Left }))
    }

    /// Rail and wheel of a contact on one side, and how the wheel stands there.
    pub(super) fn standing(&self, contact: &WheelsetContact, rail: Rail) -> (&Profile, Arc<SampledWheel>, Stand) {
        let attitude = attitude(rail, contact.lateral_shift, contact.yaw, contact.roll);
        let stand = Stand {
            lateral_shift: attitude.lateral_shift,
            yaw: attitude.yaw,
            roll: attitude.roll,
            height: contact.centre_z - self.wheels.wheels[1].rolling_radius,
            half_spacing: self.wheels.half_spacing,
        };
        let index = place(rail);
        (&self.track.rails[index].profile, Arc::clone(&self.wheels.wheels[index]), stand)
    }

    fn outline(&self, rail: Rail, x_wheel: f64, attitude: &Attitude) -> Option<Outline> {
        let wheel = self.wheel(rail);
        outline_of(&wheel.profile.at(x_wheel)?, wheel.rolling_radius, self.wheels.half_spacing, attitude)
    }

    fn wheel(&self, rail: Rail) -> &SampledWheel {
        &self.wheels.wheels[place(rail)]
    }

    /// Local minima of the gap, the least first, all within [`SECOND`]; `None` if the wheel misses the rail. `near` are the
    /// samples that may touch at any roll close by; empty, all are looked through, and those are handed back.
    fn touches(&self, rail: Rail, attitude: &Attitude, near: &mut Vec<usize>) -> Option<Vec<Touch>> {
        let wheel = self.wheel(rail);
        let placed = &self.track.rails[place(rail)];
        let gap = |index: usize| {
            let point = &wheel.samples[index];
            let outline = outline_of(point, wheel.rolling_radius, self.wheels.half_spacing, attitude)?;
            Some(-placed.height(attitude.lateral_shift + outline.across)? - outline.down)
        };
        let gaps: Vec<(usize, f64)> = match &near[..] {
            [] => (0..wheel.samples.len()).filter_map(|index| Some((index, gap(index)?))).collect(),
            near => near.iter().filter_map(|&index| Some((index, gap(index)?))).collect(),
        };
        let least = gaps.iter().fold(f64::INFINITY, |least, (_, gap)| f64::min(least, *gap));
        if near.is_empty() {
            near.extend(gaps.iter().filter(|(_, gap)| gap - least < REACH).map(|(index, _)| index));
        }
        // Samples may lie above the minimum between them by some micrometres on flanges.
        let mut touches: Vec<Touch> = Vec::new();
        let within = |&(_, gap): &(usize, f64), beyond: f64| gap <= least + beyond;
        for (place, entry) in gaps.iter().enumerate() {
            let index = entry.0;
            let beside = |other: Option<&(usize, f64)>| other.map_or(f64::INFINITY, |other| other.1);
            let is_lowest = entry.1 <= beside(place.checked_sub(1).and_then(|before| gaps.get(before)))
                && entry.1 <= beside(gaps.get(place + 1));
            // Measured profiles are uneven: where the gap is flat, minima stand closer than samples.
            if within(entry, FLAT) || (is_lowest && within(entry, SECOND + 2e-5)) {
                let low = wheel.samples[index.saturating_sub(1)].x;
                let high = wheel.samples[(index + 1).min(wheel.samples.len() - 1)].x;
                self.refine(rail, attitude, low, high, &mut touches);
            }
        }
        touches.sort_by(|one, other| one.height.total_cmp(&other.height));
        let first = *touches.first()?;
        let mut apart: Vec<Touch> = vec![first];
        for touch in touches {
            let is_new = apart.iter().all(|known| (known.x_wheel - touch.x_wheel).abs() > 1e-6);
            if is_new && touch.height - first.height <= SECOND {
                apart.push(touch);
            }
        }
        Some(apart)
    }

    /// The minima of the gap between two lateral coordinates of the wheel: where wheel and rail have one slope.
    fn refine(&self, rail: Rail, attitude: &Attitude, low: f64, high: f64, touches: &mut Vec<Touch>) {
        const PARTS: usize = 4;
        let placed = &self.track.rails[place(rail)];
        let at = |x_wheel: f64| {
            let outline = self.outline(rail, x_wheel, attitude)?;
            let below = placed.profile.at(attitude.lateral_shift + outline.across)?;
            Some((-below.slope - outline.slope, -below.height - outline.down))
        };
        let part = |index: usize| low + (high - low) * index as f64 / PARTS as f64;
        let slopes: Vec<Option<f64>> = (0..=PARTS).map(|index| Some(at(part(index))?.0)).collect();
        for index in 0..PARTS {
            let (Some(low_slope), Some(high_slope)) = (slopes[index], slopes[index + 1]) else {
                continue;
            };
            if low_slope > 0.0 || high_slope < 0.0 {
                continue;
            }
            let x_wheel =
                falling_to_rising(|x| Some(at(x)?.0), [part(index), part(index + 1)], [low_slope, high_slope]);
            if let Some((x_wheel, (_, height))) = x_wheel.and_then(|x| Some((x, at(x)?))) {
                touches.push(Touch { height, x_wheel });
            }
        }
    }

    fn describe(
        &self,
        rail: Rail,
        lateral_shift: f64,
        yaw: f64,
        roll: f64,
        height: f64,
        touches: &[Touch],
    ) -> Option<ProfileContact> {
        let touch = touches[0];
        let wheel = self.wheel(rail);
        let attitude = attitude(rail, lateral_shift, yaw, roll);
        let outline = self.outline(rail, touch.x_wheel, &attitude)?;
        let across = attitude.lateral_shift + outline.across;
        let on_wheel = wheel.profile.at(touch.x_wheel)?;
        let on_rail = self.track.rails[place(rail)].profile.at(across)?;
        Some(ProfileContact {
            rolling_radius: wheel.rolling_radius - on_wheel.height,
            contact_angle: on_rail.slope.atan(),
            x_wheel: touch.x_wheel,
            on_track: [outline.ahead, rail.sign() * across, height + outline.down],
            rail_curvature: -on_rail.curvature,
            wheel_curvature: -on_wheel.curvature,
            second: touches.get(1).map(|second| (second.height - touch.height, second.x_wheel)),
        })
    }
}

/// The zero of a slope that rises from one place to another, by Illinois' rule of false position.
fn falling_to_rising(slope: impl Fn(f64) -> Option<f64>, ends: [f64; 2], slopes: [f64; 2]) -> Option<f64> {
    let ([mut low, mut high], [mut low_slope, mut high_slope]) = (ends, slopes);
    let mut middle = 0.5 * (low + high);
    let mut last = 0.0;
    for _ in 0..60 {
        if high_slope > low_slope {
            middle = low - low_slope * (high - low) / (high_slope - low_slope);
        }
        let there = slope(middle)?;
        if there.abs() < 1e-14 || high - low < 1e-13 {
            break;
        }
        if there < 0.0 {
            (low, low_slope) = (middle, there);
            if last < 0.0 {
                high_slope *= 0.5;
            }
        } else {
            (high, high_slope) = (middle, there);
            if last > 0.0 {
                low_slope *= 0.5;
            }
        }
        last = there;
    }
    Some(middle)
}
