//! A rail in time that is fitted by itself, pair by pair of contacts and axes.

use num_complex::Complex64;
use rayon::prelude::*;

use super::ImpulseResponse;
use super::along_profile::{faded, slope_of_faded};
use super::over_supports::{AlongBay, ONSET_BAYS, frequencies, is_discrete};
use super::track_motion::TrackMotion;
use crate::feedback::Loop;
use crate::receptance::{HarmonicMatrices, SpatialMovingLoad};
use crate::{Direction, Error, Place, Rail};

/// The answers of a rail to impulses at all contacts, down and across in the axes of the track: an [`ImpulseResponse`] for every pair
/// of contacts and axes that is not zero. On discrete supports they depend on the place of the first wheel in its bay.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RailInTime {
    /// Of discrete supports \[m\].
    spacing: Option<f64>,
    entries: Vec<Entry>,
    /// Sine, with the sign of its rail, and cosine of the angle of each contact.
    angles: Vec<[f64; 2]>,
}

#[derive(Debug, Clone, PartialEq)]
struct Entry {
    row: usize,
    column: usize,
    /// Whether its motion has a part in the plane of contact, where speeds count.
    creeps: bool,
    response: ImpulseResponse,
}

/// The axis down among the three of a contact.
const DOWN: usize = 2;

impl RailInTime {
    /// A rail under one wheel that only moves down.
    pub(super) fn under_one_wheel(response: ImpulseResponse) -> Self {
        Self {
            spacing: response.support_spacing(),
            entries: vec![Entry { row: DOWN, column: DOWN, creeps: false, response }],
            angles: vec![[0.0, 1.0]],
        }
    }

    /// That of the contacts of a loop under loads that move along a track.
    ///
    /// # Errors
    /// Errors of [`ImpulseResponse::over_supports`].
    pub(super) fn over_supports(feedback: &Loop, track: &SpatialMovingLoad) -> Result<Self, Error> {
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
                    None => ImpulseResponse::along_bay(&transfer, ahead.collect(), track.spacing())?,
                };
                fitted.push(transfer);
                entries.push(Entry {
                    row,
                    column,
                    creeps: row % 3 != DOWN || feedback.contacts()[row / 3].angle != 0.0,
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
        Ok(Self { spacing: Some(track.spacing()), entries, angles: angles.collect() })
    }

    /// Spacing of discrete supports \[m\].
    pub(super) fn spacing(&self) -> Option<f64> {
        self.spacing
    }

    /// Largest [`share_cut`](ImpulseResponse::share_cut) and [`largest_error`](ImpulseResponse::largest_error) of any entry.
    pub(super) fn errors(&self) -> [f64; 2] {
        let responses = || self.entries.iter().map(|entry| &entry.response);
        [
            responses().map(ImpulseResponse::share_cut).fold(0.0, f64::max),
            responses().map(ImpulseResponse::largest_error).fold(0.0, f64::max),
        ]
    }

    /// Receptances \[m/N\] in the axes of the contacts in the mean over the places of the bay, at the angular frequency ω \[rad/s\],
    /// added to a matrix by rows.
    pub(super) fn add_mean_receptances(&self, angular_frequency: f64, matrix: &mut [Complex64]) {
        let size = 3 * self.angles.len();
        let mut own = vec![Complex64::ZERO; size * size];
        for Entry { row, column, response, .. } in &self.entries {
            own[row * size + column] = response.receptance(angular_frequency);
        }
        for row in own.chunks_exact_mut(size) {
            self.turn(row);
        }
        for column in 0..size {
            let mut values: Vec<Complex64> = own.iter().skip(column).step_by(size).copied().collect();
            self.turn(&mut values);
            for (entry, value) in matrix.iter_mut().skip(column).step_by(size).zip(values) {
                *entry += value;
            }
        }
    }

    /// Cells of a matrix by rows in the axes of the contacts that an entry counts for, and how much of it.
    fn cells(&self, entry: &Entry) -> Vec<(usize, f64)> {
        let size = 3 * self.angles.len();
        let shares = |row: usize| {
            let (contact, axis) = (row / 3, row % 3);
            let [sine, cosine] = self.angles[contact];
            let (across, normal) = (3 * contact + 1, 3 * contact + 2);
            match axis {
                1 => [(across, cosine), (normal, sine)],
                _ => [(across, -sine), (normal, cosine)],
            }
        };
        let rows = shares(entry.row).into_iter();
        let cells =
            rows.flat_map(|(row, at)| shares(entry.column).map(|(column, from)| (row * size + column, at * from)));
        cells.filter(|(_, share)| *share != 0.0).collect()
    }

    /// Whether the axes of the contacts are those of the track.
    fn is_upright(&self) -> bool {
        self.angles.iter().all(|[sine, _]| *sine == 0.0)
    }

    /// Turn motions or forces of all contacts from the axes of the track to those of the contacts, u_t = u_y cos γ ∓ u_z sin γ and
    /// u_n = u_z cos γ ± u_y sin γ, upper sign on the right rail.
    fn turn<T>(&self, values: &mut [T])
    where
        T: Copy + std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T> + std::ops::Sub<Output = T>,
    {
        for ([sine, cosine], values) in self.angles.iter().zip(values.chunks_exact_mut(3)) {
            (values[1], values[2]) = (values[1] * *cosine - values[2] * *sine, values[2] * *cosine + values[1] * *sine);
        }
    }

    /// Turn motions or forces of all contacts back to the axes of the track.
    fn turn_back(&self, values: &mut [f64]) {
        for ([sine, cosine], values) in self.angles.iter().zip(values.chunks_exact_mut(3)) {
            (values[1], values[2]) = (values[1] * cosine + values[2] * sine, values[2] * cosine - values[1] * sine);
        }
    }
}

/// The axes of the contacts as places, along, across and down.
pub(super) fn places(feedback: &Loop) -> Vec<Place> {
    let contacts = feedback.contacts().iter();
    contacts
        .flat_map(|contact| {
            Direction::ALL.map(|direction| Place { along: contact.along, rail: contact.rail, direction })
        })
        .collect()
}

/// Whether a row is that of an axis along the rail.
pub(super) fn is_along(row: usize) -> bool {
    row.is_multiple_of(3)
}

/// A rail under forces that are given from step to step.
#[derive(Debug, Clone)]
pub(super) struct RailMotion<'a> {
    rail: &'a RailInTime,
    motions: Vec<TrackMotion>,
    /// Of each entry T H Tᵀ: where it stands in a matrix by rows in the axes of the contacts, and how much of it.
    cells: Vec<Vec<(usize, f64)>>,
    /// What a steady load makes of the rail between supports.
    sag: Option<Sag>,
    /// Forces, displacements and speeds in the axes of the track.
    scratch: [Vec<f64>; 3],
}

