//! Spherical Bessel functions.

/// Values j_n(z) of z > 0 for the orders n below `count`; those too small to matter, below 10⁻¹⁶ of j₀ to j_z, are zero.
///
/// Method: Miller's recurrence downwards, scaled by Σ (2n + 1) j_n² = 1 (Abramowitz & Stegun 1964, 10.1.50). Error: rounding. Cost:
/// one step an order up to z + 20 + 5z^⅓.
pub fn spherical_bessel_functions(z: f64, count: usize) -> Vec<f64> {
    /// Squares of it are numbers.
    const LARGEST: f64 = 1e100;
    let mut functions = vec![0.0; count];
    let begin = (z + 20.0 + 5.0 * z.cbrt()) as usize;
    let (mut higher, mut current) = (0.0, f64::MIN_POSITIVE.sqrt());
    let mut sum = 0.0;
    let mut first_two = [0.0; 2];
    for n in (0..begin).rev() {
        let lower = (2 * n + 3) as f64 / z * current - higher;
        (higher, current) = (current, lower);
        if let Some(function) = functions.get_mut(n) {
            *function = current;
        }
        sum += (2 * n + 1) as f64 * current * current;
        if current.abs() > LARGEST {
            let scale = current.abs().recip();
            (higher, current) = (higher * scale, current * scale);
            functions.iter_mut().for_each(|value| *value *= scale);
            sum *= scale * scale;
        }
        first_two = [current, higher];
    }
    // The sign is that of the larger of the first two in closed form.
    let exact = [z.sin() / z, (z.sin() / z - z.cos()) / z];
    let larger = usize::from(first_two[1].abs() > first_two[0].abs());
    let scale = (exact[larger] * first_two[larger]).signum() / sum.sqrt();
    functions.iter_mut().for_each(|value| *value *= scale);
    functions
}
