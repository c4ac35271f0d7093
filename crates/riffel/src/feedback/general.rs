//! The loop on all axes: several contacts, each with a normal force and two creep forces.

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;

use crate::contact::ContactDerivative;
use crate::receptance::Structure;
use crate::wheelset::Motion;
use crate::{Direction, EnergyWear, Error, Place, PlaceOfWear, Rail, RollingContact};

/// The index of the normal force among the unknowns of a contact, after those along and across the rail.
const NORMAL: usize = 2;

/// A contact of a wheel with a rail.
#[derive(Clone)]
pub struct Contact {
    /// Distance along the rail \[m\]: zero for the first wheel, negative behind it.
    pub along: f64,
    /// The rail.
    pub rail: Rail,
    /// Linearised stiffness k_H \[N/m\].
    pub stiffness: f64,
    /// Steady rolling and its linear response.
    pub rolling: Arc<dyn RollingContact>,
    /// What holds or frees the surfaces along the rail and across it: compliant where track and wheel say how they yield.
    pub motion: [Motion<()>; 2],
    /// Phase between dissipation at the wheel and at a point of the rail.
    pub place_of_wear: PlaceOfWear,
    /// Law of wear.
    pub wear: EnergyWear,
}

/// The loop of [`FeedbackLoop`](crate::FeedbackLoop) for any number of contacts on all axes, linear in the amplitude of the profile.
///
/// For each contact, with the forces f = (Q_x, Q_y, P) of the wheel on the rail and H the receptance of track and wheel
/// together, over all contacts:
///
/// ```text
/// normal    P₁/k_H = Δ p − (H f₁)_z                   p = e^{ikx} of the place
/// creepage  V ξ₁ = −iω (H f₁)_{x,y}
/// creep     Q₁ = F_P P₁ + F_ξ ξ₁
/// energy    e₁ = e_P P₁ + e_ξ ξ₁
/// ```
///
/// A held axis has no ξ₁; on a free one Q₁ vanishes and ξ₁ takes its place among the unknowns. The rail runs level
/// under the wheel: the contact axes are those of the track.
///
/// Method: 3n complex linear equations by elimination with row pivots. Cost: O(27n³) and 9n² receptances a point; the
/// loop of one wheel and one axis is solved in closed form by `FeedbackLoop` and agrees to rounding.
#[derive(Clone)]
pub struct GeneralLoop {
    /// The track.
    pub track: Arc<dyn Structure>,
    /// The wheels, with all that connects them.
    pub wheels: Arc<dyn Structure>,
    /// The contacts.
    pub contacts: Vec<Contact>,
    /// Amplitude Δ of the profile \[m\], on every rail.
    pub amplitude: f64,
}

/// One contact in one turn of the loop: complex amplitudes relative to a profile of real amplitude Δ under the first wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct ContactState {
    /// Forces Q_x, Q_y and P of the wheel on the rail \[N\].
    pub force: [Complex64; 3],
    /// Longitudinal and lateral creepage \[-\].
    pub creepage: [Complex64; 2],
    /// Energy left at a point of the rail \[J/m\], relative to the profile under this wheel.
    pub energy_at_rail: Complex64,
    /// Growth rate of |Δ| per passage of this wheel \[-\], positive where corrugation grows.
    pub growth_rate: f64,
}

