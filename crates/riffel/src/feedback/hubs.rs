//! The direction of the normal force on a wave: what it does along the rail.

use std::sync::Arc;

use num_complex::Complex64;

use crate::wheelset::Wheelset;
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
pub enum Hubs {
    /// Of a wheel without a partner \[m/N\].
    Lone(Arc<dyn Receptance>),
    /// Of wheelsets that tell it, alike wherever they stand.
    OfWheelsets(Arc<dyn Wheelset>),
}

impl Hubs {
    /// Displacement of each wheel at its place, a distance along the rail \[m\] and the rail, per force through the hub of each
    /// \[m/N\], by rows.
    pub(super) fn between(&self, angular_frequency: f64, speed: f64, places: &[(f64, Rail)]) -> Vec<Complex64> {
        let pairs = places.iter().flat_map(|&at| places.iter().map(move |&from| (at, from)));
        match self {
            Self::Lone(receptance) => {
                let own = receptance.receptance(angular_frequency, speed);
                let entry = |(at, from)| if at == from { own } else { Complex64::ZERO };
                pairs.map(entry).collect()
            }
            Self::OfWheelsets(wheelset) => {
                let own = wheelset.hubs(angular_frequency).unwrap_or_default();
                let entry = |((along, rail), (from, of)): ((f64, Rail), (f64, Rail))| match along == from {
                    true => own[rail as usize][of as usize],
                    false => Complex64::ZERO,
                };
                pairs.map(entry).collect()
            }
        }
    }
}
