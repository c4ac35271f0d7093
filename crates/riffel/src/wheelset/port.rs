//! What a wheelset answers at its two contacts.

use std::sync::Arc;

use num_complex::Complex64;

use crate::receptance::{Structure, free_of};
use crate::{Direction, Place, Rail};

/// A contact of a wheelset and one of its axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Port {
    /// The rail under the wheel.
    pub rail: Rail,
    /// The axis, that of the track.
    pub direction: Direction,
}

impl Port {
    /// All six: left x, y, z, right x, y, z.
    pub const ALL: [Self; 6] = [
        Self::new(Rail::Left, Direction::Longitudinal),
        Self::new(Rail::Left, Direction::Lateral),
        Self::new(Rail::Left, Direction::Vertical),
        Self::new(Rail::Right, Direction::Longitudinal),
        Self::new(Rail::Right, Direction::Lateral),
        Self::new(Rail::Right, Direction::Vertical),
    ];

    /// The axis of a contact.
    pub const fn new(rail: Rail, direction: Direction) -> Self {
        Self { rail, direction }
    }

    /// That of a place, wherever the wheelset stands.
    fn of(place: Place) -> Self {
        Self::new(place.rail, place.direction)
    }

    /// Its place among [`ALL`](Self::ALL).
    pub const fn index(self) -> usize {
        3 * self.rail as usize + self.direction as usize
    }
}

/// Receptances of a wheelset at its contacts \[m/N\]: `[at][from]`, both in the order of [`Port::ALL`].
pub type ContactReceptances = [[Complex64; 6]; 6];

/// Receptances of the hubs of a wheelset along the rail \[m/N\]: `[at][from]`, left and right.
pub type HubReceptances = [[Complex64; 2]; 2];

/// A wheelset on two rails, as its contacts feel it.
///
/// Every wheelset is a [`Structure`]: alike wherever it stands, and wheelsets at different places do not feel each
/// other. A new kind of wheelset is one new implementation of [`receptances`](Self::receptances).
pub trait Wheelset: Send + Sync {
    /// Displacement of the wheels' surfaces at the contacts per force on them \[m/N\], track axes, at the angular
    /// frequency ω > 0 \[rad/s\]. Symmetric, and passive: (H − Hᴴ)/2i has no positive eigenvalue.
    ///
    /// The loop wants the displacement under the force of the *wheel on the rail*, u_w = −H f.
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances;

    /// [`receptances`](Self::receptances) at one frequency after the other, each handed on with its number.
    ///
    /// Provided; a wheelset that remembers its answers looks them up at once.
    fn receptances_at(&self, angular_frequencies: &[f64], take: &mut dyn FnMut(usize, &ContactReceptances)) {
        for (index, &w) in angular_frequencies.iter().enumerate() {
            take(index, &self.receptances(w));
        }
    }

    /// Part A \[1/kg\] of the receptances, H → −A/ω² for ω → 0: of the motions that no suspension holds, the spin among them.
    ///
    /// Provided, from the receptances at three low frequencies, for a wheelset that only they describe.
    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        let free = free_of(&|w| self.receptances(w).into_iter().flatten().collect());
        std::array::from_fn(|at| std::array::from_fn(|from| free[6 * at + from]))
    }
}

/// A wheelset whose hubs move along the rail under forces through them, which do not turn its wheels.
pub trait WheelsetWithHubs: Send + Sync {
    /// Displacement along the rail of the wheels at the contacts per force along it through their hubs \[m/N\].
    fn hubs(&self, angular_frequency: f64) -> HubReceptances;

    /// [`hubs`](Self::hubs) at one frequency after the other, each handed on with its number.
    ///
    /// Provided; a wheelset that remembers its answers looks them up at once.
    fn hubs_at(&self, angular_frequencies: &[f64], take: &mut dyn FnMut(usize, &HubReceptances)) {
        for (index, &w) in angular_frequencies.iter().enumerate() {
            take(index, &self.hubs(w));
        }
    }

    /// [`receptances`](Wheelset::receptances) and [`hubs`](Self::hubs).
    fn receptances_and_hubs(&self, angular_frequency: f64) -> (ContactReceptances, HubReceptances);

    /// Part A \[1/kg\] of [`hubs`](Self::hubs), −A/ω² for ω → 0.
    fn free_hubs(&self) -> [[f64; 2]; 2];
}

impl<W: Wheelset + ?Sized> Wheelset for Arc<W> {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        (**self).receptances(angular_frequency)
    }

    fn receptances_at(&self, angular_frequencies: &[f64], take: &mut dyn FnMut(usize, &ContactReceptances)) {
        (**self).receptances_at(angular_frequencies, take);
    }

    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        (**self).free_at_contacts()
    }
}

impl<W: Wheelset> Structure for W {
    fn cross_receptance(&self, angular_frequency: f64, _speed: f64, at: Place, from: Place) -> Complex64 {
        if at.along != from.along {
            return Complex64::ZERO;
        }
        let receptances = self.receptances(angular_frequency);
        receptances[Port::of(at).index()][Port::of(from).index()]
    }

    fn receptance_matrix(&self, angular_frequency: f64, _speed: f64, places: &[Place], matrix: &mut [Complex64]) {
        fill(&self.receptances(angular_frequency), places, matrix);
    }

    fn receptance_matrices(
        &self,
        angular_frequencies: &[f64],
        _speed: f64,
        places: &[Place],
        matrices: &mut [Complex64],
    ) {
        let size = places.len() * places.len();
        let mut take = |index: usize, found: &ContactReceptances| {
            fill(found, places, &mut matrices[index * size..][..size]);
        };
        self.receptances_at(angular_frequencies, &mut take);
    }

    fn free(&self, places: &[Place]) -> Vec<f64> {
        let mut matrix = vec![0.0; places.len() * places.len()];
        between(&self.free_at_contacts(), places, &mut matrix);
        matrix
    }
}

/// Fill a matrix of places by rows with receptances: optimised whatever crate a wheelset is of.
#[inline(never)]
fn fill(own: &ContactReceptances, places: &[Place], matrix: &mut [Complex64]) {
    between(own, places, matrix);
}

/// Fill a matrix of places by rows with numbers between the contacts of one wheelset; wheelsets apart do not feel each other.
fn between<T: Copy + Default>(own: &[[T; 6]; 6], places: &[Place], matrix: &mut [T]) {
    if places.is_empty() {
        return;
    }
    for (row, &at) in matrix.chunks_exact_mut(places.len()).zip(places) {
        let row_of_all = &own[Port::of(at).index()];
        for (entry, &from) in row.iter_mut().zip(places) {
            *entry = if at.along == from.along { row_of_all[Port::of(from).index()] } else { T::default() };
        }
    }
}
