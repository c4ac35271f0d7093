//! `riffel serve`

use std::ffi::OsString;

use riffel_web::{Options, ServeError, serve};

use crate::arguments::Serve;
use crate::error::CliError;
use crate::output::print;
use crate::session::Session;

pub(crate) fn run(session: &Session, arguments: &Serve, program: &[OsString]) -> miette::Result<()> {
    let options =
        Options { address: arguments.address, port: arguments.port, open: arguments.open, program: program.to_vec() };
    if !options.address.is_loopback() {
        session.voice.complain(format_args!(
            "warning: other machines can reach this page at {} and let this one compute; there is no password",
            options.address
        ));
    }
    let outcome = serve(options, |url| {
        // Whoever cannot be told the address on standard output is told it here.
        if let Err(error) = print(&format!("{url}\n")) {
            session.voice.complain(format_args!("{error}; the page is at {url}"));
        }
        session.voice.say("the page is served until Ctrl-C");
    });
    outcome.map_err(|error| match error {
        ServeError::Listen { .. } => CliError::Listen { error },
        error => CliError::Serve { error },
    })?;
    Ok(())
}
