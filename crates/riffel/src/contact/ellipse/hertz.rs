//! Hertz contact of wheel and rail, in the paper's closed form or exact.

use std::f64::consts::PI;

use super::unit_ellipse::UnitEllipse;
use crate::contact::WaveGeometry;
use crate::{ElasticMaterial, Error};

/// Contact patch and contact stiffness of a wheel of rolling radius R on a rail of transverse
/// radius R_r: either the closed form of the paper, equations (22) and (26), or exact.
///
/// [`new`](Self::new) is the closed form. The mildly elliptic patch is taken as that of the
/// equivalent sphere of radius R_e = √(R R_r), stretched to the axis ratio a/b = (R/R_r)^{2/3}.
/// Against the exact elliptic integrals the semi-axis a₀ of the paper's contact (0.46 m, 0.23 m,
/// 50 kN) is 0.7 % large; the closed form wants radii of the same order.
///
/// [`exact`](Self::exact) solves for the ellipse once and makes every method exact. Two bodies of
/// other curvatures or of different materials are an [`EllipticContact`](super::EllipticContact).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzContact {
    material: ElasticMaterial,
    rolling_radius: f64,
    longitudinal_radius: f64,
    transverse_radius: f64,
    normal_force: f64,
    /// The solved ellipse; none in the closed form.
    ellipse: Option<UnitEllipse>,
    /// Stiffness over that of Hertz.
    stiffening: f64,
}

impl HertzContact {
    /// A contact of rolling radius R \[m\] and transverse radius R_r \[m\] under the normal force
    /// P₀ \[N\], in the paper's closed form.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all three are positive and the ratio of the radii lies between
    /// 1e-4 and 1e4.
    pub fn new(
        material: ElasticMaterial,
        rolling_radius: f64,
        transverse_radius: f64,
        normal_force: f64,
    ) -> Result<Self, Error> {
        Error::unless_positive("rolling radius", rolling_radius, "m")?;
        Error::unless_positive("transverse radius", transverse_radius, "m")?;
        Error::unless_positive("normal force", normal_force, "N")?;
        let ratio = rolling_radius / transverse_radius;
        UnitEllipse::check_curvature_ratio(ratio.max(ratio.recip()))?;
        Ok(Self {
            material,
            rolling_radius,
            longitudinal_radius: rolling_radius,
            transverse_radius,
            normal_force,
            ellipse: None,
            stiffening: 1.0,
        })
    }

    /// Contact with another relative radius of wheel and rail along the rail \[m\] in the place of the rolling radius.
    ///
    /// Under a contact angle γ it is R/cos γ: a wheel is a surface of revolution, its circle of the radius R is curved by 1/R towards the axle,
    /// and by Meusnier's theorem the section along the rail in the plane of the normal, which leaves that direction by γ, has the
    /// share cos γ of it (do Carmo 1976, *Differential Geometry of Curves and Surfaces*, section 3-3).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] as of [`new`](Self::new).
    pub fn with_longitudinal_radius(self, radius: f64) -> Result<Self, Error> {
        Error::unless_positive("longitudinal radius", radius, "m")?;
        let ratio = radius / self.transverse_radius;
        UnitEllipse::check_curvature_ratio(ratio.max(ratio.recip()))?;
        let ellipse =
            self.ellipse.map(|_| UnitEllipse::new(self.contact_modulus(), 1.0 / radius, 1.0 / self.transverse_radius));
        Ok(Self { longitudinal_radius: radius, ellipse: ellipse.transpose()?, ..self })
    }

    /// Contact to whose curvature along the rail a wave adds the share κ, on a wheel of the radius R/(1 + κ).
    ///
    /// # Errors
    /// Errors of [`with_longitudinal_radius`](Self::with_longitudinal_radius).
    pub fn curved(self, curvature: f64) -> Result<Self, Error> {
        self.with_longitudinal_radius(self.longitudinal_radius / (1.0 + curvature))
    }

    /// c = d ln p₀/dκ \[-\] under constant load, of the [`curved`](Self::curved) contact: ⅓ in the closed form, somewhat less if exact, 0.31
    /// at a/b = 1.3. The area of the patch has −c.
    ///
    /// # Errors
    /// Errors of [`curved`](Self::curved).
    pub fn pressure_by_curvature(self) -> Result<f64, Error> {
        /// Leaves 10⁻¹¹.
        const STEP: f64 = 1e-3;
        let ln = |curvature| Ok::<_, Error>([self.curved(curvature)?.peak_pressure().ln()]);
        WaveGeometry::derivative(STEP, ln).map(|[slope]| slope)
    }

