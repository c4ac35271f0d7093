//! A track that several loops ask at the same frequencies.

use std::sync::Arc;

use num_complex::Complex64;

use super::{Motions, SpatialTrack, alongs_of, contacts_of};
use crate::memory::{Memory, bits};
use crate::receptance::Structure;
use crate::{Place, Rail};

/// Most groups of frequencies that are remembered: 40 MB, of 208 wavelengths at the 1025 speeds that sharp resonances ask for.
const MOST: usize = 1 << 16;

/// How tracks move that differ in the points of contact alone, by frequencies and places along them: at each frequency from every
/// place to every other.
#[derive(Debug)]
pub struct TrackMemory(Memory<Box<[Motions]>>);

/// A spatial track that remembers its motions, for the wheels of a vehicle in a curve: each has a point of contact of its own on the
/// same rail, and all are asked at the same speeds and wavelengths.
///
/// Answers are those of the track, to the last bit. Cost: 0.1 µs for a group of frequencies that is known.
#[derive(Debug, Clone)]
pub struct RememberingTrack {
    of: SpatialTrack,
    memory: Arc<TrackMemory>,
}

impl Default for TrackMemory {
    fn default() -> Self {
        Self(Memory::new(MOST))
    }
}

impl RememberingTrack {
    /// A track with a memory, which it may share with tracks that differ from it in their points of contact alone.
    pub fn new(of: SpatialTrack, memory: Arc<TrackMemory>) -> Self {
        Self { of, memory }
    }

    /// Hand on the motions between places along the track \[m\] at some angular frequencies \[rad/s\].
    fn motions<R>(&self, frequencies: &[f64], alongs: &[f64], read: impl FnOnce(&[Motions]) -> R) -> R {
        let asked = bits(frequencies.iter().chain(alongs));
        let find = || {
            let count = alongs.len();
            let at = |&w: &f64| {
                let waves = self.of.waves(w, alongs.to_vec());
                let motions: Vec<Motions> =
                    (0..count * count).map(|at| waves.motions(at / count, at % count)).collect();
                motions
            };
            frequencies.iter().flat_map(at).collect()
        };
        self.memory.0.recall(&asked, |motions| read(motions), find)
    }
}

impl Structure for RememberingTrack {
    fn cross_receptance(&self, angular_frequency: f64, _speed: f64, at: Place, from: Place) -> Complex64 {
        let alongs = [from.along, at.along];
        self.motions(&[angular_frequency], &alongs, |motions| self.of.entry(&motions[1], at, from))
    }

    fn roll_matrix(&self, angular_frequency: f64, _speed: f64, places: &[(f64, Rail)], matrix: &mut [Complex64]) {
        let alongs: Vec<f64> = places.iter().map(|(along, _)| *along).collect();
        self.motions(&[angular_frequency], &alongs, |motions| {
            self.of.fill_rolls(places, matrix, |from, to| motions[from * alongs.len() + to]);
        });
    }

    fn receptance_matrix(&self, angular_frequency: f64, speed: f64, places: &[Place], matrix: &mut [Complex64]) {
        self.receptance_matrices(&[angular_frequency], speed, places, matrix);
    }

    fn receptance_matrices(
        &self,
        angular_frequencies: &[f64],
        _speed: f64,
        places: &[Place],
        matrices: &mut [Complex64],
    ) {
        let alongs = alongs_of(places);
        let contacts = contacts_of(places, &alongs);
        let (count, size) = (alongs.len(), places.len() * places.len());
        self.motions(angular_frequencies, &alongs, |motions| {
            for (matrix, motions) in matrices.chunks_exact_mut(size).zip(motions.chunks_exact(count * count)) {
                self.of.fill_receptances(places, &contacts, matrix, |from, to| motions[from * count + to]);
            }
        });
    }
}
