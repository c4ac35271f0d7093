//! The table of physical ranges.

use super::PhysicalRange;
use crate::quantity::{
    Angle, Area, Damping, DampingPerLength, Density, Dimension, Force, Frequency, Inertia, Kind, Length,
    LengthPerForce, Mass, MassPerLength, Modulus, Moment, Ratio, RelativeSlope, SecondMoment, Speed, Spin, Stiffness,
    TorsionalDamping, TorsionalStiffness, VelocityDecay, WarpingConstant, WearCoefficient,
};

const fn row<D: Dimension>(
    keys: &'static [&'static str],
    hard: [f64; 2],
    usual: [f64; 2],
    reason: &'static str,
) -> PhysicalRange {
    PhysicalRange { keys, kind: Kind::of::<D>(), hard, usual, bare_up_to: f64::INFINITY, reason }
}

/// Largest speed \[m/s\] that is taken without a question where no unit is written: 144 km/h. Faster lines exist, but
/// most numbers above it are kilometres an hour without their unit.
const BARE_SPEED: f64 = 40.0;

/// A number of things, which takes no unit and is not written in per cent.
const COUNT: Kind = Kind { name: "a number", unit: "", example: "6000" };

/// Largest contact angle \[rad\] below a right one, to either side.
const LARGEST_CONTACT_ANGLE: f64 = 89.999 / 180.0 * std::f64::consts::PI;

/// Largest angle \[rad\] that is taken without a question where no unit is written: 17°. Flanges touch at steeper ones,
/// but most numbers above it are degrees without their unit.
const BARE_ANGLE: f64 = 0.3;

