//! The arrays of a study in zarr, version 3.

use std::sync::Arc;

use riffel::Complex64;
use serde_json::{Map, Value, json};
use zarrs::array::codec::Crc32cCodec;
use zarrs::array::{Array, ArrayBuilder, ArrayError, CodecOptions, FillValue, data_type};
use zarrs::storage::store::MemoryStore;
use zarrs::storage::{Bytes, ReadableStorageTraits, WritableStorageTraits};

use crate::StudyError;
use crate::outputs::Dimension;
use crate::parameter::ParameterValue;
use crate::study::{Chunk, Study};

/// The name of the array that says why a sample failed.
pub(crate) const FAILURE: &str = "failure";

/// What an array holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Content {
    /// The parameter of a number.
    Parameter(usize),
    /// Numbers of an output from one place of a sample to another.
    Output {
        from: usize,
        to: usize,
        complex: bool,
    },
    /// Why the sample failed.
    Failure,
}

/// Values of an array.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Values {
    /// Numbers, complex ones as pairs.
    Numbers(Vec<f64>),
    /// Texts.
    Texts(Vec<String>),
}

/// The arrays over the samples of a study. They write to memory; the folder takes the bytes from there.
pub(super) struct Arrays {
    arrays: Vec<(Content, Array<MemoryStore>)>,
    store: Arc<MemoryStore>,
    samples_per_chunk: usize,
}

impl Arrays {
    pub(super) fn new(study: &Study) -> Result<Self, StudyError> {
        let store = Arc::new(MemoryStore::new());
        let outputs = study.outputs();
        let mut arrays = Vec::new();
        let mut add =
            |name: &str, content, dimensions: &[Dimension], text: bool, attributes: Value| {
                let mut shape = vec![study.samples()];
                let mut chunk = vec![study.samples_per_chunk()];
                let mut names = vec!["sample"];
                for &dimension in dimensions {
                    shape.push(outputs.size(dimension) as u64);
                    chunk.push(outputs.size(dimension) as u64);
                    names.push(dimension.name());
                }
                let complex = matches!(content, Content::Output { complex: true, .. });
                let mut builder = match (text, complex) {
                    (true, _) => {
                        ArrayBuilder::new(shape, chunk, data_type::string(), FillValue::from(""))
                    }
                    (_, true) => {
                        let missing = Complex64::new(f64::NAN, f64::NAN);
                        ArrayBuilder::new(
                            shape,
                            chunk,
                            data_type::complex128(),
                            FillValue::from(missing),
                        )
                    }
                    _ => ArrayBuilder::new(
                        shape,
                        chunk,
                        data_type::float64(),
                        FillValue::from(f64::NAN),
                    ),
                };
                builder
                    .bytes_to_bytes_codecs(vec![Arc::new(Crc32cCodec::new())])
                    .dimension_names(Some(names))
                    .attributes(attributes.as_object().cloned().unwrap_or_default());
                let array = builder
                    .build(store.clone(), &format!("/{name}"))
                    .map_err(|error| wrong(name, error))?;
                arrays.push((content, array));
                Ok::<(), StudyError>(())
            };
        for (index, parameter) in study.parameters().iter().enumerate() {
            let key = parameter.key;
            let mut attributes = json!({ "long_name": key.description });
            if let Some(kind) = key.quantity {
                attributes["units"] = json!(if kind.unit.is_empty() { "1" } else { kind.unit });
            }
            add(
                &key.key,
                Content::Parameter(index),
                &[],
                !parameter.is_number(),
                attributes,
            )?;
        }
        let mut from = 0;
        for variable in outputs.variables() {
            let to = from + outputs.length(variable);
            let complex = variable.complex;
            add(
                &variable.name,
                Content::Output { from, to, complex },
                &variable.dimensions,
                false,
                json!({ "units": variable.unit, "long_name": variable.description }),
            )?;
            from = to;
        }
        let words = json!({ "long_name": "why the sample has no results, empty where it has or is not computed yet" });
        add(FAILURE, Content::Failure, &[], true, words)?;
        Ok(Self {
            arrays,
            store,
            // At most a million.
            samples_per_chunk: study.samples_per_chunk() as usize,
        })
    }

