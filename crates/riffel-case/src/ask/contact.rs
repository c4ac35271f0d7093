//! The contact of a case by itself, without track, wheels and loop.

use std::path::Path;
use std::sync::Arc;

use riffel::contact::{CreepLaw, Creepages, HalfSpace, HalfSpaceRolling, MeanRolling, MeanState, QuasiStatic};
use riffel::{HertzContact, RollingContact};
use riffel_keys::{CaseError, Message, text_file};

use crate::build::{CreepLaws, mean_key, validity};
use crate::case::Case;
use crate::file::{CaseFile, ContactDynamics, CreepLawName};
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::substitutes::Substitutes;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

/// The contact of a case, of which nothing else is built: it may creep by spin alone or slide in full, where no loop is
/// closed.
#[derive(Clone)]
pub struct CaseContact {
    keys: CheckedKeys,
    /// Every key with its value, presets and defaults filled in.
    pub file: CaseFile,
    /// The contact patch.
    pub hertz: HertzContact,
    /// The mean state that the case asks for.
    pub mean: MeanState,
    /// The creep law of the case; `None` if that is Kalker's exact theory.
    pub law: Option<Arc<dyn CreepLaw>>,
    /// What the reader should know about the validity of the models of the contact.
    pub remarks: Vec<Message>,
}

/// Steady rolling by the creep law of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyContact {
    /// Creepages and forces.
    pub rolling: MeanRolling,
    /// Moment of the creep tractions about the normal \[Nm\]; `None` if the law does not tell it.
    pub spin_moment: Option<f64>,
}

impl SteadyContact {
    /// By the exact theory.
    pub fn exact(half_space: &HalfSpace, state: &HalfSpaceRolling) -> Self {
        Self { rolling: half_space.steady(state), spin_moment: Some(state.spin_moment()) }
    }

    /// Energy dissipated per metre of rail, ξ·Q + φM \[J/m\]; `None` if there is spin and the law does not tell its moment.
    pub fn energy_per_metre(&self) -> Option<f64> {
        let spin = self.rolling.creepages.spin;
        let of_spin = match self.spin_moment {
            Some(moment) => spin * moment,
            None if spin == 0.0 => 0.0,
            None => return None,
        };
        Some(self.rolling.energy_per_metre() + of_spin)
    }
}

impl CaseContact {
    /// The contact of a case file, as [`Case::read`] reads it.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule; what is wrong with track and wheels alone is not looked at.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let text = text_file::read_keys(path, "case file")?;
        let mut text = CaseText::parse(&path.display().to_string(), &text)?;
        text.apply(overrides)?;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        let given = Substitutes::default();
        let keys = CheckedKeys::of_text(text, Some(folder), given, Window::Map)?;
        Self::of_keys(keys)
    }

    /// The contact of a case.
    ///
    /// # Errors
    /// [`CaseError`] for an ellipse beyond the table of Kalker's coefficients.
    pub fn of(case: &Case) -> Result<Self, CaseError> {
        Self::of_keys(case.keys.clone())
    }

    fn of_keys(keys: CheckedKeys) -> Result<Self, CaseError> {
        let (wavelength, _) = keys.window()?;
        let hertz = keys.hertz(keys.steel()?)?;
        keys.check_contact()?;
        let mut remarks = keys.text.remarks.clone();
        remarks.extend(validity::of_contact(&keys, hertz, wavelength.min()));
        Ok(Self {
            law: keys.creep_law(hertz, keys.file.contact.friction.si())?,
            mean: keys.mean_state()?,
            file: keys.file.clone(),
            keys,
            hertz,
            remarks,
        })
    }

    /// Coefficient of friction μ \[-\].
    pub fn friction(&self) -> f64 {
        self.file.contact.friction.si()
    }

    /// The creep law: as written, or the one that goes with the response.
    pub fn creep_law(&self) -> CreepLawName {
        self.keys.creep_law_name()
    }

    /// The creepages as the case gives them, where it gives a table of them.
    pub fn vector_creepage(&self) -> Option<Creepages> {
        let creepage = self.file.contact.creepage?;
        creepage.is_vector().then(|| creepage.components())
    }

    /// True if the contact of the case answers late, by the exact theory.
    pub fn is_non_steady(&self) -> bool {
        self.file.contact.response == ContactDynamics::NonSteady
    }

    /// The contact by Kalker's exact theory on half-spaces, whichever is the law of the case.
    ///
    /// # Errors
    /// [`CaseError`] for a grid that is too coarse.
    pub fn half_space(&self) -> Result<HalfSpace, CaseError> {
        self.keys.half_space_of(self.hertz, self.friction())
    }

    /// The mean state of the case by the exact theory, with a slope or without.
    ///
    /// # Errors
    /// [`CaseError`] where the law of the case or the exact theory has no such state.
    pub fn exact(&self, half_space: &HalfSpace) -> Result<HalfSpaceRolling, CaseError> {
        let mean = match (self.steady_by_law()?, self.vector_creepage()) {
            // At the tractive ratio of the law, so that creepages can be compared; full sliding has its creepage alone.
            (Some(by_law), None) if by_law.rolling.tractive_ratio() < 1.0 => {
                MeanState::TractiveRatio(by_law.rolling.tractive_ratio())
            }
            _ => self.mean,
        };
        self.keys.exact_state(half_space, mean)
    }

    /// Steady rolling by the law of the case.
    ///
    /// # Errors
    /// [`CaseError`] where the law has no such state.
    pub fn steady(&self) -> Result<SteadyContact, CaseError> {
        if let Some(by_law) = self.steady_by_law()? {
            return Ok(by_law);
        }
        let half_space = self.half_space()?;
        let exact = self.exact(&half_space)?;
        Ok(SteadyContact::exact(&half_space, &exact))
    }

    /// [`steady`](Self::steady) where the law is a formula; none for the exact theory.
    ///
    /// # Errors
    /// [`CaseError`] where the law has no such state.
    pub fn steady_by_law(&self) -> Result<Option<SteadyContact>, CaseError> {
        let Some(law) = &self.law else {
            return Ok(None);
        };
        let load = self.hertz.normal_force();
        let rolling = match self.vector_creepage() {
            Some(creepages) => MeanRolling {
                normal_force: load,
                friction: law.friction(),
                creepages,
                forces: law.forces(load, creepages),
            },
            None => {
                let about = QuasiStatic::new(law.clone(), load, self.mean);
                self.keys.physics(mean_key(self.mean), about)?.steady()
            }
        };
        Ok(Some(SteadyContact { rolling, spin_moment: None }))
    }

    /// Every creep law that is a formula of the ellipse.
    ///
    /// # Errors
    /// [`CaseError`] for a Poisson's ratio or an ellipse beyond the table of Kalker's coefficients.
    pub fn creep_laws(&self) -> Result<CreepLaws, CaseError> {
        self.keys.creep_laws(self.hertz, self.friction())
    }

    /// A sentence about a key of the case.
    pub fn refuse(&self, key: &str, message: &str) -> CaseError {
        self.keys.text.keys.refuse(key, message)
    }
}
