//! A spectrum under traffic, and what would help.

use std::path::PathBuf;

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel::forecast::{Reach, SpeedDistribution};
use riffel_answers::forecast::{CrackedWave, HardenedWave, WearReport};
use riffel_case::Variant;
use riffel_case::traffic::{Line, Traffic, TrafficOnCase, UsualTraffic, bands_of};
use riffel_keys::Message;
use riffel_rail::{Elapsed, Layout, RailDates};

use crate::array::owned;
use crate::begins::{Begins, GivenDates, GivenGround};
use crate::case::Case;
use crate::document::document;
use crate::errors::{of_answer, of_case, of_physics, wrong};
use crate::records::{GivenRoughness, places_of_both, survey};
use crate::tables;

/// A traffic file, its keys, or the wheel of the case at speeds of a mean and a standard deviation.
#[derive(FromPyObject)]
pub(crate) enum GivenTraffic<'py> {
    File(PathBuf),
    Keys(Bound<'py, PyDict>),
    Speeds((f64, f64)),
}

impl GivenTraffic<'_> {
    pub(crate) fn traffic(&self) -> PyResult<Traffic> {
        match self {
            Self::File(path) => Traffic::read(path).map_err(of_case),
            Self::Keys(keys) => Traffic::parse("", &tables::table(keys, "")?.to_string()).map_err(of_case),
            Self::Speeds((mean, deviation)) => {
                let speeds = SpeedDistribution::normal(*mean, *deviation);
                Ok(Traffic::of_case(speeds.map_err(of_physics)?))
            }
        }
    }
}

/// The traffic that was given, or the usual one of the line of the case, of which no amount is assumed.
pub(crate) fn traffic_of(case: &Case, given: Option<&GivenTraffic<'_>>) -> PyResult<Traffic> {
    let Some(given) = given else {
        let mut traffic = UsualTraffic::of(&case.case).traffic().map_err(of_case)?;
        traffic.file.line = Line::default();
        return Ok(traffic);
    };
    given.traffic()
}

type Real<'py> = Bound<'py, PyArray1<f64>>;

/// Messages as English sentences.
fn in_words(remarks: &[Message]) -> Vec<String> {
    remarks.iter().map(ToString::to_string).collect()
}

/// Passages after which levels are asked for, by one of three measures; those of a year if none is given.
fn passages_of(
    on: &TrafficOnCase,
    passages: Option<PyReadonlyArray1<'_, f64>>,
    mgt: Option<PyReadonlyArray1<'_, f64>>,
    months: Option<PyReadonlyArray1<'_, f64>>,
) -> PyResult<Vec<f64>> {
    Ok(match (passages, mgt, months) {
        (Some(passages), None, None) => owned(&passages),
        (None, Some(mgt), None) => owned(&mgt).iter().map(|&mgt| on.growth.passages(mgt)).collect(),
        (None, None, months) => {
            let per_month = on.passages_per_month().ok_or_else(|| {
                wrong("months needs traffic with passages_per_day or mgt_per_year under [line]; give passages or mgt")
            })?;
            let months = months.map_or_else(|| vec![12.0], |months| owned(&months));
            months.iter().map(|months| per_month * months).collect()
        }
        _ => {
            return Err(wrong("give only one of passages, mgt and months"));
        }
    })
}

