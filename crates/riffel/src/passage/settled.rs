//! The settled state over a sinusoid.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::along_profile::faded;
use super::patch_average::PatchAverageWave;
use super::{ContactInTime, ContactInstant, ImpulseResponse, PassageModel};
use crate::Error;
use crate::cancel::check;

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
    fn check(&self, steps: usize) -> Result<(), Error> {
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
const REST: f64 = 0.1;
const CHANGE: f64 = 1e-5;
/// Of rolling, after which a state that is not settled is given up \[s\].
const PATIENCE: f64 = 20.0;

/// Share of the time without contact above which the wheel hops from crest to crest.
const MOST_LOSS: f64 = 0.9;

impl PassageModel {
    /// The settled state of every contact over a sinusoid, in `steps` steps to a wave, the first wheel first: a march whose amplitude grows
    /// from nothing and that goes on until harmonics of a tenth of a second ago are those of now to 10⁻⁵ of the first. They are relative to
    /// the profile Δ cos ωt under the first wheel, along the normal of its contact.
    ///
    /// With a contact filter the wheels feel what this leaves of the amplitude.
    ///
    /// On discrete supports no wave is like the one before. There harmonics are those of 16 bays and eight waves or more after
    /// the memory of the track, under a window of Blackman and Harris: means over the places of the bay, free to 10⁻⁴ of
    /// what the supports make of the load, at d/m, unless 1/λ and m/d are [too close](Sinusoid::shares_lines_with).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless amplitude and wavelength are positive and there are 20 steps or more;
    /// [`Error::NotSettled`] where the motion does not take the period of the profile within 20 s of rolling, as of a loop that is unstable
    /// without a profile too, and [`Error::Airborne`] where a wheel is in the air for more than nine tenths of a wave.
    pub fn settle(&self, profile: Sinusoid, steps: usize) -> Result<Vec<Settled>, Error> {
        profile.check(steps)?;
        let averaged = |contact: &ContactInTime| {
            let PatchAverageWave(by_height) = self.average_of_wave(contact, profile.wavelength);
            PatchAverageWave(by_height.map(|by| profile.amplitude * by))
        };
        let averaged: Vec<PatchAverageWave> = self.contacts.iter().map(averaged).collect();
        if let Some(spacing) = self.structures.support_spacing() {
            return self.settle_over_supports(profile, &averaged, steps, spacing);
        }
        let wavelength = profile.wavelength;
        let mut march = self.march(wavelength / steps as f64)?;
        let waves_of = |time: f64| (time * self.speed / wavelength).ceil();
        let (rest, patience) = (waves_of(REST) as usize, waves_of(PATIENCE) as usize);
        let onset = waves_of(0.5 * REST).max(4.0);
        let mut waves = vec![Vec::with_capacity(steps); self.contacts.len()];
        let mut before: Option<Vec<[Harmonic; 6]>> = None;
        let mut change = f64::INFINITY;
        for number in 1..=patience {
            check();
            waves.iter_mut().for_each(Vec::clear);
            for step in 1..=steps {
                let share = step as f64 / steps as f64;
                let grown = faded(((number - 1) as f64 + share) / onset);
                let wave = |ahead: f64| Complex64::cis(TAU * share + TAU * ahead / wavelength);
                march.advance_along(|index, ahead| averaged[index].times(grown).at(wave(ahead)));
                for (wave, instant) in waves.iter_mut().zip(march.now()) {
                    wave.push(*instant);
                }
            }
            let losses = losses(&waves, &profile)?;
            if !number.is_multiple_of(rest) {
                continue;
            }
            let now: Vec<[Harmonic; 6]> = waves.iter().map(|wave| harmonics(wave)).collect();
            if let Some(before) = before {
                change = largest_change(&before, &now);
                if change <= CHANGE {
                    let contacts = now.into_iter().zip(losses).zip(waves);
                    let settled = contacts.map(|((harmonics, contact_loss), wave)| Settled {
                        harmonics,
                        contact_loss,
                        normal_force: range(&wave),
                        // Every wave is like the one before.
                        crest: wave[steps - 1],
                        wave,
                        waves: number,
                    });
                    return Ok(settled.collect());
                }
            }
            before = Some(now);
        }
        Err(Error::NotSettled { seconds: PATIENCE, change })
    }

    /// Settled state on a sinusoid with what the contacts feel of it, on discrete supports at a spacing \[m\].
    fn settle_over_supports(
        &self,
        profile: Sinusoid,
        averaged: &[PatchAverageWave],
        steps: usize,
        spacing: f64,
    ) -> Result<Vec<Settled>, Error> {
        const WAVES: f64 = 8.0;
        let wavelength = profile.wavelength;
        let waves_of = |length: f64| (length / wavelength).ceil() as usize;
        let (before, counted) = (waves_of(self.memory()?), waves_of(f64::max(BAYS * spacing, WAVES * wavelength)));
        let mut march = self.march_before(wavelength / steps as f64, before as f64 * wavelength)?;
        let mut contacts = vec![Vec::with_capacity(counted * steps); self.contacts.len()];
        let onset = 0.25 * (before * steps) as f64;
        for index in 1..=(before + counted) * steps {
            if index % steps == 0 {
                check();
            }
            let grown = faded(index as f64 / onset);
            let angle = TAU * (index % steps) as f64 / steps as f64;
            let wave = |ahead: f64| Complex64::cis(angle + TAU * ahead / wavelength);
            march.advance_along(|index, ahead| averaged[index].times(grown).at(wave(ahead)));
            if index > before * steps {
                for (contacts, now) in contacts.iter_mut().zip(march.now()) {
                    contacts.push(*now);
                }
            }
        }
        let settled = losses(&contacts, &profile)?.into_iter().zip(contacts);
        let settled = settled.map(|(contact_loss, mut contacts)| Settled {
            harmonics: windowed_harmonics(&contacts, steps),
            contact_loss,
            normal_force: range(&contacts),
            crest: contacts[contacts.len() - steps - 1],
            wave: contacts.split_off(contacts.len() - steps),
            waves: before + counted,
        });
        Ok(settled.collect())
    }
}

/// Shares of the time without contact, if no wheel is in the air for nearly all of it.
fn losses(contacts: &[Vec<ContactInstant>], profile: &Sinusoid) -> Result<Vec<f64>, Error> {
    let losses: Vec<f64> = contacts.iter().map(|wave| contact_loss(wave)).collect();
    let share = losses.iter().copied().fold(0.0, f64::max);
    match share > MOST_LOSS {
        true => Err(Error::Airborne { share, amplitude: profile.amplitude, wavelength: profile.wavelength }),
        false => Ok(losses),
    }
}

/// Least and largest normal force.
fn range(contacts: &[ContactInstant]) -> [f64; 2] {
    let forces = contacts.iter().map(|instant| instant.normal_force);
    [forces.clone().fold(f64::INFINITY, f64::min), forces.fold(f64::NEG_INFINITY, f64::max)]
}

/// Harmonics of many waves, under a window whose sidelobes are below 3·10⁻⁵ from four lines on (Harris 1978).
fn windowed_harmonics(contacts: &[ContactInstant], steps: usize) -> [Harmonic; 6] {
    const WINDOW: [f64; 4] = [0.35875, -0.48829, 0.14128, -0.01168];
    let length = contacts.len() as f64;
    // The mean of the window is its first coefficient.
    let weights = (1..=contacts.len()).map(|index| {
        let angle = TAU * index as f64 / length;
        let terms = WINDOW.iter().zip(0..);
        let sum: f64 = terms.map(|(part, n)| part * (angle * f64::from(n)).cos()).sum();
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

/// Largest difference of normal force and creepages at any contact, each over the largest first harmonic.
pub(super) fn largest_change(before: &[[Harmonic; 6]], now: &[[Harmonic; 6]]) -> f64 {
    let largest = |of: fn(&Harmonic) -> f64, difference: fn(&Harmonic, &Harmonic) -> f64| {
        let firsts = now.iter().map(|harmonics| of(&harmonics[1]));
        let first = firsts.fold(0.0, f64::max);
        let pairs = before.iter().flatten().zip(now.iter().flatten());
        let changes = pairs.map(|(before, now)| difference(before, now));
        match first > 0.0 {
            true => changes.fold(0.0, f64::max) / first,
            // Held creepages.
            false => 0.0,
        }
    };
    let creepage = |harmonic: &Harmonic| harmonic.creepage.norm().hypot(harmonic.lateral_creepage.norm());
    let normal =
        largest(|harmonic| harmonic.normal_force.norm(), |before, now| (now.normal_force - before.normal_force).norm());
    let tangential = largest(creepage, |before, now| {
        let along = (now.creepage - before.creepage).norm();
        along.hypot((now.lateral_creepage - before.lateral_creepage).norm())
    });
    normal.max(tangential)
}

/// Share of a wave with the approach below zero, linear between steps.
fn contact_loss(wave: &[ContactInstant]) -> f64 {
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
