//! The rail bending across the track and twisting, both at once.

use num_complex::Complex64;
use riffel_numerics::simultaneous_roots::polish;

use super::waves::outgoing;
use super::{Beam, Twist, Waveguide};

/// Deflection v of the shear centre across the track and twist θ: by a unit force across and by a unit moment.
pub(super) type LateralReceptance = [[Complex64; 2]; 2];

/// A rail that bends across the track and twists.
///
/// Waves e^{−αx} of the deflection v of the shear centre and the twist θ (positive: the head moves to the right), with
/// z = α², on a foundation that takes K_y per metre across the track and K_θ against rotation, at the depth d of the
/// foot below the shear centre, the centroid at the height c above it:
///
/// ```text
/// [ D_v(z) + K_y        −dK_y − ω²mc                   ] [ v ]   [ force  ]
/// [ −dK_y − ω²mc        D_θ(z) + K_θ + d²K_y − ω²mc²   ] [ θ ] = [ moment ]
/// ```
///
/// D_v is the beam's (see [`Beam`]: Bz² − mω² without shear), D_θ the twist's, EI_ωz² − GJz − ω²ρI_p. The determinant
/// times the shear of the beam is a polynomial of degree four in z, of three without warping; the residue at each root
/// is symmetric and of rank one, so that every wave has one shape r = (v, θ) and one amplitude A:
/// H(x) = Σ A_j r_j r_jᵀ e^{−α_j|x|}.
///
/// Method: the roots of bending and twist alone, moved onto those of both together. Exact to rounding; digits are lost
/// where two waves coincide, which only an undamped track can bring about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TwistingRail {
    pub(super) bending: Beam,
    pub(super) twist: Twist,
}

/// What carries a [`TwistingRail`], per metre or per support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Foundation {
    /// K_y, at the foot across the track.
    pub(super) lateral: Complex64,
    /// K_θ, against rotation of the foot.
    pub(super) roll: Complex64,
}

/// The waves that a force or a moment sends along a [`TwistingRail`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CoupledWaves {
    waves: [CoupledWave; 4],
    count: usize,
}

/// One of them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct CoupledWave {
    /// α.
    pub(super) propagation: Complex64,
    /// A.
    pub(super) amplitude: Complex64,
    /// r.
    pub(super) shape: [Complex64; 2],
}

impl Foundation {
    pub(super) const NONE: Self = Self { lateral: Complex64::ZERO, roll: Complex64::ZERO };

    /// Stiffness against (v, θ) of a rail whose foot is that far below its shear centre.
    pub(super) fn at_shear_centre(&self, foot_depth: f64) -> [[Complex64; 2]; 2] {
        let across = -foot_depth * self.lateral;
        [[self.lateral, across], [across, self.roll - foot_depth * across]]
    }
}

impl TwistingRail {
    pub(super) fn waves(&self, w: f64, foundation: &Foundation) -> CoupledWaves {
        /// A hundred roundings.
        const NOISE: f64 = 1e-14;
        /// A complex pair is so close to the real axis only where a rounding of the polynomial would make it real.
        const ALMOST: f64 = 1e-7;
        let section = self.twist.section();
        let mass = self.bending.mass_per_length();
        let [[lateral, across], [_, roll]] = foundation.at_shear_centre(section.foot_depth);
        // The centroid carries the mass.
        let moment = w * w * mass * section.centroid_height;
        let coupling = across - moment;
        let bending = self.bending.wave_stiffness(w, lateral);
        let twist = self.twist.wave_stiffness(w, roll - moment * section.centroid_height);

        let count = 2 + twist.count;
        let mut roots = [Complex64::ZERO; 4];
        roots[..2].copy_from_slice(bending.roots());
        roots[2..count].copy_from_slice(twist.roots());
        let leading = bending.leading * twist.leading;
        let coupled = coupling * coupling / leading;
        if coupling != Complex64::ZERO {
            let polynomial = |z: Complex64| bending.monic(z) * twist.monic(z) - coupled * bending.denominator(z);
            polish(polynomial, &mut roots[..count]);
            // Without loss it has real coefficients: what is almost real among the roots is so, and travels or decays.
            let value = polynomial(bending.roots[0].norm().into());
            if value.im.abs() <= NOISE * value.norm() {
                for root in &mut roots {
                    if root.im.abs() <= ALMOST * root.re.abs() {
                        root.im = 0.0;
                    }
                }
            }
        }

        // A twist by one radian moves the section about as far as its radius of gyration.
        let gyration = self.twist.polar_inertia() / mass;
        let wave = |index: usize| {
            let z = roots[index];
            // Residues of the adjugate: D_θ and D_v times the beam's shear.
            let denominator = bending.denominator(z);
            let mut by_bending = denominator * twist.leading * twist.monic(z);
            let mut by_twist = bending.leading * bending.monic(z);
            let mut slope = leading;
            let others = if coupling == Complex64::ZERO {
                // Each wave has its own motion, though it may coincide with one of the other.
                let is_bending = index < 2;
                if is_bending {
                    (by_bending, by_twist) = (denominator, Complex64::ZERO);
                    slope = bending.leading;
                    0..2
                } else {
                    (by_bending, by_twist) = (Complex64::ZERO, Complex64::ONE);
                    slope = twist.leading;
                    2..count
                }
            } else {
                0..count
            };
            for other in others {
                if other != index {
                    slope *= z - roots[other];
                }
            }
            // Damping of both motions moves every root the way damping of either does.
            let propagation = outgoing(z, || -(by_bending + gyration * by_twist) / slope);
            let scale = -(2.0 * propagation * slope).inv();
            let across = -denominator * coupling;
            let (amplitude, shape) = if by_bending.norm_sqr() >= (gyration * by_twist).norm_sqr() {
                (by_bending, [Complex64::ONE, across / by_bending])
            } else {
                (by_twist, [across / by_twist, Complex64::ONE])
            };
            CoupledWave { propagation, amplitude: amplitude * scale, shape }
        };
        let mut waves = [CoupledWave::default(); 4];
        for (index, slot) in waves[..count].iter_mut().enumerate() {
            *slot = wave(index);
        }
        CoupledWaves { waves, count }
    }
}

impl CoupledWaves {
    /// The waves, those that bending rules in the middle of the track first.
    pub(super) fn as_slice(&self) -> &[CoupledWave] {
        &self.waves[..self.count]
    }

    /// Motion at that distance from a force or moment, either way.
    pub(super) fn receptance(&self, distance: f64) -> LateralReceptance {
        let mut sum = LateralReceptance::default();
        for wave in self.as_slice() {
            let amplitude =
                if distance == 0.0 { wave.amplitude } else { wave.amplitude * (-wave.propagation * distance).exp() };
            let [lateral, twist] = wave.shape;
            sum[0][0] += amplitude * lateral * lateral;
            sum[0][1] += amplitude * lateral * twist;
            sum[1][1] += amplitude * twist * twist;
        }
        sum[1][0] = sum[0][1];
        sum
    }
}
