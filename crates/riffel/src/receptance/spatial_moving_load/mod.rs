//! Rail on discrete supports under loads that move along it and oscillate, down and across.

use std::f64::consts::TAU;

use num_complex::Complex64;
use riffel_numerics::square::Square;

use super::quadrature_over_wavenumbers::QuadratureOverWavenumbers;
use super::spatial_track::Motions;
use super::twisting_rail::{CoupledWave, Foundation, LateralReceptance, TwistingRail};
use super::{Beam, MovingLoadTrack, SpatialTrack, Supports, Waveguide};
use crate::{Error, Place};

/// A [`SpatialTrack`] on supports at x = 0, ±d, ±2d, … under loads that oscillate and pass them together at the speed V.
///
/// A force e^{iωt} at x = Vt + ξ_b moves the rail at x = Vt + ξ_a by Σ_n Ĥ_n(ω) e^{i(ω + nΩ)t}, Ω = 2πV/d, with one matrix
/// over places and axes for each n. It is [`MovingLoadOnSupports`](super::MovingLoadOnSupports) for several loads and for
/// motions that are coupled: with G(k) the 2 × 2 receptance of the free rail for a wave e^{ikx} in v and θ (one number for
/// bending downward), Z what a support takes of them and everything at the frequency ω − kV that a point of the rail feels,
///
/// ```text
/// Ĥ_n = ∫ [G(k) δ_n0 − G(k_n) (1 + ZĜ)⁻¹ Z G(k)/d] e^{i(k_n ξ_a − k ξ_b)} dk/2π,   k_n = k + 2πn/d
/// Ĝ   = Σ_m G(x = md) e^{−ikmd} = Σ_j A_j r_j r_jᵀ sinh α_jd/(cosh α_jd − cos kd)
/// ```
///
/// with the waves r_j e^{−α_j|x|} of the free rail and their amplitudes A_j.
///
/// Along itself the rail is taken on the same supports spread evenly, and at rest: places of a bay differ by some
/// κd/(12EA), 10⁻³ for κ = 40 MN/m every 0.6 m (test `stretch_hardly_feels_places`), and V is 10⁻² of the speed of its waves. A
/// motion that no support holds keeps its receptance at rest.
///
/// Method: from Ĥ₀ the closed form of the track at rest with supports spread evenly is taken away, so that what is left decays
/// like k⁻⁴ or faster where nothing moves; then the trapezoidal rule over all k, cut until no entry changes by
/// [`TOLERANCE`](Self::TOLERANCE), what is left being the cube of the last change. Cost: some thousand points of 1 to 2 µs a
/// frequency for each of both motions, three times as many with every cut where waves decay slowly.
///
/// Source: see [`MovingLoadOnSupports`](super::MovingLoadOnSupports); derived anew for two motions. Range of validity: that of
/// [`SpatialTrack`], below the critical speed of the rail downward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialMovingLoad {
    track: SpatialTrack,
    /// Track on supports spread evenly.
    even: SpatialTrack,
    spacing: f64,
    speed: f64,
}

impl SpatialMovingLoad {
    /// Change of any entry by the last cut of the step of the quadrature, over √|H_ii H_jj| of the even track.
    pub const TOLERANCE: f64 = 1e-3;

    /// A track on discrete supports under loads of the speed V > 0 \[m/s\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the supports are discrete and the speed is positive and below the critical speed downward.
    pub fn new(track: &SpatialTrack, speed: f64) -> Result<Self, Error> {
        Error::unless_positive("speed", speed, "m/s")?;
        let Some(spacing) = track.support_spacing() else {
            return Err(Error::OutOfRange {
                quantity: "support spacing",
                value: 0.0,
                unit: "m",
                rule: "must be that of discrete supports, which loads pass",
            });
        };
        let even = track.spread(spacing)?;
        let down = MovingLoadTrack::new(even.rail().vertical, even.supports().vertical);
        down.check_steady_load(speed)?;
        Ok(Self { track: *track, even, spacing, speed })
    }

