//! Instruments that measured a rail: what they differ by is no growth.

use std::collections::{BTreeMap, BTreeSet};

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::table::{is_one_of, words};
use riffel_keys::{Message, say};

use crate::{LabelledSpectrum, Survey};

/// Words for an instrument at the head of a column.
const DEVICE: &str = "device|instrument|trolley|gerät|geraet|messgerät|messgeraet|messsystem|appareil|équipement|equipo|aparato|\
                      dispositivo|strumento|apparecchio|toestel|serial|seriennummer|operator|bediener|opérateur|operador|operatore|\
                      probe|sonde|sonda|sensor|taster";

/// Whether the head of a column says that it names the instruments.
pub fn is_device_column(head: &str) -> bool {
    words(head).iter().any(|word| is_one_of(word, DEVICE))
}

impl Survey {
    /// The columns of the instruments that tell records apart, of an earlier survey too: a maker's name may stand beside the number
    /// of the one that was used.
    fn device_columns(&self, earlier: Option<&Self>) -> Vec<String> {
        let changes = |column: &&str| {
            let records = earlier.into_iter().flat_map(|it| &it.records);
            let labels = records.chain(&self.records).filter_map(|it| it.label(column));
            let devices: BTreeSet<&str> = labels.filter(|device| !device.is_empty()).collect();
            devices.len() > 1
        };
        let columns = self.columns().filter(|column| is_device_column(column));
        columns.filter(changes).map(str::to_owned).collect()
    }

    /// Sentence that dates tell no growth, where an instrument was left out and one date is left.
    pub fn without_common_instrument(&self) -> Option<Message> {
        let mut warnings = self.warnings.iter();
        let left_out = warnings.any(|warning| warning.id() == "device-is-left-out");
        (self.history.is_none() && left_out).then(|| say!(dates_of_other_instruments))
    }

    pub(super) fn change_of_device(&self) -> Option<Message> {
        let dates = self.by_date(self.date_column()?).ok()?;
        dates.last()?.1.device_since(&dates.first()?.1)
    }

    /// What is said where columns name other instruments than in an earlier survey.
    pub fn device_since(&self, earlier: &Self) -> Option<Message> {
        let columns = self.device_columns(Some(earlier));
        let devices = |survey: &Self| -> Vec<String> {
            let devices = survey.records.iter().map(|record| device_of(record, &columns));
            let devices: BTreeSet<String> = devices.filter(|device| !device.is_empty()).collect();
            devices.into_iter().collect()
        };
        let (first, last) = (devices(earlier), devices(self));
        (first != last && !first.is_empty() && !last.is_empty()).then(|| {
            say!(device_changes, column = columns.join("`, `"), first = first.join(", "), last = last.join(", "))
        })
    }

