//! Rail on an even foundation under a load that moves and oscillates.

use num_complex::Complex64;
use riffel_numerics::golden_section::golden_section;
use riffel_numerics::simultaneous_roots::polish;

use super::waves::Waveguide;
use super::{Beam, ContinuousTrack, Layer, Receptance, Support};
use crate::Error;

/// An infinite rail, free or on one or two layers spread evenly, under an oscillating load that
/// travels at the speed V.
///
/// In the frame of the load every wave is e^{αξ} e^{iωt}, ξ = x − Vt. A point of the track feels
/// e^{st} with s = iω − Vα: the Doppler effect. The waves satisfy D(α) = 0 with the dynamic stiffness
/// of the whole track against e^{αξ},
/// D = K + (Bα² − Js²)α²/(1 − h(Bα² − Js²)), K = ms² + cs + κ(s), in the symbols of [`Beam`]; and
/// H = Σ 1/D'(α) over the waves ahead of the load.
///
/// Method: D is a ratio of polynomials in α, P/N, of degree four for a free rail or one layer and of
/// six for two layers with sleepers (the sleepers, which move each on its own, add two roots that
/// matter little). All roots at once by the iteration of Weierstrass (1891) from those at rest, to
/// rounding (two roots close to each other, as near cut-on, to the square root of it); then
/// H = Σ N/P'. A root is ahead if Re α < 0; on the imaginary axis, which needs a track
/// without any loss, by the limit of vanishing damping: the sign of d(Re α) for ω → ω − i0. A
/// search that does not settle gives NaN. Cost: some two microseconds for two layers.
///
/// Range of validity: below [`critical_speed`](Self::critical_speed), and that of the track at rest.
/// A hysteretic loss factor is taken at its value whatever the local frequency, which is right while
/// Im s > 0; waves in which sleepers move alone have Im s < 0, and their share of H is then counted on the
/// wrong side: 1e-8 at 60 m/s, 1e-4 at 200 m/s. The free undamped Euler–Bernoulli beam has a closed form, [`MovingBeam`](super::MovingBeam).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingLoadTrack {
    beam: Beam,
    support: Option<Support>,
}

impl MovingLoadTrack {
    /// A rail, and a support whose values are per metre.
    pub fn new(beam: Beam, support: Option<Support>) -> Self {
        Self { beam, support }
    }

    /// Speed \[m/s\] at which a load of the angular frequency ω \[rad/s\] makes the rail's slowest
    /// waves pile up around it: min over k of (ω + Ω(k))/k, where Ω(k) is the frequency of waves of
    /// the wavenumber k. Beyond it waves run at negative frequency in the track, and a damped track
    /// may push the load along.
    ///
    /// Method: golden section over ln k to 1e-6. Ω² = (k_s + Bk⁴/(1 + Bhk²))/m with the static stiffness
    /// k_s of the support, and with the sleepers' mass moving with the rail, as it does in the long
    /// waves that pile up; short waves in which sleepers move alone are slower still, but carry next to
    /// nothing. Rotary inertia is left out: 0.3–2 % up to 500 Hz, up to 9 % at 2 kHz, where the speed
    /// is some 2000 m/s. Below its cut-on frequency an undamped track is singular also at
    /// min (Ω − ω)/k, a lower speed; it stays passive there, and any loss makes it finite.
    pub fn critical_speed(&self, angular_frequency: f64) -> f64 {
        self.slowest(|k| (angular_frequency + self.frequency(k)) / k)
    }

    /// `Ok` if a load at the speed \[m/s\] over the wavelength \[m\] stays below its critical speed.
    ///
    /// # Errors
    /// [`Error::Supercritical`]: with ω = 2πV/λ the limit is V = min Ω(k)/(k − 2π/λ).
    pub fn check_speed(&self, wavelength: f64, speed: f64) -> Result<(), Error> {
        let q = 2.0 * std::f64::consts::PI / wavelength;
        // k > 2π/λ: the excess over it is what is searched.
        let critical_speed = self.slowest(|excess| self.frequency(q + excess) / excess);
        if speed < critical_speed {
            return Ok(());
        }
        Err(Error::Supercritical { speed, wavelength, critical_speed })
    }

    /// `Ok` if a load that does not oscillate stays below its critical speed at the speed \[m/s\].
    pub(super) fn check_steady_load(&self, speed: f64) -> Result<(), Error> {
        if speed < self.critical_speed(0.0) {
            return Ok(());
        }
        Err(Error::OutOfRange {
            quantity: "speed",
            value: speed,
            unit: "m/s",
            rule: "must stay below the critical speed of the track",
        })
    }