    /// Support spacing d \[m\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Speed V \[m/s\].
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Ĥ_n(ω) \[m/N\] for n = −most … most between all places, whose distances ξ count from the point x = Vt, at the angular
    /// frequency ω ≥ 0 \[rad/s\].
    ///
    /// # Errors
    /// [`Error::UndampedWaves`] where the quadrature does not converge: a wave runs on without loss.
    pub fn harmonics(&self, angular_frequency: f64, places: &[Place], most: usize) -> Result<HarmonicMatrices, Error> {
        let w = angular_frequency.max(AT_REST);
        let mut alongs: Vec<f64> = Vec::new();
        for place in places {
            if !alongs.contains(&place.along) {
                alongs.push(place.along);
            }
        }
        let rail = self.track.rail();
        let supports = self.track.supports();
        let of = |motion: Motion| self.along_bay(&motion, w, &alongs, most);
        let down = supports.vertical.map(|_| of(Motion::Down(rail.vertical))).transpose()?;
        let across = match (rail.lateral, rail.twist) {
            (Some(bending), Some(twist)) => Some(Motion::Twisting(TwistingRail { bending, twist })),
            (Some(bending), None) => supports.lateral.map(|_| Motion::Across(bending)),
            _ => None,
        };
        let across = across.map(of).transpose()?;
        let at_rest = self.even.waves(w, alongs.clone());
        let number = |place: &Place| alongs.iter().position(|along| *along == place.along);
        let matrices = (0..=2 * most).map(|n| {
            let mut matrix = Vec::with_capacity(places.len() * places.len());
            for at in places {
                for from in places {
                    // Every place is among them.
                    let (to, from_number) = (number(at).unwrap_or(0), number(from).unwrap_or(0));
                    let mut motions = match n == most {
                        true => at_rest.motions(from_number, to),
                        false => Motions::default(),
                    };
                    let entry = (n * alongs.len() + to) * alongs.len() + from_number;
                    if let Some(down) = &down {
                        motions.vertical += down[entry][0][0];
                    }
                    if let Some(across) = &across {
                        add(&mut motions.lateral, &across[entry]);
                    }
                    matrix.push(self.track.entry(&motions, *at, *from));
                }
            }
            matrix
        });
        Ok(HarmonicMatrices { matrices: matrices.collect() })
    }

    /// The answer at x₀ + Vt + ξ_a to an impulse at x₀ + ξ_b, which comes at t = 0, as transfer functions: those of
    /// e^{2πinx₀/d}, n = −most … most, Ĥ_n(ω − nΩ) from ξ_b to ξ_a. By reciprocity it is Ĥ₋ₙ(ω) from −ξ_a to −ξ_b.
    ///
    /// # Errors
    /// Errors of [`harmonics`](Self::harmonics).
    pub fn answers_to_impulses(
        &self,
        angular_frequency: f64,
        places: &[Place],
        most: usize,
    ) -> Result<HarmonicMatrices, Error> {
        let mirrored: Vec<Place> = places.iter().map(|place| Place { along: -place.along, ..*place }).collect();
        let HarmonicMatrices { mut matrices } = self.harmonics(angular_frequency, &mirrored, most)?;
        matrices.reverse();
        let count = places.len();
        for matrix in &mut matrices {
            for row in 1..count {
                for column in 0..row {
                    matrix.swap(row * count + column, column * count + row);
                }
            }
        }
        Ok(HarmonicMatrices { matrices })
    }

    /// Receptances \[m/N\] between all places with supports spread evenly and at rest, by rows.
    pub(crate) fn evenly(&self, angular_frequency: f64, places: &[Place]) -> HarmonicMatrices {
        use super::Structure;
        let mut matrix = vec![Complex64::ZERO; places.len() * places.len()];
        let w = angular_frequency.max(AT_REST);
        self.even.receptance_matrix(w, 0.0, places, &mut matrix);
        HarmonicMatrices { matrices: vec![matrix] }
    }

