//! Text in columns with what axle boxes felt.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::table::{NumberColumns, Table, is_comment, is_mark};
use riffel_keys::text_file::Encoding;

use super::columns::{Content, channel_name, content, other_axes};
use super::head::{AxleBoxHead, AxleBoxLayout, Counting, Row, Signals, unreadable};
use crate::refusal::Refusal;

/// Longest line \[bytes\].
const LONGEST_LINE: u64 = 1 << 16;
/// Share by which a rate that is given may differ from that of the times.
const SAME_RATE: f64 = 0.02;

/// By how much a mark of a missing value is above all values before.
const FAR: f64 = 3.0;

/// Where in a table the readings are.
#[derive(Debug)]
pub(super) struct AxleBoxTable {
    columns: NumberColumns,
    header_lines: usize,
    /// SI units in one of each column: the channels, then the place and the time if they are read.
    units: Vec<f64>,
    channels: usize,
    has_place: bool,
    /// Largest values of the columns in the first rows.
    largest: Vec<f64>,
}

impl AxleBoxTable {
    /// Find the columns by the first bytes of a file.
    pub(super) fn find(
        head: &[u8],
        layout: &AxleBoxLayout,
    ) -> Result<(Self, AxleBoxHead), Refusal> {
        let refuse = |message: &str| Refusal::new(None, message);
        match Encoding::of(head) {
            Ok(Encoding::Utf8 | Encoding::Windows1252) => {}
            Ok(_) => return Err(refuse("the file is UTF-16; write it as UTF-8")),
            Err(byte) => return Err(Refusal::new(None, byte.to_string())),
        }
        let nothing =
            "there is no table under a head such as time_s,acceleration_m_per_s2,speed_km_per_h";
        let table = Table::find(head).ok_or_else(|| refuse(nothing))?;
        let written = table
            .heading
            .names
            .as_deref()
            .ok_or_else(|| refuse(nothing))?;
        let mut signals = Signals::default();
        let mut empty = None;
        for column in 0..written.len() {
            let found = content(&table.heading, column);
            if !table
                .kinds
                .get(column)
                .is_some_and(|kind| kind.is_numeric())
            {
                if let Ok(Some(Content::Speed(_) | Content::Odometer(_))) = found {
                    empty.get_or_insert(column);
                }
                continue;
            }
            let at_head = |message| Refusal::new(Some(table.header_lines), message);
            if let Some(content) = found.map_err(at_head)? {
                signals.push(column, content);
            }
        }
        if signals.channels.is_empty() {
            return Err(refuse(
                "there is no column of accelerations; call it acceleration_m_per_s2 or acceleration_g",
            ));
        }
        let remarks = leave_out_other_axes(&mut signals, written);
        let time = signals.time.take();
        let place = signals.place(layout.speed);
        if let Some((Some((column, _)), _)) = place {
            let missing = table
                .sample
                .iter()
                .filter(|row| row[column].is_nan())
                .count();
            empty = (2 * missing > table.sample.len()).then_some(column);
        }
        if let (Some(column), None) = (empty, layout.speed) {
            let name = &written[column];
            let message = format!(
                "column `{name}` is empty in most rows, but the place of every sample is needed: fill it in, or give the \
                 speed by --speed where it was constant"
            );
            return Err(Refusal::new(Some(table.header_lines), message));
        }
        let Some((place, by)) = place else {
            return Err(refuse(
                "there is no column of speeds or of an odometer, as speed_km_per_h or odometer_m; \
                 give the speed by --speed where it was constant",
            ));
        };
        let rate = rate(&table, time, layout.rate)?;
        let channels = signals.channels;
        let names = channels
            .iter()
            .map(|&(column, _)| channel_name(&table.heading, column));
        let head = AxleBoxHead {
            names: names.collect(),
            rate,
            place: by,
            counting: Counting::Lines,
            remarks,
        };
        let time = time.filter(|_| layout.rate.is_none());
        let all = channels.iter().copied().chain(place).chain(time);
        let (columns, units): (Vec<usize>, Vec<f64>) = all.unzip();
        let largest = columns.iter().map(|&column| {
            let values = table.sample.iter().map(|row| row[column].abs());
            values.filter(|value| !is_mark(*value)).fold(0.0, f64::max)
        });
        let read = Self {
            columns: NumberColumns::new((table.delimiter, table.decimal), &columns, &[], 0, true),
            header_lines: table.header_lines,
            largest: largest.collect(),
            units,
            channels: channels.len(),
            has_place: place.is_some(),
        };
        Ok((read, head))
    }

