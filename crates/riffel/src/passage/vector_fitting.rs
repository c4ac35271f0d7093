//! A sum of partial fractions through the values of a transfer function.

use num_complex::Complex64;
use rayon::prelude::*;

use riffel_numerics::eigenvalues::eigenvalues;
use riffel_numerics::least_squares::{least_squares, least_squares_of_several, remainder};

/// A real pole, or one of a pair with the imaginary part above zero, and its residue. In time it is
/// Re(residue · e^{pole · t}), twice that for a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PartialFraction {
    pub(super) pole: Complex64,
    pub(super) residue: Complex64,
}

impl PartialFraction {
    /// Value at s: r/(s − p), and r̄/(s − p̄) with it for a pair.
    pub(super) fn at(&self, s: Complex64) -> Complex64 {
        let value = self.residue / (s - self.pole);
        if self.pole.im == 0.0 {
            return value;
        }
        value + self.residue.conj() / (s - self.pole.conj())
    }

    /// r of its part Re(r e^{pt}) in time.
    pub(super) fn of_term(&self) -> Complex64 {
        match self.pole.im == 0.0 {
            true => self.residue,
            false => 2.0 * self.residue,
        }
    }
}

/// Partial fractions with poles of negative real part that come near the values H(iω) at angular frequencies ω, as many
/// poles as `order`, pairs counted twice; least squares of the relative error.
///
/// Method: vector fitting (Gustavsen & Semlyen 1999, IEEE Trans. Power Delivery 14, 1052–1061) with the relaxed condition
/// of Gustavsen (2006, IEEE Trans. Power Delivery 21, 1587–1592): poles move to the zeros of a scaling function found
/// by linear least squares, unstable ones are mirrored, and residues follow in the end. A transfer function that is not
/// causal comes out as the nearest causal one. Cost: ten or so systems of twice as many real equations as values.
pub(super) fn partial_fractions(frequencies: &[f64], values: &[Complex64], order: usize) -> Vec<PartialFraction> {
    let poles = poles(frequencies, values, order);
    let sizes: Vec<f64> = values.iter().map(|value| value.norm()).collect();
    residues(frequencies, &[values.to_vec()], &sizes, &poles).swap_remove(0)
}

/// The poles of [`partial_fractions`].
fn poles(frequencies: &[f64], values: &[Complex64], order: usize) -> Vec<Complex64> {
    /// Poles rest after some six moves in every case seen.
    const MOVES: usize = 12;
    let scale = frequencies[frequencies.len() - 1];
    let s = scaled(frequencies, scale);
    let mut poles = starting_poles(frequencies[0] / scale, order);
    for _ in 0..MOVES {
        poles = moved(&s, values, &poles);
    }
    poles.iter().map(|pole| scale * pole).collect()
}

/// A transfer function at some frequencies, and the size over which an error counts at each.
pub(super) struct Sampled<'a> {
    pub(super) values: &'a [Complex64],
    pub(super) sizes: &'a [f64],
}

