//! Wheels on a smooth rail: at rest, or in the limit cycle of an unstable loop.

use std::f64::consts::PI;

use riffel_numerics::fourier::Plans;

use super::{ContactInstant, PassageModel};
use crate::Error;

/// What wheels on a smooth rail do after a push.
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothRail {
    /// Whether it died out, goes on in a limit cycle, or without a period.
    pub outcome: Outcome,
    /// Time rolled until that was seen \[s\].
    pub seconds: f64,
    /// Frequency with which all forces repeat themselves \[Hz\]; none at rest.
    pub frequency: Option<f64>,
    /// What each contact did over the last half second, at rest over the last tenth of one.
    pub contacts: Vec<ContactSwing>,
    /// Instants of the contacts over three periods at the end, one list for each contact.
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
    /// The wheels slide as fast as they roll: their creep forces fall short of what the mean state asks for, and nothing holds them.
    RunsAway,
    /// Windows are not alike after the longest time: a motion without a period, or one that grows or dies out slowly; of a loop
    /// that is unstable also one that is still.
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

/// Windows by which the motion is judged \[s\], and how many are kept and must be alike.
const WINDOW: f64 = 0.1;
const WINDOWS: usize = 5;

impl PassageModel {
    /// Longest step in time on a smooth rail \[s\]: twenty to a period of the highest frequency at which the structures are known.
    pub const LONGEST_TIME_STEP: f64 = 1e-5;

    /// Roll on a smooth rail after a bump of a millisecond, as high as makes a tenth of the load, in steps of at most the
    /// length given \[m\], until windows of a tenth of a second show no force above 10⁻⁴ of the load, or are alike to 10⁻³
    /// five times, or the wheels slide as fast as they roll, or 10 s have passed.
    ///
    /// Where the linear loop is [unstable](crate::feedback::Loop::stability), oscillations grow until the contact
    /// saturates, sticks or lets go: the limit cycle of squeal and of stick and slip. Of its growth rate `growth` \[1/s\] what
    /// the push leaves may be small: no stillness ends the run then, and it takes as long as that needs to grow 10⁹ times, to
    /// a minute at most.
    ///
    /// # Errors
    /// Errors of [`march`](Self::march).
    pub fn on_smooth_rail(&self, largest_step: f64, growth: Option<f64>) -> Result<SmoothRail, Error> {
        const PATIENCE: f64 = 10.0;
        const MOST_PATIENCE: f64 = 60.0;
        const TO_GROW: f64 = 1e9;
        const BUMP: f64 = 1e-3;
        const STILL: f64 = 1e-4;
        const ALIKE: f64 = 1e-3;
        let step = largest_step.min(Self::LONGEST_TIME_STEP * self.speed);
        let mut march = self.march(step)?;
        let to_a_window = (WINDOW * self.speed / step).ceil() as usize;
        let patience = growth.map_or(PATIENCE, |growth| TO_GROW.ln() / growth);
        let windows = (patience.clamp(PATIENCE, MOST_PATIENCE) / WINDOW) as usize;
        // A third of dδ/δ makes half of that in P.
        let bump = 0.07 * self.contacts[0].spring.approach();
        let mut heights = vec![0.0; self.contacts.len()];
        let kept = WINDOWS * to_a_window;
        let mut course = vec![Vec::with_capacity(kept); self.contacts.len()];
        let mut sizes: Vec<f64> = Vec::new();
        let mut outcome = Outcome::Irregular;
        for window in 0..windows {
            if window >= WINDOWS {
                for course in &mut course {
                    course.drain(..to_a_window);
                }
            }
            for index in 0..to_a_window {
                let time = (window * to_a_window + index) as f64 * step / self.speed;
                let angle = PI * (time / BUMP).min(1.0);
                heights.fill(bump * angle.sin().powi(2));
                for (course, now) in course.iter_mut().zip(march.advance(&heights)) {
                    course.push(*now);
                }
            }
            if slides(&course, to_a_window) {
                outcome = Outcome::RunsAway;
                break;
            }
            let size = self.size(&course, to_a_window);
            sizes.push(size);
            if size < STILL && growth.is_none() {
                outcome = Outcome::AtRest;
                // The push is no part of what is left.
                for course in &mut course {
                    course.drain(..course.len() - to_a_window);
                }
                break;
            }
            let last = &sizes[sizes.len().saturating_sub(WINDOWS)..];
            let alike = |other: &f64| (other / size - 1.0).abs() < ALIKE;
            if size > STILL && last.len() == WINDOWS && last.iter().all(alike) {
                outcome = Outcome::LimitCycle;
                break;
            }
        }
        let frequency = match outcome {
            Outcome::AtRest | Outcome::RunsAway => None,
            _ => self.frequency(&course, step / self.speed),
        };
        let contacts = course.iter().zip(&self.contacts);
        let contacts = contacts.map(|(course, contact)| {
            ContactSwing::of(course, |instant| {
                let limit = contact.law.limit(instant.normal_force.max(1e-9 * contact.spring.normal_force()));
                instant.normal_force > 0.0 && instant.creepage.hypot(instant.lateral_creepage) < limit.creepage()
            })
        });
        let contacts = contacts.collect();
        let shown = frequency.map_or(WINDOW, |frequency| 3.0 / frequency);
        let shown = ((shown * self.speed / step).ceil() as usize).max(2);
        for course in &mut course {
            course.drain(..course.len().saturating_sub(shown));
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

    /// Half the largest range of any force over the last instants, over the load.
    fn size(&self, course: &[Vec<ContactInstant>], instants: usize) -> f64 {
        let of_contacts = course.iter().zip(&self.contacts).map(|(course, contact)| {
            let course = &course[course.len() - instants..];
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

    /// That of the shortest time after which all forces are like themselves, as nearly as after any: the first high peak of their
    /// autocorrelation, with a parabola through it. `None` if the longest time is shorter than two periods.
    fn frequency(&self, course: &[Vec<ContactInstant>], step: f64) -> Option<f64> {
        /// Of the highest peak.
        const HIGH: f64 = 0.95;
        let forces: [fn(&ContactInstant) -> f64; 3] =
            [|instant| instant.normal_force, |instant| instant.tangential_force, |instant| instant.lateral_force];
        let count = course.first()?.len();
        // Twice as long, so that the end does not meet the beginning.
        let mut plans = Plans::default();
        let (forward, inverse) = (plans.real_forward(2 * count), plans.real_inverse(2 * count));
        let mut power = inverse.make_input_vec();
        for course in course {
            for force in forces {
                let mean = course.iter().map(force).sum::<f64>() / count as f64;
                let mut values = forward.make_input_vec();
                for (value, instant) in values.iter_mut().zip(course) {
                    *value = force(instant) - mean;
                }
                let mut lines = forward.make_output_vec();
                // Lengths are those of the plan.
                forward.process(&mut values, &mut lines).ok()?;
                for (power, line) in power.iter_mut().zip(lines) {
                    *power += line.norm_sqr();
                }
            }
        }
        let mut correlation = inverse.make_output_vec();
        inverse.process(&mut power, &mut correlation).ok()?;
        // Of what overlaps, up to half of the time.
        let alike: Vec<f64> =
            correlation[..count / 2].iter().enumerate().map(|(lag, value)| value / (count - lag) as f64).collect();
        let below = alike.iter().position(|value| *value < 0.0)?;
        let highest = alike[below..].iter().copied().fold(0.0, f64::max);
        let peak = (below..alike.len() - 1)
            .find(|&lag| alike[lag] > HIGH * highest && alike[lag] >= alike[lag - 1] && alike[lag] >= alike[lag + 1])?;
        let [before, at, after] = [alike[peak - 1], alike[peak], alike[peak + 1]];
        let shift = 0.5 * (before - after) / (before - 2.0 * at + after);
        Some(((peak as f64 + shift) * step).recip())
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

/// Whether some wheel's mean creepage over the last instants is that of a locked wheel, one, or more.
fn slides(course: &[Vec<ContactInstant>], instants: usize) -> bool {
    course.iter().any(|course| {
        let last = &course[course.len() - instants..];
        let sum = |of: fn(&ContactInstant) -> f64| last.iter().map(of).sum::<f64>();
        let along = sum(|instant| instant.creepage);
        let across = sum(|instant| instant.lateral_creepage);
        along.hypot(across) > instants as f64
    })
}

/// Least and largest of something over a course.
fn range(course: &[ContactInstant], of: impl Fn(&ContactInstant) -> f64) -> [f64; 2] {
    course
        .iter()
        .map(of)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(value), most.max(value)])
}