impl GeneralLoop {
    /// The contacts at the wavelength \[m\] and speed \[m/s\], both positive, in their order.
    ///
    /// # Errors
    /// [`Error::NoResponse`] where a contact moves across the rail and does not tell its response to lateral
    /// creepage; [`Error::NotConverged`] where the equations have no single solution.
    pub fn at(&self, wavelength: f64, speed: f64) -> Result<Vec<ContactState>, Error> {
        let count = self.contacts.len();
        let wavenumber = 2.0 * PI / wavelength;
        let answers = self
            .contacts
            .iter()
            .map(|contact| Answer::of(contact, wavelength));
        let answers: Vec<Answer> = answers.collect::<Result<_, _>>()?;
        let receptances = self.receptances(wavenumber * speed, speed);
        let creepage =
            |contact: usize, axis: usize| self.creepage(&receptances, wavenumber, contact, axis);

        let mut matrix = Vec::with_capacity(3 * count);
        let mut right = vec![Complex64::ZERO; 3 * count];
        for (index, (contact, answer)) in self.contacts.iter().zip(&answers).enumerate() {
            let creepages = [creepage(index, 0), creepage(index, 1)];
            for axis in 0..NORMAL {
                // Q − F_P P − F_ξ ξ = 0.
                let mut row = vec![Complex64::ZERO; 3 * count];
                row[3 * index + axis] = contact.force_share(axis).into();
                row[3 * index + NORMAL] = -answer.by_load.force[axis];
                for (by, creepage) in answer.by_creepage.iter().zip(&creepages) {
                    for (entry, share) in row.iter_mut().zip(creepage) {
                        *entry -= by.force[axis] * share;
                    }
                }
                matrix.push(row);
            }
            // P/k_H + (H f)_z = Δ p.
            let mut row = self.displacement(&receptances, 3 * index + NORMAL);
            row[3 * index + NORMAL] += contact.stiffness.recip();
            matrix.push(row);
            right[3 * index + NORMAL] = self.amplitude * contact.phase(wavenumber);
        }
        let unknowns = solve(matrix, right)?;

        let states = self.contacts.iter().zip(&answers).enumerate();
        Ok(states
            .map(|(index, (contact, answer))| {
                let sum = |row: Vec<Complex64>| -> Complex64 {
                    row.iter()
                        .zip(&unknowns)
                        .map(|(share, value)| share * value)
                        .sum()
                };
                let creepage = [0, 1].map(|axis| sum(creepage(index, axis)));
                let force: [Complex64; 3] = std::array::from_fn(|axis| {
                    contact.force_share(axis) * unknowns[3 * index + axis]
                });
                let lag = contact.place_of_wear.lag(wavelength);
                let mut energy = answer.by_load.at_rail(lag) * force[NORMAL];
                for (by, creepage) in answer.by_creepage.iter().zip(creepage) {
                    energy += by.at_rail(lag) * creepage;
                }
                let energy_at_rail = energy / contact.phase(wavenumber);
                let depth = contact.wear.depth_per_energy() * energy_at_rail.re;
                ContactState {
                    force,
                    creepage,
                    energy_at_rail,
                    growth_rate: -depth / self.amplitude,
                }
            })
            .collect())
    }

    /// Receptances of track and wheels together \[m/N\], by the axes of all contacts in their order.
    fn receptances(&self, angular_frequency: f64, speed: f64) -> Vec<Vec<Complex64>> {
        let places: Vec<Place> = self.contacts.iter().flat_map(Contact::places).collect();
        let between = |at: Place, from: Place| {
            let of = |structure: &dyn Structure| {
                structure.cross_receptance(angular_frequency, speed, at, from)
            };
            of(&*self.track) + of(&*self.wheels)
        };
        let row = |&at: &Place| places.iter().map(|&from| between(at, from)).collect();
        places.iter().map(row).collect()
    }

    /// Displacement along an axis by the unknowns \[m per unit\]: those that are no forces do not move it.
    fn displacement(&self, receptances: &[Vec<Complex64>], axis: usize) -> Vec<Complex64> {
        let row = receptances[axis].iter().enumerate();
        row.map(|(from, receptance)| receptance * self.contacts[from / 3].force_share(from % 3))
            .collect()
    }

