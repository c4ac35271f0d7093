//! `riffel study`: stopped, shared and analysed.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::{Duration, Instant, SystemTime};

use crate::sandbox::{Sandbox, number};

/// A study that takes some seconds: whole maps of 600 samples.
const LONG: &str = r#"
case = "cases/nominal.toml"
set.map.speed = { min = "5 m/s", max = "60 m/s", points = 60 }
design = { method = "sobol", samples = 600, seed = 3 }
outputs = { ridge = true, map = ["growth_rate"] }
results.samples_per_chunk = 10
[[parameter]]
key = "contact.friction"
uniform = { min = 0.2, max = 0.5 }
[[parameter]]
key = "wheel.mass"
uniform = { min = "300 kg", max = "400 kg" }
"#;

fn sandbox(plan: &str) -> Sandbox {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("plan.toml"), plan).unwrap();
    sandbox
}

/// All files below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Files below a folder with their bytes, by name.
fn bytes(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let name = |path: &PathBuf| path.strip_prefix(folder).unwrap().to_owned();
    files(folder).iter().map(|path| (name(path), fs::read(path).unwrap())).collect()
}

fn times(folder: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let time = |path: &PathBuf| fs::metadata(path).unwrap().modified().unwrap();
    files(folder).into_iter().map(|path| (path.clone(), time(&path))).collect()
}

/// Start the study and wait until so many chunks are finished.
fn begun(sandbox: &Sandbox, chunks: usize) -> Child {
    let child = sandbox
        .command()
        .args(["study", "plan.toml", "-o", "results"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let finished = sandbox.path("results/finished");
    let records = || {
        let entries = fs::read_dir(&finished).into_iter().flatten().flatten();
        entries.filter(|entry| entry.file_name().to_string_lossy().ends_with(".json")).count()
    };
    let begun = Instant::now();
    while records() < chunks {
        assert!(begun.elapsed() < Duration::from_secs(300), "the study does not begin");
        std::thread::sleep(Duration::from_millis(2));
    }
    child
}

// Long: computes a study twice that takes long enough to be killed within.
#[test]
fn a_killed_study_goes_on_where_it_stopped() {
    let sandbox = sandbox(LONG);
    let mut child = begun(&sandbox, 5);
    child.kill().unwrap(); // SIGKILL
    child.wait().unwrap();
    let kept: Vec<String> =
        sandbox.list("results/finished").into_iter().filter(|name| !name.starts_with('.')).collect();
    assert!((5..60).contains(&kept.len()), "{} chunks", kept.len());
    let before = times(&sandbox.path("results/finished"));
    let arrays = times(&sandbox.path("results/results.zarr"));

    let outcome = sandbox.riffel("study plan.toml -o results");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let sentence = format!("{} of 60 chunks are finished and kept", kept.len());
    assert!(outcome.text.contains(&sentence), "{}", outcome.text);
    // What was finished is as it was.
    let after = times(&sandbox.path("results/finished"));
    let untouched = |path: &PathBuf| !path.file_name().unwrap().to_string_lossy().starts_with('.');
    for (path, time) in before.iter().filter(|(path, _)| untouched(path)) {
        assert_eq!(after[path], *time, "{}", path.display());
    }
    let chunks: Vec<String> = kept.iter().map(|name| name[..6].trim_start_matches('0').to_owned()).collect();
    for (path, time) in arrays {
        let chunk = path.components().skip_while(|part| part.as_os_str() != "c").nth(1);
        let chunk = chunk.map(|part| part.as_os_str().to_string_lossy().into_owned());
        if chunk.is_some_and(|chunk| chunks.contains(&chunk)) {
            assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), time);
        }
    }
    // And all is as if nothing had happened.
    assert_eq!(sandbox.riffel("study plan.toml -o whole").status, Some(0));
    assert!(bytes(&sandbox.path("whole")) == bytes(&sandbox.path("results")));
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_finished_and_says_so() {
    let sandbox = sandbox(LONG);
    let child = begun(&sandbox, 3);
    let interrupt = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(interrupt.unwrap().success());
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(130), "{text}");
    assert!(
        text.contains(" of 60 chunks are finished and kept in results; the same command goes on from there"),
        "{text}"
    );
    assert!(files(&sandbox.path("results")).iter().all(|path| !path.to_string_lossy().contains(".riffel-")));
}

