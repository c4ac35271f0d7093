//! Files that are written by the program and kept in the repository.

use std::fs;
use std::process::Command;

use crate::{Outcome, decay_rate, place_of_wear, presets, root};

/// Commands whose help the book shows.
const COMMANDS: [&str; 16] = [
    "init",
    "point",
    "map",
    "receptance",
    "contact",
    "roughness",
    "diagnose",
    "report",
    "forecast",
    "compare",
    "study",
    "figures",
    "serve",
    "presets",
    "schema",
    "validate",
];

/// Write the generated files, or with `check` compare them.
pub(crate) fn run(check: bool) -> Outcome {
    let written = |text: serde_json::Result<String>| {
        text.map(|text| text + "\n")
            .map_err(|error| format!("a schema cannot be written: {error}"))
    };
    let case = written(serde_json::to_string_pretty(&riffel_case::json_schema()))?;
    let traffic = written(serde_json::to_string_pretty(&riffel_case::traffic_schema()))?;
    let study = written(serde_json::to_string_pretty(&riffel_study::plan_schema()))?;
    let files = [
        ("docs/src/validation.md", validation()),
        ("docs/src/command-line.md", command_line()?),
        ("docs/src/case.schema.json", case),
        ("docs/src/traffic.schema.json", traffic),
        ("docs/src/study.schema.json", study),
        ("docs/src/decay-rate.md", decay_rate::page()?),
        ("docs/src/presets.md", presets::page()),
        ("docs/src/rolling-contact.md", place_of_wear::page()?),
    ];
    for (path, text) in files {
        let file = root().join(path);
        if check {
            let current = fs::read_to_string(&file).unwrap_or_default();
            if current != text {
                return Err(format!("{path} is not current; run cargo xtask generate"));
            }
        } else {
            fs::write(&file, text).map_err(|error| format!("cannot write {path}: {error}"))?;
        }
    }
    if !check {
        pictures()?;
        decay_rate::picture()?;
        place_of_wear::picture()?;
    }
    println!(
        "# generated files {}",
        if check { "are current" } else { "written" }
    );
    Ok(())
}

/// The pictures that commands make for README and book. They are not compared: the last digit of a
/// mathematical function may move a line by a tenth of a pixel from one machine to another.
fn pictures() -> Outcome {
    const PICTURES: [(&[&str], &str, &str); 6] = [
        (
            &[
                "forecast",
                "cases/nominal.toml",
                "--traffic",
                "cases/traffic.toml",
                "--spectrum",
                "validation/reference/sbb-track-noise/rail_roughness.csv",
                "--where",
                "laboratory=MBBM",
                "--date-column",
                "date",
            ],
            "forecast.png",
            "forecast.png",
        ),
        (
            &[
                "compare",
                "cases/discrete-supports.toml",
                "--with",
                "cases/soft-pads.toml",
                "--with",
                "cases/speed-spread.toml",
                "--with",
                "cases/friction-management.toml",
                "--speed",
                "110 km/h",
            ],
            "compare.png",
            "compare.png",
        ),
        (
            &[
                "roughness",
                "validation/reference/sbb-track-noise/rail_roughness.csv",
                "--where",
                "laboratory=MBBM",
                "--by",
                "campaign",
            ],
            "roughness.png",
            "niederwangen.png",
        ),
        (&["map", "cases/nominal.toml"], "map.png", "nominal-map.png"),
        (
            &["map", "cases/discrete-supports.toml", "--bay"],
            "bay-map.png",
            "bay-map.png",
        ),
        (
            &["receptance", "cases/discrete-supports.toml"],
            "receptance.png",
            "receptance.png",
        ),
    ];
    let results = root().join("target/generate");
    for (command, written, name) in PICTURES {
        riffel(&[command, &["-o", "target/generate"]].concat())?;
        fs::copy(
            results.join(written),
            root().join("docs/src/images").join(name),
        )
        .map_err(|error| format!("cannot copy the picture {name}: {error}"))?;
    }
    study_pictures()
}

/// The pictures of a study, which are made from its results.
fn study_pictures() -> Outcome {
    const RESULTS: &str = "target/generate-study";
    const FIGURES: &str = "target/generate";
    // Of another plan, if the example has changed.
    let _ = fs::remove_dir_all(root().join(RESULTS));
    riffel(&["study", "cases/sensitivity.toml", "-o", RESULTS])?;
    riffel(&["study", "sensitivity", RESULTS, "-o", FIGURES])?;
    for name in ["sobol-indices.png", "tornado.png", "growth-bands.png"] {
        fs::copy(
            root().join(FIGURES).join(name),
            root().join("docs/src/images").join(name),
        )
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

fn command_line() -> Result<String, String> {
    let mut text = String::from(
        "# The command line\n\nWritten by `cargo xtask generate` from the program's own help.\n",
    );
    text.push_str(&section("riffel", &["--help"])?);
    for command in COMMANDS {
        text.push_str(&section(
            &format!("riffel {command}"),
            &[command, "--help"],
        )?);
    }
    for command in ["merge", "sensitivity"] {
        text.push_str(&section(
            &format!("riffel study {command}"),
            &["study", command, "--help"],
        )?);
    }
    Ok(text)
}

fn section(title: &str, arguments: &[&str]) -> Result<String, String> {
    let help = riffel(arguments)?;
    Ok(format!(
        "\n## `{title}`\n\n```text\n{}\n```\n",
        help.trim_end()
    ))
}

/// What the program prints.
fn riffel(arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--package", "riffel-cli", "--"])
        .args(arguments)
        .current_dir(root())
        .output()
        .map_err(|error| format!("cannot run riffel: {error}"))?;
    if !output.status.success() {
        return Err(format!("riffel {} failed", arguments.join(" ")));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
