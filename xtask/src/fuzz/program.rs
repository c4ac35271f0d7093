//! The built program on mutated files: whatever they hold, it ends in time, with an exit status of its own and
//! without a number that is none.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::mutation::{Chance, mutated};
use super::{Target, corpus};
use crate::{Outcome, build_program, root};

/// Longest processor time of one run \[s\], whatever else the machine does.
const LONGEST: u32 = 10;
/// When a run that does not compute is given up.
const STUCK: Duration = Duration::from_secs(300);
/// Copy of the program, which builds meanwhile do not replace.
const PROGRAM: &str = "riffel";
/// A window of the map that is computed at once.
const SMALL: [&str; 4] = [
    "--set",
    "map.wavelength.points=9",
    "--set",
    "map.speed.points=5",
];

/// A command line; `FILE` is the mutated file.
struct Line {
    words: &'static [&'static str],
    /// File of the project that is mutated; one of the corpus without.
    file: Option<&'static str>,
    kind: Target,
    /// Whether it prints a document in which nothing may be missing.
    whole: bool,
}

/// One point of a case, as a document.
const POINT: [&str; 7] = [
    "point",
    "FILE",
    "--wavelength",
    "50 mm",
    "--speed",
    "90 km/h",
    "--json",
];

const LINES: [Line; 9] = [
    Line {
        words: &POINT,
        file: Some("cases/nominal.toml"),
        kind: Target::Case,
        whole: true,
    },
    Line {
        words: &POINT,
        file: Some("cases/discrete-supports.toml"),
        kind: Target::Case,
        whole: true,
    },
    Line {
        words: &["map", "FILE", "-o", "map"],
        file: Some("cases/nominal.toml"),
        kind: Target::Case,
        whole: false,
    },
    Line {
        words: &["receptance", "FILE", "--points", "20", "-o", "receptance"],
        file: Some("cases/bhaskar-track.toml"),
        kind: Target::Case,
        whole: false,
    },
    Line {
        words: &["roughness", "FILE", "-o", "roughness"],
        file: None,
        kind: Target::Roughness,
        whole: false,
    },
    Line {
        words: &[
            "diagnose",
            "cases/nominal.toml",
            "--roughness",
            "FILE",
            "-o",
            "diagnosis",
        ],
        file: None,
        kind: Target::Roughness,
        whole: false,
    },
    Line {
        words: &[
            "forecast",
            "cases/nominal.toml",
            "--spectrum",
            "levels.csv",
            "--traffic",
            "FILE",
            "-o",
            "forecast",
        ],
        file: Some("cases/traffic.toml"),
        kind: Target::Traffic,
        whole: false,
    },
    Line {
        words: &[
            "compare",
            "cases/nominal.toml",
            "--with",
            "FILE",
            "-o",
            "compare",
        ],
        file: Some("cases/soft-pads.toml"),
        kind: Target::Case,
        whole: false,
    },
    Line {
        words: &[
            "point",
            "cases/nominal.toml",
            "--wavelength",
            "50 mm",
            "--speed",
            "90 km/h",
            "--json",
            "--set",
            "track.model=\"measured\"",
            "--set",
            "track.measurement.file=\"../FILE\"",
        ],
        file: None,
        kind: Target::Receptance,
        whole: true,
    },
];

/// Levels of a rail, for commands that need some beside the mutated file.
const LEVELS: &str = "wavelength_mm,level_db\n100,4\n80,5\n63,6\n50,8\n40,7\n31.5,2\n25,-2\n";

