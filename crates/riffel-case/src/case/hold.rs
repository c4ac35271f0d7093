//! What stays as it is where friction or load change.

use std::fmt;
use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::file::CaseFile;

/// What of the mean state of rolling is held where a variant changes friction or load.
///
/// One number of it must come from outside the contact. A train that pulls or brakes asks for a force, a curve
/// for a creepage; with a tractive ratio held, less friction means less traction, too. Where nobody says it, what the
/// case gives is held, as it is where the same keys are changed in the case file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum Hold {
    /// The tangential force Q₀ \[N\]: τ changes inversely with μP₀.
    Force,
    /// The tractive ratio τ = Q₀/μP₀.
    Ratio,
    /// The creepage ξ₀.
    Creepage,
}

impl Hold {
    /// What is held where nobody says it: what the case gives.
    pub(crate) fn usual(file: &CaseFile) -> Self {
        match file.contact.creepage {
            Some(_) => Self::Creepage,
            None => Self::Ratio,
        }
    }

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::Ratio => "ratio",
            Self::Creepage => "creepage",
        }
    }
}

impl fmt::Display for Hold {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.name())
    }
}

impl FromStr for Hold {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        [Self::Force, Self::Ratio, Self::Creepage]
            .into_iter()
            .find(|hold| hold.name() == name)
            .ok_or_else(|| format!("hold is \"{name}\", but must be force, ratio or creepage"))
    }
}

/// The keys of a mean state that a file of changes may give itself.
pub(crate) const MEAN_STATE: [&str; 2] = ["contact.tractive_ratio", "contact.creepage"];

/// Whether friction and load are the same in two sets of keys.
pub(crate) fn rolls_alike(before: &CaseFile, after: &CaseFile) -> bool {
    let of = |file: &CaseFile| (file.contact.friction.si(), file.contact.normal_load.si());
    of(before) == of(after)
}
