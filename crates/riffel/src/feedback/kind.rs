//! The loop of either kind, for all that asks how fast corrugation grows.

use num_complex::Complex64;

use super::{FeedbackLoop, GeneralLoop, GeneralState, LoopState};
use crate::contact::MeanRolling;
use crate::wheelset::Motion;

/// A closed loop of either kind.
#[derive(Clone)]
pub enum Loop {
    /// One wheel and longitudinal creepage, in closed form.
    Longitudinal(FeedbackLoop),
    /// Any number of contacts on all axes.
    General(GeneralLoop),
}

/// One turn of a loop of either kind.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub enum State {
    /// One wheel and longitudinal creepage.
    Longitudinal(LoopState),
    /// Any number of contacts on all axes.
    General(GeneralState),
}

impl Loop {
    /// The state of the loop at the wavelength \[m\] and speed \[m/s\], both positive.
    pub fn at(&self, wavelength: f64, speed: f64) -> State {
        match self {
            Self::Longitudinal(feedback) => State::Longitudinal(feedback.at(wavelength, speed)),
            Self::General(general) => State::General(general.at(wavelength, speed)),
        }
    }

    /// The loop of one wheel and longitudinal creepage, if it is that.
    pub fn longitudinal(&self) -> Option<&FeedbackLoop> {
        match self {
            Self::Longitudinal(feedback) => Some(feedback),
            Self::General(_) => None,
        }
    }

    /// The loop on all axes, if it is that.
    pub fn general(&self) -> Option<&GeneralLoop> {
        match self {
            Self::Longitudinal(_) => None,
            Self::General(general) => Some(general),
        }
    }

    /// The mean state of the contact under study.
    pub fn steady(&self) -> MeanRolling {
        match self {
            Self::Longitudinal(feedback) => feedback.contact.steady(),
            Self::General(general) => general.steady(),
        }
    }

    /// Amplitude Δ of the profile \[m\].
    pub fn amplitude(&self) -> f64 {
        match self {
            Self::Longitudinal(feedback) => feedback.amplitude,
            Self::General(general) => general.amplitude(),
        }
    }

    /// Linearised stiffness k_H of the contact under study \[N/m\].
    pub fn contact_stiffness(&self) -> f64 {
        match self {
            Self::Longitudinal(feedback) => feedback.contact_stiffness,
            Self::General(general) => general.contacts()[0].stiffness,
        }
    }

    /// Receptances of track and wheel at the contact under study \[m/N\], along its normal.
    pub fn normal_receptances(&self, angular_frequency: f64, speed: f64) -> [Complex64; 2] {
        match self {
            Self::Longitudinal(feedback) => [&feedback.track, &feedback.wheel]
                .map(|structure| structure.receptance(angular_frequency, speed)),
            Self::General(general) => general.normal_receptances(angular_frequency, speed),
        }
    }

    /// Receptance matrices of track and wheel at the contact under study \[m/N\], in the axes x, y, z of the track; none
    /// where a wheel follows every oscillation of the tangential force, which no receptance tells.
    pub fn receptances(
        &self,
        angular_frequency: f64,
        speed: f64,
    ) -> Option<[[[Complex64; 3]; 3]; 2]> {
        let feedback = match self {
            Self::Longitudinal(feedback) => feedback,
            Self::General(general) => {
                let motion = &general.contacts()[0].motion;
                let free = motion.iter().any(|motion| matches!(motion, Motion::Free));
                return (!free).then(|| general.receptances(angular_frequency, speed));
            }
        };
        let [track, wheel] = self.normal_receptances(angular_frequency, speed);
        let along = match &feedback.rotation {
            Motion::Compliant(structure) => structure.receptance(angular_frequency, speed),
            Motion::Held => Complex64::ZERO,
            Motion::Free => return None,
        };
        let diagonal = |along, vertical| {
            let mut matrix = [[Complex64::ZERO; 3]; 3];
            (matrix[0][0], matrix[2][2]) = (along, vertical);
            matrix
        };
        Some([diagonal(Complex64::ZERO, track), diagonal(along, wheel)])
    }

    /// Growth rate per passage for a value of Ŵ₁: g = this factor · Re Ŵ₁, negative factor.
    pub fn growth_rate_per_dissipation(&self) -> f64 {
        match self {
            Self::Longitudinal(feedback) => feedback.growth_rate_per_dissipation(),
            Self::General(general) => general.growth_rate_per_dissipation(),
        }
    }

