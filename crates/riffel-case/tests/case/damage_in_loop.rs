//! Laws of damage in maps, ridges, on all axes, with the wave's own geometry; limits and bad inputs.

use riffel::growth::RowEvaluator;
use riffel::{Axis, GrowthMap};
use riffel_case::file::RailGrade;
use riffel_case::{Case, DamagePoint, Point};

const DAMAGE: &str = "\n[damage]\nshear_yield = \"230 MPa\"\nlimit = \"line\"\n\
    laws = [\"wear\", \"load\", \"flow\", \"flow-along\", \"bending\", \"fatigue\"]\nflow = { depth = \"1 nm\", exponent = 2 }\n\
    flow_along = { area = \"1e-12 m2\" }\nload = { depth_per_force = \"1e-15 m/N\" }\n\
    bending = { limit = \"11 kN m\", curvature = \"1e-9 1/m\" }\n\
    fatigue = { thresholds = [\"0.2 N\", \"1 N\", \"3 N\"], peak = 1e-5, loss = \"1 mm\" }\n";

fn case(text: &str, damage: &str, overrides: &[&str]) -> Case {
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    Case::parse("case.toml", &format!("{text}{damage}"), &overrides).unwrap()
}

const METRO: &str = include_str!("../../cases/metro.toml");

fn damage_of(case: &Case, wavelength: f64, speed: f64) -> DamagePoint {
    let state = case.point(wavelength, speed).unwrap();
    Point::new(case, &state).damage.unwrap()
}

fn of(values: &riffel_case::ByLaw, law: &str) -> f64 {
    values.0.iter().find(|(name, _)| *name == law).unwrap().1
}

/// A map, a row and a course take the sum that a point tells, linear and above limits, with the wave's own geometry and on all
/// axes, under several wheels and under supports at their places.
#[test]
fn every_path_takes_the_sum() {
    let wheelset = include_str!("../../cases/wheelset-metro-motor.toml");
    let one_layer = "track.model=one-layer";
    for (text, overrides) in [
        (METRO, vec![one_layer, "contact.wave_geometry=false"]),
        (METRO, vec![one_layer, "contact.wave_geometry=true"]),
        (
            METRO,
            vec![one_layer, "wheel.rotation=constant-tangential-force"],
        ),
        (
            METRO,
            vec!["track.model=one-layer-periodic", "track.position=0.2 m"],
        ),
        (METRO, vec![one_layer, "train.wheels=[0, 2.1]"]),
        (wheelset, vec![]),
    ] {
        for amplitude in ["corrugation.amplitude=1 um", "corrugation.amplitude=200 um"] {
            let mut all = overrides.clone();
            all.push(amplitude);
            let case = case(text, DAMAGE, &all);
            assert!(case.feedback.depends_on_amplitude());
            let wavelengths: Vec<f64> = (0..70).map(|i| 0.02 * 1.05f64.powi(i)).collect();
            let mut row = vec![riffel::Complex64::ZERO; wavelengths.len()];
            RowEvaluator::new(&case.feedback, &wavelengths).evaluate(17.0, &mut row);
            let per = case.feedback.growth_rate_per_dissipation();
            let mut clipped = 0;
            for (wavelength, value) in wavelengths.iter().zip(&row) {
                let state = case.feedback.at(*wavelength, 17.0);
                let sum = case.feedback.complex_growth_rate(*wavelength, 17.0);
                let got = per * value;
                // Laws cancel to some part of their sizes.
                let damage = Point::new(&case, &state).damage.unwrap();
                let size: f64 = (damage.growth_by_law.0.iter().chain(&damage.drift_by_law.0))
                    .map(|(_, rate)| rate.abs())
                    .sum();
                let tolerance = 1e-9 * size;
                assert!(
                    (got - sum).norm() < tolerance,
                    "{overrides:?} {wavelength}: {got} {sum}"
                );
                assert!((got.re - state.growth_rate).abs() < tolerance);
                clipped += usize::from(damage.amplitude_at_limit_m < case.feedback.amplitude());
            }
            if amplitude.contains("200") {
                assert!(clipped > 0, "{overrides:?}");
            }
        }
    }
}

/// A whole map is its points.
#[test]
fn a_map_is_its_points() {
    let case = case(METRO, DAMAGE, &["track.model=one-layer"]);
    let axes = [(0.03, 0.3, 12), (8.0, 22.0, 5)];
    let [wavelength, speed] = axes.map(|(low, high, points)| Axis::new(low, high, points).unwrap());
    let map = GrowthMap::compute(&case.feedback, wavelength, speed, |_| {});
    for (speed, row) in map.rows() {
        for (wavelength, value) in wavelength.values().iter().zip(row) {
            let got = map.growth_rate_per_dissipation() * value.re;
            let expected = case.feedback.at(*wavelength, speed).growth_rate;
            assert!(
                (got - expected).abs() < 1e-8 * expected.abs().max(1e-9),
                "{got} {expected}"
            );
        }
    }
}

