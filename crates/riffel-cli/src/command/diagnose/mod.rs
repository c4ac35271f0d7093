//! `riffel diagnose`

mod diagnosis;
mod document;
pub(crate) mod figure;
mod finding;
mod record;

use riffel::diagnosis::TrafficSpeeds;
use riffel_case::Case;
use riffel_case::quantity::{Quantity, Speed};
use riffel_case::traffic::Traffic;

use super::roughness::read;
use crate::arguments::{Diagnose, DiagnosisArguments, positive};
use crate::error::CliError;
use crate::output::{json, print, print_remarks};
use crate::staging::Staging;

pub(crate) use diagnosis::Diagnosis;
pub(crate) use document::{Document, SHARE};
pub(crate) use finding::{capital, row};

pub(crate) fn run(arguments: &Diagnose) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let record = read(&arguments.record.roughness, &arguments.record.layout)?;
    let diagnosis = Diagnosis::of(&case, &record, &arguments.record)?;
    let file = arguments.record.roughness.display().to_string();
    let document = json(&Document::new(&file, &diagnosis));
    if arguments.json {
        print(&document);
        print_remarks(&diagnosis.warnings);
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "diagnosis");
    let mut staging = Staging::new(&folder)?;
    staging.write_figure("diagnosis", &figure::of(&file, &diagnosis))?;
    staging.write_with("candidates.csv", |file| diagnosis.table(file))?;
    staging.write("diagnosis.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(diagnosis.readable(&file, &case) + &place));
        print_remarks(&diagnosis.warnings);
    }
    Ok(())
}

/// The speeds asked for, or those of the map.
pub(crate) fn speeds(
    case: &Case,
    arguments: &DiagnosisArguments,
    warnings: &mut Vec<String>,
) -> miette::Result<TrafficSpeeds> {
    let wrong = |value: &str, rule: &str| CliError::Argument {
        argument: "--speed",
        value: value.to_owned(),
        rule: rule.to_owned(),
    };
    if let (Some(path), true) = (&arguments.traffic, arguments.speed.is_empty()) {
        let speeds = Traffic::read(path)?.passing_speeds();
        return Ok(speeds.map_err(|error| CliError::Argument {
            argument: "--traffic",
            value: path.display().to_string(),
            rule: format!("a file with speeds: {error}"),
        })?);
    }
    if arguments.speed.is_empty() {
        let (slowest, fastest) = (case.speed.min(), case.speed.max());
        warnings.push(format!(
            "neither --speed nor --traffic given: all speeds of the case's map, {:.0}–{:.0} km/h, are taken to be equally common, which tells \
             constant frequencies apart badly",
            3.6 * slowest,
            3.6 * fastest
        ));
        let between = TrafficSpeeds::between(slowest, fastest);
        return Ok(between.map_err(|error| wrong("the map's", &error.to_string()))?);
    }
    let mut shares = Vec::new();
    for written in &arguments.speed {
        let parse = |text: &str| -> miette::Result<f64> {
            let speed: Quantity<Speed> = text
                .trim()
                .parse()
                .map_err(|error| miette::miette!("--speed: {error}"))?;
            Ok(positive("--speed", speed)?)
        };
        let (slowest, fastest) = match written.split_once("..") {
            Some((slowest, fastest)) => (parse(slowest)?, parse(fastest)?),
            None => {
                let speed = parse(written)?;
                (speed, speed)
            }
        };
        if slowest > fastest {
            Err(wrong(written, "from the slower to the faster"))?;
        }
        let range = TrafficSpeeds::between(slowest, fastest)
            .map_err(|error| wrong(written, &error.to_string()))?;
        shares.extend_from_slice(range.shares());
    }
    let all = TrafficSpeeds::new(shares);
    Ok(all.map_err(|error| wrong(&arguments.speed.join(", "), &error.to_string()))?)
}
