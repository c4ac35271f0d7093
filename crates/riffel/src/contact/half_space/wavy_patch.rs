//! How the patch moves and changes its shape on a wave.

use num_complex::Complex64;
use riffel_numerics::spherical_bessel::spherical_bessel_functions;

use crate::contact::ellipse::{PolynomialPunch, TERMS};

/// An elliptic patch under constant load on a rail with a wave, whose curvature under a point is κ = R k² Δ.
///
/// To first order the wave presses with the tilt, the curvature and every further term of e^{ikx} that the wheel does not
/// follow. In coordinates that go with the patch, x + w_x(x) and y + w_y y, its rim stays where it was, and with ξ = x/a,
/// η = y/b the pressure p₀ = p̂ζ, ζ = √(1 − ξ² − η²), changes by
///
/// ```text
/// p₁ + w·∇p₀ = p̂ [(T − T_rim(ξ))/ζ + w_y ζ],   p₁ = p̂ T/ζ
/// T = (κ/z²) Σ_{n ≥ 1} (2n + 1) iⁿ j_n(z) Σ_m (c_m^n/c_1^1) cos mφ P_n^m(ζ)/P_n^m(0),   z = ka
/// w_x/a = (T_rim(ξ) − w_y)/ξ + w_y ξ,   w_y = T_rim(0)
/// ```
///
/// with the [punches](PolynomialPunch) c. For long waves this is the shift R r' and the ellipse of Hertz on a wheel of the radius
/// R/(1 + κ). Each degree n is a field of its own, of which all waves are [sums](Self::amplitudes).
pub(super) struct WavyPatch {
    semi_axes: (f64, f64),
    punch: PolynomialPunch,
}

/// What a wave has of each degree, and the place at which it is parallel to the wheel; per κ.
pub(super) struct Amplitudes {
    /// (2n + 1) iⁿ j_n(z)/z² from n = 1 on.
    pub(super) by_degree: Vec<Complex64>,
    /// The semi-axis a times k \[-\].
    pub(super) semi_axis: f64,
    /// k times the shift of the place at which rail and wheel are parallel \[-\]: about there it spins.
    pub(super) pivot: Complex64,
}

/// What one degree does to the patch, per unit of its amplitude.
pub(super) struct Degree {
    semi_axes: (f64, f64),
    n: usize,
    /// c_m^n/c_1^1 by m: T_rim by the Chebyshev polynomials of ξ.
    rim: Vec<f64>,
    /// Shift along the rail over a \[-\] and stretch \[-\], which move both ends of the patch as w_x does.
    pub(super) shift: f64,
    pub(super) stretch: f64,
    /// w_y \[-\].
    pub(super) stretch_across: f64,
}

impl WavyPatch {
    /// An ellipse of the semi-axes a and b \[m\].
    pub(super) fn new((a, b): (f64, f64)) -> Self {
        Self { semi_axes: (a, b), punch: PolynomialPunch::new(a / b) }
    }

    /// A wave of the number k \[rad/m\], zero for an endless one.
    pub(super) fn amplitudes(&self, wavenumber: f64) -> Amplitudes {
        /// No digit changes below it.
        const LONG: f64 = 1e-5;
        /// What the terms left out may have.
        const NOTHING: f64 = 1e-10;
        let z = (wavenumber.abs() * self.semi_axes.0).max(LONG);
        let functions = spherical_bessel_functions(z, TERMS + 1);
        let size = |n: usize| (2 * n + 1) as f64 * functions[n] / (z * z);
        // Past n = z they fall faster than geometrically.
        let matters = |&n: &usize| (n as f64) < z + 2.0 || size(n).abs() > NOTHING;
        let orders = (1..functions.len()).take_while(matters);
        Amplitudes {
            by_degree: orders.map(|n| size(n) * Complex64::I.powu(n as u32)).collect(),
            semi_axis: z,
            pivot: Complex64::I * functions[0],
        }
    }

