//! A case and its variants side by side.

use riffel::forecast::SpeedDistribution;
use riffel_answers::compare::Comparison;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, NOMINAL_CASE, Variant};
use riffel_keys::CaseError;

fn nominal() -> Case {
    Case::parse("case.toml", NOMINAL_CASE, &[]).unwrap()
}

#[test]
fn wrong_changes_are_refused() {
    for row in [
        " => changes nothing",
        "title = \"empty\"\n => changes nothing",
        "[speed]\nmean = 30\nfactor = 0.8\n => exclude each other",
        "[speed]\nfactor = 0\n => `speed.factor` is 0",
        "[speed]\nfast = 30\n => `speed.fast` is not a key",
        "[contact]\nfriction = -1\n => `contact.friction` is -1",
        "[contact]\nfrction = 0.3\n => did you mean friction",
        "[speed]\nstandard_deviation = 12\n => less than a quarter",
    ] {
        let (text, part) = row.split_once(" => ").unwrap();
        let case = nominal();
        let traffic = Traffic::of_case(SpeedDistribution::single(30.0).unwrap());
        let error = Variant::parse("a.toml", text)
            .and_then(|variant| Comparison::compute(&case, &[variant], &traffic, &|_| Vec::new(), None, &|_| {}))
            .unwrap_err();
        assert!(error.to_string().contains(part), "{error}");
        assert!(!error.to_string().contains("--set"), "{error}");
    }
}

/// A change of the case is what the changed case gives; half the wear takes twice as long.
#[test]
fn variants_are_compared_with_the_case() -> Result<(), CaseError> {
    let case = nominal();
    let traffic = Traffic::of_case(SpeedDistribution::single(30.0).unwrap());
    let friction = Variant::parse("a.toml", "[contact]\nfriction = 0.3\n")?;
    let wear = Variant::parse("b.toml", "title = \"half\"\n[wear]\ncoefficient = 1.25e-9\n")?;
    let slower = Variant::parse("c.toml", "[speed]\nfactor = 0.5\n")?;
    let spectrum = riffel::roughness::Spectrum::new(bands_of(&case).into_iter().map(|band| (band, -8.0))).unwrap();
    let limit = riffel::roughness::LevelLimit::new(spectrum.map(|band| band.level + 6.0).unwrap());
    let compared = Comparison::compute(
        &case,
        &[friction, wear, slower],
        &traffic,
        &|_| vec![spectrum.clone().into()],
        Some(&limit),
        &|_| {},
    )?;
    let [base, friction, wear, slower] = &compared.outcomes[..] else {
        panic!("{} outcomes", compared.outcomes.len());
    };
    let line = 60;
    let wavelength = base.growth.wavelengths()[line];
    let rate = |case: &Case, speed: f64| case.feedback.at(wavelength, speed).growth_rate;
    let changed = case.with(&["contact.friction=0.3".to_owned()][..])?;
    for (outcome, expected) in
        [(base, rate(&case, 30.0)), (friction, rate(&changed, 30.0)), (slower, rate(&case, 15.0))]
    {
        assert!((outcome.growth.rates()[line] / expected - 1.0).abs() < 1e-12);
    }
    assert_eq!(wear.title, "half");
    let ratio = wear.passages_to_limit().unwrap() / base.passages_to_limit().unwrap();
    assert!((ratio - 2.0).abs() < 1e-9, "{ratio}");
    let ridge = base.ridge_frequency.unwrap();
    assert!((530.0..545.0).contains(&ridge), "{ridge}");
    Ok(())
}
