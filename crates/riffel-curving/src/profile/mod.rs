//! Profiles of wheels and rails, and where a wheelset touches its track.
//!
//! A profile lies in the plane across the track: x lateral, positive to the field side, height positive upward. A rail
//! stands upright with its crown in the origin; a wheel has the origin on the datum circle of its tread, its flange at
//! x below zero and downward. Both are drawn as those of the right rail; the left ones are turned over.

mod conicity;
mod contact_gap;
mod contact_surface;
mod crossing;
mod error;
mod fault;
mod loaded_contact;
mod nominal;
#[expect(clippy::module_inception, reason = "the noun is that of the folder")]
mod profile;
mod radius_difference;
mod rolling_table;
mod side;
mod smoothing;
mod spline;
mod wear;
mod wheelset_on_track;
mod worn_dimensions;

pub use conicity::EquivalentConicity;
pub use contact_gap::ContactGap;
pub use contact_surface::ContactSurface;
pub use error::ProfileError;
pub use fault::{PointFault, ShapeFault};
pub use loaded_contact::LoadedContact;
pub use nominal::{NOMINAL, NominalProfile};
pub use profile::{Profile, ProfilePoint};
pub use radius_difference::RadiusDifference;
pub use rolling_table::RollingTable;
pub use smoothing::SmoothedPoints;
pub use wear::{ProfileAlignment, ProfileWear, WornPoint};
pub use wheelset_on_track::{ProfileContact, Track, Wheels, WheelsetContact, WheelsetOnTrack};
pub use worn_dimensions::{RailWear, WheelDimensions};

#[cfg(test)]
mod tests;
