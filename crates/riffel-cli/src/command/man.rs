//! `riffel man`

use std::io;

use clap::{Command, CommandFactory};
use clap_mangen::Man;

use crate::arguments::{Arguments, ManPages};
use crate::error::CliError;
use crate::output::print;
use crate::session::Session;
use crate::staging::Staging;

pub(crate) fn run(session: &Session, arguments: &ManPages) -> miette::Result<()> {
    // In a page a line is a paragraph: nothing is broken to a width.
    let mut program = Arguments::command().disable_help_subcommand(true);
    program.build();
    let Some(folder) = &arguments.output else {
        let page = page(&program).map_err(|reason| CliError::StandardOutput { reason })?;
        print(&String::from_utf8_lossy(&page))?;
        return Ok(());
    };
    let mut staging = Staging::new(session, "man", folder)?;
    write(&program, &mut staging)?;
    let files = staging.publish()?;
    print(&format!("{}: {}\n", folder.display(), files.join(" ")))?;
    Ok(())
}

/// The page of a command, and those of the commands below it.
fn write(command: &Command, staging: &mut Staging) -> Result<(), CliError> {
    let name = command.get_display_name().unwrap_or_else(|| command.get_name());
    staging.write_with(&format!("{name}.1"), |file| Man::new(command.clone()).render(file))?;
    command.get_subcommands().try_for_each(|below| write(below, staging))
}

fn page(command: &Command) -> io::Result<Vec<u8>> {
    let mut page = Vec::new();
    Man::new(command.clone()).render(&mut page)?;
    Ok(page)
}
