//! What one expects of any program: version, completions, manual pages, as much or as little said as wanted.

use std::fs::{self, File};

use crate::sandbox::{Sandbox, number};

#[test]
fn the_version_is_told_with_the_commit_where_it_is_known() {
    let sandbox = Sandbox::new();
    let text = sandbox.riffel("--version").text;
    let rest = text.strip_prefix(concat!("riffel ", env!("CARGO_PKG_VERSION")));
    let rest = rest.unwrap_or_else(|| panic!("{text}")).trim();
    let is_commit = |inside: &str| {
        let (commit, date) = inside.split_once(' ').unwrap();
        commit.len() >= 9 && commit.bytes().all(|b| b.is_ascii_hexdigit()) && date.len() == 10
    };
    let inside = rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    // A package without its repository has no commit.
    assert!(rest.is_empty() || inside.is_some_and(is_commit), "{text}");
}

#[test]
fn shells_complete_every_command() {
    let sandbox = Sandbox::new();
    for shell in ["bash", "zsh", "fish"] {
        let outcome = sandbox.riffel(&format!("completions {shell}"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
        for word in ["receptance", "sensitivity", "observations"] {
            assert!(outcome.text.contains(word), "{shell} does not know {word}");
        }
    }
    assert_eq!(sandbox.riffel("completions tcsh").status, Some(2));
}

/// A number below zero is no option: the sentence names the option and the number.
// Long: compares all models that fit a case, the exact contact among them.
#[test]
fn numbers_below_zero_are_refused_by_name() {
    let sandbox = Sandbox::new();
    sandbox.riffel("init --metro metro.toml");
    sandbox.riffel("roughness --synthesise -o rail.csv");
    let levels = "wavelength_mm,level_db\n80,2\n63,1\n50,0\n40,-1\n31.5,-2\n";
    fs::write(sandbox.path("levels.csv"), levels).unwrap();
    for arguments in [
        "noise metro.toml --roughness levels.csv --speed 20 --distance -1",
        "noise metro.toml --roughness levels.csv --speed 20 --wheels -1",
        "diagnose metro.toml --roughness rail.csv --bending -5",
        "roughness rail.csv --longest -2",
        "simulate metro.toml --smooth --speed -3",
        "simulate metro.toml --spectrum iso-3095-2013 --speed 20 --seed -1",
    ] {
        let words: Vec<&str> = arguments.split(' ').collect();
        let (option, value) = (words[words.len() - 2], words[words.len() - 1]);
        let outcome = sandbox.riffel(arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        let said = &outcome.text;
        assert!(said.contains(option) && said.contains(value), "{said}");
        assert!(!said.contains("unexpected argument"), "{said}");
    }
    // What may stand alone takes no option behind it for its value.
    let outcome = sandbox.riffel(
        "compare cases/nominal.toml --models --speed 20 --set map.wavelength.points=7 --set map.speed.points=3 --json",
    );
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
}

#[test]
fn every_command_has_a_manual_page() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel("man -o man");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let pages = sandbox.list("man");
    for page in ["riffel.1", "riffel-map.1", "riffel-study-merge.1"] {
        assert!(pages.contains(&page.to_owned()), "{pages:?}");
    }
    let page = fs::read_to_string(sandbox.path("man/riffel-map.1")).unwrap();
    assert!(page.contains(".TH riffel-map 1"), "{page}");
    assert!(page.contains("observations"), "{page}");
    let first = fs::read_to_string(sandbox.path("man/riffel.1")).unwrap();
    assert_eq!(sandbox.riffel("man").text, first);
}

#[test]
fn presets_are_one_document() {
    let sandbox = Sandbox::new();
    let all = sandbox.json("presets --json");
    assert!(all.as_array().unwrap().len() > 30);
    let one = sandbox.json("presets br-stiff --json");
    assert!(all.as_array().unwrap().contains(&one));
    let pad = &one["values"]["track.pad.stiffness"];
    assert_eq!(number(&pad["value_si"]), 2.8e8);
    assert_eq!(pad["unit_si"], "N/m");
    assert_eq!(pad["badge"], "typical");
    assert!(pad["source"].as_str().unwrap().len() > 20);
}

/// Both streams of a run.
fn streams(sandbox: &Sandbox, arguments: &str) -> (String, String) {
    let mut command = sandbox.command();
    let output = command.args(shlex::split(arguments).unwrap()).output().unwrap();
    assert!(output.status.success(), "{arguments}: {output:?}");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr))
}

