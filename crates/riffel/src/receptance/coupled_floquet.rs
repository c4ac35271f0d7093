//! Discrete supports under a rail whose waves bend and twist it.

use num_complex::Complex64;
use riffel_numerics::simultaneous_roots::polish;

use super::periodic::{InBay, outgoing_sinh};
use super::twisting_rail::{CoupledWave, CoupledWaves, LateralReceptance};

/// The Floquet waves of a rail that bends across the track and twists, on supports every d that hold both motions.
///
/// The free rail answers G(x) = Σ A_j r_j r_jᵀ e^{−α_j|x|}, a support of the stiffness K (2 × 2) with −Ku. The supports
/// together, their forces changing by ρ = e^{−μ} a bay, move the rail at each of them by Ĝ(c) times the force there,
/// Ĝ(c) = Σ A_j s_j r_j r_jᵀ/(C_j − c), with s_j = sinh α_jd, C_j = cosh α_jd and c = cosh μ. A wave runs where
/// det(I + KĜ(c)) = 0, by Cauchy and Binet a polynomial of as many roots as the free rail has waves,
///
/// ```text
/// Π(C_j − c) [1 + Σ A_j s_j r_jᵀK r_j/(C_j − c) + det K Σ A_i s_i A_j s_j (r_i × r_j)²/((C_i − c)(C_j − c))] = 0
/// ```
///
/// With the forces f of a wave at the supports, (I + KĜ)f = 0, and y_j = r_jᵀf/(C_j − c), its shape within a bay is
/// φ±(x) = Σ A_j [sinh α_j(d − x) + ρ^{±1} sinh α_jx] y_j r_j, and, for x ≥ x₀ in one bay,
///
/// H(x, x₀) = Σ φ⁺(x) φ⁻(x₀)ᵀ / (sinh μ Σ A_j s_j y_j²)
///
/// times ρⁿ for x in the n-th bay further on; x < x₀ by reciprocity. For one motion this is the sum of
/// [`PeriodicTrack`](super::PeriodicTrack), whose source and derivation hold here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CoupledFloquet {
    spacing: f64,
    free: CoupledWaves,
    waves: [CoupledFloquetWave; 4],
}

/// A place along the rail, with sinh α_j(d − x) and sinh α_jx of the free waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CoupledStation {
    place: InBay,
    sines: [[Complex64; 2]; 4],
}

/// One of the Floquet waves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct CoupledFloquetWave {
    /// ρ, |ρ| ≤ 1.
    multiplier: Complex64,
    /// A_j y_j, scaled by the C_j − c nearest to zero: where a support is weak, it vanishes.
    content: [Complex64; 4],
    /// 1/(sinh μ Σ A_j s_j y_j²), scaled alike.
    norm: Complex64,
}

impl CoupledFloquet {
    /// The waves on supports of the given stiffness against (v, θ).
    pub(super) fn new(free: CoupledWaves, stiffness: &[[Complex64; 2]; 2], spacing: f64) -> Self {
        let waves = free.as_slice();
        let count = waves.len();
        let mut shifted = [Complex64::ZERO; 4];
        let mut strength = [Complex64::ZERO; 4];
        for (index, wave) in waves.iter().enumerate() {
            let half = (0.5 * spacing * wave.propagation).exp();
            let (sinh, cosh) = (0.5 * (half - half.inv()), 0.5 * (half + half.inv()));
            // C_j − 1 without cancellation.
            shifted[index] = 2.0 * sinh * sinh;
            strength[index] = wave.amplitude * 2.0 * sinh * cosh;
        }
        let equation = Equation::new(waves, &strength, &shifted, stiffness);
        let mut roots = equation.guesses();
        polish(|root| equation.at(root), &mut roots[..count]);

        let mut floquet = [CoupledFloquetWave::default(); 4];
        for (slot, root) in floquet.iter_mut().zip(&roots[..count]) {
            let distance = shifted.map(|shifted| shifted - root);
            let nearest = distance[..count]
                .iter()
                .copied()
                .min_by(|a, b| a.norm_sqr().total_cmp(&b.norm_sqr()))
                .unwrap_or_default();
            let near = distance.map(|distance| nearest / distance);
            // Ĝ, scaled.
            let mut sum = LateralReceptance::default();
            for (index, wave) in waves.iter().enumerate() {
                let part = strength[index] * near[index];
                let [lateral, twist] = wave.shape;
                sum[0][0] += part * lateral * lateral;
                sum[0][1] += part * lateral * twist;
                sum[1][1] += part * twist * twist;
            }
            sum[1][0] = sum[0][1];
            let force = null_vector(&[0, 1].map(|row| {
                [0, 1].map(|column| {
                    let product = stiffness[row][0] * sum[0][column] + stiffness[row][1] * sum[1][column];
                    if row == column { nearest + product } else { product }
                })
            }));
            let mut norm = Complex64::ZERO;
            for (index, wave) in waves.iter().enumerate() {
                let [lateral, twist] = wave.shape;
                let share = (lateral * force[0] + twist * force[1]) * near[index];
                norm += strength[index] * share * share;
                slot.content[index] = wave.amplitude * share;
            }
            // Any damping of the supports turns the wave into one that decays; this one resists both motions.
            let motion = sum.map(|[lateral, twist]| lateral * force[0] + twist * force[1]);
            let damped = (motion[0] * motion[0] + motion[1] * motion[1]) / norm;
            let sinh_mu = outgoing_sinh(*root, damped);
            slot.multiplier = (root + 1.0 + sinh_mu).inv();
            slot.norm = (norm * sinh_mu).inv();
        }
        Self { spacing, free, waves: floquet }
    }

