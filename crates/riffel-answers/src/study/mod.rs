//! What matters in a study, and how sure it is.

mod computed;
mod documents;
mod figure;
mod merged;
mod question;
mod statistics;
mod tables;

use riffel_keys::{Message, range, say};
use riffel_plot::{BarFigure, LineFigure};
use riffel_study::file::Method;
use riffel_study::sensitivity::{Bands, Intervals, SobolIndices, Tornado};
use riffel_study::{ResultFolder, Study, StudyError, Variable};
use serde::Serialize;

use crate::{Answer, Printed, ResultFile};
pub use computed::StudyAnswer;
use computed::failures;
use documents::{GrowthBands, ParameterEffect};
pub use merged::MergeAnswer;
pub use question::{MergeQuestion, Part, SensitivityQuestion, StudyQuestion};
use statistics::four_figures;

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
#[derive(Serialize)]
pub struct Analysis {
    /// Name, with the band where it has several.
    pub name: String,
    unit: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    variance: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    base_samples: Option<usize>,
    /// With every parameter at its median.
    at_medians: Option<f64>,
    parameters: Vec<ParameterEffect>,
    /// The output.
    #[serde(skip)]
    pub variable: Variable,
    /// Place of its number among those of a sample.
    #[serde(skip)]
    pub place: usize,
    /// Sobol indices, where the design gives them.
    #[serde(skip)]
    pub indices: Option<SobolIndices>,
}

impl Analysis {
    /// Tell what its indices and the swings of the parameters say.
    fn tell(&mut self, study: &Study, tornado: &Tornado) {
        let at = |outputs: &Result<Vec<f64>, String>| outputs.as_ref().ok().map(|values| values[self.place]);
        let indices = self.indices.as_ref();
        let parameters = study.parameters().iter().zip(&tornado.swings).enumerate();
        let parameters = parameters.map(|(index, (parameter, swing))| ParameterEffect {
            key: parameter.key.key.clone(),
            first_order: indices.map(|found| found.parameters[index].first.into()),
            total: indices.map(|found| found.parameters[index].total.into()),
            low: swing.values[0].clone(),
            high: swing.values[1].clone(),
            at_low: at(&swing.outputs[0]),
            at_high: at(&swing.outputs[1]),
        });
        let parameters = parameters.collect();
        self.at_medians = at(&tornado.middle);
        self.variance = indices.map(|indices| indices.variance);
        self.base_samples = indices.map(|indices| indices.base_samples);
        self.parameters = parameters;
    }
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
#[derive(Serialize)]
pub struct SensitivityAnswer {
    title: Option<String>,
    fingerprint: String,
    samples: u64,
    /// The outputs, each with what matters for it.
    #[serde(rename = "outputs")]
    pub analyses: Vec<Analysis>,
    #[serde(skip_serializing_if = "Option::is_none")]
    growth_bands: Option<GrowthBands>,
    /// What the reader should know.
    pub notes: Vec<Message>,
    #[serde(skip)]
    study: Study,
    /// Each parameter alone.
    #[serde(skip)]
    pub tornado: Tornado,
    /// Quantiles of growth against wavelength, where the study has it.
    #[serde(skip)]
    pub bands: Option<Bands>,
    #[serde(skip)]
    confidence: f64,
}

impl SensitivityAnswer {
    /// What matters in a study whose samples are all computed.
    ///
    /// # Errors
    /// [`StudyError::Analysis`] for a confidence out of its range, for an output that is not there or cannot be looked at,
    /// and for results that cannot be read.
    pub fn new(study: Study, folder: &ResultFolder, request: &SensitivityRequest) -> Result<Self, StudyError> {
        let confidence = request.confidence;
        if !(confidence > 0.0 && confidence < 1.0) {
            return Err(StudyError::Analysis {
                message: format!("--confidence is {confidence}, but must be between 0 and 1, both excluded"),
            });
        }
        let is_saltelli = study.plan.file.design.method == Method::Saltelli;
        let mut notes = Vec::new();
        let mut analyses = chosen(&study, &request.results)?;
        if is_saltelli {
            let intervals = Intervals { confidence, ..Intervals::default() };
            for analysis in &mut analyses {
                let values = column(&study, folder, analysis)?;
                match SobolIndices::new(&values, study.parameters().len(), intervals) {
                    Ok(indices) => analysis.indices = Some(indices),
                    Err(error) => notes.push(Message::verbatim(error.to_string()).about(analysis.name.as_str())),
                }
            }
        } else {
            notes.push(say!(sobol_indices_need_saltelli, method = study.plan.file.design.method.name()));
        }
        let left_out = analyses.iter().filter_map(|a| Some(a.indices.as_ref()?.left_out)).max();
        if let Some(count @ 1..) = left_out {
            notes.push(say!(base_samples_left_out, count));
        }
        let tornado = Tornado::new(&study, TORNADO);
        let bands = bands(&study, folder, is_saltelli)?;
        if bands.is_none() {
            notes.push(say!(bands_need_growth_by_wavelength));
        }
        for analysis in &mut analyses {
            analysis.tell(&study, &tornado);
        }
        Ok(Self {
            title: study.plan.file.title.clone(),
            fingerprint: study.fingerprint.clone(),
            samples: study.samples(),
            analyses,
            growth_bands: bands.as_ref().map(|bands| GrowthBands {
                samples: bands.samples,
                wavelength_m: study.outputs().wavelengths().to_vec(),
                quantiles: bands.shares.clone(),
                growth_rate_per_passage: bands.curves.clone(),
            }),
            notes,
            study,
            tornado,
            bands,
            confidence,
        })
    }

