//! Rail on discrete supports under a load that moves and oscillates.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::periodic::AlongBay;
use super::quadrature_over_wavenumbers::QuadratureOverWavenumbers;
use super::{Beam, MovingLoadTrack, PeriodicTrack, Receptance, Support, Waveguide};
use crate::Error;

/// An infinite rail on supports at x = 0, ±d, ±2d, … under a load that oscillates and passes them at the speed V.
///
/// A force e^{iωt} at x = Vt moves the rail under itself by Σ_n Ĥ_n(ω) e^{i(ω + nΩ)t}, Ω = 2πV/d: the passing of supports
/// makes neighbours of every frequency. With the free rail's receptance g(k, ω) of a wave e^{ikx}, the support's
/// dynamic stiffness Z(ω), k_n = k + 2πn/d and everything at the frequency ω − kV that a point of the rail feels,
///
/// Ĥ_n(ω) = ∫ \[g(k) δ_{n0} − g(k) g(k_n) (Z/d)/(1 + ZĜ)\] dk/2π, Ĝ = (1/d) Σ_m g(k_m):
///
/// a wave moves the rail, the supports answer to what Floquet's theorem makes of it, and all waves are summed
/// where the load is then. Ĝ is the closed form of [`PeriodicTrack`]. For V → 0, Σ_n Ĥ_n e^{2πinx/d} is the receptance
/// under a load at x, and always Ĥ_n(ω) = Ĥ_{−n}(ω + nΩ), which is reciprocity.
///
/// Method: from Ĥ₀ the track with supports spread evenly is taken away, [`MovingLoadTrack`], so that what is left
/// decays like k⁻⁴ or faster; the trapezoidal rule over all k, whose error falls exponentially once it resolves the
/// decay of the waves; its step is cut in three until no Ĥ_n changes by [`TOLERANCE`](Self::TOLERANCE) of Ĥ₀. Cost: 1 to
/// 10 thousand points of some 0.5 µs for one frequency.
///
/// Source: the wavenumber form of Sheng, Jones & Thompson (2005), *Responses of infinite periodic structures to moving
/// or stationary harmonic loads*, J. Sound Vib. 282, 125–149; derived anew in the book. Range of validity: that of
/// [`PeriodicTrack`]; waves must decay along the rail, see the error of [`harmonics`](Self::harmonics).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingLoadOnSupports {
    rail: Beam,
    support: Support,
    spacing: f64,
    speed: f64,
    even: MovingLoadTrack,
}

impl MovingLoadOnSupports {
    /// Change of any Ĥ_n by the last cut of the step of the quadrature, over |Ĥ₀|. What is left after it is its cube, as the
    /// error falls exponentially with the reciprocal of the step, which is then a third.
    pub const TOLERANCE: f64 = 1e-3;

    /// A track under a load of the speed V > 0 \[m/s\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the speed is positive and below the critical speed of a load that does not oscillate.
    pub fn new(track: &PeriodicTrack<Beam>, speed: f64) -> Result<Self, Error> {
        Error::unless_positive("speed", speed, "m/s")?;
        let (rail, support, spacing) = track.parts();
        let even = MovingLoadTrack::new(rail, Some(support.per_metre(spacing)?));
        even.check_steady_load(speed)?;
        Ok(Self { rail, support, spacing, speed, even })
    }

    /// Support spacing d \[m\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Speed V \[m/s\].
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Angular frequency Ω = 2πV/d \[rad/s\] at which supports pass.
    pub fn passing(&self) -> f64 {
        TAU * self.speed / self.spacing
    }

    /// Ĥ_n(ω) \[m/N\] for n = −most … most, at the angular frequency ω \[rad/s\], of either sign or zero.
    ///
    /// # Errors
    /// [`Error::UndampedWaves`] where the quadrature does not converge: a wave runs on without loss.
    pub fn harmonics(&self, angular_frequency: f64, most: usize) -> Result<Harmonics, Error> {
        /// Steps to 2π/d at first, and how often it is cut in three.
        const STEPS: f64 = 32.0;
        const CUTS: u32 = 6;
        /// Beyond this many wavenumbers of the rail nothing is left: 6⁻⁷.
        const REACH: f64 = 6.0;
        let w = angular_frequency;
        let turn = TAU / self.spacing;
        let free = self.rail.waves(w.abs().max(1.0), Complex64::ZERO);
        let shortest = free.as_slice().iter().map(|wave| wave.propagation.im.abs());
        let quadrature = QuadratureOverWavenumbers {
            first: turn / STEPS,
            reach: turn * (most as f64 + 3.0) + REACH * shortest.fold(0.0, f64::max),
            cuts: CUTS,
        };
        let even = self.evenly(w);
        let count = 2 * most + 1;
        let mut terms = vec![Complex64::ZERO; count];
        let mut harmonics = quadrature.integrals(
            w,
            count,
            |k, sums| self.add(k, w, sums, &mut terms),
            |before, now| {
                let changes = now.iter().zip(before).map(|(now, before)| now - before);
                let change = changes.map(|change| change.norm()).fold(0.0, f64::max);
                change <= Self::TOLERANCE * (even + now[most]).norm()
            },
        )?;
        harmonics[most] += even;
        Ok(Harmonics(harmonics))
    }

