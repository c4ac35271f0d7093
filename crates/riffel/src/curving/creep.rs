//! The creep force of one rail's contacts.

use std::sync::Arc;

use super::RollingPosition;
use crate::contact::{
    ContactBody, CreepEllipse, CreepForces, CreepLaw, Creepages, EllipticContact, Fastsim,
    KalkerCoefficients, ShenHedrickElkins, TractionBound,
};
use crate::{ElasticMaterial, Error};

/// How the contacts on one rail answer to creepage.
#[derive(Clone)]
pub enum Creep {
    /// Kalker's linear theory on one ellipse, which grows with the load and knows no friction but as what forces are
    /// compared to.
    Linear {
        /// The ellipse.
        ellipse: CreepEllipse,
        /// Coefficient of friction μ \[-\].
        friction: f64,
    },
    /// A creep law, whatever the place of the contact.
    Law(Arc<dyn CreepLaw>),
    /// A law on the Hertz ellipse at the place of the contact.
    Local {
        /// The law.
        law: LawOnEllipse,
        /// Material of wheel and rail.
        material: ElasticMaterial,
        /// Rolling radius r₀ \[m\].
        rolling_radius: f64,
        /// Curvature of wheel and rail across the track \[1/m\] where the running surfaces do not tell it.
        lateral_curvature: f64,
        /// Coefficient of friction μ \[-\].
        friction: f64,
    },
}

/// A creep law that is made for each ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LawOnEllipse {
    /// [`ShenHedrickElkins`].
    ShenHedrickElkins,
    /// [`Fastsim`] on its usual grid and with Kalker's bound, a hundred times slower: creepage and spin together at any spin.
    Fastsim,
}

impl Creep {
    /// The same with a closed law in the place of one that is computed cell by cell; none where it is closed already.
    pub(super) fn closed(&self) -> Option<Self> {
        let mut closed = self.clone();
        match &mut closed {
            Self::Local { law, .. } if *law == LawOnEllipse::Fastsim => {
                *law = LawOnEllipse::ShenHedrickElkins;
                Some(closed)
            }
            _ => None,
        }
    }

    /// Coefficient of friction μ \[-\].
    pub fn friction(&self) -> f64 {
        match self {
            Self::Linear { friction, .. } | Self::Local { friction, .. } => *friction,
            Self::Law(law) => law.friction(),
        }
    }

    /// Forces on the rail \[N\] under a normal force P > 0 \[N\] at a place of the contact.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a place whose curvatures have no ellipse.
    pub fn forces(
        &self,
        normal_force: f64,
        creepages: Creepages,
        position: &RollingPosition,
    ) -> Result<CreepForces, Error> {
        Ok(match self {
            Self::Linear { ellipse, .. } => ellipse.under(normal_force).linear_forces(creepages),
            Self::Law(law) => law.forces(normal_force, creepages),
            Self::Local { law, friction, .. } => {
                let ellipse = self.ellipse(normal_force, position)?;
                match law {
                    LawOnEllipse::ShenHedrickElkins => {
                        ShenHedrickElkins::new(ellipse, *friction)?.forces(normal_force, creepages)
                    }
                    LawOnEllipse::Fastsim => {
                        let (bound, divisions) =
                            (TractionBound::default(), Fastsim::DEFAULT_DIVISIONS);
                        Fastsim::new(ellipse, *friction, bound, divisions)?
                            .forces(normal_force, creepages)
                    }
                }
            }
        })
    }

    /// The Hertz ellipse at a place, with Kalker's coefficients.
    fn ellipse(
        &self,
        normal_force: f64,
        position: &RollingPosition,
    ) -> Result<CreepEllipse, Error> {
        let Self::Local {
            material,
            rolling_radius,
            lateral_curvature,
            ..
        } = self
        else {
            unreachable!("only a local creep has an ellipse of its own")
        };
        let radius = rolling_radius + position.radius_change;
        let body = |longitudinal_curvature, lateral_curvature| ContactBody {
            material: *material,
            longitudinal_curvature,
            lateral_curvature,
        };
        let across = position.lateral_curvature.unwrap_or(*lateral_curvature);
        // In the plane of contact the wheel's curvature along the rail is that of a cone.
        let along = position.contact_angle.cos() / radius;
        let hertz = EllipticContact::new([body(along, 0.0), body(0.0, across)], normal_force)?;
        let kalker = KalkerCoefficients::new(material.poisson_ratio(), hertz.axis_ratio())?;
        Ok(CreepEllipse {
            normal_force,
            semi_axis_longitudinal: hertz.semi_axis_longitudinal(),
            semi_axis_lateral: hertz.semi_axis_lateral(),
            shear_modulus: material.shear_modulus(),
            c11: kalker.c11,
            c22: kalker.c22,
            c23: kalker.c23,
        })
    }
}
