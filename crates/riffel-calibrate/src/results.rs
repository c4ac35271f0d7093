//! The files of a calibration.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use jiff::Timestamp;
use riffel_arrays::{Array, DataType, Together, Values, group, json};
use serde_json::{Map, Value, json};

use crate::chains::Chains;
use crate::data_columns::columns;
use crate::draw::Draw;
use crate::error::CalibrationError;
use crate::file::SamplerKind;
use crate::folder::Folder;
use crate::names::{GROUPS, SUMMARY, TREE};
use crate::plan::Plan;
use crate::predicted::replicas;
use crate::record::Record;
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
        self.put("plan.toml", plan.text_in(self.path()).as_bytes())
    }

    /// `summary.csv` and `posterior.zarr`, whole but not yet in their places.
    ///
    /// # Errors
    /// [`CalibrationError::Write`].
    pub fn results(&self, plan: &Plan, chains: &Chains, summary: &Summary) -> Result<Results, CalibrationError> {
        let written = all(plan, chains)?;
        let mut record = self.record.clone();
        record.arrays = written.iter().map(|it| it.array.name.clone()).collect();
        let staged = || {
            let files = Together::new_in(&self.path)?;
            write_groups(&files, self, chains, &written)?;
            files.write(SUMMARY, summary.csv().as_bytes())?;
            files.write(Record::NAME, &record.bytes())?;
            Ok(files)
        };
        let folder = self.path.clone();
        let files = staged().map_err(CalibrationError::write(&folder))?;
        Ok(Results { folder, files })
    }
}

/// Results that are whole but not yet in their places.
pub struct Results {
    folder: PathBuf,
    files: Together,
}

impl Results {
    /// Rename them to their places; their names. What else is there stays.
    ///
    /// # Errors
    /// [`CalibrationError::Write`].
    pub fn publish(self) -> Result<[&'static str; 2], CalibrationError> {
        let published = self.files.publish();
        published.map_err(CalibrationError::write(&self.folder))?;
        Ok([SUMMARY, TREE])
    }
}

/// A variable over chains and draws.
fn over_draws(group: &'static str, name: &str, unit: &str, chains: &Chains, value: impl Fn(&Draw) -> f64) -> Written {
    let draws = chains.draws.first().map_or(0, Vec::len) as u64;
    let attributes = if unit.is_empty() { json!({}) } else { json!({ "units": unit }) };
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
        written.push(over_draws("posterior", &parameter.name, &parameter.unit, chains, value));
    }
    written.extend(axes("posterior", count, draws));
    type Of = fn(&Draw) -> f64;
    let statistics: [(&str, DataType, Of); 7] = [
        ("lp", DataType::Float64, |draw| draw.log_density),
        ("diverging", DataType::Bool, |draw| f64::from(u8::from(draw.statistics.diverging))),
        ("energy", DataType::Float64, |draw| draw.statistics.energy),
        ("tree_depth", DataType::Int64, |draw| f64::from(draw.statistics.depth)),
        ("n_steps", DataType::Int64, |draw| f64::from(draw.statistics.steps)),
        ("step_size", DataType::Float64, |draw| draw.step),
        ("acceptance_rate", DataType::Float64, |draw| draw.statistics.acceptance),
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
        let root = (1..=60).fold(2.0f64, |root, _| (1.0 + root).powf(1.0 / (parameters.len() as f64 + 1.0)));
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
            values: (0..OF_PRIOR).map(|draw| parameter.prior.quantile(share(draw))).collect(),
        });
    }
    written.extend(axes("prior", 1, OF_PRIOR));
    for (group, written_of) in predictive(plan, chains) {
        written.extend(written_of);
        written.extend(axes(group, count, draws));
    }
    written.extend(data(plan));
    let given = columns(plan, "constant_data")?.into_iter();
    written.extend(given.map(|(array, values)| Written { group: "constant_data", array, values }));
    Ok(written)
}

