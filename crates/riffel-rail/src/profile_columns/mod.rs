//! Which columns of a table are the position and the heights of a profile.

use std::collections::{BTreeMap, BTreeSet};

use riffel_keys::table::{self, Table};
use riffel_keys::{Message, number, say};

use crate::date_column::{dates_of_heads, is_of_time, names_occasions};
use crate::format::{Column, ReaderFormat};
use crate::layout::Layout;
use crate::no_rail::{filter_remark, why_no_rail};
use crate::unit_remark::{Kind, UnitRemarks};

/// A table as a profile, with what a user says of it.
pub(super) struct ProfileTable<'a> {
    table: &'a Table,
    layout: &'a Layout,
    /// Units that remarks give.
    stated: UnitRemarks,
    /// Columns whose cells tell records apart: the rail, the date, the run.
    labels: Vec<usize>,
    /// Columns of text under the head of a rail or a position, which are refused with their first cell.
    misread: Vec<usize>,
    /// The first row.
    first: Vec<String>,
}

impl<'a> ProfileTable<'a> {
    /// `bytes` are those in which the table was found.
    pub(super) fn new(table: &'a Table, bytes: &[u8], layout: &'a Layout) -> Self {
        let mut found = Self {
            table,
            layout,
            stated: UnitRemarks::of(&table.heading.remarks, table.count()),
            labels: label_columns(table, bytes),
            misread: Vec::new(),
            first: first_row(table, bytes),
        };
        let is_time = |&column: &usize| is_of_time(table.heading.name(column).unwrap_or_default());
        if found.labels.iter().all(is_time)
            && let Some(position) = found.position_and_others().0
        {
            let dividing = dividing_column(table, bytes, position);
            let other = dividing.filter(|column| !found.labels.contains(column));
            found.labels.extend(other);
        }
        found.misread = misread_columns(table, bytes, &found.labels);
        found
    }

    /// The layout of a profile, or why there is none, as a sentence.
    pub(super) fn format(&self) -> Result<ReaderFormat, Message> {
        let (table, heading) = (self.table, &self.table.heading);
        let spacing = self.layout.spacing;
        let (position, mut columns) = self.position_and_others();
        let left_out = self.left_out(&columns);
        columns.retain(|column| !left_out.contains_key(column));
        if position.is_none_or(|column| table.even_step(column).is_none() && !self.is_named(column))
            && spacing.is_none()
            && let Some(counter) = self.counter()
        {
            return Err(format!(
                "no column is a position: column {}, \"{}\", is a counter or a time; give the step between samples by \
                 --spacing",
                counter + 1,
                heading.name(counter).unwrap_or_default()
            )
            .into());
        }
        if columns.is_empty() {
            let first = left_out.into_iter().next();
            let first = first.or_else(|| Some((self.empty().next()?, say!(it_is_empty))));
            return Err(first.map_or_else(
                || say!(no_heights),
                |(column, why)| {
                    let name = heading.name(column).unwrap_or_default();
                    say!(no_heights_but, reason = left_out_sentence(column, name, why))
                },
            ));
        }
        if position.is_none() && spacing.is_none() {
            return Err(self.no_position());
        }
        self.check_units(&columns, position)?;
        let heads: Vec<&str> = columns.iter().filter_map(|&column| heading.name(column)).collect();
        let dated = dates_of_heads(&heads).filter(|_| heads.len() == columns.len());
        let name = |place: usize, column: usize| match &dated {
            // As the record takes them apart again.
            Some(dated) => format!("{} {}", dated[place].1, dated[place].0),
            None => heading.bare_name(column),
        };
        let rails = columns.into_iter().enumerate();
        let rails = rails.map(|(place, column)| Column {
            column: column + 1,
            unit: self.unit(column, Kind::Height).unwrap_or("um").to_owned(),
            name: name(place, column),
        });
        let position = position.map(|column| Column {
            column: column + 1,
            unit: self.unit(column, Kind::Position).unwrap_or_else(|| self.likely_unit(column)).to_owned(),
            name: String::new(),
        });
        let mut format = self.layout.apply(&ReaderFormat {
            delimiter: table.delimiter,
            decimal: table.decimal,
            header_lines: table.header_lines,
            spacing: spacing.filter(|_| position.is_none()),
            position,
            rails: rails.collect(),
            labels: self.labels.iter().map(|column| column + 1).collect(),
        });
        if let Some(position) = format.position.as_mut()
            && self.is_chainage(position.column - 1)
        {
            position.unit = "m".to_owned();
        }
        Ok(format)
    }

