//! Many samples on all cores.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::study::{Chunk, Sample, Study};
use crate::{ResultFolder, StudyError};

/// A wish to stop, which may come from another thread.
#[derive(Debug, Default)]
pub struct Stop(AtomicBool);

impl Stop {
    /// Ask to stop after the samples under way.
    pub fn ask(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it was asked for.
    pub fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// The samples still to be given out, and those of unfinished chunks.
struct Work<'a> {
    chunks: std::slice::Iter<'a, u64>,
    /// Numbers of samples of the chunk that is being given out.
    rest: std::ops::Range<u64>,
    chunk: u64,
    open: BTreeMap<u64, Open>,
    error: Option<StudyError>,
}

/// A chunk in the making.
struct Open {
    samples: Vec<Option<Sample>>,
    missing: usize,
}

impl Study {
    /// Compute chunks and commit each as soon as its last sample is there, on the current rayon pool.
    ///
    /// Threads take samples one by one in order, so that they finish together whatever a sample costs, and no
    /// more chunks are in memory than there are threads and one. `progress` is called for each sample from any
    /// thread. A wish to stop leaves unfinished chunks out.
    ///
    /// # Errors
    /// [`StudyError::Write`]; chunks committed before are finished.
    pub fn run(
        &self,
        folder: &ResultFolder,
        chunks: &[u64],
        progress: &(dyn Fn() + Sync),
        stop: &Stop,
    ) -> Result<(), StudyError> {
        let work = Mutex::new(Work { chunks: chunks.iter(), rest: 0..0, chunk: 0, open: BTreeMap::new(), error: None });
        rayon::broadcast(|_| {
            while let Some((chunk, sample)) = self.next_of(&work, stop) {
                let computed = self.sample(sample);
                progress();
                let Some(finished) = self.put(&work, chunk, sample, computed) else {
                    continue;
                };
                if let Err(error) = folder.commit(&finished) {
                    lock(&work).error.get_or_insert(error);
                }
            }
        });
        let error = lock(&work).error.take();
        error.map_or(Ok(()), Err)
    }

    fn next_of(&self, work: &Mutex<Work<'_>>, stop: &Stop) -> Option<(u64, u64)> {
        let mut work = lock(work);
        if stop.is_asked() || work.error.is_some() {
            return None;
        }
        loop {
            if let Some(sample) = work.rest.next() {
                return Some((work.chunk, sample));
            }
            let chunk = *work.chunks.next()?;
            let samples = self.samples_of(chunk);
            let count = (samples.end - samples.start) as usize;
            let open = Open { samples: vec![None; count], missing: count };
            work.open.insert(chunk, open);
            (work.chunk, work.rest) = (chunk, samples);
        }
    }

    /// Put a sample into its chunk; the chunk, if it was the last one.
    fn put(&self, work: &Mutex<Work<'_>>, chunk: u64, sample: u64, computed: Sample) -> Option<Chunk> {
        let mut work = lock(work);
        let open = work.open.get_mut(&chunk)?;
        let place = (sample - self.samples_of(chunk).start) as usize;
        open.samples[place] = Some(computed);
        open.missing -= 1;
        if open.missing > 0 {
            return None;
        }
        let finished = work.open.remove(&chunk)?;
        drop(work);
        Some(Chunk { index: chunk, samples: finished.samples.into_iter().flatten().collect() })
    }
}

fn lock<'a, 'b>(work: &'a Mutex<Work<'b>>) -> MutexGuard<'a, Work<'b>> {
    // A panic elsewhere ends the run; until then the state is whole.
    work.lock().unwrap_or_else(PoisonError::into_inner)
}
