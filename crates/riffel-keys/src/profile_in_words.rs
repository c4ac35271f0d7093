//! What is wrong with a profile, as a message.

use riffel::Rail;
use riffel_curving::profile::{PointFault, ProfileError, ShapeFault};

use crate::{Message, fixed, say};

/// In every language, but for what the physics refuses in English.
impl From<&ProfileError> for Message {
    fn from(error: &ProfileError) -> Self {
        match error {
            ProfileError::TooFew { count, least } => {
                say!(too_few_points, least = *least, count = *count)
            }
            ProfileError::Point { fault, .. } => of_point(fault),
            ProfileError::Shape(fault) => of_shape(fault),
            ProfileError::Gauge { gauge } => say!(rails_overlap, gauge = fixed(1e3 * gauge, 1)),
            ProfileError::GaugeHeight { gauge_height } => {
                say!(ends_above_gauge_height, height = fixed(1e3 * gauge_height, 1))
            }
            ProfileError::Contact(error) => error.into(),
            ProfileError::NoContact { lateral_shift, yaw, rail } => say!(
                wheel_has_left_its_rail,
                shift = fixed(1e3 * lateral_shift, 3),
                yaw = fixed(1e3 * yaw, 3),
                side = side(*rail)
            ),
            other => Self::verbatim(other.to_string()),
        }
    }
}

fn of_point(fault: &PointFault) -> Message {
    match *fault {
        PointFault::NotFinite => say!(coordinate_not_finite),
        PointFault::Twice => say!(point_stands_twice),
        PointFault::TooMany { count, most } => say!(too_many_points, count, most),
        PointFault::Crossing { place } => say!(outline_crosses, place = fixed(1e3 * place, 2)),
        PointFault::Closed => say!(outline_closes),
        PointFault::TurnsBack => say!(curve_turns_back),
        PointFault::ComesBack => say!(outline_comes_back),
    }
}

fn of_shape(fault: &ShapeFault) -> Message {
    match *fault {
        ShapeFault::Scatter(scatter) => say!(scatter_not_positive, scatter),
        ShapeFault::CrownAtEnd => say!(crown_at_end),
        ShapeFault::NoDatumCircle => say!(no_datum_circle),
        ShapeFault::NoFlank => say!(no_flank_of_flange),
        ShapeFault::Mirrored => say!(flange_outside),
        ShapeFault::UpsideDown => say!(wheel_upside_down),
        ShapeFault::NoFlange => say!(wheel_without_flange),
        ShapeFault::Elsewhere => say!(profile_lies_elsewhere),
        ShapeFault::NoTip => say!(measured_without_tip),
        ShapeFault::NoNominalTip => say!(nominal_without_tip),
        ShapeFault::NoFieldSide => say!(field_side_not_measured),
        ShapeFault::BeyondEnd(rail) => say!(touches_beyond_end, side = side(rail)),
        ShapeFault::BesideRail(rail) => say!(touches_beside_rail, side = side(rail)),
    }
}

fn side(rail: Rail) -> Message {
    match rail {
        Rail::Left => say!(left_of_wheels),
        Rail::Right => say!(right_of_wheels),
    }
}
