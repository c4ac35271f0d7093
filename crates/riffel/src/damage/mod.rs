//! Damage beside wear: what flows, bends, cracks, as further joints of the loop.
//!
//! One law a file. Each makes of the oscillating forces of the loop a depth per passage h₁, which feeds back to the
//! profile like wear: G = −h₁/Δ, growth Re G, drift Im G.

mod bending;
mod clipped_power;
mod demand;
mod fatigue;
mod flow;
mod flow_along;
mod hardening;
mod load;
mod momentary_demand;
mod ramps;
mod rate_table;
mod shakedown;
pub mod stress;

use std::sync::OnceLock;

use num_complex::Complex64;

pub use bending::Bending;
pub use clipped_power::ClippedPower;
pub use demand::Demand;
pub use fatigue::Fatigue;
pub use flow::Flow;
pub use flow_along::FlowAlong;
pub use hardening::Hardening;
pub use load::Load;
pub(crate) use momentary_demand::MomentaryDemand;
pub use ramps::Ramps;
use rate_table::RateTable;
pub use shakedown::{ShakedownLimit, orthogonal_shear};

/// A law of damage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DamageLaw {
    /// The law of wear of the contact.
    Wear,
    /// Flow by load without a threshold.
    Load(Load),
    /// Flow to the sides.
    Flow(Flow),
    /// Flow along the rail.
    FlowAlong(FlowAlong),
    /// Bending beyond yield.
    Bending(Bending),
    /// Contact fatigue by Tγ.
    Fatigue(Fatigue),
}

impl DamageLaw {
    /// Its name in files and documents.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Wear => "wear",
            Self::Load(_) => "load",
            Self::Flow(_) => "flow",
            Self::FlowAlong(_) => "flow-along",
            Self::Bending(_) => "bending",
            Self::Fatigue(_) => "fatigue",
        }
    }

    /// Whether its rate depends on the amplitude of the wave.
    pub fn depends_on_amplitude(&self) -> bool {
        match self {
            Self::Wear | Self::Load(_) => false,
            Self::Flow(_) | Self::FlowAlong(_) | Self::Bending(_) => true,
            Self::Fatigue(fatigue) => fatigue.loss > 0.0,
        }
    }
}

/// The laws by which a contact damages its rail; their rates add.
#[derive(Debug, Clone, PartialEq)]
pub struct Damage {
    /// How near the mean state is to flow.
    pub demand: Demand,
    /// The laws, each once.
    pub laws: Vec<DamageLaw>,
    /// Of their rates over the amplitude, by law, as soon as many are asked for; `None` if a rate is in closed form.
    tables: OnceLock<Vec<Option<RateTable>>>,
}

/// What oscillates at a contact, of the profile as it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Oscillation {
    /// u₁.
    pub(crate) demand: Complex64,
    /// Energy at a point of the rail \[J/m\], as the law of wear takes it.
    pub(crate) wear: Complex64,
    /// Energy at a point of the rail as it is dissipated \[J/m\].
    pub(crate) energy: Complex64,
    /// P₁ \[N\].
    pub(crate) load: Complex64,
    /// Receptance of the track under the contact \[m/N\], downward.
    pub(crate) receptance: Complex64,
    /// \[rad/m\].
    pub(crate) wavenumber: f64,
}

/// The mean of what oscillates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mean {
    /// Energy \[J/m\].
    pub(crate) energy: f64,
    /// Depth of wear per energy \[m²/J\].
    pub(crate) wear: f64,
}

impl Damage {
    /// Laws under a contact, each once, with how near its mean state is to flow.
    pub fn new(demand: Demand, laws: Vec<DamageLaw>) -> Self {
        Self { demand, laws, tables: OnceLock::new() }
    }

    /// Whether any of its rates depends on the amplitude of the wave.
    pub fn depends_on_amplitude(&self) -> bool {
        self.laws.iter().any(DamageLaw::depends_on_amplitude)
    }

    /// Its law of flow, if that hardens.
    pub fn flow_that_hardens(&self) -> Option<&Flow> {
        self.laws.iter().find_map(|law| match law {
            DamageLaw::Flow(flow) if flow.hardening_depth.is_some() => Some(flow),
            _ => None,
        })
    }

    /// Damage without flow that hardens.
    pub(crate) fn without_flow_that_hardens(&self) -> Self {
        let keeps = |law: &&DamageLaw| !matches!(law, DamageLaw::Flow(flow) if flow.hardening_depth.is_some());
        let laws = self.laws.iter().filter(keeps).copied().collect();
        Self::new(self.demand, laws)
    }

    /// Its law of fatigue.
    pub fn fatigue(&self) -> Option<&Fatigue> {
        self.laws.iter().find_map(|law| match law {
            DamageLaw::Fatigue(fatigue) => Some(fatigue),
            _ => None,
        })
    }

