//! Questions that are refused.

use std::time::Duration;

use axum::http::{StatusCode, header};
use serde_json::{Value, json};

use super::{ask, english, get, nominal, page, page_with, question, send};
use crate::queue::Queue;

#[tokio::test]
async fn errors_are_those_of_the_program_with_key_line_and_help() {
    let answer = ask("/api/case", &nominal(&[("friction = 0.4", "frction = 0.4")])).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
    let fault = answer.json();
    assert_eq!(fault["key"], "contact.frction");
    assert_eq!(english(&fault["message"]), "`contact.frction` is not a key Riffel knows");
    assert!(english(&fault["help"]).starts_with("did you mean friction?"));
    let lines: Vec<&str> = riffel_case::NOMINAL_CASE.lines().collect();
    let line = fault["line"].as_u64().unwrap() as usize;
    assert!(lines[line - 1].starts_with("friction"), "{line}");

    let syntax = ask("/api/case", &json!({ "case": { "toml": "a = = b" } })).await.json();
    assert!(english(&syntax["message"]).starts_with("not valid TOML"));
    assert_eq!(syntax["line"], 1);
    let unit = ask("/api/map", &nominal(&[("\"50 kN\"", "\"50 kg\"")])).await.json();
    assert_eq!(unit["key"], "contact.normal_load");
}

#[tokio::test]
async fn a_case_of_the_page_names_no_files() {
    let measured = "model = \"measured\"\nmeasurement = { file = \"/etc/passwd\" }";
    for changes in [
        &[("model = \"free-beam\"", measured)][..],
        // Even where the model would not read it.
        &[("model = \"free-beam\"", "model = \"free-beam\"\nmeasurement = { file = \"/etc/passwd\" }")],
    ] {
        for path in ["/api/case", "/api/map", "/api/export/svg"] {
            let answer = ask(path, &nominal(changes)).await;
            assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{path}");
            assert_eq!(answer.json()["key"], "track.measurement.file");
            assert!(answer.message().contains("may not name any"), "{}", answer.message());
        }
    }
}

#[tokio::test]
async fn limits_of_size_are_told_in_sentences() {
    let map = nominal(&[("points = 241", "points = 5000"), ("points = 221", "points = 5000")]);
    let answer = ask("/api/map", &map).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(answer.json()["key"], "map.wavelength.points");
    let fine = nominal(&[("friction = 0.4", "response = \"non-steady\"\ngrid = 200\nfriction = 0.4")]);
    assert_eq!(ask("/api/map", &fine).await.json()["key"], "contact.grid");

    let long = format!("title = \"{}\"\n{}", "a".repeat(65 * 1024), riffel_case::NOMINAL_CASE);
    let answer = ask("/api/case", &json!({ "case": { "toml": long } })).await;
    assert_eq!(answer.status, StatusCode::PAYLOAD_TOO_LARGE);
    let huge = question("/api/map", vec![b' '; 1 << 20]);
    let answer = send(&page(), huge).await;
    assert_eq!(answer.status, StatusCode::PAYLOAD_TOO_LARGE);
    assert!(answer.message().contains("KiB"));
}

#[tokio::test]
async fn what_is_no_question_is_told_so() {
    for body in ["", "{", "[]", "{\"case\":1}", "{\"case\":{\"keys\":{\"a\":null}}}"] {
        let answer = send(&page(), question("/api/map", body)).await;
        assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{body}");
        assert!(!answer.message().is_empty());
    }
    let mut request = question("/api/map", nominal(&[]).to_string());
    let kind = request.headers_mut();
    kind.insert(header::CONTENT_TYPE, "text/plain".parse().unwrap());
    assert_eq!(send(&page(), request).await.status, StatusCode::UNSUPPORTED_MEDIA_TYPE);
    for path in ["/assets/../src/lib.rs", "/assets/x/main.js", "/etc/passwd", "/api/secret"] {
        assert_eq!(get(path).await.status, StatusCode::NOT_FOUND, "{path}");
    }
    assert_eq!(ask("/api/export/exe", &nominal(&[])).await.status, StatusCode::BAD_REQUEST);
}

#[tokio::test]
async fn a_full_queue_says_when_to_come_again() {
    let page = page_with(Queue::with_limits(0, 0, Duration::from_secs(1)));
    let answer = send(&page, question("/api/map", nominal(&[]).to_string())).await;
    assert_eq!(answer.status, StatusCode::SERVICE_UNAVAILABLE);
    assert_eq!(answer.headers[header::RETRY_AFTER], "1");
    assert!(answer.message().contains("too much"));
}

