//! `riffel init`

use std::path::Path;

use crate::arguments::Init;
use crate::output::print;
use crate::staging::write_file;

pub(crate) fn run(arguments: &Init) -> miette::Result<()> {
    let (text, name) = match arguments {
        Init { traffic: true, .. } => (riffel_case::TRAFFIC, "traffic.toml"),
        Init { study: true, .. } => (riffel_study::STUDY, "study.toml"),
        _ => (riffel_case::NOMINAL_CASE, "case.toml"),
    };
    let path = arguments.path.as_deref().unwrap_or(Path::new(name));
    write_file(path, text, arguments.force)?;
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
    print(&format!("wrote {path}; next: {next}\n"));
    Ok(())
}
