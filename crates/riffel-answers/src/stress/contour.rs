//! Lines of equal value through a grid.

/// Pieces of the line where values over a grid have a level, parted by what is no number. `values` run along x first.
pub(crate) fn contour(x: &[f64], y: &[f64], values: &[f64], level: f64) -> (Vec<f64>, Vec<f64>) {
    let mut line = (Vec::new(), Vec::new());
    let mut put = |place: [f64; 2]| {
        line.0.push(place[0]);
        line.1.push(place[1]);
    };
    let at = |i: usize, j: usize| ([x[i], y[j]], values[j * x.len() + i] - level);
    for j in 1..y.len() {
        for i in 1..x.len() {
            // Two triangles a cell, each crossed by no line or by one.
            let [a, b, c, d] = [at(i - 1, j - 1), at(i, j - 1), at(i, j), at(i - 1, j)];
            for corners in [[a, b, c], [a, c, d]] {
                let crossings = (0..3).filter_map(|side| {
                    let (from, to) = (corners[side], corners[(side + 1) % 3]);
                    let crosses = (from.1 < 0.0) != (to.1 < 0.0);
                    crosses.then(|| {
                        let share = from.1 / (from.1 - to.1);
                        [0, 1].map(|axis| from.0[axis] + share * (to.0[axis] - from.0[axis]))
                    })
                });
                let crossings: Vec<[f64; 2]> = crossings.collect();
                if let [one, other] = crossings[..] {
                    put(one);
                    put(other);
                    put([f64::NAN; 2]);
                }
            }
        }
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contour of a distance is a circle, all of it.
    #[test]
    fn of_a_distance() {
        let axis: Vec<f64> = (0..=40).map(|step| -1.0 + 0.05 * f64::from(step)).collect();
        let values: Vec<f64> = axis.iter().flat_map(|y| axis.iter().map(move |x: &f64| x.hypot(*y))).collect();
        let (x, y) = contour(&axis, &axis, &values, 0.7);
        let mut length = 0.0;
        for piece in x.chunks(3).zip(y.chunks(3)) {
            length += (piece.0[1] - piece.0[0]).hypot(piece.1[1] - piece.1[0]);
            assert!((piece.0[0].hypot(piece.1[0]) - 0.7).abs() < 1e-3);
        }
        assert!((length / (2.0 * std::f64::consts::PI * 0.7) - 1.0).abs() < 1e-2);
    }
}
