//! The compiler: what it is told, and the system that it builds for.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::output;

/// Flags of the compiler that keep the folders of this machine out of the program.
pub(crate) fn flags() -> Result<String, String> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let home = home.ok_or("there is no home folder")?;
    let project = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    let project = project.ok_or("there is no folder of the project")?;
    Ok([(home.as_path(), "cargo"), (project, "riffel")]
        .map(|(folder, name)| format!("--remap-path-prefix={}={name}", folder.display()))
        // As cargo takes them apart, whatever is in a path.
        .join("\u{1f}"))
}

/// Let clippy compile the crates of the workspace, and refuse what it warns of: lints are looked for in the build that is tested, not
/// in one of their own. Not for what is handed out: clippy switches some optimisations off.
pub(crate) fn linting(command: &mut Command) -> &mut Command {
    // As `cargo clippy` hands them to its driver.
    const ARGUMENTS: &str = "--deny__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__";
    command.env("RUSTC_WORKSPACE_WRAPPER", "clippy-driver").env("CLIPPY_ARGS", ARGUMENTS)
}

/// The system that the compiler builds for.
pub(crate) fn host() -> Result<String, String> {
    let text = output(Path::new("rustc"), &["--print", "host-tuple"])?;
    Ok(String::from_utf8_lossy(&text).trim().to_owned())
}
