//! `riffel profile`

use riffel::profile::{EquivalentConicity, ProfileAlignment};
use riffel_answers::profile::{Measures, OnTrackAnswer, OutlineAnswer, UnderLoadAnswer, WearAnswer, WearSettings};
use riffel_case::file::{Inclination, ProfileKind, ProfileOrientation};
use riffel_case::{CurvingCase, ProfileReading};

use crate::arguments::{Alignment, CaseArguments, Orientation, Profile, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, table};
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
                /// Curvature \[1/m\] of what is straight.
                const STRAIGHT: f64 = 1e-3;
                let radius = match profile.at(0.0) {
                    None => "–".to_owned(),
                    Some(origin) if origin.curvature.abs() < STRAIGHT => "straight".to_owned(),
                    Some(origin) => format!("{:.1}", -1e3 / origin.curvature),
                };
                rows.add_row([name.clone(), format!("{:.2}", 1e3 * from), format!("{:.2}", 1e3 * to), radius]);
            }
            format!("{rows}\n")
        },
    )?;
    print_remarks(&answer.remarks);
    Ok(())
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
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("wear", &answer.figure())?;
            staging.write_with("wear.csv", |file| answer.csv(file))
        },
        || in_words(&answer),
    )?;
    print_remarks(&answer.remarks);
    Ok(())
}

/// Wear as a table, in mm.
fn in_words(answer: &WearAnswer) -> String {
    let mut rows = match answer.kind() {
        ProfileKind::Wheel => table(&[
            "wheel",
            "tread wear mm",
            "flange height Sh mm",
            "thickness Sd mm",
            "qR mm",
            "deepest mm",
            "area mm2",
        ]),
        ProfileKind::Rail => {
            table(&["rail", "W1 vertical mm", "W2 lateral mm", "W3 at 45° mm", "deepest mm", "area mm2"])
        }
    };
    let millimetres = |length: f64| format!("{:.2}", 1e3 * length);
    let or_dash = |length: Option<f64>| length.map_or("–".to_owned(), millimetres);
    for worn in answer.worn() {
        let mut cells = vec![worn.name.clone()];
        match &worn.measures {
            Measures::Wheel { measured, nominal } => cells.extend([
                or_dash(measured.tread_wear(nominal)),
                or_dash(measured.flange_height),
                or_dash(measured.flange_thickness),
                or_dash(measured.flange_gradient),
            ]),
            Measures::Rail(rail) => {
                cells.extend([rail.vertical, rail.lateral, rail.diagonal].map(or_dash));
            }
        }
        cells.push(or_dash(worn.wear.deepest().map(|(_, depth)| depth)));
        cells.push(format!("{:.1}", 1e6 * worn.wear.area));
        rows.add_row(cells);
    }
    format!("Wear {}\n{rows}\n", answer.in_words())
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
                "with roll",
                "harmonic",
                "regression",
                "wavelength m",
            ]);
            for row in &answer.conicities {
                let cell = |found: &Option<EquivalentConicity>, value: fn(&EquivalentConicity) -> String| {
                    found.as_ref().map_or_else(|| "no motion".to_owned(), value)
                };
                rows.add_row([
                    format!("{:.0}", 1e3 * row.amplitude),
                    cell(&row.standard, |found| format!("{:.4}", found.klingel)),
                    cell(&row.rolling, |found| format!("{:.4}", found.klingel)),
                    cell(&row.standard, |found| format!("{:.4}", found.harmonic)),
                    cell(&row.standard, |found| format!("{:.4}", found.regression)),
                    cell(&row.standard, |found| match found.wavelength.is_finite() {
                        true => format!("{:.2}", found.wavelength),
                        false => "endless".to_owned(),
                    }),
                ]);
            }
            format!(
                "{title}\n{rows}\nequivalent conicity by EN 15302, for an axle that stays level; with roll: as it rolls where both \
                 wheels touch, which counts on flanks\n"
            )
        },
    )?;
    print_remarks(&case.remarks);
    print_remarks(&case.remarks_of_profiles()?);
    Ok(())
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
    results.hand_out(
        || json(answer.document()),
        |staging| {
            staging.write_figure("contact", &answer.figure())?;
            staging.write_with("contact.csv", |file| answer.csv(file))
        },
        || {
            let (heading, lines) = answer.table();
            let mut rows = table(&heading);
            for line in lines {
                rows.add_row(line);
            }
            format!("Wheels under {:.1} kN each\n{rows}\n", 1e-3 * load)
        },
    )?;
    print_remarks(&answer.remarks);
    print_remarks(&case.remarks);
    print_remarks(&case.remarks_of_profiles()?);
    Ok(())
}
