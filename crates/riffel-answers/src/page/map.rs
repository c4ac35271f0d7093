//! `POST /api/map`: the growth map of a case, as numbers for the page to colour.

use riffel::growth::{RidgeBranch, RidgePoint};
use riffel::{Axis, GrowthMap, Loop, Ridge};
use riffel_case::traffic::{FASTEST_DOUBLING_DAYS, UsualTraffic};
use riffel_case::{Case, idle_because};
use riffel_keys::Message;
use riffel_plot::constant_frequency_rays;
use serde::{Deserialize, Serialize};

use crate::map::DerivedDocument;
use crate::page::{CaseText, Fault, Reply};
use crate::ridge::{BranchDocument, RidgePointDocument, best_fit_frequency, ridge_in};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

/// Everything about a map but its values.
#[derive(Serialize)]
pub(crate) struct Head {
    title: Option<String>,
    window: Window,
    growth_rate_per_dissipation: f64,
    ridge: RidgeColumns,
    /// The strongest first.
    branches: Vec<Branch>,
    /// The branches in a sentence.
    branches_in_words: Message,
    /// That of the strongest branch.
    best_fit_frequency_hz: Option<f64>,
    highest: Option<RidgePointDocument>,
    rays_hz: Vec<f64>,
    derived: Derived,
    /// Every key, with presets and defaults.
    complete: riffel_case::file::CaseFile,
    /// Keys and tables that this case does not use.
    idle: Vec<&'static str>,
    remarks: Vec<Message>,
    usual_traffic: Usual,
}

/// The usual traffic of the line, for the form.
#[derive(Serialize)]
struct Usual {
    line: &'static str,
    speeds_m_per_s: [f64; 2],
    passages_per_day: f64,
    /// Days below which a doubling is faster than any railway known, and no time is told.
    fastest_doubling_days: f64,
    /// A vehicle can bring all its wheels: the case has a curve.
    in_curve: bool,
}

impl From<&Case> for Usual {
    fn from(case: &Case) -> Self {
        let usual = UsualTraffic::of(case);
        Self {
            line: usual.line.name(),
            speeds_m_per_s: usual.speeds,
            passages_per_day: usual.passages_per_day,
            fastest_doubling_days: FASTEST_DOUBLING_DAYS,
            in_curve: case.file.curve.is_some() || case.file.contact.from.is_some(),
        }
    }
}

/// The axes, equally spaced, both ends included.
#[derive(Serialize)]
pub(crate) struct Window {
    wavelength_m: Range,
    speed_m_per_s: Range,
}

#[derive(Serialize)]
struct Range {
    min: f64,
    max: f64,
    points: usize,
}

impl From<Axis> for Range {
    fn from(axis: Axis) -> Self {
        Self { min: axis.min(), max: axis.max(), points: axis.points() }
    }
}

/// One entry for each speed that grows.
#[derive(Serialize)]
struct RidgeColumns {
    speed_m_per_s: Vec<f64>,
    wavelength_m: Vec<f64>,
    growth_rate_per_passage: Vec<f64>,
    at_edge: Vec<bool>,
}

/// A branch of the ridge, with the points of its crest in order of speed.
#[derive(Serialize)]
struct Branch {
    #[serde(flatten)]
    document: BranchDocument,
    points: BranchColumns,
}

#[derive(Serialize)]
struct BranchColumns {
    speed_m_per_s: Vec<f64>,
    wavelength_m: Vec<f64>,
}

impl BranchColumns {
    /// Of all pieces of a branch.
    fn of(ridge: &Ridge, document: &BranchDocument) -> Self {
        let pieces = document.pieces.iter().map(|&piece| &ridge.branches[piece]);
        let mut points: Vec<&RidgePoint> = pieces.flat_map(RidgeBranch::crest).collect();
        points.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        let column = |value: fn(&RidgePoint) -> f64| points.iter().map(|&p| value(p)).collect();
        Self { speed_m_per_s: column(|point| point.speed), wavelength_m: column(|point| point.wavelength) }
    }
}

