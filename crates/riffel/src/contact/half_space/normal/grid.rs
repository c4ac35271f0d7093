//! The rectangles into which the surfaces are cut.

use crate::Error;

/// A grid of equal rectangles around the origin of the contact plane, x along and y across the rail.
///
/// Fields on it are slices with one value per element, row after row: the element of column i and
/// row j, counted from the ends at negative x and y, has the index j · columns + i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactGrid {
    columns: usize,
    rows: usize,
    dx: f64,
    dy: f64,
}

impl ContactGrid {
    /// Fewest elements in a direction: with a free rim on each side there are six left for the patch.
    const FEWEST: usize = 8;
    /// Most elements in a direction: a field of them takes 32 MB, its transform 256 MB.
    const MOST: usize = 2048;

    /// A grid of `columns` elements along the rail and `rows` across it, each `dx` long and `dy` wide
    /// \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the numbers lie between 8 and 2048 and the sizes are positive.
    pub fn new(columns: usize, rows: usize, dx: f64, dy: f64) -> Result<Self, Error> {
        for (quantity, count) in
            [("number of elements along the rail", columns), ("number of elements across the rail", rows)]
        {
            if !(Self::FEWEST..=Self::MOST).contains(&count) {
                return Err(Error::OutOfRange {
                    quantity,
                    value: count as f64,
                    unit: "",
                    rule: "must lie between 8 and 2048",
                });
            }
        }
        Error::unless_positive("length of an element", dx, "m")?;
        Error::unless_positive("width of an element", dy, "m")?;
        Ok(Self { columns, rows, dx, dy })
    }

    /// A grid of `columns` × `rows` elements over a rectangle \[m\] from −x to x and −y to y.
    ///
    /// # Errors
    /// Errors of those of [`new`](Self::new).
    pub fn over(columns: usize, rows: usize, x: f64, y: f64) -> Result<Self, Error> {
        Self::new(columns, rows, 2.0 * x / columns as f64, 2.0 * y / rows as f64)
    }

    /// Number of elements along the rail.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of elements across the rail.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Length of an element along the rail \[m\].
    pub fn dx(&self) -> f64 {
        self.dx
    }

    /// Width of an element across the rail \[m\].
    pub fn dy(&self) -> f64 {
        self.dy
    }

    /// Area of an element \[m²\].
    pub fn element_area(&self) -> f64 {
        self.dx * self.dy
    }

    /// Centres (x, y) of all elements \[m\], in the order of the fields.
    pub fn centres(&self) -> impl Iterator<Item = (f64, f64)> {
        let Self { columns, rows, dx, dy } = *self;
        let centre = |index: usize, count: usize, step: f64| (index as f64 - 0.5 * (count as f64 - 1.0)) * step;
        (0..rows)
            .flat_map(move |row| (0..columns).map(move |column| (centre(column, columns, dx), centre(row, rows, dy))))
    }

    /// Whether the element of an index lies on the rim.
    pub(super) fn is_on_rim(&self, index: usize) -> bool {
        let (row, column) = (index / self.columns, index % self.columns);
        row == 0 || row + 1 == self.rows || column == 0 || column + 1 == self.columns
    }
}
