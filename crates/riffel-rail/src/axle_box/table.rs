//! Text in columns with what axle boxes felt.

use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use riffel_keys::table::{NumberColumns, Table, clock, is_comment, is_mark, rows};
use riffel_keys::text_file::Encoding;
use riffel_keys::{CaseError, Message, say, seal};

use super::clock::{Clock, Midnights, Regression};
use super::columns::{Content, channel_name, content};
use super::head::{AxleBoxHead, AxleBoxLayout, Counting, Places, Row, Signals, unreadable};
use crate::profile_columns::left_out_sentence;
use crate::refusal::Refusal;

/// Longest line \[bytes\].
const LONGEST_LINE: u64 = 1 << 16;
/// Share by which a rate that is given may differ from that of the times, and share from which it is said.
const SAME_RATE: (f64, f64) = (0.02, 1e-3);

/// By how much a mark of a missing value is above all values before.
const FAR: f64 = 3.0;

/// Where in a table the readings are.
#[derive(Debug)]
pub(super) struct AxleBoxTable {
    columns: NumberColumns,
    header_lines: usize,
    /// SI units in one of each column: the channels, then place, witness and time if they are read.
    units: Vec<f64>,
    channels: usize,
    has_place: bool,
    has_witness: bool,
    /// Whether times are those of day.
    has_clock: bool,
    /// Largest values of the columns in the first rows.
    largest: Vec<f64>,
}

impl AxleBoxTable {
    /// Find the columns by the first bytes of a file, and the sampling rate by all of its times.
    pub(super) fn find(path: &Path, head: &[u8], layout: &AxleBoxLayout) -> Result<(Self, AxleBoxHead), CaseError> {
        let found = Self::columns(head, layout).map_err(|refusal| refusal.of(path));
        let (table, signals, places, has_clock, mut remarks) = found?;
        let style = (table.delimiter, table.decimal);
        let clock = match signals.time {
            Some((column, unit)) => {
                let first = match has_clock {
                    true => clocks(&table, head, column),
                    false => (table.sample.iter()).map(|row| unit * row[column]).collect(),
                };
                let first: Vec<f64> = first.into_iter().filter(|time| time.is_finite()).collect();
                let mut columns = NumberColumns::new(style, &[column], &[], 0, true);
                let mut midnights = None;
                if has_clock {
                    columns = columns.with_clock(column);
                    midnights = Some(Midnights::default());
                }
                let regression = Clock::of(&first).map(Regression::new);
                let found = regression.map(|mut regression| {
                    let mut take = |_: usize, times: &mut [f64]| {
                        let time = unit * times[0];
                        let time = midnights.as_mut().map_or(time, |them| them.after(time));
                        regression.add(time);
                        Ok(())
                    };
                    each_row(path, table.header_lines, &columns, 1, &mut take, &|_| ())?;
                    Ok(regression.finish())
                });
                found.transpose()?
            }
            None => None,
        };
        let at = signals.time.map(|_| table.header_lines + 1);
        let rate = rate(clock, at, layout.rate, &mut remarks);
        let (rate, clock) = rate.map_err(|refusal| refusal.of(path))?;
        let channels = signals.channels;
        let names = channels.iter().map(|&(column, _)| channel_name(&table.heading, column));
        let head = AxleBoxHead {
            names: names.collect(),
            rate,
            clock,
            place: places.by,
            witness: places.witness_by,
            counting: Counting::Lines,
            remarks,
        };
        let time = signals.time.filter(|_| clock.is_some());
        let all = channels.iter().copied();
        let all = all.chain(places.signal).chain(places.witness).chain(time);
        let (columns, units): (Vec<usize>, Vec<f64>) = all.unzip();
        let is_clock = |column: usize| has_clock && time.is_some_and(|(time, _)| time == column);
        let largest = columns.iter().map(|&column| {
            if is_clock(column) {
                return f64::INFINITY;
            }
            // Text behind the last numbers has no sample, and is refused.
            let values = table.sample.iter().filter_map(|row| row.get(column));
            let values = values.map(|value| value.abs());
            values.filter(|value| !is_mark(*value)).fold(0.0, f64::max)
        });
        let largest = largest.collect();
        let clock = time.map(|(time, _)| time).filter(|_| has_clock);
        let columns = NumberColumns::new(style, &columns, &[], 0, true);
        let read = Self {
            columns: match clock {
                Some(place) => columns.with_clock(place),
                None => columns,
            },
            header_lines: table.header_lines,
            largest,
            units,
            has_clock: clock.is_some(),
            channels: channels.len(),
            has_place: places.signal.is_some(),
            has_witness: places.witness.is_some(),
        };
        Ok((read, head))
    }

