//! `riffel profile`

use riffel::profile::ProfileAlignment;
use riffel_answers::profile::{OnTrackAnswer, OutlineAnswer, UnderLoadAnswer, WearAnswer, WearSettings};
use riffel_case::file::{Inclination, ProfileOrientation};
use riffel_case::{CurvingCase, ProfileReading};

use crate::arguments::{Alignment, CaseArguments, Orientation, Profile, positive};
use crate::error::CliError;
use crate::results::Results;

/// Largest yaw \[rad\], far beyond any curve.
const LARGEST_YAW: f64 = 0.1;

pub(crate) fn run(arguments: &Profile) -> miette::Result<()> {
    let named = CaseArguments::of(&arguments.files[0], &arguments.overrides);
    let results = Results::of("profile", &named, &arguments.results);
    if arguments.wheelset {
        return on_track(arguments, &named, &results);
    }
    let scatter = arguments.scatter.map(|scatter| positive("--scatter", scatter)).transpose()?;
    let reading = ProfileReading {
        orientation: arguments.orientation.map(|orientation| match orientation {
            Orientation::Found => ProfileOrientation::Found,
            Orientation::AsWritten => ProfileOrientation::AsWritten,
            Orientation::Mirrored => ProfileOrientation::Mirrored,
            Orientation::UpsideDown => ProfileOrientation::UpsideDown,
            Orientation::Turned => ProfileOrientation::Turned,
        }),
        scatter,
        ..ProfileReading::default()
    };
    if let Some(nominal) = &arguments.against {
        return against(arguments, nominal, reading, &results);
    }
    let answer = OutlineAnswer::new(arguments.files.iter().map(|file| (file.clone(), reading)))?;
    Ok(results.answer(&answer)?)
}

/// Wear against a nominal profile.
fn against(arguments: &Profile, nominal: &str, reading: ProfileReading, results: &Results) -> miette::Result<()> {
    let default = WearSettings::default();
    let settings = WearSettings {
        reading,
        alignment: arguments.align.map(|part| match part {
            Alignment::Flange => ProfileAlignment::Flange,
            Alignment::FieldSide => ProfileAlignment::FieldSide,
            Alignment::AsWritten => ProfileAlignment::AsWritten,
        }),
        inclination: arguments
            .inclination
            .as_deref()
            .map(|text| {
                Inclination::read(text).map_err(|rule| CliError::Argument {
                    argument: "--inclination",
                    value: text.to_owned(),
                    rule,
                })
            })
            .transpose()?
            .unwrap_or(default.inclination),
        gauge_height: arguments
            .gauge_height
            .map(|height| positive("--gauge-height", height))
            .transpose()?
            .unwrap_or(default.gauge_height),
        ..default
    };
    let answer = WearAnswer::new(&arguments.files, nominal, settings)?;
    Ok(results.answer(&answer)?)
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
    if let Some(load) = arguments.load {
        return under_load(arguments, &case, yaw, positive("--load", load)?, results);
    }
    let shifts: Vec<f64> = (arguments.lateral_shift.iter()).map(|shift| shift.si()).collect();
    let answer = OnTrackAnswer::new(&case, &shifts, yaw)?;
    Ok(results.answer(&answer)?)
}

/// Both contacts of a wheelset under load.
fn under_load(arguments: &Profile, case: &CurvingCase, yaw: f64, load: f64, results: &Results) -> miette::Result<()> {
    /// Some tenths of a second each.
    const MOST_SHIFTS: usize = 201;
    if arguments.lateral_shift.len() > MOST_SHIFTS {
        Err(CliError::Argument {
            argument: "--lateral-shift",
            value: format!("{} shifts", arguments.lateral_shift.len()),
            rule: format!("at most {MOST_SHIFTS} with --load"),
        })?;
    }
    let shifts: Vec<f64> = match &arguments.lateral_shift[..] {
        [] => vec![0.0],
        listed => listed.iter().map(|shift| shift.si()).collect(),
    };
    let answer = UnderLoadAnswer::new(case, &shifts, yaw, load)?;
    Ok(results.answer(&answer)?)
}
