//! # Calibration: what measurements say of a case
//!
//! A [`Plan`] names the uncertain keys of a case with their priors, and what was measured: frequency responses, decay rates,
//! dated levels of roughness, runs of axle boxes. Its [`Posterior`] is how likely values are after all of it, with the errors of
//! the instruments and with what the model misses.
//!
//! Statistics: Kennedy & O'Hagan (2001), *Bayesian calibration of computer models*, J. R. Stat. Soc. B 63, for
//! y = model(θ) + δ + ε with δ Gaussian and small by prior.

mod chain;
mod chains;
mod comparison;
mod data;
mod data_columns;
mod decision;
pub mod diagnostics;
mod draw;
mod drawn;
mod emulator;
mod ensemble;
mod error;
pub mod file;
#[cfg(test)]
#[path = "../tests/calibration/fixtures.rs"]
mod fixtures;
mod folder;
mod forecast;
mod gaussian;
mod held_out;
mod identifiability;
pub mod information;
mod kernel;
mod linear;
mod model;
mod moments;
mod names;
mod nuts;
mod optimum;
mod outlying;
mod plan;
mod posterior;
mod predicted;
mod prior;
mod rail_draw;
mod record;
mod results;
mod run;
mod sampling;
mod simulated;
mod smc;
mod smoothing;
mod summary;

pub use chains::Chains;
pub use comparison::{Comparison, ModelScore, Sampler};
pub use data::{Held, Observable};
pub use decision::{ActionOutcome, Breaks, Decision, Months, Worth};
pub use drawn::Drawn;
pub use error::CalibrationError;
pub use folder::Folder;
pub use forecast::{BandForecast, Forecast};
pub use held_out::Score;
pub use identifiability::{Correlation, Direction, Identifiability};
pub use model::Parameter;
pub use outlying::Outlying;
pub use plan::decision::{USUAL_HORIZON, USUAL_RISE};
pub use plan::{Measured, Plan, Uncertain};
pub use posterior::{Point, Posterior};
pub use predicted::Predicted;
pub use prior::Prior;
pub use rail_draw::growing_bands;
pub use results::Results;
pub use run::{Progress, finished};
pub use simulated::{Checked, LEAST_RUNS, RANKED, Ranked, Simulated};
pub use summary::{Marginal, Summary, TOLD};

#[cfg(test)]
mod conjugate;
#[cfg(test)]
mod drawn_problems;
