//! `riffel simulate --passages`

use std::fs;
use std::io;
use std::path::Path;
use std::time::{Duration, Instant};

use riffel_answers::question::of_keys;
use riffel_answers::simulate::{EvolutionRun, SimulateQuestion};
use riffel_keys::{number, say as message};

use crate::arguments::QuestionCall;
use crate::error::CliError;
use crate::interrupt::INTERRUPTED;
use crate::progress::Progress;
use crate::session::Session;
use crate::staging::{Existing, check_files, write_file};
use crate::terminal::Terminal;

/// What a run that was stopped is gone on from, in the folder of its results.
const STATE: &str = "state.json";

/// What is written when it is done.
const FILES: [&str; 11] = [
    "spectrum.png",
    "spectrum.svg",
    "spectrum.html",
    "profile.png",
    "profile.svg",
    "profile.html",
    "passages.html",
    "bands.csv",
    "profile.csv",
    "evolution.nc",
    "evolution.json",
];

/// Time from one state to the next.
const STATE_EVERY: Duration = Duration::from_secs(1);

/// The rail under many wheels, from where the folder has it on; returns the exit status, or `None` where one passage is asked for.
pub(crate) fn run(session: &Session, call: &QuestionCall) -> miette::Result<Option<u8>> {
    let question: SimulateQuestion = of_keys(call.keys.clone().into())?;
    let Some((mut run, passages)) = question.evolution(&Terminal(session))? else {
        return Ok(None);
    };
    let results = call.results_of(None);
    let state = results.folder.as_ref().map(|folder| folder.join(STATE));
    if let (Some(folder), Some(path)) = (&results.folder, &state) {
        check_files(session, folder, &FILES)?;
        resume(session, &mut run, path, passages)?;
    }
    let stop = session.interrupt.asks_work();
    let progress = Progress::new(session.voice, message!(progress_passages), passages as usize);
    progress.advance(run.passages() as usize);
    let mut kept = Instant::now();
    let answer = loop {
        let before = run.passages();
        if let Some(answer) = run.go_on(passages)? {
            break answer;
        }
        progress.advance((run.passages() - before) as usize);
        let asked = stop.is_asked();
        if let Some(path) = &state
            && (asked || kept.elapsed() > STATE_EVERY)
        {
            keep(session, &run, path)?;
            kept = Instant::now();
        }
        if asked {
            drop(progress);
            let passed = run.passages();
            let (passed, passages) = (number(passed), number(passages));
            session.voice.complain(match &state {
                Some(path) => message!(passages_kept, passed = passed, passages = passages, file = path.display()),
                None => message!(passages_stopped, passed = passed, passages = passages),
            });
            return Ok(Some(INTERRUPTED));
        }
    };
    drop(progress);
    if let Some(path) = &state {
        keep(session, &run, path)?;
    }
    results.answer(session, &answer)?;
    Ok(Some(0))
}

/// Go on from the state in the folder, if there is one.
fn resume(session: &Session, run: &mut EvolutionRun, path: &Path, passages: u64) -> Result<(), CliError> {
    let refuse = |reason: String| CliError::State { path: path.to_owned(), reason };
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(reason) if reason.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(reason) if reason.kind() == io::ErrorKind::NotADirectory => {
            return Err(CliError::Write { path: path.parent().unwrap_or(path).to_owned(), reason });
        }
        Err(reason) => return Err(refuse(reason.to_string())),
    };
    run.resume(&text).map_err(refuse)?;
    if run.passages() > passages {
        return Err(refuse(format!("it is after {} passages, more than the {passages} asked for", run.passages())));
    }
    session.voice.say(message!(going_on_after, passages = number(run.passages()), file = path.display()));
    Ok(())
}

fn keep(session: &Session, run: &EvolutionRun, path: &Path) -> Result<(), CliError> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).map_err(|reason| CliError::Write { path: folder.to_owned(), reason })?;
    write_file(session, path, &run.state(), Existing::Replace)
}
