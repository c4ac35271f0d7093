//! `riffel completions`

use clap::CommandFactory;

use crate::arguments::{Arguments, Completions};
use crate::output::print;

pub(crate) fn run(arguments: &Completions) -> miette::Result<()> {
    let mut script = Vec::new();
    let mut command = Arguments::command();
    clap_complete::generate(arguments.shell, &mut command, "riffel", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(())
}
