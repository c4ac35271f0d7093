//! The motion of a structure that nothing holds, found from its receptances.

use num_complex::Complex64;

/// Part A \[1/kg\] of receptances \[m/N\], H → −A/ω² for ω → 0, of a structure that only its receptances describe. Entries below
/// 10⁻⁹ are zero.
pub(crate) fn free_of(receptances: &dyn Fn(f64) -> Vec<Complex64>) -> Vec<f64> {
    /// Below any suspension, and high enough for the inertia of an axle beside its stiffness \[rad/s\].
    const SLOW: f64 = 0.3;
    /// \[1/kg\]: what springs and rounding leave.
    const NOTHING: f64 = 1e-9;
    // Springs leave powers of ω²: the polynomial through one, four and nine times the same, at zero.
    const SHARES: [(f64, f64); 3] = [(1.0, 1.5), (2.0, -0.6), (3.0, 0.1)];
    let mut free = Vec::new();
    for (times, share) in SHARES {
        let w = times * SLOW;
        let values = receptances(w);
        free.resize(values.len(), 0.0);
        for (free, value) in free.iter_mut().zip(values) {
            *free -= share * w * w * value.re;
        }
    }
    for free in &mut free {
        if free.abs() < NOTHING {
            *free = 0.0;
        }
    }
    free
}
