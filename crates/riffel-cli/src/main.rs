//! The executable of the program.

use std::process::ExitCode;

fn main() -> ExitCode {
    // Where the system does not tell, the name is looked for as the user's shell did.
    let program = std::env::current_exe().map_or_else(|_| "riffel".into(), Into::into);
    ExitCode::from(riffel_cli::run(std::env::args_os(), &[program]))
}
