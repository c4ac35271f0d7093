//! The files of a calibration.

use std::path::{Path, PathBuf};

use jiff::Timestamp;
use riffel_arrays::{Array, DataType, Values, group, json, whole_file};
use serde_json::{Value, json};

use crate::draw::Draw;
use crate::error::CalibrationError;
use crate::file::SamplerKind;
use crate::given::columns;
use crate::plan::Plan;
use crate::predicted::replicas;
use crate::run::{Chains, Folder};
use crate::summary::Summary;

/// Draws of the prior that are written.
const OF_PRIOR: u64 = 1000;

/// An array of a group with its numbers.
struct Written {
    group: &'static str,
    array: Array,
    values: Vec<f64>,
}

impl Folder<'_> {
    /// Write `plan.toml`, the text of the plan with its files as they are seen from here.
    ///
    /// # Errors
    /// [`CalibrationError::Write`].
    pub fn write_plan(&self, plan: &Plan) -> Result<(), CalibrationError> {
        let path = self.path().join("plan.toml");
        let text = plan.text_in(self.path());
        whole_file::write(&path, text.as_bytes()).map_err(CalibrationError::write(&path))
    }

    /// Write `summary.csv` and `posterior.zarr`; their names.
    ///
    /// # Errors
    /// [`CalibrationError::Write`].
    pub fn write(
        &self,
        plan: &Plan,
        chains: &Chains,
        summary: &Summary,
    ) -> Result<Vec<&'static str>, CalibrationError> {
        write_groups(&self.path().join("posterior.zarr"), plan, chains)?;
        let path = self.path().join("summary.csv");
        let csv = summary.csv();
        whole_file::write(&path, csv.as_bytes()).map_err(CalibrationError::write(&path))?;
        Ok(vec!["summary.csv", "posterior.zarr"])
    }
}

/// A variable over chains and draws.
fn over_draws(
    group: &'static str,
    name: &str,
    unit: &str,
    chains: &Chains,
    value: impl Fn(&Draw) -> f64,
) -> Written {
    let draws = chains.draws.first().map_or(0, Vec::len) as u64;
    let attributes = if unit.is_empty() {
        json!({})
    } else {
        json!({ "units": unit })
    };
    Written {
        group,
        array: Array {
            name: format!("{group}/{name}"),
            data_type: DataType::Float64,
            shape: vec![chains.draws.len() as u64, draws],
            rows_per_chunk: chains.draws.len() as u64,
            dimensions: vec!["chain", "draw"],
            attributes,
        },
        values: chains.draws.iter().flatten().map(value).collect(),
    }
}

fn axes(group: &'static str, chains: u64, draws: u64) -> [Written; 2] {
    let axis = |name: &'static str, length: u64| Written {
        group,
        array: Array {
            name: format!("{group}/{name}"),
            attributes: json!({}),
            data_type: DataType::Int64,
            ..Array::axis(name, name, length, "", "")
        },
        values: (0..length).map(|index| index as f64).collect(),
    };
    [axis("chain", chains), axis("draw", draws)]
}

fn all(plan: &Plan, chains: &Chains) -> Result<Vec<Written>, CalibrationError> {
    let parameters = plan.posterior.parameters();
    let mut written = Vec::new();
    let (count, draws) = (chains.draws.len() as u64, chains.draws[0].len() as u64);
    for (index, parameter) in parameters.iter().enumerate() {
        let value = |draw: &Draw| parameter.prior.value(draw.place[index]);
        written.push(over_draws(
            "posterior",
            &parameter.name,
            &parameter.unit,
            chains,
            value,
        ));
    }
    written.extend(axes("posterior", count, draws));
    type Of = fn(&Draw) -> f64;
    let statistics: [(&str, DataType, Of); 7] = [
        ("lp", DataType::Float64, |draw| draw.log_density),
        ("diverging", DataType::Bool, |draw| {
            f64::from(u8::from(draw.statistics.diverging))
        }),
        ("energy", DataType::Float64, |draw| draw.statistics.energy),
        ("tree_depth", DataType::Int64, |draw| {
            f64::from(draw.statistics.depth)
        }),
        ("n_steps", DataType::Int64, |draw| {
            f64::from(draw.statistics.steps)
        }),
        ("step_size", DataType::Float64, |draw| draw.step),
        ("acceptance_rate", DataType::Float64, |draw| {
            draw.statistics.acceptance
        }),
    ];
    // What only trajectories have.
    let has_all = plan.file.sampler.kind == SamplerKind::Nuts;
    let of_trajectories = ["energy", "tree_depth", "step_size"];
    for (name, data_type, value) in statistics {
        if !has_all && of_trajectories.contains(&name) {
            continue;
        }
        let mut of_draws = over_draws("sample_stats", name, "", chains, value);
        of_draws.array.data_type = data_type;
        written.push(of_draws);
    }
    written.extend(axes("sample_stats", count, draws));
    for (index, parameter) in parameters.iter().enumerate() {
        // A grid of each prior in its own order: what quasi-random points have, one dimension at a time.
        let root = (1..=60).fold(2.0f64, |root, _| {
            (1.0 + root).powf(1.0 / (parameters.len() as f64 + 1.0))
        });
        let share = |draw: u64| {
            let turn = (draw as f64 + 0.5) * root.powi(-(index as i32 + 1));
            turn.fract().clamp(1e-9, 1.0 - 1e-9)
        };
        written.push(Written {
            group: "prior",
            array: Array {
                name: format!("prior/{}", parameter.name),
                data_type: DataType::Float64,
                shape: vec![1, OF_PRIOR],
                rows_per_chunk: 1,
                dimensions: vec!["chain", "draw"],
                attributes: json!({ "units": parameter.unit }),
            },
            values: (0..OF_PRIOR)
                .map(|draw| parameter.prior.quantile(share(draw)))
                .collect(),
        });
    }
    written.extend(axes("prior", 1, OF_PRIOR));
    for (group, written_of) in predictive(plan, chains) {
        written.extend(written_of);
        written.extend(axes(group, count, draws));
    }
    written.extend(data(plan));
    let given = columns(plan, "constant_data")?.into_iter();
    written.extend(given.map(|(array, values)| Written {
        group: "constant_data",
        array,
        values,
    }));
    Ok(written)
}

