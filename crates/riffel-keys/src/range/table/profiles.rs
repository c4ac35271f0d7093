//! Ranges of profiles and given creep coefficients.

use super::row;
use crate::quantity::{Force, Length, Moment, Ratio, Stiffness};
use crate::range::PhysicalRange;

pub(super) const RANGES: &[PhysicalRange] = &[
    row::<Length>(
        &["profiles.scatter"],
        [1e-8, 1e-3],
        [1e-7, 1e-4],
        "Laser devices scatter by 10 to 30 µm, mechanical ones by some 5 µm.",
    ),
    row::<Length>(&["profiles.gauge"], [0.05, 5.0], [0.55, 1.75], "600 mm to 1676 mm; standard gauge is 1435 mm."),
    row::<Length>(
        &["profiles.gauge_height"],
        [1e-3, 0.05],
        [0.005, 0.02],
        "14 mm below the crown in Europe, 16 mm (5/8 in) in America.",
    ),
    row::<Length>(
        &["profiles.flange_back_distance"],
        [0.05, 5.0],
        [0.5, 1.7],
        "1360 mm at standard gauge, a few millimetres more or less.",
    ),
    row::<Length>(
        &["profiles.flange_back_position"],
        [-0.2, 0.0],
        [-0.1, -0.03],
        "In the coordinates of the wheel, whose origin is the datum circle of the tread: -70 mm.",
    ),
    row::<Ratio>(&["profiles.conicity"], [1e-6, 2.0], [0.01, 0.5], "Cones have 1:40 to 1:20, worn wheels up to 0.4."),
    row::<Length>(
        &["profiles.flange.clearance", "profiles.flange.shift"],
        [1e-4, 0.1],
        [2e-3, 0.02],
        "Wheelsets have 5 to 10 mm of free play to either side.",
    ),
    row::<Stiffness>(
        &["profiles.flange.stiffness"],
        [1.0, 1e12],
        [1e6, 1e9],
        "A rail gives way laterally with 10 to 100 MN/m.",
    ),
    row::<Ratio>(
        &["profiles.flange.slope"],
        [1e-3, 20.0],
        [1.0, 5.0],
        "The tangent of the flange angle: 1.7 (60 degrees) to 2.75 (70 degrees).",
    ),
    row::<Length>(
        &["profiles.flange.width"],
        [1e-6, 0.05],
        [1e-4, 2e-3],
        "How gradually the contact climbs the flange: some tenths of a millimetre.",
    ),
    row::<Force>(
        &["contact.creep_coefficients.longitudinal", "contact.creep_coefficients.lateral"],
        [1e-3, 1e12],
        [1e5, 1e9],
        "Kalker's linear theory has 5 to 15 MN for wheels under 50 to 100 kN.",
    ),
    row::<Moment>(
        &["contact.creep_coefficients.spin"],
        [0.0, 1e9],
        [0.0, 1e6],
        "Kalker's linear theory has 5 to 40 kN m.",
    ),
    row::<Force>(&["contact.creep_coefficients.load"], [1e-3, 1e7], [1e4, 250e3], "The load of a wheel."),
];