    /// Sobol indices; `None` if the design does not give them.
    fn indices_figure(&self) -> Option<BarFigure> {
        let mut analyses = self.analyses.iter();
        analyses.any(|analysis| analysis.indices.is_some()).then(|| figure::indices(&self.study, &self.analyses))
    }

    /// Each parameter alone; none if the medians fail.
    fn tornado_figure(&self) -> Option<BarFigure> {
        figure::tornado(&self.study, &self.analyses, &self.tornado)
    }
}

/// What a study is called.
fn title(title: Option<&str>) -> Message {
    title.map_or_else(|| say!(study_word), Message::verbatim)
}

impl Answer for SensitivityAnswer {
    fn name(&self) -> &'static str {
        "growth-bands"
    }

    fn document_name(&self) -> &'static str {
        "sensitivity.json"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![title(self.title.as_deref())]
    }

    fn sentences(&self) -> Vec<Message> {
        Vec::new()
    }

    fn printed(&self) -> Vec<Printed> {
        let analyses = || self.analyses.iter();
        let indices = analyses().filter_map(|analysis| {
            let indices = analysis.indices.as_ref()?;
            Some(Printed::Table(tables::indices(self, analysis, indices)))
        });
        let alone = analyses().flat_map(|analysis| {
            let middle = tables::at(analysis, &self.tornado.middle);
            [Printed::Table(tables::tornado(self, analysis)), Printed::Line(say!(at_all_medians, value = middle))]
        });
        self.introduction().into_iter().map(Printed::Line).chain(indices).chain(alone).collect()
    }

    /// Growth against wavelength over the samples.
    fn figure(&self) -> LineFigure {
        self.bands.as_ref().map_or_else(LineFigure::default, |bands| figure::bands(&self.study, bands))
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let indices = self.indices_figure().map(|figure| ResultFile::Bars("sobol-indices", figure));
        let tornado = self.tornado_figure().map(|figure| ResultFile::Bars("tornado", figure));
        let bands = self.bands.is_some().then(|| ResultFile::Lines(self.name(), self.figure()));
        indices.into_iter().chain(tornado).chain(bands).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.notes
    }
}

/// The outputs to look at: those asked for, or all that are one real number for each sample.
fn chosen(study: &Study, asked: &[String]) -> Result<Vec<Analysis>, StudyError> {
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
            analyses.push(Analysis {
                name,
                unit: variable.unit,
                variance: None,
                base_samples: None,
                at_medians: None,
                parameters: Vec::new(),
                variable: variable.clone(),
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
fn column(study: &Study, folder: &ResultFolder, analysis: &Analysis) -> Result<Vec<f64>, StudyError> {
    let width = study.outputs().length(&analysis.variable);
    let before: usize = study
        .outputs()
        .variables()
        .iter()
        .take_while(|variable| **variable != analysis.variable)
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
