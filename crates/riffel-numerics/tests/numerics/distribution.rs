use riffel_numerics::distribution::Distribution;

/// Mean and standard deviation by the midpoint rule over the quantiles.
fn moments(distribution: Distribution) -> (f64, f64) {
    let count = 200_000;
    let values = (0..count).map(|k| distribution.quantile((f64::from(k) + 0.5) / f64::from(count)));
    let (sum, squares) = values.fold((0.0, 0.0), |(sum, squares), x| (sum + x, squares + x * x));
    let mean = sum / f64::from(count);
    (mean, (squares / f64::from(count) - mean * mean).sqrt())
}

/// Moments in closed form; the midpoint rule over 2e5 quantiles loses some 1e-4 of the spread in infinite
/// tails. The share below a quantile is its own.
#[test]
fn moments_are_those_of_the_books() {
    let infinite = (f64::NEG_INFINITY, f64::INFINITY);
    let (density, below): (f64, f64) = (0.241_970_724_519_143_37, 0.682_689_492_137_085_9);
    let normal = |(min, max)| Distribution::Normal { mean: 3.0, standard_deviation: 2.0, min, max };
    let cases = [
        (Distribution::Uniform { min: 1.0, max: 4.0 }, 2.5, 3.0 / 12f64.sqrt()),
        (normal(infinite), 3.0, 2.0),
        // Cut at one standard deviation: σ²(1 − 2φ(1)/(Φ(1) − Φ(−1))).
        (normal((1.0, 5.0)), 3.0, 2.0 * (1.0 - 2.0 * density / below).sqrt()),
        (Distribution::lognormal_of_moments(5.0, 1.5, (0.0, f64::INFINITY)), 5.0, 1.5),
        (
            Distribution::Triangular { min: 0.0, mode: 1.0, max: 4.0 },
            5.0 / 3.0,
            ((0.0 + 1.0 + 16.0 - 0.0 - 0.0 - 4.0) / 18f64).sqrt(),
        ),
    ];
    for (distribution, mean, deviation) in cases {
        let found = moments(distribution);
        assert!((found.0 - mean).abs() < 1e-4 * deviation, "{distribution:?} {found:?}");
        assert!((found.1 - deviation).abs() < 5e-4 * deviation, "{distribution:?} {found:?}");
        assert!((distribution.mean() - mean).abs() < 1e-14 * mean, "{distribution:?}");
        for u in [0.1, 0.4, 0.9] {
            let share = distribution.share_within(f64::NEG_INFINITY, distribution.quantile(u));
            assert!((share - u).abs() < 1e-12, "{distribution:?} {u} {share}");
        }
    }
}

/// Far out in a tail the quantiles stay between the ends and in order.
#[test]
fn a_far_tail_keeps_its_digits() {
    for sign in [1.0, -1.0] {
        let ends = if sign > 0.0 { (8.0, 9.0) } else { (-9.0, -8.0) };
        let tail = Distribution::Normal { mean: 0.0, standard_deviation: 1.0, min: ends.0, max: ends.1 };
        // P(Z > z | Z > 8): the median is at φ(z)/z = φ(8)/16 nearly, z = 8.083 to 1e-3.
        let median = sign * tail.quantile(0.5);
        assert!((median - 8.0847).abs() < 2e-3, "{median}");
        let quantiles: Vec<f64> = (1..100).map(|k| tail.quantile(f64::from(k) / 100.0)).collect();
        assert!(quantiles.is_sorted() && quantiles[0] < quantiles[98]);
    }
}

/// Moments: of the standard normal distribution 1, 3, 15, 105, 945, 10395, of the even one 1/(n + 1).
#[test]
fn nodes_have_the_moments_of_their_distribution() {
    let normal = Distribution::normal(0.0, 1.0);
    let even = Distribution::Uniform { min: -1.0, max: 1.0 };
    for rule in 0..Distribution::RULES {
        for half in 0..=2 * rule as i32 + 2 {
            let moment = |it: &Distribution| -> f64 {
                it.nodes(rule).iter().map(|(at, weight)| weight * at.powi(2 * half)).sum()
            };
            let double_factorial: f64 = (1..=half).map(|k| f64::from(2 * k - 1)).product();
            // Nodes have 16 digits.
            assert!((moment(&normal) / double_factorial - 1.0).abs() < 1e-12, "{rule} {half}");
            assert!((moment(&even) * f64::from(2 * half + 1) - 1.0).abs() < 1e-12);
        }
        let odd: f64 = normal.nodes(rule).iter().map(|(at, weight)| weight * at).sum();
        assert!(odd.abs() < 1e-15);
    }
}

#[test]
fn shares_within_a_band() {
    let normal = Distribution::normal(0.0, 2.0);
    assert!((normal.share_within(-2.0, 2.0) - 0.682_689_492_137_086).abs() < 1e-14);
    let even = Distribution::Uniform { min: 0.0, max: 4.0 };
    assert_eq!(even.share_within(-1.0, 1.0), 0.25);
    assert_eq!(even.share_within(5.0, 6.0), 0.0);
}
