//! Where the program writes, and what it never touches.

use std::fs::{self, File};
use std::process::{Command, Stdio};

use crate::sandbox::Sandbox;

/// A map with little to compute.
const TINY: &str = "--set map.wavelength.points=5 --set map.speed.points=4";

fn shell(sandbox: &Sandbox, command: &str) -> bool {
    let mut shell = Command::new("sh");
    shell.current_dir(sandbox.path(".")).args(["-c", command]);
    shell.stderr(Stdio::null()).status().unwrap().success()
}

/// A pipe, a link, a device: refused with status 2, and still what it was.
#[cfg(unix)]
#[test]
fn only_regular_files_are_replaced() {
    use std::os::unix::fs::FileTypeExt;

    let sandbox = Sandbox::new();
    fs::write(sandbox.path("precious.txt"), "precious").unwrap();
    fs::create_dir(sandbox.path("out")).unwrap();
    assert!(shell(&sandbox, "mkfifo pipe && ln -s precious.txt link && ln -s ../precious.txt out/map.csv"));
    // A copy of the null device; only root can make one.
    let device = shell(&sandbox, "mknod null c 1 3");
    let mut cases = vec![
        ("init pipe --force", "a pipe"),
        ("init link --force", "a link"),
        ("init cases --force", "a folder"),
        ("report cases/nominal.toml -o link", "a link"),
        ("roughness --synthesise -o pipe", "a pipe"),
        ("map cases/nominal.toml -o pipe", "a pipe"),
        ("map cases/nominal.toml -o out", "a link"),
    ];
    if device {
        cases.push(("init null --force", "a device"));
        cases.push(("map cases/nominal.toml -o null", "a device"));
        cases.push(("report cases/nominal.toml -o null", "a device"));
    }
    for (arguments, what) in cases {
        let is_map = arguments.starts_with("map") || arguments.starts_with("report");
        let less = if is_map { TINY } else { "" };
        let outcome = sandbox.riffel(&format!("{arguments} {less}"));
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(outcome.text.contains(what), "{arguments}: {}", outcome.text);
    }
    let kind = |name| fs::symlink_metadata(sandbox.path(name)).unwrap().file_type();
    assert!(kind("pipe").is_fifo() && kind("link").is_symlink());
    assert!(!device || kind("null").is_char_device());
    assert_eq!(sandbox.list("out"), ["map.csv"]);
    let text = fs::read_to_string(sandbox.path("precious.txt")).unwrap();
    assert_eq!(text, "precious");
}

/// Under its own name, under another path, and by a second name of the same file.
#[test]
fn an_input_is_never_replaced() {
    let sandbox = Sandbox::new();
    let case = fs::read_to_string(sandbox.path("cases/nominal.toml")).unwrap();
    fs::create_dir(sandbox.path("out")).unwrap();
    fs::write(sandbox.path("out/summary.json"), &case).unwrap();
    fs::hard_link(sandbox.path("cases/nominal.toml"), sandbox.path("second.toml")).unwrap();
    for arguments in [
        "report cases/nominal.toml -o cases/nominal.toml",
        "report cases/nominal.toml -o cases/../cases/nominal.toml",
        "report cases/nominal.toml -o second.toml",
        "map out/summary.json -o out",
        "report cases/nominal.toml --site second.toml -o second.toml",
        "roughness --synthesise cases/roughness-recipe.toml -o cases/roughness-recipe.toml",
    ] {
        let less = if arguments.starts_with("map") { TINY } else { "" };
        let outcome = sandbox.riffel(&format!("{arguments} {less}"));
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
    }
    for name in ["cases/nominal.toml", "second.toml", "out/summary.json"] {
        assert_eq!(fs::read_to_string(sandbox.path(name)).unwrap(), case);
    }
    assert_eq!(sandbox.list("out"), ["summary.json"]);
}

