//! What a patch of finite size leaves of the roughness under it.

use std::f64::consts::PI;

use libm::j1;
use riffel_numerics::simpson::simpson;

use super::HertzContact;
use crate::Error;

/// Contact filter of an elliptic patch: the oscillation of the wheel's approach at constant load, over the
/// amplitude of the roughness that causes it.
///
/// A small roughness ζ(x, y), positive outward, changes the load by ∬ q(δ₁ + ζ), where q is the change of
/// the pressure that a unit of approach makes. The edge of the patch moves, too, but where it moves the
/// pressure is zero. By reciprocity q is the pressure under a flat punch of the shape of the patch,
/// ∝ 1/√(1 − x²/a² − y²/b²). At constant load the approach thus changes by the mean of ζ with this weight,
/// −δ₁ = ∬qζ/∬q. For a wave with the numbers k_x along and k_y across the rail
///
/// ```text
/// H = sin κ/κ,   κ² = (k_x a)² + (k_y b)²
/// ```
///
/// A wave that is uniform across the rail, as corrugation is, has H = sin(ka)/(ka). Roughness that varies
/// across has |H|² in the mean over its wave numbers across. With these spread evenly from −αk to αk it
/// is, if the weight is uniform and the patch a circle, the filter of Remington (1987),
/// |H|² = (4/α)(kr)⁻² ∫ J₁²(kr sec ψ) dψ from 0 to arctan α: there α is a measure of the correlation
/// across. See [`elastic`](Self::elastic) and [`uniform`](Self::uniform).
///
/// Source: derived here, held against [`NormalContact`](crate::contact::NormalContact) in its tests; for the weight
/// Johnson (1985), *Contact Mechanics*, section 3.5; P. J. Remington, *Journal of the Acoustical Society of
/// America* 81 (1987), 1805–1823, for the mean over uncorrelated roughness. Range of validity: amplitudes
/// that keep the patch whole, far below p₀λ/(πE\*), the amplitude at which a wave lifts off, and below
/// 1/(k²R), at which it is as curved as the wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactFilter {
    semi_axis_longitudinal: f64,
    semi_axis_lateral: f64,
}

impl ContactFilter {
    /// The filter of an ellipse with the semi-axes a along and b across the rail \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(semi_axis_longitudinal: f64, semi_axis_lateral: f64) -> Result<Self, Error> {
        Error::unless_positive("semi-axis of the patch along the rail", semi_axis_longitudinal, "m")?;
        Error::unless_positive("semi-axis of the patch across the rail", semi_axis_lateral, "m")?;
        Ok(Self { semi_axis_longitudinal, semi_axis_lateral })
    }

    /// The filter of a Hertz contact.
    pub fn of(contact: &HertzContact) -> Self {
        Self {
            semi_axis_longitudinal: contact.semi_axis_longitudinal(),
            semi_axis_lateral: contact.semi_axis_lateral(),
        }
    }

    /// Semi-axis a along the rail \[m\].
    pub fn semi_axis_longitudinal(&self) -> f64 {
        self.semi_axis_longitudinal
    }

    /// H \[-\] for a wave with the wave numbers k_x along and k_y across the rail \[rad/m\].
    pub fn amplitude(&self, along: f64, across: f64) -> f64 {
        let angle = (along * self.semi_axis_longitudinal).hypot(across * self.semi_axis_lateral);
        flat_punch(angle)
    }

    /// |H|² \[-\] of roughness of a wavelength λ along the rail \[m\] whose wave numbers across are spread
    /// evenly up to α times that along; α = 0 for roughness that is uniform across.
    ///
    /// Simpson's rule, eight panels to a radian of κ and at least 64: 1e-6 of the largest value, one.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless λ > 0 and α ≥ 0.
    pub fn elastic(&self, wavelength: f64, across: f64) -> Result<f64, Error> {
        self.mean_square(wavelength, across, flat_punch)
    }

    /// |H|² \[-\] for the mean of the roughness over the patch without a weight, H = 2J₁(κ)/κ: with
    /// a = b Remington's filter.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless λ > 0 and α ≥ 0.
    pub fn uniform(&self, wavelength: f64, across: f64) -> Result<f64, Error> {
        self.mean_square(wavelength, across, |angle| if angle == 0.0 { 1.0 } else { 2.0 * j1(angle) / angle })
    }

    /// |H|² = 1/(1 + (π/4)(ka)³) \[-\] at a wavelength λ \[m\]: the usual approximation of Remington's
    /// filter in prediction models of rolling noise, with the radius of the patch taken as a.
    ///
    /// At short waves it is 4/(π(ka)³), the mean of (2J₁(ka)/ka)² over its lobes; at long ones it lacks
    /// the term of second order, 1 − (ka)²/4.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless λ > 0.
    pub fn approximate(&self, wavelength: f64) -> Result<f64, Error> {
        Error::unless_positive("wavelength", wavelength, "m")?;
        let angle = 2.0 * PI / wavelength * self.semi_axis_longitudinal;
        Ok((1.0 + 0.25 * PI * angle.powi(3)).recip())
    }

    /// Mean of the square of a factor f(κ) over the wave numbers across.
    fn mean_square(&self, wavelength: f64, across: f64, factor: fn(f64) -> f64) -> Result<f64, Error> {
        Error::unless_positive("wavelength", wavelength, "m")?;
        Error::unless_not_negative("ratio of the wave numbers across and along", across, "")?;
        let wavenumber = 2.0 * PI / wavelength;
        let along = wavenumber * self.semi_axis_longitudinal;
        let widest = wavenumber * across * self.semi_axis_lateral;
        let panels = 2 * (4.0 * widest).ceil().max(32.0) as usize;
        let squares = simpson(panels).map(|(share, weight)| weight * factor(along.hypot(widest * share)).powi(2));
        Ok(squares.sum())
    }
}

