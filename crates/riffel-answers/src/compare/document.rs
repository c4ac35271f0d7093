//! A comparison as data and as tables.

use riffel_keys::Message;
use std::io::{self, Write};

use riffel::forecast::Reach;
use riffel_case::Case;
use riffel_case::file::CaseFile;
use serde::Serialize;

use super::{CompareAnswer, Effect, Outcome};
use crate::column;
use crate::forecast::{RailForecast, ReachDocument};
use crate::roughness::{Level, levels};
use crate::{OverPosterior, WearLimitDocument};

/// What `riffel compare --json` prints.
#[derive(Serialize)]
pub struct CompareDocument<'a> {
    riffel_version: &'static str,
    case: &'a CaseFile,
    speeds: &'a Message,
    /// Of the rail that leads in the case as it is.
    spectrum_now: Option<Vec<Level>>,
    /// What the rail will be ground to, if that is where the months to the limit begin.
    ground: Option<&'a Message>,
    limit: Option<&'a str>,
    /// Where the model does not explain how the rail that leads grew, or is of the other one: what follows; else empty.
    unexplained: Vec<Message>,
    /// The case as it is first.
    outcomes: Vec<OutcomeDocument<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    over_posterior: Option<&'a OverPosterior>,
}

#[derive(Serialize)]
struct OutcomeDocument<'a> {
    title: &'a str,
    /// What is held where friction or load change: force | ratio | creepage, mixed where that differs from vehicle
    /// to vehicle; null where friction and load stay, or the variant gives the mean state itself.
    hold: Option<&'static str>,
    /// Whether it changes growth; null for the case as it is.
    acts: Option<bool>,
    /// Why it does not, or which of its keys do not.
    no_effect: Option<&'a Message>,
    fastest_wavelength_m: f64,
    fastest_growth_rate_per_passage: f64,
    /// It sits at the end of the bands: another wavelength may grow faster.
    fastest_at_edge: bool,
    /// For that growth.
    #[serde(flatten)]
    wear_limit: WearLimitDocument,
    /// Relative to the case as it is; null where that does not grow, or the variant does not act.
    change_of_fastest_growth: Option<f64>,
    ridge_frequency_hz: Option<f64>,
    ridge_highest: Option<RidgeDocument>,
    growth_rate_per_passage: Vec<Rate>,
    /// The rail that reaches the limit first; null where rails are not named.
    rail: Option<&'a str>,
    /// Every rail, the one that leads first.
    rails: Vec<RailDocument<'a>>,
    /// Null without a spectrum.
    #[serde(flatten)]
    reach: ReachDocument,
    /// Passages to the limit over those of the case as it is; null where either never is there.
    change_of_time_to_limit: Option<f64>,
    linear_range_passages: Option<f64>,
    remarks: &'a [Message],
}

#[derive(Serialize)]
struct RailDocument<'a> {
    rail: Option<&'a str>,
    #[serde(flatten)]
    reach: ReachDocument,
    linear_range_passages: Option<f64>,
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

pub(super) fn document<'a>(answer: &'a CompareAnswer, case: &'a Case) -> CompareDocument<'a> {
    let rail = answer.leading();
    CompareDocument {
        riffel_version: env!("CARGO_PKG_VERSION"),
        case: &case.file,
        speeds: &answer.speeds,
        spectrum_now: rail.map(|rail| levels(&rail.start.levels.spectrum)),
        ground: answer.ground.as_ref().map(|ground| &ground.words),
        limit: rail.map(|_| answer.table.edition.as_str()),
        unexplained: answer.unexplained(),
        outcomes: answer.comparison.outcomes.iter().map(|outcome| of(answer, case, outcome)).collect(),
        over_posterior: answer.over_posterior.as_ref(),
    }
}

fn of<'a>(answer: &'a CompareAnswer, case: &Case, outcome: &'a Outcome) -> OutcomeDocument<'a> {
    let base = answer.comparison.base();
    let bands = answer.comparison.bands.iter().enumerate();
    let passages_to_limit = outcome.passages_to_limit();
    OutcomeDocument {
        title: &outcome.title,
        hold: outcome.held_name(),
        acts: (outcome.effect != Effect::None).then(|| outcome.effect.acts()),
        no_effect: outcome.effect.sentence(),
        fastest_wavelength_m: outcome.fastest.wavelength,
        fastest_growth_rate_per_passage: outcome.fastest.rate,
        fastest_at_edge: outcome.fastest.at_edge,
        wear_limit: WearLimitDocument::under(
            case,
            outcome.growth.mean_wear(),
            outcome.wear_coefficient,
            Some(outcome.fastest.rate).filter(|rate| !rate.is_nan()),
        ),
        change_of_fastest_growth: match outcome.effect {
            Effect::None => (base.fastest.rate > 0.0).then_some(0.0),
            _ => outcome.change_from(base),
        },
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
        rail: outcome.leading().and_then(RailForecast::name),
        rails: rails(outcome),
        reach: ReachDocument::new(outcome.reach().map(Reach::name), passages_to_limit, &outcome.growth, |passages| {
            outcome.months(passages)
        }),
        change_of_time_to_limit: passages_to_limit
            .zip(base.passages_to_limit().filter(|passages| *passages > 0.0))
            .map(|(own, base)| own / base - 1.0),
        linear_range_passages: outcome.leading().and_then(linear_range),
        remarks: &outcome.remarks,
    }
}

fn rails(outcome: &Outcome) -> Vec<RailDocument<'_>> {
    let rails = outcome.rails.iter();
    rails
        .map(|rail| {
            let passages = rail.reach.and_then(Reach::passages);
            RailDocument {
                rail: rail.name(),
                reach: ReachDocument::new(rail.reach.map(Reach::name), passages, &outcome.growth, |passages| {
                    outcome.months(passages)
                }),
                linear_range_passages: linear_range(rail),
            }
        })
        .collect()
}

fn linear_range(rail: &RailForecast) -> Option<f64> {
    rail.forecast.linear_range(rail.forecast.bands()).passages
}

/// One row for each band, a column for each outcome.
pub(super) fn band_table(answer: &CompareAnswer, file: &mut impl Write) -> io::Result<()> {
    let bands = answer.comparison.bands.iter();
    let wavelengths: Vec<f64> = bands.map(|band| band.wavelength()).collect();
    rate_table(answer, &wavelengths, |outcome, place| outcome.growth.band_rate(place), file)
}

/// One row for each line, a column for each outcome.
pub(super) fn line_table(answer: &CompareAnswer, file: &mut impl Write) -> io::Result<()> {
    let wavelengths = answer.comparison.base().growth.wavelengths();
    rate_table(answer, &wavelengths, |outcome, place| outcome.growth.rates()[place], file)
}

fn rate_table(
    answer: &CompareAnswer,
    wavelengths: &[f64],
    rate: impl Fn(&Outcome, usize) -> f64,
    file: &mut impl Write,
) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = vec!["wavelength_m".to_owned()];
    let outcomes = answer.comparison.outcomes.iter();
    let titles = outcomes.map(|outcome| &*outcome.title);
    header.extend(column::names(titles, "growth_rate_per_passage"));
    writer.write_record(&header)?;
    for (place, wavelength) in wavelengths.iter().enumerate() {
        let mut row = vec![*wavelength];
        row.extend(answer.comparison.outcomes.iter().map(|outcome| rate(outcome, place)));
        writer.serialize(row)?;
    }
    writer.flush()
}
