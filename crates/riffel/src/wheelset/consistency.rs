//! Reciprocity and passivity of receptances.

use riffel_numerics::matrix::Matrix;

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
    let mut matrix = Matrix::of(12, |_, _| 0.0);
    let mut set = |row: usize, column: usize, value| matrix.values[12 * row + column] = value;
    let mut largest = 0f64;
    for (i, row) in receptances.iter().enumerate() {
        for (j, receptance) in row.iter().enumerate() {
            largest = largest.max(receptance.norm());
            let difference = receptance - receptances[j][i].conj();
            let (a, b) = (0.5 * difference.im, -0.5 * difference.re);
            set(i, j, a);
            set(6 + i, 6 + j, a);
            set(6 + i, j, b);
            set(i, 6 + j, -b);
        }
    }
    let (values, vectors) = matrix.eigenvectors();
    let top = (0..12).max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0);
    let share = |port: usize| vectors.at(top, port).powi(2) + vectors.at(top, 6 + port).powi(2);
    let port = (0..6).max_by(|&a, &b| share(a).total_cmp(&share(b)));
    let error = if largest > 0.0 { values[top] / largest } else { 0.0 };
    (error.max(0.0), Port::ALL[port.unwrap_or(0)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex64;

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