    fn waves(&self) -> &[CoupledFloquetWave] {
        &self.waves[..self.free.as_slice().len()]
    }

    /// A place \[m\] from a support, for as many receptances as start or end there.
    pub(super) fn station(&self, along: f64) -> CoupledStation {
        let place = InBay::new(along, self.spacing);
        let mut sines = [[Complex64::ZERO; 2]; 4];
        for (slot, wave) in sines.iter_mut().zip(self.free.as_slice()) {
            *slot = [self.spacing - place.within, place.within].map(|way| {
                let growth = (wave.propagation * way).exp();
                0.5 * (growth - growth.inv())
            });
        }
        CoupledStation { place, sines }
    }

    /// Motion at `to` by a force or moment at `from`.
    pub(super) fn between(&self, from: &CoupledStation, to: &CoupledStation) -> LateralReceptance {
        if to.place < from.place {
            let [[vv, vt], [tv, tt]] = self.between(to, from);
            return [[vv, tv], [vt, tt]];
        }
        let bays = to.place.bay - from.place.bay;
        let mut sum = LateralReceptance::default();
        for wave in self.waves() {
            let mut scale = wave.norm;
            if bays > 0.0 {
                scale *= wave.multiplier.powi(bays as i32);
            }
            let ahead = self.shape(wave, &to.sines, wave.multiplier);
            let back = self.shape(wave, &from.sines, wave.multiplier.inv());
            for (row, ahead) in sum.iter_mut().zip(ahead) {
                for (entry, back) in row.iter_mut().zip(back) {
                    *entry += scale * ahead * back;
                }
            }
        }
        sum
    }

    /// φ± with the factor of the wave, ρ or 1/ρ.
    fn shape(&self, wave: &CoupledFloquetWave, sines: &[[Complex64; 2]; 4], multiplier: Complex64) -> [Complex64; 2] {
        let mut sum = [Complex64::ZERO; 2];
        for (index, free) in self.free.as_slice().iter().enumerate() {
            let [rest, gone] = sines[index];
            let part = wave.content[index] * (rest + multiplier * gone);
            sum[0] += part * free.shape[0];
            sum[1] += part * free.shape[1];
        }
        sum
    }
}

/// The equation of the Floquet waves, a polynomial in c − 1.
struct Equation {
    count: usize,
    /// C_j − 1.
    shifted: [Complex64; 4],
    /// A_j s_j r_jᵀK r_j.
    single: [Complex64; 4],
    /// det K A_i s_i A_j s_j (r_i × r_j)², i < j.
    pair: [[Complex64; 4]; 4],
}

