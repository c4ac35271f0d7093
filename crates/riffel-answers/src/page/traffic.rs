//! The traffic of the page, as a traffic file of the program.

use riffel_case::Case;
use riffel_case::traffic::{
    CurveOfVehicle, Line, Traffic as CheckedTraffic, TrafficFile, Vehicle as VehicleKeys, WHEEL_OF_THE_CASE,
};
use riffel_keys::quantity::Quantity;
use riffel_keys::{say, shown_speed};
use serde::Deserialize;

use crate::page::{CaseText, Fault};

/// Most vehicles of one traffic.
const MOST_VEHICLES: usize = 12;
/// Longest name of a vehicle, in letters.
const LONGEST_NAME: usize = 60;
/// Fastest speed that is taken \[m/s\].
const FASTEST: f64 = 200.0;
/// File of the traffic beside the record, and its name in errors.
pub const TRAFFIC_FILE: &str = "traffic.toml";

/// Speeds of the wheel of the case, or vehicles with speeds of their own.
#[derive(Deserialize)]
pub struct Traffic {
    slowest_m_per_s: f64,
    fastest_m_per_s: f64,
    /// Axle passages a day.
    pub passages_per_day: f64,
    #[serde(default)]
    vehicles: Vec<Vehicle>,
    /// Every vehicle brings all its wheels through the curve of the case.
    #[serde(default)]
    all_wheels: bool,
}

#[derive(Deserialize)]
struct Vehicle {
    name: String,
    /// Of the axle passages; all sum to one.
    share: f64,
    slowest_m_per_s: f64,
    fastest_m_per_s: f64,
    /// That of the case if it is left out, as is the tractive ratio.
    #[serde(default)]
    wheel_load_n: Option<f64>,
    #[serde(default)]
    tractive_ratio: Option<f64>,
}

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
        let own = [self.slowest_m_per_s, self.fastest_m_per_s];
        let ranges = self.vehicles.iter().map(Vehicle::range);
        for [slowest, fastest] in [own].into_iter().chain(ranges) {
            if !(slowest > 0.0 && slowest <= fastest && fastest < FASTEST) {
                return Err(Fault::bad(say!(
                    the_speeds_of_the_traffic_go,
                    from = shown_speed(slowest, 1),
                    to = shown_speed(fastest, 1)
                )));
            }
        }
        let daily = self.passages_per_day;
        if !(daily > 0.0 && daily <= 1e6) {
            return Err(Fault::bad(format!(
                "axle passages a day: {daily}, but must be above zero and at most {}",
                1e6
            )));
        }
        if self.vehicles.len() > MOST_VEHICLES {
            return Err(Fault::bad(say!(
                there_are_vehicles_but_the_page,
                count = self.vehicles.len(),
                most_vehicles = MOST_VEHICLES
            )));
        }
        // Names, shares and all else by the rules of the program.
        Ok(CheckedTraffic::of_keys(TRAFFIC_FILE, &self.keys())?)
    }

    /// The traffic file.
    ///
    /// # Errors
    /// A [`Fault`] for one that cannot be written.
    pub fn toml(&self) -> Result<String, Fault> {
        toml::to_string(&self.keys()).map_err(|error| Fault::bad(format!("the traffic cannot be written: {error}")))
    }

    fn keys(&self) -> TrafficFile {
        let own = [self.slowest_m_per_s, self.fastest_m_per_s];
        let of_the_case = || VehicleKeys::named(WHEEL_OF_THE_CASE).at_even_speeds(own);
        let mut vehicle: Vec<VehicleKeys> = self.vehicles.iter().map(Vehicle::keys).collect();
        if vehicle.is_empty() {
            vehicle.push(of_the_case());
        }
        if self.all_wheels {
            for one in &mut vehicle {
                one.curve = Some(CurveOfVehicle::OfCase(true));
            }
        }
        TrafficFile {
            title: None,
            line: Line { passages_per_day: Some(self.passages_per_day), ..Line::default() },
            vehicle,
        }
    }

    /// Mean speed of the axle passages \[m/s\].
    #[must_use]
    pub fn mean_speed(&self) -> f64 {
        let mean = |[slowest, fastest]: [f64; 2]| f64::midpoint(slowest, fastest);
        if self.vehicles.is_empty() {
            return mean([self.slowest_m_per_s, self.fastest_m_per_s]);
        }
        let shares: f64 = self.vehicles.iter().map(|vehicle| vehicle.share).sum();
        let speeds = self.vehicles.iter();
        speeds.map(|vehicle| vehicle.share * mean(vehicle.range())).sum::<f64>() / shares
    }

    /// The range of speeds of the wheel of the case, for a diagnosis or a report; without one the program takes those of the
    /// vehicles of the traffic file.
    #[must_use]
    pub fn speed_range(&self) -> Option<String> {
        let [slowest, fastest] = [self.slowest_m_per_s, self.fastest_m_per_s];
        let range = || format!("{slowest} m/s..{fastest} m/s");
        self.vehicles.is_empty().then(range)
    }
}

impl Vehicle {
    fn range(&self) -> [f64; 2] {
        [self.slowest_m_per_s, self.fastest_m_per_s]
    }

