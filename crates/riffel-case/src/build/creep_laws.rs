//! The creep laws that are formulas of the contact ellipse of a case.

use riffel_keys::{CaseError, say};
use std::sync::Arc;

use riffel::HertzContact;
use riffel::contact::{
    CREEP_LAWS, CreepLaw, CreepLawEntry, CreepLawInputs, FallingFriction, KalkerCoefficients, SlopeReduction,
};

use crate::file::PolachParameters;
use crate::keys::checked_keys::CheckedKeys;

/// Every creep law that is a formula of the ellipse, on that of a case and with its friction.
#[derive(Clone)]
pub struct CreepLaws {
    /// Kalker's coefficients of the ellipse, with which the laws begin.
    pub kalker: KalkerCoefficients,
    /// The laws, each with its entry in the catalogue, in the order there.
    pub laws: Vec<(&'static CreepLawEntry, Arc<dyn CreepLaw>)>,
}

/// What Polach's law takes besides the ellipse.
#[derive(Clone, Copy)]
pub(crate) struct PolachTerms {
    friction: FallingFriction,
    reduction: SlopeReduction,
    /// V \[m/s\].
    speed: f64,
}

impl CheckedKeys {
    /// The laws on an ellipse, with the coefficient of friction μ \[-\].
    pub(crate) fn creep_laws(&self, hertz: HertzContact, friction: f64) -> Result<CreepLaws, CaseError> {
        let kalker = self.kalker(hertz)?;
        let inputs = self.creep_law_inputs(hertz, friction)?;
        let laws = CREEP_LAWS.iter().map(|entry| Ok((entry, entry.build(&inputs)?)));
        Ok(CreepLaws { kalker, laws: self.physics("contact", laws.collect())? })
    }

    /// Kalker's coefficients of an ellipse.
    pub(crate) fn kalker(&self, hertz: HertzContact) -> Result<KalkerCoefficients, CaseError> {
        let poisson_ratio = hertz.material().poisson_ratio();
        let kalker = KalkerCoefficients::new(poisson_ratio, hertz.axis_ratio());
        let key = if poisson_ratio < 0.0 { "steel.poisson_ratio" } else { "contact.transverse_radius" };
        self.physics(key, kalker)
    }

    /// What a creep law is made of.
    pub(crate) fn creep_law_inputs(&self, hertz: HertzContact, friction: f64) -> Result<CreepLawInputs, CaseError> {
        let polach = self.polach(friction)?;
        Ok(CreepLawInputs {
            hertz,
            friction,
            falling_friction: polach.friction,
            slope_reduction: polach.reduction,
            speed: polach.speed,
        })
    }

    /// The parameters of Polach's law: as written, or dry and constant.
    pub(crate) fn polach(&self, friction: f64) -> Result<PolachTerms, CaseError> {
        let written = self.file.contact.polach.clone().unwrap_or_default();
        let reduction = SlopeReduction { adhesion: written.adhesion_reduction.si(), slip: written.slip_reduction.si() };
        if reduction.slip > reduction.adhesion {
            return Err(self.out_of_range(
                "contact.polach.slip_reduction",
                reduction.slip,
                say!(at_most_contact_polach_adhesion_reduction, value = reduction.adhesion),
            ));
        }
        let PolachParameters { limit_friction_ratio, friction_decay, speed, .. } = written;
        if limit_friction_ratio.is_none() && friction_decay.is_none() && speed.is_none() {
            // With constant friction the law does not depend on the speed.
            return Ok(PolachTerms { friction: FallingFriction::constant(friction), reduction, speed: 1.0 });
        }
        let missing = |key: &str| self.text.keys.missing(key, say!(falling_friction_needs_limit_friction_ratio));
        let key = "contact.polach.limit_friction_ratio";
        let limit_ratio = limit_friction_ratio.ok_or_else(|| missing(key))?.si();
        let key = "contact.polach.friction_decay";
        let decay = friction_decay.ok_or_else(|| missing(key))?.si();
        let key = "contact.polach.speed";
        let speed = speed.ok_or_else(|| missing(key))?.si();
        Ok(PolachTerms {
            friction: FallingFriction { static_friction: friction, limit_ratio, decay },
            reduction,
            speed,
        })
    }
}
