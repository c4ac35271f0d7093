//! `riffel report`

mod inputs;
mod mechanism;
mod outlook;
mod page;
mod roughness;

use std::path::Path;

use inputs::Inputs;
use outlook::{Now, Outlook};
use page::{Head, Section, escape};
use riffel_answers::capital;
use riffel_answers::report::Site;
use riffel_answers::roughness::SpectraAnswer;
use riffel_case::Case;
use riffel_keys::quantity::Quantity;
use riffel_rail::{Limit, LimitTable, RoughnessFile, Survey};

use crate::arguments::{CaseArguments, DiagnosisArguments, Report, Statistics};
use crate::command::diagnose::diagnosis;
use crate::command::roughness::profile::judged;
use crate::command::roughness::{choose_nothing, limits, read};
use crate::error::CliError;
use crate::output::print;
use crate::staging::{Existing, write_file};

/// Title where none is given.
const TITLE: &str = "Rail roughness and corrugation";

/// Why a section is left out.
const NO_CASE: &str = "no case was given.";
const NO_ROUGHNESS: &str = "no roughness was given.";
const NO_LEVEL_LIMIT: &str = "it needs a limit of levels (--limit).";

/// What of the report comes from the roughness.
struct Measured {
    sections: Vec<Section>,
    brief: Vec<String>,
    /// What the file was understood as.
    understood: String,
    /// The latest date of a table of spectra.
    date: Option<String>,
    /// The spectra, with what is to be said of them.
    survey: Survey,
}

