//! The page as one file, which opens from a disk: `riffel page`.
//!
//! It holds the text of the page, its modules, plotly.js and the answers as a WebAssembly module. Browsers load no
//! modules from a disk, so those lie in elements of the page, and `file/begin.js` gives them addresses. Its policy
//! lets it reach no network.

use std::io::{Read, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use riffel_answers::page::{CaseText, RELEASE, RELEASE_BEGINS, VOCABULARY};
use serde_json::json;
use thiserror::Error;

use crate::assets;

/// What the file may load and do: what lies in it, and nothing else.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; \
    style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'";

/// What the head of such a page says of its origin.
pub const FILE_GENERATOR: &str = "<meta name=\"generator\" content=\"riffel page\">";

/// Scripts that the page of the server has not.
const BEGIN: &str = include_str!("../assets/file/begin.js");
const WORKER: &str = include_str!("../assets/file/worker.js");
const WORKERS: &str = include_str!("../assets/file/workers.js");
const ELSEWHERE: &str = include_str!("../assets/file/elsewhere.js");

/// The module of the answers, compressed, where it was there when the program was built; see `module/README.md`.
#[cfg(page_module)]
pub const PAGE_MODULE: Option<&[u8]> = Some(include_bytes!("../module/riffel.wasm.gz"));
/// The module of the answers, compressed, where it was there when the program was built; see `module/README.md`.
#[cfg(not(page_module))]
pub const PAGE_MODULE: Option<&[u8]> = None;

/// Why there is no page.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PageFileError {
    /// The page would not take the case.
    #[error("{message}")]
    Case {
        /// What is wrong with it.
        message: String,
        /// What would be right.
        help: Option<String>,
    },

    /// The bytes given are no module.
    #[error("this is no compressed WebAssembly module of Riffel")]
    Module,

    /// The module answers as another release does.
    #[error("the WebAssembly module is of riffel {found}, the program of {own}")]
    Release {
        /// Version of the module.
        found: String,
        /// Version of the program.
        own: String,
    },
}

impl PageFileError {
    /// What would be right.
    pub fn help(&self) -> Option<&str> {
        match self {
            Self::Case { help, .. } => help.as_deref(),
            Self::Module | Self::Release { .. } => Some("`cargo xtask page` builds it"),
        }
    }
}

/// The page with a case inside it, given by its text.
///
/// `module` is the WebAssembly module of the same version, compressed by gzip, such as [`PAGE_MODULE`].
///
/// # Errors
/// [`PageFileError`] for a case that the page would refuse, as one that names files or asks for a larger map than the
/// page computes, and for bytes that are no module, or that of another release.
pub fn page_file(case: &str, module: &[u8]) -> Result<String, PageFileError> {
    let keys = keys_of(case)?;
    of_this_release(module)?;
    let mut elements = String::new();
    let mut element = |attributes: &str, text: &str| {
        elements.push_str(&format!("<script type=\"text/plain\" {attributes}>{text}</script>\n"));
    };
    element("id=\"vocabulary\"", &in_element(&VOCABULARY));
    element("id=\"case-inside\"", &in_element(&json!(keys).to_string()));
    element("id=\"riffel-wasm\"", &BASE64.encode(module));
    let plotly = compressed(riffel_plot::plotly_js().as_bytes());
    element("id=\"plotly\"", &BASE64.encode(plotly));
    element("id=\"worker\"", WORKER);
    for (name, text) in modules() {
        element(&format!("data-module=\"{name}\""), &text);
    }
    let icon = BASE64.encode(assets::text("icon.svg"));
    let head = format!(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n{FILE_GENERATOR}\n<style>\n{}</style>",
        assets::text("page.css")
    );
    let replaced = [
        ("<link rel=\"stylesheet\" href=\"{assets}/page.css\">", head),
        ("<script type=\"module\" src=\"{assets}/main.js\"></script>\n", String::new()),
        ("{assets}/icon.svg", format!("data:image/svg+xml;base64,{icon}")),
        ("content=\"{plotly}\"", "content=\"\"".to_owned()),
        ("</body>", format!("{elements}<script>\n{BEGIN}</script>\n</body>")),
    ];
    Ok(replaced.iter().fold(assets::PAGE.to_owned(), |page, (from, to)| {
        debug_assert!(page.contains(from), "{from}");
        page.replacen(from, to, 1)
    }))
}

