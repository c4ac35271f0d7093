//! A profile as its file has it.

use riffel_keys::Message;

use super::reading::ProfileKind;

/// A profile without a unit is in millimetres if it is wider than this number; none is wider than this in metres.
pub(super) const WIDEST_IN_METRES: f64 = 1.0;
/// No profile is narrower than this \[m\].
pub(super) const NARROWEST: f64 = 5e-3;

/// Points in the order of the file, x lateral and y the height, with their lines.
#[derive(Debug, Default)]
pub(super) struct WrittenProfile {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) lines: Vec<usize>,
    /// Wheel or rail, where the file says so.
    pub(super) kind: Option<ProfileKind>,
    /// Whether the format leaves open how the coordinates stand, so that it is found.
    pub(super) of_any_orientation: bool,
    /// Whether the format tells the gauge side of a rail, x below zero.
    pub(super) gauge_side_known: bool,
    /// What the head of the file says is to be added to x and y.
    pub(super) offset: [f64; 2],
    pub(super) remarks: Vec<Message>,
}

impl WrittenProfile {
    pub(super) fn push(&mut self, point: [f64; 2], line: usize) {
        self.points.push(point);
        self.lines.push(line);
    }

    pub(super) fn scale(&mut self, factor: f64) {
        self.map(|point| point.map(|value| factor * value));
        self.offset = self.offset.map(|value| factor * value);
    }

    pub(super) fn map(&mut self, change: impl Fn([f64; 2]) -> [f64; 2]) {
        for point in &mut self.points {
            *point = change(*point);
        }
    }

    /// Lateral extent.
    pub(super) fn width(&self) -> f64 {
        let x = || self.points.iter().map(|point| point[0]);
        x().fold(f64::MIN, f64::max) - x().fold(f64::MAX, f64::min)
    }
}