pub(crate) fn run(arguments: &Report) -> miette::Result<()> {
    let site = arguments.site.as_deref().map(Site::read).transpose()?;
    let site = site.unwrap_or_default();
    let case = arguments
        .case
        .as_deref()
        .map(|path| CaseArguments::of(path, &arguments.overrides).read())
        .transpose()?;
    let limits = limits(&arguments.limit)?;
    let (mut sections, mut brief, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
    let mut inputs = Inputs::default();
    let record = &arguments.record;
    let rail = match &arguments.roughness {
        Some(path) => {
            let file = read(path, &record.layout)?;
            // The diagnosis looks at the heights, which the statistics use up.
            let diagnosis = match &case {
                Some(case) => Some(diagnosis(case, path, &file, record)?),
                None => None,
            };
            let mut measured = measured(path, file, record, &limits)?;
            sections.append(&mut measured.sections);
            brief.append(&mut measured.brief);
            warnings.extend(measured.survey.warnings.clone());
            inputs.add("roughness", path, &measured.understood)?;
            for earlier in &record.earlier {
                inputs.add("earlier record", earlier, "of the same rail")?;
            }
            Some((path, measured, diagnosis))
        }
        None => {
            check_without_roughness(arguments)?;
            let all = [
                "Profile",
                "Moving RMS along the line",
                "Spectrum and limits",
                "Wavelength bands",
                "What to grind",
            ];
            sections.extend(all.map(|heading| Section::LeftOut(heading, NO_ROUGHNESS)));
            None
        }
    };

    match (&case, rail) {
        (Some(case), Some((path, measured, Some(diagnosis)))) => {
            let file = path.display().to_string();
            sections.push(mechanism::growth_map(case, Some(&diagnosis))?.section);
            sections.push(mechanism::diagnosis(&file, &diagnosis)?);
            if diagnosis.findings.is_empty() {
                brief.push("No dominant wavelength stands out of the roughness.".to_owned());
            }
            brief.extend(diagnosis.findings.iter().map(|finding| {
                format!(
                    "<b>{:.1} mm</b> stands out{}, {:.1} dB. {}",
                    1e3 * finding.measured.peak.wavelength,
                    finding
                        .place()
                        .map_or_else(String::new, |place| escape(&format!(" on {place}"))),
                    finding.measured.peak.level,
                    escape(&capital(&finding.summary()))
                )
            }));
            warnings.extend(diagnosis.warnings);
            warnings.extend(case.remarks.iter().map(ToString::to_string));
            let speed = diagnosis.speeds.mean();
            for outlook in outlooks(arguments, path, &limits, measured, speed)? {
                outlook.put(&mut sections, &mut brief, &mut warnings);
            }
        }
        (Some(case), _) => {
            let map = mechanism::growth_map(case, None)?;
            map.put(&mut sections, &mut brief, &mut warnings);
            sections.push(Section::LeftOut("Diagnosis", NO_ROUGHNESS));
            sections.push(Section::LeftOut("Forecast", NO_ROUGHNESS));
            warnings.extend(case.remarks.iter().map(ToString::to_string));
            what_if(arguments, None, &limits)?.put(&mut sections, &mut brief, &mut warnings);
        }
        (None, _) => {
            let all = ["Growth map", "Diagnosis", "Forecast", "What-if"];
            sections.extend(all.map(|heading| Section::LeftOut(heading, NO_CASE)));
        }
    }
    if let (Some(path), Some(case)) = (&arguments.case, &case) {
        let title = case.file.title.as_deref().unwrap_or("a case");
        let overrides = match &arguments.overrides[..] {
            [] => String::new(),
            overrides => format!(", with {}", overrides.join(", ")),
        };
        inputs.add("case", path, &format!("{title}{overrides}"))?;
        if let Some(measurement) = &case.file.track.measurement {
            let folder = path.parent().unwrap_or_else(|| Path::new(""));
            let file = folder.join(&measurement.file);
            inputs.add("track receptance", &file, "measured")?;
        }
    }
    if let Some(traffic) = &record.traffic {
        inputs.add("traffic", traffic, "vehicles, speeds, loads")?;
    }
    for variant in &arguments.variants {
        inputs.add("variant", variant, "changes to the case")?;
    }
    if let Some(format) = &record.layout.format {
        inputs.add("reader profile", format, "how profiles are laid out")?;
    }
    for name in arguments
        .limit
        .iter()
        .filter(|name| name.ends_with(".toml"))
    {
        inputs.add("limit table", name.as_ref(), "of your own")?;
    }
    if let Some(site) = &arguments.site {
        inputs.add("site", site, "the words at the top")?;
    }
    sections.push(inputs_section(&inputs, &limits, case.as_ref()));
    // Readings of the roughness warn of the same defects, and vehicles of the same limits at their own
    // frequencies, which stand in brackets.
    let mut known = std::collections::HashSet::new();
    warnings.retain(|warning| {
        let what = warning.split(" (").next().unwrap_or_default();
        known.insert(what.to_owned())
    });
    sections.push(warnings_section(&warnings));

    let title = arguments.title.as_deref().or(site.title.as_deref());
    let head = Head {
        title: title.unwrap_or(TITLE),
        facts: site.facts(),
        remarks: site.remarks.as_deref(),
        brief,
    };
    write_file(
        &arguments.output,
        &page::page(&head, &sections),
        Existing::Replace,
    )?;
    print(&format!(
        "wrote {}; open it in a browser, print it to A4 from there\n",
        arguments.output.display()
    ))?;
    Ok(())
}

/// `Ok` if there is a case to report on, and nothing is said of a rail.
fn check_without_roughness(arguments: &Report) -> Result<(), CliError> {
    let wrong = |argument, value: &str, rule: &str| {
        Err(CliError::Argument {
            argument,
            value: value.to_owned(),
            rule: rule.to_owned(),
        })
    };
    if let Some(argument) = arguments.record.given() {
        return wrong(argument, "given", "left out where there is no --roughness");
    }
    if arguments.case.is_none() {
        let rule = "given where there is no case to report on";
        return wrong("--roughness", "left out", rule);
    }
    Ok(())
}

/// Judge the roughness as `riffel roughness` does.
fn measured(
    path: &Path,
    file: RoughnessFile,
    record: &DiagnosisArguments,
    limits: &[LimitTable],
) -> miette::Result<Measured> {
    Ok(match file {
        RoughnessFile::Profile(profile) => {
            choose_nothing(path, &record.choose, record.by.as_deref())?;
            let strips = roughness::strips(&profile)?;
            let statistics = Statistics {
                block: Quantity::new(roughness::block_of_strip(&profile)),
                ..Statistics::default()
            };
            let report = judged(path, profile, limits, &statistics)?;
            let worst = report.worst().map(|worst| escape(&(capital(&worst) + ".")));
            let verdicts = report.verdicts().map(roughness::sentence);
            let mut brief: Vec<String> = worst.into_iter().chain(verdicts).collect();
            brief.push(escape(&roughness::total(&report)));
            Measured {
                sections: vec![
                    strips,
                    roughness::moving_rms(&report)?,
                    roughness::spectrum_of_profile(path, &report, limits)?,
                    roughness::bands(&report, limits),
                    roughness::grind(&report),
                ],
                brief,
                understood: report.understood().trim().to_owned(),
                date: None,
                survey: report.survey(path)?,
            }
        }
        RoughnessFile::Spectra(spectra) => {
            const TABLE: &str = "the record is a table of levels; it needs a profile.";
            let survey = Survey::new(path, spectra, Vec::new())?.choose(&record.choose)?;
            let dated = survey.columns().any(|column| column == "date");
            let by = record.by.as_deref().or_else(|| dated.then_some("date"));
            let dates = survey.records.iter();
            let date = dates.filter_map(|spectrum| spectrum.label("date")).max();
            let means = SpectraAnswer::new(&survey, limits, by)?;
            Measured {
                sections: vec![
                    Section::LeftOut("Profile", TABLE),
                    Section::LeftOut("Moving RMS along the line", TABLE),
                    roughness::spectrum_of_means(path, &means, limits)?,
                    Section::LeftOut("Wavelength bands", TABLE),
                    Section::LeftOut("What to grind", TABLE),
                ],
                brief: means.verdicts.iter().map(roughness::sentence).collect(),
                understood: format!(
                    "{} one-third-octave spectra{}",
                    means.count(),
                    match &record.choose[..] {
                        [] => String::new(),
                        choose => format!(", those with {}", choose.join(", ")),
                    }
                ),
                date: date.map(str::to_owned),
                survey,
            }
        }
    })
}

/// Forecast and what-if of a measured rail, as far as there is input for them.
fn outlooks(
    arguments: &Report,
    path: &Path,
    limits: &[LimitTable],
    measured: Measured,
    speed: f64,
) -> miette::Result<[Outlook; 2]> {
    let record = &arguments.record;
    let date = measured.date.as_deref();
    // A table of several dates is now at its latest.
    let choose: Vec<String> = date.iter().map(|date| format!("date={date}")).collect();
    let now = Now {
        path,
        traffic: record.traffic.as_deref(),
        survey: measured.survey.choose(&choose)?,
        date: match date {
            Some(date) => date.parse().ok(),
            None => record.dates.last().copied(),
        },
        speed,
    };
    let forecast = match (
        &arguments.case,
        &record.traffic,
        level_limit(arguments, limits),
    ) {
        (Some(case), Some(traffic), Some(limit)) => {
            let case = CaseArguments::of(case, &arguments.overrides);
            outlook::forecast(
                case,
                traffic.clone(),
                limit,
                &now,
                arguments.ground.clone(),
                arguments.months,
            )?
        }
        (_, _, None) => Outlook::left_out("Forecast", NO_LEVEL_LIMIT),
        _ => Outlook::left_out("Forecast", "no traffic was given (--traffic)."),
    };
    Ok([forecast, what_if(arguments, Some(&now), limits)?])
}

/// What would help, with what is measured now if anything is.
fn what_if(
    arguments: &Report,
    now: Option<&Now<'_>>,
    limits: &[LimitTable],
) -> miette::Result<Outlook> {
    let (Some(case), Some(limit)) = (&arguments.case, level_limit(arguments, limits)) else {
        return Ok(Outlook::left_out("What-if", NO_LEVEL_LIMIT));
    };
    if arguments.variants.is_empty() {
        return Ok(Outlook::left_out(
            "What-if",
            "no variant was given (--with).",
        ));
    }
    let case = CaseArguments::of(case, &arguments.overrides);
    outlook::what_if(
        case,
        arguments.variants.clone(),
        arguments.hold,
        limit,
        arguments.ground.clone(),
        now,
    )
}

/// The limit of levels that forecast and what-if go by: the one asked for, or the first of all.
fn level_limit(arguments: &Report, limits: &[LimitTable]) -> Option<String> {
    let is_of_levels = |table: &LimitTable| matches!(table.limit, Limit::Levels(_));
    let first = limits.iter().find(|table| is_of_levels(table))?;
    let given = arguments
        .limit
        .iter()
        .find(|name| LimitTable::find(name).is_ok_and(|table| is_of_levels(&table)));
    Some(given.unwrap_or(&first.name).clone())
}

/// Files, limit tables and presets with their origin, and what made the report.
fn inputs_section(inputs: &Inputs, limits: &[LimitTable], case: Option<&Case>) -> Section {
    let mut html = inputs.html();
    let mut sources: Vec<Vec<String>> = limits
        .iter()
        .map(|table| {
            vec![
                escape(&format!("limit {}", table.name)),
                escape(&table.edition),
                escape(&table.source),
            ]
        })
        .collect();
    if let Some(case) = case {
        let file = &case.file;
        let names = [
            file.vehicle.as_ref(),
            file.rail.section.as_ref(),
            file.track.preset.as_ref(),
        ];
        for preset in names
            .into_iter()
            .flatten()
            .filter_map(|name| riffel_case::preset(name).ok())
        {
            let mut origin: Vec<&str> = preset
                .values
                .iter()
                .map(|value| value.source.as_str())
                .collect();
            origin.dedup();
            sources.push(vec![
                escape(&format!("preset {}", preset.name)),
                escape(&preset.title),
                escape(origin.first().copied().unwrap_or_default()),
            ]);
        }
    }
    html += &page::table("words", &["built in", "what it is", "source"], &sources);
    html += &format!(
        "<p class=\"small\">Made by riffel {}. The same files and the same version give the same report.</p>\n",
        env!("CARGO_PKG_VERSION")
    );
    Section::There("Inputs and versions", html)
}

fn warnings_section(warnings: &[String]) -> Section {
    let html = if warnings.is_empty() {
        "<p>None.</p>\n".to_owned()
    } else {
        page::list(warnings.iter().cloned())
    };
    Section::There("Warnings and limits of the models", html)
}
