//! Records of a store that somebody has changed.

use std::fs;

use riffel_network::Store;

use crate::{store, survey, take};

/// What a record says that cannot be is told, and the survey left out; the store goes on.
#[test]
fn records_that_cannot_be_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 40], |_, _| 5.0);
    take(&store, "A", "2026-01-01", &file);
    take(&store, "B", "2026-01-01", &file);
    let network = folder.path().join("network");
    let record = network.join("surveys/A/2026-01-01.json");
    let plain = fs::read_to_string(&record).unwrap();
    let change = |from: &str, to: &str| {
        assert!(plain.contains(from), "{from}");
        fs::write(&record, plain.replacen(from, to, 1)).unwrap();
        let opened = Store::open(&network).unwrap();
        let told: Vec<String> = opened.damaged().map(ToString::to_string).collect();
        assert_eq!(opened.surveys().unwrap().len(), 1, "{to}");
        told.join("\n")
    };
    let start = "\"start_m\": 0.0";
    for (from, to, words) in [
        (start, "\"start_m\": 1e300", "no line has such places"),
        (start, "\"start_m\": -2e8", "no line has such places"),
        (start, "\"start_m\": 0.3", "does not begin with a cell"),
        ("\"cells\": 40", "\"cells\": 10000000000", "no survey is so long"),
        ("\"cells\": 40", "\"cells\": 20", "fewer cells than were measured"),
        ("\"name\": \"right\"", "\"name\": \"left\"", "is damaged"),
        ("\"array\": \"left\"", "\"array\": \"../../left\"", "is the record of another"),
    ] {
        let told = change(from, to);
        assert!(told.contains(words), "{to}: {told}");
    }
    fs::write(&record, &plain).unwrap();
    let bands = fs::read_to_string(network.join("network.json")).unwrap();
    for (from, to) in [("0.03", "1e-30"), ("0.3", "1e9"), ("\"resolution_m\": 1.0", "\"resolution_m\": 1e-9")] {
        assert!(bands.contains(from), "{bands}");
        fs::write(network.join("network.json"), bands.replacen(from, to, 1)).unwrap();
        assert!(Store::open(&network).is_err(), "{to}");
    }
}
