//! Growth of a wave together with its neighbours, which the passing of supports makes of it.

use num_complex::Complex64;
use riffel_numerics::elimination::{identity, inverse};

use crate::Error;
use crate::damage::DamageLaw;
use crate::feedback::Loop;
use crate::receptance::MovingLoadOnSupports;

/// Growth per passage as an operator over the wavenumbers k_n = 2π/λ + 2πn/d, n = −N … N.
///
/// A wave of the profile meets a track that changes with the supports. So its normal force has the frequencies ω + nΩ, and
/// its wear the wavenumbers k_n, each of which makes all the others again: what grows is no longer a single wave but an
/// eigenvector of
///
/// G = −(k_w/ρ2b) diag(e_n) A⁻¹, A_nm = Ĥ_{n−m}(ω + mΩ) + δ_nm (H_w(ω + nΩ) + 1/k_H),
///
/// with Ĥ_n of [`MovingLoadOnSupports`], and e_n the oscillation of the energy per metre that the loop makes of a normal
/// force at k_n; what the wave's own geometry makes of the profile at k_n stands beside it on the diagonal. N = A⁻¹r is the normal force by harmonic balance. G₀₀ is the growth of the wave alone, the mean over the bay of
/// the quasi-static loop for V → 0; the eigenvalues tend to the growth at each place of the bay as more neighbours are taken,
/// where growth does not change from one neighbour to the next. An eigenvalue is the growth rate of its pattern
/// (real part) and the phase by which it moves along the rail in each passage (imaginary part, positive ahead of e^{ikx}).
///
/// The excitation by the mean load, P₀ on supports that give way less than mid-span, is no part of this: it does not depend
/// on the profile. Method: Gaussian elimination; the eigenvalue by squaring exp(G) until one pattern is left, 10⁻⁸.
/// Cost: that of 2N + 1 frequencies of [`MovingLoadOnSupports::harmonics`].
///
/// Source: harmonic balance of a wheel on a periodic track; derived in the book.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowthWithNeighbours {
    /// 2π/λ + 2πn/d \[rad/m\], n = −N … N.
    pub wavenumbers: Vec<f64>,
    /// G, row by row: growth of wave n by wave m, per passage.
    pub operator: Vec<Vec<Complex64>>,
    /// Eigenvalue of the largest real part.
    pub leading: Complex64,
    /// Its eigenvector, the largest element one.
    pub pattern: Vec<Complex64>,
    /// Support spacing d \[m\].
    pub spacing: f64,
}

impl GrowthWithNeighbours {
    /// The wave of the length λ \[m\] with `neighbours` on each side.
    ///
    /// `feedback` gives wheel, contact and wear; its track is not used.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a loop of more than one wheel along one axis and for more neighbours than have a wavelength, N < d/λ, and
    /// those of
    /// [`MovingLoadOnSupports::harmonics`].
    pub fn at(
        feedback: &Loop,
        track: &MovingLoadOnSupports,
        wavelength: f64,
        neighbours: usize,
    ) -> Result<Self, Error> {
        Error::unless_positive("wavelength", wavelength, "m")?;
        let Some(feedback) = feedback.closed_form() else {
            return Err(Error::OutOfRange {
                quantity: "number of contacts of a wave with neighbours",
                value: feedback.contacts().len() as f64,
                unit: "",
                rule: "must be one, of a wheel along one axis",
            });
        };
        if let Some(damage) = &feedback.contact.damage
            && damage.laws != [DamageLaw::Wear]
        {
            return Err(Error::OutOfRange {
                quantity: "number of laws of damage of a wave with neighbours",
                value: damage.laws.len() as f64,
                unit: "",
                rule: "must be none: leave [damage] out",
            });
        }
        let spacing = track.spacing();
        if neighbours as f64 >= 0.999 * spacing / wavelength {
            return Err(Error::OutOfRange {
                quantity: "number of neighbours",
                value: neighbours as f64,
                unit: "",
                rule: "must be below the support spacing over the wavelength",
            });
        }
        let count = 2 * neighbours + 1;
        let wavenumbers: Vec<f64> = (0..count)
            .map(|index| {
                let order = index as f64 - neighbours as f64;
                std::f64::consts::TAU * (wavelength.recip() + order / spacing)
            })
            .collect();
        let speed = track.speed();
        let mut matrix = vec![vec![Complex64::ZERO; count]; count];
        for (m, k) in wavenumbers.iter().enumerate() {
            let w = k * speed;
            let harmonics = track.harmonics(w, 2 * neighbours)?;
            for (n, row) in matrix.iter_mut().enumerate() {
                row[m] = harmonics.at(n as isize - m as isize);
            }
            matrix[m][m] += feedback.wheel.receptance(w, speed);
            matrix[m][m] += feedback.contact.stiffness.recip();
        }
        let mut operator = inverse(matrix);
        let per_energy = feedback.contact.wear.depth_per_energy();
        let pressed: Vec<f64> = wavenumbers.iter().map(|&k| feedback.pressed(k)).collect();
        for (n, (row, k)) in operator.iter_mut().zip(&wavenumbers).enumerate() {
            let wavelength = std::f64::consts::TAU / k;
            let [by_force, by_profile] = feedback.energy_by_normal_force_and_profile(wavelength, speed);
            for (entry, pressed) in row.iter_mut().zip(&pressed) {
                *entry *= -per_energy * by_force * pressed;
            }
            row[n] -= per_energy * by_profile;
        }
        let (leading, pattern) = leading(&operator);
        Ok(Self { wavenumbers, operator, leading, pattern, spacing })
    }

