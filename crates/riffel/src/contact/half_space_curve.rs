//! The creep curve of the exact theory as a law that is asked millions of times.

use riffel_numerics::cubic::{cubic_at, cubic_slope, hermite};

use super::half_space::REMEDY;
use super::{
    CreepDerivatives, CreepForces, CreepLaw, Creepages, ForceLimit, HalfSpace, HalfSpaceRolling, OscillatingCreepages,
};
use crate::Error;

/// Q(P, ξ) of a [`HalfSpace`] in pure longitudinal creepage, through its values and slopes at some twenty creepages. Lateral
/// creepage and spin are ignored.
///
/// One curve serves every normal force, Q = μP f(ξ (P₀/P)^{1/3}), since the patch of a Hertzian ellipse keeps its shape.
/// Between its places the curve is a cubic in the creepage, as Johnson and Vermeulen's law is everywhere. Beyond τ = 0.99 it goes
/// to full slip by the forces alone. Accuracy: 2·10⁻⁴ of μP between the places, 5·10⁻⁴ at another load (test `the_curve_is_that_of_the_half_space`), besides
/// what the grid leaves. Cost: some twenty states of steady rolling with their slopes, half a second; asked, as any law.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfSpaceCurve {
    friction: f64,
    /// P₀ \[N\].
    normal_force: f64,
    /// From no creepage to full slip.
    places: Vec<Place>,
}

/// Creepage, Q/μP₀ and its slope by creepage.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    creepage: f64,
    ratio: f64,
    slope: f64,
}

impl HalfSpaceCurve {
    /// The curve of a contact; the state of steady rolling is one of its places, where value and slope are exact.
    ///
    /// # Errors
    /// Errors of [`HalfSpace::roll`] and [`HalfSpace::response`]; [`Error::NotConverged`] where a force falls or full slip is not reached.
    pub fn new(contact: &HalfSpace, state: &HalfSpaceRolling) -> Result<Self, Error> {
        /// Places in creepages at which the cubic of Johnson and Vermeulen slips fully.
        const PLACES: [f64; 20] = [
            0.0, 0.04, 0.08, 0.13, 0.18, 0.24, 0.3, 0.36, 0.42, 0.48, 0.54, 0.6, 0.66, 0.72, 0.78, 0.84, 0.9, 0.96,
            1.02, 1.1,
        ];
        /// Beyond, each farther by a fifth, full slip must come.
        const FARTHER: f64 = 1.2;
        const FARTHEST: f64 = 6.0;
        /// Of full slip, what the force is that has no more to gain.
        const FULL: f64 = 1.0 - 1e-4;
        let steady = contact.steady(state);
        let (friction, normal_force) = (steady.friction, steady.normal_force);
        let limit = friction * normal_force;
        let at = |state: &HalfSpaceRolling| -> Result<Place, Error> {
            let ratio = state.tangential_force() / limit;
            let slope = match ratio <= HalfSpace::LARGEST_TRACTIVE_RATIO {
                true => {
                    let mut sweep = contact.sweep(state, OscillatingCreepages::Longitudinal.into());
                    sweep.at(f64::INFINITY)?.by_longitudinal.force[0].re / limit
                }
                false => f64::NAN,
            };
            Ok(Place { creepage: state.creepage(), ratio, slope })
        };
        // Full slip of the cubic through the state.
        let scale = state.creepage() / (1.0 - (1.0 - steady.tractive_ratio()).cbrt());
        let mut places = Vec::new();
        let mut step = 0;
        while places.last().is_none_or(|last: &Place| last.ratio < FULL) {
            let place = match PLACES.get(step) {
                Some(place) => *place,
                None => {
                    let beyond = step + 1 - PLACES.len();
                    PLACES[PLACES.len() - 1] * FARTHER.powi(beyond as i32)
                }
            };
            if place > FARTHEST {
                return Err(Error::NotConverged {
                    problem: "creepage of full slip",
                    residual: 1.0 - places.last().map_or(0.0, |last| last.ratio),
                    tolerance: 1.0 - FULL,
                    remedy: REMEDY,
                });
            }
            places.push(at(&contact.roll(place * scale)?)?);
            step += 1;
        }
        // Neighbours so close to the state that a cubic through both would only follow the roundings give way to it.
        let own = at(state)?;
        places.retain(|place| place.creepage == 0.0 || (place.creepage - own.creepage).abs() > 0.01 * scale);
        places.push(own);
        places.sort_by(|one, other| one.creepage.total_cmp(&other.creepage));
        if let Some(last) = places.last_mut() {
            *last = Place { ratio: 1.0, slope: 0.0, ..*last };
        }
        complete(&mut places)?;
        Ok(Self { friction, normal_force, places })
    }