/// The file of a measured track is an input as much as the case that names it.
#[test]
fn a_measured_track_is_never_replaced() {
    let sandbox = Sandbox::new();
    let rows: String = (1..40).map(|f| format!("{},1e-9,-1e-10\n", 50 * f)).collect();
    let table = format!("frequency_hz,re,im\n{rows}");
    fs::create_dir(sandbox.path("out")).unwrap();
    fs::write(sandbox.path("out/receptance.csv"), &table).unwrap();
    let case = "title = \"measured\"\nvehicle = \"passenger-emu\"\n[rail]\nsection = \"60E1\"\n[track]\nmodel = \"measured\"\n\
        measurement = { file = \"out/receptance.csv\", real = \"re\", imaginary = \"im\" }\n[contact]\ntransverse_radius = 0.3\n\
        friction = 0.4\ntractive_ratio = 0.1\n";
    fs::write(sandbox.path("measured.toml"), case).unwrap();
    let outcome = sandbox.riffel("receptance measured.toml -o out");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("never replaced"), "{}", outcome.text);
    let now = fs::read_to_string(sandbox.path("out/receptance.csv")).unwrap();
    assert_eq!(now, table);
}

/// Files that the last run wrote and this one does not are removed; those of others, and those that were changed, stay.
#[test]
fn nothing_of_an_earlier_run_lies_beside_new_results() {
    let sandbox = Sandbox::new();
    let receptance = |case: &str| {
        let outcome = sandbox.riffel(&format!("receptance cases/{case} -o out --points 20"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    };
    receptance("bhaskar-track.toml");
    assert!(sandbox.list("out").contains(&"decay-rate.csv".to_owned()));
    fs::write(sandbox.path("out/notes.txt"), "mine").unwrap();
    fs::write(sandbox.path("out/decay-rate.svg"), "edited").unwrap();
    let outcome = sandbox.riffel(&format!("map cases/nominal.toml -o out {TINY}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    // The rail of the nominal case has no supports, and its waves no decay to table.
    receptance("nominal.toml");
    let now = sandbox.list("out");
    for kept in ["notes.txt", "decay-rate.svg", "map.csv", "receptance.csv"] {
        assert!(now.contains(&kept.to_owned()), "{kept} is gone: {now:?}");
    }
    for stale in ["decay-rate.csv", "decay-rate.png"] {
        assert!(!now.contains(&stale.to_owned()), "{stale} is stale: {now:?}");
    }
}

/// A file of the same name that Riffel did not write is not its to replace.
#[test]
fn a_file_of_somebody_else_is_not_replaced() {
    let sandbox = Sandbox::new();
    fs::create_dir(sandbox.path("out")).unwrap();
    fs::write(sandbox.path("out/map.csv"), "mine").unwrap();
    let outcome = sandbox.riffel(&format!("map cases/nominal.toml -o out {TINY}"));
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("not written by Riffel"), "{}", outcome.text);
    assert_eq!(sandbox.list("out"), ["map.csv"]);
    // What only looks like the list of Riffel is not believed either.
    fs::remove_file(sandbox.path("out/map.csv")).unwrap();
    fs::write(sandbox.path("out/riffel-manifest.json"), "[]").unwrap();
    let outcome = sandbox.riffel(&format!("map cases/nominal.toml -o out {TINY}"));
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    let list = fs::read_to_string(sandbox.path("out/riffel-manifest.json")).unwrap();
    assert_eq!(list, "[]");
}

/// What a killed run left is gone after the next one into the same folder.
#[cfg(unix)]
#[test]
fn leftovers_of_a_killed_run_are_removed() {
    let sandbox = Sandbox::new();
    let mut child = sandbox
        .command()
        .args(["map", "cases/nominal.toml", "-o", "out"])
        .args(["--set", "map.wavelength.points=4000"])
        .args(["--set", "map.speed.points=4000"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begun = std::time::Instant::now();
    let left = || {
        let names = fs::read_dir(sandbox.path("out")).into_iter().flatten();
        names.flatten().any(|entry| entry.path().join("lock").exists())
    };
    while !left() {
        assert!(begun.elapsed().as_secs() < 120, "nothing was begun");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    // While it lives, another run leaves it alone.
    let arguments = "receptance cases/nominal.toml -o out --points 20";
    assert_eq!(sandbox.riffel(arguments).status, Some(0));
    assert!(left());
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(left(), "a killed run cannot tidy up");
    assert_eq!(sandbox.riffel(arguments).status, Some(0));
    assert!(!left(), "{:?}", sandbox.list("out"));
}

#[test]
fn a_saved_format_replaces_nothing() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel("roughness --synthesise -o profile.csv");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    fs::write(sandbox.path("format.toml"), "mine").unwrap();
    let outcome = sandbox.riffel("roughness profile.csv --save-format format.toml");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("is there already"), "{}", outcome.text);
    let text = fs::read_to_string(sandbox.path("format.toml")).unwrap();
    assert_eq!(text, "mine");
    assert!(!sandbox.path("profile-roughness").exists());
}

/// A full disk behind standard output is an error; a reader that has seen enough is none.
#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_printed_is_an_error() {
    let sandbox = Sandbox::new();
    for arguments in [
        "presets",
        "presets --json",
        "schema",
        "--help",
        "--version",
        "completions bash",
        "point cases/nominal.toml --wavelength 0.05 --speed 20 --json",
    ] {
        let run = |stdout: Stdio| {
            let mut command = sandbox.command();
            command.args(shlex::split(arguments).unwrap());
            command.stdout(stdout).output().unwrap()
        };
        let full = run(File::options().write(true).open("/dev/full").unwrap().into());
        let errors = String::from_utf8_lossy(&full.stderr);
        assert_eq!(full.status.code(), Some(2), "{arguments}: {errors}");
        assert!(errors.contains("cannot write to standard output"), "{errors}");

        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let gone = run(writer.into());
        let errors = String::from_utf8_lossy(&gone.stderr);
        assert_eq!(gone.status.code(), Some(0), "{arguments}: {errors}");
        assert!(!errors.contains("cannot write"), "{arguments}: {errors}");
    }
}

/// A file that Riffel did not write is its owner's.
#[test]
fn foreign_files_are_not_replaced_by_single_files() {
    let sandbox = Sandbox::new();
    for command in ["roughness --synthesise -o mine.txt", "report cases/nominal.toml -o mine.txt"] {
        fs::write(sandbox.path("mine.txt"), "mine").unwrap();
        let outcome = sandbox.riffel(command);
        assert_eq!(outcome.status, Some(2), "{command}: {}", outcome.text);
        let sentence = outcome.sentence();
        assert!(sentence.contains("mine.txt is there already") && sentence.contains("--force"), "{sentence}");
        assert_eq!(fs::read(sandbox.path("mine.txt")).unwrap(), b"mine");
        let outcome = sandbox.riffel(&format!("{command} --force"));
        assert_eq!(outcome.status, Some(0), "{command}: {}", outcome.text);
        assert_ne!(fs::read(sandbox.path("mine.txt")).unwrap(), b"mine");
    }
    // A report is written anew over an earlier one, as results are in their folder.
    let outcome = sandbox.riffel("report cases/nominal.toml -o mine.txt");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
}

/// Two chapters that make one record meet in one folder; another file of that name stays.
#[test]
fn the_same_file_is_made_twice() {
    let sandbox = Sandbox::new();
    let make = "roughness --synthesise -o profile.csv";
    for _ in 0..2 {
        let outcome = sandbox.riffel(make);
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    }
    fs::write(sandbox.path("profile.csv"), "precious").unwrap();
    let outcome = sandbox.riffel(make);
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    let there = fs::read_to_string(sandbox.path("profile.csv")).unwrap();
    assert_eq!(there, "precious");
}

/// Names of rails come from files of others: what commands a terminal is written out, and what a spreadsheet would compute is text.
#[test]
fn names_command_neither_terminals_nor_spreadsheets() {
    let sandbox = Sandbox::new();
    let mut text = "rail,from_m,to_m,rms_30_to_100_mm_um\n".to_owned();
    let formula = "=1+cmd|' /C calc'!A0";
    for rail in [formula, "\u{1b}]0;owned\u{7}\u{9b}left"] {
        for from in 0..20 {
            text += &format!("{rail},{from},{},9\n", from + 1);
        }
    }
    fs::write(sandbox.path("blocks.csv"), text).unwrap();
    let take = "network ingest store blocks.csv --line @line --date 2026-01-31";
    let judged = "store --section \"10 m\"";
    for command in [
        take.to_owned(),
        format!("network worst {judged}"),
        format!("network worst {judged} --json"),
        format!("network chart {judged} -o out"),
    ] {
        let outcome = sandbox.riffel(&command);
        assert_eq!(outcome.status, Some(0), "{command}: {}", outcome.text);
        let commands = |c: char| c.is_control() && c != '\n';
        assert!(!outcome.text.contains(commands), "{command}: {:?}", outcome.text);
    }
    let document = sandbox.json(&format!("network worst {judged} --json"));
    assert!(document.to_string().contains("\u{9b}left"));
    let table = fs::read_to_string(sandbox.path("out/chart.csv")).unwrap();
    assert!(table.contains(&format!("\n'@line,2026-01-31,0.0,10.0,'{formula},")), "{table}");
}
