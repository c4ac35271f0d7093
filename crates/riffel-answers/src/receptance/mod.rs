//! The joints of a case over frequency.

mod curves;
mod matrix;

use std::f64::consts::TAU;
use std::io::{self, Write};

use riffel::receptance::{DecayRate, MassOnRail, Resonance, ResonanceKind};
use riffel::{Complex64, Direction};
use riffel_case::{Case, Track};
use riffel_keys::CaseError;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};
use serde::Serialize;

pub use curves::{ReceptanceCurve, ReceptanceCurves};
pub use matrix::{MatrixAnswer, MatrixDocument};

use crate::parameters::parameters;

/// What is asked of the receptances of a case.
#[derive(Debug, Clone)]
pub struct ReceptanceRequest {
    /// Direction of force and displacement.
    pub direction: Direction,
    /// Speed of the load \[m/s\].
    pub speed: f64,
    /// \[Hz\].
    pub frequencies: Vec<f64>,
}

/// The joints of a case over frequency, with the resonances of its track.
pub struct ReceptanceAnswer {
    /// The track in the direction asked for.
    pub track: Track,
    /// The joints over frequency.
    pub curves: ReceptanceCurves,
    /// The resonances, lowest first.
    pub resonances: Vec<Resonance>,
    /// The closed form of P2, vertically: the unsprung mass on the static shape of the rail.
    pub p2_closed_form: Option<MassOnRail>,
    /// Named frequencies \[Hz\] of the rail across the track, where it moves so in the loop.
    pub lateral_resonances: Vec<(ResonanceKind, f64)>,
    speed: f64,
    direction: Direction,
}

fn pairs(values: &[Complex64]) -> Vec<[f64; 2]> {
    values.iter().map(|value| [value.re, value.im]).collect()
}

/// What `riffel receptance --json` prints.
#[derive(Serialize)]
pub struct ReceptanceDocument {
    frequency_hz: Vec<f64>,
    resonances: Vec<ResonanceDocument>,
    /// Beside P2, as a check; of a model of the track.
    #[serde(skip_serializing_if = "Option::is_none")]
    p2_closed_form: Option<ClosedFormDocument>,
    /// Across the track, where the rail moves so.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    lateral_resonances: Vec<LateralResonance>,
    #[serde(flatten)]
    joints: serde_json::Map<String, serde_json::Value>,
}

/// One that is known by its frequency alone, without damping.
#[derive(Serialize)]
struct LateralResonance {
    resonance: String,
    frequency_hz: f64,
}

/// P2 of the unsprung mass on the static shape of the rail.
#[derive(Serialize)]
struct ClosedFormDocument {
    frequency_hz: f64,
    unsprung_mass_kg: f64,
    track_mass_kg: f64,
    stiffness_n_per_m: f64,
}

impl From<MassOnRail> for ClosedFormDocument {
    fn from(closed: MassOnRail) -> Self {
        Self {
            frequency_hz: closed.angular_frequency() / TAU,
            unsprung_mass_kg: closed.mass,
            track_mass_kg: closed.track_mass,
            stiffness_n_per_m: closed.stiffness,
        }
    }
}

/// One resonance; damping and resolution where the receptance has no model.
#[derive(Serialize)]
struct ResonanceDocument {
    resonance: String,
    frequency_hz: f64,
    receptance_m_per_n: [f64; 2],
    damping_ratio: Option<f64>,
    resolution_hz: Option<f64>,
}

impl ResonanceDocument {
    fn new(resonance: &Resonance) -> Self {
        Self {
            resonance: resonance.kind.to_string(),
            frequency_hz: resonance.angular_frequency / TAU,
            receptance_m_per_n: [resonance.receptance.re, resonance.receptance.im],
            damping_ratio: resonance.damping_ratio,
            resolution_hz: resonance.resolution.map(|resolution| resolution / TAU),
        }
    }
}

