//! Small dense square matrices, by rows: Cholesky's factor, triangles, Jacobi's eigenvectors.
//!
//! Own, because a crate for dense matrices takes longer to build than all of this one. Source of the methods: Golub & Van Loan
//! (2013), *Matrix Computations*, 3.1, 4.2 and 8.5. Dimensions that do not match cut off what is longer.

/// A square matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    /// Number of rows.
    pub size: usize,
    /// Entries, row after row.
    pub values: Vec<f64>,
}

impl Matrix {
    /// Matrix of a value for each row and column.
    pub fn of(size: usize, value: impl Fn(usize, usize) -> f64) -> Self {
        let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
        let values = places.map(|(row, column)| value(row, column)).collect();
        Self { size, values }
    }

    /// Ones on the diagonal.
    pub fn identity(size: usize) -> Self {
        Self::of(size, |row, column| f64::from(u8::from(row == column)))
    }

    /// Covariance of sums of what this is the covariance of: places with their weights.
    pub fn of_sums(&self, sums: &[Vec<(usize, f64)>]) -> Self {
        Self::of(sums.len(), |i, j| {
            let pairs = (sums[i].iter()).flat_map(|one| sums[j].iter().map(move |other| (one, other)));
            pairs.map(|((row, a), (column, b))| a * b * self.at(*row, *column)).sum()
        })
    }

    /// Entry in a row and a column.
    #[inline]
    pub fn at(&self, row: usize, column: usize) -> f64 {
        self.values[row * self.size + column]
    }

    /// Entries of a row.
    #[inline]
    pub fn row(&self, row: usize) -> &[f64] {
        &self.values[row * self.size..(row + 1) * self.size]
    }

    /// Product with a vector.
    pub fn times(&self, vector: &[f64]) -> Vec<f64> {
        (0..self.size).map(|row| dot(self.row(row), vector)).collect()
    }

    /// Rows for columns.
    pub fn transposed(&self) -> Self {
        Self::of(self.size, |row, column| self.at(column, row))
    }

    /// Product with another matrix of the size.
    pub fn product(&self, other: &Self) -> Self {
        let other = other.transposed();
        Self::of(self.size, |row, column| dot(self.row(row), other.row(column)))
    }

    /// Lower triangle L of a symmetric positive definite LLᵀ, of which the part above the diagonal is not read; `None` for any
    /// other, also where rounding makes it so. Cost: n³/3 operations.
    pub fn cholesky(&self) -> Option<Self> {
        let mut lower = Self::of(self.size, |_, _| 0.0);
        for row in 0..self.size {
            for column in 0..=row {
                let (before, own) = (&lower.row(row)[..column], &lower.row(column)[..column]);
                let rest = self.at(row, column) - dot(before, own);
                let value = match row == column {
                    true if rest > 0.0 => rest.sqrt(),
                    true => return None,
                    false => rest / lower.at(column, column),
                };
                lower.values[row * self.size + column] = value;
            }
        }
        Some(lower)
    }

    /// x of Lx = b for this lower triangle; what is above the diagonal is not read.
    pub fn forward(&self, mut vector: Vec<f64>) -> Vec<f64> {
        for row in 0..self.size {
            let before = dot(&self.row(row)[..row], &vector[..row]);
            vector[row] = (vector[row] - before) / self.at(row, row);
        }
        vector
    }

    /// x of Ux = b for this upper triangle; what is below the diagonal is not read.
    pub fn backward(&self, vector: &[f64]) -> Vec<f64> {
        let mut solved = vector.to_vec();
        for row in (0..self.size).rev() {
            let behind = dot(&self.row(row)[row + 1..], &solved[row + 1..]);
            solved[row] = (solved[row] - behind) / self.at(row, row);
        }
        solved
    }

    /// L⁻¹ of this lower triangle.
    pub fn inverse_of_triangle(&self) -> Self {
        let columns = (0..self.size).map(|column| {
            let mut unit = vec![0.0; self.size];
            unit[column] = 1.0;
            self.forward(unit)
        });
        let values = columns.flatten().collect();
        let size = self.size;
        Self { size, values }.transposed()
    }

    /// (LLᵀ)⁻¹ of this lower triangle.
    pub fn inverse_of_square(&self) -> Self {
        let inverse = self.inverse_of_triangle();
        inverse.transposed().product(&inverse)
    }

    /// Eigenvalues of a symmetric matrix, in no order, and its eigenvectors of length one by rows.
    ///
    /// Method: Jacobi's rotations (1846), until what is off the diagonal is 10⁻¹⁵ of all; converges quadratically, in some six sweeps
    /// of 6n³ operations.
    pub fn eigenvectors(&self) -> (Vec<f64>, Self) {
        const MOST_SWEEPS: usize = 50;
        let size = self.size;
        let mut own = self.clone();
        let mut vectors = Self::identity(size);
        for _ in 0..MOST_SWEEPS {
            let off = |row: usize| (0..row).map(move |column| (row, column));
            let off: f64 = (0..size).flat_map(off).map(|(r, c)| own.at(r, c).powi(2)).sum();
            let all: f64 = own.values.iter().map(|value| value * value).sum();
            if off <= 1e-30 * all {
                break;
            }
            for row in 1..size {
                for column in 0..row {
                    own.rotate(row, column, &mut vectors);
                }
            }
        }
        let values = (0..size).map(|index| own.at(index, index)).collect();
        (values, vectors)
    }

    /// Make the entry of two axes zero.
    fn rotate(&mut self, p: usize, q: usize, vectors: &mut Self) {
        let entry = self.at(p, q);
        if entry == 0.0 {
            return;
        }
        let theta = 0.5 * (self.at(q, q) - self.at(p, p)) / entry;
        let tangent = theta.signum() / (theta.abs() + (1.0 + theta * theta).sqrt());
        let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sine = tangent * cosine;
        let size = self.size;
        let turn = |values: &mut Vec<f64>, one: usize, other: usize| {
            let (a, b) = (values[one], values[other]);
            values[one] = cosine * a - sine * b;
            values[other] = sine * a + cosine * b;
        };
        for k in 0..size {
            turn(&mut self.values, k * size + p, k * size + q);
        }
        for k in 0..size {
            turn(&mut self.values, p * size + k, q * size + k);
            turn(&mut vectors.values, p * size + k, q * size + k);
        }
    }
}

/// Sum of the products of the entries.
#[inline]
pub fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
