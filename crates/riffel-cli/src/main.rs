//! The executable of the program.

use std::process::ExitCode;

use mimalloc::MiMalloc;

/// What a long run leaves, some numbers of every piece, would lie between the large arrays of the pieces, and keep the
/// system's allocator from using their place again: 2 MB for each kilometre of axle-box acceleration, where 50 kB remain.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

fn main() -> ExitCode {
    // Where the system does not tell, the name is looked for as the user's shell did.
    let program = std::env::current_exe().map_or_else(|_| "riffel".into(), Into::into);
    ExitCode::from(riffel_cli::run(std::env::args_os(), &[program]))
}
