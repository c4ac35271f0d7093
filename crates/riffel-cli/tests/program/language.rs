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
    assert!(text.contains("Hinweis: die Schiene liegt nirgends auf"), "{text}");
    let english = sandbox.json(&format!("{POINT} --json"));
    let german = sandbox.json(&format!("{POINT} --json --language de"));
    assert_eq!(english, german);
}

/// What a case is refused for and what is found are German; the command line is that of the manual, in every language.
#[test]
fn cases_and_findings_are_german_and_the_command_line_is_not() {
    let sandbox = Sandbox::new();
    let said = [
        ("map", "error: the following required arguments"),
        ("map none.toml", "none.toml ist nicht zu lesen: "),
        ("point cases/curve.toml --wavelength '40 mm' --speed '80 km/h' --set curve.radius=0.5", "`curve.speed` fehlt"),
        ("map cases/nominal.toml --set map.wavelength.max=0.001", "`map.wavelength.max` ist 0,001 m"),
        ("map cases/nominal.toml --set contact.normal_load='50 kg'", "\"50 kg\" ist in kg"),
        ("map cases/nominal.toml --set contact.frictoin=0.3", "ist kein Schlüssel"),
    ];
    say_in_german(&sandbox, &said);
}

/// That commands say these words.
fn say_in_german(sandbox: &Sandbox, said: &[(&str, &str)]) {
    for (command, words) in said {
        let text = sandbox.riffel(&format!("{command} --language de")).text;
        assert!(text.contains(words), "{command}: {text}");
    }
}

/// Findings of every command, not of one.
// Long: runs a command of every kind.
#[test]
fn findings_are_german_on_a_terminal() {
    let sandbox = Sandbox::new();
    let sample = sandbox.riffel("roughness --synthesise").text;
    std::fs::write(sandbox.path("rail.csv"), sample).unwrap();
    let said = [
        ("roughness rail.csv", "über der Grenze, 1 von 22 Bändern"),
        ("diagnose cases/metro.toml --roughness rail.csv", "führt mit einem Anteil von 0,"),
        (
            "forecast cases/nominal.toml --traffic cases/traffic.toml --from-limit '-6 dB'",
            "63 mm wächst am schnellsten, um 0,",
        ),
    ];
    say_in_german(&sandbox, &said);
}
