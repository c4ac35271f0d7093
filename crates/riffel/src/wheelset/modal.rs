//! The wheelset by its natural modes.

use num_complex::Complex64;

use super::modal_names::names;
use super::{ContactReceptances, ModeName, RigidWheelset, Wheelset};
use crate::Error;

/// An elastic mode of a wheelset, from its finite-element model or a modal test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticMode {
    /// Natural angular frequency without damping, ω_n \[rad/s\].
    pub angular_frequency: f64,
    /// Damping ratio ζ_n \[-\]; half the loss factor.
    pub damping_ratio: f64,
    /// Generalised mass m_n \[kg\]: φᵀMφ, of a shape without unit. One for a mass-normalised shape, whose unit is 1/√kg.
    pub generalised_mass: f64,
    /// Shape φ_n at the contacts, in the order of [`Port::ALL`](super::Port::ALL): of the surface of the wheels, along the
    /// axes of the track.
    pub shape: [f64; 6],
}

/// A wheelset as the sum of its modes:
///
/// ```text
/// H = H_rigid + Σ φ_n φ_nᵀ / m_n(ω_n² − ω² + 2iζ_nω_nω) + residual
/// ```
///
/// with the residual compliance of the modes that are left out, which is static far below them.
///
/// Range of validity: to about half the highest natural frequency without a residual, to most of it with one; as
/// exact as the modes. Rotation is left out.
#[derive(Debug, Clone, PartialEq)]
pub struct ModalWheelset {
    rigid: Option<RigidWheelset>,
    modes: Vec<ElasticMode>,
    residual: [[f64; 6]; 6],
}

impl ModalWheelset {
    /// Elastic modes over the motion as a rigid body; without the latter where the modes contain it, as those of a wheelset
    /// on its suspension do.
    ///
    /// # Errors
    /// [`Error::Measurement`] with the number of the mode unless its frequency and generalised mass are positive, its damping
    /// ratio is at least 0 and below 1 and its shape is finite; and where it moves a contact as less than a 500th of the
    /// rigid wheelset would, m_n/φ², because a shape whose greatest displacement is one then passes for a mass of 1 kg,
    /// and one in units of tonnes for a thousandth of the true mass.
    pub fn new(rigid: Option<RigidWheelset>, modes: Vec<ElasticMode>) -> Result<Self, Error> {
        /// Webs and tyres move contacts as masses of some 10 kg, of wheelsets of 1000 kg.
        const LEAST_SHARE: f64 = 1.0 / 500.0;
        let positive = |value: f64| value.is_finite() && value > 0.0;
        for (index, mode) in modes.iter().enumerate() {
            let wrong = |rule: &'static str| Err(Error::Measurement { index, rule });
            if !positive(mode.angular_frequency) {
                return wrong(
                    "the natural frequency of an elastic mode must be finite and above zero; motion as a rigid \
                     body is told by its mass and inertias",
                );
            }
            if !(0.0..1.0).contains(&mode.damping_ratio) {
                return wrong("the damping ratio of a mode must be at least 0 and below 1");
            }
            if !positive(mode.generalised_mass) {
                return wrong("the generalised mass of a mode must be finite and above zero");
            }
            if mode.shape.iter().any(|value| !value.is_finite()) {
                return wrong("the shape of a mode must be finite at both contacts");
            }
            let largest = mode.shape.iter().fold(0f64, |most, value| most.max(value.abs()));
            let moved = mode.generalised_mass / (largest * largest);
            if rigid.is_some_and(|rigid| moved < LEAST_SHARE * rigid.body().mass) {
                return wrong(
                    "a mode moves a contact as less than a 500th of the wheelset's mass would: give its generalised \
                     mass, or a shape in 1/√kg",
                );
            }
        }
        Ok(Self { rigid, modes, residual: [[0.0; 6]; 6] })
    }

    /// Wheelset with a residual compliance \[m/N\] at the contacts, `[at][from]`.
    ///
    /// # Errors
    /// [`Error::Measurement`] with the number of the row unless it is finite and symmetric to 1e-6 of its largest entry.
    pub fn with_residual(self, residual: [[f64; 6]; 6]) -> Result<Self, Error> {
        const ROUNDING: f64 = 1e-6;
        let largest = residual.iter().flatten().fold(0f64, |most, value| most.max(value.abs()));
        for (index, row) in residual.iter().enumerate() {
            for (value, other) in row.iter().zip(residual.map(|row| row[index])) {
                // False for what is not a number.
                let symmetric = (value - other).abs() <= ROUNDING * largest;
                if !(symmetric && value.is_finite()) {
                    return Err(Error::Measurement {
                        index,
                        rule: "a residual compliance must be finite and symmetric",
                    });
                }
            }
        }
        Ok(Self { residual, ..self })
    }

    /// True where a residual compliance stands for the modes left out.
    pub fn has_residual(&self) -> bool {
        self.residual.iter().flatten().any(|&entry| entry != 0.0)
    }

    /// Its elastic modes.
    pub fn modes(&self) -> &[ElasticMode] {
        &self.modes
    }

    /// What they are, in their order, by how they move the contacts: bending in either plane, torsion, or unnamed.
    pub fn mode_names(&self) -> Vec<ModeName> {
        names(&self.modes)
    }
}

impl Wheelset for ModalWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        let w = angular_frequency;
        let mut receptances = match &self.rigid {
            Some(rigid) => rigid.receptances(w),
            None => [[Complex64::ZERO; 6]; 6],
        };
        for (row, residual) in receptances.iter_mut().zip(self.residual) {
            for (entry, residual) in row.iter_mut().zip(residual) {
                *entry += residual;
            }
        }
        for mode in &self.modes {
            let natural = mode.angular_frequency;
            let stiffness = Complex64::new(natural * natural - w * w, 2.0 * mode.damping_ratio * natural * w);
            let compliance = (mode.generalised_mass * stiffness).inv();
            for (row, at) in receptances.iter_mut().zip(mode.shape) {
                for (entry, from) in row.iter_mut().zip(mode.shape) {
                    *entry += at * from * compliance;
                }
            }
        }
        receptances
    }

    /// Elastic modes and what stands for those left out spring back.
    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        self.rigid.map_or([[0.0; 6]; 6], |rigid| rigid.free_at_contacts())
    }
}
