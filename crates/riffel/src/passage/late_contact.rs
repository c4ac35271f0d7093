//! A contact that answers late, in time.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::track_motion::TrackMotion;
use super::vector_fitting::{Sampled, residues, shared_poles, starting_lines};
use super::{ContactInTime, ContactInstant, ImpulseResponse};
use crate::Error;
use crate::contact::{CreepLaw, RollingContact};

/// What a contact makes of the past of its load and creepage over the distance rolled.
///
/// About a mean state the response of the exact theory to an oscillation of load or creepage at the wavenumber k is that of
/// the steady law times a factor R(k), which is one for long waves. Each R is the transfer function of a causal
/// filter over distance, Σ r_j/(ik − p_j). In time the steady law is asked at the filtered load and creepage:
///
/// ```text
/// Q = Q_s(P₀ + R_P ∗ (P − P₀), ξ₀ + R_ξ ∗ (ξ − ξ₀)),     |Q| ≤ μP
/// e = Q_s ξ at the same with filters of their own, the energy that a place of the rail receives
/// ```
///
/// To first order that is the exact theory; far from the mean state it is the steady law for slow changes, and the
/// lateness is that of the mean state. Of the energy a place receives a part before the wheel is above it, so that it is
/// told for the place [`behind`](Self::behind), which the patch has left.
#[derive(Debug, Clone, PartialEq)]
pub struct LateContact {
    /// Of the force, by load and by creepage.
    force: [ImpulseResponse; 2],
    /// Of the energy at the rail.
    energy: [ImpulseResponse; 2],
    behind: f64,
    largest_error: f64,
}

impl LateContact {
    /// The filters of a contact beside the steady law of its mean state, fitted to its response at wavelengths from `shortest` to
    /// `longest` \[m\], a hundred semi-axes or so, from where on they are constant; `semi_axis` along the rail \[m\].
    ///
    /// Method: vector fitting with the same poles for all four. Accuracy: 6·10⁻⁵ of the response to slow changes for wavelengths from a
    /// semi-axis on and 0.1 ≤ τ ≤ 0.95 (test `filters_are_the_response`).
    ///
    /// # Errors
    /// [`Error::NotConverged`] if they miss the response by more than a hundredth, or it is not known over that range.
    pub fn new(
        contact: &dyn RollingContact,
        law: &dyn CreepLaw,
        semi_axis: f64,
        [shortest, longest]: [f64; 2],
    ) -> Result<Self, Error> {
        const TO_AN_OCTAVE: f64 = 8.0;
        /// Poles, pairs counted twice: twice as many halve the error.
        const ORDER: usize = 12;
        const MOST_MISSED: f64 = 0.01;
        let steady = contact.steady();
        let at_once = law.derivatives(steady.normal_force, steady.creepages);
        let (creepage, force) = (steady.creepages.longitudinal, steady.forces.longitudinal);
        let by_load = at_once.by_normal_force.longitudinal;
        let by_creepage = at_once.by_longitudinal.longitudinal;
        let count = ((longest / shortest).log2() * TO_AN_OCTAVE).ceil() as usize;
        let wavenumbers: Vec<f64> =
            (0..=count).map(|index| TAU / longest * (longest / shortest).powf(index as f64 / count as f64)).collect();
        let ratios = |wavenumber: &f64| {
            let response = contact.response(TAU / wavenumber);
            let (load, turn) = (response.by_load, response.by_longitudinal);
            // Told when the place is a semi-axis behind.
            let later = Complex64::from_polar(1.0, -wavenumber * semi_axis);
            [
                load.force[0] / by_load,
                turn.force[0] / by_creepage,
                load.at_rail(0.0) * later / (creepage * by_load),
                turn.at_rail(0.0) * later / (force + creepage * by_creepage),
            ]
        };
        let rows: Vec<[Complex64; 4]> = wavenumbers.iter().map(ratios).collect();
        let functions: Vec<Vec<Complex64>> =
            (0..4).map(|function| rows.iter().map(|row| row[function]).collect()).collect();
        let sizes = vec![1.0; wavenumbers.len()];
        let sampled: Vec<Sampled<'_>> = functions.iter().map(|values| Sampled { values, sizes: &sizes }).collect();
        let band = [wavenumbers[0], wavenumbers[count]];
        let starting = starting_lines(band, wavenumbers[count], ORDER);
        let poles = shared_poles(&wavenumbers, &sampled, &starting);
        let mut filters = residues(&wavenumbers, &functions, &sizes, &poles)
            .into_iter()
            .map(|fractions| ImpulseResponse::new(fractions, None, 0.0, 0.0));
        let mut next = || filters.next().unwrap_or_else(|| ImpulseResponse::new(Vec::new(), None, 0.0, 1.0));
        let late = Self { force: [next(), next()], energy: [next(), next()], behind: semi_axis, largest_error: 0.0 };
        let missed = wavenumbers.iter().zip(&rows).flat_map(|(k, row)| {
            let got = late.filters().map(|filter| filter.receptance(*k));
            got.into_iter().zip(*row).map(|(got, value)| (got - value).norm())
        });
        // Not a number is no small error.
        let largest_error = missed.fold(0.0, |largest: f64, error| match error <= largest {
            true => largest,
            false => error,
        });
        if largest_error.is_nan() || largest_error > MOST_MISSED {
            return Err(Error::NotConverged {
                problem: "filters for the response of the contact",
                residual: largest_error,
                tolerance: MOST_MISSED,
                remedy: "try another grid (contact.grid)",
            });
        }
        Ok(Self { largest_error, ..late })
    }

