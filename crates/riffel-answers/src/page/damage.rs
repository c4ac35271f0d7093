//! `POST /api/damage`: what rolling contact makes of the rail beside wear, over a wave and under the traffic of the line.

use crate::Answer as _;
use crate::rail_damage::RailDamage;
use riffel_keys::Message;
use serde::{Deserialize, Serialize};

use crate::page::traffic::OnLine;
use crate::page::{Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    #[serde(flatten)]
    line: OnLine,
    wavelength_m: f64,
    speed_m_per_s: f64,
}

#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    damage: &'a RailDamage,
    sentences: Vec<Message>,
    notes: &'a [Message],
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("damage".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let (case, traffic) = self.line.read()?;
        let wave = [self.wavelength_m, self.speed_m_per_s];
        let damage = RailDamage::new(&case, traffic.as_ref(), wave)?;
        let shakedown = &damage.shakedown;
        let of_mean = shakedown.of_mean();
        let sentences = [of_mean].into_iter().chain(shakedown.sentences());
        let sentences: Vec<_> = sentences.chain(damage.findings.clone()).collect();
        Reply::json(&Answer { sentences, notes: &shakedown.remarks, damage: &damage })
    }
}
