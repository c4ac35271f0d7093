//! What quantities measure.

use super::Kind;
use crate::{Message, say};

/// What a quantity measures.
pub trait Dimension {
    /// In the field's words, with its article: "a stiffness".
    const NAME: &'static str;
    /// SI unit, empty for a ratio.
    const UNIT: &'static str;
    /// What one writes in a case file.
    const EXAMPLE: &'static str;
}

macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident = $message:ident, $words:literal, $unit:literal, $example:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;

        impl Dimension for $name {
            const NAME: &'static str = $words;
            const UNIT: &'static str = $unit;
            const EXAMPLE: &'static str = $example;
        }
    )*
        /// Every kind of quantity.
        pub const KINDS: &[Kind] = &[$(Kind::of::<$name>()),*];

        /// The name of a dimension, for readers of any language.
        pub(super) fn named(words: &str) -> Message {
            match words {
                $($words => say!($message),)*
                other => other.into(),
            }
        }
    };
}

dimensions! {
    /// Ratio, also in per cent.
    Ratio = a_ratio, "a ratio", "", "0.4 %";
    /// Length.
    Length = a_length, "a length", "m", "40 mm";
    /// Speed.
    Speed = a_speed, "a speed", "m/s", "80 km/h";
    /// Frequency.
    Frequency = a_frequency, "a frequency", "Hz", "500 Hz";
    /// Mass.
    Mass = a_mass, "a mass", "kg", "350 kg";
    /// Force.
    Force = a_force, "a force", "N", "50 kN";
    /// Moment of a force, torque.
    Moment = a_moment, "a moment", "N m", "22 kN m";
    /// Moment of inertia.
    Inertia = a_moment_of_inertia, "a moment of inertia", "kg m2", "27.77 kg m2";
    /// Elastic modulus.
    Modulus = an_elastic_modulus, "an elastic modulus", "Pa", "207 GPa";
    /// Area.
    Area = an_area, "an area", "m2", "76.7 cm2";
    /// Second moment of area.
    SecondMoment = a_second_moment_of_area, "a second moment of area", "m4", "2350 cm4";
    /// Mass per length.
    MassPerLength = a_mass_per_length, "a mass per length", "kg/m", "56 kg/m";
    /// Stiffness.
    Stiffness = a_stiffness, "a stiffness", "N/m", "280 MN/m";
    /// Torsional stiffness.
    TorsionalStiffness = a_torsional_stiffness, "a torsional stiffness", "N m/rad", "400 kNm/rad";
    /// Viscous damping of rotation.
    TorsionalDamping = a_torsional_damping, "a torsional damping", "N m s/rad", "50 N m s/rad";
    /// Viscous damping.
    Damping = a_viscous_damping, "a viscous damping", "N s/m", "63 kNs/m";
    /// Viscous damping per length.
    DampingPerLength = a_viscous_damping_per_length, "a viscous damping per length", "N s/m2", "2 kNs/m2";
    /// Density.
    Density = a_density, "a density", "kg/m3", "7850 kg/m3";
    /// Mass worn per dissipated energy.
    WearCoefficient = a_wear_coefficient, "a wear coefficient", "kg/J", "2.5e-9 kg/J";
    /// Angle.
    Angle = an_angle, "an angle", "rad", "3 deg";
    /// Turn per length of way.
    Spin = a_spin, "a spin", "rad/m", "0.3 rad/m";
    /// Change per length, over the value itself.
    RelativeSlope = a_relative_slope, "a relative slope", "1/m", "2 1/m";
    /// Warping constant of a cross-section.
    WarpingConstant = a_warping_constant, "a warping constant", "m6", "2.16e-8 m6";
    /// Length per force.
    LengthPerForce = a_length_per_force, "a length per force", "m/N", "1e-15 m/N";
    /// Decay over slip velocity.
    VelocityDecay = a_decay_over_slip_velocity, "a decay over slip velocity", "s/m", "0.6 s/m";
}
