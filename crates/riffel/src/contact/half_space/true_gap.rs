//! Transient rolling over the true gap of a rail that is not straight.

use super::transient::{TransientRolling, TransientStep};
use super::{ContactGrid, NormalContact};
use crate::Error;
use crate::contact::Creepages;

/// Pressures of a [`TransientRolling`] at one place of the rail, solved for the gap that is there.
#[derive(Debug, Clone, PartialEq)]
pub struct PressedOnRail {
    /// Largest traction of each element \[Pa\].
    pub(super) bound: Vec<f64>,
}

impl TransientRolling {
    /// The normal contact of the wheel on a straight rail, on the elements of this one: whose gap
    /// [`press_on`](Self::press_on) changes.
    ///
    /// # Errors
    /// Errors of [`NormalContact::new`].
    pub fn normal_contact(&self) -> Result<NormalContact, Error> {
        let (patch, hertz) = (&self.patch, self.hertz);
        let grid = ContactGrid::new(patch.across, patch.across, patch.dx, patch.dy)?;
        NormalContact::new([hertz.material(); 2], grid, |x, y| self.gap(x, y))
    }

    /// Press with the normal force \[N\] on a rail whose height over the one under the wheel centre is a function of the distance
    /// from there \[m\], with the [`normal_contact`](Self::normal_contact) of this one.
    ///
    /// # Errors
    /// Errors of [`NormalContact::under_load`]; [`Error::GridTooSmall`] where something beside the elements is under pressure.
    pub fn press_on(
        &self,
        normal: &mut NormalContact,
        normal_force: f64,
        height: impl Fn(f64) -> f64,
    ) -> Result<PressedOnRail, Error> {
        normal.set_gap(|x, y| self.gap(x, y) - height(x))?;
        // A patch as large as that of Hertz overlaps by about half of the approach.
        let approach = 0.5 * self.hertz.under(normal_force).approach();
        let state = normal.under_load_near(normal_force, Some(approach))?;
        let patch = &self.patch;
        let pressures = patch.places.iter();
        let pressures = pressures.map(|(column, row)| state.pressures()[row * patch.across + column]);
        let bound: Vec<f64> = pressures.map(|pressure| self.friction * pressure).collect();
        let carried = bound.iter().sum::<f64>() * patch.area();
        if carried < (1.0 - 1e-9) * self.friction * state.load() {
            return Err(Error::GridTooSmall {
                length: patch.across as f64 * patch.dx,
                width: patch.across as f64 * patch.dy,
            });
        }
        Ok(PressedOnRail { bound })
    }

    /// Roll on by one element under these pressures, with a slip of so much per metre that the wheel goes on.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn roll_pressed(&mut self, pressed: &PressedOnRail, creepages: Creepages) -> Result<TransientStep, Error> {
        self.roll_under(&pressed.bound, creepages)
    }

    /// Between the undeformed bodies on a straight rail \[m\].
    fn gap(&self, x: f64, y: f64) -> f64 {
        let hertz = self.hertz;
        0.5 * (x * x / hertz.longitudinal_radius() + y * y / hertz.transverse_radius())
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use num_complex::Complex64;

    use super::*;
    use crate::contact::{HalfSpace, HertzContact, OscillatingCreepages};
    use crate::fixtures::steel;

    /// Under a constant load and slip speed a wave of 12 µm leaves on the rail what the response at its frequency says, along with the
    /// creep force. Both grids of 24 elements: 0.03 of κ.
    // Long: rolls the exact contact over three waves step by step, the independent side of the comparison.
    #[test]
    fn response_to_a_wave_is_what_time_shows() {
        const LOAD: f64 = 50e3;
        const ACROSS: usize = 24;
        const PER_WAVE: usize = 100;
        const AMPLITUDE: f64 = 12e-6;
        let steel = steel();
        let hertz = HertzContact::exact(steel, 0.46, 0.23, LOAD).unwrap();
        let half_space = HalfSpace::new(hertz, 0.4, ACROSS).unwrap();
        let state = half_space.roll_at_tractive_ratio(0.5).unwrap();
        let mut contact = TransientRolling::with_room(hertz, 0.4, ACROSS, 4).unwrap();
        let step = contact.step_length();
        let wavenumber = TAU / (PER_WAVE as f64 * step);
        let mut normal = contact.normal_contact().unwrap();
        let height = |place: f64| AMPLITUDE * (wavenumber * place).cos();
        let pressed: Vec<PressedOnRail> = (0..PER_WAVE)
            .map(|index| {
                let centre = (index as f64 + 0.5) * step;
                contact.press_on(&mut normal, LOAD, |x| height(centre + x)).unwrap()
            })
            .collect();
        let creepages = Creepages::longitudinal(state.creepage());
        let (mut force, mut energy) = ([Complex64::ZERO; 2], [Complex64::ZERO; 2]);
        for wave in 0..3 {
            for (index, pressed) in pressed.iter().enumerate() {
                let rolled = contact.roll_pressed(pressed, creepages).unwrap();
                if wave < 2 {
                    continue;
                }
                // Forces at the end of the step, the energy of each column where that lies.
                let turned = |place: f64| Complex64::cis(-wavenumber * place);
                let centre = index as f64 * step;
                force[0] += rolled.forces.longitudinal;
                force[1] += rolled.forces.longitudinal * 2.0 * turned(centre + 0.5 * step);
                for (column, part) in rolled.dissipation_along.iter().enumerate() {
                    energy[0] += part;
                    energy[1] += part * 2.0 * turned(centre + contact.place(column));
                }
            }
        }
        let curvature = 0.46 * wavenumber * wavenumber * AMPLITUDE;
        let oscillating = OscillatingCreepages::Longitudinal.on_waves();
        let response = half_space.responses(&state, &[TAU / wavenumber], oscillating, || ()).remove(0).unwrap();
        let by = response.by_curvature.unwrap();
        let steady = half_space.steady(&state);
        for (got, expected) in [
            (force[1] / force[0], by.force[0] / steady.forces.longitudinal),
            (energy[1] / energy[0], by.at_rail(0.0) / steady.energy_per_metre()),
        ] {
            assert!((got / curvature - expected).norm() < 0.03, "{} {expected}", got / curvature);
        }
    }
}
