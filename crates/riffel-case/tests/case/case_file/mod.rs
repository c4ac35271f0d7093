//! Case files, good and bad.

mod window;

use miette::Diagnostic;
use proptest::prelude::*;
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};
use riffel_keys::CaseError;

use crate::fixtures::{edits, mutated};

fn parse(text: &str) -> Result<Case, CaseError> {
    Case::parse("case.toml", text, &[])
}

/// The nominal case with one piece of its text replaced.
fn edited(piece: &str, replacement: &str) -> String {
    assert!(NOMINAL_CASE.contains(piece), "{piece}");
    NOMINAL_CASE.replacen(piece, replacement, 1)
}

/// The error of a text, which must be one, and the piece of text it points at.
fn error(text: &str) -> (CaseError, Option<String>) {
    let error = parse(text).err().expect("this case must be refused");
    let label = error
        .labels()
        .and_then(|mut labels| labels.next())
        .map(|label| text[label.offset()..label.offset() + label.len()].to_owned());
    (error, label)
}

#[test]
fn cases_of_the_repository_are_valid() {
    for text in [NOMINAL_CASE, BHASKAR_TRACK_CASE] {
        assert!(parse(text).is_ok());
    }
}

/// What a case writes after defaults and presets reads back as the same case.
#[test]
fn completed_case_reads_back() {
    for text in [NOMINAL_CASE, BHASKAR_TRACK_CASE] {
        let case = parse(text).unwrap();
        let written = toml::to_string(&case.file).unwrap();
        let again = parse(&written).unwrap();
        assert_eq!(again.file, case.file);
        assert_eq!(again.feedback.at(0.05, 20.0), case.feedback.at(0.05, 20.0));
    }
}

/// A case that was written is the same elsewhere, and goes on with the same errors.
#[test]
fn a_portable_case_is_restored() -> Result<(), CaseError> {
    let overrides = ["contact.friction=0.35", "wheel.mass=600 kg"].map(str::to_owned);
    let case = Case::parse("mine.toml", NOMINAL_CASE, &overrides)?;
    let again = riffel_case::PortableCase::of(&case).restore(None, None)?;
    assert_eq!(again.file, case.file);
    assert_eq!(again.remarks, case.remarks);
    assert_eq!(again.feedback.at(0.05, 20.0), case.feedback.at(0.05, 20.0));
    assert_eq!(riffel_case::PortableCase::of(&again), riffel_case::PortableCase::of(&case));
    assert!(riffel_case::PortableCase::of(&case).folder.is_some_and(|f| f.is_absolute()));
    for wrong in ["contact.normal_load=0", "rail.section=none", "contact=3"] {
        let refused = |case: &Case| {
            let error = case.with(&[wrong.to_owned()][..]).err();
            error.expect("this must be refused").in_words()
        };
        assert_eq!(refused(&again), refused(&case), "{wrong}");
    }
    Ok(())
}

/// Every kind of mistake: what is written instead of what, the message, and where it points.
#[test]
fn mistakes_are_named_and_shown() {
    for (piece, replacement, message, shown) in [
        ("\"50 kN\"", "\"50 kg\"", "`contact.normal_load`: \"50 kg\" is in kg, not a force in N", "\"50 kg\""),
        ("\"350 kg\"", "\"heavy\"", "`wheel.mass`: \"heavy\" does not begin with a number", "\"heavy\""),
        ("friction = 0.4", "friction = nan", "NaN is not finite", "nan"),
        ("friction = 0.4", "friction = inf", "inf is not finite", "inf"),
        ("friction = 0.4", "friction = [0.4]", "`contact.friction` is a list, but must be a ratio", "[0.4]"),
        (
            "friction = 0.4",
            "friction = 0.4\ncreep_law = 3",
            "`contact.creep_law` is 3, but must be a text in quotes",
            "3",
        ),
        ("friction = 0.4", "frction = 0.4", "`contact.frction` is not a key Riffel knows", "0.4"),
        ("[wear]", "[weer]", "`weer` is not a key Riffel knows", "weer"),
        ("normal_load = \"50 kN\"", "", "`contact.normal_load` is missing", "contact"),
        ("[track]\nmodel = \"free-beam\"", "", "`track` is missing", ""),
        ("\"350 kg\"", "\"-350 kg\"", "`wheel.mass` is -350 kg, but must be between 10 g and 100 t", "\"-350 kg\""),
        ("\"460 mm\"", "0", "`wheel.rolling_radius` is 0 m, but must be between 5 mm and 5 m", "0"),
        ("friction = 0.4", "friction = 0", "`contact.friction` is 0, but must be between 0.001 and 1.5", "0"),
        (
            "poisson_ratio = 0.3",
            "poisson_ratio = 0.5",
            "`steel.poisson_ratio` is 0.5, but must be between -0.9 and 0.499",
            "0.5",
        ),
        (
            "tractive_ratio = 0.1",
            "tractive_ratio = 0",
            "`contact.tractive_ratio` is 0, but must be between 1e-6 and 0.999999",
            "0",
        ),
        (
            "tractive_ratio = 0.1",
            "tractive_ratio = 1.0",
            "`contact.tractive_ratio` is 1, but must be between 1e-6 and 0.999999",
            "1.0",
        ),
        (
            "tractive_ratio = 0.1",
            "creepage = \"0.8 %\"",
            "creepage is 0.8000 %, but full slip begins at 0.7036 %",
            "\"0.8 %\"",
        ),
        (
            "tractive_ratio = 0.1",
            "tractive_ratio = 0.1\ncreepage = 0.004",
            "`contact.creepage` and `contact.tractive_ratio` exclude each other",
            "0.004",
        ),
        ("tractive_ratio = 0.1", "", "`contact.tractive_ratio` is missing", "contact"),
        ("\"free-beam\"", "\"fre-beam\"", "`track.model`: \"fre-beam\" is not one of its choices", "\"fre-beam\""),
        ("\"free-beam\"", "\"two-layer\"", "`track.support_spacing` is missing", "track"),
        ("\"BS113A\"", "\"BS113B\"", "`rail.section` is \"BS113B\", but no rail preset has that name", "\"BS113B\""),
        ("section = \"BS113A\"", "mass_per_length = 56", "`rail.second_moment` is missing", "rail"),
        ("max = \"80 mm\"", "max = \"20 mm\"", "`map.wavelength.max` is 0.02 m, but the window is empty", "\"20 mm\""),
        ("points = 241", "points = 1", "`map.wavelength.points` is 1, but must be between 2 and 100000", "1"),
        ("points = 241", "points = 1000000000", "`map.wavelength.points` is 1000000000, but must be", "1000000000"),
        (
            "points = 241",
            "points = -3",
            "`map.wavelength.points` is -3, but must be a whole number, zero or more",
            "-3",
        ),
        ("friction = 0.4", "friction = ", "not valid TOML", ""),
        (
            "[wear]\ncoefficient = \"2.5e-9 kg/J\"",
            "[corrugation.wear]",
            "`corrugation.wear` is not a key Riffel knows",
            "wear",
        ),
    ] {
        let (error, label) = error(&edited(piece, replacement));
        assert!(error.to_string().contains(message), "{error}");
        assert_eq!(label.unwrap_or_default(), shown, "{error}");
    }
}

