//! Linear least squares of real numbers, for a few dozen unknowns.
//!
//! Own, because a crate for dense matrices takes longer to build than all of this one. Columns that are not as long as their right
//! sides are an error of the caller, and may panic.

use super::matrix::Matrix;

/// Minimiser x of |A x − b| by Householder reflections (Golub & Van Loan, *Matrix Computations*, 5.2), for the columns of A and b; the
/// columns are used up.
pub fn least_squares(columns: &mut [Vec<f64>], right: &[f64]) -> Vec<f64> {
    least_squares_of_several(columns, vec![right.to_vec()]).swap_remove(0)
}

/// Minimisers x of |A x − b|, one for each b, by Householder reflections (Golub & Van Loan, *Matrix Computations*, 5.2): `columns`
/// are those of A, each as long as the `rights`, b; all are used up. Columns of any size: each is first scaled to length one. A
/// column that depends on those before it to rounding takes no part, its unknown is zero.
///
/// Cost: 2n²m operations for n unknowns and m equations, and 4nm for each b.
pub fn least_squares_of_several(columns: &mut [Vec<f64>], mut rights: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let length = |column: &Vec<f64>| Some(norm(column)).filter(|length| *length > 0.0);
    let scales: Vec<f64> = columns.iter().map(|column| length(column).unwrap_or(1.0)).collect();
    for (column, scale) in columns.iter_mut().zip(&scales) {
        column.iter_mut().for_each(|entry| *entry /= scale);
    }
    let taken = triangularise(columns, &mut rights);
    let solve = |right: &Vec<f64>| {
        let mut solution = vec![0.0; columns.len()];
        for &(index, row) in taken.iter().rev() {
            let after = taken.iter().filter(|(_, later)| *later > row);
            let known: f64 = after.map(|&(other, _)| columns[other][row] * solution[other]).sum();
            solution[index] = (right[row] - known) / columns[index][row];
        }
        for (value, scale) in solution.iter_mut().zip(&scales) {
            *value /= scale;
        }
        solution
    };
    rights.iter().map(solve).collect()
}

/// Rows that the columns after the first `count` leave of each other when those have taken their part: the least |A x − b|
/// over the unknowns of the first columns is that of these rows over the others.
pub fn remainder(columns: &mut [Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let taken = triangularise(columns, &mut []);
    let from = taken.iter().filter(|(index, _)| *index < count).count();
    let others = columns[count..].iter();
    others.map(|column| column[from..taken.len()].to_vec()).collect()
}

/// Upper triangle R of A = QR with a positive diagonal, and Qᵀb: x of Rx = Qᵀb makes |A x − b| least, and (RᵀR)⁻¹ is the covariance of
/// x where the errors of b are independent and of variance one. `None` where a column depends on those before it to rounding,
/// or where entries are not finite.
///
/// Unlike RᵀR = AᵀA by Cholesky's factor it does not square the condition of A.
pub fn triangle(mut columns: Vec<Vec<f64>>, right: Vec<f64>) -> Option<(Matrix, Vec<f64>)> {
    let mut rights = [right];
    let count = columns.len();
    if triangularise(&mut columns, &mut rights).len() < count {
        return None;
    }
    let sign = |row: usize| columns[row][row].signum();
    let upper = Matrix::of(count, |row, column| if row > column { 0.0 } else { sign(row) * columns[column][row] });
    let turned: Vec<f64> = (0..count).map(|row| sign(row) * rights[0][row]).collect();
    upper.values.iter().chain(&turned).all(|value| value.is_finite()).then_some((upper, turned))
}

/// Householder reflections, of the others too, that leave R in the columns, zeros below it; returns the columns that take
/// part with their rows of R.
fn triangularise(columns: &mut [Vec<f64>], others: &mut [Vec<f64>]) -> Vec<(usize, usize)> {
    /// Some hundred roundings of a column.
    const DEPENDENT: f64 = 3e-14;
    let lengths: Vec<f64> = columns.iter().map(|column| norm(column)).collect();
    let mut taken: Vec<(usize, usize)> = Vec::new();
    for index in 0..columns.len() {
        let row = taken.len();
        let (known, later) = columns.split_at_mut(index + 1);
        let pivot = &mut known[index];
        let length = norm(&pivot[row..]);
        if length <= DEPENDENT * lengths[index] {
            pivot[row..].fill(0.0);
            continue;
        }
        // The reflection that leaves the first entry alone.
        let first = -length.copysign(pivot[row]);
        let mut mirror = pivot[row..].to_vec();
        mirror[0] -= first;
        let factor = 2.0 / mirror.iter().map(|entry| entry * entry).sum::<f64>();
        let reflect = |column: &mut [f64]| {
            let share = factor * dot(&mirror, column);
            take_off(column, share, &mirror);
        };
        later.iter_mut().chain(others.iter_mut()).for_each(|column| reflect(&mut column[row..]));
        pivot[row] = first;
        pivot[row + 1..].fill(0.0);
        taken.push((index, row));
    }
    taken
}

fn norm(column: &[f64]) -> f64 {
    dot(column, column).sqrt()
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    // Four sums, so that no addition waits for the one before.
    let (ones, one_rest) = one.as_chunks::<4>();
    let (others, other_rest) = other.as_chunks::<4>();
    let mut sums = [0.0; 4];
    for ([a, b, c, d], [e, f, g, h]) in ones.iter().zip(others) {
        sums[0] += a * e;
        sums[1] += b * f;
        sums[2] += c * g;
        sums[3] += d * h;
    }
    let rest = one_rest.iter().zip(other_rest);
    let rest: f64 = rest.map(|(one, other)| one * other).sum();
    rest + (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// column − share · other, for `other` of the same length.
fn take_off(column: &mut [f64], share: f64, other: &[f64]) {
    let (columns, column_rest) = column.as_chunks_mut::<4>();
    let (others, other_rest) = other.as_chunks::<4>();
    for ([a, b, c, d], [e, f, g, h]) in columns.iter_mut().zip(others) {
        *a -= share * e;
        *b -= share * f;
        *c -= share * g;
        *d -= share * h;
    }
    for (entry, other) in column_rest.iter_mut().zip(other_rest) {
        *entry -= share * other;
    }
}
