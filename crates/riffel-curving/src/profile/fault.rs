//! What a profile is at fault by.

use thiserror::Error;

use riffel::Rail;

/// What is wrong with a point of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum PointFault {
    /// No number.
    #[error("a coordinate is not finite")]
    NotFinite,
    /// One like the point before.
    #[error("the point stands there twice")]
    Twice,
    /// The first of too many.
    #[error("the profile has {count} points, more than the {most} that are read")]
    TooMany {
        /// Points there are.
        count: usize,
        /// Points that are read.
        most: usize,
    },
    /// An outline that meets itself.
    #[error(
        "the outline crosses or retraces itself here, near x = {:.2} mm, as two passes of a device or points in a wrong order do",
        1e3 * place
    )]
    Crossing {
        /// Where, across \[m\].
        place: f64,
    },
    /// An outline that ends where it began.
    #[error(
        "the outline closes here: give the running surface alone, from one flank to the other, or from the flange to the field side"
    )]
    Closed,
    /// A loop.
    #[error("the curve turns back across the track here, as a profile with a loop or in a wrong order of points does")]
    TurnsBack,
    /// A second outline above the first.
    #[error("the outline comes back here above itself, as two passes of a device do")]
    ComesBack,
}

/// Why a profile is not what it is used as.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ShapeFault {
    /// A scatter of points that none have \[m\].
    #[error("the scatter of the points is {0} m, but must be above zero")]
    Scatter(f64),
    /// A rail that ends at its crown.
    #[error(
        "the highest point of the rail lies at its end, as in a profile that is drawn upside down or cut at its crown"
    )]
    CrownAtEnd,
    /// A wheel without its datum circle.
    #[error("x = 0, the datum circle of the tread, is not on the profile of the wheel")]
    NoDatumCircle,
    /// A wheel without the flank of its flange.
    #[error("the flank of the flange is not on the profile of the wheel")]
    NoFlank,
    /// A wheel with its flange outside.
    #[error("its flange lies at x above zero: it is mirrored, for x must be positive to the field side")]
    Mirrored,
    /// A wheel with its flange above the tread.
    #[error("it has no flange below the tread: it is upside down, for y must be the height, and a flange hangs down")]
    UpsideDown,
    /// A wheel without a flange.
    #[error("it has no flange")]
    NoFlange,
    /// A measured profile far from the nominal one.
    #[error(
        "the measured profile lies nowhere within 20 mm of the nominal one: check its origin, orientation and unit"
    )]
    Elsewhere,
    /// A measured wheel that ends at the tip of its flange.
    #[error("the measured profile does not reach around the tip of a flange, so that it cannot be laid by it")]
    NoTip,
    /// A nominal wheel that does.
    #[error("the nominal profile does not reach around the tip of a flange, so that it cannot be laid by it")]
    NoNominalTip,
    /// A rail without its field side.
    #[error("the field side of the rail, corner and flank, is not measured, so that it cannot be laid by it")]
    NoFieldSide,
    /// A contact at the end of a profile.
    #[error("under load the {} wheel touches beyond the end of a profile", .0.name())]
    BeyondEnd(Rail),
    /// A wheel beside its rail.
    #[error("the {} wheel touches beside its rail", .0.name())]
    BesideRail(Rail),
}
