//! The figure of a comparison.

use riffel_case::Case;
use riffel_case::traffic::DAYS_PER_YEAR;
use riffel_keys::{Language, Value, say};
use riffel_plot::{Arrangement, LineFigure, LineStyle, OKABE_ITO, Rgb, Series};

use super::{CompareAnswer, title_of};
use crate::forecast::{number, per_million, rate_panel, when, zero};
use crate::roughness::figure::{level_panel, levels as curve};
use crate::sentence;

pub(super) fn figure(answer: &CompareAnswer, case: &Case, language: Language) -> LineFigure {
    let base = answer.comparison.base();
    let wavelengths: Vec<f64> = base.growth.wavelengths().iter().map(|w| 1e3 * w).collect();
    let outcomes = || answer.comparison.outcomes.iter().enumerate();
    let mut rates: Vec<Series> = outcomes()
        .map(|(index, outcome)| {
            Series::new(
                title_of(outcome).text(language),
                wavelengths.clone(),
                outcome.growth.rates().iter().map(|rate| per_million(*rate)).collect(),
            )
            .colored(color(index))
        })
        .collect();
    rates.push(zero(&wavelengths));
    let mut panels = vec![rate_panel(rates, language)];
    let mut caption = vec![answer.speeds.clone(), say!(growth_of_the_level)];
    if let Some(leading) = answer.leading() {
        // All at one date: when the case as it is reaches its limit, else when the first variant does, else
        // after a year.
        let reached = answer.comparison.outcomes.iter();
        let passages = reached
            .filter_map(|outcome| outcome.passages_to_limit())
            .find(|passages| *passages > 0.0)
            .or(base.passages_per_day.map(|per_day| DAYS_PER_YEAR * per_day))
            .unwrap_or(1e6);
        let now = match &answer.ground {
            Some(_) => say!(after_grinding),
            None => say!(now),
        };
        let now = match answer.rail(leading) {
            Some(rail) => say!(rail_when, rail, time = now),
            None => now,
        };
        let mut ended = Vec::new();
        let spectrum = &leading.start.levels.spectrum;
        let mut levels = vec![curve(&now.text(language), spectrum, LineStyle::Dotted, Rgb::BLACK)];
        levels.extend(outcomes().filter_map(|(index, outcome)| {
            // All of one rail, the one that leads in the case as it is.
            let mut rails = outcome.rails.iter();
            let rail = rails.find(|rail| rail.name() == leading.name())?;
            let forecast = &rail.forecast;
            let until = passages.min(forecast.valid_to());
            if until < passages {
                ended.push(say!(in_quotes, words = title_of(outcome)));
            }
            let bands = forecast.bands().iter();
            // Where the wheel leaves the rail now, there is nothing but the spectrum now.
            (until > 0.0).then(|| {
                Series::new(
                    title_of(outcome).text(language),
                    bands.clone().map(|band| 1e3 * band.now.band.wavelength()).collect(),
                    bands.map(|band| band.level(until)).collect(),
                )
                .colored(color(index))
            })
        }));
        levels.push(curve(&answer.table.edition, answer.limit.spectrum(), LineStyle::Dashed, Rgb::BLACK));
        panels.push(level_panel(levels, language));
        caption.push(say!(levels_after, passages = when(Some(passages)), tonnes = number(base.growth.mgt(passages))));
        if let Some(rail) = answer.rail(leading) {
            caption.push(say!(levels_of_rail_as_it_is, rail));
        }
        if !ended.is_empty() {
            let titles: Value = ended.into_iter().collect();
            caption.push(say!(forecast_ends_before, titles));
        }
    }
    let caption: Vec<String> = caption.iter().map(|one| sentence(one, language)).collect();
    LineFigure::new(
        case.file.title.clone().unwrap_or_else(|| say!(comparison).text(language)),
        caption.join(" "),
        panels,
    )
    .arranged(Arrangement::Stacked)
}

/// Black for the case as it is.
fn color(index: usize) -> Rgb {
    match index {
        0 => Rgb::BLACK,
        _ => OKABE_ITO[1 + (index - 1) % (OKABE_ITO.len() - 1)],
    }
}
