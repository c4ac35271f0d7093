//! The settled state over a sinusoid.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::{ContactInstant, PassageModel};
use crate::Error;

/// A profile Δ cos(2πx/λ), upward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// Amplitude Δ \[m\].
    pub amplitude: f64,
    /// Wavelength λ \[m\].
    pub wavelength: f64,
}

/// Complex amplitudes of one harmonic, for exp(+inωt) relative to the profile Δ cos ωt; of harmonic zero the means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// \[N\]
    pub normal_force: Complex64,
    /// \[N\]
    pub tangential_force: Complex64,
    /// \[-\]
    pub creepage: Complex64,
    /// Of the energy per metre at the wheel centre \[J/m\].
    pub dissipation: Complex64,
}

/// Rolling over a sinusoid, where every wave is like the one before.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// Harmonics n = 0 … 5.
    pub harmonics: [Harmonic; 6],
    /// Share of the time without contact \[-\].
    pub contact_loss: f64,
    /// Least and largest normal force \[N\].
    pub normal_force: [f64; 2],
    /// The contact at equal steps over one wave, the crest last.
    pub wave: Vec<ContactInstant>,
    /// Waves rolled over until the state was settled.
    pub waves: usize,
}

/// Time over which a settled state no longer changes \[s\], and the largest change of any harmonic of normal force or
/// creepage, over the first: waves follow one another a hundred times faster.
const REST: f64 = 0.1;
const CHANGE: f64 = 1e-5;

impl PassageModel {
    /// The settled state over a sinusoid, in `steps` steps to a wave: a march whose amplitude grows from nothing and that
    /// goes on until harmonics of a tenth of a second ago are those of now to 10⁻⁵ of the first.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless amplitude and wavelength are positive and there are 20 steps or more;
    /// [`Error::NotSettled`] where the motion does not take the period of the profile within 20 s of rolling, and
    /// [`Error::Airborne`] where the wheel is in the air for more than nine tenths of a wave.
    pub fn settle(&self, profile: Sinusoid, steps: usize) -> Result<Settled, Error> {
        const LEAST_STEPS: usize = 20;
        /// Above, the wheel hops from crest to crest.
        const MOST_LOSS: f64 = 0.9;
        /// Of rolling \[s\].
        const PATIENCE: f64 = 20.0;
        let Sinusoid {
            amplitude,
            wavelength,
        } = profile;
        Error::unless_positive("amplitude", amplitude, "m")?;
        Error::unless_positive("wavelength", wavelength, "m")?;
        if steps < LEAST_STEPS {
            return Err(Error::OutOfRange {
                quantity: "number of steps to a wave",
                value: steps as f64,
                unit: "",
                rule: "must be at least 20",
            });
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
                let share = rolled.min(1.0);
                wave.push(march.advance(height * share * share * (3.0 - 2.0 * share)));
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

/// Sums over equal steps: exact for all harmonics that the steps resolve.
fn harmonics(wave: &[ContactInstant]) -> [Harmonic; 6] {
    let steps = wave.len() as f64;
    std::array::from_fn(|n| {
        let mut harmonic = Harmonic {
            normal_force: Complex64::ZERO,
            tangential_force: Complex64::ZERO,
            creepage: Complex64::ZERO,
            dissipation: Complex64::ZERO,
        };
        let scale = if n == 0 { 1.0 } else { 2.0 } / steps;
        for (step, instant) in wave.iter().enumerate() {
            let angle = TAU * n as f64 * (step + 1) as f64 / steps;
            let turn = Complex64::from_polar(scale, -angle);
            harmonic.normal_force += turn * instant.normal_force;
            harmonic.tangential_force += turn * instant.tangential_force;
            harmonic.creepage += turn * instant.creepage;
            harmonic.dissipation += turn * instant.energy_per_metre();
        }
        harmonic
    })
}

/// Largest difference of normal force and of creepage, each over its first harmonic.
fn largest_change(before: &[Harmonic; 6], now: &[Harmonic; 6]) -> f64 {
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
