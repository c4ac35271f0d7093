//! `riffel calibrate PLAN`

use std::path::Path;
use std::time::Instant;

use riffel_answers::calibration_question::CalibrateQuestion;
use riffel_answers::competing_models::{CompetingModels, what_is_compared};
use riffel_answers::forecast::PosteriorForecast;
use riffel_answers::question::{of_keys, on_threads};
use riffel_answers::{Answer, Calibration, CalibrationPlan, ResultFile, Table, level_limit};
use riffel_calibrate::file::SamplerKind;
use riffel_calibrate::{CalibrationError, Chains, Folder, Identifiability, Measured, Plan, Progress};
use riffel_keys::{Message, fixed, number};

use crate::arguments::QuestionCall;
use crate::interrupt::INTERRUPTED;
use crate::output::{json, print};
use crate::progress::{self, duration};
use crate::results::in_words;
use crate::session::Session;
use crate::staging::{Staging, check_files};

/// The limit of the forecast that is made with every calibration.
const LIMIT: &str = "iso-3095-2013";
/// The months of the forecast that is made with every calibration.
const MONTHS: f64 = 24.0;
/// What is written in any case, beside the draws.
const FILES: [&str; 5] =
    ["posterior.png", "posterior.svg", "posterior.html", "identifiability.csv", "correlations.csv"];
/// Sets of values that the model computes for a draw, those of an emulator among them: some 34 000 for 8000 draws of nine values.
const SETS_A_DRAW: f64 = 4.0;
/// Time above which it is told beforehand \[s\].
const SLOW: f64 = 60.0;
/// The chains allow no conclusion.
const NO_CONCLUSION: u8 = 1;

pub(super) fn run(session: &Session, call: &QuestionCall) -> miette::Result<u8> {
    let question: CalibrateQuestion = of_keys(call.keys.clone().into())?;
    let path = call.folder("posterior");
    let (traffic, tables) = (question.traffic.as_deref(), &*question.tables);
    let plan = Measured { case: &question.plan, traffic, tables }.plan_for(&path)?;
    if question.dry_run {
        match call.json {
            true => print(&json(session.voice, &CalibrationPlan::from(&plan)))?,
            false => print(&dry_run(session, &plan)?)?,
        }
        session.print_remarks(&plan.remarks);
        return Ok(0);
    }
    check_files(session, &path, &FILES)?;
    let stop = session.interrupt.asks_work();
    let folder = Folder::begin(&plan, &path, question.restart)?;
    folder.write_plan(&plan)?;
    let sampler = &plan.file.sampler;
    on_threads(question.threads, || tell_plan(session, &plan))?;
    let begun = Instant::now();
    let sample = |folder: &Folder<'_>, _: &str| {
        let chains = sampler.chains;
        let progress = progress::Progress::counting(
            session.voice,
            riffel_keys::say!(progress_draws),
            chains * folder.draws_of_a_chain(),
        );
        let tell = |of: Progress| match of {
            Progress::Drawn(draws) => progress.advance(draws as usize),
            Progress::GoesOn { draws } => {
                progress.lengthen(chains * (sampler.left_out() + draws));
                session.voice.say(riffel_keys::say!(chains_go_on, draws));
            }
        };
        folder.run(&tell, &stop)
    };
    let stopped = || {
        session.voice.complain(riffel_keys::say!(calibration_stopped, folder = path.display().to_string()));
        Ok(INTERRUPTED)
    };
    let Some(chains) = on_threads(question.threads, || sample(&folder, ""))?? else {
        return stopped();
    };
    let models = match plan.compares() {
        false => None,
        true => {
            let to = (&*path, question.restart);
            let of_each = |folder: &Folder<'_>, title: &str| {
                if !title.is_empty() {
                    session.voice.say(riffel_keys::say!(chains_of_model, title));
                }
                sample(folder, title)
            };
            let work = || CompetingModels::new(&plan, &chains, to, &of_each);
            match on_threads(question.threads, work)?? {
                None => return stopped(),
                models => models,
            }
        }
    };
    let summary = chains.summary(&plan);
    // Whole before anything appears: a full disk leaves what was there.
    let results = folder.results(&plan, &chains, &summary)?;
    let told = Identifiability::of(&plan, &chains).map_err(CalibrationError::Refused)?;
    let answer = Calibration::new(&plan, &chains, &summary, &told);
    let conclusions = conclusions(session, &plan, &chains, &answer, models.as_ref(), &path)?;
    let names = results.publish()?;
    print(&match call.json {
        true => json(session.voice, &answer),
        false => format!("{conclusions}{}: {}\n", path.display(), names.join(" ")),
    })?;
    session.voice.say(riffel_keys::say!(sampled_in, time = number(duration(begun.elapsed().as_secs_f64()))));
    session.print_remarks(answer.remarks());
    session.print_remarks(models.as_ref().map_or(&[], Answer::remarks));
    session.print_remarks(&answer.untold);
    session.print_remarks(&answer.far_from_others);
    let doubts = answer.doubts.iter();
    doubts.for_each(|doubt| session.voice.complain(doubt.text(session.voice.language)));
    Ok(if answer.is_conclusive { 0 } else { NO_CONCLUSION })
}

