//! What can be wrong with a profile, and with wheels on rails.

use thiserror::Error;

/// Points that are no profile, or profiles that do not fit each other.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// Too few points.
    #[error("a profile needs {least} points or more, and this one has {count}")]
    TooFew {
        /// Points there are.
        count: usize,
        /// Points needed.
        least: usize,
    },

    /// A point at fault.
    #[error("{rule}")]
    Point {
        /// Its place among the others, from zero.
        index: usize,
        /// What is wrong, as a sentence.
        rule: String,
    },

    /// A profile that is not what it is used as.
    #[error("{0}")]
    Shape(String),

    /// A gauge that the rails cannot have.
    #[error("{0}")]
    Gauge(String),

    /// A contact under load that has no solution.
    #[error("{0}")]
    Contact(#[from] crate::Error),

    /// A wheelset that does not touch both rails.
    #[error("at a lateral shift of {:.3} mm and a yaw of {:.3} mrad the {rail} wheel does not touch its rail", 1e3 * lateral_shift, 1e3 * yaw)]
    NoContact {
        /// Lateral shift \[m\].
        lateral_shift: f64,
        /// Yaw \[rad\].
        yaw: f64,
        /// "left" or "right".
        rail: &'static str,
    },
}
