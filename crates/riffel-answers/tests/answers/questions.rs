//! Questions by their keys: what is left out, and what is wrong.

use riffel_answers::question::{AnyQuestion, Kind, Nobody, named};
use serde_json::{Value, json};

fn question(name: &str) -> &'static dyn AnyQuestion {
    named(name).unwrap()
}

/// Why there is no answer.
fn refusal(name: &str, keys: &Value) -> String {
    let keys = keys.as_object().unwrap().clone();
    question(name).answer(keys, &Nobody).err().unwrap().to_string()
}

#[test]
fn what_is_wrong_is_told_by_its_key() {
    let noise = |key: &str, value: Value| {
        let mut keys = json!({ "case": "none.toml", "roughness": "none.csv", "speed": 30 });
        keys[key] = value;
        refusal("noise", &keys)
    };
    for (key, value, sentence) in [
        ("sped", json!(1), "`sped` is not a key of noise; its keys are case, set, roughness"),
        ("wheels", json!(0), "--wheels is 0, but must be an integer from 1 to 10000"),
        ("wheels", json!("-1"), "--wheels is -1, but must be an integer from 1 to 10000"),
        ("wheels", json!(4.5), "--wheels is 4.5, but must be an integer"),
        ("speed", json!([30]), "--speed is [30], but must be a number or a text"),
        ("limit", json!({}), "--limit is {}, but must be a text"),
        ("posterior", json!(true), "--posterior is true, but must be the path of a file or a folder"),
        ("before", json!(true), "--before is true, but must be the path of a file or an object with what stands in it"),
        ("where", json!([["a"]]), "--where is [\"a\"], but must be a text, or a list of them"),
        ("speed", json!("30 kg"), "--speed: "),
        ("speed", Value::Null, "--speed is missing"),
        ("keep_defects", json!("yes"), "--keep-defects is \"yes\", but must be true or false"),
        ("height_unit", json!("kg"), "--height-unit: \"kg\" is no unit of length"),
        ("months", json!(3), "--months needs --traffic or --posterior"),
        ("track_transfer", json!("a"), "--track-transfer needs --vehicle-transfer"),
    ] {
        let told = noise(key, value.clone());
        assert!(told.starts_with(sentence), "{key} = {value}: {told}");
    }
    let both = json!({ "case": "", "roughness": "", "speed": 1, "traffic": "a", "posterior": "b" });
    assert_eq!(refusal("noise", &both), "--traffic cannot be used with --posterior");
}

#[test]
fn keys_say_what_they_take() {
    let keys = question("noise").keys();
    let key = |name: &str| keys.iter().find(|key| key.name == name).unwrap();
    assert_eq!(key("wheels").kind, Kind::Integer([1, 10_000]));
    assert_eq!((key("wheels").default.clone(), key("wheels").is_required), (Some(json!(4)), false));
    assert_eq!(key("roughness").kind, Kind::File);
    assert_eq!(key("speed").kind, Kind::Text { or_number: true });
    assert_eq!(key("keep_defects").kind, Kind::Flag);
    assert!(key("where").takes_many && key("case").is_positional && key("speed").is_required);
    assert_eq!(question("noise").schema()["required"], json!(["case", "roughness", "speed"]));
}

/// Keys that say how a record is read, and dates, are refused without one wherever there may be none.
#[test]
fn what_is_said_of_a_record_needs_one() {
    let (case, with, speed) = ("none.toml", "none.toml", 30);
    for (name, mut keys, needs) in [
        ("report", json!({ "case": case }), "--roughness"),
        ("simulate", json!({ "case": case, "speed": speed, "smooth": true }), "--profile"),
        ("compare", json!({ "case": case, "with": with, "speed": speed }), "--spectrum"),
        ("forecast", json!({ "case": case, "traffic": case }), "--spectrum"),
        ("roughness", json!({ "synthesise": true }), "<FILE>"),
    ] {
        keys["rail"] = json!("left");
        assert_eq!(refusal(name, &keys), format!("--rail needs {needs}"), "{name}");
    }
    for name in ["noise", "diagnose", "measure"] {
        let mut keys = json!({ "case": case, "roughness": "none.csv", "dates": "2026-05-01" });
        if name == "noise" {
            keys["speed"] = json!(speed);
        }
        assert_eq!(refusal(name, &keys), "--dates needs --earlier", "{name}");
    }
}

/// A list as JSON has one, and as one text.
#[test]
fn a_list_is_one_in_either_way() {
    let answer = |friction: Value| {
        let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/nominal.toml");
        let keys = json!({ "case": case, "friction": friction });
        let answer = question("stability").answer(keys.as_object().unwrap().clone(), &Nobody).unwrap();
        serde_json::from_str::<Value>(&answer.document()).unwrap()
    };
    let list = answer(json!([0.2, "0.3"]));
    assert_eq!(list["friction"], json!([0.2, 0.3]));
    assert_eq!(answer(json!("0.2,30 %")), list);
    assert_eq!(answer(json!(["0.2,30 %"])), list);
}

/// A flag that is off and a list without items are as if they were left out.
#[test]
fn what_says_nothing_is_not_given() {
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/nominal.toml");
    for nothing in [json!({}), json!({ "with": [] }), json!({ "models": false }), json!({ "remedies": false })] {
        let mut keys = nothing.clone();
        keys["case"] = case.into();
        let told = refusal("compare", &keys);
        assert!(told.contains("--with") && told.contains("missing"), "{nothing}: {told}");
    }
    let told = refusal("roughness", &json!({ "file": "none.csv", "synthesise": false, "force": false }));
    assert!(told.contains("none.csv"), "{told}");
}
