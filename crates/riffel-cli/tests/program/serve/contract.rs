//! One answer of page and program, in numbers and in sentences.

use std::fs;

use serde_json::{Value, json};

use super::served::{Served, body};
use crate::ask::ask;
use crate::sandbox::{Sandbox, root};

/// The standard output or else the standard error of `riffel ask`, as one document.
fn asked(sandbox: &Sandbox, name: &str, question: &Value) -> Value {
    let output = ask(sandbox, name, &question.to_string());
    let told = if output.status.success() { output.stdout } else { output.stderr };
    serde_json::from_slice(&told).unwrap_or_else(|error| panic!("{name}: {error}: {}", String::from_utf8_lossy(&told)))
}

/// Asserts that two answers have the same numbers, names and truths; one may say more.
fn same(page: &Value, program: &Value, what: &str) {
    match (page, program) {
        (Value::Object(own), Value::Object(other)) => {
            let common: Vec<_> = own.keys().filter(|key| other.contains_key(*key)).collect();
            assert!(!common.is_empty(), "{what}");
            common.iter().for_each(|key| same(&own[*key], &other[*key], &format!("{what}.{key}")));
        }
        (Value::Array(own), Value::Array(other)) => {
            assert_eq!(own.len(), other.len(), "{what}");
            own.iter().zip(other).for_each(|(one, other)| same(one, other, what));
        }
        (Value::Number(own), Value::Number(other)) => {
            let [own, other] = [own, other].map(|number| number.as_f64().unwrap());
            // Quantities reach a page in SI, which costs a bit or two of the last digits.
            assert!((own - other).abs() <= 1e-9 * other.abs().max(1e-300), "{what}: {own} {other}");
        }
        // Messages are data here and sentences there.
        (Value::Object(_), Value::String(_)) => {}
        _ => assert_eq!(page, program, "{what}"),
    }
}

/// A command line beside each question of a page: the parts of the two answers that are one.
// Long: answers seven questions twice, by the page and by the program.
#[test]
fn the_numbers_of_a_page_are_those_of_the_program() {
    let sandbox = Sandbox::new();
    let few = |name: &str| {
        let text = fs::read_to_string(root().join(format!("cases/{name}.toml"))).unwrap();
        let short = text
            .replace("\"300 mm\" }", "\"300 mm\", points = 21 }")
            .replace("\"15 m/s\" }", "\"15 m/s\", points = 7 }");
        fs::write(sandbox.path(&format!("{name}.toml")), &short).unwrap();
        json!({ "toml": short })
    };
    let [nominal, metro, curve] = ["nominal", "metro", "curve"].map(few);
    let wave = json!({ "case": nominal, "wavelength_m": 0.04, "speed_m_per_s": 25, "amplitude_m": 150e-6 });
    let record: String =
        (0..3000).map(|at| format!("{:.3},{:.3}\n", 1e-3 * f64::from(at), f64::from(at * 7919 % 41))).collect();
    let record = format!("position_m,left_um\n{record}");
    fs::write(sandbox.path("record.csv"), &record).unwrap();
    let served = Served::new(&sandbox);
    served.upload(&record);
    let keys: toml::Table = metro["toml"].as_str().unwrap().parse().unwrap();
    let mut measured = json!({ "case": keys, "roughness": { "upload": 1, "name": "record.csv" }, "speed": "15 m/s" });
    measured["traffic"] = traffic_file(&sandbox, "traffic.toml", false);
    let mut rings = measured.clone();
    rings["wheel_modes"] = json!("straight-web-920");
    for (path, question, command, parts) in [
        (
            "/api/line",
            json!({ "case": nominal }),
            "map nominal.toml -o map",
            &[("/fastest", "/under_traffic/fastest"), ("/cause", "/under_traffic/cause")][..],
        ),
        (
            "/api/remedies",
            json!({ "case": metro }),
            "compare metro.toml --remedies -o remedies",
            &[("/remedies", "/remedies")],
        ),
        (
            "/api/passage",
            wave.clone(),
            "simulate nominal.toml --sinusoid 150um,0.04m --speed 25m/s -o passage",
            &[("/contact_loss_fraction", "/contact_loss_fraction")],
        ),
        (
            "/api/damage",
            wave,
            "shakedown nominal.toml --wavelength 0.04m --speed 25m/s",
            &[("/shakedown/loop", "/loop")],
        ),
        ("/api/wheelset", json!({ "case": curve }), "wheelset curve.toml", &[("/modes", "/natural_frequencies")]),
        (
            "/api/stability",
            json!({ "case": curve }),
            "stability curve.toml",
            &[("/points", "/points"), ("/branches", "/branches")],
        ),
        (
            "/api/ask/noise",
            measured,
            "noise metro.toml --roughness record.csv --speed 15m/s --traffic traffic.toml -o noise",
            &[
                ("/level", "/level"),
                ("/frequency_hz", "/frequency_hz"),
                ("/measures", "/measures"),
                ("/course", "/course"),
                ("/speed_m_per_s", "/speed_m_per_s"),
            ],
        ),
        (
            "/api/ask/noise",
            rings,
            "noise metro.toml --roughness record.csv --speed 15m/s --traffic traffic.toml --wheel-modes straight-web-920",
            &[("/level", "/level"), ("/wheel_modes", "/wheel_modes")],
        ),
    ] {
        let answer = served.answer(path, &question);
        let told = sandbox.json(&format!("{command} --json"));
        for (here, there) in parts {
            let [own, other] = [answer.pointer(here), told.pointer(there)]
                .map(|part| part.unwrap_or_else(|| panic!("{path}: {here}")));
            same(own, other, path);
        }
    }
}

