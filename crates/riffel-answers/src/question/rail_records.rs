//! Records of a rail that a question names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use jiff::civil::Date;
use riffel_keys::quantity::{Dimension, Length, Quantity};
use riffel_keys::say;
use riffel_keys::text_file::is_standard_input;
use riffel_rail::{Elapsed, Layout, LengthUnit, RailDates, ReaderFormat, RecordPart, RoughnessFile, Survey, read_date};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};

use super::source::called;
use super::{Client, Rule, Source};
use crate::{AnswerError, Result};

/// How files of roughness are laid out, and what is taken of them.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct RecordLayout {
    /// Reader profile that says how profiles are laid out [default: found from their first lines].
    #[schemars(extend("value_name" = "TOML"))]
    pub format: Option<Source<ReaderFormat>>,
    /// Step between samples of files without positions, in metres or with its unit.
    #[schemars(extend("value_name" = "LENGTH"))]
    pub spacing: Option<Quantity<Length>>,
    /// Unit of the heights, as mm or um, whatever the file says [default: that of its head or of a remark, else um].
    #[schemars(with = "Option<String>", extend("value_name" = "UNIT"))]
    pub height_unit: Option<LengthUnit>,
    /// Unit of the positions, as m or km, whatever the file says [default: that of its head or of a remark, else by
    /// their step].
    #[schemars(with = "Option<String>", extend("value_name" = "UNIT"))]
    pub position_unit: Option<LengthUnit>,
    /// Take this rail alone [default: all, each judged on its own].
    #[schemars(extend("value_name" = "NAME"))]
    pub rail: Option<String>,
    /// Take profiles from this position on, as in --from "12.4 km".
    #[schemars(extend("value_name" = "POSITION"))]
    pub from: Option<Quantity<Length>>,
    /// Take profiles up to this position.
    #[schemars(extend("value_name" = "POSITION"))]
    pub to: Option<Quantity<Length>>,
    /// Keep welds, joints and squats in the spectra of a profile that are diagnosed, forecast or heard [default: they are
    /// listed and left out; limits and marches in time always have them].
    pub keep_defects: bool,
    /// Files that were read so, where several answers are made of them.
    #[serde(skip)]
    pub kept: Option<KeptRecords>,
}

/// Records by their files, each read once.
pub type KeptRecords = Arc<Mutex<BTreeMap<PathBuf, RoughnessFile>>>;

impl RecordLayout {
    /// Its keys, which mean nothing without a record.
    pub(crate) const KEYS: &[&str] =
        &["format", "spacing", "height_unit", "position_unit", "rail", "from", "to", "keep_defects"];

    /// What is asked for of a file.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a step that is not above zero, [`AnswerError::Case`] with the file at fault.
    pub fn read(&self, path: &Path, client: &dyn Client) -> Result<RoughnessFile> {
        let Some(kept) = &self.kept else {
            return self.read_anew(path, client);
        };
        let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(file) = kept.get(path) {
            return Ok(file.clone());
        }
        let file = self.read_anew(path, client)?;
        kept.insert(path.to_owned(), file.clone());
        Ok(file)
    }

    fn read_anew(&self, path: &Path, client: &dyn Client) -> Result<RoughnessFile> {
        if let Some(spacing) = self.spacing {
            positive("--spacing", spacing)?;
        }
        let format = self.format.as_ref().map(|format| format.value(ReaderFormat::read)).transpose()?;
        let layout = Layout {
            format: format.map(Arc::unwrap_or_clone),
            spacing: self.spacing,
            height_unit: self.height_unit.clone(),
            position_unit: self.position_unit.clone(),
        };
        let part = RecordPart { rail: self.rail.clone(), from: self.from, to: self.to };
        let size = std::fs::metadata(path).map_or(0, |file| file.len() as usize);
        let file = RoughnessFile::read(path, &layout, &client.begin(say!(progress_reading), size));
        Ok(file?.part(path, &part)?)
    }

