//! `POST /api/compare`: maps of variants in the window of one case; `POST /api/growth`: their growth over wavelength.

use riffel::{Axis, Ridge};
use riffel_case::{Case, ask};
use riffel_keys::{Message, say};
use serde::{Deserialize, Serialize};

use crate::LineGrowth;
use crate::page::map::{Computed, Head};
use crate::page::{CaseText, Fault, Reply, Traffic};
use crate::ridge::RidgePointDocument;

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
        own.covering(case.wavelength.min(), case.wavelength.max()).map_err(|error| self.fault(error.into()))
    }

    /// A fault of a variant is not one of the form.
    fn fault(&self, fault: Fault) -> Fault {
        fault.without_key(&self.name)
    }
}

fn at_most<T>(what: &str, given: &[T], most: usize) -> Result<(), Fault> {
    if given.len() <= most {
        return Ok(());
    }
    let count = given.len();
    Err(Fault::bad(format!("{count} {what} are asked for, but at most {most} at a time")))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    variants: Vec<Variant>,
    /// The case at hand, whose window all maps have.
    case: CaseText,
    /// The traffic of the line; none, and it is the usual one of each.
    #[serde(default)]
    traffic: Option<Traffic>,
}

/// The values of the variants follow each other.
#[derive(Serialize)]
struct Answer {
    variants: Vec<Compared>,
}

#[derive(Serialize)]
struct Compared {
    #[serde(flatten)]
    head: Head,
    under_traffic: UnderTraffic,
}

/// What grows fastest under the traffic of the line. A variant that has no answer there leaves the maps of all.
#[derive(Serialize)]
#[serde(untagged)]
enum UnderTraffic {
    Answered {
        #[serde(flatten)]
        growth: Box<LineGrowth>,
        /// In what it doubles, "5 to 14 months"; `None` if nothing grows.
        doubles_in: Option<Message>,
    },
    Refused {
        fault: Fault,
    },
}

impl UnderTraffic {
    fn of(case: &Case, traffic: Option<&riffel_case::traffic::Traffic>) -> Self {
        match LineGrowth::new(case, traffic) {
            Ok(growth) => {
                Self::Answered { doubles_in: growth.fastest.as_ref().map(|it| it.time()), growth: Box::new(growth) }
            }
            Err(error) => Self::Refused { fault: error.into() },
        }
    }
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("comparison".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        at_most("maps", &self.variants, MOST_MAPS)?;
        let case = self.case.read()?;
        let traffic = self.traffic.as_ref().map(Traffic::read).transpose()?;
        let (wavelength, speed) = (case.wavelength, case.speed);
        let mut variants = Vec::new();
        let mut values = Vec::new();
        for variant in &self.variants {
            let own = variant.covering(&case)?;
            let map = Computed::new(&own, &own.feedback, wavelength, speed)?;
            variants.push(Compared { head: map.head, under_traffic: UnderTraffic::of(&own, traffic.as_ref()) });
            values.extend(map.values);
        }
        Reply::framed(&Answer { variants }, &values)
    }
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
                .map(|&wavelength| case.feedback.at(wavelength, speed).growth_rate)
                .collect(),
            wavelength_m,
            lines: ask::told_of(case, window)
                .map_or_else(Vec::new, |told| Ridge::lines_at(&case.feedback, told, speed))
                .iter()
                .map(RidgePointDocument::from)
                .collect(),
        })
    }
}

impl crate::page::Question for CurvesQuestion {
    fn subject(&self) -> Option<String> {
        let subject = match self.purpose {
            Purpose::Variants => "growth of variants",
            Purpose::Sweep => "growth of a sweep",
        };
        Some(subject.to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        at_most("curves", &self.curves, MOST_CURVES)?;
        let case = self.case.read()?;
        let mut curves = Vec::new();
        for CurveQuestion { variant, speed_m_per_s: speed } in &self.curves {
            if !(*speed > 0.0 && *speed <= 200.0) {
                return Err(Fault::bad(say!(the_speed_is_m_s_but, name = &variant.name, speed = *speed)));
            }
            let own = variant.covering(&case)?;
            curves.push(Growth::new(&own, case.wavelength, *speed)?);
        }
        Reply::json(&curves)
    }
}
