//! The rail as a beam that bends and shears.

use num_complex::Complex64;
use riffel_numerics::square_root::square_root;

use super::EulerBernoulliBeam;
use super::wave_stiffness::WaveStiffness;
use super::waves::{Wave, Waveguide, Waves, outgoing};
use crate::{ElasticMaterial, Error};

/// What a rail section needs beyond bending, for Timoshenko's beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearSection {
    /// Cross-section A \[m²\].
    pub area: f64,
    /// Shear coefficient κ \[-\]: the share of the section that carries shear, about 0.4 for the
    /// vertical bending of a rail.
    pub shear_coefficient: f64,
    /// Shear modulus G \[Pa\].
    pub shear_modulus: f64,
    /// Density ρ \[kg/m³\], of which rotary inertia is made: ρI per metre.
    pub density: f64,
}

/// An infinite rail that bends, shears and turns (Timoshenko 1921), with hysteretic and viscous loss:
///
/// * w' = ψ + hS, Bψ' = M, M' = −S − Jω²ψ, S' = Kw − F δ(x), with deflection w, rotation ψ, bending
///   moment M and shear force S,
/// * B = EI(1 + iη), shear compliance h = 1/(κGA(1 + iη)), rotary inertia J = ρI,
/// * K = κ + iωc − mω² the dynamic stiffness of foundation, viscous damping and mass per metre.
///
/// h = J = 0 is the Euler–Bernoulli beam, exactly. Waves e^{−αx} have
/// Bα⁴ − (BhK − Jω²)α² + K(1 − Jω²h) = 0, and the displacement at the force is
/// H = (α₁α₂ + hK) / (2K(α₁ + α₂)), free of cancellation and regular where α₁ = α₂.
///
/// It serves lateral bending, with the second moment about the vertical axis.
///
/// Range of validity: cross-sections stay plane; from some 3 kHz the foot of a rail bends on its own,
/// and lateral bending couples with torsion from some hundred hertz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam {
    bending_stiffness: f64,
    mass_per_length: f64,
    /// 1/(κGA) \[1/N\], zero without shear.
    shear_compliance: f64,
    /// ρI \[kg m\], zero without rotary inertia.
    rotary_inertia: f64,
    loss_factor: f64,
    damping: f64,
}

impl From<EulerBernoulliBeam> for Beam {
    fn from(beam: EulerBernoulliBeam) -> Self {
        Self {
            bending_stiffness: beam.bending_stiffness(),
            mass_per_length: beam.mass_per_length(),
            shear_compliance: 0.0,
            rotary_inertia: 0.0,
            loss_factor: 0.0,
            damping: 0.0,
        }
    }
}

impl Beam {
    /// Timoshenko's beam of second moment of area I \[m⁴\] and mass per length m \[kg/m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless every value is positive and the shear coefficient at most one.
    pub fn timoshenko(
        material: ElasticMaterial,
        second_moment: f64,
        mass_per_length: f64,
        shear: ShearSection,
    ) -> Result<Self, Error> {
        Error::unless_positive("cross-section", shear.area, "m2")?;
        Error::unless_positive("shear modulus", shear.shear_modulus, "Pa")?;
        Error::unless_positive("density", shear.density, "kg/m3")?;
        if !(shear.shear_coefficient > 0.0 && shear.shear_coefficient <= 1.0) {
            return Err(Error::OutOfRange {
                quantity: "shear coefficient",
                value: shear.shear_coefficient,
                unit: "",
                rule: "must be above 0 and at most 1",
            });
        }
        let beam = EulerBernoulliBeam::new(material, second_moment, mass_per_length)?;
        Ok(Self {
            shear_compliance: (shear.shear_coefficient * shear.shear_modulus * shear.area).recip(),
            rotary_inertia: shear.density * second_moment,
            ..beam.into()
        })
    }

    /// Beam with a loss factor η \[-\]: E and G become E(1 + iη) and G(1 + iη).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if η is negative.
    pub fn with_loss_factor(self, loss_factor: f64) -> Result<Self, Error> {
        Error::unless_not_negative("rail loss factor", loss_factor, "")?;
        Ok(Self { loss_factor, ..self })
    }

    /// Beam with viscous damping c per length \[N s/m²\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if c is negative.
    pub fn with_damping(self, damping: f64) -> Result<Self, Error> {
        Error::unless_not_negative("rail damping", damping, "N s/m2")?;
        Ok(Self { damping, ..self })
    }

    /// Bending stiffness EI \[N m²\].
    pub fn bending_stiffness(&self) -> f64 {
        self.bending_stiffness
    }

    /// Angular frequency \[rad/s\] at which the rail bends with nodes every `spacing` \[m\], half a
    /// wavelength apart: the pinned-pinned frequency of supports at that spacing. Of order n = 2,
    /// nodes are half the spacing apart.
    ///
    /// Source: the dispersion relation above without foundation and loss at α = inπ/d. Exact to
    /// rounding. An Euler–Bernoulli beam overstates it by 20–35 % at spacings of 0.6–0.7 m, more at less.
    pub fn pinned_pinned_frequency(&self, spacing: f64, order: u32) -> f64 {
        let k = f64::from(order) * std::f64::consts::PI / spacing;
        let (b, h, j, m) = (self.bending_stiffness, self.shear_compliance, self.rotary_inertia, self.mass_per_length);
        // mJh ω⁴ − (m + k²(Bhm + J)) ω² + Bk⁴ = 0: the lower root, without cancellation.
        let linear = m + k * k * (b * h * m + j);
        let constant = b * k.powi(4);
        let root = (linear * linear - 4.0 * m * j * h * constant).sqrt();
        (2.0 * constant / (linear + root)).sqrt()
    }

