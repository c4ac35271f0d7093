//! `riffel serve`

use std::ffi::OsString;

use riffel_web::{Options, ServeError, serve};

use crate::arguments::Serve;
use crate::error::CliError;
use crate::output::print;

pub(crate) fn run(arguments: &Serve, program: &[OsString]) -> miette::Result<()> {
    let options = Options {
        address: arguments.address,
        port: arguments.port,
        open: arguments.open,
        program: program.to_vec(),
    };
    if !options.address.is_loopback() {
        eprintln!(
            "warning: other machines can reach this page at {} and let this one compute; there is no password",
            options.address
        );
    }
    let outcome = serve(options, |url| {
        print(&format!("{url}\n"));
        eprintln!("the page is served until Ctrl-C");
    });
    outcome.map_err(|error| match error {
        ServeError::Listen { .. } => CliError::Listen { error },
        error => CliError::Serve { error },
    })?;
    Ok(())
}
