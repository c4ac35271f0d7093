//! The axle of a flexible wheelset.

use std::f64::consts::PI;

use crate::{ElasticMaterial, Error};

/// A length of an axle of one diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Length \[m\].
    pub length: f64,
    /// Diameter \[m\].
    pub diameter: f64,
}

impl Segment {
    /// Cross-section A = πd²/4 \[m²\].
    pub(super) fn area(&self) -> f64 {
        0.25 * PI * self.diameter * self.diameter
    }

    /// Second moment of area I = πd⁴/64 \[m⁴\]; the polar one is twice as much.
    pub(super) fn second_moment(&self) -> f64 {
        PI * self.diameter.powi(4) / 64.0
    }
}

/// A solid round axle, from left to right, whose middle lies over the middle of the track.
#[derive(Debug, Clone, PartialEq)]
pub struct Axle {
    pub(super) material: ElasticMaterial,
    pub(super) density: f64,
    pub(super) segments: Vec<Segment>,
    pub(super) shear_coefficient: f64,
    pub(super) loss_factor: f64,
}

impl Axle {
    /// An axle of a material, its density ρ \[kg/m³\] and its segments from left to right, without loss.
    ///
    /// Its shear coefficient is that of Cowper (1966) for a solid circle, 6(1 + ν)/(7 + 6ν).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there is a segment and every value is positive.
    pub fn new(material: ElasticMaterial, density: f64, segments: Vec<Segment>) -> Result<Self, Error> {
        Error::unless_positive("axle density", density, "kg/m3")?;
        if segments.is_empty() {
            return Err(Error::OutOfRange {
                quantity: "number of axle segments",
                value: 0.0,
                unit: "",
                rule: "must be one or more",
            });
        }
        for segment in &segments {
            Error::unless_positive("length of an axle segment", segment.length, "m")?;
            Error::unless_positive("diameter of an axle segment", segment.diameter, "m")?;
        }
        let poisson_ratio = material.poisson_ratio();
        Ok(Self {
            material,
            density,
            segments,
            shear_coefficient: 6.0 * (1.0 + poisson_ratio) / (7.0 + 6.0 * poisson_ratio),
            loss_factor: 0.0,
        })
    }

    /// Axle with a shear coefficient κ \[-\] of the caller's.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is above 0 and at most 1.
    pub fn with_shear_coefficient(self, shear_coefficient: f64) -> Result<Self, Error> {
        if !(shear_coefficient > 0.0 && shear_coefficient <= 1.0) {
            return Err(Error::OutOfRange {
                quantity: "shear coefficient of the axle",
                value: shear_coefficient,
                unit: "",
                rule: "must be above 0 and at most 1",
            });
        }
        Ok(Self { shear_coefficient, ..self })
    }

    /// Axle with a loss factor η \[-\]: E and G become E(1 + iη) and G(1 + iη).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if it is negative.
    pub fn with_loss_factor(self, loss_factor: f64) -> Result<Self, Error> {
        Error::unless_not_negative("axle loss factor", loss_factor, "")?;
        Ok(Self { loss_factor, ..self })
    }

    /// Length \[m\].
    pub fn length(&self) -> f64 {
        self.segments.iter().map(|segment| segment.length).sum()
    }

    /// Diameter of its thickest segment \[m\].
    pub fn largest_diameter(&self) -> f64 {
        let diameters = self.segments.iter().map(|segment| segment.diameter);
        diameters.fold(0.0, f64::max)
    }

    /// Ends of the segments \[m\] from the middle of the axle, the outer ends among them.
    pub(super) fn joints(&self) -> Vec<f64> {
        let mut joints = vec![-0.5 * self.length()];
        for segment in &self.segments {
            joints.push(joints[joints.len() - 1] + segment.length);
        }
        joints
    }

    /// The segment at a place \[m\] from the middle.
    pub(super) fn segment_at(&self, place: f64) -> Segment {
        let joints = self.joints();
        let last = self.segments.len() - 1;
        let index = joints[1..=last].partition_point(|&joint| joint < place);
        self.segments[index]
    }
}
