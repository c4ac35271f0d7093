//! Laws of damage in maps, ridges, on all axes, with the wave's own geometry; limits and bad inputs.

use riffel::forecast::{Forecast, ForecastBand, LINES_PER_BAND, SpeedDistribution, band_lines};
use riffel::growth::RowEvaluator;
use riffel::roughness::Spectrum;
use riffel::{Axis, GrowthMap};
use riffel_case::file::RailGrade;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, DamagePoint, Point, Variant, ask};

const DAMAGE: &str = "\n[damage]\nshear_yield = \"230 MPa\"\nlimit = \"line\"\n\
    laws = [\"wear\", \"load\", \"flow\", \"flow-along\", \"bending\", \"fatigue\"]\nflow = { depth = \"1 nm\", exponent = 2 }\n\
    flow_along = { area = \"1e-12 m2\" }\nload = { depth_per_force = \"1e-15 m/N\" }\n\
    bending = { limit = \"11 kN m\", curvature = \"1e-9 1/m\" }\n\
    fatigue = { thresholds = [\"0.2 N\", \"1 N\", \"3 N\"], peak = 1e-5, loss = \"1 mm\" }\n";

fn case(text: &str, damage: &str, overrides: &[&str]) -> Case {
    crate::parsed(&format!("{text}{damage}"), overrides).unwrap()
}

const METRO: &str = include_str!("../../cases/metro.toml");

const HEAVY_HAUL: &str = include_str!("../../cases/class-heavy-haul.toml");

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
        (METRO, vec![one_layer, "wheel.rotation=constant-tangential-force"]),
        (METRO, vec!["track.model=one-layer-periodic", "track.position=0.2 m"]),
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
                let size: f64 =
                    (damage.growth_by_law.0.iter().chain(&damage.drift_by_law.0)).map(|(_, rate)| rate.abs()).sum();
                let tolerance = 1e-9 * size;
                assert!((got - sum).norm() < tolerance, "{overrides:?} {wavelength}: {got} {sum}");
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
            assert!((got - expected).abs() < 1e-8 * expected.abs().max(1e-9), "{got} {expected}");
        }
    }
}

/// Wear named among the laws is wear alone.
#[test]
fn wear_alone_is_wear() {
    let plain = case(METRO, "", &[]);
    let named = case(METRO, "\n[damage]\nlaws = [\"wear\"]\n", &[]);
    for wavelength in [0.03, 0.06, 0.25] {
        let [one, other] = [&plain, &named].map(|case| case.feedback.at(wavelength, 16.0).growth_rate);
        assert!((one / other - 1.0).abs() < 1e-12);
    }
    // The mild regime is the energy law of 5.3e-9 kg/J.
    let mild = case(METRO, "", &["wear.law=usfd", "contact.tractive_ratio=0.02"]);
    let energy = case(METRO, "", &["wear.coefficient=5.3e-9 kg/J", "contact.tractive_ratio=0.02"]);
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
    let damage = "\n[damage]\nshear_yield = \"900 MPa\"\nlaws = [\"flow\"]\nflow = { depth = \"1 nm\" }\n";
    let below = case(METRO, damage, &["track.model=one-layer"]);
    let point = damage_of(&below, 0.2, 15.0);
    assert!(point.demand < 1.0);
    assert_eq!(of(&point.growth_by_law, "flow"), 0.0);
    assert_eq!(below.feedback.at(0.2, 15.0).growth_rate, 0.0);
    let at_limit = point.amplitude_at_limit_m;
    let above = below.feedback.clone().with_amplitude(1.5 * at_limit).unwrap();
    assert!(above.at(0.2, 15.0).growth_rate != 0.0);
    // Without friction in use: u = p₀/4k of a line.
    let rolling = case(METRO, damage, &["track.model=one-layer", "contact.tractive_ratio=1e-6"]);
    let point = damage_of(&rolling, 0.2, 15.0);
    let expected = point.contact_pressure_pa / (4.0 * 900e6);
    assert!((point.demand / expected - 1.0).abs() < 1e-5, "{}", point.demand);
}

/// FI_surf is zero where the demand of the surface is one.
#[test]
fn index_and_demand_agree() {
    let probe = case(METRO, "\n[damage]\nlimit = \"surface\"\n", &[]);
    let point = damage_of(&probe, 0.1, 15.0);
    let shear = point.contact_pressure_pa * point.utilised_friction;
    let at = case(METRO, "\n[damage]\nlimit = \"surface\"\n", &[&format!("damage.shear_yield={shear:e}")]);
    let point = damage_of(&at, 0.1, 15.0);
    assert!((point.demand - 1.0).abs() < 1e-12 && point.fi_surf.abs() < 1e-12);
}

