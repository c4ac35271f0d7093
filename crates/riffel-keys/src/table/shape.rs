//! How a table of numbers is laid out, found from its first lines.

use super::delimiter::{DecimalMark, Delimiter};
use super::heading::Heading;
use super::line::{cells, end_at, is_comment, is_remark, lines};
use super::number::{complex, is_chainage, number, oddity};
use crate::text_file::text_of;

/// Bytes that are looked at.
const SAMPLE: usize = 1 << 16;

/// Ways to write a table, the likelier first where two fit alike. With decimal commas between commas, numbers stand in
/// quotes.
const WAYS: [(Delimiter, DecimalMark); 8] = [
    (Delimiter::Semicolon, DecimalMark::Comma),
    (Delimiter::Tab, DecimalMark::Point),
    (Delimiter::Semicolon, DecimalMark::Point),
    (Delimiter::Comma, DecimalMark::Point),
    (Delimiter::Tab, DecimalMark::Comma),
    (Delimiter::Space, DecimalMark::Point),
    (Delimiter::Space, DecimalMark::Comma),
    (Delimiter::Comma, DecimalMark::Comma),
];

/// What the cells of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Numbers, or marks of missing ones.
    Number,
    /// Chainages as 12+400.123, whose numbers are in metres.
    Chainage,
    /// Complex numbers.
    Complex,
    /// What looks like numbers, but is written as none that is read: `-0.45 um`, `(0.45)`, `0.45*`.
    Odd,
    /// Nothing, or marks of missing numbers alone.
    Empty,
    /// Anything else.
    Text,
}

impl Kind {
    /// Whether the cells are numbers, chainages among them.
    pub fn is_numeric(self) -> bool {
        matches!(self, Self::Number | Self::Chainage)
    }

    /// Whether the cells are numbers, in whatever way they are written: to be read or refused, and no text.
    pub fn is_of_numbers(self) -> bool {
        self.is_numeric() || self == Self::Odd
    }

    /// Whether there are values of numbers, real or complex, that are read.
    fn has_values(self) -> bool {
        self.is_numeric() || self == Self::Complex
    }
}

/// A table of numbers as it presents itself.
#[derive(Debug, PartialEq)]
pub struct Table {
    /// What stands between cells.
    pub delimiter: Delimiter,
    /// What stands before decimals.
    pub decimal: DecimalMark,
    /// Lines before the first row of numbers.
    pub header_lines: usize,
    /// What stands above the numbers.
    pub heading: Heading,
    /// What each column is, up to the last that holds numbers.
    pub kinds: Vec<Kind>,
    /// Whether columns of text stand behind these.
    pub text_behind: bool,
    /// Whether rows above the first have the other decimal mark.
    pub mixed_marks: bool,
    /// Cells of the line right above the numbers, if it has words.
    cells_of_head: Option<usize>,
    /// The first rows; not a number where a cell holds none.
    pub sample: Vec<Vec<f64>>,
}

/// A cell and the number that it holds, which is looked at many times.
type Cell<'a> = (&'a [u8], Option<f64>);

/// A line and its cells.
type Cells<'a> = (usize, Vec<Cell<'a>>);

impl Table {
    /// The table that most of the first lines fit into; None if there is none.
    pub fn find(bytes: &[u8]) -> Option<Self> {
        let mut sample = &bytes[..bytes.len().min(SAMPLE)];
        if sample.len() < bytes.len() {
            // A line cut in two says nothing.
            let end = sample.iter().rposition(|&byte| byte == b'\n')?;
            sample = &sample[..end];
        }
        let all: Vec<&[u8]> = lines(sample).collect();
        let divides = |delimiter: Delimiter| {
            sample.iter().any(|&byte| byte == delimiter.byte() || delimiter == Delimiter::Space && byte == b'\t')
        };
        // All that divide nothing are one way.
        let undivided = WAYS.map(|(delimiter, decimal)| (!divides(delimiter)).then_some(decimal));
        let is_new = |way: &usize| undivided[*way].is_none() || !undivided[..*way].contains(&undivided[*way]);
        let (_, best) = (0..WAYS.len())
            .filter(is_new)
            .filter_map(|way| Self::read(&all, WAYS[way]))
            .rev()
            // The last of equals wins: the first of the ways.
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(best)
    }

