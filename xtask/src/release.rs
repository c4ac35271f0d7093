//! What a release consists of: an archive of the program, the Python wheel and its source distribution.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use flate2::Compression;
use flate2::write::GzEncoder;
use tar::{Builder, EntryType, Header};

use crate::compiler::{flags, host};
use crate::step::{cargo, run};
use crate::{Outcome, dependencies, environment, output, page, python, root};

/// Where the files of a release are written.
const FOLDER: &str = "target/release-files";

/// Where the package of Python has the licences of what is built into it; `pyproject.toml` names it.
const LICENCES_OF_WHEEL: &str = "crates/riffel-python/python/riffel/THIRD-PARTY-LICENSES";

/// Files of the project that stand beside the program.
const FILES: [&str; 5] = ["README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE-APACHE", "LICENSE-MIT"];

const COMPLETIONS: [(&str, &str); 4] =
    [("bash", "riffel.bash"), ("zsh", "_riffel"), ("fish", "riffel.fish"), ("powershell", "_riffel.ps1")];

/// Build everything from the sources as they are, for the system that this runs on.
pub(crate) fn build() -> Outcome {
    let folder = root().join(FOLDER);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {FOLDER}: {error}"))?;
    page::install()?;
    let flags = flags()?;
    let environment = [("CARGO_ENCODED_RUSTFLAGS", flags.as_str())];
    // With the features of both, so that what both are made of is built once.
    let packages = ["--package", "riffel-cli", "--package", "riffel-python"];
    let build = ["build", "--locked", "--profile", "dist", "--bin", "riffel"];
    run(cargo(&build).args(packages).envs(environment))?;
    archive(&folder)?;
    python_package(&environment)
}

/// The wheel, with the licences of all that is in it, and the source distribution.
fn python_package(variables: &[(&str, &str)]) -> Outcome {
    let python = python::prepare()?;
    let licences = root().join(LICENCES_OF_WHEEL);
    let text = dependencies::third_party_licences("riffel-python", &host()?)?;
    fs::write(&licences, text).map_err(|error| format!("cannot write {LICENCES_OF_WHEEL}: {error}"))?;
    let wheel = ["-m", "maturin", "build", "--locked", "--profile", "dist", "--out", FOLDER];
    let mut wheel = environment::command(&python, &wheel);
    let built = run(wheel.envs(variables.iter().copied()));
    let _ = fs::remove_file(&licences);
    built?;
    let sources = ["-m", "maturin", "sdist", "--out", FOLDER];
    run(&mut environment::command(&python, &sources))
}

/// The program with its manual, completions, example cases and all licences. The same commit gives the same bytes.
fn archive(folder: &Path) -> Outcome {
    let target = host()?;
    let name = format!("riffel-{}-{target}", env!("CARGO_PKG_VERSION"));
    let staged = folder.join(&name);
    let failed = |error: std::io::Error| format!("cannot make {name}: {error}");
    let executable = format!("riffel{}", std::env::consts::EXE_SUFFIX);
    fs::create_dir_all(staged.join("completions")).map_err(failed)?;
    let program = staged.join(&executable);
    fs::copy(root().join("target/dist").join(&executable), &program).map_err(failed)?;
    for file in FILES {
        fs::copy(root().join(file), staged.join(file)).map_err(failed)?;
    }
    copy_files(&root().join("cases"), &staged.join("cases")).map_err(failed)?;
    let licences = dependencies::third_party_licences("riffel-cli", &target)?;
    fs::write(staged.join("THIRD-PARTY-LICENSES"), licences).map_err(failed)?;
    let manual = staged.join("man/man1");
    fs::create_dir_all(staged.join("man")).map_err(failed)?;
    output(&program, &["man", "--output", &manual.to_string_lossy()])?;
    // What the program keeps account of when it writes a folder anew.
    fs::remove_file(manual.join("riffel-manifest.json")).map_err(failed)?;
    for (shell, file) in COMPLETIONS {
        let script = output(&program, &["completions", shell])?;
        fs::write(staged.join("completions").join(file), script).map_err(failed)?;
    }
    let path = folder.join(format!("{name}.tar.gz"));
    pack(folder, &name, &path, time_of_commit()?).map_err(failed)?;
    fs::remove_dir_all(&staged).map_err(failed)?;
    println!("{}", path.display());
    Ok(())
}

/// A folder as a compressed tar file, with nothing of the time, the user or the machine.
fn pack(parent: &Path, name: &str, to: &Path, time: u64) -> std::io::Result<()> {
    let mut paths = Vec::new();
    walk(&parent.join(name), &mut paths)?;
    paths.sort();
    let mut archive = Builder::new(GzEncoder::new(File::create(to)?, Compression::best()));
    for path in paths {
        let inside = path.strip_prefix(parent).map_err(std::io::Error::other)?;
        let bytes = fs::read(&path)?;
        let is_program =
            path.file_stem().is_some_and(|stem| stem == "riffel") && path.parent() == Some(&parent.join(name));
        let mut header = Header::new_gnu();
        header.set_entry_type(EntryType::Regular);
        header.set_mode(if is_program { 0o755 } else { 0o644 });
        header.set_mtime(time);
        header.set_size(bytes.len() as u64);
        archive.append_data(&mut header, inside, &bytes[..])?;
    }
    archive.into_inner()?.finish()?.flush()
}

/// All files below a folder.
pub(crate) fn walk(folder: &Path, paths: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        match path.is_dir() {
            true => walk(&path, paths)?,
            false => paths.push(path),
        }
    }
    Ok(())
}

/// Copy the files of a folder that has no folders.
fn copy_files(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        fs::copy(entry.path(), to.join(entry.file_name()))?;
    }
    Ok(())
}

/// Seconds from 1970 to the commit that is checked out.
fn time_of_commit() -> Result<u64, String> {
    let text = output(Path::new("git"), &["log", "-1", "--format=%ct"])?;
    let text = String::from_utf8_lossy(&text);
    text.trim().parse().map_err(|_| format!("git says that the commit is of {text}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_archive_depends_on_names_and_contents_alone() {
        let make = |files: [&str; 3]| {
            let parent = tempfile::tempdir().unwrap();
            let inside = parent.path().join("riffel-1");
            fs::create_dir_all(inside.join("completions")).unwrap();
            for file in files {
                fs::write(inside.join(file), file).unwrap();
            }
            let archive = parent.path().join("riffel-1.tar.gz");
            pack(parent.path(), "riffel-1", &archive, 1_000_000_000).unwrap();
            fs::read(archive).unwrap()
        };
        let files = ["riffel", "README.md", "completions/riffel.bash"];
        let archive = make(files);
        let backwards = [files[2], files[1], files[0]];
        assert_eq!(make(backwards), archive);

        let mut archive = tar::Archive::new(flate2::read::GzDecoder::new(&archive[..]));
        let entries = archive.entries().unwrap().map(|entry| {
            let entry = entry.unwrap();
            let path = entry.path().unwrap().to_string_lossy().into_owned();
            let header = entry.header();
            assert_eq!(header.mtime().unwrap(), 1_000_000_000);
            (path, header.mode().unwrap())
        });
        let expected =
            [("riffel-1/README.md", 0o644), ("riffel-1/completions/riffel.bash", 0o644), ("riffel-1/riffel", 0o755)];
        let expected = expected.map(|(path, mode)| (path.to_owned(), mode));
        assert_eq!(entries.collect::<Vec<_>>(), expected);
    }
}
