//! The contact of a case by all theories.

use riffel::contact::{
    ContactElement, CreepEllipse, CreepLaw, HalfSpace, HalfSpaceRolling, JohnsonVermeulen,
};
use riffel::{Carter3d, HertzContact};
use riffel_case::{Case, CreepLaws};
use riffel_keys::CaseError;

/// The contact of the case by all theories, and its mean state by the exact one.
pub struct RollingTheories {
    /// The ellipse.
    pub hertz: HertzContact,
    /// Coefficient of friction \[-\].
    pub friction: f64,
    /// The laws that are formulas of the ellipse.
    pub laws: CreepLaws,
    /// Kalker's exact theory on half-spaces.
    pub half_space: HalfSpace,
    /// The mean state by the exact theory.
    pub state: HalfSpaceRolling,
    full_slip_creepage: f64,
}

impl RollingTheories {
    /// All theories about the tractive ratio of the case.
    ///
    /// # Errors
    /// [`CaseError`] near full slip, for a grid of the contact that is too coarse, or where the exact theory
    /// does not converge.
    pub fn new(case: &Case) -> Result<Self, CaseError> {
        let (hertz, friction) = (case.hertz, case.steady.friction);
        let ratio = case.steady.tractive_ratio();
        if ratio > HalfSpace::LARGEST_TRACTIVE_RATIO {
            let message = format!(
                "the tractive ratio of the case is {ratio:.4}, but must be at most {} for a frequency \
                 response: nearer to full slip the creep curve has no slope",
                HalfSpace::LARGEST_TRACTIVE_RATIO
            );
            return Err(case.refuse("contact.tractive_ratio", &message));
        }
        let mean_state = || refused("the mean state of the case");
        let laws = case.creep_laws()?;
        let full_slip = || -> Result<f64, riffel::Error> {
            let ellipse = CreepEllipse::new(hertz, laws.kalker);
            let by_ellipse = JohnsonVermeulen::new(ellipse, friction)?.limit(hertz.normal_force());
            let by_paper = Carter3d::new(hertz, friction)?.saturation_creepage();
            Ok(by_ellipse.creepage().max(by_paper))
        };
        let full_slip_creepage = full_slip().map_err(mean_state())?;
        let across = usize::try_from(case.file.contact.grid).unwrap_or(usize::MAX);
        let half_space =
            HalfSpace::new(hertz, friction, across).map_err(refused("contact.grid"))?;
        let state = half_space
            .roll_at_tractive_ratio(ratio)
            .map_err(mean_state())?;
        Ok(Self {
            hertz,
            friction,
            full_slip_creepage,
            laws,
            half_space,
            state,
        })
    }

    /// The larger of the creepages at which Johnson & Vermeulen and the paper see full slip.
    pub fn full_slip_creepage(&self) -> f64 {
        self.full_slip_creepage
    }

    /// Q/μP of a tangential force \[N\].
    pub fn tractive_ratio(&self, force: f64) -> f64 {
        force / (self.friction * self.hertz.normal_force())
    }

    /// Tractions of the mean state, element by element.
    pub fn elements(&self) -> impl Iterator<Item = ContactElement> + '_ {
        self.half_space.elements(&self.state)
    }

    /// Creepages \[-\] equally spaced to beyond full slip.
    pub fn default_creepages(&self) -> Vec<f64> {
        const POINTS: u32 = 40;
        const BEYOND_FULL_SLIP: f64 = 1.2;
        let last = BEYOND_FULL_SLIP * self.full_slip_creepage();
        (1..=POINTS)
            .map(|index| last * f64::from(index) / f64::from(POINTS))
            .collect()
    }
}

/// A refusal of the physics, with what was computed.
pub(super) fn refused(input: impl Into<String>) -> impl FnOnce(riffel::Error) -> CaseError {
    let input = input.into();
    move |error| CaseError::Physics { input, error }
}
