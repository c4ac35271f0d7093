//! # Answers
//!
//! Every question that Riffel answers, once: what is asked, what is computed, and what it is as data, as tables and
//! as a figure. The program prints answers, the page sends them, the Python package converts them.
//!
//! `riffel_case` knows the case and no question; `riffel_plot` draws and knows no physics.
//!
//! ```
//! use riffel_answers::map::MapAnswer;
//! use riffel_case::{Case, NOMINAL_CASE};
//!
//! let window = ["map.wavelength.points=11", "map.speed.points=5"].map(str::to_owned);
//! let case = Case::parse("nominal", NOMINAL_CASE, &window)?;
//! let answer = MapAnswer::new(&case, |_| ());
//! let document = serde_json::to_value(&answer)?;
//! assert_eq!(document["ridge"]["speeds"], 5);
//! assert!(answer.map_figure().picture()?.svg().starts_with("<svg"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
pub mod axlebox;
mod banded;
mod calibrate;
mod calibration;
pub mod calibration_check;
mod calibration_plan;
pub mod calibration_question;
mod capital;
mod cause;
mod column;
pub mod compare;
pub mod competing_models;
mod complex;
pub mod contact;
pub mod curve;
pub mod decide;
mod defect;
pub mod diagnose;
mod error;
mod expected_growth;
#[cfg(not(target_family = "wasm"))]
mod fingerprint;
pub mod forecast;
mod grinding_interval;
mod growth_lines;
mod highest;
mod level_limit;
mod line_growth;
pub mod map;
pub mod map_question;
mod mode_in_words;
pub mod models;
mod netcdf;
#[cfg(not(target_family = "wasm"))] // its store is a folder
pub mod network;
pub mod noise;
mod number_alone;
mod outlying;
mod over_posterior;
mod pads;
pub mod page;
pub mod paper;
mod parameters;
pub mod point;
pub mod presets;
pub mod profile;
pub mod question;
pub mod rail_damage;
pub mod receptance;
pub mod remedies;
#[cfg(not(target_family = "wasm"))] // its page is drawn
pub mod report;
pub mod ridge;
pub mod roughness;
pub mod shakedown;
mod side;
pub mod simulate;
mod stability;
pub mod stability_map;
pub mod stress;
pub mod study;
mod table;
mod track_in_words;
mod wear_limit;
pub mod wheels;
pub mod wheelset;
pub mod wheelset_motions;

pub use answer::{Answer, Document, Existing, OwnText, Printed, ResultFile};
pub use banded::Banded;
pub use calibration::Calibration;
pub use calibration_plan::CalibrationPlan;
pub use capital::sentence;
pub use cause::Cause;
pub use error::{AnswerError, Result};
pub use expected_growth::ExpectedRates;
#[cfg(not(target_family = "wasm"))]
pub use fingerprint::fingerprint;
pub use grinding_interval::GrindingInterval;
pub use highest::Highest;
pub use level_limit::level_limit;
pub use line_growth::{FastestGrowth, LineGrowth};
pub use mode_in_words::mode_in_words;
pub use netcdf::Grid;
pub use number_alone::number_alone;
pub use over_posterior::{NumberOverPosterior, OverPosterior, PosteriorDraws};
pub use parameters::parameters;
pub(crate) use table::Rows;
pub use table::{Column, Table, Values};
pub use track_in_words::place;
pub(crate) use wear_limit::wear_spread;
pub use wear_limit::{WearLimitDocument, for_whom, unlikely_wear};

/// All questions that are data.
pub static QUESTIONS: &[&dyn question::AnyQuestion] = &[
    &question::of::<point::PointQuestion>(),
    &question::of::<map_question::MapQuestion>(),
    &question::of::<receptance::ReceptanceQuestion>(),
    &question::of::<wheelset::WheelsetQuestion>(),
    &question::of::<simulate::SimulateQuestion>(),
    &question::of::<contact::ContactQuestion>(),
    &question::of::<profile::ProfileQuestion>(),
    &question::of::<curve::CurveQuestion>(),
    &question::of::<roughness::RoughnessQuestion>(),
    &question::of::<axlebox::AxleBoxQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::IngestQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::StatusQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::WorstQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::GrowthQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::PlanQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::ChartQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<network::CheckQuestion>(),
    &question::of::<diagnose::DiagnoseQuestion>(),
    #[cfg(not(target_family = "wasm"))]
    &question::of::<report::ReportQuestion>(),
    &question::of::<forecast::ForecastQuestion>(),
    &question::of::<compare::CompareQuestion>(),
    &question::of::<noise::NoiseQuestion>(),
    &question::of::<shakedown::ShakedownQuestion>(),
    &question::of::<stability_map::StabilityQuestion>(),
    &question::of::<study::StudyQuestion>(),
    &question::of::<study::MergeQuestion>(),
    &question::of::<study::SensitivityQuestion>(),
    &question::of::<calibration_question::CalibrateQuestion>(),
    &question::of::<calibration_check::CheckQuestion>(),
    &question::of::<decide::DecideQuestion>(),
    &question::of::<presets::PresetsQuestion>(),
];

/// What the page asks about files beside [`QUESTIONS`]: no command has these names.
static QUESTIONS_OF_THE_PAGE: &[&dyn question::AnyQuestion] =
    &[&question::of::<page::along::AlongQuestion>(), &question::of::<page::measure::MeasureQuestion>()];

/// The listings of the book, compiled and run.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../../../docs/src/adding-a-command.md")]
    mod command {}
}
