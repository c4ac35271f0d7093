//! What the program writes: whole, correct, or not at all.

use std::collections::BTreeMap;
use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::sandbox::Sandbox;

const MAP_FILES: [&str; 8] =
    ["branches.csv", "map.csv", "map.html", "map.nc", "map.png", "map.svg", "ridge.csv", "summary.json"];

/// A map small enough to be quick and large enough to have a ridge.
const SMALL: &str = "--set map.wavelength.points=61 --set map.speed.points=56";

#[test]
fn map_writes_all_its_files() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel(&format!("map cases/nominal.toml -o out/a {SMALL}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert_eq!(sandbox.list("out/a"), MAP_FILES);

    let html = fs::read_to_string(sandbox.path("out/a/map.html")).unwrap();
    assert!(html.contains("content=\"default-src 'none';"), "no policy forbids loading");
    for loads in ["<script src", "<link", "@import"] {
        assert!(!html.contains(loads), "the page loads something: {loads}");
    }
    let rows: Vec<String> =
        fs::read_to_string(sandbox.path("out/a/map.csv")).unwrap().lines().map(str::to_owned).collect();
    assert_eq!(rows.len(), 1 + 61 * 56);
    assert_eq!(
        rows[0],
        "wavelength_m,speed_m_per_s,normalized_dissipation_re,normalized_dissipation_im,growth_rate_per_passage"
    );
}

/// The table, the grid, the ridge and a single point tell the same story.
#[test]
fn files_agree_with_each_other_and_with_point() {
    let sandbox = Sandbox::new();
    sandbox.riffel(&format!("map cases/bhaskar-track.toml -o out {SMALL}"));
    let table = fs::read_to_string(sandbox.path("out/map.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        table.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();

    let mut grid = netcdf3::FileReader::open(sandbox.path("out/map.nc")).unwrap();
    let variables = grid.read_all_vars().unwrap();
    let variable = |name: &str| variables[name].get_f64().unwrap().to_vec();
    assert_eq!(variable("wavelength").len(), 61);
    assert_eq!(variable("speed").len(), 56);
    assert_eq!(variable("normalized_dissipation_re"), column(&rows, 2));
    assert_eq!(variable("normalized_dissipation_im"), column(&rows, 3));
    assert_eq!(variable("growth_rate"), column(&rows, 4));

    let row = &rows[1234];
    let arguments = format!("point cases/bhaskar-track.toml --json --wavelength {} --speed {}", row[0], row[1]);
    let output = sandbox.command().args(shlex::split(&arguments).unwrap()).output().unwrap();
    let point: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let close = |value: &serde_json::Value, expected: f64| {
        // Both from the same formulas in another order of operations: rounding.
        (value.as_f64().unwrap() - expected).abs() <= 1e-12 * expected.abs().max(1e-3)
    };
    assert!(close(&point["normalized_dissipation"][0], row[2]));
    assert!(close(&point["normalized_dissipation"][1], row[3]));
    assert!(close(&point["growth_rate_per_passage"], row[4]));

    // No point of the grid grows faster than the ridge at its speed.
    let ridge: BTreeMap<String, f64> = fs::read_to_string(sandbox.path("out/ridge.csv"))
        .unwrap()
        .lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            (cells[0].to_owned(), cells[3].parse().unwrap())
        })
        .collect();
    for row in &rows {
        assert!(row[2] >= ridge[&format!("{:?}", row[1])] - 1e-12);
    }
}

fn column(rows: &[Vec<f64>], index: usize) -> Vec<f64> {
    rows.iter().map(|row| row[index]).collect()
}

#[test]
fn summary_is_complete_and_its_inputs_are_a_case() {
    let sandbox = Sandbox::new();
    sandbox.riffel(&format!("map cases/bhaskar-track.toml -o out {SMALL}"));
    let text = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(summary["riffel_version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(summary["inputs"]["track"]["pad"]["stiffness"], "8e7 N/m");
    let frequency = summary["ridge"]["best_fit_frequency_hz"].as_f64().unwrap();
    assert!((500.0..550.0).contains(&frequency), "{frequency}");
    // The strongest branch leads, and what is said of it agrees with its points.
    let branches = summary["ridge"]["branches"].as_array().unwrap();
    assert!(branches.len() > 1, "{branches:?}");
    assert_eq!(branches[0]["frequency_hz"].as_f64(), Some(frequency));
    let rates: Vec<f64> =
        branches.iter().map(|branch| branch["highest_growth_rate_per_passage"].as_f64().unwrap()).collect();
    assert!(rates.is_sorted_by(|a, b| a >= b), "{rates:?}");
    let highest = summary["ridge"]["highest"]["growth_rate_per_passage"].as_f64();
    assert_eq!(Some(rates[0]), highest);
    let points = fs::read_to_string(sandbox.path("out/branches.csv")).unwrap();
    for (index, branch) in branches.iter().enumerate() {
        let rows: Vec<Vec<&str>> = points
            .lines()
            .map(|line| line.split(',').collect::<Vec<_>>())
            .filter(|row| row[0] == index.to_string())
            .collect();
        let inside: Vec<&Vec<&str>> = rows.iter().filter(|row| row[6] == "false").collect();
        let shown = if inside.is_empty() { rows.iter().collect() } else { inside };
        for (column, key) in [(1, "speed_m_per_s"), (2, "wavelength_m")] {
            let values = shown.iter().map(|row| row[column].parse::<f64>().unwrap());
            let (least, most) =
                values.fold((f64::MAX, f64::MIN), |(least, most), value| (value.min(least), value.max(most)));
            assert_eq!(branch[key], serde_json::json!([least, most]), "{key}");
        }
    }
    let inputs: riffel_case::file::CaseFile = serde_json::from_value(summary["inputs"].clone()).unwrap();
    assert_eq!(inputs.track.support_spacing.unwrap().si(), 0.7);
}

/// A result folder that cannot be written, a bad case, bad observations: status 2, nothing left.
#[test]
fn failures_leave_nothing() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("file"), "in the way").unwrap();
    fs::write(sandbox.path("bad.csv"), "wavelength,speed\n40 mm,fast\n").unwrap();
    fs::write(sandbox.path("short.csv"), "length,speed\n40 mm,20\n").unwrap();
    for arguments in [
        "map cases/nominal.toml -o file",
        "map cases/nominal.toml -o file/below",
        "map cases/nominal.toml -o out --set contact.friction=-1",
        "map cases/nominal.toml -o out --observations bad.csv",
        "map cases/nominal.toml -o out --observations short.csv",
        "map cases/nominal.toml -o out --observations missing.csv",
        "map missing.toml -o out",
        "receptance cases/nominal.toml -o out --from 100 --to 50",
        "receptance cases/nominal.toml -o out --points 1",
        "point cases/nominal.toml --wavelength -1 --speed 20",
        "point cases/nominal.toml --wavelength 0.05 --speed \"20 kg\"",
        "presets no-such-preset",
        "init cases/nominal.toml",
        "init missing/folder/case.toml",
        "nonsense",
    ] {
        let outcome = sandbox.riffel(arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(outcome.text.len() > 20, "{arguments}");
    }
    assert_eq!(sandbox.list("."), ["bad.csv", "cases", "file", "short.csv"]);
    assert_eq!(fs::read_to_string(sandbox.path("file")).unwrap(), "in the way");
}

#[test]
fn observations_are_drawn() {
    let sandbox = Sandbox::new();
    let table = "label,wavelength,speed\nline A,40 mm,\"80 km/h\"\nline A,0.05,27\nline B,60 mm,108 km/h\n";
    fs::write(sandbox.path("measured.csv"), table).unwrap();
    let outcome = sandbox.riffel(&format!("map cases/nominal.toml -o out --observations measured.csv {SMALL}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let picture = fs::read_to_string(sandbox.path("out/map.svg")).unwrap();
    assert!(picture.contains("line A") && picture.contains("line B"));
}

#[test]
fn an_existing_result_is_replaced_whole() {
    let sandbox = Sandbox::new();
    for friction in ["0.4", "0.3"] {
        let arguments = format!("map cases/nominal.toml -o out {SMALL} --set contact.friction={friction}");
        assert_eq!(sandbox.riffel(&arguments).status, Some(0));
    }
    assert_eq!(sandbox.list("out"), MAP_FILES);
    let summary = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    assert!(summary.contains("\"friction\": 0.3"));
}

/// Ctrl-C in the middle of a large map: status 130, and no trace of it.
#[cfg(unix)]
#[test]
fn an_interrupted_map_leaves_nothing() {
    let sandbox = Sandbox::new();
    let mut child = sandbox
        .command()
        .args(["map", "cases/nominal.toml", "-o", "out"])
        .args(["--set", "map.wavelength.points=4000", "--set", "map.speed.points=4000"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // Wait until it has begun to write; the table of sixteen million rows takes seconds.
    let begun = Instant::now();
    let writing = || {
        let Ok(folders) = fs::read_dir(sandbox.path("out")) else {
            return false;
        };
        folders.flatten().any(|folder| folder.path().join("map.csv").exists())
    };
    while !writing() {
        assert!(begun.elapsed() < Duration::from_secs(120), "nothing was written");
        assert!(child.try_wait().unwrap().is_none(), "it ended too early");
        std::thread::sleep(Duration::from_millis(5));
    }
    let interrupted = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupted.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(sandbox.list("."), ["cases"]);
}

// Long: computes and draws seven figures by two models.
#[test]
fn figures_writes_picture_and_numbers_of_each() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel("figures -o figures");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let mut expected: Vec<String> =
        (2..=8).flat_map(|number| ["csv", "png", "svg"].map(|ending| format!("figure-{number}.{ending}"))).collect();
    expected.sort();
    assert_eq!(sandbox.list("figures"), expected);
    let dissipation = |folder: &str| {
        let table = fs::read_to_string(sandbox.path(&format!("{folder}/figure-7.csv"))).unwrap();
        let last = table.lines().last().unwrap();
        last.rsplit(',').next().unwrap().parse::<f64>().unwrap()
    };
    let outcome = sandbox.riffel("figures -o other --model spring-dashpot");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert_eq!(sandbox.list("other"), expected);
    let title = fs::read_to_string(sandbox.path("other/figure-7.svg")).unwrap();
    assert!(title.contains("dashpot"));
    // The last curve is that of infinite inertia: no creepage, but the force by load is late as well.
    assert!(dissipation("other") != dissipation("figures"));
}
