//! `--language`: what is said to a reader is in German, what another program reads stays as it is.

use crate::sandbox::Sandbox;

const POINT: &str = "point cases/nominal.toml --wavelength '40 mm' --speed '80 km/h'";

#[test]
fn a_refused_value_is_told_in_german() {
    let sandbox = Sandbox::new();
    let refused = |language: &str| {
        let outcome = sandbox.riffel(&format!("{POINT} --set contact.friction=3 {language}"));
        assert_eq!(outcome.status, Some(2));
        outcome.sentence()
    };
    let german = refused("--language de");
    let told = "`contact.friction` ist 3, muss aber zwischen 0,001 und 1,5 liegen";
    assert!(german.contains(told), "{german}");
    assert!(refused("").contains("is 3, but must be between 0.001 and 1.5"));
}

#[test]
fn notes_are_german_and_json_is_not() {
    let sandbox = Sandbox::new();
    let text = sandbox.riffel(&format!("--language de {POINT}")).text;
    assert!(
        text.contains("Hinweis: die Schiene liegt nirgends auf"),
        "{text}"
    );
    let english = sandbox.json(&format!("{POINT} --json"));
    let german = sandbox.json(&format!("{POINT} --json --language de"));
    assert_eq!(english, german);
}

#[test]
fn wrong_arguments_help_and_results_are_german() {
    let sandbox = Sandbox::new();
    let said = [
        ("map", "Fehler: diese nötigen Argumente fehlen:"),
        (
            "map nominal.toml --foo",
            "Fehler: unerwartetes Argument '--foo'",
        ),
        (
            "map none.toml",
            "die Falldatei none.toml ist nicht zu lesen: ",
        ),
        (
            "map cases/nominal.toml --bay",
            "Tipp: track.model = \"one-layer-periodic\" oder",
        ),
        (POINT, "40,0 mm bei 80,0 km/h: 555,6 Hz"),
        (POINT, "Rezeptanz der Schiene"),
    ];
    for (command, words) in said {
        let text = sandbox.riffel(&format!("{command} --language de")).text;
        assert!(text.contains(words), "{command}: {text}");
    }
}