/// The rail between discrete supports under the mean forces, which sets in over some bays.
#[derive(Debug, Clone)]
struct Sag {
    /// Mean forces in the axes of the track \[N\].
    mean: Vec<f64>,
    /// V \[m/s\].
    speed: f64,
    /// Share that has set in, and what each step and each second adds.
    onset: f64,
    onset_step: f64,
    onset_rate: f64,
}

impl<'a> RailMotion<'a> {
    /// At rest under mean forces in the axes of the contacts \[N\], the first wheel a distance before a support \[m\], for steps of the
    /// given time \[s\] at a speed \[m/s\].
    pub(super) fn new(rail: &'a RailInTime, mut mean: Vec<f64>, step: f64, speed: f64, distance: f64) -> Self {
        rail.turn_back(&mut mean);
        let size = mean.len();
        let motions = rail.entries.iter();
        Self {
            motions: motions.map(|entry| TrackMotion::new(&entry.response, step, speed, distance)).collect(),
            sag: rail.spacing.map(|spacing| {
                let onset_rate = speed / (ONSET_BAYS * spacing);
                Sag { mean, speed, onset: 0.0, onset_step: onset_rate * step, onset_rate }
            }),
            cells: rail.entries.iter().map(|entry| rail.cells(entry)).collect(),
            scratch: [(); 3].map(|()| vec![0.0; size]),
            rail,
        }
    }

    /// A step begins with the forces at its start; what it adds to displacement and speed at its end but for the forces there, in the
    /// axes of the contacts.
    pub(super) fn advance(&mut self, forces: &[f64], displacement: &mut [f64], velocity: &mut [f64]) {
        if let Some(sag) = &mut self.sag {
            sag.onset += sag.onset_step;
        }
        if self.rail.is_upright() {
            return self.add(forces, displacement, velocity);
        }
        let mut own = std::mem::take(&mut self.scratch);
        own[0].copy_from_slice(forces);
        self.rail.turn_back(&mut own[0]);
        own[1].fill(0.0);
        own[2].fill(0.0);
        let [forces, moved, moving] = &mut own;
        self.add(forces, moved, moving);
        for (sum, own) in [(displacement, moved), (velocity, moving)] {
            self.rail.turn(own);
            for (sum, own) in sum.iter_mut().zip(own) {
                *sum += *own;
            }
        }
        self.scratch = own;
    }

    /// Add the motion in the axes of the track.
    fn add(&mut self, forces: &[f64], displacement: &mut [f64], velocity: &mut [f64]) {
        for (entry, motion) in self.rail.entries.iter().zip(&mut self.motions) {
            let force = forces[entry.column];
            let [moved, moving] = match entry.creeps {
                true => motion.advance_with_speed(force),
                false => [motion.advance(force), 0.0],
            };
            displacement[entry.row] += moved;
            velocity[entry.row] += moving;
            if let Some(sag) = &self.sag {
                let [moved, moving] = sag.of(motion, entry);
                displacement[entry.row] += moved;
                velocity[entry.row] += moving;
            }
        }
    }

    /// What the forces at the end of the step add to displacement and speed \[m/N, m/(s N)\], to matrices by rows in the axes of
    /// the contacts, of which those without the rail are given.
    pub(super) fn set_by_new_force(
        &self,
        [displacement, velocity]: &mut [Vec<f64>; 2],
        [still, unmoving]: &[Vec<f64>; 2],
    ) {
        for &(cell, _) in self.cells.iter().flatten() {
            displacement[cell] = still[cell];
            velocity[cell] = unmoving[cell];
        }
        let motions = self.rail.entries.iter().zip(&self.motions);
        for ((entry, motion), cells) in motions.zip(&self.cells) {
            let by_force = motion.by_new_force();
            let speed_by_force = match entry.creeps {
                true => motion.speed_by_new_force(),
                false => 0.0,
            };
            for &(cell, share) in cells {
                displacement[cell] += share * by_force;
                velocity[cell] += share * speed_by_force;
            }
        }
    }
}

impl Sag {
    /// Displacement and speed of an entry by its mean force.
    fn of(&self, motion: &TrackMotion, entry: &Entry) -> [f64; 2] {
        let mean = self.mean[entry.column];
        let share = faded(self.onset);
        let sag = mean * motion.sag();
        if !entry.creeps {
            return [share * sag, 0.0];
        }
        let rate = self.onset_rate * slope_of_faded(self.onset);
        let slope = mean * motion.slope_of_sag();
        [share * sag, share * self.speed * slope + rate * sag]
    }
}
