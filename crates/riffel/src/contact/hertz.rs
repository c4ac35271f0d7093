//! Hertz contact of wheel and rail in the paper's closed form.

use crate::{ElasticMaterial, Error};

/// Contact patch and contact stiffness of a wheel of rolling radius R on a rail of transverse
/// radius R_r, equations (22) and (26).
///
/// The mildly elliptic patch is taken as that of the equivalent sphere of radius R_e = √(R R_r),
/// stretched to the axis ratio a/b = (R/R_r)^{2/3}. Against the exact elliptic integrals the
/// semi-axis a₀ of the paper's contact (0.46 m, 0.23 m, 50 kN) is 0.7 % large; the closed form
/// wants radii of the same order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzContact {
    material: ElasticMaterial,
    rolling_radius: f64,
    transverse_radius: f64,
    normal_force: f64,
}

impl HertzContact {
    /// A contact of rolling radius R \[m\] and transverse radius R_r \[m\] under the normal force
    /// P₀ \[N\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all three are positive.
    pub fn new(
        material: ElasticMaterial,
        rolling_radius: f64,
        transverse_radius: f64,
        normal_force: f64,
    ) -> Result<Self, Error> {
        Error::unless_positive("rolling radius", rolling_radius, "m")?;
        Error::unless_positive("transverse radius", transverse_radius, "m")?;
        Error::unless_positive("normal force", normal_force, "N")?;
        Ok(Self {
            material,
            rolling_radius,
            transverse_radius,
            normal_force,
        })
    }

    /// The material of both bodies.
    pub fn material(&self) -> ElasticMaterial {
        self.material
    }

    /// Rolling radius R of the wheel \[m\].
    pub fn rolling_radius(&self) -> f64 {
        self.rolling_radius
    }

    /// Normal force P₀ \[N\].
    pub fn normal_force(&self) -> f64 {
        self.normal_force
    }

    /// The same contact under another normal force \[N\], which must be positive.
    pub(crate) fn under(&self, normal_force: f64) -> Self {
        Self {
            normal_force,
            ..*self
        }
    }

    /// Equivalent radius R_e = √(R R_r) \[m\].
    pub fn equivalent_radius(&self) -> f64 {
        (self.rolling_radius * self.transverse_radius).sqrt()
    }

    /// Axis ratio a/b = (R/R_r)^{2/3} \[-\], as in equation (7).
    pub fn axis_ratio(&self) -> f64 {
        (self.rolling_radius / self.transverse_radius).powf(2.0 / 3.0)
    }

    /// Semi-axis a₀ along the rail \[m\], equation (22):
    /// a₀ = \[3(1 − ν) R R_e P₀ / (4 G R_r)\]^{1/3}.
    pub fn semi_axis_longitudinal(&self) -> f64 {
        (0.75 * (1.0 - self.material.poisson_ratio()) / self.material.shear_modulus()
            * self.rolling_radius
            * self.equivalent_radius()
            / self.transverse_radius
            * self.normal_force)
            .cbrt()
    }

    /// Semi-axis b₀ = a₀ (R_r/R)^{2/3} across the rail \[m\].
    pub fn semi_axis_lateral(&self) -> f64 {
        self.semi_axis_longitudinal() / self.axis_ratio()
    }

    /// Linearised contact stiffness k_H = \[6 G² P₀ R_e / (1 − ν)²\]^{1/3} \[N/m\], equation (26).
    ///
    /// The paper prints (1 − ν²) in the denominator; Hertz with E\* = G/(1 − ν) gives (1 − ν)², and
    /// only that form makes the maximum of |P₁/P₀| in Fig. 3 equal to one.
    pub fn stiffness(&self) -> f64 {
        let reduced = self.material.shear_modulus() / (1.0 - self.material.poisson_ratio());
        (6.0 * reduced * reduced * self.normal_force * self.equivalent_radius()).cbrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn sphere(normal_force: f64) -> HertzContact {
        let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
        HertzContact::new(steel, 0.3, 0.3, normal_force).unwrap()
    }

    /// Hertz for a sphere: approach δ = a²/R, a³ = 3 P R / 4E*, with E* = E / 2(1 − ν²).
    #[test]
    fn sphere_is_hertz() {
        let (force, radius) = (60e3_f64, 0.3);
        let contact_modulus = 207e9 / (2.0 * (1.0 - 0.09));
        let a = (0.75 * force * radius / contact_modulus).cbrt();
        let contact = sphere(force);
        assert_relative_eq!(contact.semi_axis_longitudinal(), a, max_relative = 1e-14);
        assert_relative_eq!(contact.semi_axis_lateral(), a, max_relative = 1e-14);
        assert_relative_eq!(
            contact.stiffness(),
            2.0 * contact_modulus * a,
            max_relative = 1e-14
        );
    }

    /// k_H = dP/dδ with δ ∝ P^{2/3}: central difference, step 1e-4, truncation 1e-9.
    #[test]
    fn stiffness_is_the_slope_of_load_against_approach() {
        let approach = |force: f64| sphere(force).semi_axis_longitudinal().powi(2) / 0.3;
        let (force, step) = (60e3, 6.0);
        let slope = 2.0 * step / (approach(force + step) - approach(force - step));
        assert_relative_eq!(sphere(force).stiffness(), slope, max_relative = 1e-8);
    }
}