    /// Smallest value over the wavenumbers 1e-4 … 1e4 rad/m.
    fn slowest(&self, speed: impl Fn(f64) -> f64) -> f64 {
        let ends = [1e-4f64.ln(), 1e4f64.ln()];
        let logarithm = golden_section(ends, 1e-6, |logarithm| speed(logarithm.exp()));
        speed(logarithm.exp())
    }

    /// Ω(k) of the undamped track, see [`critical_speed`](Self::critical_speed).
    fn frequency(&self, k: f64) -> f64 {
        let stiffness = self.support.map_or(0.0, |support| support.static_stiffness());
        let sleeper = match self.support {
            Some(Support::TwoLayer { sleeper_mass, .. }) => sleeper_mass,
            _ => 0.0,
        };
        let mass = self.beam.mass_per_length() + sleeper;
        ((stiffness + self.beam.static_wave_stiffness(k)) / mass).sqrt()
    }

    fn at_rest(&self) -> ContinuousTrack {
        match self.support {
            Some(support) => ContinuousTrack::new(self.beam, support),
            None => ContinuousTrack::free(self.beam),
        }
    }

    /// P and N for α = `scale`·a as polynomials in a.
    fn characteristic(&self, omega: Complex64, speed: f64, scale: f64) -> [Polynomial; 2] {
        let parts = self.beam.parts();
        let (b, h) = (parts.bending_stiffness, parts.shear_compliance);
        // Polynomials in s: the inertia and damping of the rail, and the support as a ratio.
        let rail = Polynomial::of(&[0.0.into(), parts.damping.into(), parts.mass_per_length.into()]);
        let layer = |layer: Layer| Polynomial::of(&layer.polynomial());
        let (above, below) = match self.support {
            None => (Polynomial::ZERO, Polynomial::ONE),
            Some(Support::OneLayer { pad }) => (layer(pad), Polynomial::ONE),
            Some(Support::TwoLayer { pad, sleeper_mass, ballast }) => {
                let pad = layer(pad);
                let sleeper = Polynomial::of(&[0.0.into(), 0.0.into(), sleeper_mass.into()]);
                let lower = layer(ballast).plus(&sleeper);
                (pad.times(&lower), pad.plus(&lower))
            }
        };
        // K · below, and J s², in a.
        let doppler = [Complex64::i() * omega, Complex64::from(-speed * scale)];
        let stiffness = rail.times(&below).plus(&above).composed(doppler);
        let below = below.composed(doppler);
        let s2 = Polynomial::of(&doppler).times(&Polynomial::of(&doppler));
        let turning = s2.scaled(parts.rotary_inertia.into());
        let alpha2 = Polynomial::of(&[0.0.into(), 0.0.into(), (scale * scale).into()]);
        // Bα² − Js², and 1 − h(Bα² − Js²).
        let bending = alpha2.scaled(b).plus(&turning.scaled((-1.0).into()));
        let shearing = Polynomial::ONE.plus(&bending.scaled(-h));
        let p = stiffness.times(&shearing).plus(&bending.times(&alpha2).times(&below));
        [p, shearing.times(&below)]
    }

    /// All roots a = α/scale.
    fn roots(&self, p: &Polynomial, omega: f64, speed: f64, scale: f64) -> Option<Vec<Complex64>> {
        let rest = self.at_rest().waves(omega);
        let mut start: Vec<Complex64> =
            rest.as_slice().iter().flat_map(|wave| [wave.propagation / scale, -wave.propagation / scale]).collect();
        // The sleepers' own roots lie far out, near α = (iω − s)/V for their own motion e^{st}.
        let own = p.degree().saturating_sub(start.len());
        let far = omega / (speed * scale);
        start.extend((0..own).map(|j| Complex64::from_polar(far * (1.0 + 0.3 * j as f64), 1.0 + 2.0 * j as f64)));
        // Without loss the roots lie symmetric to the imaginary axis, and from a symmetric start a
        // pair could never part along it.
        for (j, root) in start.iter_mut().enumerate() {
            *root *= Complex64::cis(0.02 * (j + 1) as f64);
        }
        let leading = p.coefficients[p.degree()];
        polish(|a| p.at(a) / leading, &mut start).then_some(start)
    }
}

