//! A rail that moves on all axes.

use std::f64::consts::TAU;

use riffel::receptance::{
    Bar, Beam, ContactPoint, EulerBernoulliBeam, Layer, SpatialRail, SpatialTrack, Structure, Support, Supports, Twist,
    TwistSection,
};
use riffel::{Complex64, Direction, ElasticMaterial, Error, Place, Rail};
use serde::Deserialize;

use crate::Row;
use crate::ground::WorstError;

const FILE: &str = include_str!("../reference/general-loop/rail_twist.json");

#[derive(Deserialize)]
struct Reference {
    parameters: Parameters,
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    frequency_hz: f64,
    receptance_m_per_n: Matrix,
    cross_receptance_2_5_m_m_per_n: Matrix,
}

type Matrix = [[(f64, f64); 3]; 3];

#[derive(Deserialize)]
struct Parameters {
    #[serde(rename = "E")]
    youngs_modulus: f64,
    nu: f64,
    density: f64,
    mass_per_length: f64,
    second_moment: f64,
    lateral_second_moment: f64,
    area: f64,
    loss_factor: f64,
    torsion_constant: f64,
    polar_second_moment: f64,
    head_height: f64,
    foot_depth: f64,
    foot_width: f64,
    lateral_offset: f64,
    support_spacing: f64,
    pad: Stiffness,
    sleeper_mass: f64,
    ballast: Stiffness,
}

#[derive(Deserialize)]
struct Stiffness {
    stiffness: f64,
    lateral_stiffness: f64,
    longitudinal_stiffness: f64,
    loss_factor: f64,
}

impl Parameters {
    fn track(&self) -> Result<SpatialTrack, Error> {
        let steel = ElasticMaterial::new(self.youngs_modulus, self.nu)?;
        let bending = |second_moment| {
            EulerBernoulliBeam::new(steel, second_moment, self.mass_per_length)
                .and_then(|beam| Beam::from(beam).with_loss_factor(self.loss_factor))
        };
        let section = TwistSection {
            torsion_constant: self.torsion_constant,
            polar_second_moment: self.polar_second_moment,
            warping_constant: 0.0,
            centroid_height: 0.0,
            foot_depth: self.foot_depth,
            foot_width: self.foot_width,
            shear_modulus: steel.shear_modulus(),
            density: self.density,
        };
        let rail = SpatialRail {
            vertical: bending(self.second_moment)?,
            lateral: Some(bending(self.lateral_second_moment)?),
            twist: Some(Twist::new(steel, section)?.with_loss_factor(self.loss_factor)?),
            longitudinal: Some(Bar::new(steel, self.area, self.mass_per_length)?.with_loss_factor(self.loss_factor)?),
        };
        let support = |of: fn(&Stiffness) -> f64| -> Result<Option<Support>, Error> {
            let layer = |stiffness: &Stiffness| Layer::new(of(stiffness), 0.0)?.with_loss_factor(stiffness.loss_factor);
            let (pad, ballast) = (layer(&self.pad)?, layer(&self.ballast)?);
            Support::two_layer(pad, self.sleeper_mass, ballast).map(Some)
        };
        let supports = Supports {
            vertical: support(|layer| layer.stiffness)?,
            lateral: support(|layer| layer.lateral_stiffness)?,
            longitudinal: support(|layer| layer.longitudinal_stiffness)?,
        };
        let contact = ContactPoint { height: self.head_height, lateral_offset: self.lateral_offset };
        let track = SpatialTrack::continuous(rail, supports.per_metre(self.support_spacing)?);
        Ok(track.with_contact(Rail::Right, contact))
    }
}

fn row(statement: &'static str, distance: f64, matrix: impl Fn(&Point) -> Matrix) -> Row {
    let reference: Reference = serde_json::from_str(FILE).expect("valid JSON");
    let track = reference.parameters.track().expect("a track");
    let mut error = WorstError::default();
    let mut zeros_hold = true;
    for point in &reference.points {
        let expected = matrix(point);
        for (row, at) in Direction::ALL.into_iter().enumerate() {
            for (column, from) in Direction::ALL.into_iter().enumerate() {
                let place = |along, direction| Place { along, rail: Rail::Right, direction };
                let (at, from) = (place(distance, at), place(0.0, from));
                let got = track.cross_receptance(TAU * point.frequency_hz, 0.0, at, from);
                let (re, im) = expected[row][column];
                if (re, im) == (0.0, 0.0) {
                    zeros_hold &= got == Complex64::ZERO;
                } else {
                    error.compare(got, Complex64::new(re, im));
                }
            }
        }
    }
    Row {
        statement,
        source: "`general-loop/rail_twist.json`",
        expected: format!("{} complex values, the others zero", error.compared),
        got: error.describe(1e-8),
        tolerance: "1e-8: the accuracy the reference states",
        holds: error.within(1e-8) && zeros_hold && error.compared == 300,
    }
}

pub(crate) fn twisting_rail() -> Row {
    row(
        "Receptance of a rail that stretches, bends both ways and twists on two layers, contact off its middle, 60 frequencies",
        0.0,
        |point| point.receptance_m_per_n,
    )
}

pub(crate) fn twisting_rail_farther_on() -> Row {
    row("The same, 2.5 m farther on", 2.5, |point| point.cross_receptance_2_5_m_m_per_n)
}
