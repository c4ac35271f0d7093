//! `POST /api/point`: the loop at one wavelength and speed, and the curves that run through it.

use crate::receptance::ReceptanceCurves;
use riffel::Complex64;
use riffel_case::traffic::{UsualTraffic, reported_growth};
use riffel_case::{Case, Point};
use riffel_keys::{Message, say};
use serde::{Deserialize, Serialize};

use crate::page::compare::Growth;
use crate::page::{CaseText, Fault, Reply};

/// Frequencies of the curves \[Hz\], those that `riffel receptance` draws.
const FREQUENCIES: [f64; 2] = [20.0, 5000.0];
/// How many, equally spaced in their logarithm.
const FREQUENCY_POINTS: u32 = 240;

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
    wavelength_m: f64,
    speed_m_per_s: f64,
    /// Axles a day on the line; none, and they are those of the usual traffic.
    #[serde(default)]
    passages_per_day: Option<f64>,
}

#[derive(Serialize)]
struct Answer {
    state: Turn,
    /// That growth is faster than any seen on a railway.
    reported_growth: Option<Message>,
    /// Over frequency at the speed of the point.
    spectrum: Spectrum,
    /// Over wavelength at the speed of the point.
    growth: Growth,
}

/// What `riffel point --json` prints, and what it is held against.
#[derive(Serialize)]
struct Turn {
    #[serde(flatten)]
    point: Point,
    /// Of the profile, real and upward on the rail.
    amplitude_m: f64,
    static_normal_force_n: f64,
}

#[derive(Serialize)]
struct Spectrum {
    frequency_hz: Vec<f64>,
    rail_receptance_m_per_n: Vec<[f64; 2]>,
    wheel_receptance_m_per_n: Vec<[f64; 2]>,
    /// Normal force P₁ over the static one.
    normal_force_ratio: Vec<[f64; 2]>,
}

fn pair(value: Complex64) -> [f64; 2] {
    [value.re, value.im]
}

impl Spectrum {
    fn new(case: &Case, speed: f64) -> Self {
        let [lowest, highest] = FREQUENCIES;
        let feedback = &case.feedback;
        let contact = feedback.contacts()[0].stiffness.recip();
        let mut spectrum = Self {
            rail_receptance_m_per_n: Vec::new(),
            wheel_receptance_m_per_n: Vec::new(),
            normal_force_ratio: Vec::new(),
            frequency_hz: ReceptanceCurves::frequencies(lowest, highest, FREQUENCY_POINTS),
        };
        for frequency in &spectrum.frequency_hz {
            let w = std::f64::consts::TAU * frequency;
            let [rail, wheel] = feedback.normal_receptances(w, speed);
            // Equation (24); the wavelength plays no part in it. On all axes it is the part of the normal alone.
            let force = feedback.amplitude() / (rail + wheel + contact);
            spectrum.rail_receptance_m_per_n.push(pair(rail));
            spectrum.wheel_receptance_m_per_n.push(pair(wheel));
            let ratio = force / case.steady.normal_force;
            spectrum.normal_force_ratio.push(pair(ratio));
        }
        spectrum
    }
}

/// The value, moved by rounding at most, if it lies within the window of the map.
fn within(key: &str, what: &str, value: f64, low: f64, high: f64) -> Result<f64, Fault> {
    const ROUNDING: f64 = 1e-6;
    if value >= low * (1.0 - ROUNDING) && value <= high * (1.0 + ROUNDING) {
        return Ok(value.clamp(low, high));
    }
    Err(Fault::of_key(
        key,
        say!(the_of_the_point_is_but, what = what, value = value, low = low, high = high),
        say!(choose_a_point_on_the_map),
    ))
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("point".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let case = self.case.read()?;
        let (shortest, longest) = (case.wavelength.min(), case.wavelength.max());
        let (slowest, fastest) = (case.speed.min(), case.speed.max());
        let wavelength = within("map.wavelength", "wavelength", self.wavelength_m, shortest, longest)?;
        let speed = within("map.speed", "speed", self.speed_m_per_s, slowest, fastest)?;
        let state = case.point(wavelength, speed)?;
        let spectrum = Spectrum::new(&case, speed);
        let usual = || UsualTraffic::of(&case).passages_per_day;
        let daily = self.passages_per_day.unwrap_or_else(usual);
        let reported = reported_growth(&case, wavelength, state.growth_rate, daily);
        Reply::json(&Answer {
            reported_growth: reported,
            state: Turn {
                point: Point::new(&case, &state),
                amplitude_m: case.feedback.amplitude(),
                static_normal_force_n: case.steady.normal_force,
            },
            spectrum,
            growth: Growth::new(&case, case.wavelength, speed)?,
        })
    }
}
