//! Forecast and what-if in a report.

use std::path::{Path, PathBuf};

use riffel_case::roughness::Survey;
use riffel_plot::LineFigure;

use super::page::{Section, escape, figure, list, table};
use crate::arguments::{CaseArguments, Compare, Forecast, Horizon, Layout, Spectra};
use crate::command::forecast::{number, per_million, when};
use crate::command::{compare, forecast};
use crate::error::CliError;

/// What the record says of now.
pub(super) struct Now<'a> {
    /// The file.
    pub(super) path: &'a Path,
    /// Traffic file, if one is given.
    pub(super) traffic: Option<&'a Path>,
    /// Its spectra.
    pub(super) survey: Survey,
    pub(super) date: Option<jiff::civil::Date>,
    /// Mean speed of the traffic \[m/s\].
    pub(super) speed: f64,
}

/// A section with a sentence for those in a hurry and what to warn of.
pub(super) struct Outlook {
    pub(super) section: Section,
    pub(super) brief: Vec<String>,
    pub(super) warnings: Vec<String>,
}

impl Outlook {
    /// A section that is not there, with the sentence why.
    pub(super) fn left_out(heading: &'static str, why: &'static str) -> Self {
        Self {
            section: Section::LeftOut(heading, why),
            brief: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Put everything in its place.
    pub(super) fn put(
        self,
        sections: &mut Vec<Section>,
        brief: &mut Vec<String>,
        warnings: &mut Vec<String>,
    ) {
        sections.push(self.section);
        brief.extend(self.brief);
        warnings.extend(self.warnings);
    }
}

/// What becomes of the spectrum under the traffic.
pub(super) fn forecast(
    case: CaseArguments,
    traffic: PathBuf,
    limit: String,
    now: &Now<'_>,
    months: Option<f64>,
) -> miette::Result<Outlook> {
    let forecast = Forecast {
        case,
        spectra: Spectra {
            spectrum: now.path.to_owned(),
            layout: Layout::default(),
            choose: Vec::new(),
            date_column: None,
            earlier: None,
            earlier_choose: Vec::new(),
            passages_between: None,
        },
        traffic,
        limit,
        horizon: Horizon {
            passages: None,
            mgt: None,
            months,
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
    variants: Vec<PathBuf>,
    limit: String,
    now: Option<&Now<'_>>,
) -> miette::Result<Outlook> {
    let traffic = now.and_then(|now| now.traffic.map(Path::to_owned));
    let compare = Compare {
        case,
        variants,
        speed: now
            .filter(|_| traffic.is_none())
            .map(|now| riffel_case::quantity::Quantity::new(now.speed)),
        speed_deviation: None,
        traffic,
        spectrum: now.map(|now| now.path.to_owned()),
        layout: Layout::default(),
        choose: Vec::new(),
        limit,
        output: None,
        json: false,
    };
    let report = compare::Report::new(&compare, now.map(|now| now.survey.clone()))?;
    let base = report.comparison.base();
    let rows: Vec<Vec<String>> = report
        .comparison
        .outcomes
        .iter()
        .map(|outcome| {
            let change = 100.0 * (outcome.fastest.rate / base.fastest.rate - 1.0);
            let changes = base.fastest.rate > 0.0 && !std::ptr::eq(outcome, base);
            let mut row = vec![
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
            ];
            if now.is_some() {
                row.push(when(outcome.passages_to_limit));
                row.push(
                    outcome
                        .passages_to_limit
                        .map_or_else(String::new, |passages| number(outcome.growth.mgt(passages))),
                );
            }
            row
        })
        .collect();
    let mut header = vec![
        "variant",
        "fastest [mm]",
        "growth [dB per 10⁶ passages]",
        "change",
        "ridge [Hz]",
    ];
    let mut limit = String::new();
    if now.is_some() {
        header.extend(["passages to the limit", "MGT to the limit"]);
        limit = format!("; limit: {}", escape(&report.table.edition));
    }
    let html = format!(
        "<p>The case and its variants at {}{limit}.</p>\n{}{}",
        escape(&report.speeds),
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
