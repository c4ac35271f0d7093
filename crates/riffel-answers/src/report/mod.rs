//! The report of a rail: other answers on one printable page.

mod grinding_cost;
mod inputs;
mod measured;
mod mechanism;
mod noise;
mod outlook;
mod page;
mod question;
mod roughness;
mod site;
mod strip_map;
mod working;

use std::path::Path;

use riffel_case::Case;
use riffel_case::traffic::is_of_reported_growth;
use riffel_keys::{Language, Message, Value, fixed, say};
use riffel_plot::PlotError;
use riffel_rail::{LimitTable, Record};

pub use inputs::Inputs;
use page::GENERATOR;
pub use question::ReportQuestion;
use roughness::block_of_strip;
pub use site::Site;

use crate::Result;
use crate::compare::CompareAnswer;
use crate::diagnose::{Diagnosis, Finding, course_in_words};
use crate::forecast::{PosteriorForecast, TrackForecast};
use crate::map::MapAnswer;
use crate::noise::NoiseAnswer;
use crate::roughness::{ProfileAnswer, SpectraAnswer, Verdict};
use outlook::Outlook;
use page::{Head, Section, bold, escape, said, sentence, texts};

/// Headings of the sections on the roughness.
fn of_roughness() -> [Message; 5] {
    [
        say!(profile),
        say!(moving_rms_along_the_line),
        say!(spectrum_and_limits),
        say!(wavelength_bands),
        say!(what_to_grind),
    ]
}

/// Headings of the sections on the case.
fn of_case() -> [Message; 5] {
    [say!(growth_map), say!(diagnosis), say!(forecast), say!(what_if), say!(rolling_noise)]
}

/// What the report says of the roughness of a rail.
pub struct MeasuredRail<'a> {
    /// The file.
    pub path: &'a Path,
    /// What was computed of it.
    pub roughness: MeasuredRoughness,
    /// What was put right in the records.
    pub warnings: &'a [Message],
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
    pub fn new(record: &Record, language: Language) -> Result<Self, PlotError> {
        roughness::strips(record, language).map(Self)
    }
}

/// What a report is made of.
pub struct ReportRequest<'a> {
    /// The language of its sentences.
    pub language: Language,
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
    pub forecast: Result<&'a TrackForecast, Message>,
    /// What becomes of the rail of a calibration, if there is one.
    pub posterior_forecast: Option<&'a PosteriorForecast>,
    /// What would help, or why that is left out.
    pub compare: Result<&'a CompareAnswer, Message>,
    /// What a train sounds like, or why that is left out.
    pub noise: Result<&'a NoiseAnswer, Message>,
    /// The files that went into it.
    pub inputs: &'a Inputs,
}

/// Sentences in brief under a label.
fn labelled(label: &Message, mut sentences: Vec<String>, language: Language) -> Vec<String> {
    if let Some(first) = sentences.first_mut() {
        *first = format!("<b>{}:</b> {first}", said(label, language));
    }
    sentences
}

/// Why growth under the traffic is not to be believed, if it is not.
fn doubt(forecast: Option<&TrackForecast>, compare: Option<&CompareAnswer>) -> Option<Message> {
    let remarks = forecast.into_iter().flat_map(|answer| &answer.on.remarks);
    let of_compare = compare.into_iter();
    let of_compare = of_compare.flat_map(|answer| &answer.comparison.base().remarks);
    let mut remarks = remarks.chain(of_compare);
    remarks.find(|remark| is_of_reported_growth(remark)).cloned()
}

/// What fills the page below its head: sections, sentences for those in a hurry, and warnings.
#[derive(Default)]
struct Body {
    language: Language,
    sections: Vec<Section>,
    brief: Vec<String>,
    warnings: Vec<Message>,
}

impl Body {
    fn leave_out(&mut self, headings: [Message; 5], why: &Message) {
        let sections = headings.into_iter();
        self.sections.extend(sections.map(|heading| Section::LeftOut(heading, why.clone())));
    }

