//! `riffel profile`

use riffel_answers::profile::{OnTrackAnswer, OutlineAnswer};

use crate::arguments::{CaseArguments, Profile, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, table};
use crate::results::Results;

/// Lateral shifts where none are listed \[mm\]: to either side, in tenths.
const TENTHS: i32 = 100;

/// Largest yaw \[rad\], far beyond any curve.
const LARGEST_YAW: f64 = 0.1;

pub(crate) fn run(arguments: &Profile) -> miette::Result<()> {
    let named = CaseArguments::of(&arguments.files[0], &arguments.overrides);
    let results = Results {
        command: "profile",
        case: &named,
        output: arguments.output.as_deref(),
        json: arguments.json,
    };
    if arguments.wheelset {
        return on_track(arguments, &named, &results);
    }
    let scatter = arguments
        .scatter
        .map(|scatter| positive("--scatter", scatter))
        .transpose()?;
    let answer = OutlineAnswer::new(&arguments.files, scatter)?;
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("profile", &answer.figure())?;
            staging.write_with("profile.csv", |file| answer.csv(file))
        },
        || {
            let mut rows = table(&["profile", "from mm", "to mm", "radius at x = 0 mm"]);
            for (name, profile) in answer.profiles() {
                let [from, to] = profile.range();
                let radius = profile
                    .at(0.0)
                    .map_or(f64::NAN, |origin| -1e3 / origin.curvature);
                rows.add_row([
                    name.clone(),
                    format!("{:.2}", 1e3 * from),
                    format!("{:.2}", 1e3 * to),
                    format!("{radius:.1}"),
                ]);
            }
            format!("{rows}\n")
        },
    )?;
    print_remarks(&answer.remarks);
    Ok(())
}

fn on_track(arguments: &Profile, named: &CaseArguments, results: &Results) -> miette::Result<()> {
    if let Some(second) = arguments.files.get(1) {
        Err(CliError::Argument {
            argument: "FILE",
            value: second.display().to_string(),
            rule: "the only one with --wheelset, a case file".to_owned(),
        })?;
    }
    let case = named.read_curving()?;
    let yaw = arguments.yaw.map_or(0.0, |yaw| yaw.si());
    if yaw.abs() > LARGEST_YAW {
        Err(CliError::Argument {
            argument: "--yaw",
            value: format!("{yaw} rad"),
            rule: format!("between -{LARGEST_YAW} and {LARGEST_YAW} rad"),
        })?;
    }
    let shifts: Vec<f64> = match &arguments.lateral_shift[..] {
        [] => (-TENTHS..=TENTHS)
            .map(|tenth| 1e-4 * f64::from(tenth))
            .collect(),
        listed => listed.iter().map(|shift| shift.si()).collect(),
    };
    let answer = OnTrackAnswer::new(&case, &shifts, yaw)?;
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("wheelset", &answer.figure())?;
            staging.write_with("wheelset.csv", |file| answer.csv(file))
        },
        || {
            let title = case
                .file
                .title
                .as_deref()
                .unwrap_or("Wheelset on its track");
            let mut rows = table(&[
                "amplitude mm",
                "equivalent conicity",
                "harmonic",
                "regression",
                "wavelength m",
            ]);
            for (amplitude, conicity) in &answer.conicities {
                rows.add_row([
                    format!("{:.0}", 1e3 * amplitude),
                    format!("{:.4}", conicity.klingel),
                    format!("{:.4}", conicity.harmonic),
                    format!("{:.4}", conicity.regression),
                    format!("{:.2}", conicity.wavelength),
                ]);
            }
            format!("{title}\n{rows}\n")
        },
    )?;
    print_remarks(&case.remarks);
    print_remarks(&case.remarks_of_profiles()?);
    Ok(())
}