    /// The table, where in it what is, and what is to be said of that.
    fn columns(head: &[u8], layout: &AxleBoxLayout) -> Result<Found, Refusal> {
        let refuse = |message: Message| Refusal::new(None, message);
        match Encoding::of(head) {
            Ok(Encoding::Utf8 | Encoding::Windows1252) => {}
            Ok(other) => {
                return Err(refuse(say!(file_of_other_encoding, encoding = other.name())));
            }
            Err(byte) => return Err(refuse(byte.into())),
        }
        const EXAMPLE: &str = "time_s,acceleration_m_per_s2,speed_km_per_h";
        let nothing = || refuse(say!(no_table_under_a_head, example = EXAMPLE));
        let table = Table::find(head).ok_or_else(nothing)?;
        let written = table.heading.names.as_deref().ok_or_else(nothing)?;
        let mut signals = Signals::default();
        let (mut empty, mut clocks, mut others) = (None, Vec::new(), Vec::new());
        let mut leave_out = |column: usize, why: Message| {
            others.push(left_out_sentence(column, &written[column], why));
        };
        for column in 0..written.len() {
            let kind = table.kind(column);
            let has_values = has_values(&table, head, column);
            let at_head = |message| Refusal::new(Some(table.header_lines), message);
            let first = first_value(&table, head, column);
            if !kind.is_numeric() && first.is_some_and(|(_, cell)| clock(cell.as_bytes()).is_some()) {
                clocks.push(column);
                continue;
            }
            match content(&table.heading, column) {
                Ok(Some(Content::Time(_))) if !kind.is_numeric() => {
                    if layout.rate.is_none() {
                        return Err(no_times(&table, head, column));
                    }
                    leave_out(column, say!(it_is_text));
                }
                Ok(Some(Content::Speed(_) | Content::Odometer(_))) if !has_values => {
                    empty.get_or_insert(column);
                }
                Ok(Some(_)) if !has_values => leave_out(column, say!(it_is_empty)),
                Ok(Some(content)) => signals.push(column, content),
                Err(message) if kind.is_of_numbers() => return Err(at_head(message)),
                Ok(None) if table.is_index(column) => leave_out(column, say!(it_numbers_the_rows)),
                _ if has_values && kind.is_of_numbers() => leave_out(column, say!(it_is_no_signal)),
                _ if has_values => leave_out(column, say!(it_is_text)),
                _ => leave_out(column, say!(it_is_empty)),
            }
        }
        let has_clock = signals.time.is_none() && !clocks.is_empty();
        for column in clocks {
            match signals.time {
                None => signals.push(column, Content::Time(1.0)),
                Some(_) => leave_out(column, say!(it_is_second)),
            }
        }
        if signals.channels.is_empty() {
            let nothing = say!(no_column_of_accelerations, one = "acceleration_m_per_s2", other = "acceleration_g");
            let said = others.into_iter().fold(nothing, Message::followed_by);
            return Err(refuse(said));
        }
        let is_of_clock = |column: &usize| {
            let cell = first_value(&table, head, *column).map(|(_, cell)| cell);
            !table.kind(*column).is_numeric() && cell.is_some_and(|cell| cell.contains(':'))
        };
        if signals.time.is_none()
            && layout.rate.is_none()
            && let Some(column) = (0..written.len()).find(is_of_clock)
        {
            return Err(no_times(&table, head, column));
        }
        let remarks = signals.leave_out_others(|&column| written[column].clone());
        let at_head = |message| Refusal::new(Some(table.header_lines), message);
        let mut remarks = remarks.map_err(at_head)?;
        remarks.append(&mut others);
        let name = |&column: &usize| written[column].clone();
        let places = signals.place(layout.speed, name, &mut remarks);
        if let Some(Places { signal: Some((column, _)), .. }) = places {
            let missing = table.sample.iter().filter(|row| row.get(column).is_none_or(|value| value.is_nan())).count();
            // What is there and no number is refused with its line.
            let is_empty = table.kind(column).is_numeric() && 2 * missing > table.sample.len();
            empty = is_empty.then_some(column);
        }
        if let (Some(column), None) = (empty, layout.speed) {
            return Err(at_head(say!(place_is_empty, name = &written[column])));
        }
        let Some(places) = places else {
            return Err(refuse(say!(no_column_of_the_place)));
        };
        Ok((table, signals, places, has_clock, remarks))
    }

