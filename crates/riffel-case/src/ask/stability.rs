//! Whether the loop of a case oscillates without any profile.

use riffel::feedback::Stability;
use riffel_keys::{Message, say};

use crate::Case;
use crate::build::stability::{judged, over, said};
use crate::parts::short_waves::shorter_than_patch;

/// Whether the loop oscillates without any profile at a speed \[m/s\], by
/// [`Loop::stability`](riffel::Loop::stability). None for the loop of one wheel and one
/// axis, which never does, and where the phase cannot be followed, for want of any loss or of measured frequencies.
///
/// Oscillations beyond the range of the model of the track do not count.
pub fn stability(case: &Case, speed: f64) -> Option<Stability> {
    judged(&case.feedback, case.keys.track_known_to(), speed)?.ok()
}

/// What the reader should know about the validity of the models where one speed \[m/s\] is asked about: as
/// [`remarks`](Case::remarks), but whether the loop oscillates without any profile is said of that speed.
pub fn remarks_at(case: &Case, speed: f64) -> Vec<Message> {
    let of_stability =
        [say!(loop_not_judged, speed = ""), say!(loop_unstable, speed = "", frequency = "", growth = "")];
    let other = |remark: &&Message| of_stability.iter().all(|of| of.id() != remark.id());
    let own = judged(&case.feedback, case.keys.track_known_to(), speed).and_then(|found| said([speed; 2], &found));
    case.remarks.iter().filter(other).cloned().chain(own).collect()
}

/// Remarks if one wavelength \[m\] is asked about as well, which may lie outside the map.
pub fn remarks_at_point(case: &Case, wavelength: f64, speed: f64) -> Vec<Message> {
    let mut remarks = remarks_at(case, speed);
    let short = shorter_than_patch(case.hertz, wavelength);
    let short = short.filter(|short| {
        case.file.contact.wave_geometry == Some(true) && remarks.iter().all(|remark| remark.id() != short.id())
    });
    remarks.extend(short);
    remarks
}

/// The speeds \[m/s\] of the map at which the loop is judged, with what it is there.
pub fn stability_over_the_map(case: &Case) -> Vec<(f64, Stability)> {
    let judged = over(&case.feedback, case.keys.track_known_to(), case.speed);
    judged.filter_map(|(speed, stability)| Some((speed, stability.ok()?))).collect()
}
