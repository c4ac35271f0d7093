//! The quantities of a point: keys, units, names, and the numbers they have in a state of the loop.

use riffel::{Complex64, LoopState};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::PointValue;
use crate::Case;

/// A quantity at one wavelength and speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "`name` says what each of them is")]
pub enum PointQuantity {
    WavelengthM,
    SpeedMPerS,
    FrequencyHz,
    SemiAxisLongitudinalM,
    SemiAxisLateralM,
    CreepCoefficient,
    SaturationCreepage,
    Creepage,
    TractiveRatio,
    ContactStiffnessNPerM,
    AngularFrequencyRadPerS,
    RailReceptanceMPerN,
    WheelReceptanceMPerN,
    NormalForceN,
    DqDp,
    DqDomegaNSPerRad,
    DwDpMPerS,
    DwDomegaWSPerRad,
    TangentialForceN,
    LateralForceN,
    AngularVelocityRadPerS,
    DissipationW,
    DissipationPhaseRad,
    DissipationLagW,
    NormalizedDissipation,
    NormalizedByMean,
    MeanDissipationW,
    GrowthRatePerPassage,
}

/// What numbers a quantity has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Numbers {
    Real,
    Complex,
    /// Complex, but for contacts that answer at once and wheels without a receptance of their own.
    Either,
}

/// Key, unit, numbers and name of every quantity, in their order.
const WORDS: [(&str, &str, Numbers, &str); 28] = [
    ("wavelength_m", "m", Numbers::Real, "wavelength of the corrugation"),
    ("speed_m_per_s", "m/s", Numbers::Real, "speed of the vehicle"),
    ("frequency_hz", "Hz", Numbers::Real, "frequency"),
    ("semi_axis_longitudinal_m", "m", Numbers::Real, "semi-axis of the contact ellipse along the rail"),
    ("semi_axis_lateral_m", "m", Numbers::Real, "semi-axis of the contact ellipse across the rail"),
    ("creep_coefficient", "1", Numbers::Real, "creep coefficient"),
    ("saturation_creepage", "1", Numbers::Real, "creepage of full slip"),
    ("creepage", "1", Numbers::Real, "mean creepage"),
    ("tractive_ratio", "1", Numbers::Real, "mean tractive ratio Q0/(mu P0)"),
    ("contact_stiffness_n_per_m", "N/m", Numbers::Real, "stiffness of the contact"),
    ("angular_frequency_rad_per_s", "rad/s", Numbers::Real, "angular frequency"),
    ("rail_receptance_m_per_n", "m/N", Numbers::Complex, "receptance of the rail"),
    ("wheel_receptance_m_per_n", "m/N", Numbers::Either, "receptance of the wheel"),
    ("normal_force_n", "N", Numbers::Complex, "oscillating normal force P1"),
    ("dq_dp", "1", Numbers::Either, "tangential force per normal force"),
    ("dq_domega_n_s_per_rad", "N s/rad", Numbers::Either, "tangential force per angular velocity"),
    ("dw_dp_m_per_s", "m/s", Numbers::Either, "dissipated power per normal force"),
    ("dw_domega_w_s_per_rad", "W s/rad", Numbers::Either, "dissipated power per angular velocity"),
    ("tangential_force_n", "N", Numbers::Complex, "oscillating tangential force Q1"),
    ("lateral_force_n", "N", Numbers::Complex, "oscillating lateral force of a loop on all axes"),
    ("angular_velocity_rad_per_s", "rad/s", Numbers::Complex, "oscillating angular velocity of the wheel"),
    ("dissipation_w", "W", Numbers::Complex, "oscillating dissipated power at the wheel W1"),
    ("dissipation_phase_rad", "rad", Numbers::Real, "lag of the dissipation at a point of the rail"),
    ("dissipation_lag_w", "W", Numbers::Complex, "oscillating dissipated power at a point of the rail"),
    (
        "normalized_dissipation",
        "1",
        Numbers::Complex,
        "W1/(mu P0 V xi0) at a point of the rail, growth where its real part is negative",
    ),
    ("normalized_by_mean", "1", Numbers::Complex, "dissipated power at a point of the rail over its mean"),
    ("mean_dissipation_w", "W", Numbers::Real, "mean dissipated power W0"),
    ("growth_rate_per_passage", "1", Numbers::Real, "growth rate of the amplitude per passage of a wheel"),
];

impl PointQuantity {
    /// Every quantity, in the order of documents.
    pub const ALL: [Self; 28] = [
        Self::WavelengthM,
        Self::SpeedMPerS,
        Self::FrequencyHz,
        Self::SemiAxisLongitudinalM,
        Self::SemiAxisLateralM,
        Self::CreepCoefficient,
        Self::SaturationCreepage,
        Self::Creepage,
        Self::TractiveRatio,
        Self::ContactStiffnessNPerM,
        Self::AngularFrequencyRadPerS,
        Self::RailReceptanceMPerN,
        Self::WheelReceptanceMPerN,
        Self::NormalForceN,
        Self::DqDp,
        Self::DqDomegaNSPerRad,
        Self::DwDpMPerS,
        Self::DwDomegaWSPerRad,
        Self::TangentialForceN,
        Self::LateralForceN,
        Self::AngularVelocityRadPerS,
        Self::DissipationW,
        Self::DissipationPhaseRad,
        Self::DissipationLagW,
        Self::NormalizedDissipation,
        Self::NormalizedByMean,
        Self::MeanDissipationW,
        Self::GrowthRatePerPassage,
    ];

