//! Wheels on a smooth rail: at rest, or in the limit cycle of an unstable loop.

use std::f64::consts::{PI, TAU};

use realfft::RealFftPlanner;

use super::GeneralPassage;
use crate::Error;
use crate::passage::ContactInstant;

/// What wheels on a smooth rail do after a push.
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothRail {
    /// Whether it died out, goes on in a limit cycle, or without a period.
    pub outcome: Outcome,
    /// Time rolled until that was seen \[s\].
    pub seconds: f64,
    /// Strongest frequency of the forces over the last window \[Hz\]; none at rest.
    pub frequency: Option<f64>,
    /// What each contact did over the last window.
    pub contacts: Vec<ContactSwing>,
    /// Instants of the contacts over a few periods at the end, one list for each contact.
    pub course: Vec<Vec<ContactInstant>>,
    /// Distance of the instants \[m\].
    pub step: f64,
}

/// How a motion on a smooth rail ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The push died out.
    AtRest,
    /// Windows are alike: a limit cycle.
    LimitCycle,
    /// Windows are not alike after the longest time: a motion without a period, or one that grows or dies out slowly.
    Irregular,
}

/// Range of what a contact did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactSwing {
    /// Least and largest normal force \[N\].
    pub normal_force: [f64; 2],
    /// Least and largest longitudinal creep force \[N\].
    pub tangential_force: [f64; 2],
    /// Least and largest lateral creep force \[N\].
    pub lateral_force: [f64; 2],
    /// Least and largest longitudinal creepage \[-\].
    pub creepage: [f64; 2],
    /// Least and largest lateral creepage \[-\].
    pub lateral_creepage: [f64; 2],
    /// Share of the time in which the creepage is below that of the greatest creep force, where the law has one: the surfaces stick,
    /// as far as a rolling contact can \[-\].
    pub stick: f64,
    /// Mean energy left on a metre of rail \[J/m\].
    pub dissipation: f64,
}

/// Windows by which the motion is judged \[s\].
const WINDOW: f64 = 0.1;

impl GeneralPassage {
    /// Longest step in time on a smooth rail \[s\]: twenty to a period of the highest frequency at which the structures are known.
    pub const LONGEST_TIME_STEP: f64 = 1e-5;

    /// Roll on a smooth rail after a bump of a millisecond, as high as makes a tenth of the load, in steps of at most the
    /// length given \[m\], until windows of a tenth of a second show no force above 10⁻⁴ of the load, or are alike to 10⁻³
    /// five times, or 10 s have passed.
    ///
    /// Where the linear loop is [unstable](crate::feedback::GeneralLoop::stability), oscillations grow until the contact
    /// saturates, sticks or lets go: the limit cycle of squeal and of stick and slip.
    ///
    /// # Errors
    /// Those of [`march`](Self::march).
    pub fn on_smooth_rail(&self, largest_step: f64) -> Result<SmoothRail, Error> {
        const PATIENCE: f64 = 10.0;
        const BUMP: f64 = 1e-3;
        const STILL: f64 = 1e-4;
        const ALIKE: f64 = 1e-3;
        const ALIKE_WINDOWS: usize = 5;
        let step = largest_step.min(Self::LONGEST_TIME_STEP * self.speed);
        let mut march = self.march(step)?;
        let to_a_window = (WINDOW * self.speed / step).ceil() as usize;
        let windows = (PATIENCE / WINDOW) as usize;
        // A third of dδ/δ makes half of that in P.
        let bump = 0.07 * self.contacts[0].spring.approach();
        let mut heights = vec![0.0; self.contacts.len()];
        let mut course = vec![Vec::with_capacity(to_a_window); self.contacts.len()];
        let mut sizes: Vec<f64> = Vec::new();
        let mut outcome = Outcome::Irregular;
        for window in 0..windows {
            course.iter_mut().for_each(Vec::clear);
            for index in 0..to_a_window {
                let time = (window * to_a_window + index) as f64 * step / self.speed;
                let angle = PI * (time / BUMP).min(1.0);
                heights.fill(bump * angle.sin().powi(2));
                for (course, now) in course.iter_mut().zip(march.advance(&heights)) {
                    course.push(*now);
                }
            }
            let size = self.size(&course);
            sizes.push(size);
            if size < STILL {
                outcome = Outcome::AtRest;
                break;
            }
            let last = &sizes[sizes.len().saturating_sub(ALIKE_WINDOWS)..];
            let alike = |other: &f64| (other / size - 1.0).abs() < ALIKE;
            if last.len() == ALIKE_WINDOWS && last.iter().all(alike) {
                outcome = Outcome::LimitCycle;
                break;
            }
        }
        let frequency = match outcome {
            Outcome::AtRest => None,
            _ => self.strongest_frequency(&course, step / self.speed),
        };
        let contacts = course.iter().zip(&self.contacts);
        let contacts = contacts.map(|(course, contact)| {
            ContactSwing::of(course, |instant| {
                let limit = contact.law.limit(
                    instant
                        .normal_force
                        .max(1e-9 * contact.spring.normal_force()),
                );
                instant.normal_force > 0.0
                    && instant.creepage.hypot(instant.lateral_creepage) < limit.creepage()
            })
        });
        let contacts = contacts.collect();
        // Five periods, or a tenth of the window.
        let shown = frequency.map_or(0.1 * WINDOW, |frequency| 5.0 / frequency);
        let shown = ((shown * self.speed / step).ceil() as usize).clamp(2, to_a_window);
        for course in &mut course {
            course.drain(..to_a_window - shown);
        }
        Ok(SmoothRail {
            outcome,
            seconds: sizes.len() as f64 * to_a_window as f64 * step / self.speed,
            frequency,
            contacts,
            course,
            step,
        })
    }

