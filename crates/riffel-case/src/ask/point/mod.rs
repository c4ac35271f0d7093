//! All that a case says of one wavelength and speed, each quantity with its name and unit.

mod quantity;

use riffel_keys::{CaseError, say};
use std::f64::consts::TAU;

use riffel::{Complex64, LoopState};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::{Case, ContactName, DamagePoint};
pub use quantity::PointQuantity;

/// A number of a point, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointValue {
    /// Real.
    Real(f64),
    /// Complex amplitude for exp(+iωt), written as [re, im].
    Complex(Complex64),
}

/// One turn of the loop with the contact that it is of; serialises as one table.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// In the order of documents.
    pub quantities: Vec<(PointQuantity, PointValue)>,
    /// What the wave's own geometry does; `None` if it has no part.
    pub wave_geometry: Option<WavePoint>,
    /// What the direction of the normal force does; `None` if it stays upright.
    pub normal_direction: Option<DirectionPoint>,
    /// What laws of damage say; `None` if the case has none.
    pub damage: Option<DamagePoint>,
    /// What a loop on all axes adds.
    pub all_axes: Option<AllAxes>,
}

/// What the direction of the normal force on the slope of a wave does at the contact under study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DirectionPoint {
    /// Slip speed over V along the rail, before creep forces answer it.
    pub creepage: PointValue,
    /// What it adds to the normalised dissipation at a point of the rail, to that of an upright force on a hub which moves.
    pub dissipation: PointValue,
}

impl DirectionPoint {
    fn new(case: &Case, state: &LoopState) -> Option<Self> {
        let creepage = state.contacts[0].slip_by_direction?;
        let plain = case.feedback.clone().without_normal_direction();
        let plain = plain.at(state.wavelength, state.speed);
        let added = state.normalized_dissipation - plain.normalized_dissipation;
        Some(Self { creepage: PointValue::Complex(creepage), dissipation: PointValue::Complex(added) })
    }
}

/// What the wave's own geometry does at the contact under study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WavePoint {
    /// κ/Δ.
    pub kappa_per_m: f64,
    /// Φ.
    pub phi: f64,
    /// c₀κ, what it adds to the creepage: along the rail, and on all axes across it too.
    pub creepage: WaveCreepage,
    /// What it adds to the normalised dissipation at a point of the rail.
    pub dissipation: PointValue,
}

/// Creepage by the wave's own geometry, in phase with the profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum WaveCreepage {
    /// Along the rail.
    Along(f64),
    /// Along and across it.
    InPlane([f64; 2]),
}

impl WavePoint {
    fn new(case: &Case, state: &LoopState) -> Option<Self> {
        let wave = state.contacts[0].wave?;
        let [along, across] = wave.creepage.map(|creepage| creepage.re);
        let plain = case.feedback.clone().without_wave_geometry();
        let plain = plain.at(state.wavelength, state.speed);
        let added = state.normalized_dissipation - plain.normalized_dissipation;
        Some(Self {
            kappa_per_m: wave.curvature_per_metre,
            phi: wave.share,
            creepage: match case.feedback.is_along_one_axis() {
                true => WaveCreepage::Along(along),
                false => WaveCreepage::InPlane([along, across]),
            },
            dissipation: PointValue::Complex(added),
        })
    }
}

/// What a loop on all axes adds to a point; axes of the contact are x, t, n.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AllAxes {
    /// Steady creep forces Q_x and Q_t of the contact under study \[N\].
    pub steady_force_n: [f64; 2],
    /// Receptance of the track at the contact under study, in its axes.
    pub track_receptance_matrix_m_per_n: [[PointValue; 3]; 3],
    /// Receptance of the wheel at the contact under study, in its axes.
    pub wheel_receptance_matrix_m_per_n: [[PointValue; 3]; 3],
    /// Every contact: those on the rail under study from the first wheel on, then those on the opposite rail.
    pub contacts: Vec<ContactPoint>,
}

/// One of the contacts of a loop on all axes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactPoint {
    /// Which.
    #[serde(flatten)]
    pub name: ContactName,
    /// Oscillating normal force.
    pub normal_force_n: PointValue,
    /// Oscillating longitudinal force.
    pub tangential_force_n: PointValue,
    /// Oscillating lateral force.
    pub lateral_force_n: PointValue,
    /// Growth rate of the profile of its rail per passage of this wheel; none on a smooth rail.
    pub growth_rate_per_passage: Option<f64>,
}

