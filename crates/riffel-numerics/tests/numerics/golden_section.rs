use riffel_numerics::golden_section::golden_section;

/// The minimum of a parabola, to the tolerance asked for.
#[test]
fn golden_section_finds_a_minimum() {
    let minimum = golden_section([0.0, 3.0], 1e-9, |x| (x - 1.25f64).powi(2));
    assert!((minimum - 1.25).abs() < 1e-7); // the square root of rounding limits any search
    let within_rounding = golden_section([1.0, 2.0], 0.0, |x| (x - 1.25f64).powi(2));
    assert!((within_rounding - 1.25).abs() < 1e-7);
}