/// Wear named among the laws is wear alone.
#[test]
fn wear_alone_is_wear() {
    let plain = case(METRO, "", &[]);
    let named = case(METRO, "\n[damage]\nlaws = [\"wear\"]\n", &[]);
    for wavelength in [0.03, 0.06, 0.25] {
        let [one, other] =
            [&plain, &named].map(|case| case.feedback.at(wavelength, 16.0).growth_rate);
        assert!((one / other - 1.0).abs() < 1e-12);
    }
    // The mild regime is the energy law of 5.3e-9 kg/J.
    let mild = case(METRO, "", &["wear.law=usfd", "contact.tractive_ratio=0.02"]);
    let energy = case(
        METRO,
        "",
        &[
            "wear.coefficient=5.3e-9 kg/J",
            "contact.tractive_ratio=0.02",
        ],
    );
    let [one, other] = [&mild, &energy].map(|case| case.feedback.at(0.05, 16.0).growth_rate);
    assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
}

/// Demand over the wave: −⅔ of the load at constant force, +⅓ in full slip and 0 at small creepage under a held wheel.
#[test]
fn demand_of_the_surface_in_its_limits() {
    let share = |overrides: &[&str]| {
        let mut all = vec!["track.model=one-layer", "contact.wave_geometry=false"];
        all.extend(overrides);
        let case = case(METRO, "\n[damage]\nlimit = \"surface\"\n", &all);
        let state = case.feedback.at(0.1, 15.0);
        let load = state.normal_force() / (case.feedback.amplitude() * case.hertz.normal_force());
        let damage = Point::new(&case, &state).damage.unwrap();
        let demand = riffel::Complex64::new(damage.demand_1[0], damage.demand_1[1]) / damage.demand;
        demand / load
    };
    let force = share(&["wheel.rotation=constant-tangential-force"]);
    assert!((force + 2.0 / 3.0).norm() < 1e-9, "{force}");
    let held = "wheel.rotation=constant-creepage";
    let stick = share(&[held, "contact.tractive_ratio=0.001"]);
    assert!(stick.norm() < 2e-3, "{stick}");
    let slip = share(&[held, "contact.tractive_ratio=0.999"]);
    assert!((slip - 1.0 / 3.0).norm() < 0.02, "{slip}");
}

/// Below the limit flow makes nothing of small waves, without friction neither; where part of a wave is above it, it does.
#[test]
fn flow_begins_at_the_limit() {
    let damage =
        "\n[damage]\nshear_yield = \"900 MPa\"\nlaws = [\"flow\"]\nflow = { depth = \"1 nm\" }\n";
    let below = case(METRO, damage, &["track.model=one-layer"]);
    let point = damage_of(&below, 0.2, 15.0);
    assert!(point.demand < 1.0);
    assert_eq!(of(&point.growth_by_law, "flow"), 0.0);
    assert_eq!(below.feedback.at(0.2, 15.0).growth_rate, 0.0);
    let at_limit = point.amplitude_at_limit_m;
    let above = below
        .feedback
        .clone()
        .with_amplitude(1.5 * at_limit)
        .unwrap();
    assert!(above.at(0.2, 15.0).growth_rate != 0.0);
    // Without friction in use: u = p₀/4k of a line.
    let rolling = case(
        METRO,
        damage,
        &["track.model=one-layer", "contact.tractive_ratio=1e-6"],
    );
    let point = damage_of(&rolling, 0.2, 15.0);
    let expected = point.contact_pressure_pa / (4.0 * 900e6);
    assert!(
        (point.demand / expected - 1.0).abs() < 1e-5,
        "{}",
        point.demand
    );
}

/// FI_surf is zero where the demand of the surface is one.
#[test]
fn index_and_demand_agree() {
    let probe = case(METRO, "\n[damage]\nlimit = \"surface\"\n", &[]);
    let point = damage_of(&probe, 0.1, 15.0);
    let shear = point.contact_pressure_pa * point.utilised_friction;
    let at = case(
        METRO,
        "\n[damage]\nlimit = \"surface\"\n",
        &[&format!("damage.shear_yield={shear:e}")],
    );
    let point = damage_of(&at, 0.1, 15.0);
    assert!((point.demand - 1.0).abs() < 1e-12 && point.fi_surf.abs() < 1e-12);
}

