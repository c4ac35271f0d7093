//! Files of axle-box acceleration over time.

use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use riffel_keys::CaseError;
use riffel_keys::text_file::Encoding;

use crate::axle_box_columns::{Content, channel_name, content};
use crate::axle_box_rows::Reader;
use crate::format::{DecimalMark, Delimiter};
use crate::refusal::Refusal;
use crate::sniff::Table;
use crate::{number, rows};

/// Bytes that are looked at first.
const HEAD: u64 = 1 << 16;
/// Longest line \[bytes\].
const LONGEST_LINE: u64 = 1 << 16;

/// What a user says of a file of axle-box acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxleBoxLayout {
    /// Samples per second \[Hz\], in place of a column of times.
    pub rate: Option<f64>,
    /// Speed of the train \[m/s\], in place of a column.
    pub speed: Option<f64>,
}

/// A table of readings, which is read as often as it is asked and never held whole.
#[derive(Debug)]
pub struct AxleBoxFile {
    path: PathBuf,
    pub(super) delimiter: Delimiter,
    pub(super) decimal: DecimalMark,
    pub(super) header_lines: usize,
    /// Column and unit of each channel.
    pub(super) channels: Vec<(usize, f64)>,
    pub(super) names: Vec<String>,
    pub(super) place: PlaceBy,
    /// Column and unit of the time, unless a rate was given.
    pub(super) time: Option<(usize, f64)>,
    pub(super) rate: f64,
}

/// How the file tells where the train is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PlaceBy {
    Odometer(usize, f64),
    Speed(usize, f64),
    /// \[m/s\].
    Constant(f64),
}

/// What comes out of a file, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AxleBoxReading<'a> {
    /// Accelerations of all channels \[m/s²\], and the position of the wheel \[m\].
    Sample(&'a [f64], f64),
    /// What comes next does not join on.
    Gap,
}

impl AxleBoxFile {
    /// Look at the head of a file: text in columns under a head that names them with their units, as
    /// `time_s,acceleration_left_m_per_s2,speed_km_per_h`, separated and with decimal marks as of a trolley's record.
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with what is missing.
    pub fn open(path: &Path, layout: AxleBoxLayout) -> Result<Self, CaseError> {
        let mut head = Vec::new();
        let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
        read.map_err(|reason| unreadable(path, reason))?;
        Self::of_head(path, &head, layout).map_err(|refusal| refusal.of(path))
    }

    fn of_head(path: &Path, head: &[u8], layout: AxleBoxLayout) -> Result<Self, Refusal> {
        let refuse = |message: String| Refusal::new(None, message);
        match Encoding::of(head) {
            Ok(Encoding::Utf8 | Encoding::Windows1252) => {}
            Ok(_) => return Err(refuse("the file is UTF-16; write it as UTF-8".to_owned())),
            Err(byte) => return Err(refuse(byte.to_string())),
        }
        let nothing =
            "there is no table under a head such as time_s,acceleration_m_per_s2,speed_km_per_h";
        let table = Table::find(head).ok_or_else(|| refuse(nothing.to_owned()))?;
        if table.heading.names.is_none() {
            return Err(refuse(nothing.to_owned()));
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
                "there is no column of accelerations; call it acceleration_m_per_s2 or acceleration_g".to_owned(),
            ));
        }
        let place = match (layout.speed, odometer, speed) {
            (Some(speed), _, _) => PlaceBy::Constant(speed),
            (None, Some((column, unit)), _) => PlaceBy::Odometer(column, unit),
            (None, None, Some((column, unit))) => PlaceBy::Speed(column, unit),
            (None, None, None) => {
                return Err(refuse(
                    "there is no column of speeds or of an odometer, as speed_km_per_h or odometer_m; \
                     give the speed by --speed where it was constant"
                        .to_owned(),
                ));
            }
        };
        let mut file = Self {
            path: path.to_owned(),
            delimiter: table.delimiter,
            decimal: table.decimal,
            header_lines: table.header_lines,
            channels,
            names,
            place,
            time: time.filter(|_| layout.rate.is_none()),
            rate: layout.rate.unwrap_or(0.0),
        };
        if let (None, Some((column, unit))) = (layout.rate, time) {
            file.rate = file.rate_of(head, column, unit)?;
        } else if layout.rate.is_none() {
            return Err(refuse(
                "there is no column of times, as time_s; give the sampling rate by --rate"
                    .to_owned(),
            ));
        }
        Ok(file)
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

    /// Names of the channels.
    pub fn channels(&self) -> &[String] {
        &self.names
    }

    /// Samples per second \[Hz\].
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// Read it all, row by row; what was found wrong and passed over, each with its first line. `progress` is told of
    /// bytes done.
    ///
    /// Gaps are where times leap, cells are empty, or a channel keeps one value for 50 ms.
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line and the rule for what is no
    /// number, a time or an odometer that falls, a speed below zero, and a channel that is clipped, in another unit than
    /// its head says, or dead; those of `visit`.
    pub fn read(
        &self,
        visit: &mut dyn FnMut(AxleBoxReading<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<Vec<String>, CaseError> {
        let failed = |reason| unreadable(&self.path, reason);
        let mut file = File::open(&self.path).map_err(failed)?;
        file.seek(SeekFrom::Start(0)).map_err(failed)?;
        let mut reader = BufReader::with_capacity(1 << 20, file);
        let mut table = Reader::new(self);
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
            let gap = table
                .row(bytes.trim_ascii_end(), line)
                .map_err(|refusal| refusal.of(&self.path))?;
            if gap {
                visit(AxleBoxReading::Gap)?;
            }
            if table.is_there {
                visit(AxleBoxReading::Sample(&table.accelerations, table.position))?;
            }
        }
        table.finish().map_err(|refusal| refusal.of(&self.path))
    }
}

