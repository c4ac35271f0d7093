//! What matters in a study, and how sure it is.

mod document;
mod figure;
mod statistics;

use riffel_keys::range;
use riffel_plot::{BarFigure, LineFigure};
use riffel_study::file::Method;
use riffel_study::sensitivity::{Bands, Intervals, SobolIndices, Tornado};
use riffel_study::{ResultFolder, Study, StudyError, Variable};

pub use document::{SensitivityDocument, with_unit};
pub use statistics::{Statistics, four_figures};

/// The quantiles of the tornado.
const TORNADO: [f64; 2] = [0.1, 0.9];
/// The quantiles of the bands of growth.
const BANDS: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];
/// The output that the bands are of.
const CURVE: &str = "mean_growth_rate";
/// Outputs that are looked at only where they are asked for: places of the highest growth, not its size.
const ASIDE: [&str; 4] =
    ["highest_growth_wavelength", "highest_growth_speed", "highest_growth_frequency", "highest_growth_at_edge"];

/// One output, and what matters for it.
pub struct Analysis<'a> {
    /// Name, with the band where it has several.
    pub name: String,
    /// The output.
    pub variable: &'a Variable,
    /// Place of its number among those of a sample.
    pub place: usize,
    /// Sobol indices, where the design gives them.
    pub indices: Option<SobolIndices>,
}

/// What is asked of a finished study.
#[derive(Debug, Clone)]
pub struct SensitivityRequest {
    /// Outputs to look at; all that are one real number for each sample where none is named.
    pub results: Vec<String>,
    /// Confidence of the intervals, between 0 and 1, both excluded.
    pub confidence: f64,
}

/// What matters in a study.
pub struct SensitivityAnswer<'a> {
    study: &'a Study,
    /// The outputs, each with what matters for it.
    pub analyses: Vec<Analysis<'a>>,
    /// Each parameter alone.
    pub tornado: Tornado,
    /// Quantiles of growth against wavelength, where the study has it.
    pub bands: Option<Bands>,
    /// What the reader should know.
    pub notes: Vec<String>,
}

impl<'a> SensitivityAnswer<'a> {
    /// What matters in a study whose samples are all computed.
    ///
    /// # Errors
    /// [`StudyError::Analysis`] for a confidence out of its range, for an output that is not there or cannot be looked at,
    /// and for results that cannot be read.
    pub fn new(study: &'a Study, folder: &ResultFolder, request: &SensitivityRequest) -> Result<Self, StudyError> {
        let confidence = request.confidence;
        if !(confidence > 0.0 && confidence < 1.0) {
            return Err(StudyError::Analysis {
                message: format!("--confidence is {confidence}, but must be between 0 and 1, both excluded"),
            });
        }
        let is_saltelli = study.plan.file.design.method == Method::Saltelli;
        let mut notes = Vec::new();
        let mut analyses = chosen(study, &request.results)?;
        if is_saltelli {
            let intervals = Intervals { confidence, ..Intervals::default() };
            for analysis in &mut analyses {
                let values = column(study, folder, analysis)?;
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
        let left_out = analyses.iter().filter_map(|a| Some(a.indices.as_ref()?.left_out)).max();
        if let Some(count @ 1..) = left_out {
            notes.push(format!("{count} base samples are left out: one of their rows has no results"));
        }
        let tornado = Tornado::new(study, TORNADO);
        let bands = bands(study, folder, is_saltelli)?;
        if bands.is_none() {
            notes.push("bands of growth against wavelength need outputs.growth_by_wavelength".to_owned());
        }
        Ok(Self { study, analyses, tornado, bands, notes })
    }

    /// What matters as data: what `riffel study sensitivity --json` prints.
    pub fn document(&self) -> SensitivityDocument<'_> {
        SensitivityDocument::new(self.study, &self.analyses, &self.tornado, self.bands.as_ref(), &self.notes)
    }

    /// Sobol indices; none where the design does not give them.
    pub fn indices_figure(&self) -> Option<BarFigure> {
        let mut analyses = self.analyses.iter();
        analyses.any(|analysis| analysis.indices.is_some()).then(|| figure::indices(self.study, &self.analyses))
    }

    /// Each parameter alone; none if the medians fail.
    pub fn tornado_figure(&self) -> Option<BarFigure> {
        figure::tornado(self.study, &self.analyses, &self.tornado)
    }

    /// Growth against wavelength over the samples.
    pub fn bands_figure(&self) -> Option<LineFigure> {
        let bands = self.bands.as_ref()?;
        Some(figure::bands(self.study, bands))
    }
}

/// The outputs to look at: those asked for, or all that are one real number for each sample.
fn chosen<'a>(study: &'a Study, asked: &[String]) -> Result<Vec<Analysis<'a>>, StudyError> {
    let outputs = study.outputs();
    let known = || outputs.variables().iter().map(|variable| variable.name.as_str());
    if let Some(unknown) = asked.iter().find(|name| !known().any(|known| known == *name)) {
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
                    let ends = range([band.from, band.to], |end| format!("{:.0}", 1e3 * end));
                    format!("{} {ends} mm", variable.name)
                }
                _ => variable.name.clone(),
            };
            analyses.push(Analysis { name, variable, place: place + index, indices: None });
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
fn column(study: &Study, folder: &ResultFolder, analysis: &Analysis<'_>) -> Result<Vec<f64>, StudyError> {
    let width = study.outputs().length(analysis.variable);
    let before: usize = study
        .outputs()
        .variables()
        .iter()
        .take_while(|variable| *variable != analysis.variable)
        .map(|variable| study.outputs().length(variable))
        .sum();
    let values = folder.output(&analysis.variable.name)?;
    Ok(values.into_iter().skip(analysis.place - before).step_by(width).collect())
}

/// Quantiles of growth against wavelength; of a cross sample those of its first matrix, which is a sample.
fn bands(study: &Study, folder: &ResultFolder, is_saltelli: bool) -> Result<Option<Bands>, StudyError> {
    let outputs = study.outputs();
    if !outputs.variables().iter().any(|variable| variable.name == CURVE) {
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
