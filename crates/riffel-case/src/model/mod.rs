//! Models of the field by name, each read from one case.
//!
//! A model says what stands at each joint of the loop. It is built by changing the keys of a case, so that there is one
//! way from keys to a loop; what no key says, a wear law by force or a mass on a spring, is put in afterwards.

mod joints;
mod on_case;

pub use joints::{Joint, Joints};
pub use on_case::{ModelOnCase, NotOnCase};

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// No model has this name.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("no model has the name \"{0}\"; models: {models}", models = FieldModel::names())]
pub struct UnknownModel(pub String);

/// A model of the field.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct FieldModel {
    /// Name on the command line and in documents.
    pub name: String,
    /// Authors and year.
    pub title: String,
    /// Where it was published.
    pub source: String,
    /// What it takes for given.
    pub assumptions: Vec<String>,
    /// What of the case it leaves out.
    pub leaves_out: Vec<String>,
    /// What is not known of the paper, and what stands in for it.
    #[serde(default)]
    pub not_given: Vec<String>,
    /// What stands at each joint.
    #[serde(default)]
    pub joints: Joints,
    /// Whether its papers draw wear in the complex plane over frequency, over a support and in mid-span.
    #[serde(default, skip_serializing)]
    pub complex_plane: bool,
}

/// `models.toml`, as it is written.
#[derive(Deserialize)]
struct Models {
    model: Vec<FieldModel>,
}

impl FieldModel {
    /// Every model, by year; those of this program last.
    pub fn all() -> &'static [Self] {
        static MODELS: LazyLock<Vec<FieldModel>> = LazyLock::new(|| {
            let read: Result<Models, _> = toml::from_str(include_str!("models.toml"));
            read.expect("`models.toml` holds models of the field").model
        });
        &MODELS
    }

    /// The names of all, with commas between them.
    fn names() -> String {
        Self::all().iter().map(|model| &*model.name).collect::<Vec<_>>().join(", ")
    }

    /// The model of this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        Self::all().iter().find(|model| model.name == name)
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
}