#[test]
fn quiet_says_nothing_and_changes_no_result() {
    let sandbox = Sandbox::new();
    let point = "point cases/nominal.toml --wavelength 0.02 --speed 20";
    let (results, notes) = streams(&sandbox, point);
    assert!(notes.starts_with("note: "), "{notes}");
    let (quiet_results, quiet_notes) = streams(&sandbox, &format!("{point} --quiet"));
    assert_eq!((quiet_results, quiet_notes.as_str()), (results, ""));
    let outcome = sandbox.riffel("--quiet point missing.toml --wavelength 0.02 --speed 20");
    assert_eq!(outcome.status, Some(2));
    assert!(outcome.text.contains("missing.toml"), "{}", outcome.text);
}

/// A note is one line; the whole of it is there for whoever asks, and in every document.
#[test]
fn notes_are_short_unless_more_is_wanted() {
    let sandbox = Sandbox::new();
    let point = "point cases/nominal.toml --wavelength 0.02 --speed 20";
    let (_, short) = streams(&sandbox, point);
    let (_, long) = streams(&sandbox, &format!("{point} --verbose"));
    assert_eq!(short.lines().count(), long.lines().count());
    assert!(short.lines().all(|line| line.chars().count() <= 110), "{short}");
    assert!(short.contains("no support"), "{short}");
    assert!(long.contains("pads, sleepers and ballast change its receptance"), "{long}");
    assert!(short.len() < long.len(), "{short}{long}");
    let map = "map cases/nominal.toml -o out --json --set map.wavelength.points=5 --set map.speed.points=4";
    let summary = sandbox.json(map);
    let remarks = summary["remarks"].as_array().unwrap();
    let first = remarks[0].as_str().unwrap();
    assert!(long.contains(first), "{first}");
}

/// A program with a file on its standard input, and what it printed there and its status.
fn piped(sandbox: &Sandbox, file: &str, arguments: &str) -> (String, Option<i32>) {
    let mut command = sandbox.command();
    command.args(shlex::split(arguments).unwrap());
    command.stdin(File::open(sandbox.path(file)).unwrap());
    let output = command.output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    (String::from_utf8(text).unwrap(), output.status.code())
}

#[test]
fn a_dash_is_standard_input() {
    let sandbox = Sandbox::new();
    let at = "--wavelength 0.05 --speed 20 --json";
    let (from_pipe, _) = piped(&sandbox, "cases/nominal.toml", &format!("point - {at}"));
    let from_file = sandbox.riffel(&format!("point cases/nominal.toml {at}")).text;
    assert_eq!(from_pipe, from_file);

    let (text, status) =
        piped(&sandbox, "cases/nominal.toml", "map - --set map.wavelength.points=5 --set map.speed.points=4");
    assert_eq!(status, Some(0), "{text}");
    assert!(sandbox.path("stdin-map/map.csv").exists());

    let made = sandbox.riffel("roughness --synthesise -o profile.csv");
    assert_eq!(made.status, Some(0), "{}", made.text);
    let (from_pipe, status) = piped(&sandbox, "profile.csv", "roughness - --json");
    assert_eq!(status, Some(0), "{from_pipe}");
    assert!(from_pipe.contains("bands"), "{from_pipe}");

    let forecast = "forecast cases/nominal.toml --spectrum profile.csv --traffic - --json";
    let (text, status) = piped(&sandbox, "cases/traffic.toml", forecast);
    assert_eq!(status, Some(0), "{text}");
    let (text, status) = piped(&sandbox, "cases/traffic.toml", "forecast - --spectrum profile.csv --traffic - --json");
    assert_eq!(status, Some(2), "{text}");
    assert!(text.contains("only one file can be -"), "{text}");
}