/// The bands of a forecast with all that is said of them.
#[pyfunction]
pub(crate) fn forecast<'py>(
    py: Python<'py>,
    case: &Case,
    measured: Option<GivenDates<'py>>,
    ground: GivenGround,
    traffic: Option<GivenTraffic<'py>>,
    passages: Option<PyReadonlyArray1<'py, f64>>,
    mgt: Option<PyReadonlyArray1<'py, f64>>,
    months: Option<PyReadonlyArray1<'py, f64>>,
    limit: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let (table, limit) = riffel_answers::level_limit(limit).map_err(of_answer)?;
    let begins = Begins::new(measured, ground, &limit, &table.edition)?;
    if begins.starts(None).is_empty() {
        return Err(wrong("give spectrum, ground or from_limit"));
    }
    let traffic = traffic_of(case, traffic.as_ref())?;
    let on = case.compute(py, move |case| traffic.on(case, &bands_of(case), &Variant::none(""), &|_| ()))?;
    let on = on.map_err(of_case)?;
    let starts = begins.starts(on.passages_per_day);
    let forecast = starts[0].forecast(&on).map_err(of_physics)?;
    let passages = passages_of(&on, passages, mgt, months)?;
    let bands = forecast.bands();
    let column = |value: &dyn Fn(&riffel::forecast::ForecastBand) -> f64| -> Real<'py> {
        bands.iter().map(value).collect::<Vec<_>>().into_pyarray(py)
    };
    let reaches = forecast.reaches(&limit);
    let reach = |band: &riffel::forecast::ForecastBand| reaches.iter().find(|reach| reach.0 == band);
    let mut grown = Vec::with_capacity(passages.len() * bands.len());
    for &passages in &passages {
        let levels = bands.iter();
        grown.extend(levels.map(|band| forecast.level(band, passages).unwrap_or(f64::NAN)));
    }
    let grown: Bound<'py, PyArray2<f64>> = grown.into_pyarray(py).reshape([passages.len(), bands.len()])?;
    let linear = forecast.linear_range(bands);
    let result = PyDict::new(py);
    let mgt: Vec<f64> = passages.iter().map(|&passages| on.growth.mgt(passages)).collect();
    let end = passages.iter().copied().fold(0.0, f64::max);
    let end = end.min(forecast.valid_to());
    let cracks = CrackedWave::all(&forecast, &on, end);
    let findings = [HardenedWave::in_words(&forecast, &on), CrackedWave::in_words(&cracks, &on, end)];
    let findings: Vec<Message> = findings.into_iter().flatten().collect();
    result.set_item("findings", in_words(&findings))?;
    result.set_item("hardening", document(py, &HardenedWave::all(&forecast))?)?;
    result.set_item("cracks", document(py, &cracks)?)?;
    result.set_item("passages", passages.into_pyarray(py))?;
    result.set_item("mgt", mgt.into_pyarray(py))?;
    result.set_item("level", grown)?;
    result.set_item("wavelength", column(&|band| band.now.band.wavelength()))?;
    result.set_item("nominal", column(&|band| band.now.band.nominal_millimetres()))?;
    result.set_item("now", column(&|band| band.now.level))?;
    result.set_item("growth_rate", column(&|band| forecast.growth_rate(band)))?;
    result.set_item("limit", column(&|band| reach(band).map_or(f64::NAN, |found| found.1)))?;
    result.set_item(
        "passages_to_limit",
        column(&|band| match reach(band).map(|found| found.2) {
            Some(Reach::After(passages)) => passages,
            Some(Reach::BeyondLinearRange) => f64::NAN,
            Some(Reach::Never) | None => f64::INFINITY,
        }),
    )?;
    let interval = forecast.grinding_interval(&limit);
    result.set_item("grinding_interval", interval.passages())?;
    result.set_item("limit_reached", interval.name())?;
    result.set_item("passages_per_day", on.passages_per_day)?;
    result.set_item("linear_force_ratio", linear.force_ratio)?;
    result.set_item("linear_passages", linear.passages)?;
    let mut remarks = on.remarks;
    remarks.extend(begins.remark(on.passages_per_day));
    result.set_item("remarks", in_words(&remarks))?;
    Ok(result)
}

/// The wear coefficient of two measurements: what `riffel forecast --json` says of it.
#[pyfunction]
pub(crate) fn fit_wear<'py>(
    py: Python<'py>,
    case: &Case,
    earlier: (PathBuf, GivenRoughness<'py>),
    later: (PathBuf, GivenRoughness<'py>),
    passages: Option<f64>,
    days: Option<f64>,
    traffic: Option<GivenTraffic<'py>>,
    limit: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let layout = Layout::default();
    let (_, limit) = riffel_answers::level_limit(limit).map_err(of_answer)?;
    let [earlier, mut later] = match places_of_both(py, &earlier, &later, &layout)? {
        Some(places) => places,
        None => {
            let latest = |given| Ok::<_, PyErr>(survey(py, given, &layout)?.latest().0);
            [latest(&earlier)?, latest(&later)?]
        }
    };
    let traffic = traffic_of(case, traffic.as_ref())?;
    let report = case.compute(py, move |case| {
        let on = traffic.on(case, &bands_of(case), &Variant::none(""), &|_| ())?;
        let Some(passages) = passages.or_else(|| on.passages_in(days?)) else {
            return Ok(None);
        };
        // The rail that leads by how each has grown, as in a forecast of these two dates.
        let history = RailDates::new(&later, vec![(passages, earlier.clone())], Elapsed::Passages);
        later.history = Some(history);
        WearReport::since(&earlier, None, &later, (case, &on), Some(&limit), passages).map(Some)
    })?;
    let report = report
        .map_err(of_case)?
        .ok_or_else(|| wrong("days needs traffic with passages_per_day or mgt_per_year under [line]; give passages"))?;
    document(py, &report)
}
