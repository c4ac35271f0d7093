//! All roots of a polynomial at once.

use num_complex::Complex64;

/// Moves approximate roots of a polynomial of leading coefficient one onto its roots, as many as its degree; false if they do not
/// settle.
///
/// Method: Weierstrass (1903), Durand (1960) and Kerner (1966), zᵢ − p(zᵢ)/Πₖ(zᵢ − zₖ), each root from the newest of the
/// others; quadratic near simple roots. The polynomial comes as a function, in the form that cancels least: roots of
/// very different size each keep their digits. Guesses near the real axis are first moved off it, as the iteration
/// could not find a complex pair from there. Error: that of the polynomial's value over its slope; half the digits where
/// two roots coincide. Cost: some five evaluations a root from good guesses.
pub fn polish(polynomial: impl Fn(Complex64) -> Complex64, roots: &mut [Complex64]) -> bool {
    /// Enough from any guess seen in tests by a factor of three.
    const SWEEPS: usize = 200;
    /// Steps below this only move roundings.
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    /// From here on a step that does not shrink has met the rounding of the polynomial.
    const CLOSE: f64 = 1e-8;
    for (index, root) in roots.iter_mut().enumerate() {
        if root.im.abs() <= 1e-3 * root.re.abs() {
            *root *= Complex64::new(1.0, 1e-3 * (index as f64 + 1.0));
        }
    }
    let mut before = f64::INFINITY;
    for _ in 0..SWEEPS {
        let mut largest = 0f64;
        for index in 0..roots.len() {
            let root = roots[index];
            let others = roots.iter().enumerate().filter(|&(other, _)| other != index);
            let distances: Complex64 = others.map(|(_, other)| root - other).product();
            let step = polynomial(root) / distances;
            roots[index] = root - step;
            largest = largest.max(step.norm_sqr() / root.norm_sqr());
        }
        let largest = largest.sqrt();
        if largest <= ROUNDING || (largest <= CLOSE && largest >= 0.5 * before) {
            return true;
        }
        before = largest;
    }
    false
}
