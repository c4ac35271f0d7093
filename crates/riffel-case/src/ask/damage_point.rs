//! What laws of damage say of one wavelength and speed.

use riffel::damage::{Damage, DamageState};
use riffel::{Complex64, LoopState};
use serde::{Serialize, Serializer};

use crate::Case;

/// The laws of damage of the first contact; amplitudes per metre of profile, rates at the amplitude of the case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DamagePoint {
    /// Largest pressure p₀.
    pub contact_pressure_pa: f64,
    /// Shear yield k of the rail.
    pub shear_yield_pa: f64,
    /// f = |Q|/P of the mean state.
    pub utilised_friction: f64,
    /// u = p₀/(k S): flow where it is above one.
    pub demand: f64,
    /// u₁.
    pub demand_1: [f64; 2],
    /// FI_surf = f − k/p₀.
    pub fi_surf: f64,
    /// FI₁.
    pub fi_surf_1: [f64; 2],
    /// |X₀|/|u₁|: amplitude of which a part of the wave is on the other side of the limit.
    pub amplitude_at_limit_m: f64,
    /// Phase of the demand against the profile; 180 in the troughs.
    pub place_deg: f64,
    /// Growth rate per passage of each law.
    pub growth_by_law: ByLaw,
    /// Change of the phase per passage by each law.
    pub drift_by_law: ByLaw,
    /// Mean depth per passage of the laws that take some away.
    pub depth_by_law_m: ByLaw,
    /// M₀/M_lim, where the rail bends beyond yield.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment_over_limit: Option<f64>,
    /// M₀.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_moment_nm: Option<f64>,
    /// M₁.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment_1: Option<[f64; 2]>,
    /// Damage of fatigue per passage D, with its sign.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fatigue_damage: Option<f64>,
    /// D₁.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fatigue_damage_1: Option<[f64; 2]>,
    /// Net growth of a crack per passage: that of fatigue less what wear takes of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crack_growth_m: Option<f64>,
    /// Growth of a crack along the wave; cracks grow on crests where its real part is above zero.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crack_growth_1: Option<[f64; 2]>,
    /// −D_h Re(u₁/Δ): above one the wave outgrows hardening.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub runaway_number: Option<f64>,
    /// The wave that hardening leaves, over the first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardened_wave: Option<[f64; 2]>,
}

/// A number for each law, by its name.
#[derive(Debug, Clone, PartialEq)]
pub struct ByLaw(pub Vec<(&'static str, f64)>);

impl Serialize for ByLaw {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

impl DamagePoint {
    pub(crate) fn new(case: &Case, state: &LoopState) -> Option<Self> {
        let damage = case.feedback.contacts()[0].damage.as_deref()?;
        Some(Self::of(damage, &state.contacts[0].damage?))
    }

    fn of(damage: &Damage, state: &DamageState) -> Self {
        let complex = |value: Complex64| [value.re, value.im];
        let by = |of: fn(Complex64) -> f64| ByLaw(state.laws().map(|law| (law.name, of(law.growth))).collect());
        let demand = &damage.demand;
        let crack = state.crack;
        Self {
            contact_pressure_pa: demand.contact_pressure,
            shear_yield_pa: demand.shear_yield,
            utilised_friction: demand.utilised_friction,
            demand: demand.value,
            demand_1: complex(state.demand),
            fi_surf: demand.fatigue_index,
            fi_surf_1: complex(state.fatigue_index),
            amplitude_at_limit_m: demand.excess().abs() / state.demand.norm(),
            place_deg: state.demand.arg().to_degrees(),
            growth_by_law: by(|growth| growth.re),
            drift_by_law: by(|growth| growth.im),
            depth_by_law_m: ByLaw(state.laws().filter_map(|law| Some((law.name, law.mean_depth?))).collect()),
            moment_over_limit: state.moment.map(|(share, _)| share),
            mean_moment_nm: state.moment.map(|(_, mean)| mean),
            moment_1: state.moment_1.map(complex),
            fatigue_damage: crack.map(|crack| crack.damage),
            fatigue_damage_1: crack.map(|crack| complex(crack.damage_1)),
            crack_growth_m: crack.map(|crack| crack.growth),
            crack_growth_1: crack.map(|crack| complex(crack.growth_1)),
            runaway_number: state.hardened.map(|(number, _)| number),
            hardened_wave: state.hardened.map(|(_, wave)| complex(wave)),
        }
    }
}
