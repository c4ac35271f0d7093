//! # A network: many lines, many dates
//!
//! Surveys of a line, RMS of roughness in bands of wavelength along its rails, as `riffel roughness` and `riffel axlebox`
//! write them, go into a [`Store`] on a grid of places that all dates share. What is asked of it streams: [`Sections`] of
//! the latest surveys, [`worst`] places, [`growth`] between dates, a [`plan`] of grinding, a [`StripChart`] of all dates. Memory does not grow with the
//! network but by a row for each section.
//!
//! ```
//! use riffel_network::{Store, StoreSettings, SurveyFile};
//!
//! # let folder = tempfile::tempdir()?;
//! # let survey = folder.path().join("blocks.csv");
//! std::fs::write(&survey, "rail,from_m,to_m,rms_30_to_100_mm_m\nleft,0,10,5e-6\nleft,10,20,6e-6\n")?;
//! let store = Store::create_or_open(&folder.path().join("network"), StoreSettings { resolution: Some(10.0) })?;
//! let file = SurveyFile::check(&survey)?;
//! store.ingest("Main line", "2026-01-31", &file, false, &|_| ())?;
//! assert_eq!(store.surveys()?.len(), 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod alignment;
mod error;
mod grid;
mod growth;
mod ingest;
mod judgement;
mod layout;
mod most_track;
mod name;
mod plan;
mod rails;
mod record;
mod sections;
mod single_places;
mod status;
mod store;
mod strip_chart;
mod survey_file;
mod survey_text;
mod surveys;
mod trend;
mod worst;

pub use error::NetworkError;
pub use growth::{SectionGrowth, growth, left_out_of_growth};
pub use ingest::Ingested;
pub use judgement::{DefectKind, ExpectedGrowth, Judgement};
pub use plan::{Aim, Budget, GrindingPlan, PlannedSection, plan};
pub use record::{RailRecord, SurveyRecord};
pub use sections::{Section, Sections};
pub use status::{LineStatus, Status, status};
pub use store::{Store, StoreSettings};
pub use strip_chart::{ChartedLine, ChartedSection, ChartedSurvey, StripChart};
pub use survey_file::{GoesBack, SurveyFile};
pub use worst::{WorstPlace, worst};