    /// Whether one of the laws that depend on the amplitude takes the demand.
    pub(crate) fn takes_demand(&self) -> bool {
        let mut laws = self.laws.iter();
        laws.any(|law| matches!(law, DamageLaw::Flow(_) | DamageLaw::FlowAlong(_)))
    }

    /// Whether one of them takes the energy.
    pub(crate) fn takes_energy(&self) -> bool {
        let mut laws = self.laws.iter();
        laws.any(|law| matches!(law, DamageLaw::Fatigue(fatigue) if fatigue.loss > 0.0))
    }

    /// Whether one of them takes the load and the receptance under it.
    pub(crate) fn takes_load(&self) -> bool {
        let mut laws = self.laws.iter();
        laws.any(|law| matches!(law, DamageLaw::Bending(_)))
    }

    /// Slopes of h₁ over the demand at small amplitudes \[m\] and, per wavenumber, of what turns it by a quarter \[m²\]; with the size of
    /// u₁ up to which they hold.
    pub(crate) fn small_demand(&self) -> (f64, f64, f64) {
        let excess = self.demand.excess();
        let (mut aside, mut along, mut linear) = (0.0, 0.0, true);
        for law in &self.laws {
            match law {
                DamageLaw::Flow(flow) => {
                    linear &= flow.law.is_linear_above();
                    aside += flow.depth * flow.law.slope(excess);
                }
                DamageLaw::FlowAlong(flow) => {
                    linear &= flow.law.is_linear_above();
                    along += flow.area * flow.law.slope(excess) * self.demand.along();
                }
                _ => {}
            }
        }
        (aside, along, if linear { excess.abs() } else { 0.0 })
    }

    /// Whether wear is among the laws.
    pub(crate) fn wears(&self) -> bool {
        self.laws.contains(&DamageLaw::Wear)
    }

    /// Depth per load by the law of load \[m/N\].
    pub(crate) fn depth_per_force(&self) -> f64 {
        let depths = self.laws.iter().map(|law| match law {
            DamageLaw::Load(load) => load.depth_per_force,
            _ => 0.0,
        });
        depths.sum()
    }

    /// Mean depth per passage \[m\] on a smooth rail under a load \[N\], of all laws that take some away.
    pub(crate) fn mean_depth(&self, mean: Mean, load: f64) -> f64 {
        let depths = self.laws.iter().map(|law| match law {
            DamageLaw::Wear => mean.wear * mean.energy,
            DamageLaw::Load(law) => law.depth_per_force * load,
            DamageLaw::Flow(flow) => flow.mean_depth(&self.demand, Complex64::ZERO),
            DamageLaw::Fatigue(fatigue) => fatigue.loss * fatigue.growing().value(mean.energy),
            DamageLaw::FlowAlong(_) | DamageLaw::Bending(_) => 0.0,
        });
        depths.sum()
    }

    /// Whether a rate of growth cannot last beyond what its mean depth allows: flow along the rail and bending take none away.
    pub(crate) fn is_bound_by_depth(&self) -> bool {
        let mut laws = self.laws.iter();
        !laws.any(|law| matches!(law, DamageLaw::FlowAlong(_) | DamageLaw::Bending(_)))
    }

    /// h₁ \[m\] of a law, with the table of its rates where there is one.
    fn depth_1(&self, law: &DamageLaw, mean: Mean, at: &Oscillation, table: Option<&RateTable>) -> Complex64 {
        // Far from where squares overflow: no hypotenuse.
        let size = |wave: Complex64| wave.norm_sqr().sqrt();
        let rate = |law: &ClippedPower, excess: f64, amplitude: f64| match table {
            Some(table) => table.rate(amplitude),
            None => law.rate(excess, amplitude),
        };
        match law {
            DamageLaw::Wear => at.wear * mean.wear,
            DamageLaw::Load(load) => at.load * load.depth_per_force,
            DamageLaw::Flow(flow) => {
                let rate = rate(&flow.law, self.demand.excess(), size(at.demand));
                flow.depth_1(at.demand, rate)
            }
            DamageLaw::FlowAlong(flow) => {
                let rate = rate(&flow.law, self.demand.excess(), size(at.demand));
                flow.depth_1(&self.demand, at.demand, at.wavenumber, rate)
            }
            DamageLaw::Bending(bending) if !bending.may_yield(at.load, at.receptance) => Complex64::ZERO,
            DamageLaw::Bending(bending) => {
                let swing = at.load * (bending.moment_per_force(at.receptance) / bending.limit);
                let rate = rate(&bending.law, bending.excess(), size(swing));
                bending.depth_1(swing, at.wavenumber, rate)
            }
            DamageLaw::Fatigue(fatigue) => fatigue.depth_1(mean.energy, at.energy),
        }
    }

