//! Surveys of many lines and dates, told.

mod chart;
mod growth;
mod ingested;
mod plan;
mod questions;
mod status;
mod whole;
mod words;
mod worst;

pub use chart::ChartAnswer;
pub use growth::GrowthAnswer;
pub use ingested::IngestedAnswer;
pub use plan::PlanAnswer;
pub use questions::{
    ChartQuestion, CheckQuestion, GrowthQuestion, IngestQuestion, PlanQuestion, StatusQuestion, WorstQuestion,
};
pub use status::StatusAnswer;
pub use whole::WholeAnswer;
pub use worst::WorstAnswer;
