//! Case files: [`Case::parse_sealed`], which opens no other file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riffel_case::Case;

fuzz_target!(|text: &str| {
    riffel_fuzz::read(|| Case::parse_sealed("case.toml", text));
});
