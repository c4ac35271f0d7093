use riffel_numerics::gauss::{GAUSS, equal_panels, gauss_legendre, panels};

/// Abramowitz & Stegun (1964), table 25.4, for the range from −1 to 1.
#[test]
fn rules_are_those_of_the_table() {
    let of_three = [(-0.6f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6f64.sqrt(), 5.0 / 9.0)];
    for ((place, weight), (at, of)) in gauss_legendre::<3>().into_iter().zip(of_three) {
        assert!((2.0 * place - 1.0 - at).abs() < 1e-15 && (2.0 * weight - of).abs() < 1e-15);
    }
    let (place, weight) = GAUSS[4];
    assert!((2.0 * place - 1.0 - 0.906_179_845_938_664).abs() < 1e-15);
    assert!((2.0 * weight - 0.236_926_885_056_189).abs() < 1e-15);
}

#[test]
fn a_wave_is_summed_to_rounding() {
    let edges = equal_panels([0.0, 20.0], 1.0);
    let sum: f64 = panels(&edges).map(|(x, weight)| weight * x.sin()).sum();
    assert!((sum - (1.0 - 20f64.cos())).abs() < 1e-10, "{sum}");
}