/// A value out of its range is refused also where the model in use does not need it.
#[test]
fn unused_values_are_checked() {
    for row in [
        "track.pad.stiffness=-1 => `track.pad.stiffness` is -1 N/m",
        "track.rail_damping=-1 => `track.rail_damping` is -1 N s/m2",
        "track.support_spacing=0 => `track.support_spacing` is 0 m",
        "wheel.inertia=-1 => `wheel.inertia` is -1 kg m2",
    ] {
        let (assignment, message) = row.split_once(" => ").unwrap();
        let overrides = ["wheel.rotation=constant-creepage", assignment].map(str::to_owned);
        let error = Case::parse("case.toml", NOMINAL_CASE, &overrides).err();
        let error = error.expect("out of range").to_string();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn a_mistyped_key_is_put_right() {
    let (error, _) = error(&edited("friction = 0.4", "frction = 0.4"));
    let help = error.help().map(|help| help.to_string()).unwrap_or_default();
    assert!(help.starts_with("did you mean friction?"), "{help}");
}

#[test]
fn a_load_that_outruns_its_waves_is_refused() {
    // A rail that bends easily is outrun by long waves at high speeds.
    let overrides =
        ["track.model=moving-beam", "rail.second_moment=1e-6 m4", "map.wavelength.max=10 m", "map.speed.max=180 m/s"];
    let error = Case::parse("case.toml", NOMINAL_CASE, &overrides.map(str::to_owned)).err();
    let error = error.expect("supercritical").to_string();
    assert!(error.contains("`map`: a load of wavelength 10 m outruns"), "{error}");
}

#[test]
fn overrides_replace_values_and_exclusive_keys() {
    let case = |overrides: &[&str]| crate::parsed(NOMINAL_CASE, overrides).unwrap();
    assert_eq!(case(&["contact.friction=0.3"]).steady.friction, 0.3);
    assert_eq!(case(&["contact.normal_load=60 kN"]).hertz.normal_force(), 60e3);
    // The case gives a tractive ratio; a creepage on the command line takes its place.
    assert_eq!(case(&["contact.creepage=0.4 %"]).steady.creepages.longitudinal, 0.004);
    assert_eq!(case(&["contact.friction=0.3", "contact.friction=0.2"]).steady.friction, 0.2);
}

#[test]
fn a_written_value_goes_before_that_of_the_preset() {
    let case = crate::case(BHASKAR_TRACK_CASE, &["track.pad.stiffness=100 MN/m"]);
    let pad = case.file.track.pad.unwrap();
    assert_eq!(pad.stiffness.unwrap().si(), 100e6);
    assert_eq!(pad.damping.unwrap().si(), 20e3);
}

#[test]
fn the_schema_knows_every_key() {
    let schema = serde_json::to_value(riffel_case::json_schema()).unwrap();
    let properties = schema["properties"].as_object().unwrap();
    for key in ["title", "steel", "wheel", "rail", "track", "contact", "corrugation", "wear", "map"] {
        assert!(properties.contains_key(key), "{key}");
    }
    assert_eq!(schema["additionalProperties"], false);
    assert_eq!(schema["$defs"]["Contact"]["properties"]["normal_load"]["unit"], "N");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// Fuzzed case files: whatever is cut from or put into a valid file, the reader answers with a
    /// case or an error and never panics; a case it accepts can be computed.
    // Long: computes the loop of every fuzzed case that is read.
    #[test]
    fn fuzz_case_file(
        edits in edits(),
    ) {
        let text = mutated(BHASKAR_TRACK_CASE, &edits);
        match parse(&text) {
            Ok(case) => {
                let state = case.feedback.at(case.wavelength.min(), case.speed.min());
                prop_assert!(!state.normal_force().is_nan());
            }
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }

    /// Fuzzed overrides: the same.
    // Long: reads some hundred fuzzed cases.
    #[test]
    fn fuzz_override(assignment in "[a-z._]{0,24}=?[ -~µ]{0,16}") {
        let _ = Case::parse("case.toml", NOMINAL_CASE, &[assignment]);
    }
}
