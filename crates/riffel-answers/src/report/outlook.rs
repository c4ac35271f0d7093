//! Forecast and what-if in a report.

use std::borrow::Cow;

use riffel::forecast::Reach;
use riffel_case::Case;
use riffel_keys::{Language, Message};
use riffel_plot::{LineFigure, PlotError};

use super::page::{Section, escape, figure, list, table};
use crate::compare::{CompareAnswer, Effect, Outcome};
use crate::forecast::{ForecastAnswer, WearReport, number};
use crate::{Answer, capital};

/// A section with a sentence for those in a hurry and what to warn of.
pub(super) struct Outlook {
    pub(super) section: Section,
    pub(super) brief: Vec<String>,
    pub(super) warnings: Vec<String>,
}

impl Outlook {
    /// A section that is not there, with the sentence why.
    pub(super) fn left_out(heading: &'static str, why: impl Into<Cow<'static, str>>) -> Self {
        Self {
            section: Section::left_out(heading, why),
            brief: Vec::new(),
            warnings: Vec::new(),
        }
    }
}

/// An answer as a section: its tables, its sentences, its figure.
pub(super) fn of_answer<A: Answer>(
    heading: &'static str,
    answer: &A,
) -> Result<Outlook, PlotError> {
    let sentence = |message: &Message| format!("{}.", capital(&message.to_string()));
    let mut html = String::new();
    for message in answer.introduction().iter().skip(1) {
        html += &format!("<p>{}</p>\n", escape(&sentence(message)));
    }
    for shown in answer.tables() {
        let (heads, rows) = shown.shown(Language::English);
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let rows = rows.iter();
        let rows: Vec<Vec<String>> = rows
            .map(|row| row.iter().map(|cell| escape(cell)).collect())
            .collect();
        html += &table("", &heads, &rows);
    }
    let sentences: Vec<String> = answer.sentences().iter().map(sentence).collect();
    let brief = sentences.iter().map(|sentence| escape(sentence)).collect();
    html += &list(sentences);
    html += &drawing(answer.figure())?;
    let remarks = answer.remarks().iter();
    Ok(Outlook {
        section: Section::There(heading, html),
        brief,
        warnings: remarks.map(ToString::to_string).collect(),
    })
}

/// What becomes of the spectrum under the traffic.
pub(super) fn forecast(case: &Case, report: &ForecastAnswer) -> Result<Outlook, PlotError> {
    let rows = report
        .rows()
        .into_iter()
        .map(|row| row.iter().map(|cell| escape(cell)).collect());
    let rows: Vec<Vec<String>> = rows.collect();
    let mut header = vec![
        "wavelength [mm]",
        "now [dB]",
        "then [dB]",
        "limit [dB]",
        "growth [dB per 10⁶ passages]",
        "passages to the limit",
        "wheel leaves the rail after",
    ];
    if report.names_rails() {
        header.insert(0, "rail");
    }
    let mut findings = report.findings();
    let wear = report.wear.as_ref();
    findings.extend(
        wear.into_iter()
            .flat_map(|wear| wear.sentences_of_forecast(case)),
    );
    let title = report
        .traffic
        .file
        .title
        .as_deref()
        .unwrap_or("the traffic");
    let from = match &report.ground {
        Some(ground) => format!("; now is after grinding to {}", escape(&ground.words)),
        None => String::new(),
    };
    let mut html = format!(
        "<p>One-third-octave levels under {}{from}; then is after {}.</p>\n",
        escape(title),
        escape(&report.amount(report.passages))
    );
    html += &list(findings.clone());
    html += &drawing(report.figure(case))?;
    html += &table("", &header, &rows);
    let mut warnings = report.warnings.clone();
    warnings.extend(report.on.remarks.iter().map(ToString::to_string));
    if wear.and_then(WearReport::fitted_coefficient).is_none() {
        warnings.push(
            "forecast and what-if: growth rates are proportional to a wear coefficient that is uncertain by a factor of \
             two and more until it is fitted to two dated records (--earlier, --dates)"
                .to_owned(),
        );
    }
    Ok(Outlook {
        section: Section::There("Forecast", html),
        brief: findings
            .first()
            .map(|first| escape(&format!("{}.", capital(first))))
            .into_iter()
            .collect(),
        warnings,
    })
}

