//! # Studies: many cases of one kind
//!
//! A [`Plan`] says which keys of a case vary and how, by which design, and what is wanted of each sample. A
//! [`Study`] computes any of its samples by its number alone. A [`ResultFolder`] keeps them as zarr arrays, chunk
//! by chunk, so that a study that was stopped goes on where it stopped and any number of processes may share the
//! work. [`sensitivity`] says which parameters matter.
//!
//! ```no_run
//! use riffel_study::{ResultFolder, Shard, Study};
//!
//! let study = Study::read("study.toml".as_ref())?;
//! let folder = ResultFolder::begin(&study, "results".as_ref())?;
//! for chunk in folder.pending(Shard::ALL)? {
//!     folder.commit(&study.compute(chunk))?;
//! }
//! # Ok::<(), riffel_study::StudyError>(())
//! ```
//!
//! Samples do not depend on each other, on the number of threads, on the size of the chunks or on the machine that
//! computes them: the same plan gives the same numbers bit for bit.

mod correlation;
pub mod design;
mod error;
mod fingerprint;
mod outputs;
mod parameter;
mod plan;
mod results;
mod run;
pub mod sensitivity;
mod shard;
mod study;

pub use design::Design;
pub use error::StudyError;
pub use outputs::{Band, Dimension, Outputs, Variable, WaveQuantity};
pub use parameter::{Parameter, ParameterValue, Spread};
pub use plan::{Plan, distribution, file};
pub use results::{ChunkState, MergeReport, Reason, ResultFolder, Summary};
pub use run::Stop;
pub use shard::Shard;
pub use study::{Chunk, Sample, Study};

/// `cases/study.toml`, commented: the plan that `riffel init --study` writes.
pub const STUDY: &str = include_str!("../cases/study.toml");

/// JSON schema of the plan.
pub fn plan_schema() -> schemars::Schema {
    schemars::schema_for!(file::PlanFile)
}
