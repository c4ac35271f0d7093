//! What is asked of one wavelength and speed.

use riffel_case::DrawnSupports;
use riffel_keys::quantity::{Length, Quantity, Speed};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{PointAnswer, PointRequest};
use crate::question::{AsWritten, CaseSource, Client, Files, Question, Rule, covering, positive};
use crate::{Answer, AnswerError, Result};

/// The whole loop at one wavelength and speed.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct PointQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Wavelength, in metres or with its unit.
    wavelength: AsWritten<Length>,
    /// Speed, in m/s or with its unit.
    speed: AsWritten<Speed>,
    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[schemars(extend("value_name" = "LENGTH"))]
    position: Option<Quantity<Length>>,
    /// What the growth rate answers to: its derivative by every quantity of the case, by wavelength and speed.
    sensitivity: bool,
    /// On discrete supports: growth of the wave together with N neighbours on each side, 1/λ ± n/d, which the passing of
    /// supports makes of it; 3 is usual.
    #[schemars(extend("value_name" = "N"))]
    neighbours: Option<usize>,
    /// On discrete supports: growth along a stretch whose supports stand at drawn distances, normal about that of the case with
    /// this standard deviation, at most a quarter of it, and cut at three; 1 to 5 cm are usual.
    #[schemars(extend("value_name" = "LENGTH"))]
    spacing_deviation: Option<Quantity<Length>>,
    /// Supports of that stretch, 8 to 200 [default: 60].
    #[schemars(extend("value_name" = "N"))]
    supports: Option<usize>,
    /// Seed of the draw [default: 1].
    #[schemars(extend("value_name" = "N"))]
    seed: Option<u64>,
}

impl Question for PointQuestion {
    const NAME: &'static str = "point";
    const EXAMPLE: &'static str = "Example: riffel point case.toml --wavelength \"55 mm\" --speed \"108 km/h\"";
    const RULES: &'static [Rule] = &[Rule::Needs(&["supports", "seed"], &["spacing_deviation"])];
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read_at(self.position, client)?;
        let wavelength = self.wavelength.within("--wavelength", client)?;
        let speed = self.speed.within("--speed", client)?;
        case.check_points([wavelength; 2], [speed; 2])?;
        let irregular = self.spacing_deviation.map(|deviation| {
            Ok::<_, AnswerError>(DrawnSupports {
                deviation: positive("--spacing-deviation", deviation)?,
                supports: self.supports.unwrap_or(DrawnSupports::USUAL_SUPPORTS),
                seed: self.seed.unwrap_or(1),
            })
        });
        let request = PointRequest {
            wavelength,
            speed,
            sensitivity: self.sensitivity,
            neighbours: self.neighbours,
            irregular: irregular.transpose()?,
        };
        Ok(Box::new(PointAnswer::new(&covering(&case, wavelength, wavelength)?, request)?))
    }
}
