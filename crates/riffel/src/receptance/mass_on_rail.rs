//! A mass on the static shape of a rail: the closed form of P2.

use super::Support;
use crate::Error;

/// A mass on a rail that keeps the shape in which it bends under a resting load:
///
/// ```text
/// k_t = 8 EI β³     m_t = 3m/2β     β = (k/4EI)^{1/4}     f = √(k_e/(m_u + m_t))/2π     1/k_e = 1/k_t + 1/k_H
/// ```
///
/// k and m are the static stiffness of the supports and the mass that moves with the rail, both per metre; of a sleeper that
/// moves with the share s of the rail, s² of its mass. Source: Winkler's beam, whose energy of motion is that of m_t at the load.
///
/// Range of validity: without shear, which makes the rail some per cent softer, and below the frequency at which the track
/// moves on its own. Beside a continuous track it is within 0.4 % (test `p2_is_the_mass_on_the_static_shape`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassOnRail {
    /// Unsprung mass m_u \[kg\].
    pub mass: f64,
    /// Mass of the track m_t that moves with it \[kg\].
    pub track_mass: f64,
    /// Stiffness k_e of track and contact in series \[N/m\].
    pub stiffness: f64,
}

impl MassOnRail {
    /// A mass m_u \[kg\] on a rail of the bending stiffness EI \[N m²\] and the mass \[kg/m\], on supports per metre, through a
    /// contact spring \[N/m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all are positive.
    pub fn new(
        mass: f64,
        bending_stiffness: f64,
        rail_mass: f64,
        support: Support,
        contact_stiffness: f64,
    ) -> Result<Self, Error> {
        Error::unless_positive("unsprung mass", mass, "kg")?;
        Error::unless_positive("bending stiffness", bending_stiffness, "N m2")?;
        Error::unless_positive("mass per length", rail_mass, "kg/m")?;
        Error::unless_positive("contact stiffness", contact_stiffness, "N/m")?;
        let (foundation, sleepers) = support.at_rest();
        Error::unless_positive("static stiffness of the support", foundation, "N/m2")?;
        let beta = (foundation / (4.0 * bending_stiffness)).powf(0.25);
        let of_track = 8.0 * bending_stiffness * beta.powi(3);
        Ok(Self {
            mass,
            track_mass: 1.5 * (rail_mass + sleepers) / beta,
            stiffness: (of_track.recip() + contact_stiffness.recip()).recip(),
        })
    }

    /// Angular frequency \[rad/s\].
    pub fn angular_frequency(&self) -> f64 {
        (self.stiffness / (self.mass + self.track_mass)).sqrt()
    }
}
