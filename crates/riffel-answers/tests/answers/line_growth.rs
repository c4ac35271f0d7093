//! Growth under the traffic of a line.

use std::f64::consts::LN_2;

use riffel_answers::LineGrowth;
use riffel_answers::remedies::RemediesAnswer;
use riffel_case::traffic::{DAYS_PER_MONTH, LineKind, Traffic, UsualTraffic};
use riffel_case::{FREIGHT_CASE, MAIN_LINE_CASE, METRO_CASE, METRO_CURVE_CASE, NOMINAL_CASE, TRAM_CASE};

use crate::coarse;

/// Its map goes from 5 to 15 m/s.
const CURVE: &str = include_str!("../../../../cases/curve.toml");

fn in_words(growth: &LineGrowth) -> String {
    let words: Vec<String> = growth.remarks.iter().map(ToString::to_string).collect();
    words.join("\n")
}

/// The line of a case is told by its curve, its vehicle, or else its wheel and load; speeds are those of such a line.
#[test]
fn a_line_has_traffic_of_its_kind() {
    let heavy = &["contact.normal_load=147 kN"][..];
    for (text, axles) in [(MAIN_LINE_CASE, 6000.0), (METRO_CASE, 6000.0), (FREIGHT_CASE, 3000.0), (TRAM_CASE, 2400.0)] {
        assert_eq!(UsualTraffic::of(&coarse(text, &[])).passages_per_day, axles);
    }
    for (text, overrides, line, km_per_h) in [
        (NOMINAL_CASE, &[][..], LineKind::MainLine, [80.0, 140.0]),
        (MAIN_LINE_CASE, &[], LineKind::MainLine, [80.0, 140.0]),
        (METRO_CASE, &[], LineKind::Metro, [40.0, 70.0]),
        (FREIGHT_CASE, &[], LineKind::Freight, [60.0, 100.0]),
        (FREIGHT_CASE, heavy, LineKind::HeavyHaul, [40.0, 70.0]),
        (TRAM_CASE, &[], LineKind::Tram, [20.0, 50.0]),
        (METRO_CURVE_CASE, &[], LineKind::Curve, [40.5, 49.5]),
        (CURVE, &[], LineKind::Curve, [32.4, 39.6]),
        (NOMINAL_CASE, heavy, LineKind::HeavyHaul, [40.0, 70.0]),
        (NOMINAL_CASE, &["vehicle=\"locomotive\""], LineKind::MainLine, [80.0, 140.0]),
    ] {
        let usual = UsualTraffic::of(&coarse(text, overrides));
        assert_eq!(usual.line, line);
        for (found, expected) in usual.speeds.into_iter().zip(km_per_h) {
            assert!((3.6 * found - expected).abs() < 1e-9, "{line:?}: {found}");
        }
    }
}

/// At one speed the fastest growth of a line is the highest point of the loop there; months and the band follow from it by hand.
#[test]
fn at_one_speed_it_is_the_highest_growth_there() {
    let case = coarse(NOMINAL_CASE, &["map.wavelength.max=200 mm"]);
    let text = "line.passages_per_day = 4000\n[[vehicle]]\nname = \"v\"\nshare = 1\nspeed.mean = 30\n";
    let growth = LineGrowth::new(&case, Some(&Traffic::parse("t", text).unwrap())).unwrap();
    let fastest = growth.fastest.unwrap();
    let window = (20..=80).map(|mm| case.point(1e-3 * f64::from(mm), 30.0).unwrap());
    let highest = window.max_by(|a, b| a.growth_rate.total_cmp(&b.growth_rate)).unwrap();
    assert!((fastest.wavelength_m / highest.wavelength - 1.0).abs() < 0.02);
    assert!((fastest.growth_rate_per_passage / highest.growth_rate - 1.0).abs() < 2e-3);
    let months = LN_2 / fastest.growth_rate_per_passage / 4000.0 / DAYS_PER_MONTH;
    assert!((fastest.doubling_months.unwrap() / months - 1.0).abs() < 1e-12);
    // A factor of three either way.
    let [early, late] = fastest.doubling_months_banded.unwrap().band_80;
    let factor = 3.0;
    assert!((early * factor / months - 1.0).abs() < 1e-12 && (late / factor / months - 1.0).abs() < 1e-12);
    let [shortest, longest] = fastest.wavelengths_m;
    for end in [0.97 * shortest, 1.03 * longest] {
        let rate = case.point(end, 30.0).unwrap().growth_rate;
        assert!(rate < 0.5 * fastest.growth_rate_per_passage, "{end} m");
    }
    assert!(!fastest.at_edge);
    let words = in_words(&growth);
    assert!(words.contains("under the traffic given (108 km/h, 4000 axles a day)"), "{words}");
    assert!(!words.contains("edge"), "{words}");
}

