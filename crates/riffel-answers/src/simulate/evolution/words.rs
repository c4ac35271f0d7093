//! A rail after many wheels in words.

use riffel_keys::{Message, Value, decimal, fixed, number, say};

use super::{Band, EvolutionAnswer};
use crate::forecast::{number_alone, per_million, three_digits};
use crate::simulate::Extremes;
use crate::{Rows, Table};

/// Level below which nothing is told \[dB re 1 µm\]: ten picometres.
const NOTHING: f64 = -100.0;

/// The run, with a line for each vehicle where there is more than one wheel at one speed.
pub(super) fn introduction(answer: &EvolutionAnswer) -> Vec<Message> {
    let run = say!(
        passages_over_rail,
        passages = number(three_digits(answer.passages as f64)),
        length = fixed(answer.length_m, 3),
        speed = fixed(3.6 * answer.speed_m_per_s, 1),
        step = fixed(1e3 * answer.step_m, 3)
    );
    let vehicles = match &answer.vehicles[..] {
        [one] if one.speeds == 1 => &[],
        several => several,
    };
    let vehicles = vehicles.iter().map(|vehicle| {
        say!(
            passing_vehicle,
            share = fixed(100.0 * vehicle.share, 1),
            name = &vehicle.name,
            speed = fixed(3.6 * vehicle.speed_m_per_s, 1),
            deviation = fixed(3.6 * vehicle.speed_deviation_m_per_s, 1)
        )
    });
    let title = answer.run.titled(say!(rail_under_many_wheels));
    [title, run].into_iter().chain(vehicles).collect()
}

/// Level, growth and drift of each band.
pub(super) fn bands(bands: &[Band]) -> Table {
    // Less is rounding, as of the harmonics of a sinusoid before any wheel.
    let cell = |level: f64, value: Option<f64>, digits: usize| match value {
        Some(value) if level > NOTHING => number_alone(format_args!("{value:.digits$}")),
        _ => Message::verbatim(""),
    };
    let first = |band: &Band| band.level_db[0];
    let end = |band: &Band| band.level_db[band.level_db.len() - 1];
    let level = |level: f64| cell(level, Some(level), 1);
    let growth = |level: f64, rate: Option<f64>| cell(level, rate.map(per_million), 2);
    // [m] in a passage are 10⁹ [mm] in a million.
    let drift = |level: f64, shift: Option<f64>| cell(level, shift.map(|shift| 1e9 * shift), 2);
    Table {
        name: "levels",
        columns: vec![
            bands.numbers(say!(wavelength_of_band), |band| format!("{:.1}", 1e3 * band.wavelength_m)),
            bands.shown(say!(level_column), |band| level(first(band))),
            bands.shown(say!(level_at_end_column), |band| level(end(band))),
            bands.shown(say!(linear_column), |band| level(band.linear_level_db[band.linear_level_db.len() - 1])),
            bands.shown(say!(growth_of_level_column), |band| growth(first(band), band.first_growth_per_passage)),
            bands.shown(say!(linear_column), |band| growth(first(band), band.first_linear_growth_per_passage)),
            bands.shown(say!(last_quarter_column), |band| growth(end(band), band.last_growth_per_passage)),
            bands.shown(say!(drift_column), |band| drift(first(band), band.first_shift_m_per_passage)),
            bands.shown(say!(linear_column), |band| drift(first(band), Some(band.linear_shift_m_per_passage))),
        ],
    }
}

pub(super) fn sentences(answer: &EvolutionAnswer) -> Vec<Message> {
    let supports = answer.stages.support_pattern_level_db.as_ref().map(|levels| {
        let [first, last] = [levels[0], levels[levels.len() - 1]].map(|level| match level {
            level if level > NOTHING => say!(so_many_decibels, level = fixed(level, 1)),
            _ => say!(no_level_yet),
        });
        say!(waves_between_supports, first, last)
    });
    let lifts = answer.first_contact_loss_passages;
    let lifts = lifts.map(|passages| say!(wheel_leaves_rail_from, passages = number(three_digits(passages as f64))));
    let depth = number(three_digits(1e6 * answer.mean_depth_m));
    let worn = say!(worn_off_everywhere, depth);
    supports.into_iter().chain([saturated(&answer.bands)]).chain(lifts).chain(forces(answer)).chain([worn]).collect()
}

/// Forces of the last stage that has any.
fn forces(answer: &EvolutionAnswer) -> Option<Message> {
    let stages = &answer.stages;
    let forces = stages.minimum_normal_force_n.iter().zip(&stages.maximum_normal_force_n);
    let mut each = forces.zip(&stages.contact_loss_fraction).rev();
    let last = each.find_map(|((least, largest), loss)| Some(Extremes::new([(*least)?, (*largest)?], (*loss)?)));
    let (least, largest, contact) = last?.words();
    Some(say!(last_normal_force, least, largest, contact))
}

/// The bands that have stopped growing.
fn saturated(bands: &[Band]) -> Message {
    let saturated = bands.iter().filter_map(|band| {
        let level = band.saturation_level_db?;
        let wavelength = number(decimal(1e3 * band.wavelength_m, 1));
        Some(say!(wavelength_at_level, wavelength, level = fixed(level, 1)))
    });
    let saturated: Vec<Message> = saturated.collect();
    match saturated.is_empty() {
        true => say!(no_band_has_stopped),
        false => say!(bands_have_stopped, bands = saturated.into_iter().collect::<Value>()),
    }
}
