//! What the contacts answer, over the wavelengths of the lanes of a vector register.

use std::f64::consts::PI;

use num_complex::Complex64;
use pulp::Simd;

use super::GeneralLoop;
use crate::vector::Vector;

/// Numbers of each contact.
const NUMBERS: usize = 10;

/// Wavelengths solved together, with all that depends on them alone.
#[derive(Clone)]
pub(crate) struct Answers {
    /// The wavelengths \[m\], at most one for each lane.
    wavelengths: Vec<f64>,
    /// 2π/λ \[rad/m\] of each lane; those without a wavelength of their own have the last.
    wavenumbers: Vec<f64>,
    /// Of each contact its numbers, as [`of_contact`](Self::of_contact) takes them apart; of each number the real parts of
    /// all lanes, then the imaginary ones.
    numbers: Vec<f64>,
}

/// What one contact answers.
pub(super) struct Answer<N> {
    /// F_P.
    pub(super) force_by_load: [N; 2],
    /// F_ξ \[N\], a row for each force.
    pub(super) force_by_creepage: [[N; 2]; 2],
    /// The profile under the contact \[m\].
    pub(super) profile: N,
    /// What its energies at the rail point add to Ŵ₁ of the mean growth, per normal force \[1/N\].
    pub(super) growth_by_load: N,
    /// The same per creepage \[-\].
    pub(super) growth_by_creepage: [N; 2],
}

impl Answers {
    /// Those of a loop at no more wavelengths \[m\] than lanes.
    pub(super) fn new(of: &GeneralLoop, wavelengths: &[f64], lanes: usize) -> Self {
        let last = wavelengths.len() - 1;
        let of_lane = |lane: usize| wavelengths[lane.min(last)];
        let mut numbers = vec![0.0; 2 * NUMBERS * of.contacts.len() * lanes];
        for lane in 0..lanes {
            let wavelength = of_lane(lane);
            let answers = (0..of.contacts.len()).map(|index| Answer::new(of, index, wavelength));
            let parts = numbers.chunks_exact_mut(2 * lanes);
            for (parts, number) in parts.zip(answers.flat_map(Answer::numbers)) {
                (parts[lane], parts[lanes + lane]) = (number.re, number.im);
            }
        }
        Self {
            wavelengths: wavelengths.to_vec(),
            wavenumbers: (0..lanes).map(|lane| 2.0 * PI / of_lane(lane)).collect(),
            numbers,
        }
    }

    pub(crate) fn wavelengths(&self) -> &[f64] {
        &self.wavelengths
    }

    pub(super) fn wavenumbers(&self) -> &[f64] {
        &self.wavenumbers
    }

    /// Those of each contact, in their order.
    #[inline(always)]
    pub(super) fn of_contacts<S: Simd>(&self) -> impl Iterator<Item = Answer<Vector<S>>> {
        let (contacts, _) = Vector::<S>::row(&self.numbers).as_chunks::<NUMBERS>();
        contacts.iter().map(|&numbers| {
            let [a, b, c, d, e, f, g, h, i, j] = numbers.map(Vector::from);
            Answer {
                force_by_load: [a, b],
                force_by_creepage: [[c, d], [e, f]],
                profile: g,
                growth_by_load: h,
                growth_by_creepage: [i, j],
            }
        })
    }
}

impl Answer<Complex64> {
    fn new(of: &GeneralLoop, index: usize, wavelength: f64) -> Self {
        let contact = &of.contacts[index];
        let derivatives = contact.derivatives(wavelength);
        let [along, across] = derivatives.by_creepage.map(|by| by.force);
        let phase = contact.phase(2.0 * PI / wavelength);
        let lag = contact.place_of_wear.lag(wavelength);
        let growth = of.share_of_growth(index) / (phase * contact.profile_or_one());
        Self {
            force_by_load: derivatives.by_load.force,
            force_by_creepage: [[along[0], across[0]], [along[1], across[1]]],
            profile: of.amplitude * contact.profile * phase,
            growth_by_load: derivatives.by_load.at_rail(lag) * growth,
            growth_by_creepage: derivatives.by_creepage.map(|by| by.at_rail(lag) * growth),
        }
    }

    fn numbers(self) -> [Complex64; NUMBERS] {
        let [a, b] = self.force_by_load;
        let [[c, d], [e, f]] = self.force_by_creepage;
        let [i, j] = self.growth_by_creepage;
        [a, b, c, d, e, f, self.profile, self.growth_by_load, i, j]
    }
}
