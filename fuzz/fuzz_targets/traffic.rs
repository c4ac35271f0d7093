//! Traffic files: [`Traffic::parse`].
#![no_main]

use libfuzzer_sys::fuzz_target;
use riffel_case::traffic::Traffic;

fuzz_target!(|text: &str| {
    riffel_fuzz::read(|| Traffic::parse("traffic.toml", text));
});
