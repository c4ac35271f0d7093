//! Traffic files: the vehicles of a line, and how fast corrugation grows under them.

mod mechanisms;

mod in_time;
mod mix;
mod on_case;
mod reported_growth;
mod shares;
mod spread;
mod spreads;
mod through_curve;
mod traffic_file;
mod usual;
mod vehicle_keys;
mod vehicle_name;
mod wheel_on_case;
mod wheels_of_vehicle;

use riffel::roughness::ThirdOctave;

pub use in_time::VehicleInTime;
pub use mechanisms::mechanisms;
pub use mix::Traffic;
pub use on_case::TrafficOnCase;
pub use reported_growth::{FASTEST_DOUBLING_DAYS, is_faster_than_known, is_of_reported_growth, reported_growth};
pub use spread::{Spread, SpreadEnds, ValueShare};
pub use spreads::SpreadEffect;
pub use traffic_file::{CurveOfVehicle, FrictionDays, Line, NormalSpeed, SpeedShare, TrafficFile, Vehicle};
pub use usual::{LineKind, UsualTraffic, traffic_at_speeds};
pub use vehicle_name::{WHEEL_OF_THE_CASE, vehicle_in_words};

use crate::Case;

/// Keys of the traffic file that have a range, each with its place in the schema.
pub(crate) const POINTERS: [(&str, &str); 12] = [
    ("line.passages_per_day", "/$defs/Line/properties/passages_per_day"),
    ("line.measured_line", "/$defs/Line/properties/measured_line"),
    ("line.mgt_per_year", "/$defs/Line/properties/mgt_per_year"),
    ("vehicle.axle_load", "/$defs/Vehicle/properties/axle_load"),
    ("vehicle.wheel_load", "/$defs/Vehicle/properties/wheel_load"),
    ("vehicle.wheel_mass", "/$defs/Vehicle/properties/wheel_mass"),
    ("vehicle.rolling_radius", "/$defs/Vehicle/properties/rolling_radius"),
    ("vehicle.tractive_ratio", "/$defs/Vehicle/properties/tractive_ratio"),
    ("vehicle.creepage", "/$defs/Vehicle/properties/creepage"),
    ("vehicle.speed.mean", "/$defs/NormalSpeed/properties/mean"),
    ("vehicle.speed.standard_deviation", "/$defs/NormalSpeed/properties/standard_deviation"),
    ("vehicle.speeds.speed", "/$defs/SpeedShare/properties/speed"),
];

/// Days of a year in the mean of the calendar.
pub const DAYS_PER_YEAR: f64 = 365.2425;
/// Days of a month in the mean of the calendar.
pub const DAYS_PER_MONTH: f64 = DAYS_PER_YEAR / 12.0;

/// The one-third-octave bands that a case speaks of: from the one that holds the shortest wavelength of its
/// map to the one that holds the longest.
pub fn bands_of(case: &Case) -> Vec<ThirdOctave> {
    let band = |wavelength: f64| ThirdOctave::containing(wavelength).ok();
    // An axis has wavelengths above zero.
    match (band(case.wavelength.min()), band(case.wavelength.max())) {
        (Some(shortest), Some(longest)) => ThirdOctave::between(shortest, longest).collect(),
        _ => Vec::new(),
    }
}
