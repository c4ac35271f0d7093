//! Samples and their numbers.

use riffel::{GrowthMap, Ridge};
use riffel_case::traffic::{Traffic, UsualTraffic, bands_of};
use riffel_case::{Variant, ask};
use riffel_study::{ParameterValue, Study};

use crate::{PLAN, study_of};

/// Numbers of an output within those of a sample.
fn of<'a>(study: &Study, values: &'a [f64], name: &str) -> &'a [f64] {
    let mut from = 0;
    for variable in study.outputs().variables() {
        let length = study.outputs().length(variable);
        if variable.name == name {
            return &values[from..from + length];
        }
        from += length;
    }
    panic!("no output {name}")
}

/// A sample has the numbers that the library has for the same case, bit for bit.
#[test]
fn samples_are_what_the_library_computes() {
    let study = study_of(PLAN);
    for index in [0, 7, 22] {
        let sample = study.sample(index);
        let values = sample.outputs.unwrap();
        let overrides: Vec<String> = study
            .parameters()
            .iter()
            .zip(&sample.parameters)
            .map(|(parameter, value)| format!("{}={value}", parameter.key.key))
            .collect();
        let case = study.case.with(&overrides[..]).unwrap();
        let ridge = Ridge::search(&case.feedback, case.wavelength, case.speed);
        let highest = ridge.highest().unwrap();
        assert_eq!(of(&study, &values, "ridge_frequency")[0], ridge.best_fit_frequency().unwrap());
        assert_eq!(of(&study, &values, "highest_growth_rate")[0], highest.growth_rate);
        assert_eq!(of(&study, &values, "highest_growth_wavelength")[0], highest.wavelength);
        let wavelengths: Vec<f64> = ridge.points.iter().map(|point| point.wavelength).collect();
        assert_eq!(of(&study, &values, "ridge_wavelength"), wavelengths);

        let map = GrowthMap::compute(&case.feedback, case.wavelength, case.speed, |_| ());
        let rate = map.growth_rate_per_dissipation();
        let rates: Vec<f64> = map.rows().flat_map(|(_, row)| row).map(|value| rate * value.re).collect();
        assert_eq!(of(&study, &values, "growth_rate"), rates);
        let columns = case.wavelength.points();
        for (place, mean) in of(&study, &values, "mean_growth_rate").iter().enumerate() {
            let expected = (0..5).map(|row| rates[row * columns + place]).sum::<f64>() / 5.0;
            // Summed in another order.
            assert!((mean - expected).abs() <= 1e-14 * expected.abs().max(1e-9));
        }
        // 20–30 mm and 30–80 mm of the window, in steps of 2 mm.
        let means = of(&study, &values, "mean_growth_rate");
        let highest = |range: std::ops::Range<usize>| means[range].iter().copied().fold(f64::MIN, f64::max);
        assert_eq!(of(&study, &values, "band_growth_rate"), [highest(0..5), highest(5..31)]);

        let state = case.feedback.at(0.055, 30.0);
        let force = of(&study, &values, "point_1_normal_force_n");
        assert_eq!(force, [state.normal_force().re, state.normal_force().im]);
        assert_eq!(of(&study, &values, "point_1_growth_rate_per_passage")[0], state.growth_rate);
    }
}

#[test]
fn a_grid_takes_every_combination_in_order() {
    let study = study_of(
        r#"
case = "nominal.toml"
design.method = "grid"
outputs.ridge = true
[[parameter]]
key = "track.model"
values = ["free-beam", "moving-beam"]
[[parameter]]
key = "contact.normal_load"
range = { min = "40 kN", max = "90 kN", points = 3, spacing = "log" }
"#,
    );
    assert_eq!(study.samples(), 6);
    let values: Vec<Vec<ParameterValue>> = (0..6).map(|sample| study.values(sample)).collect();
    for (index, values) in values.iter().enumerate() {
        let model = ["free-beam", "moving-beam"][index / 3];
        assert_eq!(values[0], ParameterValue::Text(model.to_owned()));
        let ParameterValue::Number(load) = values[1] else { panic!("no number") };
        assert!((load - [40e3, 60e3, 90e3][index % 3]).abs() < 1e-9 * load);
    }
}

/// Samples that fail have a sentence and no numbers; the others are not touched.
#[test]
fn failed_samples_say_why() {
    let study = study_of(&PLAN.replace("min = \"200 kg\"", "max = \"900 kg\"").replace("\"40 kg\"", "\"300 kg\""));
    let chunk_of_all: Vec<_> = (0..study.samples()).map(|index| study.sample(index)).collect();
    let failed: Vec<_> = chunk_of_all.iter().filter_map(|sample| sample.outputs.as_ref().err()).collect();
    // Φ(−350/300) = 12 %, cut at 900 kg: three of 23 strata, give or take one.
    assert!((2..=4).contains(&failed.len()), "{failed:?}");
    assert!(failed.iter().all(|sentence| sentence.starts_with("`wheel.mass` is -")), "{failed:?}");
}

