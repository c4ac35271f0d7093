//! Forecast and what-if in a report.

use riffel::forecast::Reach;
use riffel_case::Case;
use riffel_keys::{Language, Message, Value, fixed, say};
use riffel_plot::{LineFigure, PlotError};

use super::page::{Section, cells, figure, list, said, sentence, table, table_of};
use crate::Answer;
use crate::compare::{CompareAnswer, Effect, Outcome, held_in_words, outcomes};
use crate::forecast::{TrackForecast, WearReport, number};

/// A section with a sentence for those in a hurry and what to warn of.
pub(super) struct Outlook {
    pub(super) section: Section,
    pub(super) brief: Vec<String>,
    pub(super) warnings: Vec<Message>,
}

impl Outlook {
    /// A section that is not there, with the sentence why.
    pub(super) fn left_out(heading: Message, why: Message) -> Self {
        Self { section: Section::LeftOut(heading, why), brief: Vec::new(), warnings: Vec::new() }
    }
}

/// An answer as a section: its tables, its sentences, its figure.
pub(super) fn of_answer<A: Answer>(
    heading: Message,
    answer: &A,
    figure: LineFigure,
    language: Language,
) -> Result<Outlook, PlotError> {
    let mut html = String::new();
    for message in answer.introduction().iter().skip(1) {
        html += &format!("<p>{}</p>\n", sentence(message, language));
    }
    for shown in answer.tables() {
        html += &table_of(&shown, language);
    }
    let sentences = answer.sentences();
    let brief: Vec<String> = (sentences.iter()).map(|message| sentence(message, language)).collect();
    html += &list(brief.iter().cloned());
    html += &drawing(figure, language)?;
    Ok(Outlook { section: Section::There(heading, html), brief, warnings: answer.remarks().to_vec() })
}

/// What becomes of the spectrum under the traffic.
pub(super) fn forecast(case: &Case, report: &TrackForecast, language: Language) -> Result<Outlook, PlotError> {
    let mut findings = report.findings();
    let wear = report.wear.as_ref();
    let of_wear = wear.into_iter();
    findings.extend(of_wear.flat_map(|wear| wear.sentences_of_forecast(case)));
    let title = report.traffic.file.title.as_deref();
    let title = title.map_or_else(|| say!(the_traffic), Message::verbatim);
    let amount = report.amount(report.passages);
    let introduction = match &report.ground {
        Some(ground) => say!(levels_after_grinding, traffic = title, ground = ground.words.clone(), amount),
        None => say!(levels_under_traffic, traffic = title, amount),
    };
    let mut html = format!("<p>{}</p>\n", sentence(&introduction, language));
    html += &list(findings.iter().map(|finding| said(finding, language)));
    html += &drawing(report.figure(case, language), language)?;
    html += &table_of(&report.table(), language);
    let mut warnings = report.warnings.clone();
    warnings.extend(report.on.remarks.iter().cloned());
    if wear.and_then(WearReport::fitted_coefficient).is_none() {
        warnings.push(say!(growth_is_uncertain));
    }
    // Sections are worse than the mean that is forecast.
    let own = report.first_said();
    let interval = findings.get(own.len());
    let first = interval.map(|first| match &report.ground {
        Some(_) => first.clone(),
        None => say!(mean_over_the_record, sentence = first),
    });
    let brief = own.into_iter().chain(first).chain(report.months_within());
    Ok(Outlook {
        section: Section::There(say!(forecast), html),
        brief: brief.map(|message| sentence(&message, language)).collect(),
        warnings,
    })
}