/// sin κ/κ.
fn flat_punch(angle: f64) -> f64 {
    if angle == 0.0 { 1.0 } else { angle.sin() / angle }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn filter() -> ContactFilter {
        ContactFilter::new(6e-3, 4e-3).unwrap()
    }

    /// The weighted mean of a wave over the ellipse, by quadrature in elliptic polar coordinates:
    /// ∫∫ cos(k_x a r cos θ) cos(k_y b r sin θ) r/√(1 − r²) dr dθ with r = sin t; midpoint rule, exponential.
    #[test]
    fn amplitude_is_the_weighted_mean_of_a_wave() {
        const POINTS: usize = 200;
        for (along, across) in [(200.0, 0.0), (700.0, 300.0), (100.0, 1500.0)] {
            let mut sum = 0.0;
            let mut weights = 0.0;
            for i in 0..POINTS {
                let t = 0.5 * PI * (i as f64 + 0.5) / POINTS as f64;
                for j in 0..POINTS {
                    let angle = 2.0 * PI * (j as f64 + 0.5) / POINTS as f64;
                    let (x, y) = (6e-3 * t.sin() * angle.cos(), 4e-3 * t.sin() * angle.sin());
                    sum += t.sin() * (along * x).cos() * (across * y).cos();
                    weights += t.sin();
                }
            }
            // Midpoint rule in t: (π/2/200)²/24 of the slope at the ends.
            assert!((filter().amplitude(along, across) - sum / weights).abs() < 1e-5);
        }
    }

    /// Uniform across: sin(ka)/(ka) and 2J₁(ka)/(ka), and the limits of long waves 1 − (ka)²/3 and
    /// 1 − (ka)²/4 of the squares.
    #[test]
    fn no_variation_across_is_the_wave_itself() {
        for wavelength in [5e-3, 20e-3, 80e-3] {
            let wavenumber = 2.0 * PI / wavelength;
            let square = filter().amplitude(wavenumber, 0.0).powi(2);
            assert_relative_eq!(filter().elastic(wavelength, 0.0).unwrap(), square, max_relative = 1e-12);
            let tiny = filter().elastic(wavelength, 1e-6).unwrap();
            assert!((tiny - square).abs() < 1e-9);
        }
        let angle: f64 = 2.0 * PI / 3.0 * 6e-3;
        let remainder = angle.powi(4);
        let elastic = filter().elastic(3.0, 0.0).unwrap();
        let uniform = filter().uniform(3.0, 0.0).unwrap();
        assert!((elastic - 1.0 + angle * angle / 3.0).abs() < remainder);
        assert!((uniform - 1.0 + angle * angle / 4.0).abs() < remainder);
    }

    /// Remington's own integral over a circle, by the midpoint rule in ψ.
    #[test]
    fn uniform_weight_over_a_circle_is_remington() {
        let circle = ContactFilter::new(5e-3, 5e-3).unwrap();
        const POINTS: usize = 4000;
        for (wavelength, across) in [(50e-3, 1.0), (20e-3, 0.5), (10e-3, 2.0)] {
            let angle = 2.0 * PI / wavelength * 5e-3;
            let end = f64::atan(across);
            let integral: f64 = (0..POINTS)
                .map(|point| {
                    let psi = end * (point as f64 + 0.5) / POINTS as f64;
                    j1(angle / psi.cos()).powi(2) * end / POINTS as f64
                })
                .sum();
            let remington = 4.0 / across / (angle * angle) * integral;
            let got = circle.uniform(wavelength, across).unwrap();
            assert!((got - remington).abs() < 2e-6, "{got} {remington}");
        }
    }

    /// The mean of (2J₁(z)/z)² z³ over a lobe far out is 4/π, the short-wave limit of the approximation.
    #[test]
    fn approximation_is_the_mean_of_the_lobes() {
        const POINTS: usize = 400;
        let mean = (0..POINTS)
            .map(|point| {
                let z = 300.0 + PI * (point as f64 + 0.5) / POINTS as f64;
                4.0 * j1(z).powi(2) * z / POINTS as f64
            })
            .sum::<f64>();
        // The next term of J₁ is 3/(8z) of the first.
        assert_relative_eq!(mean, 4.0 / PI, max_relative = 2e-3);
        let short = 2.0 * PI / 300.0 * 6e-3;
        assert_relative_eq!(filter().approximate(short).unwrap(), 4.0 / PI / 300.0_f64.powi(3), max_relative = 1e-6);
    }

    #[test]
    fn bad_input_is_refused() {
        assert!(ContactFilter::new(0.0, 1e-3).is_err());
        assert!(ContactFilter::new(1e-3, f64::NAN).is_err());
        assert!(filter().elastic(-1.0, 0.0).is_err());
        assert!(filter().uniform(1e-2, -1.0).is_err());
        assert!(filter().approximate(0.0).is_err());
    }
}
