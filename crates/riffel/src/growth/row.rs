//! Ŵ₁ along a row of wavelengths at one speed: the inner loop of every map.

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;
use pulp::Arch;

use super::closing::Closing;
use crate::damage::Oscillation;
use crate::feedback::{Answers, ClosedForm, Derivative, Derivatives, Loop, System};
use crate::receptance::Tabulated;
use crate::tile::{Frequencies, SplitComplex, TILE, Tile};

/// Relative accuracy of a tabulated track receptance.
const TABLE_TOLERANCE: f64 = 1e-9;

/// Evaluates the loop row by row over fixed wavelengths, with all that depends on the wavelength
/// alone done beforehand.
///
/// Method: tiles of [`TILE`] wavelengths; in each, one dynamic call to every joint, then one pass in the
/// widest vector instructions of the machine. Exact to rounding. Cost: some seven nanoseconds a point
/// for the free beam, see `benches/README.md`. Holds scratch for one tile; make one evaluator per
/// thread with `clone`.
///
/// The loop on all axes is solved for as many wavelengths at once as a vector register holds.
#[derive(Clone)]
pub struct RowEvaluator(Kind);

#[derive(Clone)]
enum Kind {
    Tiles(Box<Tiles>),
    AllAxes(AllAxes),
}

/// The loop that has a closed form, by tiles.
#[derive(Clone)]
struct Tiles {
    feedback: ClosedForm,
    columns: Arc<[Columns]>,
    scratch: Box<Scratch>,
    arch: Arch,
}

/// The loop on all axes, by groups of wavelengths.
#[derive(Clone)]
struct AllAxes {
    feedback: Loop,
    system: Box<System>,
    groups: Arc<[Answers]>,
}

/// What a tile of wavelengths fixes, whatever the speed; the last is filled up with its last
/// wavelength.
///
/// With z : y the ratio of the creep force to the speed of the wheel's surface, eliminating the creepage −y/V from
/// (13), (14) leaves Ŵ₁ = (by_force z + by_speed y/V) / ((H + H_w + 1/k_H)(z + slip y/V)), and the wave's own geometry adds
/// (by_force z + by_speed y/V)/(z + slip y/V) with two columns of its own.
struct Columns {
    /// 2π/λ \[rad/m\].
    wavenumber: Tile,
    /// λ/2π \[m/rad\].
    per_wavenumber: Tile,
    /// Q_ξ.
    slip: SplitComplex,
    /// Ŵ₁ of all damage whose rate does not depend on the amplitude.
    growth: Output,
    /// What the other laws take; `None` if there are none.
    clipped: Option<Box<Clipped>>,
}

/// What one output, Ŵ₁ or another, takes of the inputs of a contact.
struct Output {
    /// e_P Δ/(μP₀ξ₀), as a point of the rail receives it.
    by_force: SplitComplex,
    /// (e_P Q_ξ − e_ξ Q_P) Δ/(μP₀ξ₀), likewise.
    by_speed: SplitComplex,
    /// e_ξ Δ/(μP₀ξ₀); `None` if normal forces do not turn with the wave. What slip that makes of itself cancels from the column by speed.
    by_creepage: Option<SplitComplex>,
    /// Of the wave's own geometry e_r Δ/(μP₀ξ₀) and (e_r Q_ξ − e_ξ Q_r) Δ/(μP₀ξ₀), r the profile; `None` if it has no part.
    wave: Option<[SplitComplex; 2]>,
}

/// What damage takes whose rate depends on the amplitude.
struct Clipped {
    /// u₁, where a law takes it.
    demand: Option<Output>,
    /// e₁ at a point of the rail \[J/m\], where a law takes it.
    energy: Option<Output>,
    /// Δ times the share of the profile that presses \[m\], where a law takes the load.
    pressed: Option<Tile>,
    /// Ŵ₁ over u₁ at small amplitudes, and the square of the size up to which that holds.
    small: SplitComplex,
    small_to: f64,
}

/// What a tile and a speed give.
#[derive(Clone)]
struct Scratch {
    frequencies: Frequencies,
    track: SplitComplex,
    wheel: SplitComplex,
    speeds: SplitComplex,
    direction: SplitComplex,
    result: SplitComplex,
}

