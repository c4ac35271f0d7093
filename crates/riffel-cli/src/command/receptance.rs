//! `riffel receptance`

use std::io::{self, Write};

use riffel::{Complex64, LoopState};
use riffel_plot::{
    Arrangement, DEFAULT_PNG_SCALE, LineFigure, LinePanel, LineStyle, Scale, Series, png,
};

use crate::arguments::{Receptance, positive};
use crate::error::CliError;
use crate::map_figure::parameters;
use crate::output::print;
use crate::staging::Staging;

pub(crate) fn run(arguments: &Receptance) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let speed = match arguments.speed {
        Some(speed) => positive("--speed", speed)?,
        None => case.speed.max(),
    };
    let (from, to) = (positive("--from", arguments.from)?, arguments.to.si());
    if from >= to {
        Err(CliError::Argument {
            argument: "--to",
            value: format!("{to} Hz"),
            rule: format!("above --from, {from} Hz"),
        })?;
    }

    let last = f64::from(arguments.points - 1);
    let states: Vec<LoopState> = (0..arguments.points)
        .map(|index| from * (to / from).powf(f64::from(index) / last))
        .map(|frequency| case.feedback.at(speed / frequency, speed))
        .collect();
    let contact = case.feedback.contact_stiffness.recip();
    let figure = figure(&states, contact, speed, &parameters(&case));

    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "receptance");
    let mut staging = Staging::new(&folder)?;
    let svg = figure.svg().map_err(CliError::from)?;
    let picture = png(&svg, DEFAULT_PNG_SCALE).map_err(CliError::from)?;
    staging.write("receptance.png", picture)?;
    staging.write("receptance.svg", svg)?;
    staging.write_with("receptance.csv", |file| table(&states, contact, file))?;
    let files = staging.publish()?;
    print(&format!("{}: {}\n", folder.display(), files.join(" ")));
    Ok(())
}

/// Receptances of the joints at a state: track, wheel, contact spring and their sum.
fn joints(state: &LoopState, contact: f64) -> [Complex64; 4] {
    let (track, wheel) = (state.track_receptance, state.wheel_receptance);
    [track, wheel, contact.into(), track + wheel + contact]
}

fn table(states: &[LoopState], contact: f64, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = vec!["frequency_hz".to_owned()];
    for joint in ["rail", "wheel", "contact", "total"] {
        header.push(format!("{joint}_receptance_re_m_per_n"));
        header.push(format!("{joint}_receptance_im_m_per_n"));
    }
    writer.write_record(&header)?;
    for state in states {
        let mut row = vec![state.speed / state.wavelength];
        row.extend(joints(state, contact).iter().flat_map(|h| [h.re, h.im]));
        writer.serialize(row)?;
    }
    writer.flush()
}

fn figure(states: &[LoopState], contact: f64, speed: f64, parameters: &str) -> LineFigure {
    let frequencies: Vec<f64> = states
        .iter()
        .map(|state| state.speed / state.wavelength)
        .collect();
    let styles = [
        ("rail", LineStyle::Solid),
        ("wheel", LineStyle::Dashed),
        ("contact spring", LineStyle::Dotted),
        ("total", LineStyle::Solid),
    ];
    let panel = |subtitle: &str, y_label: &str, y_scale, value: fn(Complex64) -> f64| LinePanel {
        subtitle: subtitle.to_owned(),
        x_label: "frequency f [Hz]".to_owned(),
        y_label: y_label.to_owned(),
        x_scale: Scale::Log,
        y_scale,
        series: styles
            .iter()
            .enumerate()
            .map(|(joint, &(label, style))| Series {
                label: label.to_owned(),
                x: frequencies.clone(),
                y: states
                    .iter()
                    .map(|state| value(joints(state, contact)[joint]))
                    .collect(),
                style,
                color: None,
            })
            .collect(),
        ..LinePanel::default()
    };
    LineFigure {
        title: "Receptances at the contact".to_owned(),
        caption: format!(
            "Displacement per force, both downward, exp(+iωt), load at {speed:.1} m/s. {parameters}"
        ),
        panels: vec![
            panel("modulus", "|H| [m/N]", Scale::Log, |h| h.norm()),
            panel("phase", "arg H [°]", Scale::Linear, |h| {
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
