//! Commands that must succeed, in the root of the workspace.

use std::process::Command;
use std::time::Instant;

use crate::{Outcome, compiler, root};

/// Cargo, the one that runs this.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(arguments);
    cargo
}

/// Cargo, which looks for lints as it compiles, for all but what is handed out.
pub(crate) fn linting_cargo(arguments: &[&str]) -> Command {
    let mut cargo = cargo(arguments);
    compiler::linting(&mut cargo);
    cargo
}

/// Run a command that writes to the terminal.
pub(crate) fn run(command: &mut Command) -> Outcome {
    let line = line(command);
    println!("# {line}");
    let status = command.current_dir(root()).status();
    let status = status.map_err(|error| format!("cannot run {line}: {error}"))?;
    match status.success() {
        true => Ok(()),
        false => Err(format!("{line} failed")),
    }
}

/// Run a command beside others: what it writes appears when it ends, in one piece.
pub(crate) fn run_beside(command: &mut Command) -> Outcome {
    let line = line(command);
    println!("# {line} ...");
    let begin = Instant::now();
    let (outcome, written) = end(command, &line);
    let seconds = begin.elapsed().as_secs_f64();
    println!("# {line}: {seconds:.0} s\n{written}");
    outcome
}

/// Run a command of which nothing is to be told unless it fails.
pub(crate) fn run_unseen(command: &mut Command) -> Outcome {
    let line = line(command);
    println!("# {line} ...");
    let (outcome, written) = end(command, &line);
    if outcome.is_err() {
        eprintln!("{written}");
    }
    outcome
}

/// Run a command to its end, and what it wrote.
fn end(command: &mut Command, line: &str) -> (Outcome, String) {
    match command.current_dir(root()).output() {
        Err(error) => (Err(format!("cannot run {line}: {error}")), String::new()),
        Ok(output) => {
            let [out, err] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text));
            let outcome = match output.status.success() {
                true => Ok(()),
                false => Err(format!("{line} failed")),
            };
            (outcome, format!("{out}{err}"))
        }
    }
}

/// What one would type, or how it begins.
fn line(command: &Command) -> String {
    const LENGTH: usize = 200;
    let program = command.get_program();
    let program = match program == env!("CARGO") {
        true => "cargo".into(),
        false => program.to_string_lossy(),
    };
    let arguments = command.get_args().map(|argument| argument.to_string_lossy());
    let words: Vec<_> = std::iter::once(program).chain(arguments).collect();
    let line = words.join(" ");
    match line.char_indices().nth(LENGTH) {
        Some((end, _)) => format!("{} …", &line[..end]),
        None => line,
    }
}