    /// That there is no position, with the first column that has digits in it and is text.
    fn no_position(&self) -> Message {
        let texts = (0..).zip(&self.first).find(|(column, cell)| {
            self.table.kind(*column) == table::Kind::Text
                && !self.labels.contains(column)
                && cell.contains(char::is_numeric)
        });
        texts.map_or_else(
            || say!(heights_without_position),
            |(column, cell)| {
                let column = number(column + 1);
                say!(heights_without_position_but, column, cell = &cell[..])
            },
        )
    }

    /// The column of positions, if there is one, and the other columns of lengths.
    fn position_and_others(&self) -> (Option<usize>, Vec<usize>) {
        let table = self.table;
        let mut columns: Vec<usize> = (0..self.width())
            .filter(|&column| self.may_be_read(column) && !self.is_no_length(column))
            .filter(|&column| !is_something_else(table, column))
            .collect();
        let named = columns.iter().position(|&column| self.is_named(column));
        let place = named.or_else(|| self.unnamed_position(&columns));
        (place.map(|place| columns.remove(place)), columns)
    }

    /// Columns of the head and of the rows.
    fn width(&self) -> usize {
        let names = self.table.heading.names.as_ref().map_or(0, Vec::len);
        names.max(self.table.count())
    }

    /// Whether a column is to be read or refused unless its head is that of something else.
    fn may_be_read(&self, column: usize) -> bool {
        self.table.kind(column).is_of_numbers() || self.misread.contains(&column)
    }

    /// Columns without any value, under the head of a rail.
    fn empty(&self) -> impl Iterator<Item = usize> {
        (0..self.width()).filter(|&column| {
            let is_empty = match column < self.table.count() {
                true => self.table.kind(column) == table::Kind::Empty,
                false => !self.misread.contains(&column) && !self.labels.contains(&column),
            };
            is_empty && is_of_a_rail(self.table, column)
        })
    }

    /// Which of some columns are no heights of a rail, each with the reason: by their names, or by their units beside columns of
    /// lengths.
    fn left_out(&self, columns: &[usize]) -> BTreeMap<usize, Message> {
        let heading = &self.table.heading;
        let is_foreign = |column: &usize| heading.foreign_unit_of(*column).is_some();
        let (foreign, lengths): (Vec<usize>, Vec<usize>) = columns.iter().copied().partition(is_foreign);
        let why = |columns: &[usize]| -> BTreeMap<usize, Message> {
            let names = columns.iter().map(|&column| heading.name(column));
            let names: Vec<&str> = names.map(Option::unwrap_or_default).collect();
            let all = columns.iter().copied().zip(why_no_rail(&names));
            all.filter_map(|(column, why)| Some((column, why?))).collect()
        };
        let mut left_out = why(&lengths);
        let is_length = |column: &usize| !left_out.contains_key(column) && heading.unit_of(*column).is_some();
        let beside_lengths = lengths.iter().any(is_length);
        left_out.extend(why(&foreign));
        if beside_lengths {
            for column in foreign {
                left_out.entry(column).or_insert(say!(its_unit_is_no_length));
            }
        }
        left_out
    }

    /// Whether a column is a position by its head or the form of its numbers.
    fn is_named(&self, column: usize) -> bool {
        self.is_chainage(column) || self.table.heading.is(column, POSITION)
    }

    /// Whether a column tells records apart or only numbers the rows.
    fn is_no_length(&self, column: usize) -> bool {
        self.labels.contains(&column) || self.table.is_index(column)
    }

    fn is_chainage(&self, column: usize) -> bool {
        self.table.kind(column) == table::Kind::Chainage
    }

    /// The column besides positions and heights that rises evenly, if there is one.
    fn counter(&self) -> Option<usize> {
        (0..self.table.count()).find(|&column| {
            self.table.kind(column).is_numeric()
                && (is_something_else(self.table, column) || self.table.is_index(column))
                && self.table.even_step(column).is_some()
        })
    }

    /// The place among some columns of the one that rises or falls evenly, the first of several; else the first, where
    /// there must be a position.
    fn unnamed_position(&self, columns: &[usize]) -> Option<usize> {
        let is_even = |&column: &usize| self.table.even_step(column).is_some();
        let even = columns.iter().position(is_even);
        match even {
            _ if columns.len() < 2 => None,
            Some(place) => Some(place),
            None => self.layout.spacing.is_none().then_some(0),
        }
    }

