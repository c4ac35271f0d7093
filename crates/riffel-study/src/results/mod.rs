//! Results in a folder, chunk by chunk.
//!
//! ```text
//! DIR/study.json         version, fingerprint, numbers of samples and chunks
//! DIR/plan.toml          the plan as it was written
//! DIR/case.toml          the case as it was written, with its data beside it
//! DIR/results.zarr/      the arrays, which xarray.open_zarr opens
//! DIR/finished/000012.json   chunk 12 is finished: its files and their checksums
//! ```
//!
//! Every file is written under another name in the same folder, synchronised and renamed, so that it is there
//! whole or not at all. The record of a chunk comes last. A chunk is believed if its record is there and all its
//! files have the checksums that the record tells.

mod arrays;
mod in_use;
mod merge;
mod record;

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use rayon::prelude::*;
use riffel_arrays::{Values, json, whole_file};

pub use merge::MergeReport;
pub use record::{Reason, Summary};

use crate::study::{Chunk, Study};
use crate::{ParameterValue, Shard, StudyError};
use arrays::Arrays;
use record::{ChunkRecord, StudyRecord};
use sha2::{Digest, Sha256};

/// The folder of the arrays.
pub(crate) const ARRAYS: &str = "results.zarr";
const FINISHED: &str = "finished";
const STUDY: &str = "study.json";
const PLAN: &str = "plan.toml";
const CASE: &str = "case.toml";

/// A folder with the results of a study, finished or not.
pub struct ResultFolder {
    path: PathBuf,
    study: StudyRecord,
    arrays: Arrays,
}

/// What is known of a chunk.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ChunkState {
    /// Its files are what was written.
    Finished,
    /// There is no record of it.
    Missing,
    /// There is a record, but this file is not what it tells.
    Damaged(PathBuf),
}

impl ResultFolder {
    /// The folder of a study, made if need be.
    ///
    /// # Errors
    /// [`StudyError::OtherPlan`], [`StudyError::OtherVersion`] or [`StudyError::NotAStudy`] if the folder is that of
    /// something else, which is left alone; [`StudyError::Write`].
    pub fn begin(study: &Study, path: &Path) -> Result<Self, StudyError> {
        let own = StudyRecord::of(study);
        let folder = Self { path: path.to_owned(), arrays: Arrays::new(study), study: own };
        if !path.join(STUDY).exists() {
            folder.check_free(study)?;
            // Of two studies that begin here at once, the second finds the record of the first.
            match whole_file::write_new(path, STUDY, &json(&folder.study)) {
                Err(reason) if reason.kind() != io::ErrorKind::AlreadyExists => {
                    return Err(StudyError::write(&path.join(STUDY))(reason));
                }
                _ => {}
            }
        }
        let there = StudyRecord::read(&path.join(STUDY))?;
        there.check(&folder.study, path)?;
        folder.write_study(study)?;
        Ok(folder)
    }

