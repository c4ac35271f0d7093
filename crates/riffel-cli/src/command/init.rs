//! `riffel init`

use crate::arguments::Init;
use crate::output::print;
use crate::staging::write_file;

pub(crate) fn run(arguments: &Init) -> miette::Result<()> {
    write_file(&arguments.path, riffel_case::NOMINAL_CASE, arguments.force)?;
    let path = arguments.path.display();
    print(&format!("wrote {path}; next: riffel map {path}\n"));
    Ok(())
}