    /// Creepage of a contact along one of its axes by the unknowns.
    fn creepage(
        &self,
        receptances: &[Vec<Complex64>],
        wavenumber: f64,
        contact: usize,
        axis: usize,
    ) -> Vec<Complex64> {
        let own = 3 * contact + axis;
        match self.contacts[contact].motion[axis] {
            Motion::Held => vec![Complex64::ZERO; receptances.len()],
            Motion::Free => {
                let mut row = vec![Complex64::ZERO; receptances.len()];
                row[own] = Complex64::ONE;
                row
            }
            // −iω/V = −ik.
            Motion::Compliant(()) => {
                let mut row = self.displacement(receptances, own);
                for entry in &mut row {
                    *entry *= Complex64::new(0.0, -wavenumber);
                }
                row
            }
        }
    }
}

impl Contact {
    /// Its axes as places on track and wheel.
    fn places(&self) -> [Place; 3] {
        Direction::ALL.map(|direction| Place {
            along: self.along,
            rail: self.rail,
            direction,
        })
    }

    /// The profile under it, relative to that under the first wheel.
    fn phase(&self, wavenumber: f64) -> Complex64 {
        Complex64::cis(wavenumber * self.along)
    }

    /// One where the unknown of an axis is a force, zero where it is a creepage.
    fn force_share(&self, axis: usize) -> f64 {
        match self.motion.get(axis) {
            Some(Motion::Free) => 0.0,
            _ => 1.0,
        }
    }
}

/// What a contact answers at one wavelength.
struct Answer {
    by_load: ContactDerivative,
    by_creepage: [ContactDerivative; 2],
}

impl Answer {
    fn of(contact: &Contact, wavelength: f64) -> Result<Self, Error> {
        /// What a creepage that is held does.
        const NOTHING: ContactDerivative = ContactDerivative {
            force: [Complex64::ZERO; 2],
            energy: Complex64::ZERO,
            energy_at_rail: None,
        };
        let response = contact.rolling.response(wavelength);
        let lateral = match (response.by_lateral, &contact.motion[1]) {
            (Some(by_lateral), _) => by_lateral,
            (None, Motion::Held) => NOTHING,
            (None, _) => {
                return Err(Error::NoResponse {
                    creepage: "lateral creepage",
                });
            }
        };
        Ok(Self {
            by_load: response.by_load,
            by_creepage: [response.by_longitudinal, lateral],
        })
    }
}

/// The solution of square linear equations, by elimination with row pivots.
///
/// Own, because a crate for dense matrices takes longer to build than all of this one and the systems are small.
fn solve(
    mut matrix: Vec<Vec<Complex64>>,
    mut right: Vec<Complex64>,
) -> Result<Vec<Complex64>, Error> {
    let size = right.len();
    // Forces and displacements differ by ten orders: rows are compared by the size of their own entries.
    let largest = |row: &Vec<Complex64>| row.iter().map(|entry| entry.norm()).fold(0.0, f64::max);
    let mut scales: Vec<f64> = matrix.iter().map(largest).collect();
    for column in 0..size {
        let weight = |row: usize| matrix[row][column].norm() / scales[row];
        let pivot = (column..size).max_by(|&a, &b| weight(a).total_cmp(&weight(b)));
        let pivot = pivot
            .filter(|&row| weight(row) > 0.0)
            .ok_or(Error::NotConverged {
                problem: "the loop of several contacts",
                residual: f64::INFINITY,
                tolerance: 0.0,
                remedy: "its equations are singular: free or hold fewer axes",
            })?;
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        scales.swap(column, pivot);
        let (above, below) = matrix.split_at_mut(column + 1);
        let above = &above[column];
        for (offset, row) in below.iter_mut().enumerate() {
            let factor = row[column] / above[column];
            for (entry, pivot) in row[column..].iter_mut().zip(&above[column..]) {
                *entry -= factor * pivot;
            }
            let subtrahend = factor * right[column];
            right[column + 1 + offset] -= subtrahend;
        }
    }
    for row in (0..size).rev() {
        let known: Complex64 = (row + 1..size)
            .map(|column| matrix[row][column] * right[column])
            .sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    Ok(right)
}
