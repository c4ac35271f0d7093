//! What laws of damage beside wear take off a rail in a passage.

use std::f64::consts::TAU;
use std::sync::Arc;

use num_complex::Complex64;

use super::ContactInstant;
use super::fourier_series::{series, spectrum};
use crate::damage::{Bending, Damage, DamageLaw, MomentaryDemand};
use crate::feedback::{Contact, Loop};

/// Laws of damage under the forces of every instant, each at the point of the rail under the wheel; fatigue takes the energy where
/// that is left. Flow that hardens does so at every point by what has flowed out there.
#[derive(Clone)]
pub struct DamageInTime {
    damage: Arc<Damage>,
    demand: Arc<MomentaryDemand>,
    /// The track under the wheel, for the moment of the rail.
    feedback: Loop,
}

impl DamageInTime {
    /// That of a contact of a loop; `None` if wear is alone.
    pub fn of(feedback: &Loop, contact: &Contact) -> Option<Self> {
        let damage = contact.damage.clone()?;
        (damage.laws != [DamageLaw::Wear]).then(|| Self {
            demand: Arc::new(MomentaryDemand::new(&damage.demand)),
            feedback: feedback.clone(),
            damage,
        })
    }

    /// Share of its hardening that a point takes on in a passage where it is fastest \[-\]; `None` if nothing hardens.
    pub(super) fn hardening_rate(&self) -> Option<f64> {
        let flow = self.damage.flow_that_hardens()?;
        let steepest = self.damage.demand.excess().abs() + flow.law.spread();
        Some(flow.depth * flow.law.slope(steepest) / flow.hardening_depth?)
    }

    /// Whether wear is among the laws.
    pub(super) fn wears(&self) -> bool {
        self.damage.wears()
    }

    /// Waves of the depth \[m\] that all laws but wear take off a ring of some length \[m\] at a speed \[m/s\]; of the mean, as the first,
    /// what is taken away. `energy` is that of the waves at the rail \[J/m\], `outflow` what has flowed and hardened at the places of
    /// the instants \[m\], and `curvature` the κ of the profile there, each empty for nothing. The second waves are what flows and hardens in
    /// this passage.
    pub(super) fn waves(
        &self,
        instants: &[ContactInstant],
        energy: &[Complex64],
        [outflow, curvature]: [&[f64]; 2],
        [length, speed]: [f64; 2],
    ) -> [Vec<Complex64>; 2] {
        let over = |of: &dyn Fn(&ContactInstant) -> f64| -> Vec<Complex64> {
            spectrum(&instants.iter().map(of).collect::<Vec<f64>>())
        };
        let there = |values: &[f64], place: usize| values.get(place).copied().unwrap_or(0.0);
        let excess = |place: usize| {
            let at = &instants[place];
            let forces = [at.tangential_force, at.lateral_force];
            self.demand.excess(at.normal_force, forces, there(curvature, place))
        };
        let wavenumber = |n: usize| TAU * n as f64 / length;
        let mut sum = vec![Complex64::ZERO; energy.len()];
        let mut hardening = Vec::new();
        for law in &self.damage.laws {
            let waves = match law {
                DamageLaw::Wear => continue,
                DamageLaw::Load(load) => over(&|at| load.depth_per_force * at.normal_force),
                DamageLaw::Flow(flow) => {
                    let softening = flow.hardening_depth.map_or(0.0, f64::recip);
                    let flows = (0..instants.len()).map(|place| {
                        let flowed = there(outflow, place);
                        flow.depth * flow.law.value(excess(place) - softening * flowed)
                    });
                    let waves = spectrum(&flows.collect::<Vec<f64>>());
                    if flow.hardening_depth.is_some() {
                        hardening.clone_from(&waves);
                    }
                    waves
                }
                DamageLaw::FlowAlong(flow) => {
                    let flows = instants.iter().enumerate().map(|(place, at)| {
                        let force = at.tangential_force.hypot(at.lateral_force);
                        let along = match force > 0.0 {
                            true => at.tangential_force / force,
                            false => 0.0,
                        };
                        flow.area * flow.law.value(excess(place)) * along
                    });
                    let flows = spectrum(&flows.collect::<Vec<f64>>());
                    let flows = flows.into_iter().enumerate();
                    flows.map(|(n, flow)| Complex64::I * wavenumber(n) * flow).collect()
                }
                DamageLaw::Bending(bending) => self.bent(bending, instants, [length, speed]),
                DamageLaw::Fatigue(fatigue) => {
                    let energies = series(energy.to_vec(), instants.len());
                    let lost = energies.iter().map(|&energy| fatigue.loss * fatigue.growing().value(energy));
                    spectrum(&lost.collect::<Vec<f64>>())
                }
            };
            for (sum, wave) in sum.iter_mut().zip(waves) {
                *sum += wave;
            }
        }
        [sum, hardening]
    }

    /// Of the curvature that a rail keeps what it does not take back on its springs.
    fn bent(&self, bending: &Bending, instants: &[ContactInstant], [length, speed]: [f64; 2]) -> Vec<Complex64> {
        let loads: Vec<f64> = instants.iter().map(|at| at.normal_force).collect();
        let at_rest = bending.mean_moment / self.damage.demand.load;
        let moments = spectrum(&loads).into_iter().enumerate();
        let moments = moments.map(|(n, load)| match n {
            0 => load * at_rest,
            _ => {
                let frequency = TAU * n as f64 * speed / length;
                let [track, _] = self.feedback.normal_receptances(frequency, speed);
                load * bending.moment_per_force(track)
            }
        });
        let moments = series(moments.collect(), loads.len());
        let kept = moments.iter().map(|moment| bending.curvature * bending.law.value(moment / bending.limit - 1.0));
        let waves = spectrum(&kept.collect::<Vec<f64>>()).into_iter().enumerate();
        waves
            .map(|(n, curvature)| match n {
                0 => Complex64::ZERO,
                _ => {
                    let wavenumber = TAU * n as f64 / length;
                    curvature * bending.freedom(wavenumber) / (wavenumber * wavenumber)
                }
            })
            .collect()
    }
}
