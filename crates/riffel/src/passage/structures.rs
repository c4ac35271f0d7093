//! Track and wheels in time, at all contacts.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rayon::prelude::*;

use super::ImpulseResponse;
use super::direction_in_time::DirectionInTime;
use super::pole_search::{PoleFit, PoleSearch};
use super::rail_in_time::{RailInTime, is_along, places};
use super::structures_samples::{Receptances, Sample, samples, with_rail_along};
use super::vector_fitting::{Sampled, residues, shared_poles, starting_poles};
use crate::Error;
use crate::feedback::Loop;
use crate::receptance::SpatialMovingLoad;
use crate::wheelset::{RigidInertia, RigidMass};

/// Displacement of the wheels against the rail after impulses at all contacts of a loop, in their axes x, t, n:
///
/// ```text
/// g(t) = A t + Σ Re(R_j e^{p_j t})        Re p_j < 0;  A, R_j symmetric matrices over contacts and axes
/// ```
///
/// A \[1/kg\] is the motion of wheels that nothing holds, as their spin; the rest is the causal function whose receptance
/// comes nearest to that of track and wheels together without A, by vector fitting with poles that all entries share.
///
/// The receptance counts as it is up to [`KNOWN`](Self::KNOWN), and as a hint, of which an error counts a twentieth, from there to
/// [`HIGHEST`](Self::HIGHEST): axles and webs have lines without end, and none above moves a contact that corrugation excites. An error
/// counts over √|H_ii H_jj|. Frequencies stand closer where the receptance turns quickly, and around the natural frequencies that are told.
/// Accuracy: [`share_cut`](Self::share_cut) and [`largest_error`](Self::largest_error) up to 3 kHz; 10⁻⁴ rms on viscous tracks under
/// flexible wheelsets. A loss factor is not causal, see [`ImpulseResponse`]. Cost: some seconds for two contacts.
///
/// Of [one wheel](Self::of_one_wheel) along one axis the track is fitted by itself, and the motion of the wheel is exact.
///
/// Over discrete supports the rail is taken apart, down and across: its answer is that of the place where the first wheel is when the
/// impulse comes, [`ImpulseResponse::over_supports`] for each pair of contacts and axes, with poles of its own. Along itself it
/// is even, see [`SpatialMovingLoad`].
#[derive(Debug, Clone, PartialEq)]
pub struct StructuresInTime {
    size: usize,
    /// One of each pair.
    poles: Vec<Complex64>,
    /// R_j by rows, one for each pole.
    residues: Vec<Vec<Complex64>>,
    /// A by rows.
    free: Vec<f64>,
    /// The rail down and across, where it is fitted by itself.
    rail: Option<RailInTime>,
    /// What normal forces do that turn with the waves.
    direction: Option<DirectionInTime>,
    share_cut: f64,
    largest_error: f64,
}

impl StructuresInTime {
    /// Frequencies \[Hz\] up to which receptances count as they are, and up to which as a hint.
    pub const KNOWN: f64 = 5e3;
    /// The end of the fit \[Hz\].
    pub const HIGHEST: f64 = 20e3;

    /// Structures of a loop at a speed \[m/s\]; `natural_frequencies` \[rad/s\] of the wheels, as far as they are known, are where
    /// the search for poles begins.
    ///
    /// # Errors
    /// [`Error::NotCausal`] if no causal response comes near enough, [`Error::OutOfRange`] for a receptance that is not finite.
    pub fn of(feedback: &Loop, speed: f64, natural_frequencies: &[f64]) -> Result<Self, Error> {
        let receptances = |w: f64| {
            let Some(hubs) = feedback.hub_receptances(w, speed) else {
                let whole = feedback.contact_receptances(w, speed);
                return [whole.clone(), whole, Vec::new()];
            };
            let [whole, wheels] = feedback.receptances_with_those_of_wheels(w, speed);
            let rail: Vec<Complex64> = (whole.iter().zip(&wheels)).map(|(whole, wheels)| whole - wheels).collect();
            let direction = with_rail_along(hubs, &rail);
            [whole.clone(), whole, direction]
        };
        Self::fitted(feedback, &receptances, natural_frequencies)
    }

