//! The ellipse of a contact and steady rolling on it as data.

use riffel::HertzContact;
use riffel::contact::KalkerCoefficients;
use riffel_case::SteadyContact;
use serde::{Serialize, Serializer};

/// The contact patch with steady rolling by the law of the case.
#[derive(Serialize)]
pub struct ContactPatch {
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    approach_m: f64,
    peak_pressure_pa: f64,
    stiffness_n_per_m: f64,
    #[serde(serialize_with = "coefficients")]
    kalker: KalkerCoefficients,
    steady: SteadyForces,
}

#[derive(Serialize)]
struct SteadyForces {
    /// Along and across the rail.
    force_n: [f64; 2],
    /// `None` if the law does not tell it.
    spin_moment_nm: Option<f64>,
    /// With the work of the spin moment; `None` if there is spin and the law does not tell it.
    dissipation_j_per_m: Option<f64>,
}

fn coefficients<S: Serializer>(kalker: &KalkerCoefficients, serializer: S) -> Result<S::Ok, S::Error> {
    let KalkerCoefficients { c11, c22, c23, c33 } = *kalker;
    serializer.collect_map([("c11", c11), ("c22", c22), ("c23", c23), ("c33", c33)])
}

impl ContactPatch {
    /// The patch as data.
    pub fn new(hertz: &HertzContact, kalker: KalkerCoefficients, steady: &SteadyContact) -> Self {
        let forces = steady.rolling.forces;
        Self {
            semi_axis_longitudinal_m: hertz.semi_axis_longitudinal(),
            semi_axis_lateral_m: hertz.semi_axis_lateral(),
            approach_m: hertz.approach(),
            peak_pressure_pa: hertz.peak_pressure(),
            stiffness_n_per_m: hertz.stiffness(),
            kalker,
            steady: SteadyForces {
                force_n: [forces.longitudinal, forces.lateral],
                spin_moment_nm: steady.spin_moment,
                dissipation_j_per_m: steady.energy_per_metre(),
            },
        }
    }
}