impl Columns {
    fn new(feedback: &ClosedForm, wavelengths: &[f64]) -> Self {
        let last = wavelengths.len() - 1;
        let wavelengths: Tile = std::array::from_fn(|j| wavelengths[j.min(last)]);
        let amplitude = feedback.amplitude;
        let scale = amplitude / feedback.steady.full_slip_energy_per_metre();
        let contact = &feedback.contact;
        let at = wavelengths.map(|wavelength| contact.derivatives(wavelength));
        let parts = [contact.wave.is_some(), feedback.hub.is_some()];
        Self {
            wavenumber: wavelengths.map(|wavelength| 2.0 * PI / wavelength),
            per_wavenumber: wavelengths.map(|wavelength| wavelength / (2.0 * PI)),
            slip: SplitComplex::from_fn(|j| at[j].by_creepage[0].force[0]),
            growth: Output::new(&at, parts, scale, |by| by.growth),
            clipped: contact.clipped_damage().map(|damage| {
                let demand = || Output::new(&at, parts, amplitude, |by| by.demand);
                let energy = || Output::new(&at, parts, amplitude, |by| by.dissipated);
                let (aside, along, small_to) = damage.small_demand();
                let depth = contact.mean_of_damage().wear * feedback.steady.full_slip_energy_per_metre();
                Box::new(Clipped {
                    demand: damage.takes_demand().then(demand),
                    energy: damage.takes_energy().then(energy),
                    pressed: (damage.takes_load()).then(|| std::array::from_fn(|j| amplitude * at[j].pressed)),
                    small: SplitComplex::from_fn(|j| {
                        let wavenumber = 2.0 * PI / wavelengths[j];
                        Complex64::new(aside, wavenumber * along) / depth
                    }),
                    small_to: small_to * small_to,
                })
            }),
        }
    }
}

impl Output {
    fn new(at: &[Derivatives; TILE], [waves, turns]: [bool; 2], scale: f64, of: fn(&Derivative) -> Complex64) -> Self {
        let column = |value: &dyn Fn(&Derivatives) -> Complex64| SplitComplex::from_fn(|j| value(&at[j]));
        // [..] of two inputs: what the second makes in the place of the first.
        let cross = |first: &Derivative, at: &Derivatives| {
            let by_creepage = at.by_creepage[0];
            of(first) * by_creepage.force[0] - of(&by_creepage) * first.force[0]
        };
        Self {
            by_force: column(&|at| of(&at.by_load) * scale * at.pressed),
            by_speed: column(&|at| cross(&at.by_load, at) * scale * at.pressed),
            by_creepage: turns.then(|| column(&|at| of(&at.by_creepage[0]) * scale)),
            wave: waves
                .then(|| [column(&|at| of(&at.by_profile) * scale), column(&|at| cross(&at.by_profile, at) * scale)]),
        }
    }
}

impl RowEvaluator {
    /// An evaluator of the loop over the wavelengths \[m\].
    pub fn new(feedback: impl Into<Loop>, wavelengths: &[f64]) -> Self {
        let feedback = feedback.into();
        Self(match feedback.closed_form() {
            Some(closed) => Kind::Tiles(Box::new(Tiles::new((**closed).clone(), wavelengths))),
            None => Kind::AllAxes(AllAxes::new(feedback, wavelengths)),
        })
    }

    /// An evaluator for a whole map, which reads an expensive track receptance from a table good to
    /// 1e-9 where the map is large enough to repay it.
    pub fn for_map(feedback: impl Into<Loop>, wavelengths: &[f64], speeds: &[f64]) -> Self {
        /// Points from which a table of some thousand receptances is a small part of the work.
        const WORTH_A_TABLE: usize = 20_000;
        let feedback = feedback.into();
        if let Some(closed) = feedback.closed_form()
            && closed.track.worth_tabulating()
            && wavelengths.len() * speeds.len() >= WORTH_A_TABLE
        {
            let (shortest, longest) = ends(wavelengths);
            let (slowest, fastest) = ends(speeds);
            let lowest = 2.0 * PI * slowest / longest;
            let highest = 2.0 * PI * fastest / shortest;
            let track = Tabulated::new(closed.track.clone(), lowest, highest, TABLE_TOLERANCE);
            let closed = ClosedForm { track: Arc::new(track), ..(**closed).clone() };
            return Self(Kind::Tiles(Box::new(Tiles::new(closed, wavelengths))));
        }
        Self::new(feedback, wavelengths)
    }

    /// Ŵ₁ of equation (20) at every wavelength for one speed \[m/s\] into `row`, whose length is
    /// that of the wavelengths.
    pub fn evaluate(&mut self, speed: f64, row: &mut [Complex64]) {
        for (index, row) in row.chunks_mut(TILE).enumerate() {
            let values = self.evaluate_tile(speed, index);
            row.copy_from_slice(&values[..row.len()]);
        }
    }

    /// Ŵ₁ at one speed \[m/s\] over one tile of wavelengths.
    // Where the compiler leaves it a call, the result is copied on its way into the map: a third of the time.
    #[inline(always)]
    pub(super) fn evaluate_tile(&mut self, speed: f64, index: usize) -> [Complex64; TILE] {
        match &mut self.0 {
            Kind::Tiles(tiles) => tiles.evaluate(speed, index),
            Kind::AllAxes(axes) => axes.evaluate(speed, index),
        }
    }
}

impl Tiles {
    fn new(feedback: ClosedForm, wavelengths: &[f64]) -> Self {
        Self {
            columns: wavelengths.chunks(TILE).map(|wavelengths| Columns::new(&feedback, wavelengths)).collect(),
            feedback,
            scratch: Box::new(Scratch {
                frequencies: Frequencies { angular: [0.0; TILE], reciprocal: [0.0; TILE] },
                track: SplitComplex::ZERO,
                wheel: SplitComplex::ZERO,
                speeds: SplitComplex::ZERO,
                direction: SplitComplex::ZERO,
                result: SplitComplex::ZERO,
            }),
            arch: Arch::new(),
        }
    }

