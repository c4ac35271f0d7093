//! Profiles, contact of wheelsets on their track, equivalent conicity, and curving on them.

use riffel_case::CurvingCase;
use riffel_curving::profile::{EquivalentConicity, Profile, RadiusDifference, Track, Wheels, WheelsetOnTrack};
use serde::Deserialize;
use serde_json::Value;

use crate::Row;
use crate::ground::WorstError;

macro_rules! reference {
    ($name:literal) => {
        include_str!(concat!("../reference/profiles/", $name))
    };
}

/// Table, description.
const NOMINAL: [(&str, &str); 2] = [
    (reference!("s1002_60e1_1in40.csv"), reference!("s1002_60e1_1in40.json")),
    (reference!("s1002_60e1_1in20.csv"), reference!("s1002_60e1_1in20.json")),
];
const MEASURED: [(&str, &str); 2] = [
    (reference!("mbench_yaw0.csv"), reference!("mbench_yaw0.json")),
    (reference!("mbench_yaw12.csv"), reference!("mbench_yaw12.json")),
];
const ON_PROFILES: &str = include_str!("../reference/curving/profiles.json");

fn nominal(description: &str) -> std::sync::Arc<WheelsetOnTrack> {
    let description: Value = serde_json::from_str(description).expect("valid JSON");
    let toml = description["case_toml"].as_str().expect("a case");
    let case = CurvingCase::parse("case.toml", toml, &[]).expect("a case");
    case.wheelset_on_track().expect("a wheelset")
}

/// The Manchester profiles, whose rail is inclined in its coordinates.
pub(crate) fn measured() -> WheelsetOnTrack {
    let profile = |text: &str| {
        let rows = text.lines().filter_map(|line| {
            let (x, height) = line.split_once(',')?;
            Some([1e-3 * x.parse::<f64>().ok()?, 1e-3 * height.parse::<f64>().ok()?])
        });
        Profile::through(&rows.collect::<Vec<_>>()).expect("a profile")
    };
    let (wheel, rail) = (profile(reference!("mbench_s1002.csv")), profile(reference!("mbench_uic60.csv")));
    WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [0.46; 2], 1.36, -0.07).expect("wheels"),
        track: Track::new([&rail, &rail], 1.435, 0.014, 0.0).expect("a track"),
    }
}

/// Largest errors: height of the axle \[mm\], roll \[rad\], positions \[mm\], angles \[rad\]; and the number of contacts.
#[derive(Default)]
struct Errors {
    height: f64,
    roll: f64,
    position: f64,
    angle: f64,
    contacts: usize,
}

impl Errors {
    fn compare(&mut self, wheelset: &WheelsetOnTrack, table: &str) {
        let mut lines = table.lines();
        let head: Vec<&str> = lines.next().expect("a head").split(',').collect();
        for line in lines {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
            let expected = |name: &str| cells[head.iter().position(|head| *head == name).expect("a column")];
            let contact = wheelset.contact(1e-3 * expected("lateral_shift_mm"), expected("yaw_rad")).expect("contact");
            let worse = |worst: &mut f64, got: f64, expected: f64| *worst = worst.max((got - expected).abs());
            worse(&mut self.height, 1e3 * contact.centre_z, expected("centre_z_mm"));
            worse(&mut self.roll, contact.roll, expected("roll_rad"));
            for (side, on) in ["left", "right"].into_iter().zip(&contact.contacts) {
                self.contacts += 1;
                let expected = |name: &str| expected(&format!("{side}_{name}"));
                worse(&mut self.position, 1e3 * on.x_wheel, expected("y_wheel_mm"));
                worse(&mut self.position, 1e3 * on.on_track[0], expected("x_track_mm"));
                worse(&mut self.position, 1e3 * on.on_track[1], expected("y_track_mm"));
                worse(&mut self.position, 1e3 * on.on_track[2], expected("z_track_mm"));
                worse(&mut self.position, 1e3 * on.rolling_radius, expected("rolling_radius_mm"));
                worse(&mut self.angle, on.contact_angle, expected("contact_angle_rad"));
            }
        }
    }

    /// Positions \[mm\] and angles \[rad\] have limits of the caller's.
    fn row(&self, statement: &'static str, tolerance: &'static str, least: usize, [position, angle]: [f64; 2]) -> Row {
        let holds = self.height <= 1e-4 && self.roll <= 2e-7 && self.position <= position && self.angle <= angle;
        let relation = if holds { "≤" } else { "above" };
        Row {
            statement,
            source: "`profiles/*.csv`, written apart from Riffel in Python, held against CONTACT to 5e-5 mm",
            expected: format!("{} contacts", self.contacts),
            got: format!("errors {relation} 1e-4 mm of height, 2e-7 rad of roll, {position} mm, {angle:e} rad"),
            tolerance,
            holds: holds && self.contacts >= least,
        }
    }
}

pub(crate) fn wheelset_on_nominal_rails() -> Row {
    let mut errors = Errors::default();
    for (table, description) in NOMINAL {
        errors.compare(&nominal(description), table);
    }
    errors.row(
        "S1002 on 60E1 inclined 1:40 and 1:20, every 0.1 mm to 10 mm: height of the axle, roll, places and angles of contact",
        "that stated by the reference; found 1e-7 mm and 1e-9 rad, 0.003 mm, 6e-6 rad",
        400,
        [0.05, 5e-4],
    )
}

pub(crate) fn wheelset_on_measured_rails() -> Row {
    let mut errors = Errors::default();
    let wheelset = measured();
    for (table, _) in MEASURED {
        errors.compare(&wheelset, table);
    }
    errors.row(
        "The same for the profiles of the Manchester benchmark, and to ±8 mm at a yaw of 12 mrad",
        "heights and roll as stated by the reference; places 0.15 mm and angles 1e-3: the reference stands up to 2e-5 mm above the least gap, which is that flat (see the README)",
        260,
        [0.15, 1e-3],
    )
}