    /// Hand on row by row; `progress` is told of bytes done. Memory: a line.
    pub(super) fn each(
        &self,
        path: &Path,
        take: &mut dyn FnMut(&Row<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(), CaseError> {
        let mut largest = self.largest.clone();
        let mut midnights = Midnights::default();
        let mut row = |number: usize, values: &mut [f64]| {
            let mut marked = None;
            for ((value, unit), largest) in values.iter_mut().zip(&self.units).zip(&mut largest) {
                if is_mark(*value) && value.abs() > FAR * *largest {
                    marked = Some(*value);
                    *value = f64::NAN;
                }
                *largest = largest.max(value.abs());
                *value *= unit;
            }
            if let (true, Some(time)) = (self.has_clock, values.last_mut()) {
                *time = midnights.after(*time);
            }
            let (accelerations, others) = values.split_at(self.channels);
            let mut others = others.iter().copied();
            let mut next = |there: bool| there.then(|| others.next()).flatten();
            take(&Row {
                accelerations,
                place: next(self.has_place).unwrap_or(f64::NAN),
                witness: next(self.has_witness).unwrap_or(f64::NAN),
                time: next(true),
                marked,
                number,
            })
        };
        let (header, width) = (self.header_lines, self.units.len());
        each_row(path, header, &self.columns, width, &mut row, progress)
    }
}

/// A table, where in it what is, whether its times are those of day, and what is to be said of that.
type Found = (Table, Signals<usize>, Places<usize>, bool, Vec<Message>);

/// What takes the line and the numbers of a row.
type TakeRow<'a> = dyn FnMut(usize, &mut [f64]) -> Result<(), CaseError> + 'a;

/// Hand on the numbers of each row of some columns with its line; `progress` is told of bytes done. Memory: a line.
fn each_row(
    path: &Path,
    header_lines: usize,
    columns: &NumberColumns,
    width: usize,
    take: &mut TakeRow<'_>,
    progress: &dyn Fn(usize),
) -> Result<(), CaseError> {
    let failed = |reason| unreadable(path, reason);
    let file = seal::open(path).map_err(failed)?;
    let mut reader = BufReader::with_capacity(1 << 20, file);
    let mut values = vec![0.0; width];
    let mut bytes = Vec::new();
    for number in 1.. {
        bytes.clear();
        let read = reader.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut bytes).map_err(failed)?;
        if read == 0 {
            break;
        }
        let refuse = |message: Message| Refusal::new(Some(number), message).of(path);
        if read as u64 == LONGEST_LINE && !bytes.ends_with(b"\n") {
            return Err(refuse(say!(line_is_too_long, most = LONGEST_LINE)));
        }
        progress(read);
        let line = bytes.strip_suffix(b"\n").unwrap_or(&bytes);
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if number <= header_lines || is_comment(line) {
            continue;
        }
        let parsed = columns.parse_line(line, &mut values, &mut Vec::new());
        parsed.map_err(refuse)?;
        take(number, &mut values)?;
    }
    Ok(())
}

/// Whether any of the first rows has more than marks of missing values in a column.
fn has_values(table: &Table, head: &[u8], column: usize) -> bool {
    first_value(table, head, column).is_some()
}

/// The first row with more than a mark of a missing value in a column: its line and its cell.
fn first_value(table: &Table, head: &[u8], column: usize) -> Option<(usize, String)> {
    let style = (table.delimiter, Some(table.decimal));
    rows(head, table.header_lines, style.0, style.1)
        .filter(|row| column < row.cells.len() && !row.value(column).is_some_and(f64::is_nan))
        .map(|row| (row.line, row.text(column)))
        .next()
}

/// The times of day of a column in the first rows \[s\].
fn clocks(table: &Table, head: &[u8], column: usize) -> Vec<f64> {
    let style = (table.delimiter, Some(table.decimal));
    let rows = rows(head, table.header_lines, style.0, style.1);
    let mut midnights = Midnights::default();
    let times = rows.filter_map(|row| clock(row.cells.get(column)?));
    times.map(|time| midnights.after(time)).collect()
}

/// That a column of times holds none.
fn no_times(table: &Table, head: &[u8], column: usize) -> Refusal {
    let name = table.heading.name(column).unwrap_or_default();
    let (line, cell) = first_value(table, head, column).unwrap_or((table.header_lines + 1, String::new()));
    let text = say!(times_are_text, column = column + 1, name, cell);
    Refusal::new(Some(line), text)
}

/// Samples per second: those that are given, which must agree with the times, or else those of the times; with the clock of
/// the times. `at` is the first line with a time.
fn rate(
    clock: Option<Result<(Clock, Option<Message>), Message>>,
    at: Option<usize>,
    given: Option<f64>,
    remarks: &mut Vec<Message>,
) -> Result<(f64, Option<Clock>), Refusal> {
    let (clock, given) = match (clock, given) {
        (Some(Ok((clock, drift))), given) => {
            remarks.extend(drift);
            (clock, given)
        }
        (_, Some(rate)) => return Ok((rate, None)),
        (Some(Err(message)), None) => return Err(Refusal::new(at, message)),
        (None, None) => {
            let message = match at {
                Some(_) => say!(times_do_not_rise),
                None => say!(no_column_of_times),
            };
            return Err(Refusal::new(at, message));
        }
    };
    let Some(rate) = given else {
        return Ok((clock.rate, Some(clock)));
    };
    let off = (rate / clock.rate - 1.0).abs();
    let contrary = say!(times_make_another_rate, rate = clock.rate, given = rate);
    if off > SAME_RATE.0 {
        return Err(Refusal::new(at, contrary));
    }
    if off > SAME_RATE.1 {
        remarks.push(say!(given_rate_is_taken, sentence = contrary));
    }
    Ok((rate, Some(clock)))
}
