//! A wheel of a case along a rail, in time.

mod along_rail;
mod contact_history;
mod evolution;
mod extremes;
mod question;
mod rail;
mod remarks;
mod run;
mod sinusoid;
mod smooth_rail;

pub use along_rail::{PassageAnswer, PassageRequest};
pub use contact_history::ContactHistory;
pub use evolution::{EvolutionAnswer, EvolutionRequest, EvolutionRun, Surface};
pub use extremes::Extremes;
pub use question::SimulateQuestion;
pub use run::Run;
pub use sinusoid::{SinusoidAnswer, SinusoidRequest};
pub use smooth_rail::SmoothRailAnswer;

use riffel_keys::CaseError;

/// A refusal of the physics, of an argument.
fn refused(argument: &'static str) -> impl Fn(riffel::Error) -> CaseError {
    move |error| CaseError::Physics { input: argument.to_owned(), error }
}