/// What a wave, a year and a bogie do: largest force, cracks, and all wheels through a curve.
// Long: answers four questions twice, by the page and by the program.
#[test]
fn forces_cracks_and_all_wheels_of_a_page_are_those_of_the_program() {
    let sandbox = Sandbox::new();
    let served = Served::new(&sandbox);
    let case = json!({ "toml": riffel_case::NOMINAL_CASE });
    let wave = json!({ "case": case, "wavelength_m": 0.04, "speed_m_per_s": 25, "amplitude_m": 150e-6 });
    let passage = served.answer("/api/passage", &wave);
    let forces = passage["course"]["normal_force_n"].as_array().unwrap().iter().filter_map(Value::as_f64);
    let told = sandbox.json("simulate cases/nominal.toml --sinusoid 150um,0.04m --speed 25m/s -o passage --json");
    let highest = told["maximum_normal_force_n"].as_f64().unwrap();
    assert!((forces.fold(0.0, f64::max) / highest - 1.0).abs() < 1e-3, "{highest}");
    let fatigue = fatigue(&sandbox);
    let damage = served.answer("/api/damage", &json!({ "case": fatigue, "wavelength_m": 0.2, "speed_m_per_s": 15 }));
    let told =
        sandbox.json("forecast fatigue.toml --from-limit=-6dB --traffic usual-of-a-metro.toml --months 12 --json");
    same(&damage["cracks"], &told["cracks"], "cracks");
    let is_cracked = |crack: &Value| crack["crack_length_m"].as_f64().unwrap() > 0.0;
    assert!(damage["cracks"].as_array().unwrap().iter().any(is_cracked), "{}", damage["cracks"]);
    let case = curve_in_closed_form(&sandbox);
    let [all, one] = [true, false].map(|is_in_curve| {
        let traffic = traffic_file(&sandbox, "trains.toml", is_in_curve);
        let line = served.answer("/api/line", &json!({ "case": case, "traffic": traffic }));
        let told = sandbox.json("map closed-form.toml --traffic trains.toml --json");
        same(&line["fastest"], &told["under_traffic"]["fastest"], "fastest");
        line["fastest"].clone()
    });
    assert_ne!(all, one);
}

/// A traffic, and its file in the sandbox; through the curve of the case with all wheels or with the wheel of the case alone.
fn traffic_file(sandbox: &Sandbox, name: &str, is_in_curve: bool) -> Value {
    let vehicle = json!({
        "name": "all", "share": 1, "speed": { "mean": 12.5, "standard_deviation": 0.75 }, "curve": is_in_curve,
    });
    let traffic = json!({ "line": { "passages_per_day": 6000 }, "vehicle": [vehicle] });
    let file: toml::Table = serde_json::from_value(traffic.clone()).unwrap();
    fs::write(sandbox.path(name), file.to_string()).unwrap();
    traffic
}