    /// h₁ \[m\] of the laws whose rate depends on the amplitude, by tables of their rates that are good to 1e-9.
    pub(crate) fn clipped(&self, mean: Mean, at: &Oscillation) -> Complex64 {
        let laws = self.laws.iter().zip(self.tables());
        let laws = laws.filter(|(law, _)| law.depends_on_amplitude());
        laws.map(|(law, table)| self.depth_1(law, mean, at, table.as_ref())).sum()
    }

    fn tables(&self) -> &[Option<RateTable>] {
        self.tables.get_or_init(|| {
            let excess = self.demand.excess();
            let table = |law: &DamageLaw| match law {
                DamageLaw::Flow(flow) => RateTable::new(flow.law, excess),
                DamageLaw::FlowAlong(flow) => RateTable::new(flow.law, excess),
                DamageLaw::Bending(bending) => RateTable::new(bending.law, bending.excess()),
                DamageLaw::Wear | DamageLaw::Load(_) | DamageLaw::Fatigue(_) => None,
            };
            self.laws.iter().map(table).collect()
        })
    }

    /// All that the laws say of an oscillation. `profile` is the wave under the contact \[m\], `curvature` what its patch feels of it.
    pub(crate) fn state(
        &self,
        mean: Mean,
        load: f64,
        at: &Oscillation,
        force: [Complex64; 3],
        curvature: Complex64,
        profile: Complex64,
    ) -> DamageState {
        let mut laws = [None; 6];
        for (slot, law) in laws.iter_mut().zip(&self.laws) {
            let depth = match law {
                DamageLaw::Wear => Some(mean.wear * mean.energy),
                DamageLaw::Load(law) => Some(law.depth_per_force * load),
                DamageLaw::Flow(flow) => Some(flow.mean_depth(&self.demand, at.demand)),
                DamageLaw::FlowAlong(_) | DamageLaw::Bending(_) => None,
                DamageLaw::Fatigue(fatigue) => {
                    let of_wave = fatigue.growing().mean(mean.energy, at.energy.norm());
                    Some(fatigue.loss * of_wave)
                }
            };
            *slot = Some(LawState {
                name: law.name(),
                growth: -self.depth_1(law, mean, at, None) / profile,
                mean_depth: depth,
            });
        }
        let bending = self.laws.iter().find_map(|law| match law {
            DamageLaw::Bending(bending) => Some(bending),
            _ => None,
        });
        DamageState {
            demand: at.demand / profile,
            fatigue_index: self.demand.fatigue_index_oscillation(force, curvature) / profile,
            laws,
            moment: bending.map(|law| [law.mean_moment, law.limit]).map(|[mean, limit]| (mean / limit, mean)),
            moment_1: bending.map(|law| at.load * law.moment_per_force(at.receptance) / profile),
            crack: self.fatigue().map(|law| {
                let (growth, oscillation) = law.crack(mean.energy, at.energy, mean.wear);
                let size = at.energy.norm();
                CrackState {
                    damage: law.damage().mean(mean.energy, size),
                    damage_1: at.energy * law.damage().rate(mean.energy, size) / profile,
                    growth,
                    growth_1: oscillation / profile,
                }
            }),
            hardened: self.flow_that_hardens().and_then(|flow| flow.hardened(at.demand / profile)),
        }
    }
}

/// What a law does at one wavelength and speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawState {
    /// Its name.
    pub name: &'static str,
    /// G = −h₁/Δ per passage: growth and, as its imaginary part, drift.
    pub growth: Complex64,
    /// Mean depth per passage \[m\]; `None` if a law takes none away.
    pub mean_depth: Option<f64>,
}

/// Cracks at one wavelength and speed, per passage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrackState {
    /// D, mean over the wave.
    pub damage: f64,
    /// D₁/Δ \[1/m\].
    pub damage_1: Complex64,
    /// Net growth of a crack, mean \[m\].
    pub growth: f64,
    /// Net growth of a crack along the wave, per metre of profile \[-\].
    pub growth_1: Complex64,
}

/// What the laws of damage say at one wavelength and speed; amplitudes per metre of profile.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct DamageState {
    /// u₁/Δ \[1/m\].
    pub demand: Complex64,
    /// FI₁/Δ \[1/m\].
    pub fatigue_index: Complex64,
    /// Each law, in the order of the case.
    laws: [Option<LawState>; 6],
    /// M₀/M_lim and M₀ \[N m\] where the rail bends beyond yield.
    pub moment: Option<(f64, f64)>,
    /// M₁/Δ \[N\].
    pub moment_1: Option<Complex64>,
    /// Cracks where fatigue is among the laws.
    pub crack: Option<CrackState>,
    /// Runaway number and the factor that a wave ends at, where flow hardens.
    pub hardened: Option<(f64, Complex64)>,
}

impl DamageState {
    /// Each law, in the order of the case.
    pub fn laws(&self) -> impl Iterator<Item = &LawState> {
        self.laws.iter().flatten()
    }

    /// G of all laws together.
    pub fn growth(&self) -> Complex64 {
        self.laws().map(|law| law.growth).sum()
    }
}
