//! A sum of partial fractions through the values of a transfer function.

use num_complex::Complex64;

use super::least_squares::least_squares;

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
}

/// Partial fractions with poles of negative real part that come near the values H(iω) at angular frequencies ω, as many
/// poles as `order`, pairs counted twice; least squares of the relative error.
///
/// Method: vector fitting (Gustavsen & Semlyen 1999, IEEE Trans. Power Delivery 14, 1052–1061) with the relaxed condition
/// of Gustavsen (2006, IEEE Trans. Power Delivery 21, 1587–1592): poles move to the zeros of a scaling function found
/// by linear least squares, unstable ones are mirrored, and residues follow in the end. A transfer function that is not
/// causal comes out as the nearest causal one. Cost: ten or so systems of twice as many real equations as values.
pub(super) fn partial_fractions(
    frequencies: &[f64],
    values: &[Complex64],
    order: usize,
) -> Vec<PartialFraction> {
    /// Poles rest after some six moves in every case seen.
    const MOVES: usize = 12;
    let scale = frequencies[frequencies.len() - 1];
    let s: Vec<Complex64> = frequencies
        .iter()
        .map(|w| Complex64::new(0.0, w / scale))
        .collect();
    let mut poles = starting_poles(frequencies[0] / scale, order);
    for _ in 0..MOVES {
        poles = moved(&s, values, &poles);
    }
    let mut columns: Vec<Vec<f64>> = Vec::new();
    for basis in basis(&s, &poles) {
        let relative = basis.iter().zip(values).map(|(basis, value)| basis / value);
        columns.push(parts(relative));
    }
    let mut right = parts(values.iter().map(|_| Complex64::ONE));
    let coefficients = least_squares(&mut columns, &mut right);
    let mut coefficients = coefficients.into_iter();
    let mut next = || coefficients.next().unwrap_or_default();
    let fractions = poles.iter().map(|&pole| PartialFraction {
        residue: match pole.im == 0.0 {
            true => scale * Complex64::from(next()),
            false => scale * Complex64::new(next(), next()),
        },
        pole: scale * pole,
    });
    fractions.collect()
}

/// A third of the poles real, the others pairs of little damping, evenly over the decades below one.
fn starting_poles(lowest: f64, order: usize) -> Vec<Complex64> {
    let pairs = order / 3;
    let real = order - 2 * pairs;
    let place = |index: usize, count: usize| lowest.powf(1.0 - (index as f64 + 0.5) / count as f64);
    let on_axis = (0..real).map(|index| Complex64::from(-place(index, real)));
    let off_axis = (0..pairs).map(|index| Complex64::new(-0.05, 1.0) * place(index, pairs));
    on_axis.chain(off_axis).collect()
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
        columns.push(
            both()
                .map(|(one, other)| Complex64::I * (one - other))
                .collect(),
        );
    }
    columns
}

/// Real parts, then imaginary parts.
fn parts(values: impl Iterator<Item = Complex64> + Clone) -> Vec<f64> {
    values
        .clone()
        .map(|value| value.re)
        .chain(values.map(|value| value.im))
        .collect()
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
    let solution = least_squares(&mut columns, &mut right);
    let d = solution[0];
    let mut of_sigma = solution[1..=basis.len()].iter().map(|c| c / d);
    let mut next = || of_sigma.next().unwrap_or_default();
    let mut terms: Vec<(Complex64, Complex64)> = Vec::new();
    for &pole in poles {
        if pole.im == 0.0 {
            terms.push((pole, next().into()));
        } else {
            let coefficient = Complex64::new(next(), next());
            terms.push((pole, coefficient));
            terms.push((pole.conj(), coefficient.conj()));
        }
    }
    zeros(&terms)
}

/// Zeros of σ = 1 + Σ c/(s − p), mirrored to the left half-plane: real ones, and of pairs those above the axis.
///
/// Method: Ehrlich (1967) and Aberth (1973), all zeros at once, with p'/p of the numerator as σ'/σ + Σ 1/(s − p): no
/// product is formed that could leave the range of numbers. Begun at the poles, where zeros of vector fitting end.
fn zeros(terms: &[(Complex64, Complex64)]) -> Vec<Complex64> {
    const SWEEPS: usize = 200;
    /// Of the size of a zero.
    const ROUNDING: f64 = 1e-14;
    let guesses = terms.iter().enumerate();
    // Off the poles, and off the real axis, which no real zero leaves by itself.
    let mut zeros: Vec<Complex64> = guesses
        .map(|(index, (pole, _))| {
            pole * Complex64::new(1.001, 1e-3 * (1.0 + index as f64 / terms.len() as f64))
        })
        .collect();
    for _ in 0..SWEEPS {
        let mut largest = 0f64;
        for index in 0..zeros.len() {
            let zero = zeros[index];
            let (mut sigma, mut slope, mut poles) =
                (Complex64::ONE, Complex64::ZERO, Complex64::ZERO);
            for &(pole, coefficient) in terms {
                let inverse = (zero - pole).inv();
                sigma += coefficient * inverse;
                slope -= coefficient * inverse * inverse;
                poles += inverse;
            }
            let others = zeros
                .iter()
                .enumerate()
                .filter(|&(other, _)| other != index);
            let repulsion: Complex64 = others.map(|(_, other)| (zero - other).inv()).sum();
            let step = sigma / (slope + sigma * (poles - repulsion));
            // On a pole or on another zero to rounding: there it stays.
            if step.is_finite() {
                zeros[index] = zero - step;
                largest = largest.max(step.norm() / zero.norm());
            }
        }
        if largest <= ROUNDING {
            break;
        }
    }
    in_pairs(zeros)
}

/// Roots of a real polynomial, each pair found where two are nearest to being conjugate.
fn in_pairs(roots: Vec<Complex64>) -> Vec<Complex64> {
    /// Part of its size by which rounding may part a root from the conjugate of its other.
    const ROUNDING: f64 = 1e-6;
    let stable = |root: Complex64| Complex64::new(-root.re.abs(), root.im);
    let (above, mut below): (Vec<_>, Vec<_>) = roots.into_iter().partition(|root| root.im > 0.0);
    let mut poles = Vec::new();
    for root in above {
        let distance = |other: &Complex64| (other.conj() - root).norm();
        let nearest = (0..below.len())
            .min_by(|&one, &other| distance(&below[one]).total_cmp(&distance(&below[other])));
        match nearest {
            Some(other) if distance(&below[other]) <= ROUNDING * root.norm() => {
                below.swap_remove(other);
                poles.push(stable(root));
            }
            _ => poles.push(Complex64::from(-root.norm())),
        }
    }
    poles.extend(below.into_iter().map(|root| Complex64::from(-root.norm())));
    poles
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
        let frequencies: Vec<f64> = (0..200)
            .map(|index| 10f64.powf(f64::from(index) / 40.0))
            .collect();
        let at = |fractions: &[PartialFraction], w: f64| {
            fractions
                .iter()
                .map(|fraction| fraction.at(Complex64::new(0.0, w)))
                .sum::<Complex64>()
        };
        let values: Vec<Complex64> = frequencies.iter().map(|&w| at(&known, w)).collect();
        let found = partial_fractions(&frequencies, &values, 8);
        for fraction in known {
            let nearest = found
                .iter()
                .map(|found| (found.pole - fraction.pole).norm());
            assert!(
                nearest.fold(f64::INFINITY, f64::min) < 1e-6 * fraction.pole.norm(),
                "{found:?}"
            );
        }
        for (&w, value) in frequencies.iter().zip(&values) {
            assert!((at(&found, w) - value).norm() < 1e-8 * value.norm());
        }
    }
}
