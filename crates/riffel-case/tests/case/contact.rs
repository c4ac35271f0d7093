//! Contact theories from keys to response.

use riffel_case::{Case, NOMINAL_CASE};
use riffel_keys::CaseError;

fn case(overrides: &[&str]) -> Result<Case, CaseError> {
    // A coarse grid: these tests ask whether, not how well.
    let overrides = [&["contact.grid=16"], overrides].concat();
    crate::parsed(NOMINAL_CASE, &overrides)
}

#[test]
fn every_creep_law_takes_either_mean_state() {
    for law in ["carter-3d", "carter-2d", "johnson-vermeulen", "shen-hedrick-elkins", "polach", "fastsim", "half-space"]
    {
        let law = format!("contact.creep_law={law}");
        for mean in ["contact.tractive_ratio=0.3", "contact.creepage=0.1 %"] {
            for response in ["contact.response=quasi-static", "contact.response=spring-dashpot"] {
                let case = case(&[&law, mean, response]).unwrap();
                let ratio = case.steady.tractive_ratio();
                assert!((0.2..0.5).contains(&ratio), "{law} {mean}: {ratio}");
                let state = case.feedback.at(0.05, 20.0);
                assert!(state.growth_rate.is_finite());
            }
        }
    }
}

/// A non-steady response brings the exact theory with it, ellipse included, and answers late.
#[test]
fn non_steady_is_exact() {
    let case = case(&["contact.response=non-steady"]).unwrap();
    assert!(case.law.is_none());
    assert!((1e3 * case.hertz.semi_axis_longitudinal() - 5.9437).abs() < 1e-3);
    let state = case.feedback.at(0.05, 20.0);
    assert!(state.response.by_longitudinal.force[0].im != 0.0);
    assert!(state.growth_rate > 0.0, "at 400 Hz");
    let paper = self::case(&[]).unwrap();
    assert!((1e3 * paper.hertz.semi_axis_longitudinal() - 5.986).abs() < 1e-3);
}

const FALLING: [&str; 6] = [
    "contact.creep_law=polach",
    "contact.polach.limit_friction_ratio=0.4",
    "contact.polach.friction_decay=0.6 s/m",
    "contact.polach.speed=72 km/h",
    "contact.polach.adhesion_reduction=0.7",
    "contact.polach.slip_reduction=0.3",
];

/// The slope in the loop is that of Polach's formula (2005, equations 1–6), written out here and
/// differenced over ±1e-4 of the creepage, whose error is 1e-8.
#[test]
fn falling_friction_reaches_the_loop() {
    let case = case(&FALLING).unwrap();
    let (hertz, load) = (case.hertz, 50e3);
    let kalker = case.creep_laws().unwrap().kalker;
    let stiffness =
        hertz.material().shear_modulus() * hertz.semi_axis_longitudinal() * hertz.semi_axis_lateral() * kalker.c11;
    let force = |creepage: f64| {
        let friction = 0.4 * (0.6 * (-0.6 * 20.0 * creepage).exp() + 0.4);
        let epsilon = std::f64::consts::PI * stiffness * creepage / (4.0 * friction * load);
        let (adhesion, slip) = (0.7 * epsilon, 0.3 * epsilon);
        let curve = adhesion / (1.0 + adhesion * adhesion) + slip.atan();
        2.0 * friction * load / std::f64::consts::PI * curve
    };
    let creepage = case.steady.creepages.longitudinal;
    // The tractive ratio of the nominal case is over the friction at rest.
    assert!((force(creepage) / (0.1 * 0.4 * load) - 1.0).abs() < 1e-9);
    let step = 1e-4 * creepage;
    let slope = (force(creepage + step) - force(creepage - step)) / (2.0 * step);
    let state = case.feedback.at(0.05, 25.0);
    let by_creepage = state.response.by_longitudinal.force[0];
    assert!((by_creepage.re / slope - 1.0).abs() < 1e-6);
    assert!(
        case.remarks
            .iter()
            .any(|remark| { remark.to_string().contains("falling friction is that of the slip at 20 m/s") })
    );
    let dry = self::case(&FALLING[..1]).unwrap().feedback.at(0.05, 25.0);
    assert!(state.growth_rate != dry.growth_rate);
}

/// Factors of one, and friction that does not fall, are what no table means.
#[test]
fn a_clean_contact_needs_no_table() {
    let growth = |overrides: &[&str]| {
        let overrides = [&FALLING[..1], overrides].concat();
        case(&overrides).unwrap().feedback.at(0.05, 20.0).growth_rate
    };
    let none = growth(&[]);
    assert_eq!(growth(&["contact.polach.slip_reduction=1"]), none);
    let constant =
        ["contact.polach.limit_friction_ratio=1", "contact.polach.friction_decay=0.6", "contact.polach.speed=20"];
    assert_eq!(growth(&constant), none);
}

/// A non-steady contact is tabulated over the window of the map; a point outside it has an answer too,
/// the same as in a wider window.
#[test]
fn a_point_outside_the_window_is_covered() {
    let narrow = case(&["contact.response=non-steady"]).unwrap();
    assert!(narrow.feedback.at(0.15, 30.0).growth_rate.is_nan());
    let covering = narrow.covering(0.15, 0.15).unwrap();
    assert_eq!(covering.wavelength.max(), 0.08);
    let wide = case(&["contact.response=non-steady", "map.wavelength.max=150 mm"]).unwrap();
    let growth = |case: &Case| case.feedback.at(0.15, 30.0).growth_rate;
    assert_eq!(growth(&covering), growth(&wide));
    assert!(narrow.covering(1e-3, 0.05).is_err());
}

