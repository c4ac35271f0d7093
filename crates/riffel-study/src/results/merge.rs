//! Folders of shards as one.

use std::fs;
use std::path::Path;

use super::record::ChunkRecord;
use super::{ARRAYS, ChunkState, ResultFolder};
use crate::{Shard, StudyError, Summary};

/// What a merge did.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct MergeReport {
    /// Chunks that were copied.
    pub copied: u64,
    /// Chunks that were there already, with the same numbers.
    pub there_already: u64,
    /// Chunks that no folder has, in order.
    pub missing: Vec<u64>,
    /// What is there now.
    pub summary: Summary,
}

impl ResultFolder {
    /// Copy the finished chunks of other folders of the same study into one, which is made if need be.
    ///
    /// All folders are read and checked before anything is written.
    ///
    /// # Errors
    /// [`StudyError::OtherPlan`], [`StudyError::OtherVersion`], [`StudyError::Damaged`] for a chunk whose files are not
    /// what was written, [`StudyError::Conflict`] for two folders that disagree.
    pub fn merge(into: &Path, from: &[&Path]) -> Result<MergeReport, StudyError> {
        let mut folders = Vec::new();
        for &path in from {
            let (study, folder) = Self::open(path)?;
            if let Some((_, first)) = folders.first() {
                let first: &Self = first;
                folder.study.check(&first.study, path)?;
            }
            folders.push((study, folder));
        }
        let Some((study, first)) = folders.first() else {
            return Self::open(into).and_then(|(_, folder)| folder.report(0, 0));
        };
        let target = match into.join(super::STUDY).exists() {
            true => {
                let there = super::StudyRecord::read(&into.join(super::STUDY))?;
                there.check(&first.study, into)?;
                Some(Self::begin(study, into)?)
            }
            false => None,
        };
        // Where each chunk comes from; checksums tell whether two folders agree.
        let chunks = first.study.chunks;
        let mut sources: Vec<Option<(usize, ChunkRecord)>> = vec![None; chunks as usize];
        let mut there: Vec<Option<ChunkRecord>> = vec![None; chunks as usize];
        let mut there_already = 0;
        for chunk in 0..chunks {
            let slot = chunk as usize;
            if let Some(target) = &target {
                // A damaged chunk of the target is replaced.
                there[slot] = target.look_at(chunk)?.1;
            }
            for (index, (_, folder)) in folders.iter().enumerate() {
                let (state, record) = folder.look_at(chunk)?;
                if let ChunkState::Damaged(path) = state {
                    return Err(StudyError::Damaged { path, chunk });
                }
                let Some(record) = record else {
                    continue;
                };
                let known = there[slot].as_ref().or(sources[slot].as_ref().map(|(_, record)| record));
                match known {
                    Some(known) if *known != record => {
                        return Err(StudyError::Conflict { folder: folder.path.clone(), into: into.to_owned(), chunk });
                    }
                    Some(_) => there_already += 1,
                    None => sources[slot] = Some((index, record)),
                }
            }
        }
        let target = match target {
            Some(target) => target,
            None => Self::begin(study, into)?,
        };
        let mut copied = 0;
        for (chunk, source) in (0..).zip(sources) {
            let Some((index, record)) = source else {
                continue;
            };
            for (name, checksum) in &record.files {
                let path = folders[index].1.path.join(ARRAYS).join(name);
                let bytes = fs::read(&path).map_err(|reason| StudyError::Read { path: path.clone(), reason })?;
                if super::checksum(&bytes) != *checksum {
                    return Err(StudyError::Damaged { path, chunk });
                }
                target.put(&format!("{ARRAYS}/{name}"), &bytes)?;
            }
            target.put(&super::record_name(chunk), &riffel_arrays::json(&record))?;
            copied += 1;
        }
        target.report(copied, there_already)
    }

    fn report(&self, copied: u64, there_already: u64) -> Result<MergeReport, StudyError> {
        Ok(MergeReport { copied, there_already, missing: self.pending(Shard::ALL)?, summary: self.summary()? })
    }
}
