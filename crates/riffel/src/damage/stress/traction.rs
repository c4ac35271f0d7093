//! Tractions on the rail.

use std::sync::Arc;

use super::field::Field;
use super::{ElementStress, EllipseStress, StressTensor, UnitStress};
use crate::cancel::check;
use crate::contact::{HalfSpace, HalfSpaceRolling};

/// Shear of a contact on the rail: μp in full slip, or less of it where the surfaces stick.
#[derive(Debug, Clone, PartialEq)]
pub struct Traction {
    friction: f64,
    direction: [f64; 2],
    stick: Stick,
}

/// What sticking takes off full slip.
#[derive(Debug, Clone, PartialEq)]
enum Stick {
    None,
    /// A similar ellipse a′/a that touches the leading edge.
    Ellipse(f64),
    /// Tractions of the elements of a patch.
    Elements(Arc<ElementStress>),
}

impl Traction {
    /// Full slip of a coefficient of friction; the direction is that of the force on the rail, forward in braking, of length one.
    pub fn full_slip(friction: f64, direction: [f64; 2]) -> Self {
        Self { friction, direction, stick: Stick::None }
    }

    /// Partial slip at a tractive ratio Q/μP (Vermeulen & Johnson 1964): less μp₀ a′/a over a similar ellipse, a′/a = (1 − τ)^(1/3),
    /// about x = a − a′.
    pub fn partial_slip(friction: f64, direction: [f64; 2], tractive_ratio: f64) -> Self {
        Self {
            friction,
            direction,
            stick: match tractive_ratio < 1.0 {
                true => Stick::Ellipse((1.0 - tractive_ratio.max(0.0)).cbrt()),
                false => Stick::None,
            },
        }
    }

    /// That of Kalker's exact theory, element by element. Only what its tractions lack of full slip in the direction of the force
    /// is summed over elements, so that the edge behind, which slips, is as good as the ellipse's own.
    pub fn half_space(half_space: &HalfSpace, state: &HalfSpaceRolling) -> Self {
        let hertz = half_space.hertz();
        let [a, pressure] = [hertz.semi_axis_longitudinal(), hertz.peak_pressure()];
        let forces = state.forces();
        let forces = [forces.longitudinal, forces.lateral];
        let size = forces[0].hypot(forces[1]);
        let direction = match size > 0.0 {
            true => forces.map(|force| force / size),
            false => [1.0, 0.0],
        };
        let lacking: Vec<([f64; 2], [f64; 2])> = half_space
            .elements(state)
            .map(|element| {
                let (along, across) = element.traction;
                let full = direction.map(|part| part * element.bound);
                let lacking = [full[0] - along, full[1] - across];
                let place = [element.centre.0 / a, element.centre.1 / a];
                (place, lacking.map(|traction| traction / pressure))
            })
            .collect();
        let size = half_space.element_size().map(|size| size / a);
        let stress = ElementStress::new(&lacking, size, hertz.material().poisson_ratio());
        Self { friction: half_space.friction(), direction, stick: Stick::Elements(Arc::new(stress)) }
    }

    /// Stress over p₀ under pressure and traction, at x/a, y/b and z/a.
    pub fn stress(&self, ellipse: &EllipseStress, place: [f64; 3]) -> StressTensor {
        let mut stress = self.of_slip(&ellipse.at(place));
        match &self.stick {
            Stick::None => {}
            Stick::Ellipse(c) => self.less(&mut stress, *c, &ellipse.at(inner(*c, place))),
            Stick::Elements(elements) => less_elements(&mut stress, elements, ellipse, place),
        }
        stress
    }

    /// Stress to 1e-3 of p₀ under all points of a grid, plane by plane and in them row by row along x.
    ///
    /// Cost: a quarter of the points, three times as much in partial slip.
    pub fn field(&self, ellipse: &EllipseStress, axes: [&[f64]; 3]) -> Vec<StressTensor> {
        use rayon::prelude::*;
        let [x, y, z] = axes;
        let outer = Field::new(ellipse, axes);
        let within = match self.stick {
            Stick::Ellipse(c) => {
                let inner_x: Vec<f64> = x.iter().map(|&x| inner(c, [x, 0.0, 0.0])[0]).collect();
                let [inner_y, inner_z] = [y, z].map(|axis| axis.iter().map(|v| v / c).collect());
                let (inner_y, inner_z): (Vec<f64>, Vec<f64>) = (inner_y, inner_z);
                Some((c, Field::new(ellipse, [&inner_x, &inner_y, &inner_z])))
            }
            Stick::None | Stick::Elements(_) => None,
        };
        let mut stresses = vec![StressTensor::default(); x.len() * y.len() * z.len()];
        let rows = stresses.par_chunks_mut(x.len()).enumerate();
        rows.for_each(|(row, stresses)| {
            check();
            let (plane, row) = (row / y.len(), row % y.len());
            for (stress, &x) in stresses.iter_mut().zip(x) {
                let place = [x, y[row], z[plane]];
                *stress = self.of_slip(&outer.at([x, y[row]], plane));
                if let Some((c, within)) = &within {
                    let [x, y, _] = inner(*c, place);
                    self.less(stress, *c, &within.at([x, y], plane));
                }
                if let Stick::Elements(elements) = &self.stick {
                    less_elements(stress, elements, ellipse, place);
                }
            }
        });
        stresses
    }

    /// In full slip.
    fn of_slip(&self, unit: &UnitStress) -> StressTensor {
        let [along, across] = self.direction.map(|part| part * self.friction);
        std::array::from_fn(|i| unit.normal[i] + along * unit.along[i] + across * unit.across[i])
    }

    /// Less that of the ellipse of stick.
    fn less(&self, stress: &mut StressTensor, c: f64, inner: &UnitStress) {
        let [along, across] = self.direction.map(|part| part * self.friction);
        for (i, stress) in stress.iter_mut().enumerate() {
            *stress -= c * (along * inner.along[i] + across * inner.across[i]);
        }
    }
}

/// A place as the ellipse of stick a′/a has it.
fn inner(c: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    [(x - (1.0 - c)) / c, y / c, z / c]
}

fn less_elements(stress: &mut StressTensor, elements: &ElementStress, ellipse: &EllipseStress, [x, y, z]: [f64; 3]) {
    let lacking = elements.at([x, y * ellipse.across_over_along(), z]);
    for (stress, lacking) in stress.iter_mut().zip(lacking) {
        *stress -= lacking;
    }
}
