//! What each spread over the wheels of a vehicle does to growth.

use riffel::forecast::{SpeedDistribution, band_lines};
use riffel::roughness::ThirdOctave;
use riffel_keys::CaseError;

use super::{KeptWheels, VehicleRequest};
use crate::traffic::{SpreadEffect, Traffic, TrafficOnCase};
use crate::{Case, Variant};

impl Traffic {
    /// The traffic on a case, and what each spread does to the growth under its vehicle, the vehicles in their order: the fastest
    /// growth with every wheel at the mean of this spread over that with all of them. `progress` is told of each vehicle.
    ///
    /// Cost: that of [`on`](Self::on) with some wheels more for each spread.
    ///
    /// # Errors
    /// Errors of [`on`](Self::on).
    pub fn on_with_effects(
        &self,
        case: &Case,
        bands: &[ThirdOctave],
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<(TrafficOnCase, Vec<SpreadEffect>), CaseError> {
        let kept = KeptWheels::default();
        let on = self.on_keeping(&kept, case, bands, &Variant::none(""), progress)?;
        let effects = self.spread_effects(&kept, case, bands, &on)?;
        Ok((on, effects))
    }

    fn spread_effects(
        &self,
        kept: &KeptWheels,
        case: &Case,
        bands: &[ThirdOctave],
        on: &TrafficOnCase,
    ) -> Result<Vec<SpreadEffect>, CaseError> {
        let lines = band_lines(bands);
        let variant = Variant::none("");
        let mut effects = Vec::new();
        for (index, vehicle) in self.file.vehicle.iter().enumerate() {
            let asked =
                VehicleRequest { kept, traffic: self, index, case, lines: &lines, variant: &variant, speeds: None };
            let rates = &on.growth.vehicles()[index].growth.rates;
            let with = rates.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let traction = vehicle.traction_share.map_or(1.0, |share| share.si());
            let mut tell = |what: &str, without: f64| {
                effects.push(SpreadEffect {
                    vehicle: vehicle.name.clone(),
                    what: what.to_owned(),
                    reduction: (with > 0.0).then(|| traction * without / with),
                });
            };
            let spread = asked.spreads().spread_values();
            let (rules, _) = asked.rules(&spread, bands)?;
            let speeds = &self.speeds[index];
            if speeds.deviation() > 0.0
                && let Ok(mean) = SpeedDistribution::single(speeds.mean())
            {
                let at_mean = VehicleRequest { speeds: Some(&mean), ..asked };
                tell("speed", asked.fastest(&at_mean.parts(&rules)?));
            }
            for &place in &spread {
                let mut others = rules.clone();
                others[place] = None;
                let growth = asked.growth(&asked.parts(&others)?, bands, false)?;
                let rates = growth.growth.rates.into_iter();
                tell(asked.spreads().of_keys[place].name(), rates.fold(f64::NEG_INFINITY, f64::max));
            }
            if asked.spreads().lateral_position.is_some() || self.file.line.measured_line.is_some() {
                let growth = asked.growth(&asked.parts(&rules)?, bands, true)?;
                let rates = growth.growth.rates.into_iter();
                tell("lateral_position", rates.fold(f64::NEG_INFINITY, f64::max));
            }
        }
        Ok(effects)
    }
}