    /// Contact by exact elliptic integrals: combined curvatures 1/R along and 1/R_r
    /// across the rail, E\* = E/2(1 − ν²). Error: rounding, 1e-13 relative.
    ///
    /// Source: Hertz (1881); Johnson (1985), equations 4.24–4.29.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all three are positive and the ratio of the radii lies between
    /// 1e-4 and 1e4.
    pub fn exact(
        material: ElasticMaterial,
        rolling_radius: f64,
        transverse_radius: f64,
        normal_force: f64,
    ) -> Result<Self, Error> {
        let contact = Self::new(material, rolling_radius, transverse_radius, normal_force)?;
        Ok(Self {
            ellipse: Some(UnitEllipse::new(contact.contact_modulus(), 1.0 / rolling_radius, 1.0 / transverse_radius)?),
            ..contact
        })
    }

    /// Relative radii of wheel and rail along and across \[m\] whose exact ellipse under the normal force P₀ \[N\] has the
    /// semi-axes a along and b across \[m\]. A patch that is no ellipse enters laws of ellipses by those of one that is like it.
    ///
    /// With the long semi-axis c, the short one qc and the elliptic integrals B and D of k' = q, 1/R_c = 3P₀D/(πE\*c³) and
    /// R_c/R_q = B/(q²D) (Johnson 1985, equations 4.26). Error: rounding, 1e-13.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all are positive.
    pub fn radii_of_ellipse(material: ElasticMaterial, [a, b]: [f64; 2], normal_force: f64) -> Result<[f64; 2], Error> {
        Error::unless_positive("semi-axis along the rail", a, "m")?;
        Error::unless_positive("semi-axis across the rail", b, "m")?;
        Error::unless_positive("normal force", normal_force, "N")?;
        let modulus = material.shear_modulus() / (1.0 - material.poisson_ratio());
        Ok(UnitEllipse::curvatures(modulus, [a, b], normal_force).map(f64::recip))
    }

    /// Contact with another stiffness k_H under its load \[N/m\] in the place of Hertz's, of a patch that is no ellipse;
    /// over the load it goes as Hertz's, by P^(1/3).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is positive.
    pub fn with_stiffness(self, stiffness: f64) -> Result<Self, Error> {
        Error::unless_positive("stiffness of the contact", stiffness, "N/m")?;
        Ok(Self { stiffening: self.stiffening * stiffness / self.stiffness(), ..self })
    }

    /// The material of both bodies.
    pub fn material(&self) -> ElasticMaterial {
        self.material
    }

    /// Rolling radius R of the wheel \[m\].
    pub fn rolling_radius(&self) -> f64 {
        self.rolling_radius
    }

    /// Relative radius of wheel and rail along the rail \[m\]: R, or what was given in its place.
    pub fn longitudinal_radius(&self) -> f64 {
        self.longitudinal_radius
    }

    /// Relative radius R_r of wheel and rail across the rail \[m\].
    pub(crate) fn transverse_radius(&self) -> f64 {
        self.transverse_radius
    }

    /// Normal force P₀ \[N\].
    pub fn normal_force(&self) -> f64 {
        self.normal_force
    }

    /// Contact under another normal force \[N\], which must be positive; an exact one is
    /// not solved again, since its axis ratio does not depend on the load.
    pub(crate) fn under(&self, normal_force: f64) -> Self {
        Self { normal_force, ..*self }
    }

    /// Equivalent radius R_e \[m\] of the sphere on a plane whose patch has the same area πab:
    /// √(R R_r) in the closed form, 4E\*(ab)^{3/2}/(3P₀) if exact. Equation (6) with it is
    /// Kalker's linear law Q = G ab C₀₀ ξ for small creepage in both cases.
    pub fn equivalent_radius(&self) -> f64 {
        match self.ellipse {
            Some(ellipse) => ellipse.equivalent_radius(self.contact_modulus()),
            None => (self.longitudinal_radius * self.transverse_radius).sqrt(),
        }
    }

    /// Axis ratio a/b \[-\]: (R/R_r)^{2/3} in the closed form, as in equation (7).
    pub fn axis_ratio(&self) -> f64 {
        match self.ellipse {
            Some(ellipse) => ellipse.axis_ratio(),
            None => (self.longitudinal_radius / self.transverse_radius).powf(2.0 / 3.0),
        }
    }

    /// Semi-axis a₀ along the rail \[m\]. Closed form, equation (22):
    /// a₀ = \[3(1 − ν) R R_e P₀ / (4 G R_r)\]^{1/3}.
    pub fn semi_axis_longitudinal(&self) -> f64 {
        match self.ellipse {
            Some(ellipse) => ellipse.semi_axis_longitudinal(self.normal_force),
            None => (0.75 * (1.0 - self.material.poisson_ratio()) / self.material.shear_modulus()
                * self.longitudinal_radius
                * self.equivalent_radius()
                / self.transverse_radius
                * self.normal_force)
                .cbrt(),
        }
    }

