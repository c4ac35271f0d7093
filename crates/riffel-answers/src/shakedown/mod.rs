//! Limits of shakedown over the utilised friction, and where a contact stands between them along a wave.

mod figure;
mod tables;

use rayon::prelude::*;
use riffel::{HertzContact, LoopState};
use riffel_case::file::LimitName;
use riffel_case::{Case, ask};
use riffel_keys::quantity::{Length, Quantity, Ratio, Speed};
use riffel_keys::{Message, fixed, say, significant};
use riffel_plot::LineFigure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::question::{AsWritten, CaseSource, Client, Question, Rule};
use crate::{Answer, AnswerError, Result, Table};

/// Limits of shakedown over the friction that is used, and where a contact stands between them along a wave.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ShakedownQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Values of the utilised friction |Q|/P at which limits are told, separated by commas [default: 31, from 0 to 0.6].
    #[schemars(extend("value_name" = "LIST", "separator" = ","))]
    utilised_friction: Vec<Quantity<Ratio>>,
    /// Wavelength of a wave along which the contact is followed.
    wavelength: Option<AsWritten<Length>>,
    /// Speed over it.
    speed: Option<AsWritten<Speed>>,
    /// Amplitude of the wave [default: that of the case].
    amplitude: Option<AsWritten<Length>>,
}

impl Question for ShakedownQuestion {
    const NAME: &'static str = "shakedown";
    const EXAMPLE: &'static str =
        "Example: riffel shakedown case.toml --wavelength \"300 mm\" --speed \"50 km/h\" --amplitude \"50 um\"";
    const RULES: &'static [Rule] =
        &[Rule::Needs(&["wavelength"], &["speed"]), Rule::Needs(&["speed", "amplitude"], &["wavelength"])];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read(client)?;
        let mut covering = None;
        let wave = match (&self.wavelength, &self.speed) {
            (Some(wavelength), Some(speed)) => {
                let wavelength = wavelength.within("--wavelength", client)?;
                let speed = speed.within("--speed", client)?;
                case.check_points([wavelength; 2], [speed; 2])?;
                covering = Some(crate::question::covering(&case, wavelength, wavelength)?);
                Some([wavelength, speed])
            }
            _ => None,
        };
        let amplitude = self.amplitude.as_ref().map(|amplitude| amplitude.within("--amplitude", client)).transpose()?;
        let utilised_friction = self.utilised_friction.iter().map(Quantity::si).collect();
        let limits = ShakedownLimits { utilised_friction, wave, amplitude };
        Ok(Box::new(limits.answer(covering.as_ref().unwrap_or(&case))?))
    }
}

/// What is computed of a contact, in SI.
#[derive(Debug, Clone, Default)]
pub struct ShakedownLimits {
    /// Values of f = |Q|/P; none: equally spaced to 0.6.
    pub utilised_friction: Vec<f64>,
    /// Wavelength \[m\] and speed \[m/s\] of a wave along which the operating point goes.
    pub wave: Option<[f64; 2]>,
    /// Its amplitude \[m\]; none: that of the case.
    pub amplitude: Option<f64>,
}

/// Limits and the operating point.
#[derive(Debug, Serialize)]
pub struct ShakedownAnswer {
    #[serde(skip)]
    title: Option<String>,
    /// Shear yield k of the rail.
    pub shear_yield_pa: f64,
    /// a/b of the contact.
    pub a_over_b: f64,
    /// The mean state.
    pub mean: MeanPoint,
    /// The limits, in the order of f.
    pub map: Vec<LimitRow>,
    /// Amplitude of the wave.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub amplitude_m: Option<f64>,
    /// The operating point over one wave, every 10°.
    #[serde(rename = "loop", skip_serializing_if = "Option::is_none")]
    pub along_wave: Option<Vec<OperatingPoint>>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

/// The mean state of the contact.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct MeanPoint {
    /// p₀/k.
    pub p0_over_k: f64,
    /// f.
    pub utilised_friction: f64,
    /// f − k/p₀.
    pub fi_surf: f64,
    /// By the limit of the case.
    pub demand: f64,
}

