//! `riffel init`

use std::path::Path;

use crate::arguments::Init;
use crate::output::print;
use crate::staging::write_file;

pub(crate) fn run(arguments: &Init) -> miette::Result<()> {
    let (text, name) = match arguments.traffic {
        true => (riffel_case::TRAFFIC, "traffic.toml"),
        false => (riffel_case::NOMINAL_CASE, "case.toml"),
    };
    let path = arguments.path.as_deref().unwrap_or(Path::new(name));
    write_file(path, text, arguments.force)?;
    let path = path.display();
    print(&match arguments.traffic {
        true => {
            format!("wrote {path}; next: riffel forecast CASE --spectrum FILE --traffic {path}\n")
        }
        false => format!("wrote {path}; next: riffel map {path}\n"),
    });
    Ok(())
}