    fn words(self) -> (&'static str, &'static str, Numbers, &'static str) {
        WORDS[self as usize]
    }

    /// Key in documents, with the unit in it.
    pub fn key(self) -> &'static str {
        self.words().0
    }

    /// SI unit, "1" for a ratio.
    pub fn unit(self) -> &'static str {
        self.words().1
    }

    /// What it is.
    pub fn name(self) -> &'static str {
        self.words().3
    }

    /// Whether it has an imaginary part on some case.
    pub fn is_complex(self) -> bool {
        self.words().2 != Numbers::Real
    }

    /// Its number in a state of the loop of a case; none for the constants of a creep law on the cases of others, and
    /// for what one kind of loop alone has.
    pub fn number(self, case: &Case, state: &LoopState) -> Option<Complex64> {
        let real = |value: f64| Complex64::new(value, 0.0);
        if self.is_left_out(case.feedback.is_along_one_axis()) {
            return None;
        }
        // ξ₁ = −Ω₁R/V from (4) turns creepage and derivatives by it into those of angular velocity.
        let creepage_per_omega = -case.hertz.rolling_radius() / state.speed;
        let (by_load, by_creepage) = (state.response.by_load, state.response.by_longitudinal);
        Some(match self {
            Self::WavelengthM => real(state.wavelength),
            Self::SpeedMPerS => real(state.speed),
            Self::FrequencyHz => real(state.speed / state.wavelength),
            Self::SemiAxisLongitudinalM => real(case.hertz.semi_axis_longitudinal()),
            Self::SemiAxisLateralM => real(case.hertz.semi_axis_lateral()),
            Self::CreepCoefficient => real(case.law.as_ref()?.own_slope()?.creep_coefficient),
            Self::SaturationCreepage => real(case.law.as_ref()?.own_slope()?.saturation_creepage),
            Self::Creepage => real(case.steady.creepages.longitudinal),
            Self::TractiveRatio => real(case.steady.tractive_ratio()),
            Self::ContactStiffnessNPerM => real(case.feedback.contacts()[0].stiffness),
            Self::AngularFrequencyRadPerS => real(state.angular_frequency),
            Self::RailReceptanceMPerN => state.normal_receptance(),
            Self::WheelReceptanceMPerN => state.wheel_receptance[2][2],
            Self::NormalForceN => state.normal_force(),
            Self::DqDp => by_load.force[0],
            Self::DqDomegaNSPerRad => by_creepage.force[0] * creepage_per_omega, // (10)
            Self::DwDpMPerS => by_load.energy * state.speed,                     // (11)
            Self::DwDomegaWSPerRad => by_creepage.energy * creepage_per_omega * state.speed, // (12)
            Self::TangentialForceN => state.tangential_force(),
            Self::LateralForceN => state.contacts[0].force[1],
            Self::AngularVelocityRadPerS => state.slip() / creepage_per_omega,
            Self::DissipationW => state.dissipation,
            Self::DissipationPhaseRad => real(state.dissipation_lag_angle),
            Self::DissipationLagW => state.dissipation_at_rail,
            Self::NormalizedDissipation => state.normalized_dissipation,
            Self::NormalizedByMean => state.dissipation_at_rail / state.mean_dissipation,
            Self::MeanDissipationW => real(state.mean_dissipation),
            Self::GrowthRatePerPassage => real(state.growth_rate),
        })
    }

    /// Whether a loop along one axis, or else one on all axes, does not have it.
    fn is_left_out(self, along_one_axis: bool) -> bool {
        match self {
            Self::LateralForceN => along_one_axis,
            Self::Creepage
            | Self::WheelReceptanceMPerN
            | Self::DqDp
            | Self::DqDomegaNSPerRad
            | Self::DwDomegaWSPerRad
            | Self::AngularVelocityRadPerS => !along_one_axis,
            _ => false,
        }
    }

    pub(super) fn value(self, case: &Case, state: &LoopState) -> Option<PointValue> {
        let number = self.number(case, state)?;
        Some(match self.words().2 {
            Numbers::Complex => PointValue::Complex(number),
            Numbers::Either if number.im != 0.0 => PointValue::Complex(number),
            _ => PointValue::Real(number.re),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plans_and_documents_name_quantities_alike() {
        for quantity in PointQuantity::ALL {
            let written = serde_json::to_value(quantity).unwrap();
            assert_eq!(written, quantity.key());
        }
    }
}
