//! The files of the page, inside the program.

use std::sync::LazyLock;

use axum::extract::Path;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::{IntoResponse, Response};
use riffel_keys::Language;
use riffel_keys::message::wordings;
use riffel_plot::plotly_js;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// Name, content type and text of the files written here.
macro_rules! files {
    ($($name:literal: $kind:literal),* $(,)?) => {
        [$(($name, $kind, include_str!(concat!("../assets/", $name)))),*]
    };
}

const SCRIPT: &str = "text/javascript; charset=utf-8";

static FILES: &[(&str, &str, &str)] = &files! {
    "page.css": "text/css; charset=utf-8",
    "icon.svg": "image/svg+xml",
    "along.js": "text/javascript; charset=utf-8",
    "banner.js": "text/javascript; charset=utf-8",
    "bogie.js": "text/javascript; charset=utf-8",
    "bogie-wheels.js": "text/javascript; charset=utf-8",
    "calibrate.js": "text/javascript; charset=utf-8",
    "calibration-answer.js": "text/javascript; charset=utf-8",
    "calibration-data.js": "text/javascript; charset=utf-8",
    "calm.js": "text/javascript; charset=utf-8",
    "case-panel.js": "text/javascript; charset=utf-8",
    "causes.js": "text/javascript; charset=utf-8",
    "bogie-drawing.js": "text/javascript; charset=utf-8",
    "colors.js": "text/javascript; charset=utf-8",
    "columns.js": "text/javascript; charset=utf-8",
    "compare.js": "text/javascript; charset=utf-8",
    "level-trend.js": "text/javascript; charset=utf-8",
    "curves.js": "text/javascript; charset=utf-8",
    "damage.js": "text/javascript; charset=utf-8",
    "decision.js": "text/javascript; charset=utf-8",
    "earlier.js": "text/javascript; charset=utf-8",
    "elements.js": "text/javascript; charset=utf-8",
    "figures.js": "text/javascript; charset=utf-8",
    "faults.js": "text/javascript; charset=utf-8",
    "field.js": "text/javascript; charset=utf-8",
    "form.js": "text/javascript; charset=utf-8",
    "keys.js": "text/javascript; charset=utf-8",
    "lists.js": "text/javascript; charset=utf-8",
    "main.js": "text/javascript; charset=utf-8",
    "map-names.js": "text/javascript; charset=utf-8",
    "map-view.js": "text/javascript; charset=utf-8",
    "messages.js": "text/javascript; charset=utf-8",
    "measure.js": "text/javascript; charset=utf-8",
    "noise.js": "text/javascript; charset=utf-8",
    "motion.js": "text/javascript; charset=utf-8",
    "number-field.js": "text/javascript; charset=utf-8",
    "numbers.js": "text/javascript; charset=utf-8",
    "outlook.js": "text/javascript; charset=utf-8",
    "paper.js": "text/javascript; charset=utf-8",
    "phasors.js": "text/javascript; charset=utf-8",
    "printing.js": "text/javascript; charset=utf-8",
    "priors.js": "text/javascript; charset=utf-8",
    "project.js": "text/javascript; charset=utf-8",
    "remedies.js": "text/javascript; charset=utf-8",
    "remembered.js": "text/javascript; charset=utf-8",
    "sent-files.js": "text/javascript; charset=utf-8",
    "sidebar.js": "text/javascript; charset=utf-8",
    "server.js": "text/javascript; charset=utf-8",
    "svg-context.js": "text/javascript; charset=utf-8",
    "start.js": "text/javascript; charset=utf-8",
    "stability.js": "text/javascript; charset=utf-8",
    "steps.js": "text/javascript; charset=utf-8",
    "take-away.js": "text/javascript; charset=utf-8",
    "transport.js": "text/javascript; charset=utf-8",
    "tour.js": "text/javascript; charset=utf-8",
    "traffic.js": "text/javascript; charset=utf-8",
    "sweep.js": "text/javascript; charset=utf-8",
    "variant-report.js": "text/javascript; charset=utf-8",
    "variants.js": "text/javascript; charset=utf-8",
    "vehicles.js": "text/javascript; charset=utf-8",
    "wheelset-drawing.js": "text/javascript; charset=utf-8",
    "wording.js": "text/javascript; charset=utf-8",
    "words.js": "text/javascript; charset=utf-8",
};

/// The module of the wordings.
const WORDINGS: &str = "wordings.js";

