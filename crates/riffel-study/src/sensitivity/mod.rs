//! Which parameters matter, and how sure the answer is.

mod bands;
mod sobol_indices;
mod tornado;

pub use bands::{Bands, quantile};
pub use sobol_indices::{Estimate, Intervals, ParameterIndices, SobolIndices};
pub use tornado::{Swing, Tornado};
