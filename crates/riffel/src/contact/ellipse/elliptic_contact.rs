//! Hertz contact of two bodies with any principal curvatures and materials.

use std::f64::consts::PI;

use super::unit_ellipse::UnitEllipse;
use crate::{ElasticMaterial, Error};

/// One of the two bodies of an [`EllipticContact`].
///
/// A curvature is one over the radius of curvature \[1/m\]: positive for a convex surface, zero for
/// a straight one, negative for a hollow one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactBody {
    /// Its material.
    pub material: ElasticMaterial,
    /// Curvature along the rolling direction \[1/m\]; 1/R for a wheel, 0 for a straight rail.
    pub longitudinal_curvature: f64,
    /// Curvature across the rolling direction \[1/m\]; 1/R_r for the head of a rail.
    pub lateral_curvature: f64,
}

/// Elliptic contact of two smooth elastic bodies whose principal curvatures lie along and across
/// the rolling direction, by exact elliptic integrals.
///
/// The curvatures of the bodies add, and so do their compliances:
/// 1/E\* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂. Either semi-axis may be the longer one.
///
/// Source: Hertz (1881); Johnson (1985), *Contact Mechanics*, equations 4.24–4.29. Range of
/// validity: patches small against the radii of curvature, no friction between unlike materials.
/// Error: rounding, 1e-13 relative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipticContact {
    contact_modulus: f64,
    ellipse: UnitEllipse,
    normal_force: f64,
}

impl EllipticContact {
    /// The contact of two bodies under the normal force P \[N\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the force is positive, the combined curvature of either
    /// direction is positive (zero makes a line contact, a negative value a conformal one), and
    /// the ratio of the two combined curvatures is at most 1e4.
    pub fn new(bodies: [ContactBody; 2], normal_force: f64) -> Result<Self, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        let [first, second] = bodies;
        let contact_modulus = contact_modulus([first.material, second.material]);
        Ok(Self {
            contact_modulus,
            ellipse: UnitEllipse::new(
                contact_modulus,
                first.longitudinal_curvature + second.longitudinal_curvature,
                first.lateral_curvature + second.lateral_curvature,
            )?,
            normal_force,
        })
    }

    /// Width 2b \[m\] over which no profile of a wheel or a rail keeps one curvature, so that the theory ends.
    pub const WIDEST: f64 = 0.03;

    /// A wheel on a rail of its own material, with the curvatures of both together along and across the rail \[1/m\].
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn of_wheel_on_rail(
        material: ElasticMaterial,
        [along, across]: [f64; 2],
        normal_force: f64,
    ) -> Result<Self, Error> {
        let body = |longitudinal_curvature, lateral_curvature| ContactBody {
            material,
            longitudinal_curvature,
            lateral_curvature,
        };
        Self::new([body(along, 0.0), body(0.0, across)], normal_force)
    }

    /// Contact under another normal force \[N\], without solving for the ellipse again.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the force is positive.
    pub fn under(&self, normal_force: f64) -> Result<Self, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        Ok(Self { normal_force, ..*self })
    }

    /// Contact modulus E\* \[Pa\].
    pub fn contact_modulus(&self) -> f64 {
        self.contact_modulus
    }

    /// Normal force P \[N\].
    pub fn normal_force(&self) -> f64 {
        self.normal_force
    }

    /// Semi-axis a along the rolling direction \[m\], ∝ P^{1/3}.
    pub fn semi_axis_longitudinal(&self) -> f64 {
        self.ellipse.semi_axis_longitudinal(self.normal_force)
    }

    /// Semi-axis b across the rolling direction \[m\], ∝ P^{1/3}.
    pub fn semi_axis_lateral(&self) -> f64 {
        self.ellipse.semi_axis_lateral(self.normal_force)
    }

    /// Axis ratio a/b \[-\], the same under every load.
    pub fn axis_ratio(&self) -> f64 {
        self.ellipse.axis_ratio()
    }

    /// Approach δ of distant points of the two bodies \[m\], ∝ P^{2/3}.
    pub fn approach(&self) -> f64 {
        self.ellipse.approach(self.normal_force)
    }

    /// Pressure p₀ = 3P/(2πab) in the middle of the patch \[Pa\], ∝ P^{1/3}.
    pub fn peak_pressure(&self) -> f64 {
        1.5 * self.normal_force / (PI * self.semi_axis_longitudinal() * self.semi_axis_lateral())
    }

    /// Pressure p₀ √(1 − x²/a² − y²/b²) at the distances x along and y across from the middle of
    /// the patch \[m\], in Pa; zero outside it.
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        let along = x / self.semi_axis_longitudinal();
        let across = y / self.semi_axis_lateral();
        self.peak_pressure() * (1.0 - along * along - across * across).max(0.0).sqrt()
    }

    /// Contact stiffness dP/dδ = 3P/(2δ) \[N/m\], ∝ P^{1/3}.
    pub fn stiffness(&self) -> f64 {
        self.ellipse.stiffness(self.normal_force)
    }
}

/// Contact modulus E\* \[Pa\] of two bodies: 1/E\* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂.
pub(in crate::contact) fn contact_modulus(materials: [ElasticMaterial; 2]) -> f64 {
    materials.map(plane_compliance).iter().sum::<f64>().recip()
}

