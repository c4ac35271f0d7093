//! Files of axle-box acceleration over time.

use std::io::Read;
use std::path::{Path, PathBuf};

use riffel_keys::{CaseError, Message, say, seal, text_file};

use super::arrays::{AxleBoxArrays, AxleBoxPlace};
use super::head::{AxleBoxHead, AxleBoxLayout, Counting, Row, unreadable};
use super::listener::Listener;
use super::run_end::RunEnd;
use super::table::AxleBoxTable;
use super::universal::{AxleBoxUniversal, is_universal};
use super::wave::{AxleBoxWave, is_wave};
use crate::no_rail::filter_remark;

/// Bytes that are looked at first: one more than a table is found by, so that it knows of a line cut in two.
const HEAD: u64 = (1 << 16) + 1;

/// A run of readings, which is read as often as it is asked and never held whole.
#[derive(Debug)]
pub struct AxleBoxFile {
    path: PathBuf,
    head: AxleBoxHead,
    source: Source,
}

#[derive(Debug)]
enum Source {
    Table(AxleBoxTable),
    Wave(AxleBoxWave),
    Universal(Box<AxleBoxUniversal>),
    Arrays(AxleBoxArrays),
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
    /// Look at the head of a file, which is told by its first bytes:
    ///
    /// * text in columns under a head that names them with their units, as
    ///   `time_s,acceleration_left_m_per_s2,speed_km_per_h`, separated and with decimal marks as of a trolley's record;
    /// * WAV, of which the layout names the channels;
    /// * a universal file with accelerations over time, and speed or odometer as signals of their own (dataset 58, as text
    ///   or binary).
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with what is missing, two channels of one name, or
    /// channels named of what is no WAV file.
    pub fn open(path: &Path, layout: &AxleBoxLayout) -> Result<Self, CaseError> {
        let mut head = Vec::new();
        let read = text_file::check_is_read_twice(path)
            .and_then(|()| seal::open(path))
            .and_then(|file| file.take(HEAD).read_to_end(&mut head));
        read.map_err(|reason| unreadable(path, reason))?;
        if !layout.channels.is_empty() && !is_wave(&head) {
            return Err(CaseError::data(path, say!(channels_are_for_wav)));
        }
        let (source, head) = if is_wave(&head) {
            let (wave, head) = AxleBoxWave::find(path, layout)?;
            (Source::Wave(wave), head)
        } else if is_universal(&head) {
            let (file, head) = AxleBoxUniversal::find(path, layout)?;
            (Source::Universal(Box::new(file)), head)
        } else {
            let (table, head) = AxleBoxTable::find(path, &head, layout)?;
            (Source::Table(table), head)
        };
        Self::checked(path.to_owned(), head, source)
    }

    /// A run that is there as arrays: channels by name with their accelerations \[m/s²\], and samples per second \[Hz\].
    ///
    /// # Errors
    /// [`CaseError::Data`] unless every array has a value for each sample and every name is another.
    pub fn of_arrays(
        name: &str,
        channels: Vec<(String, Vec<f64>)>,
        rate: f64,
        place: AxleBoxPlace,
    ) -> Result<Self, CaseError> {
        let path = PathBuf::from(name);
        let refuse = |message: Message| Err(CaseError::data(&path, message));
        let (names, channels): (Vec<_>, Vec<_>) = channels.into_iter().unzip();
        let Some(count) = channels.first().map(Vec::len).filter(|count| *count > 0) else {
            return refuse(say!(no_acceleration_given));
        };
        for (name, values) in names.iter().zip(&channels) {
            if values.len() != count {
                return refuse(say!(
                    lengths_of_arrays_differ,
                    name,
                    count = values.len(),
                    first = &names[0],
                    other = count
                ));
            }
        }
        if let Some(values) = place.values().filter(|values| values.len() != count) {
            return refuse(say!(place_of_other_length, count = values.len(), first = &names[0], other = count));
        }
        let head = AxleBoxHead {
            names,
            rate,
            clock: None,
            place: place.by(),
            witness: None,
            counting: Counting::Samples,
            remarks: Vec::new(),
        };
        Self::checked(path, head, Source::Arrays(AxleBoxArrays { channels, place }))
    }

