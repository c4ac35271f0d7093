//! `riffel axlebox`

use std::path::PathBuf;

use riffel_answers::axlebox::{AxleBoxAnswer, AxleBoxRail};
use riffel_rail::AxleBoxFile;

use super::roughness::{bands_table, grind_table, limits};
use crate::arguments::{AxleBox, stem};
use crate::messages::{language, print_remarks};
use crate::output::{json, print, table};
use crate::progress::Progress;
use crate::staging::Staging;

pub(crate) fn run(arguments: &AxleBox) -> miette::Result<()> {
    let (layout, request) = (arguments.layout()?, arguments.request()?);
    let limits = limits(&arguments.limit)?;
    let case = arguments.case().read()?;
    let mut files = Vec::new();
    for path in &arguments.paths {
        files.push((path.clone(), AxleBoxFile::open(path, &layout)?));
    }
    let sizes = arguments.paths.iter().filter_map(|path| std::fs::metadata(path).ok());
    let size: u64 = sizes.map(|file| file.len()).sum();
    let progress = Progress::new(riffel_keys::say!(progress_listening), size as usize);
    let answer = AxleBoxAnswer::new(&case, &files, &limits, &request, &|by| progress.advance(by))?;
    drop(progress);
    let document = json(&answer.document());
    if arguments.results.json {
        print(&document)?;
    }
    if !arguments.results.json || arguments.results.output.is_some() {
        let folder = arguments.results.output.clone().unwrap_or_else(|| folder(&arguments.paths));
        let mut staging = Staging::new("axlebox", &folder)?;
        staging.write_figure("axlebox", &answer.figure(&case, &limits))?;
        staging.write_with("spectrum.csv", |file| answer.spectrum_csv(file))?;
        staging.write_with("pads.csv", |file| answer.pads_csv(file))?;
        staging.write_with("blocks.csv", |file| answer.block_csv(file))?;
        staging.write_with("grind.csv", |file| answer.grind_csv(file))?;
        staging.write("summary.json", document)?;
        let files = staging.publish()?.join(" ");
        if !arguments.results.json {
            print(&format!("{}{}: {files}\n", readable(&answer), folder.display()))?;
        }
    }
    print_remarks(&answer.remarks);
    print_remarks(&case.remarks);
    Ok(())
}

/// The folder named after the first file.
fn folder(paths: &[PathBuf]) -> PathBuf {
    let first = paths.first().map_or_else(String::new, |path| stem(path));
    PathBuf::from(format!("{first}-axlebox"))
}

/// What was computed, for the terminal.
fn readable(answer: &AxleBoxAnswer) -> String {
    let mut text = String::new();
    for rail in &answer.rails {
        text += &format!("{}\n", heard(rail));
    }
    let mut rows = table(&["rail", "wavelength mm", "level dB re 1 µm", "with pads of half to twice the stiffness"]);
    for rail in &answer.rails {
        for level in &rail.levels {
            let [low, high] = level.range;
            rows.add_row([
                rail.rail.name.clone(),
                format!("{}", level.band.nominal_millimetres()),
                format!("{:.1}", level.level),
                format!("{low:.1} to {high:.1}"),
            ]);
        }
    }
    text += &format!("{rows}\n");
    text += &bands_table(answer.rails.iter().map(|rail| &rail.rail));
    for verdict in answer.rails.iter().flat_map(|rail| &rail.rail.verdicts) {
        text += &format!("{}\n", verdict.sentence.text(language()));
    }
    text + &grind_in_words(answer)
}

/// Where a rail was heard, and how fast the train was.
fn heard(rail: &AxleBoxRail) -> String {
    let analysis = &rail.rail.analysis;
    let [slowest, _, fastest] = rail.speeds.map(|speed| 3.6 * speed);
    format!(
        "{}: {:.1} m of rail at {slowest:.0} to {fastest:.0} km/h, wavelengths of {:.1} to {:.0} mm",
        rail.rail.name,
        analysis.length(),
        1e3 * rail.known.from(),
        1e3 * rail.known.to(),
    )
}

fn grind_in_words(answer: &AxleBoxAnswer) -> String {
    let sections = answer.rails.iter().flat_map(|rail| {
        let own = rail.rail.sections.iter();
        own.map(move |section| (&rail.rail, section))
    });
    let sections: Vec<_> = sections.collect();
    if sections.is_empty() {
        return String::new();
    }
    let (rows, more) = grind_table(&sections);
    let more = more.map_or_else(String::new, |more| format!("{more}\n"));
    format!("{rows}\n{more}")
}
