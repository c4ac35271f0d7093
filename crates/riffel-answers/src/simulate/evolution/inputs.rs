//! What the numbers of a run follow from, so that a run that was stopped is not gone on with by another case.

use riffel_case::Case;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::EvolutionRequest;

/// Names of inputs, those of the case by their keys, with their values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub(super) struct Inputs(Map<String, Value>);

impl Inputs {
    /// Inputs of a case, presets and defaults filled in. The profile is not among them: it is the first of the run.
    pub(super) fn new(case: &Case, request: &EvolutionRequest) -> Self {
        /// Keys that no number follows from.
        const IDLE: [&str; 7] = ["title", "vehicle", "corrugation", "curve", "bogie", "body", "profiles"];
        let mut inputs = Map::new();
        inputs.insert("version of Riffel".into(), env!("CARGO_PKG_VERSION").into());
        inputs.insert("--step".into(), request.largest_step.into());
        if request.contact_filter {
            inputs.insert("--contact-filter".into(), true.into());
        }
        if let Ok(Value::Object(mut keys)) = serde_json::to_value(&case.file) {
            keys.retain(|key, _| !IDLE.contains(&key.as_str()));
            flatten("", Value::Object(keys), &mut inputs);
        }
        for (index, vehicle) in request.traffic.file.vehicle.iter().enumerate() {
            let mut keys = serde_json::to_value(vehicle).unwrap_or_default();
            if let Some(keys) = keys.as_object_mut() {
                keys.remove("name");
            }
            flatten(&format!("vehicle[{index}]"), keys, &mut inputs);
        }
        // That of the case has none in a file.
        if let [speeds] = request.traffic.speeds() {
            inputs.insert("--speed".into(), speeds.mean().into());
        }
        inputs.retain(|key, _| !key.starts_with("map.speed"));
        Self(inputs)
    }

    /// The first input in which another run differs, with its value here and there.
    pub(super) fn difference(&self, other: &Self) -> Option<[String; 3]> {
        let keys = self.0.keys().chain(other.0.keys());
        let mut values = keys.map(|key| (key, self.0.get(key), other.0.get(key)));
        let (key, own, others) = values.find(|(_, own, others)| own != others)?;
        let text = |value: Option<&Value>| match value {
            None => "not given".to_owned(),
            Some(Value::String(text)) => text.clone(),
            Some(value) => value.to_string(),
        };
        Some([key.clone(), text(own), text(others)])
    }
}

/// Leaves of a tree of keys, `wheel.mass`.
fn flatten(prefix: &str, value: Value, leaves: &mut Map<String, Value>) {
    match value {
        Value::Object(keys) => {
            for (key, value) in keys {
                let name = match prefix {
                    "" => key,
                    prefix => format!("{prefix}.{key}"),
                };
                flatten(&name, value, leaves);
            }
        }
        leaf => {
            leaves.insert(prefix.to_owned(), leaf);
        }
    }
}
