use riffel_numerics::simpson::simpson;

/// ∫ x³ = ¼, and ∫ x⁴ = ⅕ but for (1/panels)⁴ · 4!/180.
#[test]
fn powers_are_summed() {
    for panels in [2, 4, 16] {
        let sum = |power: i32| simpson(panels).map(|(x, weight)| weight * x.powi(power)).sum::<f64>();
        assert!((sum(0) - 1.0).abs() < 1e-15 && (sum(3) - 0.25).abs() < 1e-15);
        let error = 24.0 / 180.0 / (panels as f64).powi(4);
        assert!((sum(4) - 0.2 - error).abs() < 1e-15, "{panels}");
    }
}