    /// Structures of one wheel that moves down as a mass and turns as a rigid body, under the dead load and the constant torque of its drive,
    /// equation (15), or evenly where no rotation is given; its track answers downward alone.
    ///
    /// Range of validity: a wheel without a suspension of its own, so above some 10 Hz.
    pub fn of_one_wheel(track: ImpulseResponse, wheel: &RigidMass, rotation: Option<&RigidInertia>) -> Self {
        let mut free = vec![0.0; 9];
        free[0] = rotation.map_or(0.0, |rotation| rotation.mass_along().recip());
        free[8] = wheel.mass().recip();
        Self {
            size: 3,
            poles: Vec::new(),
            residues: Vec::new(),
            free,
            share_cut: track.share_cut(),
            largest_error: track.largest_error(),
            rail: Some(RailInTime::under_one_wheel(track)),
            direction: None,
        }
    }

    /// Structures of [one wheel](Self::of_one_wheel) whose normal force turns with the wave, and whose hub moves along the rail as a mass.
    #[must_use]
    pub fn with_normal_direction(self, hub: &RigidMass) -> Self {
        let direction = DirectionInTime { contacts: 1, free: vec![hub.mass().recip()], residues: Vec::new() };
        Self { direction: Some(direction), ..self }
    }

    /// Structures of a loop on discrete supports, under wheels that pass them at the speed of the moving load.
    ///
    /// # Errors
    /// Errors of [`of`](Self::of), and of [`SpatialMovingLoad::harmonics`].
    pub fn over_supports(
        feedback: &Loop,
        track: &SpatialMovingLoad,
        natural_frequencies: &[f64],
    ) -> Result<Self, Error> {
        let rail = RailInTime::over_supports(feedback, track)?;
        let places = places(feedback);
        let size = places.len();
        let receptances = |w: f64| {
            let [whole, mut fitted] = feedback.receptances_with_those_of_wheels(w, track.speed());
            let even = track.evenly(w, &places);
            // The axes of contacts and track are the same along the rail.
            let even = even.at(0).unwrap_or_default();
            for (index, along) in even.iter().enumerate() {
                if is_along(index / size) && is_along(index % size) {
                    fitted[index] += along;
                }
            }
            let hubs = feedback.hub_receptances(w, track.speed());
            let direction = hubs.map_or_else(Vec::new, |hubs| with_rail_along(hubs, even));
            [whole, fitted, direction]
        };
        let even = Self::fitted(feedback, &receptances, natural_frequencies)?;
        let [share_cut, largest_error] = rail.errors();
        Ok(Self {
            share_cut: even.share_cut.max(share_cut),
            largest_error: even.largest_error.max(largest_error),
            rail: Some(rail),
            ..even
        })
    }

    fn fitted(feedback: &Loop, receptances: &Receptances<'_>, natural_frequencies: &[f64]) -> Result<Self, Error> {
        /// Poles beside those of the wheels at first, pairs counted twice.
        const POLES: usize = 40;
        /// An rms below needs no more poles.
        const FINE: f64 = 3e-5;
        let lines: Vec<f64> = natural_frequencies.iter().copied().filter(|&w| w < TAU * Self::KNOWN).collect();
        let transfer = Transfer::of(feedback, receptances, &lines)?;
        let (lowest, highest) = (ImpulseResponse::BAND.0, TAU * Self::HIGHEST);
        let spread = starting_poles(lowest / highest, POLES).into_iter();
        let of_lines = lines.iter().map(|&line| Complex64::new(-0.003, 1.0) * line);
        let starting: Vec<Complex64> = spread.map(|pole| highest * pole).chain(of_lines).collect();
        let fit = |starting: &[Complex64]| transfer.fit(starting);
        let search = PoleSearch::among([fit(&starting)], FINE * FINE, None);
        search.refined(fit).found()
    }

    /// Rows of the matrices: three for each contact.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Receptances \[m/N\] at the angular frequency ω \[rad/s\], by rows; on discrete supports the mean over the places of the bay.
    pub fn receptances(&self, angular_frequency: f64) -> Vec<Complex64> {
        let s = Complex64::new(0.0, angular_frequency);
        let mut sum: Vec<Complex64> = self.free.iter().map(|free| free / (s * s)).collect();
        for (pole, residues) in self.poles.iter().zip(&self.residues) {
            let [one, other] = [(s - pole).inv(), (s - pole.conj()).inv()];
            for (entry, residue) in sum.iter_mut().zip(residues) {
                *entry += 0.5 * (residue * one + residue.conj() * other);
            }
        }
        if let Some(rail) = &self.rail {
            rail.add_mean_receptances(angular_frequency, &mut sum);
        }
        sum
    }

