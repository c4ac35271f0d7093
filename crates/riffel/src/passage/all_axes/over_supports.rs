//! A rail on discrete supports under several wheels in time, down and across.

use num_complex::Complex64;
use rayon::prelude::*;

use crate::feedback::GeneralLoop;
use crate::passage::ImpulseResponse;
use crate::passage::along_profile::{faded, slope_of_faded};
use crate::passage::over_supports::{AlongBay, ONSET_BAYS, frequencies, is_discrete};
use crate::passage::track_motion::TrackMotion;
use crate::receptance::{HarmonicMatrices, SpatialMovingLoad};
use crate::{Direction, Error, Place, Rail};

/// The answers of a rail to impulses at all contacts, down and across in the axes of the track, where they depend on the place of
/// the first wheel in its bay: [`ImpulseResponse::over_supports`] for every pair of contacts and axes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TrackOverSupports {
    /// \[m\]
    spacing: f64,
    entries: Vec<Entry>,
    /// Sine, with the sign of its rail, and cosine of the angle of each contact.
    angles: Vec<[f64; 2]>,
}

#[derive(Debug, Clone, PartialEq)]
struct Entry {
    row: usize,
    column: usize,
    response: ImpulseResponse,
}

impl TrackOverSupports {
    /// Those of the contacts of a loop under loads that move along a track.
    ///
    /// # Errors
    /// Those of [`ImpulseResponse::over_supports`].
    pub(super) fn of(feedback: &GeneralLoop, track: &SpatialMovingLoad) -> Result<Self, Error> {
        /// Of √|H_ii H_jj|: an entry below is rounding.
        const NOTHING: f64 = 1e-6;
        let most = ImpulseResponse::MOST_HARMONICS;
        let places = places(feedback);
        let size = places.len();
        let samples: Vec<(f64, HarmonicMatrices)> = frequencies()
            .into_par_iter()
            .map(|w| {
                let matrices = match is_discrete(w) {
                    true => track.answers_to_impulses(w, &places, most)?,
                    false => track.evenly(w, &places),
                };
                Ok((w, matrices))
            })
            .collect::<Result<_, Error>>()?;
        let at_rest = track.harmonics(0.0, &places, most)?;
        let mut entries: Vec<Entry> = Vec::new();
        let mut fitted: Vec<AlongBay> = Vec::new();
        for row in 0..size {
            for column in 0..size {
                if is_along(row) || is_along(column) {
                    continue;
                }
                let samples = samples.iter().map(|(w, matrices)| {
                    let at = |n: isize, row: usize, column: usize| {
                        let matrix = matrices.at(n);
                        matrix.map_or(Complex64::ZERO, |matrix| matrix[row * size + column])
                    };
                    let own = |index: usize| at(0, index, index).norm();
                    let parts = AlongBay::parts(|n| at(n, row, column));
                    (*w, parts, (own(row) * own(column)).sqrt())
                });
                let transfer = AlongBay::new(samples.collect());
                if !transfer.exceeds(NOTHING) {
                    continue;
                }
                let ahead = (1..=most as isize).filter_map(|n| at_rest.at(n));
                let ahead = ahead.map(|matrix| matrix[row * size + column]);
                // Both rails are alike.
                let known = fitted.iter().position(|known| known.is(&transfer));
                let response = match known {
                    Some(known) => entries[known].response.clone(),
                    None => {
                        ImpulseResponse::along_bay(&transfer, ahead.collect(), track.spacing())?
                    }
                };
                fitted.push(transfer);
                entries.push(Entry {
                    row,
                    column,
                    response,
                });
            }
        }
        let contacts = feedback.contacts().iter();
        let angles = contacts.map(|contact| {
            let (sine, cosine) = contact.angle.sin_cos();
            match contact.rail {
                Rail::Right => [sine, cosine],
                Rail::Left => [-sine, cosine],
            }
        });
        Ok(Self {
            spacing: track.spacing(),
            entries,
            angles: angles.collect(),
        })
    }

    /// Support spacing \[m\].
    pub(super) fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Largest [`share_cut`](ImpulseResponse::share_cut) and [`largest_error`](ImpulseResponse::largest_error) of any entry.
    pub(super) fn errors(&self) -> [f64; 2] {
        let responses = || self.entries.iter().map(|entry| &entry.response);
        [
            responses()
                .map(ImpulseResponse::share_cut)
                .fold(0.0, f64::max),
            responses()
                .map(ImpulseResponse::largest_error)
                .fold(0.0, f64::max),
        ]
    }

    /// Receptances \[m/N\] in the axes of the contacts in the mean over the places of the bay, at the angular frequency ω \[rad/s\],
    /// added to a matrix by rows.
    pub(super) fn add_mean_receptances(&self, angular_frequency: f64, matrix: &mut [Complex64]) {
        let size = 3 * self.angles.len();
        let mut own = vec![Complex64::ZERO; size * size];
        for Entry {
            row,
            column,
            response,
        } in &self.entries
        {
            own[row * size + column] = response.receptance(angular_frequency);
        }
        for row in own.chunks_exact_mut(size) {
            self.turn(row);
        }
        for column in 0..size {
            let mut values: Vec<Complex64> =
                own.iter().skip(column).step_by(size).copied().collect();
            self.turn(&mut values);
            for (entry, value) in matrix.iter_mut().skip(column).step_by(size).zip(values) {
                *entry += value;
            }
        }
    }

