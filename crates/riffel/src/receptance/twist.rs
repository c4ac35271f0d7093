//! The rail as a rod that twists and warps.

use num_complex::Complex64;
use riffel_numerics::square_root::square_root;

use super::wave_stiffness::WaveStiffness;
use crate::{ElasticMaterial, Error};

/// What a rail section needs beyond bending to twist, and where its foot and its mass are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwistSection {
    /// Torsion constant J \[m⁴\]: GJ is the stiffness of Saint-Venant's torsion.
    pub torsion_constant: f64,
    /// Polar second moment I_p \[m⁴\] about the centroid: ρI_p is the rotary inertia per metre.
    pub polar_second_moment: f64,
    /// Warping constant I_ω \[m⁶\]: zero without warping, which stiffens the rail against short waves (UIC60: a tenth off the
    /// lateral receptance of the head at 300 Hz, a third at 1 kHz).
    pub warping_constant: f64,
    /// Height c of the centroid above the shear centre \[m\]; zero puts the mass at the shear centre. UIC60 has 33 mm, which
    /// moves the lateral receptance of the head by a third or more from 100 Hz on.
    pub centroid_height: f64,
    /// Depth d of the foot below the shear centre \[m\].
    pub foot_depth: f64,
    /// Width B of the foot on its pad \[m\].
    pub foot_width: f64,
    /// Shear modulus G \[Pa\].
    pub shear_modulus: f64,
    /// Density ρ \[kg/m³\].
    pub density: f64,
}

/// A rail that twists about its shear centre and warps (Vlasov), with hysteretic loss:
/// EI_ω(1 + iη) θ'''' − GJ(1 + iη) θ'' + (K_θ − ω²ρI_p) θ = moment per metre.
///
/// Source: the torsion of Kostovasilis, Thompson & Hussein (2017), *A semi-analytical beam model for the vibration of
/// railway tracks*, without the shear of warping. Range of validity: the section keeps its shape; above some 1.3 kHz the
/// web of a rail bends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Twist {
    section: TwistSection,
    /// EI_ω \[N m⁴\].
    warping_stiffness: f64,
    loss_factor: f64,
}

impl Twist {
    /// A rail of the given section.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless torsion constant, polar second moment, foot width, shear modulus and density are positive
    /// and the warping constant is not negative; centroid and foot may lie on either side of the shear centre.
    pub fn new(material: ElasticMaterial, section: TwistSection) -> Result<Self, Error> {
        Error::unless_positive("torsion constant", section.torsion_constant, "m4")?;
        Error::unless_positive("polar second moment", section.polar_second_moment, "m4")?;
        Error::unless_positive("shear modulus", section.shear_modulus, "Pa")?;
        Error::unless_positive("density", section.density, "kg/m3")?;
        Error::unless_not_negative("warping constant", section.warping_constant, "m6")?;
        Error::unless_positive("foot width", section.foot_width, "m")?;
        for (quantity, value) in [("centroid height", section.centroid_height), ("foot depth", section.foot_depth)] {
            if !value.is_finite() {
                return Err(Error::OutOfRange { quantity, value, unit: "m", rule: "must be finite" });
            }
        }
        Ok(Self { section, warping_stiffness: material.youngs_modulus() * section.warping_constant, loss_factor: 0.0 })
    }

    /// Twist with a loss factor η \[-\]: E and G become E(1 + iη) and G(1 + iη).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if η is negative.
    pub fn with_loss_factor(self, loss_factor: f64) -> Result<Self, Error> {
        Error::unless_not_negative("rail loss factor", loss_factor, "")?;
        Ok(Self { loss_factor, ..self })
    }

    /// The section.
    pub fn section(&self) -> &TwistSection {
        &self.section
    }

    /// ρI_p \[kg m\].
    pub(super) fn polar_inertia(&self) -> f64 {
        self.section.density * self.section.polar_second_moment
    }

    /// GJ \[N m²\].
    fn torsional_stiffness(&self) -> f64 {
        self.section.shear_modulus * self.section.torsion_constant
    }

    /// How fast warping dies away from where it is held \[1/m\], √(GJ/EI_ω); none without warping.
    pub(super) fn warping_decay(&self) -> Option<f64> {
        (self.warping_stiffness > 0.0).then(|| (self.torsional_stiffness() / self.warping_stiffness).sqrt())
    }

    /// Stiffness of the twist on a foundation K \[N\] per metre, of all that does not depend on the wave but ρI_p.
    pub(super) fn wave_stiffness(&self, w: f64, foundation: Complex64) -> WaveStiffness {
        let elastic = Complex64::new(1.0, self.loss_factor);
        let torsion = elastic * self.torsional_stiffness();
        let stiffness = foundation - w * w * self.polar_inertia();
        let denominator = [Complex64::ONE, Complex64::ZERO];
        if self.warping_stiffness == 0.0 {
            return WaveStiffness {
                leading: -torsion,
                roots: [stiffness / torsion, Complex64::ZERO],
                count: 1,
                denominator,
            };
        }
        let warping = elastic * self.warping_stiffness;
        let root = square_root(torsion * torsion - 4.0 * warping * stiffness);
        // The larger root first; the other from the product, so that neither cancels.
        let larger = if (torsion.conj() * root).re >= 0.0 {
            (torsion + root) / (2.0 * warping)
        } else {
            (torsion - root) / (2.0 * warping)
        };
        WaveStiffness { leading: warping, roots: [larger, stiffness / (warping * larger)], count: 2, denominator }
    }
}
