//! The report of a rail: other answers on one printable page.

mod grinding_cost;
mod inputs;
mod mechanism;
mod noise;
mod outlook;
mod page;
mod roughness;
mod site;
mod strip_map;

use std::path::Path;

use riffel_case::Case;
use riffel_keys::Language;
use riffel_plot::PlotError;
use riffel_rail::{LimitTable, Record};

pub use inputs::Inputs;
pub use page::GENERATOR;
pub use roughness::block_of_strip;
pub use site::Site;

use riffel_case::traffic::is_of_reported_growth;

use crate::AnswerError;
use crate::capital;
use crate::compare::CompareAnswer;
use crate::diagnose::Diagnosis;
use crate::forecast::{ForecastAnswer, PosteriorForecast, WearReport};
use crate::map::MapAnswer;
use crate::noise::NoiseAnswer;
use crate::roughness::{ProfileAnswer, SpectraAnswer};
use outlook::Outlook;
use page::{Head, Section, escape};

/// Title where none is given.
const TITLE: &str = "Rail roughness and corrugation";

/// Why a section is left out.
const NO_CASE: &str = "no case was given.";
const NO_ROUGHNESS: &str = "no roughness was given.";
const NO_DIAGNOSIS: &str = "the roughness was not diagnosed.";

/// Headings of the sections on the roughness, and on the case.
const OF_ROUGHNESS: [&str; 5] = [
    "Profile",
    "Moving RMS along the line",
    "Spectrum and limits",
    "Wavelength bands",
    "What to grind",
];
const OF_CASE: [&str; 5] = [
    "Growth map",
    "Diagnosis",
    "Forecast",
    "What-if",
    "Rolling noise",
];

/// What the report says of the roughness of a rail.
pub struct MeasuredRail<'a> {
    /// The file.
    pub path: &'a Path,
    /// What was computed of it.
    pub roughness: MeasuredRoughness,
    /// What was put right in the records.
    pub warnings: &'a [String],
    /// What may have made its wavelengths, where there is a case.
    pub diagnosis: Option<&'a Diagnosis>,
}

/// Heights or levels, held to limits.
pub enum MeasuredRoughness {
    /// A profile.
    Profile {
        /// Its heights, drawn.
        strips: ProfileStrips,
        /// What was computed of it.
        answer: Box<ProfileAnswer>,
    },
    /// A table of spectra.
    Spectra(SpectraAnswer),
}

/// The heights of a profile, drawn before they are used up.
pub struct ProfileStrips(Section);

impl ProfileStrips {
    /// The lowest and highest of each of many short lengths.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn new(record: &Record) -> Result<Self, PlotError> {
        roughness::strips(record).map(Self)
    }
}

/// What a report is made of.
pub struct ReportRequest<'a> {
    /// Its title, in place of that of the site.
    pub title: Option<&'a str>,
    /// The site.
    pub site: &'a Site,
    /// The limits to which the rail is held.
    pub limits: &'a [LimitTable],
    /// The rail, if it was measured.
    pub rail: Option<MeasuredRail<'a>>,
    /// The case and its growth map, if there is one.
    pub case: Option<(&'a Case, &'a MapAnswer)>,
    /// What becomes of the rail, or why that is left out.
    pub forecast: Result<&'a ForecastAnswer, &'static str>,
    /// What becomes of the rail of a calibration, if there is one.
    pub posterior_forecast: Option<&'a PosteriorForecast>,
    /// What would help, or why that is left out.
    pub compare: Result<&'a CompareAnswer, &'static str>,
    /// What a train sounds like, or why that is left out.
    pub noise: Result<&'a NoiseAnswer, String>,
    /// The files that went into it.
    pub inputs: &'a Inputs,
}

/// Sentences in brief under a label.
fn labelled(label: &str, mut sentences: Vec<String>) -> Vec<String> {
    if let Some(first) = sentences.first_mut() {
        *first = format!("<b>{label}:</b> {first}");
    }
    sentences
}

/// Why growth under the traffic is not to be believed, if it is not.
fn doubt(forecast: Option<&ForecastAnswer>, compare: Option<&CompareAnswer>) -> Option<String> {
    let remarks = forecast.into_iter().flat_map(|answer| &answer.on.remarks);
    let of_compare = compare.into_iter();
    let of_compare = of_compare.flat_map(|answer| &answer.comparison.base().remarks);
    let mut remarks = remarks.chain(of_compare);
    let found = remarks.find(|remark| is_of_reported_growth(remark))?;
    Some(crate::capital(&found.to_string()))
}

/// What fills the page below its head: sections, sentences for those in a hurry, and warnings.
#[derive(Default)]
struct Body {
    sections: Vec<Section>,
    brief: Vec<String>,
    warnings: Vec<String>,
}

