//! How a file of text is laid out, found from its first lines.

use riffel_keys::text_file::text_of;

use crate::format::{Column, DecimalMark, Delimiter, ReaderFormat};
use crate::heading::{Heading, Kind};
use crate::layout::Layout;
use crate::number;
use crate::rows::{cells, is_comment, is_remark, lines};

/// Bytes that are looked at.
const SAMPLE: usize = 1 << 16;

/// Ways to write a table, the likelier first where two fit alike.
const WAYS: [(Delimiter, DecimalMark); 7] = [
    (Delimiter::Semicolon, DecimalMark::Comma),
    (Delimiter::Tab, DecimalMark::Point),
    (Delimiter::Semicolon, DecimalMark::Point),
    (Delimiter::Comma, DecimalMark::Point),
    (Delimiter::Tab, DecimalMark::Comma),
    (Delimiter::Space, DecimalMark::Point),
    (Delimiter::Space, DecimalMark::Comma),
];

/// A table as it presents itself.
#[derive(Debug, PartialEq)]
pub(super) struct Table {
    pub(super) delimiter: Delimiter,
    pub(super) decimal: DecimalMark,
    /// Lines before the first row of numbers.
    pub(super) header_lines: usize,
    /// Cells of the line right above, if it has words.
    pub(super) cells_of_head: Option<usize>,
    /// Whether rows above the first have the other decimal mark.
    pub(super) mixed_marks: bool,
    /// What stands above the numbers.
    pub(super) heading: Heading,
    /// Cells of a row up to the last that holds numbers.
    pub(super) count: usize,
    /// Whether columns of text stand behind these.
    pub(super) text_behind: bool,
    /// Whether each column holds numbers.
    pub(super) numeric: Vec<bool>,
    /// Whether each column holds kilometrages, as in 12+400.123, whose numbers are in metres.
    kilometrage: Vec<bool>,
    /// The first rows; not a number where a cell holds none.
    sample: Vec<Vec<f64>>,
}

impl Table {
    /// The table that most of the first lines fit into; None if there is none.
    pub(super) fn find(bytes: &[u8]) -> Option<Self> {
        let mut sample = &bytes[..bytes.len().min(SAMPLE)];
        if sample.len() < bytes.len() {
            // A line cut in two says nothing.
            let end = sample.iter().rposition(|&byte| byte == b'\n')?;
            sample = &sample[..end];
        }
        let all: Vec<&[u8]> = lines(sample).collect();
        let (_, best) = WAYS
            .into_iter()
            .filter_map(|way| Self::read(&all, way))
            .rev()
            // The last of equals wins: the first of the ways.
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(best)
    }

