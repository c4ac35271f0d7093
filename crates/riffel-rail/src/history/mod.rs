//! The records of a rail: what stands out of them, and what it did in time.

mod profiles;
mod tables;

use jiff::civil::Date;
use riffel::diagnosis::{DominantWavelength, FineSpectrum, LevelTrend, Place, TimeUnit};
use riffel::roughness::{RailDefect, Spectrum};
use riffel_keys::{CaseError, Message};

use crate::{RailRecord, RailRoughness};

/// A dominant wavelength with what goes with it.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The rail it stands on, where rails are known one by one.
    pub rail: Option<String>,
    /// Where along the rail it stands, the highest level first; none for tables of levels.
    pub places: Vec<Place>,
    /// Whether it stands all along the rail.
    pub all_along: bool,
    /// Where it stands, and how far it stands out.
    pub peak: DominantWavelength,
    /// The record of which the peak is told, where it was looked for in several: it stands out most there.
    pub record: Option<String>,
    /// Whether it fell as by grinding and stands out of no record since: it tells of the rail before.
    pub gone: bool,
    /// Its levels in time, where there are two records or more.
    pub course: Option<LevelTrend>,
    /// Levels in time on mean energies, if the levels are means of several spectra.
    pub energy_levels: Option<Vec<f64>>,
    /// Level of every rail at the first place, or in the record where the wavelength stands out most, where there are
    /// several rails \[dB re 1 µm\].
    pub rails: Vec<(String, f64)>,
}

/// What a figure shows of the records.
pub enum Curves {
    /// Levels of a profile in narrow bands, of each rail and of the places that tell most; the worst first.
    Fine(Vec<(Message, FineSpectrum)>),
    /// Means of levels of one-third octaves, by group.
    Levels(Vec<(Message, Spectrum)>),
}

/// What stands out of the records of a rail, and what became of it.
pub struct RailHistory {
    /// The dominant wavelengths: rail by rail, the one with the highest level first, and of a rail the most prominent
    /// first; behind them those that are gone.
    pub measured: Vec<Measured>,
    /// What a figure shows of the records.
    pub curves: Curves,
    /// What the records are, in words.
    pub words: Message,
    /// Welds, joints and squats of the present record by rail, which its spectra leave out unless they were kept.
    pub defects: Vec<(String, RailDefect)>,
    /// What was put right in the records.
    pub warnings: Vec<Message>,
}

/// Which spectra of a table are meant.
#[derive(Debug, Clone, Copy, Default)]
pub struct SpectraChoice<'a> {
    /// Choices `COLUMN=VALUE` among the spectra.
    pub choose: &'a [String],
    /// Column that tells the spectra of one table apart in time; `date` by default, if there is one.
    pub by: Option<&'a str>,
    /// Keep welds, joints and squats in the spectra of profiles.
    pub keep_defects: bool,
}

impl RailHistory {
    /// The history of a rail from its records; earlier ones are the oldest first.
    ///
    /// Cost: a transform of each profile.
    ///
    /// # Errors
    /// [`CaseError::Data`] where a record has no spectrum, is of another kind than the present one, or a choice does
    /// not fit.
    pub fn new(
        present: &RailRecord<'_>,
        earlier: &[RailRecord<'_>],
        choice: SpectraChoice<'_>,
    ) -> Result<Self, CaseError> {
        if let ([], None, RailRoughness::Profile { rails, before: Some((date, before @ [_, ..])), warnings }) =
            (earlier, present.date, present.roughness)
        {
            let record = |date: Date, rails, warnings| RailRecord {
                name: present.name,
                date: Some(date),
                roughness: RailRoughness::Profile { rails, before: None, warnings },
            };
            let earlier: Vec<RailRecord<'_>> = before.iter().map(|one| record(one.date, &one.rails, &[])).collect();
            return Self::new(&record(date, rails, warnings), &earlier, choice);
        }
        let given = dates(earlier.iter().chain([present])).unwrap_or_default();
        if let Some(pair) = given.windows(2).find(|pair| pair[1] <= pair[0]) {
            let message = format!(
                "the dates of the records do not rise: {} comes after {}; give the oldest first",
                pair[1], pair[0]
            );
            return Err(CaseError::data(present.name, message));
        }
        match present.roughness {
            RailRoughness::Profile { rails, warnings, .. } => {
                profiles::history(present, rails, warnings, earlier, choice)
            }
            RailRoughness::Spectra(spectra) => tables::history(present, spectra, earlier, choice),
        }
    }
}

/// The dates of all records, unless one has none.
fn dates<'a>(records: impl Iterator<Item = &'a RailRecord<'a>>) -> Option<Vec<Date>> {
    records.map(|record| record.date).collect()
}

/// Times of the records: years by their dates, or their places in the order.
fn times(records: usize, dates: &[Date]) -> (Vec<f64>, TimeUnit) {
    const DAYS_A_YEAR: f64 = 365.2425;
    let Some(first) = dates.first() else {
        let places = (0..records).map(|place| place as f64);
        return (places.collect(), TimeUnit::Record);
    };
    let days = |date: &Date| date.duration_since(*first).as_secs_f64() / 86_400.0;
    let years = dates.iter().map(|date| days(date) / DAYS_A_YEAR);
    (years.collect(), TimeUnit::Year)
}