    /// Receptance \[m/N\] with supports spread evenly, which Ĥ₀ would be.
    pub(crate) fn evenly(&self, angular_frequency: f64) -> Complex64 {
        // Where the load does not oscillate, the limit of low frequency.
        let w = angular_frequency.abs().max(1e-3);
        let even = self.even.receptance(w, self.speed);
        match angular_frequency < 0.0 {
            true => even.conj(),
            false => even,
        }
    }

    /// The integrands at one wavenumber.
    fn add(&self, k: f64, w: f64, sums: &mut [Complex64], receptances: &mut [Complex64]) {
        let rail_frequency = w - k * self.speed;
        // The rail at rest is the limit of low frequencies.
        let size = rail_frequency.abs().max(1e-3);
        let free = self.rail.waves(size, Complex64::ZERO);
        let along = AlongBay::new(&free, self.spacing);
        let stiffness = self.support.dynamic_stiffness(size);
        let most = (sums.len() / 2) as f64;
        let turn = TAU / self.spacing;
        for (index, receptance) in receptances.iter_mut().enumerate() {
            let k = k + turn * (index as f64 - most);
            *receptance = along.wave_receptance(k);
        }
        let own = receptances[sums.len() / 2];
        let even = stiffness / self.spacing * own;
        let others = stiffness * (along.support_receptance(k) - own / self.spacing);
        let factor = -even / (1.0 + even + others);
        let conjugate = |value: Complex64| if rail_frequency < 0.0 { value.conj() } else { value };
        for (index, (sum, receptance)) in sums.iter_mut().zip(receptances.iter()).enumerate() {
            *sum += conjugate(match index == receptances.len() / 2 {
                // g(1 + s)/(1 + a + s) − g/(1 + a).
                true => -own * factor * others / (1.0 + even),
                false => receptance * factor,
            });
        }
    }
}

/// Ĥ_n of [`MovingLoadOnSupports`] at one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Harmonics(Vec<Complex64>);

impl Harmonics {
    /// Ĥ_n \[m/N\]; zero beyond the largest |n| asked for.
    pub fn at(&self, order: isize) -> Complex64 {
        let index = order + (self.0.len() / 2) as isize;
        usize::try_from(index).ok().and_then(|index| self.0.get(index).copied()).unwrap_or(Complex64::ZERO)
    }

