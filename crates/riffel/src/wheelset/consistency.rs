//! Reciprocity and passivity of receptances.

use super::{ContactReceptances, Port};

/// The largest departure of receptances from reciprocity, |H_ij − H_ji| over the larger of the two \[-\], and the entry.
pub fn reciprocity_error(receptances: &ContactReceptances) -> (f64, [Port; 2]) {
    let mut worst = (0.0, [Port::ALL[0]; 2]);
    for at in Port::ALL {
        for from in &Port::ALL[..at.index()] {
            let [one, other] = [[at, *from], [*from, at]].map(|[at, from]| receptances[at.index()][from.index()]);
            let error = (one - other).norm() / one.norm().max(other.norm());
            if error > worst.0 {
                worst = (error, [at, *from]);
            }
        }
    }
    worst
}

/// How far receptances are from those of a passive structure: the largest eigenvalue of (H − Hᴴ)/2i over the largest |H|
/// \[-\], or zero where none is positive, and the port with the largest share in it.
///
/// The power that a force f brings in is −ω fᴴ(H − Hᴴ)f/4i.
pub fn passivity_error(receptances: &ContactReceptances) -> (f64, Port) {
    // The eigenvalues of a Hermitian A + iB are those of the symmetric [[A, −B], [B, A]], each twice.
    let mut matrix = [[0.0; 12]; 12];
    let mut largest = 0f64;
    for (i, row) in receptances.iter().enumerate() {
        for (j, receptance) in row.iter().enumerate() {
            largest = largest.max(receptance.norm());
            let difference = receptance - receptances[j][i].conj();
            let (a, b) = (0.5 * difference.im, -0.5 * difference.re);
            (matrix[i][j], matrix[6 + i][6 + j]) = (a, a);
            (matrix[6 + i][j], matrix[i][6 + j]) = (b, -b);
        }
    }
    let (eigenvalue, vector) = largest_eigenvalue(matrix);
    let share = |port: usize| vector[port].powi(2) + vector[6 + port].powi(2);
    let port = (0..6).max_by(|&a, &b| share(a).total_cmp(&share(b)));
    let error = if largest > 0.0 { eigenvalue / largest } else { 0.0 };
    (error.max(0.0), Port::ALL[port.unwrap_or(0)])
}

/// The largest eigenvalue of a symmetric matrix and its vector, by Jacobi's rotations to rounding.
fn largest_eigenvalue<const N: usize>(mut matrix: [[f64; N]; N]) -> (f64, [f64; N]) {
    /// They converge quadratically; six or so are enough.
    const SWEEPS: usize = 30;
    let mut vectors = [[0.0; N]; N];
    for (i, vector) in vectors.iter_mut().enumerate() {
        vector[i] = 1.0;
    }
    for _ in 0..SWEEPS {
        let diagonal = (0..N).map(|i| matrix[i][i].abs()).fold(0.0, f64::max);
        let mut turned = false;
        for p in 0..N {
            for q in p + 1..N {
                if matrix[p][q].abs() <= f64::EPSILON * diagonal * 1e-2 {
                    continue;
                }
                turned = true;
                let cotangent = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
                let t = cotangent.signum() / (cotangent.abs() + cotangent.hypot(1.0));
                let cosine = t.hypot(1.0).recip();
                let turn = |x: &mut f64, y: &mut f64| {
                    (*x, *y) = (cosine * (*x - t * *y), cosine * (*y + t * *x));
                };
                for row in matrix.iter_mut().chain(&mut vectors) {
                    let (head, tail) = row.split_at_mut(q);
                    turn(&mut head[p], &mut tail[0]);
                }
                let (above, below) = matrix.split_at_mut(q);
                for (x, y) in above[p].iter_mut().zip(&mut below[0]) {
                    turn(x, y);
                }
            }
        }
        if !turned {
            break;
        }
    }
    let largest = (0..N).max_by(|&a, &b| matrix[a][a].total_cmp(&matrix[b][b]));
    let largest = largest.unwrap_or(0);
    (matrix[largest][largest], vectors.map(|row| row[largest]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex64;

    /// Of ones everywhere: N, with equal shares.
    #[test]
    fn jacobi_finds_the_largest_eigenvalue() {
        let (value, vector) = largest_eigenvalue([[1.0; 5]; 5]);
        assert!((value - 5.0).abs() < 1e-14);
        for share in vector {
            assert!((share.abs() - 0.2f64.sqrt()).abs() < 1e-14);
        }
    }

    #[test]
    fn tells_what_is_wrong_and_where() {
        let mut receptances = [[Complex64::ZERO; 6]; 6];
        for (i, row) in receptances.iter_mut().enumerate() {
            row[i] = Complex64::new(-1.0, -0.1);
        }
        assert_eq!(reciprocity_error(&receptances).0, 0.0);
        assert_eq!(passivity_error(&receptances).0, 0.0);

        receptances[5][4] = Complex64::new(0.5, 0.0);
        receptances[4][5] = Complex64::new(0.4, 0.0);
        let (error, ports) = reciprocity_error(&receptances);
        assert!((error - 0.2).abs() < 1e-15);
        assert_eq!(ports, [Port::ALL[5], Port::ALL[4]]);

        // A pair that is coupled more than it loses: −0.1 ± 0.3.
        receptances[4][5] = Complex64::new(0.0, 0.3);
        receptances[5][4] = Complex64::new(0.0, 0.3);
        let (error, port) = passivity_error(&receptances);
        let largest = Complex64::new(-1.0, -0.1).norm();
        assert!((error - 0.2 / largest).abs() < 1e-14, "{error}");
        assert!(port == Port::ALL[4] || port == Port::ALL[5]);
    }
}
