//! A measured rail on the page: what the single questions say, of records that are read once.

use std::path::Path;
use std::sync::Mutex;

use riffel_answers::question::{Client, Nobody, Step, named};
use riffel_keys::Message;
use serde_json::{Value, json};

/// Keeps what work was begun.
#[derive(Default)]
struct Watcher(Mutex<Vec<String>>);

impl Client for Watcher {
    fn begin(&self, work: Message, _: usize) -> Step<'_> {
        self.0.lock().unwrap().push(work.to_string());
        Box::new(|_| ())
    }

    fn remark(&self, _: &[Message]) {}

    fn reads(&self, _: &Path) {}
}

fn answer(name: &str, question: &Value, client: &dyn Client) -> Value {
    let keys = question.as_object().unwrap().clone();
    let answer = named(name).unwrap().answer(keys, client).unwrap_or_else(|error| panic!("{name}: {error}"));
    serde_json::from_str(&answer.document()).unwrap()
}

// Long: answers three questions about two records twice, alone and together.
#[test]
fn a_measured_rail_is_told_as_by_the_single_questions_and_each_record_is_read_once() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    // A wave of 55 mm under a slope that no limit knows, twice as high a year later.
    let profile = |height: f64| {
        let rows = (0..20_000).map(|row| {
            let position = 1e-3 * f64::from(row);
            let wave = height * (std::f64::consts::TAU * position / 0.055).sin() + 2.0 * (7.1 * position).sin();
            format!("{position},{wave}\n")
        });
        format!("position_m,height_um\n{}", rows.collect::<String>())
    };
    let case = file("case.toml", riffel_case::NOMINAL_CASE);
    let traffic = "[line]\npassages_per_day = 4000\n[[vehicle]]\nname = \"any\"\nshare = 1\nspeed = { mean = 25, standard_deviation = 3 }\n";
    let traffic = file("traffic.toml", traffic);
    let (before, now) = (file("before.csv", &profile(2.0)), file("now.csv", &profile(4.0)));
    let dates = json!(["2025-05-01", "2026-05-01"]);
    let both = json!({ "case": case, "traffic": traffic, "earlier": [before], "dates": dates });
    let with = |key: &str| {
        let mut question = both.clone();
        question[key] = json!(now);
        question
    };
    let watcher = Watcher::default();
    let measured = answer("measure", &with("roughness"), &watcher);
    let read = watcher.0.lock().unwrap().iter().filter(|work| *work == "reading").count();
    assert_eq!(read, 2, "a record and the one before it");
    assert_eq!(measured["roughness"], answer("roughness", &json!({ "file": now }), &Nobody));
    assert_eq!(measured["diagnosis"], answer("diagnose", &with("roughness"), &Nobody));
    let mut forecast = with("spectrum");
    forecast["months"] = json!(12);
    assert_eq!(measured["forecast"], answer("forecast", &forecast, &Nobody));
    assert!(measured["forecast"]["wear_fit"].is_object());
    // A free rail has no level of noise; what a moving one carries is not known.
    assert_eq!(measured["is_silent"], true);
    let mut moving = json!({ "traffic": traffic, "roughness": now });
    for (model, is_silent) in
        [("model = \"moving-beam\"", true), ("model = \"one-layer\"\npreset = \"slab-direct\"", false)]
    {
        let text = riffel_case::NOMINAL_CASE.replace("model = \"free-beam\"", model);
        moving["case"] = json!(file("moving.toml", &text));
        assert_eq!(answer("measure", &moving, &Nobody)["is_silent"], is_silent, "{model}");
    }
}