    /// Ĥ₀ of an evenly supported track alone.
    pub(crate) fn even(receptance: Complex64) -> Self {
        Self(vec![receptance])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{on_sleepers, steel};
    use crate::receptance::{CrossReceptance, Layer};

    fn track() -> PeriodicTrack<Beam> {
        on_sleepers(300.0)
    }

    /// A load that hardly moves is one at rest at each place: to the share of |n| > 8, which falls like n⁻² where
    /// the rail shears.
    #[test]
    fn slow_loads_are_loads_at_rest() {
        let track = track();
        let moving = MovingLoadOnSupports::new(&track, 0.05).unwrap();
        for hertz in [20.0, 150.0, 600.0, 1400.0] {
            let harmonics = moving.harmonics(TAU * hertz, 8).unwrap();
            for place in [0.0, 0.13, 0.3, 0.51] {
                let exact = track.cross_receptance(TAU * hertz, place, place);
                let sum: Complex64 = (-8..=8)
                    .map(|n| {
                        let angle = TAU * n as f64 * place / 0.6;
                        harmonics.at(n) * Complex64::from_polar(1.0, angle)
                    })
                    .sum();
                let error = (sum - exact).norm() / exact.norm();
                let left = 20.0 * harmonics.at(8).norm() / harmonics.at(0).norm();
                assert!(error < left + 1e-4, "{hertz} Hz, {place} m: {error:e}, {left:e}");
            }
        }
    }

    /// Ĥ_n(ω) = Ĥ₋ₙ(ω + nΩ) and Ĥ_n(−ω) = Ĥ₋ₙ(ω)*, to the quadrature.
    #[test]
    fn reciprocal_and_real_in_time() {
        let moving = MovingLoadOnSupports::new(&track(), 40.0).unwrap();
        for hertz in [90.0, 600.0, 1020.0] {
            let w = TAU * hertz;
            let harmonics = moving.harmonics(w, 3).unwrap();
            let negative = moving.harmonics(-w, 3).unwrap();
            let scale = harmonics.at(0).norm();
            for n in -3..=3 {
                let other = moving.harmonics(w + n as f64 * moving.passing(), 3).unwrap();
                let error = (harmonics.at(n) - other.at(-n)).norm() / scale;
                assert!(error < 1e-5, "{hertz} Hz, {n}: {error:e}");
                let error = (negative.at(n) - harmonics.at(-n).conj()).norm() / scale;
                assert!(error < 1e-5, "{hertz} Hz, {n}: {error:e}");
            }
        }
    }

    /// Supports close together are supports spread evenly.
    #[test]
    fn close_supports_are_even() {
        let layer = |stiffness, damping| Layer::new(stiffness, damping).unwrap();
        let support = Support::two_layer(layer(25e6, 3e3), 12.0, layer(7e6, 7e3)).unwrap();
        let close = PeriodicTrack::new(track().parts().0, support, 0.05).unwrap();
        let even = MovingLoadTrack::new(track().parts().0, Some(support.per_metre(0.05).unwrap()));
        let moving = MovingLoadOnSupports::new(&close, 60.0).unwrap();
        for hertz in [30.0, 200.0, 800.0] {
            let w = TAU * hertz;
            let harmonics = moving.harmonics(w, 1).unwrap();
            let error = (harmonics.at(0) / even.receptance(w, 60.0) - 1.0).norm();
            // The rail's shear between supports, κd/GA against 1/k of the support, goes with d.
            assert!(error < 5e-3, "{hertz} Hz: {error:e}");
        }
    }

    /// The moving load from loads at rest: ∫∫ H(x₀ + Vs, x₀; ω) e^{i(ω − ω')s} ds dω/2π is the answer to an impulse at x₀ where
    /// the load is when it comes, Σ Ĥ₋ₙ(ω') e^{2πinx₀/d}. Sums of equal steps, to the ends of both integrals.
    #[test]
    fn moving_loads_from_loads_at_rest() {
        let soft = |stiffness, damping| Layer::new(stiffness, damping).unwrap();
        let support = Support::two_layer(soft(200e6, 80e3), 150.0, soft(80e6, 80e3)).unwrap();
        let steel = steel();
        // Without shear H has no kink at the force, and the integral over ω converges fast.
        let rail = crate::receptance::EulerBernoulliBeam::new(steel, 3.04e-5, 60.2).unwrap();
        let rail = Beam::from(rail).with_damping(6e3).unwrap();
        let track = PeriodicTrack::new(rail, support, 0.6).unwrap();
        let (speed, place, w) = (60.0, 0.17, TAU * 1250.0);
        let moving = MovingLoadOnSupports::new(&track, speed).unwrap();
        let harmonics = moving.harmonics(w, 12).unwrap();
        let expected: Complex64 =
            (-12..=12).map(|n| harmonics.at(-n) * Complex64::from_polar(1.0, TAU * n as f64 * place / 0.6)).sum();
        let (dw, dt) = (8.0, 2.5e-4);
        let mut sum = Complex64::ZERO;
        for i in -250..=250 {
            let shift = f64::from(i) * dw;
            let waves = track.floquet_waves(w + shift);
            for j in -800..=800 {
                let s = f64::from(j) * dt;
                let turn = Complex64::from_polar(dt * dw / TAU, shift * s);
                sum += turn * waves.receptance(place, place + speed * s);
            }
        }
        let error = (sum - expected).norm() / expected.norm();
        let at_rest = track.cross_receptance(w, place, place);
        assert!((at_rest - expected).norm() > 0.02 * expected.norm());
        assert!(error < 3e-3, "{error:e}");
    }

    /// Nearly free rails have no steady answer, and loads that outrun all waves are beyond the model.
    #[test]
    fn waves_without_loss_and_supercritical_speeds_are_refused() {
        let fast = MovingLoadOnSupports::new(&track(), 2e3).unwrap_err();
        assert!(fast.to_string().contains("critical speed"), "{fast}");
        let rail = track().parts().0.with_damping(0.0).unwrap();
        let layer = |stiffness| Layer::new(stiffness, 0.0).unwrap();
        let support = Support::two_layer(layer(300e6), 150.0, layer(80e6)).unwrap();
        let track = PeriodicTrack::new(rail, support, 0.6).unwrap();
        let moving = MovingLoadOnSupports::new(&track, 30.0).unwrap();
        let refused = moving.harmonics(TAU * 700.0, 1);
        assert!(matches!(refused, Err(Error::UndampedWaves { .. })), "{refused:?}");
    }
}
