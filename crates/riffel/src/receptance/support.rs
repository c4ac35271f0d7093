//! What carries the rail: pads, sleepers and ballast.

use num_complex::Complex64;

use crate::Error;

/// A spring with viscous and hysteretic damping, in one direction; per support, or per metre of rail
/// where supports are spread evenly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    stiffness: f64,
    damping: f64,
    loss_factor: f64,
}

impl Layer {
    /// A layer of stiffness k and viscous damping c: \[N/m\] and \[N s/m\] per support, \[N/m²\] and
    /// \[N s/m²\] per metre of rail.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless k > 0 and c ≥ 0.
    pub fn new(stiffness: f64, damping: f64) -> Result<Self, Error> {
        Error::unless_positive("layer stiffness", stiffness, "N/m")?;
        Error::unless_not_negative("layer damping", damping, "N s/m")?;
        Ok(Self { stiffness, damping, loss_factor: 0.0 })
    }

    /// Layer with a loss factor η \[-\]: k becomes k(1 + iη), at every frequency.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if η is negative.
    pub fn with_loss_factor(self, loss_factor: f64) -> Result<Self, Error> {
        Error::unless_not_negative("loss factor", loss_factor, "")?;
        Ok(Self { loss_factor, ..self })
    }

    /// Dynamic stiffness k(1 + iη) + sc for motion like e^{st}; s = iω where nothing moves along.
    pub(super) fn dynamic_stiffness(&self, s: Complex64) -> Complex64 {
        Complex64::new(self.stiffness, self.stiffness * self.loss_factor) + s * self.damping
    }

    /// Coefficients of the dynamic stiffness as a polynomial in s, constant term first.
    pub(super) fn polynomial(&self) -> [Complex64; 2] {
        [self.dynamic_stiffness(Complex64::ZERO), self.damping.into()]
    }

    /// k, without damping.
    pub(super) fn stiffness(&self) -> f64 {
        self.stiffness
    }

    fn scaled(&self, factor: f64) -> Self {
        Self { stiffness: self.stiffness * factor, damping: self.damping * factor, loss_factor: self.loss_factor }
    }
}

/// What the rail stands on, to the ground that does not move; per support, or per metre of rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Support {
    /// Pads on a slab.
    OneLayer {
        /// Rail pad.
        pad: Layer,
    },
    /// Pads on sleepers on ballast.
    TwoLayer {
        /// Rail pad.
        pad: Layer,
        /// Mass of the sleeper that moves with one rail \[kg\], or per metre \[kg/m\].
        sleeper_mass: f64,
        /// Ballast.
        ballast: Layer,
    },
}

impl Support {
    /// Pads on a slab.
    pub fn one_layer(pad: Layer) -> Self {
        Self::OneLayer { pad }
    }

    /// Pads on sleepers of the mass m_s \[kg\], or \[kg/m\], on ballast.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the sleeper mass is negative.
    pub fn two_layer(pad: Layer, sleeper_mass: f64, ballast: Layer) -> Result<Self, Error> {
        Error::unless_not_negative("sleeper mass", sleeper_mass, "kg")?;
        Ok(Self::TwoLayer { pad, sleeper_mass, ballast })
    }

    /// Support per metre of rail, one every `spacing` \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the spacing is positive.
    pub fn per_metre(&self, spacing: f64) -> Result<Self, Error> {
        Error::unless_positive("support spacing", spacing, "m")?;
        let share = spacing.recip();
        Ok(match *self {
            Self::OneLayer { pad } => Self::OneLayer { pad: pad.scaled(share) },
            Self::TwoLayer { pad, sleeper_mass, ballast } => Self::TwoLayer {
                pad: pad.scaled(share),
                sleeper_mass: sleeper_mass * share,
                ballast: ballast.scaled(share),
            },
        })
    }

    /// Dynamic stiffness under the rail: k_p, or 1/(1/k_p + 1/(k_b − ω²m_s)), with
    /// k = k(1 + iη) + iωc in both layers. Im ≥ 0: a support takes energy.
    pub fn dynamic_stiffness(&self, angular_frequency: f64) -> Complex64 {
        let s = Complex64::new(0.0, angular_frequency);
        match self {
            Self::OneLayer { pad } => pad.dynamic_stiffness(s),
            Self::TwoLayer { pad, sleeper_mass, ballast } => {
                let pad = pad.dynamic_stiffness(s);
                let below_pad = ballast.dynamic_stiffness(s) - sleeper_mass * angular_frequency * angular_frequency;
                pad * below_pad / (pad + below_pad)
            }
        }
    }

    /// Stiffness under a rail that does not move, and the mass of the sleeper that moves with the rail, by its energy: both
    /// per support, or per metre as the support is.
    pub(super) fn at_rest(&self) -> (f64, f64) {
        match *self {
            Self::OneLayer { pad } => (pad.stiffness, 0.0),
            Self::TwoLayer { pad, sleeper_mass, ballast } => {
                let share = pad.stiffness / (pad.stiffness + ballast.stiffness);
                (share * ballast.stiffness, share * share * sleeper_mass)
            }
        }
    }