/// Say how many draws there are to be, and how long they may take where that is longer than one waits without a word.
fn tell_plan(session: &Session, plan: &Plan) {
    let sampler = &plan.file.sampler;
    session.voice.say(riffel_keys::say!(
        chains_begin,
        chains = number(sampler.chains),
        warmup = number(sampler.left_out()),
        draws = number(sampler.draws),
        parameters = number(plan.posterior.parameters().len())
    ));
    if sampler.kind != SamplerKind::Nuts {
        return;
    }
    let parameters = plan.posterior.parameters().iter();
    let values: Vec<f64> = parameters.map(|it| it.prior.quantile(0.5)).collect();
    // The first fills tables.
    let mut seconds = 0.0;
    for _ in 0..2 {
        let begun = Instant::now();
        let _ = plan.posterior.log_likelihood(&values);
        seconds = begun.elapsed().as_secs_f64();
    }
    let at_once = sampler.chains.min(rayon::current_num_threads() as u64).max(1);
    let draws = sampler.chains * (sampler.left_out() + sampler.draws) / at_once;
    let whole = SETS_A_DRAW * seconds * draws as f64;
    if whole > SLOW {
        session.voice.say(riffel_keys::say!(
            chains_take,
            seconds = fixed(seconds, 3),
            minutes = fixed((whole / 60.0).ceil(), 0)
        ));
    }
}

/// Write what follows from the draws: what they tell of values together, where the plan has levels and the traffic says how much of
/// it there is, when the rail reaches its limit, and which models predict better; what is to be said of that.
fn conclusions(
    session: &Session,
    plan: &Plan,
    chains: &Chains,
    answer: &Calibration,
    models: Option<&CompetingModels>,
    folder: &Path,
) -> miette::Result<String> {
    let mut staging = Staging::new(session, "calibrate", folder)?;
    staging.write_figure(answer.name(), &answer.figure())?;
    let (mut text, mut tables) = (in_words(session.voice, answer), answer.tables());
    if plan.passages_per_day.is_some() && plan.has_levels() {
        let limit = level_limit(LIMIT)?;
        let answer = PosteriorForecast::new(plan, chains, &limit, MONTHS)?;
        staging.write_figure(answer.name(), &answer.figure())?;
        text += &in_words(session.voice, &answer);
        tables.extend(answer.tables());
    }
    if let Some(models) = models {
        staging.write_figure(models.name(), &models.figure())?;
        staging.write(models.document_name(), json(session.voice, models))?;
        text += &in_words(session.voice, models);
        tables.extend(models.tables());
    }
    for table in tables.into_iter().filter(Table::has_file) {
        staging.write_result(ResultFile::Table(table))?;
    }
    let names = staging.publish()?;
    Ok(format!("{text}{}: {}\n", folder.display(), names.join(" ")))
}

/// What a plan asks for.
fn dry_run(session: &Session, plan: &Plan) -> miette::Result<String> {
    let values = plan.posterior.parameters().iter().map(|parameter| {
        let touched = plan.posterior.data_of(&parameter.name);
        let data = match &touched[..] {
            [] => riffel_keys::say!(no_data),
            names => Message::verbatim(names.join(", ")),
        };
        data.about(parameter.name.as_str())
    });
    let sampler = &plan.file.sampler;
    let asked = riffel_keys::say!(
        plan_asks_for,
        data = number(plan.posterior.observed().iter().map(Vec::len).sum::<usize>()),
        chains = number(sampler.chains),
        warmup = number(sampler.left_out()),
        draws = number(sampler.draws)
    );
    let lines = values.chain(what_is_compared(plan)?).chain([asked]);
    Ok(lines.map(|line| line.text(session.voice.language) + "\n").collect())
}
