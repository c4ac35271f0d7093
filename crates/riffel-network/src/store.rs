//! A folder with the surveys of a network.

use std::fs;
use std::path::{Path, PathBuf};

use riffel::roughness::WavelengthBand;
use riffel_arrays::{Array, DataType, Values, whole_file};
use riffel_keys::range;
use serde::Serialize;
use serde_json::json;

use crate::NetworkError;
use crate::error::Damage;
use crate::name::RECORD;
use crate::record::{FORMAT, NetworkRecord, RailRecord, SurveyRecord};

/// Cells of a chunk.
pub(crate) const ROWS: u64 = 8192;

/// How a store that is not there yet is made.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StoreSettings {
    /// Length of a cell of the grid \[m\]; that of the first block where it is left out.
    pub resolution: Option<f64>,
}

/// The surveys of a network, each one a group of zarr arrays (version 3) that xarray opens.
///
/// `network.json` says what the grid and the bands are, `surveys/LINE/DATE.json` that a survey is there, and its arrays are
/// in a folder beside it. That record is written last and at once: a process that is killed leaves a survey whole or not at
/// all, and what it left half is removed by the next that adds to the line. Nothing else is: what a store has not written
/// stays, and links in it are not followed.
#[derive(Debug)]
pub struct Store {
    pub(crate) folder: PathBuf,
    pub(crate) settings: StoreSettings,
    /// Surveys that are left out.
    pub(crate) damage: Damage,
}

impl Store {
    /// The store in a folder, or a new one in a folder that is new or empty; nothing is written yet.
    ///
    /// # Errors
    /// [`NetworkError::NotANetwork`] for a folder with other files, [`NetworkError::Value`] for a resolution below 0.1 m or
    /// above 1 km, or another than the store has.
    pub fn create_or_open(folder: &Path, settings: StoreSettings) -> Result<Self, NetworkError> {
        if let Some(resolution) = settings.resolution
            && !(0.1..=1e3).contains(&resolution)
        {
            return Err(NetworkError::Value {
                what: "the resolution",
                value: format!("{resolution} m"),
                rule: "between 0.1 m and 1000 m".to_owned(),
            });
        }
        let store = Self { folder: folder.to_owned(), settings, damage: Damage::new() };
        if let Some(record) = store.record()? {
            let there = record.resolution_m;
            if let Some(asked) = settings.resolution.filter(|asked| *asked != there) {
                return Err(NetworkError::Value {
                    what: "the resolution",
                    value: format!("{asked} m"),
                    rule: format!("that of the store, {there} m"),
                });
            }
            return Ok(store);
        }
        store.check_free()?;
        Ok(store)
    }

    pub(crate) fn record(&self) -> Result<Option<NetworkRecord>, NetworkError> {
        let path = self.folder.join(RECORD);
        match fs::read(&path) {
            Ok(bytes) => {
                let record: Result<NetworkRecord, _> = serde_json::from_slice(&bytes);
                let checked = record.map_err(|error| error.to_string());
                let checked = checked.and_then(|record| record.check().map(|()| record));
                let wrong = |reason| NetworkError::DamagedStore { path, reason };
                checked.map(Some).map_err(wrong)
            }
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(NetworkError::read(&path)(error)),
        }
    }

    fn there(&self) -> Result<NetworkRecord, NetworkError> {
        self.record()?.ok_or_else(|| NetworkError::NoNetwork { folder: self.folder.clone() })
    }

    /// Length of a cell of the grid \[m\].
    ///
    /// # Errors
    /// [`NetworkError::NoNetwork`] before the first survey.
    pub fn resolution(&self) -> Result<f64, NetworkError> {
        Ok(self.there()?.resolution_m)
    }

    /// The bands of wavelength.
    ///
    /// # Errors
    /// [`NetworkError::NoNetwork`] before the first survey.
    pub fn bands(&self) -> Result<Vec<WavelengthBand>, NetworkError> {
        let path = self.folder.join(RECORD);
        self.there()?.bands().map_err(|error| NetworkError::DamagedStore { path, reason: error.to_string() })
    }

    /// What the first survey makes of a new store; one that is there must have the bands of the survey.
    pub(crate) fn begin(&self, bands: &[WavelengthBand], block: f64) -> Result<NetworkRecord, NetworkError> {
        let bands_m: Vec<[f64; 2]> = bands.iter().map(|band| [band.from(), band.to()]).collect();
        if let Some(record) = self.record()? {
            if bands_m.iter().all(|band| record.place_of(*band).is_some()) {
                return Ok(record);
            }
            return Err(NetworkError::Value {
                what: "the list of bands",
                value: in_words(&bands_m),
                rule: format!("of those of the store, {}", in_words(&record.bands_m)),
            });
        }
        let record = NetworkRecord {
            format: FORMAT,
            riffel_version: env!("CARGO_PKG_VERSION").to_owned(),
            resolution_m: self.settings.resolution.unwrap_or(block),
            bands_m,
        };
        record.check().map_err(|_| NetworkError::Value {
            what: "the list of bands",
            value: in_words(&record.bands_m),
            rule: "of wavelengths between 0.1 mm and 1 km, each once".to_owned(),
        })?;
        write_document(&self.folder, RECORD, &record)?;
        Ok(record)
    }

    /// RMS \[m\] of a chunk of cells of a rail, band by band; `None` if nothing is known.
    pub(crate) fn chunk(
        &self,
        survey: &SurveyRecord,
        rail: &RailRecord,
        bands: usize,
        chunk: u64,
    ) -> Result<Option<Vec<f64>>, NetworkError> {
        let array = array(survey, rail, bands);
        let group = self.line_folder(&survey.line).join(&survey.folder);
        let path = group.join(array.file(chunk));
        let bytes = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound && group.exists() => {
                return Ok(None);
            }
            Err(error) => return Err(NetworkError::read(&path)(error)),
        };
        match array.decode(&bytes, ROWS) {
            Ok(Values::Numbers(values)) => Ok(Some(values)),
            Ok(Values::Texts(_)) => Ok(None),
            Err(reason) => Err(NetworkError::Damaged { path, reason: reason.to_owned() }),
        }
    }
}

/// The array of a rail.
pub(crate) fn array(survey: &SurveyRecord, rail: &RailRecord, bands: usize) -> Array {
    Array {
        name: rail.array.clone(),
        data_type: DataType::Float64,
        shape: vec![survey.cells, bands as u64],
        rows_per_chunk: ROWS,
        dimensions: vec!["place", "band"],
        attributes: json!({
            "units": "m",
            "long_name": format!("RMS of roughness in a band of wavelength, {} rail", rail.name),
            "rail": rail.name,
        }),
    }
}

/// Ends of bands \[m\] in words.
pub(crate) fn in_words(bands: &[[f64; 2]]) -> String {
    let bands = bands.iter();
    let texts: Vec<String> = bands.map(|&ends| range(ends, |end| format!("{:.0}", 1e3 * end)) + " mm").collect();
    texts.join(", ")
}

pub(crate) fn write_document(folder: &Path, name: &str, document: &impl Serialize) -> Result<(), NetworkError> {
    whole_file::write(folder, name, &riffel_arrays::json(document)).map_err(NetworkError::write(&folder.join(name)))
}
