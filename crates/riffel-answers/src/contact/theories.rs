//! The contact of a case by all theories.

use riffel::contact::{ContactElement, CreepEllipse, CreepLaw, HalfSpace, HalfSpaceRolling, JohnsonVermeulen};
use riffel::{Carter3d, HertzContact};
use riffel_case::{CaseContact, CreepLaws, SteadyContact};
use riffel_keys::CaseError;

/// The contact of the case by all theories, and its mean state by its own and by the exact one.
pub struct RollingTheories {
    /// The contact of the case.
    pub contact: CaseContact,
    /// The ellipse.
    pub hertz: HertzContact,
    /// Coefficient of friction \[-\].
    pub friction: f64,
    /// The laws that are formulas of the ellipse.
    pub laws: CreepLaws,
    /// The mean state by the law of the case.
    pub steady: SteadyContact,
    /// Kalker's exact theory on half-spaces.
    pub half_space: HalfSpace,
    /// The mean state by the exact theory: at the tractive ratio of the law, or at the creepages of a table.
    pub state: HalfSpaceRolling,
    full_slip_creepage: f64,
}

impl RollingTheories {
    /// All theories about the mean state of the case.
    ///
    /// # Errors
    /// [`CaseError`] for a grid of the contact that is too coarse, or where the exact theory does not converge.
    pub fn new(contact: CaseContact) -> Result<Self, CaseError> {
        let (hertz, friction) = (contact.hertz, contact.friction());
        let by_law = contact.steady_by_law()?;
        let half_space = contact.half_space()?;
        let state = contact.exact(&half_space)?;
        let laws = contact.creep_laws()?;
        let full_slip = || -> Result<f64, riffel::Error> {
            let ellipse = CreepEllipse::new(hertz, laws.kalker);
            let by_ellipse = JohnsonVermeulen::new(ellipse, friction)?.limit(hertz.normal_force());
            let by_paper = Carter3d::new(hertz, friction)?.saturation_creepage();
            Ok(by_ellipse.creepage().max(by_paper))
        };
        let full_slip_creepage = full_slip().map_err(refused("the creep curves"))?;
        Ok(Self {
            steady: by_law.unwrap_or_else(|| SteadyContact::exact(&half_space, &state)),
            contact,
            hertz,
            friction,
            full_slip_creepage,
            laws,
            half_space,
            state,
        })
    }

    /// `Ok` if the exact theory has slopes about its mean state.
    ///
    /// # Errors
    /// [`CaseError`] near full slip.
    pub fn check_slope(&self) -> Result<(), CaseError> {
        match self.along_rail() {
            true => slope_at(&self.contact, self.exact_tractive_ratio()),
            false => Ok(()),
        }
    }

    /// |Q|/μP of the mean state by the exact theory.
    pub fn exact_tractive_ratio(&self) -> f64 {
        self.half_space.steady(&self.state).tractive_ratio()
    }

    /// True for a mean state of longitudinal creepage alone, given by a number.
    pub fn along_rail(&self) -> bool {
        self.contact.vector_creepage().is_none()
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
        (1..=POINTS).map(|index| last * f64::from(index) / f64::from(POINTS)).collect()
    }
}

/// `Ok` if there is a slope at a tractive ratio \[-\].
fn slope_at(contact: &CaseContact, ratio: f64) -> Result<(), CaseError> {
    /// What the search for a tractive ratio leaves.
    const ROUNDING: f64 = 2e-6;
    if ratio <= HalfSpace::LARGEST_TRACTIVE_RATIO + ROUNDING {
        return Ok(());
    }
    let message = format!(
        "the tractive ratio of the case is {ratio:.4}, but must be at most {} for a frequency \
         response: nearer to full slip the creep curve has no slope",
        HalfSpace::LARGEST_TRACTIVE_RATIO
    );
    let key = match contact.file.contact.creepage {
        Some(_) => "contact.creepage",
        None => "contact.tractive_ratio",
    };
    Err(contact.refuse(key, &message))
}

/// A refusal of the physics, with what was computed.
pub(super) fn refused(input: impl Into<String>) -> impl FnOnce(riffel::Error) -> CaseError {
    let input = input.into();
    move |error| CaseError::Physics { input, error }
}