    /// Growth of the wave alone, G₀₀: that of a long profile of one wavelength.
    pub fn alone(&self) -> Complex64 {
        let middle = self.operator.len() / 2;
        self.operator[middle][middle]
    }

    /// Amplitude of the pattern at a distance from a support \[m\]: |Σ v_n e^{2πinx/d}|.
    pub fn amplitude_at(&self, place: f64) -> f64 {
        let terms = self.pattern.iter().enumerate();
        let turn = std::f64::consts::TAU * place / self.spacing;
        let sum: Complex64 = terms.map(|(n, value)| value * Complex64::from_polar(1.0, turn * n as f64)).sum();
        sum.norm()
    }
}

/// Eigenvalue of the largest real part and its vector: columns of exp(sG) for s → ∞ are multiples of it.
fn leading(operator: &[Vec<Complex64>]) -> (Complex64, Vec<Complex64>) {
    /// Then s|G| is 2³⁶/64: parts that differ by 10⁻⁷ of |G| are told apart.
    const SQUARINGS: u32 = 36;
    let count = operator.len();
    let size = operator.iter().flatten().map(|entry| entry.norm_sqr());
    let size = size.sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    // exp(G/64|G|) to rounding.
    let scaled: Vec<Vec<Complex64>> =
        operator.iter().map(|row| row.iter().map(|entry| entry / (64.0 * size)).collect()).collect();
    let mut power = identity(count);
    for order in (1..=8).rev() {
        power = product(&scaled, &power);
        for (index, row) in power.iter_mut().enumerate() {
            row.iter_mut().for_each(|entry| *entry /= f64::from(order));
            row[index] += 1.0;
        }
    }
    for _ in 0..SQUARINGS {
        power = product(&power, &power);
        let largest = power.iter().flatten().map(|entry| entry.norm());
        let largest = largest.fold(f64::MIN_POSITIVE, f64::max);
        for entry in power.iter_mut().flatten() {
            *entry /= largest;
        }
    }
    let norm = |column: usize| power.iter().map(|row| row[column].norm_sqr()).sum::<f64>();
    let column = (0..count).max_by(|&one, &other| norm(one).total_cmp(&norm(other)));
    let column = column.unwrap_or(0);
    let mut vector: Vec<Complex64> = power.iter().map(|row| row[column]).collect();
    let largest = (0..count).max_by(|&one, &other| vector[one].norm().total_cmp(&vector[other].norm()));
    let unit = vector[largest.unwrap_or(0)];
    vector.iter_mut().for_each(|entry| *entry /= unit);
    let image: Vec<Complex64> =
        operator.iter().map(|row| row.iter().zip(&vector).map(|(entry, part)| entry * part).sum()).collect();
    let square: f64 = vector.iter().map(|part| part.norm_sqr()).sum();
    let along: Complex64 = vector.iter().zip(&image).map(|(part, image)| part.conj() * image).sum();
    (along / square, vector)
}

fn product(one: &[Vec<Complex64>], other: &[Vec<Complex64>]) -> Vec<Vec<Complex64>> {
    let row = |row: &Vec<Complex64>| {
        let entry = |column: usize| {
            let pairs = row.iter().zip(other);
            pairs.map(|(entry, other)| entry * other[column]).sum()
        };
        (0..other.len()).map(entry).collect()
    };
    one.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a matrix with the eigenvalues −3, 1 and 1 + 10⁻³ ± 5i, made by a similarity, the upper of the pair or the
    /// lower.
    #[test]
    fn the_largest_real_part_leads() {
        let values = [Complex64::from(-3.0), Complex64::from(1.0), Complex64::new(1.001, 5.0)];
        let basis: Vec<Vec<Complex64>> = (0..3)
            .map(|i| (0..3).map(|j| Complex64::new(1.0 / f64::from(1 + i + j), f64::from(i * j))).collect())
            .collect();
        let back = inverse(basis.clone());
        let mut scaled = back;
        for (row, value) in scaled.iter_mut().zip(values) {
            row.iter_mut().for_each(|entry| *entry *= value);
        }
        let matrix = product(&basis, &scaled);
        let (value, vector) = leading(&matrix);
        assert!((value - values[2]).norm() < 1e-8, "{value}");
        let ratio = vector[1] / vector[0] - basis[1][2] / basis[0][2];
        assert!(ratio.norm() < 1e-8);
    }
}
