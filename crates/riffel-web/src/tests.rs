//! The page asked one request at a time, without a socket.

use axum::body::{Body, to_bytes};
use axum::http::{HeaderMap, Request, StatusCode, header};
use serde_json::{Value, json};
use std::time::Duration;
use tower::ServiceExt;

use crate::program::Program;
use crate::queue::Queue;
use crate::uploads::Uploads;
use crate::{Page, router};

const HOST: &str = "127.0.0.1:8311";
const ORIGIN: &str = "http://127.0.0.1:8311";

fn page_with(queue: Queue) -> Page {
    Page {
        queue,
        marches: Queue::new(1),
        long: Queue::for_files(),
        uploads: Uploads::new().unwrap(),
        program: Program::new(vec!["/nowhere/riffel".into()]),
    }
}

fn page() -> Page {
    page_with(Queue::new(2))
}

struct Answer {
    status: StatusCode,
    headers: HeaderMap,
    bytes: Vec<u8>,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.bytes)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&self.bytes)))
    }

    fn message(&self) -> String {
        self.json()["message"].as_str().unwrap().to_owned()
    }

    /// Head and values of a framed answer.
    fn framed(&self) -> (Value, Vec<f32>) {
        let length = u32::from_le_bytes(self.bytes[..4].try_into().unwrap()) as usize;
        let head = serde_json::from_slice(&self.bytes[4..4 + length]).unwrap();
        let values = self.bytes[4 + length..].as_chunks::<4>().0;
        (
            head,
            values.iter().map(|&v| f32::from_le_bytes(v)).collect(),
        )
    }
}

async fn send(page: &Page, request: Request<Body>) -> Answer {
    let response = router(page.clone()).oneshot(request).await.unwrap();
    Answer {
        status: response.status(),
        headers: response.headers().clone(),
        bytes: to_bytes(response.into_body(), usize::MAX)
            .await
            .unwrap()
            .to_vec(),
    }
}

async fn get(path: &str) -> Answer {
    let request = Request::get(path).header(header::HOST, HOST);
    send(&page(), request.body(Body::empty()).unwrap()).await
}

fn question(path: &str, body: impl Into<Body>) -> Request<Body> {
    Request::post(path)
        .header(header::HOST, HOST)
        .header(header::ORIGIN, ORIGIN)
        .header(header::CONTENT_TYPE, "application/json")
        .header("x-riffel-page", "a")
        .body(body.into())
        .unwrap()
}

async fn ask(path: &str, body: &Value) -> Answer {
    send(&page(), question(path, body.to_string())).await
}

/// The nominal case with changes to its text.
fn nominal(changes: &[(&str, &str)]) -> Value {
    let mut text = riffel_case::NOMINAL_CASE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    json!({ "case": { "toml": text } })
}

#[tokio::test]
async fn the_page_comes_with_a_policy_and_its_files_for_ever() {
    let page = get("/").await;
    assert_eq!(page.status, StatusCode::OK);
    let policy = page.headers[header::CONTENT_SECURITY_POLICY]
        .to_str()
        .unwrap();
    for rule in [
        "default-src 'none'",
        "script-src 'self';",
        "connect-src 'self'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    ] {
        assert!(policy.contains(rule), "{policy}");
    }
    assert!(!policy.contains("unsafe"));
    assert_eq!(page.headers["x-content-type-options"], "nosniff");
    assert_eq!(page.headers["referrer-policy"], "no-referrer");
    let html = String::from_utf8(page.bytes).unwrap();
    assert!(!html.contains("{assets}") && !html.contains("{plotly}"));
    assert!(
        !html.contains("http://") && !html.contains("https://"),
        "nothing is loaded"
    );
    // Every file of the page is there, under an address that changes with its content.
    let addresses: Vec<&str> = html
        .split('"')
        .filter(|word| word.starts_with("/assets/"))
        .collect();
    assert!(addresses.len() >= 4, "{addresses:?}");
    for address in addresses {
        let file = get(address).await;
        assert_eq!(file.status, StatusCode::OK, "{address}");
        let kept = file.headers[header::CACHE_CONTROL].to_str().unwrap();
        assert!(kept.contains("immutable"), "{address}: {kept}");
    }
}

