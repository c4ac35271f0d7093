//! What is asked of the contact of a case.

use riffel_case::CaseContact;
use riffel_keys::quantity::{Quantity, Ratio};
use riffel_keys::{CaseError, say};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{ContactAnswer, ContactRequest, FrequencyResponse, RollingTheories};
use crate::question::{CaseSource, Client, Question, Rule, positive};
use crate::stress::{PointInRail, StressAnswer};
use crate::{Answer, Result};

/// The contact patch: its size and stiffness, creep curves of all laws, frequency response.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct ContactQuestion {
    #[serde(flatten)]
    case: CaseSource<CaseContact>,
    /// Creepages of the creep curves, as ratios or with %, separated by commas [default: 40, to 1.2
    /// times that of full slip].
    #[schemars(extend("value_name" = "CREEPAGES", "separator" = ","))]
    creepage: Vec<Quantity<Ratio>>,
    /// Wavelengths of the frequency response in semi-axes λ/a, separated by commas [default: 61, from 2
    /// to 100].
    #[schemars(extend("value_name" = "RATIOS", "separator" = ","))]
    ratio: Vec<Quantity<Ratio>>,
    /// Stress in the rail under the mean state, at the surface and below, in place of creep curves and responses.
    stress: bool,
    /// Stress at a point too, x/a, y/b, z/a with z into the rail, as --stress-at=-0.8,0,0.1; may be repeated.
    #[schemars(extend("value_name" = "X,Y,Z"))]
    stress_at: Vec<PointInRail>,
}

impl ContactQuestion {
    /// Creepages \[-\] and wavelengths \[semi-axes\], by default those that are usual.
    fn samples(&self, theories: &RollingTheories) -> Result<[Vec<f64>; 2]> {
        let listed = |argument, list: &[Quantity<Ratio>], usual: Vec<f64>| match list {
            [] => Ok(usual),
            list => list.iter().map(|&value| positive(argument, value)).collect(),
        };
        Ok([
            listed("--creepage", &self.creepage, theories.default_creepages())?,
            listed("--ratio", &self.ratio, FrequencyResponse::default_ratios())?,
        ])
    }
}

impl Question for ContactQuestion {
    const NAME: &'static str = "contact";
    const EXAMPLE: &'static str = "Example: riffel contact case.toml --ratio 4,8,16 --set contact.hertz=exact";
    const RULES: &'static [Rule] =
        &[Rule::Excludes("stress", &["creepage", "ratio"]), Rule::Needs(&["stress_at"], &["stress"])];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let contact = self.case.read(client)?;
        if self.stress {
            let points: Vec<[f64; 3]> = self.stress_at.iter().map(|point| point.0).collect();
            return Ok(Box::new(StressAnswer::new(&contact, &points)?));
        }
        let theories = RollingTheories::new(CaseContact::clone(&contact))?;
        let [creepages, ratios] = self.samples(&theories)?;
        let step = client.begin(say!(progress_contact), creepages.len() + ratios.len() + 1);
        let request = ContactRequest { creepages: Some(creepages), ratios: Some(ratios) };
        // A wavelength that the contact refuses stands under the name of its argument.
        let answer = ContactAnswer::new(theories, request, || step(1)).map_err(|error| match error {
            CaseError::Physics { input, error } => {
                CaseError::Physics { input: input.replace("λ/a = ", "--ratio "), error }
            }
            error => error,
        })?;
        Ok(Box::new(answer))
    }
}