impl ReceptanceAnswer {
    /// The receptances asked for.
    ///
    /// # Errors
    /// [`CaseError`] where the case lacks a value for the direction, its model has no such direction, or the track is
    /// not known at a frequency.
    pub fn new(case: &Case, request: ReceptanceRequest) -> Result<Self, CaseError> {
        let ReceptanceRequest { direction, speed, frequencies } = request;
        let track = case.track_in(direction)?;
        if let (Some(from), Some(to)) = (frequencies.first(), frequencies.last()) {
            case.check_frequencies(*from, *to)?;
        }
        let curves = ReceptanceCurves::new(case, &track, direction, speed, frequencies);
        let resonances = match direction {
            Direction::Vertical => case.resonances(),
            _ => track.resonances(),
        };
        Ok(Self {
            track,
            curves,
            resonances,
            p2_closed_form: (direction == Direction::Vertical).then(|| case.p2_closed_form()).flatten(),
            lateral_resonances: (case.lateral_resonances.iter()).map(|(kind, w)| (*kind, w / TAU)).collect(),
            speed,
            direction,
        })
    }

    /// Decay rates in one-third octaves; none for a rail without support, which hardly decays, and where supports are
    /// not known.
    pub fn decay(&self) -> Option<Vec<DecayRate>> {
        let structure = self.track.structure.as_deref();
        let structure = structure.filter(|_| self.track.support.is_some());
        structure.map(DecayRate::of_track)
    }

    /// The curves and resonances as data: what `riffel receptance --json` prints.
    pub fn document(&self) -> ReceptanceDocument {
        let joints = self.curves.joints.iter().map(|curve| {
            let values = serde_json::to_value(pairs(&curve.values)).unwrap_or_default();
            (curve.key.to_owned(), values)
        });
        ReceptanceDocument {
            frequency_hz: self.curves.frequencies.clone(),
            resonances: self.resonances.iter().map(ResonanceDocument::new).collect(),
            p2_closed_form: self.p2_closed_form.map(ClosedFormDocument::from),
            lateral_resonances: (self.lateral_resonances.iter())
                .map(|(kind, frequency_hz)| LateralResonance {
                    resonance: kind.to_string(),
                    frequency_hz: *frequency_hz,
                })
                .collect(),
            joints: joints.collect(),
        }
    }

