//! A thin disc that vibrates along its axis: the web and the tyre of a wheel.

use std::f64::consts::{FRAC_PI_2, PI};

use libm::tgamma;
use riffel::{Complex64, Error};
use riffel_numerics::elimination::inverse;
use riffel_numerics::gauss::{equal_panels, panels};
use riffel_numerics::spherical_bessel::spherical_bessel_functions;

use super::Air;

/// A thin disc in free air, both faces of which move by s(r) cos nθ along its axis.
///
/// The pressures on its faces are opposite, and nothing outside it: a wheel is short-circuited at low frequencies, the more
/// so the more nodal diameters n it has.
///
/// Method: the pressure on a face is a sum of r^n √(1 − r²) P_j(1 − 2r²) with Jacobi's polynomials P_j of the orders (n, ½),
/// r in radii a, whose Hankel transforms are κ^(−3/2) J_{n+2j+3/2}(κ) (A. Erdélyi, *Tables of Integral Transforms* II (1954), section
/// 8.9). Moments of the velocity with the same functions give as many equations, of the matrix
///
/// ```text
/// A_jl = 2/(πka) ∫₀^∞ √((ka)² − κ²) j_{n+2j+1}(κ) j_{n+2l+1}(κ) dκ/κ
/// ```
///
/// with spherical Bessel functions; beyond ka the root is −i√(κ² − (ka)²). Powers are exact to 1e-4 to ka = 60. Cost: some 5 ms at ka = 40.
#[derive(Debug, Clone, PartialEq)]
pub struct VibratingDisc {
    radius: f64,
    nodal_diameters: u32,
    /// Radii over that of the disc, and displacements there.
    shape: Vec<(f64, f64)>,
}

impl VibratingDisc {
    /// A disc as large as the last of some radii \[m\], with the displacement at each. It is straight between them, and
    /// inside the first falls to nothing at the axis.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless radii increase from above zero, with as many displacements, all finite.
    pub fn new(nodal_diameters: u32, radii: &[f64], shape: &[f64]) -> Result<Self, Error> {
        let wrong =
            |value: f64, rule| Err(Error::OutOfRange { quantity: "radii of a vibrating disc", value, unit: "m", rule });
        if radii.len() != shape.len() || shape.iter().any(|value| !value.is_finite()) {
            return wrong(radii.len() as f64, "must each have a finite displacement");
        }
        let mut before = 0.0;
        for &radius in radii {
            if !(radius > before && radius.is_finite()) {
                return wrong(radius, "must increase from above zero");
            }
            before = radius;
        }
        if radii.is_empty() {
            return wrong(0.0, "must be one or more");
        }
        let radius = before;
        let mut places = vec![(0.0, 0.0)];
        let scaled = radii.iter().map(|place| place / radius);
        places.extend(scaled.zip(shape.iter().copied()));
        Ok(Self { radius, nodal_diameters, shape: places })
    }

    /// Sound power per mean square velocity of the motion s(r) cos nθ \[W per (m/s)²\], where s is 1.
    pub fn power(&self, air: &Air, frequency: f64) -> f64 {
        /// Functions beyond those that are as short as the waves of the air.
        const BEYOND: f64 = 10.0;
        let x = air.wavenumber(frequency) * self.radius;
        let count = (0.5 * x + BEYOND).ceil() as usize;
        let moments = self.moments(count);
        let admittance = inverse(self.matrix(x, count));
        let product: f64 = admittance
            .iter()
            .zip(&moments)
            .map(|(row, moment)| {
                let pressure: f64 = row.iter().zip(&moments).map(|(a, b)| a.re * b).sum();
                moment * pressure
            })
            .sum();
        2.0 * air.impedance() * self.radius.powi(2) * self.around() * product
    }

    /// ∫cos²nθ dθ.
    fn around(&self) -> f64 {
        match self.nodal_diameters {
            0 => 2.0 * PI,
            _ => PI,
        }
    }

    /// ∫s ψ_j r dr, where ψ_j is the function whose transform is κ^(−3/2) J_{n+2j+3/2}(κ).
    fn moments(&self, count: usize) -> Vec<f64> {
        let n = f64::from(self.nodal_diameters);
        // j!/(√2 Γ(j + 3/2)).
        let mut scale = (2f64.sqrt() * tgamma(1.5)).recip();
        let scales: Vec<f64> = (0..count)
            .map(|j| {
                let this = scale;
                scale *= (j as f64 + 1.0) / (j as f64 + 1.5);
                this
            })
            .collect();
        let mut moments = vec![0.0; count];
        for ends in self.shape.windows(2) {
            let [(from, begin), (to, end)] = [ends[0], ends[1]];
            // r = sin φ, in which the functions are as smooth as waves of the numbers 2j.
            let edges = equal_panels([from.asin(), to.asin()], (count as f64).recip());
            for (angle, weight) in panels(&edges) {
                let (r, root) = angle.sin_cos();
                let displacement = begin + (end - begin) * (r - from) / (to - from);
                let common = weight * displacement * r.powf(n + 1.0) * root * root;
                let polynomials = jacobi(n, 1.0 - 2.0 * r * r);
                for ((moment, scale), value) in moments.iter_mut().zip(&scales).zip(polynomials) {
                    *moment += common * scale * value;
                }
            }
        }
        moments
    }