#[test]
fn unlike_radii_are_worth_a_remark() {
    let remarks = |overrides: &[&str]| {
        let remarks = case(overrides).unwrap().remarks;
        remarks.iter().map(ToString::to_string).collect::<String>()
    };
    let words = "the closed form of the contact ellipse is";
    assert!(remarks(&["contact.transverse_radius=30 m"]).contains(words));
    assert!(!remarks(&["contact.transverse_radius=30 m", "contact.hertz=exact"]).contains(words));
    assert!(!remarks(&[]).contains(words));
}

/// Where all slips, the exact contact lays down its load through the filter of the ellipse, F = sin(ka)/(ka): but for what the surfaces yield, which
/// is late and falls as one over the creepage, 0.06 at 2 %, and the grid.
#[test]
fn the_exact_contact_slides_everywhere() {
    let case = case(&["contact.response=non-steady", "contact.creepage=2 %", "contact.grid=32"]).unwrap();
    let state = case.feedback.at(0.0557, 30.0);
    let steady = case.feedback.steady();
    let z = std::f64::consts::TAU / 0.0557 * case.hertz.semi_axis_longitudinal();
    let share = state.response.by_load.at_rail(0.0) * steady.normal_force / steady.energy_per_metre();
    assert!((share - z.sin() / z).norm() < 0.08, "{share} {}", z.sin() / z);
    assert!(state.response.by_longitudinal.force[0].norm() * 0.02 < 1e-3 * steady.forces.magnitude());
}

#[test]
fn bad_contacts() {
    for row in [
        "contact.polach.slip_reduction=0.3; contact.polach.adhesion_reduction=0.2 => `contact.polach.slip_reduction` is 0.3, but must be at most contact.polach.adhesion_reduction, 0.2",
        "contact.polach.adhesion_reduction=0 => `contact.polach.adhesion_reduction` is 0, but must be between 0.001 and 1",
        "contact.polach.friction_decay=0.6 s/m => `contact.polach.limit_friction_ratio` is missing",
        "contact.polach.limit_friction_ratio=0.4; contact.polach.friction_decay=0.6 => `contact.polach.speed` is missing",
        "contact.polach.limit_friction_ratio=1.4; contact.polach.friction_decay=0.6; contact.polach.speed=20 => `contact.polach.limit_friction_ratio` is 1.4, but must be between 0.001 and 1",
        "contact.polach.limit_friction_ratio=0.4; contact.polach.friction_decay=-1; contact.polach.speed=20 => `contact.polach.friction_decay` is -1 s/m, but must be between 0 s/m and 1000 s/m",
        "contact.polach.limit_friction_ratio=0.4; contact.polach.friction_decay=1; contact.polach.speed=0 => `contact.polach.speed` is 0 m/s, but must be between 0.01 m/s and 200 m/s",
        "contact.polach.friction_decay=0.6 m/s => not a decay over slip velocity in s/m",
        "contact.polach.limit=0.4 => `contact.polach.limit` is not a key Riffel knows",
        "contact.creep_law=polach; contact.polach.limit_friction_ratio=0.4; contact.polach.friction_decay=0.6; contact.polach.speed=20; contact.tractive_ratio=0.99 => `contact.tractive_ratio`: tractive ratio is 0.99, but must stay below the maximum of adhesion of the creep law at 0.9",
        "contact.response=non-steady; contact.creep_law=fastsim => exclude each other",
        "contact.creep_law=fastsim; contact.creepage=2 % => full slip begins at",
        "contact.creep_law=half-space; contact.tractive_ratio=1 => must be between 1e-6 and 0.999999",
        "contact.creep_law=half-space; contact.grid=17 => `contact.grid` is 17, but must be an even number from 16 to 200",
        "contact.creep_law=half-space; contact.grid=14 => `contact.grid` is 14, but must be an even number from 16 to 200",
        "contact.response=non-steady; map.wavelength.min=2 mm => `map.wavelength.min`: wavelength is 0.002 m, but must be at least six elements",
        "contact.transverse_radius=10 km => `contact.transverse_radius`: ratio of the combined curvatures is 21739.1, ",
        "contact.hertz=exact; contact.transverse_radius=10 km => beyond that the contact is a line contact",
        "contact.transverse_radius=10 um => `contact.transverse_radius` is 10 um, but must be between 1 mm and 10000 m",
        "contact.creep_law=fastsim; steel.poisson_ratio=-0.2 => `steel.poisson_ratio`: Poisson's ratio is -0.2, but must lie between 0 and 0.5",
        "contact.normal_load=-50 kN => `contact.normal_load` is -50 kN, but must be between 1 N and 2 MN",
        "contact.hertz=exact; contact.normal_load=0 => `contact.normal_load` is 0 N",
        "contact.creep_law=polache => did you mean polach?",
    ] {
        let (overrides, sentence) = row.split_once(" => ").unwrap();
        let overrides: Vec<&str> = overrides.split("; ").collect();
        let error = case(&overrides).err().expect("a case with a mistake").to_string();
        assert!(error.contains(sentence), "{error}");
    }
}
