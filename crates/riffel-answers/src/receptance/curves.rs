//! The joints of a case over frequency.

use std::f64::consts::TAU;

use riffel::{Complex64, Direction, Receptance};
use riffel_case::{Case, Track};

/// A joint of the loop over frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct ReceptanceCurve {
    /// Key in documents and tables.
    pub key: &'static str,
    /// Name in figures.
    pub label: &'static str,
    /// Receptances \[m/N\].
    pub values: Vec<Complex64>,
}

/// Receptances in one direction over the same frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct ReceptanceCurves {
    /// \[Hz\].
    pub frequencies: Vec<f64>,
    /// The rail; vertically the wheel, the contact spring and their sum as well.
    pub joints: Vec<ReceptanceCurve>,
    /// The rail over a support and in mid-span, where supports are discrete.
    pub places: Vec<ReceptanceCurve>,
}

impl ReceptanceCurves {
    /// The curves of a case on its track in a direction, under a load that travels at the speed \[m/s\].
    pub fn new(case: &Case, track: &Track, direction: Direction, speed: f64, frequencies: Vec<f64>) -> Self {
        let over = |structure: &dyn Receptance| -> Vec<Complex64> {
            frequencies.iter().map(|frequency| structure.receptance(TAU * frequency, speed)).collect()
        };
        let curve = |key, label, values| ReceptanceCurve { key, label, values };
        let rail = over(&*track.receptance);
        let mut joints = vec![curve("rail_m_per_n", "rail", rail)];
        if direction == Direction::Vertical {
            let wheel = |frequency: &f64| {
                let [_, wheel] = case.feedback.normal_receptances(TAU * frequency, speed);
                wheel
            };
            let wheel: Vec<Complex64> = frequencies.iter().map(wheel).collect();
            let contact = Complex64::from(case.feedback.contacts()[0].stiffness.recip());
            let total = joints[0].values.iter().zip(&wheel);
            let total = total.map(|(rail, wheel)| rail + wheel + contact).collect();
            let contact = vec![contact; frequencies.len()];
            joints.extend([
                curve("wheel_m_per_n", "wheel", wheel),
                curve("contact_m_per_n", "contact spring", contact),
                curve("total_m_per_n", "total", total),
            ]);
        }
        let mut places = Vec::new();
        if let Some(spacing) = track.support_spacing() {
            for (key, label, place) in [
                ("rail_over_support_m_per_n", "rail over support", 0.0),
                ("rail_mid_span_m_per_n", "rail in mid-span", 0.5 * spacing),
            ] {
                places.extend(track.at(place).map(|rail| curve(key, label, over(&*rail))));
            }
        }
        Self { frequencies, joints, places }
    }

    /// The usual frequencies \[Hz\]: 20 Hz to 5 kHz, or as many of them as the receptance is known at.
    pub fn default_range(receptance: &dyn Receptance) -> (f64, f64) {
        let (known_from, known_to) = receptance.frequency_range();
        (20f64.max(known_from / TAU), 5000f64.min(known_to / TAU))
    }

    /// Frequencies equally spaced in their logarithm, both ends included and exact.
    pub fn frequencies(from: f64, to: f64, points: u32) -> Vec<f64> {
        let last = points - 1;
        (0..points)
            .map(|index| match index {
                0 => from,
                _ if index == last => to,
                _ => from * (to / from).powf(f64::from(index) / f64::from(last)),
            })
            .collect()
    }
}
