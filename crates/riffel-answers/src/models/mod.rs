//! The same case by the models of the field, side by side.

mod difference;
mod document;
mod figure;
mod passing;

use std::io::{self, Write};

use riffel::growth::GrowthCourse;
use riffel::{Complex64, Loop};
use riffel_case::Case;
use riffel_case::model::{FieldModel, Joints, ModelOnCase};
use riffel_case::traffic::UsualTraffic;
use riffel_keys::{Message, say, shown_speed};
use riffel_plot::LineFigure;

pub use difference::Difference;
pub use document::ModelsDocument;

use passing::Passing;

use crate::highest::{Highest, wavelengths_of};
use crate::{AnswerError, WearLimitDocument};

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
pub struct ModelsAnswer {
    /// The speed, or the mean of the traffic \[m/s\].
    pub speed: f64,
    /// The usual traffic, where no speed was asked for: growth is the mean over its speeds.
    pub usual_traffic: Option<UsualTraffic>,
    /// Wavelengths \[m\] of the window of the map, rising, close together at narrow lines of any model.
    pub wavelengths: Vec<f64>,
    /// The models in their order.
    pub models: Vec<ModelGrowth>,
}

/// A model, and what it says of a case.
pub struct ModelGrowth {
    /// The model.
    pub model: &'static FieldModel,
    /// Growth; where the case lacks something, what it needs as the end of a sentence.
    pub growth: Result<Growth, String>,
}

/// Growth by one model.
pub struct Growth {
    /// Growth rates per passage \[-\] at the wavelengths of the answer.
    pub rates: Vec<f64>,
    /// The fastest of the wavelengths; none where nothing grows.
    pub highest: Option<Highest>,
    /// Mean wear under the model, and how far that growth can last.
    pub wear_limit: WearLimitDocument,
    /// By which joints it differs from the case with the exact contact, the one that moves growth most first.
    pub differs_by: Vec<Difference>,
    /// Wear in the complex plane, of a model whose papers draw it, on discrete supports.
    pub complex_plane: Option<ComplexPlane>,
    /// What its reader should know, beyond what is to be known of the case.
    pub remarks: Vec<String>,
    /// At which frequency its loop oscillates without any profile, if it does.
    pub unstable: Option<String>,
}

/// Energy left on a metre of rail over the amplitude of the profile, e₁/Δ \[J/m²\], over frequency: growth in the left
/// half-plane.
pub struct ComplexPlane {
    /// Frequencies \[Hz\], rising.
    pub frequencies: Vec<f64>,
    /// With the wheel over a support.
    pub over_support: Vec<Complex64>,
    /// With the wheel in mid-span.
    pub mid_span: Vec<Complex64>,
}

impl ModelsAnswer {
    /// Growth by each model; `progress` is told of each that is done.
    ///
    /// # Errors
    /// [`AnswerError::Case`] for frequencies at which the case is not known, [`AnswerError::NotOnCase`] for a model that
    /// is named and cannot be read from the case.
    pub fn new(
        case: &Case,
        request: &ModelsRequest,
        progress: &dyn Fn(usize),
    ) -> Result<Self, AnswerError> {
        let named = !request.models.is_empty();
        let models = match named {
            true => request.models.clone(),
            false => FieldModel::ALL.to_vec(),
        };
        let (case, passing, usual_traffic) = match request.speed {
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
            let growth = Growth::of(&case, model, &passing);
            progress(1);
            match growth {
                Err(reason) if named => Err(AnswerError::NotOnCase {
                    model: model.name,
                    reason,
                }),
                growth => Ok((model, growth)),
            }
        };
        let models: Result<Vec<_>, AnswerError> = models.into_iter().map(growth).collect();
        let models = models?;
        let on_case = models.iter().filter_map(|(_, growth)| growth.as_ref().ok());
        let wavelengths = wavelengths_of(on_case.map(|(_, course, _)| course));
        let models = models.into_iter().map(|(model, growth)| ModelGrowth {
            model,
            growth: growth.map(|(on, _, growth)| Growth {
                rates: passing.rates(&on, &wavelengths),
                ..growth
            }),
        });
        Ok(Self {
            speed: passing.mean(),
            usual_traffic,
            models: models.collect(),
            wavelengths,
        })
    }

