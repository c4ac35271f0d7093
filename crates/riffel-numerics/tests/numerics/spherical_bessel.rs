use riffel_numerics::spherical_bessel::spherical_bessel_functions;

/// In closed form to order 2, through many turns; rounding.
#[test]
fn in_closed_form() {
    for step in 1..400 {
        let z = 0.13 * f64::from(step);
        let (sine, cosine) = z.sin_cos();
        let exact = [sine / z, (sine / z - cosine) / z, ((3.0 / (z * z) - 1.0) * sine - 3.0 * cosine / z) / z];
        for (count, orders) in [(1, 1), (73, 3)] {
            let got = spherical_bessel_functions(z, count);
            assert_eq!(got.len(), count);
            for (got, exact) in got.iter().zip(exact).take(orders) {
                assert!((got - exact).abs() < 1e-12 / z.min(1.0), "{z}: {got} {exact}");
            }
        }
    }
}

/// Abramowitz & Stegun (1964), table 10.5.
#[test]
fn high_orders_are_those_of_the_table() {
    let at = |z: f64, n: usize, exact: f64| {
        let got = spherical_bessel_functions(z, 101)[n];
        assert!((got / exact - 1.0).abs() < 1e-9, "{n} {z}: {got}");
    };
    at(1.0, 10, 7.116_552_640e-11);
    at(10.0, 10, 6.460_515_449e-2);
    at(100.0, 100, 1.088_047_701e-2);
}
