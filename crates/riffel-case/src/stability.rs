//! Whether the loop of a case oscillates without any profile.

use riffel::feedback::Stability;
use riffel::{Axis, Error, Loop};

use crate::Case;

/// Below the modes of a wheelset, and above what creep forces feel \[Hz\].
const BAND: (f64, f64) = (1.0, 10e3);

impl Case {
    /// Whether the loop oscillates without any profile at a speed \[m/s\], by
    /// [`Loop::stability`]. None for the loop of one wheel and one
    /// axis, which never does, and where the phase cannot be followed, for want of any loss or of measured frequencies.
    pub fn stability(&self, speed: f64) -> Option<Stability> {
        judged(&self.feedback, speed)?.ok()
    }

    /// The speeds \[m/s\] of the map at which the loop is judged, with what it is there.
    pub fn stability_over_the_map(&self) -> Vec<(f64, Stability)> {
        let judged = over(&self.feedback, self.speed);
        judged
            .filter_map(|(speed, stability)| Some((speed, stability.ok()?)))
            .collect()
    }
}

fn judged(feedback: &Loop, speed: f64) -> Option<Result<Stability, Error>> {
    let on_all_axes = !feedback.is_along_one_axis();
    on_all_axes.then(|| feedback.stability(speed, BAND.0, BAND.1))
}

/// At the ends of some speeds and in the middle.
pub(crate) fn over(
    feedback: &Loop,
    speed: Axis,
) -> impl Iterator<Item = (f64, Result<Stability, Error>)> {
    let speeds = [speed.min(), 0.5 * (speed.min() + speed.max()), speed.max()];
    speeds
        .into_iter()
        .filter_map(move |speed| Some((speed, judged(feedback, speed)?)))
}
