//! Maps, points and variants of a case.

use axum::http::{StatusCode, header};
use riffel_keys::Language;
use serde_json::{Value, json};

use super::{ask, english, get, in_words, nominal};

#[tokio::test]
async fn a_map_is_that_of_the_program() {
    let answer = ask("/api/map", &nominal(&[])).await;
    assert_eq!(answer.status, StatusCode::OK);
    let (head, values) = answer.framed();
    let case = riffel_case::Case::parse("nominal", riffel_case::NOMINAL_CASE, &[]).unwrap();
    let points = (case.wavelength.points(), case.speed.points());
    assert_eq!(values.len(), points.0 * points.1);
    for (column, row) in [(0, 0), (100, 110), (240, 220)] {
        let state = case.feedback.at(case.wavelength.value(column), case.speed.value(row));
        let expected = state.normalized_dissipation.re as f32;
        // The map agrees with the loop to rounding, then both are rounded to 32 bits.
        let got = values[row * points.0 + column];
        assert!((got - expected).abs() <= 2.0 * f32::EPSILON * expected.abs(), "{got} {expected}");
    }
    assert!((530.0..545.0).contains(&head["best_fit_frequency_hz"].as_f64().unwrap()));
    let branches = head["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 1);
    assert_eq!(branches[0]["frequency_hz"], head["best_fit_frequency_hz"]);
    let columns = &branches[0]["points"];
    assert_eq!(columns["speed_m_per_s"].as_array().unwrap().len(), columns["wavelength_m"].as_array().unwrap().len());
    let told = head["branches_in_words"].to_string();
    assert!(told.contains("\"id\"") && told.contains("{\"number\":\"537\"}"), "{told}");
    assert_eq!(head["complete"]["wear"]["density"], "7850 kg/m3");
}

#[tokio::test]
async fn a_point_is_that_of_the_loop() {
    let mut body = nominal(&[]);
    body["wavelength_m"] = json!(0.055);
    body["speed_m_per_s"] = json!(30.0);
    let answer = ask("/api/point", &body).await.json();
    let case = riffel_case::Case::parse("nominal", riffel_case::NOMINAL_CASE, &[]).unwrap();
    let state = case.feedback.at(0.055, 30.0);
    // serde_json reads numbers back to within a unit in the last place.
    let same = |got: &Value, expected: f64| {
        let got = got.as_f64().unwrap();
        assert!((got - expected).abs() <= 1e-15 * expected.abs(), "{got} {expected}");
    };
    let got = &answer["state"];
    same(&got["growth_rate_per_passage"], state.growth_rate);
    same(&got["normal_force_n"][0], state.normal_force().re);
    same(&got["normal_force_n"][1], state.normal_force().im);
    let spectrum = &answer["spectrum"];
    assert_eq!(spectrum["frequency_hz"].as_array().unwrap().len(), 240);
    // P₁ of the curve is P₁ of the loop at its own frequency, equation (24).
    let frequency = spectrum["frequency_hz"][120].as_f64().unwrap();
    let there = case.feedback.at(30.0 / frequency, 30.0).normal_force() / case.steady.normal_force;
    let curve = spectrum["normal_force_ratio"][120][0].as_f64().unwrap();
    assert!((curve - there.re).abs() <= 1e-12 * there.norm(), "{curve} {there}");
    body["wavelength_m"] = json!(0.5);
    let outside = ask("/api/point", &body).await;
    assert_eq!(outside.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(outside.json()["key"], "map.wavelength");
}

#[tokio::test]
async fn keys_and_text_say_the_same() {
    let text = ask("/api/case", &nominal(&[])).await.json();
    let keys = ask("/api/case", &json!({ "case": { "keys": text["keys"] } })).await.json();
    assert_eq!(keys["complete"], text["complete"]);
    let again = json!({ "case": { "toml": keys["toml"] } });
    assert_eq!(ask("/api/case", &again).await.json()["complete"], text["complete"]);
}

#[tokio::test]
async fn variants_are_compared_in_the_window_of_the_case() {
    let narrow = nominal(&[("\"80 mm\"", "\"60 mm\""), ("friction = 0.4", "friction = 0.2")]);
    let case = nominal(&[])["case"].clone();
    let variants = json!([
        { "name": "A", "case": narrow["case"] }, { "name": "now", "case": case },
    ]);
    let (head, values) = ask("/api/compare", &json!({ "variants": variants, "case": case })).await.framed();
    assert_eq!(values.len(), 2 * 241 * 221);
    let [one, other] = [&head["variants"][0], &head["variants"][1]];
    assert_eq!(one["window"], other["window"]);
    assert_eq!(one["complete"]["contact"]["friction"], json!(0.2));
    assert!(one["under_traffic"]["fastest"]["wavelength_m"].is_number());
    // A variant without an answer under the traffic leaves the maps, and says why.
    let traffic = json!({
        "vehicle": [{ "name": "unit", "share": 1, "speed": { "mean": 15 }, "curve": true }],
    });
    let question = json!({ "variants": variants, "case": case, "traffic": traffic });
    let (head, values) = ask("/api/compare", &question).await.framed();
    assert_eq!(values.len(), 2 * 241 * 221);
    let why = &head["variants"][0]["under_traffic"]["fault"]["message"];
    assert!(english(why).contains("curve"), "{why}");
    let refused = nominal(&[("friction = 0.4", "friction = -1")])["case"].clone();
    let wrong = json!({ "variants": [{ "name": "dry", "case": refused }], "case": case });
    let fault = ask("/api/compare", &wrong).await.json();
    let message = english(&fault["message"]);
    assert!(message.starts_with("dry: "), "{message}");
    assert_eq!(fault.get("key"), None, "the form does not show it");
    let many = json!({ "variants": vec![json!({ "name": "A", "case": case }); 8], "case": case });
    let fault = ask("/api/compare", &many).await;
    assert_eq!(fault.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert!(fault.message().contains("at most 7"));
}

#[tokio::test]
async fn curves_of_variants_are_those_of_a_point() {
    let case = nominal(&[])["case"].clone();
    let curve = json!({ "name": "A", "case": case, "speed_m_per_s": 20.0 });
    let curves = ask("/api/growth", &json!({ "for": "variants", "curves": [curve], "case": case })).await.json();
    let mut point = nominal(&[]);
    point["wavelength_m"] = json!(0.04);
    point["speed_m_per_s"] = json!(20.0);
    let point = ask("/api/point", &point).await.json();
    assert_eq!(curves[0], point["growth"]);
    let still = json!({ "name": "A", "case": case, "speed_m_per_s": 0.0 });
    let fault = ask("/api/growth", &json!({ "for": "sweep", "curves": [still], "case": case })).await;
    assert!(fault.message().starts_with("A: the speed is 0 m/s"));
}

#[tokio::test]
async fn files_and_figures_are_those_of_the_program() {
    let csv = ask("/api/export/csv", &nominal(&[])).await;
    let text = String::from_utf8(csv.bytes).unwrap();
    assert_eq!(text.lines().count(), 1 + 241 * 221);
    assert!(text.starts_with("wavelength_m,speed_m_per_s,"));
    assert_eq!(csv.headers[header::CONTENT_DISPOSITION], "attachment");
    let svg = ask("/api/export/svg", &nominal(&[])).await;
    assert!(svg.bytes.starts_with(b"<svg"));
    let png = ask("/api/export/png", &nominal(&[])).await;
    assert!(png.bytes.starts_with(b"\x89PNG"));
    let figure = ask("/api/figure", &json!({ "number": 7, "contact": "quasi-static" })).await.json();
    assert_eq!(figure["lines"][0]["series"].as_array().unwrap().len(), 5);
    let german = ask("/api/figure", &json!({ "number": 7, "contact": "quasi-static", "language": "de" })).await.json();
    assert!(german["title"].as_str().unwrap().starts_with("Bild 7."));
    assert!(german["caption"].as_str().unwrap().contains("R = 0,46 m"));
    let label = &german["lines"][0]["series"][1]["label"];
    assert_eq!(label, "13,89 kg m²");
    let none = ask("/api/figure", &json!({ "number": 1, "contact": "quasi-static" })).await;
    assert_eq!(none.status, StatusCode::UNPROCESSABLE_ENTITY);
}

/// A first visit offers rails and tracks, each of which makes a case of every line.
#[tokio::test]
async fn every_track_of_the_first_visit_makes_a_case_of_every_line() {
    let start = include_str!("../../assets/start.js");
    let tracks = start.split_once("const TRACKS = [").unwrap().1.split_once("\n];").unwrap().0;
    let tracks: Vec<Vec<&str>> =
        tracks.split('[').skip(1).map(|track| track.split('\'').skip(1).step_by(2).collect()).collect();
    assert!(tracks.len() > 5, "{tracks:?}");
    let vocabulary = get("/api/vocabulary").await.json();
    let lines = vocabulary["lines"].as_array().unwrap();
    assert!(lines.len() > 3);
    for line in lines {
        // Its keys are those of the case of the book.
        let name = line["name"].as_str().unwrap();
        let file = std::fs::read_to_string(format!("{}/../../cases/{name}.toml", env!("CARGO_MANIFEST_DIR"))).unwrap();
        assert_eq!(line["case"], json!(file.parse::<toml::Table>().unwrap()), "{name}");
        for track in &tracks {
            let &[section, preset, model] = &track[..] else { panic!("{track:?}") };
            let mut keys = line["case"].clone();
            keys["rail"]["section"] = json!(section);
            keys["track"] = json!({ "model": model, "preset": preset });
            if model.ends_with("periodic") {
                keys["track"]["position"] = json!("0 m");
            }
            let answer = ask("/api/case", &json!({ "case": { "keys": keys } })).await;
            assert_eq!(answer.status, StatusCode::OK, "{line}, {track:?}: {}", answer.json());
        }
    }
}

/// Small words without which English gets nowhere, and which German does not have.
const ENGLISH: [&str; 32] = [
    "the",
    "of",
    "and",
    "is",
    "are",
    "at",
    "from",
    "with",
    "by",
    "not",
    "over",
    "under",
    "after",
    "which",
    "that",
    "must",
    "no",
    "wheel",
    "wheels",
    "track",
    "speed",
    "force",
    "growth",
    "now",
    "length",
    "wavelength",
    "choose",
    "give",
    "soft",
    "sleepers",
    "half",
    "chosen",
];

/// All messages in an answer, in German.
fn german(answer: &Value, found: &mut Vec<String>) {
    match answer {
        Value::Object(message) if message.contains_key("id") && message.contains_key("values") => {
            found.push(in_words(Language::German, answer));
        }
        Value::Object(parts) => parts.values().for_each(|part| german(part, found)),
        Value::Array(parts) => parts.iter().for_each(|part| german(part, found)),
        _ => {}
    }
}

/// What grows, why, where, and what helps, of every line and of a curve.
// Long: asks for all that is told of each line and of a curve.
#[tokio::test]
async fn what_is_said_of_a_case_is_german() {
    let vocabulary = get("/api/vocabulary").await.json();
    let lines = vocabulary["lines"].as_array().unwrap().iter().map(|line| line["case"].clone());
    let curve: toml::Table = riffel_case::METRO_CURVE_CASE.replace("fastsim", "polach").parse().unwrap();
    for mut keys in lines.chain([json!(curve)]) {
        for (axis, points) in [("wavelength", 21), ("speed", 7)] {
            keys["map"][axis]["points"] = json!(points);
        }
        let question = json!({ "case": { "keys": keys } });
        let mut said = Vec::new();
        german(&ask("/api/map", &question).await.framed().0, &mut said);
        german(&ask("/api/line", &question).await.json(), &mut said);
        // Those of a wheelset take long.
        if keys["wheelset"].is_null() {
            german(&ask("/api/remedies", &question).await.json(), &mut said);
        }
        assert!(said.len() > 10, "{said:?}");
        for sentence in &said {
            let mut words = sentence.split(|letter: char| !letter.is_alphanumeric() && !"-_.'\"`".contains(letter));
            assert!(!words.any(|word| ENGLISH.contains(&word)), "{sentence}");
        }
    }
}

/// A wheel whose force is held, which nothing does where it leaves the rail.
#[tokio::test]
async fn a_case_without_a_passage_in_time_says_so() {
    let mut wave = nominal(&[("# rotation = \"inertia\"", "rotation = \"constant-tangential-force\"")]);
    for (key, value) in [("wavelength_m", 0.04), ("speed_m_per_s", 25.0), ("amplitude_m", 1e-5)] {
        wave[key] = json!(value);
    }
    let refused = ask("/api/passage", &wave).await;
    assert_eq!(refused.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert!(refused.message().contains("no creepage keeps the force"), "{}", refused.message());
    let german = in_words(Language::German, &refused.json()["message"]);
    assert!(german.contains("hält kein Schlupf die Kraft"), "{german}");
}

/// The sliders of the page move within what is usual, so that none of their places is asked about.
#[test]
fn sliders_stay_within_what_is_usual() {
    let form = include_str!("../../assets/form.js");
    let sliders = form.split_once("const SLIDERS = {").unwrap().1;
    let sliders = sliders.split_once("};").unwrap().0;
    let mut seen = 0;
    for slider in sliders.split("],").filter(|slider| slider.contains('[')) {
        let (key, ends) = slider.trim().split_once(": [").unwrap();
        let mut ends = ends.split(", ").map(|end| end.parse::<f64>());
        let [low, high] = [(); 2].map(|()| ends.next().unwrap().unwrap());
        let key = key.trim_matches('\'');
        let range = riffel_keys::PhysicalRange::of(key).unwrap();
        assert!(range.usual[0] <= low && low < high && high <= range.usual[1], "{key}");
        seen += 1;
    }
    assert_eq!(seen, 5);
}
