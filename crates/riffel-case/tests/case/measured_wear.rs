//! The wear of a rail as it was measured, in the place of a wear coefficient.

use riffel_case::traffic::{Traffic, TrafficOnCase, bands_of};
use riffel_case::{Case, METRO_CASE, NOMINAL_CASE, Variant, wear_spread};

use crate::{case, parsed};

const MEASURED: &str = "wear.measured=1.2 mm / 100 MGT";
/// Of an axle in three; and of all at other loads.
const TRAFFIC: &str = "
[[vehicle]]
name = \"coaches\"
share = 0.6
traction_share = 0.3
speed = { mean = \"100 km/h\", standard_deviation = \"8 km/h\" }
[[vehicle]]
name = \"locomotive\"
share = 0.4
axle_load = \"21 t\"
speed = { mean = \"90 km/h\", standard_deviation = \"8 km/h\" }
";

/// The nominal case with a further line of wear.
fn with_wear(line: &str) -> String {
    NOMINAL_CASE.replace("[wear]\n", &format!("[wear]\n{line}\n"))
}

fn depth(case: &Case) -> f64 {
    1e3 * case.feedback.mean_wear().depth_per_100_mgt()
}

fn under_traffic(case: &Case, change: &str) -> TrafficOnCase {
    let traffic = Traffic::parse("t.toml", TRAFFIC).unwrap();
    let variant = match change {
        "" => Variant::none(""),
        change => Variant::parse("change", change).unwrap(),
    };
    traffic.on(case, &bands_of(case), &variant, &|_| ()).unwrap()
}

/// Rounding alone: all is in proportion to the coefficient.
fn same(got: f64, right: f64) {
    assert!((got / right - 1.0).abs() < 1e-12, "{got:e} for {right:e}");
}

/// All spellings of one wear make one coefficient, of the wheel of the case; another friction another.
#[test]
fn a_measured_wear_makes_the_coefficient() {
    let plain = case(NOMINAL_CASE, &[]);
    let rate = |case: &Case| case.feedback.complex_growth_rate(0.05, 30.0).re;
    for spelling in [
        MEASURED,
        "wear.measured=1.2 mm per 100 MGT",
        "wear.measured=12 um / MGT",
        "wear.measured={ depth = 1.2e-3, per = \"1e8 t\" }",
        "wear.measured.depth=1.2 mm",
    ] {
        let measured = case(NOMINAL_CASE, &[spelling]);
        same(depth(&measured), 1.2);
        let coefficient = measured.file.wear.coefficient.si();
        same(coefficient, 2.5e-9 * 1.2 / depth(&plain));
        same(rate(&measured) / rate(&plain), coefficient / 2.5e-9);
        let [low, high] = wear_spread(&measured).band_80(coefficient);
        same(high / coefficient, 1.5);
        same(coefficient / low, 1.5);
        let slippery = measured.edit(|keys| {
            keys.contact.friction = riffel_keys::quantity::Quantity::new(0.2);
        });
        same(depth(&slippery.unwrap()), 1.2);
    }
    let text = with_wear("measured = \"1.2 mm / 100 MGT\"").replace("coefficient = \"2.5e-9", "# \"");
    same(depth(&case(&text, &[])), 1.2);
    let given = case(&text, &["wear.coefficient=1e-9"]);
    assert!(given.file.wear.measured.is_none(), "an override replaces it");
}

/// Under a traffic the mean over its axles wears as measured; a variant keeps the coefficient of the case as it is.
// Long: puts four traffics on a line.
#[test]
fn a_traffic_wears_as_measured() {
    let (measured, plain) = (case(METRO_CASE, &[MEASURED]), case(METRO_CASE, &[]));
    let of = |on: &TrafficOnCase| 1e3 * on.growth.mean_wear().depth_per_100_mgt();
    let (on, given) = (under_traffic(&measured, ""), under_traffic(&plain, ""));
    same(of(&on), 1.2);
    same(on.wear_coefficient, 0.3e-9 * 1.2 / of(&given));
    let softer = "contact.friction = 0.3";
    let change = |case: &Case, on: &TrafficOnCase| of(&under_traffic(case, softer)) / of(on);
    let kept = change(&measured, &on);
    same(kept, change(&plain, &given));
    assert!((kept - 1.0).abs() > 0.1, "less friction wears otherwise");
}

#[test]
fn a_measured_wear_that_cannot_be_is_refused() {
    let both = with_wear("measured = \"1.2 mm / 100 MGT\"");
    let cases: [(&str, &[&str], &str); 8] = [
        (&both, &[], "`wear.measured` and `wear.coefficient` exclude each other"),
        (NOMINAL_CASE, &["wear.measured=1.2 mm"], "is \"1.2 mm\", but must be a depth"),
        (NOMINAL_CASE, &["wear.measured=1.2 / 100"], "is \"1.2 / 100\", but must be a depth"),
        (
            NOMINAL_CASE,
            &["wear.measured={ depth = \"1.2 mm\", per = \"100 MGT\", factor = 0.8 }"],
            "`wear.measured.factor` is 0.8",
        ),
        (NOMINAL_CASE, &["wear.measured={ depth = \"0 mm\", per = \"100 MGT\" }"], "`wear.measured.depth` is 0"),
        (
            NOMINAL_CASE,
            &[MEASURED, "contact.creepage={ longitudinal = 0 }"],
            "a wheel that does not creep does not wear the rail",
        ),
        (NOMINAL_CASE, &[MEASURED, "wear.law=usfd"], "leave out other laws"),
        (
            NOMINAL_CASE,
            &[MEASURED, "wear.natural_lubrication=5"],
            "`wear.measured` and `wear.natural_lubrication` exclude each other",
        ),
    ];
    for (text, keys, expected) in cases {
        let error = parsed(text, keys).err().map(|error| error.to_string());
        let error = error.unwrap_or_else(|| panic!("{keys:?} is taken"));
        assert!(error.contains(expected), "{error}");
    }
}
