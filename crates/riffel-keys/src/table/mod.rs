//! Tables of text from anywhere: how they are laid out, and their rows.
//!
//! Cells are divided by commas, semicolons, tabulators or blanks, numbers have a decimal point or a decimal comma, also in
//! quotes; lines that begin with # or % are remarks. Two ways lead to a table: [`Table`] finds it by its numbers, whatever
//! stands above them, and [`HeadedTable`] by the names that are asked for.

mod delimiter;
mod head;
mod heading;
mod length;
mod line;
mod missing;
mod number;
mod number_columns;
mod row;
mod shape;

pub use delimiter::{DecimalMark, Delimiter};
pub use head::{HeadedTable, NoHead};
pub use heading::{Heading, it_has, label};
pub use length::{foreign_unit, is_one_of, length_in, length_word, words};
pub use line::{cells, is_comment, lines};
pub use missing::{Marked, is_mark, marks};
pub use number::clock;
pub use number_columns::{NumberColumns, NumberRows, RowError};
pub use row::{Row, number_in, rows};
pub use shape::{Kind, Table};
