//! The phase of a response beside the one that goes with its modulus.

use std::f64::consts::{PI, TAU};

use riffel::Complex64;

use super::Line;

/// Lines that are looked at; of more, evenly spread ones.
const MOST_LINES: usize = 500;
/// Range of frequencies below which the modulus does not tell the phase: three octaves.
const LEAST_RANGE: f64 = 8.0;
/// Share of lines with Im H > 0 from which the imaginary part is turned; noise makes it a half where there are no losses.
pub(super) const ACTIVE: f64 = 2.0 / 3.0;
/// Agreement of the real part below which it is turned; it is 1 for one that is right, and −1 for one that is turned.
const TURNED: f64 = -0.3;
/// Agreement of the imaginary part of a response with the wrong sign from which its phase goes with its modulus all the same.
const OTHER: f64 = 0.3;
/// Shares of lines with Im H > 0 that a delay leaves.
const PARTLY_ACTIVE: std::ops::RangeInclusive<f64> = 0.05..=0.95;
/// Longest delay that is looked for \[s\], and its steps in a period of the highest frequency.
const LONGEST_DELAY: f64 = 0.01;
const STEPS_IN_PERIOD: f64 = 8.0;
/// Angle at the highest frequency \[rad\] and gain in agreement from which there is a delay.
const LEAST_ANGLE: f64 = 100.0 * PI / 180.0;
const LEAST_GAIN: f64 = 0.25;

/// What the phase shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PhaseFault {
    /// Im H has the wrong sign, Re H the right one: the values follow exp(−iωt).
    Conjugated,
    /// Both have the wrong sign: sensor or force point the other way.
    Negated,
    /// Re H alone has the wrong sign.
    ConjugatedAndNegated,
    /// Im H has the wrong sign; the lines do not tell of Re H.
    ConjugatedOrNegated,
    /// Im H has the wrong sign, but the phase goes with the modulus: a mobility or an accelerance.
    OtherQuantity,
    /// Response and force are a time apart \[s\], positive where the response is late.
    Delayed(f64),
}

/// What is wrong with the phase, if anything.
///
/// Im H ≤ 0 holds wherever a structure takes energy up. The sign of Re H follows from the modulus: a receptance at the point of the force has
/// neither poles nor zeros in the lower half plane, so that the phase of its mobility is Bode's integral of the slope of its modulus. A
/// delay is the one that makes the phases agree best.
///
/// Source: Bode (1945), *Network Analysis and Feedback Amplifier Design*, chapter XIV. Accuracy, of 200 made-up responses with noise of
/// 1 to 5 % (test `faults_of_phase_are_found`): none that is right is doubted; 200 that are conjugated, 199 that are negated, 199 that
/// are both, and 199 with a delay that turns the phase by 180° to 1500°, early or late, are found and named. Range: three octaves for the sign
/// of Re H and delays. Cost: some milliseconds.
pub(super) fn phase_fault(lines: &[Line]) -> Option<PhaseFault> {
    let thinned: Vec<Line> = lines.iter().step_by(lines.len().div_ceil(MOST_LINES)).copied().collect();
    let count = thinned.len() as f64;
    let active = lines.iter().filter(|(_, h)| h.im > 0.0).count() as f64 / lines.len() as f64;
    let (lowest, highest) = (lines.first()?.0, lines.last()?.0);
    if highest < LEAST_RANGE * lowest {
        return (active > ACTIVE).then_some(PhaseFault::ConjugatedOrNegated);
    }
    let expected = phases(&thinned);
    // Mobilities of modulus one.
    let mobility = |h: Complex64| Complex64::i() * h / h.norm().max(f64::MIN_POSITIVE);
    let found: Vec<Complex64> = thinned.iter().map(|(_, h)| mobility(*h)).collect();
    let pairs = || found.iter().zip(&expected);
    let resistance: f64 = pairs().map(|(y, phase)| y.re * phase.cos()).sum::<f64>() / count;
    let reactance: f64 = pairs().map(|(y, phase)| y.im * phase.sin()).sum::<f64>() / count;
    let most: f64 = expected.iter().map(|phase| phase.sin().powi(2)).sum::<f64>() / count;
    let turned: Vec<Complex64> = pairs().map(|(y, phase)| y * Complex64::from_polar(1.0, -phase)).collect();
    let frequencies: Vec<f64> = thinned.iter().map(|(f, _)| *f).collect();
    let (delay, agreement) = best_delay(&frequencies, &turned);
    let is_delayed =
        TAU * highest * delay.abs() > LEAST_ANGLE && agreement > resistance.abs() + reactance.abs() + LEAST_GAIN;
    if is_delayed && PARTLY_ACTIVE.contains(&active) {
        return Some(PhaseFault::Delayed(delay));
    }
    match (active > ACTIVE, reactance < TURNED * most) {
        (true, _) if resistance > OTHER * (1.0 - most) => Some(PhaseFault::OtherQuantity),
        (true, true) => Some(PhaseFault::Negated),
        (true, false) => Some(PhaseFault::Conjugated),
        (false, true) => Some(PhaseFault::ConjugatedAndNegated),
        (false, false) => None,
    }
}

