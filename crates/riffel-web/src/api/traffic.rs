//! The traffic of the page, as a traffic file of the program.

use riffel_case::traffic::Traffic as CheckedTraffic;
use serde::{Deserialize, Serialize};

use crate::fault::Fault;

/// Most vehicles of one traffic.
const MOST_VEHICLES: usize = 12;
/// Longest name of a vehicle, in letters.
const LONGEST_NAME: usize = 60;
/// Fastest speed that is taken \[m/s\].
const FASTEST: f64 = 200.0;
/// Where the standard deviation of a speed reaches this share of its mean, no normal distribution stands for it.
const WIDEST_NORMAL: f64 = 0.25;
/// Speeds that stand for a wide range, each in the middle of an equal part of it.
const WIDE_RANGE_SPEEDS: usize = 16;

/// File of the traffic beside the record.
pub(super) const TRAFFIC_FILE: &str = "traffic.toml";

/// Speeds of the wheel of the case, or vehicles with speeds of their own.
#[derive(Deserialize)]
pub(super) struct Traffic {
    slowest_m_per_s: f64,
    fastest_m_per_s: f64,
    pub(super) passages_per_day: f64,
    #[serde(default)]
    vehicles: Vec<Vehicle>,
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

#[derive(Serialize)]
struct File<'a> {
    title: &'a str,
    line: Line,
    vehicle: Vec<Entry<'a>>,
}

#[derive(Serialize)]
struct Line {
    passages_per_day: f64,
}

#[derive(Serialize)]
struct Entry<'a> {
    name: &'a str,
    share: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    wheel_load: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tractive_ratio: Option<f64>,
    #[serde(flatten)]
    speeds: Speeds,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Speeds {
    Speed(Normal),
    Speeds(Vec<SpeedShare>),
}

#[derive(Serialize)]
struct Normal {
    mean: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    standard_deviation: Option<f64>,
}

#[derive(Serialize)]
struct SpeedShare {
    speed: f64,
    share: f64,
}

impl Speeds {
    /// Speeds spread evenly over a range: a normal distribution of their mean and standard deviation, or one by one
    /// where that would reach below standstill.
    fn even([slowest, fastest]: [f64; 2]) -> Self {
        let mean = f64::midpoint(slowest, fastest);
        // Of an even distribution.
        let deviation = (fastest - slowest) / 12f64.sqrt();
        if deviation < WIDEST_NORMAL * mean {
            let standard_deviation = (deviation > 0.0).then_some(deviation);
            return Self::Speed(Normal {
                mean,
                standard_deviation,
            });
        }
        let count = WIDE_RANGE_SPEEDS as f64;
        let places = (0..WIDE_RANGE_SPEEDS).map(|place| (place as f64 + 0.5) / count);
        Self::Speeds(
            places
                .map(|place| SpeedShare {
                    speed: slowest + (fastest - slowest) * place,
                    share: 1.0 / count,
                })
                .collect(),
        )
    }
}

