//! `riffel simulate --passages`

use std::fs;
use std::io;
use std::path::Path;
use std::time::{Duration, Instant};

use riffel_answers::forecast::{per_million, three_digits};
use riffel_answers::simulate::{EvolutionAnswer, EvolutionDocument, EvolutionRequest, EvolutionRun};
use riffel_case::Case;
use riffel_plot::html_of_stages;

use super::{results, without_contact};
use crate::arguments::Simulate;
use crate::error::CliError;
use crate::messages::{complain, print_remarks, say};
use crate::output::{Table, json, table};
use crate::progress::Progress;
use crate::staging::{Existing, INTERRUPTED, check_files, stop_on_interrupt, write_file};

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

/// Level below which nothing is told \[dB re 1 µm\]: ten picometres.
const NOTHING: f64 = -100.0;

/// Time from one state to the next.
const STATE_EVERY: Duration = Duration::from_secs(1);

/// The rail under many wheels, from where the folder has it on; returns the exit status.
pub(super) fn run(arguments: &Simulate, case: &Case, request: EvolutionRequest, passages: u64) -> Result<u8, CliError> {
    let mut run = EvolutionRun::new(case, request)?;
    let folder = arguments.case.folder(arguments.results.output.as_deref(), "simulate");
    let keeps = arguments.results.output.is_some() || !arguments.results.json;
    let state = keeps.then(|| folder.join(STATE));
    if let Some(path) = &state {
        check_files(&folder, &FILES)?;
        resume(&mut run, path, passages)?;
    }
    let stop = stop_on_interrupt();
    let progress = Progress::new(riffel_keys::say!(progress_passages), passages as usize);
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
            keep(&run, &folder, path)?;
            kept = Instant::now();
        }
        if asked {
            drop(progress);
            let passed = run.passages();
            complain(match &state {
                Some(path) => format!(
                    "stopped after {passed} of {passages} passages, which are kept in {}; the same command goes on from there",
                    path.display()
                ),
                None => format!("stopped after {passed} of {passages} passages"),
            });
            return Ok(INTERRUPTED);
        }
    };
    drop(progress);
    if let Some(path) = &state {
        keep(&run, &folder, path)?;
    }
    results(arguments).hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("spectrum", &answer.spectrum_figure(case))?;
            staging.write_figure("profile", &answer.profile_figure(case))?;
            staging.write("passages.html", passages_page(&answer, case)?)?;
            staging.write_with("bands.csv", |file| answer.bands_csv(file))?;
            staging.write_with("profile.csv", |file| answer.profiles_csv(file))?;
            answer.netcdf(&answer.title(case), &staging.path("evolution.nc"))?;
            staging.write("evolution.json", json(&answer.document()))
        },
        || readable(case, &answer),
    )?;
    print_remarks(&case.remarks);
    print_remarks(&answer.remarks);
    Ok(0)
}

/// Levels and profile with a slider over passages.
fn passages_page(answer: &EvolutionAnswer, case: &Case) -> Result<String, CliError> {
    let figures = answer.stage_figures(case);
    let stages = figures.iter().map(|(name, figure)| (name.as_str(), figure));
    Ok(html_of_stages(&stages.collect::<Vec<_>>())?)
}

/// Go on from the state in the folder, if there is one.
fn resume(run: &mut EvolutionRun, path: &Path, passages: u64) -> Result<(), CliError> {
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
    say(format_args!("going on after {} passages, from {}", run.passages(), path.display()));
    Ok(())
}

fn keep(run: &EvolutionRun, folder: &Path, path: &Path) -> Result<(), CliError> {
    fs::create_dir_all(folder).map_err(|reason| CliError::Write { path: folder.to_owned(), reason })?;
    write_file(path, &run.state(), Existing::Replace)
}

