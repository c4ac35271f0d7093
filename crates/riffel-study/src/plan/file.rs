//! The keys of a plan, as written.

use riffel_keys::quantity::{Quantity, Ratio};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use toml::Value;

pub use crate::outputs::file::*;

/// Riffel study: which keys of a case vary and how, and what is wanted of each sample.
///
/// Every quantity is a bare number in SI or a string with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Riffel study")]
pub struct PlanFile {
    /// What the study is, for titles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// The case file, relative to the plan.
    pub case: String,
    /// Keys of the case that are different for the whole study, as tables of the case file.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(schema_with = "any_table")]
    pub set: toml::Table,
    /// How samples are chosen.
    pub design: DesignFile,
    /// The keys that vary.
    pub parameter: Vec<ParameterFile>,
    /// Parameters that vary together.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub correlation: Vec<CorrelationFile>,
    /// What is computed for each sample.
    pub outputs: OutputsFile,
    /// How results are kept.
    #[serde(default)]
    pub results: ResultsFile,
}

/// How samples are chosen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignFile {
    /// The method.
    pub method: Method,
    /// Number of samples, or of base samples for `saltelli`; not for `grid`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub samples: Option<u64>,
    /// Number that random choices follow from; left out, 0.
    #[serde(default)]
    pub seed: u64,
}

/// A design of experiments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Every combination of the values.
    Grid,
    /// Independent samples.
    Random,
    /// One sample in each of as many strata as there are samples, for each parameter.
    LatinHypercube,
    /// A scrambled Sobol sequence; best with a power of two.
    Sobol,
    /// Saltelli's cross sample for Sobol indices: `samples` times the number of parameters and two more.
    Saltelli,
}

impl Method {
    /// The name in a plan.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Random => "random",
            Self::LatinHypercube => "latin-hypercube",
            Self::Sobol => "sobol",
            Self::Saltelli => "saltelli",
        }
    }
}

/// A key that varies. Give just one of the others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterFile {
    /// The key of the case.
    pub key: String,
    /// Its values one by one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_values")]
    pub values: Option<Vec<Value>>,
    /// Values in equal steps, both ends included.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<RangeFile>,
    /// Uniform distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uniform: Option<UniformFile>,
    /// Normal distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<NormalFile>,
    /// Lognormal distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lognormal: Option<LognormalFile>,
    /// Triangular distribution.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub triangular: Option<TriangularFile>,
}

/// Values in equal steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RangeFile {
    /// The first.
    #[schemars(schema_with = "any_value")]
    pub min: Value,
    /// The last.
    #[schemars(schema_with = "any_value")]
    pub max: Value,
    /// How many.
    #[schemars(range(min = 2, max = 1_000_000))]
    pub points: u64,
    /// Steps of the value or of its logarithm.
    #[serde(default)]
    pub spacing: Spacing,
}

/// What is equal from one value of a range to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Spacing {
    /// The difference.
    #[default]
    Linear,
    /// The ratio.
    Log,
}

/// Every value between two is as likely.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UniformFile {
    /// Lower end.
    #[schemars(schema_with = "any_value")]
    pub min: Value,
    /// Upper end.
    #[schemars(schema_with = "any_value")]
    pub max: Value,
}

/// Normal distribution, cut off at its ends where they are given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NormalFile {
    /// Mean, before it is cut off.
    #[schemars(schema_with = "any_value")]
    pub mean: Value,
    /// Standard deviation, likewise.
    #[schemars(schema_with = "any_value")]
    pub standard_deviation: Value,
    /// Lower end; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub min: Option<Value>,
    /// Upper end; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub max: Option<Value>,
}

/// Lognormal distribution. Give `mean` and `standard_deviation` of the quantity itself, or `median` and
/// `factor`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LognormalFile {
    /// Mean of the quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub mean: Option<Value>,
    /// Standard deviation of the quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub standard_deviation: Option<Value>,
    /// Median of the quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub median: Option<Value>,
    /// Factor of uncertainty above 1: 68 % of all values lie between median / factor and median · factor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub factor: Option<Quantity<Ratio>>,
    /// Lower end; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub min: Option<Value>,
    /// Upper end; left out, none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "any_value")]
    pub max: Option<Value>,
}

/// Triangular distribution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TriangularFile {
    /// Lower end.
    #[schemars(schema_with = "any_value")]
    pub min: Value,
    /// Most likely value.
    #[schemars(schema_with = "any_value")]
    pub mode: Value,
    /// Upper end.
    #[schemars(schema_with = "any_value")]
    pub max: Value,
}

/// Two parameters that vary together, by a Gaussian copula.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CorrelationFile {
    /// The two keys.
    pub between: [String; 2],
    /// Correlation ρ of their normal scores, between -1 and 1: that of the parameters where both are normal; the
    /// rank correlation is 6/π asin(ρ/2).
    pub coefficient: f64,
}

/// How results are kept.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResultsFile {
    /// Samples of a chunk, which is finished or not as a whole; left out, a fiftieth of all, 10 to 1000; for
    /// samples that take minutes, 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 1_000_000))]
    pub samples_per_chunk: Option<u64>,
}

fn any_table(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "object" })
}

fn any_value(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": ["number", "string"] })
}

fn any_values(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": ["array"], "items": { "type": ["number", "string", "boolean"] } })
}
