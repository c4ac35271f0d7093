//! What every answer is: a document, tables, a figure and what is said of them.

use std::borrow::Cow;
use std::path::Path;

use riffel::GrowthMap;
use riffel_case::Case;
use riffel_keys::Message;
use riffel_plot::{BarFigure, LineFigure, MapFigure, StripFigure};
use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::Table;
use crate::netcdf::Grid;

/// A file beside the document of an answer.
pub enum ResultFile<'a> {
    /// A picture of lines, as PNG, SVG and page.
    Lines(&'static str, LineFigure),
    /// A picture of lines without a page.
    Picture(&'static str, LineFigure),
    /// A picture of maps, likewise.
    Maps(&'static str, MapFigure),
    /// A growth map as CSV, written row by row.
    Map(&'static str, &'a GrowthMap),
    /// A picture of strips, as PNG and SVG.
    Strips(&'static str, StripFigure),
    /// A picture of bars, as PNG and SVG.
    Bars(&'static str, BarFigure),
    /// A table as CSV.
    Table(Table),
    /// A table as CSV under a name of its own.
    TableAs(String, Table),
    /// Pictures of lines by their names, as one page with a slider.
    Stages(&'static str, Vec<(String, LineFigure)>),
    /// A grid as NetCDF-3.
    Grid(&'static str, Grid<'a>),
}

impl ResultFile<'_> {
    /// Result files of tables that are not for readers alone.
    pub(crate) fn tables(tables: Vec<Table>) -> impl Iterator<Item = Self> {
        tables.into_iter().filter(Table::has_file).map(Self::Table)
    }
}

/// A text of an answer that is no file of its folder.
pub struct OwnText<'a> {
    /// Its file; standard output without any.
    pub path: Option<&'a Path>,
    /// What it says.
    pub text: Cow<'a, str>,
    /// What becomes of a file that is there.
    pub existing: Existing,
    /// What is said when it is written; `None` if it goes before the files of a folder.
    pub written: Option<Message>,
}

impl OwnText<'_> {
    /// Whether it is the whole answer.
    pub fn is_all(&self) -> bool {
        self.path.is_none() || self.written.is_some()
    }
}

/// What becomes of a file that is there where another is to be written.
pub enum Existing {
    /// It is kept.
    Kept,
    /// It is replaced.
    Replaced,
    /// It is replaced if it says the same, or has this mark near its beginning.
    ReplacedIfKnown(Option<&'static str>),
}

/// What serialises to a document.
pub trait Document {
    /// The document, indented.
    fn document(&self) -> String;

    /// The document as data; numbers that are not finite are null, as in its text.
    fn value(&self) -> Value;
}

impl<T: Serialize> Document for T {
    fn document(&self) -> String {
        // Only a map with keys that are not strings, or a failing `Serialize`, could be refused.
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    fn value(&self) -> Value {
        serde_json::to_value(self).unwrap_or_default()
    }
}

/// What a reader sees of an answer.
pub enum Printed {
    /// A line.
    Line(Message),
    /// A table.
    Table(Table),
    /// A table of texts, wrapped.
    Texts(Table),
}

/// An answer as data; its document is what `--json` prints.
pub trait Answer: Document {
    /// Its name in files, as in `noise.png`.
    fn name(&self) -> &'static str;

    /// What its folder is named after, where that is not the question.
    fn folder_name(&self) -> Option<&'static str> {
        None
    }

    /// The file of its document.
    fn document_name(&self) -> &'static str {
        "summary.json"
    }

    /// What it is about, in lines before the tables.
    fn introduction(&self) -> Vec<Message> {
        Vec::new()
    }

    /// Tables, for files and readers.
    fn tables(&self) -> Vec<Table> {
        Vec::new()
    }

    /// What a reader sees above a table of a name, a line each.
    fn above(&self, _table: &str) -> Vec<Message> {
        Vec::new()
    }

    /// What a reader sees below a table of a name, a line each.
    fn below(&self, _table: &str) -> Vec<Message> {
        Vec::new()
    }

    /// What the tables do not say, a line each.
    fn sentences(&self) -> Vec<Message> {
        Vec::new()
    }

    /// What a reader sees, in its order.
    fn printed(&self) -> Vec<Printed> {
        let lines = |lines: Vec<Message>| lines.into_iter().map(Printed::Line);
        let shown = self.tables().into_iter().filter(Table::is_shown);
        let tables = shown.flat_map(|table| {
            let [above, below] = [self.above(table.name), self.below(table.name)].map(lines);
            above.chain([Printed::Table(table)]).chain(below)
        });
        lines(self.introduction()).chain(tables).chain(lines(self.sentences())).collect()
    }

    /// The picture; without panels where there is none.
    fn figure(&self) -> LineFigure {
        LineFigure::default()
    }

    /// Whether there is anything to write.
    fn has_files(&self) -> bool {
        true
    }

    /// What makes it none to go by: the program complains of it, and ends with the status 1.
    fn doubts(&self) -> Vec<Message> {
        Vec::new()
    }

    /// The files beside the document, in the order in which they are named.
    fn files(&self) -> Vec<ResultFile<'_>> {
        let figure = ResultFile::Lines(self.name(), self.figure());
        [figure].into_iter().chain(ResultFile::tables(self.tables())).collect()
    }

    /// A text that goes to a file that the question names, or to standard output.
    fn own_text(&self) -> Option<OwnText<'_>> {
        None
    }

    /// What the reader should know.
    fn remarks(&self) -> &[Message] {
        &[]
    }
}

/// The title that somebody gave, or the usual one.
pub(crate) fn titled(title: Option<&String>, usual: Message) -> Message {
    title.map_or(usual, Message::verbatim)
}

/// The file of a case, as documents repeat it.
pub(crate) fn inputs<S: Serializer>(case: &Case, serializer: S) -> Result<S::Ok, S::Error> {
    case.file.serialize(serializer)
}
