//! A wheel of a case along a rail, in time.

mod along_rail;
mod course;
mod document;
mod evolution;
mod remarks;
mod sinusoid;
mod smooth_rail;

pub use along_rail::{PassageAnswer, PassageRequest};
pub use course::Course;
pub use document::{
    ContactCourseDocument, ContactOverSinusoidDocument, ContactSwingDocument, HarmonicDocument, PassageDocument,
    SinusoidDocument, SmoothRailDocument,
};
pub use evolution::{
    BandDocument, EvolutionAnswer, EvolutionDocument, EvolutionRequest, EvolutionRun, Extremes, Stage, Surface,
    WornProfile,
};
pub use sinusoid::{SinusoidAnswer, SinusoidRequest};
pub use smooth_rail::SmoothRailAnswer;
