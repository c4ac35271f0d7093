//! Profiles of wheels and rails, and where a wheelset touches its track.

mod on_track;
mod outline;
mod under_load;
mod wear;

pub use on_track::{OnTrackAnswer, OnTrackDocument};
pub use outline::{OutlineAnswer, OutlineDocument};
pub use under_load::{UnderLoadAnswer, UnderLoadDocument};
pub use wear::{Measures, WearAnswer, WearDocument, WearSettings, Worn, alignment_name, alignment_named};
