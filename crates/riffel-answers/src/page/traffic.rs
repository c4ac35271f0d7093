//! A case with the traffic of its line, as the page sends both.

use riffel_case::Case;
use riffel_case::traffic::{CurveOfVehicle, Traffic as CheckedTraffic};
use riffel_keys::say;
use serde::Deserialize;

use crate::page::{CaseText, Fault};

/// Most vehicles of one traffic.
const MOST_VEHICLES: usize = 12;
/// Name of the traffic in errors.
const NAME: &str = "traffic.toml";

/// The keys of a traffic file that names no other file.
#[derive(Deserialize)]
#[serde(transparent)]
pub struct Traffic(toml::Table);

/// A case with the traffic of its line.
#[derive(Deserialize)]
pub(crate) struct OnLine {
    case: CaseText,
    /// None, and it is the usual one.
    #[serde(default)]
    traffic: Option<Traffic>,
}

impl OnLine {
    pub(crate) fn read(&self) -> Result<(Case, Option<CheckedTraffic>), Fault> {
        let traffic = self.traffic.as_ref().map(Traffic::read).transpose()?;
        Ok((self.case.read()?, traffic))
    }
}

impl Traffic {
    /// The traffic as the program reads it.
    ///
    /// # Errors
    /// A [`Fault`] for what makes no traffic.
    pub fn read(&self) -> Result<CheckedTraffic, Fault> {
        let count = self.0.get("vehicle").and_then(toml::Value::as_array).map_or(0, Vec::len);
        if count > MOST_VEHICLES {
            return Err(Fault::bad(say!(
                there_are_vehicles_but_the_page,
                count = count,
                most_vehicles = MOST_VEHICLES
            )));
        }
        let traffic = CheckedTraffic::parse(NAME, &self.0.to_string())?;
        let mut vehicles = traffic.file.vehicle.iter();
        match vehicles.any(|vehicle| matches!(vehicle.curve, Some(CurveOfVehicle::File(_)))) {
            true => Err(Fault::bad(say!(place_is_not_for_a_page, key = "vehicle.curve"))),
            false => Ok(traffic),
        }
    }

    /// The traffic file.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read), and a [`Fault`] for one that cannot be written.
    pub fn toml(&self) -> Result<String, Fault> {
        let file = self.read()?.file;
        toml::to_string(&file).map_err(|error| Fault::bad(format!("the traffic cannot be written: {error}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn read(vehicles: &[Value]) -> Result<CheckedTraffic, Fault> {
        let keys = json!({ "line": { "passages_per_day": 4000.0 }, "vehicle": vehicles });
        serde_json::from_value::<Traffic>(keys).unwrap().read()
    }

    #[test]
    fn the_keys_are_those_of_the_program_whatever_a_vehicle_is_called() {
        let name = "fre\"ight\"\n[line]";
        let traffic = read(&[json!({ "name": name, "share": 1, "speed": { "mean": 25.125 }, "curve": true })]).unwrap();
        let [freight] = &traffic.file.vehicle[..] else { panic!("one vehicle") };
        assert_eq!((&*freight.name, freight.speed.unwrap().mean.si()), (name, 25.125));
        assert_eq!(traffic.file.line.passages_per_day, Some(4000.0));
    }

    #[test]
    fn what_the_program_refuses_is_refused_with_its_sentence() {
        let vehicle = |share: f64| json!({ "name": "a", "share": share, "speed": { "mean": 25.0 } });
        let mut through = vehicle(1.0);
        through["curve"] = json!("../curve.toml");
        for (vehicles, words) in [
            (vec![vehicle(0.5)], "sum to 0.5"),
            (vec![vehicle(0.5), vehicle(0.5)], "a second time"),
            (vec![vehicle(1.0 / 13.0); 13], "12"),
            (vec![through], "`vehicle.curve` is a place on the disk and not for a page"),
        ] {
            let fault = read(&vehicles).err().unwrap();
            assert!(fault.message().contains(words), "{}", fault.message());
        }
    }
}
