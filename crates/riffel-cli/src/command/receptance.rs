//! `riffel receptance`

use std::f64::consts::TAU;
use std::io::{self, Write};

use riffel::receptance::{DecayRate, Resonance, ResonanceKind};
use riffel::{Complex64, Direction};
use riffel_case::{Case, Origin, ReceptanceCurve, ReceptanceCurves, Track};
use riffel_figures::parameters;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};
use serde::Serialize;

use crate::arguments::{DirectionArgument, Receptance};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{print, print_json, table};
use crate::staging::Staging;

pub(crate) fn run(arguments: &Receptance) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    let direction = match arguments.direction {
        DirectionArgument::Vertical => Direction::Vertical,
        DirectionArgument::Lateral => Direction::Lateral,
        DirectionArgument::Longitudinal => Direction::Longitudinal,
    };
    let track = case.track_in(direction)?;
    let speed = match &arguments.speed {
        Some(speed) => speed.within("--speed")?,
        None => case.speed.max(),
    };
    let (from, to) = range(arguments, &track)?;
    case.check_frequencies(from, to)?;
    let curves = Curves::new(
        &case,
        &track,
        direction,
        speed,
        ReceptanceCurves::frequencies(from, to, arguments.points),
    );
    let resonances = match direction {
        Direction::Vertical => case.resonances(),
        _ => track.resonances(),
    };
    if arguments.json {
        print_json(&curves.document(&resonances))?;
        print_remarks(&case.remarks);
        if arguments.output.is_none() {
            return Ok(());
        }
    }

    // A rail without support hardly decays.
    let decay = track
        .structure
        .as_deref()
        .filter(|_| track.support.is_some())
        .map(DecayRate::of_track);

    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "receptance");
    let mut staging = Staging::new("receptance", &folder)?;
    staging.write_figure("receptance", &curves.figure(&case, &resonances))?;
    staging.write_with("receptance.csv", |file| curves.table(file))?;
    staging.write_with("resonances.csv", |file| resonance_table(&resonances, file))?;
    if let Some(decay) = &decay {
        staging.write_with("decay-rate.csv", |file| decay_table(decay, file))?;
        let svg = decay_figure(&case, decay).svg().map_err(CliError::from)?;
        staging.write_picture("decay-rate", &svg)?;
    }
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(readable(&case, &track, &resonances, decay.as_deref()) + &place))?;
        print_remarks(&case.remarks);
    }
    Ok(())
}

/// The frequencies asked for \[Hz\]; where nothing is said, as many of the usual ones as a measurement
/// has.
fn range(arguments: &Receptance, track: &Track) -> Result<(f64, f64), CliError> {
    let (usual_from, usual_to) = ReceptanceCurves::default_range(&*track.receptance);
    let from = match &arguments.from {
        Some(from) => from.within("--from")?,
        None => usual_from,
    };
    let to = match &arguments.to {
        Some(to) => to.within("--to")?,
        None => usual_to,
    };
    if from < to {
        return Ok((from, to));
    }
    Err(CliError::Argument {
        argument: "--to",
        value: format!("{to} Hz"),
        rule: format!("above --from, {from} Hz"),
    })
}

/// What the command shows.
struct Curves {
    receptances: ReceptanceCurves,
    speed: f64,
    direction: Direction,
}

fn pairs(values: &[Complex64]) -> Vec<[f64; 2]> {
    values.iter().map(|value| [value.re, value.im]).collect()
}

/// `receptance --json`.
#[derive(Serialize)]
struct Document {
    frequency_hz: Vec<f64>,
    resonances: Vec<ResonanceDocument>,
    #[serde(flatten)]
    joints: serde_json::Map<String, serde_json::Value>,
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

impl Curves {
    fn new(
        case: &Case,
        track: &Track,
        direction: Direction,
        speed: f64,
        frequencies: Vec<f64>,
    ) -> Self {
        Self {
            receptances: ReceptanceCurves::new(case, track, direction, speed, frequencies),
            speed,
            direction,
        }
    }

    fn document(&self, resonances: &[Resonance]) -> Document {
        let joints = self.receptances.joints.iter().map(|curve| {
            let values = serde_json::to_value(pairs(&curve.values)).unwrap_or_default();
            (curve.key.to_owned(), values)
        });
        Document {
            frequency_hz: self.receptances.frequencies.clone(),
            resonances: resonances.iter().map(ResonanceDocument::new).collect(),
            joints: joints.collect(),
        }
    }

    fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let all = &self.receptances;
        let curves = || all.joints.iter().chain(&all.places);
        let mut header = vec!["frequency_hz".to_owned()];
        header.extend(
            curves().flat_map(|curve| ["re", "im"].map(|part| format!("{}_{part}", curve.key))),
        );
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
        let ReceptanceCurves { joints, places, .. } = &self.receptances;
        let rail = match places.is_empty() {
            true => &joints[..1],
            false => &places[..],
        };
        rail.iter().chain(&joints[1..]).collect()
    }

    fn figure(&self, case: &Case, resonances: &[Resonance]) -> LineFigure {
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
                    label: if named {
                        curve.label.to_owned()
                    } else {
                        String::new()
                    },
                    x: self.receptances.frequencies.clone(),
                    y: curve
                        .values
                        .iter()
                        .map(|&receptance| value(receptance))
                        .collect(),
                    style: style(curve),
                    color: None,
                })
                .collect(),
            marks: resonances
                .iter()
                .map(|resonance| mark(resonance, named))
                .collect(),
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
                    if degrees > 90.0 {
                        degrees - 360.0
                    } else {
                        degrees
                    }
                }),
            ],
            arrangement: Arrangement::Stacked,
        }
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

fn resonance_table(resonances: &[Resonance], file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record([
        "resonance",
        "frequency_hz",
        "receptance_modulus_m_per_n",
        "damping_ratio",
        "resolution_hz",
    ])?;
    for resonance in resonances {
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

fn decay_table(rates: &[DecayRate], file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record(["frequency_hz", "decay_rate_db_per_m", "upper_bound"])?;
    for rate in rates {
        writer.serialize((rate.nominal_frequency, rate.decay_rate, rate.upper_bound))?;
    }
    writer.flush()
}

fn decay_figure(case: &Case, rates: &[DecayRate]) -> LineFigure {
    LineFigure {
        title: "Track decay rate".to_owned(),
        caption: format!(
            "One-third octaves of EN 15461, force in mid-span. {}",
            parameters(case)
        ),
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

/// Resonances and decay rates for the terminal.
fn readable(
    case: &Case,
    track: &Track,
    resonances: &[Resonance],
    decay: Option<&[DecayRate]>,
) -> String {
    let mut text = format!("{}\n", case.file.title.as_deref().unwrap_or("Receptance"));
    let has_model = matches!(track.origin, Origin::Model);
    if resonances.is_empty() {
        text.push_str(match has_model {
            true => "no resonance to name: the rail has no support that is known\n",
            false => "no peak or dip of the measured receptance stands out of its neighbours and its noise\n",
        });
    } else {
        let mut header = vec!["resonance", "frequency Hz", "|H| nm/N", "of"];
        if !has_model {
            header.extend(["damping %", "lines Hz"]);
        }
        let mut rows = table(&header);
        for resonance in resonances {
            let of = match resonance.kind {
                ResonanceKind::P2 => "rail, wheel and contact: least",
                ResonanceKind::PinnedPinned if has_model => "rail in mid-span",
                _ if track.support_spacing().is_some() => "rail over support",
                _ => "rail",
            };
            let mut row = vec![
                resonance.kind.to_string(),
                format!("{:.1}", resonance.angular_frequency / TAU),
                format!("{:.3}", 1e9 * resonance.receptance.norm()),
                of.to_owned(),
            ];
            if !has_model {
                let damping = resonance.damping_ratio;
                let lines = resonance.resolution.map(|resolution| resolution / TAU);
                row.push(damping.map_or_else(String::new, |ratio| format!("{:.1}", 100.0 * ratio)));
                row.push(lines.map_or_else(String::new, |lines| format!("{lines:.1}")));
            }
            rows.add_row(row);
        }
        text.push_str(&format!("{rows}\n"));
    }
    if let Some(rates) = decay {
        let list: Vec<String> = rates
            .iter()
            .map(|rate| {
                let bound = if rate.upper_bound { "<" } else { "" };
                format!(
                    "{} Hz {bound}{:.2}",
                    rate.nominal_frequency, rate.decay_rate
                )
            })
            .collect();
        text.push_str(&format!("decay rate dB/m: {}\n", list.join(", ")));
    }
    text
}
