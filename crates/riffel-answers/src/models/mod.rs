//! The same case by the models of the field, side by side.

mod difference;
mod figure;
mod passing;

use riffel::growth::GrowthSpectrum;
use riffel::{Complex64, Loop};
use riffel_case::model::{FieldModel, Joints, ModelOnCase};
use riffel_case::traffic::UsualTraffic;
use riffel_case::{Case, ask};
use riffel_keys::{Message, decimal, say, shown_speed};
use riffel_plot::LineFigure;
use serde::Serialize;

pub use difference::Difference;

use passing::Passing;

use crate::answer::{inputs, titled};
use crate::highest::{Highest, wavelengths_of};
use crate::number_alone;
use crate::{Answer, AnswerError, Result, ResultFile, Rows, Table, WearLimitDocument, growth_lines};

/// Points of a curve in the complex plane: a resonance with a loss factor of 0.02 at 1 kHz has ten.
const PLANE_POINTS: usize = 801;

/// What is asked of the models of the field.
pub struct ModelsRequest {
    /// The models; all where none is named. One that is named must be on the case.
    pub models: Vec<&'static FieldModel>,
    /// Speed \[m/s\]; none for all speeds of the usual traffic of the line.
    pub speed: Option<f64>,
}

/// Growth by the models of the field at one speed or under the usual traffic, over the wavelengths of the map of a case.
#[derive(Serialize)]
pub struct ModelsAnswer {
    riffel_version: &'static str,
    #[serde(serialize_with = "inputs")]
    case: Case,
    /// The speed, or the mean of the traffic.
    pub speed_m_per_s: f64,
    /// Slowest and fastest trains of the usual traffic, over which growth is the mean; null at one speed.
    pub speeds_m_per_s: Option<[f64; 2]>,
    /// Of the window of the map, rising, close together at narrow lines of any model.
    pub wavelength_m: Vec<f64>,
    /// The models in their order.
    pub models: Vec<ModelGrowth>,
    /// At which speed, or under which traffic.
    #[serde(skip)]
    passing: Message,
    #[serde(skip)]
    remarks: Vec<Message>,
}

/// A model, and what it says of a case.
#[derive(Serialize)]
pub struct ModelGrowth {
    /// The model.
    #[serde(flatten)]
    pub model: &'static FieldModel,
    /// Whether it can be read from the case.
    pub applies: bool,
    /// What the case lacks, as the end of a sentence; null where the model applies.
    pub not_on_this_case: Option<String>,
    /// At the wavelengths of the answer; null where the model does not apply.
    pub growth_rate_per_passage: Option<Vec<f64>>,
    /// The fastest of the wavelengths; null where nothing grows.
    pub highest: Option<Highest>,
    /// Mean wear under the model, and how far that growth can last; left out where the model does not apply.
    #[serde(flatten)]
    pub wear_limit: Option<WearLimitDocument>,
    /// By which joints it differs from the case with the exact contact, the one that moves growth most first.
    pub differs_by: Vec<Difference>,
    /// Null but for a model whose papers draw it, on discrete supports.
    pub complex_plane: Option<ComplexPlane>,
    /// What its reader should know, beyond what is to be known of the case.
    pub remarks: Vec<String>,
    /// That its loop oscillates without any profile, if it does: the last of the remarks.
    #[serde(skip)]
    unstable: Option<String>,
}

/// Energy left on a metre of rail over the amplitude of the profile, e₁/Δ, over frequency: growth in the left half-plane.
#[derive(Serialize)]
pub struct ComplexPlane {
    /// Rising.
    pub frequency_hz: Vec<f64>,
    /// With the wheel over a support, [re, im].
    pub over_support_j_per_m2: Vec<[f64; 2]>,
    /// With the wheel in mid-span.
    pub mid_span_j_per_m2: Vec<[f64; 2]>,
}