    /// One degree from 1 on.
    pub(super) fn degree(&self, n: usize) -> Degree {
        let of_tilt = self.punch.pressure(1)[0].1;
        let mut rim = vec![0.0; n + 1];
        for (m, c) in self.punch.pressure(n) {
            rim[m] = c / of_tilt;
        }
        let all: f64 = rim.iter().sum();
        let is_even = n.is_multiple_of(2);
        let in_the_middle = rim.iter().step_by(2).enumerate();
        let signed = in_the_middle.map(|(half, c)| if half % 2 == 0 { *c } else { -c });
        Degree {
            semi_axes: self.semi_axes,
            n,
            shift: if is_even { 0.0 } else { all },
            stretch: if is_even { all } else { 0.0 },
            stretch_across: signed.sum(),
            rim,
        }
    }
}

impl Degree {
    /// w_x beside shift and stretch, which vanishes at both ends of the patch \[m\], and its slope \[-\] at a place along the rail \[m\].
    pub(super) fn along(&self, x: f64) -> (f64, f64) {
        let xi = x / self.semi_axes.0;
        let stretch = self.stretch_across - self.stretch;
        let (mut beside, mut slope) = (stretch * xi - self.shift, stretch);
        // T_m, its slope, (T_m − T_m(0))/ξ and its slope, of this order and the one before.
        let mut before = [1.0, 0.0, 0.0, 0.0];
        let mut now = [xi, 1.0, 1.0, 0.0];
        for rim in &self.rim[1..] {
            beside += rim * now[2];
            slope += rim * now[3];
            let next = [
                2.0 * xi * now[0] - before[0],
                2.0 * (now[0] + xi * now[1]) - before[1],
                2.0 * now[0] - before[2],
                2.0 * now[1] - before[3],
            ];
            (before, now) = (now, next);
        }
        (beside * self.semi_axes.0, slope)
    }

