//! Mean and scatter of places.

use riffel_numerics::matrix::Matrix;

/// Mean and scatter of places, by Welford.
#[derive(Debug, Clone)]
pub(crate) struct Moments {
    pub(crate) count: f64,
    pub(crate) mean: Vec<f64>,
    /// Sum of the products of the distances from the mean.
    pub(crate) scatter: Matrix,
}

impl Moments {
    pub(crate) fn new(size: usize) -> Self {
        Self { count: 0.0, mean: vec![0.0; size], scatter: Matrix::of(size, |_, _| 0.0) }
    }

    pub(crate) fn add(&mut self, place: &[f64]) {
        self.count += 1.0;
        let before: Vec<f64> = place.iter().zip(&self.mean).map(|(z, mean)| z - mean).collect();
        for (mean, before) in self.mean.iter_mut().zip(&before) {
            *mean += before / self.count;
        }
        let after = place.iter().zip(&self.mean).map(|(z, mean)| z - mean);
        let after: Vec<f64> = after.collect();
        let rows = self.scatter.values.chunks_exact_mut(place.len());
        for (row, before) in rows.zip(before) {
            for (entry, after) in row.iter_mut().zip(&after) {
                *entry += before * after;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use riffel_numerics::matrix::dot;

    use super::*;

    /// Mean and scatter are those of the sums.
    #[test]
    fn moments_are_those_of_the_sums() {
        let draws = [[1.0, 2.0], [3.0, -1.0], [0.5, 0.0], [-2.0, 4.0]];
        let mut moments = Moments::new(2);
        draws.iter().for_each(|draw| moments.add(draw));
        let column = |index: usize| draws.map(|draw| draw[index] - moments.mean[index]);
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            assert!((moments.scatter.at(i, j) - dot(&column(i), &column(j))).abs() < 1e-12);
        }
    }
}