    /// The table read in one way, and how well it fits.
    fn read(all: &[&[u8]], (delimiter, decimal): (Delimiter, DecimalMark)) -> Option<(f64, Self)> {
        let mut rows: Vec<(usize, Vec<&[u8]>)> = all
            .iter()
            .enumerate()
            .filter(|(_, line)| !is_comment(line))
            .map(|(index, line)| (index, cells(line, delimiter)))
            .collect();
        // Titles stand above: the later half tells what a row is.
        let later = &rows[rows.len() / 2..];
        let widest = most_frequent(later.iter().map(|(_, cells)| cells.len()))?;
        let shaped: Vec<_> = later.iter().filter(|row| row.1.len() == widest).collect();
        let number = |cell: &[u8]| number::parse(cell, decimal.byte());
        let other = |cell: &[u8]| number::parse(cell, decimal.other().byte());
        let mut numeric: Vec<bool> = (0..widest)
            .map(|column| {
                let numbers = shaped.iter().filter(|row| number(row.1[column]).is_some());
                let values = shaped
                    .iter()
                    .filter(|row| number(row.1[column]).is_some_and(f64::is_finite));
                10 * numbers.count() >= 9 * shaped.len() && values.count() > 0
            })
            .collect();
        // Remarks behind the numbers are there or not, and may have any number of cells.
        let count = numeric.iter().rposition(|&numeric| numeric)? + 1;
        numeric.truncate(count);
        let text_behind = count < widest;
        let columns = numeric.iter().filter(|&&numeric| numeric).count();
        // An empty cell at the end is a missing value where it stands for a number.
        for (index, cells) in &mut rows {
            let line = all[*index].strip_suffix(b"\r").unwrap_or(all[*index]);
            if cells.len() + 1 == count
                && delimiter != Delimiter::Space
                && line.ends_with(&[delimiter.byte()])
            {
                cells.push(b"");
            }
        }
        let is_data = |cells: &[&[u8]]| {
            let with_numbers = || (0..count).filter(|&column| numeric[column]);
            cells.len() >= count
                && with_numbers().all(|column| number(cells[column]).is_some())
                && with_numbers().any(|column| number(cells[column]).is_some_and(f64::is_finite))
                && (cells.len() == count
                    || text_behind
                    || is_remark(cells[count], delimiter, decimal.byte()))
        };
        let mut first = rows.iter().position(|row| is_data(&row.1))?;
        // Bare wavelengths of bands are names of columns.
        let values = |cells: &[&[u8]]| -> Vec<f64> {
            let numbers = (0..count).filter(|&column| numeric[column]);
            numbers.filter_map(|column| number(cells[column])).collect()
        };
        if are_bands(&values(&rows[first].1))
            && let Some(next) = rows[first + 1..].iter().position(|row| is_data(&row.1))
        {
            first += 1 + next;
        }
        let data: Vec<_> = rows[first..].iter().filter(|row| is_data(&row.1)).collect();
        let share = data.len() as f64 / (rows.len() - first) as f64;
        let header_lines = rows[first].0;
        // One such line may be a title.
        let with_other_mark = rows[..first].iter().filter(|(_, cells)| {
            cells.len() == count && (0..count).all(|at| !numeric[at] || other(cells[at]).is_some())
        });
        let mixed_marks = with_other_mark.count() > 1;
        let kilometrage = (0..count)
            .map(|column| {
                let is = |row: &&&(usize, Vec<&[u8]>)| {
                    number::is_kilometrage(row.1[column], decimal.byte())
                };
                2 * data.iter().filter(is).count() > data.len()
            })
            .collect();
        let sample = data
            .iter()
            .map(|row| {
                let value = |cell: &&[u8]| number(cell).unwrap_or(f64::NAN);
                row.1[..count].iter().map(value).collect()
            })
            .collect();
        // A few odd lines are defects of the file and not of the way.
        let fits = if share > 0.8 { 1.0 } else { share };
        if fits < 0.5 {
            return None;
        }
        let all_numbers = columns as f64 / widest as f64;
        let score = 1e4 * fits + 1e2 * all_numbers + columns.min(50) as f64;
        let cells_of_head = rows[..first].last().and_then(|(index, cells)| {
            let has_words = text_of(all[*index]).contains(char::is_alphabetic);
            has_words.then_some(cells.len())
        });
        let table = Self {
            delimiter,
            decimal,
            header_lines,
            cells_of_head,
            mixed_marks,
            heading: Heading::read(&all[..header_lines], delimiter, count, widest),
            count,
            text_behind,
            numeric,
            kilometrage,
            sample,
        };
        // In "3,21" the comma is a decimal mark unless the first column counts.
        if delimiter == Delimiter::Comma
            && count == 2
            && table.heading.names.is_none()
            && table.integers()
            && !table.is_even(0)
        {
            return None;
        }
        Some((score, table))
    }

    /// Whether commas divide cells and stand in numbers, too, so that rows have twice as many cells as their head; a line
    /// of one cell above two columns is a title, not a head.
    pub(super) fn has_decimal_commas(&self) -> bool {
        self.delimiter == Delimiter::Comma
            && self
                .cells_of_head
                .is_some_and(|cells| cells > 1 && 2 * cells == self.count)
    }

    fn integers(&self) -> bool {
        self.sample
            .iter()
            .flatten()
            .all(|value| value.fract() == 0.0)
    }

    /// Median of the steps of a column if nearly all have its sign and about its size.
    fn even_step(&self, column: usize) -> Option<f64> {
        let mut steps: Vec<f64> = self
            .sample
            .windows(2)
            .map(|pair| pair[1][column] - pair[0][column])
            .filter(|step| step.is_finite())
            .collect();
        steps.sort_by(f64::total_cmp);
        let median = *steps.get(steps.len() / 2)?;
        let near = steps
            .iter()
            .filter(|&&step| (step / median - 1.0).abs() < 0.5);
        (median != 0.0 && 10 * near.count() >= 9 * steps.len()).then_some(median)
    }