/// (1 − ν²)/E \[1/Pa\] of one body.
fn plane_compliance(material: ElasticMaterial) -> f64 {
    let ratio = material.poisson_ratio();
    (1.0 - ratio * ratio) / material.youngs_modulus()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn body(longitudinal_curvature: f64, lateral_curvature: f64) -> ContactBody {
        ContactBody { material: ElasticMaterial::new(207e9, 0.3).unwrap(), longitudinal_curvature, lateral_curvature }
    }

    fn on_rail(longitudinal: f64, lateral: f64, force: f64) -> EllipticContact {
        let wheel = body(longitudinal, 0.0);
        EllipticContact::new([wheel, body(0.0, lateral)], force).unwrap()
    }

    /// Hertz for spheres of aluminium and steel: a³ = 3PR/4E*, δ = a²/R, 1/R = 1/R₁ + 1/R₂.
    #[test]
    fn unlike_spheres_are_hertz() {
        let steel = body(1.0 / 0.3, 1.0 / 0.3);
        let aluminium =
            ContactBody { material: ElasticMaterial::new(70e9, 0.33).unwrap(), ..body(1.0 / 0.2, 1.0 / 0.2) };
        let contact = EllipticContact::new([steel, aluminium], 2e3).unwrap();
        let modulus = 1.0 / ((1.0 - 0.09) / 207e9 + (1.0 - 0.33 * 0.33) / 70e9);
        let radius = 0.12_f64;
        let a = (0.75 * 2e3 * radius / modulus).cbrt();
        assert_relative_eq!(contact.semi_axis_longitudinal(), a, max_relative = 1e-14);
        assert_eq!(contact.axis_ratio(), 1.0);
        assert_relative_eq!(contact.approach(), a * a / radius, max_relative = 1e-14);
        assert_relative_eq!(contact.stiffness(), 2.0 * modulus * a, max_relative = 1e-14);
    }

    #[test]
    fn contacts_without_an_ellipse_are_refused_with_the_reason() {
        let flat = body(0.0, 0.0);
        let message = |bodies, force| EllipticContact::new(bodies, force).unwrap_err().to_string();
        let wheel = body(1.0 / 0.46, 0.0);
        assert!(message([wheel, flat], 5e4).contains("touch along a line"));
        assert!(message([wheel, body(0.0, -3.0)], 5e4).contains("conform"));
        assert!(message([wheel, body(0.0, 1e5)], 5e4).contains("at most 10000"));
        assert!(message([wheel, body(0.0, f64::NAN)], 5e4).contains("finite"));
        assert!(message([wheel, body(0.0, 3.0)], 0.0).contains("normal force"));
        assert!(on_rail(2.0, 3.0, 1.0).under(-1.0).is_err());
    }

    proptest! {
        /// ∬ p dx dy by Gauss–Chebyshev points of the second kind across each chord of the
        /// ellipse, with which the integral of this pressure is exact.
        #[test]
        fn pressure_carries_the_load(
            along in 0.1..50.0f64, across in 0.1..50.0f64, force in 1.0..2e5f64,
        ) {
            let contact = on_rail(along, across, force);
            let (a, b) = (contact.semi_axis_longitudinal(), contact.semi_axis_lateral());
            let count = 24;
            let nodes: Vec<(f64, f64)> = (1..=count)
                .map(|i| {
                    let angle = PI * f64::from(i) / f64::from(count + 1);
                    // The weight of dx = sin θ dθ.
                    (angle.cos(), PI / f64::from(count + 1) * angle.sin())
                })
                .collect();
            let mut sum = 0.0;
            for (x, weight) in &nodes {
                let chord = (1.0 - x * x).sqrt();
                for (y, inner) in &nodes {
                    sum += weight * inner * chord * contact.pressure(a * x, b * chord * y);
                }
            }
            // The outer integrand is (1 − x²), a half power short of the rule: π²/12(n + 1)² off.
            assert_relative_eq!(a * b * sum, force, max_relative = 2e-3);
            assert_relative_eq!(
                2.0 / 3.0 * PI * a * b * contact.peak_pressure(), force, max_relative = 1e-13
            );
        }

        /// The scaling a ∝ P^{1/3}, δ ∝ P^{2/3}; no more than rounding, since nothing is solved.
        #[test]
        fn scaling_with_the_load(
            along in 0.1..50.0f64, across in 0.1..50.0f64, factor in 1e-3..1e3f64,
        ) {
            let contact = on_rail(along, across, 5e4);
            let other = contact.under(5e4 * factor).unwrap();
            let third = factor.cbrt();
            assert_relative_eq!(
                other.semi_axis_longitudinal(), third * contact.semi_axis_longitudinal(),
                max_relative = 1e-15
            );
            assert_relative_eq!(
                other.approach(), third * third * contact.approach(), max_relative = 2e-15
            );
            prop_assert_eq!(other, on_rail(along, across, 5e4 * factor));
        }

        #[test]
        fn swapping_the_directions_swaps_the_axes(
            along in 0.1..50.0f64, across in 0.1..50.0f64,
        ) {
            let (one, other) = (on_rail(along, across, 5e4), on_rail(across, along, 5e4));
            prop_assert_eq!(one.semi_axis_longitudinal(), other.semi_axis_lateral());
            prop_assert_eq!(one.semi_axis_lateral(), other.semi_axis_longitudinal());
            prop_assert_eq!(one.approach(), other.approach());
            // The flatter direction has the longer axis.
            prop_assert_eq!(along < across, one.axis_ratio() > 1.0);
        }

        /// Central differences with a relative step of 1e-4: truncation 1e-9, rounding 1e-11.
        #[test]
        fn stiffness_is_a_slope(
            along in 0.1..50.0f64, across in 0.1..50.0f64, force in 1.0..2e5f64,
        ) {
            let contact = on_rail(along, across, force);
            let step = 1e-4 * force;
            let higher = contact.under(force + step).unwrap();
            let lower = contact.under(force - step).unwrap();
            assert_relative_eq!(
                contact.stiffness(), 2.0 * step / (higher.approach() - lower.approach()),
                max_relative = 1e-8
            );
        }
    }
}
