//! What can be wrong with the input of the physics.

use thiserror::Error;

/// An input outside the range in which the physics has a meaning.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A single quantity outside its physical range.
    #[error("{quantity} is {}{space}{unit}, but {rule}", as_typed(*value), space = if unit.is_empty() { "" } else { " " })]
    OutOfRange {
        /// The quantity, in the field's words.
        quantity: &'static str,
        /// Its value in SI units.
        value: f64,
        /// The SI unit, empty for a ratio.
        unit: &'static str,
        /// What is allowed, as the rest of the sentence.
        rule: &'static str,
    },

    /// The mean creepage leaves no stick: the linearisation about the steady state has no slope.
    #[error(
        "creepage is {:.4} %, but full slip begins at {:.4} % for this contact; the mean state must \
         keep a region of stick",
        100.0 * creepage,
        100.0 * saturation_creepage
    )]
    FullSlip {
        /// The creepage asked for \[-\].
        creepage: f64,
        /// The creepage ξ_max at which full slip begins \[-\].
        saturation_creepage: f64,
    },

    /// The mean state lies beyond the maximum of adhesion, where the force falls with creepage.
    #[error(
        "{quantity} is {}, but must stay below the maximum of adhesion of the creep law at {maximum:.6}, \
         beyond which the force falls",
        as_typed(*value)
    )]
    BeyondAdhesion {
        /// Tractive ratio or creepage.
        quantity: &'static str,
        /// Its value \[-\].
        value: f64,
        /// Value of the quantity at the maximum \[-\].
        maximum: f64,
    },

    /// A measured receptance, profile or spectrum that is none.
    #[error("{rule} (value number {})", index + 1)]
    Measurement {
        /// Place of the value among the others, from zero.
        index: usize,
        /// What is allowed.
        rule: &'static str,
    },

    /// A contact that moves along an axis to which it does not tell its response.
    #[error(
        "the contact does not tell its response to {creepage}; hold its surfaces along that axis, or choose another contact"
    )]
    NoResponse {
        /// The creepage, in the field's words.
        creepage: &'static str,
    },

    /// An iteration that did not reach its tolerance.
    #[error("{problem} did not converge: residual {residual:.1e}, tolerance {tolerance:.1e}; {remedy}")]
    NotConverged {
        /// What was to be solved.
        problem: &'static str,
        /// Residual when it was given up.
        residual: f64,
        /// Residual that was asked for.
        tolerance: f64,
        /// What to try, as the rest of the sentence.
        remedy: &'static str,
    },

    /// A patch that the grid of the contact does not hold.
    #[error(
        "the patch reaches the rim of the grid of {} m along and {} m across the rail; make the grid larger",
        as_typed(*length),
        as_typed(*width)
    )]
    GridTooSmall {
        /// Length of the grid along the rail \[m\].
        length: f64,
        /// Its width across the rail \[m\].
        width: f64,
    },

    /// A drive torque that friction does not carry.
    #[error(
        "no equilibrium is found, and a drive torque of {torque:.0} N m on wheelset {wheelset} is more than the {largest:.0} N m \
         that friction carries under the loads of its wheels"
    )]
    TorqueBeyondFriction {
        /// The wheelset, 1 leads.
        wheelset: usize,
        /// The torque \[N m\].
        torque: f64,
        /// Σ μ r W over both wheels \[N m\].
        largest: f64,
    },

    /// A wheelset that stands where no wheelset stays on its rails.
    #[error(
        "in its equilibrium wheelset {wheelset} is shifted by {:.0} mm and yawed by {:.0} mrad, but must be shifted by less \
         than {:.0} mm and yawed by less than {:.0} mrad to stay on its rails",
        1e3 * lateral_shift,
        1e3 * yaw,
        1e3 * crate::FARTHEST_SHIFT,
        1e3 * crate::LARGEST_YAW
    )]
    OffTheRails {
        /// The wheelset, 1 leads.
        wheelset: usize,
        /// Lateral shift \[m\].
        lateral_shift: f64,
        /// Yaw \[rad\].
        yaw: f64,
    },

    /// A vehicle for which no equilibrium was found.
    #[error(
        "no equilibrium was found beyond {:.0} % of this curve: it may be tighter than the wheelsets can take on these \
         profiles; take a wider curve, less uncompensated acceleration, less moment and torque or softer springs",
        100.0 * reached
    )]
    NoEquilibrium {
        /// Share of curvature, acceleration and torques that continuation reached.
        reached: f64,
    },

    /// A structure that moves before it is struck.
    #[error(
        "no causal track has this receptance: the nearest differs from it by {:.1} % rms, a share of {share:.1e} of its \
         square, and at most {largest:.0e} may be cut; give damping in N s/m in place of loss factors",
        100.0 * share.sqrt()
    )]
    NotCausal {
        /// Mean square of the relative difference.
        share: f64,
        /// The largest allowed.
        largest: f64,
    },

    /// Waves that run along a track on discrete supports without loss.
    #[error(
        "at {frequency:.1} Hz waves run along the track nearly without loss, and a load that passes its supports has no \
         steady answer; give the rail some damping"
    )]
    UndampedWaves {
        /// Frequency of the load \[Hz\].
        frequency: f64,
    },

    /// Motion that does not repeat itself with every wave of the profile.
    #[error(
        "after {seconds} s of rolling the motion still does not repeat itself from wave to wave: it changes by \
         {change:.1e} of its first harmonic; choose a smaller amplitude"
    )]
    NotSettled {
        /// Time of rolling \[s\].
        seconds: f64,
        /// Change over a tenth of a second, over the first harmonic.
        change: f64,
    },

    /// A profile that ends before the motion has forgotten its beginning.
    #[error("the profile is {length:.3} m long, but the motion remembers {memory:.3} m of rail; give a longer one")]
    ProfileTooShort {
        /// Length of the profile \[m\].
        length: f64,
        /// Distance after which a step of the rail is forgotten \[m\].
        memory: f64,
    },

    /// A wheel that hops instead of rolling.
    #[error(
        "a sinusoid of {:.1} µm and {:.1} mm keeps the wheel in the air for {:.0} % of a wave; choose a smaller amplitude",
        1e6 * amplitude,
        1e3 * wavelength,
        100.0 * share
    )]
    Airborne {
        /// Share of a wave without contact \[-\].
        share: f64,
        /// Amplitude of the profile \[m\].
        amplitude: f64,
        /// Its wavelength \[m\].
        wavelength: f64,
    },

    /// The load outruns the bending waves that its own oscillation excites.
    #[error(
        "a load of wavelength {} m outruns its bending waves at {} m/s; \
         a moving load must stay below the critical speed of {critical_speed:.1} m/s",
        as_typed(*wavelength),
        as_typed(*speed)
    )]
    Supercritical {
        /// Speed of the load \[m/s\].
        speed: f64,
        /// Wavelength of the corrugation \[m\].
        wavelength: f64,
        /// Speed at which the receptance is singular \[m/s\].
        critical_speed: f64,
    },
}