    fn is_even(&self, column: usize) -> bool {
        self.even_step(column).is_some()
    }

    /// The layout of a profile, or why there is none, as a sentence.
    pub(super) fn format(&self, layout: &Layout) -> Result<ReaderFormat, String> {
        let spacing = layout.spacing;
        let mut columns: Vec<usize> = (0..self.count)
            .filter(|&column| self.numeric[column] && !self.is_something_else(column))
            .collect();
        let named = columns
            .iter()
            .position(|&column| self.kilometrage[column] || self.heading.is(column, &POSITION));
        let position = match named {
            Some(place) => Some(columns.remove(place)),
            None => self
                .unnamed_position(&columns, spacing.is_some())
                .map(|place| columns.remove(place)),
        };
        if position.is_none_or(|column| !self.is_even(column) && named.is_none())
            && spacing.is_none()
            && let Some(counter) = self.counter()
        {
            return Err(format!(
                "no column is a position: column {}, \"{}\", is a counter or a time; give the step between samples by \
                 --spacing",
                counter + 1,
                self.heading.name(counter).unwrap_or_default()
            ));
        }
        if columns.is_empty() {
            return Err("there is no column of heights".to_owned());
        }
        if position.is_none() && spacing.is_none() {
            return Err("there is one column of heights and no position".to_owned());
        }
        self.check_units(layout, &columns, position)?;
        let rails = columns
            .into_iter()
            .map(|column| Column {
                column: column + 1,
                unit: self.unit(column, Kind::Height).unwrap_or("um").to_owned(),
                name: self.heading.rail_name(column),
            })
            .collect();
        let mut format = layout.apply(&ReaderFormat {
            delimiter: self.delimiter,
            decimal: self.decimal,
            header_lines: self.header_lines,
            spacing: spacing.filter(|_| position.is_none()),
            position: position.map(|column| Column {
                column: column + 1,
                unit: self
                    .unit(column, Kind::Position)
                    .unwrap_or_else(|| self.likely_unit(column))
                    .to_owned(),
                name: String::new(),
            }),
            rails,
        });
        if let Some(position) = format.position.as_mut()
            && self.kilometrage[position.column - 1]
        {
            position.unit = "m".to_owned();
        }
        Ok(format)
    }

    /// The column besides positions and heights that rises evenly, if there is one.
    fn counter(&self) -> Option<usize> {
        (0..self.count).find(|&column| {
            self.numeric[column] && self.is_something_else(column) && self.is_even(column)
        })
    }

    /// The place among some columns of the one that rises or falls evenly, the first of several; else the first, where
    /// there must be a position.
    fn unnamed_position(&self, columns: &[usize], spaced: bool) -> Option<usize> {
        let even = columns.iter().position(|&column| self.is_even(column));
        match even {
            _ if columns.len() < 2 => None,
            Some(place) => Some(place),
            None => (!spaced).then_some(0),
        }
    }

    /// Refuse a head whose unit is no length, and a remark that contradicts a head, unless the user says the unit.
    fn check_units(
        &self,
        layout: &Layout,
        heights: &[usize],
        position: Option<usize>,
    ) -> Result<(), String> {
        let heights = heights
            .iter()
            .map(|&column| (column, Kind::Height, layout.height_unit.is_some()));
        let position =
            position.map(|column| (column, Kind::Position, layout.position_unit.is_some()));
        for (column, kind, said) in heights.chain(position) {
            if let (Some(foreign), false) = (self.heading.foreign_unit_of(column), said)
                && !self.kilometrage[column]
            {
                let (what, option) = kind.words();
                return Err(format!(
                    "the head of column {}, \"{}\", gives {foreign} as the unit of the {what}, which is no length known \
                     here; convert the column, or give {option}",
                    column + 1,
                    self.heading.name(column).unwrap_or_default()
                ));
            }
            if let (Some(own), Some(stated), false) = (
                self.heading.unit_of(column),
                self.heading.stated(kind),
                said,
            ) && own != stated.unit
                && !self.kilometrage[column]
            {
                let (what, option) = kind.words();
                return Err(format!(
                    "the head of column {} gives {own}, but line {} says {what} in {}; give {option}",
                    column + 1,
                    stated.line,
                    stated.unit
                ));
            }
        }
        Ok(())
    }