    /// The survey as one instrument would have measured it, so that growth is that of pairs of one instrument.
    ///
    /// Where instruments change along the dates, every other one counts more or less by what it differs in each band from the one
    /// of the last date, or from another that was laid on that, where both measured a rail on one day, at the same place where places
    /// are named; a band that they do not share by the mean of the others. An instrument without such a day is left out. Warnings say
    /// both.
    #[must_use]
    pub fn on_one_device(mut self) -> Self {
        let own = |column: Option<&str>| column.map(str::to_owned);
        let (columns, date) = (self.device_columns(None), own(self.date_column()));
        let (false, Some(date), rail) = (columns.is_empty(), date, own(self.rail_column())) else {
            return self;
        };
        let column = columns.join("`, `");
        let of = |record: &LabelledSpectrum| device_of(record, &columns);
        let by_date = self.by_date(&date).unwrap_or_default().into_iter();
        let by_date = by_date.map(|(_, survey)| survey.records.iter().map(of).collect());
        let by_date: Vec<BTreeSet<String>> = by_date.collect();
        let Some(last) = by_date.last() else {
            return self;
        };
        let Some(reference) = last.first().cloned() else {
            return self;
        };
        if by_date.iter().all(|devices| devices == last) {
            return self;
        }
        let told = self.change_of_device();
        self.warnings.retain(|warning| Some(warning) != told.as_ref());
        let mut known = BTreeSet::from([reference.clone()]);
        let mut others: BTreeSet<String> = by_date.into_iter().flatten().collect();
        others.remove(&reference);
        let is_of_rail = |head: &String| *head == date || Some(head) == rail.as_ref();
        // Of all that is said of a record, or of its day and rail alone.
        let place = |record: &LabelledSpectrum, whole: bool| -> Vec<String> {
            let labels = record.labels.iter().filter(|(head, _)| is_of_rail(head) || whole && !is_device_column(head));
            labels.map(|(_, cell)| cell.clone()).collect()
        };
        while let Some((other, offsets)) = others.iter().find_map(|other| {
            let pairs = |whole: bool| {
                let here = self.records.iter().filter(|record| of(record) == *other);
                let pairs = here.flat_map(|record| {
                    let there = self.records.iter().filter(|one| known.contains(&of(one)));
                    let there = there.filter(|one| place(one, whole) == place(record, whole));
                    there.map(|one| (&record.spectrum, &one.spectrum))
                });
                offsets(pairs)
            };
            Some((other.clone(), pairs(true).or_else(|| pairs(false))?))
        }) {
            let mean = offsets.values().sum::<f64>() / offsets.len() as f64;
            for record in self.records.iter_mut().filter(|record| of(record) == other) {
                let levels = record.spectrum.levels().iter();
                let levels = levels.map(|one| (one.band, one.level + offsets.get(&one.band).unwrap_or(&mean)));
                // Bands are those of before.
                record.spectrum = Spectrum::new(levels).unwrap_or_else(|_| record.spectrum.clone());
            }
            others.remove(&other);
            self.warnings.push(say!(
                device_is_laid_on_another,
                column = &column,
                device = &other,
                reference = &reference,
                offset = format!("{mean:+.1}")
            ));
            known.insert(other);
        }
        for other in others {
            self.records.retain(|record| of(record) != other);
            self.warnings.push(say!(device_is_left_out, column = &column, device = other, reference = &reference));
        }
        self
    }
}

/// The instrument of a record, as columns name it.
fn device_of(record: &LabelledSpectrum, columns: &[String]) -> String {
    let cells = columns.iter().filter_map(|column| record.label(column));
    let cells: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
    cells.join(" ")
}

