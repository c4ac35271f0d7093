//! `POST /api/passage`: a wheel over a sinusoid in time, and what the linear loop says of the same wave.

use crate::AnswerError;
use crate::simulate::{ContactHistory, SinusoidAnswer, SinusoidRequest};
use riffel::passage::Sinusoid;
use riffel_keys::{CaseError, Message, say};
use serde::{Deserialize, Serialize};

use crate::page::{CaseText, Fault, Reply};

/// Amplitudes of the wave \[m\].
const AMPLITUDES: [f64; 2] = [1e-8, 2e-3];

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
    wavelength_m: f64,
    speed_m_per_s: f64,
    amplitude_m: f64,
}

#[derive(Serialize)]
struct Answer {
    /// One wave under the wheel, from crest to crest.
    course: ContactHistory,
    contact_loss_fraction: f64,
    static_normal_force_n: f64,
    linear: Linear,
    remarks: Vec<Message>,
}

/// Wave of the linear loop at the same places.
#[derive(Serialize)]
struct Linear {
    normal_force_n: Vec<f64>,
    dissipation_j_per_m: Vec<f64>,
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("passage".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let [least, most] = AMPLITUDES;
        let (wavelength, speed, amplitude) = (self.wavelength_m, self.speed_m_per_s, self.amplitude_m);
        if !(least..=most).contains(&amplitude) {
            return Err(Fault::bad(say!(
                the_amplitude_is_m_but_must,
                number = 1e6 * amplitude,
                low = 1e6 * least,
                high = 1e6 * most
            )));
        }
        let case = self.case.read()?;
        let state = case.point(wavelength, speed)?;
        let profile = Sinusoid { wavelength, amplitude };
        let request = SinusoidRequest::new(speed, profile, None).map_err(refused)?;
        let mut answer = SinusoidAnswer::new(&case, request).map_err(refused)?;
        let course = answer.run.courses.remove(0);
        // Oscillations are those of the amplitude of the case, with the profile real at x = 0.
        let share = amplitude / case.feedback.amplitude();
        let linear = |mean: f64, oscillation: riffel::Complex64| {
            let at = |x: &f64| {
                let turn = riffel::Complex64::cis(std::f64::consts::TAU * x / wavelength);
                mean + share * (oscillation * turn).re
            };
            course.position_m.iter().map(at).collect()
        };
        let static_normal_force = case.steady.normal_force;
        Reply::json(&Answer {
            linear: Linear {
                normal_force_n: linear(static_normal_force, state.normal_force()),
                dissipation_j_per_m: linear(state.mean_dissipation / speed, state.dissipation / speed),
            },
            contact_loss_fraction: answer.extremes.contact_loss_fraction,
            static_normal_force_n: static_normal_force,
            remarks: answer.run.own_remarks,
            course,
        })
    }
}

/// Error without the option of the program, of which the page has none.
fn refused(error: AnswerError) -> Fault {
    match error {
        AnswerError::Case(CaseError::Physics { error, .. }) => Fault::bad(Message::from(&error)),
        AnswerError::Argument { value, rule, .. } => Fault::bad(say!(wave_is_but_must_be, value = value, rule = rule)),
        error => error.into(),
    }
}
