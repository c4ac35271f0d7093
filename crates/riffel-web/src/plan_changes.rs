//! What a page changes of a plan with usual priors.

use riffel_keys::say;
use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value as Json;
use toml::{Table, Value};

use crate::fault::Fault;

/// Chains of a page, and draws of each: a shorter warm-up than the program takes by default, and more draws that count.
const CHAINS: i64 = 4;
const WARMUP: i64 = 500;
const DRAWS: i64 = 1500;
/// Seed of the draws, one for all times.
const SEED: i64 = 1;

/// What is changed of a plan.
#[derive(Default, Deserialize)]
pub(crate) struct PlanChanges {
    /// Draws of each chain that are kept.
    #[serde(default)]
    draws: Option<i64>,
    /// By the names of the values.
    #[serde(default)]
    parameters: BTreeMap<String, ParameterChange>,
}

#[derive(Deserialize)]
struct ParameterChange {
    /// It is known, with the value of the case.
    #[serde(default)]
    left_out: bool,
    /// Keys of its prior, such as `median`.
    #[serde(default)]
    prior: BTreeMap<String, Json>,
}

/// What is told of a parameter of a plan.
#[derive(Deserialize)]
struct PlanParameter {
    name: String,
    distribution: String,
}

impl PlanChanges {
    /// The text of a plan, of which a document tells, with the changes.
    pub(crate) fn made(&self, document: &Json) -> Result<String, Fault> {
        let defect = |_| Fault::defect(say!(the_plan_cannot_be_read));
        let text = document["text"].as_str().unwrap_or_default();
        let mut plan: Table = toml::from_str(text).map_err(|_| Fault::defect(say!(the_plan_cannot_be_read)))?;
        let told: Vec<PlanParameter> = serde_json::from_value(document["parameters"].clone()).map_err(defect)?;
        let sampler = [("chains", CHAINS), ("warmup", WARMUP), ("draws", self.draws.unwrap_or(DRAWS)), ("seed", SEED)];
        let sampler = sampler.map(|(key, value)| (key.to_owned(), Value::Integer(value)));
        plan.insert("sampler".to_owned(), Value::Table(sampler.into_iter().collect()));
        if let Some(Value::Array(parameters)) = plan.get_mut("parameter") {
            let given = std::mem::take(parameters).into_iter().zip(told);
            let kept = given.filter_map(|(parameter, told)| match self.parameters.get(&told.name) {
                None => Some(Ok(parameter)),
                Some(change) if change.left_out => None,
                Some(change) => Some(change.made(parameter, &told.distribution)),
            });
            *parameters = kept.collect::<Result<Vec<Value>, Fault>>()?;
        }
        toml::to_string(&plan).map_err(|_| Fault::defect(say!(the_plan_cannot_be_written)))
    }
}

impl ParameterChange {
    fn made(&self, mut parameter: Value, distribution: &str) -> Result<Value, Fault> {
        let prior = parameter.get_mut(distribution).and_then(Value::as_table_mut);
        let prior = prior.ok_or_else(|| Fault::defect(say!(the_plan_cannot_be_read)))?;
        for (key, value) in &self.prior {
            let value = Value::try_from(value).ok();
            let value = value.filter(|value| value.is_str() || value.is_integer() || value.is_float());
            let value = value.ok_or_else(|| Fault::bad(say!(of_a_prior_must_be_a, key = key)))?;
            prior.insert(key.clone(), value);
        }
        Ok(parameter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn parameters_are_left_out_and_priors_changed() {
        let text = "case = \"case.toml\"\n[[parameter]]\nkey = \"a\"\nlognormal = { median = 2.0, factor = 2 }\n\
                    [[parameter]]\nkey = \"b\"\nnormal = { mean = \"3 m\", standard_deviation = \"1 m\" }\n\
                    [[parameter]]\nkey = \"c\"\nuniform = { min = 0, max = 1 }\n";
        let told = |name: &str, distribution: &str| json!({ "name": name, "distribution": distribution });
        let told = [told("a", "lognormal"), told("b", "normal"), told("c", "uniform")];
        let document = json!({ "text": text, "parameters": told });
        let made = |changes: Json| {
            let changes: PlanChanges = serde_json::from_value(changes).unwrap();
            changes.made(&document)
        };
        let plan: Table = toml::from_str(&made(json!({})).unwrap()).unwrap();
        assert_eq!(plan["sampler"]["draws"].as_integer(), Some(DRAWS));
        assert_eq!(plan["parameter"].as_array().unwrap().len(), 3);
        let changes =
            json!({ "draws": 40, "parameters": { "a": { "left_out": true }, "b": { "prior": { "mean": "5 m" } } } });
        let plan: Table = toml::from_str(&made(changes).unwrap()).unwrap();
        let parameters = plan["parameter"].as_array().unwrap();
        assert_eq!(parameters.len(), 2);
        assert_eq!(parameters[0]["normal"]["mean"].as_str(), Some("5 m"));
        assert_eq!(parameters[0]["normal"]["standard_deviation"].as_str(), Some("1 m"));
        assert_eq!(plan["sampler"]["draws"].as_integer(), Some(40));
        let nested = json!({ "parameters": { "b": { "prior": { "mean": [1] } } } });
        assert!(made(nested).unwrap_err().message().contains("`mean`"));
    }
}