#[tokio::test]
async fn every_module_that_a_module_imports_is_served() {
    let html = String::from_utf8(get("/").await.bytes).unwrap();
    let folder = html
        .split('"')
        .find(|word| word.ends_with("/main.js"))
        .unwrap();
    let folder = folder.strip_suffix("main.js").unwrap();
    let mut asked = vec!["main.js".to_owned()];
    let mut next = 0;
    while let Some(name) = asked.get(next).cloned() {
        next += 1;
        let file = get(&format!("{folder}{name}")).await;
        assert_eq!(file.status, StatusCode::OK, "{name}");
        let text = String::from_utf8(file.bytes).unwrap();
        for import in text.split("from './").skip(1) {
            let import = import.split('\'').next().unwrap().to_owned();
            if !asked.contains(&import) {
                asked.push(import);
            }
        }
    }
    assert!(asked.len() > 10, "{asked:?}");
}

#[tokio::test]
async fn a_page_that_is_known_is_not_sent_again() {
    let first = get("/").await;
    let request = Request::get("/")
        .header(header::HOST, HOST)
        .header(header::IF_NONE_MATCH, &first.headers[header::ETAG]);
    let again = send(&page(), request.body(Body::empty()).unwrap()).await;
    assert_eq!(again.status, StatusCode::NOT_MODIFIED);
    assert!(again.bytes.is_empty());
}

#[tokio::test]
async fn other_names_other_origins_and_no_origin_are_refused() {
    for host in [
        "evil.example",
        "evil.example:8311",
        "127.0.0.1.evil.example",
    ] {
        let request = Request::get("/").header(header::HOST, host);
        let answer = send(&page(), request.body(Body::empty()).unwrap()).await;
        assert_eq!(answer.status, StatusCode::MISDIRECTED_REQUEST, "{host}");
    }
    let body = nominal(&[]).to_string();
    let from = |headers: &[(&str, &str)]| {
        let mut request = Request::post("/api/case")
            .header(header::HOST, HOST)
            .header(header::CONTENT_TYPE, "application/json");
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        request.body(Body::from(body.clone())).unwrap()
    };
    for headers in [
        &[][..],
        &[("origin", "http://evil.example")],
        &[("origin", "http://127.0.0.1:9999")],
        &[("origin", "null")],
        &[("origin", "https://127.0.0.1:8311")],
        &[("sec-fetch-site", "cross-site")],
        &[("sec-fetch-site", "same-site")],
        &[
            ("origin", "http://evil.example"),
            ("sec-fetch-site", "same-origin"),
        ],
    ] {
        let answer = send(&page(), from(headers)).await;
        assert_eq!(answer.status, StatusCode::FORBIDDEN, "{headers:?}");
    }
    for headers in [
        &[("origin", ORIGIN)][..],
        &[("sec-fetch-site", "same-origin")],
    ] {
        assert_eq!(send(&page(), from(headers)).await.status, StatusCode::OK);
    }
}

