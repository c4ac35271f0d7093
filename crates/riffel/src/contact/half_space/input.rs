//! What oscillates under a rolling contact.

use num_complex::Complex64;

use super::forcing::{Deformation, Forcing};
use super::on_waves::OnWaves;
use super::patch::Field;
use super::response::Oscillation;

/// What oscillates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Input {
    /// Normal load, per share of the mean load.
    Load,
    /// Longitudinal creepage, per unit.
    Longitudinal,
    /// Lateral creepage, per unit.
    Lateral,
    /// Spin, per 1/m.
    Spin,
    /// A wave of the rail, per κ = R k² Δ under the wheel, at constant load and slip speed.
    Profile,
}

impl Oscillation<'_> {
    pub(super) fn forcing(&self, input: Input, on_waves: Option<&OnWaves>) -> Forcing {
        let of_creepage = |slip: &dyn Fn((f64, f64)) -> [f64; 2]| Forcing { slip: self.rigid(slip), deformation: None };
        match input {
            Input::Longitudinal => of_creepage(&|_| [1.0, 0.0]),
            Input::Lateral => of_creepage(&|_| [0.0, 1.0]),
            Input::Spin => of_creepage(&|(x, y)| [-y, x]),
            Input::Load => self.by_load(),
            Input::Profile => self.by_profile(on_waves.expect("made where it is asked for")),
        }
    }

    /// The slip of rigid bodies per distance \[-\] over every step \[m\].
    fn rigid<T: Into<Complex64>>(&self, slip: impl Fn((f64, f64)) -> [T; 2]) -> Field<Complex64> {
        let patch = &self.tangent.grid.patch;
        let mut parts: Field<Complex64> = [0, 1].map(|_| Vec::with_capacity(patch.steps.len()));
        for step in &patch.steps {
            for (part, slip) in parts.iter_mut().zip(slip(step.middle)) {
                part.push(patch.dx * slip.into());
            }
        }
        parts
    }

    /// By a share of the load. Lengths and pressures of the patch go like P^{1/3}. In coordinates that stretch with it
    /// the edges stay, and what is left is smooth: u₁ = A₀p₁ + εu₀, the material passes slower
    /// by ε, and is carried along by the stretching; spin slides faster further out.
    fn by_load(&self) -> Forcing {
        let tangent = self.tangent;
        let patch = &tangent.grid.patch;
        let third = 1.0 / 3.0;
        let spin = tangent.creepages.spin;
        let mut slip = self.rigid(|(x, y)| [-third * spin * y, third * spin * x]);
        let [of_here, of_ahead] = self.difference();
        for (part, slip) in slip.iter_mut().enumerate() {
            for (index, slip) in slip.iter_mut().enumerate() {
                let (x, y) = patch.steps[index].middle;
                let (here, ahead) = (tangent.here[part][index], tangent.ahead[part][index]);
                let along = x * (ahead - here) / patch.dx;
                let carried =
                    Complex64::new(0.0, self.wavenumber * patch.dx) * (along + y * tangent.across[part][index]);
                let stretched = of_here * here + of_ahead * ahead;
                *slip += third * (carried - (ahead - here) - stretched);
            }
        }
        let of_area = Complex64::from(2.0 * third);
        let displaced = |x: f64| Complex64::new(0.0, -self.wavenumber * x) * third;
        let steps = patch.steps.iter();
        Forcing {
            slip,
            deformation: Some(Deformation {
                bound: vec![third.into(); patch.len()],
                elements: vec![of_area; patch.len()],
                steps: vec![of_area; patch.steps.len()],
                displaced: steps.map(|step| displaced(step.middle.0)).collect(),
                slower: Complex64::ZERO,
            }),
        }
    }
}
