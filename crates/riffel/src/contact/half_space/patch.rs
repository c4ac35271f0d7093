//! The contact ellipse cut into elements.

use super::normal::NormalState;
use crate::Error;
use crate::contact::{CreepForces, HertzContact};

/// Fewest and most elements across a diameter of the ellipse.
const ELEMENTS: std::ops::RangeInclusive<usize> = 8..=200;

/// Tangential tractions or displacements: x and y part.
pub(super) type Field<T> = [Vec<T>; 2];

/// Equal rectangles over the box around a patch; those inside it carry
/// traction. x points along the direction of rolling, so that the rail's material enters at x = +a.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Patch {
    /// Elements across a diameter, in both directions.
    pub(super) across: usize,
    /// Length of an element \[m\].
    pub(super) dx: f64,
    /// Width of an element \[m\].
    pub(super) dy: f64,
    /// Column and row of each element inside, row by row.
    pub(super) places: Vec<(usize, usize)>,
    /// Centre of each element \[m\].
    pub(super) centres: Vec<(f64, f64)>,
    /// Steps of one element length that the material makes: one into each element, in the order of
    /// the elements, then one out of the last element of each row.
    pub(super) steps: Vec<Step>,
}

/// A step of the material from x + dx to x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    /// Column and row at the end of the step; the column behind the first is −1.
    pub(super) end: (isize, usize),
    /// Middle of the step \[m\].
    pub(super) middle: (f64, f64),
    /// Element in which it begins; none if it enters the patch.
    pub(super) from: Option<usize>,
    /// Element in which it ends; none if it leaves the patch.
    pub(super) to: Option<usize>,
}

impl Patch {
    /// The ellipse of the semi-axes a along x and b along y \[m\].
    pub(super) fn new(a: f64, b: f64, across: usize) -> Result<Self, Error> {
        if !ELEMENTS.contains(&across) {
            return Err(Error::OutOfRange {
                quantity: "number of elements across the contact",
                value: across as f64,
                unit: "",
                rule: "must be between 8 and 200",
            });
        }
        // The elements together are as large as the ellipse.
        let inside = |index: usize| (2.0 * index as f64 + 1.0) / across as f64 - 1.0;
        let count = (0..across)
            .flat_map(|row| (0..across).map(move |column| (row, column)))
            .filter(|&(row, column)| inside(row).powi(2) + inside(column).powi(2) < 1.0)
            .count();
        let scale = (std::f64::consts::FRAC_PI_4 * (across * across) as f64 / count as f64).sqrt();
        let (dx, dy) = (2.0 * a * scale / across as f64, 2.0 * b * scale / across as f64);
        let centre = |index: usize, step: f64, semi: f64| (index as f64 + 0.5) * step - semi * scale;
        let mut patch = Self { across, dx, dy, places: Vec::new(), centres: Vec::new(), steps: Vec::new() };
        for row in 0..across {
            for column in 0..across {
                if inside(row).powi(2) + inside(column).powi(2) < 1.0 {
                    patch.places.push((column, row));
                    let centre = (centre(column, dx, a), centre(row, dy, b));
                    patch.centres.push(centre);
                }
            }
        }
        patch.steps = patch.all_steps();
        Ok(patch)
    }

    /// The elements of a grid that are under pressure.
    pub(super) fn under_pressure(state: &NormalState) -> Self {
        let grid = state.grid();
        let mut patch = Self {
            across: grid.columns().max(grid.rows()),
            dx: grid.dx(),
            dy: grid.dy(),
            places: Vec::new(),
            centres: Vec::new(),
            steps: Vec::new(),
        };
        for ((index, centre), &pressure) in grid.centres().enumerate().zip(state.pressures()) {
            if pressure > 0.0 {
                patch.places.push((index % grid.columns(), index / grid.columns()));
                patch.centres.push(centre);
            }
        }
        patch.steps = patch.all_steps();
        patch
    }

    /// Largest traction μp of each element \[Pa\] in a contact on this patch or within it.
    pub(super) fn traction_bound(&self, hertz: HertzContact, friction: f64) -> Vec<f64> {
        let semi_axes = (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral());
        let largest = friction * hertz.peak_pressure();
        let mut bound = self.pressure_of(semi_axes);
        bound.iter_mut().for_each(|share| *share *= largest);
        bound
    }

    /// Forces of tractions on the elements \[N\].
    pub(super) fn forces(&self, tractions: &Field<f64>) -> CreepForces {
        let sum = |part: usize| tractions[part].iter().sum::<f64>() * self.area();
        CreepForces { longitudinal: sum(0), lateral: sum(1) }
    }

    /// Moment of tractions on the elements about the normal \[Nm\].
    pub(super) fn moment(&self, tractions: &Field<f64>) -> f64 {
        let elements = self.centres.iter().zip(tractions[0].iter().zip(&tractions[1]));
        let moments = elements.map(|(&(x, y), (along, across))| x * across - y * along);
        self.area() * moments.sum::<f64>()
    }