    /// The spectra of a file, those of a profile computed.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read), and [`AnswerError::Case`] where a profile has no spectrum.
    pub fn survey(&self, path: &Path, client: &dyn Client) -> Result<Survey> {
        Ok(Survey::of(called(path), self.read_growing(path, client)?)?)
    }

    /// What grows of a rail: a file without single defects, unless they are kept.
    fn read_growing(&self, path: &Path, client: &dyn Client) -> Result<RoughnessFile> {
        Ok(self.growing(self.read(path, client)?))
    }

    /// A file without single defects, unless they are kept.
    pub(crate) fn growing(&self, file: RoughnessFile) -> RoughnessFile {
        match self.keep_defects {
            true => file,
            false => file.without_defects(),
        }
    }

    /// The records of a rail whose profile was measured twice, place by place; `None` for tables, and for what came over
    /// standard input and is gone.
    fn places_of_both(&self, earlier: &Path, later: &Path, client: &dyn Client) -> Result<Option<[Survey; 2]>> {
        if is_standard_input(earlier) || is_standard_input(later) {
            return Ok(None);
        }
        let before = self.read_growing(earlier, client)?;
        if !matches!(before, RoughnessFile::Profile(_)) {
            return Ok(None);
        }
        let now = self.read_growing(later, client)?;
        Ok(Survey::at_same_places((earlier, &before), (later, &now))?)
    }
}

/// `Ok` without a choice among spectra, which means nothing for a profile.
pub(crate) fn choose_nothing(path: &Path, choose: &[String], by: Option<&str>) -> Result<()> {
    let choice = choose.first().map(|choice| ("--where", choice.as_str()));
    match choice.or(by.map(|by| ("--by", by))) {
        None => Ok(()),
        Some((argument, value)) => Err(AnswerError::argument(
            argument,
            value,
            format!("left out: it is for tables of spectra, and {} is a profile", path.display()),
        )),
    }
}

/// The value of an argument that must be above zero, in SI.
///
/// # Errors
/// [`AnswerError::Argument`] with the rule.
pub fn positive<D: Dimension>(argument: &'static str, value: Quantity<D>) -> Result<f64> {
    /// Nothing about a railway is smaller or larger in SI.
    const RANGE: [f64; 2] = [1e-12, 1e12];
    let si = value.si();
    if (RANGE[0]..=RANGE[1]).contains(&si) {
        return Ok(si);
    }
    let rule = match si > 0.0 {
        true => format!("between {:e} and {:e} in SI", RANGE[0], RANGE[1]),
        false => "greater than zero".to_owned(),
    };
    Err(AnswerError::argument(argument, value, rule))
}

/// Earlier records of the rail that is measured.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct EarlierRecords {
    /// An earlier record of the same rail, by which it goes on growing; may be repeated, the oldest first.
    #[schemars(extend("value_name" = "FILE"))]
    pub earlier: Vec<Source<RoughnessFile>>,
    /// Dates of all records, as 2026-01-31 or 31.01.2026, separated by commas, the oldest first and that of now last.
    #[serde(deserialize_with = "dates")]
    #[schemars(with = "Vec<String>", extend("separator" = ","))]
    pub dates: Vec<Date>,
}

fn dates<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Date>, D::Error> {
    Vec::<String>::deserialize(deserializer)?.iter().map(|text| date_of(text)).collect()
}

/// A date as it is written in a question.
pub(crate) fn date_of<E: serde::de::Error>(text: &str) -> Result<Date, E> {
    read_date(text).map_err(|said| E::custom(said.to_string()))
}

impl EarlierRecords {
    /// Dates are those of several records.
    pub(crate) const RULE: Rule = Rule::Needs(&["dates"], &["earlier"]);