    fn filters(&self) -> [&ImpulseResponse; 4] {
        let ([force_by_load, force_by_creepage], [by_load, by_creepage]) = (&self.force, &self.energy);
        [force_by_load, force_by_creepage, by_load, by_creepage]
    }

    /// How far behind the wheel centre the place is whose energy is told \[m\].
    pub fn behind(&self) -> f64 {
        self.behind
    }

    /// Largest error of a filter, as a part of the response to slow changes.
    pub fn largest_error(&self) -> f64 {
        self.largest_error
    }
}

/// The filters under way.
#[derive(Debug, Clone)]
pub(super) struct LateMotion {
    /// In the order of [`LateContact::filters`].
    filters: [TrackMotion; 4],
    /// What they make of the past, before the step's own end is known.
    past: [f64; 4],
}

impl LateMotion {
    /// At rest, for steps of the given length \[m\].
    pub(super) fn new(late: &LateContact, step: f64) -> Self {
        Self {
            // The filters are over distance: a speed of one metre a metre.
            filters: late.filters().map(|filter| TrackMotion::new(filter, step, 1.0, 0.0)),
            past: [0.0; 4],
        }
    }

    /// A step of a contact begins, under which the wave has the curvature κ: it feels the slip speed, over V.
    pub(super) fn advance(&mut self, contact: &ContactInTime, now: &ContactInstant, curvature: f64) {
        self.advance_by([
            now.normal_force - contact.spring.normal_force(),
            now.creepage / (1.0 + curvature) - contact.mean.creepages.longitudinal,
        ]);
    }

    /// Advance with load and creepage beside their means.
    fn advance_by(&mut self, [load, creepage]: [f64; 2]) {
        let inputs = [load, creepage, load, creepage];
        for ((filter, past), input) in self.filters.iter_mut().zip(&mut self.past).zip(inputs) {
            *past = filter.advance(input);
        }
    }

    /// Load \[N\] and slip speed over V at which the law is asked for the force, if the step ends with these.
    pub(super) fn for_force(&self, contact: &ContactInTime, load: f64, creepage: f64) -> (f64, f64) {
        self.filtered([0, 1], contact, load, creepage)
    }

    /// Those for the energy.
    pub(super) fn for_energy(&self, contact: &ContactInTime, load: f64, creepage: f64) -> (f64, f64) {
        self.filtered([2, 3], contact, load, creepage)
    }

    fn filtered(&self, filters: [usize; 2], contact: &ContactInTime, load: f64, creepage: f64) -> (f64, f64) {
        let mean = [contact.spring.normal_force(), contact.mean.creepages.longitudinal];
        let [filtered_load, filtered_creepage] = self.beside_mean(filters, [load - mean[0], creepage - mean[1]]);
        (mean[0] + filtered_load, mean[1] + filtered_creepage)
    }

