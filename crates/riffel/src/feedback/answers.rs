//! What the contacts answer, over the wavelengths of the lanes of a vector register.

use std::f64::consts::PI;

use num_complex::Complex64;
use pulp::Simd;

use super::Loop;
use crate::vector::Vector;

/// Numbers of each contact.
const NUMBERS: usize = 18;

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
    /// What the creep forces in the axes of the mean state take of a shift on the wheel \[N/m\], with the sign of the left side of
    /// the equations.
    pub(super) force_by_shift: [N; 2],
    /// What the displacement along the normal takes of it \[-\].
    pub(super) approach_by_shift: N,
    /// Roll by the cross slope of the profile \[rad\], right side down for the wheel against the rail.
    pub(super) roll: N,
    /// The force that the profile makes by its own geometry \[N\].
    pub(super) force_by_profile: [N; 2],
    /// What that geometry adds to Ŵ₁ of the mean growth at constant load and slip speed \[-\].
    pub(super) growth_by_profile: N,
    /// What its energies at the rail point add to Ŵ₁ of the mean growth, per normal force \[1/N\].
    pub(super) growth_by_load: N,
    /// Growth per creepage \[-\].
    pub(super) growth_by_creepage: [N; 2],
    /// Growth per shift on the wheel \[1/m\].
    pub(super) growth_by_shift: N,
}

impl Answers {
    /// Answers of a loop at no more wavelengths \[m\] than lanes.
    pub(super) fn new(of: &Loop, wavelengths: &[f64], lanes: usize) -> Self {
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

    /// Answers of a contact, by its number.
    #[inline(always)]
    pub(super) fn of_contact<S: Simd>(&self, index: usize) -> Answer<Vector<S>> {
        let numbers = &Vector::<S>::row(&self.numbers)[NUMBERS * index..][..NUMBERS];
        let at = |number: usize| numbers[number].into();
        Answer {
            force_by_load: [at(0), at(1)],
            force_by_creepage: [[at(2), at(3)], [at(4), at(5)]],
            profile: at(6),
            force_by_shift: [at(7), at(8)],
            approach_by_shift: at(9),
            roll: at(10),
            growth_by_load: at(11),
            growth_by_creepage: [at(12), at(13)],
            growth_by_shift: at(14),
            force_by_profile: [at(15), at(16)],
            growth_by_profile: at(17),
        }
    }
}

impl Answer<Complex64> {
    fn new(of: &Loop, index: usize, wavelength: f64) -> Self {
        let contact = &of.contacts[index];
        let derivatives = contact.derivatives(wavelength);
        let wavenumber = 2.0 * PI / wavelength;
        let [along, across] = derivatives.by_creepage.map(|by| by.force);
        let phase = contact.phase(wavenumber);
        let growth = of.share_of_growth(index) / (phase * contact.profile_or_one());
        let by_creepage = derivatives.by_creepage.map(|by| by.growth * growth);
        let by_load = derivatives.by_load.growth * growth;
        let by_spin = derivatives.by_spin.growth * growth;
        // With f the forces in the axes of the mean state, Q = f − (its part by the shift): Q − F_P P − F_ξ ξ = 0.
        let shift = contact.by_shift();
        let own = [0.0, shift.lateral_force];
        let force_by_shift = std::array::from_fn(|axis| {
            derivatives.by_load.force[axis] * shift.normal_force
                - own[axis]
                - along[axis] * shift.creepage
                - derivatives.by_spin.force[axis] * shift.spin
        });
        let profile = of.amplitude * contact.profile * phase;
        let cross_slope = contact.moving.map_or(0.0, |moving| moving.cross_slope);
        let by_profile = derivatives.by_profile;
        Self {
            force_by_load: derivatives.by_load.force,
            force_by_creepage: [[along[0], across[0]], [along[1], across[1]]],
            profile: profile * derivatives.pressed,
            force_by_shift,
            approach_by_shift: (-shift.normal_force / contact.stiffness).into(),
            roll: contact.rail.sign() * cross_slope * profile,
            growth_by_load: by_load,
            growth_by_creepage: by_creepage,
            growth_by_shift: by_creepage[0] * shift.creepage + by_spin * shift.spin - by_load * shift.normal_force,
            force_by_profile: by_profile.force.map(|force| force * profile),
            growth_by_profile: by_profile.growth * growth * profile,
        }
    }

    fn numbers(self) -> [Complex64; NUMBERS] {
        let [a, b] = self.force_by_load;
        let [[c, d], [e, f]] = self.force_by_creepage;
        let [h, i] = self.force_by_shift;
        let [m, n] = self.growth_by_creepage;
        let [p, q] = self.force_by_profile;
        [
            a,
            b,
            c,
            d,
            e,
            f,
            self.profile,
            h,
            i,
            self.approach_by_shift,
            self.roll,
            self.growth_by_load,
            m,
            n,
            self.growth_by_shift,
            p,
            q,
            self.growth_by_profile,
        ]
    }
}
