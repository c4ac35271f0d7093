//! Creep curves of all laws.

use riffel::contact::{CreepLaw, Creepages};
use riffel_keys::CaseError;

use super::{RollingTheories, refused};

/// Tractive ratio against creepage by one law.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepCurve {
    /// Name in the case file, and key in documents and tables.
    pub key: &'static str,
    /// Name in figures.
    pub label: &'static str,
    /// Q/μP at each creepage \[-\].
    pub tractive_ratios: Vec<f64>,
}

/// The curves of all laws over the same creepages.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepCurves {
    /// Creepages \[-\].
    pub creepages: Vec<f64>,
    /// Law by law, the exact one last.
    pub laws: Vec<CreepCurve>,
}

impl CreepCurves {
    /// The curves at some creepages \[-\]; `progress` is told of each of them.
    ///
    /// # Errors
    /// [`CaseError::Physics`] where the exact theory does not converge.
    pub fn new(
        theories: &RollingTheories,
        creepages: Vec<f64>,
        progress: impl Fn(),
    ) -> Result<Self, CaseError> {
        let load = theories.hertz.normal_force();
        let mut exact = Vec::with_capacity(creepages.len());
        for &creepage in &creepages {
            let state = theories.half_space.roll(creepage);
            let state = state.map_err(refused(format!("half-space, creepage {creepage}")))?;
            exact.push(theories.tractive_ratio(state.tangential_force()));
            progress();
        }
        let over = |force: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let ratio = |&creepage| theories.tractive_ratio(force(creepage));
            creepages.iter().map(ratio).collect()
        };
        let by = |law: &dyn CreepLaw| {
            over(&|creepage| {
                law.forces(load, Creepages::longitudinal(creepage))
                    .longitudinal
            })
        };
        let curve = |key, label, tractive_ratios| CreepCurve {
            key,
            label,
            tractive_ratios,
        };
        let laws = theories.laws.laws.iter();
        let mut laws: Vec<CreepCurve> = laws
            .map(|(entry, law)| curve(entry.name, entry.label, by(&**law)))
            .collect();
        laws.push(curve("half-space", "half-space (exact)", exact));
        Ok(Self { creepages, laws })
    }
}
