//! Tables of a function: polynomials of degree 7 through Chebyshev's nodes, in cells.

use std::array;
use std::f64::consts::PI;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul};

/// Coefficients of the polynomial of a cell.
pub const NODES: usize = 8;

/// Power coefficients in t, lowest first, of the polynomial that meets a function at Chebyshev's nodes in [−1, 1].
fn through_nodes<V>(f: impl Fn(f64) -> V) -> [V; NODES]
where
    V: Copy + Default + Sum + AddAssign + Mul<f64, Output = V>,
{
    let angle = |j: usize| PI * (j as f64 + 0.5) / NODES as f64;
    let values: [V; NODES] = array::from_fn(|j| f(angle(j).cos()));
    // Sum of c_k T_k(t), the T_k by T_{k+1} = 2t T_k − T_{k−1}.
    let mut powers = [V::default(); NODES];
    let (mut before, mut current) = ([0.0; NODES], [0.0; NODES]);
    current[0] = 1.0;
    for k in 0..NODES {
        let scale = if k == 0 { 1.0 } else { 2.0 } / NODES as f64;
        let coefficient: V =
            values.iter().enumerate().map(|(j, &value)| value * (scale * (k as f64 * angle(j)).cos())).sum();
        for (power, factor) in powers.iter_mut().zip(current) {
            *power += coefficient * factor;
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let next = array::from_fn(|j| {
            let raised = if j == 0 { 0.0 } else { factor * current[j - 1] };
            raised - before[j]
        });
        (before, current) = (current, next);
    }
    powers
}

/// The polynomial of some power coefficients, the lowest first, at t.
fn polynomial_at<V>(polynomial: &[V; NODES], t: f64) -> V
where
    V: Copy + Default + Add<Output = V> + Mul<f64, Output = V>,
{
    let powers = polynomial.iter().rev();
    powers.fold(V::default(), |sum, &power| sum * t + power)
}

/// Part of a range with the polynomial that a function has there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell<V> {
    /// Where it begins.
    pub begin: f64,
    /// Where it ends.
    pub end: f64,
    /// Half way between them.
    pub middle: f64,
    /// One over half its width.
    pub per_half: f64,
    /// In t ∈ \[−1, 1\], lowest power first.
    pub polynomial: [V; NODES],
    /// Whether it is the function between its nodes, too.
    pub holds: bool,
}

/// How a range is cut into cells.
pub struct Cut {
    /// Equal cells to begin with.
    pub first_cells: usize,
    /// How often a cell may be halved.
    pub most_halvings: u32,
    /// Places t between the nodes of a cell at which its polynomial must hold.
    pub checks: [f64; 5],
}

impl<V> Cell<V>
where
    V: Copy + Default + Sum + Add<Output = V> + AddAssign + Mul<f64, Output = V>,
{
    /// Cells over a range, in order and without gaps, which are halved until `holds` says so of the value of the function and that
    /// of the polynomial at each check, or as often as they may be.
    pub fn table(f: impl Fn(f64) -> V, [from, to]: [f64; 2], cut: &Cut, holds: impl Fn(V, V) -> bool) -> Vec<Self> {
        let end = |cell: usize| from + (to - from) * cell as f64 / cut.first_cells as f64;
        let mut cells = Vec::new();
        for cell in 0..cut.first_cells {
            Self::divide(&f, [end(cell), end(cell + 1)], (cut.most_halvings, &cut.checks), &holds, &mut cells);
        }
        cells
    }

    fn divide(
        f: &impl Fn(f64) -> V,
        [begin, end]: [f64; 2],
        (halvings, checks): (u32, &[f64; 5]),
        holds: &impl Fn(V, V) -> bool,
        cells: &mut Vec<Self>,
    ) {
        let (middle, half) = (0.5 * (begin + end), 0.5 * (end - begin));
        let at = |t: f64| f(middle + half * t);
        let polynomial = through_nodes(at);
        let holds_here = checks.iter().all(|&t| holds(at(t), polynomial_at(&polynomial, t)));
        if holds_here || halvings == 0 {
            cells.push(Self { begin, end, middle, per_half: 1.0 / half, polynomial, holds: holds_here });
            return;
        }
        for ends in [[begin, middle], [middle, end]] {
            Self::divide(f, ends, (halvings - 1, checks), holds, cells);
        }
    }

    /// Value of the polynomial.
    #[inline]
    pub fn at(&self, place: f64) -> V {
        polynomial_at(&self.polynomial, (place - self.middle) * self.per_half)
    }
}