    /// Growth of the pressure at a place that goes with the patch \[m\], over p₀ \[-\].
    pub(super) fn growth_of_pressure(&self, (x, y): (f64, f64)) -> f64 {
        /// From here on, over the rim.
        const RIM: f64 = 0.999;
        let (mut xi, mut eta) = (x / self.semi_axes.0, y / self.semi_axes.1);
        let mut rho = xi.hypot(eta);
        if rho > RIM {
            (xi, eta, rho) = (xi * RIM / rho, eta * RIM / rho, RIM);
        }
        let zeta = (1.0 - rho * rho).sqrt();
        let (phi, of_rim) = (eta.atan2(xi), xi.acos());
        let terms = self.rim.iter().enumerate().filter(|(_, c)| **c != 0.0);
        let above_rim = terms.map(|(m, c)| {
            // P_n^m here and on the rim, from n = m on; of both n and n − 1.
            let (mut here, mut on_rim) = ([rho.powi(m as i32), 0.0], [1.0, 0.0]);
            for n in m..self.n {
                let (up, twice, down) = ((n - m + 1) as f64, (2 * n + 1) as f64, (n + m) as f64);
                here = [(twice * zeta * here[0] - down * here[1]) / up, here[0]];
                on_rim = [-down * on_rim[1] / up, on_rim[0]];
            }
            let m = m as f64;
            c * ((m * phi).cos() * here[0] / on_rim[0] - (m * of_rim).cos())
        });
        above_rim.sum::<f64>() / (zeta * zeta) + self.stretch_across
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{CurvatureFilter, HertzContact};
    use crate::fixtures::steel;

    fn hertz(curvature: f64) -> HertzContact {
        let steel = steel();
        HertzContact::exact(steel, 0.46 / (1.0 + curvature), 0.23, 50e3).unwrap()
    }

    fn semi_axes(hertz: HertzContact) -> (f64, f64) {
        (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral())
    }

    /// A long wave is the ellipse of Hertz on another wheel, R ik Δ ahead. Central differences of 1e-3 leave 1e-6; ka is 1e-5.
    #[test]
    fn long_waves_change_the_radius() {
        let (a, b) = semi_axes(hertz(0.0));
        let patch = WavyPatch::new((a, b));
        let amplitudes = patch.amplitudes(0.0);
        let [tilt, curvature] = [1, 2].map(|n| patch.degree(n));
        let [by_tilt, by_curvature] = [0, 1].map(|index| amplitudes.by_degree[index]);
        assert!((by_tilt * amplitudes.semi_axis * tilt.shift - Complex64::I).norm() < 1e-9);
        assert!((amplitudes.pivot - Complex64::I).norm() < 1e-9);
        assert!(tilt.growth_of_pressure((0.3 * a, 0.2 * b)).abs() < 1e-12);
        let slope = |of: &dyn Fn(HertzContact) -> f64| (of(hertz(1e-3)).ln() - of(hertz(-1e-3)).ln()) / 2e-3;
        let along = slope(&|hertz| hertz.semi_axis_longitudinal());
        let across = slope(&|hertz| hertz.semi_axis_lateral());
        let pressure = slope(&|hertz| hertz.peak_pressure());
        assert!((by_curvature * curvature.stretch - along).norm() < 1e-5);
        assert!((by_curvature * curvature.stretch_across - across).norm() < 1e-5);
        for at in [(0.0, 0.0), (0.5 * a, 0.3 * b), (-0.2 * a, 0.95 * b)] {
            let growth = by_curvature * curvature.growth_of_pressure(at);
            assert!((growth - pressure).norm() < 1e-5);
            for degree in [&tilt, &curvature] {
                let (beside, slope) = degree.along(at.0);
                assert!(beside.abs() < 1e-12 * a && slope.abs() < 1e-12, "{beside} {slope}");
            }
        }
    }

    /// The load stays, and what presses on crests is Φ: ∫(p₁ + w·∇p₀)e^{−ikx} over all of the patch, by sums over 200 × 200
    /// points, 5e-3.
    #[test]
    fn crests_are_pressed_by_the_filter() {
        const POINTS: u32 = 200;
        let (a, b) = semi_axes(hertz(0.0));
        let filter = CurvatureFilter::new(a, b).unwrap();
        let patch = WavyPatch::new((a, b));
        for wavelength in [2.0 * a, 3.0 * a, 5.0 * a, 10.0 * a] {
            let k = std::f64::consts::TAU / wavelength;
            let (mut load, mut crests, mut whole) = (Complex64::ZERO, Complex64::ZERO, 0.0);
            for (index, amplitude) in patch.amplitudes(k).by_degree.into_iter().enumerate() {
                let degree = patch.degree(index + 1);
                let place = |index: u32| 2.0 * (f64::from(index) + 0.5) / f64::from(POINTS) - 1.0;
                for (x, y) in (0..POINTS * POINTS).map(|index| (place(index % POINTS), place(index / POINTS))) {
                    let inside = 1.0 - x * x - y * y;
                    if inside <= 0.0 {
                        continue;
                    }
                    let (x, y) = (a * x, b * y);
                    let (beside, slope) = degree.along(x);
                    let moved = degree.shift * a + degree.stretch * x + beside;
                    let dilation = degree.stretch + slope + degree.stretch_across;
                    let growth = degree.growth_of_pressure((x, y)) + dilation;
                    let displaced = Complex64::new(growth, -k * moved);
                    load += amplitude * inside.sqrt() * growth;
                    crests += amplitude * inside.sqrt() * displaced * Complex64::cis(-k * x);
                    whole += if index == 0 { inside.sqrt() } else { 0.0 };
                }
            }
            assert!((load / whole).norm() < 5e-3, "{load}");
            let (got, share) = (crests / whole, filter.share(k));
            assert!((got - share).norm() < 5e-3, "{wavelength}: {got} {share}");
        }
    }
}
