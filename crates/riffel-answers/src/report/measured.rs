//! What was measured of the rail of a report, now and before.

use std::sync::Arc;

use jiff::civil::Date;
use riffel::roughness::GrindSettings;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Variant};
use riffel_keys::{Message, number, say};
use riffel_rail::{RoughnessFile, Survey};

use super::working::Working;
use super::{MeasuredRoughness, ProfileStrips, block_of_strip};
use crate::diagnose::Diagnosis;
use crate::forecast::WearReport;
use crate::question::choose_nothing;
use crate::roughness::{ProfileAnswer, ProfileRequest, SpectraAnswer};
use crate::{AnswerError, Result, level_limit};

/// What was measured of the rail.
pub(super) struct Measured {
    roughness: MeasuredRoughness,
    /// What the file was understood as.
    pub(super) understood: Message,
    /// The latest date of a table of spectra.
    date: Option<Date>,
    /// The latest spectra, with what is to be said of them.
    survey: Survey,
    /// The earliest of a table of several dates.
    before: Option<Before>,
    diagnosis: Option<Diagnosis>,
}

/// What the record says of now.
pub(super) struct Now {
    pub(super) survey: Survey,
    pub(super) date: Option<Date>,
    /// Mean speed of the traffic \[m/s\].
    pub(super) speed: f64,
}

/// The rail as it was before.
#[derive(Clone)]
pub(super) struct Before {
    survey: Survey,
    places: Option<[Survey; 2]>,
    date: Option<Date>,
}

impl Measured {
    /// The roughness, and the rest that a page says of the rail: warnings and diagnosis.
    pub(super) fn apart(self) -> (MeasuredRoughness, (Vec<Message>, Option<Diagnosis>)) {
        (self.roughness, (self.survey.warnings, self.diagnosis))
    }
}

impl Before {
    /// The earliest records of a table of several dates.
    fn of_table(survey: &Survey) -> Option<Self> {
        let dates = survey.by_date(survey.column_of_several_dates()?).ok()?;
        let (date, survey) = dates.into_iter().next()?;
        Some(Self { survey, places: None, date: Some(date) })
    }
}

impl Working<'_> {
    /// What was measured, held to limits and diagnosed.
    pub(super) fn measured(&self, case: Option<&Case>) -> Result<Option<Measured>> {
        let (asked, limits) = (&self.question.rail, &self.limits);
        let Some(file) = &self.question.roughness else {
            return Ok(None);
        };
        let path = file.name();
        let file = file.value(|path| asked.layout.read(path, self.client))?;
        // The diagnosis looks at the heights, which the statistics use up.
        let diagnosis = case.map(|case| asked.diagnosis(case, path, &file, self.client)).transpose()?;
        Ok(Some(match Arc::unwrap_or_clone(file) {
            RoughnessFile::Profile(profile) => {
                choose_nothing(path, &asked.choose, asked.by.as_deref())?;
                let strips = ProfileStrips::new(&profile, self.client.language())?;
                let growing = asked.layout.growing(RoughnessFile::Profile(profile.clone()));
                let survey = Survey::of(path, growing)?;
                let before = Before::of_table(&survey);
                let (survey, date) = survey.latest();
                let request = ProfileRequest {
                    longest: None,
                    window: None,
                    block: block_of_strip(&profile),
                    grinding: GrindSettings::default(),
                };
                let answer = Box::new(ProfileAnswer::new(path, profile, limits, &request, self.client)?);
                let understood = answer.understood();
                let roughness = MeasuredRoughness::Profile { strips, answer };
                Measured { roughness, understood, date, survey, before, diagnosis }
            }
            RoughnessFile::Spectra(spectra, warnings) => {
                let survey = Survey::new(path, spectra, warnings)?.choose(&asked.choose)?;
                let by = asked.by.as_deref().or_else(|| survey.date_column());
                let before = Before::of_table(&survey);
                let answer = SpectraAnswer::new(&survey, limits, by)?;
                let understood = match (answer.count(), &asked.choose[..]) {
                    (count, []) => say!(one_third_octave_spectra, count),
                    (count, choose) => say!(chosen_spectra, count = number(count), choices = choose.join(", ")),
                };
                let (survey, date) = survey.latest();
                Measured { roughness: MeasuredRoughness::Spectra(answer), understood, date, survey, before, diagnosis }
            }
        }))
    }

    /// What the record says of now; none without a diagnosis, for the speeds are its.
    pub(super) fn now(&self, rail: &Measured) -> Option<Now> {
        Some(Now {
            speed: rail.diagnosis.as_ref()?.speeds.mean(),
            survey: rail.survey.clone(),
            date: rail.date.or_else(|| self.question.rail.earlier.dates.last().copied()),
        })
    }

    /// The oldest of the earlier records that are named, with all of which the rail of now has a history, or else the earliest of its table.
    pub(super) fn before(&self, rail: Option<&Measured>, now: Option<&mut Now>) -> Result<Option<Before>> {
        let (question, asked) = (self.question, &self.question.rail);
        let path = question.roughness.as_ref().and_then(|file| file.path());
        let history = asked.earlier.read(path, &asked.layout, &asked.choose, self.client)?;
        let before = match history.surveys.first() {
            Some(oldest) => {
                let (survey, written) = oldest.clone().latest();
                if let Some(now) = now {
                    now.survey = history.before(now.survey.clone(), question.passages_between);
                }
                let date = asked.earlier.dates.first().copied().or(written);
                Some(Before { survey, places: history.places, date })
            }
            None => rail.and_then(|rail| rail.before.clone()),
        };
        match (question.passages_between, &before) {
            (Some(passages), None) => Err(AnswerError::argument(
                "--passages-between",
                passages,
                "left out, for there is no earlier record; give --earlier",
            )),
            _ => Ok(before),
        }
    }

    /// The fit of the change from before to now under the traffic, or why there is none.
    pub(super) fn fit(
        &self,
        case: &Case,
        traffic: &Traffic,
        before: &Before,
        now: &Now,
    ) -> Result<Result<WearReport, Message>> {
        let step = self.client.begin(say!(progress_fit), traffic.file.vehicle.len());
        let on = traffic.on(case, &bands_of(case), &Variant::none(""), &step)?;
        let by_date = || {
            let days = now.date?.since(before.date?).ok()?.get_days();
            (days > 0).then(|| on.passages_in(f64::from(days))).flatten()
        };
        let Some(passages) = self.question.passages_between.or_else(by_date) else {
            return Ok(Err(say!(not_fitted_without_passages)));
        };
        let limit = self.level_limit.as_deref().map(level_limit).transpose()?.map(|(_, limit)| limit);
        let places = before.places.as_ref();
        let report = WearReport::since(&before.survey, places, &now.survey, (case, &on), limit.as_ref(), passages);
        Ok(report.map_err(|error| say!(coefficient_not_fitted, reason = error.message())))
    }
}