    fn beside_mean(&self, filters: [usize; 2], at_end: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|input| {
            let filter = filters[input];
            self.past[filter] + self.filters[filter].by_new_force() * at_end[input]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticMaterial;
    use crate::contact::{
        Creepages, HalfSpace, HalfSpaceCurve, HertzContact, NonSteady, OscillatingCreepages, TransientRolling,
    };

    /// At tractive ratios and a wavelength between those fitted, and for slow changes: their ratio is one but for what grid and
    /// similarity differ by, a hundredth.
    #[test]
    fn filters_are_the_response() -> Result<(), Error> {
        let steel = ElasticMaterial::new(207e9, 0.3)?;
        let hertz = HertzContact::new(steel, 0.46, 0.3, 50e3)?;
        let contact = HalfSpace::new(hertz, 0.4, 24)?;
        let a = hertz.semi_axis_longitudinal();
        for ratio in [0.1, 0.95] {
            let state = contact.roll_at_tractive_ratio(ratio)?;
            let curve = HalfSpaceCurve::new(&contact, &state)?;
            let longitudinal = OscillatingCreepages::Longitudinal;
            let table = NonSteady::new(&contact, &state, longitudinal, 1.01 * a, 100.0 * a, 1e-4)?;
            let late = LateContact::new(&table, &curve, a, [1.01 * a, 100.0 * a])?;
            assert!(late.largest_error() < 6e-5, "{ratio}: {:e}", late.largest_error());
            for filter in late.filters() {
                assert!((filter.receptance(0.0) - 1.0).norm() < 2e-2);
            }
            let wavelength = 2.345 * a;
            let force = curve.derivatives(50e3, table.steady().creepages).by_longitudinal;
            let expected = table.response(wavelength).by_longitudinal.force[0];
            let got = late.force[1].receptance(TAU / wavelength) * force.longitudinal;
            assert!((got - expected).norm() < 1e-4 * force.longitudinal);
        }
        Ok(())
    }

    /// Creepage that swings by a half and load by a fifth, over five semi-axes, against the half-space in steps: the filters of the mean
    /// state miss 5 % of the oscillation of the force (3 to 7 % at τ = 0.3 and 0.7 and over 3 to 12 semi-axes, the first-order error of
    /// the steps on this grid included), the steady law alone more than all of it.
    #[test]
    fn far_from_the_mean_state() -> Result<(), Error> {
        const ACROSS: usize = 24;
        const FRICTION: f64 = 0.4;
        const LOAD: f64 = 50e3;
        let steel = ElasticMaterial::new(207e9, 0.3)?;
        let hertz = |load: f64| HertzContact::new(steel, 0.46, 0.3, load);
        let a = hertz(LOAD)?.semi_axis_longitudinal();
        let contact = HalfSpace::new(hertz(LOAD)?, FRICTION, ACROSS)?;
        let state = contact.roll_at_tractive_ratio(0.5)?;
        let curve = HalfSpaceCurve::new(&contact, &state)?;
        let range = [1.01 * a, 100.0 * a];
        let longitudinal = OscillatingCreepages::Longitudinal;
        let table = NonSteady::new(&contact, &state, longitudinal, range[0], range[1], 1e-4)?;
        let late = LateContact::new(&table, &curve, a, range)?;
        let mean = table.steady().creepages.longitudinal;
        let mut stepped = TransientRolling::new(hertz(1.25 * LOAD)?, FRICTION, ACROSS)?;
        let step = stepped.step_length();
        let mut motion = LateMotion::new(&late, step);
        let at = |steps: f64| {
            let turn = TAU * steps * step / (5.0 * a);
            [LOAD * (1.0 + 0.2 * turn.cos()), mean * (1.0 + 0.5 * (turn + 1.0).cos())]
        };
        let law = |load: f64, creepage: f64| {
            let forces = curve.forces(load, Creepages::longitudinal(creepage));
            forces.longitudinal
        };
        let (settling, wave) = ((8.0 * a / step) as usize, (5.0 * a / step) as usize);
        let mut forces = Vec::new();
        for index in 1..=settling + wave {
            let [before, middle, now] = [1.0, 0.5, 0.0].map(|back| at(index as f64 - back));
            let exact = stepped.roll(now[0], Creepages::longitudinal(middle[1]))?;
            motion.advance_by([before[0] - LOAD, before[1] - mean]);
            let beside = motion.beside_mean([0, 1], [now[0] - LOAD, now[1] - mean]);
            if index > settling {
                forces.push([exact.forces.longitudinal, law(LOAD + beside[0], mean + beside[1]), law(now[0], now[1])]);
            }
        }
        let oscillation = |of: &dyn Fn(&[f64; 3]) -> f64| {
            let values: Vec<f64> = forces.iter().map(of).collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let square = values.iter().map(|value| (value - mean).powi(2));
            square.sum::<f64>().sqrt()
        };
        let exact = oscillation(&|row| row[0]);
        let (by_late, by_steady) =
            (oscillation(&|row| row[1] - row[0]) / exact, oscillation(&|row| row[2] - row[0]) / exact);
        assert!(by_late < 0.05 && by_steady > 1.0, "{by_late} {by_steady}");
        Ok(())
    }
}
