//! The pages of the book that are written by the program.

use std::path::Path;

// Long: writes every generated page of the book anew.
#[test]
fn generated_pages_are_current() {
    let program = Path::new(env!("CARGO_BIN_EXE_riffel"));
    assert_eq!(riffel_book::check(program), Ok(()));
}
