//! Operating points along a wave, against numbers made apart from Riffel.

use riffel_answers::shakedown::ShakedownLimits;
use riffel_case::Case;
use serde_json::Value;

/// The case of these numbers of `growth.json`, with more keys of `contact`.
fn case_of(of: impl Fn(&str) -> f64, contact: &str, shear: f64, limit: &str) -> Case {
    let text = format!(
        "[wheel]\nrolling_radius = {}\nmass = {}\n[rail]\nmass_per_length = {}\nsecond_moment = {}\n\
         beam = \"euler-bernoulli\"\n[track]\nmodel = \"two-layer\"\nsupport_spacing = {}\n\
         pad = {{ stiffness = {}, damping = {} }}\nsleeper = {{ mass = {} }}\n\
         ballast = {{ stiffness = {}, damping = {} }}\n[contact]\ntransverse_radius = {}\nnormal_load = {}\n\
         friction = {}\ntractive_ratio = {}\n{contact}\n\
         [damage]\nshear_yield = {shear}\nlimit = \"{limit}\"\n",
        of("R"),
        of("mw"),
        of("mr"),
        of("I"),
        of("d"),
        of("kp"),
        of("cp"),
        of("ms"),
        of("kb"),
        of("cb"),
        of("Rr"),
        of("P0"),
        of("mu"),
        of("tau"),
    );
    Case::parse("case.toml", &text, &[]).unwrap()
}

/// P and Q linear, p₀ by the third root: 2e-4 of the printed numbers, demands by the line and by the surface.
// Long: makes a case of every row of its reference, twice.
#[test]
fn operating_points() {
    let growth: Value =
        serde_json::from_str(include_str!("../../../../validation/reference/damage/growth.json")).unwrap();
    let points = include_str!("../../../../validation/reference/damage/operating_points.csv");
    let mut worst = 0.0f64;
    for line in points.lines().skip(1) {
        let row: Vec<&str> = line.split(',').collect();
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let of = |key: &str| growth["cases"][row[0]][key].as_f64().unwrap();
        let shear = growth["shear_yield_pa"][row[0]].as_f64().unwrap();
        for (limit, column) in [("line", 12), ("surface", 11)] {
            let case = case_of(of, "wave_geometry = false", shear, limit);
            let question = ShakedownLimits {
                utilised_friction: vec![0.3],
                wave: Some([number(1), number(2)]),
                amplitude: Some(number(3)),
            };
            let answer = question.answer(&case).unwrap();
            let along = answer.along_wave.unwrap();
            let point = along.iter().find(|point| point.phase_deg == number(4)).unwrap();
            for (got, expected) in [
                (point.normal_force_n, number(6)),
                (point.tangential_force_n, number(7)),
                (point.p0_over_k, number(8)),
                (point.utilised_friction, number(9)),
                (point.demand, number(column)),
            ] {
                worst = worst.max((got / expected - 1.0).abs());
            }
            assert!((point.fi_surf - number(10)).abs() < 2e-5);
        }
    }
    assert!(worst < 2e-4, "{worst}");
}

/// Half a millimetre at 300 mm asks for more than the friction of 0.35 under high traction, a hundredth of that does not.
#[test]
fn more_friction_than_there_is_is_told() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/class-heavy-haul.toml"));
    let traction = ["contact.tractive_ratio=0.9".to_owned()];
    let case = Case::parse("case.toml", &text.unwrap(), &traction).unwrap();
    for (amplitude, told) in [(500e-6, true), (5e-6, false)] {
        let question = ShakedownLimits {
            utilised_friction: Vec::new(),
            wave: Some([0.3, 50.0 / 3.6]),
            amplitude: Some(amplitude),
        };
        let answer = question.answer(&case).unwrap();
        let remarks = answer.remarks.iter();
        let ids: Vec<&str> = remarks.map(|remark| remark.id()).collect();
        assert_eq!(ids.contains(&"more-friction-than-there-is"), told, "{ids:?}");
    }
}

/// Over waves whose geometry has a part the orbit has the pressure and the ellipse of the radius R/(1 + κ), against numbers made apart;
/// an amplitude at which the wheel bridges the troughs is refused.
#[test]
fn operating_points_on_waves() {
    let reference = |text: &str| serde_json::from_str::<Value>(text).unwrap();
    let growth = reference(include_str!("../../../../validation/reference/damage/growth.json"));
    let waves = reference(include_str!("../../../../validation/reference/damage/on_waves.json"));
    for row in waves["points"].as_array().unwrap() {
        let number = |key: &str| row[key].as_f64().unwrap();
        let case = &growth["cases"][row["case"].as_str().unwrap()];
        let of = |key: &str| case[key].as_f64().unwrap();
        for limit in ["surface", "subsurface"] {
            let hertz = row["hertz"].as_str().unwrap();
            let contact = format!("hertz = \"{hertz}\"\nwave_geometry = true");
            let case = case_of(of, &contact, number("shear_yield_pa"), limit);
            let ask = |amplitude| ShakedownLimits {
                utilised_friction: vec![0.3],
                wave: Some([number("wavelength_m"), number("speed_m_per_s")]),
                amplitude: Some(amplitude),
            };
            let along = ask(20e-6).answer(&case).unwrap().along_wave.unwrap();
            let point = along.iter().find(|point| point.phase_deg == 60.0).unwrap();
            let expected = &row["orbit_60_deg_20_um"];
            for (got, key) in [
                (point.p0_over_k, "p0_over_k"),
                (point.utilised_friction, "utilised_friction"),
                (point.fi_surf, "fi_surf"),
                (point.demand, &format!("demand_{limit}")),
            ] {
                let off = got / expected[key].as_f64().unwrap() - 1.0;
                assert!(off.abs() < 1e-6, "{row} {limit} {key}: {off:e}");
            }
            let refused = ask(1e-3).answer(&case).unwrap_err().to_string();
            assert!(refused.contains("bridges the troughs"), "{refused}");
        }
    }
}