#[tokio::test]
async fn a_question_about_a_file_needs_that_file() {
    let case: toml::Table = riffel_case::NOMINAL_CASE.parse().unwrap();
    let mut body = json!({ "case": case, "roughness": { "upload": 1, "name": "profile.csv" }, "speed": "25 m/s" });
    let page = page();
    let asked =
        async |name: &str, body: &Value| send(&page, question(&format!("/api/ask/{name}"), body.to_string())).await;
    assert_eq!(asked("noise", &body).await.status, StatusCode::GONE);
    let sent = send(&page, question("/api/upload", "position_m,left_um\n0,1\n")).await;
    assert_eq!(sent.json(), json!({ "upload": 1, "bytes": 23 }));
    // Without the program the page says so; it does not break off.
    assert_eq!(asked("noise", &body).await.status, StatusCode::INTERNAL_SERVER_ERROR);
    for nameless in [json!({ "upload": 1 }), json!({ "text": "0,1" })] {
        let body = json!({ "case": body["case"], "roughness": nameless, "speed": "25 m/s" });
        let answer = asked("noise", &body).await;
        assert_eq!(
            (answer.status, &*answer.message()),
            (StatusCode::UNPROCESSABLE_ENTITY, "`roughness.name` is missing")
        );
    }
    body["roughness"]["upload"] = json!(2);
    assert_eq!(asked("noise", &body).await.status, StatusCode::GONE);
    let twice = question("/api/ask/noise", r#"{ "speed": 30, "case": { "a": 1, "a": 2 } }"#);
    let twice = send(&page, twice).await;
    assert_eq!(twice.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(twice.message(), "`a` is given twice, the second time in line 1");
    let unknown = asked("sound", &body).await;
    assert!(unknown.message().starts_with("NAME is sound, but must be one of point, "), "{}", unknown.message());
}

#[tokio::test]
async fn a_question_stays_within_what_the_page_computes() {
    let case = json!({ "contact": { "response": "non-steady", "grid": 2000 } });
    for (body, words) in [
        (json!({ "limit_dba": 500 }), "--limit-dba is 500, but must be from 0 to 200"),
        (json!({ "months": 0 }), "--months is 0, but must be above zero and at most 1200"),
        // As texts, too.
        (json!({ "months": "1e9" }), "--months is 1000000000, but must be above zero and at most 1200"),
        (json!({ "block": "5 mm" }), "--block is 0.005, but must be from 1 to 1000000"),
        (json!({ "case": case }), "2000"),
        // No question of a page says where to write.
        (json!({ "posterior": "/tmp" }), "`posterior` is a place on the disk and not for a page: leave it out"),
        (json!({ "output": "/tmp/results" }), "`output` is a place on the disk and not for a page: leave it out"),
    ] {
        let answer = ask("/api/ask/noise", &body).await;
        assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{words}");
        assert!(answer.message().contains(words), "{}", answer.message());
    }
}

/// A window of frequencies that overflow used to keep a worker for good; two of them stopped the page.
#[tokio::test]
async fn windows_beyond_physics_are_refused_at_once() {
    for (from, to, key) in [
        ("min = \"20 mm\"", "min = 1e-300", "map.wavelength.min"),
        ("max = \"60 m/s\"", "max = 1e300", "map.speed.max"),
        ("friction = 0.4", "friction = 1e-320", "contact.friction"),
    ] {
        for path in ["/api/map", "/api/point"] {
            let mut body = nominal(&[(from, to)]);
            body["wavelength_m"] = json!(0.055);
            body["speed_m_per_s"] = json!(30.0);
            let answer = tokio::time::timeout(Duration::from_secs(300), ask(path, &body));
            let answer = answer.await.unwrap();
            assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{path}");
            assert!(answer.message().contains("but must be between"), "{}", answer.message());
            assert_eq!(answer.json()["key"], key, "{path}");
        }
    }
}

#[tokio::test]
async fn a_request_of_another_form_keeps_its_insides_for_developers() {
    let answer = ask("/api/map", &json!({ "case": { "keys": null } })).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
    let fault = answer.json();
    let inside = |key: &str| fault[key].to_string().contains("invalid type");
    assert!(inside("detail") && !inside("message") && !inside("help"), "{fault}");
}
