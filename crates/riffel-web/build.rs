//! Takes the module of the page into the program where it has been built; see `module/README.md`.

use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=module");
    println!("cargo::rustc-check-cfg=cfg(page_module)");
    if Path::new("module/riffel.wasm.gz").exists() {
        println!("cargo::rustc-cfg=page_module");
    }
}