impl Receptance for MovingLoadTrack {
    fn receptance(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        if speed == 0.0 {
            return self.at_rest().receptance(angular_frequency, 0.0);
        }
        // Roots of size one for the free rail.
        let parts = self.beam.parts();
        let inertia = parts.mass_per_length * angular_frequency * angular_frequency;
        let scale = (inertia / parts.bending_stiffness.re).sqrt().sqrt();
        let [p, n] = self.characteristic(angular_frequency.into(), speed, scale);
        let Some(roots) = self.roots(&p, angular_frequency, speed, scale) else {
            return Complex64::new(f64::NAN, f64::NAN);
        };
        let slope = p.derivative();
        // The same track a little before it has lost what it radiates: ω − iδ, of which only the
        // sign of the shift of a root is used.
        let earlier = angular_frequency * Complex64::new(1.0, -1e-6);
        let [shifted, _] = self.characteristic(earlier, speed, scale);
        let ahead = |a: &Complex64| {
            if a.re.abs() > 1e-10 * a.norm() {
                return a.re < 0.0;
            }
            (-shifted.at(*a) / slope.at(*a)).re < 0.0
        };
        roots.iter().filter(|a| ahead(a)).map(|&a| scale * n.at(a) / slope.at(a)).sum()
    }
}

/// A polynomial of degree six at most, constant term first.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Polynomial {
    coefficients: [Complex64; Self::MOST],
}

impl Polynomial {
    const MOST: usize = 7;
    const ZERO: Self = Self { coefficients: [Complex64::ZERO; Self::MOST] };
    const ONE: Self = {
        let mut one = Self::ZERO;
        one.coefficients[0] = Complex64::ONE;
        one
    };

    fn of(coefficients: &[Complex64]) -> Self {
        let mut polynomial = Self::ZERO;
        polynomial.coefficients[..coefficients.len()].copy_from_slice(coefficients);
        polynomial
    }

    fn plus(&self, other: &Self) -> Self {
        Self { coefficients: std::array::from_fn(|j| self.coefficients[j] + other.coefficients[j]) }
    }

    fn scaled(&self, factor: Complex64) -> Self {
        Self { coefficients: self.coefficients.map(|c| c * factor) }
    }

    /// The product; its degree is at most six by construction of the caller.
    fn times(&self, other: &Self) -> Self {
        Self {
            coefficients: std::array::from_fn(|j| {
                (0..=j).map(|i| self.coefficients[i] * other.coefficients[j - i]).sum()
            }),
        }
    }

    /// p(q(a)) for q(a) = q₀ + q₁a, by Horner's rule.
    fn composed(&self, linear: [Complex64; 2]) -> Self {
        let linear = Self::of(&linear);
        self.coefficients.iter().rev().fold(Self::ZERO, |sum, &c| sum.times(&linear).plus(&Self::of(&[c])))
    }

    fn at(&self, a: Complex64) -> Complex64 {
        self.coefficients.iter().rev().fold(Complex64::ZERO, |sum, c| sum * a + c)
    }

    fn derivative(&self) -> Self {
        Self {
            coefficients: std::array::from_fn(|j| {
                self.coefficients.get(j + 1).map_or(Complex64::ZERO, |c| c * (j + 1) as f64)
            }),
        }
    }

