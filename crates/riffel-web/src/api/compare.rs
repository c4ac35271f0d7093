//! `POST /api/compare`: maps of variants in the window of one case; `POST /api/growth`: their growth over wavelength.

use axum::Json;
use axum::extract::State;
use riffel::{Axis, Ridge};
use riffel_answers::ridge::RidgePointDocument;
use riffel_case::Case;
use serde::{Deserialize, Serialize};

use super::map::{Computed, Head};
use crate::Page;
use crate::fault::Fault;
use crate::framed::Framed;
use crate::request::{Asked, Asker, CaseText};

/// Wavelengths of a growth curve.
pub(super) const WAVELENGTH_POINTS: usize = 241;
/// Most curves over each other: the variants of a page, or a sweep.
const MOST_CURVES: usize = 12;
/// Most maps of one answer: six variants and the case at hand.
const MOST_MAPS: usize = 7;

/// A case with the name that the reader gave it.
#[derive(Deserialize)]
pub(crate) struct Variant {
    name: String,
    case: CaseText,
}

impl Variant {
    /// The case with a contact that answers in the whole window of another.
    fn covering(&self, case: &Case) -> Result<Case, Fault> {
        let own = self.case.read().map_err(|fault| self.fault(fault))?;
        own.covering(case.wavelength.min(), case.wavelength.max())
            .map_err(|error| self.fault(error.into()))
    }

    /// A fault of a variant is not one of the form.
    fn fault(&self, fault: Fault) -> Fault {
        fault.without_key(&format!("{}: ", self.name))
    }
}

fn at_most<T>(what: &str, given: &[T], most: usize) -> Result<(), Fault> {
    if given.len() <= most {
        return Ok(());
    }
    let count = given.len();
    Err(Fault::bad(format!(
        "{count} {what} are asked for, but at most {most} at a time"
    )))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    variants: Vec<Variant>,
    /// The case at hand, whose window all maps have.
    case: CaseText,
}

/// The values of the variants follow each other.
#[derive(Serialize)]
pub(crate) struct Answer {
    variants: Vec<Head>,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Framed<Answer>, Fault> {
    at_most("maps", &question.variants, MOST_MAPS)?;
    page.queue
        .run(asker.subject("comparison"), move |wanted| {
            let case = question.case.read()?;
            let (wavelength, speed) = (case.wavelength, case.speed);
            let mut variants = Vec::new();
            let mut values = Vec::new();
            for variant in &question.variants {
                let own = variant.covering(&case)?;
                let map = Computed::new(&own, &own.feedback, wavelength, speed, wanted);
                variants.push(map.head);
                values.extend(map.values);
            }
            Ok(Framed {
                head: Answer { variants },
                values,
            })
        })
        .await
}

#[derive(Deserialize)]
pub(crate) struct CurvesQuestion {
    /// Of each use only the newest question is wanted.
    #[serde(rename = "for")]
    purpose: Purpose,
    curves: Vec<CurveQuestion>,
    /// The case at hand, whose wavelengths all curves have.
    case: CaseText,
}

/// What curves are for.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Purpose {
    Variants,
    Sweep,
}

#[derive(Deserialize)]
struct CurveQuestion {
    #[serde(flatten)]
    variant: Variant,
    speed_m_per_s: f64,
}

/// Growth over wavelength at one speed.
#[derive(Serialize)]
pub(crate) struct Growth {
    pub(super) wavelength_m: Vec<f64>,
    pub(super) growth_rate_per_passage: Vec<f64>,
    /// The wavelengths that grow fastest around them.
    pub(super) lines: Vec<RidgePointDocument>,
}

impl Growth {
    pub(super) fn new(case: &Case, window: Axis, speed: f64) -> Result<Self, Fault> {
        let drawn = Axis::new(window.min(), window.max(), WAVELENGTH_POINTS);
        let drawn = drawn.map_err(|error| Fault::bad(error.to_string()))?;
        let wavelength_m = drawn.values();
        Ok(Self {
            growth_rate_per_passage: wavelength_m
                .iter()
                .map(|&wavelength| case.feedback.at(wavelength, speed).growth_rate())
                .collect(),
            wavelength_m,
            lines: Ridge::lines_at(&case.feedback, window, speed)
                .iter()
                .map(RidgePointDocument::from)
                .collect(),
        })
    }
}

pub(crate) async fn growth(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<CurvesQuestion>,
) -> Result<Json<Vec<Growth>>, Fault> {
    at_most("curves", &question.curves, MOST_CURVES)?;
    let subject = asker.subject(match question.purpose {
        Purpose::Variants => "growth of variants",
        Purpose::Sweep => "growth of a sweep",
    });
    page.queue
        .run(subject, move |wanted| {
            let case = question.case.read()?;
            let mut curves = Vec::new();
            for CurveQuestion {
                variant,
                speed_m_per_s: speed,
            } in &question.curves
            {
                if !(*speed > 0.0 && *speed <= 200.0) {
                    return Err(Fault::bad(format!(
                        "{}: the speed is {speed} m/s, but must be above zero and at most 200 m/s",
                        variant.name
                    )));
                }
                if !wanted.still() {
                    return Err(Fault::busy(
                        "a newer request has taken the place of this one",
                    ));
                }
                let own = variant.covering(&case)?;
                curves.push(Growth::new(&own, case.wavelength, *speed)?);
            }
            Ok(Json(curves))
        })
        .await
}