    /// Motion of the sleeper over that of the rail above it, k_p/(k_p + k_b − ω²m_s); None without a sleeper.
    pub fn sleeper_share(&self, angular_frequency: f64) -> Option<Complex64> {
        let Self::TwoLayer { pad, sleeper_mass, ballast } = self else {
            return None;
        };
        let s = Complex64::new(0.0, angular_frequency);
        let pad = pad.dynamic_stiffness(s);
        let below_pad = ballast.dynamic_stiffness(s) - sleeper_mass * angular_frequency * angular_frequency;
        Some(pad / (pad + below_pad))
    }

    /// The pad alone.
    pub(super) fn pad(&self) -> &Layer {
        let (Self::OneLayer { pad } | Self::TwoLayer { pad, .. }) = self;
        pad
    }

    /// Undamped angular frequencies \[rad/s\] at which a rail of the mass m (per support, or per
    /// metre as the support is) moves on the support without bending, lowest first: rail on pad; or
    /// rail with sleeper on ballast, and rail against sleeper on the pad. Waves of the track cut on
    /// there, and its receptance has its peaks nearby.
    ///
    /// Source: ω² of (k_p − mω²)(k_p + k_b − m_sω²) = k_p². Exact to rounding.
    pub fn cut_on_frequencies(&self, rail_mass: f64) -> Vec<f64> {
        match *self {
            Self::OneLayer { pad } => vec![(pad.stiffness / rail_mass).sqrt()],
            Self::TwoLayer { pad, sleeper_mass, ballast } => {
                let (kp, kb) = (pad.stiffness, ballast.stiffness);
                if sleeper_mass == 0.0 {
                    return vec![(kp * kb / (kp + kb) / rail_mass).sqrt()];
                }
                let sum = kp / rail_mass + (kp + kb) / sleeper_mass;
                let product = kp * kb / (rail_mass * sleeper_mass);
                let upper = 0.5 * (sum + (sum * sum - 4.0 * product).sqrt());
                vec![(product / upper).sqrt(), upper.sqrt()]
            }
        }
    }

    /// Undamped angular frequency \[rad/s\] at which the sleeper between pad and ballast holds the rail still,
    /// √((k_p + k_b)/m_s); None without a sleeper that has mass.
    pub fn sleeper_antiresonance(&self) -> Option<f64> {
        match *self {
            Self::TwoLayer { pad, sleeper_mass, ballast } if sleeper_mass > 0.0 => {
                Some(((pad.stiffness + ballast.stiffness) / sleeper_mass).sqrt())
            }
            _ => None,
        }
    }

    /// Stiffness at rest.
    pub fn static_stiffness(&self) -> f64 {
        match self {
            Self::OneLayer { pad } => pad.stiffness,
            Self::TwoLayer { pad, ballast, .. } => {
                pad.stiffness * ballast.stiffness / (pad.stiffness + ballast.stiffness)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// At a cut-on frequency the undamped support balances the rail's inertia.
    #[test]
    fn cut_on_frequencies_balance_the_rail() {
        let (pad, ballast) = (Layer::new(3e8, 0.0).unwrap(), Layer::new(1e8, 0.0).unwrap());
        let two = Support::two_layer(pad, 250.0, ballast).unwrap();
        for support in [Support::one_layer(pad), two] {
            for w in support.cut_on_frequencies(60.0) {
                let stiffness = support.dynamic_stiffness(w);
                assert_relative_eq!(stiffness.re, 60.0 * w * w, max_relative = 1e-12);
            }
        }
        assert_eq!(two.cut_on_frequencies(60.0).len(), 2);
    }

    /// There the undamped support is infinitely stiff.
    #[test]
    fn the_sleeper_holds_the_rail_still() {
        let (pad, ballast) = (Layer::new(3e8, 0.0).unwrap(), Layer::new(1e8, 0.0).unwrap());
        let two = Support::two_layer(pad, 250.0, ballast).unwrap();
        let w = two.sleeper_antiresonance().unwrap();
        // √(4e8/250)/2π = 201.3 Hz.
        assert_relative_eq!(w / std::f64::consts::TAU, 201.317, max_relative = 1e-5);
        assert!(two.dynamic_stiffness(w * (1.0 + 1e-6)).norm() > 1e12);
        assert_eq!(Support::one_layer(pad).sleeper_antiresonance(), None);
    }

    #[test]
    fn half_the_spacing_is_twice_the_stiffness() {
        let pad = Layer::new(3e8, 2e4).unwrap().with_loss_factor(0.2).unwrap();
        let ballast = Layer::new(1e8, 8e4).unwrap();
        let support = Support::two_layer(pad, 150.0, ballast).unwrap();
        let stiffness = |spacing| support.per_metre(spacing).unwrap().dynamic_stiffness(2e3);
        assert_relative_eq!(stiffness(0.3).re, 2.0 * stiffness(0.6).re, max_relative = 1e-14);
        assert_relative_eq!(stiffness(0.3).im, 2.0 * stiffness(0.6).im, max_relative = 1e-14);
        assert!(support.per_metre(0.0).is_err());
    }
}
