//! What every answer is: a document, tables, a figure and what is said of them.

use riffel_keys::Message;
use riffel_plot::LineFigure;
use serde::Serialize;

use crate::Table;

/// An answer as data; its document is what `--json` prints.
pub trait Answer: Serialize {
    /// Its name in files, as in `noise.png`.
    const NAME: &'static str;

    /// What it is about, in lines before the tables.
    fn introduction(&self) -> Vec<Message>;

    /// Tables, for files and readers.
    fn tables(&self) -> Vec<Table>;

    /// What the tables do not say, a line each.
    fn sentences(&self) -> Vec<Message>;

    /// The picture.
    fn figure(&self) -> LineFigure;

    /// What the reader should know.
    fn remarks(&self) -> &[Message];
}
