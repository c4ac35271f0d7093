//! What is to be asked of a measured receptance, and what makes it none.

mod double_hit;
mod mirrored;
mod phase;

use std::f64::consts::TAU;

use riffel::Complex64;
use riffel::receptance::MeasuredReceptance;
use riffel_keys::{Message, fixed, number, say};

use self::phase::PhaseFault;

/// Receptances that a rail may have \[m/N\]: those of tracks under `presets/` are 1e-11 to 3e-8 from 20 Hz to 5 kHz. The
/// median of a table lies between these, or its unit is another one.
const OF_A_RAIL: (f64, f64) = (1e-14, 1e-4);

/// Receptances \[m/N\] of which every measured rail has some: those of the presets, with room for softer tracks.
const USUAL: (f64, f64) = (1e-11, 1e-7);

/// Frequency \[Hz\] and receptance \[m/N\].
type Line = (f64, Complex64);

/// How a response is turned that has the wrong signs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Remedy {
    /// By keys of the case, which are so now.
    Keys {
        /// `track.measurement.conjugate`.
        conjugate: bool,
        /// `track.measurement.negate`.
        negate: bool,
    },
    /// Whoever has the values can do it.
    Values,
}

impl Remedy {
    fn message(self, fault: PhaseFault) -> Message {
        let (conjugated, negated) = match fault {
            PhaseFault::Conjugated => (true, false),
            PhaseFault::Negated => (false, true),
            _ => (true, true),
        };
        match self {
            Self::Keys { .. } if fault == PhaseFault::ConjugatedOrNegated => {
                say!(set_one_of_the_signs)
            }
            Self::Keys { conjugate, negate } => say!(
                set_signs,
                conjugate = (conjugate != conjugated).to_string(),
                negate = (negate != negated).to_string()
            ),
            Self::Values => match (conjugated, negated) {
                (true, false) => say!(conjugate_it),
                (false, true) => say!(negate_it),
                _ if fault == PhaseFault::ConjugatedOrNegated => say!(conjugate_or_negate_it),
                _ => say!(conjugate_and_negate_it),
            },
        }
    }
}

/// What is to be asked of a receptance that was measured on a rail: whether it has the size of one, and the phase.
///
/// # Errors
/// The sentence for one that no rail has.
pub fn doubts_about_rail(receptance: &MeasuredReceptance) -> Result<Vec<Message>, Message> {
    let size = doubts_about_size(receptance)?;
    let others = doubts(receptance, Remedy::Values)?;
    Ok(size.into_iter().chain(others).collect())
}

/// What is to be asked of a receptance at the point of its force: where it gives energy away, a delay, a second hit.
///
/// # Errors
/// The sentence for one with the wrong signs, or with the upper half of a two-sided spectrum: what it says of growth is another track's.
pub fn doubts(receptance: &MeasuredReceptance, remedy: Remedy) -> Result<Vec<Message>, Message> {
    let lines: Vec<Line> = receptance.lines().map(|(w, h)| (w / TAU, h)).collect();
    if let Some(middle) = mirrored::mirrored_from(&lines) {
        return Err(say!(response_mirrored, hertz = fixed(middle, 0)));
    }
    let active = || lines.iter().filter(|(_, h)| h.im > 0.0).map(|(f, _)| *f);
    let (count, points) = (active().count(), lines.len());
    let mut doubts = Vec::new();
    match phase::phase_fault(&lines) {
        None => {
            if let (Some(first), Some(last)) = (active().next(), active().next_back()) {
                let (first, last) = (fixed(first, 0), fixed(last, 0));
                doubts.push(say!(receptance_gives_energy, count, points, first, last));
            }
        }
        Some(PhaseFault::Delayed(delay)) => {
            let highest = lines.last().map_or(0.0, |(f, _)| *f);
            doubts.push(say!(
                response_delayed,
                degrees = fixed(360.0 * highest * delay.abs(), 0),
                hertz = fixed(highest, 0),
                milliseconds = fixed(1e3 * delay.abs(), 2)
            ));
        }
        Some(fault) => {
            let remedy = remedy.message(fault);
            return Err(match fault {
                PhaseFault::Negated => say!(response_negated, count, points, remedy),
                PhaseFault::ConjugatedAndNegated => {
                    say!(response_conjugated_and_negated, remedy)
                }
                PhaseFault::OtherQuantity => {
                    say!(response_of_other_quantity, count, points)
                }
                PhaseFault::ConjugatedOrNegated => {
                    say!(response_conjugated_or_negated, count, points, remedy)
                }
                _ => say!(response_conjugated, count, points, remedy),
            });
        }
    }
    if let Some(time) = double_hit::time_between_hits(&lines) {
        doubts.push(say!(response_ripples, hertz = fixed(1.0 / time, 0), milliseconds = fixed(1e3 * time, 1)));
    }
    Ok(doubts)
}

/// Check that a receptance of a wheelset at one port does not give energy away as a rule, beyond rounding.
///
/// # Errors
/// The sentence for one that does.
pub(super) fn check_sign(receptance: &MeasuredReceptance, rounding: f64) -> Result<(), Message> {
    let points = receptance.points();
    let active = receptance.lines().filter(|(_, h)| h.im > rounding * h.norm());
    let count = active.count();
    if count as f64 <= phase::ACTIVE * points as f64 {
        return Ok(());
    }
    let remedy = Remedy::Values.message(PhaseFault::ConjugatedOrNegated);
    Err(say!(response_conjugated_or_negated, count, points, remedy))
}

/// `Ok` where the median of the modulus is one that a rail may have, with a remark where none of its lines is one
/// that rails do have.
pub(super) fn doubts_about_size(receptance: &MeasuredReceptance) -> Result<Option<Message>, Message> {
    let mut moduli: Vec<f64> = receptance.lines().map(|(_, h)| h.norm()).collect();
    let middle = moduli.len() / 2;
    let (_, &mut median, _) = moduli.select_nth_unstable_by(middle, f64::total_cmp);
    if (OF_A_RAIL.0..=OF_A_RAIL.1).contains(&median) {
        let least = moduli.iter().copied().fold(f64::INFINITY, f64::min);
        let most = moduli.iter().copied().fold(0.0, f64::max);
        let unusual = least > USUAL.1 || most < USUAL.0;
        return Ok(unusual.then(|| {
            say!(
                receptance_unlike_rail,
                least = number(format_args!("{least:.0e}")),
                most = number(format_args!("{most:.0e}"))
            )
        }));
    }
    Err(format!(
        "half of its receptances are above {median:.1e} m/N, but those of rails are some 1e-11 to 1e-7 m/N: check \
             track.measurement.quantity and unit (a modulus in decibels has unit = \"dB re 1 m/N\")"
    )
    .into())
}

#[cfg(test)]
mod tests;
