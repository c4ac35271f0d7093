//! The arrays of a study: what each holds, and from where in a sample.

use serde_json::{Map, Value, json};

use crate::StudyError;
use crate::outputs::Dimension;
use crate::parameter::ParameterValue;
use crate::study::{Chunk, Sample, Study};
use crate::zarr::{Array, DataType, Values};

/// The name of the array that says why a sample failed.
pub(crate) const FAILURE: &str = "failure";

/// What an array holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Content {
    /// The parameter of a number.
    Parameter(usize),
    /// Numbers of an output from one place of a sample to another.
    Output { from: usize, to: usize },
    /// Why the sample failed.
    Failure,
}

/// The arrays over the samples of a study.
pub(super) struct Arrays {
    arrays: Vec<(Content, Array)>,
}

impl Arrays {
    pub(super) fn new(study: &Study) -> Self {
        let outputs = study.outputs();
        let array = |name: &str, data_type, dimensions: &[Dimension], attributes| {
            let sizes = dimensions.iter().map(|&axis| outputs.size(axis) as u64);
            let names = dimensions.iter().map(|axis| axis.name());
            Array {
                name: name.to_owned(),
                data_type,
                shape: std::iter::once(study.samples()).chain(sizes).collect(),
                rows_per_chunk: study.samples_per_chunk(),
                dimensions: std::iter::once("sample").chain(names).collect(),
                attributes,
            }
        };
        let mut arrays = Vec::new();
        for (index, parameter) in study.parameters().iter().enumerate() {
            let key = parameter.key;
            let mut attributes = json!({ "long_name": key.description });
            if let Some(kind) = key.quantity {
                attributes["units"] = json!(if kind.unit.is_empty() { "1" } else { kind.unit });
            }
            let data_type = match parameter.is_number() {
                true => DataType::Float64,
                false => DataType::String,
            };
            let array = array(&key.key, data_type, &[], attributes);
            arrays.push((Content::Parameter(index), array));
        }
        let mut from = 0;
        for variable in outputs.variables() {
            let to = from + outputs.length(variable);
            let data_type = match variable.complex {
                true => DataType::Complex128,
                false => DataType::Float64,
            };
            let attributes = json!({ "units": variable.unit, "long_name": variable.description });
            let array = array(&variable.name, data_type, &variable.dimensions, attributes);
            arrays.push((Content::Output { from, to }, array));
            from = to;
        }
        let words = json!({ "long_name": "why the sample has no results, empty where it has or is not computed yet" });
        arrays.push((
            Content::Failure,
            array(FAILURE, DataType::String, &[], words),
        ));
        Self { arrays }
    }

