//! Tractions on the rail.

use std::sync::Arc;

use super::{ElementStress, EllipseStress, StressTensor};
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
        Self {
            friction,
            direction,
            stick: Stick::None,
        }
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
        Self {
            friction: half_space.friction(),
            direction,
            stick: Stick::Elements(Arc::new(stress)),
        }
    }

    /// Stress over p₀ under pressure and traction, at x/a, y/b and z/a.
    pub fn stress(&self, ellipse: &EllipseStress, place: [f64; 3]) -> StressTensor {
        let unit = ellipse.at(place);
        let [along, across] = self.direction.map(|part| part * self.friction);
        let mut stress: StressTensor = std::array::from_fn(|i| {
            unit.normal[i] + along * unit.along[i] + across * unit.across[i]
        });
        let [x, y, z] = place;
        match &self.stick {
            Stick::None => {}
            Stick::Ellipse(c) => {
                let inner = ellipse.at([(x - (1.0 - c)) / c, y / c, z / c]);
                for (i, stress) in stress.iter_mut().enumerate() {
                    *stress -= c * (along * inner.along[i] + across * inner.across[i]);
                }
            }
            Stick::Elements(elements) => {
                let lacking = elements.at([x, y * ellipse.across_over_along(), z]);
                for (stress, lacking) in stress.iter_mut().zip(lacking) {
                    *stress -= lacking;
                }
            }
        }
        stress
    }
}