    /// The table read in one way, and how well it fits.
    fn read(all: &[&[u8]], (delimiter, decimal): (Delimiter, DecimalMark)) -> Option<(f64, Self)> {
        let with_number = |cell| (cell, number(cell, decimal.byte()));
        let mut rows: Vec<Cells<'_>> = all
            .iter()
            .enumerate()
            .filter(|(_, line)| !is_comment(line))
            .map(|(index, line)| (index, cells(line, delimiter).into_iter().map(with_number).collect()))
            .collect();
        // Titles stand above: the later half tells what a row is.
        let later = &rows[rows.len() / 2..];
        let widest = most_frequent(later.iter().map(|(_, cells)| cells.len()))?;
        let shaped: Vec<_> = later.iter().filter(|row| row.1.len() == widest).collect();
        let mut kinds: Vec<Kind> =
            (0..widest).map(|column| kind_of(shaped.iter().map(|row| row.1[column]), decimal)).collect();
        // Remarks behind the numbers are there or not, and may have any number of cells.
        let is_there = |kind: &Kind| !matches!(kind, Kind::Text | Kind::Empty);
        let count = kinds.iter().rposition(is_there)? + 1;
        let are_all_odd = !kinds.iter().any(|kind| kind.has_values());
        kinds.truncate(count);
        let behind = |row: &&&Cells<'_>| row.1[count..].iter().any(|(cell, _)| !cell.is_empty());
        let text_behind = shaped.iter().any(|row| behind(&row));
        // Delimiters at the end of a line begin no columns.
        for (_, cells) in &mut rows {
            end_at(cells, count, |(cell, _)| cell.is_empty());
        }
        let with_values = |kind: Kind| kind.has_values() || kind == Kind::Odd && are_all_odd;
        let is_value = |column: usize, (cell, number): Cell<'_>| {
            number.is_some()
                || match kinds[column] {
                    Kind::Odd => oddity(cell).is_some(),
                    Kind::Complex => complex(cell, decimal.byte()).is_some(),
                    _ => false,
                }
        };
        let is_there = |column: usize, (cell, number): Cell<'_>| match kinds[column] {
            Kind::Odd => oddity(cell).is_some(),
            Kind::Complex => complex(cell, decimal.byte()).is_some(),
            _ => number.is_some_and(f64::is_finite),
        };
        let is_data = |cells: &[Cell<'_>]| {
            let mut values = (0..count).filter(|&column| with_values(kinds[column]));
            cells.len() >= count
                && values.clone().all(|column| is_value(column, cells[column]))
                && values.any(|column| is_there(column, cells[column]))
                && (cells.len() == count || text_behind || is_remark(cells[count].0, delimiter, decimal.byte()))
        };
        let mut first = rows.iter().position(|row| is_data(&row.1))?;
        // Bare wavelengths of bands are names of columns.
        let values = |cells: &[Cell<'_>]| -> Vec<f64> {
            let numbers = (0..count).filter(|&column| kinds[column].is_numeric());
            numbers.filter_map(|column| cells[column].1).collect()
        };
        if are_bands(&values(&rows[first].1))
            && let Some(next) = rows[first + 1..].iter().position(|row| is_data(&row.1))
        {
            first += 1 + next;
        }
        let data: Vec<_> = rows[first..].iter().filter(|row| is_data(&row.1)).collect();
        let share = data.len() as f64 / (rows.len() - first) as f64;
        // A few odd lines are defects of the file and not of the way.
        let fits = if share > 0.8 { 1.0 } else { share };
        if fits < 0.5 {
            return None;
        }
        let value = |&(_, number): &Cell<'_>| number.unwrap_or(f64::NAN);
        let sample = data.iter().map(|row| row.1[..count].iter().map(value).collect());
        let header_lines = rows[first].0;
        let cells_of_head = rows[..first].last().and_then(|(index, cells)| {
            let has_words = text_of(all[*index]).contains(char::is_alphabetic);
            has_words.then_some(cells.len())
        });
        let columns = kinds.iter().filter(|kind| kind.has_values()).count();
        let table = Self {
            delimiter,
            decimal,
            header_lines,
            cells_of_head,
            mixed_marks: has_other_mark(&rows[..first], &kinds, decimal),
            heading: Heading::read(&all[..header_lines], delimiter, count, widest),
            text_behind,
            sample: sample.collect(),
            kinds,
        };
        // In "3,21" the comma is a decimal mark unless the first column counts.
        if delimiter == Delimiter::Comma
            && count == 2
            && table.heading.names.is_none()
            && table.sample.iter().flatten().all(|value| value.fract() == 0.0)
            && table.even_step(0).is_none()
        {
            return None;
        }
        let all_numbers = columns as f64 / widest as f64;
        // Odd numbers alone may be any way's.
        let fits = if are_all_odd { fits - 1.0 } else { fits };
        Some((1e4 * fits + 1e2 * all_numbers + columns.min(50) as f64, table))
    }

    /// What a column is; text behind the last that holds numbers.
    pub fn kind(&self, column: usize) -> Kind {
        self.kinds.get(column).copied().unwrap_or(Kind::Text)
    }

    /// Columns up to the last that holds numbers.
    pub fn count(&self) -> usize {
        self.kinds.len()
    }

    /// Whether commas divide cells and stand in numbers, too, so that rows have twice as many cells as their head; a line
    /// of one cell above two columns is a title, not a head.
    pub fn has_decimal_commas(&self) -> bool {
        self.delimiter == Delimiter::Comma
            && self.cells_of_head.is_some_and(|cells| cells > 1 && 2 * cells == self.count())
    }

    /// Median of the steps of a column if nearly all have its sign and about its size.
    pub fn even_step(&self, column: usize) -> Option<f64> {
        let pairs = self.sample.windows(2);
        let steps = pairs.filter_map(|pair| Some(pair[1].get(column)? - pair[0][column]));
        let mut steps: Vec<f64> = steps.filter(|step| step.is_finite()).collect();
        steps.sort_by(f64::total_cmp);
        let median = *steps.get(steps.len() / 2)?;
        let near = steps.iter().filter(|&&step| (step / median - 1.0).abs() < 0.5);
        (median != 0.0 && 10 * near.count() >= 9 * steps.len()).then_some(median)
    }

    /// Whether a column only numbers the rows, 0, 1, 2 …, as pandas writes it without a name, or under "Unnamed: 0".
    pub fn is_index(&self, column: usize) -> bool {
        // A column without any number has no sample.
        if !self.kind(column).is_numeric() {
            return false;
        }
        let name = self.heading.name(column);
        let first = self.sample.first().map(|row| row[column]);
        let has_no_name = match name {
            Some(name) => name.is_empty() || name.to_lowercase().starts_with("unnamed"),
            // Without a head, another column is the position, and a third one the heights.
            None => {
                let mut others = column + 1..self.count();
                self.count() > 2 && others.any(|other| self.even_step(other).is_some())
            }
        };
        has_no_name
            && matches!(first, Some(0.0 | 1.0))
            && self.sample.windows(2).all(|pair| pair[1][column] - pair[0][column] == 1.0)
    }
}