    /// A folder of results with the study that is recorded in it.
    ///
    /// # Errors
    /// [`StudyError::NoStudy`], [`StudyError::OtherVersion`], or an error of the recorded plan.
    pub fn open(path: &Path) -> Result<(Study, Self), StudyError> {
        let record = path.join(STUDY);
        if !record.exists() {
            return Err(StudyError::NoStudy { folder: path.to_owned() });
        }
        let there = StudyRecord::read(&record)?;
        let plan = path.join(PLAN);
        let text = fs::read_to_string(&plan).map_err(|reason| StudyError::Read { path: plan.clone(), reason })?;
        there.check_version(path)?;
        let study = Study::parse(&plan.display().to_string(), &text, &path.join(CASE))?;
        there.check(&StudyRecord::of(&study), path)?;
        let folder = Self { path: path.to_owned(), arrays: Arrays::new(&study), study: there };
        Ok((study, folder))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The zarr group in it.
    pub fn arrays_path(&self) -> PathBuf {
        self.path.join(ARRAYS)
    }

    /// `Ok` if nothing but an interrupted beginning of this study is there: a file of another's stays.
    fn check_free(&self, study: &Study) -> Result<(), StudyError> {
        if !self.path.exists() {
            return Ok(());
        }
        let read = |reason| StudyError::Read { path: self.path.clone(), reason };
        let files = [(PLAN, study.plan.text.as_bytes()), (CASE, study.case_text.as_bytes())];
        let data = study.data.iter().map(|(name, bytes)| (&**name, &**bytes));
        let files: Vec<(&str, &[u8])> = files.into_iter().chain(data).collect();
        let first = |name: &str| name.split('/').next().unwrap_or_default().to_owned();
        for entry in fs::read_dir(&self.path).map_err(read)? {
            let name = entry.map_err(read)?.file_name();
            let name = name.to_string_lossy();
            let folder = [ARRAYS, FINISHED].contains(&&*name) || name.starts_with(whole_file::PREFIX);
            let mut own = files.iter().filter(|(file, _)| first(file) == name).peekable();
            let same = own.peek().is_some()
                && own.all(|(file, bytes)| {
                    let path = self.path.join(file);
                    !path.exists() || fs::read(path).is_ok_and(|there| there == *bytes)
                });
            if !folder && !same {
                return Err(StudyError::NotAStudy { folder: self.path.clone() });
            }
        }
        Ok(())
    }

    /// Write what is not there of all but the chunks, after `study.json`, and find links in the way of the chunks.
    fn write_study(&self, study: &Study) -> Result<(), StudyError> {
        let write = |name: &str, bytes: &[u8]| match self.path.join(name).exists() {
            true => Ok(()),
            false => self.put(name, bytes),
        };
        write(PLAN, study.plan.text.as_bytes())?;
        write(CASE, study.case_text.as_bytes())?;
        for (name, bytes) in &study.data {
            let inside = Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
            // A name that leads out of the folder of the case is found where it was, or not at all.
            if inside {
                write(name, bytes)?;
            }
        }
        for (name, bytes) in self.arrays.beginning(study) {
            write(&format!("{ARRAYS}/{name}"), &bytes)?;
        }
        let of_chunks = self.arrays.files_of(0).map(|name| format!("{ARRAYS}/{name}"));
        for name in of_chunks.chain([record_name(0)]) {
            let path = self.path.join(&name);
            whole_file::place(&self.path, &name).map_err(StudyError::write(&path))?;
        }
        Ok(())
    }

    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), StudyError> {
        whole_file::write(&self.path, name, bytes).map_err(StudyError::write(&self.path.join(name)))
    }

    fn record_path(&self, chunk: u64) -> PathBuf {
        self.path.join(record_name(chunk))
    }

    /// Write a chunk, all its arrays and then its record. From then on it is finished.
    ///
    /// # Errors
    /// [`StudyError::Write`]; the chunk is then not finished.
    pub fn commit(&self, chunk: &Chunk) -> Result<(), StudyError> {
        let mut record = ChunkRecord::new(chunk);
        for (name, bytes) in self.arrays.encode(chunk) {
            self.put(&format!("{ARRAYS}/{name}"), &bytes)?;
            record.files.insert(name, checksum(&bytes));
        }
        self.put(&record_name(chunk.index), &json(&record))
    }

    /// What is known of a chunk. Cost: its files are read.
    ///
    /// # Errors
    /// [`StudyError::Read`].
    pub fn state(&self, chunk: u64) -> Result<ChunkState, StudyError> {
        Ok(self.look_at(chunk)?.0)
    }

    fn look_at(&self, chunk: u64) -> Result<(ChunkState, Option<ChunkRecord>), StudyError> {
        let path = self.record_path(chunk);
        if !path.exists() {
            return Ok((ChunkState::Missing, None));
        }
        let Ok(record) = ChunkRecord::read(&path) else {
            return Ok((ChunkState::Damaged(path), None));
        };
        for name in self.arrays.files_of(chunk) {
            let path = self.path.join(ARRAYS).join(&name);
            let believed = fs::read(&path).is_ok_and(|bytes| record.files.get(&name) == Some(&checksum(&bytes)));
            if !believed {
                return Ok((ChunkState::Damaged(path), None));
            }
        }
        Ok((ChunkState::Finished, Some(record)))
    }