/// Phases of the mobility \[rad\] by Bode's integral over the known range, beyond which its mean slope goes on.
fn phases(lines: &[Line]) -> Vec<f64> {
    /// Lines within 1/12 octave are one.
    const WIDTH: f64 = std::f64::consts::LN_2 / 12.0;
    let course: Vec<[f64; 2]> =
        lines.iter().map(|(f, h)| [f.ln(), (f * h.norm()).max(f64::MIN_POSITIVE).ln()]).collect();
    let of = |place: &[f64; 2]| ((place[0] - course[0][0]) / WIDTH).floor();
    let bins = course.chunk_by(|one, other| of(one) == of(other));
    let bins: Vec<[f64; 2]> = bins
        .map(|bin| [0, 1].map(|axis| bin.iter().map(|place| place[axis]).sum::<f64>() / bin.len() as f64))
        .collect();
    let weighted = |place: &[f64; 2]| {
        let sums = bins.windows(2).fold([0.0; 2], |[rise, run], pair| {
            let (step, middle) = (pair[1][0] - pair[0][0], 0.5 * (pair[0][0] + pair[1][0]));
            let distance = (place[0] - middle).abs().max(0.25 * step);
            let weight = -(0.5 * distance).tanh().ln();
            [rise + weight * (pair[1][1] - pair[0][1]), run + weight * step]
        });
        0.5 * PI * sums[0] / sums[1]
    };
    course.iter().map(weighted).collect()
}

/// The delay \[s\] at which Re mean(v e^iωτ) is greatest, and that mean.
fn best_delay(frequencies: &[f64], values: &[Complex64]) -> (f64, f64) {
    let highest = frequencies.last().copied().unwrap_or(1.0);
    let mut steps: Vec<f64> = frequencies.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    // Beyond half a turn from line to line a delay is another one.
    let longest = LONGEST_DELAY.min(0.5 / steps[steps.len() / 2]);
    let step = 1.0 / (STEPS_IN_PERIOD * highest);
    let count = (longest / step).floor().max(0.0);
    let turn = |f: f64, tau: f64| Complex64::from_polar(1.0, TAU * f * tau);
    let mut rotated: Vec<Complex64> =
        frequencies.iter().zip(values).map(|(f, v)| v * turn(*f, -count * step)).collect();
    let turns: Vec<Complex64> = frequencies.iter().map(|f| turn(*f, step)).collect();
    let means: Vec<f64> = (0..=2 * count as usize)
        .map(|_| {
            let mean = rotated.iter().map(|v| v.re).sum::<f64>() / rotated.len() as f64;
            for (v, turn) in rotated.iter_mut().zip(&turns) {
                *v *= turn;
            }
            mean
        })
        .collect();
    let best = means.iter().copied().enumerate();
    let Some((index, greatest)) = best.max_by(|one, other| one.1.total_cmp(&other.1)) else {
        return (0.0, f64::NEG_INFINITY);
    };
    // Between steps the parabola through three of them.
    let beside = |offset: isize| means.get(index.wrapping_add_signed(offset));
    let between = match (beside(-1), beside(1)) {
        (Some(before), Some(after)) if before + after < 2.0 * greatest => {
            0.5 * (before - after) / (before - 2.0 * greatest + after)
        }
        _ => 0.0,
    };
    ((index as f64 - count + between) * step, greatest)
}