#[tokio::test]
async fn a_map_is_that_of_the_program() {
    let answer = ask("/api/map", &nominal(&[])).await;
    assert_eq!(answer.status, StatusCode::OK);
    let (head, values) = answer.framed();
    let case = riffel_case::Case::parse("nominal", riffel_case::NOMINAL_CASE, &[]).unwrap();
    let points = (case.wavelength.points(), case.speed.points());
    assert_eq!(values.len(), points.0 * points.1);
    for (column, row) in [(0, 0), (100, 110), (240, 220)] {
        let state = case
            .feedback
            .at(case.wavelength.value(column), case.speed.value(row));
        let expected = state.normalized_dissipation.re as f32;
        // The map agrees with the loop to rounding, then both are rounded to 32 bits.
        let got = values[row * points.0 + column];
        assert!(
            (got - expected).abs() <= 2.0 * f32::EPSILON * expected.abs(),
            "{got} {expected}"
        );
    }
    assert!((530.0..545.0).contains(&head["best_fit_frequency_hz"].as_f64().unwrap()));
    let branches = head["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 1);
    assert_eq!(branches[0]["frequency_hz"], head["best_fit_frequency_hz"]);
    let columns = &branches[0]["points"];
    assert_eq!(
        columns["speed_m_per_s"].as_array().unwrap().len(),
        columns["wavelength_m"].as_array().unwrap().len()
    );
    let german = head["branches_in_words"]["de"].as_str().unwrap();
    assert!(german.contains("bei 537 Hz"), "{german}");
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
        assert!(
            (got - expected).abs() <= 1e-15 * expected.abs(),
            "{got} {expected}"
        );
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
    assert!(
        (curve - there.re).abs() <= 1e-12 * there.norm(),
        "{curve} {there}"
    );
    body["wavelength_m"] = json!(0.5);
    let outside = ask("/api/point", &body).await;
    assert_eq!(outside.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(outside.json()["key"], "map.wavelength");
}

#[tokio::test]
async fn errors_are_those_of_the_program_with_key_line_and_help() {
    let answer = ask(
        "/api/case",
        &nominal(&[("friction = 0.4", "frction = 0.4")]),
    )
    .await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
    let fault = answer.json();
    assert_eq!(fault["key"], "contact.frction");
    assert_eq!(
        fault["message"],
        "`contact.frction` is not a key Riffel knows"
    );
    assert!(
        fault["help"]
            .as_str()
            .unwrap()
            .starts_with("did you mean friction?")
    );
    let lines: Vec<&str> = riffel_case::NOMINAL_CASE.lines().collect();
    let line = fault["line"].as_u64().unwrap() as usize;
    assert!(lines[line - 1].starts_with("friction"), "{line}");

    let syntax = ask("/api/case", &json!({ "case": { "toml": "a = = b" } }))
        .await
        .json();
    assert!(
        syntax["message"]
            .as_str()
            .unwrap()
            .starts_with("not valid TOML")
    );
    assert_eq!(syntax["line"], 1);
    let unit = ask("/api/map", &nominal(&[("\"50 kN\"", "\"50 kg\"")]))
        .await
        .json();
    assert_eq!(unit["key"], "contact.normal_load");
}

#[tokio::test]
async fn keys_and_text_say_the_same() {
    let text = ask("/api/case", &nominal(&[])).await.json();
    let keys = ask("/api/case", &json!({ "case": { "keys": text["keys"] } }))
        .await
        .json();
    assert_eq!(keys["complete"], text["complete"]);
    let again = json!({ "case": { "toml": keys["toml"] } });
    assert_eq!(
        ask("/api/case", &again).await.json()["complete"],
        text["complete"]
    );
}

#[tokio::test]
async fn a_case_of_the_page_names_no_files() {
    let measured = "model = \"measured\"\nmeasurement = { file = \"/etc/passwd\" }";
    for changes in [
        &[("model = \"free-beam\"", measured)][..],
        // Even where the model would not read it.
        &[(
            "model = \"free-beam\"",
            "model = \"free-beam\"\nmeasurement = { file = \"/etc/passwd\" }",
        )],
    ] {
        for path in ["/api/case", "/api/map", "/api/export/svg"] {
            let answer = ask(path, &nominal(changes)).await;
            assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{path}");
            assert_eq!(answer.json()["key"], "track.measurement.file");
            assert!(
                answer.message().contains("may not name any"),
                "{}",
                answer.message()
            );
        }
    }
}

#[tokio::test]
async fn limits_of_size_are_told_in_sentences() {
    let map = nominal(&[
        ("points = 241", "points = 5000"),
        ("points = 221", "points = 5000"),
    ]);
    let answer = ask("/api/map", &map).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
    assert_eq!(answer.json()["key"], "map.wavelength.points");
    let fine = nominal(&[(
        "friction = 0.4",
        "response = \"non-steady\"\ngrid = 200\nfriction = 0.4",
    )]);
    assert_eq!(ask("/api/map", &fine).await.json()["key"], "contact.grid");

    let long = format!(
        "title = \"{}\"\n{}",
        "a".repeat(65 * 1024),
        riffel_case::NOMINAL_CASE
    );
    let answer = ask("/api/case", &json!({ "case": { "toml": long } })).await;
    assert_eq!(answer.status, StatusCode::PAYLOAD_TOO_LARGE);
    let huge = question("/api/map", vec![b' '; 1 << 20]);
    let answer = send(&page(), huge).await;
    assert_eq!(answer.status, StatusCode::PAYLOAD_TOO_LARGE);
    assert!(answer.message().contains("KiB"));
}

#[tokio::test]
async fn what_is_no_question_is_told_so() {
    for body in [
        "",
        "{",
        "[]",
        "{\"case\":1}",
        "{\"case\":{\"keys\":{\"a\":null}}}",
    ] {
        let answer = send(&page(), question("/api/map", body)).await;
        assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY, "{body}");
        assert!(!answer.message().is_empty());
    }
    let mut request = question("/api/map", nominal(&[]).to_string());
    let kind = request.headers_mut();
    kind.insert(header::CONTENT_TYPE, "text/plain".parse().unwrap());
    assert_eq!(
        send(&page(), request).await.status,
        StatusCode::UNSUPPORTED_MEDIA_TYPE
    );
    for path in [
        "/assets/../src/lib.rs",
        "/assets/x/main.js",
        "/etc/passwd",
        "/api/secret",
    ] {
        assert_eq!(get(path).await.status, StatusCode::NOT_FOUND, "{path}");
    }
    assert_eq!(
        ask("/api/export/exe", &nominal(&[])).await.status,
        StatusCode::BAD_REQUEST
    );
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
async fn variants_are_compared_in_the_window_of_the_case() {
    let narrow = nominal(&[
        ("\"80 mm\"", "\"60 mm\""),
        ("friction = 0.4", "friction = 0.2"),
    ]);
    let case = nominal(&[])["case"].clone();
    let variants = json!([
        { "name": "A", "case": narrow["case"] }, { "name": "now", "case": case },
    ]);
    let (head, values) = ask(
        "/api/compare",
        &json!({ "variants": variants, "case": case }),
    )
    .await
    .framed();
    assert_eq!(values.len(), 2 * 241 * 221);
    let [one, other] = [&head["variants"][0], &head["variants"][1]];
    assert_eq!(one["window"], other["window"]);
    assert_eq!(one["complete"]["contact"]["friction"], json!(0.2));
    assert!(one["under_traffic"]["fastest"]["wavelength_m"].is_number());
    // A variant without an answer under the traffic leaves the maps, and says why.
    let traffic = json!({
        "slowest_m_per_s": 10, "fastest_m_per_s": 20, "passages_per_day": 1000, "all_wheels": true,
    });
    let question = json!({ "variants": variants, "case": case, "traffic": traffic });
    let (head, values) = ask("/api/compare", &question).await.framed();
    assert_eq!(values.len(), 2 * 241 * 221);
    let why = &head["variants"][0]["under_traffic"]["fault"]["message"];
    assert!(why.as_str().unwrap().contains("curve"), "{why}");
    let refused = nominal(&[("friction = 0.4", "friction = -1")])["case"].clone();
    let wrong = json!({ "variants": [{ "name": "dry", "case": refused }], "case": case });
    let fault = ask("/api/compare", &wrong).await.json();
    let message = fault["message"].as_str().unwrap();
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
    let curves = ask(
        "/api/growth",
        &json!({ "for": "variants", "curves": [curve], "case": case }),
    )
    .await
    .json();
    let mut point = nominal(&[]);
    point["wavelength_m"] = json!(0.04);
    point["speed_m_per_s"] = json!(20.0);
    let point = ask("/api/point", &point).await.json();
    assert_eq!(curves[0], point["growth"]);
    let still = json!({ "name": "A", "case": case, "speed_m_per_s": 0.0 });
    let fault = ask(
        "/api/growth",
        &json!({ "for": "sweep", "curves": [still], "case": case }),
    )
    .await;
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
    let figure = ask(
        "/api/figure",
        &json!({ "number": 7, "contact": "quasi-static" }),
    )
    .await
    .json();
    assert_eq!(figure["lines"][0]["series"].as_array().unwrap().len(), 5);
    let german = ask(
        "/api/figure",
        &json!({ "number": 7, "contact": "quasi-static", "language": "de" }),
    )
    .await
    .json();
    assert!(german["title"].as_str().unwrap().starts_with("Bild 7."));
    assert!(german["caption"].as_str().unwrap().contains("R = 0,46 m"));
    let label = &german["lines"][0]["series"][1]["label"];
    assert_eq!(label, "13,89 kg m²");
    let none = ask(
        "/api/figure",
        &json!({ "number": 1, "contact": "quasi-static" }),
    )
    .await;
    assert_eq!(none.status, StatusCode::UNPROCESSABLE_ENTITY);
}

#[tokio::test]
async fn a_measured_rail_needs_its_file() {
    let mut body = nominal(&[]);
    body["name"] = json!("profile.csv");
    body["slowest_m_per_s"] = json!(20.0);
    body["fastest_m_per_s"] = json!(25.0);
    body["passages_per_day"] = json!(1000.0);
    body["months"] = json!(12.0);
    let page = page();
    let gone = send(&page, question("/api/measure", body.to_string())).await;
    assert_eq!(gone.status, StatusCode::GONE);
    let sent = send(
        &page,
        question("/api/roughness", "position_m,left_um\n0,1\n"),
    )
    .await;
    assert_eq!(sent.json()["bytes"], 23);
    // Without the program the page says so; it does not break off.
    let answer = send(&page, question("/api/measure", body.to_string())).await;
    assert_eq!(answer.status, StatusCode::INTERNAL_SERVER_ERROR);
    // A free rail has no level, whatever is in the file.
    let silent = send(&page, question("/api/noise", body.to_string())).await;
    assert_eq!(silent.json()["fault"]["key"], "track.model");
    body["limit_dba"] = json!(500.0);
    let loud = send(&page, question("/api/noise", body.to_string())).await;
    assert_eq!(loud.status, StatusCode::UNPROCESSABLE_ENTITY);
    body["fastest_m_per_s"] = json!(5.0);
    let answer = send(&page, question("/api/measure", body.to_string())).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
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
            assert!(
                answer.message().contains("but must be between"),
                "{}",
                answer.message()
            );
            assert_eq!(answer.json()["key"], key, "{path}");
        }
    }
}

