//! `compare --json` and the tables.

use std::io::{self, Write};

use riffel_case::what_if::Outcome;
use serde::Serialize;

use super::{Report, months_to_limit};
use crate::command::roughness::document::{Level, levels};

#[derive(Serialize)]
pub(super) struct Document<'a> {
    riffel_version: &'static str,
    case: &'a riffel_case::file::CaseFile,
    speeds: &'a str,
    spectrum_now: Option<Vec<Level>>,
    limit: Option<&'a str>,
    /// The case as it is first.
    outcomes: Vec<OutcomeDocument<'a>>,
}

#[derive(Serialize)]
struct OutcomeDocument<'a> {
    title: &'a str,
    fastest_wavelength_m: f64,
    fastest_growth_rate_per_passage: f64,
    /// It sits at the end of the bands: another wavelength may grow faster.
    fastest_at_edge: bool,
    /// Relative to the case as it is; null where that does not grow.
    change_of_fastest_growth: Option<f64>,
    ridge_frequency_hz: Option<f64>,
    ridge_highest: Option<RidgeDocument>,
    growth_rate_per_passage: Vec<Rate>,
    passages_to_limit: Option<f64>,
    mgt_to_limit: Option<f64>,
    months_to_limit: Option<f64>,
    /// Passages to the limit over those of the case as it is; null where either never is there.
    change_of_time_to_limit: Option<f64>,
    linear_range_passages: Option<f64>,
    remarks: &'a [String],
}

#[derive(Serialize)]
struct RidgeDocument {
    wavelength_m: f64,
    speed_m_per_s: f64,
    frequency_hz: f64,
    growth_rate_per_passage: f64,
}

#[derive(Serialize)]
struct Rate {
    wavelength_m: f64,
    growth_rate_per_passage: f64,
    change: f64,
}

pub(super) fn document(report: &Report) -> Document<'_> {
    let with_limit = report.spectrum.is_some();
    Document {
        riffel_version: env!("CARGO_PKG_VERSION"),
        case: &report.case.file,
        speeds: &report.speeds,
        spectrum_now: report.spectrum.as_ref().map(levels),
        limit: with_limit.then_some(report.table.edition.as_str()),
        outcomes: report
            .comparison
            .outcomes
            .iter()
            .map(|outcome| of(report, outcome))
            .collect(),
    }
}

fn of<'a>(report: &'a Report, outcome: &'a Outcome) -> OutcomeDocument<'a> {
    let base = report.comparison.base();
    let bands = report.comparison.bands.iter().enumerate();
    let change = outcome.fastest.rate / base.fastest.rate - 1.0;
    OutcomeDocument {
        title: &outcome.title,
        fastest_wavelength_m: outcome.fastest.wavelength,
        fastest_growth_rate_per_passage: outcome.fastest.rate,
        fastest_at_edge: outcome.fastest.at_edge,
        change_of_fastest_growth: (base.fastest.rate > 0.0).then_some(change),
        ridge_frequency_hz: outcome.ridge_frequency,
        ridge_highest: outcome.ridge_highest.map(|point| RidgeDocument {
            wavelength_m: point.wavelength,
            speed_m_per_s: point.speed,
            frequency_hz: point.frequency,
            growth_rate_per_passage: point.growth_rate,
        }),
        growth_rate_per_passage: bands
            .map(|(place, band)| {
                let rate = outcome.growth.band_rate(place);
                Rate {
                    wavelength_m: band.wavelength(),
                    growth_rate_per_passage: rate,
                    change: rate - base.growth.band_rate(place),
                }
            })
            .collect(),
        passages_to_limit: outcome.passages_to_limit,
        mgt_to_limit: outcome
            .passages_to_limit
            .map(|passages| outcome.growth.mgt(passages)),
        months_to_limit: months_to_limit(outcome),
        change_of_time_to_limit: outcome
            .passages_to_limit
            .zip(base.passages_to_limit.filter(|passages| *passages > 0.0))
            .map(|(own, base)| own / base - 1.0),
        linear_range_passages: outcome
            .forecast
            .as_ref()
            .and_then(|forecast| forecast.linear_range(forecast.bands()).passages),
        remarks: &outcome.remarks,
    }
}

/// One row for each band, a column for each outcome.
pub(super) fn band_table(report: &Report, file: &mut impl Write) -> io::Result<()> {
    let bands = report.comparison.bands.iter();
    let wavelengths: Vec<f64> = bands.map(|band| band.wavelength()).collect();
    rate_table(
        report,
        &wavelengths,
        |outcome, place| outcome.growth.band_rate(place),
        file,
    )
}

/// One row for each line, a column for each outcome.
pub(super) fn line_table(report: &Report, file: &mut impl Write) -> io::Result<()> {
    let wavelengths = report.comparison.base().growth.wavelengths();
    rate_table(
        report,
        &wavelengths,
        |outcome, place| outcome.growth.rates()[place],
        file,
    )
}

fn rate_table(
    report: &Report,
    wavelengths: &[f64],
    rate: impl Fn(&Outcome, usize) -> f64,
    file: &mut impl Write,
) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = vec!["wavelength_m".to_owned()];
    let outcomes = report.comparison.outcomes.iter();
    header.extend(outcomes.map(|outcome| format!("{} growth_rate_per_passage", outcome.title)));
    writer.write_record(&header)?;
    for (place, wavelength) in wavelengths.iter().enumerate() {
        let mut row = vec![*wavelength];
        row.extend(
            report
                .comparison
                .outcomes
                .iter()
                .map(|outcome| rate(outcome, place)),
        );
        writer.serialize(row)?;
    }
    writer.flush()
}