/// `Ok` for the module of this release.
fn of_this_release(module: &[u8]) -> Result<(), PageFileError> {
    let mut bytes = Vec::new();
    let read = GzDecoder::new(module).read_to_end(&mut bytes);
    if read.is_err() || !bytes.starts_with(b"\0asm") {
        return Err(PageFileError::Module);
    }
    let begins = RELEASE_BEGINS.as_bytes();
    let place = bytes.windows(begins.len()).position(|text| text == begins);
    let place = place.ok_or(PageFileError::Module)?;
    let version = |text: &[u8]| {
        let rest = text[begins.len()..].split(|&byte| byte == b';').next();
        String::from_utf8_lossy(rest.unwrap_or_default()).into_owned()
    };
    let [found, own] = [&bytes[place..], RELEASE.as_bytes()].map(version);
    match found == own {
        true => Ok(()),
        false => Err(PageFileError::Release { found, own }),
    }
}

/// The keys of a case that the page takes.
fn keys_of(case: &str) -> Result<toml::Table, PageFileError> {
    let given = CaseText::Toml(case.to_owned());
    given.read().map_err(|fault| PageFileError::Case { message: fault.message(), help: fault.help() })?;
    case.parse().map_err(|error: toml::de::Error| PageFileError::Case { message: error.to_string(), help: None })
}

/// The modules of the page that `main.js` leads to, with names that an import map knows.
fn modules() -> Vec<(&'static str, String)> {
    let mut found: Vec<(&str, String)> = Vec::new();
    let mut wanted = vec!["main.js"];
    while let Some(name) = wanted.pop() {
        if found.iter().any(|(known, _)| *known == name) {
            continue;
        }
        let mut text = match name {
            "transport.js" => WORKERS,
            "elsewhere.js" => ELSEWHERE,
            name => assets::text(name),
        }
        .to_owned();
        // Those of which the page has a sentence alone.
        for absent in ["measure.js", "bogie.js", "calibrate.js"] {
            text = text.replace(&format!("'./{absent}'"), "'./elsewhere.js'");
        }
        let imports = text.split(" from './").skip(1);
        let imports = imports.filter_map(|rest| rest.split('\'').next());
        wanted.extend(imports.map(|import| {
            let known = assets::name(import);
            known.unwrap_or("elsewhere.js")
        }));
        text = text.replace(" from './", " from 'riffel/");
        found.push((name, text));
    }
    found.sort();
    found
}

/// JSON that ends no element.
fn in_element(json: &str) -> String {
    json.replace('<', "\\u003c")
}

fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    // Memory takes all that is written.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn module_of(release: &str) -> Vec<u8> {
        compressed(format!("\0asm\x01\0\0\0 {release} and more").as_bytes())
    }

    fn page_of(case: &str) -> Result<String, PageFileError> {
        page_file(case, &module_of(RELEASE))
    }

    #[test]
    fn modules_of_another_release_are_refused() {
        let refused = |release: &str| page_file(riffel_case::NOMINAL_CASE, &module_of(release)).unwrap_err();
        let other = refused("answers of riffel 0.0.1;");
        assert!(other.help().is_some());
        let own = env!("CARGO_PKG_VERSION");
        assert_eq!(other.to_string(), format!("the WebAssembly module is of riffel 0.0.1, the program of {own}"));
        assert!(matches!(refused(""), PageFileError::Module));
    }

    #[test]
    fn a_page_holds_all_that_it_loads() {
        let page = page_of(riffel_case::NOMINAL_CASE).unwrap();
        assert!(!page.contains("{assets}") && !page.contains("{plotly}"));
        for loads in ["src=\"", "from './", "href=\"/"] {
            assert!(!page.contains(loads), "{loads}");
        }
        let style = assets::text("page.css");
        assert!(!style.contains("url(") && !style.contains("@import"));
        // No text ends the element that it stands in.
        assert_eq!(page.matches("<script").count(), page.matches("</script>").count());
        let names: Vec<_> = modules().into_iter().map(|(name, _)| name).collect();
        for (name, text) in modules() {
            for import in text.split(" from 'riffel/").skip(1) {
                let import = import.split('\'').next().unwrap();
                assert!(names.contains(&import), "{name} imports {import}");
            }
        }
        assert!(!names.contains(&"measure.js") && names.contains(&"elsewhere.js"));
    }

    #[test]
    fn the_case_inside_is_the_one_given_whatever_its_title() {
        let title = "title = \"</script><script>alert(1)//\"";
        let case = riffel_case::NOMINAL_CASE.replacen("title = ", &format!("{title} # "), 1);
        let page = page_of(&case).unwrap();
        assert!(!page.contains("alert(1)//</") && page.contains("\\u003c/script>\\u003cscript>alert"));
    }

    #[test]
    fn what_the_page_would_refuse_is_refused() {
        let large = riffel_case::NOMINAL_CASE.replace("points = 241", "points = 5000");
        let error = page_of(&large).unwrap_err().to_string();
        assert!(error.contains("points are more than"), "{error}");
        let nothing = page_file(riffel_case::NOMINAL_CASE, b"nothing").unwrap_err();
        assert!(matches!(nothing, PageFileError::Module));
    }
}