impl ModelsAnswer {
    /// Growth by each model; `progress` is told of each that is done.
    ///
    /// # Errors
    /// [`AnswerError::Case`] for frequencies at which the case is not known, [`AnswerError::NotOnCase`] for a model that
    /// is named and cannot be read from the case.
    pub fn new(case: &Case, request: &ModelsRequest, progress: &dyn Fn(usize)) -> Result<Self> {
        let named = !request.models.is_empty();
        let models = match named {
            true => request.models.clone(),
            false => FieldModel::all().iter().collect(),
        };
        let (own, passing, usual) = match request.speed {
            None => {
                let usual = UsualTraffic::of(case);
                let speeds = usual.traffic()?.speeds()[0].clone();
                let case = usual.case_under(&case.sharing_parts())?;
                (case, Passing::Traffic(speeds), Some(usual))
            }
            Some(speed) => {
                case.check_points([case.wavelength.min(), case.wavelength.max()], [speed; 2])?;
                (case.sharing_parts(), Passing::Speed(speed), None)
            }
        };
        let growth = |model: &'static FieldModel| {
            let growth = ModelGrowth::of(&own, model, &passing);
            progress(1);
            match growth {
                Err(reason) if named => Err(AnswerError::NotOnCase { model: &model.name, reason }),
                growth => Ok((model, growth)),
            }
        };
        let models: Result<Vec<_>> = models.into_iter().map(growth).collect();
        let models = models?;
        let on_case = models.iter().filter_map(|(_, growth)| growth.as_ref().ok());
        let wavelengths = wavelengths_of(on_case.map(|(_, course, _)| course));
        let models = models.into_iter().map(|(model, growth)| match growth {
            Ok((on, _, growth)) => {
                ModelGrowth { growth_rate_per_passage: Some(passing.rates(&on, &wavelengths)), ..growth }
            }
            Err(reason) => ModelGrowth { not_on_this_case: Some(reason), ..ModelGrowth::without(model) },
        });
        let models: Vec<ModelGrowth> = models.collect();
        let speed = passing.mean();
        let unstable = models.iter().filter_map(|of| {
            let remark = Message::verbatim(of.unstable.clone()?);
            Some(remark.about(&of.model.title))
        });
        Ok(Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            case: case.clone(),
            speed_m_per_s: speed,
            speeds_m_per_s: usual.map(|usual| usual.speeds),
            passing: match &usual {
                Some(usual) => say!(compared_under, traffic = usual.in_words()),
                None => say!(at_speed, speed = shown_speed(speed, 1)),
            },
            remarks: ask::remarks_at(case, speed).into_iter().chain(unstable).collect(),
            models,
            wavelength_m: wavelengths,
        })
    }

    /// The models that are on the case.
    pub fn on_case(&self) -> impl Iterator<Item = &ModelGrowth> {
        self.models.iter().filter(|of| of.applies)
    }

    /// What a reader sees.
    fn table(&self) -> Table {
        let on_case: Vec<&ModelGrowth> = self.on_case().collect();
        let shown = |head: Message, of: fn(&Highest) -> Message| {
            on_case.shown(head, |of_model| of_model.highest.as_ref().map_or_else(|| Message::verbatim(""), of))
        };
        Table {
            name: "models",
            columns: vec![
                on_case.shown(Message::verbatim(""), |of| Message::verbatim(&of.model.title)),
                on_case.shown(say!(highest_growth_column), |of| match of.highest {
                    Some(highest) => number_alone(format!("{:+.4}", 1e6 * highest.rate)),
                    None => say!(no_growth_in_table),
                }),
                shown(Message::verbatim("mm"), Highest::millimetres),
                shown(Message::verbatim("Hz"), |highest| number_alone(decimal(highest.frequency, 0))),
                shown(say!(passages_to_double_column), |highest| {
                    number_alone(format!("{:.2e}", highest.doubling_passages()))
                }),
            ],
        }
    }

    /// One row for each wavelength, a column for each model on the case.
    fn growth_table(&self) -> Table {
        let grown = self.on_case().filter_map(|of| Some((&*of.model.name, of.growth_rate_per_passage.as_deref()?)));
        growth_lines::table(&self.wavelength_m, grown)
    }
}

