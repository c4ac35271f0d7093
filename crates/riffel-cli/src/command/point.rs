//! `riffel point`

use riffel::{Complex64, LoopState};
use riffel_case::Case;
use serde::Serialize;

use crate::arguments::{Point, covering, positive};
use crate::output::{print, print_json, print_remarks, table};

/// One turn of the loop, units in the names.
#[derive(Serialize)]
struct Document {
    wavelength_m: f64,
    speed_m_per_s: f64,
    frequency_hz: f64,
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    /// Of the paper's creep law only.
    #[serde(skip_serializing_if = "Option::is_none")]
    creep_coefficient: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    saturation_creepage: Option<f64>,
    creepage: f64,
    contact_stiffness_n_per_m: f64,
    angular_frequency_rad_per_s: f64,
    rail_receptance_m_per_n: [f64; 2],
    /// Real for a rigid mass.
    wheel_receptance_m_per_n: f64,
    normal_force_n: [f64; 2],
    dq_dp: RealOrPair,
    dq_domega_n_s_per_rad: RealOrPair,
    dw_dp_m_per_s: RealOrPair,
    dw_domega_w_s_per_rad: RealOrPair,
    tangential_force_n: [f64; 2],
    angular_velocity_rad_per_s: [f64; 2],
    dissipation_w: [f64; 2],
    dissipation_phase_rad: f64,
    dissipation_lag_w: [f64; 2],
    normalized_dissipation: [f64; 2],
    normalized_by_mean: [f64; 2],
    mean_dissipation_w: f64,
    growth_rate_per_passage: f64,
}

/// A derivative of the contact: a number if it answers at once, a pair if it answers late.
#[derive(Serialize)]
#[serde(untagged)]
enum RealOrPair {
    Real(f64),
    Pair([f64; 2]),
}

impl From<Complex64> for RealOrPair {
    fn from(value: Complex64) -> Self {
        if value.im == 0.0 {
            Self::Real(value.re)
        } else {
            Self::Pair(pair(value))
        }
    }
}

fn pair(value: Complex64) -> [f64; 2] {
    [value.re, value.im]
}

impl Document {
    fn new(case: &Case, state: &LoopState) -> Self {
        Self {
            wavelength_m: state.wavelength,
            speed_m_per_s: state.speed,
            frequency_hz: state.speed / state.wavelength,
            semi_axis_longitudinal_m: case.hertz.semi_axis_longitudinal(),
            semi_axis_lateral_m: case.hertz.semi_axis_lateral(),
            creep_coefficient: case.carter.map(|law| law.creep_coefficient()),
            saturation_creepage: case.carter.map(|law| law.saturation_creepage()),
            creepage: case.steady.creepage,
            contact_stiffness_n_per_m: case.feedback.contact_stiffness,
            angular_frequency_rad_per_s: state.angular_frequency,
            rail_receptance_m_per_n: pair(state.track_receptance),
            wheel_receptance_m_per_n: state.wheel_receptance.re,
            normal_force_n: pair(state.normal_force),
            dq_dp: state.dq_dp.into(),
            dq_domega_n_s_per_rad: state.dq_domega.into(),
            dw_dp_m_per_s: state.dw_dp.into(),
            dw_domega_w_s_per_rad: state.dw_domega.into(),
            tangential_force_n: pair(state.tangential_force),
            angular_velocity_rad_per_s: pair(state.angular_velocity),
            dissipation_w: pair(state.dissipation),
            dissipation_phase_rad: state.dissipation_lag_angle,
            dissipation_lag_w: pair(state.dissipation_at_rail),
            normalized_dissipation: pair(state.normalized_dissipation),
            normalized_by_mean: pair(state.dissipation_at_rail / state.mean_dissipation),
            mean_dissipation_w: state.mean_dissipation,
            growth_rate_per_passage: state.growth_rate,
        }
    }
}

pub(crate) fn run(arguments: &Point) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    let wavelength = positive("--wavelength", arguments.wavelength)?;
    let speed = positive("--speed", arguments.speed)?;
    case.check_frequencies(speed / wavelength, speed / wavelength)?;
    let case = covering(&case, wavelength)?;
    let state = case.feedback.at(wavelength, speed);
    let document = Document::new(&case, &state);
    if arguments.json {
        print_json(&document);
    } else {
        print(&readable(&case, &state, &document));
    }
    print_remarks(&case.remarks);
    Ok(())
}

/// Amplitudes and phases in engineers' units.
fn readable(case: &Case, state: &LoopState, document: &Document) -> String {
    let mut table = table(&["oscillation for exp(+iωt)", "amplitude", "unit", "phase"]);
    let rows = [
        (
            "receptance of the rail",
            state.track_receptance * 1e9,
            "nm/N",
        ),
        (
            "receptance of the wheel",
            state.wheel_receptance * 1e9,
            "nm/N",
        ),
        ("normal force P₁", state.normal_force * 1e-3, "kN"),
        ("tangential force Q₁", state.tangential_force, "N"),
        (
            "angular velocity Ω₁",
            state.angular_velocity * 1e3,
            "mrad/s",
        ),
        ("dissipation at the wheel W₁", state.dissipation, "W"),
        ("dissipation at the rail", state.dissipation_at_rail, "W"),
        ("normalised, Ŵ₁", state.normalized_dissipation, "-"),
    ];
    for (name, value, unit) in rows {
        table.add_row([
            name.to_owned(),
            format!("{:.4}", value.norm()),
            unit.to_owned(),
            format!("{:.1}°", value.arg().to_degrees()),
        ]);
    }
    let rate = state.growth_rate;
    let verdict = if rate > 0.0 {
        format!(
            "grows: doubles in {:.2e} passages",
            std::f64::consts::LN_2 / rate
        )
    } else {
        format!(
            "decays: halves in {:.2e} passages",
            std::f64::consts::LN_2 / -rate
        )
    };
    let full_slip = document
        .saturation_creepage
        .map(|creepage| format!(" (full slip from {:.4} %)", 100.0 * creepage))
        .unwrap_or_default();
    format!(
        "{}{:.1} mm at {:.1} km/h: {:.1} Hz\n\
         tractive ratio {:.3}, creepage {:.4} %{full_slip}, contact {:.2} × {:.2} mm\n\
         {table}\n\
         Re Ŵ₁ = {:.5}, growth rate {rate:.3e} per passage: {verdict}\n",
        case.file
            .title
            .as_ref()
            .map(|title| format!("{title}\n"))
            .unwrap_or_default(),
        1e3 * state.wavelength,
        3.6 * state.speed,
        document.frequency_hz,
        case.steady.tractive_ratio(),
        100.0 * document.creepage,
        2e3 * document.semi_axis_longitudinal_m,
        2e3 * document.semi_axis_lateral_m,
        state.normalized_dissipation.re,
    )
}
