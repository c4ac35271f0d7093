//! Rail on pads, sleepers and ballast, all spread evenly along the track.

use num_complex::Complex64;

use super::{EulerBernoulliBeam, Receptance};
use crate::Error;

/// A spring and a viscous damper in parallel, per metre of rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer {
    stiffness: f64,
    damping: f64,
}

impl Layer {
    /// A layer of stiffness k \[N/m²\] and viscous damping c \[N s/m²\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless k > 0 and c ≥ 0.
    pub fn new(stiffness: f64, damping: f64) -> Result<Self, Error> {
        Error::unless_positive("layer stiffness", stiffness, "N/m2")?;
        Error::unless_not_negative("layer damping", damping, "N s/m2")?;
        Ok(Self { stiffness, damping })
    }

    /// Dynamic stiffness k + iωc \[N/m²\].
    fn dynamic_stiffness(&self, angular_frequency: f64) -> Complex64 {
        Complex64::new(self.stiffness, angular_frequency * self.damping)
    }
}

/// Track of Bhaskar et al.: a beam on continuous pads, sleeper mass and ballast.
///
/// With κ(ω) = −mω² + 1/(1/(k_p + iωc_p) + 1/(k_b + iωc_b − ω² m_s)) the dynamic stiffness of rail
/// and foundation per metre, H = 1/(2√2 (EI)^{1/4} κ^{3/4}), principal branch: Im κ ≥ 0 for a
/// passive foundation, and κ → −mω² + i0 gives equation (23).
///
/// Source: Bhaskar, Johnson, Wood & Woodhouse (1997); H from the two decaying waves of
/// EI u'''' + κu = F δ(x). Range of validity: wavelengths of the rail well above the support
/// spacing, so below the pinned-pinned frequency. Exact to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoLayerTrack {
    beam: EulerBernoulliBeam,
    pad: Layer,
    sleeper_mass: f64,
    ballast: Layer,
}

impl TwoLayerTrack {
    /// A track with pads, sleeper mass m_s per metre \[kg/m\] and ballast.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the sleeper mass is negative.
    pub fn new(
        beam: EulerBernoulliBeam,
        pad: Layer,
        sleeper_mass: f64,
        ballast: Layer,
    ) -> Result<Self, Error> {
        Error::unless_not_negative("sleeper mass per length", sleeper_mass, "kg/m")?;
        Ok(Self {
            beam,
            pad,
            sleeper_mass,
            ballast,
        })
    }
}

impl Receptance for TwoLayerTrack {
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let w2 = angular_frequency * angular_frequency;
        let pad = self.pad.dynamic_stiffness(angular_frequency);
        let below_pad = self.ballast.dynamic_stiffness(angular_frequency) - w2 * self.sleeper_mass;
        let foundation = pad * below_pad / (pad + below_pad);
        self.beam
            .receptance_on(foundation - w2 * self.beam.mass_per_length())
    }

    fn worth_tabulating(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ElasticMaterial, FreeBeam};
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn rail() -> EulerBernoulliBeam {
        let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
        EulerBernoulliBeam::new(steel, 2.35e-5, 56.0).unwrap()
    }

    /// A weak foundation leaves the free beam: the remainder is ¾ k/(mω²) of the value.
    #[test]
    fn soft_pads_leave_the_free_beam() {
        let layer = Layer::new(1.0, 0.0).unwrap();
        let track = TwoLayerTrack::new(rail(), layer, 150.0, layer).unwrap();
        for w in [300.0, 3e3, 3e4] {
            let (h, free) = (
                track.receptance(w, 0.0),
                FreeBeam::new(rail()).receptance(w, 0.0),
            );
            assert!((h - free).norm() < 1e-6 * free.norm(), "{w}: {h} {free}");
        }
    }

    /// Statics: Winkler (1867), H(0) = 1/(2√2 (EI)^{1/4} k^{3/4}) with the two springs in series.
    #[test]
    fn static_limit_is_the_winkler_beam() {
        let (pad, ballast) = (Layer::new(4e8, 9e4).unwrap(), Layer::new(1e8, 9e4).unwrap());
        let track = TwoLayerTrack::new(rail(), pad, 150.0, ballast).unwrap();
        let winkler = 1.0 / (8f64.sqrt() * (207e9f64 * 2.35e-5).powf(0.25) * 0.8e8f64.powf(0.75));
        let h = track.receptance(1e-4, 0.0);
        assert_relative_eq!(h.re, winkler, max_relative = 1e-9);
    }

    proptest! {
        #[test]
        fn passive(
            w in 10.0..40e3, kp in 1e7..3e9, cp in 0.0..3e5, ms in 0.0..500.0, kb in 1e6..1e9, cb in 0.0..3e5,
        ) {
            let (pad, ballast) = (Layer::new(kp, cp).unwrap(), Layer::new(kb, cb).unwrap());
            let track = TwoLayerTrack::new(rail(), pad, ms, ballast).unwrap();
            prop_assert!(track.receptance(w, 0.0).im <= 0.0);
        }
    }
}
