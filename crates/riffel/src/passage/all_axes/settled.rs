//! The settled state of all contacts over a sinusoid.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::GeneralPassage;
use crate::Error;
use crate::passage::along_profile::{faded, felt};
use crate::passage::settled::{
    CHANGE, MOST_LOSS, PATIENCE, REST, contact_loss, harmonics, settle_over_supports,
};
use crate::passage::{ContactInstant, Harmonic, Settled, Sinusoid};

/// The rail under all contacts, as the wave that grows from nothing.
struct Wave<'a> {
    model: &'a GeneralPassage,
    profile: Sinusoid,
    steps: usize,
    /// Waves over which it grows.
    onset: f64,
}

impl Wave<'_> {
    /// Heights under the contacts after so many steps of a wave \[m\].
    fn heights(&self, number: usize, step: usize, heights: &mut [f64]) {
        let rolled = number as f64 + step as f64 / self.steps as f64;
        let grown = self.profile.amplitude * faded(rolled / self.onset);
        let angle = TAU * step as f64 / self.steps as f64;
        for (height, contact) in heights.iter_mut().zip(&self.model.contacts) {
            let behind = TAU * contact.along / self.profile.wavelength;
            *height = grown * contact.profile * (angle + behind).cos();
        }
    }
}

impl GeneralPassage {
    /// The settled state of every contact over a sinusoid, in `steps` steps to a wave, as
    /// [`PassageModel::settle`](crate::passage::PassageModel::settle) finds it: harmonics are relative to the profile
    /// Δ cos ωt under the first wheel, along the normal of its contact. On discrete supports likewise: means over the places of the bay.
    ///
    /// # Errors
    /// Those of one wheel; [`Error::NotSettled`] where the loop is unstable without a profile too.
    pub fn settle(&self, profile: Sinusoid, steps: usize) -> Result<Vec<Settled>, Error> {
        profile.check(steps)?;
        let Sinusoid {
            amplitude,
            wavelength,
        } = profile;
        let profile = Sinusoid {
            amplitude: amplitude * felt(self.contact_filter, wavelength),
            wavelength,
        };
        if let Some(spacing) = self.structures.support_spacing() {
            let start = |step, before| self.march_before(step, before);
            return settle_over_supports(profile, steps, spacing, self.memory()?, start);
        }
        let mut march = self.march(wavelength / steps as f64)?;
        let waves_of = |time: f64| (time * self.speed / wavelength).ceil();
        let (rest, patience) = (waves_of(REST) as usize, waves_of(PATIENCE) as usize);
        let rail = Wave {
            model: self,
            profile,
            steps,
            onset: waves_of(0.5 * REST).max(4.0),
        };
        let count = self.contacts.len();
        let mut waves: Vec<Vec<ContactInstant>> = vec![Vec::with_capacity(steps); count];
        let mut heights = vec![0.0; count];
        let mut before: Option<Vec<[Harmonic; 6]>> = None;
        let mut change = f64::INFINITY;
        for number in 0..patience {
            waves.iter_mut().for_each(Vec::clear);
            for step in 1..=steps {
                rail.heights(number, step, &mut heights);
                for (wave, instant) in waves.iter_mut().zip(march.advance(&heights)) {
                    wave.push(*instant);
                }
            }
            let share = waves.iter().map(|wave| contact_loss(wave));
            let share = share.fold(0.0, f64::max);
            if share > MOST_LOSS {
                return Err(Error::Airborne {
                    share,
                    amplitude,
                    wavelength,
                });
            }
            if !(number + 1).is_multiple_of(rest) {
                continue;
            }
            let now: Vec<[Harmonic; 6]> = waves.iter().map(|wave| harmonics(wave)).collect();
            if let Some(before) = before {
                change = largest_change(&before, &now);
                if change <= CHANGE {
                    let pairs = now.into_iter().zip(waves);
                    return Ok(pairs
                        .map(|(harmonics, wave)| settled(harmonics, wave, number + 1))
                        .collect());
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

fn settled(harmonics: [Harmonic; 6], wave: Vec<ContactInstant>, waves: usize) -> Settled {
    let forces = wave.iter().map(|instant| instant.normal_force);
    Settled {
        harmonics,
        contact_loss: contact_loss(&wave),
        normal_force: [
            forces.clone().fold(f64::INFINITY, f64::min),
            forces.fold(f64::NEG_INFINITY, f64::max),
        ],
        // Every wave is like the one before.
        crest: wave[wave.len() - 1],
        wave,
        waves,
    }
}

/// Largest difference of normal force and creepages at any contact, each over the largest first harmonic.
fn largest_change(before: &[[Harmonic; 6]], now: &[[Harmonic; 6]]) -> f64 {
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
    let creepage = |harmonic: &Harmonic| {
        let [along, across]: [Complex64; 2] = [harmonic.creepage, harmonic.lateral_creepage];
        along.norm().hypot(across.norm())
    };
    let normal = largest(
        |harmonic| harmonic.normal_force.norm(),
        |before, now| (now.normal_force - before.normal_force).norm(),
    );
    let tangential = largest(creepage, |before, now| {
        let along = (now.creepage - before.creepage).norm();
        along.hypot((now.lateral_creepage - before.lateral_creepage).norm())
    });
    normal.max(tangential)
}
