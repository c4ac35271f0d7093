//! A wheel of a case along a rail, in time.

mod course;
mod document;
mod remarks;
mod sinusoid;

pub use course::Course;
pub use document::{HarmonicDocument, SinusoidDocument};
pub use sinusoid::{SinusoidAnswer, SinusoidRequest};
