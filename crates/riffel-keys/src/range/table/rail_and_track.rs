//! Ranges of wheel, rail and track.

use super::row;
use crate::quantity::{
    Area, Damping, DampingPerLength, Density, Inertia, Length, Mass, MassPerLength, Modulus, Ratio, SecondMoment,
    Stiffness, WarpingConstant,
};
use crate::range::PhysicalRange;

pub(super) const RANGES: &[PhysicalRange] = &[
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
];
