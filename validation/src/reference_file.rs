//! Files of cases, each with points at which numbers are expected.

use serde::Deserialize;
use serde::de::DeserializeOwned;

/// A case with its points.
#[derive(Deserialize)]
pub(crate) struct ReferenceCase<P> {
    pub(crate) name: String,
    pub(crate) case_toml: String,
    pub(crate) points: Vec<P>,
}

#[derive(Deserialize)]
struct ReferenceFile<P> {
    cases: Vec<ReferenceCase<P>>,
}

/// The cases of a file.
pub(crate) fn reference_cases<P: DeserializeOwned>(file: &str) -> Vec<ReferenceCase<P>> {
    let file: ReferenceFile<P> = serde_json::from_str(file).expect("valid JSON");
    file.cases
}
