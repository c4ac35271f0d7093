//! Damage beside wear, from the command line to the files.

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const FLOW: &str =
    "--set \"damage.laws=[\\\"wear\\\", \\\"flow\\\"]\" --set damage.flow.depth=1e-9 --set damage.shear_yield=230e6";

fn sum(values: &Value) -> f64 {
    let values = values.as_object().unwrap().values();
    values.map(|value| value.as_f64().unwrap()).sum()
}

/// A point tells every law and their sum, and a forecast and a passage say what they make of them.
#[test]
fn a_point_tells_the_laws() {
    let sandbox = Sandbox::new();
    let point = format!("point cases/metro.toml --wavelength 0.2 --speed 14 --json {FLOW}");
    let document = sandbox.json(&point);
    let damage = &document["damage"];
    let told = number(&document["growth_rate_per_passage"]);
    assert!((sum(&damage["growth_by_law"]) - told).abs() < 1e-12 * told.abs());
    assert!(number(&damage["demand"]) > 0.5);
    let plain = sandbox.json("point cases/metro.toml --wavelength 0.2 --speed 14 --json");
    assert!(plain.get("damage").is_none());
    let named = sandbox.json("point cases/metro.toml --wavelength 0.2 --speed 14 --json --set wear.law=usfd");
    assert!(named["damage"]["growth_by_law"]["wear"].is_number());
}

/// The map of shakedown, its orbit and its files.
#[test]
fn shakedown_follows_a_wave() {
    let sandbox = Sandbox::new();
    let document = sandbox.json("shakedown cases/metro.toml --utilised-friction 0,0.3,0.5 --json");
    let map = document["map"].as_array().unwrap();
    assert!((number(&map[0]["line"]) - 4.0).abs() < 1e-9 && map[0]["surface"].is_null());
    assert!((number(&map[2]["line"]) - 2.0).abs() < 1e-9);
    let wave = "shakedown cases/metro.toml --wavelength 0.2 --speed 14 --amplitude \"20 um\"";
    let document = sandbox.json(&format!("{wave} --utilised-friction 0.1 --json"));
    let along = document["loop"].as_array().unwrap();
    assert_eq!(along.len(), 36);
    assert!((number(&along[0]["profile_m"]) - 20e-6).abs() < 1e-18);
    let outcome = sandbox.riffel(&format!("{wave} -o out"));
    assert!(outcome.text.contains("the demand is largest"), "{}", outcome.text);
}

/// Stress under the contact: the axis of a point that was asked for, and the maxima of both tractions.
#[test]
fn stress_under_the_contact() {
    let sandbox = Sandbox::new();
    let document = sandbox.json("contact cases/metro.toml --stress --stress-at=-0.8,0,0.1 --stress-at=0,0,0.5 --json");
    let stress = &document["stress"];
    assert_eq!(stress["maxima"].as_array().unwrap().len(), 8);
    let points = stress["points"].as_array().unwrap();
    assert_eq!(number(&points[0]["x_over_a"]), -0.8);
    assert!(number(&points[1]["normal_over_p0"][2]) < -0.5);
}

/// Class of heavy haul by flow alone, above a sharp limit, with a hardening depth.
fn hardening(depth: &str) -> String {
    format!(
        "cases/class-heavy-haul.toml --set damage.laws='[\"flow\"]' --set damage.shear_yield=200e6 --set damage.spread=0 \
         --set damage.limit=subsurface --set damage.flow.hardening_depth=\"{depth}\""
    )
}

/// Two trains, of which one is laden.
const TRAINS: &str = "[line]\nmgt_per_year = 20\n[[vehicle]]\nname = \"laden\"\nshare = 0.5\naxle_load = \"30 t\"\n\
    speed = { mean = \"60 km/h\", standard_deviation = \"5 km/h\" }\n[[vehicle]]\nname = \"empty\"\nshare = 0.5\naxle_load = \"8 t\"\n\
    speed = { mean = \"70 km/h\" }\n";

fn findings(document: &Value) -> String {
    let findings = document["findings"].as_array().unwrap().iter();
    findings.map(|finding| finding.as_str().unwrap().to_owned() + "\n").collect()
}

/// A run that goes on knows what has flowed at every point of the rail: of 20 µm as in one go to the rounding of sums that are cut
/// in two.
#[test]
fn hardening_goes_on_from_where_it_was() {
    let sandbox = Sandbox::new();
    let run = |passages: u32, folder: &str| {
        let outcome = sandbox.riffel(&format!(
            "simulate {} --speed 14 --sinusoid 20um,300mm --passages {passages} -o {folder}",
            hardening("0.2mm")
        ));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    };
    run(2000, "whole");
    run(1000, "parts");
    run(2000, "parts");
    let heights = |folder: &str| -> Vec<f64> {
        let text = std::fs::read_to_string(sandbox.path(folder).join("profile.csv")).unwrap();
        let rows = text.lines().skip(1).map(|row| row.rsplit(',').next());
        rows.map(|height| height.unwrap().parse().unwrap()).collect()
    };
    let (whole, parts) = (heights("whole"), heights("parts"));
    assert!(whole.len() == parts.len() && !whole.is_empty());
    for (one, other) in whole.iter().zip(&parts) {
        assert!((one - other).abs() < 1e-18, "{one:e} {other:e}");
    }
}