impl AllAxes {
    fn new(case: &Case, state: &LoopState) -> Option<Self> {
        if case.feedback.is_along_one_axis() {
            return None;
        }
        let contacts = ContactName::all(&case.feedback);
        let contacts = contacts.into_iter().zip(&state.contacts);
        let contacts = contacts.map(|(name, at)| {
            let [tangential, lateral, normal] = at.force.map(PointValue::Complex);
            ContactPoint {
                name,
                normal_force_n: normal,
                tangential_force_n: tangential,
                lateral_force_n: lateral,
                growth_rate_per_passage: at.growth_rate,
            }
        });
        let forces = case.steady.forces;
        Some(Self {
            steady_force_n: [forces.longitudinal, forces.lateral],
            track_receptance_matrix_m_per_n: state.track_receptance.map(|row| row.map(PointValue::Complex)),
            wheel_receptance_matrix_m_per_n: state.wheel_receptance.map(|row| row.map(PointValue::Complex)),
            contacts: contacts.collect(),
        })
    }
}

impl Point {
    /// The quantities of a state of the loop of a case.
    pub fn new(case: &Case, state: &LoopState) -> Self {
        let quantities = PointQuantity::ALL.into_iter();
        Self {
            quantities: quantities.filter_map(|quantity| Some((quantity, quantity.value(case, state)?))).collect(),
            wave_geometry: WavePoint::new(case, state),
            normal_direction: DirectionPoint::new(case, state),
            damage: DamagePoint::new(case, state),
            all_axes: AllAxes::new(case, state),
        }
    }
}

impl Point {
    /// The first quantity that is infinite or not a number.
    pub(crate) fn not_finite(&self) -> Option<PointQuantity> {
        let finite = |value: &PointValue| match value {
            PointValue::Real(value) => value.is_finite(),
            PointValue::Complex(value) => value.is_finite(),
        };
        let found = self.quantities.iter().find(|(_, value)| !finite(value));
        found.map(|&(quantity, _)| quantity)
    }
}

impl Serialize for PointValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Real(value) => value.serialize(serializer),
            Self::Complex(value) => [value.re, value.im].serialize(serializer),
        }
    }
}

impl Serialize for Point {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (quantity, value) in &self.quantities {
            map.serialize_entry(quantity.key(), value)?;
        }
        if let Some(wave) = &self.wave_geometry {
            map.serialize_entry("wave_geometry", wave)?;
        }
        if let Some(direction) = &self.normal_direction {
            map.serialize_entry("normal_direction", direction)?;
        }
        if let Some(damage) = &self.damage {
            map.serialize_entry("damage", damage)?;
        }
        if let Some(all_axes) = &self.all_axes {
            map.serialize_entry("steady_force_n", &all_axes.steady_force_n)?;
            let track = &all_axes.track_receptance_matrix_m_per_n;
            map.serialize_entry("track_receptance_matrix_m_per_n", track)?;
            let wheel = &all_axes.wheel_receptance_matrix_m_per_n;
            map.serialize_entry("wheel_receptance_matrix_m_per_n", wheel)?;
            map.serialize_entry("contacts", &all_axes.contacts)?;
        }
        map.end()
    }
}

impl Case {
    /// One turn of the loop at a wavelength \[m\] and a speed \[m/s\], inside or outside the window of the map.
    ///
    /// # Errors
    /// [`CaseError`] for a point outside its physical range, where the track is not known or the contact not resolved,
    /// and where a number would not be finite.
    pub fn point(&self, wavelength: f64, speed: f64) -> Result<LoopState, CaseError> {
        self.check_points([wavelength; 2], [speed; 2])?;
        let amplitude = self.feedback.amplitude();
        let wave = self.feedback.contacts()[0].wave.as_ref();
        let bridged = |radius: f64| amplitude * radius * (TAU / wavelength).powi(2) >= 1.0;
        let chosen = self.keys.text.is_written("corrugation.amplitude");
        if chosen && wave.is_some_and(|wave| bridged(wave.radius())) {
            // To a micrometre, as it was meant.
            let wavelength = (1e6 * wavelength).round() / 1e6;
            return Err(self.keys.out_of_range(
                "corrugation.amplitude",
                self.file.corrugation.amplitude,
                say!(below_r_at_the_wavelength_of, wavelength),
            ));
        }
        let case = self.covering(wavelength, wavelength)?;
        let state = case.feedback.at(wavelength, speed);
        match Point::new(&case, &state).not_finite() {
            None => Ok(state),
            Some(quantity) => {
                Err(CaseError::Point { message: say!(at_m_and_m_s_is, quantity = quantity.name(), wavelength, speed) })
            }
        }
    }
}
