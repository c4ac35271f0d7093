//! Profiles of wheels and rails, and where a wheelset touches its track.

mod on_track;
mod outline;
mod question;
mod under_load;
mod wear;

pub use on_track::OnTrackAnswer;
pub use outline::OutlineAnswer;
pub use question::ProfileQuestion;
pub use under_load::UnderLoadAnswer;
pub use wear::{WearAnswer, WearSettings, alignment_name};

use riffel_keys::Message;

use crate::number_alone;

/// A number of a table; a dash where there is none.
fn or_dash(value: Option<f64>, digits: usize) -> Message {
    value.map_or_else(|| Message::verbatim("–"), |value| number_alone(format_args!("{value:.digits$}")))
}