    /// Distance of the supports \[m\] that pass under the wheels; none on a track that is even.
    pub fn support_spacing(&self) -> Option<f64> {
        self.rail.as_ref().and_then(RailInTime::spacing)
    }

    /// Whether track and wheels are fitted together, and not the track by itself under wheels that are free masses.
    pub fn are_fitted_together(&self) -> bool {
        !self.poles.is_empty()
    }

    /// Mean square of the relative error of the receptances up to 3 kHz, over frequencies that are even on a logarithmic scale.
    pub fn share_cut(&self) -> f64 {
        self.share_cut
    }

    /// Structures whose receptance differs by a mean square of the relative error from the one they stand for,
    /// besides what is cut of it.
    #[must_use]
    pub fn with_share_cut(self, share: f64) -> Self {
        Self { share_cut: self.share_cut + share, ..self }
    }

    /// Largest relative error of any entry at any of these frequencies, over √|H_ii H_jj|.
    pub fn largest_error(&self) -> f64 {
        self.largest_error
    }

    /// What normal forces do that turn with the waves; `None` if they stay upright.
    pub(super) fn direction(&self) -> Option<&DirectionInTime> {
        self.direction.as_ref()
    }

    /// Poles p_j and residue matrices R_j by rows.
    pub(super) fn terms(&self) -> impl Iterator<Item = (Complex64, &[Complex64])> + '_ {
        let residues = self.residues.iter().map(Vec::as_slice);
        self.poles.iter().copied().zip(residues)
    }

    /// A by rows.
    pub(super) fn free(&self) -> &[f64] {
        &self.free
    }

    /// The rail down and across, where it is fitted by itself.
    pub(super) fn rail(&self) -> Option<&RailInTime> {
        self.rail.as_ref()
    }
}

/// Transfer functions over frequency.
struct Transfer {
    size: usize,
    frequencies: Vec<f64>,
    /// H + A/ω² of each entry of the upper triangle that is not zero.
    entries: Vec<Entry>,
    free: Vec<f64>,
    /// Entries by forces through the hubs, and their A; `None` if normal forces stay upright.
    direction: Option<(Vec<Entry>, Vec<f64>)>,
}

struct Entry {
    row: usize,
    column: usize,
    values: Vec<Complex64>,
    /// √|H_ii H_jj|.
    sizes: Vec<f64>,
}

impl Transfer {
    fn of(feedback: &Loop, receptances: &Receptances<'_>, lines: &[f64]) -> Result<Self, Error> {
        /// What an error counts where receptances are a hint.
        const HINT: f64 = 0.05;
        /// Entries below this share of the largest they could have are rounding.
        const NOTHING: f64 = 1e-9;
        let size = 3 * feedback.contacts().len();
        let free = feedback.free_motion();
        let samples = samples(size, receptances, lines)?;
        let mut entries = Vec::new();
        for row in 0..size {
            for column in row..size {
                let sizes: Vec<f64> = samples
                    .iter()
                    .map(|sample| {
                        let own = |axis: usize| sample.whole[axis * (size + 1)].norm();
                        (own(row) * own(column)).sqrt()
                    })
                    .collect();
                let values: Vec<Complex64> = samples
                    .iter()
                    .map(|Sample { w, fitted, .. }| fitted[row * size + column] + free[row * size + column] / (w * w))
                    .collect();
                let counts = values.iter().zip(&sizes).any(|(value, size)| value.norm() > NOTHING * size);
                if !counts {
                    continue;
                }
                let sizes =
                    samples.iter().zip(sizes).map(|(sample, size)| match sample.w < TAU * StructuresInTime::KNOWN {
                        true => size,
                        false => size / HINT,
                    });
                entries.push(Entry { row, column, values, sizes: sizes.collect() });
            }
        }
        let direction = feedback.free_hubs().map(|free| {
            let contacts = size / 3;
            let entry = |index: usize| {
                let (row, column) = (index / contacts, index % contacts);
                let own = |sample: &Sample, contact: usize| sample.whole[3 * contact * (size + 1)].norm();
                let sizes = samples.iter().map(|sample| {
                    let size = (own(sample, row) * own(sample, column)).sqrt();
                    match sample.w < TAU * StructuresInTime::KNOWN {
                        true => size,
                        false => size / HINT,
                    }
                });
                Entry {
                    row,
                    column,
                    sizes: sizes.collect(),
                    values: samples
                        .iter()
                        .map(|sample| sample.direction[index] + free[index] / (sample.w * sample.w))
                        .collect(),
                }
            };
            let counts = |entry: &Entry| {
                let pairs = entry.values.iter().zip(&entry.sizes);
                pairs.into_iter().any(|(value, size)| value.norm() > NOTHING * size)
            };
            let entries = (0..free.len()).map(entry).filter(counts);
            (entries.collect(), free)
        });
        Ok(Self { direction, size, frequencies: samples.iter().map(|sample| sample.w).collect(), entries, free })
    }

