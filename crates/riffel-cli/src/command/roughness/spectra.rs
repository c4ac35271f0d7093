//! A table of spectra on the command line.

use riffel_answers::roughness::SpectraAnswer;
use riffel_keys::{Language, say};
use riffel_rail::{LimitTable, Survey};

use super::folder;
use crate::arguments::Roughness;
use crate::error::CliError;
use crate::messages::{language, print_remarks};
use crate::output::{json, print, table};
use crate::staging::Staging;

pub(super) fn run(survey: Survey, limits: &[LimitTable], arguments: &Roughness) -> miette::Result<()> {
    let along = arguments.along.as_ref();
    let of_profiles = [
        ("--longest", arguments.statistics.longest.map(|value| value.to_string())),
        ("--window", arguments.statistics.window.map(|value| value.to_string())),
        ("--along", along.map(|path| path.display().to_string())),
    ];
    for (argument, value) in of_profiles {
        if let Some(value) = value {
            Err(CliError::Argument {
                argument,
                value,
                rule: format!("left out: it is for profiles, and {} is a table of spectra", survey.path().display()),
            })?;
        }
    }
    let survey = survey.choose(&arguments.choose)?;
    let path = survey.path();
    // The mean of several dates is the state of no day.
    let dates = survey.column_of_several_dates();
    let by = arguments.by.as_deref().or(dates);
    let answer = SpectraAnswer::new(&survey, limits, by)?;
    let document = json(&answer.document(path));
    if arguments.json {
        print(&document)?;
        if arguments.output.is_none() {
            print_remarks(&survey.warnings);
            return Ok(());
        }
    }
    let folder = folder(path, arguments.output.as_deref());
    let mut staging = Staging::new("roughness", &folder)?;
    staging.write_figure("roughness", &answer.figure(path, limits, Language::English))?;
    staging.write_with("spectrum.csv", |file| answer.spectrum_csv(file))?;
    staging.write("summary.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let mut text = format!("{}\n", path.display());
        let count = say!(one_third_octave_spectra, count = answer.count());
        text += &format!("read as: {}", count.text(language()));
        if let (None, Some(column)) = (&arguments.by, dates) {
            text += &format!(" of {} dates, told apart by column {column}", answer.groups.len());
        }
        text.push('\n');
        text += &readable(&answer);
        let verdicts = answer.verdicts.iter().map(|verdict| &verdict.sentence);
        for line in verdicts.chain(&answer.findings) {
            text += &format!("{}\n", line.text(language()));
        }
        print(&format!("{text}{}: {}\n", folder.display(), files.join(" ")))?;
    }
    print_remarks(&survey.warnings);
    Ok(())
}

/// Energy mean and, behind the stroke, mean of levels of each group.
fn readable(answer: &SpectraAnswer) -> String {
    let groups = &answer.groups;
    let mut header = vec!["wavelength mm".to_owned()];
    header.extend(groups.iter().map(|group| format!("{} ({})", group.name, group.count)));
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let mut rows = table(&header);
    for band in answer.bands() {
        let mut row = vec![format!("{}", band.nominal_millimetres())];
        row.extend(groups.iter().map(|group| match group.energy.level(band).zip(group.arithmetic.level(band)) {
            Some((energy, arithmetic)) => format!("{energy:.1} | {arithmetic:.1}"),
            None => String::new(),
        }));
        rows.add_row(row);
    }
    format!("levels in dB re 1 µm: mean of energies | mean of levels, over so many spectra\n{rows}\n")
}
