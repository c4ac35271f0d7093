//! Kalker's linear theory of rolling contact, solved to check the table of `KalkerCoefficients`.
//!
//! No slip anywhere: in the patch, scaled to the unit disc, the displacement difference is
//! u = (ξx − φxy + f(y), ηx + φx²/2 + h(y)), and f and h are such that the traction vanishes at the
//! leading edge (Kalker 1967, 1990 section 2.2.3). Spherical harmonics of degree n, even in
//! z = √(1 − X² − Y²), turn the elastic half-space into one small matrix for each n: a traction
//! Yₙₘ/z has the Fourier transform 2π(−i)ⁿ jₙ(κ) Yₙₘ, and ∫jₙjₗ dκ vanishes for even n − l ≠ 0. The
//! unknown f and h are sums of Legendre polynomials, the edge is met at as many points.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// C₁₁, C₂₂, C₂₃, C₃₃ \[-\] for ν, a/b and the number of polynomial degrees; with 24 the error is
/// 2e-4 for 0.1 ≤ a/b ≤ 10 (`converges`). C₂₃ is the mean of the two values that reciprocity makes
/// equal.
pub(crate) fn coefficients(poisson_ratio: f64, axis_ratio: f64, degrees: usize) -> [f64; 4] {
    // Unit area ab: forces in units of G, moments in units of G√(ab).
    let (a, b) = (axis_ratio.sqrt(), 1.0 / axis_ratio.sqrt());
    let stiffness: Vec<_> = (0..degrees).map(|degree| compliance(degree, poisson_ratio, a, b)).collect();
    let traction = |degree: usize, component: usize, displacement: &[f64]| {
        let count = displacement.len();
        let mut right = vec![0.0; 2 * count];
        for (cell, u) in right[component * count..].iter_mut().zip(displacement) {
            *cell = 0.5 * u;
        }
        solve(stiffness[degree].clone(), right)
    };

    let unknowns: Vec<(usize, Vec<f64>)> =
        (0..2 * degrees).map(|i| (i / 2, traction(i / 2, i % 2, &zonal(i / 2, FRAC_PI_2)))).collect();
    let edge: Vec<(f64, usize)> =
        (0..2 * degrees).map(|i| (((i / 2) as f64 + 0.5) * PI / degrees as f64 - FRAC_PI_2, i % 2)).collect();
    let matrix: Vec<Vec<f64>> = edge
        .iter()
        .map(|&(angle, component)| {
            unknowns.iter().map(|(degree, field)| at_edge(*degree, field, angle, component)).collect()
        })
        .collect();

    let scaled = |factor: f64, field: Vec<f64>| -> Vec<f64> { field.into_iter().map(|u| factor * u).collect() };
    let product: Vec<f64> =
        zonal(2, FRAC_PI_4).iter().zip(zonal(2, -FRAC_PI_4)).map(|(plus, minus)| (plus - minus) / 3.0).collect();
    // The displacements of ξ, η and φ, each by degree, component and harmonics.
    let creepages = [
        vec![(1, 0, scaled(a, zonal(1, 0.0)))],
        vec![(1, 1, scaled(a, zonal(1, 0.0)))],
        vec![
            (2, 0, scaled(-a * b, product)),
            (2, 1, scaled(a * a / 3.0, zonal(2, 0.0))),
            (0, 1, scaled(a * a / 6.0, zonal(0, 0.0))),
        ],
    ];
    let [longitudinal, lateral, spin] = creepages.map(|fields| {
        let mut parts: Vec<(usize, Vec<f64>)> =
            fields.iter().map(|(degree, component, field)| (*degree, traction(*degree, *component, field))).collect();
        let right = edge
            .iter()
            .map(|&(angle, component)| {
                -parts.iter().map(|(degree, field)| at_edge(*degree, field, angle, component)).sum::<f64>()
            })
            .collect();
        let amplitudes = solve(matrix.clone(), right);
        parts.extend(
            unknowns
                .iter()
                .zip(amplitudes)
                .map(|((degree, field), amplitude)| (*degree, scaled(amplitude, field.clone()))),
        );
        // ∫ P p dX dY of a harmonic P on the disc, half of that over the sphere.
        let moment = |degree: usize, component: usize, angle: f64| -> f64 {
            let weights = zonal(degree, angle);
            let offset = component * weights.len();
            parts
                .iter()
                .filter(|(other, _)| *other == degree)
                .map(|(_, field)| 0.5 * dot(&weights, &field[offset..]))
                .sum()
        };
        [moment(0, 0, 0.0), moment(0, 1, 0.0), a * moment(1, 1, 0.0) - b * moment(1, 0, FRAC_PI_2)]
    });
    [-longitudinal[0], -lateral[1], 0.5 * (lateral[2] - spin[1]), -spin[2]]
}

