//! Tables of physical ranges. Hard ranges leave room for roller rigs and twin-disc machines (wheels of 5 mm, loads of 1 N, discs of
//! polymer) and for limits that a thought experiment takes; where a limit has a key of its own, such as `wheel.rotation`, the range
//! ends far beyond where it is reached.

mod contact;
mod profiles;
mod rail_and_track;
mod speed_and_place;
mod vehicle;
mod wear_and_damage;

use super::PhysicalRange;
use crate::quantity::{Dimension, Kind};

/// Largest speed \[m/s\] that is taken without a question where no unit is written: 144 km/h. Faster lines exist, but
/// most numbers above it are kilometres an hour without their unit.
const BARE_SPEED: f64 = 40.0;

const fn row<D: Dimension>(
    keys: &'static [&'static str],
    hard: [f64; 2],
    usual: [f64; 2],
    reason: &'static str,
) -> PhysicalRange {
    PhysicalRange { keys, kind: Kind::of::<D>(), hard, usual, bare_up_to: f64::INFINITY, reason }
}

/// Tables in the order of the case file.
pub(super) const TABLES: [&[PhysicalRange]; 6] = [
    rail_and_track::RANGES,
    contact::RANGES,
    vehicle::RANGES,
    profiles::RANGES,
    wear_and_damage::RANGES,
    speed_and_place::RANGES,
];
