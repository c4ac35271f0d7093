//! The whole loop at one wavelength and speed.

mod question;
mod words;

use riffel::LoopState;
use riffel::growth::{GrowthOnIrregularSupports, GrowthWithNeighbours};
use riffel_case::traffic::{UsualTraffic, reported_growth};
use riffel_case::{Case, DrawnSupports, Point, Sensitivity, ask};
use riffel_keys::{CaseError, Message};
use serde::Serialize;

use crate::stability::StabilityDocument;
use crate::{Answer, Table, WearLimitDocument};

pub use question::PointQuestion;

/// What is asked of one wavelength and speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointRequest {
    /// \[m\].
    pub wavelength: f64,
    /// \[m/s\].
    pub speed: f64,
    /// Whether to tell what growth answers to there.
    pub sensitivity: bool,
    /// How many neighbours on each side, 1/λ ± n/d, to let grow with the wave; `None` if it is not asked.
    pub neighbours: Option<usize>,
    /// Supports at drawn distances to grow on too; `None` if it is not asked.
    pub irregular: Option<DrawnSupports>,
}

/// The loop at one wavelength and speed: serialised, what `riffel point --json` prints.
#[derive(Serialize)]
pub struct PointAnswer {
    /// One turn of the loop.
    #[serde(skip)]
    state: LoopState,
    #[serde(skip)]
    case: Case,
    /// Every quantity with its key.
    #[serde(flatten)]
    quantities: Point,
    /// For the growth rate of one wheel of this kind on one line of the rail.
    #[serde(flatten)]
    wear_limit: WearLimitDocument,
    /// Whether the loop oscillates without any profile at the speed; none for one wheel and one axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    stability: Option<StabilityDocument>,
    /// That growth is faster than any seen on a railway, under as many axles as usually run on such a line.
    #[serde(skip_serializing_if = "Option::is_none")]
    reported_growth: Option<Message>,
    /// What growth answers to, the strongest first; `None` if it was not asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    sensitivity: Option<Vec<Sensitivity>>,
    /// Growth of the wave with its neighbours; `None` if it was not asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    with_neighbours: Option<Neighbours>,
    /// Growth along supports at drawn distances; `None` if it was not asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    irregular_supports: Option<IrregularSupports>,
    #[serde(skip)]
    remarks: Vec<Message>,
}

/// Growth along a stretch of supports at drawn distances, beside that on equal ones.
#[derive(Serialize)]
struct IrregularSupports {
    /// Standard deviation of the distance that was asked for.
    spacing_deviation_m: f64,
    /// Of the draw.
    seed: u64,
    /// Over the places of the stretch.
    along: Spread,
    /// Over a bay of equal supports.
    even: Spread,
    /// Where the supports stand, from where the first one would.
    support_position_m: Vec<f64>,
    /// Places of the wheel.
    position_m: Vec<f64>,
    /// Growth rate at each.
    growth_rate_per_passage: Vec<f64>,
}

/// How a growth rate per passage is spread over places.
#[derive(Serialize)]
struct Spread {
    /// Growth of the mean logarithm of the amplitude.
    mean: f64,
    /// About the mean.
    standard_deviation: f64,
    /// Of the places.
    least: f64,
    /// A tenth of the places have less.
    tenth: f64,
    /// A tenth of the places have more.
    nine_tenths: f64,
    /// Of the places.
    largest: f64,
}

impl Spread {
    fn new(values: &[f64]) -> Self {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let square: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |share: f64| sorted[(share * (count - 1.0)).round() as usize];
        Self {
            mean,
            standard_deviation: (square / count).sqrt(),
            least: at(0.0),
            tenth: at(0.1),
            nine_tenths: at(0.9),
            largest: at(1.0),
        }
    }
}

impl IrregularSupports {
    fn new(growth: GrowthOnIrregularSupports, drawn: DrawnSupports) -> Self {
        Self {
            spacing_deviation_m: drawn.deviation,
            seed: drawn.seed,
            along: Spread::new(&growth.growth_rates),
            even: Spread::new(&growth.even),
            support_position_m: growth.supports,
            position_m: growth.places,
            growth_rate_per_passage: growth.growth_rates,
        }
    }
}

