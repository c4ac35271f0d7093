//! The equations of the general loop at one point.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::contact::Answer;
use super::linear::solve;
use super::{Comb, ContactState, GeneralLoop};
use crate::Place;
use crate::wheelset::Motion;

/// The index of the normal force among the unknowns of a contact, after those along and across the rail.
const NORMAL: usize = 2;

/// The equations and their scratch, for one loop at one point after the other.
#[derive(Clone)]
pub(crate) struct System {
    wavelength: f64,
    wavenumber: f64,
    angular_frequency: f64,
    /// Places of the contacts on the track and on the wheels.
    on_track: Vec<Place>,
    on_wheels: Vec<Place>,
    /// Receptances of the track, of the wheels, and of both, in the axes of the contacts.
    track: Vec<Complex64>,
    wheels: Vec<Complex64>,
    both: Vec<Complex64>,
    answers: Vec<Answer>,
    /// Creepages of all contacts by the unknowns, two rows a contact.
    creepage: Vec<Complex64>,
    matrix: Vec<Complex64>,
    /// The unknowns, a column for each excitation.
    unknowns: Vec<Complex64>,
    /// Which excitation is that of each contact.
    excitation: Vec<usize>,
    /// The contacts as the equations solved leave them.
    states: Vec<ContactState>,
}

impl System {
    pub(crate) fn new(of: &GeneralLoop) -> Self {
        let size = 3 * of.contacts.len();
        let places = |from: f64| -> Vec<Place> {
            let places = of.contacts.iter();
            places
                .flat_map(|contact| contact.places(from + contact.along))
                .collect()
        };
        let mut wheelsets: Vec<f64> = Vec::new();
        let excitation = of.contacts.iter().map(|contact| match of.comb {
            Comb::Resolved => 0,
            Comb::Mean => {
                let known = wheelsets.iter().position(|&along| along == contact.along);
                known.unwrap_or_else(|| {
                    wheelsets.push(contact.along);
                    wheelsets.len() - 1
                })
            }
        });
        let excitation: Vec<usize> = excitation.collect();
        let columns = 1 + excitation.iter().max().copied().unwrap_or(0);
        let matrix = || vec![Complex64::ZERO; size * size];
        Self {
            wavelength: f64::NAN,
            wavenumber: f64::NAN,
            angular_frequency: f64::NAN,
            on_track: places(of.position),
            on_wheels: places(0.0),
            track: matrix(),
            wheels: matrix(),
            both: matrix(),
            answers: Vec::with_capacity(of.contacts.len()),
            creepage: vec![Complex64::ZERO; 2 * of.contacts.len() * size],
            matrix: matrix(),
            unknowns: vec![Complex64::ZERO; size * columns],
            excitation,
            states: Vec::with_capacity(of.contacts.len()),
        }
    }

    /// Solve the equations at a wavelength \[m\] and a speed \[m/s\].
    pub(super) fn turn(&mut self, of: &GeneralLoop, wavelength: f64, speed: f64) {
        self.assemble(of, wavelength, speed);
        let size = self.size();
        let columns = self.columns();
        self.unknowns.fill(Complex64::ZERO);
        for (index, contact) in of.contacts.iter().enumerate() {
            let right = of.amplitude * contact.profile * contact.phase(self.wavenumber);
            self.unknowns[(3 * index + NORMAL) * columns + self.excitation[index]] = right;
        }
        if solve(&mut self.matrix, &mut self.unknowns, size).is_zero() {
            self.unknowns.fill(Complex64::new(f64::NAN, f64::NAN));
        }
        let mut states = std::mem::take(&mut self.states);
        states.clear();
        states.extend((0..of.contacts.len()).map(|index| self.state(of, index)));
        self.states = states;
    }