pub(crate) fn conicity_of_a_cubic() -> Row {
    const LIMIT: f64 = 1e-6;
    let cases: Vec<Value> = serde_json::from_str(reference!("conicity-duffing.json")).expect("valid JSON");
    let mut error = WorstError::default();
    for case in &cases {
        let number = |key: &str| case[key].as_f64().expect("a number");
        let (g, c) = (number("g"), 1e6 * number("c_per_mm2"));
        let found = EquivalentConicity::at(
            |y| 2.0 * g * y + c * y.powi(3),
            [-1.0, 1.0],
            1e-3 * number("amplitude_mm"),
            1e-3 * number("e_mm"),
            1e-3 * number("wheel_radius_mm"),
        )
        .expect("a motion");
        for (key, got) in [
            ("klingel", found.klingel),
            ("harmonic", found.harmonic),
            ("regression", found.regression),
            ("wavelength_mm", 1e3 * found.wavelength),
        ] {
            let expected = case["expect"][key].as_f64().expect("a number");
            error.compare(got.into(), expected.into());
        }
    }
    Row {
        statement: "Equivalent conicity of Δr = 2gy + cy³ by three rules, 18 cases",
        source: "`profiles/conicity-duffing.json`: closed form with elliptic integrals",
        expected: format!("{} values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-6: midpoint rule over 8000 pieces of half a wave",
        holds: error.within(LIMIT) && error.compared == 72,
    }
}

pub(crate) fn equivalent_conicity() -> Row {
    const LIMIT: f64 = 1e-4;
    let mut error = WorstError::default();
    let tables = NOMINAL.iter().map(|(_, description)| (nominal(description), *description, 1.0));
    for (wheelset, description, size) in tables.chain([(measured().into(), MEASURED[0].1, 5.0)]) {
        let description: Value = serde_json::from_str(description).expect("valid JSON");
        let table = RadiusDifference::rolling(&wheelset, 0.46, 0.010, 1e-4).expect("a table");
        let conicities = description["equivalent_conicity"].as_object().expect("conicities");
        for (amplitude, expected) in conicities {
            let amplitude: f64 = amplitude.parse().expect("a number");
            let found = table.equivalent_conicity(1e-3 * amplitude, 1.5).expect("a motion");
            for (key, got) in
                [("klingel", found.klingel), ("harmonic", found.harmonic), ("regression", found.regression)]
            {
                let expected = expected[key].as_f64().expect("a number");
                error.compare_beside(size, got.into(), expected.into());
            }
        }
    }
    Row {
        statement: "Equivalent conicity of S1002 on 60E1 at 1:40 and 1:20 and of the Manchester profiles, to 7 mm",
        source: "`profiles/*.json`, from their tables of 0.1 mm",
        expected: format!("{} values", error.compared),
        got: format!("{}, absolute", error.describe(LIMIT)),
        tolerance: "1e-4: jumps of Δr within a step of the table; 5e-4 for the Manchester profiles, for the places of their contacts",
        holds: error.within(LIMIT) && error.compared >= 60,
    }
}

#[derive(Deserialize)]
struct CurvingReference {
    name: String,
    case_toml: String,
    expect: Value,
}

pub(crate) fn curving_on_profiles() -> Row {
    const LIMIT: f64 = 2e-3;
    let cases: Vec<CurvingReference> = serde_json::from_str(ON_PROFILES).expect("valid JSON");
    let mut error = WorstError::default();
    for reference in cases {
        let case = CurvingCase::parse(&reference.name, &reference.case_toml, &[]).expect("a case");
        let equilibria = case.vehicle_in_curve().and_then(|vehicle| case.equilibria(&vehicle));
        let equilibria = equilibria.expect("an equilibrium");
        let expect = &reference.expect;
        let number = |table: &str, index: usize, key: &str| expect[table][index][key].as_f64().expect("a number");
        // Where Δr jumps there may be several; the reference stands between the jumps.
        let distance = |state: &riffel_curving::VehicleState| {
            (0..2)
                .map(|index| {
                    (state.wheelsets[index].lateral_shift - number("wheelsets", index, "lateral_shift_m")).abs()
                })
                .fold(0.0, f64::max)
        };
        let state = equilibria.iter().min_by(|one, other| distance(one).total_cmp(&distance(other))).expect("a state");
        let largest = |table: &str, key: &str, count: usize| {
            (0..count).map(|index| number(table, index, key).abs()).fold(0.0, f64::max)
        };
        for (index, wheelset) in state.wheelsets.iter().enumerate() {
            let key = "lateral_shift_m";
            let size = largest("wheelsets", key, 2);
            error.compare_beside(size, wheelset.lateral_shift.into(), number("wheelsets", index, key).into());
        }
        for (index, wheel) in state.wheels.iter().enumerate() {
            for (key, got) in [
                ("longitudinal_force_n", wheel.creep_forces.longitudinal),
                ("lateral_force_n", wheel.creep_forces.lateral),
                ("normal_force_n", wheel.normal_force),
            ] {
                let size = largest("wheels", key, 4);
                error.compare_beside(size, got.into(), number("wheels", index, key).into());
            }
        }
    }
    Row {
        statement: "Two-axle bogie on S1002 and 60E1 in 4 curves of 700–6000 m: shifts and forces",
        source: "`curving/profiles.json`, written apart from Riffel in Python",
        expected: format!("{} values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "2e-3: the accuracy the reference states, cubics between rows of the contact table",
        holds: error.within(LIMIT) && error.compared == 56,
    }
}
