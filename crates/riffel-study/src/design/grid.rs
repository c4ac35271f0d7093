//! Every combination.

/// Every combination of the values of lists, the first list slowest: the order of a table in C.
#[derive(Debug, Clone)]
pub struct Grid {
    levels: Vec<u64>,
}

impl Grid {
    /// The combinations of lists with so many values each; their number must not exceed u64.
    pub fn new(levels: Vec<u64>) -> Self {
        Self { levels }
    }

    /// Number of values of each list.
    pub fn levels(&self) -> &[u64] {
        &self.levels
    }

    /// Number of combinations.
    pub fn samples(&self) -> u64 {
        self.levels.iter().product()
    }

    /// The point of a number: the middles of its levels.
    pub fn point(&self, index: u64) -> Vec<f64> {
        let mut rest = index;
        let mut point: Vec<f64> = self
            .levels
            .iter()
            .rev()
            .map(|&levels| {
                let level = rest % levels;
                rest /= levels;
                (level as f64 + 0.5) / levels as f64
            })
            .collect();
        point.reverse();
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_list_runs_fastest() {
        let grid = Grid::new(vec![2, 3]);
        let level = |point: Vec<f64>| [(2.0 * point[0]) as u64, (3.0 * point[1]) as u64];
        let levels: Vec<_> = (0..grid.samples()).map(|index| level(grid.point(index))).collect();
        assert_eq!(levels, [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2]]);
    }

    /// The middle of a level falls into it again, for every length of list.
    #[test]
    fn levels_survive_rounding() {
        for levels in 1..2000u64 {
            let grid = Grid::new(vec![levels]);
            for index in [0, levels / 3, levels / 2, levels - 1] {
                assert_eq!((grid.point(index)[0] * levels as f64) as u64, index);
            }
        }
    }
}
