//! The page asked one request at a time, without a socket.

mod cases;
mod refusals;

use axum::body::{Body, to_bytes};
use axum::http::{HeaderMap, Request, StatusCode, header};
use riffel_keys::Language;
use riffel_keys::message::wordings;
use serde_json::{Value, json};
use tower::ServiceExt;

use crate::answered::Answered;
use crate::program::Program;
use crate::queue::Queue;
use crate::uploads::Uploads;
use crate::{Page, router};

const HOST: &str = "127.0.0.1:8311";
const ORIGIN: &str = "http://127.0.0.1:8311";

fn page_with(queue: Queue) -> Page {
    Page {
        queue,
        answered: Answered::default(),
        marches: Queue::new(1),
        long: Queue::for_files(),
        chains: Queue::for_files(),
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
        serde_json::from_slice(&self.bytes).unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&self.bytes)))
    }

    fn message(&self) -> String {
        english(&self.json()["message"])
    }

    /// Head and values of a framed answer.
    fn framed(&self) -> (Value, Vec<f32>) {
        let length = u32::from_le_bytes(self.bytes[..4].try_into().unwrap()) as usize;
        let head = serde_json::from_slice(&self.bytes[4..4 + length]).unwrap();
        let values = self.bytes[4 + length..].as_chunks::<4>().0;
        (head, values.iter().map(|&v| f32::from_le_bytes(v)).collect())
    }
}

/// A message in English, as the page makes it of its data.
fn english(said: &Value) -> String {
    in_words(Language::English, said)
}

/// A message in a language, as the page makes it of its data.
fn in_words(language: Language, said: &Value) -> String {
    let Value::Object(data) = said else {
        return said.as_str().map_or_else(|| said.to_string(), str::to_owned);
    };
    if let Some(shown) = ["number", "text", "key", "capital"].iter().find_map(|kind| data.get(*kind)) {
        return in_words(language, shown);
    }
    match wordings(language).get(data["id"].as_str().unwrap()) {
        Some(wording) => filled(language, wording, &data["values"]),
        None => in_words(language, &data["english"]),
    }
}

fn filled(language: Language, wording: &Value, values: &Value) -> String {
    let named = |part: &Value, kind: &str| part.get(kind).and_then(Value::as_str).map(str::to_owned);
    let part = |part: &Value| match (named(part, "value"), named(part, "choice")) {
        (Some(value), _) => in_words(language, &values[value]),
        (_, Some(value)) if values[value.as_str()] == 1 => filled(language, &part["among"]["one"], values),
        (_, Some(value)) => {
            let own = values[value.as_str()].as_str().and_then(|text| part["among"].get(text));
            filled(language, own.unwrap_or(&part["among"]["other"]), values)
        }
        (None, None) => in_words(language, part),
    };
    match wording {
        Value::Array(parts) => parts.iter().map(part).collect(),
        text => in_words(language, text),
    }
}

async fn send(page: &Page, request: Request<Body>) -> Answer {
    let response = router(page.clone()).oneshot(request).await.unwrap();
    Answer {
        status: response.status(),
        headers: response.headers().clone(),
        bytes: to_bytes(response.into_body(), usize::MAX).await.unwrap().to_vec(),
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
    let policy = page.headers[header::CONTENT_SECURITY_POLICY].to_str().unwrap();
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
    assert!(!html.contains("http://") && !html.contains("https://"), "nothing is loaded");
    // Every file of the page is there, under an address that changes with its content.
    let addresses: Vec<&str> = html.split('"').filter(|word| word.starts_with("/assets/")).collect();
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
    let folder = html.split('"').find(|word| word.ends_with("/main.js")).unwrap();
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
    let request =
        Request::get("/").header(header::HOST, HOST).header(header::IF_NONE_MATCH, &first.headers[header::ETAG]);
    let again = send(&page(), request.body(Body::empty()).unwrap()).await;
    assert_eq!(again.status, StatusCode::NOT_MODIFIED);
    assert!(again.bytes.is_empty());
}

#[tokio::test]
async fn other_names_other_origins_and_no_origin_are_refused() {
    for host in ["evil.example", "evil.example:8311", "127.0.0.1.evil.example"] {
        let request = Request::get("/").header(header::HOST, host);
        let answer = send(&page(), request.body(Body::empty()).unwrap()).await;
        assert_eq!(answer.status, StatusCode::MISDIRECTED_REQUEST, "{host}");
    }
    let body = nominal(&[]).to_string();
    let from = |headers: &[(&str, &str)]| {
        let mut request =
            Request::post("/api/case").header(header::HOST, HOST).header(header::CONTENT_TYPE, "application/json");
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
        &[("origin", "http://evil.example"), ("sec-fetch-site", "same-origin")],
    ] {
        let answer = send(&page(), from(headers)).await;
        assert_eq!(answer.status, StatusCode::FORBIDDEN, "{headers:?}");
    }
    for headers in [&[("origin", ORIGIN)][..], &[("sec-fetch-site", "same-origin")]] {
        assert_eq!(send(&page(), from(headers)).await.status, StatusCode::OK);
    }
}

/// A link may lead to the page from anywhere; a question is the page's own, by whatever method.
#[tokio::test]
async fn other_origins_get_the_page_and_no_answer() {
    let from = async |path: &str, name: &str, value: &str| {
        let request = Request::get(path).header(header::HOST, HOST);
        let request = request.header("x-riffel-page", "a").header(name, value);
        let answer = send(&page(), request.body(Body::empty()).unwrap()).await;
        answer.status
    };
    for path in ["/api/vocabulary", "/api/calibration/example"] {
        for (name, value) in [
            ("origin", "http://evil.example"),
            ("origin", "null"),
            ("sec-fetch-site", "cross-site"),
            ("sec-fetch-site", "same-site"),
        ] {
            let status = from(path, name, value).await;
            assert_eq!(status, StatusCode::FORBIDDEN, "{path} {value}");
        }
        let own = from(path, "sec-fetch-site", "same-origin").await;
        assert_ne!(own, StatusCode::FORBIDDEN, "{path}");
    }
    assert_eq!(from("/", "sec-fetch-site", "cross-site").await, StatusCode::OK);
    // A browser that tells no site, as over a network, says which page asks; another page cannot.
    assert_eq!(get("/api/vocabulary").await.status, StatusCode::OK);
}
