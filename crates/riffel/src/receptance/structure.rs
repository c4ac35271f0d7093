//! Structures that answer along several axes and at several places.

use std::sync::Arc;

use num_complex::Complex64;

use super::{Receptance, free_of};
use crate::{Direction, Place, Rail};

/// Joint of the loop: a structure that answers at one place to a force at another, along any axis.
///
/// Reciprocal: the two places may be exchanged. The scalar [`Receptance`] is one entry of it and its fast path.
pub trait Structure: Send + Sync {
    /// Displacement at `at` per force at `from` \[m/N\], each along its own axis, at the angular frequency
    /// ω > 0 \[rad/s\] under a load that travels at the given speed \[m/s\].
    fn cross_receptance(&self, angular_frequency: f64, speed: f64, at: Place, from: Place) -> Complex64;

    /// Receptances along each axis; `None` if axes or places of the structure are coupled.
    fn uncoupled(&self) -> Option<&Uncoupled> {
        None
    }

    /// Roll of a rail under the places given, each a distance along it \[m\] and the rail: its turn \[rad\] about the direction of travel,
    /// right side down, per force on it along x, y, z \[rad/N\] and per moment about the direction of travel \[rad/(N m)\] at each
    /// of the n places, in rows of 4n. By reciprocity the same numbers are the displacements by a moment.
    ///
    /// Provided: that of a structure which does not roll, zeros.
    fn roll_matrix(&self, _angular_frequency: f64, _speed: f64, _places: &[(f64, Rail)], matrix: &mut [Complex64]) {
        matrix.fill(Complex64::ZERO);
    }

    /// Receptances between all places \[m/N\] into a matrix by rows, the displacement at the i-th place per force at the
    /// j-th at [i·n + j] of the n places; symmetric.
    ///
    /// Provided, each entry by itself; a structure whose places share their work does it once a frequency.
    fn receptance_matrix(&self, angular_frequency: f64, speed: f64, places: &[Place], matrix: &mut [Complex64]) {
        for (entry, (&at, &from)) in matrix.iter_mut().zip(pairs(places)) {
            *entry = self.cross_receptance(angular_frequency, speed, at, from);
        }
    }

    /// Part A \[1/kg\] of the receptance matrix of the places, H → −A/ω² for ω → 0, by rows: the masses of a structure that nothing
    /// holds, and its inertias over the square of the rolling radius.
    ///
    /// Provided, from the receptances at three low frequencies, for a structure that only they describe.
    fn free(&self, places: &[Place]) -> Vec<f64> {
        free_of(&|w| {
            let mut matrix = vec![Complex64::ZERO; places.len() * places.len()];
            self.receptance_matrix(w, 1.0, places, &mut matrix);
            matrix
        })
    }

    /// [`receptance_matrix`](Self::receptance_matrix) at one frequency after the other, one matrix behind the other.
    ///
    /// Provided; a structure that remembers its answers looks them up at once.
    fn receptance_matrices(
        &self,
        angular_frequencies: &[f64],
        speed: f64,
        places: &[Place],
        matrices: &mut [Complex64],
    ) {
        let size = places.len() * places.len();
        for (index, &w) in angular_frequencies.iter().enumerate() {
            self.receptance_matrix(w, speed, places, &mut matrices[index * size..][..size]);
        }
    }
}

/// A structure whose axes do not feel each other and which answers at the place of the force alone: a wheel without a
/// partner, a rail under one wheel.
#[derive(Clone, Default)]
pub struct Uncoupled {
    /// Receptance along the rail; none for a structure that does not move so.
    pub longitudinal: Option<Arc<dyn Receptance>>,
    /// Receptance across the track; none for a structure that does not move so.
    pub lateral: Option<Arc<dyn Receptance>>,
    /// Receptance downward; none for a structure that does not move so.
    pub vertical: Option<Arc<dyn Receptance>>,
}

impl Uncoupled {
    fn along(&self, direction: Direction) -> &Option<Arc<dyn Receptance>> {
        match direction {
            Direction::Longitudinal => &self.longitudinal,
            Direction::Lateral => &self.lateral,
            Direction::Vertical => &self.vertical,
        }
    }
}

impl Structure for Uncoupled {
    fn uncoupled(&self) -> Option<&Uncoupled> {
        Some(self)
    }

    fn cross_receptance(&self, angular_frequency: f64, speed: f64, at: Place, from: Place) -> Complex64 {
        match self.along(at.direction) {
            Some(receptance) if at == from => receptance.receptance(angular_frequency, speed),
            _ => Complex64::ZERO,
        }
    }

    fn free(&self, places: &[Place]) -> Vec<f64> {
        let entry = |(at, from): (&Place, &Place)| match self.along(at.direction) {
            Some(receptance) if at == from => receptance.free(),
            _ => 0.0,
        };
        pairs(places).map(entry).collect()
    }
}

/// Every place with every place, in the order of a matrix by rows.
pub(crate) fn pairs<T>(places: &[T]) -> impl Iterator<Item = (&T, &T)> {
    places.iter().flat_map(move |at| places.iter().map(move |from| (at, from)))
}