    /// All files but those of the chunks: metadata, and the coordinates of the dimensions.
    pub(super) fn beginning(&self, study: &Study) -> Result<Vec<(String, Vec<u8>)>, StudyError> {
        let outputs = study.outputs();
        let mut files = Vec::new();
        let mut metadata = Map::new();
        let mut describe = |name: &str, array: &Array<MemoryStore>| {
            let document =
                serde_json::to_value(array.metadata()).map_err(|error| wrong(name, error))?;
            files.push((format!("{name}/zarr.json"), pretty(&document)));
            metadata.insert(name.to_owned(), document);
            Ok::<(), StudyError>(())
        };
        for (_, array) in &self.arrays {
            describe(name_of(array), array)?;
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
            let length = vec![values.len() as u64];
            let mut builder = ArrayBuilder::new(
                length.clone(),
                length,
                data_type::float64(),
                FillValue::from(f64::NAN),
            );
            let attributes = json!({ "units": unit, "long_name": words });
            builder
                .bytes_to_bytes_codecs(vec![Arc::new(Crc32cCodec::new())])
                .dimension_names(Some([dimension]))
                .attributes(attributes.as_object().cloned().unwrap_or_default());
            let array = builder
                .build(self.store.clone(), &format!("/{name}"))
                .map_err(|error| wrong(name, error))?;
            describe(name, &array)?;
            chunks.push((format!("{name}/c/0"), self.encoded(&array, &[0], values)?));
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
        Ok(files)
    }

    /// The files of a chunk, below the folder of the arrays.
    pub(super) fn files_of(&self, chunk: u64) -> impl Iterator<Item = String> {
        self.arrays.iter().map(move |(_, array)| file(array, chunk))
    }

    /// The file of an array and a chunk.
    pub(super) fn file_of(&self, name: &str, chunk: u64) -> Result<String, StudyError> {
        Ok(file(&self.find(name)?.1, chunk))
    }

    fn find(&self, name: &str) -> Result<&(Content, Array<MemoryStore>), StudyError> {
        self.arrays
            .iter()
            .find(|(_, array)| name_of(array) == name)
            .ok_or_else(|| StudyError::Array {
                name: name.to_owned(),
                reason: "the study has no such array".to_owned(),
            })
    }

    /// The bytes of all files of a chunk. Chunks of a zarr array are equally long: the last is filled up.
    pub(super) fn encode(&self, chunk: &Chunk) -> Result<Vec<(String, Vec<u8>)>, StudyError> {
        let missing = self.samples_per_chunk - chunk.samples.len();
        self.arrays
            .iter()
            .map(|(content, array)| {
                let place: Vec<u64> = (0..array.shape().len())
                    .map(|axis| if axis == 0 { chunk.index } else { 0 })
                    .collect();
                let bytes = match *content {
                    Content::Parameter(index) => {
                        let values = chunk.samples.iter().map(|sample| &sample.parameters[index]);
                        let numbers: Option<Vec<f64>> =
                            values.clone().map(ParameterValue::number).collect();
                        match numbers {
                            Some(mut numbers) => {
                                numbers.resize(self.samples_per_chunk, f64::NAN);
                                self.encoded(array, &place, numbers)
                            }
                            None => {
                                let mut texts: Vec<String> =
                                    values.map(ToString::to_string).collect();
                                texts.resize(self.samples_per_chunk, String::new());
                                self.encoded(array, &place, texts)
                            }
                        }
                    }
                    Content::Output { from, to, complex } => {
                        let width = to - from;
                        let mut numbers = Vec::with_capacity(width * self.samples_per_chunk);
                        for sample in &chunk.samples {
                            match &sample.outputs {
                                Ok(values) => numbers.extend_from_slice(&values[from..to]),
                                Err(_) => numbers.extend(std::iter::repeat_n(f64::NAN, width)),
                            }
                        }
                        numbers.extend(std::iter::repeat_n(f64::NAN, width * missing));
                        if complex {
                            let pairs = numbers
                                .chunks_exact(2)
                                .map(|pair| Complex64::new(pair[0], pair[1]));
                            self.encoded(array, &place, pairs.collect::<Vec<_>>())
                        } else {
                            self.encoded(array, &place, numbers)
                        }
                    }
                    Content::Failure => {
                        let sentence = |sample: &crate::study::Sample| match &sample.outputs {
                            Ok(_) => String::new(),
                            Err(sentence) => sentence.clone(),
                        };
                        let mut texts: Vec<String> = chunk.samples.iter().map(sentence).collect();
                        texts.resize(self.samples_per_chunk, String::new());
                        self.encoded(array, &place, texts)
                    }
                };
                Ok((file(array, chunk.index), bytes?))
            })
            .collect()
    }

    /// Values of a chunk by its bytes; `samples` of them are real.
    pub(super) fn decode(
        &self,
        name: &str,
        chunk: u64,
        bytes: Vec<u8>,
        samples: u64,
    ) -> Result<Values, StudyError> {
        let (content, array) = self.find(name)?;
        let place: Vec<u64> = (0..array.shape().len())
            .map(|axis| if axis == 0 { chunk } else { 0 })
            .collect();
        let key = array.chunk_key(&place);
        self.store
            .set(&key, Bytes::from(bytes))
            .map_err(|error| wrong(name, error))?;
        let width: u64 = array.shape().iter().skip(1).product();
        let length = (samples * width) as usize;
        let is_text = *array.data_type() == data_type::string();
        let read = || -> Result<Values, ArrayError> {
            Ok(match content {
                _ if is_text => {
                    let mut texts: Vec<String> = array.retrieve_chunk(&place)?;
                    texts.truncate(length);
                    Values::Texts(texts)
                }
                Content::Output { complex: true, .. } => {
                    let mut numbers: Vec<Complex64> = array.retrieve_chunk(&place)?;
                    numbers.truncate(length);
                    Values::Numbers(
                        numbers
                            .into_iter()
                            .flat_map(|value| [value.re, value.im])
                            .collect(),
                    )
                }
                _ => {
                    let mut numbers: Vec<f64> = array.retrieve_chunk(&place)?;
                    numbers.truncate(length);
                    Values::Numbers(numbers)
                }
            })
        };
        let values = read().map_err(|error| wrong(name, error));
        self.store.erase(&key).map_err(|error| wrong(name, error))?;
        values
    }

    fn encoded<T: zarrs::array::Element>(
        &self,
        array: &Array<MemoryStore>,
        place: &[u64],
        values: Vec<T>,
    ) -> Result<Vec<u8>, StudyError> {
        let name = name_of(array);
        // A chunk in which every sample failed is a file as well: the record tells all files.
        let options = CodecOptions::default().with_store_empty_chunks(true);
        array
            .store_chunk_opt(place, &values, &options)
            .map_err(|error| wrong(name, error))?;
        let key = array.chunk_key(place);
        let bytes = self.store.get(&key).map_err(|error| wrong(name, error))?;
        self.store.erase(&key).map_err(|error| wrong(name, error))?;
        bytes
            .map(|bytes| bytes.to_vec())
            .ok_or_else(|| wrong(name, "nothing was stored"))
    }
}

fn name_of(array: &Array<MemoryStore>) -> &str {
    array.path().as_str().trim_start_matches('/')
}

fn file(array: &Array<MemoryStore>, chunk: u64) -> String {
    let zeros = "/0".repeat(array.shape().len() - 1);
    format!("{}/c/{chunk}{zeros}", name_of(array))
}

fn wrong(name: &str, error: impl std::fmt::Display) -> StudyError {
    StudyError::Array {
        name: name.to_owned(),
        reason: error.to_string(),
    }
}

fn pretty(document: &Value) -> Vec<u8> {
    // A document made of values is always written.
    let mut text = serde_json::to_vec_pretty(document).unwrap_or_default();
    text.push(b'\n');
    text
}