/// A case of a metro in which cracks grow, and the file of its usual traffic, 40 to 70 km/h.
fn fatigue(sandbox: &Sandbox) -> Value {
    let mut text = fs::read_to_string(root().join("cases/class-contact-fatigue.toml")).unwrap();
    for (from, to) in [
        ("laws = [\"wear\"]", "laws = [\"wear\", \"fatigue\"]"),
        ("loss = \"1 mm\"", "loss = \"1 mm\", crack_growth = \"1 mm\""),
        ("tractive_ratio = 0.3 ", "tractive_ratio = 0.5 "),
        ("points = 236", "points = 21"),
        ("points = 61", "points = 7"),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    fs::write(sandbox.path("fatigue.toml"), &text).unwrap();
    let width = 30.0 / 3.6 / 12_f64.sqrt();
    let usual = format!(
        "[line]\npassages_per_day = 6000\n[[vehicle]]\nname = \"any\"\nshare = 1\n\
         speed = {{ mean = \"55 km/h\", standard_deviation = {width} }}\n"
    );
    fs::write(sandbox.path("usual-of-a-metro.toml"), usual).unwrap();
    json!({ "toml": text })
}

/// A metro curve by a law of creep that takes tenths of a second.
fn curve_in_closed_form(sandbox: &Sandbox) -> Value {
    let text = fs::read_to_string(root().join("cases/metro-curve.toml")).unwrap();
    let short = text.replace("\"fastsim\"", "\"polach\"").replace("points = 141", "points = 21");
    let short = short.replace("points = 51", "points = 7");
    fs::write(sandbox.path("closed-form.toml"), &short).unwrap();
    json!({ "toml": short })
}

/// What is wrong with a question is one sentence, over HTTP as on standard error.
#[test]
fn a_page_is_refused_by_the_sentences_of_the_program() {
    let sandbox = Sandbox::new();
    let served = Served::new(&sandbox);
    let bad: Value = serde_json::from_str(include_str!("../../../../riffel-answers/tests/bad-questions.json")).unwrap();
    let bad = bad.as_array().unwrap();
    assert!(bad.len() > 10);
    let page = format!("--page {}", std::process::id());
    for bad in bad {
        let name = bad["name"].as_str().unwrap();
        let mut question = bad["question"].clone();
        // What stands in the files of the project is in their place: a page names none.
        for value in question.as_object_mut().unwrap().values_mut() {
            let file = value.as_str().filter(|name| name.ends_with(".toml"));
            if let Some(text) = file.and_then(|name| fs::read_to_string(root().join(name)).ok()) {
                *value = json!(text.parse::<toml::Table>().unwrap());
            }
        }
        let (status, answer) = served.ask(&format!("/api/ask/{name}"), &question);
        assert_eq!(status, 422, "{name} {question}: {answer}");
        let fault: Value = serde_json::from_str(body(&answer)).unwrap();
        let told = asked(&sandbox, &format!("{page} --messages {name}"), &question);
        for part in ["message", "help"] {
            assert_eq!(fault[part], told["error"][part], "{name} {question}");
        }
        let told = asked(&sandbox, &format!("{page} {name}"), &question);
        let said = told["error"]["message"].as_str().unwrap();
        assert!(said.contains(bad["sentence"].as_str().unwrap()), "{name}: {said}");
    }
}

/// The nominal case under the bogie that the view of curves begins with, and with the keys that are told of one wheel.
// Long: maps all wheels of a bogie twice, by the page and by the program.
#[test]
fn wheels_of_a_curve_on_the_page_are_those_of_the_program() {
    let sandbox = Sandbox::new();
    let text = fs::read_to_string(root().join("cases/nominal.toml")).unwrap();
    let text = text.replace("points = 241", "points = 21").replace("points = 221", "points = 7");
    let gives = ["tractive_ratio", "transverse_radius", "normal_load", "friction", "rolling_radius"];
    let lines = text.lines().filter(|line| !gives.iter().any(|key| line.starts_with(key)));
    let from = "[contact]\ncreep_law = \"fastsim\"\n\
                from = { curve = \"cases/metro-curve.toml\", wheelset = 1, rail = \"low\" }";
    let on_curve = lines.collect::<Vec<_>>().join("\n").replace("[contact]", from);
    fs::write(sandbox.path("on-curve.toml"), on_curve).unwrap();
    let told = sandbox.json("map on-curve.toml --wheels --json");
    let mut keys: Value = json!(text.parse::<toml::Table>().unwrap());
    let served = Served::new(&sandbox);
    let answer = served.answer(
        "/api/curve/wheels",
        &json!({
            "case": { "keys": keys }, "wheel": { "name": "S1002" }, "rail": { "name": "60E1" },
            "set": {
                "curve.radius": 180, "curve.speed": 12.5, "curve.cant": 0.1, "profiles.gauge": 1.435,
                "bogie.wheelbase": 2.1, "bogie.mass_per_axle": 10e3,
                "bogie.primary_longitudinal_stiffness": 8e6, "bogie.primary_lateral_stiffness": 4e6,
                "contact.friction.left": 0.4, "contact.friction.right": 0.4,
            },
        }),
    );
    for part in ["radius_m", "speed_m_per_s", "speeds_m_per_s", "wavelength_m", "wheels"] {
        same(&answer[part], &told[part], part);
    }
    // What is said of a wheel is data, of which the page makes words in its language.
    let remarks = answer["wheels"].as_array().unwrap().iter().flat_map(|wheel| wheel["remarks"].as_array().unwrap());
    assert!(remarks.clone().count() > 3 && remarks.clone().all(|remark| remark["id"].is_string()), "{answer}");
    let is_second_on_the_low_rail = |wheel: &&Value| wheel["wheelset"] == 2 && wheel["rail"] == "low";
    let wheel = answer["wheels"].as_array().unwrap().iter().find(is_second_on_the_low_rail).unwrap();
    let rate = wheel["highest"]["growth_rate_per_passage"].as_f64().unwrap();
    assert!(rate > 0.0);
    // Under trains within a tenth of the speed of the curve the case of that wheel grows as its picture tells.
    for key in answer["give_way"].as_array().unwrap() {
        let place = format!("/{}", key.as_str().unwrap().replace('.', "/"));
        let (table, last) = place.rsplit_once('/').unwrap();
        keys.pointer_mut(table).and_then(Value::as_object_mut).and_then(|table| table.remove(last));
    }
    for (key, value) in wheel["keys"].as_object().unwrap() {
        let place = key.split('.').fold(&mut keys, |table, name| &mut table[name]);
        *place = value.clone();
    }
    assert_eq!(keys["contact"]["creep_law"], "fastsim");
    assert!(keys["contact"]["tractive_ratio"].is_null());
    let speed = json!({ "mean": 12.5, "standard_deviation": 2.5 / 12_f64.sqrt() });
    let traffic = json!({ "vehicle": [{ "name": "any", "share": 1, "speed": speed }] });
    let line = served.answer("/api/line", &json!({ "case": { "keys": keys }, "traffic": traffic }));
    let found = line["fastest"]["growth_rate_per_passage"].as_f64().unwrap();
    assert!((found / rate - 1.0).abs() < 1e-6, "{found:e} {rate:e}");
}

/// Levels that have risen five times as fast as the model has it, and as fast once the wear coefficient is five times that of the case.
#[test]
fn what_the_model_does_not_explain_is_told_to_a_page() {
    let sandbox = Sandbox::new();
    let passages_per_day = 6000.0;
    let traffic = traffic_file(&sandbox, "traffic.toml", false);
    let table = |levels: &[(f64, f64)]| {
        let rows = levels.iter().map(|(wavelength, level)| format!("{wavelength},{level}\n"));
        format!("wavelength_mm,level_db\n{}", rows.collect::<String>())
    };
    let now = [25.0, 31.5, 40.0, 50.0, 63.0, 80.0].map(|wavelength| (wavelength, 10.0));
    fs::write(sandbox.path("now.csv"), table(&now)).unwrap();
    let forecast = "forecast cases/nominal.toml --traffic traffic.toml --spectrum now.csv --months 12 --json";
    let bands = sandbox.json(forecast)["bands"].clone();
    let before = now.map(|(wavelength, level)| {
        let of = |band: &&Value| (1e3 * band["wavelength_m"].as_f64().unwrap() / wavelength - 1.0).abs() < 0.02;
        let band = bands.as_array().unwrap().iter().find(of).unwrap();
        let growth = band["growth_db_per_million_axles"].as_f64().unwrap();
        (wavelength, level - 5e-6 * 365.0 * passages_per_day * growth)
    });
    fs::write(sandbox.path("before.csv"), table(&before)).unwrap();
    let dates = ["2025-05-01", "2026-05-01"];
    let told = sandbox.json(&format!("{forecast} --earlier before.csv --dates {}", dates.join(",")));
    let doubts = told["unexplained"].as_array().unwrap();
    // A fifth, of the fastest within a tenth of the wavelength, which is a little above its band.
    let sentence = doubts[0].as_str().unwrap();
    assert!(sentence.contains("the model has 0.2"), "{sentence}");
    let served = Served::new(&sandbox);
    served.upload(&table(&now));
    served.upload(&table(&before));
    let mut keys: Value = json!(riffel_case::NOMINAL_CASE.parse::<toml::Table>().unwrap());
    let mut question = json!({
        "case": keys, "traffic": traffic, "roughness": { "upload": 1, "name": "now.csv" },
        "earlier": [{ "upload": 2, "name": "before.csv" }], "dates": dates, "months": 12,
    });
    let measured = served.answer("/api/ask/measure", &question);
    let mut own = question.clone();
    own["spectrum"] = json!("now.csv");
    own["earlier"] = json!(["before.csv"]);
    own.as_object_mut().unwrap().remove("roughness");
    let as_data = asked(&sandbox, "--messages forecast", &own);
    assert_eq!(measured["forecast"]["unexplained"], as_data["unexplained"]);
    assert_eq!(measured["forecast"]["unexplained"].as_array().unwrap().len(), doubts.len());
    keys["wear"]["coefficient"] = json!("12.5e-9 kg/J");
    question["case"] = keys;
    let explained = served.answer("/api/ask/measure", &question);
    assert!(explained["forecast"]["bands"].is_array() && explained["forecast"]["unexplained"].is_null());
}

/// A report that is told of no traffic goes by the usual one of the line, as the page does: one level, and one set of shares.
// Long: writes a report of 20 000 heights and asks its two questions again.
#[test]
fn the_report_of_a_rail_has_level_and_causes_of_the_page() {
    let sandbox = Sandbox::new();
    let wave = |at: i32| {
        let floor = f64::from(at * 7919 % 41) / 41.0;
        20.0 * (std::f64::consts::TAU * f64::from(at) / 40.0).sin() + floor
    };
    let record: String = (0..20_000).map(|at| format!("{:.3},{:.3}\n", 1e-3 * f64::from(at), wave(at))).collect();
    let record = format!("position_m,left_um\n{record}");
    fs::write(sandbox.path("record.csv"), &record).unwrap();
    let served = Served::new(&sandbox);
    served.upload(&record);
    let case = fs::read_to_string(root().join("cases/metro.toml")).unwrap();
    let mut case: Value = json!(case.parse::<toml::Table>().unwrap());
    for (axis, points) in [("wavelength", 21), ("speed", 7)] {
        case["map"][axis]["points"] = json!(points);
    }
    let report = asked(&sandbox, "report", &json!({ "case": case, "roughness": "record.csv" }));
    let report = report["page"].as_str().unwrap();
    // As the page writes the usual traffic of a metro.
    let speed = json!({ "mean": 55.0 / 3.6, "standard_deviation": 30.0 / 3.6 / 12_f64.sqrt() });
    let vehicle = json!({ "name": "the wheel of the case", "share": 1, "speed": speed });
    let mut question = json!({
        "case": case, "roughness": { "upload": 1, "name": "record.csv" }, "months": 12, "speed": "15.277777777777779 m/s",
        "traffic": { "line": { "passages_per_day": 6000 }, "vehicle": [vehicle] },
    });
    let noise = served.answer("/api/ask/noise", &question);
    let level = noise["level"]["total_dba"].as_f64().unwrap();
    assert!(report.contains(&format!("{level:.1} dB(A)")), "{level}");
    question["speed"] = json!(["11.11111111111111 m/s..19.444444444444443 m/s"]);
    let measured = served.answer("/api/ask/measure", &question);
    let findings = measured["diagnosis"]["dominant_wavelengths"].as_array().unwrap().iter();
    let candidates = findings.flat_map(|finding| finding["candidates"].as_array().unwrap());
    let shares: Vec<f64> = candidates.map(|candidate| candidate["share"].as_f64().unwrap()).collect();
    let widths = report.split("<span class=\"bar\"><i style=\"width:").skip(1);
    let widths: Vec<f64> = widths.map(|rest| rest.split('%').next().unwrap().parse().unwrap()).collect();
    assert!(shares.len() > 3 && shares.len() == widths.len(), "{shares:?} {widths:?}");
    // A digit of a percent is drawn.
    let apart = shares.iter().zip(&widths).map(|(share, width)| (100.0 * share - width).abs());
    assert!(apart.fold(0.0, f64::max) < 0.06, "{shares:?} {widths:?}");
}

/// A record every half a millimetre, of heights alone and in feet and inches, by the columns that a page chooses.
#[test]
fn columns_of_a_page_reach_the_program() {
    let sandbox = Sandbox::new();
    let step = 0.5e-3;
    let rows = (0..20_000).map(|at| {
        let place = step * f64::from(at);
        let wave = 20e-6 * (std::f64::consts::TAU * place / 0.063).sin();
        (place, wave + 1e-6 * f64::from(at * 7919 % 41) / 41.0)
    });
    let rows: Vec<(f64, f64)> = rows.collect();
    let table = |head: &str, [across, up]: [f64; 2]| {
        let lines = rows.iter().map(|(place, height)| format!("{},{}\n", place / across, height / up));
        format!("{head}\n{}", lines.collect::<String>())
    };
    let heights: String = rows.iter().map(|(_, height)| format!("{}\n", 1e6 * height)).collect();
    let served = Served::new(&sandbox);
    for text in [&table("position_m,left_um", [1.0, 1e-6]), &table("a,b", [0.3048, 0.0254]), &heights] {
        served.upload(text);
    }
    let levels = |upload: u32, format: Option<Value>| -> Vec<f64> {
        let mut question = json!({ "file": { "upload": upload, "name": "trolley.csv" } });
        if let Some(format) = format {
            question["format"] = format;
        }
        let answer = served.answer("/api/ask/roughness", &question);
        let spectrum = answer.pointer("/rails/0/spectrum").unwrap_or(&answer["spectrum"]);
        let points = spectrum.as_array().unwrap_or_else(|| panic!("{answer}"));
        points.iter().map(|point| point["level_db"].as_f64().unwrap()).collect()
    };
    let expected = levels(1, None);
    // A sine has the root mean square of its amplitude over √2, all of it in one third octave.
    let highest = expected.iter().copied().fold(f64::MIN, f64::max);
    assert!((highest - 20.0 * (20.0 / 2_f64.sqrt()).log10()).abs() < 0.2, "{highest}");
    let rail = |column: u32, unit: &str| json!([{ "column": column, "unit": unit, "name": "left" }]);
    let feet = json!({
        "delimiter": "comma", "decimal": "point", "header_lines": 1,
        "position": { "column": 1, "unit": "ft", "name": "" }, "rails": rail(2, "in"),
    });
    let alone = json!({
        "delimiter": "tab", "decimal": "point", "header_lines": 0, "spacing": "0.0005 m", "rails": rail(1, "um"),
    });
    for (upload, format) in [(2, feet), (3, alone)] {
        let found = levels(upload, Some(format));
        assert_eq!(found.len(), expected.len());
        for (one, other) in found.iter().zip(&expected) {
            assert!((one - other).abs() < 1e-6, "{upload}: {one} {other}");
        }
    }
}

/// What the program makes of nothing and says of itself.
#[test]
fn the_sample_and_the_version_of_a_page_are_those_of_the_program() {
    let sandbox = Sandbox::new();
    let made = sandbox.riffel("roughness --synthesise -o sample.csv");
    assert_eq!(made.status, Some(0), "{}", made.text);
    let served = Served::new(&sandbox);
    let (status, answer) = served.ask("/api/ask/roughness", &json!({ "synthesise": true }));
    assert_eq!(status, 200, "{answer}");
    assert!(body(&answer) == fs::read_to_string(sandbox.path("sample.csv")).unwrap(), "another sample");
    let vocabulary: Value = serde_json::from_str(body(&served.get("/api/vocabulary"))).unwrap();
    let version = format!("riffel {}", vocabulary["version"].as_str().unwrap());
    assert!(sandbox.riffel("--version").text.starts_with(&version), "{version}");
}