impl Traffic {
    /// Refuse what makes no traffic.
    pub(super) fn check(&self) -> Result<(), Fault> {
        let own = [self.slowest_m_per_s, self.fastest_m_per_s];
        let ranges = self.vehicles.iter().map(Vehicle::range);
        for [slowest, fastest] in [own].into_iter().chain(ranges) {
            if !(slowest > 0.0 && slowest <= fastest && fastest < FASTEST) {
                return Err(Fault::bad(format!(
                    "the speeds of the traffic go from {:.1} to {:.1} km/h, but must be above zero and rise",
                    3.6 * slowest,
                    3.6 * fastest
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
            return Err(Fault::bad(format!(
                "there are {} vehicles, but the page takes {MOST_VEHICLES} at most",
                self.vehicles.len()
            )));
        }
        // Names, shares and all else by the rules of the program.
        CheckedTraffic::parse(TRAFFIC_FILE, &self.toml()?)?;
        Ok(())
    }

    /// The traffic file.
    pub(super) fn toml(&self) -> Result<String, Fault> {
        let of_the_case = Entry {
            name: "the wheel of the case",
            share: 1.0,
            wheel_load: None,
            tractive_ratio: None,
            speeds: Speeds::even([self.slowest_m_per_s, self.fastest_m_per_s]),
        };
        let entries: Vec<Entry<'_>> = self.vehicles.iter().map(Vehicle::entry).collect();
        let file = File {
            title: "traffic of the page",
            line: Line {
                passages_per_day: self.passages_per_day,
            },
            vehicle: if entries.is_empty() {
                vec![of_the_case]
            } else {
                entries
            },
        };
        toml::to_string(&file)
            .map_err(|error| Fault::bad(format!("the traffic cannot be written: {error}")))
    }

    /// Mean speed of the axle passages \[m/s\].
    pub(super) fn mean_speed(&self) -> f64 {
        let mean = |[slowest, fastest]: [f64; 2]| f64::midpoint(slowest, fastest);
        if self.vehicles.is_empty() {
            return mean([self.slowest_m_per_s, self.fastest_m_per_s]);
        }
        let shares: f64 = self.vehicles.iter().map(|vehicle| vehicle.share).sum();
        let speeds = self.vehicles.iter();
        speeds
            .map(|vehicle| vehicle.share * mean(vehicle.range()))
            .sum::<f64>()
            / shares
    }

    /// The range of speeds of the wheel of the case, for a diagnosis or a report; without one the program takes those of the
    /// vehicles of the traffic file.
    pub(super) fn speed_range(&self) -> Option<String> {
        let [slowest, fastest] = [self.slowest_m_per_s, self.fastest_m_per_s];
        let range = || format!("{slowest} m/s..{fastest} m/s");
        self.vehicles.is_empty().then(range)
    }
}

impl Vehicle {
    fn range(&self) -> [f64; 2] {
        [self.slowest_m_per_s, self.fastest_m_per_s]
    }

    fn entry(&self) -> Entry<'_> {
        let end = self.name.char_indices().nth(LONGEST_NAME);
        Entry {
            name: end.map_or(&self.name, |(end, _)| &self.name[..end]),
            share: self.share,
            wheel_load: self.wheel_load_n,
            tractive_ratio: self.tractive_ratio,
            speeds: Speeds::even(self.range()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn traffic(more: Value) -> Traffic {
        let mut given =
            json!({ "slowest_m_per_s": 20.0, "fastest_m_per_s": 30.0, "passages_per_day": 4000.0 });
        given["vehicles"] = more;
        serde_json::from_value(given).unwrap()
    }

    fn vehicle(name: &str, share: f64, speeds: [f64; 2]) -> Value {
        json!({ "name": name, "share": share, "slowest_m_per_s": speeds[0], "fastest_m_per_s": speeds[1] })
    }

    #[test]
    fn without_vehicles_it_is_the_wheel_of_the_case_at_even_speeds() {
        let traffic = traffic(json!([]));
        traffic.check().unwrap();
        let read = CheckedTraffic::parse("t", &traffic.toml().unwrap()).unwrap();
        let [only] = &read.file.vehicle[..] else {
            panic!("one vehicle")
        };
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
        traffic.check().unwrap();
        let read = CheckedTraffic::parse("t", &traffic.toml().unwrap()).unwrap();
        let [unit, freight] = &read.file.vehicle[..] else {
            panic!("two vehicles")
        };
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
        let Speeds::Speeds(list) = Speeds::even([10.0, 40.0]) else {
            panic!("speeds one by one")
        };
        let mean: f64 = list.iter().map(|one| one.share * one.speed).sum();
        let square = |one: &SpeedShare| one.share * (one.speed - mean).powi(2);
        let deviation = list.iter().map(square).sum::<f64>().sqrt();
        assert!((mean - 25.0).abs() < 1e-12);
        // n middles of equal parts have √(1 − 1/n²) of the scatter, 0.998 for 16.
        assert!((deviation / (30.0 / 12f64.sqrt()) - 1.0).abs() < 3e-3);
        let wide = traffic(json!([vehicle("any", 1.0, [10.0, 40.0])]));
        wide.check().unwrap();
    }

    #[test]
    fn what_the_program_refuses_is_refused_with_its_sentence() {
        for (vehicles, words) in [
            (json!([vehicle("a", 0.5, [20.0, 30.0])]), "sum to 0.5"),
            (
                json!([
                    vehicle("a", 0.0, [20.0, 30.0]),
                    vehicle("b", 1.0, [20.0, 30.0])
                ]),
                "greater than zero",
            ),
            (
                json!([
                    vehicle("a", -0.5, [20.0, 30.0]),
                    vehicle("b", 1.5, [20.0, 30.0])
                ]),
                "greater than zero",
            ),
            (
                json!([
                    vehicle("a", 0.5, [20.0, 30.0]),
                    vehicle("a", 0.5, [20.0, 30.0])
                ]),
                "a second time",
            ),
            (json!([vehicle(" ", 1.0, [20.0, 30.0])]), "is empty"),
            (
                json!([vehicle("a", 1.0, [30.0, 20.0])]),
                "must be above zero and rise",
            ),
            (
                json!([vehicle("a", 1.0, [0.0, 20.0])]),
                "must be above zero and rise",
            ),
        ] {
            let fault = traffic(vehicles).check().unwrap_err();
            assert!(fault.message().contains(words), "{}", fault.message());
        }
        let many: Vec<Value> = (0..13)
            .map(|k| vehicle(&k.to_string(), 1.0 / 13.0, [20.0, 30.0]))
            .collect();
        assert!(traffic(json!(many)).check().is_err());
    }
}