    fn put_brief(&mut self, label: &Message, sentences: Vec<String>) {
        self.brief.extend(labelled(label, sentences, self.language));
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
        diagnosis: Result<&Diagnosis, Message>,
    ) -> Result<(), PlotError> {
        let language = self.language;
        let found = diagnosis.as_ref().ok().copied();
        let map = mechanism::growth_map(case, map, found, language)?;
        match diagnosis {
            // What the map says in brief, the diagnosis says of the wavelengths that were measured.
            Ok(diagnosis) => {
                self.sections.push(map.section);
                let section = mechanism::diagnosis(diagnosis, language)?;
                self.sections.push(section);
                self.put_brief(&say!(since_when), since(diagnosis, language));
                self.put_brief(&say!(why_and_how_sure), dominant(diagnosis, language));
                self.warnings.extend(diagnosis.warnings.iter().cloned());
            }
            Err(why) => {
                self.put(map);
                self.sections.push(Section::LeftOut(say!(diagnosis), why));
            }
        }
        Ok(())
    }

    /// What comes, what helps and what is heard, with a doubt of the growth they follow from.
    fn put_outlooks(&mut self, outlooks: [(Message, Outlook); 3], doubt: Option<&Message>) {
        for (label, mut outlook) in outlooks {
            outlook.brief = labelled(&label, outlook.brief, self.language);
            // No dates of a growth that nobody has seen.
            if doubt.is_some() {
                outlook.brief.clear();
            }
            self.put(outlook);
        }
        let doubt = doubt.map(|doubt| {
            let sentences = [doubt, &say!(no_dates_are_told)].map(|one| sentence(one, self.language));
            let label = said(&say!(not_plausible), self.language);
            format!("<b>{label}:</b> {}", sentences.join(" "))
        });
        self.brief.splice(0..0, doubt);
    }
}

/// What comes, what helps and what is heard, each under its label; or why one of them is left out.
fn outlooks(
    case: &Case,
    forecast: Result<&TrackForecast, Message>,
    compare: Result<&CompareAnswer, Message>,
    noise: Result<&NoiseAnswer, Message>,
    language: Language,
) -> Result<[(Message, Outlook); 3], PlotError> {
    let is_unexplained = forecast.as_ref().is_ok_and(|answer| !answer.unexplained().is_empty());
    let forecast = match forecast {
        Ok(answer) => outlook::forecast(case, answer, language)?,
        Err(why) => Outlook::left_out(say!(forecast), why),
    };
    let mut what_if = match compare {
        Ok(answer) => outlook::what_if(answer, language)?,
        Err(why) => Outlook::left_out(say!(what_if), why),
    };
    let noise = match noise {
        Ok(answer) => noise::outlook(case, answer, language)?,
        Err(why) => Outlook::left_out(say!(rolling_noise), why),
    };
    // Where growth goes by what was measured, the case knows nothing of what its variants would do to it.
    if is_unexplained {
        what_if.brief = vec![sentence(&say!(model_does_not_explain_growth), language)];
    }
    Ok([(say!(what_comes), forecast), (say!(what_helps), what_if), (say!(what_is_heard), noise)])
}

