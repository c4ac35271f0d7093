//! Contact theories from keys to response.

use riffel_case::{Case, CaseError, NOMINAL_CASE};
use rstest::rstest;

fn case(overrides: &[&str]) -> Result<Case, CaseError> {
    // A coarse grid: these tests ask whether, not how well.
    let overrides = [&["contact.grid=16"], overrides].concat();
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    Case::parse("case.toml", NOMINAL_CASE, &overrides)
}

#[rstest]
#[case("carter-3d")]
#[case("carter-2d")]
#[case("johnson-vermeulen")]
#[case("shen-hedrick-elkins")]
#[case("polach")]
#[case("fastsim")]
#[case("half-space")]
fn every_creep_law_takes_either_mean_state(#[case] law: &str) {
    let law = format!("contact.creep_law={law}");
    for mean in ["contact.tractive_ratio=0.3", "contact.creepage=0.1 %"] {
        for response in [
            "contact.response=quasi-static",
            "contact.response=spring-dashpot",
        ] {
            let case = case(&[&law, mean, response]).unwrap();
            let ratio = case.steady.tractive_ratio();
            assert!((0.2..0.5).contains(&ratio), "{law} {mean}: {ratio}");
            let state = case.feedback.at(0.05, 20.0);
            assert!(state.growth_rate.is_finite());
        }
    }
}

/// A non-steady response brings the exact theory with it, ellipse included, and answers late.
#[test]
fn non_steady_is_exact() {
    let case = case(&["contact.response=non-steady"]).unwrap();
    assert!(case.carter.is_none());
    assert!((1e3 * case.hertz.semi_axis_longitudinal() - 5.9437).abs() < 1e-3);
    let state = case.feedback.at(0.05, 20.0);
    assert!(state.dq_domega.im != 0.0);
    assert!(state.growth_rate > 0.0, "at 400 Hz");
    let paper = self::case(&[]).unwrap();
    assert!((1e3 * paper.hertz.semi_axis_longitudinal() - 5.986).abs() < 1e-3);
}

#[rstest]
#[case(&["contact.response=non-steady", "contact.creep_law=fastsim"], "exclude each other")]
#[case(&["contact.creep_law=half-space", "contact.creepage=2 %"], "`contact.creepage` is 0.02, but must be so small")]
#[case(&["contact.creep_law=fastsim", "contact.creepage=2 %"], "full slip begins at")]
#[case(&["contact.creep_law=half-space", "contact.tractive_ratio=0.995"], "nearer to full slip there is no slope")]
#[case(&["contact.creep_law=half-space", "contact.grid=17"], "must be even")]
#[case(&["contact.creep_law=half-space", "contact.grid=1000"], "must be between 8 and 200")]
#[case(&["contact.response=non-steady", "map.wavelength.min=2 mm"], "`map.wavelength.min`: wavelength is 0.002 m, but must be at least six elements")]
#[case(&["contact.hertz=exact", "contact.normal_load=0"], "`contact.normal_load` is 0 N")]
#[case(&["contact.creep_law=polache"], "did you mean polach?")]
fn bad_contacts(#[case] overrides: &[&str], #[case] sentence: &str) {
    let error = case(overrides)
        .err()
        .expect("a case with a mistake")
        .to_string();
    assert!(error.contains(sentence), "{error}");
}
