//! The wear coefficient of two dated measurements, on the command line.

use riffel::roughness::LevelLimit;
use riffel_answers::forecast::{ForecastAnswer, WearReport, rail_to_fit};
use riffel_case::Case;
use riffel_case::traffic::TrafficOnCase;
use riffel_keys::CaseError;
use riffel_rail::{RailDates, Survey};

use super::dated::Dated;
use crate::arguments::Spectra;
use crate::error::CliError;
use crate::messages::language;
use crate::output::table;

/// A fit, where there is an earlier measurement.
pub(super) fn wear_report(
    spectra: &Spectra,
    dated: &Dated,
    case: &Case,
    answer: &ForecastAnswer,
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
    let is_asked = spectra.date_column.is_some()
        || !spectra.earlier.files.is_empty()
        || !spectra.earlier_choose.is_empty();
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
    pub(crate) fn new(
        oldest: &'a Survey,
        now: &'a Survey,
        places: Option<&'a [Survey; 2]>,
    ) -> Self {
        Self {
            oldest,
            now,
            places,
        }
    }

    /// The fit of the change of one rail, of so many passages since the oldest record or its part since the rail was ground; under a
    /// limit the rail that leads.
    pub(crate) fn fit(
        &self,
        case: &Case,
        on: &TrafficOnCase,
        limit: Option<&LevelLimit>,
        passages: f64,
    ) -> Result<WearReport, CaseError> {
        let rail = rail_to_fit(case, self.now, on, limit);
        let rail = rail.as_deref();
        let history = self.now.of_rail(rail).and_then(|own| own.history);
        if let Some((share, earlier)) = history.as_ref().and_then(RailDates::since_ground) {
            return WearReport::new(on, rail, earlier, self.now, share * passages);
        }
        let [earlier, now] = match self.places {
            Some([oldest, now]) => [oldest, now],
            None => [self.oldest, self.now],
        };
        WearReport::new(on, rail, earlier, now, passages)
    }
}

/// A fit as a table and in words.
pub(super) fn readable(report: &WearReport) -> String {
    let claimed = report.fit.verdict.is_fit();
    let mut rows = table(&[
        "wavelength mm",
        "measured dB",
        "model dB",
        "fitted dB",
        "residual dB",
        "",
    ]);
    for band in report.fit.bands.iter().rev() {
        let fitted = |value: f64| match claimed {
            true => format!("{value:+.1}"),
            false => String::new(),
        };
        rows.add_row([
            format!("{}", band.band.nominal_millimetres()),
            format!("{:+.1}", band.measured),
            format!("{:+.1}", band.predicted),
            fitted(band.fitted),
            fitted(band.residual()),
            match (band.grows, band.predicted > 0.0) {
                (true, _) => "",
                (false, false) => "decays in the model",
                (false, true) => "decays at first in the model",
            }
            .to_owned(),
        ]);
    }
    let [earlier, later] = report.records;
    let pairs = if report.fit.paired {
        ", paired by place"
    } else {
        ""
    };
    let mut text = format!(
        "change over {:.2e} axle passages between {earlier} and {later} records{pairs}\n{rows}\n",
        report.passages
    );
    for sentence in report.sentences().into_iter().chain(report.advice()) {
        text += &format!("{}\n", sentence.text(language()));
    }
    text
}
