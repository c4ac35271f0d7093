//! The grid of a map: two axes of points and one number per node.

use crate::error::PlotError;

/// Values on the nodes of a rectangular grid, row-major `[y][x]`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    pub(crate) values: Vec<f64>,
}

impl Grid {
    /// The value at column `i` and row `j`.
    pub(crate) fn value(&self, i: usize, j: usize) -> f64 {
        self.values[j * self.x.len() + i]
    }

    /// Map with at most `limit` points along each axis, first and last point kept.
    pub(crate) fn thinned(&self, limit: usize) -> Grid {
        let columns = thinned_indices(self.x.len(), limit);
        let rows = thinned_indices(self.y.len(), limit);
        Grid {
            x: columns.iter().map(|&i| self.x[i]).collect(),
            y: rows.iter().map(|&j| self.y[j]).collect(),
            values: rows.iter().flat_map(|&j| columns.iter().map(move |&i| self.value(i, j))).collect(),
        }
    }

    /// Smallest finite value, if it is negative: the strongest growth of the map.
    pub(crate) fn strongest_growth(&self) -> Option<f64> {
        let least = self.values.iter().copied().filter(|value| value.is_finite()).fold(f64::INFINITY, f64::min);
        (least < 0.0).then_some(least)
    }
}

/// At most `limit` indices spread evenly over `0..count`, the first and the last among them.
pub(crate) fn thinned_indices(count: usize, limit: usize) -> Vec<usize> {
    let limit = limit.max(2);
    if count <= limit {
        return (0..count).collect();
    }
    (0..limit).map(|k| (k * (count - 1) + (limit - 1) / 2) / (limit - 1)).collect()
}

/// Checks that an axis can carry a map.
pub(crate) fn check_axis(panel: usize, axis: &'static str, points: &[f64]) -> Result<(), PlotError> {
    if points.len() < 2 {
        return Err(PlotError::TooFewGridPoints { panel, axis, found: points.len() });
    }
    let mut previous = 0.0;
    for (index, &value) in points.iter().enumerate() {
        if !value.is_finite() || value <= previous {
            return Err(PlotError::GridOrder { panel, axis, index, value });
        }
        previous = value;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_the_ends() {
        let indices = thinned_indices(1001, 50);
        assert_eq!((indices.len(), indices[0], indices[49]), (50, 0, 1000));
        assert!(indices.windows(2).all(|pair| pair[1] > pair[0]));
        assert_eq!(thinned_indices(3, 50), [0, 1, 2]);
        assert!(thinned_indices(0, 50).is_empty());
    }

    #[test]
    fn thinned_values_stay_at_their_points() {
        let x: Vec<f64> = (1..=900).map(f64::from).collect();
        let y: Vec<f64> = (1..=700).map(f64::from).collect();
        let values = y.iter().flat_map(|v| x.iter().map(move |u| u * 1000.0 + v)).collect();
        let thin = Grid { x, y, values }.thinned(100);
        assert_eq!((thin.x.len(), thin.y.len()), (100, 100));
        for j in 0..100 {
            for i in 0..100 {
                assert_eq!(thin.value(i, j), thin.x[i] * 1000.0 + thin.y[j]);
            }
        }
    }
}
