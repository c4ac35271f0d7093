//! Receptances of the track.

use riffel::{
    Complex64, ElasticMaterial, EulerBernoulliBeam, FreeBeam, Layer, Receptance, TwoLayerTrack,
};
use serde::Deserialize;

use crate::Row;
use crate::ground::{WorstError, extent, on_track};

const FILES: [(&str, &str); 3] = [
    (
        include_str!("../reference/receptance/bs113a_lossless.json"),
        include_str!("../reference/receptance/bs113a_lossless.csv"),
    ),
    (
        include_str!("../reference/receptance/uic60_lossless.json"),
        include_str!("../reference/receptance/uic60_lossless.csv"),
    ),
    (
        include_str!("../reference/receptance/uic60_stiff_pad.json"),
        include_str!("../reference/receptance/uic60_stiff_pad.csv"),
    ),
];

#[derive(Deserialize)]
struct Parameters {
    youngs_modulus_pa: f64,
    second_moment_m4: f64,
    mass_per_length_kg_per_m: f64,
    support_spacing_m: f64,
    pad_stiffness_n_per_m: f64,
    pad_damping_ns_per_m: f64,
    sleeper_mass_kg: f64,
    ballast_stiffness_n_per_m: f64,
    ballast_damping_ns_per_m: f64,
}

fn beam(youngs_modulus: f64, second_moment: f64, mass_per_length: f64) -> EulerBernoulliBeam {
    let steel = ElasticMaterial::new(youngs_modulus, 0.3).expect("a steel");
    EulerBernoulliBeam::new(steel, second_moment, mass_per_length).expect("a rail")
}

/// Values per metre.
fn two_layer(
    beam: EulerBernoulliBeam,
    pad: (f64, f64),
    sleeper: f64,
    ballast: (f64, f64),
) -> TwoLayerTrack {
    let layer = |(stiffness, damping)| Layer::new(stiffness, damping).expect("a layer");
    TwoLayerTrack::new(beam, layer(pad), sleeper, layer(ballast)).expect("a track")
}

pub(crate) fn two_layer_receptance() -> Row {
    let mut error = WorstError::default();
    for (parameters, table) in FILES {
        let p: Parameters = serde_json::from_str(parameters).expect("valid JSON");
        let d = p.support_spacing_m;
        let track = two_layer(
            beam(
                p.youngs_modulus_pa,
                p.second_moment_m4,
                p.mass_per_length_kg_per_m,
            ),
            (p.pad_stiffness_n_per_m / d, p.pad_damping_ns_per_m / d),
            p.sleeper_mass_kg / d,
            (
                p.ballast_stiffness_n_per_m / d,
                p.ballast_damping_ns_per_m / d,
            ),
        );
        for line in table.lines().skip(1) {
            let columns: Vec<f64> = line
                .split(',')
                .take(3)
                .map(|cell| cell.parse().expect("a number"))
                .collect();
            let expected = Complex64::new(columns[1], columns[2]);
            let got = track.receptance(std::f64::consts::TAU * columns[0], 0.0);
            error.compare(got, expected);
        }
    }
    Row {
        statement: "Receptance of the two-layer track, Euler rail, three tracks at 200 frequencies",
        source: "`receptance/*.csv`, checked against rolland 26.8",
        expected: format!("{} complex values", error.compared),
        got: error.describe(1e-8),
        tolerance: "1e-8: the accuracy the reference states",
        holds: error.within(1e-8) && error.compared == 600,
    }
}

/// A resonance: frequency \[Hz\] and modulus of the mobility ωH \[m/(s N)\].
type Resonance = (f64, f64);

/// The two largest peaks of |ωH| and the dip between them, on a grid of 0.1 Hz.
fn peaks_and_dip(track: &dyn Receptance, from: f64, to: f64) -> Option<[Resonance; 3]> {
    let steps = ((to - from) * 10.0) as usize;
    let curve: Vec<Resonance> = (0..=steps)
        .map(|step| {
            let frequency = from + step as f64 / 10.0;
            let w = std::f64::consts::TAU * frequency;
            (frequency, w * track.receptance(w, 0.0).norm())
        })
        .collect();
    let turning = |sign: f64| {
        curve
            .windows(3)
            .filter(move |w| sign * w[1].1 > sign * w[0].1 && sign * w[1].1 >= sign * w[2].1)
            .map(|w| w[1])
    };
    let mut peaks = turning(1.0);
    Some([peaks.next()?, turning(-1.0).next()?, peaks.next()?])
}

pub(crate) fn two_layer_peaks() -> Row {
    let track = two_layer(
        beam(210e9, 3.0383e-5, 60.2),
        (300e6, 30e3),
        250.0,
        (100e6, 80e3),
    );
    let expected = [(89.6, 8.05e-6), (198.9, 2.117e-6), (403.7, 1.461e-5)];
    let got = peaks_and_dip(&track, 30.0, 1000.0).unwrap_or([(f64::NAN, f64::NAN); 3]);
    let close = |a: f64, b: f64, tolerance: f64| (a / b - 1.0).abs() < tolerance;
    Row {
        statement: "UIC60 on two layers: peaks and dip of the mobility",
        source: "rolland, test data of its analytical methods",
        expected: "89.6 Hz 8.05e-6, 198.9 Hz 2.117e-6, 403.7 Hz 1.461e-5 m/(s N)".to_owned(),
        got: got.map(|(f, y)| format!("{f:.1} Hz {y:.3e}")).join(", "),
        tolerance: "frequency 0.5 %: the reference is sampled every 2 Hz; height 0.2 %: its printed digits",
        holds: expected
            .iter()
            .zip(got)
            .all(|(e, g)| close(g.0, e.0, 5e-3) && close(g.1, e.1, 2e-3)),
    }
}

pub(crate) fn bhaskar_resonance() -> Row {
    let case = on_track(&[]);
    let (mut peak, mut frequency) = (0.0, f64::NAN);
    for step in 300..5000 {
        let f = f64::from(step) / 10.0;
        let modulus = case
            .feedback
            .track
            .receptance(std::f64::consts::TAU * f, 0.0)
            .norm();
        if modulus > peak {
            (peak, frequency) = (modulus, f);
        }
    }
    Row {
        statement: "Track of Bhaskar et al.: a sharp resonance at about 100 Hz",
        source: "section 3, Fig. 2 (`bhaskar-inferred`)",
        expected: "about 100 Hz".to_owned(),
        got: format!("{frequency:.0} Hz"),
        tolerance: "10 %: the word \"about\", and a preset inferred from it",
        holds: (frequency / 100.0 - 1.0).abs() < 0.1,
    }
}

pub(crate) fn free_beam_is_the_high_frequency_limit() -> Row {
    let track = on_track(&[]).feedback.track;
    let free = FreeBeam::new(beam(207e9, 2.35e-5, 56.0));
    let (low, high) = extent((1500..=3000).step_by(10).map(|f| {
        let w = std::f64::consts::TAU * f64::from(f);
        track.receptance(w, 0.0).norm() / free.receptance(w, 0.0).norm()
    }));
    Row {
        statement: "At high frequency the supported rail tends to the free beam (23)",
        source: "section 3, Fig. 2",
        expected: "modulus ratio → 1".to_owned(),
        got: format!("{low:.3} … {high:.3} over 1500–3000 Hz"),
        tolerance: "5 %: the pad still carries k/(mω²) ≈ 2 % at 1500 Hz",
        holds: low > 0.95 && high < 1.05,
    }
}
