//! Pages and pictures of the book that are written by the program and kept in the repository.

mod decay_rate;
mod marked;
mod models;
mod place_of_wear;
mod presets;
mod ranges;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use riffel_plot::{DEFAULT_PNG_SCALE, LineFigure};

/// A failure as a sentence.
type Outcome = Result<(), String>;

/// The generated pages as they should be, but the table of validation, each with its path; `program` is `riffel`, whose help the book shows.
///
/// # Errors
/// A sentence, where the program or a page it is part of cannot be read.
pub fn pages(program: &Path) -> Result<Vec<(&'static str, String)>, String> {
    Ok(vec![
        ("docs/src/command-line.md", command_line(program)?),
        ("docs/src/decay-rate.md", decay_rate::page()?),
        ("docs/src/models.md", models::page()?),
        ("docs/src/presets.md", presets::page()),
        ("docs/src/ranges.md", ranges::page()),
        ("docs/src/rolling-contact.md", place_of_wear::page()?),
    ])
}

/// `Ok` if all generated pages are current. Pictures are not compared: the last digit of a mathematical function may
/// move a line by a tenth of a pixel from one machine to another. Nor is the table of validation, which the tests of the
/// checks hold row by row.
///
/// # Errors
/// A sentence that names the page.
pub fn check(program: &Path) -> Result<(), String> {
    for (path, text) in pages(program)? {
        if fs::read_to_string(root().join(path)).unwrap_or_default() != text {
            return Err(format!("{path} is not current; run cargo xtask generate"));
        }
    }
    Ok(())
}

/// Write all pages and pictures.
///
/// # Errors
/// A sentence.
pub fn write(program: &Path) -> Result<(), String> {
    let validation = [("docs/src/validation.md", validation())];
    for (path, text) in pages(program)?.into_iter().chain(validation) {
        fs::write(root().join(path), text).map_err(|error| format!("cannot write {path}: {error}"))?;
    }
    pictures(program)?;
    decay_rate::picture()?;
    place_of_wear::picture()?;
    println!("# generated files written");
    Ok(())
}

/// The root of the workspace.
fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Draw a picture of the book.
fn draw(path: &str, figure: &LineFigure) -> Outcome {
    let picture = figure.picture().and_then(|picture| picture.png(DEFAULT_PNG_SCALE));
    let picture = picture.map_err(|error| format!("cannot draw {path}: {error}"))?;
    fs::write(root().join(path), picture).map_err(|error| format!("cannot write {path}: {error}"))
}

/// Commands in words, the picture that each makes and the name that it gets.
const PICTURES: [(&str, &str, &str); 22] = [
    (
        "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum validation/reference/sbb-track-noise/rail_roughness.csv \
         --where laboratory=MBBM --date-column date",
        "forecast.png",
        "forecast.png",
    ),
    (
        "compare cases/discrete-supports.toml --with cases/soft-pads.toml \
         --with cases/speed-spread.toml --with cases/friction-management.toml \
         --speed 110km/h",
        "compare.png",
        "compare.png",
    ),
    (
        "roughness validation/reference/sbb-track-noise/rail_roughness.csv \
         --where laboratory=MBBM --by campaign",
        "roughness.png",
        "niederwangen.png",
    ),
    (
        "noise cases/main-line.toml --roughness validation/reference/sbb-track-noise/rail_roughness.csv \
         --where laboratory=MBBM --speed 136km/h --wheel-roughness cnossos-disc-brakes \
         --track-transfer cnossos-monobloc-hard-pads --vehicle-transfer cnossos-wheel-920",
        "noise.png",
        "noise.png",
    ),
    // The second goes on from the first.
    (
        "simulate cases/bhaskar-track.toml --speed 30 --spectrum validation/reference/sbb-track-noise/rail_roughness.csv \
         --length 12m --passages 2e7",
        "profile.png",
        "evolution-profile.png",
    ),
    (
        "simulate cases/bhaskar-track.toml --speed 30 --spectrum validation/reference/sbb-track-noise/rail_roughness.csv \
         --length 12m --passages 8e7",
        "spectrum.png",
        "evolution.png",
    ),
    ("map cases/nominal.toml", "map.png", "nominal-map.png"),
    ("map cases/discrete-supports.toml --bay", "bay-map.png", "bay-map.png"),
    ("map cases/curve.toml", "map.png", "curve-map.png"),
    ("map cases/metro-curve.toml --wheels", "map.png", "metro-curve-wheels.png"),
    ("map cases/metro-curve.toml --wheels", "growth.png", "metro-curve-growth.png"),
    ("map cases/class-roaring-rails.toml", "map.png", "class-roaring-rails.png"),
    ("map cases/class-rutting.toml", "map.png", "class-rutting.png"),
    ("map cases/class-contact-fatigue.toml", "map.png", "class-contact-fatigue.png"),
    ("map cases/class-booted-sleeper.toml", "map.png", "class-booted-sleeper.png"),
    ("map cases/class-soft-slab.toml", "map.png", "class-soft-slab.png"),
    ("curve cases/bogie.toml", "curve.png", "bogie-curve.png"),
    ("profile cases/profiles.toml --wheelset", "wheelset.png", "contact-geometry.png"),
    ("wheelset cases/curve.toml", "modes.png", "curve-modes.png"),
    ("compare cases/wheelset-coach.toml --models", "models.png", "models.png"),
    ("compare cases/wheelset-coach.toml --models frederick-1987", "complex-plane.png", "complex-plane.png"),
    ("receptance cases/discrete-supports.toml", "receptance.png", "receptance.png"),
];