    /// The determinant of the equations at an angular frequency \[rad/s\] and a speed \[m/s\], over that of the
    /// normal forces alone on rails and wheels without friction.
    pub(super) fn determinant(
        &mut self,
        of: &GeneralLoop,
        angular_frequency: f64,
        speed: f64,
    ) -> Complex64 {
        self.assemble(of, 2.0 * PI * speed / angular_frequency, speed);
        let size = self.size();
        let count = of.contacts.len();
        let whole = solve(&mut self.matrix, &mut [Complex64::ZERO].repeat(size), size);
        let mut normal = Vec::with_capacity(count * count);
        for (row, contact) in of.contacts.iter().enumerate() {
            for column in 0..count {
                let mut entry = self.both[(3 * row + NORMAL) * size + 3 * column + NORMAL];
                if row == column {
                    entry += contact.stiffness.recip();
                }
                normal.push(entry);
            }
        }
        let without = solve(&mut normal, &mut [Complex64::ZERO].repeat(count), count);
        whole.over(without)
    }

    /// The matrix of the equations
    ///
    /// ```text
    /// Q − F_P P − F_ξ ξ = 0        two rows a contact
    /// P/k_H + (H f)_n = Δ p        one row
    /// ```
    fn assemble(&mut self, of: &GeneralLoop, wavelength: f64, speed: f64) {
        let size = self.size();
        self.wavelength = wavelength;
        self.wavenumber = 2.0 * PI / wavelength;
        self.angular_frequency = self.wavenumber * speed;
        self.answers.clear();
        let answers = of.contacts.iter().map(|contact| contact.answer(wavelength));
        self.answers.extend(answers);
        self.receptances(of, self.angular_frequency, speed);
        for ((both, track), wheels) in self.both.iter_mut().zip(&self.track).zip(&self.wheels) {
            *both = track + wheels;
        }

        // Creepages by the unknowns: those that are no forces move nothing but their own.
        for (index, contact) in of.contacts.iter().enumerate() {
            for axis in 0..NORMAL {
                let own = 3 * index + axis;
                let row = &mut self.creepage[(2 * index + axis) * size..][..size];
                match contact.motion[axis] {
                    Motion::Held => row.fill(Complex64::ZERO),
                    Motion::Free => {
                        row.fill(Complex64::ZERO);
                        row[own] = Complex64::ONE;
                    }
                    // −iω/V = −ik.
                    Motion::Compliant(()) => {
                        let receptances = &self.both[own * size..][..size];
                        for (from, (entry, receptance)) in
                            row.iter_mut().zip(receptances).enumerate()
                        {
                            let share =
                                of.contacts[from / 3].force_share(from % 3) * self.wavenumber;
                            *entry = Complex64::new(receptance.im * share, -receptance.re * share);
                        }
                    }
                }
            }
        }

        for (index, (contact, answer)) in of.contacts.iter().zip(&self.answers).enumerate() {
            let creepages = &self.creepage[2 * index * size..][..2 * size];
            let (along, across) = creepages.split_at(size);
            for axis in 0..NORMAL {
                let row = &mut self.matrix[(3 * index + axis) * size..][..size];
                let [by_along, by_across] = answer.by_creepage.map(|by| by.force[axis]);
                for ((entry, along), across) in row.iter_mut().zip(along).zip(across) {
                    *entry = -(by_along * along + by_across * across);
                }
                row[3 * index + axis] += contact.force_share(axis);
                row[3 * index + NORMAL] -= answer.by_load.force[axis];
            }
            let own = 3 * index + NORMAL;
            let row = &mut self.matrix[own * size..][..size];
            let receptances = &self.both[own * size..][..size];
            for (from, (entry, receptance)) in row.iter_mut().zip(receptances).enumerate() {
                *entry = receptance * of.contacts[from / 3].force_share(from % 3);
            }
            row[own] += contact.stiffness.recip();
        }
    }

    /// Receptances of track and wheels in the axes of the contacts.
    pub(super) fn receptances(&mut self, of: &GeneralLoop, angular_frequency: f64, speed: f64) {
        self.track_axes(of, angular_frequency, speed);
        turn_axes(of, &mut self.track);
        turn_axes(of, &mut self.wheels);
    }

