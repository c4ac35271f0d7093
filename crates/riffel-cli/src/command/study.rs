//! `riffel study PLAN`

use std::time::Instant;

use riffel_answers::Answer;
use riffel_answers::question::{of_keys, on_threads};
use riffel_answers::study::{Part, StudyAnswer, StudyQuestion};
use riffel_keys::{Message, number};
use riffel_study::{ChunkState, ResultFolder, Shard, Study};

use crate::arguments::QuestionCall;
use crate::interrupt::INTERRUPTED;
use crate::output::{print, print_json};
use crate::progress::Progress;
use crate::results::in_words;
use crate::session::Session;

pub(super) fn run(session: &Session, call: &QuestionCall) -> miette::Result<u8> {
    let question: StudyQuestion = of_keys(call.keys.clone().into())?;
    let study = Study::read(&question.plan)?;
    let path = call.folder("results");
    let shard = question.shard.map_or(Shard::ALL, |Part(shard)| shard);
    let stop = session.interrupt.asks_work();
    session.voice.say(beginning(&study));
    let folder = ResultFolder::begin(&study, &path)?;
    let _in_use = folder.occupy(shard)?;
    let states = folder.states(shard)?;
    let pending = pending(session, &states);
    let size = |chunk: &u64| {
        let samples = study.samples_of(*chunk);
        samples.end - samples.start
    };
    let samples: u64 = pending.iter().map(size).sum();

    let begun = Instant::now();
    let progress = Progress::counting(session.voice, riffel_keys::say!(progress_samples), samples);
    let work = || study.run(&folder, &pending, &|| progress.advance(1), &stop);
    let outcome = on_threads(question.threads, work)?;
    drop(progress);
    outcome?;
    let seconds = begun.elapsed().as_secs_f64();
    let summary = folder.summary()?;
    let whole = summary.chunks_finished == summary.chunks;
    if stop.is_asked() && !pending.is_empty() && !whole {
        session.voice.complain(riffel_keys::say!(
            study_stopped,
            finished = number(summary.chunks_finished),
            chunks = number(summary.chunks),
            folder = path.display().to_string()
        ));
        return Ok(INTERRUPTED);
    }
    if whole && shard == Shard::ALL {
        folder.sweep()?;
    }
    let answer = StudyAnswer::new(&study, (&folder, &path), summary, (samples, seconds))?;
    match call.json {
        true => print_json(session.voice, &answer)?,
        false => {
            let files = "results.zarr plan.toml case.toml study.json";
            print(&format!("{}{}: {files}\n", in_words(session.voice, &answer), path.display()))?;
        }
    }
    if samples > 0 {
        session.voice.say(riffel_keys::say!(
            samples_computed,
            samples = number(samples),
            time = number(crate::progress::duration(seconds)),
            rate = number(format_args!("{:.0}", samples as f64 / seconds))
        ));
    }
    session.print_remarks(answer.remarks());
    Ok(0)
}

/// The chunks that are to be computed, with a word on damaged and on finished ones.
fn pending(session: &Session, states: &[(u64, ChunkState)]) -> Vec<u64> {
    for (chunk, state) in states {
        if let ChunkState::Damaged(file) = state {
            let file = file.display();
            session.voice.say(riffel_keys::say!(chunk_is_damaged, file = file.to_string(), chunk = number(chunk)));
        }
    }
    let pending: Vec<u64> =
        states.iter().filter(|(_, state)| *state != ChunkState::Finished).map(|(chunk, _)| *chunk).collect();
    let kept = states.len() - pending.len();
    if kept > 0 {
        session.voice.say(riffel_keys::say!(chunks_are_kept, kept = number(kept), chunks = number(states.len())));
    }
    pending
}

/// How large the study is.
fn beginning(study: &Study) -> Message {
    let plan = &study.plan;
    riffel_keys::say!(
        study_begins,
        samples = number(study.samples()),
        parameters = number(study.parameters().len()),
        method = plan.file.design.method.name(),
        size = number(plan.size_in_words()),
        chunks = number(study.chunks())
    )
}
