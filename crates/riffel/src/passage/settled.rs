//! The settled state over a sinusoid.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::along_profile::{faded, felt};
use super::on_rail::OnRail;
use super::{ContactInstant, ImpulseResponse, PassageModel};
use crate::Error;

/// A profile Δ cos(2πx/λ), upward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// Amplitude Δ \[m\].
    pub amplitude: f64,
    /// Wavelength λ \[m\].
    pub wavelength: f64,
}

/// Bays that a state on discrete supports is averaged over, and lines of the window's spectrum from which on it leaves
/// nothing: four widths to a bay.
const BAYS: f64 = 16.0;
const WIDTH: f64 = 4.0;

impl Sinusoid {
    /// Fewest steps to a wave: fewer do not show the fifth harmonic.
    pub const LEAST_STEPS: usize = 20;

    /// Most steps to a wave that are worth their minutes.
    pub const MOST_STEPS: usize = 16384;

    /// `Ok` if it is a wave that so many steps resolve.
    pub(super) fn check(&self, steps: usize) -> Result<(), Error> {
        Error::unless_positive("amplitude", self.amplitude, "m")?;
        Error::unless_positive("wavelength", self.wavelength, "m")?;
        match steps < Self::LEAST_STEPS {
            false => Ok(()),
            true => Err(Error::OutOfRange {
                quantity: "number of steps to a wave",
                value: steps as f64,
                unit: "",
                rule: "must be at least 20",
            }),
        }
    }

    /// Steps to a wave that leave some 10⁻⁴ of a first harmonic at a speed \[m/s\]. A slow wave takes more, so that wheel and contact
    /// spring are followed, whose own oscillations last a millisecond.
    pub fn usual_steps(&self, speed: f64) -> usize {
        const LEAST: f64 = 256.0;
        /// \[s\]
        const LONGEST_STEP: f64 = 4e-5;
        f64::max(LEAST, (self.wavelength / speed / LONGEST_STEP).ceil()) as usize
    }

    /// The line m of what supports at a spacing \[m\] make of a load, d/m long, that a settled state cannot tell from this
    /// wave, if there is one: |1/λ − m/d| < 1/4d, m = 1 … 8.
    pub fn shares_lines_with(&self, spacing: f64) -> Option<usize> {
        let waves = spacing / self.wavelength;
        let line = waves.round() as usize;
        let close = (waves - waves.round()).abs() < WIDTH / BAYS;
        (close && (1..=ImpulseResponse::MOST_HARMONICS).contains(&line)).then_some(line)
    }
}

/// Complex amplitudes of one harmonic, for exp(+inωt) relative to the profile Δ cos ωt; of harmonic zero the means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// \[N\]
    pub normal_force: Complex64,
    /// \[N\]
    pub tangential_force: Complex64,
    /// \[N\]
    pub lateral_force: Complex64,
    /// \[-\]
    pub creepage: Complex64,
    /// \[-\]
    pub lateral_creepage: Complex64,
    /// Of the energy per metre at the wheel centre \[J/m\].
    pub dissipation: Complex64,
}

/// Rolling over a sinusoid, where every wave is like the one before, or on discrete supports every long stretch.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// Harmonics n = 0 … 5.
    pub harmonics: [Harmonic; 6],
    /// Share of the time without contact \[-\].
    pub contact_loss: f64,
    /// Least and largest normal force \[N\].
    pub normal_force: [f64; 2],
    /// The contact at equal steps over the last wave, the crest last.
    pub wave: Vec<ContactInstant>,
    /// The contact at the crest before that wave.
    pub crest: ContactInstant,
    /// Waves rolled over until the state was settled.
    pub waves: usize,
}

/// Time over which a settled state no longer changes \[s\], and the largest change of any harmonic of normal force or
/// creepage, over the first: waves follow one another a hundred times faster.
pub(super) const REST: f64 = 0.1;
pub(super) const CHANGE: f64 = 1e-5;
/// Of rolling, after which a state that is not settled is given up \[s\].
pub(super) const PATIENCE: f64 = 20.0;

/// Share of the time without contact above which the wheel hops from crest to crest.
pub(super) const MOST_LOSS: f64 = 0.9;