/// Every range, in the order of the case file. Hard ranges leave room for roller rigs and twin-disc machines (wheels of
/// 5 mm, loads of 1 N, discs of polymer) and for limits that a thought experiment takes; where a limit has a key of
/// its own, such as `wheel.rotation`, the range ends far beyond where it is reached.
pub static RANGES: &[PhysicalRange] = &[
    row::<Modulus>(
        &["steel.youngs_modulus", "wheelset.axle.youngs_modulus"],
        [1e9, 1e12],
        [150e9, 230e9],
        "Polymer discs have 1 to 3 GPa, no metal more than 600; steels 190 to 215, cast iron from 150.",
    ),
    row::<Ratio>(
        &["steel.poisson_ratio", "wheelset.axle.poisson_ratio"],
        [-0.9, 0.499],
        [0.2, 0.4],
        "An isotropic solid is stable between -1 and 0.5; steels have 0.27 to 0.31.",
    ),
    row::<Length>(
        &[
            "wheel.rolling_radius",
            "wheel.left_rolling_radius",
            "vehicle.rolling_radius",
            "vehicle.wheel_radius.mean",
            "vehicle.wheel_radius.min",
            "vehicle.wheel_radius.max",
        ],
        [0.005, 5.0],
        [0.15, 0.70],
        "Twin discs begin at 10 mm; wheels in service have 165 mm (rolling highway) to 625 mm (locomotives).",
    ),
    row::<Mass>(
        &["wheel.mass", "vehicle.wheel_mass"],
        [0.01, 1e5],
        [50.0, 3000.0],
        "Discs of a rig weigh grams; a wheel with its share of wheelset and drive 150 to 2500 kg.",
    ),
    row::<Inertia>(
        &["wheel.inertia"],
        [1e-7, 1e7],
        [1.0, 500.0],
        "Follows from mass and radius; the limits of none and of infinite inertia are wheel.rotation.",
    ),
    row::<MassPerLength>(
        &["rail.mass_per_length"],
        [0.01, 1e4],
        [10.0, 130.0],
        "Model rails weigh grams a metre; rails 15 kg/m (mines) to 75, crane rails to 120.",
    ),
    row::<SecondMoment>(
        &["rail.second_moment"],
        [1e-14, 1e-2],
        [1e-6, 1e-4],
        "Rails of 15 to 75 kg/m have 150 to 4500 cm4.",
    ),
    row::<SecondMoment>(
        &["rail.lateral_second_moment"],
        [1e-14, 1e-2],
        [2e-7, 5e-5],
        "Rails of 15 to 75 kg/m have 30 to 1000 cm4.",
    ),
    row::<Area>(
        &["rail.area"],
        [1e-7, 1.0],
        [1e-3, 2e-2],
        "The mass per length over the density of steel: 19 to 96 cm2.",
    ),
    row::<Ratio>(
        &["rail.shear_coefficient", "rail.lateral_shear_coefficient", "wheelset.axle.shear_coefficient"],
        [0.01, 1.0],
        [0.2, 0.95],
        "At most 1 by its definition; 0.34 to 0.45 for rails, 0.85 for a rectangle, 0.89 for a solid axle.",
    ),
    row::<Modulus>(
        &["rail.shear_modulus"],
        [1e8, 1e12],
        [60e9, 90e9],
        "E/2(1 + v) of the range of Young's modulus; steels 77 to 83 GPa.",
    ),
    row::<Density>(
        &["rail.density", "wear.density", "wheelset.axle.density"],
        [100.0, 3e4],
        [7000.0, 8100.0],
        "Polymers have 1000 kg/m3, no metal more than 22 600; steels 7700 to 8000, cast iron from 7000.",
    ),
    row::<Ratio>(
        &["rail.loss_factor", "wheelset.axle.loss_factor"],
        [0.0, 2.0],
        [0.0, 0.2],
        "Steel has 0.0002, with joints and clips 0.02; rails with dampers up to 0.2.",
    ),
    row::<SecondMoment>(
        &["rail.torsion_constant"],
        [1e-16, 1e-2],
        [2e-8, 2e-5],
        "Rails of 15 to 75 kg/m have 10 to 400 cm4.",
    ),
    row::<SecondMoment>(
        &["rail.polar_second_moment"],
        [1e-14, 1e-2],
        [1e-6, 2e-4],
        "The sum of the second moments about the two axes of bending.",
    ),
    row::<WarpingConstant>(
        &["rail.warping_constant"],
        [0.0, 1e-2],
        [0.0, 1e-6],
        "None where sections stay plane; 60E1 has 2e-8 m6.",
    ),
    row::<Length>(
        &["rail.centroid_height"],
        [-10.0, 10.0],
        [0.0, 0.06],
        "60E1 has 33 mm: the foot draws the shear centre down; none puts the mass at the shear centre.",
    ),
    row::<Length>(
        &["rail.head_height", "rail.foot_depth"],
        [0.0, 10.0],
        [0.01, 0.2],
        "Their sum is the height of the rail: 60 to 190 mm.",
    ),
    row::<Length>(&["rail.foot_width"], [0.0, 10.0], [0.04, 0.4], "Rails of 15 to 75 kg/m have feet of 70 to 160 mm."),
    row::<Length>(
        &["track.support_spacing"],
        [0.01, 10.0],
        [0.3, 1.6],
        "Model tracks begin at centimetres; sleepers lie 0.5 to 0.75 m apart, steel ones and bridges up to 1.5 m.",
    ),
    row::<Stiffness>(
        &["track.pad.stiffness"],
        [1.0, 1e13],
        [5e6, 5e9],
        "Baseplates on tunnel slabs have from 6 MN/m, stiff thin pads under dynamic load up to 3 GN/m.",
    ),
    row::<Stiffness>(
        &["track.ballast.stiffness"],
        [1.0, 1e13],
        [5e6, 5e9],
        "Under a sleeper end: soft peat 10 MN/m, frozen ballast on rock or a slab some GN/m.",
    ),
    row::<Stiffness>(
        &[
            "track.pad.lateral_stiffness",
            "track.ballast.lateral_stiffness",
            "track.pad.longitudinal_stiffness",
            "track.ballast.longitudinal_stiffness",
        ],
        [1.0, 1e13],
        [5e5, 5e9],
        "A tenth of the vertical stiffness and more.",
    ),
    row::<Damping>(
        &["track.pad.damping", "track.ballast.damping"],
        [0.0, 1e10],
        [0.0, 5e6],
        "Pads have 5 to 100 kN s/m, ballast 20 to 500.",
    ),
    row::<Ratio>(
        &["track.pad.loss_factor", "track.ballast.loss_factor"],
        [0.0, 10.0],
        [0.0, 3.0],
        "Pads of rubber have 0.1 to 0.4, ballast up to 2.",
    ),
    row::<Mass>(
        &["track.sleeper.mass"],
        [0.0, 1e5],
        [0.0, 1000.0],
        "Per rail: baseplates from 5 kg, half of a concrete sleeper 100 to 200, blocks and slabs more.",
    ),
    row::<Length>(&["track.position", "--position"], [0.0, 10.0], [0.0, 1.6], "Within one spacing of supports."),
    row::<DampingPerLength>(
        &["track.rail_damping"],
        [0.0, 1e9],
        [0.0, 1e6],
        "Free rails have next to none; embedded ones some 100 kN s/m2.",
    ),
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
    row::<Length>(
        &["corrugation.amplitude", "outputs.wave.amplitude", "--amplitude"],
        [1e-12, 0.01],
        [1e-8, 2e-3],
        "Smooth rails have 0.1 µm, the worst corrugation 0.5 mm.",
    ),
    row::<WearCoefficient>(
        &["wear.coefficient"],
        [1e-16, 1e-2],
        [1e-11, 1e-6],
        "Rails in service have some 3e-10 kg/J, clean dry discs ten times that, severe wear a thousand times.",
    ),
    row::<Length>(
        &["wear.measured.depth"],
        [1e-9, 0.1],
        [1e-5, 0.02],
        "Heads lose 0.1 to 5 mm under 100 MGT, and 10 to 20 mm until they are replaced.",
    ),
    row::<Mass>(
        &["wear.measured.per"],
        [1e3, 1e13],
        [1e8, 3e12],
        "A tram line has 1 to 5 MGT (1e9 kg) a year, a rail in its life 10 to 3000.",
    ),
    row::<Ratio>(&["wear.measured.factor"], [1.0, 100.0], [1.0, 3.0], "Surveys tell wear within a factor of 1.1 to 2."),
    row::<Ratio>(
        &["line.friction_days.factor"],
        [1.0, 4.0],
        [1.0, 2.0],
        "Two days of three lie within a factor of 1.2 to 1.6 of the middle of a dry rail.",
    ),
    row::<Ratio>(
        &["wear.natural_lubrication"],
        [1e-3, 1e6],
        [1.0, 100.0],
        "Rails in the field wear some 5 times less than dry discs, where they are damp or greased 100 times less.",
    ),
    row::<Ratio>(&["wear.spread"], [0.0, 3.0], [0.0, 1.0], "Tγ/A of the wheels of one train differs by half to twice."),
    row::<Length>(
        &["wear.band_width"],
        [1e-5, 0.3],
        [3e-3, 0.08],
        "One contact is 5 to 15 mm wide, the running band of a worn head 20 to 60 mm, a head 75 mm.",
    ),
    row::<Modulus>(
        &["damage.shear_yield"],
        [1e7, 2e9],
        [150e6, 900e6],
        "Rail steel yields in shear at 200 to 300 MPa as rolled, its hardened surface at 250 to 700.",
    ),
    row::<Ratio>(&["damage.spread"], [0.0, 3.0], [0.0, 0.5], "Loads and friction of traffic differ by 5 to 30 %."),
    row::<Length>(
        &["damage.flow.depth"],
        [1e-15, 1e-3],
        [1e-12, 1e-6],
        "Rails lose nanometres by flow per passage, if any; more than 0.2 µm leaves no rail.",
    ),
    row::<Ratio>(
        &["damage.flow.exponent", "damage.flow_along.exponent", "damage.bending.exponent"],
        [1.0, 10.0],
        [1.0, 4.0],
        "Ratchetting is taken in proportion to what lies above the limit; below one the law would begin with a step.",
    ),
    row::<Length>(
        &["damage.flow.hardening_depth"],
        [1e-9, 1.0],
        [1e-6, 0.02],
        "Heads of rails settle by tenths of a millimetre before they are hard.",
    ),
    row::<Area>(
        &["damage.flow_along.area"],
        [1e-18, 1e-4],
        [1e-13, 1e-8],
        "A layer of 1 mm sheared by 0.24 % per passage moves 1.2e-9 m2.",
    ),
    row::<LengthPerForce>(
        &["damage.load.depth_per_force"],
        [1e-24, 1e-6],
        [1e-18, 1e-12],
        "1e-15 m/N lowers a rail by 0.05 nm under a wheel.",
    ),
    row::<Moment>(&["damage.bending.limit"], [1.0, 1e7], [1e4, 3e5], "Plastic moments of rails are 60 to 200 kN m."),
    row::<RelativeSlope>(
        &["damage.bending.curvature"],
        [1e-18, 1.0],
        [1e-13, 1e-5],
        "A sag of 0.1 mm over 1 m after a million wheels is 4e-9 1/m each.",
    ),
    row::<Force>(
        &["damage.fatigue.thresholds"],
        [0.0, 1e5],
        [1.0, 1e3],
        "Cracks begin at 15 N and are worn away from 175 N on.",
    ),
    row::<Ratio>(
        &["damage.fatigue.peak"],
        [1e-12, 1.0],
        [1e-8, 1e-3],
        "Rails crack after some 1e5 axles at the worst Tγ.",
    ),
    row::<Length>(
        &["damage.fatigue.crack_growth", "damage.fatigue.loss"],
        [0.0, 1.0],
        [0.0, 0.03],
        "A rail whose damage is one has cracks of 2 mm to 5 mm.",
    ),
    row::<Angle>(&["damage.fatigue.crack_angle"], [0.01, 1.57], [0.15, 1.1], "Cracks go down at 15 to 45 degrees."),
    row::<Length>(
        &[
            "map.wavelength.min",
            "map.wavelength.max",
            "--wavelength",
            "outputs.point.wavelength",
            "outputs.wave.wavelength",
        ],
        [1e-4, 10.0],
        [2e-3, 3.0],
        "Shorter than a tenth of any contact patch nothing grows; corrugation has 10 mm to 1.5 m.",
    ),
    PhysicalRange {
        bare_up_to: BARE_SPEED,
        ..row::<Speed>(
            &[
                "map.speed.min",
                "map.speed.max",
                "contact.polach.speed",
                "wear.speed",
                "--speed",
                "outputs.point.speed",
                "outputs.wave.speed",
                "vehicle.speed.mean",
                "vehicle.speeds.speed",
                "speed.mean",
            ],
            [0.01, 200.0],
            [1.0, 100.0],
            "Roller rigs begin at centimetres a second; trains in service run at up to 350 km/h, 97 m/s.",
        )
    },
    row::<Speed>(
        &["vehicle.speed.standard_deviation", "speed.standard_deviation"],
        [0.0, 50.0],
        [0.0, 20.0],
        "Less than a quarter of the mean.",
    ),
    row::<Ratio>(
        &["speed.factor"],
        [1e-3, 1e3],
        [0.1, 10.0],
        "Of the speeds of the traffic, which keep their own range.",
    ),
    row::<Mass>(
        &["vehicle.axle_load"],
        [0.2, 4e5],
        [2e3, 5e4],
        "Twice the load of a wheel: 3 t (light rail) to 40 t (ore lines).",
    ),
    PhysicalRange {
        kind: COUNT,
        ..row::<Ratio>(
            &["line.passages_per_day"],
            [1e-6, 1e7],
            [20.0, 5e4],
            "Axles: a branch line with two trains a day has 30, a metro with 40 trains an hour 30 000.",
        )
    },
    PhysicalRange {
        kind: COUNT,
        ..row::<Ratio>(
            &["line.mgt_per_year"],
            [1e-6, 1e4],
            [0.01, 300.0],
            "A tram 1 to 5, main lines 5 to 40, heavy haul up to 250.",
        )
    },
    row::<Frequency>(
        &["--from", "--to", "--frequencies"],
        [1e-3, 2e6],
        [1.0, 5e4],
        "The slowest speed over the longest wavelength to the fastest over the shortest.",
    ),
    row::<Length>(
        &["--distance"],
        [0.76, 1e3],
        [1.0, 100.0],
        "From the middle of the track, beyond the rail; pass-bys are measured at 7.5 and 25 m.",
    ),
    row::<Length>(&["--height"], [0.0, 100.0], [0.0, 20.0], "Above the rail; pass-bys are measured at 1.2 and 3.5 m."),
    row::<Length>(&["--train-length"], [0.1, 1e4], [2.0, 3e3], "A tram has 20 m, an ore train 3 km."),
    row::<Length>(
        &["--rail-foot"],
        [0.01, 0.5],
        [0.08, 0.2],
        "Vignole rails have 110 to 150 mm, grooved rails 180 mm.",
    ),
    row::<Area>(&["--sleeper-area"], [1e-4, 10.0], [0.1, 1.0], "Half of a sleeper of 2.6 m by 0.25 m."),
];