    /// Refuse a head whose unit is no length, and a remark that contradicts a head, unless the user says the unit.
    fn check_units(&self, heights: &[usize], position: Option<usize>) -> Result<(), Message> {
        let heading = &self.table.heading;
        let heights = heights.iter().map(|&column| (column, Kind::Height));
        let all = heights.chain(position.map(|column| (column, Kind::Position)));
        for (column, kind) in all.filter(|&(column, _)| !self.is_chainage(column)) {
            if self.is_said(kind) {
                continue;
            }
            let (what, option) = kind.words();
            if let Some(foreign) = heading.foreign_unit_of(column) {
                if foreign.eq_ignore_ascii_case("dB") {
                    return Err(format!(
                        "the head of column {}, \"{}\", gives {foreign}: beside levels there must be a column of wavelengths, as \
                         wavelength_mm; for heights give {option}",
                        column + 1,
                        heading.name(column).unwrap_or_default()
                    ).into());
                }
                return Err(format!(
                    "the head of column {}, \"{}\", gives {foreign} as the unit of the {what}, which is no length known \
                     here; convert the column, or give {option}",
                    column + 1,
                    heading.name(column).unwrap_or_default()
                ).into());
            }
            if let (Some(own), Some(stated)) = (heading.unit_of(column), self.stated.unit(kind))
                && own != stated.unit
            {
                return Err(format!(
                    "the head of column {} gives {own}, but line {} says {what} in {}; give {option}",
                    column + 1,
                    stated.line,
                    stated.unit
                )
                .into());
            }
        }
        Ok(())
    }

    /// Whether the user says the unit.
    fn is_said(&self, kind: Kind) -> bool {
        match kind {
            Kind::Height => self.layout.height_unit.is_some(),
            Kind::Position => self.layout.position_unit.is_some(),
        }
    }

    /// Columns whose unit no head gives, as a sentence on where it was taken from, and what was left out.
    pub(super) fn assumptions(&self, format: &ReaderFormat) -> Vec<Message> {
        let heading = &self.table.heading;
        let source = |column: &Column, kind: Kind| {
            let place = column.column - 1;
            if self.is_said(kind) || self.is_chainage(place) || heading.unit_of(place).is_some() {
                return None;
            }
            let stated = self.stated.unit(kind);
            Some((column.unit.clone(), stated.map(|stated| stated.line)))
        };
        let mut position = format.position.iter();
        let position = position.find_map(|column| source(column, Kind::Position));
        let mut heights = format.rails.iter();
        let heights = heights.find_map(|column| source(column, Kind::Height));
        let what = match (position, heights) {
            (Some(a), Some(b)) if a.1 == b.1 => {
                vec![(say!(position_and_heights_in, unit = a.0, other = b.0), a.1)]
            }
            (a, b) => {
                let position = a.map(|(unit, line)| (say!(position_in, unit), line));
                let heights = b.map(|(unit, line)| (say!(heights_in, unit), line));
                position.into_iter().chain(heights).collect()
            }
        };
        let sentences = what.into_iter().map(|(what, line)| match line {
            Some(line) => say!(by_line, what, line = number(line)),
            None => say!(taken_for_granted, what),
        });
        let mut sentences: Vec<Message> = sentences.collect();
        let count = self.table.count();
        let mut left_out = self.left_out(&self.position_and_others().1);
        left_out.extend(self.empty().map(|column| (column, say!(it_is_empty))));
        sentences.extend((0..self.width()).filter_map(|column| {
            let is_read = |one: &Column| one.column == column + 1;
            let is_read = format.position.iter().chain(&format.rails).any(is_read);
            if is_read || self.labels.contains(&column) {
                return None;
            }
            let why = match left_out.remove(&column) {
                Some(why) => why,
                None if !self.table.kind(column).is_of_numbers() => return None,
                None if self.table.is_index(column) => say!(it_numbers_the_rows),
                None => say!(it_is_neither),
            };
            let name = heading.name(column).unwrap_or_default();
            Some(left_out_sentence(column, name, why))
        }));
        let heads = format.rails.iter().filter_map(|rail| {
            let head = heading.name(rail.column - 1)?;
            let column = say!(column_of_head, column = number(rail.column), head);
            filter_remark(head, column.into())
        });
        sentences.extend(heads);
        let text: Vec<String> = (0..count)
            .filter(|&column| {
                let kind = self.table.kind(column);
                let is_text = matches!(kind, table::Kind::Text | table::Kind::Complex);
                is_text && !self.labels.contains(&column)
            })
            .map(|column| (column + 1).to_string())
            .collect();
        let is_label_behind = self.labels.iter().any(|&label| label >= count);
        match (&text[..], self.table.text_behind && !is_label_behind) {
            ([], false) => {}
            ([], true) => sentences.push(say!(text_behind_left_out, column = number(count))),
            (columns, _) => {
                sentences.push(say!(text_columns_left_out, columns = columns.join(", ")));
            }
        }
        sentences
    }

