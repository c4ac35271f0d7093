//! Input that is no record, and arguments that are wrong.

use std::fs;

use super::{check_wave, comma, rail, table, unwrapped, utf_16};
use crate::sandbox::Sandbox;

#[test]
fn files_of_keys_say_where_and_what_they_are() {
    let sandbox = Sandbox::new();
    let case = fs::read_to_string(sandbox.path("cases/nominal.toml")).unwrap();
    let titled = case.replace("title = \"", "title = \"Gleisb\u{f6}gen ");
    let latin: Vec<u8> = titled.chars().filter(char::is_ascii).map(|letter| letter as u8).collect();
    let at = latin.windows(7).position(|word| word == b"Gleisbg").unwrap() + 6;
    let mut latin = latin;
    latin.insert(at, 0xf6);
    fs::write(sandbox.path("latin.toml"), latin).unwrap();
    fs::write(sandbox.path("wide.toml"), utf_16(&case)).unwrap();
    fs::write(sandbox.path("returns.toml"), case.replace('\n', "\r")).unwrap();
    fs::write(sandbox.path("marked.toml"), format!("\u{feff}{case}")).unwrap();
    fs::write(sandbox.path("escape.toml"), case.replace("title = \"", "title = \"\\u001b[2J")).unwrap();
    fs::write(sandbox.path("raw.toml"), case.replace("title = \"", "title = \"\u{1b}[2J")).unwrap();
    fs::write(sandbox.path("large.toml"), vec![b'\n'; (16 << 20) + 1]).unwrap();
    for (name, words) in [
        ("latin.toml", "it looks like Windows-1252, where it is \"ö\""),
        ("latin.toml", "latin.toml, line"),
        ("wide.toml", "is text in UTF-16, but a case file must be UTF-8"),
        ("escape.toml", "`title` is a text with the control character '\\u{1b}'"),
        ("raw.toml", "not valid TOML"),
        ("large.toml", "larger than 16 MiB"),
    ] {
        let outcome = sandbox.riffel(&format!("map {name}"));
        assert_eq!(outcome.status, Some(2), "{name}: {}", outcome.text);
        let text = unwrapped(&outcome.text);
        assert!(text.contains(words), "{name}: {text}");
        assert!(!text.contains('\u{1b}'), "{name}: {text:?}");
    }
    for name in ["returns.toml", "marked.toml"] {
        let outcome = sandbox.riffel(&format!("point {name} --wavelength \"40 mm\" --speed \"100 km/h\""));
        assert_eq!(outcome.status, Some(0), "{name}: {}", outcome.text);
    }
    let heading = "x m,\u{1b}[2Jz um\n";
    fs::write(sandbox.path("rail.csv"), table(heading, &rail(), |x, h| format!("{x:.3},{:.4}", 1e6 * h))).unwrap();
    let outcome = sandbox.riffel("roughness rail.csv -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(!outcome.text.contains('\u{1b}'), "{:?}", outcome.text);
}

/// Names of files, values of `--set` and words of files reach a message as characters that can be seen.
#[cfg(unix)]
#[test]
fn no_message_holds_control_characters() {
    let sandbox = Sandbox::new();
    let name = "a\tb\u{1b}[31m\u{7f}.toml";
    let case = fs::read_to_string(sandbox.path("cases/discrete-supports.toml")).unwrap();
    fs::write(sandbox.path(name), "no case\n").unwrap();
    let preset = case.replace("preset = \"", "preset = \"a\\tb");
    assert_ne!(case, preset);
    fs::write(sandbox.path("preset.toml"), preset).unwrap();
    for (words, said) in [
        (vec!["map", "\u{1b}[31m\t.toml"], "\\u{1b}[31m\\t.toml"),
        (vec!["map", name], "a\\tb\\u{1b}[31m\\u{7f}.toml"),
        (vec!["map", "preset.toml"], "a\\tb"),
        (vec!["roughness", name], "a\\tb\\u{1b}[31m\\u{7f}.toml"),
        (vec!["map", "cases/nominal.toml", "--set", "contact.friction=a\tb\u{1b}[31m"], "a\\tb\\u{1b}[31m"),
        (vec!["map", "cases/nominal.toml", "--set", "contact.fri\u{9b}ction=0.3"], "fri\\u{9b}ction"),
        (vec!["map", "cases/nominal.toml", "-o", "cases/nominal.toml/\u{1b}[31m"], "\\u{1b}[31m"),
        (vec!["init", name], "a\\tb\\u{1b}[31m\\u{7f}.toml"),
        (vec!["map", "--\u{1b}[31mfast"], "--"),
        (vec!["\u{1b}[31m\tmap"], "map"),
        (vec!["point", "cases/nominal.toml", "--speed", "\u{1b}]0;a\tb"], "--speed"),
    ] {
        let output = sandbox.command().args(&words).output().unwrap();
        let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert_eq!(output.status.code(), Some(2), "{words:?}: {text}");
        assert!(unwrapped(&text).contains(said), "{words:?}: {text}");
        let control = text.chars().find(|c| c.is_control() && *c != '\n');
        assert_eq!(control, None, "{words:?}: {text:?}");
    }
}

/// A device that never ends, as any file: a sentence after some megabytes.
#[cfg(unix)]
#[test]
fn endless_input_ends() {
    let sandbox = Sandbox::new();
    for arguments in [
        "map /dev/zero",
        "roughness /dev/zero",
        "roughness --synthesise /dev/zero",
        "roughness cases/roughness-recipe.toml --format /dev/zero",
        "roughness cases/roughness-recipe.toml --limit /dev/zero.toml",
        "map cases/nominal.toml --observations /dev/zero",
        "forecast cases/nominal.toml --spectrum /dev/zero --traffic cases/traffic.toml",
        "forecast cases/nominal.toml --spectrum /dev/zero --traffic /dev/zero",
        "compare cases/nominal.toml --with /dev/zero",
        "report --site /dev/zero --roughness /dev/zero",
        "diagnose cases/nominal.toml --roughness /dev/urandom",
        "study /dev/zero",
    ] {
        let outcome = sandbox.riffel(arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(!outcome.text.contains("panicked"), "{arguments}: {}", outcome.text);
    }
    let line = vec![b'1'; 3 << 20];
    fs::write(sandbox.path("line.txt"), line).unwrap();
    assert_eq!(sandbox.riffel("roughness line.txt").status, Some(2));
}

/// What stands in the way of a position is named.
// Long: reads a record under every heading.
#[test]
fn tables_without_a_position_say_what_they_have() {
    let sandbox = Sandbox::new();
    let rail = rail();
    let rows = |heading: &str, row: &dyn Fn(usize, f64) -> String| {
        let rows = rail.iter().enumerate();
        let rows = rows.map(|(index, &(_, height))| row(index, 1e6 * height) + "\n");
        format!("{heading}\n{}", rows.collect::<String>())
    };
    let counted = |index: usize, height: f64| format!("{index},{height:.4},{:.4}", height + 1.0);
    let timed = |index: usize, height: f64| format!("{:.3},{height:.4}", 1e-3 * index as f64);
    let commas = |index: usize, height: f64| comma(format!("{:.3};{height:.4}", 1e-3 * index as f64)).replace(';', ",");
    for (text, part) in [
        (rows("sample,left_um,right_um", &counted), "column 1, \"sample\", is a counter or a time"),
        (rows("time_s,left_um", &timed), "column 1, \"time_s\", is a counter or a time"),
        (rows("Zeit [s],Hoehe [um]", &timed), "column 1, \"Zeit [s]\", is a counter or a time"),
        (rows("x_m,left_um", &commas), "line 2: has 4 columns, but its head has 2"),
    ] {
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        let outcome = sandbox.riffel("roughness rail.csv");
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{sentence}");
        assert!(sentence.contains(part), "{sentence}");
    }
    let text = rows("sample,left_um", &|index, height| format!("{index},{height:.4}"));
    fs::write(sandbox.path("rail.csv"), text).unwrap();
    let document = sandbox.json("roughness rail.csv --spacing \"1 mm\" --json");
    check_wave(&document, "a counter and the spacing");
}

#[test]
fn empty_files_are_named() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("empty.toml"), "\n").unwrap();
    for command in [
        "map empty.toml",
        "study empty.toml",
        "forecast cases/nominal.toml --traffic empty.toml --from-limit 3",
        "compare cases/nominal.toml --with empty.toml --traffic cases/traffic.toml",
        "report cases/nominal.toml --site empty.toml",
        "map cases/nominal.toml --observations empty.toml",
        "roughness empty.toml",
    ] {
        let outcome = sandbox.riffel(command);
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{command}: {sentence}");
        assert!(sentence.contains("empty.toml: the file "), "{command}: {sentence}");
    }
}

/// What is wrong on a command line is said in the words of its options.
#[test]
fn wrong_arguments_are_named() {
    let sandbox = Sandbox::new();
    for (command, part) in [
        (
            "point cases/nominal.toml --wavelength \"-55 mm\" --speed \"80 km/h\"",
            "--wavelength is -55 mm, but must be between",
        ),
        ("init nowhere/case.toml", "nowhere/case.toml: there is no folder nowhere"),
        (
            "forecast cases/nominal.toml --traffic cases/traffic.toml",
            "--spectrum is left out, but must be given, or else --ground or --from-",
        ),
    ] {
        let outcome = sandbox.riffel(command);
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{command}: {sentence}");
        assert!(sentence.contains(part), "{command}: {sentence}");
    }
    // Neighbouring speeds are told apart.
    let outcome = sandbox.riffel("map cases/nominal.toml -o out --set 'map.speed={min=\"18 km/h\",max=\"20 km/h\"}'");
    assert!(outcome.text.contains("  18.0 ") && outcome.text.contains("  18.2 "), "{}", outcome.text);
}
