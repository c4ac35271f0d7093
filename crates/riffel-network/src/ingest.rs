//! A survey into the store.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

use jiff::civil::Date;
use riffel_arrays::{Array, Values, whole_file};
use riffel_rail::read_date;
use serde::Serialize;
use serde_json::json;

use crate::grid::Gridded;
use crate::name::{array_name, arrays_name, record_name};
use crate::rails::LineRails;
use crate::record::{MOST_CELLS, NetworkRecord, RailRecord, SurveyRecord};
use crate::store::{ROWS, Store, array, write_document};
use crate::{GoesBack, NetworkError, SurveyFile};

/// What became of a survey.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Ingested {
    /// The line.
    pub line: String,
    /// The day.
    pub date: String,
    /// Whether the store had it already, and nothing was written.
    pub there_already: bool,
    /// Length of the cells of the store \[m\].
    pub resolution_m: f64,
    /// Another line of the store that is called alike, but for capitals, spaces and marks.
    pub alike: Option<String>,
    /// Cells that are measured, of each rail.
    pub measured: BTreeMap<String, u64>,
    /// Where places go back, as at a long kilometre: cells of both stretches hold the mean of their energies.
    pub goes_back: Vec<GoesBack>,
    /// Rails of the file that have other names in the line.
    pub renamed: BTreeMap<String, String>,
    /// Rails that the line has not had, if it had any.
    pub new_rails: Vec<String>,
}

impl Store {
    /// Add a survey of a line at a date. The same file of the same date is there already and changes nothing; another one is
    /// refused, unless it is to `replace`. Rails have the names that other surveys of the line have for them. `progress` is told of
    /// blocks done.
    ///
    /// Memory: a chunk of cells for each rail.
    ///
    /// # Errors
    /// [`NetworkError::Date`] for what is no date; [`NetworkError::Value`] for a line without a name, two rails of one, other bands than the store has, or more than 10⁸
    /// cells; [`NetworkError::Conflict`], [`NetworkError::Locked`], [`NetworkError::Write`].
    pub fn ingest(
        &self,
        line: &str,
        date: &str,
        file: &SurveyFile,
        replace: bool,
        progress: &dyn Fn(usize),
    ) -> Result<Ingested, NetworkError> {
        let line = line.trim();
        check_line(line)?;
        let day = day_of(date)?;
        if let Some([first, last]) = file.dates.filter(|[first, last]| !(first..=last).contains(&&day)) {
            let rule = format!("a day of the blocks, which are of {first} to {last}");
            return Err(value("the date", day.to_string(), &rule));
        }
        let _held = self.lock()?;
        self.check_writable(line)?;
        let network = self.begin(&file.bands(), file.usual_block)?;
        let folder = self.line_folder(line);
        let (surveys, mut damage) = self.records()?;
        let is_known = surveys.iter().any(|survey| survey.line == line);
        let is_alike = |survey: &&SurveyRecord| plain(&survey.line) == plain(line);
        let alike = surveys.iter().find(is_alike).filter(|_| !is_known);
        let others = surveys.iter();
        let others = others.filter(|survey| survey.line == line && survey.date != day);
        let rails = LineRails::new(file, &others.collect::<Vec<_>>())?;
        let sha256 = rails.sha256(file);
        let done = |survey: &SurveyRecord, there_already: bool| Ingested {
            line: survey.line.clone(),
            date: survey.date.to_string(),
            there_already,
            resolution_m: network.resolution_m,
            alike: alike.map(|survey| survey.line.clone()),
            measured: (survey.rails.iter()).map(|rail| (rail.name.clone(), rail.measured)).collect(),
            goes_back: file.goes_back.clone(),
            renamed: rails.renamed.clone(),
            new_rails: rails.new.clone(),
        };
        let there = surveys.iter().find(|survey| survey.line == line && survey.date == day);
        let mut broken = damage.remove(&folder.join(record_name(day)));
        if let Some(survey) = there {
            broken = self.check_arrays(survey).err();
            match broken {
                None if survey.sha256 == sha256 => return Ok(done(survey, true)),
                None if !replace => {
                    return Err(NetworkError::Conflict {
                        line: line.to_owned(),
                        date: day.to_string(),
                        source_name: survey.source.clone(),
                    });
                }
                _ => {}
            }
        }
        let there = there.filter(|_| broken.is_none());
        if let Some(error) = broken.filter(|_| !replace) {
            return Err(error);
        }
        let mut survey = record(line, day, file, (&rails.names, sha256), network.resolution_m)?;
        fs::create_dir_all(&folder).map_err(NetworkError::write(&folder))?;
        let recorded = there.map_or("", |survey| &survey.folder);
        Self::sweep(&folder, day, recorded)?;
        let temporary = Self::half_written(&folder)?;
        let half = temporary.path().join("arrays");
        write_arrays(&half, file, &network, &mut survey, progress)?;
        let arrays = folder.join(&survey.folder);
        whole_file::put(&half, &folder, &survey.folder).map_err(NetworkError::write(&arrays))?;
        let synchronise = || whole_file::synchronise(&folder).map_err(NetworkError::write(&folder));
        synchronise()?;
        write_document(&folder, &record_name(day), &survey)?;
        synchronise()?;
        Self::sweep(&folder, day, &survey.folder)?;
        Ok(done(&survey, false))
    }
}

fn value(what: &'static str, value: String, rule: &str) -> NetworkError {
    NetworkError::Value { what, value, rule: rule.to_owned() }
}

fn check_line(line: &str) -> Result<(), NetworkError> {
    if line.is_empty() || line.len() > 80 || line.chars().any(char::is_control) {
        let written = format!("\"{line}\"");
        return Err(value("the line", written, "a name of up to 80 bytes"));
    }
    Ok(())
}