    /// Ĥ_n of one motion between all distances without the even track at rest: by n, place of the displacement and place of
    /// the force.
    fn along_bay(&self, motion: &Motion, w: f64, alongs: &[f64], most: usize) -> Result<Vec<LateralReceptance>, Error> {
        /// Steps to 2π/d at first, and how often it is cut in three.
        const STEPS: f64 = 32.0;
        const CUTS: u32 = 5;
        /// Beyond this many wavenumbers of the rail nothing is left: 6⁻⁷.
        const REACH: f64 = 6.0;
        let turn = TAU / self.spacing;
        let even = motion.waves(w, Some(self.even.supports()));
        let free = motion.waves(w.max(1.0), None);
        let shortest = free.iter().map(|wave| wave.propagation.im.abs());
        let quadrature = QuadratureOverWavenumbers {
            first: turn / STEPS,
            reach: turn * (most as f64 + 3.0) + REACH * shortest.fold(0.0, f64::max),
            cuts: CUTS,
        };
        let sizes = {
            let mut point = LateralReceptance::default();
            for wave in even.iter() {
                add_wave(&mut point, wave, wave.amplitude);
            }
            [0, 1].map(|index| point[index][index].norm().sqrt())
        };
        let count = (2 * most + 1) * alongs.len() * alongs.len();
        let mut harmonics = vec![LateralReceptance::default(); 2 * most + 1];
        let turns: Vec<Complex64> = alongs.iter().map(|along| Complex64::cis(turn * along)).collect();
        let mut phases = vec![[Complex64::ZERO; 2]; alongs.len()];
        let sums = quadrature.integrals(
            w,
            4 * count,
            |k, sums| {
                self.at_wavenumber(motion, &even, k, w, &mut harmonics);
                // By place the phase of the lowest k_n, and what it turns by from one n to the next.
                let lowest = k - turn * most as f64;
                for (phase, along) in phases.iter_mut().zip(alongs) {
                    *phase = [Complex64::cis(-k * along), Complex64::cis(lowest * along)];
                }
                let mut sums = sums.chunks_exact_mut(4);
                for harmonic in &harmonics {
                    for to in 0..alongs.len() {
                        let arriving = phases[to][1];
                        for [leaving, _] in &phases {
                            let phase = arriving * leaving;
                            let Some(sums) = sums.next() else { return };
                            for (sum, entry) in sums.iter_mut().zip(harmonic.iter().flatten()) {
                                *sum += phase * entry;
                            }
                        }
                        phases[to][1] = arriving * turns[to];
                    }
                }
            },
            |before, now| {
                let mut pairs = before.chunks_exact(4).zip(now.chunks_exact(4));
                pairs.all(|(before, now)| {
                    (0..4).all(|entry| {
                        let size = sizes[entry / 2] * sizes[entry % 2];
                        (now[entry] - before[entry]).norm() <= Self::TOLERANCE * size
                    })
                })
            },
        )?;
        let matrices = sums.chunks_exact(4);
        Ok(matrices.map(|entries| [[entries[0], entries[1]], [entries[2], entries[3]]]).collect())
    }

    /// The integrands of all n at one wavenumber, but for the phases of the places.
    fn at_wavenumber(&self, motion: &Motion, even: &FewWaves, k: f64, w: f64, harmonics: &mut [LateralReceptance]) {
        let rail_frequency = w - k * self.speed;
        let size = rail_frequency.abs().max(AT_REST);
        let free = motion.waves(size, None);
        let stiffness = Square(motion.stiffness(self.track.supports(), size));
        let own = of_wave(&free, k);
        let at_supports = Square(of_supports(&free, k, self.spacing));
        // (1 + ZĜ)⁻¹ Z G/d.
        let resists = (stiffness * at_supports).plus_diagonal(&[Complex64::ONE; 2]);
        let forces = resists.inverse() * (stiffness * Square(own));
        let most = (harmonics.len() / 2) as f64;
        let turn = TAU / self.spacing;
        for (n, slot) in harmonics.iter_mut().enumerate() {
            let there = Square(of_wave(&free, k + turn * (n as f64 - most)));
            let Square(moved) = there * forces;
            *slot = moved.map(|row| row.map(|entry| entry / -self.spacing));
        }
        let zero = &mut harmonics[most as usize];
        add(zero, &own);
        if rail_frequency < 0.0 {
            for entry in harmonics.iter_mut().flatten().flatten() {
                *entry = entry.conj();
            }
        }
        let rest = of_wave(even, k);
        for (entry, rest) in harmonics[most as usize].iter_mut().flatten().zip(rest.iter().flatten()) {
            *entry -= rest;
        }
    }
}

/// Below this angular frequency \[rad/s\] a track is as at rest.
const AT_REST: f64 = 1e-2;

/// Ĥ_n of [`SpatialMovingLoad`] at one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicMatrices {
    /// From the lowest n on, by rows.
    matrices: Vec<Vec<Complex64>>,
}