    fn keys(&self) -> VehicleKeys {
        let end = self.name.char_indices().nth(LONGEST_NAME);
        let name = end.map_or(&*self.name, |(end, _)| &self.name[..end]);
        VehicleKeys {
            share: Quantity::new(self.share),
            wheel_load: self.wheel_load_n.map(Quantity::new),
            tractive_ratio: self.tractive_ratio.map(Quantity::new),
            ..VehicleKeys::named(name).at_even_speeds(self.range())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn traffic(more: Value) -> Traffic {
        let mut given = json!({ "slowest_m_per_s": 20.0, "fastest_m_per_s": 30.0, "passages_per_day": 4000.0 });
        given["vehicles"] = more;
        serde_json::from_value(given).unwrap()
    }

    fn vehicle(name: &str, share: f64, speeds: [f64; 2]) -> Value {
        json!({ "name": name, "share": share, "slowest_m_per_s": speeds[0], "fastest_m_per_s": speeds[1] })
    }

    #[test]
    fn without_vehicles_it_is_the_wheel_of_the_case_at_even_speeds() {
        let traffic = traffic(json!([]));
        traffic.read().unwrap();
        let read = CheckedTraffic::parse("t", &traffic.toml().unwrap()).unwrap();
        let [only] = &read.file.vehicle[..] else { panic!("one vehicle") };
        let speed = only.speed.unwrap();
        let deviation = speed.standard_deviation.unwrap().si();
        // Written and read as decimal digits, which hold every bit.
        assert_eq!((speed.mean.si(), deviation), (25.0, 10.0 / 12f64.sqrt()));
        assert_eq!(read.file.line.passages_per_day, Some(4000.0));
        assert_eq!(traffic.mean_speed(), 25.0);
        assert_eq!(traffic.speed_range().unwrap(), "20 m/s..30 m/s");
    }

    #[test]
    fn vehicles_are_those_of_the_program_whatever_they_are_called() {
        let mut freight = vehicle("fre\"ight\"\n[line]", 0.25, [20.0, 20.0]);
        freight["wheel_load_n"] = json!(80e3);
        freight["tractive_ratio"] = json!(0.03);
        let traffic = traffic(json!([vehicle("unit", 0.75, [30.0, 40.0]), freight]));
        traffic.read().unwrap();
        let read = CheckedTraffic::parse("t", &traffic.toml().unwrap()).unwrap();
        let [unit, freight] = &read.file.vehicle[..] else { panic!("two vehicles") };
        assert_eq!((unit.share.si(), unit.wheel_load), (0.75, None));
        assert_eq!(freight.name, "fre\"ight\"\n[line]");
        assert_eq!(freight.wheel_load.unwrap().si(), 80e3);
        assert_eq!(freight.tractive_ratio.unwrap().si(), 0.03);
        assert!(freight.speed.unwrap().standard_deviation.is_none());
        assert_eq!(traffic.mean_speed(), 0.75 * 35.0 + 0.25 * 20.0);
        assert_eq!(traffic.speed_range(), None);
    }

    #[test]
    fn a_wide_range_keeps_the_mean_and_scatter_of_even_speeds() {
        let wide = traffic(json!([vehicle("any", 1.0, [10.0, 40.0])]));
        let list = wide.keys().vehicle.remove(0).speeds.unwrap();
        let sum = |of: &dyn Fn(f64) -> f64| -> f64 {
            let one = list.iter();
            one.map(|one| one.share.si() * of(one.speed.si())).sum()
        };
        let mean = sum(&|speed| speed);
        let deviation = sum(&|speed| (speed - mean).powi(2)).sqrt();
        assert!((mean - 25.0).abs() < 1e-12);
        // n middles of equal parts have √(1 − 1/n²) of the scatter, 0.998 for 16.
        assert!((deviation / (30.0 / 12f64.sqrt()) - 1.0).abs() < 3e-3);
        wide.read().unwrap();
    }

    #[test]
    fn what_the_program_refuses_is_refused_with_its_sentence() {
        for (vehicles, words) in [
            (json!([vehicle("a", 0.5, [20.0, 30.0])]), "sum to 0.5"),
            (json!([vehicle("a", 0.0, [20.0, 30.0]), vehicle("b", 1.0, [20.0, 30.0])]), "greater than zero"),
            (json!([vehicle("a", -0.5, [20.0, 30.0]), vehicle("b", 1.5, [20.0, 30.0])]), "greater than zero"),
            (json!([vehicle("a", 0.5, [20.0, 30.0]), vehicle("a", 0.5, [20.0, 30.0])]), "a second time"),
            (json!([vehicle(" ", 1.0, [20.0, 30.0])]), "is empty"),
            (json!([vehicle("a", 1.0, [30.0, 20.0])]), "must be above zero and rise"),
            (json!([vehicle("a", 1.0, [0.0, 20.0])]), "must be above zero and rise"),
        ] {
            let fault = traffic(vehicles).read().err().unwrap();
            assert!(fault.message().contains(words), "{}", fault.message());
        }
        let many: Vec<Value> = (0..13).map(|k| vehicle(&k.to_string(), 1.0 / 13.0, [20.0, 30.0])).collect();
        assert!(traffic(json!(many)).read().is_err());
    }
}
