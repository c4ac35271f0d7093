//! What is uncertain in a plan, for a document.

use serde::Serialize;
use toml::Value;

use super::Plan;

/// An uncertain value of a plan with its prior.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uncertain {
    /// Its name in the results.
    pub name: String,
    /// The key that it is or multiplies.
    pub key: String,
    /// Its unit, SI.
    pub unit: String,
    /// `lognormal`, `normal`, `uniform` or `triangular`.
    pub distribution: &'static str,
    /// The keys of that, as they are written.
    pub prior: Value,
    /// Names of the data that depend on it.
    pub data: Vec<String>,
}

impl Plan {
    /// What is uncertain, in the order of the plan, sizes of discrepancies aside.
    pub fn uncertain(&self) -> Vec<Uncertain> {
        let written = self.source.table().get("parameter");
        let written = written.and_then(Value::as_array).into_iter().flatten();
        let parameters = self.posterior.parameters().iter();
        let uncertain = written.zip(parameters).filter_map(|(written, parameter)| {
            let distributions = ["lognormal", "normal", "uniform", "triangular"];
            let mut given = distributions.iter();
            let (distribution, prior) = given.find_map(|name| Some((*name, written.get(*name)?.clone())))?;
            let key = written.get("key").or_else(|| written.get("multiplies"));
            Some(Uncertain {
                name: parameter.name.clone(),
                key: key.and_then(Value::as_str).unwrap_or_default().to_owned(),
                unit: parameter.unit.clone(),
                distribution,
                prior,
                data: self.posterior.data_of(&parameter.name),
            })
        });
        uncertain.collect()
    }
}
