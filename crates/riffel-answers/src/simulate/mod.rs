//! A wheel of a case along a rail, in time.

mod along_rail;
mod course;
mod document;
mod evolution;
mod remarks;
mod sinusoid;

pub use along_rail::{PassageAnswer, PassageRequest};
pub use course::Course;
pub use document::{HarmonicDocument, PassageDocument, SinusoidDocument};
pub use evolution::{
    BandDocument, EvolutionAnswer, EvolutionDocument, EvolutionRequest, EvolutionRun, Extremes,
    Stage, Surface, WornProfile,
};
pub use sinusoid::{SinusoidAnswer, SinusoidRequest};
