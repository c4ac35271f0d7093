//! What sits on the axle.

use crate::Error;

/// A rigid disc on the axle: a wheel, a brake disc, a gear, an axle box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Place along the axle \[m\], from its middle to the right.
    pub position: f64,
    /// Mass \[kg\].
    pub mass: f64,
    /// Inertia about the axle \[kg m²\]; zero for an axle box, which does not turn.
    pub polar_inertia: f64,
    /// Inertia about a diameter \[kg m²\].
    pub diametral_inertia: f64,
    /// An inertia that turns with the disc through a spring: the rotor of a motor behind its gear, an absorber.
    pub coupled: Option<CoupledInertia>,
}

/// An inertia that turns about the axle on a torsional spring and a damper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledInertia {
    /// Inertia \[kg m²\]; behind a gear of ratio n, n² times that of the rotor.
    pub polar_inertia: f64,
    /// Torsional stiffness \[N m/rad\], seen at the axle too.
    pub stiffness: f64,
    /// Viscous damping \[N m s/rad\].
    pub damping: f64,
}

impl Disc {
    /// Nothing where its inertias and its place on an axle of that length \[m\] have a meaning.
    pub(super) fn check(&self, axle_length: f64) -> Result<(), Error> {
        Error::unless_not_negative("mass of a disc", self.mass, "kg")?;
        Error::unless_not_negative("polar inertia of a disc", self.polar_inertia, "kg m2")?;
        Error::unless_not_negative("diametral inertia of a disc", self.diametral_inertia, "kg m2")?;
        let half = 0.5 * axle_length;
        if !(-half..=half).contains(&self.position) {
            return Err(Error::OutOfRange {
                quantity: "position of a disc",
                value: self.position,
                unit: "m",
                rule: "must lie on the axle, at most half its length from its middle",
            });
        }
        if let Some(coupled) = &self.coupled {
            Error::unless_positive("coupled inertia", coupled.polar_inertia, "kg m2")?;
            Error::unless_positive("stiffness of a coupled inertia", coupled.stiffness, "N m/rad")?;
            Error::unless_not_negative("damping of a coupled inertia", coupled.damping, "N m s/rad")?;
        }
        Ok(())
    }
}