impl HarmonicMatrices {
    /// Ĥ_n \[m/N\] by rows, the displacement at the i-th of p places per force at the j-th at [i·p + j]; none beyond the
    /// largest |n| asked for.
    pub fn at(&self, order: isize) -> Option<&[Complex64]> {
        let index = order + (self.matrices.len() / 2) as isize;
        let index = usize::try_from(index).ok()?;
        self.matrices.get(index).map(Vec::as_slice)
    }
}

/// A motion of a rail that supports hold, or two that they couple.
enum Motion {
    Down(Beam),
    Across(Beam),
    Twisting(TwistingRail),
}

impl Motion {
    /// Waves on supports spread evenly, or of the free rail.
    fn waves(&self, w: f64, supports: Option<&Supports>) -> FewWaves {
        let beam = |beam: &Beam, foundation: Complex64| {
            let mut few = FewWaves::default();
            for wave in beam.waves(w, foundation).as_slice() {
                few.push(CoupledWave {
                    propagation: wave.propagation,
                    amplitude: wave.amplitude,
                    shape: [Complex64::ONE, Complex64::ZERO],
                });
            }
            few
        };
        let along_first = |supports: &Supports| self.stiffness(supports, w)[0][0];
        match self {
            Self::Down(rail) | Self::Across(rail) => beam(rail, supports.map_or(Complex64::ZERO, along_first)),
            Self::Twisting(rail) => {
                let width = rail.twist.section().foot_width;
                let foundation = supports.map_or(Foundation::NONE, |supports| supports.under_foot(w, width));
                let mut few = FewWaves::default();
                for wave in rail.waves(w, &foundation).as_slice() {
                    few.push(*wave);
                }
                few
            }
        }
    }

    /// Z of a support.
    fn stiffness(&self, supports: &Supports, w: f64) -> LateralReceptance {
        let of = |support: Option<super::Support>| {
            let stiffness = support.map_or(Complex64::ZERO, |support| support.dynamic_stiffness(w));
            [[stiffness, Complex64::ZERO], [Complex64::ZERO; 2]]
        };
        match self {
            Self::Down(_) => of(supports.vertical),
            Self::Across(_) => of(supports.lateral),
            Self::Twisting(rail) => {
                let section = rail.twist.section();
                let foundation = supports.under_foot(w, section.foot_width);
                foundation.at_shear_centre(section.foot_depth)
            }
        }
    }
}

/// At most four waves.
#[derive(Default)]
struct FewWaves {
    waves: [CoupledWave; 4],
    count: usize,
}

impl FewWaves {
    fn push(&mut self, wave: CoupledWave) {
        self.waves[self.count] = wave;
        self.count += 1;
    }

    fn iter(&self) -> impl Iterator<Item = &CoupledWave> {
        self.waves[..self.count].iter()
    }
}

/// G(k): motion by forces e^{ikx} along the rail, where they are one.
fn of_wave(waves: &FewWaves, k: f64) -> LateralReceptance {
    let mut sum = LateralReceptance::default();
    for wave in waves.iter() {
        let alpha = wave.propagation;
        add_wave(&mut sum, wave, 2.0 * wave.amplitude * alpha / (alpha * alpha + k * k));
    }
    sum
}

/// Ĝ: motion at a support by forces e^{ikmd} at all of them, m = 0, ±1, …
fn of_supports(waves: &FewWaves, k: f64, spacing: f64) -> LateralReceptance {
    let half_sine = (0.5 * k * spacing).sin();
    let mut sum = LateralReceptance::default();
    for wave in waves.iter() {
        let half = (0.5 * spacing * wave.propagation).exp();
        let (sinh, cosh) = (0.5 * (half - half.inv()), 0.5 * (half + half.inv()));
        // cosh αd − cos kd without cancellation.
        let distance = 2.0 * (sinh * sinh + half_sine * half_sine);
        add_wave(&mut sum, wave, wave.amplitude * 2.0 * sinh * cosh / distance);
    }
    sum
}

fn add_wave(sum: &mut LateralReceptance, wave: &CoupledWave, strength: Complex64) {
    let [v, theta] = wave.shape;
    sum[0][0] += strength * v * v;
    let across = strength * v * theta;
    sum[0][1] += across;
    sum[1][0] += across;
    sum[1][1] += strength * theta * theta;
}

fn add(sum: &mut LateralReceptance, other: &LateralReceptance) {
    for (sum, other) in sum.iter_mut().flatten().zip(other.iter().flatten()) {
        *sum += other;
    }
}

#[cfg(test)]
mod tests;
