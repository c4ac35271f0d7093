use riffel_numerics::normal_distribution::{HALF_OF_50, HALF_OF_80, HALF_OF_95, above, below, density, quantile};

/// Abramowitz & Stegun (1964), tables 26.1, 26.2 and 26.5.
#[test]
fn values_are_those_of_the_tables() {
    let quantiles = [(0.5, 0.0), (0.75, HALF_OF_50), (0.9, HALF_OF_80), (0.975, HALF_OF_95)];
    for (u, z) in quantiles.into_iter().chain([(0.995, 2.575_829_303_548_901), (1e-6, -4.753_424_308_822_899)]) {
        assert!((quantile(u) - z).abs() < 1e-14, "{u}: {}", quantile(u));
    }
    assert!((below(1.0) - 0.841_344_746_068_543).abs() < 1e-15);
    assert!((above(5.0) / 2.866_515_719_e-7 - 1.0).abs() < 1e-9);
    assert!((density(1.0) - 0.241_970_724_519_143).abs() < 1e-15);
}

/// The probability itself is rounded, which weighs more the flatter it is.
#[test]
fn a_quantile_is_the_inverse() {
    for step in -70..=50 {
        let z = 0.1 * f64::from(step);
        let rounding = f64::EPSILON * below(z) / density(z);
        assert!((quantile(below(z)) - z).abs() < 1e-14 + 20.0 * rounding, "{z}");
    }
}
