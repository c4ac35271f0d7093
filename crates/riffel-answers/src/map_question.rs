//! What is asked of the growth map.

use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::quantity::{Length, Quantity, Speed};
use riffel_keys::say;
use riffel_plot::Observation;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::map::observations::read;
use crate::map::{BayGrowth, MapAnswer, growth_over};
use crate::question::{AsWritten, CaseSource, Client, PosteriorSource, Question, Rule, Source, covering, over};
use crate::wheels::WheelsAnswer;
use crate::{Answer, LineGrowth, Result};

/// Growth over wavelength and speed: picture, page, tables.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct MapQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Measured corrugation to draw on the map: a table with the columns wavelength, speed and label,
    /// values in SI, with their units, or with those in the head, as in wavelength_mm.
    #[schemars(extend("value_name" = "CSV"))]
    observations: Option<Source<Vec<Observation>>>,
    /// Traffic file, for growth under the traffic [default: the usual traffic of a line of this kind].
    #[schemars(extend("value_name" = "FILE"))]
    traffic: Option<Source<Traffic>>,
    #[serde(flatten)]
    posterior: PosteriorSource,
    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[schemars(extend("value_name" = "LENGTH"))]
    position: Option<Quantity<Length>>,
    /// Growth over the bay between two supports as well: maps over a support, in mid-span and of the
    /// mean, and the curve of growth against position.
    bay: bool,
    /// Every wheel of the vehicle in its curve instead, side by side: maps in one scale, growth under the usual traffic, and a
    /// table of mean states. Needs contact.from.
    wheels: bool,
    /// Wavelength of the curve over the bay [default: where the mean grows fastest].
    wavelength: Option<AsWritten<Length>>,
    /// Speed of the curve over the bay.
    speed: Option<AsWritten<Speed>>,
}

impl MapQuestion {
    fn map(&self, case: &Case, client: &dyn Client) -> Result<MapAnswer> {
        case.check_window()?;
        let curve = match (&self.wavelength, &self.speed) {
            (Some(wavelength), Some(speed)) => {
                Some((wavelength.within("--wavelength", client)?, speed.within("--speed", client)?))
            }
            _ => None,
        };
        let covered = curve.map(|(wavelength, _)| covering(case, wavelength, wavelength)).transpose()?;
        let case = covered.as_ref().unwrap_or(case);
        let observations = self.observations.as_ref().map(|marks| marks.value(read)).transpose()?;
        let step = client.begin(say!(progress_growth_map), case.speed.points());
        let mut answer = MapAnswer::new(case, &step);
        drop(step);
        let traffic = self.traffic.as_ref().map(|traffic| traffic.value(Traffic::read)).transpose()?;
        let draws = self.posterior.draws(&self.case, client)?;
        answer.over_posterior = over(draws.as_ref(), client, growth_over)?;
        // The calibration knows more than the case says.
        if answer.over_posterior.is_none() {
            answer.under_traffic = Some(LineGrowth::new(case, traffic.as_deref())?);
        }
        if self.bay {
            let step = client.begin(say!(progress_bay), case.speed.points() * BayGrowth::map_count());
            answer.bay = Some(BayGrowth::new(case, curve, &step)?);
        }
        Ok(match observations {
            Some(observations) => answer.with_observations(observations.to_vec()),
            None => answer,
        })
    }
}

impl Question for MapQuestion {
    const NAME: &'static str = "map";
    const EXAMPLE: &'static str = "Example: riffel map case.toml -o results --set contact.friction=0.3";
    const RULES: &'static [Rule] = &[
        Rule::OneOf(&["traffic", "wheels"]),
        Rule::OneOf(&["traffic", "posterior"]),
        Rule::OneOf(&["wheels", "bay"]),
        Rule::OneOf(&["wheels", "observations"]),
        Rule::Needs(&["wavelength"], &["bay"]),
        Rule::Needs(&["wavelength"], &["speed"]),
        Rule::Needs(&["speed"], &["bay"]),
        Rule::Needs(&["speed"], &["wavelength"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read_at(self.position, client)?;
        if self.wheels {
            let step = client.begin(say!(progress_wheels), WheelsAnswer::rows(&case));
            return Ok(Box::new(WheelsAnswer::new(&case, &step)?));
        }
        Ok(Box::new(self.map(&case, client)?))
    }
}