/// Real harmonics of one degree on the equator; their sign off it is of no consequence.
fn harmonics(degree: usize, angle: f64) -> Vec<f64> {
    // (k − 1)!!/k!! of an even k.
    let ratio = |k: usize| -> f64 { (1..=k / 2).map(|i| 1.0 - 0.5 / i as f64).product() };
    let mut values = Vec::new();
    for order in (degree % 2..=degree).step_by(2) {
        let square = (2 * degree + 1) as f64 / (4.0 * PI) * ratio(degree + order) * ratio(degree - order);
        if order == 0 {
            values.push(square.sqrt());
        } else {
            let (sine, cosine) = (order as f64 * angle).sin_cos();
            let norm = (2.0 * square).sqrt();
            values.extend([norm * cosine, norm * sine]);
        }
    }
    values
}

/// The Legendre polynomial of the coordinate in a direction of the disc, in harmonics.
fn zonal(degree: usize, angle: f64) -> Vec<f64> {
    let factor = 4.0 * PI / (2 * degree + 1) as f64;
    harmonics(degree, angle).into_iter().map(|value| factor * value).collect()
}

fn at_edge(degree: usize, field: &[f64], angle: f64, component: usize) -> f64 {
    let values = harmonics(degree, angle);
    dot(&values, &field[component * values.len()..])
}

fn dot(left: &[f64], right: &[f64]) -> f64 {
    left.iter().zip(right).map(|(l, r)| l * r).sum()
}

/// Matrix of one degree: both bodies, (2/Gk)(I − ν kkᵀ/k²) with k = (cos α/a, sin α/b) κ.
fn compliance(degree: usize, poisson_ratio: f64, a: f64, b: f64) -> Vec<Vec<f64>> {
    // The periodic integrand has its poles at a distance of about min(a/b, b/a) from the real axis.
    let points = 4 * degree + (40.0 * (a / b).max(b / a)) as usize + 16;
    let count = degree + 1;
    let mut matrix = vec![vec![0.0; 2 * count]; 2 * count];
    for point in 0..points {
        let angle = 2.0 * PI * (point as f64 + 0.5) / points as f64;
        let wave = [angle.cos() / a, angle.sin() / b];
        let number = wave[0].hypot(wave[1]);
        let values = harmonics(degree, angle);
        let factor = 2.0 * PI * PI / (points * (2 * degree + 1)) as f64 / number;
        for (i, row) in matrix.iter_mut().enumerate() {
            for (j, cell) in row.iter_mut().enumerate() {
                let (to, from) = (i / count, j / count);
                let kernel =
                    f64::from(u8::from(to == from)) - poisson_ratio * wave[to] * wave[from] / (number * number);
                *cell += factor * kernel * values[i % count] * values[j % count];
            }
        }
    }
    matrix
}

/// Gauss elimination with partial pivoting.
fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let size = right.len();
    for column in 0..size {
        let pivot = (column..size)
            .max_by(|&i, &j| matrix[i][column].abs().total_cmp(&matrix[j][column].abs()))
            .unwrap_or(column);
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        for row in column + 1..size {
            let factor = matrix[row][column] / matrix[column][column];
            let (above, below) = matrix.split_at_mut(row);
            for (cell, upper) in below[0].iter_mut().zip(&above[column]).skip(column) {
                *cell -= factor * upper;
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..size).rev() {
        let known: f64 = (row + 1..size).map(|j| matrix[row][j] * right[j]).sum();
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::coefficients;

    // Long: solves the boundary-value problem of Kalker with 36 degrees at four ratios.
    #[test]
    fn converges() {
        for (poisson_ratio, axis_ratio) in [(0.0, 0.1), (0.5, 0.1), (0.3, 1.0), (0.5, 10.0)] {
            let coarse = coefficients(poisson_ratio, axis_ratio, 24);
            let fine = coefficients(poisson_ratio, axis_ratio, 36);
            for (coarse, fine) in coarse.into_iter().zip(fine) {
                assert!((coarse / fine - 1.0).abs() < 2e-4, "{coarse} {fine}");
            }
        }
    }
}