impl Equation {
    fn new(
        waves: &[CoupledWave],
        strength: &[Complex64; 4],
        shifted: &[Complex64; 4],
        stiffness: &[[Complex64; 2]; 2],
    ) -> Self {
        let [[lateral, across], [_, roll]] = *stiffness;
        let determinant = lateral * roll - across * across;
        let mut single = [Complex64::ZERO; 4];
        let mut pair = [[Complex64::ZERO; 4]; 4];
        for (index, wave) in waves.iter().enumerate() {
            let [v, theta] = wave.shape;
            single[index] = strength[index] * (lateral * v * v + 2.0 * across * v * theta + roll * theta * theta);
            for (other, next) in waves.iter().enumerate().skip(index + 1) {
                let cross = v * next.shape[1] - theta * next.shape[0];
                pair[index][other] = determinant * strength[index] * strength[other] * cross * cross;
            }
        }
        Self { count: waves.len(), shifted: *shifted, single, pair }
    }

    /// The polynomial, its leading coefficient one.
    fn at(&self, root: Complex64) -> Complex64 {
        let distance = self.shifted.map(|shifted| root - shifted);
        let distance = &distance[..self.count];
        // Products of the distances before and behind each wave, and the sums without one of them and without two.
        let mut before = Complex64::ONE;
        let mut without_one = Complex64::ZERO;
        let mut without_two = Complex64::ZERO;
        for (index, own) in distance.iter().enumerate() {
            let rest: Complex64 = distance[index + 1..].iter().product();
            without_one += self.single[index] * before * rest;
            for other in index + 1..self.count {
                let between: Complex64 = distance[index + 1..other].iter().product();
                let rest: Complex64 = distance[other + 1..].iter().product();
                without_two += self.pair[index][other] * before * between * rest;
            }
            before *= own;
        }
        before - without_one + without_two
    }

    /// Roots of bending and twist apart: of the first two waves and of the others.
    fn guesses(&self) -> [Complex64; 4] {
        let alone = |index: usize| self.shifted[index] + self.single[index];
        let two = |first: usize| {
            let second = first + 1;
            let product = self.shifted[first] * self.shifted[second]
                + self.shifted[first] * self.single[second]
                + self.single[first] * self.shifted[second]
                + self.pair[first][second];
            let half = 0.5 * (alone(first) + alone(second));
            let root = (half * half - product).sqrt();
            let larger = if (half.conj() * root).re >= 0.0 { half + root } else { half - root };
            [larger, product / larger]
        };
        let [first, second] = two(0);
        let [third, fourth] = match self.count {
            3 => [alone(2), Complex64::ZERO],
            _ => two(2),
        };
        [first, second, third, fourth]
    }
}