    /// f and its slope at a creepage under P₀, of either sign.
    fn at(&self, creepage: f64) -> [f64; 2] {
        let size = creepage.abs();
        let after = self.places.partition_point(|place| place.creepage <= size);
        let [ratio, slope] = match self.places.get(after.max(1)) {
            None => [1.0, 0.0],
            Some(after_it) => between(&self.places[after.max(1) - 1], after_it, size),
        };
        [ratio * creepage.signum(), slope]
    }
}

/// Value and slope of the cubic of Hermite.
fn between(one: &Place, other: &Place, creepage: f64) -> [f64; 2] {
    let width = other.creepage - one.creepage;
    let t = (creepage - one.creepage) / width;
    let cubic = hermite([one.ratio, other.ratio], [one.slope * width, other.slope * width]);
    [cubic_at(cubic, t), cubic_slope(cubic, t) / width]
}

/// Slopes that are not known, from the chords on both sides, so that the force does not fall (Fritsch & Carlson 1980).
fn complete(places: &mut [Place]) -> Result<(), Error> {
    let chords: Vec<f64> =
        places.windows(2).map(|pair| (pair[1].ratio - pair[0].ratio) / (pair[1].creepage - pair[0].creepage)).collect();
    if let Some(worst) = chords.iter().copied().reduce(f64::min).filter(|worst| *worst < 0.0) {
        return Err(Error::NotConverged {
            problem: "growth of the creep force with creepage",
            residual: -worst,
            tolerance: 0.0,
            remedy: REMEDY,
        });
    }
    for index in 0..places.len() {
        if places[index].slope.is_nan() {
            let (before, after) = (chords[index - 1], chords[index]);
            places[index].slope = match before + after > 0.0 {
                true => 2.0 * before * after / (before + after),
                false => 0.0,
            };
        }
        let around = [index.checked_sub(1), Some(index)].into_iter().flatten();
        let least = around.filter_map(|index| chords.get(index)).copied();
        let most = 3.0 * least.fold(f64::INFINITY, f64::min);
        places[index].slope = places[index].slope.clamp(0.0, most);
    }
    Ok(())
}

impl CreepLaw for HalfSpaceCurve {
    fn friction(&self) -> f64 {
        self.friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let growth = (self.normal_force / normal_force).cbrt();
        CreepForces {
            longitudinal: self.friction * normal_force * self.at(creepages.longitudinal * growth)[0],
            lateral: 0.0,
        }
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let growth = (self.normal_force / normal_force).cbrt();
        let [ratio, slope] = self.at(creepages.longitudinal * growth);
        let limit = self.friction * normal_force;
        let along = |longitudinal: f64| CreepForces { longitudinal, lateral: 0.0 };
        CreepDerivatives::of_ellipse(
            normal_force,
            Creepages::longitudinal(creepages.longitudinal),
            along(limit * ratio),
            along(limit * slope * growth),
            along(0.0),
        )
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        let last = self.places[self.places.len() - 1].creepage;
        ForceLimit::FullSlip(last * (normal_force / self.normal_force).cbrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticMaterial;
    use crate::contact::HertzContact;

    #[test]
    fn the_curve_is_that_of_the_half_space() -> Result<(), Error> {
        let steel = ElasticMaterial::new(207e9, 0.3)?;
        let hertz = HertzContact::new(steel, 0.46, 0.3, 50e3)?;
        let contact = HalfSpace::new(hertz, 0.4, 32)?;
        let state = contact.roll_at_tractive_ratio(0.37)?;
        let curve = HalfSpaceCurve::new(&contact, &state)?;
        let limit = 0.4 * 50e3;
        let exact = contact.response(&state, f64::INFINITY)?;
        let derivatives = curve.derivatives(50e3, Creepages::longitudinal(state.creepage()));
        let slope = derivatives.by_longitudinal.longitudinal;
        assert!((slope / exact.by_longitudinal.force[0].re - 1.0).abs() < 1e-9);
        let by_load = derivatives.by_normal_force.longitudinal;
        // Kalker's similarity, against the response to the load on a coarse grid.
        assert!((by_load / exact.by_load.force[0].re - 1.0).abs() < 1e-2);
        for ratio in [0.1, 0.25, 0.55, 0.8, 0.95] {
            let creepage = contact.roll_at_tractive_ratio(ratio)?.creepage();
            let got = curve.forces(50e3, Creepages::longitudinal(creepage)).longitudinal / limit;
            assert!((got - ratio).abs() < 2e-4, "{ratio}: {got}");
        }
        // Another load on the same bodies.
        let heavy = HalfSpace::new(HertzContact::new(steel, 0.46, 0.3, 80e3)?, 0.4, 32)?;
        let rolling = heavy.roll_at_tractive_ratio(0.6)?;
        let forces = curve.forces(80e3, Creepages::longitudinal(-rolling.creepage()));
        assert!((forces.longitudinal / (0.4 * 80e3) + 0.6).abs() < 5e-4);
        Ok(())
    }
}