    /// Largest deviation of any force from its mean state over the load.
    fn size(&self, course: &[Vec<ContactInstant>]) -> f64 {
        let of_contacts = course.iter().zip(&self.contacts).map(|(course, contact)| {
            let range = |of: fn(&ContactInstant) -> f64| {
                let [least, largest] = range(course, of);
                largest - least
            };
            let tangential = range(|instant| instant.tangential_force);
            let lateral = range(|instant| instant.lateral_force);
            let normal = range(|instant| instant.normal_force);
            0.5 * normal.max(tangential).max(lateral) / contact.spring.normal_force()
        });
        of_contacts.fold(0.0, f64::max)
    }

    /// Of the force that moves most, under a window of Hann, with a parabola through the peak.
    fn strongest_frequency(&self, course: &[Vec<ContactInstant>], step: f64) -> Option<f64> {
        let forces: [fn(&ContactInstant) -> f64; 3] = [
            |instant| instant.normal_force,
            |instant| instant.tangential_force,
            |instant| instant.lateral_force,
        ];
        let span = |pair: &(&Vec<ContactInstant>, fn(&ContactInstant) -> f64)| {
            let [least, largest] = range(pair.0, pair.1);
            largest - least
        };
        let (course, force) = course
            .iter()
            .flat_map(|course| forces.map(|force| (course, force)))
            .max_by(|one, other| span(one).total_cmp(&span(other)))?;
        let count = course.len();
        let mean = course.iter().map(force).sum::<f64>() / count as f64;
        let windowed = course.iter().enumerate().map(|(index, instant)| {
            let angle = TAU * index as f64 / count as f64;
            (force(instant) - mean) * (1.0 - angle.cos())
        });
        let mut values: Vec<f64> = windowed.collect();
        let transform = RealFftPlanner::new().plan_fft_forward(count);
        let mut lines = transform.make_output_vec();
        // Lengths are those of the plan.
        transform.process(&mut values, &mut lines).ok()?;
        let sizes: Vec<f64> = lines.iter().map(|line| line.norm()).collect();
        let inner = 1..sizes.len().saturating_sub(1);
        let peak = inner.max_by(|&one, &other| sizes[one].total_cmp(&sizes[other]))?;
        let [before, at, after] = [sizes[peak - 1], sizes[peak], sizes[peak + 1]].map(f64::ln);
        let shift = 0.5 * (before - after) / (before - 2.0 * at + after);
        Some((peak as f64 + shift) / (count as f64 * step))
    }
}

impl ContactSwing {
    fn of(course: &[ContactInstant], sticks: impl Fn(&ContactInstant) -> bool) -> Self {
        let count = course.len() as f64;
        let energies = course.iter().map(ContactInstant::energy_per_metre);
        Self {
            normal_force: range(course, |instant| instant.normal_force),
            tangential_force: range(course, |instant| instant.tangential_force),
            lateral_force: range(course, |instant| instant.lateral_force),
            creepage: range(course, |instant| instant.creepage),
            lateral_creepage: range(course, |instant| instant.lateral_creepage),
            stick: course.iter().filter(|instant| sticks(instant)).count() as f64 / count,
            dissipation: energies.sum::<f64>() / count,
        }
    }
}

/// Least and largest of something over a course.
fn range(course: &[ContactInstant], of: impl Fn(&ContactInstant) -> f64) -> [f64; 2] {
    course.iter().map(of).fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    )
}
