//! Rail on supports that are spread evenly along it.

use std::sync::Arc;

use num_complex::Complex64;

use super::{Beam, CrossReceptance, Receptance, Support, Waveguide, Waves};

/// An infinite rail without support, on one layer, or on two: the track of Bhaskar et al. (1997).
///
/// The support's dynamic stiffness κ(ω) per metre carries the rail everywhere alike; the rail's
/// outgoing waves give the receptance, see [`Beam`] and [`Bar`](super::Bar).
///
/// Range of validity: wavelengths of the rail well above the support spacing, so below the
/// pinned-pinned frequency. Exact to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContinuousTrack<R = Beam> {
    rail: R,
    support: Option<Support>,
}

impl<R: Waveguide> ContinuousTrack<R> {
    /// A rail on a support whose values are per metre.
    pub fn new(rail: R, support: Support) -> Self {
        Self { rail, support: Some(support) }
    }

    /// A rail without support.
    pub fn free(rail: R) -> Self {
        Self { rail, support: None }
    }

    fn foundation(&self, angular_frequency: f64) -> Complex64 {
        self.support.map_or(Complex64::ZERO, |support| support.dynamic_stiffness(angular_frequency))
    }
}

impl<R: Waveguide> Receptance for ContinuousTrack<R> {
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        self.rail.point_receptance(angular_frequency, self.foundation(angular_frequency))
    }

    fn worth_tabulating(&self) -> bool {
        true
    }
}

impl<R: Waveguide + Copy + 'static> CrossReceptance for ContinuousTrack<R> {
    fn cross_receptance(&self, angular_frequency: f64, from: f64, to: f64) -> Complex64 {
        let foundation = self.foundation(angular_frequency);
        let waves = self.rail.waves(angular_frequency, foundation);
        let distance = (to - from).abs();
        waves.as_slice().iter().map(|wave| wave.amplitude * (-wave.propagation * distance).exp()).sum()
    }

    fn support_spacing(&self) -> Option<f64> {
        None
    }

    fn under_load_at(&self, _place: f64) -> Arc<dyn Receptance> {
        Arc::new(*self)
    }
}

impl<R: Waveguide> ContinuousTrack<R> {
    /// The waves that a force sends along the track.
    pub fn waves(&self, angular_frequency: f64) -> Waves {
        self.rail.waves(angular_frequency, self.foundation(angular_frequency))
    }
}