    /// Semi-axis b₀ across the rail \[m\]: a₀ (R_r/R)^{2/3} in the closed form.
    pub fn semi_axis_lateral(&self) -> f64 {
        match self.ellipse {
            Some(ellipse) => ellipse.semi_axis_lateral(self.normal_force),
            None => self.semi_axis_longitudinal() / self.axis_ratio(),
        }
    }

    /// Linearised contact stiffness k_H = dP/dδ = 3P₀/(2δ) \[N/m\]. Closed form, equation (26):
    /// k_H = \[6 G² P₀ R_e / (1 − ν)²\]^{1/3}.
    ///
    /// The paper prints (1 − ν²) in the denominator; Hertz with E\* = G/(1 − ν) gives (1 − ν)², and
    /// only that form makes the maximum of |P₁/P₀| in Fig. 3 equal to one.
    pub fn stiffness(&self) -> f64 {
        let hertz = match self.ellipse {
            Some(ellipse) => ellipse.stiffness(self.normal_force),
            None => {
                let reduced = self.material.shear_modulus() / (1.0 - self.material.poisson_ratio());
                (6.0 * reduced * reduced * self.normal_force * self.equivalent_radius()).cbrt()
            }
        };
        self.stiffening * hertz
    }

    /// Approach δ of wheel and rail \[m\]; in the closed form that of the equivalent sphere,
    /// δ = 3P₀/(2k_H), 0.7 % large for the paper's contact.
    pub fn approach(&self) -> f64 {
        match self.ellipse {
            Some(ellipse) => ellipse.approach(self.normal_force) / self.stiffening,
            None => 1.5 * self.normal_force / self.stiffness(),
        }
    }

    /// Pressure p₀ = 3P₀/(2π a₀ b₀) in the middle of the patch \[Pa\]; in the closed form 1.3 %
    /// small for the paper's contact.
    pub fn peak_pressure(&self) -> f64 {
        1.5 * self.normal_force / (PI * self.semi_axis_longitudinal() * self.semi_axis_lateral())
    }

