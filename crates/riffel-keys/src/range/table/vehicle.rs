//! Ranges of wheelsets, bogies and vehicles in curves.

use super::{BARE_SPEED, row};
use crate::quantity::{
    Angle, Damping, Inertia, Length, Mass, Moment, Speed, Stiffness, TorsionalDamping, TorsionalStiffness,
};
use crate::range::PhysicalRange;

pub(super) const RANGES: &[PhysicalRange] = &[
    row::<Mass>(
        &["wheelset.mass"],
        [0.01, 1e5],
        [100.0, 6000.0],
        "Roller rigs weigh some kilograms; wheelsets in service 400 kg (trams) to 4000 (locomotives with their drive).",
    ),
    row::<Inertia>(
        &["wheelset.roll_inertia", "wheelset.spin_inertia"],
        [1e-7, 1e7],
        [1.0, 5000.0],
        "Wheelsets in service roll with 100 to 3000 kg m2 and spin with 20 to 500.",
    ),
    row::<Length>(
        &["wheelset.contact_spacing"],
        [0.01, 10.0],
        [0.5, 2.0],
        "The gauge and one rail head: 0.67 m (600 mm) to 1.75 m (1676 mm).",
    ),
    row::<Stiffness>(
        &[
            "wheelset.suspension.longitudinal_stiffness",
            "wheelset.suspension.lateral_stiffness",
            "wheelset.suspension.vertical_stiffness",
        ],
        [0.0, 1e13],
        [0.0, 1e9],
        "Primary springs of a side have 0.3 to 60 MN/m.",
    ),
    row::<Damping>(
        &[
            "wheelset.suspension.longitudinal_damping",
            "wheelset.suspension.lateral_damping",
            "wheelset.suspension.vertical_damping",
        ],
        [0.0, 1e10],
        [0.0, 1e6],
        "Primary dampers of a side have 1 to 60 kN s/m.",
    ),
    row::<Length>(
        &["wheelset.suspension.spacing"],
        [0.01, 10.0],
        [0.5, 3.0],
        "Axle boxes lie 1.1 m (inside the wheels) to 2.2 m apart.",
    ),
    row::<Length>(
        &["wheelset.axle.length", "wheelset.axle.segments.length"],
        [1e-3, 10.0],
        [0.005, 3.0],
        "Axles of standard gauge are 2.0 to 2.4 m long.",
    ),
    row::<Length>(
        &["wheelset.axle.diameter", "wheelset.axle.segments.diameter"],
        [1e-3, 2.0],
        [0.05, 0.4],
        "Axles have 110 mm (journals) to 250 mm (seats of locomotive wheels).",
    ),
    row::<Length>(&["wheelset.discs.position"], [-10.0, 10.0], [-1.5, 1.5], "From the middle of the axle."),
    row::<Mass>(
        &["wheelset.discs.mass"],
        [0.0, 1e5],
        [0.0, 3000.0],
        "Brake discs weigh 80 to 140 kg, wheels 200 to 600, gears up to 500.",
    ),
    row::<Inertia>(
        &["wheelset.discs.polar_inertia", "wheelset.discs.diametral_inertia"],
        [0.0, 1e7],
        [0.0, 1000.0],
        "Brake discs have 3 to 12 kg m2, wheels 15 to 120; about the diameter half as much.",
    ),
    row::<Inertia>(
        &["wheelset.discs.coupled.polar_inertia"],
        [1e-9, 1e7],
        [0.01, 5000.0],
        "Rotors of some kg m2 behind gears of ratio 3 to 7 count for 10 to 500.",
    ),
    row::<TorsionalStiffness>(
        &["wheelset.discs.coupled.stiffness"],
        [1e-6, 1e13],
        [1e3, 1e9],
        "With the inertia it turns on, some ten to some hundred hertz.",
    ),
    row::<TorsionalDamping>(
        &["wheelset.discs.coupled.damping"],
        [0.0, 1e10],
        [0.0, 1e6],
        "Some per cent of the critical one.",
    ),
    row::<Length>(
        &["train.wheels"],
        [0.0, 1e4],
        [0.0, 1000.0],
        "Bogies have 1.6 to 3 m between their wheels, passenger trains up to 400 m in all.",
    ),
    row::<Length>(
        &["curve.radius"],
        [-1e7, 1e7],
        [-1e5, 1e5],
        "Above zero to the right, below to the left: trams turn on 15 m, main lines on 300 m to 10 km.",
    ),
    row::<Length>(&["curve.cant"], [0.0, 1.0], [0.0, 0.2], "Railways allow 150 to 180 mm, 200 mm in some countries."),
    PhysicalRange {
        bare_up_to: BARE_SPEED,
        ..row::<Speed>(
            &["curve.speed"],
            [0.001, 200.0],
            [1.0, 100.0],
            "Trains in service run at up to 350 km/h, 97 m/s.",
        )
    },
    row::<Length>(
        &["bogie.wheelbase"],
        [0.05, 50.0],
        [1.2, 10.0],
        "Bogies have 1.6 to 3 m between their axles, wagons of two axles 5 to 10 m.",
    ),
    row::<Length>(
        &["bogie.primary_spacing"],
        [0.01, 10.0],
        [0.5, 3.0],
        "Axle boxes lie 1.1 m (inside the wheels) to 2.2 m apart.",
    ),
    row::<Stiffness>(
        &["bogie.primary_longitudinal_stiffness", "bogie.primary_lateral_stiffness"],
        [1e-3, 1e13],
        [1e3, 1e9],
        "Per axle box: 0.3 MN/m (steering) to 60 MN/m (stiff).",
    ),
    row::<Mass>(
        &["bogie.mass_per_axle"],
        [0.1, 4e5],
        [2e3, 5e4],
        "The axle load as a mass: 3 t (light rail) to 40 t (ore lines).",
    ),
    row::<Length>(
        &["bogie.centre_of_mass_height"],
        [0.0, 20.0],
        [0.3, 3.0],
        "Vehicles have 1 m (low-floor) to 2.5 m (high loads).",
    ),
    row::<Moment>(
        &["bogie.frame_yaw_moment"],
        [-1e8, 1e8],
        [-1e5, 1e5],
        "Yaw dampers and bolsters turn frames back with some kN m.",
    ),
    row::<Moment>(
        &["bogie.drive_torque"],
        [-1e7, 1e7],
        [-1e5, 1e5],
        "At the limit of adhesion a locomotive has 35 kN m per wheelset.",
    ),
    row::<Angle>(
        &["bogie.frame_yaw"],
        [-6.0 / 180.0 * std::f64::consts::PI, 6.0 / 180.0 * std::f64::consts::PI],
        [-2.0 / 180.0 * std::f64::consts::PI, 2.0 / 180.0 * std::f64::consts::PI],
        "Over one axle of a long vehicle half its wheelbase over the radius: 4 m in 200 m are 20 mrad.",
    ),
    row::<Length>(
        &["bogie.frame_lateral_shift"],
        [-0.1, 0.1],
        [-0.02, 0.02],
        "Flanges leave 5 to 10 mm to either side.",
    ),
    row::<Length>(
        &["body.bogie_spacing"],
        [0.1, 100.0],
        [3.0, 25.0],
        "Metro cars have 10 to 15 m between their bogies, main-line coaches 17 to 20 m.",
    ),
    row::<Mass>(
        &["body.mass"],
        [0.0, 1e6],
        [1e3, 1.5e5],
        "Metro cars 20 to 40 t with passengers, loaded wagons up to 130 t.",
    ),
    row::<Stiffness>(
        &["body.secondary_lateral_stiffness"],
        [1e-3, 1e13],
        [1e4, 1e9],
        "Per bogie: air springs 0.2 to 0.6 MN/m, flat centre bowls stand for rigid.",
    ),
    row::<TorsionalStiffness>(
        &["body.secondary_yaw_stiffness"],
        [0.0, 1e12],
        [0.0, 1e7],
        "Per bogie: 0.1 to 0.5 MN m/rad of air springs, above 1 of stiff ones.",
    ),
];