    /// At which speed, or under which traffic.
    pub fn passing(&self) -> Message {
        match &self.usual_traffic {
            Some(usual) => say!(compared_under, traffic = usual.in_words()),
            None => say!(at_speed, speed = shown_speed(self.speed, 1)),
        }
    }

    /// The models that are on the case, with their growth.
    pub fn on_case(&self) -> impl Iterator<Item = (&'static FieldModel, &Growth)> {
        let models = self.models.iter();
        models.filter_map(|of| Some((of.model, of.growth.as_ref().ok()?)))
    }

    /// The models as data: what `riffel compare --models --json` prints.
    pub fn document<'a>(&'a self, case: &'a Case) -> ModelsDocument<'a> {
        document::document(self, case)
    }

    /// Growth over wavelength, a line for each model.
    pub fn figure(&self, case: &Case) -> LineFigure {
        figure::growth(self, case)
    }

    /// Wear in the complex plane; none where no model of the answer draws it.
    pub fn complex_plane(&self, case: &Case) -> Option<LineFigure> {
        figure::complex_plane(self, case)
    }

    /// One row for each wavelength, a column for each model on the case.
    ///
    /// # Errors
    /// Those of the file.
    pub fn growth_csv(&self, file: &mut impl Write) -> io::Result<()> {
        document::growth_table(self, file)
    }
}

impl Growth {
    /// Growth but for its rates, with its course.
    fn of(
        case: &Case,
        model: &'static FieldModel,
        passing: &Passing,
    ) -> Result<(ModelOnCase, GrowthCourse, Self), String> {
        let on = on_case(case, model.joints, passing)?;
        let (course, highest) = passing.course(&on);
        let speed = passing.mean();
        let known = &case.remarks;
        let remarks = on.case.remarks.iter();
        let remarks = remarks.filter(|remark| !known.contains(remark));
        let unstable = on
            .case
            .stability(speed)
            .and_then(|stability| stability.frequency);
        let unstable = unstable.map(|frequency| {
            format!(
                "at {:.0} km/h the loop of this model is unstable: near {frequency:.0} Hz it oscillates without any profile, \
                 and its growth rates mean nothing",
                3.6 * speed
            )
        });
        let growth = Self {
            wear_limit: WearLimitDocument::new(&on.case, highest.map(|highest| highest.rate)),
            rates: Vec::new(),
            highest,
            differs_by: Difference::all(case, model.joints, &course, passing),
            complex_plane: model
                .has_complex_plane()
                .then(|| ComplexPlane::of(&on, passing.frequencies(case), speed))
                .flatten(),
            remarks: remarks.map(ToString::to_string).collect(),
            unstable,
        };
        Ok((on, course, growth))
    }
}

impl ComplexPlane {
    /// Over the frequencies \[Hz\] at one speed \[m/s\], both ends included; none where supports are not discrete.
    fn of(on: &ModelOnCase, [lowest, highest]: [f64; 2], speed: f64) -> Option<Self> {
        let places = on.over_support_and_mid_span()?;
        let step = (highest - lowest) / (PLANE_POINTS - 1) as f64;
        let frequencies = (0..PLANE_POINTS).map(|point| lowest + step * point as f64);
        let frequencies: Vec<f64> = frequencies.collect();
        let wear = |feedback: &Loop| -> Vec<Complex64> {
            let states = frequencies.iter();
            let states = states.map(|frequency| feedback.at(speed / frequency, speed));
            states
                .map(|state| state.dissipation_at_rail / speed / feedback.amplitude())
                .collect()
        };
        let [over_support, mid_span] = places.each_ref().map(wear);
        Some(Self {
            frequencies,
            over_support,
            mid_span,
        })
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