/// Limits of p₀/k at one utilised friction.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct LimitRow {
    /// f.
    pub utilised_friction: f64,
    /// First yield by von Mises under the ellipse in full slip.
    pub elastic: f64,
    /// Shakedown of line contact.
    pub line: f64,
    /// 1/f; none without friction.
    pub surface: Option<f64>,
    /// Below the surface of the ellipse without friction.
    pub subsurface: f64,
}

/// Where a contact stands at one phase of a wave.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct OperatingPoint {
    /// Phase of the profile: 0 on the crest.
    pub phase_deg: f64,
    /// Amplitude times its cosine, upward.
    pub profile_m: f64,
    /// P; zero where wheel and rail part.
    pub normal_force_n: f64,
    /// Q along the rail, or |Q| with its sign where it has a part across.
    pub tangential_force_n: f64,
    /// p₀/k.
    pub p0_over_k: f64,
    /// |Q|/P.
    pub utilised_friction: f64,
    /// f − k/p₀.
    pub fi_surf: f64,
    /// By the limit of the case.
    pub demand: f64,
}

impl ShakedownLimits {
    /// Utilised friction beyond which nothing has been compared.
    const LARGEST: f64 = 0.6;

    /// The answer on a case.
    ///
    /// # Errors
    /// [`AnswerError`] for a friction below zero or above one, and for a point that the case does not know.
    pub fn answer(&self, case: &Case) -> Result<ShakedownAnswer> {
        for &friction in &self.utilised_friction {
            if !(0.0..=1.0).contains(&friction) {
                return Err(AnswerError::argument("--utilised-friction", friction, "between 0 and 1"));
            }
        }
        let shear_yield = ask::shear_yield(case);
        let frictions = match self.utilised_friction.is_empty() {
            true => (0..=30).map(|step| 0.02 * f64::from(step)).collect(),
            false => self.utilised_friction.clone(),
        };
        let mut remarks = case.remarks.clone();
        if !ask::has_shear_yield(case) {
            remarks.push(say!(shear_yield_assumed, shear = fixed(1e-6 * shear_yield, 0)));
        }
        let mean = standing(case, 0.0, 0.0, mean_forces(case), case.hertz);
        let along_wave = self.wave.map(|[wavelength, speed]| {
            let state = case.point(wavelength, speed)?;
            let amplitude = self.amplitude.unwrap_or(case.feedback.amplitude());
            let points = along(case, &state, amplitude).ok_or_else(|| {
                AnswerError::argument(
                    "--amplitude",
                    format!("{} mm", 1e3 * amplitude),
                    say!(below_r_at_the_wavelength_of, wavelength).to_string(),
                )
            })?;
            Ok::<_, AnswerError>((amplitude, points))
        });
        let along_wave = along_wave.transpose()?;
        let (amplitude_m, along_wave) = along_wave.unzip();
        let points = || along_wave.iter().flatten();
        if points().any(|point: &OperatingPoint| point.normal_force_n == 0.0) {
            remarks.push(say!(parts_along_the_wave));
        }
        let most = points().map(|point| point.utilised_friction).fold(0.0, f64::max);
        if most > case.steady.friction {
            remarks.push(say!(
                more_friction_than_there_is,
                used = fixed(most, 2),
                friction = significant(case.steady.friction, 2)
            ));
        }
        let used = points().chain([&mean]).map(|point| point.utilised_friction);
        let is_beyond = |friction: f64| friction > Self::LARGEST;
        if used.chain(frictions.iter().copied()).any(is_beyond) {
            remarks.push(say!(shakedown_beyond_friction));
        }
        Ok(ShakedownAnswer {
            title: case.file.title.clone(),
            shear_yield_pa: shear_yield,
            a_over_b: case.hertz.semi_axis_longitudinal() / case.hertz.semi_axis_lateral(),
            mean: MeanPoint {
                p0_over_k: mean.p0_over_k,
                utilised_friction: mean.utilised_friction,
                fi_surf: mean.fi_surf,
                demand: mean.demand,
            },
            map: limits(case, &frictions),
            amplitude_m,
            along_wave,
            remarks,
        })
    }
}