/// Run mutated files through the program for some seconds.
pub(super) fn run(seconds: u64, seed: u64) -> Outcome {
    build_program()?;
    let folder = root().join("target/fuzz/program");
    let findings = root().join("target/fuzz/findings/program");
    prepare(&folder).map_err(|reason| format!("cannot prepare {}: {reason}", folder.display()))?;
    let mut seeds: Vec<Vec<Vec<u8>>> = Vec::new();
    for line in &LINES {
        seeds.push(match line.file {
            Some(file) => vec![corpus::read(&root().join(file))?],
            None => corpus::seeds(line.kind)?,
        });
    }
    println!("# program, {seconds} s");
    let mut chance = Chance(seed);
    let mut statuses: BTreeMap<String, u32> = BTreeMap::new();
    let mut found = 0;
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_secs(seconds) {
        let index = chance.below(LINES.len());
        let original = &seeds[index][chance.below(seeds[index].len())];
        let bytes = mutated(original, &mut chance);
        let line = &LINES[index];
        let outcome = run_once(line, &bytes, &folder)
            .map_err(|reason| format!("cannot run the program: {reason}"))?;
        *statuses
            .entry(
                outcome
                    .status
                    .map_or("none".to_owned(), |status| status.to_string()),
            )
            .or_default() += 1;
        if let Some(fault) = outcome.fault(line) {
            found += 1;
            let place = findings.join(format!("{seed}-{found}"));
            let words = line.words.join(" ");
            let note = format!("riffel {words}\n{fault}\n{}\n", outcome.text);
            fs::create_dir_all(&place)
                .and_then(|()| fs::write(place.join("FILE"), &bytes))
                .and_then(|()| fs::write(place.join("finding.txt"), note))
                .map_err(|reason| format!("cannot write {}: {reason}", place.display()))?;
            println!("{}: riffel {words}: {fault}", place.display());
        }
    }
    let runs: u32 = statuses.values().sum();
    let statuses: Vec<String> = statuses
        .iter()
        .map(|(status, count)| format!("{count} × {status}"))
        .collect();
    println!(
        "{runs} runs, exit status {}; {found} findings",
        statuses.join(", ")
    );
    if found == 0 {
        Ok(())
    } else {
        Err(format!("{found} findings in {}", findings.display()))
    }
}

fn prepare(folder: &Path) -> std::io::Result<()> {
    let cases = folder.join("cases");
    fs::create_dir_all(&cases)?;
    for entry in fs::read_dir(root().join("cases"))? {
        let path = entry?.path();
        if let Some(name) = path.file_name() {
            fs::copy(&path, cases.join(name))?;
        }
    }
    fs::copy(root().join("target/debug/riffel"), folder.join(PROGRAM))?;
    fs::write(folder.join("levels.csv"), LEVELS)
}

/// What came of a run.
struct Run {
    /// Exit status; none if it was ended by a signal, for one for want of time.
    status: Option<i32>,
    /// Both streams.
    text: String,
}

impl Run {
    /// What the program should not have done.
    fn fault(&self, line: &Line) -> Option<String> {
        // Without the notes: they may quote the file.
        let document = self
            .text
            .split_once("\n}")
            .map_or("", |(document, _)| document);
        let missing = ["NaN", "null"];
        if self.text.contains("panicked at") {
            Some("panicked".to_owned())
        } else if self.status.is_none() {
            Some(format!("computed for {LONGEST} s, was stuck or broke down"))
        } else if !matches!(self.status, Some(0..=2)) {
            Some(format!("ended with {:?}", self.status))
        } else if self.status == Some(0)
            && line.whole
            && missing.iter().any(|word| document.contains(word))
        {
            Some("printed a number that is none".to_owned())
        } else if self.text.chars().any(|c| c.is_control() && c != '\n') {
            Some("printed a control character".to_owned())
        } else {
            None
        }
    }
}

fn run_once(line: &Line, bytes: &[u8], folder: &Path) -> std::io::Result<Run> {
    let universal = line.kind == Target::Receptance && bytes.starts_with(b"    -1");
    let name = match line.kind {
        Target::Receptance if universal => "input.uff",
        Target::Receptance | Target::Roughness => "input.csv",
        _ => "cases/input.toml",
    };
    fs::write(folder.join(name), bytes)?;
    let output = folder.join("output.txt");
    let stream = File::create(&output)?;
    let mut command = Command::new("sh");
    command
        .arg("-c")
        .arg(format!("ulimit -t {LONGEST}; exec \"$0\" \"$@\""))
        .arg(folder.join(PROGRAM))
        .args(line.words.iter().map(|word| word.replace("FILE", name)))
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .stdout(stream.try_clone()?)
        .stderr(stream);
    if line.words[0] == "map" {
        command.args(SMALL);
    }
    let mut child = command.spawn()?;
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if begun.elapsed() > STUCK {
            child.kill()?;
            break child.wait()?;
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    Ok(Run {
        status: status.code(),
        text: String::from_utf8_lossy(&fs::read(&output)?).into_owned(),
    })
}