/// A vector that a singular matrix takes to zero.
fn null_vector(matrix: &[[Complex64; 2]; 2]) -> [Complex64; 2] {
    let size = |row: &[Complex64; 2]| row[0].norm_sqr() + row[1].norm_sqr();
    let [first, second] = matrix;
    if size(first) >= size(second) { [-first[1], first[0]] } else { [second[1], -second[0]] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticMaterial;
    use crate::receptance::twisting_rail::{Foundation, TwistingRail};
    use crate::receptance::{Beam, ShearSection, Twist, TwistSection};
    use std::f64::consts::TAU;

    /// Rail UIC60 of Kostovasilis, Thompson & Hussein (2017), with or without warping and with its mass at the centroid
    /// or at the shear centre.
    fn rail(warping_constant: f64, centroid_height: f64) -> TwistingRail {
        let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
        let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.538, shear_modulus: 80.769e9, density: 7850.0 };
        let section = TwistSection {
            torsion_constant: 2.212e-6,
            polar_second_moment: 3.55e-5,
            warping_constant,
            centroid_height,
            foot_depth: 0.048,
            foot_width: 0.15,
            shear_modulus: 80.769e9,
            density: 7850.0,
        };
        TwistingRail {
            bending: Beam::timoshenko(steel, 5.127e-6, 60.2, shear)
                .and_then(|beam| beam.with_loss_factor(0.02))
                .unwrap(),
            twist: Twist::new(steel, section).and_then(|twist| twist.with_loss_factor(0.02)).unwrap(),
        }
    }

    const SPACING: f64 = 0.6;

    fn foundation() -> Foundation {
        Foundation { lateral: Complex64::new(40e6, 12e6), roll: Complex64::new(120e6, 36e6) * (0.15 * 0.15 / 12.0) }
    }

    fn track(rail: &TwistingRail, hertz: f64) -> CoupledFloquet {
        let free = rail.waves(TAU * hertz, &Foundation::NONE);
        CoupledFloquet::new(free, &foundation().at_shear_centre(0.048), SPACING)
    }

    /// Distance from the expected v by a force, v by a moment and θ by a moment, in units of those at the place of the force.
    fn error(track: &CoupledFloquet, from: f64, to: f64, expected: [(f64, f64); 3]) -> f64 {
        let [[vv, vt], [_, tt]] = track.between(&track.station(from), &track.station(to));
        let [[own_vv, _], [_, own_tt]] = track.between(&track.station(from), &track.station(from));
        let scales = [own_vv.norm(), (own_vv * own_tt).norm().sqrt(), own_tt.norm()];
        let errors = [vv, vt, tt].into_iter().zip(expected).zip(scales);
        errors.map(|((got, (re, im)), scale)| (got - Complex64::new(re, im)).norm() / scale).fold(0.0, f64::max)
    }

    /// Warping constant \[m⁶\] and height of the centroid \[m\], frequency \[Hz\], places of force and motion \[m\], v by a force, v by a
    /// moment and θ by a moment: of the periodic transfer matrix of one bay (eight states of the rail, six without warping; waves from
    /// its eigenvectors, a force as a jump between those of either side) in arithmetic of 60 digits.
    const EXACT: &str = "\
0.0 0.0 561.0 0.17 0.45 -4.5032057673189e-9 -1.1486835499738e-9 -3.663809562872e-10 5.1461047414827e-9 -5.5243340789116e-7 -4.2374201338896e-7
0.0 0.033 5.0 0.17 0.45 1.4028568160901e-8 -3.3212811059845e-9 5.2813037616915e-8 -1.1178000314544e-8 1.3277984141233e-6 -2.5077235175584e-7
2.161e-8 0.0 101.0 0.3 0.3 2.6455365522881e-8 -1.2028263833703e-8 1.0913608309901e-7 -6.4865212829353e-8 2.0725806301796e-6 -7.32464421663e-7
2.161e-8 0.033 0.1 0.17 0.45 1.3938582032718e-8 -3.3028249150669e-9 5.3186205573732e-8 -1.0988515481077e-8 1.255558256829e-6 -2.5238964035268e-7
2.161e-8 0.033 1.0 0.17 0.45 1.3939245118331e-8 -3.3031834604459e-9 5.3191314706705e-8 -1.0991152917844e-8 1.2556091764076e-6 -2.524151691084e-7
2.161e-8 0.033 5.0 0.17 0.45 1.3955342608476e-8 -3.3118974996262e-9 5.3315372015435e-8 -1.1055279720685e-8 1.2568454438383e-6 -2.5303577718802e-7
2.161e-8 0.033 20.0 0.17 0.45 1.4212647227382e-8 -3.4537666797345e-9 5.5304670117566e-8 -1.2106362176674e-8 1.2766350947375e-6 -2.6318251073464e-7
2.161e-8 0.033 330.0 0.1 2.6 4.7837024566954e-10 3.9254100116599e-9 1.1768983338891e-8 -8.9773382884304e-9 -5.9062040697264e-8 4.0350303929627e-7
2.161e-8 0.033 1300.0 0.1 2.6 3.8552357735512e-11 5.4861833752826e-10 -1.2445136149621e-9 -2.3227903555113e-9 1.8900847283339e-8 9.8032397475826e-8
2.161e-8 0.033 5000.0 0.17 0.45 7.6059113924429e-11 -2.5747934503985e-11 -3.0339510811746e-10 -6.7290537393713e-10 1.0688096622731e-8 6.6352561808373e-9";

    #[test]
    fn supports_to_all_digits() {
        for row in EXACT.lines() {
            let numbers: Vec<f64> = (row.split(' ').map(|number| number.parse().unwrap())).collect();
            let [warping, centroid, hertz, from, to] = numbers[..5] else { panic!("{row}") };
            let expected = [5, 7, 9].map(|first| (numbers[first], numbers[first + 1]));
            let track = track(&rail(warping, centroid), hertz);
            let error = error(&track, from, to, expected);
            // Far below, amplitudes of lateral waves cancel.
            let tolerance = if hertz < 1.0 { 1e-11 } else { 1e-12 };
            assert!(error < tolerance, "{hertz} Hz from {from} m to {to} m: {error:e}");
        }
        assert_eq!(EXACT.lines().count(), 10);
    }
}