fn limits(case: &Case, frictions: &[f64]) -> Vec<LimitRow> {
    let row = |&friction: &f64| {
        let limit = |name: LimitName| ask::shakedown_limit(case, name).at(friction)[0];
        LimitRow {
            utilised_friction: friction,
            elastic: limit(LimitName::Elastic),
            line: limit(LimitName::Line),
            surface: (friction > 0.0).then(|| limit(LimitName::Surface)),
            subsurface: limit(LimitName::Subsurface),
        }
    };
    frictions.par_iter().map(row).collect()
}

/// Along the rail, across it and normal, of the mean state.
fn mean_forces(case: &Case) -> [f64; 3] {
    let forces = case.steady.forces;
    [forces.longitudinal, forces.lateral, case.hertz.normal_force()]
}

/// Where the contact stands over one wave; `None` if the wheel bridges its troughs.
fn along(case: &Case, state: &LoopState, amplitude: f64) -> Option<Vec<OperatingPoint>> {
    /// Degrees from one point to the next.
    const STEP: u32 = 10;
    let share = amplitude / case.feedback.amplitude();
    let oscillation = state.contacts[0].force.map(|force| force * share);
    let mean = mean_forces(case);
    let wave = case.feedback.contacts()[0].wave.as_ref();
    let curvature = wave.map_or(0.0, |wave| amplitude * wave.patch_curvature(std::f64::consts::TAU / state.wavelength));
    (0..360 / STEP)
        .map(|index| {
            let degrees = f64::from(index * STEP);
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let forces =
                std::array::from_fn(|axis| mean[axis] + oscillation[axis].re * cosine - oscillation[axis].im * sine);
            let hertz = match wave {
                Some(_) => case.hertz.curved(curvature * cosine).ok()?,
                None => case.hertz,
            };
            Some(standing(case, degrees, amplitude * cosine, forces, hertz))
        })
        .collect()
}

/// Where it stands under forces, with the patch of an ellipse.
fn standing(
    case: &Case,
    degrees: f64,
    profile: f64,
    [along, across, load]: [f64; 3],
    hertz: HertzContact,
) -> OperatingPoint {
    let load = load.max(0.0);
    let force = match (load > 0.0, case.feedback.is_along_one_axis()) {
        (false, _) => 0.0,
        (true, true) => along,
        (true, false) => along.hypot(across).copysign(along),
    };
    let pressure = hertz.peak_pressure() * (load / hertz.normal_force()).cbrt();
    let ratio = pressure / ask::shear_yield(case);
    let friction = match load > 0.0 {
        true => force.abs() / load,
        false => 0.0,
    };
    let name = ask::limit_name(case);
    let demand = match (ratio > 0.0, name, friction) {
        (false, ..) | (_, LimitName::Surface, 0.0) => 0.0,
        _ => ratio / ask::shakedown_limit_of(case, name, hertz).at(friction)[0],
    };
    OperatingPoint {
        phase_deg: degrees,
        profile_m: profile,
        normal_force_n: load,
        tangential_force_n: force,
        p0_over_k: ratio,
        utilised_friction: friction,
        fi_surf: friction - ratio.recip(),
        demand,
    }
}

impl ShakedownAnswer {
    /// Where the mean state stands.
    pub fn of_mean(&self) -> Message {
        tables::of_mean(self)
    }
}

impl Answer for ShakedownAnswer {
    fn name(&self) -> &'static str {
        "shakedown"
    }

    fn introduction(&self) -> Vec<Message> {
        tables::introduction(self)
    }

    fn tables(&self) -> Vec<Table> {
        tables::tables(self)
    }

    fn sentences(&self) -> Vec<Message> {
        tables::sentences(self)
    }

    fn figure(&self) -> LineFigure {
        figure::figure(self)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