    /// The same in the axes of the track.
    pub(super) fn track_axes(&mut self, of: &GeneralLoop, angular_frequency: f64, speed: f64) {
        of.track
            .receptance_matrix(angular_frequency, speed, &self.on_track, &mut self.track);
        of.wheels
            .receptance_matrix(angular_frequency, speed, &self.on_wheels, &mut self.wheels);
    }

    /// A contact as the equations solved leave it.
    fn state(&self, of: &GeneralLoop, index: usize) -> ContactState {
        let (size, columns, column) = (self.size(), self.columns(), self.excitation[index]);
        let (contact, answer) = (&of.contacts[index], &self.answers[index]);
        let unknown = |of: usize| self.unknowns[of * columns + column];
        let creepage: [Complex64; 2] = std::array::from_fn(|axis| {
            let row = &self.creepage[(2 * index + axis) * size..][..size];
            let products = row
                .iter()
                .enumerate()
                .map(|(of, share)| share * unknown(of));
            products.sum()
        });
        let force: [Complex64; 3] =
            std::array::from_fn(|axis| contact.force_share(axis) * unknown(3 * index + axis));
        let lag = contact.place_of_wear.lag(self.wavelength);
        let mut energy = answer.by_load.energy * force[NORMAL];
        let mut at_rail = answer.by_load.at_rail(lag) * force[NORMAL];
        for (by, creepage) in answer.by_creepage.iter().zip(creepage) {
            energy += by.energy * creepage;
            at_rail += by.at_rail(lag) * creepage;
        }
        let rough = contact.profile != 0.0;
        let profile = if rough { contact.profile } else { 1.0 };
        let energy_at_rail = at_rail / (contact.phase(self.wavenumber) * profile);
        let depth = contact.wear.depth_per_energy() * energy_at_rail.re;
        ContactState {
            force,
            creepage,
            energy,
            energy_at_rail,
            growth_rate: rough.then(|| -depth / of.amplitude),
        }
    }

    /// The contacts of the point solved last, in their order.
    pub(super) fn states(&self) -> &[ContactState] {
        &self.states
    }

    pub(super) fn angular_frequency(&self) -> f64 {
        self.angular_frequency
    }

    pub(super) fn track_at_first(&self) -> [[Complex64; 3]; 3] {
        self.at_first(&self.track)
    }

    pub(super) fn wheels_at_first(&self) -> [[Complex64; 3]; 3] {
        self.at_first(&self.wheels)
    }

    /// e_P of the first contact \[J/m per N\].
    pub(super) fn energy_by_load(&self) -> Complex64 {
        self.answers[0].by_load.energy
    }

    fn at_first(&self, matrix: &[Complex64]) -> [[Complex64; 3]; 3] {
        let size = self.size();
        std::array::from_fn(|row| std::array::from_fn(|column| matrix[row * size + column]))
    }

    fn size(&self) -> usize {
        self.on_track.len()
    }

    fn columns(&self) -> usize {
        self.unknowns.len() / self.size()
    }
}

/// Turn a receptance matrix of all contacts from the axes of the track to those of each contact: T H Tᵀ.
fn turn_axes(of: &GeneralLoop, matrix: &mut [Complex64]) {
    let size = 3 * of.contacts.len();
    for (index, contact) in of.contacts.iter().enumerate() {
        if contact.angle == 0.0 {
            continue;
        }
        let (lateral, vertical) = (3 * index + 1, 3 * index + 2);
        let (above, below) = matrix.split_at_mut(vertical * size);
        let rows = above[lateral * size..].iter_mut().zip(&mut below[..size]);
        for (lateral, vertical) in rows {
            contact.turn(lateral, vertical);
        }
        for row in matrix.chunks_exact_mut(size) {
            let (left, right) = row.split_at_mut(vertical);
            contact.turn(&mut left[lateral], &mut right[0]);
        }
    }
}
