//! What the wavelength that grows fastest follows: what speaks for it, what against, and which measurement would settle it.

use riffel::diagnosis::MechanismKind;
use riffel_case::Case;
use riffel_keys::{Message, Value, fixed, say, shown_speed, significant};
use serde::Serialize;

use crate::Highest;
use crate::capital::as_sentence;
use crate::diagnose::mechanism_words::settled_by;
use crate::highest::over_the_window;
use crate::ridge::{NEAR, mechanism_name, nearest, resonances};

/// The resonance that growth at a wavelength follows, as far as the case tells.
#[derive(Debug, Clone, Serialize)]
pub struct Cause {
    /// Its name; that of the growth ridge where no resonance is near.
    pub mechanism: &'static str,
    #[serde(skip)]
    kind: MechanismKind,
    /// Frequency of the resonance; `None` if none is near.
    pub resonance_hz: Option<f64>,
    /// The wavelength.
    pub wavelength_m: f64,
    /// Of the speeds of the traffic the one at which it grows most under the wheel of the case.
    pub speed_m_per_s: f64,
    /// Frequency there.
    pub frequency_hz: f64,
    /// What speaks for it; the first is the answer.
    pub evidence_for: Vec<Message>,
    /// What speaks against it.
    pub evidence_against: Vec<Message>,
    /// What would settle it.
    pub measurement: Message,
}

impl Cause {
    /// Of growth at a wavelength \[m\] between the slowest and the fastest speed of a traffic \[m/s\]; `None` if the wheel of the case
    /// makes none.
    pub(crate) fn of(case: &Case, wavelength: f64, [slowest, fastest]: [f64; 2]) -> Option<Self> {
        /// Speeds at which growth is looked for.
        const SPEEDS: u32 = 61;
        let rate = |speed: f64| case.feedback.at(wavelength, speed).growth_rate;
        let step = (fastest - slowest) / f64::from(SPEEDS - 1);
        let speeds = (0..SPEEDS).map(|place| slowest + step * f64::from(place));
        let (speed, _) = speeds
            .map(|speed| (speed, rate(speed)))
            .filter(|(_, rate)| *rate > 0.0)
            .max_by(|a, b| a.1.total_cmp(&b.1))?;
        let frequency = speed / wavelength;
        let resonances = resonances(case);
        let found = nearest(&resonances, frequency);
        let kind = found.map_or(MechanismKind::GrowthRidge, |(kind, _)| kind);
        let mut evidence_for = vec![sentence(wavelength, speed, found)];
        let mut evidence_against = Vec::new();
        if let Some((kept, evidence)) = frequency_kept(case, [slowest, fastest]) {
            match kept == found.is_some() {
                true => evidence_for.push(evidence),
                false => evidence_against.push(evidence),
            }
        }
        let [low, high] = [slowest / wavelength, fastest / wavelength];
        let others = resonances.iter().filter(|other| Some(**other) != found && (low..=high).contains(&other.1));
        let others = others.map(|&(kind, frequency)| at(kind, frequency));
        let others = others.reduce(|one, other| say!(both, one, other));
        let millimetres = significant(1e3 * wavelength, 2);
        let [low, high] = [low, high].map(|frequency| fixed(frequency, 0));
        match others {
            Some(others) => evidence_against.push(say!(others_in_reach, wavelength = millimetres, low, high, others)),
            None => evidence_for.push(say!(others_out_of_reach, wavelength = millimetres, low, high)),
        }
        if evidence_against.is_empty() {
            evidence_against.push(say!(nothing_against));
        }
        Some(Self {
            mechanism: kind.name(),
            kind,
            resonance_hz: found.map(|(_, frequency)| frequency),
            wavelength_m: wavelength,
            speed_m_per_s: speed,
            frequency_hz: frequency,
            evidence_for,
            evidence_against,
            measurement: as_sentence(&settled_by(kind)),
        })
    }

    /// Its name for a reader.
    pub fn title(&self) -> Message {
        match self.resonance_hz {
            Some(frequency) => at(self.kind, frequency),
            None => say!(cause_loop),
        }
    }

    /// The answer in one sentence.
    pub fn sentence(&self) -> &Message {
        &self.evidence_for[0]
    }
}

/// A mechanism with its frequency: "rail on pad (216 Hz)".
fn at(kind: MechanismKind, frequency: f64) -> Message {
    say!(mechanism_at, mechanism = mechanism_name(kind), frequency = fixed(frequency, 0))
}

fn sentence(wavelength: f64, speed: f64, found: Option<(MechanismKind, f64)>) -> Message {
    let frequency = speed / wavelength;
    let [millimetres, speed, hertz]: [Value; 3] =
        [significant(1e3 * wavelength, 2), shown_speed(speed, 0), fixed(frequency, 0)];
    match found {
        // At less than half a percent, or where both are written alike, it is the resonance.
        Some((kind, resonance))
            if (frequency / resonance - 1.0).abs() < 5e-3 || frequency.round() == resonance.round() =>
        {
            say!(cause_at, wavelength = millimetres, speed, frequency = hertz, mechanism = mechanism_name(kind))
        }
        Some((kind, resonance)) => say!(
            cause_near,
            wavelength = millimetres,
            speed,
            frequency = hertz,
            distance = fixed(100.0 * (frequency / resonance - 1.0).abs(), 0),
            resonance = fixed(resonance, 0),
            mechanism = mechanism_name(kind)
        ),
        None => say!(cause_alone, wavelength = millimetres, speed, frequency = hertz, within = fixed(100.0 * NEAR, 0)),
    }
}

/// Whether the fastest wavelengths of the slowest and the fastest trains keep a frequency more than a length, with the sentence on it;
/// `None` if one of them has no crest, or the speeds are too near to tell.
fn frequency_kept(case: &Case, speeds: [f64; 2]) -> Option<(bool, Message)> {
    /// Ratio of the speeds below which nothing can be told.
    const TOO_NEAR: f64 = 1.1;
    let crest = |speed: f64| {
        let rate = |wavelength: f64| case.feedback.at(wavelength, speed).growth_rate;
        over_the_window(case, false, speed, rate).1.filter(|it| !it.at_edge)
    };
    let [slowest, fastest] = speeds;
    if fastest < TOO_NEAR * slowest {
        return None;
    }
    let (first, last): (Highest, Highest) = (crest(slowest)?, crest(fastest)?);
    // A fixed length has a frequency that goes with the speed.
    let kept = (last.frequency / first.frequency).ln().abs() < 0.5 * (fastest / slowest).ln();
    let [slow, fast] = speeds.map(|speed| shown_speed(speed, 0));
    let [low, high] = [first, last].map(|it| fixed(it.frequency, 0));
    Some((
        kept,
        match kept {
            true => say!(
                frequency_is_kept,
                slow,
                fast,
                first = significant(1e3 * first.wavelength, 2),
                last = significant(1e3 * last.wavelength, 2),
                low,
                high
            ),
            false => say!(frequency_is_not_kept, slow, fast, low, high),
        },
    ))
}