    /// All files but those of the chunks: metadata, and the coordinates of the dimensions.
    pub(super) fn beginning(&self, study: &Study) -> Vec<(String, Vec<u8>)> {
        let outputs = study.outputs();
        let mut files = Vec::new();
        let mut metadata = Map::new();
        let mut describe = |array: &Array| {
            let document = array.metadata();
            files.push((format!("{}/zarr.json", array.name), pretty(&document)));
            metadata.insert(array.name.clone(), document);
        };
        for (_, array) in &self.arrays {
            describe(array);
        }
        let mut coordinates: Vec<&str> = study
            .parameters()
            .iter()
            .map(|parameter| parameter.key.key.as_str())
            .collect();
        let mut axes: Vec<(&str, &str, Vec<f64>, &str, &str)> = Vec::new();
        for dimension in outputs.dimensions() {
            let bands = |value: &dyn Fn(f64, f64) -> f64| {
                outputs
                    .bands()
                    .iter()
                    .map(|band| value(band.from, band.to))
                    .collect()
            };
            match dimension {
                Dimension::Speed => axes.push((
                    "speed",
                    "speed",
                    outputs.speeds().to_vec(),
                    "m/s",
                    "speed of the vehicle",
                )),
                Dimension::Wavelength => axes.push((
                    "wavelength",
                    "wavelength",
                    outputs.wavelengths().to_vec(),
                    "m",
                    "wavelength of the corrugation",
                )),
                Dimension::Band => {
                    let centre = bands(&|from, to| (from * to).sqrt());
                    axes.push((
                        "band",
                        "band",
                        centre,
                        "m",
                        "centre of the band in the logarithm of wavelength",
                    ));
                    axes.push((
                        "band_from",
                        "band",
                        bands(&|from, _| from),
                        "m",
                        "shortest wavelength of the band",
                    ));
                    axes.push((
                        "band_to",
                        "band",
                        bands(&|_, to| to),
                        "m",
                        "longest wavelength of the band",
                    ));
                    coordinates.extend(["band_from", "band_to"]);
                }
            }
        }
        let mut chunks = Vec::new();
        for (name, dimension, values, unit, words) in axes {
            let length = values.len() as u64;
            let array = Array {
                name: name.to_owned(),
                data_type: DataType::Float64,
                shape: vec![length],
                rows_per_chunk: length,
                dimensions: vec![dimension],
                attributes: json!({ "units": unit, "long_name": words }),
            };
            describe(&array);
            chunks.push((array.file(0), array.encode(&Values::Numbers(values))));
        }
        files.extend(chunks);
        let group = json!({
            "zarr_format": 3,
            "node_type": "group",
            "attributes": {
                "title": study.plan.file.title.as_deref().unwrap_or("Study"),
                "source": concat!("riffel ", env!("CARGO_PKG_VERSION")),
                "Conventions": "CF-1.8",
                "coordinates": coordinates.join(" "),
                "design": study.plan.file.design.method.name(),
                "fingerprint": study.fingerprint,
            },
            // One file to open instead of one for each array.
            "consolidated_metadata": {
                "kind": "inline",
                "must_understand": false,
                "metadata": metadata,
            },
        });
        files.push(("zarr.json".to_owned(), pretty(&group)));
        files
    }

    /// The files of a chunk, below the folder of the arrays.
    pub(super) fn files_of(&self, chunk: u64) -> impl Iterator<Item = String> {
        self.arrays.iter().map(move |(_, array)| array.file(chunk))
    }

    /// An array by its name.
    pub(super) fn find(&self, name: &str) -> Result<&Array, StudyError> {
        let mut arrays = self.arrays.iter().map(|(_, array)| array);
        arrays
            .find(|array| array.name == name)
            .ok_or_else(|| StudyError::Array {
                name: name.to_owned(),
                reason: "the study has no such array",
            })
    }

    /// The bytes of all files of a chunk.
    pub(super) fn encode<'a>(
        &'a self,
        chunk: &'a Chunk,
    ) -> impl Iterator<Item = (String, Vec<u8>)> + 'a {
        self.arrays.iter().map(|(content, array)| {
            let values = content.values(array.data_type, &chunk.samples);
            (array.file(chunk.index), array.encode(&values))
        })
    }
}

impl Content {
    /// What samples have of it.
    fn values(self, data_type: DataType, samples: &[Sample]) -> Values {
        match self {
            Self::Parameter(index) => {
                let values = samples.iter().map(|sample| &sample.parameters[index]);
                match data_type {
                    DataType::String => Values::Texts(values.map(ToString::to_string).collect()),
                    _ => {
                        let number = |value: &ParameterValue| value.number().unwrap_or(f64::NAN);
                        Values::Numbers(values.map(number).collect())
                    }
                }
            }
            Self::Output { from, to } => {
                let mut numbers = Vec::with_capacity((to - from) * samples.len());
                for sample in samples {
                    match &sample.outputs {
                        Ok(values) => numbers.extend_from_slice(&values[from..to]),
                        Err(_) => numbers.extend(std::iter::repeat_n(f64::NAN, to - from)),
                    }
                }
                Values::Numbers(numbers)
            }
            Self::Failure => {
                let sentence = |sample: &Sample| sample.outputs.clone().err().unwrap_or_default();
                Values::Texts(samples.iter().map(sentence).collect())
            }
        }
    }
}

fn pretty(document: &Value) -> Vec<u8> {
    // A document made of values is always written.
    let mut text = serde_json::to_vec_pretty(document).unwrap_or_default();
    text.push(b'\n');
    text
}