/// Derivatives of demand and index by finite differences of the mean state, 1e-8 of central differences.
#[test]
fn slopes_of_the_demand() {
    use riffel::damage::{Demand, ShakedownLimit};
    let case = case(METRO, "\n[damage]\n", &["contact.tractive_ratio=0.6"]);
    let (steady, pressure) = (case.steady, case.hertz.peak_pressure());
    for limit in [ShakedownLimit::Surface, ShakedownLimit::Line, ShakedownLimit::Subsurface { ratio: 1.4 }] {
        let at = |load: f64, along: f64, across: f64| {
            let mut state = steady;
            state.normal_force = load;
            (state.forces.longitudinal, state.forces.lateral) = (along, across);
            let pressure = pressure * (load / steady.normal_force).cbrt();
            Demand::new(&state, pressure, 300e6, limit).unwrap()
        };
        let [p, q, t] = [steady.normal_force, steady.forces.longitudinal, 0.3 * steady.forces.longitudinal];
        let here = at(p, q, t);
        let step = 1e-5 * p;
        let slopes = [[step, 0.0, 0.0], [0.0, step, 0.0], [0.0, 0.0, step]].map(|[dp, dq, dt]| {
            let [up, down] = [1.0, -1.0].map(|s| at(p + s * dp, q + s * dq, t + s * dt));
            let half = 2.0 * step;
            [(up.value - down.value) / half, (up.fatigue_index - down.fatigue_index) / half]
        });
        let expected = [
            [here.by_load, here.fatigue_index_by_load],
            [here.by_force[0], here.fatigue_index_by_force[0]],
            [here.by_force[1], here.fatigue_index_by_force[1]],
        ];
        for (got, expected) in slopes.as_flattened().iter().zip(expected.as_flattened()) {
            assert!((got - expected).abs() < 1e-7 / p, "{limit:?}: {got} {expected}");
        }
    }
}

/// Grades stand in their order, and a yield that is written comes before.
#[test]
fn grades_of_rail() {
    let shear = |damage: &str| ask::shear_yield(&case(METRO, damage, &[]));
    assert_eq!(shear("\n[damage]\ngrade = \"R260\"\n"), 300e6);
    assert_eq!(shear("\n[damage]\ngrade = \"R260\"\nshear_yield = \"410 MPa\"\n"), 410e6);
    let [soft, usual, hard] = [RailGrade::R200, RailGrade::R260, RailGrade::R350HT].map(RailGrade::shear_yield);
    assert!(soft < usual && usual < hard);
}

/// A yield so low that the whole patch is plastic is said, a usual one is not.
#[test]
fn beyond_the_elastic_range() {
    for (shear_yield, said) in [("100 MPa", true), ("300 MPa", false)] {
        let shear_yield = format!("damage.shear_yield={shear_yield}");
        let case = case(HEAVY_HAUL, "", &["damage.laws=[\"flow\"]", &shear_yield]);
        let mut remarks = case.remarks.iter().map(ToString::to_string);
        let found = remarks.any(|remark| remark.contains("whole patch is plastic"));
        assert_eq!(found, said, "{shear_yield}");
    }
}