/// The sliders of the page move within what is usual, so that none of their places is asked about.
#[test]
fn sliders_stay_within_what_is_usual() {
    let form = include_str!("../assets/form.js");
    let sliders = form.split_once("const SLIDERS = {").unwrap().1;
    let sliders = sliders.split_once("};").unwrap().0;
    let mut seen = 0;
    for slider in sliders.split("],").filter(|slider| slider.contains('[')) {
        let (key, ends) = slider.trim().split_once(": [").unwrap();
        let mut ends = ends.split(", ").map(|end| end.parse::<f64>());
        let [low, high] = [(); 2].map(|()| ends.next().unwrap().unwrap());
        let key = key.trim_matches('\'');
        let range = riffel_keys::PhysicalRange::of(key).unwrap();
        assert!(
            range.usual[0] <= low && low < high && high <= range.usual[1],
            "{key}"
        );
        seen += 1;
    }
    assert_eq!(seen, 5);
}

#[tokio::test]
async fn a_request_of_another_form_keeps_its_insides_for_developers() {
    let answer = ask("/api/map", &json!({ "case": { "keys": null } })).await;
    assert_eq!(answer.status, StatusCode::UNPROCESSABLE_ENTITY);
    let fault = answer.json();
    let inside = |key: &str| fault[key].as_str().unwrap().contains("invalid type");
    assert!(
        inside("detail") && !inside("message") && !inside("help"),
        "{fault}"
    );
}