/// Derivatives of demand and index by finite differences of the mean state, 1e-8 of central differences.
#[test]
fn slopes_of_the_demand() {
    use riffel::damage::{Demand, ShakedownLimit};
    let case = case(METRO, "\n[damage]\n", &["contact.tractive_ratio=0.6"]);
    let (steady, pressure) = (case.steady, case.hertz.peak_pressure());
    for limit in [
        ShakedownLimit::Surface,
        ShakedownLimit::Line,
        ShakedownLimit::Subsurface { ratio: 1.4 },
    ] {
        let at = |load: f64, along: f64, across: f64| {
            let mut state = steady;
            state.normal_force = load;
            (state.forces.longitudinal, state.forces.lateral) = (along, across);
            let pressure = pressure * (load / steady.normal_force).cbrt();
            Demand::new(&state, pressure, 300e6, limit).unwrap()
        };
        let [p, q, t] = [
            steady.normal_force,
            steady.forces.longitudinal,
            0.3 * steady.forces.longitudinal,
        ];
        let here = at(p, q, t);
        let step = 1e-5 * p;
        let slopes = [[step, 0.0, 0.0], [0.0, step, 0.0], [0.0, 0.0, step]].map(|[dp, dq, dt]| {
            let [up, down] = [1.0, -1.0].map(|s| at(p + s * dp, q + s * dq, t + s * dt));
            let half = 2.0 * step;
            [
                (up.value - down.value) / half,
                (up.fatigue_index - down.fatigue_index) / half,
            ]
        });
        let expected = [
            [here.by_load, here.fatigue_index_by_load],
            [here.by_force[0], here.fatigue_index_by_force[0]],
            [here.by_force[1], here.fatigue_index_by_force[1]],
        ];
        for (got, expected) in slopes.as_flattened().iter().zip(expected.as_flattened()) {
            assert!(
                (got - expected).abs() < 1e-7 / p,
                "{limit:?}: {got} {expected}"
            );
        }
    }
}

/// Grades stand in their order, and a yield that is written comes before.
#[test]
fn grades_of_rail() {
    let shear = |damage: &str| case(METRO, damage, &[]).shear_yield();
    assert_eq!(shear("\n[damage]\ngrade = \"R260\"\n"), 300e6);
    assert_eq!(
        shear("\n[damage]\ngrade = \"R260\"\nshear_yield = \"410 MPa\"\n"),
        410e6
    );
    let [soft, usual, hard] =
        [RailGrade::R200, RailGrade::R260, RailGrade::R350HT].map(RailGrade::shear_yield);
    assert!(soft < usual && usual < hard);
}

#[test]
fn bad_inputs_are_refused() {
    for (damage, overrides, words) in [
        (
            "\n[damage]\nshear_yield = \"-1 MPa\"\n",
            vec![],
            vec!["damage.shear_yield"],
        ),
        (
            "\n[damage]\nlimit = \"plastic\"\n",
            vec![],
            vec!["plastic", "subsurface"],
        ),
        (
            "\n[damage]\nlaws = [\"flow\"]\n",
            vec![],
            vec!["damage.flow"],
        ),
        (
            "\n[damage]\nlaws = [\"wear\", \"wear\"]\n",
            vec![],
            vec!["damage.laws", "twice"],
        ),
        (
            "\n[damage]\nlaws = [\"fatigue\"]\nfatigue = { thresholds = [\"15 N\", \"10 N\", \"175 N\"] }\n",
            vec![],
            vec!["damage.fatigue.thresholds", "between"],
        ),
        (
            "\n[damage]\nlaws = [\"fatigue\"]\nfatigue = { thresholds = [\"15 N\"] }\n",
            vec![],
            vec!["damage.fatigue.thresholds", "three"],
        ),
        (
            "\n[damage]\nlaws = [\"bending\"]\nbending = { limit = \"80 kN m\", curvature = 1e-10 }\n",
            vec!["track.model=free-beam"],
            vec!["damage.laws", "bending"],
        ),
        (
            "\n[damage]\nlaws = [\"flow\"]\nflow = { depth = \"1 nm\", exponent = 0.5 }\n",
            vec![],
            vec!["damage.flow.exponent"],
        ),
        ("", vec!["wear.spread=0.5"], vec!["wear.spread", "usfd"]),
    ] {
        let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
        let error = Case::parse("case.toml", &format!("{METRO}{damage}"), &overrides);
        let error = match error {
            Ok(_) => panic!("{damage} {overrides:?}"),
            Err(error) => {
                let sentence = error.to_string();
                format!("{sentence} {:?}", miette::Report::new(error))
            }
        };
        for word in words {
            assert!(error.contains(word), "{damage}: {error}");
        }
    }
    // Friction beyond what was compared is remarked.
    let slippery = case(
        METRO,
        "\n[damage]\n",
        &["contact.friction=0.8", "contact.tractive_ratio=0.9"],
    );
    let remarks: Vec<String> = slippery.remarks.iter().map(ToString::to_string).collect();
    assert!(
        remarks.iter().any(|remark| remark.contains("0.6")),
        "{remarks:?}"
    );
}
