//! Whether a loop oscillates without any profile, before it is the loop of a case.

use riffel::feedback::{Stability, UnstableRoot};
use riffel::{Axis, Error, Loop};
use riffel_keys::{Message, Value, fixed, number, say, shown_speeds, significant};

use crate::file::{BeamModel, TrackModel};
use crate::keys::checked_keys::CheckedKeys;

/// Below the modes of a wheelset, and above what creep forces feel \[Hz\].
const BAND: (f64, f64) = (1.0, 10e3);

/// What is to be said of a loop from a speed to another \[m/s\], if anything: that it oscillates, or that it cannot be told.
pub(crate) fn said(speeds: [f64; 2], found: &Result<Stability, Error>) -> Option<Message> {
    let speed = shown_speeds(speeds);
    let Ok(found) = found else {
        return Some(say!(loop_not_judged, speed));
    };
    let frequency = fixed(found.frequency?, 0);
    let time = |root: &UnstableRoot| duration(root.growth_rate.recip());
    let roots: Vec<&UnstableRoot> = found.roots.iter().filter(|root| root.counts).collect();
    let growth = roots.split_first().map(|(highest, others)| {
        let others = others.iter().rev().fold(Value::from(""), |others, root| {
            let frequency = significant(root.frequency, 4);
            let other = say!(loop_unstable_other, frequency, time = time(root), others);
            other.into()
        });
        let highest = say!(loop_unstable_growth, time = time(highest), others);
        Value::from(highest)
    });
    Some(say!(loop_unstable, speed, frequency, growth = growth.unwrap_or("".into())))
}

/// A time \[s\] to two digits.
fn duration(seconds: f64) -> Value {
    match seconds {
        seconds if seconds >= 10.0 => number(format_args!("{seconds:.0} s")),
        seconds if seconds >= 0.995 => number(format_args!("{seconds:.1} s")),
        seconds if seconds >= 0.00995 => number(format_args!("{:.0} ms", 1e3 * seconds)),
        seconds => number(format_args!("{:.1} ms", 1e3 * seconds)),
    }
}

impl CheckedKeys {
    /// Frequency \[Hz\] up to which the model of the track holds: a measured one to its end, which it is not asked beyond; a beam for
    /// as long as the section of the rail keeps its shape, with shear to 2 kHz and without to 1.5 kHz, where it is 24° off.
    pub(crate) fn track_known_to(&self) -> f64 {
        let measured = self.given.track.is_some() || self.file.track.model == TrackModel::Measured;
        match (measured, self.beam_model()) {
            (true, _) => BAND.1,
            (false, BeamModel::EulerBernoulli) => 1500.0,
            (false, BeamModel::Timoshenko) => 2000.0,
        }
    }
}

/// Whether a loop oscillates at a speed \[m/s\] within the range of its track; `None` along one axis.
pub(crate) fn judged(feedback: &Loop, known_to: f64, speed: f64) -> Option<Result<Stability, Error>> {
    if feedback.is_along_one_axis() {
        return None;
    }
    let found = feedback.stability(speed, BAND.0, BAND.1);
    Some(found.map(|found| found.known_to(known_to)))
}

/// At the ends of some speeds and in the middle.
pub(crate) fn over(
    feedback: &Loop,
    known_to: f64,
    speed: Axis,
) -> impl Iterator<Item = (f64, Result<Stability, Error>)> {
    let speeds = [speed.min(), 0.5 * (speed.min() + speed.max()), speed.max()];
    speeds.into_iter().filter_map(move |speed| Some((speed, judged(feedback, known_to, speed)?)))
}