    /// Share of the peak pressure that is the mean pressure of each element \[-\], of the ellipse of
    /// other semi-axes that is not larger.
    pub(super) fn pressure_of(&self, (a, b): (f64, f64)) -> Vec<f64> {
        let size = (self.dx / a, self.dy / b);
        let centres = self.centres.iter();
        let mut pressure: Vec<f64> = centres.map(|(x, y)| mean_pressure((x / a, y / b), size)).collect();
        // What elements with their centre outside would carry, half a per cent, goes to the others.
        let sum: f64 = pressure.iter().sum::<f64>() * self.area();
        let share = 2.0 / 3.0 * std::f64::consts::PI * a * b / sum;
        pressure.iter_mut().for_each(|pressure| *pressure *= share);
        pressure
    }

    fn all_steps(&self) -> Vec<Step> {
        // Elements of a row follow each other; a patch that is no ellipse may have gaps in it.
        let neighbour = |index: Option<usize>, of: usize| {
            index.filter(|&index| {
                let of = self.places[of];
                self.places.get(index).is_some_and(|place| place.1 == of.1 && place.0.abs_diff(of.0) == 1)
            })
        };
        let step = |index: usize, back: bool| {
            let (column, row) = self.places[index];
            let side = if back { -0.5 } else { 0.5 };
            Step {
                end: (column as isize - isize::from(back), row),
                middle: (self.centres[index].0 + side * self.dx, self.centres[index].1),
                from: if back { Some(index) } else { neighbour(Some(index + 1), index) },
                to: (!back).then_some(index),
            }
        };
        let is_last = |&index: &usize| neighbour(index.checked_sub(1), index).is_none();
        let into = (0..self.len()).map(|index| step(index, false));
        let out_of = (0..self.len()).filter(is_last);
        into.chain(out_of.map(|index| step(index, true))).collect()
    }

    /// The elements of each row, or of each part of it where there are gaps.
    pub(super) fn rows(&self) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let mut begin = 0;
        let follows = |a: &(usize, usize), b: &(usize, usize)| a.1 == b.1 && b.0 == a.0 + 1;
        self.places.chunk_by(follows).map(move |row| {
            let range = begin..begin + row.len();
            begin = range.end;
            range
        })
    }

    /// Number of elements inside.
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// Area of an element \[m²\].
    pub(super) fn area(&self) -> f64 {
        self.dx * self.dy
    }
}

/// Mean of √(1 − x² − y²) over a rectangle, zero outside the unit circle: an element on the edge is
/// covered in part. Exact in x; in y the midpoint rule across the edge, 1e-3 relative, and Gauss's inside,
/// 1e-6.
fn mean_pressure((x, y): (f64, f64), (width, height): (f64, f64)) -> f64 {
    const LINES: usize = 16;
    let mean_along = |y: f64| {
        let chord = (1.0 - y * y).max(0.0);
        let end = chord.sqrt();
        // ∫√(c² − x²) dx = \[x√(c² − x²) + c² arcsin(x/c)\]/2
        let [low, high] = [x - 0.5 * width, x + 0.5 * width].map(|x| x.clamp(-end, end));
        let [fall, rise] = [low, high].map(|x| (chord - x * x).max(0.0).sqrt());
        let angle = (high * fall - low * rise).atan2(rise * fall + low * high);
        0.5 * (high * rise - low * fall + chord * angle) / width
    };
    let corner = (x.abs() + 0.5 * width).hypot(y.abs() + 0.5 * height);
    if corner < 1.0 {
        let offset = 0.5 * height * 0.6f64.sqrt();
        let sides = mean_along(y - offset) + mean_along(y + offset);
        return (5.0 * sides + 8.0 * mean_along(y)) / 18.0;
    }
    let line = |line: usize| y + height * ((line as f64 + 0.5) / LINES as f64 - 0.5);
    (0..LINES).map(line).map(mean_along).sum::<f64>() / LINES as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The elements carry the load, 2/3 of the peak pressure over the ellipse, and are together as large
    /// as it; each row ends with a step out of the patch.
    #[test]
    fn elements_are_the_ellipse() {
        for across in [15, 16, 40] {
            let patch = Patch::new(6e-3, 4e-3, across).unwrap();
            let area = std::f64::consts::PI * 6e-3 * 4e-3;
            let pressure = patch.pressure_of((6e-3, 4e-3));
            let load: f64 = pressure.iter().sum::<f64>() * patch.area();
            assert!((load / (2.0 / 3.0 * area) - 1.0).abs() < 1e-12);
            assert!((patch.len() as f64 * patch.area() / area - 1.0).abs() < 1e-12);
            let rows = patch.places.iter().map(|place| place.1);
            let rows = rows.collect::<std::collections::BTreeSet<_>>().len();
            assert_eq!(patch.steps.len(), patch.len() + rows);
        }
        assert!(Patch::new(6e-3, 4e-3, 4).is_err());
    }

    /// In the middle the mean over an element is the pressure there, less its curvature.
    #[test]
    fn mean_pressure_is_a_mean() {
        let mean = mean_pressure((0.1, 0.2), (0.05, 0.05));
        let middle = (1.0f64 - 0.01 - 0.04).sqrt();
        assert!((mean / middle - 1.0).abs() < 1e-3);
        assert_eq!(mean_pressure((2.0, 0.0), (0.1, 0.1)), 0.0);
    }
}
