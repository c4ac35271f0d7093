//! The window of the map, and points in it.

use riffel_case::{Case, NOMINAL_CASE};
use riffel_keys::CaseError;

#[test]
fn too_many_points_together() {
    let overrides = ["map.wavelength.points=100000", "map.speed.points=100000"];
    let error = Case::parse("case.toml", NOMINAL_CASE, &overrides.map(str::to_owned)).err();
    let error = error.expect("ten thousand million points").to_string();
    assert!(error.contains("`map`: 100000 wavelengths at 100000 speeds"), "{error}");
}

/// The axes of a map as ranges, in the file and in overrides, which go on to their keys.
#[test]
fn axes_of_the_map_are_read_from_ranges() -> Result<(), CaseError> {
    let text = format!(
        "{}\n[map]\nwavelength = \"25-60 mm\"\nspeed = \"60..90 km/h\"\n",
        NOMINAL_CASE.split("[map]").next().unwrap_or_default()
    );
    let case = crate::parsed(&text, &[])?;
    assert_eq!((case.wavelength.min(), case.wavelength.max()), (0.025, 0.06));
    assert_eq!(case.wavelength.points(), 241);
    assert!((case.speed.min() - 60.0 / 3.6).abs() < 1e-12 && case.speed.max() == 25.0);
    assert_eq!(case.speed.points(), 221);
    let sets = ["map.speed=40 – 70 mph", "map.speed.points=5", "map.wavelength=1e-2-2e-1"];
    let case = Case::parse("case.toml", &text, &sets.map(str::to_owned))?;
    assert_eq!((case.speed.min(), case.speed.points()), (40.0 * 0.44704, 5));
    assert_eq!((case.wavelength.min(), case.wavelength.max()), (0.01, 0.2));
    // What the file says of a written case comes back.
    let again = riffel_case::PortableCase::of(&case).restore(None, None)?;
    assert_eq!(again.file, case.file);
    Ok(())
}

#[test]
fn wrong_ranges_are_refused() {
    for row in [
        "map.speed=60 km/h => `map.speed` is \"60 km/h\", but must be a range as in \"60-90 km/h\"",
        "map.speed=90-60 km/h => `map.speed.max` is 16.666666666666668 m/s, but the window is empty",
        "map.speed=60-90 kg => `map.speed` is \"60-90 kg\", but must be a range",
        "map.wavelength=20-80 =>  m, but must be between 100 µm and 10 m; did you mean ",
        "contact.friction=0.2-0.4 => \"0.2-0.4\" is a range, but one value is needed",
    ] {
        let (set, part) = row.split_once(" => ").unwrap();
        let error = crate::parsed(NOMINAL_CASE, &[set]).err();
        let error = error.expect("a mistake").to_string();
        assert!(error.starts_with(&format!("--set {set}: ")), "{error}");
        assert!(error.contains(part), "{error}");
    }
}

/// What is unusual is computed, and asked about.
#[test]
fn unusual_values_are_remarks() -> Result<(), CaseError> {
    let sets = ["contact.normal_load=5000", "map.speed.max=58"].map(str::to_owned);
    let case = Case::parse("case.toml", NOMINAL_CASE, &sets)?;
    let remarks: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
    for part in [
        "contact.normal_load is 5000 N; usual values are 10 kN to 250 kN",
        "map.speed.max has no unit and is read as 58 m/s = 208.8 km/h (did you mean \"58 km/h\"",
    ] {
        assert!(remarks.iter().any(|remark| remark.starts_with(part)), "{remarks:?}");
    }
    let nominal = crate::parsed(NOMINAL_CASE, &[])?;
    let said = |remark: &riffel_keys::Message| remark.to_string().contains("usual values");
    assert!(!nominal.remarks.iter().any(said));
    Ok(())
}

/// A point outside the window is computed, one outside of physics is not.
#[test]
fn points_are_checked() -> Result<(), CaseError> {
    let case = crate::parsed(NOMINAL_CASE, &[])?;
    assert_eq!(case.point(0.055, 30.0)?, case.feedback.at(0.055, 30.0));
    assert!(case.point(0.5, 80.0)?.growth_rate.is_finite());
    for (wavelength, speed, sentence) in [
        (1e-300, 30.0, "wavelength is"),
        (55.0, 30.0, "wavelength is 55 m, but must be between 100 µm and 10 m"),
        (0.055, 1e9, "speed is 1000000000 m/s, but must be between 0.01 m/s and 200 m/s"),
        (0.055, f64::NAN, "speed is NaN m/s"),
        (0.055, -3.0, "speed is -3 m/s"),
    ] {
        let error = case.point(wavelength, speed).unwrap_err().to_string();
        assert!(error.starts_with(sentence), "{error}");
    }
    Ok(())
}