    #[inline(always)]
    fn evaluate(&mut self, speed: f64, index: usize) -> [Complex64; TILE] {
        let columns = &self.columns[index];
        let per_speed = speed.recip();
        let joints = &self.feedback;
        let scratch = &mut *self.scratch;
        let frequencies = &mut scratch.frequencies;
        frequencies.angular = columns.wavenumber.map(|wavenumber| wavenumber * speed);
        frequencies.reciprocal = columns.per_wavenumber.map(|length| length * per_speed);
        joints.track.receptances(frequencies, speed, &mut scratch.track);
        joints.wheel.receptances(frequencies, speed, &mut scratch.wheel);
        joints.rotation.speeds(frequencies, speed, &mut scratch.speeds);
        if let Some(hub) = &joints.hub {
            let slips = &mut scratch.direction;
            hub.receptances(frequencies, speed, slips);
            let parts = slips.re.iter_mut().zip(&mut slips.im);
            for ((re, im), k) in parts.zip(&columns.wavenumber) {
                let load = joints.steady.normal_force * k * k;
                (*re, *im) = (*re * load, *im * load);
            }
        }
        let arch = self.arch;
        let mut close = |output: &Output| {
            arch.dispatch(Closing {
                track: &scratch.track,
                wheel: &scratch.wheel,
                speeds: &scratch.speeds,
                by_force: &output.by_force,
                by_speed: &output.by_speed,
                slip: &columns.slip,
                wave: output.wave.as_ref(),
                direction: (output.by_creepage.as_ref()).map(|by_creepage| [by_creepage, &scratch.direction]),
                force: joints.rotation.force(),
                contact: joints.contact.stiffness.recip(),
                per_speed,
                result: &mut scratch.result,
            });
            scratch.result.joined()
        };
        let mut growth = close(&columns.growth);
        if let Some(clipped) = &columns.clipped {
            let demand = clipped.demand.as_ref().map(&mut close);
            let is_small = |demand: &[Complex64; TILE]| demand.iter().all(|u| u.norm_sqr() <= clipped.small_to);
            // A tile of small waves, and of nothing else, takes no case distinctions.
            if let (Some(demand), None, None) = (&demand, &clipped.energy, &clipped.pressed)
                && is_small(demand)
            {
                let small = &clipped.small;
                for (j, (growth, u)) in growth.iter_mut().zip(demand).enumerate() {
                    growth.re += small.re[j] * u.re - small.im[j] * u.im;
                    growth.im += small.re[j] * u.im + small.im[j] * u.re;
                }
                return growth;
            }
            let demand = demand.unwrap_or([Complex64::ZERO; TILE]);
            let energy = clipped.energy.as_ref().map(&mut close);
            let energy = energy.unwrap_or([Complex64::ZERO; TILE]);
            let [track, wheel] = [&scratch.track, &scratch.wheel].map(SplitComplex::joined);
            add_clipped(&mut growth, joints, |j| Oscillation {
                demand: demand[j],
                wear: Complex64::ZERO,
                energy: energy[j],
                load: clipped.pressed.as_ref().map_or(Complex64::ZERO, |pressed| {
                    pressed[j] / (track[j] + wheel[j] + joints.contact.stiffness.recip())
                }),
                receptance: track[j],
                wavenumber: columns.wavenumber[j],
            });
        }
        growth
    }
}

/// Add the damage whose rate depends on the amplitude to Ŵ₁.
fn add_clipped(growth: &mut [Complex64; TILE], joints: &ClosedForm, at: impl Fn(usize) -> Oscillation) {
    let Some(damage) = joints.contact.clipped_damage() else {
        return;
    };
    let mean = joints.contact.mean_of_damage();
    let depth = mean.wear * joints.steady.full_slip_energy_per_metre();
    for (j, growth) in growth.iter_mut().enumerate() {
        *growth += damage.clipped(mean, &at(j)) / depth;
    }
}

impl AllAxes {
    fn new(feedback: Loop, wavelengths: &[f64]) -> Self {
        let system = Box::new(System::new(&feedback));
        let groups = wavelengths.chunks(system.lanes()).map(|wavelengths| system.answers(&feedback, wavelengths));
        Self { groups: groups.collect(), system, feedback }
    }

    fn evaluate(&mut self, speed: f64, index: usize) -> [Complex64; TILE] {
        let mut tile = [Complex64::ZERO; TILE];
        let lanes = self.system.lanes();
        let groups = &self.groups[index * TILE / lanes..];
        for (values, answers) in tile.chunks_exact_mut(lanes).zip(groups) {
            self.system.solve(&self.feedback, answers, speed);
            let wavelengths = answers.wavelengths();
            let last = wavelengths.len() - 1;
            for (lane, value) in values.iter_mut().enumerate() {
                let wavelength = wavelengths[lane.min(last)];
                *value = self.system.equivalent(&self.feedback, wavelength, speed, lane);
            }
        }
        tile
    }
}

/// Smallest and largest value.
fn ends(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, 0.0), |(least, most), &value| (value.min(least), value.max(most)))
}
