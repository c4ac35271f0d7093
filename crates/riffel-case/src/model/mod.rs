//! Models of the field by name, each read from one case.
//!
//! A model says what stands at each joint of the loop. It is built by changing the keys of a case, so that there is one
//! way from keys to a loop; what no key says, a wear law by force or a mass on a spring, is put in afterwards.

mod afferrante_ciavarella_2009;
mod bhaskar_1997;
mod both_2001;
mod carson_johnson_1971;
mod elkins_1998;
mod frederick_1987;
mod grassie_edwards_2008;
mod grassie_johnson_1985;
mod hempelmann_knothe_1996;
mod joints;
mod on_case;
mod riffel_exact;
mod tassilly_vincent_1991;
mod valdivia_1988;

pub use joints::{Joint, Joints};
pub use on_case::{ModelOnCase, NotOnCase};

use serde::Serialize;
use thiserror::Error;

/// No model has this name.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("no model has the name \"{0}\"; models: {models}", models = FieldModel::ALL.map(|model| model.name).join(", "))]
pub struct UnknownModel(pub String);

/// A model of the field.
#[derive(Debug, Clone, Copy, Serialize)]
#[non_exhaustive]
pub struct FieldModel {
    /// Name on the command line and in documents.
    pub name: &'static str,
    /// Authors and year.
    pub title: &'static str,
    /// Where it was published.
    pub source: &'static str,
    /// What it takes for given.
    pub assumptions: &'static [&'static str],
    /// What of the case it leaves out.
    pub leaves_out: &'static [&'static str],
    /// What is not known of the paper, and what stands in for it.
    pub not_given: &'static [&'static str],
    /// What stands at each joint.
    pub joints: Joints,
}

impl FieldModel {
    /// Every model, by year; those of this program last.
    pub const ALL: [&'static Self; 13] = [
        &carson_johnson_1971::MODEL,
        &grassie_johnson_1985::MODEL,
        &frederick_1987::MODEL,
        &valdivia_1988::MODEL,
        &tassilly_vincent_1991::MODEL,
        &hempelmann_knothe_1996::MODEL,
        &bhaskar_1997::MODEL,
        &elkins_1998::MODEL,
        &both_2001::MODEL,
        &grassie_edwards_2008::MODEL,
        &afferrante_ciavarella_2009::MODEL,
        Self::EXACT,
        &riffel_exact::WITH_WAVES,
    ];

    /// The case with the exact contact, towards which others are compared.
    pub const EXACT: &'static Self = &riffel_exact::MODEL;

    /// The model of this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        Self::ALL.into_iter().find(|model| model.name == name)
    }

    /// The models of these names, each once.
    ///
    /// # Errors
    /// [`UnknownModel`] with the first name that no model has.
    pub fn named<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<Vec<&'static Self>, UnknownModel> {
        let mut models: Vec<&'static Self> = Vec::new();
        for name in names {
            let model = Self::find(name).ok_or_else(|| UnknownModel(name.to_owned()))?;
            if models.iter().all(|known| known.name != model.name) {
                models.push(model);
            }
        }
        Ok(models)
    }

    /// Whether its papers draw wear in the complex plane over frequency, over a support and in mid-span.
    pub fn has_complex_plane(&self) -> bool {
        self.name == frederick_1987::MODEL.name
    }
}
