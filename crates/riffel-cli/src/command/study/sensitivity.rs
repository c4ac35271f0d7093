//! `riffel study sensitivity`

use std::path::Path;

use riffel_answers::study::{SensitivityAnswer, SensitivityDocument, SensitivityRequest, four_figures, with_unit};
use riffel_study::{ResultFolder, Study};

use crate::arguments::Sensitivity;
use crate::error::CliError;
use crate::messages::{complain, print_remarks};
use crate::output::{print, print_json, table};
use crate::staging::Staging;

pub(super) fn run(arguments: &Sensitivity) -> miette::Result<u8> {
    let (study, folder) = ResultFolder::open(&arguments.folder)?;
    let summary = folder.summary()?;
    if summary.chunks_finished < summary.chunks {
        let folder = arguments.folder.display();
        complain(format_args!(
            "note: nothing is analysed, for {folder} is not finished: {} of {} chunks are missing; \
             riffel study PLAN -o {folder} computes them, riffel study merge brings shards together",
            summary.chunks - summary.chunks_finished,
            summary.chunks,
        ));
        return Ok(1);
    }
    let confidence = arguments.confidence.si();
    let request = SensitivityRequest { results: arguments.results.clone(), confidence };
    let answer = SensitivityAnswer::new(&study, &folder, &request)?;
    let document = answer.document();
    let to = match &arguments.output {
        None if arguments.json => None,
        None => Some(arguments.folder.as_path()),
        Some(to) => Some(to.as_path()),
    };
    let files = to.map(|to| write(to, &answer, &document)).transpose()?;
    if arguments.json {
        print_json(&document)?;
    } else {
        print(&readable(&study, &answer, confidence))?;
        if let (Some(to), Some(files)) = (to, files) {
            print(&format!("{}: {}\n", to.display(), files.join(" ")))?;
        }
    }
    print_remarks(&answer.notes);
    Ok(0)
}

fn write(
    to: &Path,
    answer: &SensitivityAnswer<'_>,
    document: &SensitivityDocument<'_>,
) -> Result<Vec<String>, CliError> {
    let mut staging = Staging::new("study sensitivity", to)?;
    if let Some(figure) = answer.indices_figure() {
        staging.write_picture("sobol-indices", &figure.picture()?)?;
    }
    if let Some(figure) = answer.tornado_figure() {
        staging.write_picture("tornado", &figure.picture()?)?;
    }
    if let Some(figure) = answer.bands_figure() {
        staging.write_figure("growth-bands", &figure)?;
    }
    staging.write("sensitivity.json", crate::output::json(document))?;
    staging.publish()
}

fn readable(study: &Study, answer: &SensitivityAnswer<'_>, confidence: f64) -> String {
    let SensitivityAnswer { analyses, tornado, .. } = answer;
    let mut text = study.plan.file.title.clone().unwrap_or_else(|| "Study".to_owned());
    text.push('\n');
    for analysis in analyses {
        if let Some(indices) = &analysis.indices {
            let interval = format!("{:.4} % interval", 100.0 * confidence).replace(".0000", "");
            let mut rows = table(&[&analysis.name, "first order", &interval, "total", &interval]);
            for (parameter, found) in study.parameters().iter().zip(&indices.parameters) {
                let [first, total] = [found.first, found.total];
                rows.add_row([
                    parameter.key.key.clone(),
                    format!("{:.3}", first.value),
                    format!("{:.3} to {:.3}", first.low, first.high),
                    format!("{:.3}", total.value),
                    format!("{:.3} to {:.3}", total.low, total.high),
                ]);
            }
            text.push_str(&format!("{rows}\n"));
        }
    }
    for analysis in analyses {
        let at = |outputs: &Result<Vec<f64>, String>| match outputs {
            Ok(values) => four_figures(values[analysis.place]),
            Err(_) => "fails".to_owned(),
        };
        let title = format!("{} alone", analysis.name);
        let mut rows = table(&[&title, "10 %", "90 %", "at 10 %", "at 90 %"]);
        for (parameter, swing) in study.parameters().iter().zip(&tornado.swings) {
            let [low, high] = swing.values.each_ref().map(|value| with_unit(parameter, value));
            rows.add_row([parameter.key.key.clone(), low, high, at(&swing.outputs[0]), at(&swing.outputs[1])]);
        }
        text.push_str(&format!("{rows}\nat all medians: {}\n", at(&tornado.middle)));
    }
    text
}
