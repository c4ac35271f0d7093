//! Who may ask: the page itself and nobody else; and what the browser may do with an answer.
//!
//! A program that listens on this machine can be reached by any page that the same browser shows. Two
//! checks keep those out. A page of another origin is told by `Origin` or `Sec-Fetch-Site`. A page whose
//! own name has been made to point at this machine (DNS rebinding) is of the same origin to the browser,
//! but is told by `Host`: the name is still its own. Addresses written as numbers cannot be rebound.

use std::net::IpAddr;

use axum::extract::Request;
use axum::http::{HeaderName, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use crate::fault::{Fault, Refusal};

/// What the page may load and do: its own files, nothing else.
///
/// plotly.js makes a style element without text and adds its rules by script. The hash is that of the
/// empty text: it lets that element be, and no style with any text in it.
const POLICY: &str = "default-src 'none'; script-src 'self'; \
    style-src 'self' 'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='; img-src 'self' data: blob:; \
    connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Headers of every answer.
const HEADERS: [(HeaderName, &str); 7] = [
    (header::CONTENT_SECURITY_POLICY, POLICY),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("permissions-policy"), "camera=(), microphone=(), geolocation=()"),
];

/// Check a request, pass it on and put the headers on its answer.
pub(crate) async fn guard(request: Request, next: Next) -> Response {
    let mut response = match check(&request) {
        Ok(()) => next.run(request).await,
        Err(fault) => Refusal(fault).into_response(),
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.entry(header::CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}

fn check(request: &Request) -> Result<(), Fault> {
    let headers = request.headers();
    let text = |name: HeaderName| headers.get(name).and_then(|value| value.to_str().ok());
    let host = text(header::HOST).unwrap_or_default();
    if !is_this_machine(host) {
        return Err(Fault::refused(
            StatusCode::MISDIRECTED_REQUEST,
            format!("this page is not served under the name \"{}\"", shown(host)),
            "open it by the address that riffel serve prints",
        ));
    }
    let site = text(HeaderName::from_static("sec-fetch-site"));
    let same_origin = match text(header::ORIGIN) {
        Some(origin) => Some(origin == format!("http://{host}")),
        None => site.map(|site| site == "same-origin"),
    };
    let gets = matches!(*request.method(), Method::GET | Method::HEAD);
    // A link leads here from anywhere, but nobody else asks.
    let is_file = gets && !request.uri().path().starts_with("/api/");
    // Of a question, browsers of before 2023 leave one of the two out, never both.
    if is_file || same_origin.unwrap_or(gets) {
        return Ok(());
    }
    Err(Fault::refused(
        StatusCode::FORBIDDEN,
        "only the page itself may ask for results".to_owned(),
        "the header Origin must be that of the page",
    ))
}

/// True for `localhost` or an address written as numbers, with or without a port.
fn is_this_machine(host: &str) -> bool {
    let (name, port) = match host.rsplit_once(':') {
        // The colons of an address of version 6 stand in brackets.
        Some((name, port)) if !port.ends_with(']') => (name, Some(port)),
        _ => (host, None),
    };
    let port_is_a_number = port.is_none_or(|port| !port.is_empty() && port.bytes().all(|byte| byte.is_ascii_digit()));
    let bare = name.strip_prefix('[').and_then(|name| name.strip_suffix(']'));
    let is_address = bare.map_or_else(
        || name.parse::<IpAddr>().is_ok_and(|address| address.is_ipv4()),
        |name| name.parse::<IpAddr>().is_ok_and(|address| address.is_ipv6()),
    );
    port_is_a_number && (name.eq_ignore_ascii_case("localhost") || is_address)
}

/// The beginning of words that somebody else has sent.
fn shown(words: &str) -> String {
    words.chars().take(80).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_numbers_and_localhost_are_this_machine() {
        for host in
            ["127.0.0.1:8311", "127.0.0.1", "localhost:8311", "LOCALHOST", "[::1]:8311", "[::1]", "192.168.1.7:80"]
        {
            assert!(is_this_machine(host), "{host}");
        }
        for host in [
            "",
            "evil.example",
            "evil.example:8311",
            "localhost.evil.example:8311",
            "127.0.0.1.evil.example",
            "127.0.0.1:8311@evil.example",
            "localhost:",
            "[localhost]:80",
            "::1",
            "[::1",
        ] {
            assert!(!is_this_machine(host), "{host}");
        }
    }
}
