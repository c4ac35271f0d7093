//! The whole loop at one wavelength and speed.

use riffel::feedback::State;
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
        Ok(Self {
            quantities: Point::new(case, &state),
            state,
            stability: case.stability(speed).map(StabilityDocument::from),
            sensitivity,
        })
    }
}
