//! The answers of the page as a WebAssembly module, for `riffel page`.
//!
//! Rust's own toolchain builds it where its library for `wasm32-unknown-unknown` is installed. Elsewhere Debian's
//! compiler `rustc-web` does: its packages are unpacked below `target`, nothing is installed, and the standard library
//! is built from its sources.

use std::env;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::step::{run_beside, run_unseen};
use crate::{Outcome, compiler, output, root};

const TARGET: &str = "wasm32-unknown-unknown";

/// Where all this is built.
const FOLDER: &str = "target/page-module";

/// Where a program that is built takes the module from; see the README there.
const INSIDE: &str = "crates/riffel-web/module/riffel.wasm.gz";

/// The profile of what is handed out.
const HANDED_OUT: &str = "page";

/// That of tests, which takes half the time to build.
const TESTED: &str = "page-tests";

/// What one has to install where nothing that is needed is to be had.
const ADVICE: &str = "a WebAssembly module needs Rust's library for it: `rustup target add wasm32-unknown-unknown`";

/// A compiler that makes modules.
enum Toolchain {
    /// The one that runs this.
    Own,
    /// Debian's packages, unpacked.
    Debian(PathBuf),
}

/// Build the module and put it where the next build of the program finds it.
pub(crate) fn install() -> Outcome {
    let module = build(HANDED_OUT)?;
    fs::copy(&module, root().join(INSIDE)).map_err(|error| format!("cannot write {INSIDE}: {error}"))?;
    println!("# a program that is built now holds the page: cargo run --release -- page -o riffel.html");
    Ok(())
}

/// Build the module for tests. Where its tools are not to be had it is left out with a word, but not by a service
/// that checks changes, which sets `CI`.
pub(crate) fn build_if_possible() -> Result<Option<PathBuf>, String> {
    match toolchain() {
        Err(reason) if env::var_os("CI").is_none() => {
            println!("# the page in one file is not tested: {reason}");
            Ok(None)
        }
        _ => build(TESTED).map(Some),
    }
}

/// Build the module with a profile, compressed, and where it is.
fn build(profile: &str) -> Result<PathBuf, String> {
    let toolchain = toolchain()?;
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--locked", "--profile", profile, "--target", TARGET]);
    cargo.args(["--package", "riffel-wasm", "--target-dir", FOLDER]);
    cargo.env("CARGO_ENCODED_RUSTFLAGS", compiler::flags()?);
    if let Toolchain::Debian(folder) = &toolchain {
        cargo.arg("-Zbuild-std=std,panic_abort");
        let (compiler, linker) = (folder.join("usr/bin/rustc"), linker(folder)?);
        cargo
            .env("RUSTC", compiler)
            .env("RUSTC_BOOTSTRAP", "1")
            .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker)
            .env("LD_LIBRARY_PATH", libraries(folder)?);
    }
    run_beside(&mut cargo)?;
    let module = root().join(FOLDER).join(TARGET).join(profile).join("riffel_wasm.wasm");
    let packed = root().join(FOLDER).join("riffel.wasm.gz");
    pack(&module, &packed).map_err(|error| format!("cannot write {}: {error}", packed.display()))?;
    Ok(packed)
}

/// Compress a file, with nothing of its name and time.
fn pack(from: &Path, to: &Path) -> std::io::Result<()> {
    let bytes = fs::read(from)?;
    let mut encoder = GzEncoder::new(File::create(to)?, Compression::best());
    encoder.write_all(&bytes)?;
    let packed = encoder.finish()?.metadata()?.len();
    println!("# {}: {} bytes, {packed} compressed", to.display(), bytes.len());
    Ok(())
}

/// The compiler that is there, or Debian's.
fn toolchain() -> Result<Toolchain, String> {
    let rustc = env::var_os("RUSTC").map_or_else(|| PathBuf::from("rustc"), PathBuf::from);
    let libraries = output(&rustc, &["--print", "target-libdir", "--target", TARGET])?;
    if Path::new(String::from_utf8_lossy(&libraries).trim()).is_dir() {
        return Ok(Toolchain::Own);
    }
    let folder = root().join("target/wasm-toolchain");
    if !folder.join("complete").is_file() {
        debian(&folder).map_err(|reason| format!("{ADVICE} ({reason})"))?;
        fs::write(folder.join("complete"), "").map_err(|error| error.to_string())?;
    }
    Ok(Toolchain::Debian(folder))
}

/// Unpack the packages of Debian that build modules into a folder.
fn debian(folder: &Path) -> Outcome {
    let mut packages = ["rustc-web", "rust-web-src", "libstd-rust-web-dev"].map(str::to_owned).to_vec();
    if depends_on("rustc-web").is_err() {
        run_unseen(Command::new("apt-get").args(["update", "--quiet"]))
            .map_err(|_| "Debian's list of packages is not to be had".to_owned())?;
    }
    let dependence = |package: &str, begin: &str| {
        named(&depends_on(package)?, begin).ok_or_else(|| format!("Debian's {package} depends on no {begin}"))
    };
    let library = dependence("libstd-rust-web-dev", "libstd-rust-web-")?;
    let llvm = dependence(&library, "libllvm")?;
    let linker = llvm.replace("libllvm", "lld-");
    packages.extend([library, llvm, linker]);
    let downloads = folder.join("packages");
    fs::create_dir_all(&downloads).map_err(|error| error.to_string())?;
    println!("# {} from Debian ...", packages.join(" "));
    let mut download = Command::new("apt-get");
    download.args(["download", "--quiet"]).args(&packages).current_dir(&downloads);
    // Not in the root of the workspace, where other commands run.
    let downloaded = download.output().is_ok_and(|output| output.status.success());
    if !downloaded {
        return Err("Debian's packages cannot be downloaded".to_owned());
    }
    let files = fs::read_dir(&downloads).map_err(|error| error.to_string())?;
    for file in files.flatten() {
        let mut unpack = Command::new("dpkg");
        run_unseen(unpack.arg("-x").arg(file.path()).arg(folder))?;
    }
    fs::remove_dir_all(&downloads).map_err(|error| error.to_string())
}

/// The packages on which one of Debian's depends.
fn depends_on(package: &str) -> Result<String, String> {
    let text = output(Path::new("apt-cache"), &["depends", package])
        .map_err(|_| format!("Debian has no package {package}"))?;
    match text.is_empty() {
        true => Err(format!("Debian has no package {package}")),
        false => Ok(String::from_utf8_lossy(&text).into_owned()),
    }
}

/// The first package of a list whose name begins so.
fn named(list: &str, begin: &str) -> Option<String> {
    let packages = list.lines().filter_map(|line| line.trim().strip_prefix("Depends: "));
    let mut found = packages.filter(|package| package.starts_with(begin));
    found.next().map(str::to_owned)
}

/// The linker among unpacked packages.
fn linker(folder: &Path) -> Result<PathBuf, String> {
    let programs = fs::read_dir(folder.join("usr/bin")).map_err(|error| error.to_string())?;
    let is_linker = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("wasm-ld-")
    };
    let mut linkers = programs.flatten().map(|entry| entry.path()).filter(is_linker);
    linkers.next().ok_or_else(|| "Debian's package lld has no wasm-ld".to_owned())
}

/// The folder of the libraries among unpacked packages.
fn libraries(folder: &Path) -> Result<PathBuf, String> {
    let host = compiler::host()?;
    let machine = host.split('-').next().unwrap_or_default();
    Ok(folder.join(format!("usr/lib/{machine}-linux-gnu")))
}