// Long: computes a study whole, in seven shards and in three, each a start of the program.
#[test]
fn shards_are_merged_into_the_whole() {
    let plan = LONG.replace("samples = 600", "samples = 90").replace("points = 60", "points = 6");
    let sandbox = sandbox(&plan);
    for shard in 1..=7 {
        let outcome = sandbox.riffel(&format!("study plan.toml -o part-{shard} --shard {shard}/7"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    }
    let outcome = sandbox.riffel("study merge merged part-1 part-2 part-3 part-4 part-5 part-6");
    assert_eq!(outcome.status, Some(1), "{}", outcome.text);
    assert!(outcome.text.contains("note: 1 chunks are missing: 6;"), "{}", outcome.text);
    let report = sandbox.json("study merge merged part-7 part-1 --json");
    assert_eq!((number(&report["copied"]), number(&report["there_already"])), (1.0, 2.0));
    sandbox.json("study plan.toml -o whole --threads 1 --json");
    assert!(bytes(&sandbox.path("whole")) == bytes(&sandbox.path("merged")));
    // Shards in one folder come to the same.
    for shard in [2, 1, 3] {
        assert_eq!(sandbox.riffel(&format!("study plan.toml -o shared --shard {shard}/3")).status, Some(0));
    }
    assert!(bytes(&sandbox.path("whole")) == bytes(&sandbox.path("shared")));
}

#[test]
fn a_bad_plan_leaves_no_folder() {
    let sandbox = sandbox(&LONG.replace("0.5", "-0.5"));
    let outcome = sandbox.riffel("study plan.toml");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(!sandbox.path("plan-results").exists());
}

/// Also by a design whose tornado needs no results.
#[test]
fn an_unfinished_study_is_not_analysed() {
    for plan in [LONG.to_owned(), LONG.replace("\"sobol\"", "\"saltelli\"")] {
        let sandbox = sandbox(&plan.replace("600", "64").replace("points = 60", "points = 5"));
        let part = sandbox.riffel("study plan.toml -o part --shard 1/2");
        assert_eq!(part.status, Some(0), "{}", part.text);
        let before = sandbox.list("part");
        for words in ["study sensitivity part", "study sensitivity part --json"] {
            let outcome = sandbox.riffel(words);
            assert_eq!(outcome.status, Some(1), "{}", outcome.text);
            assert!(
                outcome.text.contains("part is not finished: ") && outcome.text.contains(" chunks are missing"),
                "{}",
                outcome.text
            );
            assert!(!outcome.text.contains("alone"), "{}", outcome.text);
        }
        assert_eq!(sandbox.list("part"), before);
    }
}

#[test]
fn sensitivity_answers_in_tables_and_pictures() {
    let plan = LONG
        .replace("\"sobol\", samples = 600", "\"saltelli\", samples = 64")
        .replace("points = 60", "points = 5")
        .replace("map = [\"growth_rate\"]", "growth_by_wavelength = true");
    let sandbox = sandbox(&plan);
    sandbox.json("study plan.toml -o results --json");
    let document = sandbox.json("study sensitivity results -o figures --json");
    let frequency = &document["outputs"][0];
    assert_eq!(frequency["name"], "ridge_frequency");
    // The resonance of wheel and rail follows the mass of the wheel, and friction not at all.
    let share = |parameter: usize| number(&frequency["parameters"][parameter]["first_order"]["value"]);
    assert!(share(0).abs() < 0.01 && share(1) > 0.9, "{frequency}");
    assert_eq!(frequency["parameters"][1]["key"], "wheel.mass");
    let names = [
        "growth-bands.html",
        "growth-bands.png",
        "growth-bands.svg",
        "sensitivity.json",
        "sobol-indices.png",
        "sobol-indices.svg",
        "tornado.png",
        "tornado.svg",
    ];
    assert_eq!(sandbox.list("figures"), names);
    let outcome = sandbox.riffel("study sensitivity results --result growth");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    let outcome = sandbox.riffel("study sensitivity results --confidence 1");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    let rule = "--confidence is 1, but must be between 0 and 1, both excluded";
    assert!(outcome.sentence().contains(rule), "{}", outcome.text);
}