/// Correlated parameters keep their distributions, and their scores have the coefficient.
#[test]
fn correlated_parameters_vary_together() {
    let plan = PLAN.replace("latin-hypercube", "sobol").replace("samples = 23", "samples = 4096")
        + "\n[[correlation]]\nbetween = [\"contact.friction\", \"wheel.mass\"]\ncoefficient = -0.6\n";
    let study = study_of(&plan);
    let points: Vec<Vec<f64>> = (0..4096).map(|sample| study.plan.point(sample)).collect();
    for parameter in 0..3 {
        let mean = points.iter().map(|point| point[parameter]).sum::<f64>() / 4096.0;
        assert!((mean - 0.5).abs() < 2e-3, "{mean}");
    }
    let product = points.iter().map(|point| (point[0] - 0.5) * (point[1] - 0.5)).sum::<f64>();
    let rank = 12.0 * product / 4096.0;
    // The rank correlation of a Gaussian copula.
    let expected = 6.0 / std::f64::consts::PI * (-0.3f64).asin();
    assert!((rank - expected).abs() < 0.01, "{rank} {expected}");
}

/// Growth that still rises with the speed at the end of the window is flagged, as one that rises with the wavelength.
#[test]
fn the_highest_growth_may_sit_at_an_end_of_the_speeds() {
    let mut beyond = 0;
    for (slowest, fastest) in [(20, 22), (38, 40)] {
        let window = format!("min = \"{slowest} m/s\", max = \"{fastest} m/s\"");
        let study = study_of(&PLAN.replace("min = \"20 m/s\", max = \"40 m/s\"", &window));
        let sample = study.sample(0);
        let values = sample.outputs.unwrap();
        let speed = of(&study, &values, "highest_growth_speed")[0];
        let wavelengths = [study.case.wavelength.min(), study.case.wavelength.max()];
        let wavelength = of(&study, &values, "highest_growth_wavelength")[0];
        let at_end = [f64::from(slowest), f64::from(fastest)].contains(&speed);
        let at_edge = of(&study, &values, "highest_growth_at_edge")[0];
        assert_eq!(at_edge == 1.0, at_end || wavelengths.contains(&wavelength));
        beyond += i32::from(at_end && !wavelengths.contains(&wavelength));
    }
    // One of the two windows lies on a slope.
    assert!(beyond > 0);
}

/// Growth under a traffic is that of the traffic on the case of the sample.
#[test]
fn growth_under_a_traffic_is_that_of_the_sample() {
    let plan = |outputs: &str| {
        let text = format!(
            "case = \"nominal.toml\"\ndesign.method = \"grid\"\n[[parameter]]\nkey = \"wheel.mass\"\nvalues = [\"300 kg\", \"400 kg\"]\n{outputs}"
        );
        study_of(&text)
    };
    let vehicles = "[[vehicle]]\nname = \"fast\"\nshare = 0.25\nspeed = { mean = 40, standard_deviation = 3 }\n\
                    [[vehicle]]\nname = \"slow\"\nshare = 0.75\nspeed.mean = 25\n";
    let given = Traffic::parse("t.toml", vehicles).unwrap();
    let own = plan(&vehicles.replace("[[vehicle", "[[outputs.traffic.vehicle"));
    let usual = plan("[outputs]\nusual_traffic = true\n");
    let of_line = UsualTraffic::of(&usual.case).traffic().unwrap();
    for (study, traffic) in [(own, given), (usual, of_line)] {
        for (index, mass) in [(0, 300), (1, 400)] {
            let values = study.sample(index).outputs.unwrap();
            let case = study.case.with(&[format!("wheel.mass={mass}")][..]).unwrap();
            let on = traffic.on(&case, &bands_of(&case), &Variant::none(""), &|_| ());
            let (wavelength, rate, at_edge) = ask::fastest_under(&case, &on.unwrap().growth).unwrap();
            assert_eq!(values, [rate, wavelength, f64::from(u8::from(at_edge))]);
        }
    }
}

/// Waves in time: a small one has the normal force and the growth of the linear loop, to what steps of the march and of wear
/// leave, and a high one lifts the wheel.
#[test]
fn waves_are_followed_in_time() {
    let study = study_of(
        r#"
case = "nominal.toml"
design.method = "grid"
[[parameter]]
key = "wheel.mass"
values = ["300 kg", "400 kg"]
[[outputs.wave]]
name = "small"
wavelength = "55 mm"
amplitude = "0.01 um"
speed = "108 km/h"
quantities = ["normal_force_n"]
[[outputs.wave]]
name = "worn"
wavelength = "55 mm"
amplitude = "0.01 um"
speed = "108 km/h"
passages = 20000
quantities = ["amplitude_m"]
[[outputs.wave]]
wavelength = "55 mm"
amplitude = "150 um"
speed = "108 km/h"
quantities = ["contact_loss_fraction", "minimum_normal_force_n"]
"#,
    );
    for (index, mass) in [(0, 300), (1, 400)] {
        let values = study.sample(index).outputs.unwrap();
        let case = study.case.with(&[format!("wheel.mass={mass}")][..]).unwrap();
        let linear = case.feedback.at(0.055, 30.0);
        let scale = 0.01e-6 / case.feedback.amplitude();
        let &[re, im] = of(&study, &values, "small_normal_force_n") else { panic!("no complex number") };
        let force = linear.normal_force() * scale;
        assert!((re - force.re).hypot(im - force.im) < 1e-3 * force.norm());
        let grown = (of(&study, &values, "worn_amplitude_m")[0] / 0.01e-6).ln();
        let rate = 20_000.0 * linear.growth_rate;
        // Heun's steps leave 10⁻³ of a rate, and this one is a tenth of the dissipation.
        assert!((grown - rate).abs() < 0.02 * rate.abs(), "{grown} {rate}");
        assert!(of(&study, &values, "wave_3_contact_loss_fraction")[0] > 0.0);
        assert_eq!(of(&study, &values, "wave_3_minimum_normal_force_n"), [0.0]);
    }
}
