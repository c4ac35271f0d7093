//! `ask`: questions in JSON, as another program puts them.

use std::io::{ErrorKind, Write};
use std::process::{Output, Stdio};

use serde_json::{Value, json};

use crate::sandbox::Sandbox;

pub(crate) fn ask(sandbox: &Sandbox, name: &str, question: &str) -> Output {
    let mut command = sandbox.command();
    command.arg("ask").args(shlex::split(name).unwrap());
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    // A question by an unknown name is refused before it is read.
    match input.write_all(question.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => panic!("{error}"),
        _ => drop(input),
    }
    child.wait_with_output().unwrap()
}

/// The answer.
fn answer(sandbox: &Sandbox, name: &str, question: &Value) -> Value {
    let output = ask(sandbox, name, &question.to_string());
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name}: {errors}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A question of texts and numbers as a command line; `None` for what JSON alone can say.
fn command_line(name: &str, question: &Value) -> Option<String> {
    let option = |(key, value): (&String, &Value)| {
        let value = value
            .as_str()
            .map_or_else(|| value.as_f64().map(|number| number.to_string()), |text| Some(text.to_owned()))?;
        Some(match &**key {
            "case" => value,
            key => format!("--{}='{value}'", key.replace('_', "-")),
        })
    };
    let options = question.as_object()?.iter().map(option).collect::<Option<Vec<_>>>()?;
    (!options.is_empty()).then(|| format!("{name} {}", options.join(" ")))
}