    fn checked(path: PathBuf, mut head: AxleBoxHead, source: Source) -> Result<Self, CaseError> {
        for (index, name) in head.names.iter().enumerate() {
            if head.names[..index].contains(name) {
                let two = say!(two_channels_of_one_name, name);
                return Err(CaseError::data(&path, two));
            }
        }
        let filtered = head.names.iter();
        let filtered = filtered.filter_map(|name| filter_remark(name, format!("\"{name}\"").into()));
        head.remarks.extend(filtered);
        Ok(Self { path, head, source })
    }

    /// Names of the channels.
    pub fn channels(&self) -> &[String] {
        &self.head.names
    }

    /// Samples per second \[Hz\].
    pub fn rate(&self) -> f64 {
        self.head.rate
    }

    /// Read it all, reading by reading; what was found wrong and passed over, each with where it is first. `progress` is told
    /// of bytes done, of arrays of samples.
    ///
    /// Gaps are where times or odometer leap, values are missing, or a channel keeps one value for 50 ms. Positions without an
    /// odometer begin at zero, or go on where the file before of the same channels ended if the times go on.
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line or the sample and the rule for what
    /// is no number, a time or an odometer that falls, a speed below zero or above any train's, and a channel that is
    /// clipped, in another unit than its head says, or dead; those of `visit`.
    pub fn read(
        &self,
        before: Option<RunEnd>,
        visit: &mut dyn FnMut(AxleBoxReading<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(Vec<Message>, RunEnd), CaseError> {
        let mut listener = Listener::new(&self.head, before);
        let mut take = |row: &Row<'_>| {
            let gap = listener.row(row);
            if gap.map_err(|refusal| refusal.of(&self.path))? {
                visit(AxleBoxReading::Gap)?;
            }
            if listener.is_there {
                visit(AxleBoxReading::Sample(row.accelerations, listener.position))?;
            }
            Ok(())
        };
        match &self.source {
            Source::Table(table) => table.each(&self.path, &mut take, progress)?,
            Source::Wave(wave) => wave.each(&self.path, &mut take, progress)?,
            Source::Universal(file) => file.each(&self.path, &mut take, progress)?,
            Source::Arrays(arrays) => arrays.each(&mut take, progress)?,
        }
        let end = listener.end();
        let remarks = listener.finish().map_err(|refusal| refusal.of(&self.path))?;
        Ok((remarks, end))
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
    fn read(text: &str, layout: &AxleBoxLayout) -> Result<(usize, usize, f64, Vec<String>), String> {
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
        let (remarks, _) = file.read(None, &mut visit, &|_| ()).map_err(shown)?;
        assert_eq!(file.channels(), ["left"]);
        assert!((file.rate() - 1000.0).abs() < 1e-6, "{}", file.rate());
        let remarks = remarks.iter().map(ToString::to_string).collect();
        Ok((samples, gaps, last, remarks))
    }

    #[test]
    fn a_run_is_read() {
        let (samples, gaps, last, remarks) = read(&table(HEAD, |_, _| ()), &AxleBoxLayout::default()).unwrap();
        assert_eq!((samples, gaps), (2000, 0));
        assert!((last - 40.0).abs() < 1e-6, "{last}");
        assert!(remarks.is_empty(), "{remarks:?}");
        let commas = table(HEAD, |_, _| ()).replace('.', ",");
        assert_eq!(read(&commas, &AxleBoxLayout::default()).unwrap().0, 2000);
        let odometer = "time_s;acceleration_left_g;odometer_m";
        let along = table(odometer, |row, values| values[2] = 12_000.0 + 0.02 * row as f64);
        let (_, _, last, _) = read(&along, &AxleBoxLayout::default()).unwrap();
        assert!((last - 12_039.98).abs() < 1e-6);
    }

    /// A run in two files is one line; what does not go on in time is another run, and that is said.
    #[test]
    fn a_file_goes_on_where_the_one_before_ended() {
        let folder = tempfile::tempdir().unwrap();
        let read = |from: f64, before: Option<RunEnd>| {
            let path = folder.path().join("run.csv");
            std::fs::write(&path, table(HEAD, |_, values| values[0] += from)).unwrap();
            let file = AxleBoxFile::open(&path, &AxleBoxLayout::default()).unwrap();
            let mut first = None;
            let mut visit = |reading: AxleBoxReading<'_>| {
                if let AxleBoxReading::Sample(_, position) = reading {
                    first.get_or_insert(position);
                }
                Ok(())
            };
            let (remarks, end) = file.read(before, &mut visit, &|_| ()).unwrap();
            let said = Message::one_after_other(remarks).map(|said| said.to_string());
            (first.unwrap(), end, said.unwrap_or_default())
        };
        let (_, end, _) = read(0.0, None);
        assert!((end.position - 40.0).abs() < 1e-6 && end.time == Some(1.999), "{end:?}");
        let (first, last, said) = read(2.5, Some(end));
        // Half a second at 20 m/s between them.
        assert!((first - 50.04).abs() < 1e-6 && (last.position - 90.02).abs() < 1e-2, "{first} {last:?}");
        assert!(said.is_empty(), "{said}");
        let (first, _, said) = read(0.0, Some(end));
        assert!(first < 0.1 && said.contains("another run from the same place"), "{first} {said}");
    }

    #[test]
    fn gaps_are_said_and_passed_over() {
        let leaping = table(HEAD, |row, values| {
            values[0] += if row > 500 { 1.0 } else { 0.0 };
        });
        let (samples, gaps, _, remarks) = read(&leaping, &AxleBoxLayout::default()).unwrap();
        assert_eq!((samples, gaps), (2000, 1));
        assert!(remarks[0].contains("leaps once, at line 503"), "{remarks:?}");
        let dead = table(HEAD, |row, values| {
            if (800..1000).contains(&row) {
                values[1] = 0.123;
            }
        });
        let (samples, gaps, _, remarks) = read(&dead, &AxleBoxLayout::default()).unwrap();
        assert_eq!((samples, gaps), (1850, 1));
        assert!(remarks[0].contains("drops out once"), "{remarks:?}");
        assert!(remarks[0].contains("line 802"), "{remarks:?}");
        let silent = table(HEAD, |_, values| values[1] = 0.0);
        let (.., remarks) = read(&silent, &AxleBoxLayout::default()).unwrap();
        // It drops out, and is not clipped.
        assert!(remarks[0].contains("drops out once") && remarks.len() == 1, "{remarks:?}");
    }

    #[test]
    fn what_is_wrong_is_refused_with_its_line() {
        let plain = &AxleBoxLayout::default();
        for (text, part) in [
            (table(HEAD, |row, values| values[2] = 50.0 - 0.1 * row as f64), "line 503: the speed is"),
            (table(HEAD, |row, values| values[0] -= if row > 99 { 0.05 } else { 0.0 }), "line 102: the time falls"),
            (
                table("time_s;acceleration_left_m_per_s2;odometer_m", |row, values| {
                    values[2] = 100.0 - 0.02 * row as f64;
                }),
                "line 3: the odometer falls",
            ),
            (table(HEAD, |_, values| values[1] = values[1].min(3.0)), "clipped at 3.0000 m/s² in"),
            (table(HEAD, |_, values| values[1] = 0.01 * values[1] + 1.0), "as gravity is in g"),
            (
                table("time_s;acceleration_left_g;speed_km_per_h", |_, values| {
                    values[1] = 0.01 * values[1] + 9.81;
                }),
                "as gravity is in m/s²",
            ),
            (table("time_s;acceleration_left;speed_km_per_h", |_, _| ()), "has no unit"),
            (table("time_s;acceleration_left_g;temperature", |_, _| ()), "no column of speeds"),
            (table("row;acceleration_left_g;speed_m_per_s", |_, _| ()), "no column of times"),
            ("1;2;3\n4;5;6\n".to_owned(), "under a head"),
        ] {
            let refusal = read(&text, plain).unwrap_err();
            assert!(refusal.contains(part), "{refusal}");
        }
    }
}
