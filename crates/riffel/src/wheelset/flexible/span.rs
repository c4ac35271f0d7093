//! How motion and load pass along an axle of one diameter.

use num_complex::Complex64;

use riffel_numerics::square::Square;

/// Displacements d and loads p at the far end of a span by those at its near end: d' = T_dd d + T_dp p and
/// p' = T_pd d + T_pp p. The loads are those that the span receives from what lies beyond it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Transfer<const N: usize> {
    pub(super) displacement: [Square<N>; 2],
    pub(super) load: [Square<N>; 2],
}

impl<const N: usize> Transfer<N> {
    /// Across the span from a part of dynamic stiffness Z at its near end, p = Z d: the dynamic stiffness at the far end,
    /// and the matrix that gives d from d'.
    #[inline(always)]
    pub(super) fn across(&self, stiffness: Square<N>) -> (Square<N>, Square<N>) {
        let [by_displacement, by_load] = self.displacement;
        let back = (by_displacement + by_load * stiffness).inverse();
        let [load_by_displacement, load_by_load] = self.load;
        let load = load_by_displacement + load_by_load * stiffness;
        ((load * back).symmetric(), back)
    }

    /// The dynamic stiffness at the near end where the far end is held and Z lies before it.
    pub(super) fn held(&self, stiffness: Square<N>) -> Square<N> {
        let [by_displacement, by_load] = self.displacement;
        by_load.inverse() * (by_displacement + by_load * stiffness)
    }

    /// Displacements and loads at the far end.
    pub(super) fn state(
        &self,
        displacement: &[Complex64; N],
        load: &[Complex64; N],
    ) -> ([Complex64; N], [Complex64; N]) {
        let sum = |[by_displacement, by_load]: &[Square<N>; 2]| {
            let (one, other) = (by_displacement.apply(displacement), by_load.apply(load));
            std::array::from_fn(|i| one[i] + other[i])
        };
        (sum(&self.displacement), sum(&self.load))
    }
}

/// An axle of one diameter, as one of its motions feels it.
pub(super) trait Section<const N: usize>: Copy {
    /// Along a length \[m\] at ω² \[rad²/s²\], the moduli being multiplied by 1 + iη.
    ///
    /// By the power series of the state equations, to rounding where the length is at most three over
    /// [`wavenumber`](Self::wavenumber).
    fn transfer(&self, length: f64, w2: f64, elasticity: Complex64) -> Transfer<N>;

    /// An upper bound of the wavenumbers without loss \[rad/m\].
    fn wavenumber(&self, w2: f64) -> f64;

    /// Mass, or inertia, of each displacement per length.
    fn inertia(&self) -> [f64; N];

    /// Number of equal pieces no longer than a phase \[rad\] into which a length is cut.
    fn pieces(&self, length: f64, w2: f64, phase: f64) -> usize {
        (length * self.wavenumber(w2) / phase).ceil().max(1.0) as usize
    }
}

/// The longest piece of axle that is taken at once, as a phase \[rad\].
///
/// Below π, the least phase at which a piece with held ends has a natural frequency, so that the stiffness of every
/// piece is finite; and short enough for the power series and for waves that decay across it by e³ at most.
pub(super) const LONGEST_PHASE: f64 = 3.0;

/// Terms of a power series at an argument of nine, below the rounding of the first by then.
const MOST_TERMS: usize = 18;

/// |Re z| + |Im z|.
fn size(z: Complex64) -> f64 {
    z.re.abs() + z.im.abs()
}

/// cosh √x and sinh √x/√x by their power series in x, |x| ≤ 9.
#[inline(always)]
pub(super) fn hyperbolic(x: Complex64) -> [Complex64; 2] {
    let (mut power, mut even, mut odd) = (Complex64::ONE, 1.0, 1.0);
    let mut sums = [Complex64::ZERO; 2];
    for n in 0..=MOST_TERMS {
        sums[0] += power * even;
        sums[1] += power * odd;
        if size(power) * even < 1e-18 {
            break;
        }
        power *= x;
        let next = 2.0 * n as f64;
        even /= (next + 1.0) * (next + 2.0);
        odd /= (next + 2.0) * (next + 3.0);
    }
    sums
}

/// The matrix functions cosh √X = Σ Xⁿ/(2n)! and sinh √X/√X = Σ Xⁿ/(2n+1)! as first-degree polynomials of a
/// 2 × 2 matrix X of that trace and determinant: `[[c₀, c₁], [s₀, s₁]]` with cosh √X = c₀ + c₁X.
///
/// Method: by Cayley and Hamilton Xⁿ = pₙX − pₙ₋₁ det X, pₙ₊₁ = pₙ tr X − pₙ₋₁ det X. Free of cancellation where the
/// eigenvalues are small, equal or of opposite sign.
#[inline(always)]
pub(super) fn matrix_hyperbolic(trace: Complex64, determinant: Complex64) -> [[Complex64; 2]; 2] {
    let (mut before, mut power) = (Complex64::ZERO, Complex64::ONE);
    let (mut even, mut odd) = (0.5, 1.0 / 6.0);
    let mut sums = [[Complex64::ZERO; 2]; 2];
    for n in 1..=MOST_TERMS {
        sums[0][0] += before * even;
        sums[0][1] += power * even;
        sums[1][0] += before * odd;
        sums[1][1] += power * odd;
        // Powers may vanish in turn.
        if (size(before) * size(determinant) + size(power)) * even < 1e-18 {
            break;
        }
        (before, power) = (power, power * trace - before * determinant);
        let next = 2.0 * n as f64;
        even /= (next + 1.0) * (next + 2.0);
        odd /= (next + 2.0) * (next + 3.0);
    }
    let [[even_before, even_power], [odd_before, odd_power]] = sums;
    [[1.0 - determinant * even_before, even_power], [1.0 - determinant * odd_before, odd_power]]
}