    /// Ŵ₁ as a function of wavelength and speed, for a search that turns the loop many times.
    pub(crate) fn normalized_dissipation(&self) -> impl Fn(f64, f64) -> Complex64 + Sync + '_ {
        let steady = self.steady();
        move |wavelength, speed| match self {
            Self::Longitudinal(feedback) => {
                feedback.normalized_dissipation(&steady, wavelength, speed)
            }
            Self::General(general) => general.normalized_dissipation(wavelength, speed),
        }
    }
}

impl From<FeedbackLoop> for Loop {
    fn from(feedback: FeedbackLoop) -> Self {
        Self::Longitudinal(feedback)
    }
}

impl From<&FeedbackLoop> for Loop {
    fn from(feedback: &FeedbackLoop) -> Self {
        Self::Longitudinal(feedback.clone())
    }
}

impl From<GeneralLoop> for Loop {
    fn from(general: GeneralLoop) -> Self {
        Self::General(general)
    }
}

impl From<&GeneralLoop> for Loop {
    fn from(general: &GeneralLoop) -> Self {
        Self::General(general.clone())
    }
}

impl From<&Loop> for Loop {
    fn from(feedback: &Loop) -> Self {
        feedback.clone()
    }
}

impl State {
    /// The state of a loop of one wheel and longitudinal creepage, if it is that.
    pub fn longitudinal(&self) -> Option<&LoopState> {
        match self {
            Self::Longitudinal(state) => Some(state),
            Self::General(_) => None,
        }
    }

    /// The state of a loop on all axes, if it is that.
    pub fn general(&self) -> Option<&GeneralState> {
        match self {
            Self::Longitudinal(_) => None,
            Self::General(state) => Some(state),
        }
    }

    /// Wavelength λ \[m\].
    pub fn wavelength(&self) -> f64 {
        match self {
            Self::Longitudinal(state) => state.wavelength,
            Self::General(state) => state.wavelength,
        }
    }

    /// Speed V \[m/s\].
    pub fn speed(&self) -> f64 {
        match self {
            Self::Longitudinal(state) => state.speed,
            Self::General(state) => state.speed,
        }
    }

    /// Angular frequency ω = 2πV/λ \[rad/s\].
    pub fn angular_frequency(&self) -> f64 {
        match self {
            Self::Longitudinal(state) => state.angular_frequency,
            Self::General(state) => state.angular_frequency,
        }
    }

    /// Receptance of the track along the normal of the contact under study \[m/N\].
    pub fn track_receptance(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.track_receptance,
            Self::General(state) => state.track_receptance[2][2],
        }
    }

    /// Normal force P₁ of the contact under study \[N\].
    pub fn normal_force(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.normal_force,
            Self::General(state) => state.contacts[0].force[2],
        }
    }

    /// Longitudinal creep force Q₁ of the contact under study \[N\].
    pub fn tangential_force(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.tangential_force,
            Self::General(state) => state.contacts[0].force[0],
        }
    }

    /// W_P of the contact under study \[m/s\].
    pub fn dw_dp(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.dw_dp,
            Self::General(state) => state.dw_dp,
        }
    }

    /// Dissipated power W₁ at the wheel under study \[W\].
    pub fn dissipation(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.dissipation,
            Self::General(state) => state.dissipation,
        }
    }

    /// Angle by which the dissipation at a rail point lags W₁ \[rad\].
    pub fn dissipation_lag_angle(&self) -> f64 {
        match self {
            Self::Longitudinal(state) => state.dissipation_lag_angle,
            Self::General(state) => state.dissipation_lag_angle,
        }
    }

    /// Dissipated power at a rail point \[W\].
    pub fn dissipation_at_rail(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.dissipation_at_rail,
            Self::General(state) => state.dissipation_at_rail,
        }
    }

    /// Ŵ₁ at a rail point \[-\].
    pub fn normalized_dissipation(&self) -> Complex64 {
        match self {
            Self::Longitudinal(state) => state.normalized_dissipation,
            Self::General(state) => state.normalized_dissipation,
        }
    }

    /// Mean dissipated power W₀ \[W\].
    pub fn mean_dissipation(&self) -> f64 {
        match self {
            Self::Longitudinal(state) => state.mean_dissipation,
            Self::General(state) => state.mean_dissipation,
        }
    }

    /// Growth rate of |Δ| per passage of a wheel \[-\], positive where corrugation grows; in the mean over the wheels
    /// on the rail under study.
    pub fn growth_rate(&self) -> f64 {
        match self {
            Self::Longitudinal(state) => state.growth_rate,
            Self::General(state) => state.growth_rate,
        }
    }
}