/// Growth of a wave with the neighbours that the passing of supports makes of it.
#[derive(Serialize)]
struct Neighbours {
    /// Wavelengths, 1/λ + n/d for n = −N … N.
    wavelengths_m: Vec<f64>,
    /// Of the wave alone.
    growth_rate_alone: f64,
    /// Of the pattern that grows fastest.
    growth_rate_of_pattern: f64,
    /// Phase by which each passage moves the pattern \[rad\], positive along the rail.
    drift_of_pattern_rad: f64,
    /// Amplitudes of the pattern, the largest one.
    pattern: Vec<[f64; 2]>,
    /// Where in the bay the pattern is highest, from a support.
    highest_at_m: f64,
    /// There over its least amplitude in the bay.
    modulation: f64,
}

impl Neighbours {
    fn new(growth: &GrowthWithNeighbours) -> Self {
        /// Steps over the bay.
        const STEPS: usize = 120;
        let spacing = growth.spacing;
        let places: Vec<(f64, f64)> = (0..STEPS)
            .map(|index| spacing * index as f64 / STEPS as f64)
            .map(|place| (place, growth.amplitude_at(place)))
            .collect();
        let by_amplitude = |one: &&(f64, f64), other: &&(f64, f64)| one.1.total_cmp(&other.1);
        let highest = places.iter().max_by(by_amplitude).copied();
        let lowest = places.iter().min_by(by_amplitude).copied();
        let (highest, lowest) = (highest.unwrap_or_default(), lowest.unwrap_or_default());
        Self {
            wavelengths_m: growth.wavenumbers.iter().map(|k| std::f64::consts::TAU / k).collect(),
            growth_rate_alone: growth.alone().re,
            growth_rate_of_pattern: growth.leading.re,
            drift_of_pattern_rad: -growth.leading.im,
            pattern: growth.pattern.iter().map(|v| [v.re, v.im]).collect(),
            highest_at_m: highest.0,
            modulation: highest.1 / lowest.1,
        }
    }
}

impl PointAnswer {
    /// The loop of a case at the point.
    ///
    /// # Errors
    /// [`CaseError`] as of [`Case::point`].
    pub fn new(case: &Case, request: PointRequest) -> Result<Self, CaseError> {
        let PointRequest { wavelength, speed, .. } = request;
        let state = case.point(wavelength, speed)?;
        let sensitivity = match request.sensitivity {
            true => Some(ask::sensitivities(case, wavelength, speed)?),
            false => None,
        };
        let with_neighbours = match request.neighbours {
            Some(neighbours) => {
                let growth = ask::growth_with_neighbours(case, wavelength, speed, neighbours)?;
                Some(Neighbours::new(&growth))
            }
            None => None,
        };
        let irregular_supports = match request.irregular {
            Some(drawn) => {
                let growth = ask::growth_on_irregular_supports(case, wavelength, speed, drawn)?;
                Some(IrregularSupports::new(growth, drawn))
            }
            None => None,
        };
        let stability = ask::stability(case, speed).map(StabilityDocument::from);
        let oscillates = stability.as_ref().is_some_and(|it| it.oscillates());
        let per_day = UsualTraffic::of(case).passages_per_day;
        let reported = reported_growth(case, wavelength, state.growth_rate, per_day);
        let reported_growth = reported.filter(|_| !oscillates);
        let remarks = reported_growth.iter().cloned().chain(ask::remarks_at_point(case, wavelength, speed));
        Ok(Self {
            quantities: Point::new(case, &state),
            wear_limit: WearLimitDocument::new(case, Some(state.growth_rate)),
            remarks: remarks.collect(),
            reported_growth,
            case: case.clone(),
            state,
            stability,
            sensitivity,
            with_neighbours,
            irregular_supports,
        })
    }

    /// Whether the loop oscillates by itself at the speed, so that its growth rate means nothing.
    fn oscillates(&self) -> bool {
        self.stability.as_ref().is_some_and(|it| it.oscillates())
    }
}

impl Answer for PointAnswer {
    fn name(&self) -> &'static str {
        "point"
    }

    fn introduction(&self) -> Vec<Message> {
        words::introduction(self)
    }

    fn tables(&self) -> Vec<Table> {
        words::tables(self)
    }

    fn above(&self, table: &str) -> Vec<Message> {
        words::above(self, table)
    }

    fn below(&self, table: &str) -> Vec<Message> {
        words::below(self, table)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