    /// True if the rail shears: the pinned-pinned frequency may be named.
    pub fn shears(&self) -> bool {
        self.shear_compliance > 0.0
    }

    /// Static stiffness of bending and shear against a wave of the wavenumber k \[rad/m\], per metre
    /// \[N/m²\]: Bk⁴/(1 + Bhk²).
    pub(super) fn static_wave_stiffness(&self, k: f64) -> f64 {
        let b = self.bending_stiffness;
        b * k.powi(4) / (1.0 + b * self.shear_compliance * k * k)
    }

    pub(super) fn parts(&self) -> BeamParts {
        let elastic = Complex64::new(1.0, self.loss_factor);
        BeamParts {
            bending_stiffness: elastic * self.bending_stiffness,
            shear_compliance: self.shear_compliance / elastic,
            rotary_inertia: self.rotary_inertia,
            mass_per_length: self.mass_per_length,
            damping: self.damping,
        }
    }

    /// Stiffness on a foundation κ \[N/m²\] per metre against the waves of the relation above.
    pub(super) fn wave_stiffness(&self, w: f64, foundation: Complex64) -> WaveStiffness {
        let Dispersion { squares, transfer, .. } = self.dispersion(w, foundation);
        let leading = self.parts().bending_stiffness;
        WaveStiffness {
            leading,
            roots: squares,
            count: 2,
            // 1 − Jω²h and −Bh.
            denominator: transfer.map(|part| -2.0 * leading * part),
        }
    }

    fn dispersion(&self, w: f64, foundation: Complex64) -> Dispersion {
        let parts = self.parts();
        let (b, h) = (parts.bending_stiffness, parts.shear_compliance);
        let w2 = w * w;
        let stiffness = foundation + Complex64::new(-w2 * self.mass_per_length, w * self.damping);
        let turning = self.rotary_inertia * w2;
        let rigid = 1.0 - turning * h;
        let linear = b * h * stiffness - turning;
        let root = square_root(linear * linear - 4.0 * b * stiffness * rigid);
        // The larger root first; the other from the product, so that neither cancels.
        let larger =
            if (linear.conj() * root).re >= 0.0 { (linear + root) / (2.0 * b) } else { (linear - root) / (2.0 * b) };
        let squares = [larger, stiffness * rigid / (b * larger)];
        let propagation = [0, 1].map(|j| {
            let (z, other) = (squares[j], squares[1 - j]);
            // dz/dK of the dispersion relation.
            outgoing(z, || (b * h * z - rigid) / (b * (z - other)))
        });
        Dispersion { stiffness, shear: h * stiffness, squares, propagation, transfer: [-0.5 * rigid / b, 0.5 * h] }
    }
}

/// Values of a [`Beam`] with their loss.
pub(super) struct BeamParts {
    pub(super) bending_stiffness: Complex64,
    pub(super) shear_compliance: Complex64,
    pub(super) rotary_inertia: f64,
    pub(super) mass_per_length: f64,
    pub(super) damping: f64,
}

/// The roots α and what goes with them.
struct Dispersion {
    /// K \[N/m²\].
    stiffness: Complex64,
    /// hK \[1/m²\].
    shear: Complex64,
    /// α² \[1/m²\].
    squares: [Complex64; 2],
    /// α \[1/m\].
    propagation: [Complex64; 2],
    /// −(1 − Jω²h)/(2B) and h/2: those of [`Waves::Beam`], from A_j and z₁z₂ = K(1 − Jω²h)/B.
    transfer: [Complex64; 2],
}

impl Waveguide for Beam {
    fn mass_per_length(&self) -> f64 {
        self.mass_per_length
    }

    fn waves(&self, angular_frequency: f64, foundation: Complex64) -> Waves {
        let Dispersion { stiffness, shear, squares, propagation, transfer } =
            self.dispersion(angular_frequency, foundation);
        // ψ(0) = 0 and S(0⁺) = −F/2 fix the amplitudes.
        let common = (2.0 * stiffness * (squares[1] - squares[0])).inv();
        let amplitudes =
            [propagation[0] * (squares[1] - shear) * common, propagation[1] * (shear - squares[0]) * common];
        let waves = [0, 1].map(|j| Wave { propagation: propagation[j], amplitude: amplitudes[j] });
        Waves::Beam { waves, transfer }
    }

    fn point_receptance(&self, angular_frequency: f64, foundation: Complex64) -> Complex64 {
        let Dispersion { stiffness, shear, propagation: [first, second], .. } =
            self.dispersion(angular_frequency, foundation);
        (first * second + shear) / (2.0 * stiffness * (first + second))
    }
}
