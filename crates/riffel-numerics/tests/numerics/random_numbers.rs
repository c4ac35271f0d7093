use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use riffel_numerics::random_numbers::{normal, normal_pair, uniform, unit};

#[test]
fn units_fill_their_range() {
    assert_eq!([0, 1 << 63, u64::MAX].map(unit), [0.0, 0.5, 1.0 - 0.5 * f64::EPSILON]);
}

/// Moments of 10⁵ draws: four standard errors, √(variance of the power/n).
#[test]
fn moments_are_those_of_the_distributions() {
    const DRAWS: u32 = 100_000;
    let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
    let mut mean = |draw: &dyn Fn(&mut Xoshiro256PlusPlus) -> f64| {
        (0..DRAWS).map(|_| draw(&mut random)).sum::<f64>() / f64::from(DRAWS)
    };
    let error = 4.0 / f64::from(DRAWS).sqrt();
    assert!((mean(&|random| uniform(random)) - 0.5).abs() < error * (1.0f64 / 12.0).sqrt());
    assert!(mean(&|random| normal(random)).abs() < error);
    assert!((mean(&|random| normal(random).powi(2)) - 1.0).abs() < error * 2f64.sqrt());
    assert!((mean(&|random| normal(random).powi(4)) - 3.0).abs() < error * 96f64.sqrt());
    let product = |random: &mut Xoshiro256PlusPlus| {
        let pair = normal_pair(random);
        pair.re * pair.im
    };
    assert!(mean(&product).abs() < error);
}