    /// Unit that the head of a column or else a remark gives.
    fn unit(&self, column: usize, kind: Kind) -> Option<&'static str> {
        let stated = || self.stated.unit(kind).map(|stated| stated.unit);
        self.table.heading.unit_of(column).or_else(stated)
    }

    /// Unit of a position that has none, from its step: no trolley samples in steps of less than 20 µm
    /// or more than 100 mm.
    fn likely_unit(&self, column: usize) -> &'static str {
        match self.table.even_step(column).map(f64::abs) {
            Some(step) if step < 2e-5 => "km",
            Some(step) if step > 0.1 => "mm",
            _ => "m",
        }
    }
}

const POSITION: &str = "position|pos|chainage|station|distance|dist|abscissa|location|kilometre|kilometer|mileage|weg|\
                        strecke|pk|x|s|km|way|abszisse|abscisse|kilometrierung";
const IGNORED: &str = "index|sample|samples|nr|no|number|id|time|zeit|speed|date|temperature|latitude|longitude|lat|lon|\
                        event|velocity|geschwindigkeit|temperatur|datum|uhrzeit|lfd|temp|température|temperatura|vitesse|\
                        velocidad|velocità|alt|altitude|elevation|acc|acceleration|beschleunigung|gyro|quality|flag";
/// Units of columns that hold something else.
const OTHER_UNITS: [&str; 9] = ["km/h", "m/s", "km_h", "kmh", "m_per_s", "°c", "[s]", "(s)", "[v]"];
/// Words for columns that tell records apart.
const LABELS: &str = "rail|side|schiene|seite|track|gleis|line|linie|strecke|date|datum|run|lauf|fahrt|record|messung|\
                        site|ort|section|abschnitt|campaign|kampagne|côté|cote|voie|carril|lado|vía|fecha|rotaia|binario|\
                        lato|spoor|spoorstaaf|zijde|szyna|kolejnice";

/// Whether the head of a column names neither a position nor a height.
fn is_something_else(table: &Table, column: usize) -> bool {
    let name = table.heading.name(column).unwrap_or_default().to_lowercase();
    table.heading.is(column, IGNORED) || is_of_time(&name) || OTHER_UNITS.iter().any(|unit| name.contains(unit))
}

/// That a column is left out, and why.
pub(crate) fn left_out_sentence(column: usize, name: &str, why: Message) -> Message {
    let column = number(column + 1);
    match name {
        "" => say!(column_left_out, column, reason = why),
        name => say!(headed_column_left_out, column, head = name, reason = why),
    }
}

/// Whether the head of a column is that of a rail or its height, by its words or its unit.
fn is_of_a_rail(table: &Table, column: usize) -> bool {
    let has_unit = || table.heading.unit_of(column).is_some();
    !is_something_else(table, column) && (names_a_rail(table, column) || has_unit())
}

/// Whether the head of a column has a word for one rail or for heights; one with words for both rails tells them apart.
pub(super) fn names_a_rail(table: &Table, column: usize) -> bool {
    const LEFT: &str = "left|links|gauche|izquierda|izquierdo|sinistra|sinistro|lewa|low";
    const RIGHT: &str = "right|rechts|droite|droit|derecha|derecho|destra|destro|prawa|high";
    const HEIGHT: &str = "height|heights|höhe|hoehe|höhen|hauteur|altura|altezza|hoogte|roughness|rauheit";
    let is = |known: &str| table.heading.is(column, known);
    is(LEFT) != is(RIGHT) || is(HEIGHT) && !is(LEFT)
}

/// The texts of the first row.
fn first_row(table: &Table, bytes: &[u8]) -> Vec<String> {
    let row = table::rows(bytes, table.header_lines, table.delimiter, None).next();
    row.map_or_else(Vec::new, |row| (0..row.cells.len()).map(|column| row.text(column)).collect())
}