/// A forecast says whether flow that hardens ends a wave or lets it run away, and passages in time end it where a point says.
#[test]
fn hardening_ends_or_runs_away() {
    let sandbox = Sandbox::new();
    std::fs::write(sandbox.path("trains.toml"), TRAINS).unwrap();
    let of = |depth: &str, more: &str| {
        let command =
            format!("forecast {} {more} --traffic trains.toml --from-limit=-6dB --months 60 --json", hardening(depth));
        sandbox.json(&command)
    };
    let (ends, away) = (of("0.2mm", ""), of("50mm", ""));
    assert!(findings(&ends).contains("makes no corrugation by itself"), "{}", findings(&ends));
    assert!(findings(&away).contains("runs away"), "{}", findings(&away));
    // What is told of a band is what the forecast makes of it, and when.
    let bands = ends["bands"].as_array().unwrap();
    let mut nearest = (0.0, 0.0, 0.0);
    for wave in ends["hardening"].as_array().unwrap() {
        let [length, ratio, runaway] =
            ["wavelength_m", "hardened_wave_ratio", "runaway_number"].map(|key| number(&wave[key]));
        let band = bands.iter().find(|band| number(&band["wavelength_m"]) == length).unwrap();
        let change = number(&band["level_then_db"]) - number(&band["level_now_db"]);
        // The march in time goes on to a hundredth of the smallest change.
        assert!((change - 20.0 * ratio.log10()).abs() < 2e-3, "{length}: {change} {ratio}");
        if runaway > nearest.0 {
            nearest = (runaway, length, ratio);
        }
    }
    let told = format!(
        "multiplies the waves of the band at {:.0} mm by {:.3} and comes to rest after ",
        1e3 * nearest.1,
        nearest.2
    );
    let said = findings(&ends);
    assert!(said.contains(&told) && said.contains(" months: their runaway number"), "{told}: {said}");
    let numbers = |document: &Value| -> Vec<f64> {
        let waves = document["hardening"].as_array().unwrap().iter();
        waves.map(|wave| number(&wave["runaway_number"])).collect()
    };
    for (one, other) in numbers(&ends).iter().zip(numbers(&away)) {
        assert!((250.0 * one - other).abs() < 1e-6 * other.abs());
    }
    // The wave stays at what hardening leaves.
    let level = |document: &Value| number(&document["bands"][0]["level_then_db"]);
    let later = sandbox
        .json(&format!("forecast {} --traffic trains.toml --from-limit=-6dB --months 600 --json", hardening("0.2mm")));
    assert!((level(&later) - level(&ends)).abs() < 1.0);

    let point = format!("point {} --wavelength 0.3 --speed 14 --json", hardening("0.2mm"));
    let wave = &sandbox.json(&point)["damage"]["hardened_wave"];
    let ratio = number(&wave[0]).hypot(number(&wave[1]));
    let run = sandbox
        .json(&format!("simulate {} --speed 14 --sinusoid 20um,300mm --passages 4e6 --json", hardening("0.2mm")));
    let bands = run["bands"].as_array().unwrap();
    let near = |band: &&Value| (number(&band["wavelength_m"]) / 0.3 - 1.0).abs() < 0.1;
    let levels = bands.iter().find(near).unwrap()["level_db"].as_array().unwrap();
    let change = number(levels.last().unwrap()) - number(&levels[0]);
    let found = 10f64.powf(change / 20.0);
    assert!((found / ratio - 1.0).abs() < 0.03, "{found} {ratio}");
}

/// A forecast tells cracks beside wear at four phases of each band, over the vehicles.
#[test]
fn cracks_over_a_traffic() {
    let sandbox = Sandbox::new();
    std::fs::write(sandbox.path("trains.toml"), TRAINS).unwrap();
    let laws = "--set damage.laws='[\"wear\", \"fatigue\"]' --set contact.tractive_ratio=0.5 --set damage.fatigue.crack_growth=1mm";
    let command =
        format!("forecast cases/class-heavy-haul.toml {laws} --traffic trains.toml --from-limit=-6dB --months 12");
    let document = sandbox.json(&format!("{command} --json"));
    let bands = document["bands"].as_array().unwrap().len();
    let cracks = document["cracks"].as_array().unwrap();
    assert_eq!(cracks.len(), 4 * bands);
    let per_month = number(&cracks[0]["crack_growth_mm_per_month"]);
    let per_passage = number(&cracks[0]["crack_growth_m_per_passage"]);
    let passages = number(&document["traffic"]["passages_per_day"]) * 365.2425 / 12.0;
    assert!((per_month / (1e3 * passages * per_passage) - 1.0).abs() < 1e-3);
    assert!(cracks.iter().any(|row| number(&row["crack_length_m"]) > 1e-4));
    assert!(findings(&document).contains("cracks are longest"));
    let outcome = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let table = std::fs::read_to_string(sandbox.path("out/cracks.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + cracks.len());
    let plain =
        sandbox.json("forecast cases/class-heavy-haul.toml --traffic trains.toml --from-limit=-6dB --months 12 --json");
    assert!(plain.get("cracks").is_none() && plain.get("hardening").is_none());
}

/// Any creepage has a third traction, that of the elements.
#[test]
fn stress_of_the_elements() {
    let sandbox = Sandbox::new();
    for overrides in ["--set contact.creepage.longitudinal=0", ""] {
        let command = format!("contact cases/wheelset-coach.toml --stress --json {overrides}");
        let maxima = &sandbox.json(&command)["stress"]["maxima"];
        let maxima = maxima.as_array().unwrap();
        assert_eq!(maxima.len(), 12);
        let of = |traction: &str| {
            let mut rows = maxima.iter();
            number(&rows.find(|row| row["traction"] == traction).unwrap()["value_over_p0"])
        };
        let (full, partial, exact) = (of("full-slip"), of("partial-slip"), of("half-space"));
        assert!(exact < full && (exact / partial - 1.0).abs() < 0.05, "{full} {partial} {exact}");
    }
}
