//! Search for a minimum along one axis.

/// Minimum of a unimodal function by golden-section search (Kiefer 1953) to an absolute tolerance, or to rounding where that
/// is wider: 80 steps take 2e-17 of the bracket.
pub fn golden_section([mut low, mut high]: [f64; 2], tolerance: f64, f: impl Fn(f64) -> f64) -> f64 {
    const MOST_STEPS: usize = 80;
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let (mut inner_low, mut inner_high) = (high - ratio * (high - low), low + ratio * (high - low));
    let (mut at_low, mut at_high) = (f(inner_low), f(inner_high));
    for _ in 0..MOST_STEPS {
        if high - low <= tolerance {
            break;
        }
        if at_low < at_high {
            (high, inner_high, at_high) = (inner_high, inner_low, at_low);
            inner_low = high - ratio * (high - low);
            at_low = f(inner_low);
        } else {
            (low, inner_low, at_low) = (inner_low, inner_high, at_high);
            inner_high = low + ratio * (high - low);
            at_high = f(inner_high);
        }
    }
    0.5 * (low + high)
}
