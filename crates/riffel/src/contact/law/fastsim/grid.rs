//! The march along the strips in coordinates that no load changes.
//!
//! X = x/a and Y = y/b. A strip at Y reaches to X = ±h, h = √(1 − Y²), and its bound of traction is
//! h² (1 − t²) or h √(1 − t²) with t = X/h. Tractions of a strip are therefore kept over h² or h: the
//! bound is then the same for all strips.

use super::TractionBound;

/// Strips marched side by side: so many that one waits for the square root of its next cell no longer than the others take.
const LANES: usize = 10;

/// Growth of traction per half-length a, over the bound at the centre of the ellipse \[-\].
#[derive(Debug, Clone, Copy)]
pub(super) struct Loading {
    pub(super) longitudinal: f64,
    pub(super) lateral: f64,
    /// Times Y.
    pub(super) longitudinal_by_y: f64,
    /// Times X.
    pub(super) lateral_by_x: f64,
}

/// One cell of a strip.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cell {
    /// Bound at the middle of the cell.
    bound: f64,
    /// Length of the step from the middle of the cell before, in cells.
    step: f64,
    /// Middle t of that step.
    at: f64,
}

/// One strip; a strip that only fills the lanes has no weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strip {
    /// Y.
    pub(super) y: f64,
    /// Half-length h.
    pub(super) half_length: f64,
    /// Bound at the middle of the strip, h² or h.
    pub(super) height: f64,
    /// Length of a cell over `height`.
    reach: f64,
    /// Area of a cell times `height`.
    weight: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grid {
    divisions: usize,
    cells: Vec<Cell>,
    /// Filled up to a multiple of the lanes.
    strips: Vec<Strip>,
    bound_integral: f64,
}

/// Growth of traction over one cell of a strip.
#[derive(Debug, Clone, Copy, Default)]
struct Growth {
    x: f64,
    y: f64,
    /// Times t.
    y_by_t: f64,
}

impl Strip {
    fn growth(&self, loading: Loading) -> Growth {
        Growth {
            x: self.reach * (loading.longitudinal + self.y * loading.longitudinal_by_y),
            y: self.reach * loading.lateral,
            y_by_t: self.reach * self.half_length * loading.lateral_by_x,
        }
    }
}

impl Grid {
    pub(super) fn new(bound: TractionBound, divisions: usize) -> Self {
        let n = divisions as f64;
        let cells: Vec<Cell> = (0..divisions)
            .map(|i| {
                let i = i as f64;
                let t = 1.0 - (2.0 * i + 1.0) / n;
                let parabola = 1.0 - t * t;
                Cell {
                    bound: match bound {
                        TractionBound::Parabolic => parabola,
                        TractionBound::Elliptic => parabola.sqrt(),
                    },
                    // From the leading edge to the first middle it is half a cell.
                    step: if i == 0.0 { 0.5 } else { 1.0 },
                    at: if i == 0.0 { 1.0 - 0.5 / n } else { 1.0 - 2.0 * i / n },
                }
            })
            .collect();
        let strips: Vec<Strip> = (0..divisions.next_multiple_of(LANES))
            .map(|j| {
                if j >= divisions {
                    return Strip { y: 0.0, half_length: 1.0, height: 1.0, reach: 0.0, weight: 0.0 };
                }
                let y = (2.0 * j as f64 + 1.0) / n - 1.0;
                let half_length = (1.0 - y * y).sqrt();
                let height = match bound {
                    TractionBound::Parabolic => half_length * half_length,
                    TractionBound::Elliptic => half_length,
                };
                Strip {
                    y,
                    half_length,
                    height,
                    reach: 2.0 * half_length / (n * height),
                    weight: 4.0 * half_length * height / (n * n),
                }
            })
            .collect();
        let along: f64 = cells.iter().map(|cell| cell.bound).sum();
        let across: f64 = strips.iter().map(|strip| strip.weight).sum();
        Self { divisions, cells, strips, bound_integral: along * across }
    }

    /// Integral of the bound over the ellipse, the bound at the centre and the semi-axes being one.
    pub(super) fn bound_integral(&self) -> f64 {
        self.bound_integral
    }

    /// The strips proper.
    pub(super) fn strips(&self) -> &[Strip] {
        &self.strips[..self.divisions]
    }

    /// Forces over the force of full slip \[-\].
    pub(super) fn forces(&self, loading: Loading) -> [f64; 2] {
        let mut total = [0.0; 2];
        for strips in self.strips.chunks_exact(LANES) {
            let growth: [Growth; LANES] = std::array::from_fn(|lane| strips[lane].growth(loading));
            let grow_x = growth.map(|growth| growth.x);
            let grow_y = growth.map(|growth| growth.y);
            let grow_y_by_t = growth.map(|growth| growth.y_by_t);
            let [mut x, mut y] = [[0.0; LANES]; 2];
            let [mut sum_x, mut sum_y] = [[0.0; LANES]; 2];
            for cell in &self.cells {
                for lane in 0..LANES {
                    let trial_x = x[lane] + cell.step * grow_x[lane];
                    let trial_y = y[lane] + cell.step * (grow_y[lane] + cell.at * grow_y_by_t[lane]);
                    let magnitude = (trial_x * trial_x + trial_y * trial_y).sqrt();
                    // The larger of the two makes the factor one in stick, without a branch.
                    let shorten = cell.bound / if magnitude > cell.bound { magnitude } else { cell.bound };
                    x[lane] = shorten * trial_x;
                    y[lane] = shorten * trial_y;
                    sum_x[lane] += x[lane];
                    sum_y[lane] += y[lane];
                }
            }
            for (lane, strip) in strips.iter().enumerate() {
                total[0] += strip.weight * sum_x[lane];
                total[1] += strip.weight * sum_y[lane];
            }
        }
        total.map(|force| force / self.bound_integral)
    }

    /// Tractions of a strip over its bound at the middle, from the leading edge on, with `true` in
    /// stick.
    pub(super) fn march(&self, strip: &Strip, loading: Loading) -> impl Iterator<Item = ([f64; 2], bool)> {
        let growth = strip.growth(loading);
        self.cells.iter().scan([0.0; 2], move |traction, cell| {
            traction[0] += cell.step * growth.x;
            traction[1] += cell.step * (growth.y + cell.at * growth.y_by_t);
            let magnitude = traction[0].hypot(traction[1]);
            let sticks = magnitude <= cell.bound;
            if !sticks {
                *traction = traction.map(|component| cell.bound / magnitude * component);
            }
            Some((*traction, sticks))
        })
    }

    /// Longitudinal loading from which on every cell slips: it carries the first cell of the longest
    /// strip to the bound. Every later step of the bound is less than twice as high, and so within
    /// reach.
    pub(super) fn full_slip(&self) -> f64 {
        let first = self.cells.first().map_or(0.0, |cell| cell.bound / cell.step);
        let shortest_reach = self.strips().iter().map(|strip| strip.reach).fold(f64::MAX, f64::min);
        first / shortest_reach
    }
}