/// Poles \[rad/s\] that several transfer functions share, least squares of their errors, from poles to start from.
///
/// Method: that of [`partial_fractions`]; the residues of each function are eliminated before the scaling function is found
/// (Deschrijver, Mrozowski, Dhaene & De Zutter 2008, IEEE Microwave Wireless Comp. Lett. 18, 383–385).
pub(super) fn shared_poles(frequencies: &[f64], functions: &[Sampled<'_>], starting: &[Complex64]) -> Vec<Complex64> {
    /// The best of these is taken: further ones go to and fro.
    const MOVES: usize = 3;
    let scale = frequencies[frequencies.len() - 1];
    let s = scaled(frequencies, scale);
    let mut poles: Vec<Complex64> = starting.iter().map(|pole| pole / scale).collect();
    let mut best = (f64::INFINITY, Vec::new());
    for _ in 0..MOVES {
        poles = moved_together(&s, functions, &poles);
        let unscaled: Vec<Complex64> = poles.iter().map(|pole| scale * pole).collect();
        let missed = functions.par_iter().map(|Sampled { values, sizes }| {
            let fit = residues(frequencies, &[values.to_vec()], sizes, &unscaled).swap_remove(0);
            let errors = frequencies.iter().zip(*values).zip(*sizes).map(|((w, value), size)| {
                let s = Complex64::new(0.0, *w);
                let sum: Complex64 = fit.iter().map(|fraction| fraction.at(s)).sum();
                ((sum - value) / size).norm_sqr()
            });
            errors.sum::<f64>()
        });
        let missed = missed.collect::<Vec<f64>>().iter().sum();
        if missed < best.0 {
            best = (missed, unscaled);
        }
    }
    best.1
}

/// Partial fractions of each function with given poles, least squares of the error over the size given at each frequency.
pub(super) fn residues(
    frequencies: &[f64],
    functions: &[Vec<Complex64>],
    sizes: &[f64],
    poles: &[Complex64],
) -> Vec<Vec<PartialFraction>> {
    let scale = frequencies[frequencies.len() - 1];
    let s = scaled(frequencies, scale);
    let scaled_poles: Vec<Complex64> = poles.iter().map(|pole| pole / scale).collect();
    let over_size = |values: &[Complex64]| {
        let pairs: Vec<Complex64> = values.iter().zip(sizes).map(|(value, size)| value / size).collect();
        parts(pairs.into_iter())
    };
    let mut columns: Vec<Vec<f64>> = basis(&s, &scaled_poles).iter().map(|basis| over_size(basis)).collect();
    let rights = functions.iter().map(|values| over_size(values)).collect();
    let fractions = |coefficients: Vec<f64>| {
        let mut coefficients = coefficients.into_iter();
        let mut next = || coefficients.next().unwrap_or_default();
        let fractions = poles.iter().map(|&pole| PartialFraction {
            residue: match pole.im == 0.0 {
                true => scale * Complex64::from(next()),
                false => scale * Complex64::new(next(), next()),
            },
            pole,
        });
        fractions.collect()
    };
    let coefficients = least_squares_of_several(&mut columns, rights);
    coefficients.into_iter().map(fractions).collect()
}

/// The frequencies of the largest errors, of neighbours one.
pub(super) fn worst_frequencies(mut errors: Vec<(f64, f64)>, count: usize) -> Vec<f64> {
    /// Part of its frequency within which one pair of poles is enough.
    const NEAR: f64 = 0.05;
    errors.sort_by(|one, other| other.1.total_cmp(&one.1));
    let mut worst: Vec<f64> = Vec::new();
    for (w, _) in errors {
        if worst.iter().all(|other| (w / other - 1.0).abs() > NEAR) {
            worst.push(w);
        }
        if worst.len() == count {
            break;
        }
    }
    worst
}

fn scaled(frequencies: &[f64], scale: f64) -> Vec<Complex64> {
    let s = frequencies.iter().map(|w| Complex64::new(0.0, w / scale));
    s.collect()
}

/// A third of the poles real, the others pairs of little damping, evenly over the decades below one.
pub(super) fn starting_poles(lowest: f64, order: usize) -> Vec<Complex64> {
    let pairs = order / 3;
    let real = order - 2 * pairs;
    let place = |index: usize, count: usize| lowest.powf(1.0 - (index as f64 + 0.5) / count as f64);
    let on_axis = (0..real).map(|index| Complex64::from(-place(index, real)));
    let off_axis = (0..pairs).map(|index| Complex64::new(-0.05, 1.0) * place(index, pairs));
    on_axis.chain(off_axis).collect()
}

/// Poles \[rad/s\] to start from: a dozen real ones over the decades, and pairs of little damping, three quarters evenly up
/// to `dense`, the others over the decades; where `dense` \[rad/s\] ends, lines may lie as close as a few frequencies.
pub(super) fn starting_lines([lowest, highest]: [f64; 2], dense: f64, order: usize) -> Vec<Complex64> {
    const REAL: usize = 12;
    let pairs = order.saturating_sub(REAL) / 2;
    let lines = pairs * 3 / 4;
    let others = pairs - lines;
    let place =
        |index: usize, count: usize| highest * (lowest / highest).powf(1.0 - (index as f64 + 0.5) / count as f64);
    let on_axis = (0..REAL).map(|index| Complex64::from(-place(index, REAL)));
    let lines = (0..lines).map(|index| Complex64::new(-0.02, 1.0) * (dense * (index as f64 + 0.5) / lines as f64));
    let others = (0..others).map(|index| Complex64::new(-0.05, 1.0) * place(index, others));
    on_axis.chain(lines).chain(others).collect()
}

/// Functions of s with real coefficients: 1/(s − p), and for a pair their sum and i times their difference.
fn basis(s: &[Complex64], poles: &[Complex64]) -> Vec<Vec<Complex64>> {
    let mut columns = Vec::new();
    for &pole in poles {
        let one = s.iter().map(|s| (s - pole).inv());
        if pole.im == 0.0 {
            columns.push(one.collect());
            continue;
        }
        let one: Vec<Complex64> = one.collect();
        let other: Vec<Complex64> = s.iter().map(|s| (s - pole.conj()).inv()).collect();
        let both = || one.iter().zip(&other);
        columns.push(both().map(|(one, other)| one + other).collect());
        columns.push(both().map(|(one, other)| Complex64::I * (one - other)).collect());
    }
    columns
}

/// Real parts, then imaginary parts.
fn parts(values: impl Iterator<Item = Complex64> + Clone) -> Vec<f64> {
    values.clone().map(|value| value.re).chain(values.map(|value| value.im)).collect()
}

/// The poles after one move: zeros of σ = d + Σ c_j/(s − p_j), where Σ r_j/(s − p_j) comes nearest to σH and the mean of
/// Re σ is one.
fn moved(s: &[Complex64], values: &[Complex64], poles: &[Complex64]) -> Vec<Complex64> {
    let basis = basis(s, poles);
    let count = s.len() as f64;
    // Divided by H: Σ r_j φ_j/H − Σ c_j φ_j − d = 0, with the condition as the last row. The constant comes first, so that
    // it is there even where the others nearly depend on each other.
    let mut constant = parts(s.iter().map(|_| -Complex64::ONE));
    constant.push(count.sqrt());
    let mut columns = vec![constant];
    for basis in &basis {
        let mut column = parts(basis.iter().map(|basis| -basis));
        column.push(basis.iter().map(|basis| basis.re).sum::<f64>() / count.sqrt());
        columns.push(column);
    }
    for basis in &basis {
        let mut column = parts(basis.iter().zip(values).map(|(basis, value)| basis / value));
        column.push(0.0);
        columns.push(column);
    }
    let mut right = vec![0.0; 2 * s.len() + 1];
    right[2 * s.len()] = count.sqrt();
    let solution = least_squares(&mut columns, &right);
    zeros_of_scaling(poles, &solution[..=basis.len()])
}

/// Poles after one move for several functions.
fn moved_together(s: &[Complex64], functions: &[Sampled<'_>], poles: &[Complex64]) -> Vec<Complex64> {
    let basis = basis(s, poles);
    let count = basis.len();
    let remainders: Vec<Vec<Vec<f64>>> = functions
        .par_iter()
        .map(|Sampled { values, sizes }| {
            let over_size = |values: &[Complex64]| {
                let pairs = values.iter().zip(*sizes);
                let ratios: Vec<Complex64> = pairs.map(|(value, size)| value / size).collect();
                parts(ratios.into_iter())
            };
            let mut columns: Vec<Vec<f64>> = basis.iter().map(|basis| over_size(basis)).collect();
            let negative: Vec<Complex64> = values.iter().map(|value| -value).collect();
            columns.push(over_size(&negative));
            for basis in &basis {
                let pairs = basis.iter().zip(&negative);
                let scaled: Vec<Complex64> = pairs.map(|(basis, value)| basis * value).collect();
                columns.push(over_size(&scaled));
            }
            remainder(&mut columns, count)
        })
        .collect();
    let frequencies = (s.len() as f64).sqrt();
    let mut columns: Vec<Vec<f64>> = (0..=count)
        .map(|index| {
            let mut column: Vec<f64> = remainders.iter().flat_map(|columns| columns[index].iter().copied()).collect();
            // The mean of Re σ is one.
            column.push(match index {
                0 => frequencies,
                _ => basis[index - 1].iter().map(|basis| basis.re).sum::<f64>() / frequencies,
            });
            column
        })
        .collect();
    let mut right = vec![0.0; columns[0].len()];
    if let Some(last) = right.last_mut() {
        *last = frequencies;
    }
    let solution = least_squares(&mut columns, &right);
    zeros_of_scaling(poles, &solution)
}

/// Zeros of σ = d + Σ c_j φ_j from d and c, mirrored to the left half-plane: real ones, and of pairs those above the axis.
///
/// They are the eigenvalues of A − b cᵀ/d with the poles in A, real blocks of two rows for pairs (Gustavsen & Semlyen 1999).
fn zeros_of_scaling(poles: &[Complex64], solution: &[f64]) -> Vec<Complex64> {
    let count = solution.len() - 1;
    let mut matrix = vec![vec![0.0; count]; count];
    let mut inputs = Vec::with_capacity(count);
    for pole in poles {
        let row = inputs.len();
        matrix[row][row] = pole.re;
        if pole.im == 0.0 {
            inputs.push(1.0);
            continue;
        }
        matrix[row + 1][row + 1] = pole.re;
        matrix[row][row + 1] = pole.im;
        matrix[row + 1][row] = -pole.im;
        inputs.extend([2.0, 0.0]);
    }
    for (row, input) in matrix.iter_mut().zip(inputs) {
        for (entry, c) in row.iter_mut().zip(&solution[1..]) {
            *entry -= input * c / solution[0];
        }
    }
    let zeros = eigenvalues(matrix).into_iter();
    let above = zeros.filter(|zero| zero.im >= 0.0);
    above.map(|zero| Complex64::new(-zero.re.abs(), zero.im)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three pairs and two real poles come back from 200 values.
    #[test]
    fn finds_the_poles_of_partial_fractions() {
        let known = [
            (Complex64::new(-3.0, 100.0), Complex64::new(1.0, -2.0)),
            (Complex64::new(-80.0, 700.0), Complex64::new(5.0, 1.0)),
            (Complex64::new(-300.0, 9e3), Complex64::new(-20.0, 90.0)),
            (Complex64::from(-20.0), Complex64::from(2.0)),
            (Complex64::from(-4e3), Complex64::from(-70.0)),
        ]
        .map(|(pole, residue)| PartialFraction { pole, residue });
        let frequencies: Vec<f64> = (0..200).map(|index| 10f64.powf(f64::from(index) / 40.0)).collect();
        let at = |fractions: &[PartialFraction], w: f64| {
            fractions.iter().map(|fraction| fraction.at(Complex64::new(0.0, w))).sum::<Complex64>()
        };
        let values: Vec<Complex64> = frequencies.iter().map(|&w| at(&known, w)).collect();
        let found = partial_fractions(&frequencies, &values, 8);
        for fraction in known {
            let nearest = found.iter().map(|found| (found.pole - fraction.pole).norm());
            assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-6 * fraction.pole.norm(), "{found:?}");
        }
        for (&w, value) in frequencies.iter().zip(&values) {
            assert!((at(&found, w) - value).norm() < 1e-8 * value.norm());
        }
    }
}
