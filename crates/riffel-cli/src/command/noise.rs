//! `riffel noise`

use std::path::Path;

use riffel::noise::Surroundings;
use riffel::roughness::Spectrum;
use riffel_answers::noise::{Future, NoiseAnswer, NoiseRequest, Part, Train};
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_rail::{TransferPart, TransferTable, WheelModesTable, WheelRoughness, read_decay_rates};

use super::forecast::level_limit;
use super::roughness::survey;
use crate::arguments::{Layout, Noise};
use crate::messages::print_remarks;
use crate::output::{Progress, json, table};
use crate::results::Results;

pub(crate) fn run(arguments: &Noise) -> miette::Result<()> {
    let survey = survey(&arguments.roughness, &arguments.layout)?.choose(&arguments.choose)?;
    let (survey, _) = survey.latest();
    let case = arguments.case.read()?;
    let request = request(arguments, survey.mean())?;
    let future = request.future.as_ref();
    let vehicles = future.map_or(0, |future| future.traffic.file.vehicle.len());
    let progress = Progress::new("growth under traffic", vehicles);
    let answer = NoiseAnswer::new(&case, request, &|by| progress.advance(by))?;
    drop(progress);
    let results = Results {
        command: "noise",
        case: &arguments.case,
        output: arguments.output.as_deref(),
        json: arguments.json,
    };
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("noise", &answer.figure(&case))?;
            staging.write_with("bands.csv", |file| answer.bands_csv(file))?;
            staging.write("summary.json", json(&answer.document()))
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&survey.warnings);
    print_remarks(&answer.remarks);
    if let Some(course) = &answer.course {
        print_remarks(&course.remarks);
    }
    print_remarks(&case.remarks);
    Ok(())
}

fn request(arguments: &Noise, roughness: Spectrum) -> miette::Result<NoiseRequest> {
    let length = match &arguments.train_length {
        Some(length) => length.within("--train-length")?,
        None => Train::LENGTH_PER_WHEEL * f64::from(arguments.wheels),
    };
    let transfer = match (&arguments.track_transfer, &arguments.vehicle_transfer) {
        (Some(track), Some(vehicle)) => Some([
            TransferTable::find(track, TransferPart::Track)?,
            TransferTable::find(vehicle, TransferPart::Vehicle)?,
        ]),
        _ => None,
    };
    let future = match &arguments.traffic {
        Some(traffic) => Some(Future {
            traffic: Traffic::read(traffic)?,
            months: arguments.months,
            limit: arguments.limit_dba,
        }),
        None => None,
    };
    Ok(NoiseRequest {
        speed: arguments.speed.within("--speed")?,
        roughness,
        wheels: arguments
            .wheel_roughness
            .as_deref()
            .map(wheel_roughness)
            .transpose()?,
        wheel_modes: arguments
            .wheel_modes
            .as_deref()
            .map(WheelModesTable::find)
            .transpose()?,
        decay: arguments
            .decay_rate
            .as_deref()
            .map(read_decay_rates)
            .transpose()?,
        transfer,
        limit: level_limit(&arguments.limit)?,
        train: Train {
            wheels: arguments.wheels,
            length,
            distance: arguments.distance.within("--distance")?,
            height: arguments.height.within("--height")?,
            surroundings: Surroundings::HardGround,
        },
        rail_foot: arguments.rail_foot.within("--rail-foot")?,
        sleeper_area: arguments.sleeper_area.within("--sleeper-area")?,
        future,
    })
}

/// Roughness of the wheels, of a table that comes with Riffel or of a file.
fn wheel_roughness(path: &Path) -> miette::Result<(String, Spectrum)> {
    let name = path.display().to_string();
    Ok(match WheelRoughness::find(&name) {
        Some(table) => (table.name, table.spectrum),
        None => (name, survey(path, &Layout::default())?.mean()),
    })
}

/// Levels for the terminal.
fn readable(case: &Case, answer: &NoiseAnswer) -> String {
    let title = case.file.title.as_deref().unwrap_or("Rolling noise");
    let train = &answer.request.train;
    let mut text = format!(
        "{title}, {:.1} km/h\nlevels over the passage, {} m from the middle of the track, {} m above the rail\n",
        3.6 * answer.request.speed,
        train.distance,
        train.height
    );
    let mut header = vec!["frequency Hz"];
    header.extend(["rail dB", "sleepers dB", "wheel dB", "total dB"]);
    let transfer = answer.by_transfer.as_ref();
    if transfer.is_some() {
        header.push("by transfer functions dB");
    }
    let mut rows = table(&header);
    let cell = |level: Option<f64>| level.map_or_else(String::new, |level| format!("{level:.1}"));
    for band in answer.levels.bands() {
        let mut row = vec![format!("{}", band.band.nominal())];
        row.extend(Part::ALL.map(|part| cell(band.level(part))));
        if let Some(levels) = transfer {
            let same = levels.bands().iter().find(|other| other.band == band.band);
            row.push(cell(same.and_then(|band| band.level(Part::Total))));
        }
        rows.add_row(row);
    }
    let weighted = |level: f64| cell(Some(level).filter(|level| level.is_finite()));
    let mut row = vec!["dB(A)".to_owned()];
    row.extend(Part::ALL.map(|part| weighted(answer.levels.a_weighted(part))));
    row.extend(transfer.map(|levels| weighted(levels.a_weighted(Part::Total))));
    rows.add_row(row);
    text += &format!("{rows}\n");
    text += &format!(
        "sound exposure level of {} wheels on each rail: {:.1} dB(A)\n",
        train.wheels,
        answer.exposure_level()
    );
    let power = |part| answer.powers.a_weighted(part);
    // A track on direct fastenings has no sleepers.
    let sleepers = match power(Part::Sleepers) {
        level if level.is_finite() => format!("sleepers {level:.1}, "),
        _ => String::new(),
    };
    text += &format!(
        "sound power of a wheel with its rail: {:.1} dB(A) re 1 pW; rail {:.1}, {sleepers}wheel {:.1} dB(A)\n",
        power(Part::Total),
        power(Part::Rail),
        power(Part::Wheel)
    );
    text += &measures(answer);
    if let Some(course) = &answer.course {
        text += &format!("{}\n", course.in_words());
    }
    text
}

/// What would help.
fn measures(answer: &NoiseAnswer) -> String {
    let mut rows = table(&["each alone", "dB(A)", "saves dB"]);
    let now = answer.levels.a_weighted(Part::Total);
    for measure in &answer.measures {
        // Not −0.0.
        let saved = (10.0 * measure.saved).round() / 10.0 + 0.0;
        rows.add_row([
            measure.title.clone(),
            format!("{:.1}", now - measure.saved),
            format!("{saved:+.1}"),
        ]);
    }
    format!("{rows}\n")
}