/// Bands for the terminal.
fn readable(case: &Case, answer: &EvolutionAnswer) -> String {
    let document = answer.document();
    let vehicles = vehicles(&document);
    let rows = bands(&document);
    let saturated = saturated(&document);
    let last = answer.stages.iter().rev().find_map(|stage| stage.extremes);
    let forces = last.map_or_else(String::new, |passage| {
        format!(
            "last normal force {:.2} to {:.2} kN; {}\n",
            1e-3 * passage.minimum_normal_force_n,
            1e-3 * passage.maximum_normal_force_n,
            without_contact(passage.contact_loss_fraction)
        )
    });
    let lifts = document.first_contact_loss_passages;
    let lifts = lifts.map_or_else(String::new, |passages| {
        format!("the wheel leaves the rail from {} passages on\n", three_digits(passages as f64))
    });
    let supports = document.stages.support_pattern_level_db.as_ref();
    let supports = supports.map_or_else(String::new, |levels| {
        let [first, last] = [levels[0], levels[levels.len() - 1]].map(|level| match level {
            level if level > NOTHING => format!("{level:.1} dB"),
            _ => "nothing".to_owned(),
        });
        format!("waves that fit between two supports: from {first} to {last}\n")
    });
    format!(
        "{}\n{} passages over {:.3} m at {:.1} km/h in steps of {:.3} mm\n{vehicles}{rows}\n{supports}{saturated}\n{lifts}{forces}worn off everywhere \
         {} µm\n",
        case.file.title.as_deref().unwrap_or("A rail under many wheels"),
        three_digits(document.passages as f64),
        document.length_m,
        3.6 * document.speed_m_per_s,
        1e3 * document.step_m,
        three_digits(1e6 * document.mean_depth_m),
    )
}

/// Level, growth and drift of each band.
fn bands(document: &EvolutionDocument) -> Table {
    let mut rows = table(&[
        "wavelength mm",
        "level dB",
        "at the end",
        "linear",
        "growth dB/10⁶",
        "linear",
        "last quarter",
        "drift mm/10⁶",
        "linear",
    ]);
    // Less is rounding, as of the harmonics of a sinusoid before any wheel.
    let is_something = |level: f64| level > NOTHING;
    let decibels = |level: f64| match is_something(level) {
        true => format!("{level:.1}"),
        false => String::new(),
    };
    let growth = |level: f64, rate: Option<f64>| match rate {
        Some(rate) if is_something(level) => format!("{:.2}", per_million(rate)),
        _ => String::new(),
    };
    // [m] in a passage are 10⁹ [mm] in a million.
    let drift = |level: f64, shift: Option<f64>| match shift {
        Some(shift) if is_something(level) => format!("{:.2}", 1e9 * shift),
        _ => String::new(),
    };
    for band in &document.bands {
        let last = band.level_db.len() - 1;
        let (first, end) = (band.level_db[0], band.level_db[last]);
        rows.add_row([
            format!("{:.1}", 1e3 * band.wavelength_m),
            decibels(band.level_db[0]),
            decibels(band.level_db[last]),
            decibels(band.linear_level_db[last]),
            growth(first, band.first_growth_per_passage),
            growth(first, band.first_linear_growth_per_passage),
            growth(end, band.last_growth_per_passage),
            drift(first, band.first_shift_m_per_passage),
            drift(first, Some(band.linear_shift_m_per_passage)),
        ]);
    }
    rows
}

/// The bands that have stopped growing.
fn saturated(document: &EvolutionDocument) -> String {
    let saturated: Vec<String> = document
        .bands
        .iter()
        .filter_map(|band| {
            let level = band.saturation_level_db?;
            Some(format!("{:.1} mm at {level:.1} dB", 1e3 * band.wavelength_m))
        })
        .collect();
    match saturated.is_empty() {
        true => "no band has stopped growing".to_owned(),
        false => format!("stopped growing: {}", saturated.join(", ")),
    }
}

/// A line for each vehicle, where there is more than one wheel at one speed.
fn vehicles(document: &EvolutionDocument) -> String {
    match &document.vehicles[..] {
        [one] if one.speeds == 1 => String::new(),
        vehicles => vehicles
            .iter()
            .map(|vehicle| {
                format!(
                    "  {:.1} %  {}, {:.1} ± {:.1} km/h\n",
                    100.0 * vehicle.share,
                    vehicle.name,
                    3.6 * vehicle.speed_m_per_s,
                    3.6 * vehicle.speed_deviation_m_per_s
                )
            })
            .collect(),
    }
}
