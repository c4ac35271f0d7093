//! The whole loop at one wavelength and speed.

use riffel::feedback::State;
use riffel::growth::GrowthWithNeighbours;
use riffel_case::{Case, Point, Sensitivity};
use riffel_keys::CaseError;
use serde::Serialize;

use crate::stability::StabilityDocument;

/// What is asked of one wavelength and speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointRequest {
    /// \[m\].
    pub wavelength: f64,
    /// \[m/s\].
    pub speed: f64,
    /// Whether to tell what growth answers to there.
    pub sensitivity: bool,
    /// How many neighbours on each side, 1/λ ± n/d, to let grow with the wave; none where it is not asked.
    pub neighbours: Option<usize>,
}

/// The loop at one wavelength and speed: serialised, what `riffel point --json` prints.
#[derive(Serialize)]
pub struct PointAnswer {
    /// One turn of the loop.
    #[serde(skip)]
    pub state: State,
    /// Every quantity with its key.
    #[serde(flatten)]
    pub quantities: Point,
    /// Whether the loop oscillates without any profile at the speed; none for one wheel and one axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    stability: Option<StabilityDocument>,
    /// What growth answers to, the strongest first; none where it was not asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivity: Option<Vec<Sensitivity>>,
    /// Growth of the wave with its neighbours; none where it was not asked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub with_neighbours: Option<NeighboursDocument>,
}

/// Growth of a wave with the neighbours that the passing of supports makes of it.
#[derive(Serialize)]
pub struct NeighboursDocument {
    /// Wavelengths, 1/λ + n/d for n = −N … N.
    pub wavelengths_m: Vec<f64>,
    /// Of the wave alone.
    pub growth_rate_alone: f64,
    /// Of the pattern that grows fastest.
    pub growth_rate_of_pattern: f64,
    /// Phase by which each passage moves the pattern \[rad\], positive along the rail.
    pub drift_of_pattern_rad: f64,
    /// Amplitudes of the pattern, the largest one.
    pub pattern: Vec<[f64; 2]>,
    /// Where in the bay the pattern is highest, from a support.
    pub highest_at_m: f64,
    /// There over its least amplitude in the bay.
    pub modulation: f64,
}

impl NeighboursDocument {
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
            wavelengths_m: growth
                .wavenumbers
                .iter()
                .map(|k| std::f64::consts::TAU / k)
                .collect(),
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
        let PointRequest {
            wavelength, speed, ..
        } = request;
        let state = case.point(wavelength, speed)?;
        let sensitivity = match request.sensitivity {
            true => Some(case.sensitivities(wavelength, speed)?),
            false => None,
        };
        let with_neighbours = match request.neighbours {
            Some(neighbours) => {
                let growth = case.growth_with_neighbours(wavelength, speed, neighbours)?;
                Some(NeighboursDocument::new(&growth))
            }
            None => None,
        };
        Ok(Self {
            quantities: Point::new(case, &state),
            state,
            stability: case.stability(speed).map(StabilityDocument::from),
            sensitivity,
            with_neighbours,
        })
    }
}