    /// The matrix A at x = ka.
    fn matrix(&self, x: f64, count: usize) -> Vec<Vec<Complex64>> {
        /// How far the integral beyond ka goes before its tail.
        const REACH: f64 = 150.0;
        /// Length of a panel of κ, of which waves have the length π.
        const PANEL: f64 = 1.5;
        let first = self.nodal_diameters as usize + 1;
        let mut matrix = vec![vec![Complex64::ZERO; count]; count];
        let mut add = |kappa: f64, weight: Complex64| {
            let bessel = spherical_bessel_functions(kappa, first + 2 * count);
            for (row, line) in matrix.iter_mut().enumerate() {
                let scaled = weight * bessel[first + 2 * row];
                for (entry, value) in line.iter_mut().zip(bessel[first..].iter().step_by(2)) {
                    *entry += scaled * value;
                }
            }
        };
        // Propagating waves, κ = x sin t; the static integral lacks them.
        let panel = PANEL / x.max(PANEL);
        for (angle, weight) in panels(&equal_panels([0.0, FRAC_PI_2], panel)) {
            let (sin, cos) = angle.sin_cos();
            let propagating = weight * x * cos * cos / sin;
            add(x * sin, Complex64::new(propagating, weight * x * cos));
        }
        // Decaying waves, κ = x cosh s, less what they would be at low frequency.
        let ends = equal_panels([x, x + REACH], PANEL);
        let edges: Vec<f64> = ends.iter().map(|end| (end / x).acosh()).collect();
        for (s, weight) in panels(&edges) {
            let lacking = weight * x * s.sinh() * (1.0 - s.tanh());
            add(x * s.cosh(), Complex64::new(0.0, lacking));
        }
        // Beyond, j_l j_m is ±1/2κ² in the mean.
        let tail = x * x / (12.0 * (x + REACH).powi(3));
        for (row, line) in matrix.iter_mut().enumerate() {
            for (column, entry) in line.iter_mut().enumerate() {
                let sign = if (row + column) % 2 == 0 { 1.0 } else { -1.0 };
                entry.im += sign * tail;
                if row == column {
                    let order = (first + 2 * row) as f64;
                    entry.im -= FRAC_PI_2 / (2.0 * order + 1.0);
                }
                *entry *= 2.0 / (PI * x);
            }
        }
        matrix
    }
}

/// Jacobi's polynomials of the orders (α, ½) at x, of the degrees 0, 1, …
fn jacobi(alpha: f64, x: f64) -> impl Iterator<Item = f64> {
    const BETA: f64 = 0.5;
    let (mut before, mut value, mut degree) = (0.0, 1.0, 0.0);
    std::iter::from_fn(move || {
        let this = value;
        let sum = 2.0 * degree + alpha + BETA;
        let next = if degree == 0.0 {
            0.5 * (alpha - BETA) + 0.5 * (alpha + BETA + 2.0) * x
        } else {
            let first = 2.0 * (degree + 1.0) * (degree + 1.0 + alpha + BETA) * sum;
            let second = (sum + 1.0) * (alpha * alpha - BETA * BETA);
            let third = sum * (sum + 1.0) * (sum + 2.0);
            let fourth = 2.0 * (degree + alpha) * (degree + BETA) * (sum + 2.0);
            ((second + third * x) * value - fourth * before) / first
        };
        (before, value) = (value, next);
        degree += 1.0;
        Some(this)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(nodal_diameters: u32, shape: impl Fn(f64) -> f64) -> Result<VibratingDisc, Error> {
        let radii: Vec<f64> = (1..=400).map(|step| 0.46 * f64::from(step) / 400.0).collect();
        let shape: Vec<f64> = radii.iter().map(|r| shape(r / 0.46)).collect();
        VibratingDisc::new(nodal_diameters, &radii, &shape)
    }

    fn frequency(ka: f64) -> f64 {
        ka * Air::default().sound_speed / (2.0 * PI * 0.46)
    }

    /// A small rigid disc moves 8/3 ρa³ of air along: a dipole, W = (ωF)²/(12πρc³) with the force F on the air. The shape
    /// given rises to 1 within a four-hundredth of the radius; the next term is of the order (ka)².
    #[test]
    fn a_small_rigid_disc_is_a_dipole() -> Result<(), Error> {
        let (air, disc) = (Air::default(), disc(0, |_| 1.0)?);
        let frequency = frequency(0.02);
        let w = 2.0 * PI * frequency;
        let force = w * 8.0 / 3.0 * air.density * 0.46f64.powi(3);
        let dipole = (w * force).powi(2) / (12.0 * PI * air.density * air.sound_speed.powi(3));
        let ratio = disc.power(&air, frequency) / dipole;
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
        Ok(())
    }

    /// With n nodal diameters a small disc radiates as (ka)^(2n + 4) of its efficiency, a large one ρc on either face.
    #[test]
    fn limits_of_small_and_large_discs() -> Result<(), Error> {
        let air = Air::default();
        for n in 0..5u32 {
            let disc = disc(n, |r| r.powi(n as i32))?;
            let [low, high] = [0.05, 0.1].map(|ka| disc.power(&air, frequency(ka)));
            let slope = (high / low).log2();
            assert!((slope - f64::from(2 * n + 4)).abs() < 0.02, "{n}: {slope}");
            let plane = 2.0 * air.impedance() * disc.around() * 0.46f64.powi(2) / f64::from(2 * n + 2);
            let efficiency = disc.power(&air, frequency(50.0)) / plane;
            assert!((efficiency - 1.0).abs() < 0.02, "{n}: {efficiency}");
        }
        Ok(())
    }

    #[test]
    fn radii_that_do_not_increase_are_refused() {
        assert!(VibratingDisc::new(2, &[0.2, 0.1], &[1.0, 1.0]).is_err());
        assert!(VibratingDisc::new(2, &[0.2], &[1.0, 1.0]).is_err());
        assert!(VibratingDisc::new(2, &[], &[]).is_err());
    }
}