#[test]
fn bad_inputs_are_refused() {
    for (damage, overrides, words) in [
        ("\n[damage]\nshear_yield = \"-1 MPa\"\n", vec![], vec!["damage.shear_yield"]),
        ("\n[damage]\nlimit = \"plastic\"\n", vec![], vec!["plastic", "subsurface"]),
        ("\n[damage]\nlaws = [\"flow\"]\n", vec![], vec!["damage.flow"]),
        ("\n[damage]\nlaws = [\"wear\", \"wear\"]\n", vec![], vec!["damage.laws", "twice"]),
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
        let error = crate::parsed(&format!("{METRO}{damage}"), &overrides);
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
    let slippery = case(METRO, "\n[damage]\n", &["contact.friction=0.8", "contact.tractive_ratio=0.9"]);
    let remarks: Vec<String> = slippery.remarks.iter().map(ToString::to_string).collect();
    assert!(remarks.iter().any(|remark| remark.contains("0.6")), "{remarks:?}");
}

/// A rail of 1 µm in all bands under the wheel of a case at one speed.
fn forecast(case: &Case, speed: f64) -> Forecast {
    let bands = bands_of(case);
    let traffic = Traffic::of_case(SpeedDistribution::single(speed).unwrap());
    let on = traffic.on(case, &bands, &Variant::none(""), &|_| ());
    let spectrum = Spectrum::new(bands.iter().map(|band| (*band, 20.0))).unwrap();
    Forecast::new(&spectrum, on.unwrap().growth).unwrap()
}

/// Lines of a band of a forecast.
fn lines(band: &ForecastBand) -> Vec<f64> {
    band_lines(&[band.now.band])
}

/// A forecast of flow that hardens ends where closed forms say, line by line, and tells whether it runs away; the point says the same.
#[test]
fn a_forecast_hardens() {
    let speed = 14.0;
    for (depth, wears) in [("0.2 mm", false), ("20 mm", false), ("0.2 mm", true)] {
        let laws = if wears { "\"wear\", \"flow\"" } else { "\"flow\"" };
        let laws = format!("damage.laws=[{laws}]");
        let hardens = format!("damage.flow.hardening_depth=\"{depth}\"");
        let sharp = ["damage.spread=0", "damage.limit=subsurface", "damage.shear_yield=200e6"];
        let overrides = [&sharp[..], &[&laws, &hardens]].concat();
        let case = case(HEAVY_HAUL, "", &overrides);
        let demand = case.feedback.contacts()[0].damage.as_ref().unwrap().demand;
        assert!(demand.excess() > 0.1);
        let forecast = forecast(&case, speed);
        let mut grown = 0;
        for band in forecast.bands() {
            let ends: Vec<(f64, f64)> = lines(band)
                .into_iter()
                .map(|line| {
                    let state = case.feedback.at(line, speed).contacts[0].damage.unwrap();
                    let (number, ratio) = state.hardened.unwrap();
                    (number, ratio.norm_sqr())
                })
                .collect();
            let most = ends.iter().map(|end| end.0).fold(f64::NEG_INFINITY, f64::max);
            let told = band.hardening().unwrap();
            assert!((told.runaway_number - most).abs() < 1e-6 * most.abs().max(1e-3));
            assert_eq!(told.wave_ratio.is_none(), most >= 1.0);
            let change = band.level(1e7) - band.level(0.0);
            let closed = 10.0 * (ends.iter().map(|end| end.1).sum::<f64>() / ends.len() as f64).log10();
            match (wears, most >= 1.0) {
                // Wear goes on, for better or worse.
                (true, _) => {}
                (false, true) => assert!(band.level(1e9) - band.level(1e7) > 10.0),
                // 0.26 dB are 3 %; what decays keeps its level.
                (false, false) => {
                    assert!((change - closed.max(0.0)).abs() < 0.05, "{change} {closed}")
                }
            }
            grown += usize::from(most >= 1.0 || closed > 0.01);
        }
        assert!(grown > 0, "{depth}");
        let away = forecast.bands().iter().any(|band| band.hardening().unwrap().wave_ratio.is_none());
        assert_eq!(away, depth == "20 mm");
    }
}

/// Cracks along a wave are those of Tγ at each of its phases, less the wear, with the amplitude of the band; where the wave stands still
/// their length goes with the passages.
#[test]
fn cracks_along_a_wave() {
    let speed = 14.0;
    let damage = "\n[damage]\nlaws = [\"wear\", \"fatigue\"]\nshear_yield = \"300 MPa\"\n\
        fatigue = { thresholds = [\"5 N\", \"20 N\", \"60 N\"], peak = 1e-5, crack_growth = \"1 mm\", crack_angle = \"25 deg\" }\n";
    let case = case(METRO, damage, &["track.model=one-layer"]);
    let contact = &case.feedback.contacts()[0];
    let laws = contact.damage.as_ref().unwrap();
    let fatigue = laws.fatigue().unwrap();
    let mean = contact.rolling.steady().energy_per_metre();
    let forecast = forecast(&case, speed);
    // Where growth is slow, so that a thousand passages leave the amplitude as it is.
    let amplitude = 2f64.sqrt() * 1e-5;
    let mut differ = 0;
    for band in forecast.bands() {
        let line = lines(band)[LINES_PER_BAND / 2];
        let state = case.feedback.at(line, speed).contacts[0];
        let energy = state.energy_at_rail / case.feedback.amplitude() * amplitude;
        let index = state.damage.unwrap().fatigue_index * amplitude;
        let phases = forecast.cracks(band, 1000.0).unwrap();
        let parts = |value: riffel::Complex64| [value.re, -value.im, -value.re, value.im];
        for ((found, energy), index) in phases.iter().zip(parts(energy)).zip(parts(index)) {
            let energy = (mean + energy).max(0.0);
            let wear = contact.wear.depth_per_energy() * energy;
            let growth = 1e-3 * fatigue.growing().value(energy) - wear / 25f64.to_radians().sin();
            let near = |found: f64, expected: f64, size: f64| {
                assert!((found - expected).abs() < 1e-2 * size, "{line}: {found:e} {expected:e}");
            };
            near(found.now.fatigue_index, laws.demand.fatigue_index + index, 1e-2);
            near(found.now.damage, fatigue.damage().value(energy), 1e-5);
            near(found.now.wear, wear, wear);
            near(found.now.crack_growth, growth, 1e-8);
            near(found.length, (1000.0 * growth).max(0.0), 1e-5);
        }
        differ += usize::from((phases[0].now.damage - phases[2].now.damage).abs() > 1e-7);
    }
    assert!(differ > 3);
    let plain = crate::case(METRO, &["track.model=one-layer"]);
    let smooth = self::forecast(&plain, speed);
    assert!(smooth.cracks(&smooth.bands()[0], 1e3).is_none());
}