/// What follows from the case, with what the form shows beside it.
#[derive(Serialize)]
pub(crate) struct Derived {
    #[serde(flatten)]
    document: DerivedDocument,
    inertia_kg_m2: Option<f64>,
    pinned_pinned_hz: Option<f64>,
}

impl Derived {
    pub(crate) fn of(case: &Case) -> Self {
        Self {
            document: DerivedDocument::of(case),
            inertia_kg_m2: case.file.wheel.inertia.map(|inertia| inertia.si()),
            pinned_pinned_hz: case.track.pinned_pinned.map(|w| w / std::f64::consts::TAU),
        }
    }
}

/// A map and what is drawn on it.
pub(crate) struct Computed {
    pub(crate) head: Head,
    pub(crate) values: Vec<f32>,
}

impl Computed {
    /// The map of a loop of the case in a window.
    pub(crate) fn new(case: &Case, feedback: &Loop, wavelength: Axis, speed: Axis) -> Result<Self, Fault> {
        let map = GrowthMap::compute(feedback, wavelength, speed, |_| ());
        let ridge = ridge_in(case, feedback, [wavelength, speed]);
        let branches = BranchDocument::all(case, &ridge);
        let branches_in_words = BranchDocument::sentence(&branches);
        let growing: Vec<&RidgePoint> = ridge.points.iter().filter(|point| point.growth_rate > 0.0).collect();
        let column = |value: fn(&RidgePoint) -> f64| growing.iter().map(|&p| value(p)).collect();
        Ok(Self {
            head: Head {
                title: case.file.title.clone(),
                window: Window { wavelength_m: wavelength.into(), speed_m_per_s: speed.into() },
                growth_rate_per_dissipation: map.growth_rate_per_dissipation(),
                ridge: RidgeColumns {
                    speed_m_per_s: column(|point| point.speed),
                    wavelength_m: column(|point| point.wavelength),
                    growth_rate_per_passage: column(|point| point.growth_rate),
                    at_edge: growing.iter().map(|point| point.at_edge).collect(),
                },
                branches: branches
                    .into_iter()
                    .map(|document| Branch { points: BranchColumns::of(&ridge, &document), document })
                    .collect(),
                branches_in_words,
                best_fit_frequency_hz: best_fit_frequency(&ridge),
                highest: ridge.highest().filter(|point| point.growth_rate > 0.0).map(RidgePointDocument::from),
                rays_hz: constant_frequency_rays((wavelength.min(), wavelength.max()), (speed.min(), speed.max())),
                derived: Derived::of(case),
                complete: case.file.clone(),
                idle: idle(case),
                remarks: case.remarks.clone(),
                usual_traffic: case.into(),
            },
            values: map.rows().flat_map(|(_, row)| row).map(|value| value.re as f32).collect(),
        })
    }
}

/// Keys and tables that a model may leave aside; those of the window and of the amplitude have their use in the page.
const MAY_BE_IDLE: [&str; 26] = [
    "track.preset",
    "track.pad",
    "track.sleeper",
    "track.ballast",
    "track.support_spacing",
    "track.position",
    "rail.polar_second_moment",
    "rail.warping_constant",
    "rail.centroid_height",
    "rail.head_height",
    "rail.foot_depth",
    "rail.foot_width",
    "contact.polach",
    "contact.grid",
    "contact.conformity",
    "contact.dissipation_phase",
    "contact.wave_patch",
    "wheelset.mass",
    "wheelset.roll_inertia",
    "wheelset.spin_inertia",
    "wheelset.axle",
    "wheelset.discs",
    "curve",
    "bogie",
    "body",
    "profiles",
];

fn idle(case: &Case) -> Vec<&'static str> {
    // The map is that of one place of the bay.
    let of_a_place = |key: &str| key == "track.position" && case.file.track.model.is_periodic();
    let idle = MAY_BE_IDLE.into_iter();
    idle.filter(|key| idle_because(case, key).is_some() && !of_a_place(key)).collect()
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("map".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let case = self.case.read()?;
        let (wavelength, speed) = (case.wavelength, case.speed);
        let map = Computed::new(&case, &case.feedback, wavelength, speed)?;
        Reply::framed(&map.head, &map.values)
    }
}
