//! The future of a rail, and its place in a report.

use std::path::Path;

use riffel::roughness::Spectrum;
use riffel_answers::AnswerError;
use riffel_answers::forecast::{ForecastHorizon, ForecastRequest, TrackForecast};
use riffel_answers::map::MapAnswer;
use riffel_answers::report::{Inputs, MeasuredRail, MeasuredRoughness, ReportRequest, Site, report};
use riffel_answers::roughness::SpectraAnswer;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, CurvingCase, METRO_CURVE_CASE, NOMINAL_CASE, TRAFFIC, on_curve};
use riffel_keys::{Language, Message, say};
use riffel_rail::{LabelledSpectrum, Limit, LimitTable, Survey};

fn case() -> Case {
    let window = ["map.wavelength.points=21", "map.speed.points=5"].map(str::to_owned);
    Case::parse("case.toml", NOMINAL_CASE, &window).unwrap()
}

/// A rail whose bands are all at one level.
fn survey(case: &Case) -> Survey {
    let levels = bands_of(case).into_iter().map(|band| (band, -8.0));
    let record = LabelledSpectrum::of_rail("left", Spectrum::new(levels).unwrap());
    Survey::new(Path::new("rail.csv"), vec![record], Vec::new()).unwrap()
}

/// The first table of levels that is built in.
fn limit() -> LimitTable {
    let mut tables = LimitTable::all().into_iter();
    tables.find(|table| matches!(table.limit, Limit::Levels(_))).unwrap()
}

fn forecast(case: &Case, horizon: ForecastHorizon) -> Result<TrackForecast, AnswerError> {
    forecast_of(case, TRAFFIC, survey(case), horizon)
}

fn forecast_of(
    case: &Case,
    traffic: &str,
    survey: Survey,
    horizon: ForecastHorizon,
) -> Result<TrackForecast, AnswerError> {
    let table = limit();
    let Limit::Levels(levels) = table.limit.clone() else {
        panic!("{} is a table of levels", table.name);
    };
    let request = ForecastRequest {
        traffic: Traffic::parse("traffic.toml", traffic)?,
        survey: Some(survey),
        ground: None,
        horizon,
        limit: (table, levels),
        date: None,
        tells_spreads: true,
    };
    TrackForecast::new(case, request, &|_| ())
}

#[test]
fn a_horizon_is_above_zero_and_within_a_thousand_years() {
    for (horizon, part) in [
        (ForecastHorizon::Passages(f64::NAN), "--passages is NaN"),
        (ForecastHorizon::MillionGrossTonnes(-1.0), "--mgt is -1"),
        (ForecastHorizon::Months(f64::INFINITY), "--months is inf"),
        (ForecastHorizon::Months(0.0), "--months is 0"),
        (ForecastHorizon::Months(12_001.0), "--months is 12001"),
        (ForecastHorizon::MillionGrossTonnes(1e300), "--mgt is 1"),
    ] {
        let error = forecast(&case(), horizon).err().unwrap().to_string();
        assert!(error.contains(part), "{error}");
        assert!(error.contains("must be above zero and at most 1"), "{error}");
    }
}

/// A rail that was not diagnosed has a forecast all the same, and the report says that it was given.
#[test]
fn a_report_needs_no_diagnosis_for_its_forecast() -> Result<(), AnswerError> {
    let case = case();
    let survey = survey(&case);
    let limits = [limit()];
    let forecast = forecast(&case, ForecastHorizon::Months(12.0))?;
    let map = MapAnswer::new(&case, |_| ());
    let page = report(ReportRequest {
        language: Language::English,
        title: None,
        site: &Site::default(),
        limits: &limits,
        rail: Some(MeasuredRail {
            path: survey.path(),
            roughness: MeasuredRoughness::Spectra(SpectraAnswer::new(&survey, &limits, None)?),
            warnings: &survey.warnings,
            diagnosis: None,
        }),
        case: Some((&case, &map)),
        forecast: Ok(&forecast),
        posterior_forecast: None,
        compare: Err(say!(no_variant_given)),
        noise: Err(Message::verbatim("no train was given")),
        inputs: &Inputs::default(),
    })?;
    assert!(page.contains("One-third-octave levels under"), "{page}");
    assert!(page.contains("the roughness was not diagnosed."), "{page}");
    assert!(!page.contains("no roughness was given."), "{page}");
    Ok(())
}

/// A wheel of a curve is on one rail, wherever the curve is written: the others are said to be given its growth.
#[test]
fn rails_of_a_curve_in_another_file_are_said_to_grow_alike() -> Result<(), AnswerError> {
    let folder = tempfile::tempdir().unwrap();
    let curve = CurvingCase::parse("curve", METRO_CURVE_CASE, &[])?;
    std::fs::write(folder.path().join("curve.toml"), curve.toml()).unwrap();
    let case = on_curve(&case(), folder.path(), "curve.toml")?;
    let levels = || bands_of(&case).into_iter().map(|band| (band, -8.0));
    let rail = |name| LabelledSpectrum::of_rail(name, Spectrum::new(levels()).unwrap());
    let survey = Survey::new(Path::new("rail.csv"), vec![rail("left"), rail("right")], Vec::new())?;
    let (line, _) = TRAFFIC.split_once("[[vehicle]]").unwrap();
    let traffic = format!("{line}[[vehicle]]\nname = \"metro\"\nshare = 1\nspeed.mean = \"60 km/h\"\n");
    let answer = forecast_of(&case, &traffic, survey, ForecastHorizon::Months(1.0))?;
    let said = say!(all_rails_grow_alike, of_rail = say!(of_low));
    assert!(answer.warnings.contains(&said), "{:?}", answer.warnings);
    Ok(())
}