/// The pictures that commands make for README and book.
fn pictures(program: &Path) -> Outcome {
    let results = root().join("target/generate");
    // Of an earlier version, perhaps, whose files this one does not know as its own.
    let _ = fs::remove_dir_all(&results);
    for (command, written, name) in PICTURES {
        let words = command.split_whitespace().chain(["-o", "target/generate"]);
        riffel(program, &words.collect::<Vec<&str>>())?;
        fs::copy(results.join(written), root().join("docs/src/images").join(name))
            .map_err(|error| format!("cannot copy the picture {name}: {error}"))?;
    }
    study_pictures(program)
}

/// The pictures of a study, which are made from its results.
fn study_pictures(program: &Path) -> Outcome {
    const RESULTS: &str = "target/generate-study";
    const FIGURES: &str = "target/generate";
    // Of another plan, if the example has changed.
    let _ = fs::remove_dir_all(root().join(RESULTS));
    riffel(program, &["study", "cases/sensitivity.toml", "-o", RESULTS])?;
    riffel(program, &["study", "sensitivity", RESULTS, "-o", FIGURES])?;
    for name in ["sobol-indices.png", "tornado.png", "growth-bands.png"] {
        fs::copy(root().join(FIGURES).join(name), root().join("docs/src/images").join(name))
            .map_err(|error| format!("cannot copy the picture {name}: {error}"))?;
    }
    Ok(())
}

fn validation() -> String {
    format!(
        "# Validation\n\n\
         Written by `cargo xtask generate`; `riffel validate` prints the same on any machine. Sections and figures\n\
         are those of Afferrante & Ciavarella (2009); `validation/README.md` says where the reference numbers come\n\
         from and lists each deviation from the paper with its reason. Times are no statements that hold on any\n\
         machine: those of the page under load and of its sliders are in [The page](page.md#measured).\n\n{}",
        riffel_validation::markdown()
    )
}

fn command_line(program: &Path) -> Result<String, String> {
    let text = "# The command line\n\nWritten by `cargo xtask generate` from the program's own help.\n";
    Ok(text.to_owned() + &sections(program, &[])?)
}

/// The help of a command, and of all below it.
fn sections(program: &Path, command: &[&str]) -> Result<String, String> {
    let help = riffel(program, &[command, &["--help"]].concat())?;
    let title = [&["riffel"], command].concat().join(" ");
    let mut text = format!("\n## `{title}`\n\n```text\n{}\n```\n", help.trim_end());
    // Lines of words that go on are indented further.
    let below = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names = below.filter_map(|line| line.strip_prefix("  ")?.split(' ').next().filter(|name| !name.is_empty()));
    for name in names.filter(|name| *name != "help") {
        text.push_str(&sections(program, &[command, &[name]].concat())?);
    }
    Ok(text)
}

/// What the program prints.
fn riffel(program: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(root())
        .output()
        .map_err(|error| format!("cannot run {}: {error}", program.display()))?;
    if !output.status.success() {
        return Err(format!("riffel {} failed", arguments.join(" ")));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
