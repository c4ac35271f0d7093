//! Records of a track at several dates, and how each rail grew over them.

use std::collections::BTreeMap;

use riffel::diagnosis::{fall_of_bands, first_since_ground};
use riffel::forecast::MeasuredGrowth;
use riffel::roughness::Spectrum;

use crate::Survey;

/// What time between records is counted in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Elapsed {
    /// Days.
    Days,
    /// Axle passages.
    Passages,
}

/// The records of a track at all dates, the earliest first.
#[derive(Debug, Clone, PartialEq)]
pub struct RailDates {
    /// Time of each date with its records.
    pub dates: Vec<(f64, Survey)>,
    /// What the times are counted in.
    pub elapsed: Elapsed,
}

impl RailDates {
    /// Records of now with earlier ones, of which each is so long ago, the longest first.
    pub fn new(now: &Survey, earlier: Vec<(f64, Survey)>, elapsed: Elapsed) -> Self {
        let earlier = earlier.into_iter().map(|(ago, survey)| (-ago, survey));
        Self { dates: earlier.chain([(0.0, now.clone())]).collect(), elapsed }
    }

    /// The first records since the rails were last ground, with their share of the time from the oldest to now; of rails that were ground
    /// to the last date those before it; `None` if nothing was ground or there are two dates: their change says it.
    pub fn since_ground(&self) -> Option<(f64, &Survey)> {
        let means: Vec<Spectrum> = self.dates.iter().map(|(_, survey)| survey.mean()).collect();
        let fall = |pair: &[Spectrum]| {
            let falls = pair[0].levels().iter();
            fall_of_bands(falls.filter_map(|own| Some(own.level - pair[1].level(own.band)?)))
        };
        let place = first_since_ground(means.windows(2).map(fall));
        let place = place.min(self.dates.len().checked_sub(2)?);
        let (time, survey) = &self.dates[place];
        (place > 0).then(|| (time / self.dates[0].0, survey))
    }

    /// The growth of a rail by its own dates, or of all rails together without a name, in axle passages; `None` if days are counted and
    /// it is not known how many axles run in one, or no band of the rail has two dates since it was ground.
    pub fn growth(&self, rail: Option<&str>, passages_per_day: Option<f64>) -> Option<MeasuredGrowth> {
        let per_unit = match self.elapsed {
            Elapsed::Days => passages_per_day?,
            Elapsed::Passages => 1.0,
        };
        let (_, last) = self.dates.last()?;
        let dated =
            self.dates.iter().filter_map(|(time, survey)| Some((*time, survey.with_names_of(last).of_rail(rail)?)));
        let (times, surveys): (Vec<f64>, Vec<Survey>) = dated.unzip();
        let surveys: Vec<&Survey> = surveys.iter().collect();
        let (records, paired) = in_step(&surveys);
        let dates: Vec<(f64, Vec<Spectrum>)> = times.into_iter().zip(records).collect();
        let growth = MeasuredGrowth::new(&dates, paired).ok()?;
        (!growth.bands().is_empty()).then(|| growth.in_unit(per_unit))
    }
}

/// The spectra of surveys, and whether those of each are of the same places in the same order: told by the columns that hold the same
/// values in all, if these tell the records of each apart; a number of the spectrum or a date does not count, for its values differ.
pub(super) fn in_step(surveys: &[&Survey]) -> (Vec<Vec<Spectrum>>, bool) {
    let apart = || surveys.iter().map(|survey| survey.spectra()).collect();
    let Some((first, others)) = surveys.split_first() else {
        return (apart(), false);
    };
    let values = |survey: &Survey, column: &str| {
        let labels = survey.records.iter().filter_map(|one| one.label(column));
        let mut values: Vec<String> = labels.map(str::to_owned).collect();
        values.sort();
        values.dedup();
        values
    };
    let columns: Vec<&str> = first
        .columns()
        .filter(|column| (others.iter()).all(|other| values(other, column) == values(first, column)))
        .collect();
    let keyed = |survey: &Survey| -> BTreeMap<Vec<String>, Spectrum> {
        let records = survey.records.iter();
        let keyed = records.map(|record| {
            let labels = columns.iter().map(|column| record.label(column));
            let key = labels.map(|label| label.unwrap_or_default().to_owned());
            (key.collect(), record.spectrum.clone())
        });
        keyed.collect()
    };
    let maps: Vec<BTreeMap<Vec<String>, Spectrum>> = surveys.iter().map(|survey| keyed(survey)).collect();
    let unique = (surveys.iter().zip(&maps)).all(|(survey, map)| survey.records.len() == map.len());
    let same = maps.windows(2).all(|pair| pair[0].keys().eq(pair[1].keys()));
    if columns.is_empty() || !unique || !same {
        return (apart(), false);
    }
    // In the order of the rail: neighbours scatter together.
    let order = first.records.iter().map(|record| {
        let labels = columns.iter().map(|column| record.label(column));
        labels.map(|label| label.unwrap_or_default().to_owned()).collect()
    });
    let order: Vec<Vec<String>> = order.collect();
    let in_order = |map: &BTreeMap<Vec<String>, Spectrum>| order.iter().map(|key| map[key].clone()).collect();
    (maps.iter().map(in_order).collect(), true)
}