    /// Columns whose unit no head gives, as a sentence on where it was taken from, and what was left out.
    pub(super) fn assumptions(&self, format: &ReaderFormat, layout: &Layout) -> Vec<String> {
        let source = |column: &Column, kind: Kind, said: bool| {
            let place = column.column - 1;
            let (what, _) = kind.words();
            let unit = &column.unit;
            if said || self.kilometrage[place] || self.heading.unit_of(place).is_some() {
                None
            } else if let Some(stated) = self.heading.stated(kind) {
                Some((
                    format!("{what} in {unit}"),
                    format!("by line {}", stated.line),
                ))
            } else {
                Some((format!("{what} in {unit}"), "taken for granted".to_owned()))
            }
        };
        let mut position = format.position.iter();
        let position = position
            .find_map(|column| source(column, Kind::Position, layout.position_unit.is_some()));
        let mut rails = format.rails.iter();
        let heights =
            rails.find_map(|column| source(column, Kind::Height, layout.height_unit.is_some()));
        let mut sentences: Vec<String> = match (position, heights) {
            (Some(a), Some(b)) if a.1 == b.1 => vec![format!("{} and {} {}", a.0, b.0, a.1)],
            (a, b) => a
                .into_iter()
                .chain(b)
                .map(|(what, from)| format!("{what} {from}"))
                .collect(),
        };
        let text: Vec<String> = (0..self.count)
            .filter(|&column| !self.numeric[column])
            .map(|column| (column + 1).to_string())
            .collect();
        match (&text[..], self.text_behind) {
            ([], false) => {}
            ([], true) => {
                sentences.push(format!("the text behind column {} is left out", self.count))
            }
            (columns, _) => {
                sentences.push(format!("text in column {} is left out", columns.join(", ")))
            }
        }
        sentences
    }

    /// Unit that the head of a column or else a remark gives.
    fn unit(&self, column: usize, kind: Kind) -> Option<&'static str> {
        let stated = || self.heading.stated(kind).map(|stated| stated.unit);
        self.heading.unit_of(column).or_else(stated)
    }

    /// Whether the head of a column names neither a position nor a height.
    fn is_something_else(&self, column: usize) -> bool {
        let name = self.heading.name(column).unwrap_or_default().to_lowercase();
        self.heading.is(column, &IGNORED) || OTHER_UNITS.iter().any(|unit| name.contains(unit))
    }

    /// Unit of a position that has none, from its step: no trolley samples in steps of less than 20 µm
    /// or more than 100 mm.
    fn likely_unit(&self, column: usize) -> &'static str {
        match self.even_step(column).map(f64::abs) {
            Some(step) if step < 2e-5 => "km",
            Some(step) if step > 0.1 => "mm",
            _ => "m",
        }
    }
}

const POSITION: [&str; 21] = [
    "position",
    "pos",
    "chainage",
    "station",
    "distance",
    "dist",
    "abscissa",
    "location",
    "kilometre",
    "kilometer",
    "mileage",
    "weg",
    "strecke",
    "pk",
    "x",
    "s",
    "km",
    "way",
    "abszisse",
    "abscisse",
    "kilometrierung",
];
const IGNORED: [&str; 23] = [
    "index",
    "sample",
    "samples",
    "nr",
    "no",
    "number",
    "id",
    "time",
    "zeit",
    "speed",
    "date",
    "temperature",
    "latitude",
    "longitude",
    "lat",
    "lon",
    "event",
    "velocity",
    "geschwindigkeit",
    "temperatur",
    "datum",
    "uhrzeit",
    "lfd",
];
/// Units of columns that hold something else.
const OTHER_UNITS: [&str; 9] = [
    "km/h", "m/s", "km_h", "kmh", "m_per_s", "°c", "[s]", "(s)", "[v]",
];

/// Whether numbers follow each other as the wavelengths of one-third octaves do, by a factor of 10^0.1 either way; nominal
/// ones are up to 3 % off.
fn are_bands(numbers: &[f64]) -> bool {
    let steps = |up: f64| {
        let pairs = numbers.windows(2);
        pairs
            .map(|pair| (pair[1] / pair[0]).log10() * up)
            .all(|step| (0.08..0.12).contains(&step))
    };
    numbers.len() > 2 && (steps(1.0) || steps(-1.0))
}