    /// The fit from poles to start from \[rad/s\].
    fn fit(&self, starting: &[Complex64]) -> PoleFit<StructuresInTime> {
        /// Up to here errors count \[Hz\].
        const JUDGED: f64 = 3e3;
        let Self { size, frequencies, .. } = self;
        // Entries along one axis show all poles.
        let sampled: Vec<Sampled<'_>> = self
            .entries
            .iter()
            .filter(|entry| entry.row % 3 == entry.column % 3)
            .map(|Entry { values, sizes, .. }| Sampled { values, sizes })
            .collect();
        let poles = match sampled.is_empty() {
            true => Vec::new(),
            false => shared_poles(frequencies, &sampled, starting),
        };
        let fits: Vec<_> = self
            .entries
            .par_iter()
            .map(|Entry { values, sizes, .. }| {
                residues(frequencies, std::slice::from_ref(values), sizes, &poles).swap_remove(0)
            })
            .collect();
        let mut matrices = vec![vec![Complex64::ZERO; size * size]; poles.len()];
        for (Entry { row, column, .. }, fit) in self.entries.iter().zip(&fits) {
            for (matrix, fraction) in matrices.iter_mut().zip(fit) {
                let residue = fraction.of_term();
                matrix[row * size + column] = residue;
                matrix[column * size + row] = residue;
            }
        }
        let direction = self.direction.as_ref().map(|(entries, free)| {
            let contacts = size / 3;
            let mut matrices = vec![vec![Complex64::ZERO; contacts * contacts]; poles.len()];
            for Entry { row, column, values, sizes } in entries {
                let fit = residues(frequencies, std::slice::from_ref(values), sizes, &poles).swap_remove(0);
                for (matrix, fraction) in matrices.iter_mut().zip(&fit) {
                    matrix[row * contacts + column] = fraction.of_term();
                }
            }
            DirectionInTime { contacts, free: free.clone(), residues: matrices }
        });
        let (mut share_cut, mut weights, mut largest_error) = (0.0, 0.0, 0f64);
        let mut errors = Vec::new();
        for (index, w) in frequencies.iter().enumerate() {
            if *w > TAU * JUDGED {
                break;
            }
            let mut largest_here = 0f64;
            let next = frequencies.get(index + 1).copied().unwrap_or(*w);
            let weight = (next / w).ln();
            let s = Complex64::new(0.0, *w);
            for (Entry { values, sizes, .. }, fit) in self.entries.iter().zip(&fits) {
                let value: Complex64 = fit.iter().map(|fraction| fraction.at(s)).sum();
                let error = ((value - values[index]) / sizes[index]).norm_sqr();
                share_cut += weight * error;
                weights += weight;
                largest_here = largest_here.max(error.sqrt());
            }
            largest_error = largest_error.max(largest_here);
            errors.push((*w, largest_here));
        }
        let fit = StructuresInTime {
            size: *size,
            poles,
            residues: matrices,
            free: self.free.clone(),
            rail: None,
            direction,
            // Wheels that nothing holds leave nothing to fit.
            share_cut: match weights > 0.0 {
                true => share_cut / weights,
                false => 0.0,
            },
            largest_error,
        };
        PoleFit { share_cut: fit.share_cut, poles: fit.poles.clone(), errors, fit }
    }
}
