//! The arrays of a study: what each holds, and from where in a sample.

use riffel_arrays::{Array, DataType, Values, json};
use serde_json::json;

use crate::StudyError;
use crate::outputs::Dimension;
use crate::parameter::ParameterValue;
use crate::study::{Chunk, Sample, Study};

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
        arrays.push((Content::Failure, array(FAILURE, DataType::String, &[], words)));
        Self { arrays }
    }

    /// All files but those of the chunks: metadata, and the coordinates of the dimensions.
    pub(super) fn beginning(&self, study: &Study) -> Vec<(String, Vec<u8>)> {
        let outputs = study.outputs();
        let parameters = study.parameters().iter();
        let mut coordinates: Vec<&str> = parameters.map(|it| it.key.key.as_str()).collect();
        let mut axes = Vec::new();
        for dimension in outputs.dimensions() {
            let (name, unit, words, values) = match dimension {
                Dimension::Speed => ("speed", "m/s", "speed of the vehicle", outputs.speeds()),
                Dimension::Wavelength => {
                    let words = "wavelength of the corrugation";
                    ("wavelength", "m", words, outputs.wavelengths())
                }
                Dimension::Band => {
                    let bands = outputs.bands().iter().map(|band| [band.from, band.to]);
                    axes.extend(riffel_arrays::band_axes(&bands.collect::<Vec<_>>()));
                    coordinates.extend(["band_from", "band_to"]);
                    continue;
                }
            };
            let array = Array::axis(name, name, values.len() as u64, unit, words);
            axes.push((array, Values::Numbers(values.to_vec())));
        }
        let own = self.arrays.iter().map(|(_, array)| array);
        let all = || own.clone().chain(axes.iter().map(|(array, _)| array));
        let described = |array: &Array| (format!("{}/zarr.json", array.name), json(&array.metadata()));
        let mut files: Vec<_> = all().map(described).collect();
        files.extend(axes.iter().map(|(array, values)| (array.file(0), array.encode(values))));
        let attributes = json!({
            "title": study.plan.file.title.as_deref().unwrap_or("Study"),
            "source": concat!("riffel ", env!("CARGO_PKG_VERSION")),
            "Conventions": "CF-1.8",
            "coordinates": coordinates.join(" "),
            "design": study.plan.file.design.method.name(),
            "fingerprint": study.fingerprint,
        });
        let group = riffel_arrays::group(attributes, all());
        files.push(("zarr.json".to_owned(), json(&group)));
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
            .ok_or_else(|| StudyError::Array { name: name.to_owned(), reason: "the study has no such array" })
    }

    /// The bytes of all files of a chunk.
    pub(super) fn encode<'a>(&'a self, chunk: &'a Chunk) -> impl Iterator<Item = (String, Vec<u8>)> + 'a {
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
