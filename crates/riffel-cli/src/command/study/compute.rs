//! `riffel study PLAN`

use std::path::PathBuf;
use std::time::Instant;

use riffel_answers::study::Statistics;
use riffel_study::{ChunkState, ResultFolder, Shard, Study, Summary};
use serde::Serialize;

use super::statistics::table_of;
use crate::arguments::{Run, stem};
use crate::messages::{complain, print_remarks, say};
use crate::output::{print, print_json};
use crate::progress::Progress;
use crate::staging::{INTERRUPTED, stop_on_interrupt};
use crate::threads::on_threads;

/// What `--json` prints.
#[derive(Serialize)]
struct Document<'a> {
    folder: String,
    fingerprint: &'a str,
    parameters: Vec<&'a str>,
    #[serde(flatten)]
    summary: &'a Summary,
    /// Samples computed by this run.
    samples_computed: u64,
    seconds: f64,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    outputs: Vec<Statistics>,
    remarks: &'a [String],
}

pub(super) fn run(arguments: &Run) -> miette::Result<u8> {
    // The plan is given where there is no sub-command.
    let plan = arguments.plan.clone().unwrap_or_default();
    let study = Study::read(&plan)?;
    let path = arguments.output.clone().unwrap_or_else(|| PathBuf::from(format!("{}-results", stem(&plan))));
    let shard = arguments.shard.unwrap_or(Shard::ALL);
    let stop = stop_on_interrupt();
    say(beginning(&study));
    let folder = ResultFolder::begin(&study, &path)?;
    let _in_use = folder.occupy(shard)?;
    let states = folder.states(shard)?;
    let pending = pending(&states);
    let size = |chunk: &u64| {
        let samples = study.samples_of(*chunk);
        samples.end - samples.start
    };
    let samples: u64 = pending.iter().map(size).sum();

    let begun = Instant::now();
    let progress = Progress::counting(riffel_keys::say!(progress_samples), samples);
    let work = || study.run(&folder, &pending, &|| progress.advance(1), &stop);
    let outcome = on_threads(arguments.threads, work)?;
    drop(progress);
    outcome?;
    let seconds = begun.elapsed().as_secs_f64();
    let summary = folder.summary()?;
    let whole = summary.chunks_finished == summary.chunks;
    if stop.is_asked() && !pending.is_empty() && !whole {
        complain(format_args!(
            "stopped: {} of {} chunks are finished and kept in {}; the same command goes on from there",
            summary.chunks_finished,
            summary.chunks,
            path.display()
        ));
        return Ok(INTERRUPTED);
    }
    if whole && shard == Shard::ALL {
        folder.sweep()?;
    }
    let outputs = match whole {
        true => Statistics::of(&study, &folder)?,
        false => Vec::new(),
    };
    let document = Document {
        folder: path.display().to_string(),
        fingerprint: &study.fingerprint,
        parameters: study.parameters().iter().map(|p| p.key.key.as_str()).collect(),
        summary: &summary,
        samples_computed: samples,
        seconds,
        outputs,
        remarks: &study.plan.remarks,
    };
    match arguments.json {
        true => print_json(&document)?,
        false => print(&readable(&study, &document))?,
    }
    if samples > 0 {
        say(format_args!(
            "{samples} samples in {}, {:.0} a second",
            crate::progress::duration(seconds),
            samples as f64 / seconds
        ));
    }
    print_remarks(&study.plan.remarks);
    Ok(0)
}

/// The chunks that are to be computed, with a word on damaged and on finished ones.
fn pending(states: &[(u64, ChunkState)]) -> Vec<u64> {
    for (chunk, state) in states {
        if let ChunkState::Damaged(file) = state {
            let file = file.display();
            say(format_args!("note: {file} is damaged; chunk {chunk} is computed anew"));
        }
    }
    let pending: Vec<u64> =
        states.iter().filter(|(_, state)| *state != ChunkState::Finished).map(|(chunk, _)| *chunk).collect();
    let kept = states.len() - pending.len();
    if kept > 0 {
        say(format_args!("{kept} of {} chunks are finished and kept", states.len()));
    }
    pending
}

/// Statistics for the terminal.
fn readable(study: &Study, document: &Document<'_>) -> String {
    let summary = document.summary;
    let title = study.plan.file.title.as_deref().unwrap_or("Study");
    let left = match summary.chunks - summary.chunks_finished {
        0 => String::new(),
        left => format!("{left} of {} chunks are left to other shards\n", summary.chunks),
    };
    format!(
        "{title}\n{}{}{left}{}: results.zarr plan.toml case.toml study.json\n",
        table_of(&document.outputs),
        super::failures(summary),
        document.folder,
    )
}

/// How large the study is.
fn beginning(study: &Study) -> String {
    let plan = &study.plan;
    format!(
        "{} samples of {} parameters ({}), {} in {} chunks",
        study.samples(),
        study.parameters().len(),
        plan.file.design.method.name(),
        plan.size_in_words(),
        study.chunks()
    )
}
