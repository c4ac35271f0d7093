//! `riffel study sensitivity`

mod document;
mod figure;

use std::path::Path;

use riffel_study::file::Method;
use riffel_study::sensitivity::{Bands, Intervals, SobolIndices, Tornado};
use riffel_study::{ResultFolder, Study, StudyError, Variable};

use self::document::Document;
use super::statistics::figures;
use crate::arguments::Sensitivity;
use crate::error::CliError;
use crate::messages::{complain, print_remarks};
use crate::output::{print, print_json, table};
use crate::staging::Staging;

/// The quantiles of the tornado.
const TORNADO: [f64; 2] = [0.1, 0.9];
/// The quantiles of the bands of growth.
const BANDS: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];
/// The output that the bands are of.
const CURVE: &str = "mean_growth_rate";
/// Outputs that are looked at only where they are asked for: places of the highest growth, not its size.
const ASIDE: [&str; 4] = [
    "highest_growth_wavelength",
    "highest_growth_speed",
    "highest_growth_frequency",
    "highest_growth_at_edge",
];

/// One output, and what matters for it.
struct Analysis<'a> {
    /// Name, with the band where it has several.
    name: String,
    variable: &'a Variable,
    /// Place of its number among those of a sample.
    place: usize,
    indices: Option<SobolIndices>,
}

pub(super) fn run(arguments: &Sensitivity) -> miette::Result<u8> {
    let confidence = arguments.confidence.si();
    if !(confidence > 0.0 && confidence < 1.0) {
        Err(CliError::Argument {
            argument: "--confidence",
            value: confidence.to_string(),
            rule: "between 0 and 1, both excluded".to_owned(),
        })?;
    }
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
    let is_saltelli = study.plan.file.design.method == Method::Saltelli;
    let mut notes = Vec::new();
    let mut analyses = chosen(&study, &arguments.results)?;
    if is_saltelli {
        let intervals = Intervals {
            confidence,
            ..Intervals::default()
        };
        for analysis in &mut analyses {
            let values = column(&study, &folder, analysis)?;
            match SobolIndices::new(&values, study.parameters().len(), intervals) {
                Ok(indices) => analysis.indices = Some(indices),
                Err(error) => notes.push(format!("{}: {error}", analysis.name)),
            }
        }
    } else {
        notes.push(format!(
            "Sobol indices need design.method = \"saltelli\"; this study has \"{}\"",
            study.plan.file.design.method.name()
        ));
    }
    let left_out = analyses
        .iter()
        .filter_map(|a| Some(a.indices.as_ref()?.left_out))
        .max();
    if let Some(count @ 1..) = left_out {
        notes.push(format!(
            "{count} base samples are left out: one of their rows has no results"
        ));
    }
    let tornado = Tornado::new(&study, TORNADO);
    let bands = bands(&study, &folder, is_saltelli)?;
    if bands.is_none() {
        notes.push(
            "bands of growth against wavelength need outputs.growth_by_wavelength".to_owned(),
        );
    }
    let document = Document::new(&study, &analyses, &tornado, bands.as_ref(), &notes);
    let to = match &arguments.output {
        None if arguments.json => None,
        None => Some(arguments.folder.as_path()),
        Some(to) => Some(to.as_path()),
    };
    let files = to
        .map(|to| write(to, &study, &analyses, &tornado, bands.as_ref(), &document))
        .transpose()?;
    if arguments.json {
        print_json(&document)?;
    } else {
        print(&readable(&study, &analyses, &tornado, confidence))?;
        if let (Some(to), Some(files)) = (to, files) {
            print(&format!("{}: {}\n", to.display(), files.join(" ")))?;
        }
    }
    print_remarks(&notes);
    Ok(0)
}