impl Error {
    /// `Ok` for a finite value above zero.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for any other value.
    pub fn unless_positive(quantity: &'static str, value: f64, unit: &'static str) -> Result<(), Self> {
        if value.is_finite() && value > 0.0 {
            return Ok(());
        }
        Err(Self::OutOfRange { quantity, value, unit, rule: "must be finite and greater than zero" })
    }

    /// `Ok` for a finite value of zero or more.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for any other value.
    pub fn unless_not_negative(quantity: &'static str, value: f64, unit: &'static str) -> Result<(), Self> {
        if value.is_finite() && value >= 0.0 {
            return Ok(());
        }
        Err(Self::OutOfRange { quantity, value, unit, rule: "must be finite and not negative" })
    }
}

/// A value as it was typed, or to six digits where it was computed: what has more digits than anybody types.
pub fn as_typed(value: f64) -> String {
    const TYPED: usize = 9;
    let exact = value.to_string();
    let digits = exact.trim_start_matches(['-', '0', '.']).trim_end_matches('0');
    if digits.bytes().filter(u8::is_ascii_digit).count() <= TYPED {
        return exact;
    }
    // The shortest number that is the same to six digits.
    let rounded = format!("{value:.5e}").parse();
    rounded.unwrap_or(value).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_told_as_they_were_typed_or_to_six_digits() {
        for (value, told) in [
            (350.0, "350"),
            (-0.000_123, "-0.000123"),
            (123_456.789, "123456.789"),
            (60.0 / 3.6, "16.6667"),
            (-105_682.186_933_103_25, "-105682"),
            (2.0 / 3e7, "0.0000000666667"),
            (0.1 + 0.2, "0.3"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(as_typed(value), told);
        }
    }
}