/// Columns of text, none of `labels`, whose head is that of a rail, or that of a position above cells with digits.
fn misread_columns(table: &Table, bytes: &[u8], labels: &[usize]) -> Vec<usize> {
    /// Rows that are looked at.
    const ROWS: usize = 2000;
    let names = table.heading.names.as_ref().map_or(0, Vec::len);
    let is_misread = |&column: &usize| {
        let of_rail = is_of_a_rail(table, column);
        let of_position = table.heading.is(column, POSITION);
        if table.kind(column) != table::Kind::Text || labels.contains(&column) || !(of_rail || of_position) {
            return false;
        }
        let (above, style) = (table.header_lines, (table.delimiter, table.decimal));
        let mut rows = table::rows(bytes, above, style.0, Some(style.1)).take(ROWS);
        rows.any(|row| {
            let text = row.text(column);
            row.value(column).is_none() && !text.is_empty() && (of_rail || text.contains(char::is_numeric))
        })
    };
    (0..names.max(table.count())).filter(is_misread).collect()
}

/// Columns that tell records apart: of text under one of [`LABELS`] or without any head, or of such whole numbers, with few
/// that differ; or of few dates. A clock beside no date tells rows apart, not records.
fn label_columns(table: &Table, bytes: &[u8]) -> Vec<usize> {
    /// Rows that are looked at, and of these for each label.
    const ROWS: (usize, usize) = (2000, 100);
    let heading = &table.heading;
    let sample = || {
        let rows = table::rows(bytes, table.header_lines, table.delimiter, None);
        rows.take(ROWS.0)
    };
    let widest = sample().map(|row| row.cells.len()).max().unwrap_or(0);
    let is_label = |&column: &usize| {
        let kind = table.kind(column);
        let head = heading.name(column).unwrap_or_default();
        let cells: Vec<String> = sample().map(|row| row.text(column)).collect();
        let is_time = is_of_time(head) || names_occasions(head, &cells);
        let is_named = is_time || heading.is(column, LABELS);
        let is_whole = || {
            let mut values = table.sample.iter().map(|row| row[column]);
            values.all(|value| value.fract() == 0.0) && heading.unit_of(column).is_none()
        };
        let may_be = match kind {
            table::Kind::Text => is_named || heading.names.is_none() && column < table.count(),
            table::Kind::Number => is_time || is_named && is_whole(),
            table::Kind::Odd => is_time || is_named && heading.unit_of(column).is_none(),
            _ => is_time,
        };
        if !may_be {
            return false;
        }
        let different: BTreeSet<&String> = cells.iter().collect();
        different.len() <= (cells.len() / ROWS.1).max(2)
            && match is_time {
                // An empty date is refused.
                true => cells.iter().any(|cell| !cell.is_empty()),
                false => (cells.iter()).all(|cell| !cell.is_empty() && !cell.contains(':')),
            }
    };
    (0..widest).filter(is_label).collect()
}

/// The column of text under another head than [`LABELS`] that tells records apart, in whatever language: one of few words
/// without which positions repeat or go back more often than within each of its words. Remarks on rows do not.
fn dividing_column(table: &Table, bytes: &[u8], position: usize) -> Option<usize> {
    /// Rows for each word.
    const ROWS: usize = 20;
    let is_text = |&column: &usize| match table.kind(column) {
        table::Kind::Text => true,
        table::Kind::Odd => !is_of_a_rail(table, column),
        _ => false,
    };
    let columns: Vec<usize> = (0..table.count()).filter(is_text).collect();
    if columns.is_empty() {
        return None;
    }
    // Last position of each word, and steps that do not rise and that do.
    let mut last: Vec<BTreeMap<String, f64>> = vec![BTreeMap::new(); columns.len() + 1];
    let mut steps = vec![[0usize; 2]; columns.len() + 1];
    let (mut rows, mut is_whole) = (0, vec![true; columns.len() + 1]);
    for row in table::rows(bytes, table.header_lines, table.delimiter, Some(table.decimal)) {
        let Some(here) = row.value(position).filter(|here| !here.is_nan()) else {
            continue;
        };
        rows += 1;
        let words = columns.iter().map(|&column| row.text(column));
        for (index, word) in [String::new()].into_iter().chain(words).enumerate() {
            is_whole[index] &= index == 0 || !word.is_empty() && !word.contains(':');
            if last[index].len() > rows / ROWS + 2 {
                is_whole[index] = false;
            } else if let Some(before) = last[index].insert(word, here) {
                steps[index][usize::from(here > before)] += 1;
            }
        }
    }
    let against = |index: usize| steps[index][0].min(steps[index][1]);
    let mut divides = (1..=columns.len()).filter(|&index| {
        let words = last[index].len();
        let few = (2..=(rows / ROWS).max(2)).contains(&words);
        is_whole[index] && few && against(index) < against(0)
    });
    divides.next().map(|index| columns[index - 1])
}

#[cfg(test)]
mod tests;
