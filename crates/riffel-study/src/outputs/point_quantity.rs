//! Quantities of the loop at one wavelength and speed.

use riffel::{Complex64, LoopState};
use riffel_case::Case;

use crate::file::PointQuantity;

/// How a quantity is called.
pub(super) struct Words {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) complex: bool,
    pub(super) description: &'static str,
}

impl PointQuantity {
    pub(super) fn words(self) -> Words {
        let (name, unit, complex, description) = match self {
            Self::SemiAxisLongitudinalM => (
                "semi_axis_longitudinal_m",
                "m",
                false,
                "semi-axis of the contact along the rail",
            ),
            Self::SemiAxisLateralM => (
                "semi_axis_lateral_m",
                "m",
                false,
                "semi-axis of the contact across the rail",
            ),
            Self::Creepage => ("creepage", "1", false, "mean creepage"),
            Self::TractiveRatio => (
                "tractive_ratio",
                "1",
                false,
                "mean tractive ratio Q0/(mu P0)",
            ),
            Self::ContactStiffnessNPerM => (
                "contact_stiffness_n_per_m",
                "N/m",
                false,
                "linearised contact stiffness",
            ),
            Self::RailReceptanceMPerN => (
                "rail_receptance_m_per_n",
                "m/N",
                true,
                "receptance of the rail",
            ),
            Self::WheelReceptanceMPerN => (
                "wheel_receptance_m_per_n",
                "m/N",
                true,
                "receptance of the wheel",
            ),
            Self::NormalForceN => ("normal_force_n", "N", true, "normal force P1"),
            Self::DqDp => ("dq_dp", "1", true, "dQ/dP of the contact"),
            Self::DqDomegaNSPerRad => (
                "dq_domega_n_s_per_rad",
                "N s/rad",
                true,
                "dQ/dOmega of the contact",
            ),
            Self::DwDpMPerS => ("dw_dp_m_per_s", "m/s", true, "dW/dP of the contact"),
            Self::DwDomegaWSPerRad => (
                "dw_domega_w_s_per_rad",
                "W s/rad",
                true,
                "dW/dOmega of the contact",
            ),
            Self::TangentialForceN => ("tangential_force_n", "N", true, "tangential force Q1"),
            Self::AngularVelocityRadPerS => (
                "angular_velocity_rad_per_s",
                "rad/s",
                true,
                "angular velocity Omega1",
            ),
            Self::DissipationW => (
                "dissipation_w",
                "W",
                true,
                "dissipated power W1 at the wheel",
            ),
            Self::DissipationPhaseRad => (
                "dissipation_phase_rad",
                "rad",
                false,
                "lag of the dissipation at a point of the rail",
            ),
            Self::DissipationLagW => (
                "dissipation_lag_w",
                "W",
                true,
                "dissipated power at a point of the rail",
            ),
            Self::NormalizedDissipation => (
                "normalized_dissipation",
                "1",
                true,
                "W1/(mu P0 V xi0), growth where its real part is negative",
            ),
            Self::NormalizedByMean => (
                "normalized_by_mean",
                "1",
                true,
                "W1/W0 at a point of the rail",
            ),
            Self::MeanDissipationW => {
                ("mean_dissipation_w", "W", false, "mean dissipated power W0")
            }
            Self::GrowthRatePerPassage => (
                "growth_rate_per_passage",
                "1",
                false,
                "growth rate per passage",
            ),
        };
        Words {
            name,
            unit,
            complex,
            description,
        }
    }

    pub(super) fn value(self, case: &Case, state: &LoopState) -> Complex64 {
        let real = |value: f64| Complex64::new(value, 0.0);
        match self {
            Self::SemiAxisLongitudinalM => real(case.hertz.semi_axis_longitudinal()),
            Self::SemiAxisLateralM => real(case.hertz.semi_axis_lateral()),
            Self::Creepage => real(case.steady.creepage),
            Self::TractiveRatio => real(case.steady.tractive_ratio()),
            Self::ContactStiffnessNPerM => real(case.feedback.contact_stiffness),
            Self::RailReceptanceMPerN => state.track_receptance,
            Self::WheelReceptanceMPerN => state.wheel_receptance,
            Self::NormalForceN => state.normal_force,
            Self::DqDp => state.dq_dp,
            Self::DqDomegaNSPerRad => state.dq_domega,
            Self::DwDpMPerS => state.dw_dp,
            Self::DwDomegaWSPerRad => state.dw_domega,
            Self::TangentialForceN => state.tangential_force,
            Self::AngularVelocityRadPerS => state.angular_velocity,
            Self::DissipationW => state.dissipation,
            Self::DissipationPhaseRad => real(state.dissipation_lag_angle),
            Self::DissipationLagW => state.dissipation_at_rail,
            Self::NormalizedDissipation => state.normalized_dissipation,
            Self::NormalizedByMean => state.dissipation_at_rail / state.mean_dissipation,
            Self::MeanDissipationW => real(state.mean_dissipation),
            Self::GrowthRatePerPassage => real(state.growth_rate),
        }
    }
}
