//! What a pattern that changes slowly is at one turn, by the turns about it.

/// Most turns to either side. A parabola through them errs by 3/35 · n⁴/24 of the fourth difference from turn to turn in the middle: of a
/// phase that swings by 1 rad within 100 turns, 0.001 of the pattern.
pub(super) const MOST_TURNS: usize = 12;

/// A height that the heights of other turns let expect, as a sum of their sums times powers of their number.
#[derive(Clone, Copy)]
pub(super) struct Expected {
    pub(super) weights: [f64; 3],
    /// Of the sum beside that of a height.
    pub(super) variance: f64,
}

impl Expected {
    /// By so many turns before and behind: h = a + b j + c j², by least squares; the mean of fewer than six, of which a parabola tells
    /// nothing.
    pub(super) fn of([before, behind]: [usize; 2]) -> Self {
        let mut sums = [0.0; 5];
        let turns = (-(before as isize)..=behind as isize).filter(|turn| *turn != 0);
        for turn in turns {
            for (power, sum) in (0..).zip(&mut sums) {
                *sum += (turn as f64).powi(power);
            }
        }
        let [n, s1, s2, s3, s4] = sums;
        if n < 6.0 {
            let weight = 1.0 / n.max(1.0);
            return Self { weights: [weight, 0.0, 0.0], variance: weight };
        }
        // The first row of the inverse of [[n, s1, s2], [s1, s2, s3], [s2, s3, s4]], times its determinant.
        let row = [s2 * s4 - s3 * s3, s2 * s3 - s1 * s4, s1 * s3 - s2 * s2];
        let determinant = n * row[0] + s1 * row[1] + s2 * row[2];
        let weights = row.map(|cofactor| cofactor / determinant);
        // Squares of what turns weigh add up to the first of the row.
        Self { weights, variance: weights[0] }
    }
}