impl PassageModel {
    /// The settled state over a sinusoid, in `steps` steps to a wave: a march whose amplitude grows from nothing and that
    /// goes on until harmonics of a tenth of a second ago are those of now to 10⁻⁵ of the first.
    ///
    /// With a contact filter the wheel feels what this leaves of the amplitude.
    ///
    /// On discrete supports no wave is like the one before. There harmonics are those of 16 bays and eight waves or more after
    /// the memory of the track, under a window of Blackman and Harris: means over the places of the bay, free to 10⁻⁴ of
    /// what the supports make of the load, at d/m, unless 1/λ and m/d are [too close](Sinusoid::shares_lines_with).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless amplitude and wavelength are positive and there are 20 steps or more;
    /// [`Error::NotSettled`] where the motion does not take the period of the profile within 20 s of rolling, and
    /// [`Error::Airborne`] where the wheel is in the air for more than nine tenths of a wave.
    pub fn settle(&self, profile: Sinusoid, steps: usize) -> Result<Settled, Error> {
        profile.check(steps)?;
        let Sinusoid {
            amplitude,
            wavelength,
        } = profile;
        let amplitude = amplitude * felt(self.contact_filter, wavelength);
        if let Some(spacing) = self.track.support_spacing() {
            let felt = Sinusoid {
                amplitude,
                wavelength,
            };
            let start = |step, before| self.march_before(step, before);
            let mut settled = settle_over_supports(felt, steps, spacing, self.memory()?, start)?;
            return Ok(settled.swap_remove(0));
        }
        let mut march = self.march(wavelength / steps as f64)?;
        let period = wavelength / self.speed;
        let waves_of = |time: f64| (time / period).ceil();
        let (rest, patience) = (waves_of(REST) as usize, waves_of(PATIENCE) as usize);
        let onset = waves_of(0.5 * REST).max(4.0);
        let heights: Vec<f64> = (1..=steps)
            .map(|step| amplitude * (TAU * step as f64 / steps as f64).cos())
            .collect();
        let mut wave = Vec::with_capacity(steps);
        let mut before: Option<[Harmonic; 6]> = None;
        let mut change = f64::INFINITY;
        for number in 0..patience {
            wave.clear();
            for (step, height) in heights.iter().enumerate() {
                let rolled = (number as f64 + (step + 1) as f64 / steps as f64) / onset;
                wave.push(march.advance(height * faded(rolled)));
            }
            let share = contact_loss(&wave);
            if share > MOST_LOSS {
                return Err(Error::Airborne {
                    share,
                    amplitude,
                    wavelength,
                });
            }
            if (number + 1) % rest != 0 {
                continue;
            }
            let now = harmonics(&wave);
            if let Some(before) = before {
                change = largest_change(&before, &now);
                if change <= CHANGE {
                    let forces = wave.iter().map(|instant| instant.normal_force);
                    return Ok(Settled {
                        harmonics: now,
                        contact_loss: share,
                        normal_force: [
                            forces.clone().fold(f64::INFINITY, f64::min),
                            forces.fold(f64::NEG_INFINITY, f64::max),
                        ],
                        // Every wave is like the one before.
                        crest: wave[steps - 1],
                        wave,
                        waves: number + 1,
                    });
                }
            }
            before = Some(now);
        }
        Err(Error::NotSettled {
            seconds: PATIENCE,
            change,
        })
    }
}

/// The settled state of every contact over a sinusoid as the wheels feel it, on discrete supports at a spacing \[m\], after the length of
/// a memory \[m\]; `start` begins a march with a step, a distance before the wave \[m\].
pub(super) fn settle_over_supports<M: OnRail>(
    profile: Sinusoid,
    steps: usize,
    spacing: f64,
    memory: f64,
    start: impl FnOnce(f64, f64) -> Result<M, Error>,
) -> Result<Vec<Settled>, Error> {
    const WAVES: f64 = 8.0;
    let Sinusoid {
        amplitude,
        wavelength,
    } = profile;
    let waves_of = |length: f64| (length / wavelength).ceil() as usize;
    let (before, counted) = (
        waves_of(memory),
        waves_of(f64::max(BAYS * spacing, WAVES * wavelength)),
    );
    let mut march = start(wavelength / steps as f64, before as f64 * wavelength)?;
    let mut contacts = vec![Vec::with_capacity(counted * steps); march.contacts().len()];
    let onset = 0.25 * (before * steps) as f64;
    for index in 1..=(before + counted) * steps {
        let share = faded(index as f64 / onset);
        let angle = TAU * (index % steps) as f64 / steps as f64;
        march.advance_over(|ahead| amplitude * share * (angle + TAU * ahead / wavelength).cos());
        if index > before * steps {
            for (contacts, now) in contacts.iter_mut().zip(march.contacts()) {
                contacts.push(*now);
            }
        }
    }
    let shares = contacts.iter().map(|contacts| contact_loss(contacts));
    let share = shares.clone().fold(0.0, f64::max);
    if share > MOST_LOSS {
        return Err(Error::Airborne {
            share,
            amplitude,
            wavelength,
        });
    }
    let settled = shares.collect::<Vec<f64>>().into_iter().zip(contacts);
    Ok(settled
        .map(|(contact_loss, mut contacts)| {
            let forces = contacts.iter().map(|instant| instant.normal_force);
            Settled {
                harmonics: windowed_harmonics(&contacts, steps),
                contact_loss,
                normal_force: [
                    forces.clone().fold(f64::INFINITY, f64::min),
                    forces.fold(f64::NEG_INFINITY, f64::max),
                ],
                crest: contacts[contacts.len() - steps - 1],
                wave: contacts.split_off(contacts.len() - steps),
                waves: before + counted,
            }
        })
        .collect())
}