    /// One row for each frequency.
    ///
    /// # Errors
    /// Those of the file.
    pub fn curves_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let all = &self.curves;
        let curves = || all.joints.iter().chain(&all.places);
        let mut header = vec!["frequency_hz".to_owned()];
        header.extend(curves().flat_map(|curve| ["re", "im"].map(|part| format!("{}_{part}", curve.key))));
        writer.write_record(&header)?;
        for (index, &frequency) in all.frequencies.iter().enumerate() {
            let mut row = vec![frequency];
            row.extend(curves().flat_map(|curve| {
                let value = curve.values[index];
                [value.re, value.im]
            }));
            writer.serialize(row)?;
        }
        writer.flush()
    }

    /// Discrete supports show the rail at both of its typical places instead of at one.
    fn drawn(&self) -> Vec<&ReceptanceCurve> {
        let ReceptanceCurves { joints, places, .. } = &self.curves;
        let rail = match places.is_empty() {
            true => &joints[..1],
            false => &places[..],
        };
        rail.iter().chain(&joints[1..]).collect()
    }

    /// Modulus and phase over frequency, resonances marked.
    pub fn figure(&self, case: &Case) -> LineFigure {
        // Names stand in the first panel only.
        let panel = |named: bool, y_label: &str, y_scale, value: fn(Complex64) -> f64| LinePanel {
            x_label: "frequency f [Hz]".to_owned(),
            y_label: y_label.to_owned(),
            x_scale: Scale::Log,
            y_scale,
            series: self
                .drawn()
                .into_iter()
                .map(|curve| Series {
                    label: if named { curve.label.to_owned() } else { String::new() },
                    x: self.curves.frequencies.clone(),
                    y: curve.values.iter().map(|&receptance| value(receptance)).collect(),
                    style: style(curve),
                    color: None,
                })
                .collect(),
            marks: self.resonances.iter().map(|resonance| mark(resonance, named)).collect(),
            ..LinePanel::default()
        };
        let (title, force) = match self.direction {
            Direction::Vertical => ("Receptances at the contact", "both downward"),
            Direction::Lateral => ("Lateral receptance of the rail", "both across the track"),
            Direction::Longitudinal => ("Receptance along the rail", "both along the rail"),
        };
        LineFigure {
            title: title.to_owned(),
            caption: format!(
                "Displacement per force, {force}, exp(+iωt), load at {:.1} m/s. {}",
                self.speed,
                parameters(case)
            ),
            panels: vec![
                panel(true, "|H| [m/N]", Scale::Log, |h| h.norm()),
                panel(false, "arg H [°]", Scale::Linear, |h| {
                    // −180 … 0°: a passive structure never leads; −0.0 turns a real negative H to −180°.
                    let degrees = h.arg().to_degrees();
                    if degrees > 90.0 { degrees - 360.0 } else { degrees }
                }),
            ],
            arrangement: Arrangement::Stacked,
        }
    }

    /// One row for each resonance.
    ///
    /// # Errors
    /// Those of the file.
    pub fn resonances_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "resonance",
            "frequency_hz",
            "receptance_modulus_m_per_n",
            "damping_ratio",
            "resolution_hz",
        ])?;
        for resonance in &self.resonances {
            writer.serialize((
                resonance.kind.to_string(),
                resonance.angular_frequency / TAU,
                resonance.receptance.norm(),
                resonance.damping_ratio,
                resonance.resolution.map(|resolution| resolution / TAU),
            ))?;
        }
        writer.flush()
    }
}

/// One row for each one-third octave.
///
/// # Errors
/// Those of the file.
pub fn decay_csv(rates: &[DecayRate], file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record(["frequency_hz", "decay_rate_db_per_m", "upper_bound"])?;
    for rate in rates {
        writer.serialize((rate.nominal_frequency, rate.decay_rate, rate.upper_bound))?;
    }
    writer.flush()
}

/// Decay rates over frequency.
pub fn decay_figure(case: &Case, rates: &[DecayRate]) -> LineFigure {
    LineFigure {
        title: "Track decay rate".to_owned(),
        caption: format!("One-third octaves of EN 15461, force in mid-span. {}", parameters(case)),
        panels: vec![LinePanel {
            x_label: "frequency f [Hz]".to_owned(),
            y_label: "decay rate [dB/m]".to_owned(),
            x_scale: Scale::Log,
            y_scale: Scale::Log,
            series: vec![Series {
                x: rates.iter().map(|rate| rate.nominal_frequency).collect(),
                y: rates.iter().map(|rate| rate.decay_rate).collect(),
                ..Series::default()
            }],
            ..LinePanel::default()
        }],
        arrangement: Arrangement::Stacked,
    }
}

/// The rail and the sum of all are solid.
fn style(curve: &ReceptanceCurve) -> LineStyle {
    match curve.key {
        "wheel_m_per_n" => LineStyle::Dashed,
        "contact_m_per_n" => LineStyle::Dotted,
        _ => LineStyle::Solid,
    }
}

fn mark(resonance: &Resonance, named: bool) -> Mark {
    let frequency = resonance.angular_frequency / TAU;
    let name = match resonance.kind {
        ResonanceKind::MeasuredPeak | ResonanceKind::GivenPeak => "peak".to_owned(),
        ResonanceKind::MeasuredDip | ResonanceKind::GivenDip => "dip".to_owned(),
        kind => kind.to_string(),
    };
    Mark {
        x: frequency,
        label: if named {
            // In a picture the index of P2 is one.
            format!("{} {frequency:.0} Hz", name.replace("P2", "P₂"))
        } else {
            String::new()
        },
    }
}