    /// Hand on row by row; `progress` is told of bytes done. Memory: a line.
    pub(super) fn each(
        &self,
        path: &Path,
        take: &mut dyn FnMut(&Row<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(), CaseError> {
        let failed = |reason| unreadable(path, reason);
        let file = File::open(path).map_err(failed)?;
        let mut reader = BufReader::with_capacity(1 << 20, file);
        let mut values = vec![0.0; self.units.len()];
        let mut largest = self.largest.clone();
        let mut bytes = Vec::new();
        for number in 1.. {
            bytes.clear();
            let read = reader
                .by_ref()
                .take(LONGEST_LINE)
                .read_until(b'\n', &mut bytes)
                .map_err(failed)?;
            if read == 0 {
                break;
            }
            progress(read);
            let line = bytes.strip_suffix(b"\n").unwrap_or(&bytes);
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            if number <= self.header_lines || is_comment(line) {
                continue;
            }
            let parsed = self.columns.parse_line(line, &mut values, &mut Vec::new());
            parsed.map_err(|message| Refusal::new(Some(number), message).of(path))?;
            let mut marked = None;
            for ((value, unit), largest) in values.iter_mut().zip(&self.units).zip(&mut largest) {
                if is_mark(*value) && value.abs() > FAR * *largest {
                    marked = Some(*value);
                    *value = f64::NAN;
                }
                *largest = largest.max(value.abs());
                *value *= unit;
            }
            let (accelerations, others) = values.split_at(self.channels);
            let (place, time) = others.split_at(usize::from(self.has_place));
            take(&Row {
                accelerations,
                time: time.first().copied(),
                place: place.first().copied().unwrap_or(f64::NAN),
                marked,
                number,
            })?;
        }
        Ok(())
    }
}

/// Leave out what a box felt along and across the rail; as a sentence.
fn leave_out_other_axes(signals: &mut Signals<usize>, names: &[String]) -> Vec<String> {
    let channels: Vec<&str> = signals
        .channels
        .iter()
        .map(|&(column, _)| &names[column][..])
        .collect();
    let mut others = other_axes(&channels).into_iter();
    let mut left_out = Vec::new();
    signals.channels.retain(|&(column, _)| {
        let is_other = others.next().unwrap_or(false);
        if is_other {
            left_out.push(format!("`{}`", names[column]));
        }
        !is_other
    });
    if left_out.is_empty() {
        return left_out;
    }
    vec![format!(
        "{} left out: of the axes of a box, z tells of the rail",
        left_out.join(", ")
    )]
}

/// Samples per second: those that are given, which must agree with the times, or else those of the times.
fn rate(table: &Table, time: Option<(usize, f64)>, given: Option<f64>) -> Result<f64, Refusal> {
    match (
        given,
        time.map(|(column, unit)| rate_of(table, column, unit)),
    ) {
        (None, Some(rate)) => rate,
        (Some(rate), Some(Ok(other))) if (rate / other - 1.0).abs() > SAME_RATE => {
            let message =
                format!("the times make {other} samples a second, but --rate says {rate}");
            Err(Refusal::new(Some(table.header_lines + 1), message))
        }
        (Some(rate), _) => Ok(rate),
        (None, None) => Err(Refusal::new(
            None,
            "there is no column of times, as time_s; give the sampling rate by --rate",
        )),
    }
}

/// Samples per second by the times of the first rows: the mean of the steps between rows that follow each other.
fn rate_of(table: &Table, column: usize, unit: f64) -> Result<f64, Refusal> {
    let times = table.sample.iter().map(|row| unit * row[column]);
    let times: Vec<f64> = times.filter(|time| time.is_finite()).collect();
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    let median = steps.get(steps.len() / 2).copied().unwrap_or(0.0);
    if median <= 0.0 {
        return Err(Refusal::new(
            Some(table.header_lines + 1),
            "the times do not rise from line to line; give the sampling rate by --rate",
        ));
    }
    // Rounded times have steps that differ by as much as a step; leaps are longer.
    let mean_about = |middle: f64, width: f64| {
        let like = steps
            .iter()
            .filter(|step| (**step / middle - 1.0).abs() < width);
        let (count, sum) = like.fold((0.0, 0.0), |(count, sum), step| (count + 1.0, sum + step));
        sum / count
    };
    // To nine digits, which is more than times have.
    let rate: f64 = mean_about(mean_about(median, 1.5), 0.7).recip();
    let digits = 10f64.powi(9 - rate.log10().ceil() as i32);
    Ok((rate * digits).round() / digits)
}
