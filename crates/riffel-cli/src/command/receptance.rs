//! `riffel receptance`

use std::cell::LazyCell;
use std::f64::consts::TAU;

use riffel::Direction;
use riffel::receptance::{DecayRate, ResonanceKind};
use riffel_answers::receptance::{
    MatrixAnswer, ReceptanceAnswer, ReceptanceCurves, ReceptanceRequest, decay_csv, decay_figure,
};
use riffel_case::{Case, Origin, Track};
use riffel_keys::quantity::Frequency;

use crate::arguments::{Asked, DirectionArgument, Receptance};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, table};
use crate::results::Results;

pub(crate) fn run(arguments: &Receptance) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    if arguments.matrix {
        return matrix(arguments, &case);
    }
    let direction = match arguments.direction {
        DirectionArgument::Vertical => Direction::Vertical,
        DirectionArgument::Lateral => Direction::Lateral,
        DirectionArgument::Longitudinal => Direction::Longitudinal,
    };
    let track = case.track_in(direction)?;
    let speed = speed(arguments, &case)?;
    let (from, to) = range(arguments, &track)?;
    let request =
        ReceptanceRequest { direction, speed, frequencies: ReceptanceCurves::frequencies(from, to, arguments.points) };
    let answer = ReceptanceAnswer::new(&case, request)?;
    // Only files and words tell it.
    let decay = LazyCell::new(|| answer.decay());
    let results = Results::of("receptance", &arguments.case, &arguments.results);
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("receptance", &answer.figure(&case))?;
            staging.write_with("receptance.csv", |file| answer.curves_csv(file))?;
            staging.write_with("resonances.csv", |file| answer.resonances_csv(file))?;
            if let Some(decay) = &*decay {
                staging.write_with("decay-rate.csv", |file| decay_csv(decay, file))?;
                let picture = decay_figure(&case, decay).picture();
                staging.write_picture("decay-rate", &picture.map_err(CliError::from)?)?;
            }
            Ok(())
        },
        || readable(&case, &answer, decay.as_deref()),
    )?;
    print_remarks(&case.remarks);
    Ok(())
}

/// Speed of the load \[m/s\], by default the highest of the map.
fn speed(arguments: &Receptance, case: &Case) -> Result<f64, CliError> {
    match &arguments.speed {
        Some(speed) => speed.within("--speed"),
        None => Ok(case.speed.max()),
    }
}

/// Track and wheel along all axes.
fn matrix(arguments: &Receptance, case: &Case) -> miette::Result<()> {
    let speed = speed(arguments, case)?;
    let frequencies = match &arguments.frequencies[..] {
        [] => {
            let (from, to) = range(arguments, &case.track)?;
            ReceptanceCurves::frequencies(from, to, arguments.points)
        }
        listed => within("--frequencies", listed)?,
    };
    let answer = MatrixAnswer::new(case, speed, frequencies)?;
    let results = Results::of("receptance", &arguments.case, &arguments.results);
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("matrix", &answer.figure(case))?;
            staging.write_with("matrix.csv", |file| answer.csv(file))
        },
        String::new,
    )?;
    print_remarks(&case.remarks);
    Ok(())
}

/// Frequencies of a list \[Hz\].
pub(super) fn within(argument: &'static str, listed: &[Asked<Frequency>]) -> Result<Vec<f64>, CliError> {
    listed.iter().map(|frequency| frequency.within(argument)).collect()
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
    Err(CliError::Argument { argument: "--to", value: format!("{to} Hz"), rule: format!("above --from, {from} Hz") })
}

/// Resonances and decay rates for the terminal.
fn readable(case: &Case, answer: &ReceptanceAnswer, decay: Option<&[DecayRate]>) -> String {
    let ReceptanceAnswer { track, resonances, .. } = answer;
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
    if let Some(closed) = answer.p2_closed_form {
        text.push_str(&format!(
            "P2 in closed form: {:.1} Hz, {:.0} kg of the wheel and {:.0} kg of the track on {:.1} MN/m of track and contact\n",
            closed.angular_frequency() / TAU,
            closed.mass,
            closed.track_mass,
            1e-6 * closed.stiffness,
        ));
    }
    if !answer.lateral_resonances.is_empty() {
        let named = answer.lateral_resonances.iter();
        let named: Vec<String> = named.map(|(kind, frequency)| format!("{kind} {frequency:.1} Hz")).collect();
        text.push_str(&format!("across the track, undamped: {}\n", named.join(", ")));
    }
    if let Some(rates) = decay {
        let list: Vec<String> = rates
            .iter()
            .map(|rate| {
                let bound = if rate.upper_bound { "<" } else { "" };
                format!("{} Hz {bound}{:.2}", rate.nominal_frequency, rate.decay_rate)
            })
            .collect();
        text.push_str(&format!("decay rate dB/m: {}\n", list.join(", ")));
    }
    text
}