    /// The chunks of a shard with their states, in order. Cost: their files are read, in parallel.
    ///
    /// # Errors
    /// [`StudyError::Read`].
    pub fn states(&self, shard: Shard) -> Result<Vec<(u64, ChunkState)>, StudyError> {
        (0..self.study.chunks)
            .into_par_iter()
            .filter(|&chunk| shard.contains(chunk))
            .map(|chunk| Ok((chunk, self.state(chunk)?)))
            .collect()
    }

    /// The chunks of a shard that are missing or damaged, in order.
    ///
    /// # Errors
    /// [`StudyError::Read`].
    pub fn pending(&self, shard: Shard) -> Result<Vec<u64>, StudyError> {
        let states = self.states(shard)?.into_iter();
        Ok(states.filter(|(_, state)| *state != ChunkState::Finished).map(|(chunk, _)| chunk).collect())
    }

    /// What the finished chunks hold.
    ///
    /// # Errors
    /// [`StudyError::Read`].
    pub fn summary(&self) -> Result<Summary, StudyError> {
        let mut summary = Summary::new(self.study.samples, self.study.chunks);
        for chunk in 0..self.study.chunks {
            let path = self.record_path(chunk);
            if path.exists() {
                summary.add(&ChunkRecord::read(&path)?);
            }
        }
        Ok(summary)
    }

    /// Remove what killed processes left half-written. Only where no other process works on the folder.
    ///
    /// # Errors
    /// [`StudyError::Write`].
    pub fn sweep(&self) -> Result<(), StudyError> {
        whole_file::sweep(&self.path).map_err(StudyError::write(&self.path))
    }

    /// All values of an output, sample after sample; complex ones as pairs.
    ///
    /// # Errors
    /// [`StudyError::Incomplete`], [`StudyError::Damaged`], [`StudyError::Read`].
    pub fn output(&self, name: &str) -> Result<Vec<f64>, StudyError> {
        self.check_complete()?;
        match self.read_array(name)? {
            Values::Numbers(numbers) => Ok(numbers),
            Values::Texts(_) => Err(StudyError::Array { name: name.to_owned(), reason: "its values are texts" }),
        }
    }

    /// The values of a parameter, sample after sample.
    ///
    /// # Errors
    /// Errors of [`output`](Self::output).
    pub fn parameter(&self, key: &str) -> Result<Vec<ParameterValue>, StudyError> {
        self.check_complete()?;
        Ok(match self.read_array(key)? {
            Values::Numbers(numbers) => numbers.into_iter().map(ParameterValue::Number).collect(),
            Values::Texts(texts) => texts.into_iter().map(ParameterValue::Text).collect(),
        })
    }

    fn check_complete(&self) -> Result<(), StudyError> {
        let missing = (0..self.study.chunks).filter(|&chunk| !self.record_path(chunk).exists()).count() as u64;
        match missing {
            0 => Ok(()),
            missing => Err(StudyError::Incomplete { folder: self.path.clone(), missing, chunks: self.study.chunks }),
        }
    }

    fn read_array(&self, name: &str) -> Result<Values, StudyError> {
        let array = self.arrays.find(name)?;
        let mut all: Option<Values> = None;
        for chunk in 0..self.study.chunks {
            let file = array.file(chunk);
            let path = self.path.join(ARRAYS).join(&file);
            let damaged = || StudyError::Damaged { path: path.clone(), chunk };
            let bytes = fs::read(&path).map_err(|_| damaged())?;
            let record = ChunkRecord::read(&self.record_path(chunk))?;
            if record.files.get(&file) != Some(&checksum(&bytes)) {
                return Err(damaged());
            }
            let values = array
                .decode(&bytes, record.samples)
                .map_err(|reason| StudyError::Array { name: name.to_owned(), reason })?;
            match (&mut all, values) {
                (Some(Values::Numbers(all)), Values::Numbers(more)) => all.extend(more),
                (Some(Values::Texts(all)), Values::Texts(more)) => all.extend(more),
                (all, values) => *all = Some(values),
            }
        }
        Ok(all.unwrap_or(Values::Numbers(Vec::new())))
    }
}

/// The record of a chunk, below the folder of results.
fn record_name(chunk: u64) -> String {
    format!("{FINISHED}/{chunk:06}.json")
}

/// SHA-256 of a file. Not a CRC: the files of the arrays end with their own, and the CRC of any such file is the
/// same number.
fn checksum(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}