    /// E\* = E/2(1 − ν²) = G/(1 − ν) \[Pa\].
    fn contact_modulus(&self) -> f64 {
        self.material.shear_modulus() / (1.0 - self.material.poisson_ratio())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{ContactBody, EllipticContact};
    use crate::fixtures::steel;
    use approx::assert_relative_eq;

    fn sphere(normal_force: f64) -> HertzContact {
        let steel = steel();
        HertzContact::new(steel, 0.3, 0.3, normal_force).unwrap()
    }

    /// Radii of an ellipse are those that it was made of, and another stiffness goes over the load as Hertz's.
    #[test]
    fn an_ellipse_tells_its_radii() {
        let steel = steel();
        for (along, across) in [(0.46, 0.23), (0.46, 0.46), (0.3, 4.0), (0.9, 0.01)] {
            let hertz = HertzContact::exact(steel, 0.46, across, 60e3)
                .and_then(|hertz| hertz.with_longitudinal_radius(along))
                .unwrap();
            let axes = [hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral()];
            let radii = HertzContact::radii_of_ellipse(steel, axes, 60e3).unwrap();
            assert_relative_eq!(radii[0], along, max_relative = 1e-12);
            assert_relative_eq!(radii[1], across, max_relative = 1e-12);
            let stiffer = hertz.with_stiffness(1.3 * hertz.stiffness()).unwrap();
            assert_relative_eq!(stiffer.stiffness(), 1.3 * hertz.stiffness(), max_relative = 1e-14);
            assert_relative_eq!(stiffer.approach(), hertz.approach() / 1.3, max_relative = 1e-14);
            assert_relative_eq!(
                stiffer.under(120e3).stiffness() / stiffer.stiffness(),
                2f64.cbrt(),
                max_relative = 1e-12
            );
        }
        assert!(HertzContact::radii_of_ellipse(steel, [0.0, 5e-3], 60e3).is_err());
        assert!(sphere(60e3).with_stiffness(f64::NAN).is_err());
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
        assert_relative_eq!(contact.stiffness(), 2.0 * contact_modulus * a, max_relative = 1e-14);
    }

    /// k_H = dP/dδ with δ ∝ P^{2/3}: central difference, step 1e-4, truncation 1e-9.
    #[test]
    fn stiffness_is_the_slope_of_load_against_approach() {
        let approach = |force: f64| sphere(force).semi_axis_longitudinal().powi(2) / 0.3;
        let (force, step) = (60e3, 6.0);
        let slope = 2.0 * step / (approach(force + step) - approach(force - step));
        assert_relative_eq!(sphere(force).stiffness(), slope, max_relative = 1e-8);
    }

    /// `hertz.csv`: P, a, b, p₀, δ by exact elliptic integrals, to its six digits.
    #[test]
    fn exact_contact_is_the_reference() {
        let steel = steel();
        for [force, a, b, pressure, approach] in [
            [45e3, 5.73857e-3, 3.61872e-3, 1034.656e6, 64.262e-6],
            [50e3, 5.94369e-3, 3.74806e-3, 1071.639e6, 68.938e-6],
        ] {
            let contact = HertzContact::exact(steel, 0.46, 0.23, force).unwrap();
            assert_relative_eq!(contact.semi_axis_longitudinal(), a, max_relative = 1e-6);
            assert_relative_eq!(contact.semi_axis_lateral(), b, max_relative = 1.5e-6);
            assert_relative_eq!(contact.peak_pressure(), pressure, max_relative = 5e-7);
            // The last printed digit of the approach is 1.5e-5 of it.
            assert_relative_eq!(contact.approach(), approach, max_relative = 8e-6);
        }
    }

    /// Equal radii make a circle, for which the closed form is exact.
    #[test]
    fn closed_form_is_exact_for_the_circle() {
        let closed = sphere(60e3);
        let exact = HertzContact::exact(closed.material(), 0.3, 0.3, 60e3).unwrap();
        for method in [
            HertzContact::semi_axis_longitudinal,
            HertzContact::semi_axis_lateral,
            HertzContact::axis_ratio,
            HertzContact::equivalent_radius,
            HertzContact::stiffness,
            HertzContact::approach,
            HertzContact::peak_pressure,
        ] {
            assert_relative_eq!(method(&exact), method(&closed), max_relative = 1e-14);
        }
    }

    /// An exact wheel on a rail is the general contact of its two bodies, under any load.
    #[test]
    fn exact_contact_is_that_of_two_bodies() {
        let steel = steel();
        let contact = HertzContact::exact(steel, 0.46, 0.23, 50e3).unwrap().under(45e3);
        let body = |longitudinal_curvature, lateral_curvature| ContactBody {
            material: steel,
            longitudinal_curvature,
            lateral_curvature,
        };
        let bodies = [body(1.0 / 0.46, 0.0), body(0.0, 1.0 / 0.23)];
        let general = EllipticContact::new(bodies, 45e3).unwrap();
        assert_relative_eq!(contact.approach(), general.approach(), max_relative = 1e-14);
        assert_relative_eq!(contact.stiffness(), general.stiffness(), max_relative = 1e-14);
        assert_relative_eq!(contact.semi_axis_lateral(), general.semi_axis_lateral(), max_relative = 1e-14);
        assert_relative_eq!(contact.axis_ratio(), general.axis_ratio(), max_relative = 1e-14);
    }

    /// The section of a conical wheel along the rail, in the plane of the normal, is curved by cos γ/R: from its points.
    #[test]
    fn a_wheel_is_flatter_under_a_contact_angle() {
        let steel = steel();
        for angle in [0.05_f64, 0.6, 1.2] {
            let radius = 0.46;
            // At the angle θ about the axle the cone r = R − y tan γ meets that plane at y; x ahead, h against the normal.
            let about = 1e-3_f64;
            let y = radius * (about.cos() - 1.0) / (angle.tan().recip() + angle.tan() * about.cos());
            let (x, h) = ((radius - y * angle.tan()) * about.sin(), -y / angle.sin());
            let flatter = x * x / (2.0 * h);
            assert_relative_eq!(flatter, radius / angle.cos(), max_relative = 1e-6);
            let contact = HertzContact::exact(steel, radius, 0.3, 50e3).unwrap();
            let contact = contact.with_longitudinal_radius(flatter).unwrap();
            let alone = HertzContact::exact(steel, flatter, 0.3, 50e3).unwrap();
            assert_eq!(contact.semi_axis_longitudinal(), alone.semi_axis_longitudinal());
            assert_eq!(contact.rolling_radius(), radius);
        }
    }

    /// The equivalent sphere has the area of the patch: c² = ab with c³ = 3 P R_e / 4E*.
    #[test]
    fn equivalent_radius_keeps_the_area() {
        let steel = steel();
        for make in [HertzContact::new, HertzContact::exact] {
            let contact = make(steel, 0.46, 0.23, 50e3).unwrap();
            let modulus = 207e9 / (2.0 * (1.0 - 0.09));
            let c = (0.75 * 50e3 * contact.equivalent_radius() / modulus).cbrt();
            let area = contact.semi_axis_longitudinal() * contact.semi_axis_lateral();
            assert_relative_eq!(c * c, area, max_relative = 1e-14);
        }
    }
}
