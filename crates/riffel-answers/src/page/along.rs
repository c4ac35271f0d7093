//! A measured rail along the line: the highest moving RMS of each block, by band.

use riffel::roughness::WavelengthBand;
use riffel_keys::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::question::{Client, Question, Rule};
use crate::roughness::{MeasuredAnswer, ProfileAnswer, RailAnswer, RoughnessQuestion};
use crate::{Answer, AnswerError, Result};

/// A measured rail in blocks along the line.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct AlongQuestion {
    #[serde(flatten)]
    roughness: RoughnessQuestion,
}

#[derive(Serialize)]
struct AlongAnswer {
    /// Shortest and longest wavelength of each band.
    bands_m: Vec<[f64; 2]>,
    rails: Vec<RailBlocks>,
    /// What `riffel roughness` says of the whole record.
    roughness: Box<ProfileAnswer>,
}

/// The blocks of a rail.
#[derive(Serialize)]
struct RailBlocks {
    name: String,
    from_m: Vec<f64>,
    to_m: Vec<f64>,
    /// Highest moving RMS in each block by band, in the order of `bands_m`; null where the band cannot be judged.
    moving_rms_max_m: Vec<Vec<Option<f64>>>,
}

impl RailBlocks {
    fn new(rail: &RailAnswer) -> Self {
        let blocks = &rail.analysis.blocks;
        let bands = 0..WavelengthBand::GRINDING.len();
        let highest = |band| blocks.iter().map(|block| block.moving_rms_max[band]).collect();
        Self {
            name: rail.name.clone(),
            from_m: blocks.iter().map(|block| block.from).collect(),
            to_m: blocks.iter().map(|block| block.to).collect(),
            moving_rms_max_m: bands.map(highest).collect(),
        }
    }
}

impl Question for AlongQuestion {
    const NAME: &'static str = "along";
    const EXAMPLE: &'static str = "";
    const RULES: &'static [Rule] = RoughnessQuestion::RULES;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let Some(MeasuredAnswer::Profile(roughness)) = self.roughness.measured(client)? else {
            return Err(AnswerError::Question { question: Self::NAME, message: "<FILE> must be a profile".to_owned() });
        };
        Ok(Box::new(AlongAnswer {
            bands_m: WavelengthBand::GRINDING.iter().map(|band| [band.from(), band.to()]).collect(),
            rails: roughness.rails.iter().map(RailBlocks::new).collect(),
            roughness,
        }))
    }
}

impl Answer for AlongAnswer {
    fn name(&self) -> &'static str {
        "along"
    }

    fn remarks(&self) -> &[Message] {
        self.roughness.remarks()
    }
}
