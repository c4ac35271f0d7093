//! How near a contact is to flow under the forces of an instant.

use std::sync::OnceLock;

use riffel_numerics::cubic::{cubic_at, hermite};

use super::{Demand, ShakedownLimit};

/// Intervals of the utilised friction from zero to one.
const INTERVALS: usize = 256;

/// The demand u = p₀(P)/(k S(f)) under any load and force, p₀ as P^⅓ of the mean state; zero without a load. The curvature κ of a wave
/// multiplies it by a power of 1 + κ, which has the slope of the patch at κ = 0.
///
/// Method: 1/S by its values and slopes at every 256th of the utilised friction, each computed when it is first asked for. Error: 1e-6,
/// but for a part in a thousand within one step of the friction at which the maximum comes to the surface. Above a friction of one it
/// stays on the line of 1/f.
#[derive(Debug)]
pub(crate) struct MomentaryDemand {
    /// p₀/k of the mean state, over the cube root of its load.
    per_root: f64,
    /// d ln u/dκ.
    by_curvature: f64,
    limit: ShakedownLimit,
    /// 1/S and its change over an interval at its slope.
    nodes: Vec<OnceLock<[f64; 2]>>,
}

impl MomentaryDemand {
    /// That of a mean state.
    pub(crate) fn new(demand: &Demand) -> Self {
        Self {
            per_root: demand.contact_pressure / demand.shear_yield / demand.load.cbrt(),
            by_curvature: demand.by_curvature / demand.value,
            limit: demand.limit,
            nodes: (0..=INTERVALS).map(|_| OnceLock::new()).collect(),
        }
    }

    /// X = u − 1 under a load P, forces along and across the rail \[N\] and a curvature κ.
    pub(crate) fn excess(&self, load: f64, [along, across]: [f64; 2], curvature: f64) -> f64 {
        if load <= 0.0 {
            return -1.0;
        }
        let flat = self.per_root * load.cbrt() * self.per_limit(along.hypot(across) / load);
        flat * (1.0 + curvature).max(0.0).powf(self.by_curvature) - 1.0
    }

    /// 1/S.
    fn per_limit(&self, friction: f64) -> f64 {
        if self.limit == ShakedownLimit::Surface {
            return friction;
        }
        let place = (friction * INTERVALS as f64).min(INTERVALS as f64);
        let index = (place as usize).min(INTERVALS - 1);
        let [[from, rise], [to, fall]] =
            [index, index + 1].map(|index| *self.nodes[index].get_or_init(|| self.node(index)));
        cubic_at(hermite([from, to], [rise, fall]), place - index as f64)
    }

    fn node(&self, index: usize) -> [f64; 2] {
        let [limit, slope] = self.limit.at(index as f64 / INTERVALS as f64);
        [limit.recip(), -slope / limit / INTERVALS as f64]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{CreepForces, Creepages, MeanRolling};

    fn demand(limit: ShakedownLimit, load: f64, force: f64) -> Demand {
        let steady = MeanRolling {
            normal_force: load,
            friction: 0.4,
            creepages: Creepages::default(),
            forces: CreepForces { longitudinal: force, lateral: 0.0 },
        };
        Demand::new(&steady, 1e9, 300e6, limit).unwrap()
    }

    /// At the mean state it is the demand, and its slopes are those of the linear loop, for every limit.
    #[test]
    fn about_the_mean_state_it_is_linear() {
        let ratio = 1.2;
        for limit in [ShakedownLimit::Line, ShakedownLimit::Surface, ShakedownLimit::Subsurface { ratio }] {
            let (load, force) = (60e3, 0.21 * 60e3);
            let mut linear = demand(limit, load, force);
            linear.by_curvature = 0.4 * linear.value;
            let momentary = MomentaryDemand::new(&linear);
            let over = |curvature| momentary.excess(load, [force, 0.0], curvature);
            let by_curvature = (over(1e-4) - over(-1e-4)) / 2e-4;
            let off = by_curvature / linear.by_curvature - 1.0;
            assert!(off.abs() < 1e-5, "{limit:?}: {off:e}");
            let at = |load, force| momentary.excess(load, [force, 0.0], 0.0);
            assert!((at(load, force) - linear.excess()).abs() < 1e-6);
            let by_load = (at(load + 10.0, force) - at(load - 10.0, force)) / 20.0;
            let by_force = (at(load, force + 10.0) - at(load, force - 10.0)) / 20.0;
            let scale = linear.value / load;
            assert!((by_load - linear.by_load).abs() < 1e-3 * scale, "{limit:?}");
            let off = (by_force - linear.by_force[0]).abs();
            assert!(off < 1e-3 * scale, "{limit:?}: {by_force:e}");
            assert_eq!(at(0.0, 0.0), -1.0);
        }
    }
}
