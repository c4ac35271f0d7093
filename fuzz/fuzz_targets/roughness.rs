//! Files of roughness, profiles and tables of levels: [`RoughnessFile::read`], once as the file explains itself and
//! once with the spacing given.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riffel_rail::{Layout, RoughnessFile};

fuzz_target!(|bytes: &[u8]| {
    let path = riffel_fuzz::file("rail.csv", bytes);
    for spacing in [None, "1 mm".parse().ok()] {
        let layout = Layout {
            spacing,
            ..Layout::default()
        };
        riffel_fuzz::read(|| RoughnessFile::read(&path, &layout, &|_| ()));
    }
});
