//! Ranges of roughness, wear and damage.

use super::row;
use crate::quantity::{
    Angle, Area, Force, Length, LengthPerForce, Mass, Modulus, Moment, Ratio, RelativeSlope, WearCoefficient,
};
use crate::range::PhysicalRange;

pub(super) const RANGES: &[PhysicalRange] = &[
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
];
