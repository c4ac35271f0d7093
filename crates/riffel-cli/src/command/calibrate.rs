//! `riffel calibrate`

use std::path::PathBuf;
use std::time::Instant;

use riffel_calibrate::{Folder, Marginal, Plan, Summary, TOLD};

use super::study::progress::{SampleProgress, duration};
use crate::arguments::{Calibrate, stem};
use crate::messages::{complain, print_remarks, say};
use crate::output::print;
use crate::staging::{INTERRUPTED, stop_on_interrupt};

/// The chains allow no conclusion.
const NO_CONCLUSION: u8 = 1;

pub(crate) fn run(arguments: &Calibrate) -> miette::Result<u8> {
    let plan = Plan::read(&arguments.plan)?;
    if arguments.dry_run {
        print(&dry_run(&plan))?;
        print_remarks(&plan.remarks);
        return Ok(0);
    }
    let path = arguments.output.clone();
    let path =
        path.unwrap_or_else(|| PathBuf::from(format!("{}-posterior", stem(&arguments.plan))));
    let stop = stop_on_interrupt();
    let folder = Folder::begin(&plan, &path, arguments.restart)?;
    let sampler = &plan.file.sampler;
    say(format_args!(
        "{} chains of {} + {} draws of {} parameters",
        sampler.chains,
        sampler.warmup,
        sampler.draws,
        plan.posterior.parameters().len()
    ));
    let begun = Instant::now();
    let progress = SampleProgress::new("draws", sampler.chains * folder.draws_of_a_chain());
    let work = || folder.run(&|draws| progress.advance_by(draws), &stop);
    let chains = match arguments.threads {
        None => work(),
        Some(threads) => rayon::ThreadPoolBuilder::new()
            .num_threads(threads.into())
            .build()
            .map_err(|error| miette::miette!("cannot start {threads} threads: {error}"))?
            .install(work),
    };
    drop(progress);
    let Some(chains) = chains? else {
        complain(format_args!(
            "stopped: finished parts of the chains are kept in {}; the same command with --restart goes on from there",
            path.display()
        ));
        return Ok(INTERRUPTED);
    };
    let summary = chains.summary(&plan);
    let names = folder.write(&plan, &chains, &summary)?;
    let title = plan.file.title.as_deref().unwrap_or("Calibration");
    print(&format!(
        "{title}\n{}{}: {}\n",
        table(&summary),
        path.display(),
        names.join(" ")
    ))?;
    say(format_args!(
        "sampled in {}",
        duration(begun.elapsed().as_secs_f64())
    ));
    print_remarks(&plan.remarks);
    print_remarks(&untold(&summary));
    let doubts = summary.doubts();
    doubts.iter().map(String::as_str).for_each(complain);
    Ok(if doubts.is_empty() { 0 } else { NO_CONCLUSION })
}

/// What a plan asks for.
fn dry_run(plan: &Plan) -> String {
    let mut text = String::new();
    for parameter in plan.posterior.parameters() {
        let touched = plan.posterior.data_of(&parameter.name);
        let data = match &touched[..] {
            [] => "no data".to_owned(),
            names => names.join(", "),
        };
        text += &format!("{}: {data}\n", parameter.name);
    }
    text + &format!(
        "{} data, {} chains of {} + {} draws\n",
        plan.posterior
            .observed()
            .iter()
            .map(Vec::len)
            .sum::<usize>(),
        plan.file.sampler.chains,
        plan.file.sampler.warmup,
        plan.file.sampler.draws
    )
}

/// What the data say of each parameter.
fn table(summary: &Summary) -> String {
    let width = summary
        .marginals
        .iter()
        .map(|it| it.name.chars().count())
        .max()
        .unwrap_or(0);
    let heads = ["median", "90 %", "R̂"];
    let mut text = format!(
        "  {:width$}  {:>11}  {:>23}  {:>6}",
        "", heads[0], heads[1], heads[2]
    );
    text += "  told\n";
    for marginal in &summary.marginals {
        let [low, _, middle, _, high] = marginal.quantiles;
        text += &format!(
            "  {:width$}  {:>11}  {:>11} {:>11}  {:>6.3}  {:>3.0} %  {}\n",
            marginal.name,
            four(middle),
            four(low),
            four(high),
            marginal.rhat,
            100.0 * marginal.contraction.max(0.0),
            marginal.unit
        );
    }
    text
}

/// A number with four digits.
fn four(number: f64) -> String {
    match number.abs() {
        size if (0.01..1e5).contains(&size) => {
            let decimals = (3 - size.log10().floor() as i32).clamp(0, 6);
            format!("{number:.*}", decimals as usize)
        }
        _ => format!("{number:.3e}"),
    }
}

/// What the data do not tell.
fn untold(summary: &Summary) -> Vec<String> {
    let untold =
        |marginal: &&Marginal| marginal.contraction.is_nan() || marginal.contraction < TOLD;
    let untold = summary.marginals.iter().filter(untold).map(|marginal| {
        let [low, .., high] = marginal.prior_quantiles;
        format!(
            "{} is not told by these data: 90 % of its prior lie between {} and {} {}",
            marginal.name,
            four(low),
            four(high),
            marginal.unit
        )
    });
    untold.collect()
}