fn most_frequent(values: impl Iterator<Item = usize>) -> Option<usize> {
    let mut counts = std::collections::BTreeMap::new();
    for value in values {
        *counts.entry(value).or_insert(0usize) += 1;
    }
    counts
        .into_iter()
        .max_by_key(|&(_, count)| count)
        .map(|(value, _)| value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of position and height written in a way.
    fn text(delimiter: &str, decimal: &str, header: &str) -> String {
        let rows = (0..50).map(|row| {
            let cells = [
                0.001 * f64::from(row),
                f64::from(row * row % 13) - 6.25,
                f64::from(row % 7) + 0.5,
            ];
            let cells = cells.map(|cell| format!("{cell:.3}").replace('.', decimal));
            format!("{}\n", cells.join(delimiter))
        });
        header.to_owned() + &rows.collect::<String>()
    }

    #[test]
    fn finds_how_a_table_is_written() {
        for (between, mark, header, delimiter, decimal) in [
            (",", ".", "", Delimiter::Comma, DecimalMark::Point),
            (
                ";",
                ",",
                "Position [m];links [µm];rechts [µm]\n",
                Delimiter::Semicolon,
                DecimalMark::Comma,
            ),
            (
                ";",
                ".",
                "a title\n\nx;l;r\n",
                Delimiter::Semicolon,
                DecimalMark::Point,
            ),
            ("\t", ",", "", Delimiter::Tab, DecimalMark::Comma),
            (
                "\t",
                ".",
                "# pos_m\tleft_um\tright_um\n",
                Delimiter::Tab,
                DecimalMark::Point,
            ),
            ("   ", ".", "", Delimiter::Space, DecimalMark::Point),
            (" ", ",", "", Delimiter::Space, DecimalMark::Comma),
        ] {
            let table = Table::find(text(between, mark, header).as_bytes()).unwrap();
            assert_eq!(
                (table.delimiter, table.decimal, table.count),
                (delimiter, decimal, 3)
            );
            assert_eq!(table.header_lines, header.lines().count());
            let format = table.format(&Layout::default()).unwrap();
            assert_eq!(format.position.unwrap().column, 1);
            assert_eq!(format.rails.len(), 2);
            assert_eq!(table.heading.names.is_some(), !header.is_empty());
        }
    }

    #[test]
    fn units_come_from_the_header_or_the_step() {
        let format = |header: &str, step: &str| {
            let rows: String = (0..20)
                .map(|row| format!("{}{step};{row}.5\n", row))
                .collect();
            Table::find((header.to_owned() + &rows).as_bytes())
                .unwrap()
                .format(&Layout::default())
                .unwrap()
        };
        let units = |format: &ReaderFormat| {
            (
                format.position.as_ref().unwrap().unit.clone(),
                format.rails[0].unit.clone(),
            )
        };
        assert_eq!(
            units(&format("km;Hoehe (mm)\n", "e-6")),
            ("km".into(), "mm".into())
        );
        assert_eq!(units(&format("", "e-6")), ("km".into(), "um".into()));
        assert_eq!(units(&format("", "e-3")), ("m".into(), "um".into()));
        assert_eq!(units(&format("", "")), ("mm".into(), "um".into()));
    }

    #[test]
    fn a_lone_comma_is_a_decimal_mark_unless_the_first_number_counts() {
        let decimals: String = [3, 1, 4, 1, 5, 9, 2, 6]
            .map(|n| format!("{n},{}\n", 10 - n))
            .concat();
        let table = Table::find(decimals.as_bytes()).unwrap();
        assert_eq!((table.decimal, table.count), (DecimalMark::Comma, 1));
        assert!(table.format(&Layout::default()).is_err());
        let counted: String = (0..8).map(|n| format!("{n},{}\n", 10 - n)).collect();
        assert_eq!(Table::find(counted.as_bytes()).unwrap().count, 2);
    }

    #[test]
    fn other_columns_are_left_out() {
        let rows: String = (0..30)
            .map(|n| format!("{n},2014-07-01,{},{}.5\n", 0.001 * f64::from(n), n))
            .collect();
        let table =
            Table::find(format!("index,date,chainage_m,left rail um\n{rows}").as_bytes()).unwrap();
        let format = table.format(&Layout::default()).unwrap();
        assert_eq!(format.position.unwrap().column, 3);
        assert_eq!(format.rails.len(), 1);
        assert_eq!(format.rails[0].name, "left rail");
        assert_eq!(Table::find(b"no numbers here\nnone at all\n"), None);
    }
}