/// What would help.
pub(super) fn what_if(report: &CompareAnswer, language: Language) -> Result<Outlook, PlotError> {
    let (mut heads, rows) = cells(&outcomes(report), language);
    heads[0] = say!(variant_head).text(language);
    let mut introduction = say!(case_and_variants, speeds = report.speeds.clone());
    if report.leading().is_some() {
        let limit = say!(limit_is, edition = &report.table.edition);
        introduction = say!(one_after_other, one = introduction, other = limit);
    }
    if let Some(ground) = &report.ground {
        let from = say!(from_ground, ground = ground.words.clone());
        introduction = say!(one_after_other, one = introduction, other = from);
    }
    let mut html = format!("<p>{}</p>\n{}", sentence(&introduction, language), table("", &heads, &rows),);
    let mut outcomes = report.comparison.outcomes.iter();
    if outcomes.any(|outcome| !outcome.held.is_empty()) {
        let held = sentence(&say!(held_is), language);
        html += &format!("<p class=\"small\">{held}</p>\n");
    }
    let over = report.over_posterior_in_words();
    let over: Vec<String> = over.iter().map(|it| sentence(it, language)).collect();
    let first = report.first_said();
    let effects = report.effects();
    let effects = first.iter().chain(&effects).map(|effect| said(effect, language));
    html += &list(effects.chain(over.iter().cloned()));
    html += &drawing(report.figure_in(language), language)?;
    // Draws tell months with their bands.
    let months = months(report).filter(|_| report.over_posterior.is_none());
    let best: Vec<String> = (best(report).iter()).map(|it| sentence(it, language)).collect();
    let best = (!best.is_empty()).then(|| best.join(" "));
    let months = months.map(|months| sentence(&months, language));
    let remarks = report.comparison.base().remarks.iter();
    Ok(Outlook {
        section: Section::There(say!(what_if), html),
        brief: best.into_iter().chain(months).chain(over).collect(),
        warnings: report.warnings.iter().chain(remarks).cloned().collect(),
    })
}

/// Which variant lowers growth most, of those that act, and which have no effect.
fn best(report: &CompareAnswer) -> Vec<Message> {
    let base = report.comparison.base();
    let variants = &report.comparison.outcomes[1..];
    if base.fastest.rate <= 0.0 {
        return Vec::new();
    }
    let changes = variants.iter().filter_map(|outcome| Some((outcome, outcome.change_from(base)?)));
    let Some((best, change)) = changes.min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return vec![say!(no_variant_can_act)];
    };
    // A change below a hundredth helps nobody.
    let lowers = match change < -0.01 {
        true => say!(variant_lowers_most, title = &best.title, percent = fixed(-100.0 * change, 0)),
        false => say!(no_variant_lowers),
    };
    let held = best.held.first().filter(|_| best.held.len() == 1);
    let lowers = match held {
        Some(held) => say!(with_held, sentence = lowers, held = held_in_words(*held)),
        None => lowers,
    };
    let idle = variants.iter().filter(|outcome| !outcome.effect.acts());
    let idle: Vec<Message> = idle.map(|outcome| say!(in_quotes, words = &outcome.title)).collect();
    let mut sentences = vec![lowers];
    if !idle.is_empty() {
        let titles: Value = idle.into_iter().collect();
        sentences.push(say!(without_any_effect, titles));
    }
    sentences
}

/// How long the case and each variant take to the limit.
fn months(report: &CompareAnswer) -> Option<Message> {
    let edition = &report.table.edition;
    let base = report.comparison.base();
    if base.reach()? == Reach::After(0.0) {
        let rail = base.leading().and_then(|rail| report.rail(rail));
        return Some(match rail {
            Some(rail) => say!(limit_is_passed_on, edition, rail),
            None => say!(limit_is_passed, edition),
        });
    }
    let when = |outcome: &Outcome| {
        let title = match outcome.effect {
            Effect::None => say!(as_it_is),
            _ => say!(with_variant, title = &outcome.title),
        };
        let time = match outcome.reach()? {
            Reach::After(passages) => {
                let tonnes = || say!(gross_tonnes, tonnes = number(outcome.growth.mgt(passages)));
                let months = outcome.months_to_limit();
                let months = months.map(|months| say!(months_of, months = number(months)));
                say!(reached_after, time = months.unwrap_or_else(tonnes), variant = title)
            }
            Reach::BeyondLinearRange => say!(reached_beyond_linear_range, variant = title),
            Reach::Never => return Some(say!(never_reached, variant = title)),
        };
        let rail = outcome.leading().and_then(|rail| report.rail(rail));
        Some(match rail {
            Some(rail) => say!(on_rail, sentence = time, rail),
            None => time,
        })
    };
    let times = report.comparison.outcomes.iter().filter_map(when);
    let times = times.reduce(Message::followed_by)?;
    Some(match &report.ground {
        Some(ground) => say!(limit_is_reached_from, ground = ground.words.clone(), edition, times),
        None => say!(limit_is_reached, edition, times),
    })
}

/// A figure of the program with its caption below.
pub(super) fn drawing(drawing: LineFigure, language: Language) -> Result<String, PlotError> {
    let caption = drawing.caption.clone();
    let drawing = LineFigure { title: String::new(), caption: String::new(), ..drawing };
    Ok(figure("half", drawing.picture()?, &caption, language))
}
