//! `riffel init`

use std::path::Path;

use crate::arguments::Init;
use crate::output::print;
use crate::session::Session;
use crate::staging::{Existing, write_file};

pub(crate) fn run(session: &Session, arguments: &Init) -> miette::Result<()> {
    let (text, name) = match arguments {
        Init { metro: true, .. } => (riffel_case::METRO_CASE, "metro.toml"),
        Init { main_line: true, .. } => (riffel_case::MAIN_LINE_CASE, "main-line.toml"),
        Init { tram: true, .. } => (riffel_case::TRAM_CASE, "tram.toml"),
        Init { freight: true, .. } => (riffel_case::FREIGHT_CASE, "freight.toml"),
        Init { traffic: true, .. } => (riffel_case::TRAFFIC, "traffic.toml"),
        Init { study: true, .. } => (riffel_study::STUDY, "study.toml"),
        _ => (riffel_case::NOMINAL_CASE, "case.toml"),
    };
    let path = arguments.path.as_deref().unwrap_or(Path::new(name));
    let existing = match arguments.force {
        true => Existing::Replace,
        false => Existing::Keep("--force to replace it"),
    };
    write_file(session, path, text, existing)?;
    let path = path.display();
    let next = match arguments {
        Init { traffic: true, .. } => {
            format!("riffel forecast CASE --spectrum FILE --traffic {path}")
        }
        Init { study: true, .. } => {
            format!("riffel study {path}, on the case nominal.toml that it names")
        }
        _ => format!("riffel map {path}"),
    };
    print(&format!("wrote {path}; next: {next}\n"))?;
    Ok(())
}