    fn degree(&self) -> usize {
        self.coefficients.iter().rposition(|c| *c != Complex64::ZERO).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{rail, steel};
    use crate::receptance::{MovingBeam, ShearSection};
    use proptest::prelude::*;

    fn shearing() -> Beam {
        let shear = ShearSection { area: 7.17e-3, shear_coefficient: 0.4, shear_modulus: 80e9, density: 7850.0 };
        Beam::timoshenko(steel(), 2.35e-5, 56.0, shear).unwrap()
    }

    fn two_layers(damping: f64) -> Support {
        let (pad, ballast) = (Layer::new(4e8, damping).unwrap(), Layer::new(8e7, damping).unwrap());
        Support::two_layer(pad, 157.0, ballast).unwrap()
    }

    /// The critical speed of a load that does not oscillate is that of the Winkler beam,
    /// (4kEI/m²)^{1/4} (Timoshenko 1926), and the root of the free beam is the closed one.
    #[test]
    fn critical_speeds_of_the_textbooks() {
        let pad = Layer::new(1e8, 0.0).unwrap();
        let track = MovingLoadTrack::new(rail().into(), Some(Support::one_layer(pad)));
        let winkler = (4.0 * 1e8 * rail().bending_stiffness() / 56f64.powi(2)).powf(0.25);
        assert!((track.critical_speed(0.0) / winkler - 1.0).abs() < 1e-9);
        let free = MovingLoadTrack::new(rail().into(), None);
        for w in [100.0, 1e4] {
            let closed = MovingBeam::new(rail()).critical_speed(w);
            assert!((free.critical_speed(w) / closed - 1.0).abs() < 1e-9);
        }
        assert!(free.check_speed(0.08, 60.0).is_ok());
        let error = free.check_speed(200.0, 60.0).unwrap_err();
        let same = MovingBeam::new(rail()).check_speed(200.0, 60.0).unwrap_err();
        let limit = |error: Error| match error {
            Error::Supercritical { critical_speed, .. } => critical_speed,
            _ => f64::NAN,
        };
        assert!((limit(error) / limit(same) - 1.0).abs() < 1e-9);
    }

    /// At its critical speed the undamped one-layer track resonates: towards it the receptance grows
    /// without bound, as the inverse square root of the distance.
    #[test]
    fn resonates_at_the_critical_speed() {
        let pad = Layer::new(1e8, 0.0).unwrap();
        let track = MovingLoadTrack::new(rail().into(), Some(Support::one_layer(pad)));
        let w = 300.0;
        let near = |share: f64| track.receptance(w, track.critical_speed(w) * (1.0 - share)).norm();
        for share in [1e-4, 1e-6] {
            let ratio = near(share / 100.0) / near(share);
            assert!((ratio / 10.0 - 1.0).abs() < 0.05, "{ratio}");
        }
    }

    proptest! {
        /// Without foundation, loss and shear it is the paper's moving load. The sum over roots loses
        /// digits as p → 0, where the four nearly form a square: 1e-10.
        #[test]
        fn free_beam_is_the_closed_form(w in 50.0..30e3, v in 0.5..120.0) {
            let closed = MovingBeam::new(rail());
            prop_assume!(v < 0.99 * closed.critical_speed(w));
            let track = MovingLoadTrack::new(rail().into(), None);
            let (h, expected) = (track.receptance(w, v), closed.receptance(w, v));
            prop_assert!((h - expected).norm() < 1e-10 * expected.norm(), "{h} {expected}");
        }

        /// The choice of roots is the limit of vanishing damping: the difference falls in
        /// proportion to it, here ¾ Ĉ of the value at leading order.
        #[test]
        fn undamped_is_the_limit_of_damped(w in 300.0..30e3, v in 1.0..60.0) {
            let undamped = MovingBeam::new(rail()).receptance(w, v);
            for loss in [1e-3, 1e-6] {
                let beam = Beam::from(rail()).with_damping(loss * 56.0 * w).unwrap();
                let h = MovingLoadTrack::new(beam, None).receptance(w, v);
                prop_assert!((h - undamped).norm() < loss * undamped.norm(), "{h} {undamped}");
            }
        }

        /// A slow load is one at rest, on every foundation and rail: H(V) = H(−V) by symmetry, so the
        /// difference is of second order in the speed over that of the waves, here 0.02 m/s over some
        /// hundreds; resonances enlarge it.
        #[test]
        fn slow_is_at_rest(w in 200.0..20e3, damping in 1e4..1e5, loss in 0.0..0.3) {
            let pad = Layer::new(2e8, damping).unwrap().with_loss_factor(loss).unwrap();
            for support in [None, Some(Support::one_layer(pad)), Some(two_layers(damping))] {
                for beam in [Beam::from(rail()), shearing()] {
                    let track = MovingLoadTrack::new(beam.with_loss_factor(0.01).unwrap(), support);
                    let (slow, rest) = (track.receptance(w, 0.02), track.receptance(w, 0.0));
                    prop_assert!((slow - rest).norm() < 1e-5 * rest.norm(), "{slow} {rest}");
                }
            }
        }

        /// Every track without loss finds its roots at speeds of trains, and is passive there.
        #[test]
        fn passive_at_train_speeds(w in 100.0..20e3, v in 1.0..90.0, damping in prop_oneof![Just(0.0), 1e3..1e5]) {
            let pad = Layer::new(2e8, damping).unwrap();
            for support in [None, Some(Support::one_layer(pad)), Some(two_layers(damping))] {
                for beam in [Beam::from(rail()), shearing()] {
                    let track = MovingLoadTrack::new(beam, support);
                    prop_assume!(v < 0.9 * track.critical_speed(w));
                    let h = track.receptance(w, v);
                    // Rounding of the sum over roots, where a track without loss radiates nothing.
                    prop_assert!(h.im <= 1e-9 * h.norm(), "{support:?} {h}");
                }
            }
        }
    }
}