/// What would help.
pub(super) fn what_if(case: &Case, report: &CompareAnswer) -> Result<Outlook, PlotError> {
    let rows = report.comparison.outcomes.iter().map(|outcome| {
        let mut row = vec![escape(&outcome.title)];
        row.extend(report.row(outcome).iter().map(|cell| escape(cell)));
        row
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let mut header = vec!["variant"];
    header.extend(report.header());
    let mut limit = String::new();
    if report.leading().is_some() {
        limit = format!("; limit: {}", escape(&report.table.edition));
    }
    if let Some(ground) = &report.ground {
        limit += &format!("; from {}", escape(&ground.words));
    }
    let mut html = format!(
        "<p>The case and its variants at {}{limit}.</p>\n{}",
        escape(&report.speeds),
        table("", &header, &rows),
    );
    let held = report.comparison.outcomes.iter();
    if held.clone().any(|outcome| !outcome.held.is_empty()) {
        html += "<p class=\"small\">Held is what a change of friction or load leaves as it is: the traction force, the \
                 tractive ratio Q₀/μP₀ or the creepage.</p>\n";
    }
    let over = report.over_posterior_in_words();
    let over = over
        .iter()
        .map(|it| format!("{}.", capital(&it.to_string())));
    let over: Vec<String> = over.collect();
    html += &list(report.effects().into_iter().chain(over.iter().cloned()));
    html += &drawing(report.figure(case))?;
    let over = over.iter().map(|sentence| escape(sentence));
    // Draws tell months with their bands.
    let months = months(report).filter(|_| report.over_posterior.is_none());
    let brief = best(report).into_iter().chain(months).chain(over);
    let remarks = report
        .comparison
        .base()
        .remarks
        .iter()
        .map(ToString::to_string);
    Ok(Outlook {
        section: Section::There("What-if", html),
        brief: brief.collect(),
        warnings: report.warnings.iter().cloned().chain(remarks).collect(),
    })
}

/// Which variant lowers growth most, of those that act.
fn best(report: &CompareAnswer) -> Option<String> {
    let base = report.comparison.base();
    let variants = &report.comparison.outcomes[1..];
    if base.fastest.rate <= 0.0 {
        return None;
    }
    let changes = variants
        .iter()
        .filter_map(|outcome| Some((outcome, outcome.change_from(base)?)));
    let Some((best, change)) = changes.min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return Some("None of the variants can act on this case.".to_owned());
    };
    // A change below a hundredth helps nobody.
    let held = match best.held_name() {
        Some(held) if held != "mixed" => format!(" (held: {held})"),
        _ => String::new(),
    };
    let lowers = match change < -0.01 {
        true => format!(
            "Of the variants \u{201c}{}\u{201d} lowers the fastest growth most, by {:.0} %{held}.",
            escape(&best.title),
            -100.0 * change
        ),
        false => format!("None of the variants lowers the fastest growth{held}."),
    };
    let idle: Vec<String> = variants
        .iter()
        .filter(|outcome| !outcome.effect.acts())
        .map(|outcome| format!("\u{201c}{}\u{201d}", escape(&outcome.title)))
        .collect();
    Some(match idle.is_empty() {
        true => lowers,
        false => format!("{lowers} Without any effect: {}.", idle.join(", ")),
    })
}

/// How long the case and each variant take to the limit.
fn months(report: &CompareAnswer) -> Option<String> {
    let edition = escape(&report.table.edition);
    let from = match &report.ground {
        Some(ground) => format!("From {} the", escape(&ground.words)),
        None => "The".to_owned(),
    };
    let base = report.comparison.base();
    if base.reach()? == Reach::After(0.0) {
        let on = base.leading().map(|rail| report.on(rail));
        let on = escape(&on.unwrap_or_default());
        return Some(format!(
            "The limit ({edition}) is passed already{on}; --ground or --from-limit says how long each variant lasts after \
             grinding."
        ));
    }
    let when = |outcome: &Outcome| {
        let title = match outcome.effect {
            Effect::None => "as it is".to_owned(),
            _ => format!("with \u{201c}{}\u{201d}", escape(&outcome.title)),
        };
        let on = outcome.leading().map(|rail| report.on(rail));
        let on = escape(&on.unwrap_or_default());
        Some(match outcome.reach()? {
            Reach::After(passages) => {
                let tonnes = format!("{} MGT", number(outcome.growth.mgt(passages)));
                let time = outcome.months_to_limit();
                let time = time.map_or(tonnes, |months| format!("{} months", number(months)));
                format!("after {time} {title}{on}")
            }
            Reach::BeyondLinearRange => {
                format!("not before the wheel leaves the rail {title}{on}")
            }
            Reach::Never => format!("never {title}"),
        })
    };
    let times: Vec<String> = report.comparison.outcomes.iter().filter_map(when).collect();
    Some(format!(
        "{from} limit ({edition}) is reached {}.",
        times.join("; ")
    ))
}

/// A figure of the program with its caption below.
pub(super) fn drawing(drawing: LineFigure) -> Result<String, PlotError> {
    let caption = drawing.caption.clone();
    let drawing = LineFigure {
        title: String::new(),
        caption: String::new(),
        ..drawing
    };
    Ok(figure("half", &drawing.picture()?, &caption))
}
