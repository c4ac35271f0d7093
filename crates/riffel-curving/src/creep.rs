//! The creep force of one rail's contacts.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::sync::Arc;

use riffel::contact::{
    CreepEllipse, CreepForces, CreepLaw, Creepages, EllipticContact, Fastsim, KalkerCoefficients, ShenHedrickElkins,
    TractionBound,
};
use riffel::{ElasticMaterial, Error};

use super::RollingPosition;

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
    /// Creep with a closed law in the place of one that is computed cell by cell; `None` if it is closed already.
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

    /// Curvatures of wheel and rail together along and across the rail \[1/m\] at a place.
    fn curvatures(&self, position: &RollingPosition) -> [f64; 2] {
        let Self::Local { rolling_radius, lateral_curvature, .. } = self else {
            unreachable!("only a local creep has an ellipse of its own")
        };
        let across = position.lateral_curvature.unwrap_or(*lateral_curvature);
        // In the plane of contact the wheel's curvature along the rail is that of a cone.
        let along = position.contact_angle.cos() / (rolling_radius + position.radius_change);
        [along, across]
    }

    /// The Hertz ellipse of curvatures along and across the rail \[1/m\] under 1 N, with Kalker's coefficients.
    fn unit_ellipse(&self, curvatures: [f64; 2]) -> Result<CreepEllipse, Error> {
        let Self::Local { material, .. } = self else { unreachable!("only a local creep has an ellipse of its own") };
        let normal_force = 1.0;
        let hertz = EllipticContact::of_wheel_on_rail(*material, curvatures, normal_force)?;
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

/// Ellipses under 1 N of the places met last. What differs from one evaluation of a balance to the next is mostly not the
/// place, and its ellipse with Kalker's coefficients costs more than all else.
#[derive(Default)]
pub(super) struct KnownEllipses(RefCell<VecDeque<([f64; 2], CreepEllipse)>>);

impl KnownEllipses {
    /// Two for each wheel of a vehicle, with those beside them of a difference.
    const MOST: usize = 24;

    fn at(&self, creep: &Creep, position: &RollingPosition) -> Result<CreepEllipse, Error> {
        let place = creep.curvatures(position);
        let mut known = self.0.borrow_mut();
        if let Some((_, ellipse)) = known.iter().rev().find(|(of, _)| *of == place) {
            return Ok(*ellipse);
        }
        let ellipse = creep.unit_ellipse(place)?;
        if known.len() == Self::MOST {
            known.pop_front();
        }
        known.push_back((place, ellipse));
        Ok(ellipse)
    }
}

/// The creep of one rail in a balance.
#[derive(Clone, Copy)]
pub(super) struct CreepOnRail<'a> {
    pub(super) creep: &'a Creep,
    pub(super) known: &'a KnownEllipses,
}

impl CreepOnRail<'_> {
    /// Forces on the rail \[N\] under a normal force P > 0 \[N\] at a place of the contact.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a place whose curvatures have no ellipse.
    pub(super) fn forces(
        self,
        normal_force: f64,
        creepages: Creepages,
        position: &RollingPosition,
    ) -> Result<CreepForces, Error> {
        Ok(match self.creep {
            Creep::Linear { ellipse, .. } => ellipse.under(normal_force).linear_forces(creepages),
            Creep::Law(law) => law.forces(normal_force, creepages),
            Creep::Local { law, friction, .. } => {
                let ellipse = self.known.at(self.creep, position)?.under(normal_force);
                match law {
                    LawOnEllipse::ShenHedrickElkins => {
                        ShenHedrickElkins::new(ellipse, *friction)?.forces(normal_force, creepages)
                    }
                    LawOnEllipse::Fastsim => {
                        let (bound, divisions) = (TractionBound::default(), Fastsim::DEFAULT_DIVISIONS);
                        Fastsim::new(ellipse, *friction, bound, divisions)?.forces(normal_force, creepages)
                    }
                }
            }
        })
    }

    pub(super) fn friction(self) -> f64 {
        self.creep.friction()
    }
}
