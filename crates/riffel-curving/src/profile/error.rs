//! What can be wrong with a profile, and with wheels on rails.

use riffel::Rail;
use thiserror::Error;

use super::{PointFault, ShapeFault};

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
    #[error("{fault}")]
    Point {
        /// Its place among the others, from zero.
        index: usize,
        /// What is wrong with it.
        fault: PointFault,
    },

    /// A profile that is not what it is used as.
    #[error("{0}")]
    Shape(ShapeFault),

    /// A gauge that the rails cannot have.
    #[error("with a gauge of {:.1} mm the rails overlap", 1e3 * gauge)]
    Gauge {
        /// \[m\].
        gauge: f64,
    },

    /// A rail whose gauge cannot be measured.
    #[error("the inner side of the rail ends above the gauge height of {:.1} mm below its crown, or the profile is mirrored: x must be positive to the field side", 1e3 * gauge_height)]
    GaugeHeight {
        /// \[m\].
        gauge_height: f64,
    },

    /// A contact under load that has no solution.
    #[error("{0}")]
    Contact(#[from] riffel::Error),

    /// A wheelset that does not touch both rails.
    #[error("at a lateral shift of {:.3} mm and a yaw of {:.3} mrad the {} wheel does not touch its rail", 1e3 * lateral_shift, 1e3 * yaw, rail.name())]
    NoContact {
        /// Lateral shift \[m\].
        lateral_shift: f64,
        /// Yaw \[rad\].
        yaw: f64,
        /// The rail.
        rail: Rail,
    },
}
