//! Text in columns with what axle boxes felt.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::text_file::Encoding;

use crate::axle_box_columns::{Content, channel_name, content};
use crate::axle_box_file::{AxleBoxHead, AxleBoxLayout, PlaceBy, unreadable};
use crate::axle_box_listener::{Counting, Row};
use crate::format::{DecimalMark, Delimiter};
use crate::refusal::Refusal;
use crate::sniff::Table;
use crate::{number, rows};

/// Longest line \[bytes\].
const LONGEST_LINE: u64 = 1 << 16;
/// Share by which a rate that is given may differ from that of the times.
const SAME_RATE: f64 = 0.02;

/// Where in a table the readings are.
#[derive(Debug)]
pub(super) struct AxleBoxTable {
    delimiter: Delimiter,
    decimal: DecimalMark,
    header_lines: usize,
    /// Column and unit of each channel.
    channels: Vec<(usize, f64)>,
    /// Column and unit of the speed or the odometer, unless the speed is constant.
    place: Option<(usize, f64)>,
    /// Column and unit of the time, unless a rate was given.
    time: Option<(usize, f64)>,
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
        if table.heading.names.is_none() {
            return Err(refuse(nothing));
        }
        let (mut channels, mut names) = (Vec::new(), Vec::new());
        let (mut speed, mut odometer, mut time) = (None, None, None);
        for column in (0..table.count).filter(|&column| table.numeric[column]) {
            let found = content(&table.heading, column)
                .map_err(|message| Refusal::new(Some(table.header_lines), message))?;
            match found {
                Some(Content::Acceleration(unit)) => {
                    channels.push((column, unit));
                    names.push(channel_name(&table.heading, column));
                }
                Some(Content::Speed(unit)) => speed = speed.or(Some((column, unit))),
                Some(Content::Odometer(unit)) => odometer = odometer.or(Some((column, unit))),
                Some(Content::Time(unit)) => time = time.or(Some((column, unit))),
                None => {}
            }
        }
        if channels.is_empty() {
            return Err(refuse(
                "there is no column of accelerations; call it acceleration_m_per_s2 or acceleration_g",
            ));
        }
        let (place, by) = match (layout.speed, odometer, speed) {
            (Some(speed), _, _) => (None, PlaceBy::Constant(speed)),
            (None, Some(odometer), _) => (Some(odometer), PlaceBy::Odometer),
            (None, None, Some(speed)) => (Some(speed), PlaceBy::Speed),
            (None, None, None) => {
                return Err(refuse(
                    "there is no column of speeds or of an odometer, as speed_km_per_h or odometer_m; \
                     give the speed by --speed where it was constant",
                ));
            }
        };
        let table = Self {
            delimiter: table.delimiter,
            decimal: table.decimal,
            header_lines: table.header_lines,
            channels,
            place,
            time: time.filter(|_| layout.rate.is_none()),
        };
        let by_times = time.map(|(column, unit)| table.rate_of(head, column, unit));
        let rate = match (layout.rate, by_times) {
            (None, Some(rate)) => rate?,
            (Some(rate), Some(Ok(other))) if (rate / other - 1.0).abs() > SAME_RATE => {
                let message =
                    format!("the times make {other} samples a second, but --rate says {rate}");
                return Err(Refusal::new(Some(table.header_lines + 1), message));
            }
            (Some(rate), _) => rate,
            (None, None) => {
                return Err(refuse(
                    "there is no column of times, as time_s; give the sampling rate by --rate",
                ));
            }
        };
        let head = AxleBoxHead {
            names,
            rate,
            place: by,
            counting: Counting::Lines,
        };
        Ok((table, head))
    }

    /// Samples per second by the times in the head of the file: the median of their steps.
    fn rate_of(&self, head: &[u8], column: usize, unit: f64) -> Result<f64, Refusal> {
        let lines = rows::lines(head).skip(self.header_lines);
        let times = lines
            .filter(|line| !rows::is_comment(line))
            .filter_map(|line| {
                let cells = rows::cells(line, self.delimiter);
                number::parse(cells.get(column)?, self.decimal.byte())
            });
        let times: Vec<f64> = times.filter(|time| time.is_finite()).collect();
        // The last line of the head may be cut.
        let whole = &times[..times.len().saturating_sub(1)];
        let mut steps: Vec<f64> = whole
            .windows(2)
            .map(|pair| unit * (pair[1] - pair[0]))
            .collect();
        steps.sort_by(f64::total_cmp);
        let median = steps.get(steps.len() / 2).copied().unwrap_or(0.0);
        if median <= 0.0 {
            return Err(Refusal::new(
                Some(self.header_lines + 1),
                "the times do not rise from line to line; give the sampling rate by --rate",
            ));
        }
        // The mean of the steps that are like it: times are rounded.
        let like = steps
            .iter()
            .filter(|step| (**step / median - 1.0).abs() < 0.5);
        let (count, sum) = like.fold((0.0, 0.0), |(count, sum), step| (count + 1.0, sum + step));
        // To nine digits, which is more than times have.
        let rate: f64 = count / sum;
        let digits = 10f64.powi(9 - rate.log10().ceil() as i32);
        Ok((rate * digits).round() / digits)
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
        let mut accelerations = vec![0.0; self.channels.len()];
        let mut bytes = Vec::new();
        for line in 1.. {
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
            if line <= self.header_lines || rows::is_comment(bytes.trim_ascii_end()) {
                continue;
            }
            let row = self.row(bytes.trim_ascii_end(), line, &mut accelerations);
            take(&row.map_err(|refusal| refusal.of(path))?)?;
        }
        Ok(())
    }

    fn row<'a>(
        &self,
        bytes: &[u8],
        line: usize,
        accelerations: &'a mut [f64],
    ) -> Result<Row<'a>, Refusal> {
        let cells = rows::cells(bytes, self.delimiter);
        let decimal = self.decimal.byte();
        let value = |(column, unit): (usize, f64)| {
            let cell = cells.get(column).ok_or_else(|| {
                let message = format!("has {} columns, but its head has more", cells.len());
                Refusal::new(Some(line), message)
            })?;
            if cell.is_empty() {
                return Ok(f64::NAN);
            }
            number::parse(cell, decimal)
                .map(|value| unit * value)
                .ok_or_else(|| {
                    let shown = String::from_utf8_lossy(cell);
                    let message = format!("column {} is \"{shown}\", not a number", column + 1);
                    Refusal::new(Some(line), message)
                })
        };
        for (acceleration, &channel) in accelerations.iter_mut().zip(&self.channels) {
            *acceleration = value(channel)?;
        }
        Ok(Row {
            accelerations,
            time: self.time.map(value).transpose()?,
            place: self.place.map(value).transpose()?.unwrap_or(f64::NAN),
            number: line,
        })
    }
}