impl Body {
    fn leave_out(&mut self, headings: &[&'static str], why: &'static str) {
        let sections = headings.iter();
        self.sections
            .extend(sections.map(|heading| Section::left_out(heading, why)));
    }

    fn put(&mut self, outlook: Outlook) {
        self.sections.push(outlook.section);
        self.brief.extend(outlook.brief);
        self.warnings.extend(outlook.warnings);
    }

    /// The growth map, and what made the wavelengths that were measured, or why that is left out.
    fn put_mechanism(
        &mut self,
        case: &Case,
        map: &MapAnswer,
        diagnosis: Result<(&Path, &Diagnosis), &'static str>,
    ) -> Result<(), PlotError> {
        let found = diagnosis.ok().map(|(_, diagnosis)| diagnosis);
        let map = mechanism::growth_map(case, map, found)?;
        match diagnosis {
            // What the map says in brief, the diagnosis says of the wavelengths that were measured.
            Ok((path, diagnosis)) => {
                let file = path.display().to_string();
                self.sections.push(map.section);
                self.sections.push(mechanism::diagnosis(&file, diagnosis)?);
                self.brief.extend(labelled("Since when", since(diagnosis)));
                self.brief
                    .extend(labelled("Why, and how sure", dominant(diagnosis)));
                self.warnings.extend(diagnosis.warnings.iter().cloned());
            }
            Err(why) => {
                self.put(map);
                self.sections.push(Section::left_out("Diagnosis", why));
            }
        }
        Ok(())
    }

    /// What comes, what helps and what is heard, with a doubt of the growth they follow from.
    fn put_outlooks(&mut self, outlooks: [(&str, Outlook); 3], doubt: Option<String>) {
        for (label, mut outlook) in outlooks {
            outlook.brief = labelled(label, outlook.brief);
            // No dates of a growth that nobody has seen.
            if doubt.is_some() {
                outlook.brief.clear();
            }
            self.put(outlook);
        }
        let no_dates = "Dates, times and what measures would save are therefore left out here; below they stand as the model has them.";
        let doubt = doubt.map(|doubt| {
            let doubt = page::escape(&doubt);
            format!("<b>Not plausible:</b> {doubt}. {no_dates}")
        });
        self.brief.splice(0..0, doubt);
    }
}

/// What comes, what helps and what is heard, each under its label; or why one of them is left out.
fn outlooks(
    case: &Case,
    forecast: Result<&ForecastAnswer, &'static str>,
    compare: Result<&CompareAnswer, &'static str>,
    noise: Result<&NoiseAnswer, String>,
) -> Result<[(&'static str, Outlook); 3], PlotError> {
    let is_unexplained = |answer: &ForecastAnswer| {
        let wear = answer.wear.as_ref();
        wear.is_some_and(WearReport::is_unexplained)
    };
    let forecast_by_measured = forecast.is_ok_and(is_unexplained);
    let forecast = match forecast {
        Ok(answer) => outlook::forecast(case, answer)?,
        Err(why) => Outlook::left_out("Forecast", why),
    };
    let mut what_if = match compare {
        Ok(answer) => outlook::what_if(case, answer)?,
        Err(why) => Outlook::left_out("What-if", why),
    };
    let mut noise = match noise {
        Ok(answer) => noise::heard(answer)?,
        Err(why) => Outlook::left_out("Rolling noise", why),
    };
    // Where growth goes by what was measured, the case knows nothing of what its variants would do to it.
    if forecast_by_measured {
        let unknown = "The model does not explain the growth that was measured, so that it cannot tell what would lower it.";
        what_if.brief = vec![unknown.to_owned()];
        noise.brief.truncate(1);
    }
    Ok([
        ("What comes", forecast),
        ("What helps", what_if),
        ("What is heard", noise),
    ])
}

/// The report as a page of HTML that loads nothing and prints on A4.
///
/// # Errors
/// [`AnswerError::Plot`].
pub fn report(request: ReportRequest<'_>) -> Result<String, AnswerError> {
    let ReportRequest {
        title,
        site,
        limits,
        rail,
        case,
        forecast,
        posterior_forecast,
        compare,
        noise,
        inputs,
    } = request;
    let mut body = Body::default();
    let (mut map, mut to_grind, mut interval) = (String::new(), None, None);
    let mut diagnosis = Err(NO_ROUGHNESS);
    match rail {
        Some(rail) => {
            let diagnosed = rail.diagnosis.map(|diagnosis| (rail.path, diagnosis));
            diagnosis = diagnosed.ok_or(NO_DIAGNOSIS);
            if let MeasuredRoughness::Profile { answer, .. } = &rail.roughness {
                map = strip_map::strip_map(answer, rail.diagnosis);
                to_grind = Some(answer.line_to_grind().0).filter(|length| *length > 0.0);
            }
            let (own, words) = measured(rail.path, rail.roughness, limits)?;
            body.sections.extend(own);
            body.brief.extend(labelled("How bad, and where", words));
            body.warnings.extend_from_slice(rail.warnings);
        }
        None => body.leave_out(&OF_ROUGHNESS, NO_ROUGHNESS),
    }
    match case {
        Some((case, map)) => {
            body.put_mechanism(case, map, diagnosis)?;
            let remarks = case.remarks.iter().map(ToString::to_string);
            body.warnings.extend(remarks);
            let doubt = doubt(forecast.ok(), compare.ok());
            interval = forecast
                .ok()
                .and_then(ForecastAnswer::months_between_grindings)
                .filter(|_| doubt.is_none());
            if let Some(answer) = posterior_forecast {
                let mut over = outlook::of_answer("Forecast over the calibration", answer)?;
                over.brief = labelled("What comes", over.brief);
                body.put(over);
            }
            let mut outlooks = outlooks(case, forecast, compare, noise)?;
            if posterior_forecast.is_some() {
                // What was calibrated says more than the case as it was.
                outlooks[0].1.brief.clear();
            }
            body.put_outlooks(outlooks, doubt);
        }
        None => body.leave_out(&OF_CASE, NO_CASE),
    }
    let Body {
        mut sections,
        mut brief,
        mut warnings,
    } = body;
    if let (Some(cost), Some(length)) = (&site.cost, to_grind) {
        let words = escape(&cost.words(length, interval));
        brief.extend(labelled("What it costs", vec![words]));
    }
    sections.push(inputs_section(inputs, limits, case.map(|(case, _)| case)));
    // Readings of the roughness warn of the same defects, and vehicles of the same limits at their own
    // frequencies, which stand in brackets.
    let mut known = std::collections::HashSet::new();
    warnings.retain(|warning| {
        let what = warning.split(" (").next().unwrap_or_default();
        known.insert(what.to_owned())
    });
    sections.push(warnings_section(&warnings));
    let head = Head {
        title: title.or(site.title.as_deref()).unwrap_or(TITLE),
        facts: site.facts(),
        remarks: site.remarks.as_deref(),
        brief,
        map,
    };
    Ok(page::page(&head, &sections))
}

/// The sections on the roughness, and sentences for those in a hurry.
fn measured(
    path: &Path,
    roughness: MeasuredRoughness,
    limits: &[LimitTable],
) -> Result<([Section; 5], Vec<String>), PlotError> {
    const TABLE: &str = "the record is a table of levels; it needs a profile.";
    Ok(match roughness {
        MeasuredRoughness::Profile { strips, answer } => {
            let worst = answer.worst().map(|worst| escape(&(capital(&worst) + ".")));
            let verdicts = answer.verdicts().map(roughness::sentence);
            let mut brief: Vec<String> = worst.into_iter().chain(verdicts).collect();
            brief.push(escape(&roughness::total(&answer)));
            let sections = [
                strips.0,
                roughness::moving_rms(&answer)?,
                roughness::spectrum_of_profile(path, &answer, limits)?,
                roughness::bands(&answer, limits),
                roughness::grind(&answer),
            ];
            (sections, brief)
        }
        MeasuredRoughness::Spectra(answer) => {
            let sections = [
                Section::left_out("Profile", TABLE),
                Section::left_out("Moving RMS along the line", TABLE),
                roughness::spectrum_of_means(path, &answer, limits)?,
                Section::left_out("Wavelength bands", TABLE),
                Section::left_out("What to grind", TABLE),
            ];
            let brief = answer.verdicts.iter().map(roughness::sentence);
            (sections, brief.collect())
        }
    })
}

/// What the records say of the course of each dominant wavelength, a sentence each.
fn since(diagnosis: &Diagnosis) -> Vec<String> {
    let findings = diagnosis.findings.iter();
    let courses = findings.filter_map(|finding| Some((finding, finding.measured.course.as_ref()?)));
    courses
        .filter_map(|(finding, course)| {
            let (first, last) = (course.points.first()?, course.points.last()?);
            Some(format!(
                "<b>{:.1} mm</b>, {} to {}: {}.",
                1e3 * finding.measured.peak.wavelength,
                escape(&first.label),
                escape(&last.label),
                escape(&course.words())
            ))
        })
        .collect()
}

/// The dominant wavelengths, a sentence each.
fn dominant(diagnosis: &Diagnosis) -> Vec<String> {
    if diagnosis.findings.is_empty() {
        return vec!["No dominant wavelength stands out of the roughness.".to_owned()];
    }
    let findings = diagnosis.findings.iter();
    findings
        .map(|finding| {
            format!(
                "<b>{:.1} mm</b> stands out{}, {:.1} dB. {}",
                1e3 * finding.measured.peak.wavelength,
                finding
                    .place()
                    .map_or_else(String::new, |place| escape(&format!(" on {place}"))),
                finding.measured.peak.level,
                escape(&capital(&finding.summary()))
            )
        })
        .collect()
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
            (file.wheelset.as_ref()).and_then(|wheelset| wheelset.preset.as_ref()),
        ];
        for preset in names
            .into_iter()
            .flatten()
            .filter_map(|name| riffel_case::preset(name).ok())
        {
            let mut origin: Vec<&str> = preset
                .values
                .iter()
                .map(|value| value.source.text(Language::English))
                .collect();
            origin.dedup();
            sources.push(vec![
                escape(&format!("preset {}", preset.name)),
                escape(preset.title.text(Language::English)),
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