/// The report as a page of HTML that loads nothing and prints on A4.
///
/// # Errors
/// [`AnswerError::Plot`](crate::AnswerError::Plot).
pub fn report(request: ReportRequest<'_>) -> Result<String> {
    let ReportRequest {
        language,
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
    let mut body = Body { language, ..Body::default() };
    let (mut map, mut to_grind, mut interval) = (String::new(), None, None);
    let mut diagnosis = Err(say!(no_roughness_given));
    match rail {
        Some(rail) => {
            diagnosis = rail.diagnosis.ok_or_else(|| say!(roughness_not_diagnosed));
            if let MeasuredRoughness::Profile { answer, .. } = &rail.roughness {
                map = strip_map::strip_map(answer, rail.diagnosis, language);
                to_grind = Some(answer.grind.total_m).filter(|length| *length > 0.0);
            }
            let (own, words) = measured(rail.roughness, limits, language)?;
            body.sections.extend(own);
            body.put_brief(&say!(how_bad_and_where), words);
            body.warnings.extend_from_slice(rail.warnings);
        }
        None => body.leave_out(of_roughness(), &say!(no_roughness_given)),
    }
    match case {
        Some((case, map)) => {
            body.put_mechanism(case, map, diagnosis)?;
            body.warnings.extend(case.remarks.iter().cloned());
            let (forecasted, compared) = (forecast.as_ref().ok(), compare.as_ref().ok());
            let doubt = doubt(forecasted.copied(), compared.copied());
            interval = forecasted.and_then(|answer| answer.months_between_grindings()).filter(|_| doubt.is_none());
            if let Some(answer) = posterior_forecast {
                let (heading, figure) = (say!(forecast_over_calibration), answer.figure_in(language));
                let mut over = outlook::of_answer(heading, answer, figure, language)?;
                over.brief = labelled(&say!(what_comes), over.brief, language);
                body.put(over);
            }
            let mut outlooks = outlooks(case, forecast, compare, noise, language)?;
            if posterior_forecast.is_some() {
                // What was calibrated says more than the case as it was.
                outlooks[0].1.brief.clear();
            }
            body.put_outlooks(outlooks, doubt.as_ref());
        }
        None => body.leave_out(of_case(), &say!(no_case_given)),
    }
    if let (Some(cost), Some(length)) = (&site.cost, to_grind) {
        let words = sentence(&cost.words(length, interval), language);
        body.put_brief(&say!(what_it_costs), vec![words]);
    }
    let inputs = inputs_section(inputs, limits, case.map(|(case, _)| case), language);
    body.sections.push(inputs);
    body.sections.push(warnings_section(&body.warnings, language));
    let head = Head {
        title: (title.or(site.title.as_deref()))
            .map_or_else(|| say!(rail_roughness_and_corrugation).text(language), str::to_owned),
        facts: site.facts(),
        remarks: site.remarks.as_deref(),
        brief: body.brief,
        map,
    };
    Ok(page::page(&head, &body.sections, language))
}

/// The sections on the roughness, and sentences for those in a hurry.
fn measured(
    roughness: MeasuredRoughness,
    limits: &[LimitTable],
    language: Language,
) -> Result<([Section; 5], Vec<String>), PlotError> {
    let marked = |verdict: &Verdict| roughness::marked(verdict, language);
    Ok(match roughness {
        MeasuredRoughness::Profile { strips, answer } => {
            let worst = answer.worst();
            let worst = worst.map(|worst| sentence(&worst, language));
            let total = roughness::total(&answer);
            let total: Vec<String> = total.iter().map(|one| sentence(one, language)).collect();
            let verdicts = answer.verdicts.iter().map(marked);
            let brief = worst.into_iter().chain(verdicts).chain([total.join(" ")]);
            let brief = brief.collect();
            let sections = [
                strips.0,
                roughness::moving_rms(&answer, language)?,
                roughness::spectrum_of_profile(&answer, limits, language)?,
                roughness::bands(&answer, limits, language),
                roughness::grind(&answer, language),
            ];
            (sections, brief)
        }
        MeasuredRoughness::Spectra(answer) => {
            let mut sections = of_roughness().map(|heading| Section::LeftOut(heading, say!(levels_are_no_profile)));
            sections[2] = roughness::spectrum_of_means(&answer, limits, language)?;
            let brief = answer.verdicts_of_now().iter().map(marked);
            (sections, brief.collect())
        }
    })
}

/// What the records say of the course of each dominant wavelength, a sentence each.
fn since(diagnosis: &Diagnosis, language: Language) -> Vec<String> {
    let findings = diagnosis.findings.iter();
    let findings = findings.filter(|finding| finding.sideband.is_none());
    let courses = findings.filter_map(|finding| Some((finding, finding.measured.course.as_ref()?)));
    courses
        .filter_map(|(finding, course)| {
            let (first, last) = (course.points.first()?, course.points.last()?);
            let wavelength = wavelength_of(finding);
            let said = say!(
                course_of_wavelength,
                wavelength = wavelength.clone(),
                first = &first.label,
                last = &last.label,
                course = course_in_words(course)
            );
            Some(bold(&sentence(&said, language), &wavelength.text(language)))
        })
        .collect()
}

fn wavelength_of(finding: &Finding) -> Message {
    let wavelength = fixed(1e3 * finding.measured.peak.wavelength, 1);
    say!(one_wavelength, wavelength)
}

/// The dominant wavelengths, a sentence each; sidebands are told with their wave.
fn dominant(diagnosis: &Diagnosis, language: Language) -> Vec<String> {
    if diagnosis.findings.is_empty() {
        return vec![sentence(&say!(no_wavelength_stands_out), language)];
    }
    let findings = || diagnosis.findings.iter();
    findings()
        .filter(|finding| finding.sideband.is_none())
        .map(|finding| {
            let wavelength = wavelength_of(finding);
            let own = |other: &&Finding| {
                let of = other.sideband.map(|sideband| sideband.of);
                let rail = &finding.measured.rail;
                of == Some(finding.measured.peak.wavelength) && other.measured.rail == *rail
            };
            let beside: Vec<Message> = findings().filter(own).map(wavelength_of).collect();
            let level = fixed(finding.measured.peak.level, 1);
            let stands = match finding.place() {
                Some(place) => {
                    say!(wavelength_stands_out_at, wavelength = wavelength.clone(), place, level)
                }
                None => say!(wavelength_stands_out, wavelength = wavelength.clone(), level),
            };
            let stands = bold(&sentence(&stands, language), &wavelength.text(language));
            let mut summary = finding.summary();
            if !beside.is_empty() {
                let count = beside.len();
                let wavelengths: Value = beside.into_iter().collect();
                let told = say!(beside_stand, count, wavelengths);
                summary = say!(two_sentences, one = told, other = summary);
            }
            format!("{stands} {}", escape(&summary.capitalised(language)))
        })
        .collect()
}

/// Files, limit tables and presets with their origin, and what made the report.
fn inputs_section(inputs: &Inputs, limits: &[LimitTable], case: Option<&Case>, language: Language) -> Section {
    let row = |name: Message, title: &str, source: &str| vec![said(&name, language), escape(title), escape(source)];
    let limits = limits.iter().map(|table| {
        let name = say!(limit_of_name, name = &table.name);
        row(name, &table.edition, &table.source)
    });
    let mut sources: Vec<Vec<String>> = limits.collect();
    if let Some(case) = case {
        let file = &case.file;
        let names = [
            file.vehicle.as_ref(),
            file.rail.section.as_ref(),
            file.track.preset.as_ref(),
            (file.wheelset.as_ref()).and_then(|wheelset| wheelset.preset.as_ref()),
        ];
        let names = names.into_iter().flatten();
        for preset in names.filter_map(|name| riffel_case::preset(name).ok()) {
            let origin = preset.values.first().map(|value| value.source.text(language));
            let name = say!(preset_of_name, name = &preset.name);
            sources.push(row(name, &preset.title.text(language), &origin.unwrap_or_default()));
        }
    }
    let heads = [say!(built_in_head), say!(what_it_is_head), say!(source_head)];
    let made_by = say!(made_by, version = env!("CARGO_PKG_VERSION"));
    let html = format!(
        "{}{}<p class=\"small\">{}</p>\n",
        inputs.html(language),
        page::table("words", &texts(heads, language), &sources),
        sentence(&made_by, language)
    );
    Section::There(say!(inputs_and_versions), html)
}

/// Warnings, each once: readings of the roughness warn of the same defects, and vehicles of the same limits at their own
/// frequencies, which stand in brackets.
fn warnings_section(warnings: &[Message], language: Language) -> Section {
    let mut known = std::collections::HashSet::new();
    let warnings = warnings.iter().map(|warning| said(warning, language));
    let warnings: Vec<String> = warnings
        .filter(|warning| {
            let what = warning.split(" (").next().unwrap_or_default();
            known.insert(what.to_owned())
        })
        .collect();
    let html = match warnings.is_empty() {
        true => format!("<p>{}</p>\n", sentence(&say!(no_warnings), language)),
        false => page::list(warnings),
    };
    Section::There(say!(warnings_and_limits_of_models), html)
}