    /// Turn motions or forces of all contacts from the axes of the track to those of the contacts, u_t = u_y cos γ ∓ u_z sin γ and
    /// u_n = u_z cos γ ± u_y sin γ, upper sign on the right rail.
    fn turn<T>(&self, values: &mut [T])
    where
        T: Copy
            + std::ops::Mul<f64, Output = T>
            + std::ops::Add<Output = T>
            + std::ops::Sub<Output = T>,
    {
        for ([sine, cosine], values) in self.angles.iter().zip(values.chunks_exact_mut(3)) {
            (values[1], values[2]) = (
                values[1] * *cosine - values[2] * *sine,
                values[2] * *cosine + values[1] * *sine,
            );
        }
    }

    /// The same back to the axes of the track.
    fn turn_back(&self, values: &mut [f64]) {
        for ([sine, cosine], values) in self.angles.iter().zip(values.chunks_exact_mut(3)) {
            (values[1], values[2]) = (
                values[1] * cosine + values[2] * sine,
                values[2] * cosine - values[1] * sine,
            );
        }
    }
}

/// The axes of the contacts as places, along, across and down.
pub(super) fn places(feedback: &GeneralLoop) -> Vec<Place> {
    let contacts = feedback.contacts().iter();
    contacts
        .flat_map(|contact| {
            Direction::ALL.map(|direction| Place {
                along: contact.along,
                rail: contact.rail,
                direction,
            })
        })
        .collect()
}

/// Whether a row is that of an axis along the rail.
pub(super) fn is_along(row: usize) -> bool {
    row.is_multiple_of(3)
}

/// A track on discrete supports under forces that are given from step to step.
#[derive(Debug, Clone)]
pub(super) struct MotionOverSupports<'a> {
    track: &'a TrackOverSupports,
    motions: Vec<TrackMotion>,
    /// Mean forces in the axes of the track \[N\].
    mean: Vec<f64>,
    /// V \[m/s\].
    speed: f64,
    /// Share of the sag between supports that has set in, and what each step and each second adds.
    onset: f64,
    onset_step: f64,
    onset_rate: f64,
    /// Scratch.
    forces: Vec<f64>,
    displacement: Vec<f64>,
    velocity: Vec<f64>,
}

impl<'a> MotionOverSupports<'a> {
    /// At rest under mean forces in the axes of the contacts \[N\], the first wheel a distance before a support \[m\], for steps of the
    /// given time \[s\] at a speed \[m/s\].
    pub(super) fn new(
        track: &'a TrackOverSupports,
        mut mean: Vec<f64>,
        step: f64,
        speed: f64,
        distance: f64,
    ) -> Self {
        track.turn_back(&mut mean);
        let size = mean.len();
        let motions = track.entries.iter();
        let onset_rate = speed / (ONSET_BAYS * track.spacing);
        Self {
            motions: motions
                .map(|entry| TrackMotion::new(&entry.response, step, speed, distance))
                .collect(),
            mean,
            speed,
            onset: 0.0,
            onset_step: onset_rate * step,
            onset_rate,
            forces: vec![0.0; size],
            displacement: vec![0.0; size],
            velocity: vec![0.0; size],
            track,
        }
    }

    /// A step begins with the forces at its start; what it adds to displacement and speed at its end but for the forces there, in the
    /// axes of the contacts.
    pub(super) fn advance(
        &mut self,
        forces: &[f64],
        displacement: &mut [f64],
        velocity: &mut [f64],
    ) {
        self.forces.copy_from_slice(forces);
        self.track.turn_back(&mut self.forces);
        self.onset += self.onset_step;
        let (share, rate) = (
            faded(self.onset),
            self.onset_rate * slope_of_faded(self.onset),
        );
        self.displacement.fill(0.0);
        self.velocity.fill(0.0);
        for (entry, motion) in self.track.entries.iter().zip(&mut self.motions) {
            let [moved, moving] = motion.advance_with_speed(self.forces[entry.column]);
            let mean = self.mean[entry.column];
            let (sag, slope) = (mean * motion.sag(), mean * motion.slope_of_sag());
            self.displacement[entry.row] += moved + share * sag;
            self.velocity[entry.row] += moving + share * self.speed * slope + rate * sag;
        }
        self.track.turn(&mut self.displacement);
        self.track.turn(&mut self.velocity);
        for (sum, own) in displacement.iter_mut().zip(&self.displacement) {
            *sum += own;
        }
        for (sum, own) in velocity.iter_mut().zip(&self.velocity) {
            *sum += own;
        }
    }

    /// What the forces at the end of the step add to displacement and speed \[m/N, m/(s N)\], to matrices by rows in the axes of
    /// the contacts.
    pub(super) fn add_by_new_force(&self, [displacement, velocity]: &mut [Vec<f64>; 2]) {
        let size = self.mean.len();
        for (entry, motion) in self.track.entries.iter().zip(&self.motions) {
            let (by_force, speed_by_force) = (motion.by_new_force(), motion.speed_by_new_force());
            // T H Tᵀ of one entry.
            for (row, at) in self.shares(entry.row) {
                for (column, from) in self.shares(entry.column) {
                    let share = at * from;
                    displacement[row * size + column] += share * by_force;
                    velocity[row * size + column] += share * speed_by_force;
                }
            }
        }
    }

    /// Rows in the axes of a contact that a row in those of the track counts for, and how much of it.
    fn shares(&self, row: usize) -> [(usize, f64); 2] {
        let (contact, axis) = (row / 3, row % 3);
        let [sine, cosine] = self.track.angles[contact];
        let (across, normal) = (3 * contact + 1, 3 * contact + 2);
        match axis {
            1 => [(across, cosine), (normal, sine)],
            _ => [(across, -sine), (normal, cosine)],
        }
    }
}