/// The outputs to look at: those asked for, or all that are one real number for each sample.
fn chosen<'a>(study: &'a Study, asked: &[String]) -> Result<Vec<Analysis<'a>>, StudyError> {
    let outputs = study.outputs();
    let known = || {
        outputs
            .variables()
            .iter()
            .map(|variable| variable.name.as_str())
    };
    if let Some(unknown) = asked
        .iter()
        .find(|name| !known().any(|known| known == *name))
    {
        let known: Vec<&str> = known().collect();
        return Err(StudyError::Analysis {
            message: format!("--result {unknown}: the study has {}", known.join(", ")),
        });
    }
    let mut analyses = Vec::new();
    let mut place = 0;
    for variable in outputs.variables() {
        let length = outputs.length(variable);
        let single = variable.dimensions.is_empty() && !variable.complex;
        let wanted = match asked.is_empty() {
            true => single && !ASIDE.contains(&variable.name.as_str()),
            false => asked.contains(&variable.name),
        };
        if wanted && (variable.complex || length > outputs.bands().len().max(1)) {
            return Err(StudyError::Analysis {
                message: format!(
                    "--result {}: only real numbers and bands are looked at; open the arrays in Python for more",
                    variable.name
                ),
            });
        }
        for index in 0..if wanted { length } else { 0 } {
            let name = match (single, outputs.bands().get(index)) {
                (false, Some(band)) => {
                    format!(
                        "{} {:.0}–{:.0} mm",
                        variable.name,
                        1e3 * band.from,
                        1e3 * band.to
                    )
                }
                _ => variable.name.clone(),
            };
            analyses.push(Analysis {
                name,
                variable,
                place: place + index,
                indices: None,
            });
        }
        place += length;
    }
    if analyses.is_empty() {
        return Err(StudyError::Analysis {
            message: "the study has no output that is one real number for each sample; name one by --result".to_owned(),
        });
    }
    Ok(analyses)
}

/// The number of an analysis in every sample.
fn column(
    study: &Study,
    folder: &ResultFolder,
    analysis: &Analysis<'_>,
) -> Result<Vec<f64>, StudyError> {
    let width = study.outputs().length(analysis.variable);
    let before: usize = study
        .outputs()
        .variables()
        .iter()
        .take_while(|variable| *variable != analysis.variable)
        .map(|variable| study.outputs().length(variable))
        .sum();
    let values = folder.output(&analysis.variable.name)?;
    Ok(values
        .into_iter()
        .skip(analysis.place - before)
        .step_by(width)
        .collect())
}

/// Quantiles of growth against wavelength; of a cross sample those of its first matrix, which is a sample.
fn bands(
    study: &Study,
    folder: &ResultFolder,
    is_saltelli: bool,
) -> Result<Option<Bands>, StudyError> {
    let outputs = study.outputs();
    if !outputs
        .variables()
        .iter()
        .any(|variable| variable.name == CURVE)
    {
        return Ok(None);
    }
    let width = outputs.wavelengths().len();
    let mut values = folder.output(CURVE)?;
    if is_saltelli {
        let rows = study.parameters().len() + 2;
        let first = values.chunks_exact(width).step_by(rows);
        values = first.flatten().copied().collect();
    }
    Ok(Some(Bands::new(&values, width, &BANDS)))
}

fn write(
    to: &Path,
    study: &Study,
    analyses: &[Analysis<'_>],
    tornado: &Tornado,
    bands: Option<&Bands>,
    document: &Document<'_>,
) -> Result<Vec<String>, CliError> {
    let mut staging = Staging::new("study sensitivity", to)?;
    if analyses.iter().any(|analysis| analysis.indices.is_some()) {
        staging.write_picture("sobol-indices", &figure::indices(study, analyses).svg()?)?;
    }
    if let Some(figure) = figure::tornado(study, analyses, tornado) {
        staging.write_picture("tornado", &figure.svg()?)?;
    }
    if let Some(bands) = bands {
        staging.write_figure("growth-bands", &figure::bands(study, bands))?;
    }
    staging.write("sensitivity.json", crate::output::json(document))?;
    staging.publish()
}

fn readable(
    study: &Study,
    analyses: &[Analysis<'_>],
    tornado: &Tornado,
    confidence: f64,
) -> String {
    let mut text = study
        .plan
        .file
        .title
        .clone()
        .unwrap_or_else(|| "Study".to_owned());
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
            Ok(values) => figures(values[analysis.place]),
            Err(_) => "fails".to_owned(),
        };
        let title = format!("{} alone", analysis.name);
        let mut rows = table(&[&title, "10 %", "90 %", "at 10 %", "at 90 %"]);
        for (parameter, swing) in study.parameters().iter().zip(&tornado.swings) {
            let [low, high] = swing
                .values
                .each_ref()
                .map(|value| document::with_unit(parameter, value));
            rows.add_row([
                parameter.key.key.clone(),
                low,
                high,
                at(&swing.outputs[0]),
                at(&swing.outputs[1]),
            ]);
        }
        text.push_str(&format!(
            "{rows}\nat all medians: {}\n",
            at(&tornado.middle)
        ));
    }
    text
}