/// Its text: of each language by its code the decimal mark, and the wordings of all messages.
static WORDINGS_TEXT: LazyLock<String> = LazyLock::new(|| {
    let languages = Language::ALL.iter().map(|&language| {
        let own = json!({ "decimal_mark": language.decimal_mark(), "wordings": wordings(language) });
        (language.code().to_owned(), own)
    });
    format!("export const LANGUAGES = {};\n", Value::Object(languages.collect()))
});

/// Name, content type and text of all files.
fn files() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    FILES.iter().copied().chain([(WORDINGS, SCRIPT, WORDINGS_TEXT.as_str())])
}

pub(crate) const PAGE: &str = include_str!("../assets/page.html");

/// The name of a file as it is known here.
pub(crate) fn name(name: &str) -> Option<&'static str> {
    let (name, ..) = files().find(|(known, ..)| *known == name)?;
    Some(name)
}

/// The text of a file; that of one that is not there is empty.
pub(crate) fn text(name: &str) -> &'static str {
    let file = files().find(|(known, ..)| *known == name);
    file.map_or("", |(.., text)| text)
}

/// What is computed once: the page, and what their addresses are made of.
struct Built {
    /// Address and entity tag of the page.
    page: String,
    page_tag: String,
    version: String,
    plotly_version: String,
}

static BUILT: LazyLock<Built> = LazyLock::new(|| {
    let plotly_version = fingerprint([plotly_js()]);
    let version = fingerprint(files().map(|(_, _, text)| text));
    let page = PAGE
        .replace("{assets}", &format!("/assets/{version}"))
        .replace("{plotly}", &format!("/assets/{plotly_version}/plotly.min.js"));
    Built { page_tag: format!("\"{}\"", fingerprint([page.as_str()])), page, version, plotly_version }
});

/// The first 64 bits of SHA-256 of some texts.
fn fingerprint<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hash = Sha256::new();
    for text in texts {
        hash.update(text.len().to_le_bytes());
        hash.update(text);
    }
    hash.finalize()[..8].iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The page. Its files carry their content in their address, so it alone is asked for anew.
pub(crate) async fn page(headers: HeaderMap) -> Response {
    let built = &*BUILT;
    let known = headers.get(header::IF_NONE_MATCH).is_some_and(|tag| tag.as_bytes() == built.page_tag.as_bytes());
    let tags = [(header::ETAG, built.page_tag.as_str()), (header::CACHE_CONTROL, "no-cache")];
    if known {
        return (StatusCode::NOT_MODIFIED, tags).into_response();
    }
    let kind = [(header::CONTENT_TYPE, "text/html; charset=utf-8")];
    (tags, kind, built.page.as_str()).into_response()
}

/// A file of the page. Whatever has another address than the present one is not there.
pub(crate) async fn file(Path((version, name)): Path<(String, String)>) -> Response {
    let built = &*BUILT;
    let found = if name == "plotly.min.js" && version == built.plotly_version {
        Some((SCRIPT, plotly_js()))
    } else {
        files().find(|(known, ..)| *known == name && version == built.version).map(|(_, kind, text)| (kind, text))
    };
    let Some((kind, text)) = found else {
        return StatusCode::NOT_FOUND.into_response();
    };
    let headers = [(header::CONTENT_TYPE, kind), (header::CACHE_CONTROL, "public, max-age=31536000, immutable")];
    (headers, text).into_response()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// The words of the page that a text asks for.
    fn asked(text: &'static str) -> impl Iterator<Item = &'static str> {
        let begins = ["t('", "wordsOf('", "worded('", "data-t=\"", "data-t-label=\"", "data-t-title=\""];
        let after = begins.into_iter().flat_map(|begin| text.split(begin).skip(1));
        after.filter_map(|rest| rest.split(['\'', '"']).next())
    }

    #[test]
    fn no_word_of_the_page_is_missing() {
        let known = wordings(Language::English);
        let texts = FILES.iter().map(|(_, _, text)| *text).chain([PAGE]);
        let id = |key: &str| format!("web-{}", key.replace(['_', '/', '.'], "-"));
        let words: BTreeSet<&str> = texts.flat_map(asked).collect();
        let is_word = |word: &&str| word.contains('_') && !word.ends_with('_');
        let missing: Vec<_> = words.into_iter().filter(is_word).filter(|word| !known.contains_key(&id(word))).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }
}
