//! All that a case says of one wavelength and speed, each quantity with its name and unit.

use riffel::{Complex64, LoopState};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::Case;

/// A number of a point, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PointValue {
    /// Real.
    Real(f64),
    /// Complex amplitude for exp(+iωt), written as [re, im].
    Complex(Complex64),
}

/// A quantity at one wavelength and speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointQuantity {
    /// Key in documents, with the unit in it.
    pub key: &'static str,
    /// SI unit, "1" for a ratio.
    pub unit: &'static str,
    /// What it is.
    pub name: &'static str,
    /// The number.
    pub value: PointValue,
}

/// One turn of the loop with the contact that it is of; serialises as one table.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// In the order of documents.
    pub quantities: Vec<PointQuantity>,
}

impl Point {
    /// The quantities of a state of the loop of a case.
    pub fn new(case: &Case, state: &LoopState) -> Self {
        let mut quantities = Vec::new();
        let mut add = |key, unit, name, value| {
            quantities.push(PointQuantity {
                key,
                unit,
                name,
                value,
            });
        };
        use PointValue::{Complex, Real};
        // A derivative of the contact is a number if it answers at once, a pair if it answers late.
        let derivative = |value: Complex64| match value.im == 0.0 {
            true => Real(value.re),
            false => Complex(value),
        };
        let hertz = case.hertz;
        add(
            "wavelength_m",
            "m",
            "wavelength of the corrugation",
            Real(state.wavelength),
        );
        add(
            "speed_m_per_s",
            "m/s",
            "speed of the vehicle",
            Real(state.speed),
        );
        add(
            "frequency_hz",
            "Hz",
            "frequency",
            Real(state.speed / state.wavelength),
        );
        add(
            "semi_axis_longitudinal_m",
            "m",
            "semi-axis of the contact ellipse along the rail",
            Real(hertz.semi_axis_longitudinal()),
        );
        add(
            "semi_axis_lateral_m",
            "m",
            "semi-axis of the contact ellipse across the rail",
            Real(hertz.semi_axis_lateral()),
        );
        // Of the paper's creep law only.
        if let Some(law) = case.carter {
            add(
                "creep_coefficient",
                "1",
                "creep coefficient",
                Real(law.creep_coefficient()),
            );
            add(
                "saturation_creepage",
                "1",
                "creepage of full slip",
                Real(law.saturation_creepage()),
            );
        }
        add("creepage", "1", "mean creepage", Real(case.steady.creepage));
        add(
            "contact_stiffness_n_per_m",
            "N/m",
            "stiffness of the contact",
            Real(case.feedback.contact_stiffness),
        );
        add(
            "angular_frequency_rad_per_s",
            "rad/s",
            "angular frequency",
            Real(state.angular_frequency),
        );
        add(
            "rail_receptance_m_per_n",
            "m/N",
            "receptance of the rail",
            Complex(state.track_receptance),
        );
        add(
            "wheel_receptance_m_per_n",
            "m/N",
            "receptance of the wheel",
            derivative(state.wheel_receptance),
        );
        add(
            "normal_force_n",
            "N",
            "oscillating normal force P1",
            Complex(state.normal_force),
        );
        add(
            "dq_dp",
            "1",
            "tangential force per normal force",
            derivative(state.dq_dp),
        );
        add(
            "dq_domega_n_s_per_rad",
            "N s/rad",
            "tangential force per angular velocity",
            derivative(state.dq_domega),
        );
        add(
            "dw_dp_m_per_s",
            "m/s",
            "dissipated power per normal force",
            derivative(state.dw_dp),
        );
        add(
            "dw_domega_w_s_per_rad",
            "W s/rad",
            "dissipated power per angular velocity",
            derivative(state.dw_domega),
        );
        add(
            "tangential_force_n",
            "N",
            "oscillating tangential force Q1",
            Complex(state.tangential_force),
        );
        add(
            "angular_velocity_rad_per_s",
            "rad/s",
            "oscillating angular velocity of the wheel",
            Complex(state.angular_velocity),
        );
        add(
            "dissipation_w",
            "W",
            "oscillating dissipated power at the wheel W1",
            Complex(state.dissipation),
        );
        add(
            "dissipation_phase_rad",
            "rad",
            "lag of the dissipation at a point of the rail",
            Real(state.dissipation_lag_angle),
        );
        add(
            "dissipation_lag_w",
            "W",
            "oscillating dissipated power at a point of the rail",
            Complex(state.dissipation_at_rail),
        );
        add(
            "normalized_dissipation",
            "1",
            "W1/(mu P0 V xi0) at a point of the rail, growth where its real part is negative",
            Complex(state.normalized_dissipation),
        );
        add(
            "normalized_by_mean",
            "1",
            "dissipated power at a point of the rail over its mean",
            Complex(state.dissipation_at_rail / state.mean_dissipation),
        );
        add(
            "mean_dissipation_w",
            "W",
            "mean dissipated power W0",
            Real(state.mean_dissipation),
        );
        add(
            "growth_rate_per_passage",
            "1",
            "growth rate of the amplitude per passage of a wheel",
            Real(state.growth_rate),
        );
        Self { quantities }
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
        let mut map = serializer.serialize_map(Some(self.quantities.len()))?;
        for quantity in &self.quantities {
            map.serialize_entry(quantity.key, &quantity.value)?;
        }
        map.end()
    }
}
