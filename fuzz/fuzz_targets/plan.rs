//! Plans of studies: [`Plan::parse`], on the nominal case.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use riffel_case::NOMINAL_CASE;
use riffel_study::Plan;

static CASE: LazyLock<PathBuf> =
    LazyLock::new(|| riffel_fuzz::file("nominal.toml", NOMINAL_CASE.as_bytes()));

fuzz_target!(|text: &str| {
    riffel_fuzz::read(|| Plan::parse("study.toml", text, &CASE));
});
