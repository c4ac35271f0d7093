//! `riffel calibrate PLAN`

use std::path::{Path, PathBuf};
use std::time::Instant;

use riffel_answers::calibrate::{close_pairs, correlations, directions, figure, log_evidence};
use riffel_answers::competing_models::{CompetingModels, what_is_compared};
use riffel_answers::forecast::PosteriorForecast;
use riffel_answers::{Answer, Calibration, PlanDocument, four_digits, level_limit};
use riffel_calibrate::file::SamplerKind;
use riffel_calibrate::{CalibrationError, Chains, Folder, Identifiability, Measured, Plan, Progress, Summary};
use riffel_keys::fixed;

use super::LIMIT;
use crate::arguments::{CalibrateChains, stem};
use crate::messages::{complain, language, print_remarks, say};
use crate::output::{json, print, table, table_of};
use crate::progress::{self, duration};
use crate::results::readable;
use crate::staging::{INTERRUPTED, Staging, check_files, stop_on_interrupt};
use crate::threads::on_threads;

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

pub(super) fn run(arguments: &CalibrateChains) -> miette::Result<u8> {
    let named = arguments.plan.as_deref().unwrap_or(Path::new(""));
    let path = arguments.output.clone();
    let path = path.unwrap_or_else(|| PathBuf::from(format!("{}-posterior", stem(named))));
    let measured = Measured { case: named, traffic: arguments.traffic.as_deref(), tables: &arguments.tables };
    let plan = measured.plan_for(&path)?;
    if arguments.dry_run {
        match arguments.json {
            true => print(&json(&PlanDocument::from(&plan)))?,
            false => print(&dry_run(&plan)?)?,
        }
        print_remarks(&plan.remarks);
        return Ok(0);
    }
    check_files(&path, &FILES)?;
    let stop = stop_on_interrupt();
    let folder = Folder::begin(&plan, &path, arguments.restart)?;
    folder.write_plan(&plan)?;
    let sampler = &plan.file.sampler;
    on_threads(arguments.threads, || tell_plan(&plan))?;
    let begun = Instant::now();
    let sample = |folder: &Folder<'_>, _: &str| {
        let chains = sampler.chains;
        let progress =
            progress::Progress::counting(riffel_keys::say!(progress_draws), chains * folder.draws_of_a_chain());
        let tell = |of: Progress| match of {
            Progress::Drawn(draws) => progress.advance(draws as usize),
            Progress::GoesOn { draws } => {
                progress.lengthen(chains * (sampler.left_out() + draws));
                say(riffel_keys::say!(chains_go_on, draws = draws));
            }
        };
        folder.run(&tell, &stop)
    };
    let stopped = || {
        complain(format_args!(
            "stopped: finished parts of the chains are kept in {}; the same command with --restart goes on from there",
            path.display()
        ));
        Ok(INTERRUPTED)
    };
    let Some(chains) = on_threads(arguments.threads, || sample(&folder, ""))?? else {
        return stopped();
    };
    let models = match plan.compares() {
        false => None,
        true => {
            let to = (&*path, arguments.restart);
            let of_each = |folder: &Folder<'_>, title: &str| {
                if !title.is_empty() {
                    say(format_args!("chains of \"{title}\""));
                }
                sample(folder, title)
            };
            let work = || CompetingModels::new(&plan, &chains, to, &of_each);
            match on_threads(arguments.threads, work)?? {
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
    let conclusions = conclusions(&plan, &chains, (&summary, &told), models.as_ref(), &path)?;
    let names = results.publish()?;
    let title = plan.file.title.as_deref().unwrap_or("Calibration");
    print(&match arguments.json {
        true => json(&answer),
        false => format!("{title}\n{}{conclusions}{}: {}\n", marginals(&summary), path.display(), names.join(" ")),
    })?;
    say(format_args!("sampled in {}", duration(begun.elapsed().as_secs_f64())));
    print_remarks(&plan.remarks);
    print_remarks(models.as_ref().map_or(&[], Answer::remarks));
    print_remarks(&answer.untold);
    print_remarks(&answer.far_from_others);
    let doubts = answer.doubts.iter();
    doubts.for_each(|doubt| complain(doubt.text(language())));
    Ok(if answer.is_conclusive { 0 } else { NO_CONCLUSION })
}

/// Say how many draws there are to be, and how long they may take where that is longer than one waits without a word.
fn tell_plan(plan: &Plan) {
    let sampler = &plan.file.sampler;
    say(format_args!(
        "{} chains of {} + {} draws of {} parameters",
        sampler.chains,
        sampler.left_out(),
        sampler.draws,
        plan.posterior.parameters().len()
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
        say(riffel_keys::say!(chains_take, seconds = fixed(seconds, 3), minutes = fixed((whole / 60.0).ceil(), 0)));
    }
}

/// Write what follows from the draws: what they tell of values together, where the plan has levels and the traffic says how much of
/// it there is, when the rail reaches its limit, and which models predict better; what is to be said of that.
fn conclusions(
    plan: &Plan,
    chains: &Chains,
    (summary, told): (&Summary, &Identifiability),
    models: Option<&CompetingModels>,
    folder: &Path,
) -> miette::Result<String> {
    let mut staging = Staging::new("calibrate", folder)?;
    let directions = directions(told);
    let mut text = format!("{}\n", table_of(&directions));
    for sentence in close_pairs(told).into_iter().chain(log_evidence(chains)) {
        text += &format!("{}\n", sentence.text(language()));
    }
    let mut tables = vec![directions, correlations(told)];
    staging.write_figure("posterior", &figure(plan, chains, summary, told))?;
    if plan.passages_per_day.is_some() && plan.has_levels() {
        let limit = level_limit(LIMIT)?;
        let answer = PosteriorForecast::new(plan, chains, &limit, MONTHS)?;
        staging.write_figure(answer.name(), &answer.figure())?;
        text += &readable(&answer);
        tables.extend(answer.tables());
    }
    if let Some(models) = models {
        staging.write_figure(models.name(), &models.figure())?;
        staging.write("models.json", json(models))?;
        text += &readable(models);
        tables.extend(models.tables());
    }
    for table in &tables {
        staging.write_with(&format!("{}.csv", table.name), |file| table.csv(file))?;
    }
    let names = staging.publish()?;
    Ok(format!("{text}{}: {}\n", folder.display(), names.join(" ")))
}

/// What a plan asks for.
fn dry_run(plan: &Plan) -> miette::Result<String> {
    let mut text = String::new();
    for parameter in plan.posterior.parameters() {
        let touched = plan.posterior.data_of(&parameter.name);
        let data = match &touched[..] {
            [] => "no data".to_owned(),
            names => names.join(", "),
        };
        text += &format!("{}: {data}\n", parameter.name);
    }
    for message in what_is_compared(plan)? {
        text += &format!("{}\n", message.text(language()));
    }
    Ok(text
        + &format!(
            "{} data, {} chains of {} + {} draws\n",
            plan.posterior.observed().iter().map(Vec::len).sum::<usize>(),
            plan.file.sampler.chains,
            plan.file.sampler.left_out(),
            plan.file.sampler.draws
        ))
}

/// What the data say of each parameter.
fn marginals(summary: &Summary) -> String {
    let mut rows = table(&["", "median", "5 %", "95 %", "R̂", "told by data", "unit"]);
    for marginal in &summary.marginals {
        let [low, _, middle, _, high] = marginal.quantiles;
        rows.add_row([
            marginal.name.clone(),
            four_digits(middle),
            four_digits(low),
            four_digits(high),
            format!("{:.3}", marginal.rhat),
            format!("{:.0} %", 100.0 * marginal.contraction.max(0.0)),
            marginal.unit.clone(),
        ]);
    }
    format!("{rows}\n")
}
