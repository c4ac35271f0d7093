//! Ranges of the contacts.

use super::row;
use crate::quantity::{Angle, Force, Length, Ratio, RelativeSlope, Spin, Stiffness, VelocityDecay};
use crate::range::PhysicalRange;

/// Largest contact angle \[rad\] below a right one, to either side.
const LARGEST_CONTACT_ANGLE: f64 = 89.999 / 180.0 * std::f64::consts::PI;

/// Largest angle \[rad\] that is taken without a question where no unit is written: 17°. Flanges touch at steeper ones,
/// but most numbers above it are degrees without their unit.
const BARE_ANGLE: f64 = 0.3;

pub(super) const RANGES: &[PhysicalRange] = &[
    row::<Length>(
        &["contact.transverse_radius", "opposite_contact.transverse_radius"],
        [1e-3, 1e4],
        [0.02, 20.0],
        "Rail heads have 10 to 600 mm; a conformal contact is flatter, a line contact as flat as one likes.",
    ),
    row::<Length>(
        &["contact.longitudinal_radius", "opposite_contact.longitudinal_radius"],
        [1e-3, 1e4],
        [0.1, 3.0],
        "The rolling radius over the cosine of the contact angle: on a flange of 70 degrees three times the radius.",
    ),
    row::<Force>(
        &[
            "contact.normal_load",
            "opposite_contact.normal_load",
            "vehicle.wheel_load",
            "vehicle.load.mean",
            "vehicle.load.min",
            "vehicle.load.max",
        ],
        [1.0, 2e6],
        [10e3, 250e3],
        "Twin discs press with 10 N to some kN; wheels with 15 kN (light rail) to 200 kN (40 t axles).",
    ),
    row::<Stiffness>(
        &["contact.stiffness", "opposite_contact.stiffness"],
        [1e3, 1e12],
        [2e8, 5e9],
        "Wheels on rails have 800 to 1500 MN/m, twin discs less.",
    ),
    row::<Ratio>(
        &[
            "contact.friction",
            "contact.friction.left",
            "contact.friction.right",
            "opposite_contact.friction",
            "line.friction_days.mean",
            "vehicle.friction.mean",
            "vehicle.friction.min",
            "vehicle.friction.max",
        ],
        [0.001, 1.5],
        [0.02, 0.8],
        "Leaves and ice have 0.02 to 0.05, dry rails 0.3 to 0.6, clean ones in vacuum more than 1.",
    ),
    row::<Ratio>(
        &["contact.tractive_ratio", "vehicle.tractive_ratio"],
        [1e-6, 0.999_999],
        [1e-6, 0.999_999],
        "Above 0 and below 1 by its definition; nearer to an end its digits are lost.",
    ),
    row::<Ratio>(
        &["contact.creepage", "opposite_contact.creepage", "vehicle.creepage"],
        [1e-9, 1.0],
        [1e-6, 0.1],
        "Free rolling wheels have 0.01 %, full slip begins at 0.3 to 1 %, a locked wheel has 1.",
    ),
    row::<Ratio>(
        &[
            "contact.creepage.longitudinal",
            "contact.creepage.lateral",
            "opposite_contact.creepage.longitudinal",
            "opposite_contact.creepage.lateral",
        ],
        [-1.0, 1.0],
        [-0.1, 0.1],
        "Of either sign; a locked wheel has 1, an axle in a sharp curve 1 to 2 % across the rail.",
    ),
    row::<Spin>(
        &["contact.creepage.spin", "opposite_contact.creepage.spin"],
        [-1e3, 1e3],
        [-3.0, 3.0],
        "The sine of the contact angle over the rolling radius: 0.1 rad/m on treads, 2 on flanges, more on small discs.",
    ),
    PhysicalRange {
        bare_up_to: BARE_ANGLE,
        ..row::<Angle>(
            &["contact.contact_angle", "opposite_contact.contact_angle"],
            [-LARGEST_CONTACT_ANGLE, LARGEST_CONTACT_ANGLE],
            [-10.0 / 180.0 * std::f64::consts::PI, 80.0 / 180.0 * std::f64::consts::PI],
            "Below a right angle, where no load is carried; treads have 1 to 5 degrees, flanges 60 to 75; hollow wheels are inclined \
             the other way by a few.",
        )
    },
    row::<Length>(
        &["contact.lateral_offset", "opposite_contact.lateral_offset"],
        [-1.0, 1.0],
        [-0.05, 0.05],
        "Within half the width of a rail head, 30 to 37 mm.",
    ),
    row::<Length>(
        &["line.measured_line"],
        [-0.1, 0.1],
        [-0.05, 0.05],
        "On the head of a rail, which ends 30 to 40 mm beside its axis.",
    ),
    row::<Length>(
        &["contact.conformity.rail_radius", "opposite_contact.rail_radius"],
        [1e-3, 10.0],
        [0.08, 1.0],
        "The radius of the head where the wheel runs: 80 mm at the gauge corner of new rails, 300 on their crown, more on worn ones.",
    ),
    row::<RelativeSlope>(
        &["contact.conformity.cross_slope"],
        [-1e4, 1e4],
        [-200.0, 200.0],
        "A ripple that vanishes within 10 mm from where it is deepest has 100 1/m.",
    ),
    row::<Ratio>(
        &["contact.polach.limit_friction_ratio"],
        [0.001, 1.0],
        [0.1, 1.0],
        "At most 1 by its definition; Polach (2005) gives 0.36 to 0.44.",
    ),
    row::<VelocityDecay>(
        &["contact.polach.friction_decay"],
        [0.0, 1e3],
        [0.0, 10.0],
        "Polach (2005) gives 0.2 to 0.6 s/m.",
    ),
    row::<Ratio>(
        &["contact.polach.adhesion_reduction", "contact.polach.slip_reduction"],
        [0.001, 1.0],
        [0.05, 1.0],
        "At most 1 by their definition; Polach (2005) gives 0.1 to 1.",
    ),
];