/// What nearly all of the cells of a column are.
fn kind_of<'a>(cells: impl Iterator<Item = Cell<'a>> + Clone, decimal: DecimalMark) -> Kind {
    let decimal = decimal.byte();
    let all = cells.clone().count();
    let most = |count: usize| count > 0 && 10 * count >= 9 * all;
    let mut values = cells.clone().filter_map(|(_, number)| number);
    let numbers = values.clone().count();
    if most(numbers) && values.any(f64::is_finite) {
        let posts = cells.filter(|(cell, _)| is_chainage(cell, decimal)).count();
        return if 2 * posts > all { Kind::Chainage } else { Kind::Number };
    }
    if numbers == all {
        return Kind::Empty;
    }
    let odd = cells.clone().filter(|(cell, number)| number.is_none() && oddity(cell).is_some()).count();
    let pairs = cells.filter(|(cell, _)| complex(cell, decimal).is_some()).count();
    match odd {
        _ if most(pairs) => Kind::Complex,
        odd if odd > 0 && most(odd + numbers) => Kind::Odd,
        _ => Kind::Text,
    }
}

/// Whether several rows are of numbers with the other decimal mark; one may be a title.
fn has_other_mark(rows: &[Cells<'_>], kinds: &[Kind], decimal: DecimalMark) -> bool {
    let other = decimal.other().byte();
    let is_row = |cells: &[Cell<'_>]| {
        cells.len() == kinds.len()
            && kinds.iter().zip(cells).all(|(kind, (cell, _))| !kind.is_numeric() || number(cell, other).is_some())
    };
    rows.iter().filter(|row| is_row(&row.1)).count() > 1
}

/// Whether numbers follow each other as the wavelengths of one-third octaves do, by a factor of 10^0.1 either way; nominal
/// ones are up to 3 % off.
fn are_bands(numbers: &[f64]) -> bool {
    let steps = |up: f64| {
        let pairs = numbers.windows(2);
        pairs.map(|pair| (pair[1] / pair[0]).log10() * up).all(|step| (0.08..0.12).contains(&step))
    };
    numbers.len() > 2 && (steps(1.0) || steps(-1.0))
}

fn most_frequent(values: impl Iterator<Item = usize>) -> Option<usize> {
    let mut counts = std::collections::BTreeMap::new();
    for value in values {
        *counts.entry(value).or_insert(0usize) += 1;
    }
    counts.into_iter().max_by_key(|&(_, count)| count).map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of position and height written in a way.
    fn text(delimiter: &str, decimal: &str, header: &str) -> String {
        let rows = (0..50).map(|row| {
            let cells = [0.001 * f64::from(row), f64::from(row * row % 13) - 6.25, f64::from(row % 7) + 0.5];
            let cells = cells.map(|cell| format!("{cell:.3}").replace('.', decimal));
            format!("{}\n", cells.join(delimiter))
        });
        header.to_owned() + &rows.collect::<String>()
    }

    #[test]
    fn finds_how_a_table_is_written() {
        for (between, mark, header, delimiter, decimal) in [
            (",", ".", "", Delimiter::Comma, DecimalMark::Point),
            (";", ",", "Position [m];links [µm];rechts [µm]\n", Delimiter::Semicolon, DecimalMark::Comma),
            (";", ".", "a title\n\nx;l;r\n", Delimiter::Semicolon, DecimalMark::Point),
            ("\t", ",", "", Delimiter::Tab, DecimalMark::Comma),
            ("\t", ".", "# pos_m\tleft_um\tright_um\n", Delimiter::Tab, DecimalMark::Point),
            ("   ", ".", "", Delimiter::Space, DecimalMark::Point),
            (" ", ",", "", Delimiter::Space, DecimalMark::Comma),
        ] {
            let table = Table::find(text(between, mark, header).as_bytes()).unwrap();
            assert_eq!((table.delimiter, table.decimal, table.count()), (delimiter, decimal, 3));
            assert_eq!(table.header_lines, header.lines().count());
            assert_eq!(table.heading.names.is_some(), !header.is_empty());
        }
    }

    #[test]
    fn a_lone_comma_is_a_decimal_mark_unless_the_first_number_counts() {
        let decimals: String = [3, 1, 4, 1, 5, 9, 2, 6].map(|n| format!("{n},{}\n", 10 - n)).concat();
        let table = Table::find(decimals.as_bytes()).unwrap();
        assert_eq!((table.decimal, table.count()), (DecimalMark::Comma, 1));
        let counted: String = (0..8).map(|n| format!("{n},{}\n", 10 - n)).collect();
        assert_eq!(Table::find(counted.as_bytes()).unwrap().count(), 2);
    }

    #[test]
    fn decimal_commas_between_commas_stand_in_quotes() {
        let rows: String = (0..20).map(|n| format!("\"0,{n:03}\",\"{n},5\"\n")).collect();
        let table = Table::find(format!("\"x (m)\",\"z (um)\"\n{rows}").as_bytes()).unwrap();
        assert_eq!((table.delimiter, table.decimal), (Delimiter::Comma, DecimalMark::Comma));
        assert_eq!((table.count(), table.sample[3][1]), (2, 3.5));
        // Nor does a column of words behind the numbers number the rows.
        assert!(!table.is_index(2));
        assert_eq!(table.heading.unit_of(1), Some("um"));
    }

    #[test]
    fn columns_tell_what_they_are() {
        let rows: String = (0..20)
            .map(|n| format!("{n},12+4{n:02},(1.5-{n}e-3j),joint,{}\n", if n == 0 { "80" } else { "" }))
            .collect();
        let table = Table::find(format!(",km,H,event,speed\n{rows}").as_bytes()).unwrap();
        assert_eq!(table.kinds, [Kind::Number, Kind::Chainage, Kind::Complex]);
        assert!(table.is_index(0) && !table.is_index(1));
        assert_eq!(table.heading.name(4), Some("speed"));
        assert_eq!(Table::find(b"no numbers here\nnone at all\n"), None);
    }
}
