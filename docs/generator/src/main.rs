//! `cargo xtask generate`: write the generated files of the book with the program at the path given.

use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let outcome = match std::env::args_os().nth(1) {
        Some(program) => riffel_book::write(&PathBuf::from(program)),
        None => Err("the program `riffel` is missing: cargo xtask generate gives it".to_owned()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("riffel-book: {message}");
            ExitCode::FAILURE
        }
    }
}
