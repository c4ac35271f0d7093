//! What quantities measure.

use super::Kind;

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
    ($($(#[$doc:meta])* $name:ident = $words:literal, $unit:literal, $example:literal;)*) => {$(
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
    };
}

dimensions! {
    /// Ratio, also in per cent.
    Ratio = "a ratio", "", "0.4 %";
    /// Length.
    Length = "a length", "m", "40 mm";
    /// Speed.
    Speed = "a speed", "m/s", "80 km/h";
    /// Frequency.
    Frequency = "a frequency", "Hz", "500 Hz";
    /// Mass.
    Mass = "a mass", "kg", "350 kg";
    /// Force.
    Force = "a force", "N", "50 kN";
    /// Moment of a force, torque.
    Moment = "a moment", "N m", "22 kN m";
    /// Moment of inertia.
    Inertia = "a moment of inertia", "kg m2", "27.77 kg m2";
    /// Elastic modulus.
    Modulus = "an elastic modulus", "Pa", "207 GPa";
    /// Area.
    Area = "an area", "m2", "76.7 cm2";
    /// Second moment of area.
    SecondMoment = "a second moment of area", "m4", "2350 cm4";
    /// Mass per length.
    MassPerLength = "a mass per length", "kg/m", "56 kg/m";
    /// Stiffness.
    Stiffness = "a stiffness", "N/m", "280 MN/m";
    /// Torsional stiffness.
    TorsionalStiffness = "a torsional stiffness", "N m/rad", "400 kNm/rad";
    /// Viscous damping of rotation.
    TorsionalDamping = "a torsional damping", "N m s/rad", "50 N m s/rad";
    /// Viscous damping.
    Damping = "a viscous damping", "N s/m", "63 kNs/m";
    /// Viscous damping per length.
    DampingPerLength = "a viscous damping per length", "N s/m2", "2 kNs/m2";
    /// Density.
    Density = "a density", "kg/m3", "7850 kg/m3";
    /// Mass worn per dissipated energy.
    WearCoefficient = "a wear coefficient", "kg/J", "0.3e-9 kg/J";
    /// Angle.
    Angle = "an angle", "rad", "3 deg";
    /// Turn per length of way.
    Spin = "a spin", "rad/m", "0.3 rad/m";
    /// Change per length, over the value itself.
    RelativeSlope = "a relative slope", "1/m", "2 1/m";
    /// Warping constant of a cross-section.
    WarpingConstant = "a warping constant", "m6", "2.16e-8 m6";
    /// Length per force.
    LengthPerForce = "a length per force", "m/N", "1e-15 m/N";
    /// Decay over slip velocity.
    VelocityDecay = "a decay over slip velocity", "s/m", "0.6 s/m";
}