/// A window that cuts the maximum off has its fastest growth at the edge, and says on which side more may be.
#[test]
fn an_edge_is_told_as_an_edge() {
    for (window, side) in [
        ("map.wavelength.max=50 mm", "longer waves may grow faster"),
        ("map.wavelength.min=75 mm", "shorter waves may grow faster"),
    ] {
        let growth = LineGrowth::new(&coarse(NOMINAL_CASE, &[window]), None).unwrap();
        assert!(growth.fastest.unwrap().at_edge);
        let words = in_words(&growth);
        assert!(words.contains(side), "{words}");
    }
}

/// Depths of flow are known from no measurement, so that a time by them holds for what the case says alone.
#[test]
fn a_time_by_flow_holds_for_its_depth() {
    let flow = [
        "damage.laws=['flow']",
        "damage.grade='R260'",
        "damage.flow.depth=1e-9",
        "damage.flow.exponent=1",
        "contact.friction=0.5",
        "contact.wave_geometry=false",
    ];
    let case = coarse(NOMINAL_CASE, &flow);
    let words = in_words(&LineGrowth::new(&case, None).unwrap());
    let wear = in_words(&LineGrowth::new(&coarse(NOMINAL_CASE, &[]), None).unwrap());
    let doubt = "if the depths of damage are as written, which no measurement has told";
    assert!(words.contains(doubt), "{words}");
    assert!(!wear.contains(doubt), "{wear}");
}

/// Wear a hundred times as fast is faster than any growth seen on a railway; wear of none lets nothing grow.
#[test]
fn growth_that_nobody_has_seen_is_remarked() {
    let seen = |coefficient: &str| {
        let coefficient = format!("wear.coefficient={coefficient} kg/J");
        in_words(&LineGrowth::new(&coarse(NOMINAL_CASE, &[&coefficient]), None).unwrap())
    };
    assert!(!seen("2.5e-9").contains("faster than any railway known"));
    let words = seen("2.5e-7");
    let (wear, sentence) = words.split_once('\n').unwrap();
    let sentence = sentence.lines().next().unwrap();
    assert!(
        wear.starts_with("on straight track the rail would lose 20 mm per 100 MGT, where rails lose 0.1 to 5"),
        "{wear}"
    );
    let slow = seen("1e-9");
    assert!(slow.contains("would lose 0.080 mm"), "{slow}");
    assert!(!seen("2.5e-9").contains("would lose"));
    assert!(
        sentence.ends_with("leads, faster than any railway known: wavelengths and order hold, the rate does not"),
        "{words}"
    );
    // The only time is that of the railway known.
    assert_eq!(words.matches(" days").count(), 1, "{words}");
    assert!(words.contains("doubled in 96 days"), "{words}");
    let fast = coarse(NOMINAL_CASE, &["wear.coefficient=2.5e-7 kg/J"]);
    let growth = LineGrowth::new(&fast, None).unwrap();
    let fastest = growth.fastest.unwrap();
    assert!(fastest.faster_than_known && fastest.doubling_months.is_none());
    assert_eq!(fastest.time().to_string(), "faster than any railway known");
    // Fewer trains take their time over it.
    let few = "line.passages_per_day = 40\n[[vehicle]]\nname = \"v\"\nshare = 1\nspeed.mean = 30\n";
    let slow = LineGrowth::new(&fast, Some(&Traffic::parse("t", few).unwrap())).unwrap();
    assert!(!slow.fastest.unwrap().faster_than_known && !in_words(&slow).contains("faster than any railway known"));
    let remedies = RemediesAnswer::new(&fast, None, &|_| ()).unwrap();
    let best = remedies.helps_most().unwrap().to_string();
    assert!(best.contains(": growth falls by") && !best.contains("doubles"), "{best}");
    assert!(remedies.grinding_interval.is_none());
    let calm = coarse(NOMINAL_CASE, &["map.wavelength.max=30 mm"]);
    let growth = LineGrowth::new(&calm, None).unwrap();
    assert!(growth.fastest.is_none());
    assert!(in_words(&growth).starts_with("nothing from 20 to 30 mm grows under the usual traffic"));
}