fn unreadable(path: &Path, reason: std::io::Error) -> CaseError {
    CaseError::Read {
        what: "file",
        path: path.to_owned(),
        reason,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows at 1 kHz of a channel that never keeps its value; `change` may alter time, acceleration and speed of a row.
    fn table(head: &str, change: impl Fn(usize, &mut [f64; 3])) -> String {
        let rows = (0..2000).map(|row| {
            let noise = ((row * 7919) % 1000) as f64 / 100.0 - 5.0;
            let mut values = [1e-3 * row as f64, noise, 72.0];
            change(row, &mut values);
            let [time, acceleration, speed] = values;
            format!("{time:.3};{acceleration};{speed}\n")
        });
        format!("{head}\n{}", rows.collect::<String>())
    }

    const HEAD: &str = "time_s;acceleration_left_m_per_s2;speed_km_per_h";

    /// Samples, gaps, last position and remarks of a table.
    fn read(text: &str, layout: AxleBoxLayout) -> Result<(usize, usize, f64, Vec<String>), String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        std::fs::write(&path, text).unwrap();
        let shown = |error: CaseError| error.to_string();
        let file = AxleBoxFile::open(&path, layout).map_err(shown)?;
        let (mut samples, mut gaps, mut last) = (0, 0, 0.0);
        let mut visit = |reading: AxleBoxReading<'_>| {
            match reading {
                AxleBoxReading::Sample(_, position) => (samples, last) = (samples + 1, position),
                AxleBoxReading::Gap => gaps += 1,
            }
            Ok(())
        };
        let remarks = file.read(&mut visit, &|_| ()).map_err(shown)?;
        assert_eq!(file.channels(), ["left"]);
        assert!((file.rate() - 1000.0).abs() < 1e-6, "{}", file.rate());
        Ok((samples, gaps, last, remarks))
    }

    #[test]
    fn a_run_is_read() {
        let (samples, gaps, last, remarks) =
            read(&table(HEAD, |_, _| ()), AxleBoxLayout::default()).unwrap();
        assert_eq!((samples, gaps), (2000, 0));
        assert!((last - 40.0).abs() < 1e-6, "{last}");
        assert!(remarks.is_empty(), "{remarks:?}");
        let commas = table(HEAD, |_, _| ()).replace('.', ",");
        assert_eq!(read(&commas, AxleBoxLayout::default()).unwrap().0, 2000);
        let odometer = "time_s;acceleration_left_g;odometer_m";
        let along = table(odometer, |row, values| {
            values[2] = 12_000.0 + 0.02 * row as f64
        });
        let (_, _, last, _) = read(&along, AxleBoxLayout::default()).unwrap();
        assert!((last - 12_039.98).abs() < 1e-6);
    }

    #[test]
    fn gaps_are_said_and_passed_over() {
        let leaping = table(HEAD, |row, values| {
            values[0] += if row > 500 { 1.0 } else { 0.0 };
        });
        let (samples, gaps, _, remarks) = read(&leaping, AxleBoxLayout::default()).unwrap();
        assert_eq!((samples, gaps), (2000, 1));
        assert!(
            remarks[0].contains("leaps once, at line 503"),
            "{remarks:?}"
        );
        let dead = table(HEAD, |row, values| {
            if (800..1000).contains(&row) {
                values[1] = 0.123;
            }
        });
        let (samples, gaps, _, remarks) = read(&dead, AxleBoxLayout::default()).unwrap();
        assert_eq!((samples, gaps), (1850, 1));
        assert!(remarks[0].contains("drops out once"), "{remarks:?}");
        assert!(remarks[0].contains("line 802"), "{remarks:?}");
    }

    #[test]
    fn what_is_wrong_is_refused_with_its_line() {
        let plain = AxleBoxLayout::default();
        for (text, part) in [
            (
                table(HEAD, |row, values| values[2] = 50.0 - 0.1 * row as f64),
                "line 503: the speed is",
            ),
            (
                table(HEAD, |row, values| {
                    values[0] -= if row > 99 { 0.05 } else { 0.0 }
                }),
                "line 102: the time falls",
            ),
            (
                table(
                    "time_s;acceleration_left_m_per_s2;odometer_m",
                    |row, values| {
                        values[2] = 100.0 - 0.02 * row as f64;
                    },
                ),
                "line 3: the odometer falls",
            ),
            (
                table(HEAD, |_, values| values[1] = values[1].min(3.0)),
                "clipped at 3.0000 m/s² in",
            ),
            (
                table(HEAD, |_, values| values[1] = 0.01 * values[1] + 1.0),
                "as gravity is in g",
            ),
            (
                table("time_s;acceleration_left_g;speed_km_per_h", |_, values| {
                    values[1] = 0.01 * values[1] + 9.81;
                }),
                "as gravity is in m/s²",
            ),
            (
                table("time_s;acceleration_left;speed_km_per_h", |_, _| ()),
                "has no unit",
            ),
            (
                table("time_s;acceleration_left_g;temperature", |_, _| ()),
                "no column of speeds",
            ),
            (
                table("row;acceleration_left_g;speed_m_per_s", |_, _| ()),
                "no column of times",
            ),
            ("1;2;3\n4;5;6\n".to_owned(), "under a head"),
        ] {
            let refusal = read(&text, plain).unwrap_err();
            assert!(refusal.contains(part), "{refusal}");
        }
    }
}
