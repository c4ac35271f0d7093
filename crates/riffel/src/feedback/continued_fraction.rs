//! An analytic function continued from the imaginary axis into the half-planes beside it.

use num_complex::Complex64;

/// Thiele's continued fraction through values at real frequencies, a₀ + (x − x₀)/(a₁ + (x − x₁)/(a₂ + …)).
///
/// Method: nodes are taken one after the other where the fraction is farthest from the values that are left (Salazar Celis 2021,
/// recalled), until it meets all of them to 1e-12. Accuracy: as many digits as the values have, less about one for each of their spacings that a
/// place lies beside the axis; a resonance that no value shows is missed.
pub(super) struct ContinuedFraction {
    nodes: Vec<f64>,
    terms: Vec<Complex64>,
}

impl ContinuedFraction {
    /// Through values at frequencies.
    pub(super) fn through(samples: &[(f64, Complex64)]) -> Self {
        const MOST: usize = 40;
        const MET: f64 = 1e-12;
        let mut fraction = Self { nodes: Vec::new(), terms: Vec::new() };
        let size = |value: &Complex64| value.norm().max(1e-300);
        for _ in 0..MOST.min(samples.len()) {
            let off = |(x, value): &(f64, Complex64)| match fraction.nodes.contains(x) {
                true => 0.0,
                false => (fraction.at((*x).into())[0] - value).norm() / size(value),
            };
            let far = samples.iter().map(|sample| (off(sample), sample)).max_by(|one, other| one.0.total_cmp(&other.0));
            let Some((off, &(x, value))) = far else { break };
            if off < MET {
                break;
            }
            let pairs = fraction.nodes.iter().zip(&fraction.terms);
            let term = pairs.fold(value, |v, (node, term)| (x - node) / (v - term));
            if !term.is_finite() {
                break;
            }
            fraction.nodes.push(x);
            fraction.terms.push(term);
        }
        fraction
    }

    /// Value and slope at a complex frequency.
    pub(super) fn at(&self, x: Complex64) -> [Complex64; 2] {
        let Some((&last, terms)) = self.terms.split_last() else {
            return [Complex64::ZERO; 2];
        };
        let pairs = terms.iter().zip(&self.nodes).rev();
        let (value, slope) = pairs.fold((last, Complex64::ZERO), |(inner, slope), (term, node)| {
            let ratio = (x - node) / inner;
            (term + ratio, (1.0 - ratio * slope) / inner)
        });
        [value, slope]
    }

    /// A zero of it by Newton's method from a place, beside those that are known already.
    pub(super) fn zero_from(&self, start: Complex64, known: &[Complex64]) -> Option<Complex64> {
        const STEPS: usize = 60;
        const FOUND: f64 = 1e-12;
        let mut x = start;
        for _ in 0..STEPS {
            let [value, slope] = self.at(x);
            let others: Complex64 = known.iter().map(|zero| (x - zero).inv()).sum();
            let step = -(slope / value - others).inv();
            x += step;
            if !x.is_finite() {
                return None;
            }
            if step.norm() < FOUND * x.norm() {
                return Some(x);
            }
        }
        None
    }
}
