//! `riffel report`

mod fingerprint;
mod mechanism;
mod outlook;
mod page;
mod roughness;

use riffel_case::roughness::{Limit, LimitTable, RoughnessFile, Survey};
use riffel_case::{Case, Site};

use crate::arguments::{CaseArguments, Report, Statistics};
use crate::command::diagnose::diagnosis;
use crate::command::roughness::profile::Report as ProfileReport;
use crate::command::roughness::spectra::Means;
use crate::command::roughness::{choose_nothing, limits, read};
use crate::output::print;
use crate::staging::write_file;
use fingerprint::Inputs;
use outlook::{Now, Outlook};
use page::{Head, Section, escape};

/// Title where none is given.
const TITLE: &str = "Rail roughness and corrugation";

/// What of the report comes from the roughness alone.
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
        .map(|path| Case::read(path, &arguments.overrides))
        .transpose()?;
    let limits = limits(&arguments.limit)?;
    let path = &arguments.record.roughness;
    let file = read(path, &arguments.record.layout)?;
    // The diagnosis looks at the heights, which the statistics use up.
    let diagnosis = match &case {
        Some(case) => Some(diagnosis(case, &file, &arguments.record)?),
        None => None,
    };
    let Measured {
        mut sections,
        mut brief,
        understood,
        date,
        survey,
    } = measured(file, arguments, &limits)?;
    let mut warnings = survey.warnings.clone();
    let mut inputs = Inputs::default();
    inputs.add("roughness", path, &understood)?;
    for earlier in &arguments.record.earlier {
        inputs.add("earlier record", earlier, "of the same rail")?;
    }

    const NO_CASE: &str = "no case was given.";
    match case.as_ref().zip(diagnosis) {
        Some((case, diagnosis)) => {
            let file = path.display().to_string();
            sections.push(mechanism::growth_map(case, &diagnosis)?);
            sections.push(mechanism::diagnosis(&file, &diagnosis)?);
            if diagnosis.findings.is_empty() {
                brief.push("No dominant wavelength stands out of the roughness.".to_owned());
            }
            brief.extend(diagnosis.findings.iter().map(|finding| {
                format!(
                    "<b>{:.1} mm</b> stands out. {}",
                    1e3 * finding.measured.peak.wavelength,
                    escape(&crate::command::diagnose::capital(&finding.summary()))
                )
            }));
            warnings.extend(diagnosis.warnings);
            warnings.extend(case.remarks.iter().map(ToString::to_string));
            let speed = diagnosis.speeds.mean();
            for outlook in outlooks(arguments, &limits, survey, date.as_deref(), speed)? {
                sections.push(outlook.section);
                brief.extend(outlook.brief);
                warnings.extend(outlook.warnings);
            }
        }
        None => {
            sections.push(Section::LeftOut("Growth map", NO_CASE));
            sections.push(Section::LeftOut("Diagnosis", NO_CASE));
            sections.push(Section::LeftOut("Forecast", NO_CASE));
            sections.push(Section::LeftOut("What-if", NO_CASE));
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
            let folder = path.parent().unwrap_or_else(|| std::path::Path::new(""));
            let file = folder.join(&measurement.file);
            inputs.add("track receptance", &file, "measured")?;
        }
    }
    if let Some(traffic) = &arguments.record.traffic {
        inputs.add("traffic", traffic, "vehicles, speeds, loads")?;
    }
    for variant in &arguments.variants {
        inputs.add("variant", variant, "changes to the case")?;
    }
    if let Some(format) = &arguments.record.layout.format {
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
    write_file(&arguments.output, &page::page(&head, &sections), true)?;
    print(&format!(
        "wrote {}; open it in a browser, print it to A4 from there\n",
        arguments.output.display()
    ));
    Ok(())
}

/// Judge the roughness as `riffel roughness` does.
fn measured(
    file: RoughnessFile,
    arguments: &Report,
    limits: &[LimitTable],
) -> miette::Result<Measured> {
    let record = &arguments.record;
    let path = &record.roughness;
    Ok(match file {
        RoughnessFile::Profile(profile) => {
            choose_nothing(path, &record.choose, record.by.as_deref())?;
            let strips = roughness::strips(&profile)?;
            let report = ProfileReport::new(path, profile, limits, &Statistics::default())?;
            let mut brief: Vec<String> = report.verdicts.iter().map(roughness::sentence).collect();
            brief.push(escape(&roughness::total(&report)));
            Measured {
                sections: vec![
                    strips,
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
            let means = Means::new(&survey, limits, by)?;
            Measured {
                sections: vec![
                    Section::LeftOut("Profile", TABLE),
                    roughness::spectrum_of_means(path, &means, limits)?,
                    Section::LeftOut("Wavelength bands", TABLE),
                    Section::LeftOut("What to grind", TABLE),
                ],
                brief: means.verdicts.iter().map(roughness::sentence).collect(),
                understood: format!(
                    "{} one-third-octave spectra{}",
                    means.counts.iter().sum::<usize>(),
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

/// Forecast and what-if, as far as there is input for them.
fn outlooks(
    arguments: &Report,
    limits: &[LimitTable],
    survey: Survey,
    date: Option<&str>,
    speed: f64,
) -> miette::Result<Vec<Outlook>> {
    let left_out = |heading, why| Outlook {
        section: Section::LeftOut(heading, why),
        brief: Vec::new(),
        warnings: Vec::new(),
    };
    let levels = limits
        .iter()
        .find(|table| matches!(table.limit, Limit::Levels(_)));
    let (Some(case), Some(limit)) = (&arguments.case, levels) else {
        const WHY: &str = "it needs a limit of levels (--limit).";
        return Ok(vec![left_out("Forecast", WHY), left_out("What-if", WHY)]);
    };
    let given = arguments.limit.iter().find(|name| {
        LimitTable::find(name).is_ok_and(|table| matches!(table.limit, Limit::Levels(_)))
    });
    // A table of several dates is now at its latest.
    let choose: Vec<String> = date.iter().map(|date| format!("date={date}")).collect();
    let now = Now {
        survey: survey.choose(&choose)?,
        date: match date {
            Some(date) => date.parse().ok(),
            None => arguments.record.dates.last().copied(),
        },
        limit: given.unwrap_or(&limit.name).clone(),
        speed,
    };
    let of_case = || CaseArguments::of(case, &arguments.overrides);
    let forecast = match &arguments.record.traffic {
        Some(traffic) => outlook::forecast(of_case(), traffic.clone(), &now, arguments)?,
        None => left_out("Forecast", "no traffic was given (--traffic)."),
    };
    let what_if = if arguments.variants.is_empty() {
        left_out("What-if", "no variant was given (--with).")
    } else {
        outlook::what_if(of_case(), &now, arguments)?
    };
    Ok(vec![forecast, what_if])
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
