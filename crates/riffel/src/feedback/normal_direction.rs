//! The direction of the normal force on a wave: what it does along the rail.

use std::sync::Arc;

use num_complex::Complex64;

use crate::receptance::pairs;
use crate::wheelset::WheelsetWithHubs;
use crate::{Rail, Receptance};

/// How the hubs of the wheels move along the rail under a force through their centres.
///
/// The normal of a contact turns with the slope of the wave, n = (r', 0, 1): the wheel pushes the rail ahead uphill, and the rail
/// brakes the wheel, both with
///
/// ```text
/// N = P₀ r' = P₀ ik Δ p
/// ```
///
/// N passes through the centre of the wheel and does not turn it. So it meets the rail at the contact and the wheel at its hub, with the
/// receptance T of both along the rail, and slip begins without any creep force:
///
/// ```text
/// s₁/V = −ik [(H f₁)_x + T N]            of a rigid wheel alone, T = −1/(Mω²): −P₀ Δ p/(M V²)
/// ```
///
/// That is the energy of a mass which climbs, ½MV² + P₀r. A wheel whose hub moves under N does so under creep forces too: its own
/// receptance along the rail must contain T. The component of the creep force along the normal, −Q₀r', is 10⁻³ of P₁ and less, and
/// left out.
///
/// Source: derived in the book. Range of validity: to first order in the slope, a contact in a point; over an ellipse the slope that counts is
/// 3j₁(ka)/(ka) of it, 0.95 at λ = 9a.
#[derive(Clone)]
pub enum NormalDirection {
    /// Of a wheel without a partner \[m/N\].
    Lone(Arc<dyn Receptance>),
    /// Of wheelsets, alike wherever they stand.
    OfWheelsets(Arc<dyn WheelsetWithHubs>),
}

impl NormalDirection {
    /// Displacement of each wheel at its place, a distance along the rail \[m\] and the rail, per force through the hub of each
    /// \[m/N\], at one angular frequency \[rad/s\] after the other: matrices by rows, one behind the other.
    pub(super) fn between(
        &self,
        angular_frequencies: &[f64],
        speed: f64,
        places: &[(f64, Rail)],
        matrices: &mut [Complex64],
    ) {
        let size = places.len() * places.len();
        match self {
            Self::Lone(receptance) => {
                for (index, &w) in angular_frequencies.iter().enumerate() {
                    alone(receptance.receptance(w, speed), places, &mut matrices[index * size..][..size]);
                }
            }
            Self::OfWheelsets(wheelset) => wheelset.hubs_at(angular_frequencies, &mut |index, hubs| {
                on_axles(hubs, places, &mut matrices[index * size..][..size]);
            }),
        }
    }

    /// Part A \[1/kg\] of [`between`](Self::between), −A/ω² for ω → 0.
    pub(super) fn free(&self, places: &[(f64, Rail)]) -> Vec<f64> {
        let mut free = vec![0.0; places.len() * places.len()];
        match self {
            Self::Lone(receptance) => alone(receptance.free(), places, &mut free),
            Self::OfWheelsets(wheelset) => on_axles(&wheelset.free_hubs(), places, &mut free),
        }
        free
    }
}

/// Fill a matrix between places by rows, of wheels that do not feel each other.
fn alone<T: Copy + Default>(own: T, places: &[(f64, Rail)], matrix: &mut [T]) {
    for (entry, (at, from)) in matrix.iter_mut().zip(pairs(places)) {
        *entry = if at == from { own } else { T::default() };
    }
}

/// Fill a matrix between places by rows, of wheels that feel the other one on their axle.
fn on_axles<T: Copy + Default>(own: &[[T; 2]; 2], places: &[(f64, Rail)], matrix: &mut [T]) {
    for (entry, ((along, rail), (from, of))) in matrix.iter_mut().zip(pairs(places)) {
        *entry = if along == from { own[*rail as usize][*of as usize] } else { T::default() };
    }
}