/// Each case to start from runs as it is written, stands on supports, and finds growth inside its window.
// Long: maps four lines on discrete supports.
#[test]
fn the_cases_to_start_from_run() {
    let sandbox = Sandbox::new();
    for kind in ["metro", "main-line", "tram", "freight"] {
        let outcome = sandbox.riffel(&format!("init --{kind}"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
        assert!(outcome.text.contains(&format!("riffel map {kind}.toml")));
        let less = "--set map.wavelength.points=41 --set map.speed.points=21";
        let summary = sandbox.json(&format!("map {kind}.toml -o {kind} --json {less}"));
        let model = summary["inputs"]["track"]["model"].as_str().unwrap();
        assert!(model.ends_with("-periodic"), "{kind} is on {model}");
        let highest = &summary["ridge"]["highest"];
        assert!(number(&highest["growth_rate_per_passage"]) > 0.0, "{kind}");
        assert_eq!(highest["at_edge"], false, "{kind}: {highest}");
    }
    assert_eq!(sandbox.riffel("init --metro --tram").status, Some(2));
}

/// Whatever the length or the depth of what was written, it is refused in a sentence that fits a screen.
// Long: reads keys of 100 000 letters in every place.
#[test]
fn endless_keys_are_refused_in_few_words() {
    let sandbox = Sandbox::new();
    let case = fs::read_to_string(sandbox.path("cases/nominal.toml")).unwrap();
    let long = "a".repeat(100_000);
    let files = [
        format!("{long} = 1\n{case}"),
        format!("\"{}\" = 1\n{case}", "ä".repeat(100_000)),
        format!("{long}\n{case}"),
        case.replace("[contact]", &format!("[contact]\n{long} = 1")),
        case.replace("friction = 0.4", &format!("friction = \"{long}\"")),
        format!("a{} = 1\n{case}", ".a".repeat(50_000)),
    ];
    let at = "--wavelength 0.05 --speed 20";
    let refused = |arguments: &str| {
        let outcome = sandbox.riffel(arguments);
        let start: String = outcome.text.chars().take(300).collect();
        assert_eq!(outcome.status, Some(2), "{start}");
        assert!(outcome.text.chars().count() < 5000, "{start}");
        assert!(!outcome.text.contains("panicked"), "{start}");
    };
    for text in files {
        fs::write(sandbox.path("long.toml"), text).unwrap();
        refused(&format!("point long.toml {at}"));
    }
    let deep = ".a".repeat(35_000);
    for key in [&long, &format!("contact.{long}"), &format!("a{deep}")] {
        refused(&format!("point cases/nominal.toml {at} --set {key}=1"));
    }
}

/// Errors that go to a file are not broken to the width of the terminal beside it. `script` makes a terminal; on a
/// machine without it there is nothing to try.
#[cfg(target_os = "linux")]
#[test]
fn errors_in_a_file_do_not_know_the_terminal() {
    let sandbox = Sandbox::new();
    let program = env!("CARGO_BIN_EXE_riffel");
    let line = format!(
        "stty cols 30; {program} point cases/nominal.toml --wavelength 0.05 --speed 20 --set contact.friction=-1 2> errors.txt"
    );
    let mut script = std::process::Command::new("script");
    script.current_dir(sandbox.path("."));
    script.args(["-q", "-e", "-c", &line, "typescript"]);
    let Ok(output) = script.output() else {
        return;
    };
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let in_a_file = fs::read_to_string(sandbox.path("errors.txt")).unwrap();
    let arguments = "point cases/nominal.toml --wavelength 0.05 --speed 20 --set contact.friction=-1";
    assert_eq!(in_a_file, sandbox.riffel(arguments).text);
}
