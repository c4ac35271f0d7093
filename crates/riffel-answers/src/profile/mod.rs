//! Profiles of wheels and rails, and where a wheelset touches its track.

mod on_track;
mod outline;

pub use on_track::{OnTrackAnswer, OnTrackDocument};
pub use outline::{OutlineAnswer, OutlineDocument};
