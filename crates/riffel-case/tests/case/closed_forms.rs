//! Cases that must grow alike, and numbers of the paper's case worked out by hand.

use riffel::Complex64;
use riffel_case::{Case, NOMINAL_CASE};

use crate::case;

/// Equal but for a share.
fn alike(one: f64, other: f64, share: f64) {
    assert!((one - other).abs() <= share * other.abs(), "{one} {other}");
}

/// Growth rates per passage of all contacts that have one, and of the mean.
fn growth(case: &Case, wavelength: f64, speed: f64) -> Vec<f64> {
    let state = case.feedback.at(wavelength, speed);
    let contacts = &state.contacts;
    let rates = contacts.iter().filter_map(|contact| contact.growth_rate);
    rates.chain([state.growth_rate]).collect()
}

/// What is turned over from left to right grows alike: the rail under study, a gear off the middle of the axle, lateral
/// creepage and spin, the offset of the contact on a rail that twists.
#[test]
fn a_case_in_the_mirror_grows_alike() {
    for opposite in ["smooth", "in-phase", "absent"] {
        let text = include_str!("../../cases/curve.toml");
        let [right, left] = [("right", 1.0), ("left", -1.0)].map(|(rail, sign)| {
            let wheel = "mass = 350, polar_inertia = 42, diametral_inertia = 21.5";
            let discs = format!(
                "wheelset.discs=[{{ position = -0.75, {wheel} }}, {{ position = 0.75, {wheel} }}, \
             {{ position = {}, mass = 200, polar_inertia = 15, diametral_inertia = 8 }}]",
                0.4 * sign
            );
            let creepage =
                format!("contact.creepage={{ longitudinal = 1e-3, lateral = {}, spin = {} }}", 2e-3 * sign, 0.1 * sign);
            let overrides = [
                format!("wheelset.rail={rail}"),
                format!("wheelset.opposite_rail={opposite}"),
                format!("contact.lateral_offset={}", 0.01 * sign),
                discs,
                creepage,
                "contact.contact_angle=4 deg".to_owned(),
                "contact.creep_law=fastsim".to_owned(),
            ];
            Case::parse("curve.toml", text, &overrides).unwrap()
        });
        for (wavelength, speed) in [(0.04, 8.0), (0.06, 8.0), (0.1, 12.0)] {
            let (one, other) = (growth(&right, wavelength, speed), growth(&left, wavelength, speed));
            assert_eq!(one.len(), other.len());
            for (one, other) in one.into_iter().zip(other) {
                assert!(one != 0.0);
                // Rounding of the wheelset's receptances from its two ends, which differ beside a resonance.
                alike(one, other, 1e-8);
            }
        }
    }
}

/// Twice the wear, twice the growth. All stiffnesses, dampings, masses and loads s times as large leave creepages, P₁/P₀ and Ŵ₁
/// and make growth s times as fast: energy is s times as much.
#[test]
fn growth_goes_with_the_scale_of_forces() {
    let scaled = |s: f64, wear: f64| {
        let text = format!(
            "[steel]\nyoungs_modulus = {}\npoisson_ratio = 0.3\n\
             [wheel]\nrolling_radius = 0.46\nmass = {}\n\
             [rail]\nmass_per_length = {}\nsecond_moment = 3e-5\narea = 7.67e-3\nshear_coefficient = 0.4\ndensity = {}\n\
             loss_factor = 0.02\n\
             [track]\nmodel = \"two-layer-periodic\"\nsupport_spacing = 0.6\nsleeper = {{ mass = {} }}\n\
             pad = {{ stiffness = {}, damping = {} }}\nballast = {{ stiffness = {}, damping = {} }}\n\
             [contact]\ntransverse_radius = 0.3\nnormal_load = {}\nfriction = 0.35\ntractive_ratio = 0.3\n\
             [wear]\ncoefficient = {}\n",
            207e9 * s,
            350.0 * s,
            60.0 * s,
            7850.0 * s,
            162.0 * s,
            300e6 * s,
            30e3 * s,
            50e6 * s,
            40e3 * s,
            60e3 * s,
            2.5e-9 * wear,
        );
        let case = case(&text, &[]);
        let state = case.feedback.at(0.06, 30.0);
        (case.steady.creepages.longitudinal, state.normal_force(), state.normalized_dissipation, state.growth_rate)
    };
    let one = scaled(1.0, 1.0);
    alike(scaled(1.0, 2.0).3, 2.0 * one.3, 1e-14);
    for s in [0.7, 1.8] {
        let other = scaled(s, 1.0);
        alike(other.0, one.0, 1e-12);
        assert!((other.1 / s - one.1).norm() < 1e-9 * one.1.norm());
        assert!((other.2 - one.2).norm() < 1e-9 * one.2.norm());
        alike(other.3, s * one.3, 1e-8);
    }
}

/// Two wheels 2.5 m apart on the paper's rail, which is free and without loss: Ŵ₁ of both at 30 m/s and of their mean over the
/// comb, by two equations with H(l) = −(i e^{−ikl} + e^{−kl})/4EIk³ and the derivatives of (5), in another program.
#[test]
fn two_wheels_of_the_paper() {
    let normalized = |comb: &str, wavelength: f64| -> Vec<Complex64> {
        let case = case(NOMINAL_CASE, &["train.wheels=[0, 2.5]", &format!("train.comb={comb}")]);
        let state = case.feedback.at(wavelength, 30.0);
        let contacts = state.contacts.iter();
        let unit = case.steady.full_slip_energy_per_metre();
        contacts.map(|contact| contact.energy_at_rail / unit).collect()
    };
    let exact = |parts: [[f64; 2]; 2]| parts.map(|[re, im]| Complex64::new(re, im));
    for (comb, wavelength, expected) in [
        ("resolved", 0.0557, [[-0.013540, -0.006578], [-0.028879, 0.005927]]),
        ("mean", 0.0557, [[-0.014268, 0.008189]; 2]),
        ("mean", 0.04, [[0.043951, 0.024069]; 2]),
        ("mean", 0.08, [[-0.033842, 0.006020]; 2]),
    ] {
        for (got, expected) in normalized(comb, wavelength).into_iter().zip(exact(expected)) {
            // The semi-axis of the place of wear was given by four digits.
            assert!((got - expected).norm() < 5e-5, "{comb} {wavelength} {got} {expected}");
        }
    }
}

/// Lateral receptance of the head of 60E1 on pads of 120 and 40 MN/m, with its mass at the centroid and at the shear centre:
/// modulus \[m/N\] and phase as in the book, to its digits.
#[test]
fn the_centroid_is_where_the_mass_is() {
    for (height, modulus, degrees) in [("33 mm", 1.53e-7, -45.0), ("0", 9.74e-8, -18.0)] {
        let height = format!("rail.centroid_height={height}");
        let text = include_str!("../../cases/curve.toml");
        let case = case(text, &["steel.youngs_modulus=210 GPa", &height]);
        let w = std::f64::consts::TAU * 100.0;
        let [track, _] = case.feedback.receptances(w, 10.0).unwrap();
        let lateral = track[1][1];
        assert!((lateral.norm() / modulus - 1.0).abs() < 5e-3, "{lateral}");
        assert!((lateral.arg().to_degrees() - degrees).abs() < 0.5, "{lateral}");
        assert!(case.remarks.iter().all(|remark| !remark.to_string().contains("usual")));
    }
}