/// What must be added to the first spectrum of pairs to have the second, in the mean by band \[dB\]; none without a band in both.
fn offsets<'a>(pairs: impl Iterator<Item = (&'a Spectrum, &'a Spectrum)>) -> Option<BTreeMap<ThirdOctave, f64>> {
    let mut sums: BTreeMap<ThirdOctave, (f64, f64)> = BTreeMap::new();
    for (own, other) in pairs {
        for one in own.levels() {
            if let Some(level) = other.level(one.band) {
                let sum = sums.entry(one.band).or_default();
                *sum = (sum.0 + level - one.level, sum.1 + 1.0);
            }
        }
    }
    let means = sums.into_iter().map(|(band, (sum, count))| (band, sum / count));
    let means: BTreeMap<ThirdOctave, f64> = means.collect();
    (!means.is_empty()).then_some(means)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// Levels of 50 mm and 25 mm that grow by 4 and 1 dB a year, as instruments show them that differ by 3 and 2 dB, and one that
    /// measured on no day with another.
    #[test]
    fn what_instruments_differ_by_is_no_growth() {
        let survey = |rows: &[(&str, i32, [f64; 2])]| {
            let record = |&(device, year, offset): &(&str, i32, [f64; 2])| {
                let grown = f64::from(year - 2024);
                let level = |at: usize| [4.0, 1.0][at] * grown + offset[at];
                let labels = [
                    ("Messgerät", device.to_owned()),
                    // Days that fall as years rise: the order is that of dates, not of letters.
                    ("date", format!("{:02}.06.{year}", 2040 - year)),
                ];
                let bands = [0.05, 0.025].map(|it| ThirdOctave::containing(it).unwrap());
                LabelledSpectrum {
                    labels: labels.map(|(head, cell)| (head.to_owned(), cell)).to_vec(),
                    spectrum: Spectrum::new(vec![(bands[0], level(0)), (bands[1], level(1))]).unwrap(),
                }
            };
            let records = rows.iter().map(record).collect();
            Survey::new(Path::new("rail"), records, Vec::new()).unwrap().choose(&[]).unwrap()
        };
        let (none, more, alone) = ([0.0, 0.0], [3.0, 2.0], [9.0, 9.0]);
        let both = [("T1", 2024, none), ("T1", 2025, none), ("T2", 2025, more), ("T2", 2026, more)];
        let one = survey(&both).on_one_device();
        for (place, record) in one.records.iter().enumerate() {
            let year = [0.0, 1.0, 1.0, 2.0][place];
            let levels: Vec<f64> = record.spectrum.levels().iter().map(|one| one.level).collect();
            let expected = [4.0 * year + 3.0, year + 2.0];
            let off = |other: &f64| levels.iter().all(|level| (level - other).abs() > 1e-12);
            assert!(levels.len() == 2 && !expected.iter().any(off), "{levels:?}");
        }
        let said = one.warnings.iter().map(Message::to_string).collect::<Vec<_>>().join("; ");
        assert!(said.contains("T1 count +2.5 dB") && !said.contains("not told apart"), "{said}");
        // By a third that was laid on the second.
        let chain = [("T3", 2023, alone), ("T3", 2024, alone), both[0], both[1], both[2], both[3]];
        let levels = |survey: &Survey| survey.records[0].spectrum.levels().to_vec();
        let chained = levels(&survey(&chain).on_one_device());
        let plain = levels(&survey(&[("T2", 2023, more)]));
        assert!(chained.iter().zip(&plain).all(|(one, other)| (one.level - other.level).abs() < 1e-12));
        let apart = survey(&[both[0], both[1], ("T2", 2026, more)]).on_one_device();
        assert_eq!(apart.records.len(), 1);
        assert!(apart.warnings.last().unwrap().to_string().contains("T1 is left out of growth"));
        // Places pair by themselves: T2 measured one more on the day of both, 20 dB rougher, under the number of the same maker.
        let places = [
            ("T1", 2024, none, "A"),
            ("T1", 2025, none, "A"),
            ("T2", 2025, more, "A"),
            ("T2", 2025, [23.0, 22.0], "B"),
            ("T2", 2026, more, "A"),
        ];
        let rows = places.map(|(device, year, offset, _)| (device, year, offset));
        let mut of_places = survey(&rows);
        for (record, (.., place)) in of_places.records.iter_mut().zip(places) {
            let serial = std::mem::replace(&mut record.labels[0].1, "Trolley".to_owned());
            record.labels.push(("serial".to_owned(), serial));
            record.labels.push(("section".to_owned(), place.to_owned()));
        }
        let of_places = of_places.on_one_device();
        let first = of_places.records[0].spectrum.levels();
        assert!(first.iter().zip([2.0, 3.0]).all(|(one, level)| (one.level - level).abs() < 1e-12));
        let told = of_places.warnings.last().unwrap().to_string();
        assert!(told.contains("column `serial`: levels of T1 count +2.5 dB"), "{told}");
        // The same instruments at each date pair by themselves.
        let pairs = [("T1", 2024, none), ("T2", 2024, more), ("T1", 2026, none), ("T2", 2026, more)];
        assert_eq!(survey(&pairs).on_one_device(), survey(&pairs));
    }
}