/// ln likelihood of each datum given all others of its data, and data as they might have been measured, by draw.
fn predictive(plan: &Plan, chains: &Chains) -> [(&'static str, Vec<Written>); 2] {
    let posterior = &plan.posterior;
    let all: Vec<&Draw> = chains.draws.iter().flatten().collect();
    let drawn = replicas(plan, &all);
    let (count, draws) = (chains.draws.len() as u64, chains.draws[0].len() as u64);
    [("log_likelihood", 0), ("posterior_predictive", 1)].map(|(group, part)| {
        let blocks = posterior.blocks.iter().zip(DIMENSIONS.iter().cycle()).enumerate();
        let written = blocks.map(|(block, (named, dimension))| {
            let values: Vec<f64> = drawn.iter().flat_map(|blocks| blocks[block][part].clone()).collect();
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
    let observed = blocks.zip(DIMENSIONS.iter().cycle()).map(|((named, values), dimension)| {
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
const DIMENSIONS: [&str; 6] = ["datum", "datum_2", "datum_3", "datum_4", "datum_5", "datum_6"];

/// Attributes of the whole tree: ln of the evidence by each run besides, where it is told.
fn with_evidence(mut attributes: Value, chains: &Chains) -> Value {
    if let (Some(attributes), [_, ..]) = (attributes.as_object_mut(), &chains.log_evidences[..]) {
        attributes.insert("log_evidence".to_owned(), json!(chains.log_evidences));
    }
    attributes
}

/// What groups and arrays say of themselves that somebody has added to a tree, by their names in it. Links are not followed.
fn of_others(tree: &Path, within: &str, own: &[&str], found: &mut Map<String, Value>) {
    let entries = fs::read_dir(tree.join(within)).into_iter().flatten();
    let folders = entries.flatten().filter(|it| it.file_type().is_ok_and(|kind| kind.is_dir()));
    for folder in folders {
        let name = folder.file_name();
        let name = match within {
            "" => name.to_string_lossy().into_owned(),
            within => format!("{within}/{}", name.to_string_lossy()),
        };
        if own.contains(&&*name) {
            continue;
        }
        let document = fs::read(folder.path().join("zarr.json")).unwrap_or_default();
        let document = serde_json::from_slice::<Map<String, Value>>(&document);
        let is_array = |it: &Map<String, Value>| it.get("node_type") == Some(&json!("array"));
        if !document.as_ref().is_ok_and(is_array) {
            of_others(tree, &name, own, found);
        }
        if let Ok(mut document) = document
            && document.contains_key("node_type")
            && !GROUPS.contains(&&*name)
        {
            document.remove("consolidated_metadata");
            found.insert(name, Value::Object(document));
        }
    }
}

fn write_groups(files: &Together, folder: &Folder<'_>, chains: &Chains, written: &[Written]) -> io::Result<()> {
    // `created_at` is the one that the same seed does not give again.
    let attributes = json!({
        "created_at": Timestamp::now().to_string(),
        "inference_library": "riffel",
        "inference_library_version": env!("CARGO_PKG_VERSION"),
        "fingerprint": folder.record.fingerprint,
    });
    let empty = json!({ "zarr_format": 3, "node_type": "group", "attributes": attributes });
    let own = written.iter().map(|it| it.array.name.as_str());
    let mut others = Map::new();
    of_others(&folder.path().join(TREE), "", &own.collect::<Vec<_>>(), &mut others);
    // A document repeats those of what is below, and of what somebody has added there.
    let document = |name: &str, attributes: Value, groups: &[&str]| {
        let below = |it: &str| match name {
            "" => Some(it.to_owned()),
            name => it.strip_prefix(&format!("{name}/")).map(str::to_owned),
        };
        let arrays = written.iter().filter_map(|it| {
            let name = below(&it.array.name)?;
            Some(Array { name, ..it.array.clone() })
        });
        let mut document = group(attributes, &arrays.collect::<Vec<_>>());
        let metadata = document.pointer_mut("/consolidated_metadata/metadata");
        if let Some(metadata) = metadata.and_then(Value::as_object_mut) {
            metadata.extend(groups.iter().map(|it| ((*it).to_owned(), empty.clone())));
            metadata.extend(others.iter().filter_map(|(name, it)| Some((below(name)?, it.clone()))));
        }
        json(&document)
    };
    let mut groups: Vec<&str> = written.iter().map(|it| it.group).collect();
    groups.dedup();
    let write = |name: &str, bytes: &[u8]| files.write(&format!("{TREE}/{name}"), bytes);
    for it in written {
        let array = &it.array;
        write(&format!("{}/zarr.json", array.name), &json(&array.metadata()))?;
        let numbers = Values::Numbers(it.values.clone());
        write(&array.file(0), &array.encode(&numbers))?;
    }
    for name in &groups {
        write(&format!("{name}/zarr.json"), &document(name, attributes.clone(), &[]))?;
    }
    write("zarr.json", &document("", with_evidence(attributes, chains), &groups))
}