impl Answer for ModelsAnswer {
    fn name(&self) -> &'static str {
        "models"
    }

    fn folder_name(&self) -> Option<&'static str> {
        Some("models")
    }

    fn introduction(&self) -> Vec<Message> {
        let title = titled(self.case.file.title.as_ref(), say!(models_of_the_field));
        vec![say!(under_title, title, passing = self.passing.clone())]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.table(), self.growth_table()]
    }

    fn sentences(&self) -> Vec<Message> {
        let moves = self.on_case().filter_map(|of| {
            let sentence = &of.differs_by.first()?.sentence;
            Some(Message::verbatim(format!("  {}: {sentence}", of.model.title)))
        });
        let moves: Vec<Message> = moves.collect();
        let heading = (!moves.is_empty()).then(|| say!(what_moves_models_most));
        let left_out = self.models.iter().filter_map(|of| {
            let reason = of.not_on_this_case.as_deref()?;
            Some(say!(model_not_on_this_case, model = &of.model.title, reason))
        });
        heading.into_iter().chain(moves).chain(left_out).collect()
    }

    fn figure(&self) -> LineFigure {
        figure::growth(self)
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let own = ResultFile::Lines(self.name(), self.figure());
        let plane = figure::complex_plane(self).map(|plane| ResultFile::Lines("complex-plane", plane));
        let growth = ResultFile::Table(self.growth_table());
        [own].into_iter().chain(plane).chain([growth]).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

impl ModelGrowth {
    /// A model that does not apply.
    fn without(model: &'static FieldModel) -> Self {
        Self {
            model,
            applies: false,
            not_on_this_case: None,
            growth_rate_per_passage: None,
            highest: None,
            wear_limit: None,
            differs_by: Vec::new(),
            complex_plane: None,
            remarks: Vec::new(),
            unstable: None,
        }
    }

    /// Growth but for its rates, with its course.
    fn of(
        case: &Case,
        model: &'static FieldModel,
        passing: &Passing,
    ) -> Result<(ModelOnCase, GrowthSpectrum, Self), String> {
        let on = on_case(case, model.joints, passing)?;
        let (course, highest) = passing.course(&on);
        let speed = passing.mean();
        let stability = ask::stability(&on.case, speed);
        let unstable = stability.and_then(|stability| stability.frequency);
        let unstable = unstable.map(|frequency| {
            format!(
                "at {:.0} km/h the loop of this model is unstable: near {frequency:.0} Hz it oscillates without any profile, \
                 and its growth rates mean nothing",
                3.6 * speed
            )
        });
        let remarks = on.case.remarks.iter();
        let remarks = remarks.filter(|remark| !case.remarks.contains(remark));
        let growth = Self {
            applies: true,
            wear_limit: Some(WearLimitDocument::new(&on.case, highest.map(|highest| highest.rate))),
            highest,
            differs_by: Difference::all(case, model.joints, (&course, highest), passing),
            complex_plane: model
                .complex_plane
                .then(|| ComplexPlane::of(&on, passing.frequencies(case), speed))
                .flatten(),
            remarks: remarks.map(ToString::to_string).chain(unstable.clone()).collect(),
            unstable,
            ..Self::without(model)
        };
        Ok((on, course, growth))
    }
}

impl ComplexPlane {
    /// Over the frequencies \[Hz\] at one speed \[m/s\], both ends included; `None` if supports are not discrete.
    fn of(on: &ModelOnCase, [lowest, highest]: [f64; 2], speed: f64) -> Option<Self> {
        let places = on.over_support_and_mid_span()?;
        let step = (highest - lowest) / (PLANE_POINTS - 1) as f64;
        let frequencies = (0..PLANE_POINTS).map(|point| lowest + step * point as f64);
        let frequencies: Vec<f64> = frequencies.collect();
        let wear = |feedback: &Loop| -> Vec<[f64; 2]> {
            let states = frequencies.iter();
            let states = states.map(|frequency| feedback.at(speed / frequency, speed));
            let wear = |wear: Complex64| [wear.re, wear.im];
            states.map(|state| wear(state.dissipation_at_rail / speed / feedback.amplitude())).collect()
        };
        let [over_support_j_per_m2, mid_span_j_per_m2] = places.each_ref().map(wear);
        Some(Self { frequency_hz: frequencies, over_support_j_per_m2, mid_span_j_per_m2 })
    }
}

/// The case with joints, known at the frequencies that are asked for.
fn on_case(case: &Case, joints: Joints, passing: &Passing) -> Result<ModelOnCase, String> {
    let on = ModelOnCase::new(case, joints).map_err(|lacks| lacks.0)?;
    let [lowest, highest] = passing.frequencies(case);
    let known = on.case.check_frequencies(lowest, highest);
    known.map_err(|error| error.to_string())?;
    Ok(on)
}