/// Those of many waves, under a window whose sidelobes are below 3·10⁻⁵ from four lines on (Harris 1978).
fn windowed_harmonics(contacts: &[ContactInstant], steps: usize) -> [Harmonic; 6] {
    const WINDOW: [f64; 4] = [0.35875, -0.48829, 0.14128, -0.01168];
    let length = contacts.len() as f64;
    // The mean of the window is its first coefficient.
    let weights = (1..=contacts.len()).map(|index| {
        let angle = TAU * index as f64 / length;
        let terms = WINDOW.iter().zip(0..);
        let sum: f64 = terms
            .map(|(part, n)| part * (angle * f64::from(n)).cos())
            .sum();
        sum / WINDOW[0]
    });
    weighted_harmonics(contacts.iter().zip(weights), length, steps)
}

/// Sums over equal steps: exact for all harmonics that the steps resolve.
pub(super) fn harmonics(wave: &[ContactInstant]) -> [Harmonic; 6] {
    let weighted = wave.iter().map(|instant| (instant, 1.0));
    weighted_harmonics(weighted, wave.len() as f64, wave.len())
}

/// Sums over `length` instants with weights whose mean is one, `steps` to a wave, the last of them a crest.
fn weighted_harmonics<'a>(
    instants: impl Iterator<Item = (&'a ContactInstant, f64)>,
    length: f64,
    steps: usize,
) -> [Harmonic; 6] {
    let none = Harmonic {
        normal_force: Complex64::ZERO,
        tangential_force: Complex64::ZERO,
        lateral_force: Complex64::ZERO,
        creepage: Complex64::ZERO,
        lateral_creepage: Complex64::ZERO,
        dissipation: Complex64::ZERO,
    };
    let mut harmonics = [none; 6];
    for (index, (instant, weight)) in instants.enumerate() {
        for (n, harmonic) in harmonics.iter_mut().enumerate() {
            let scale = if n == 0 { 1.0 } else { 2.0 } / length;
            let angle = TAU * (n * (index + 1) % steps) as f64 / steps as f64;
            let turn = Complex64::from_polar(scale * weight, -angle);
            harmonic.normal_force += turn * instant.normal_force;
            harmonic.tangential_force += turn * instant.tangential_force;
            harmonic.lateral_force += turn * instant.lateral_force;
            harmonic.creepage += turn * instant.creepage;
            harmonic.lateral_creepage += turn * instant.lateral_creepage;
            harmonic.dissipation += turn * instant.energy_per_metre();
        }
    }
    harmonics
}

/// Largest difference of normal force and of creepage, each over its first harmonic.
pub(super) fn largest_change(before: &[Harmonic; 6], now: &[Harmonic; 6]) -> f64 {
    let largest = |of: fn(&Harmonic) -> Complex64| {
        let pairs = before.iter().zip(now);
        let changes = pairs.map(|(before, now)| (of(now) - of(before)).norm());
        let first = of(&now[1]).norm();
        match first > 0.0 {
            true => changes.fold(0.0, f64::max) / first,
            // Held creepage.
            false => 0.0,
        }
    };
    largest(|harmonic| harmonic.normal_force).max(largest(|harmonic| harmonic.creepage))
}

/// Share of a wave with the approach below zero, linear between steps.
pub(super) fn contact_loss(wave: &[ContactInstant]) -> f64 {
    let following = wave.iter().skip(1).chain(wave.first());
    let parts = wave.iter().zip(following).map(|(one, other)| {
        let (one, other) = (one.approach, other.approach);
        match (one < 0.0, other < 0.0) {
            (true, true) => 1.0,
            (false, false) => 0.0,
            (true, false) => one / (one - other),
            (false, true) => other / (other - one),
        }
    });
    parts.sum::<f64>() / wave.len() as f64
}
