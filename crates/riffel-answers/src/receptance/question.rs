//! What is asked of the joints of a case.

use riffel::Direction;
use riffel_case::{Case, Track};
use riffel_keys::quantity::{Frequency, Length, Quantity, Speed};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{MatrixAnswer, ReceptanceAnswer, ReceptanceCurves, ReceptanceRequest};
use crate::question::{AsWritten, CaseSource, Client, Question, Rule};
use crate::{Answer, AnswerError, Result};

/// Receptance of track, wheel and contact over frequency.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct ReceptanceQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Lowest frequency, in Hz or with its unit [default: 20 Hz, or the lowest measured].
    from: Option<AsWritten<Frequency>>,
    /// Highest frequency, in Hz or with its unit [default: 5 kHz, or the highest measured].
    to: Option<AsWritten<Frequency>>,
    /// Number of frequencies, equally spaced in their logarithm.
    #[schemars(range(min = 2, max = 1_000_000), extend("value_name" = "N", "default" = 600))]
    points: u32,
    /// Speed of the load, in m/s or with its unit [default: the highest of the map].
    speed: Option<AsWritten<Speed>>,
    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[schemars(extend("value_name" = "LENGTH"))]
    position: Option<Quantity<Length>>,
    /// Direction of force and displacement; wheel and contact are vertical only.
    #[schemars(extend("default" = "vertical"))]
    direction: Along,
    /// Matrices of track and wheel along all axes x, y, z of the track, at the contact under study.
    matrix: bool,
    /// Frequencies of --matrix, separated by commas, in Hz or with their unit, in place of --from, --to and --points.
    #[schemars(extend("value_name" = "LIST", "separator" = ","))]
    frequencies: Vec<AsWritten<Frequency>>,
}

/// Direction of force and displacement.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
enum Along {
    /// Downward.
    Vertical,
    /// Across the track.
    Lateral,
    /// Along the rail.
    Longitudinal,
}

impl From<Along> for Direction {
    fn from(along: Along) -> Self {
        match along {
            Along::Vertical => Self::Vertical,
            Along::Lateral => Self::Lateral,
            Along::Longitudinal => Self::Longitudinal,
        }
    }
}

impl ReceptanceQuestion {
    /// Speed of the load \[m/s\].
    fn speed(&self, case: &Case, client: &dyn Client) -> Result<f64> {
        match &self.speed {
            Some(speed) => speed.within("--speed", client),
            None => Ok(case.speed.max()),
        }
    }

    /// The frequencies asked for \[Hz\]; where nothing is said, as many of the usual ones as a measurement has.
    fn range(&self, track: &Track, client: &dyn Client) -> Result<Vec<f64>> {
        let (usual_from, usual_to) = ReceptanceCurves::default_range(&*track.receptance);
        let end = |end: &Option<AsWritten<Frequency>>, argument, usual| match end {
            Some(end) => end.within(argument, client),
            None => Ok(usual),
        };
        let (from, to) = (end(&self.from, "--from", usual_from)?, end(&self.to, "--to", usual_to)?);
        if from < to {
            return Ok(ReceptanceCurves::frequencies(from, to, self.points));
        }
        let rule = format!("above --from, {from} Hz");
        Err(AnswerError::argument("--to", format!("{to} Hz"), rule))
    }
}

impl Question for ReceptanceQuestion {
    const NAME: &'static str = "receptance";
    const EXAMPLE: &'static str = "Example: riffel receptance case.toml --from \"50 Hz\" --to \"2 kHz\"";
    const RULES: &'static [Rule] = &[
        Rule::OneOf(&["matrix", "direction"]),
        Rule::Needs(&["frequencies"], &["matrix"]),
        Rule::Excludes("frequencies", &["from", "to", "points"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read_at(self.position, client)?;
        if self.matrix {
            let speed = self.speed(&case, client)?;
            let frequencies = match &self.frequencies[..] {
                [] => self.range(&case.track, client)?,
                listed => AsWritten::all_within(listed, "--frequencies", client)?,
            };
            return Ok(Box::new(MatrixAnswer::new(&case, speed, frequencies)?));
        }
        let direction = self.direction.into();
        let track = case.track_in(direction)?;
        let speed = self.speed(&case, client)?;
        let request = ReceptanceRequest { direction, speed, frequencies: self.range(&track, client)? };
        Ok(Box::new(ReceptanceAnswer::new(&case, request)?))
    }
}