/// What is said on standard error, line by line.
fn said(output: &Output) -> Vec<Value> {
    let lines = std::str::from_utf8(&output.stderr).unwrap().lines();
    lines.map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn spectrum() -> Value {
    let wavelengths = [0.02, 0.025, 0.0315, 0.04, 0.05, 0.063, 0.08, 0.1];
    let levels = [2.0, 3.5, 5.25, 6.0, 7.0, 9.0, 8.0, 6.0];
    json!({ "wavelength_m": wavelengths, "level_db": levels })
}

#[test]
fn the_answer_is_that_of_the_command() {
    let sandbox = Sandbox::new();
    let point = json!({
        "case": "cases/nominal.toml", "set": ["contact.friction=0.3"], "wavelength": "56 mm", "speed": 30,
    });
    let command = "point cases/nominal.toml --set contact.friction=0.3 --wavelength '56 mm' --speed 30 --json";
    assert_eq!(answer(&sandbox, "point", &point), sandbox.json(command));
    let remedies = json!({ "case": "cases/nominal.toml", "remedies": true });
    let ranked = answer(&sandbox, "compare", &remedies);
    assert_eq!(ranked, sandbox.json("compare cases/nominal.toml --remedies --json"));
    assert_eq!(ranked["remedies"][0]["changes"][0]["key"], "speed.standard_deviation");
    let presets = answer(&sandbox, "presets", &json!({ "name": "60E1" }));
    assert_eq!(presets, sandbox.json("presets 60E1 --json"));
}

#[test]
fn documents_stand_in_place_of_files() {
    let sandbox = Sandbox::new();
    let read = |name: &str| std::fs::read_to_string(sandbox.path(name)).unwrap();
    let keys = |text: &str| toml::from_str::<Value>(text).unwrap();
    let traffic = "[line]\npassages_per_day = 4000\n[[vehicle]]\nname = \"all\"\nshare = 1\n\
                   speed = { mean = \"80 km/h\", standard_deviation = \"5 km/h\" }\n";
    let rows = |table: &Value| {
        let [x, y] = ["wavelength_m", "level_db"].map(|name| table[name].as_array().unwrap());
        let rows = x.iter().zip(y).map(|(x, y)| format!("{x},{y}\n"));
        format!("wavelength_m,level_db\n{}", rows.collect::<String>())
    };
    std::fs::write(sandbox.path("traffic.toml"), traffic).unwrap();
    std::fs::write(sandbox.path("spectrum.csv"), rows(&spectrum())).unwrap();
    let files = json!({
        "case": "cases/main-line.toml", "roughness": "spectrum.csv", "traffic": "traffic.toml", "speed": "80 km/h",
        "months": 6, "limit_dba": 90,
    });
    let mut documents = files.clone();
    documents["case"] = keys(&read("cases/main-line.toml"));
    documents["roughness"] = spectrum();
    documents["traffic"] = keys(traffic);
    documents["wheel_roughness"] = Value::Null;
    let by_files = answer(&sandbox, "noise", &files);
    assert_eq!(by_files, answer(&sandbox, "noise", &documents));
    assert!(by_files["course"]["months_to_limit"].is_null());
    // The page of a report is its document, and a file only where one is named.
    let mut report = json!({ "case": documents["case"] });
    let page = answer(&sandbox, "report", &report)["page"].take();
    assert!(page.as_str().unwrap().contains("<td>case</td>"));
    assert!(!sandbox.path("report.html").exists());
    report["output"] = "named.html".into();
    assert_eq!(answer(&sandbox, "report", &report)["page"], page);
    assert_eq!(page, read("named.html"));
    // What is wrong in a document is told by its key.
    documents["traffic"]["vehicle"][0]["share"] = json!(0.5);
    let refused = ask(&sandbox, "noise", &documents.to_string());
    assert_eq!(refused.status.code(), Some(2));
    let error = &said(&refused)[0]["error"];
    let sentence = error["message"].as_str().unwrap();
    assert!(sentence.contains("the shares of `vehicle` sum to 0.5"), "{sentence}");
    documents["roughness"]["level_db"].as_array_mut().unwrap().pop();
    let refused = ask(&sandbox, "noise", &documents.to_string());
    let error = said(&refused)[0]["error"]["message"].to_string();
    assert!(error.contains("question:roughness: level_db has 7 values"), "{error}");
}

#[test]
fn remarks_are_data_in_the_language_asked_for() {
    let sandbox = Sandbox::new();
    let question = json!({ "case": "cases/main-line.toml", "roughness": spectrum(), "speed": 30 });
    let output = ask(&sandbox, "noise --language de", &question.to_string());
    assert!(output.status.success());
    let left_out = said(&output)
        .into_iter()
        .map(|mut line| line["remark"].take())
        .find(|remark| remark["id"] == "bands-left-out")
        .unwrap();
    assert!(left_out["text"].as_str().unwrap().contains("fehlt in jedem Pegel"), "{left_out}");
    let frequencies = left_out["values"]["frequencies"].as_array().unwrap();
    assert!(frequencies.contains(&json!(5000)), "{left_out}");
    let quiet = ask(&sandbox, "noise --quiet", &question.to_string());
    assert_eq!(quiet.stdout, output.stdout);
    assert!(quiet.stderr.is_empty());
}

/// A question that has no answer, and how the sentence on it begins.
#[derive(serde::Deserialize)]
struct Bad {
    name: String,
    question: Value,
    sentence: String,
}

#[test]
fn what_is_wrong_is_one_line_of_json() {
    let sandbox = Sandbox::new();
    let point = r#""case": "cases/nominal.toml", "speed": 30"#;
    let own = [
        ("network", "{}".to_owned(), "NAME is network, but"),
        ("serve", "{}".to_owned(), "NAME is serve, but"),
        ("point", "[1]".to_owned(), "the question is not a JSON object"),
        ("point", "{".to_owned(), "the question is not JSON: EOF"),
        ("point", format!("{{{point}, \"speed\": 20}}"), "`speed` is given twice, the second time in line 1"),
        ("point", String::new(), "the question is not JSON: EOF"),
        ("point", r#"{"help": true}"#.to_owned(), "`help` is not a key of point"),
        ("point", format!("{{{point}, \"wavelength\": 0.05, \"quiet\": true}}"), "`quiet` is not a key of point"),
        ("network worst", r#"{"store": "s", "language": "de"}"#.to_owned(), "`language` is not a key of network worst"),
        ("presets", r#"{"json": false}"#.to_owned(), "`json` is not a key of presets; its keys are name"),
        ("presets", r#"{"version": null}"#.to_owned(), "`version` is not a key"),
        (
            "point",
            r#"{"case": "-", "speed": 30, "wavelength": 0.05}"#.to_owned(),
            "`case` is \"-\", but must be a file: standard input holds the question",
        ),
    ];
    let bad: Vec<Bad> = serde_json::from_str(include_str!("../../../riffel-answers/tests/bad-questions.json")).unwrap();
    for bad in &bad {
        // An option that there is none of is refused as options are.
        if let Some(line) = command_line(&bad.name, &bad.question).filter(|_| !bad.sentence.starts_with('`')) {
            let outcome = sandbox.riffel(&line);
            assert_eq!(outcome.status, Some(2), "{line}");
            assert!(outcome.sentence().contains(&bad.sentence), "{line}: {}", outcome.sentence());
        }
    }
    let bad = bad.into_iter().map(|bad| (bad.name, bad.question.to_string(), bad.sentence));
    let own = own.map(|(name, question, message)| (name.to_owned(), question, message.to_owned()));
    for (name, question, message) in own.into_iter().chain(bad) {
        let output = ask(&sandbox, &name, &question);
        assert_eq!(output.status.code(), Some(2), "{name} {question}");
        assert!(output.stdout.is_empty(), "{name} {question}");
        let lines = said(&output);
        let [line] = &lines[..] else { panic!("{name} {question}: {lines:?}") };
        let told = line["error"]["message"].as_str().unwrap();
        assert!(told.contains(&message), "{told}");
    }
}

/// What the page asks is no command, and its help names none.
#[test]
fn a_question_of_the_page_is_told_by_its_schema() {
    let sandbox = Sandbox::new();
    let refused = ask(&sandbox, "along", "{}");
    let help = said(&refused)[0]["error"]["help"].take();
    assert_eq!(help, "`riffel schema --question along` says as JSON what each takes");
    assert_eq!(sandbox.json("schema --question along")["title"], "riffel ask along");
}

#[test]
fn the_schema_of_a_question_has_its_keys() {
    let sandbox = Sandbox::new();
    let schema = sandbox.json("schema --question noise");
    assert_eq!(schema["required"], json!(["case", "roughness", "speed"]));
    let of = |key: &str| schema["properties"][key].clone();
    assert_eq!(of("roughness")["type"], json!(["string", "object"]));
    assert_eq!(of("where")["type"], "array");
    assert_eq!((&of("wheels")["type"], &of("wheels")["default"]), (&json!("integer"), &json!(4)));
    assert_eq!(of("months")["default"], json!(12));
    assert!(of("json").is_null() && of("language").is_null());
    let below = sandbox.json("schema --question network worst");
    assert_eq!(below["title"], "riffel ask network worst");
    assert_eq!(below["required"], json!(["store"]));
}

/// Messages of an answer and of an error are their ids and values where that is wanted.
#[test]
fn messages_are_their_ids_and_values() {
    let sandbox = Sandbox::new();
    let question = json!({ "case": "cases/wheelset-metro-motor.toml" });
    let [english, data] = ["wheelset", "--messages wheelset"].map(|name| answer(&sandbox, name, &question));
    let name = |answer: &Value| answer["natural_frequencies"][4]["name"].clone();
    assert_eq!(name(&english), "first torsion (discs against wheels)");
    let ordinal = json!({ "id": "ordinal", "values": { "order": 1 } });
    let mode = json!({ "id": "torsional-mode", "values": { "ordinal": ordinal } });
    assert_eq!(name(&data), json!({ "id": "discs-against-wheels", "values": { "mode": mode } }));
    let refused = ask(&sandbox, "--messages wheelset", r#"{ "case": "none.toml" }"#);
    let error = &said(&refused)[0]["error"];
    assert_eq!(error["message"]["id"], "file-cannot-be-read", "{error}");
}
