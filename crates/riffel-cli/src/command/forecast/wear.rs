//! The wear coefficient of two dated measurements, on the command line.

use riffel::roughness::LevelLimit;
use riffel_answers::forecast::{TrackForecast, WearReport, rail_to_fit};
use riffel_case::Case;
use riffel_case::traffic::TrafficOnCase;
use riffel_keys::CaseError;
use riffel_rail::{RailDates, Survey};

use super::dated::Dated;
use crate::arguments::Spectra;
use crate::error::CliError;

/// A fit, where there is an earlier measurement.
pub(super) fn wear_report(
    spectra: &Spectra,
    dated: &Dated,
    case: &Case,
    answer: &TrackForecast,
) -> miette::Result<Option<WearReport>> {
    let Some(earlier) = &dated.earlier else {
        if spectra.passages_between.is_some() {
            Err(CliError::Argument {
                argument: "--passages-between",
                value: "given".to_owned(),
                rule: "left out, for there is no earlier measurement; give --earlier, --earlier-where or \
                       --date-column"
                    .to_owned(),
            })?;
        }
        return Ok(None);
    };
    let by_date = dated.days.and_then(|days| answer.on.passages_in(days));
    // A table of several dates is fitted by itself, if it can be.
    let is_asked =
        spectra.date_column.is_some() || !spectra.earlier.files.is_empty() || !spectra.earlier_choose.is_empty();
    let measured = Measured::new(earlier, &dated.now, dated.places.as_ref());
    let fit = |passages| measured.fit(case, &answer.on, Some(&answer.limit), passages);
    match spectra.passages_between.or(by_date) {
        Some(passages) if is_asked => Ok(Some(fit(passages)?)),
        Some(passages) => Ok(fit(passages).ok()),
        None if is_asked => Err(CliError::Argument {
            argument: "--passages-between",
            value: "left out".to_owned(),
            rule: "given, or else --dates or --date-column, and a traffic file that says how much traffic there is"
                .to_owned(),
        }
        .into()),
        None => Ok(None),
    }
}

/// Rails as they were measured before and now.
pub(crate) struct Measured<'a> {
    oldest: &'a Survey,
    now: &'a Survey,
    /// Both place by place, where they are profiles: more of them tell how sure a change is.
    places: Option<&'a [Survey; 2]>,
}

impl<'a> Measured<'a> {
    /// Rails with their oldest record, and where both are profiles place by place.
    pub(crate) fn new(oldest: &'a Survey, now: &'a Survey, places: Option<&'a [Survey; 2]>) -> Self {
        Self { oldest, now, places }
    }

    /// The fit of how one rail has changed, by so many passages since the oldest record: of several rails that of the case, or else the
    /// one that leads under a limit. It begins where that rail was last ground.
    pub(crate) fn fit(
        &self,
        case: &Case,
        on: &TrafficOnCase,
        limit: Option<&LevelLimit>,
        passages: f64,
    ) -> Result<WearReport, CaseError> {
        let rail = rail_to_fit(case, self.now, on, limit);
        let rail = rail.as_deref();
        let history = self.now.clone().of_rail(rail).and_then(|own| own.history);
        if let Some((share, earlier)) = history.as_ref().and_then(RailDates::since_ground) {
            return WearReport::new(on, rail, earlier, self.now, share * passages);
        }
        let places = self.places.map(|[oldest, now]| [oldest, now]);
        let [earlier, now] = places.unwrap_or([self.oldest, self.now]);
        WearReport::new(on, rail, earlier, now, passages)
    }
}
