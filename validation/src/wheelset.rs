//! The flexible wheelset.

use std::f64::consts::TAU;

use riffel::wheelset::{Axle, ContactGeometry, Disc, FlexibleWheelset, ModeName, Segment, Wheelset};
use riffel::{Complex64, ElasticMaterial};
use serde::Deserialize;

use crate::Row;
use crate::ground::WorstError;

const FILE: &str = include_str!("../reference/general-loop/flexible_wheelset.json");

#[derive(Deserialize)]
struct Reference {
    wheelsets: Vec<ReferenceWheelset>,
}

#[derive(Deserialize)]
struct ReferenceWheelset {
    parameters: Parameters,
    natural_frequencies_hz_lossless: Frequencies,
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Parameters {
    youngs_modulus: f64,
    poisson_ratio: f64,
    rolling_radius: f64,
    density: f64,
    shear_coefficient: f64,
    loss_factor: f64,
    contact_spacing: f64,
    segments: Vec<ReferenceSegment>,
    discs: Vec<ReferenceDisc>,
}

#[derive(Deserialize)]
struct ReferenceSegment {
    length: f64,
    diameter: f64,
}

#[derive(Deserialize)]
struct ReferenceDisc {
    position: f64,
    mass: f64,
    polar_inertia: f64,
    diametral_inertia: f64,
}

#[derive(Deserialize)]
struct Frequencies {
    bending: Vec<f64>,
    torsion: Vec<f64>,
    stretch: Vec<f64>,
}

#[derive(Deserialize)]
struct Point {
    frequency_hz: f64,
    receptance_m_per_n: [[[f64; 2]; 6]; 6],
}

impl Parameters {
    fn wheelset(&self) -> FlexibleWheelset {
        let steel = ElasticMaterial::new(self.youngs_modulus, self.poisson_ratio).expect("a steel");
        let segments =
            self.segments.iter().map(|segment| Segment { length: segment.length, diameter: segment.diameter });
        let axle = Axle::new(steel, self.density, segments.collect())
            .and_then(|axle| axle.with_shear_coefficient(self.shear_coefficient))
            .and_then(|axle| axle.with_loss_factor(self.loss_factor))
            .expect("an axle");
        let discs = self.discs.iter().map(|disc| Disc {
            position: disc.position,
            mass: disc.mass,
            polar_inertia: disc.polar_inertia,
            diametral_inertia: disc.diametral_inertia,
            coupled: None,
        });
        let contacts = ContactGeometry { contact_spacing: self.contact_spacing, rolling_radius: self.rolling_radius };
        FlexibleWheelset::new(axle, discs.collect(), contacts).expect("a wheelset")
    }
}

fn wheelsets() -> Vec<ReferenceWheelset> {
    let reference: Reference = serde_json::from_str(FILE).expect("valid JSON");
    reference.wheelsets
}

pub(crate) fn flexible_wheelset_receptance() -> Row {
    const LIMIT: f64 = 1e-7;
    let mut error = WorstError::default();
    for reference in wheelsets() {
        let wheelset = reference.parameters.wheelset();
        for point in reference.points {
            let got = wheelset.receptances(TAU * point.frequency_hz);
            let expected = point.receptance_m_per_n.map(|row| row.map(|[re, im]| Complex64::new(re, im)));
            for i in 0..6 {
                for j in 0..6 {
                    let size = (expected[i][i] * expected[j][j]).norm().sqrt();
                    error.compare_beside(size, got[i][j], expected[i][j]);
                }
            }
        }
    }
    Row {
        statement: "Receptances of two flexible wheelsets at both contacts, 80 frequencies of 5–2000 Hz",
        source: "`general-loop/flexible_wheelset.json`, by two other methods",
        expected: format!("{} complex values", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-7 of √(H_ii H_jj): the accuracy the reference states",
        holds: error.within(LIMIT) && error.compared == 2 * 80 * 36,
    }
}

pub(crate) fn flexible_wheelset_natural_frequencies() -> Row {
    const LIMIT: f64 = 1e-6;
    let mut error = WorstError::default();
    for reference in wheelsets() {
        let modes = reference.parameters.wheelset().natural_modes(TAU * 2000.0);
        let modes = modes.expect("below shear across the thickness");
        let expected = reference.natural_frequencies_hz_lossless;
        let mut compare = |wanted: fn(&ModeName) -> bool, expected: &[f64]| {
            let modes = modes.iter().filter(|mode| wanted(&mode.name));
            // The reference lists the lowest ones.
            for (mode, &expected) in modes.zip(expected) {
                error.compare((mode.angular_frequency / TAU).into(), expected.into());
            }
        };
        compare(|name| matches!(name, ModeName::Bending { .. }), &expected.bending);
        compare(|name| matches!(name, ModeName::Torsion { .. }), &expected.torsion);
        compare(|name| matches!(name, ModeName::Stretch { .. }), &expected.stretch);
    }
    Row {
        statement: "Their lowest natural frequencies, five of bending, two of torsion, one of stretch",
        source: "`general-loop/flexible_wheelset.json`, by two other methods",
        expected: format!("{} frequencies", error.compared),
        got: error.describe(LIMIT),
        tolerance: "1e-6: the accuracy the reference states",
        holds: error.within(LIMIT) && error.compared == 16,
    }
}