/// The day of a survey.
fn day_of(date: &str) -> Result<Date, NetworkError> {
    let day = read_date(date).map_err(NetworkError::Date)?;
    // A later survey than all others is the state of its line: a year mistyped would stay so.
    match (1950..=2100).contains(&day.year()) {
        true => Ok(day),
        false => {
            let rule = "a day between 1950 and 2100";
            Err(value("the date", day.to_string(), rule))
        }
    }
}

/// What the store keeps of a survey beside its cells, none of which is measured yet.
fn record(
    line: &str,
    day: Date,
    file: &SurveyFile,
    (names, sha256): (&[String], String),
    resolution: f64,
) -> Result<SurveyRecord, NetworkError> {
    let first = (file.ends[0] / resolution + 1e-6).floor();
    let cells = (file.ends[1] / resolution - 1e-6).ceil() - first;
    if cells > MOST_CELLS {
        return Err(value(
            "the length of the line",
            format!("{:.0} km", 1e-3 * cells * resolution),
            "at most 10⁸ cells of the store",
        ));
    }
    Ok(SurveyRecord {
        line: line.to_owned(),
        date: day,
        source: file.name(),
        folder: arrays_name(day, &sha256),
        sha256,
        start_m: first * resolution,
        cells: cells as u64,
        devices: file.devices.clone(),
        rails: (names.iter().enumerate())
            .map(|(index, name)| RailRecord {
                name: name.clone(),
                array: array_name(name, index),
                measured: 0,
                defects_m: file.has_defects().then(Vec::new),
            })
            .collect(),
    })
}

/// Letters and digits of a name, small.
fn plain(name: &str) -> String {
    let kept = name.chars().filter(|letter| letter.is_alphanumeric());
    kept.flat_map(char::to_lowercase).collect()
}

/// All arrays of a survey below a folder.
fn write_arrays(
    folder: &Path,
    file: &SurveyFile,
    network: &NetworkRecord,
    survey: &mut SurveyRecord,
    progress: &dyn Fn(usize),
) -> Result<(), NetworkError> {
    let bands = network.bands_m.len();
    let arrays: Vec<Array> = survey.rails.iter().map(|rail| array(survey, rail, bands)).collect();
    let gridded = || Gridded::new(survey.start_m, network.resolution_m, ROWS as usize, bands);
    let mut rails: Vec<Gridded> = arrays.iter().map(|_| gridded()).collect();
    let put = |rail: usize, chunk: u64, values: Vec<f64>| -> Result<(), NetworkError> {
        let bytes = arrays[rail].encode(&Values::Numbers(values));
        write(&folder.join(arrays[rail].file(chunk)), &bytes)
    };
    // Bands of the store that the survey does not have are not known.
    let mut rms = vec![f64::NAN; bands];
    let places = file.bands().into_iter();
    let places: Vec<Option<usize>> = places.map(|band| network.place_of([band.from(), band.to()])).collect();
    file.each(
        &mut |block| {
            for (place, value) in places.iter().zip(&block.rms) {
                if let Some(place) = *place {
                    rms[place] = *value;
                }
            }
            let rail = block.rail;
            if let Some(found) = &mut survey.rails[rail].defects_m {
                found.extend(&block.defects);
            }
            rails[rail].add(block.from, block.to, &rms, |chunk, values| put(rail, chunk, values))
        },
        progress,
    )?;
    for (index, (rail, record)) in rails.iter_mut().zip(&mut survey.rails).enumerate() {
        rail.finish(|chunk, values| put(index, chunk, values))?;
        record.measured = rail.measured;
        if let Some(found) = &mut record.defects_m {
            found.sort_by(f64::total_cmp);
        }
    }
    coordinates(folder, network, survey, &arrays)
}

/// Places and bands, and what the group says of its arrays.
fn coordinates(
    folder: &Path,
    network: &NetworkRecord,
    survey: &SurveyRecord,
    arrays: &[Array],
) -> Result<(), NetworkError> {
    let mut place = Array::axis("place", "place", survey.cells, "m", "middle of a cell along the line");
    place.rows_per_chunk = ROWS;
    let axes = riffel_arrays::band_axes(&network.bands_m);
    let coordinates = [&place].into_iter().chain(axes.iter().map(|(array, _)| array));
    let all = || arrays.iter().chain(coordinates.clone());
    for array in all() {
        let path = folder.join(&array.name).join("zarr.json");
        write(&path, &riffel_arrays::json(&array.metadata()))?;
    }
    for chunk in 0..survey.cells.div_ceil(ROWS) {
        let middle = |row: u64| survey.start_m + (row as f64 + 0.5) * network.resolution_m;
        let rows = chunk * ROWS..((chunk + 1) * ROWS).min(survey.cells);
        let bytes = place.encode(&Values::Numbers(rows.map(middle).collect()));
        write(&folder.join(place.file(chunk)), &bytes)?;
    }
    for (array, values) in &axes {
        write(&folder.join(array.file(0)), &array.encode(values))?;
    }
    let attributes = json!({
        "title": survey.line,
        "date": survey.date.to_string(),
        "source": concat!("riffel ", env!("CARGO_PKG_VERSION")),
        "Conventions": "CF-1.8",
        "coordinates": "band_from band_to",
    });
    let group = riffel_arrays::group(attributes, all());
    write(&folder.join("zarr.json"), &riffel_arrays::json(&group))
}

/// Write a file of a folder that is not there yet for anybody else.
fn write(path: &Path, bytes: &[u8]) -> Result<(), NetworkError> {
    let parent = path.parent().unwrap_or_else(|| Path::new("."));
    fs::create_dir_all(parent)
        .and_then(|()| File::create(path))
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_data()))
        .map_err(NetworkError::write(path))
}
