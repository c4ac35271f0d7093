//! Forecast and what-if in a report.

use std::path::PathBuf;

use riffel_case::roughness::Survey;
use riffel_plot::LineFigure;

use super::page::{Section, escape, figure, list, table};
use crate::arguments::{
    CaseArguments, Compare, Forecast, Horizon, Layout, Report as Arguments, Spectra,
};
use crate::command::forecast::{number, per_million, when};
use crate::command::{compare, forecast};
use crate::error::CliError;

/// What the record says of now.
pub(super) struct Now {
    /// Its spectra.
    pub(super) survey: Survey,
    pub(super) date: Option<jiff::civil::Date>,
    /// Limit of the levels.
    pub(super) limit: String,
    /// Mean speed of the traffic \[m/s\].
    pub(super) speed: f64,
}

/// A section with a sentence for those in a hurry and what to warn of.
pub(super) struct Outlook {
    pub(super) section: Section,
    pub(super) brief: Vec<String>,
    pub(super) warnings: Vec<String>,
}

/// What becomes of the spectrum under the traffic.
pub(super) fn forecast(
    case: CaseArguments,
    traffic: PathBuf,
    now: &Now,
    arguments: &Arguments,
) -> miette::Result<Outlook> {
    let forecast = Forecast {
        case,
        spectra: Spectra {
            spectrum: arguments.record.roughness.clone(),
            layout: Layout::default(),
            choose: Vec::new(),
            date_column: None,
            earlier: None,
            earlier_choose: Vec::new(),
            passages_between: None,
        },
        traffic,
        limit: now.limit.clone(),
        horizon: Horizon {
            passages: None,
            mgt: None,
            months: arguments.months,
        },
        date: now.date,
        output: None,
        json: false,
    };
    let report = forecast::Report::new(&forecast, now.survey.clone())?;
    let limits = report.forecast.passages_to(&report.limit);
    let rows: Vec<Vec<String>> = report
        .forecast
        .bands()
        .iter()
        .rev()
        .map(|band| {
            let limit = limits.iter().find(|limit| limit.0 == band);
            let linear = report.forecast.linear_range([band]);
            vec![
                format!("{}", band.now.band.nominal_millimetres()),
                format!("{:.1}", band.now.level),
                format!("{:.1}", band.level(report.passages)),
                limit.map_or_else(String::new, |limit| format!("{:.1}", limit.1)),
                format!("{:+.3}", per_million(report.forecast.growth_rate(band))),
                limit.map_or_else(String::new, |limit| when(limit.2)),
                when(linear.passages),
            ]
        })
        .collect();
    let header = [
        "wavelength [mm]",
        "now [dB]",
        "then [dB]",
        "limit [dB]",
        "growth [dB per 10⁶ passages]",
        "passages to the limit",
        "wheel leaves the rail after",
    ];
    let findings = report.findings();
    let title = report
        .traffic
        .file
        .title
        .as_deref()
        .unwrap_or("the traffic");
    let mut html = format!(
        "<p>{} under {}: then is after {}.</p>\n",
        "One-third-octave levels",
        escape(title),
        escape(&report.amount(report.passages))
    );
    html += &list(findings.clone());
    html += &drawing(report.figure())?;
    html += &table("", &header, &rows);
    let mut warnings = report.survey.warnings.clone();
    warnings.extend(report.on.remarks.iter().cloned());
    warnings.push(
        "forecast and what-if: growth rates are proportional to a wear coefficient that is uncertain by a factor of two \
         and more until it is fitted to two dated records (riffel forecast --earlier)"
            .to_owned(),
    );
    Ok(Outlook {
        section: Section::There("Forecast", html),
        brief: findings
            .first()
            .map(|first| escape(&capital(first)))
            .into_iter()
            .collect(),
        warnings,
    })
}

/// What would help.
pub(super) fn what_if(
    case: CaseArguments,
    now: &Now,
    arguments: &Arguments,
) -> miette::Result<Outlook> {
    let traffic = arguments.record.traffic.clone();
    let compare = Compare {
        case,
        variants: arguments.variants.clone(),
        speed: traffic
            .is_none()
            .then(|| riffel_case::quantity::Quantity::new(now.speed)),
        speed_deviation: None,
        traffic,
        spectrum: Some(arguments.record.roughness.clone()),
        layout: Layout::default(),
        choose: Vec::new(),
        limit: now.limit.clone(),
        output: None,
        json: false,
    };
    let report = compare::Report::new(&compare, Some(now.survey.clone()))?;
    let base = report.comparison.base();
    let rows: Vec<Vec<String>> = report
        .comparison
        .outcomes
        .iter()
        .map(|outcome| {
            let change = 100.0 * (outcome.fastest.rate / base.fastest.rate - 1.0);
            let changes = base.fastest.rate > 0.0 && !std::ptr::eq(outcome, base);
            vec![
                escape(&outcome.title),
                format!("{:.1}", 1e3 * outcome.fastest.wavelength),
                format!("{:+.3}", per_million(outcome.fastest.rate)),
                if changes {
                    format!("{change:+.0} %")
                } else {
                    String::new()
                },
                outcome
                    .ridge_frequency
                    .map_or_else(String::new, |f| format!("{f:.0}")),
                when(outcome.passages_to_limit),
                outcome
                    .passages_to_limit
                    .map_or_else(String::new, |passages| number(outcome.growth.mgt(passages))),
            ]
        })
        .collect();
    let header = [
        "variant",
        "fastest [mm]",
        "growth [dB per 10⁶ passages]",
        "change",
        "ridge [Hz]",
        "passages to the limit",
        "MGT to the limit",
    ];
    let html = format!(
        "<p>The case and its variants at {}; limit: {}.</p>\n{}{}",
        escape(&report.speeds),
        escape(&report.table.edition),
        table("", &header, &rows),
        drawing(report.figure())?
    );
    let best = report
        .comparison
        .outcomes
        .iter()
        .skip(1)
        .min_by(|a, b| a.fastest.rate.total_cmp(&b.fastest.rate));
    // A change below a hundredth helps nobody.
    let brief = best.filter(|_| base.fastest.rate > 0.0).map(|best| {
        match best.fastest.rate / base.fastest.rate - 1.0 {
            change if change < -0.01 => format!(
                "Of the variants \u{201c}{}\u{201d} lowers the fastest growth most, by {:.0} %.",
                escape(&best.title),
                -100.0 * change
            ),
            _ => "None of the variants lowers the fastest growth.".to_owned(),
        }
    });
    Ok(Outlook {
        section: Section::There("What-if", html),
        brief: brief.into_iter().collect(),
        warnings: base.remarks.clone(),
    })
}

/// A figure of the program with its caption below.
fn drawing(drawing: LineFigure) -> Result<String, CliError> {
    let caption = drawing.caption.clone();
    let drawing = LineFigure {
        title: String::new(),
        caption: String::new(),
        ..drawing
    };
    Ok(figure("half", &drawing.svg()?, &caption))
}

fn capital(words: &str) -> String {
    crate::command::diagnose::capital(words) + "."
}