    /// `Ok` if there is a date for each record, each later than the one before, or none at all.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] with the rule.
    pub fn check(&self) -> Result<()> {
        let (dates, records) = (&self.dates, self.earlier.len() + 1);
        if dates.is_empty() || (dates.len() == records && dates.is_sorted_by(|one, next| one < next)) {
            return Ok(());
        }
        let written: Vec<String> = dates.iter().map(Date::to_string).collect();
        let rule = match dates.len() == records {
            true => "days that rise from each record to the next, that of now last".to_owned(),
            false => format!("{records} dates, one for each --earlier and one for the record of now"),
        };
        Err(AnswerError::argument("--dates", written.join(","), rule))
    }

    /// The records, each as it is chosen, beside the one of now in a file.
    ///
    /// # Errors
    /// Errors of [`check`](Self::check) and [`RecordLayout::survey`].
    pub fn read(
        &self,
        now: Option<&Path>,
        layout: &RecordLayout,
        choose: &[String],
        client: &dyn Client,
    ) -> Result<History> {
        self.check()?;
        let chosen = |source: &Source<RoughnessFile>| {
            let file = source.value(|path| layout.read(path, client))?;
            let file = layout.growing(Arc::unwrap_or_clone(file));
            Ok(Survey::of(called(source.name()), file)?.choose(choose)?)
        };
        Ok(History {
            surveys: self.earlier.iter().map(chosen).collect::<Result<_>>()?,
            places: match (self.earlier.first().and_then(Source::path), now) {
                (Some(before), Some(now)) => layout.places_of_both(before, now, client)?,
                _ => None,
            },
            dates: self.dates.clone(),
        })
    }

    /// The latest of a survey as it is chosen, with the records that are named beside it, each with its date.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read), and [`AnswerError::Argument`] for records without dates.
    pub fn of_dates(
        &self,
        survey: Survey,
        now: Option<&Path>,
        layout: &RecordLayout,
        choose: &[String],
        client: &dyn Client,
    ) -> Result<Survey> {
        if !self.earlier.is_empty() && self.dates.is_empty() {
            let rule = "given beside --earlier: the date of each record, that of now last";
            return Err(AnswerError::argument("--dates", "left out", rule));
        }
        let (survey, _) = survey.choose(choose)?.latest();
        Ok(self.read(now, layout, choose, client)?.before(survey, None))
    }
}

/// What was measured of a rail before now, the oldest first.
pub struct History {
    /// All that were named.
    pub surveys: Vec<Survey>,
    /// The oldest and now place by place, where both are profiles: more records tell how sure a change is.
    pub places: Option<[Survey; 2]>,
    dates: Vec<Date>,
}

impl History {
    /// Date of now, and the days since the oldest; none without dates.
    pub fn days(&self) -> Option<(Date, f64)> {
        let (oldest, latest) = (self.dates.first()?, self.dates.last()?);
        Some((*latest, days_between(*oldest, *latest)?))
    }

    /// The survey of now with these before it, at their dates or else, of one, so many axle passages ago; unless it is of several dates.
    pub fn before(&self, mut now: Survey, passages: Option<f64>) -> Survey {
        if now.history.is_some() || self.surveys.is_empty() {
            return now;
        }
        let latest = self.dates.last();
        let days = (self.dates.iter()).map(|date| days_between(*date, *latest?));
        let (ago, elapsed) = match (passages, days.collect::<Option<Vec<f64>>>()) {
            (Some(passages), _) if self.surveys.len() == 1 => (vec![passages], Elapsed::Passages),
            (_, Some(days)) if !days.is_empty() => (days, Elapsed::Days),
            _ => return now,
        };
        let dated = |now: &Survey, surveys: &[Survey]| {
            let earlier = ago.iter().copied().zip(surveys.iter().cloned());
            RailDates::new(now, earlier.collect(), elapsed)
        };
        now.history = Some(match (&self.places, &self.surveys[..]) {
            (Some([before, now]), [_]) => dated(now, std::slice::from_ref(before)),
            _ => dated(&now, &self.surveys),
        });
        now
    }
}

fn days_between(earlier: Date, later: Date) -> Option<f64> {
    Some(f64::from(later.since(earlier).ok()?.get_days()))
}