/// ln likelihood of each datum given all others of its data, and data as they might have been measured, by draw.
fn predictive(plan: &Plan, chains: &Chains) -> [(&'static str, Vec<Written>); 2] {
    let posterior = &plan.posterior;
    let all: Vec<&Draw> = chains.draws.iter().flatten().collect();
    let drawn = replicas(plan, &all);
    let (count, draws) = (chains.draws.len() as u64, chains.draws[0].len() as u64);
    [("log_likelihood", 0), ("posterior_predictive", 1)].map(|(group, part)| {
        let blocks = posterior
            .blocks
            .iter()
            .zip(DIMENSIONS.iter().cycle())
            .enumerate();
        let written = blocks.map(|(block, (named, dimension))| {
            let values: Vec<f64> = drawn
                .iter()
                .flat_map(|blocks| blocks[block][part].clone())
                .collect();
            Written {
                group,
                array: Array {
                    name: format!("{group}/{}", named.names.join("+")),
                    data_type: DataType::Float64,
                    shape: vec![count, draws, values.len() as u64 / (count * draws)],
                    rows_per_chunk: count,
                    dimensions: vec!["chain", "draw", dimension],
                    attributes: json!({}),
                },
                values,
            }
        });
        (group, written.collect())
    })
}

/// What was measured, in the form in which it is compared.
fn data(plan: &Plan) -> Vec<Written> {
    let blocks = plan.posterior.blocks.iter().zip(plan.posterior.observed());
    let observed = blocks
        .zip(DIMENSIONS.iter().cycle())
        .map(|((named, values), dimension)| {
            let name = named.names.join("+");
            Written {
                group: "observed_data",
                array: Array {
                    name: format!("observed_data/{name}"),
                    ..Array::axis("", dimension, values.len() as u64, "", "")
                },
                values,
            }
        });
    observed.collect()
}

/// Names of the dimensions of the blocks of data.
const DIMENSIONS: [&str; 6] = [
    "datum", "datum_2", "datum_3", "datum_4", "datum_5", "datum_6",
];

/// Attributes of the whole tree: ln of the evidence by each run besides, where it is told.
fn with_evidence(mut attributes: Value, chains: &Chains) -> Value {
    if let (Some(attributes), [_, ..]) = (attributes.as_object_mut(), &chains.log_evidences[..]) {
        attributes.insert("log_evidence".to_owned(), json!(chains.log_evidences));
    }
    attributes
}

fn write_groups(path: &Path, plan: &Plan, chains: &Chains) -> Result<(), CalibrationError> {
    let written = all(plan, chains)?;
    let write = |name: PathBuf, bytes: &[u8]| {
        whole_file::write(&name, bytes).map_err(CalibrationError::write(&name))
    };
    if path.exists() {
        std::fs::remove_dir_all(path).map_err(CalibrationError::write(path))?;
    }
    // The one that the same seed does not give again.
    let attributes = json!({
        "created_at": Timestamp::now().to_string(),
        "inference_library": "riffel",
        "inference_library_version": env!("CARGO_PKG_VERSION"),
    });
    let empty = || json!({ "zarr_format": 3, "node_type": "group", "attributes": attributes });
    let mut root = group(
        with_evidence(attributes.clone(), chains),
        written.iter().map(|it| &it.array),
    );
    let mut groups: Vec<&str> = written.iter().map(|it| it.group).collect();
    groups.dedup();
    if let Some(metadata) = root
        .pointer_mut("/consolidated_metadata/metadata")
        .and_then(Value::as_object_mut)
    {
        groups
            .iter()
            .for_each(|name| drop(metadata.insert((*name).to_owned(), empty())));
    }
    for it in &written {
        let array = &it.array;
        write(
            path.join(&array.name).join("zarr.json"),
            &json(&array.metadata()),
        )?;
        write(
            path.join(array.file(0)),
            &array.encode(&Values::Numbers(it.values.clone())),
        )?;
    }
    for name in groups {
        let own: Vec<Array> = written
            .iter()
            .filter(|it| it.group == name)
            .map(|it| Array {
                name: it.array.name[name.len() + 1..].to_owned(),
                ..it.array.clone()
            })
            .collect();
        write(
            path.join(name).join("zarr.json"),
            &json(&group(attributes.clone(), &own)),
        )?;
    }
    write(path.join("zarr.json"), &json(&root))
}
