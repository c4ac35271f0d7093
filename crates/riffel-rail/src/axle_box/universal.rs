//! Universal files (dataset 58) with what axle boxes felt.

use std::io::BufReader;
use std::path::Path;

use riffel_keys::universal_file::{
    ACCELERATION, Axis, DISPLACEMENT, Signal, SignalError, Signals, TIME, Units, VELOCITY, unit_size,
};
use riffel_keys::{CaseError, Exponents, Message, Unit, say, seal};

use super::columns::Content;
use super::head::Signals as Found;
use super::head::{AxleBoxHead, AxleBoxLayout, Row, left_out, unreadable};
use crate::refusal::Refusal;

/// Share by which steps of signals may differ that are one: they are printed with six digits.
const SAME_STEP: f64 = 1e-5;

/// Which signals of a universal file hold what, each with the SI units in one of its own.
#[derive(Debug)]
pub(super) struct AxleBoxUniversal {
    channels: Vec<(Signal, f64)>,
    place: Option<(Signal, f64)>,
    /// What else tells the place.
    witness: Option<(Signal, f64)>,
}

/// Whether a file is a universal file by its first line that is not blank.
pub(super) fn is_universal(head: &[u8]) -> bool {
    let mut lines = head.split(|&byte| byte == b'\n');
    let first = lines.find(|line| !line.trim_ascii().is_empty());
    first.is_some_and(|line| line.trim_ascii_end() == b"    -1")
}

/// What a signal is, by its kind or else by its unit.
fn kind(axis: &Axis) -> i32 {
    if axis.kind > 1 {
        return axis.kind;
    }
    let exponents = Unit::parse(axis.unit.trim()).map(|unit| unit.exponents);
    match exponents {
        _ if axis.unit.trim() == "g" => ACCELERATION,
        Ok(of) if of == Exponents::new(0, 1, -2) => ACCELERATION,
        Ok(of) if of == Exponents::new(0, 1, -1) => VELOCITY,
        Ok(of) if of == Exponents::new(0, 1, 0) => DISPLACEMENT,
        _ => axis.kind,
    }
}

impl AxleBoxUniversal {
    /// Find the signals over time.
    pub(super) fn find(path: &Path, layout: &AxleBoxLayout) -> Result<(Self, AxleBoxHead), CaseError> {
        let file = seal::open(path).map_err(|reason| unreadable(path, reason))?;
        let found = Signals::find(BufReader::with_capacity(1 << 20, file));
        let Signals { signals, units } = found.map_err(|error| at_fault(path, error))?;
        let refuse = |message: Message| Err(CaseError::data(path, message));
        let (mut found, mut others) = (Found::default(), Vec::new());
        for signal in signals {
            let function = &signal.function;
            if function.abscissa_axis.kind != TIME && function.function_type != 1 {
                continue;
            }
            let kind = kind(&function.numerator);
            let (exponents, what) = match kind {
                ACCELERATION => (Exponents::new(0, 1, -2), say!(an_acceleration)),
                VELOCITY => (Exponents::new(0, 1, -1), say!(a_speed)),
                DISPLACEMENT => (Exponents::new(0, 1, 0), say!(an_odometer)),
                _ => {
                    others.push(left_out(&function.title, say!(it_is_no_signal)));
                    continue;
                }
            };
            let unit = unit_of(&signal, exponents, units, what).map_err(|refusal| refusal.of(path))?;
            let content = match kind {
                ACCELERATION => {
                    let sign = f64::from(function.response.direction.signum());
                    Content::Acceleration(if sign == 0.0 { unit } else { sign * unit })
                }
                VELOCITY => Content::Speed(unit),
                _ => Content::Odometer(unit),
            };
            found.push(signal, content);
        }
        let remarks = found.leave_out_others(|signal| signal.function.title.clone());
        let mut remarks = remarks.map_err(|message| CaseError::data(path, message))?;
        remarks.append(&mut others);
        let title = |signal: &Signal| signal.function.title.clone();
        let places = found.place(layout.speed, title, &mut remarks);
        let channels = found.channels;
        let Some((first, _)) = channels.first() else {
            return refuse(say!(no_acceleration_over_time));
        };
        let Some(places) = places else {
            return refuse(say!(no_place_over_time));
        };
        let names = names(&channels);
        let points = first.points;
        let (begin, step) = times(first).map_err(|refusal| refusal.of(path))?;
        for (signal, _) in channels.iter().chain(&places.signal).chain(&places.witness) {
            let (other_begin, other) = times(signal).map_err(|refusal| refusal.of(path))?;
            let (line, title) = (signal.function.line, &signal.function.title);
            let refuse = |message: Message| Err(Refusal::new(Some(line), message).of(path));
            if signal.function.complex || (other / step - 1.0).abs() > SAME_STEP || signal.points != points {
                return refuse(say!(signal_of_other_form, title, points, step));
            }
            // Signals a step apart or more stand at other places.
            if (other_begin - begin).abs() > 0.5 * step {
                return refuse(say!(
                    signal_begins_elsewhere,
                    title,
                    begin = other_begin,
                    first = &first.function.title,
                    other = begin
                ));
            }
        }
        // Steps are printed with six digits, as 4.00000e-04.
        let rate = 1.0 / step;
        let digits = 10f64.powi(6 - rate.log10().ceil() as i32);
        let rate = (rate * digits).round() / digits;
        if let Some(given) = layout.rate
            && (given / rate - 1.0).abs() > SAME_STEP
        {
            return refuse(say!(file_says_its_rate, rate));
        }
        let head = AxleBoxHead::of_samples(names, rate, &places, remarks);
        let read = Self { channels, place: places.signal, witness: places.witness };
        Ok((read, head))
    }

    /// Hand on sample by sample; `progress` is told of bytes done. Memory: 256 KB for each signal, which are read side by side
    /// although they stand one behind the other.
    pub(super) fn each(
        &self,
        path: &Path,
        take: &mut dyn FnMut(&Row<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(), CaseError> {
        let signals = self.channels.iter().chain(&self.place);
        let signals: Vec<&(Signal, f64)> = signals.chain(&self.witness).collect();
        let mut values = Vec::new();
        for (signal, _) in &signals {
            let file = seal::open(path).map_err(|reason| unreadable(path, reason))?;
            let reader = BufReader::with_capacity(1 << 18, file);
            values.push(signal.values(reader).map_err(|error| at_fault(path, error))?);
        }
        let points = self.channels[0].0.points;
        let size = std::fs::metadata(path).map_or(0, |file| file.len() as usize);
        let mut sample = vec![0.0; signals.len()];
        for number in 1..=points {
            for ((value, of), (_, unit)) in sample.iter_mut().zip(&mut values).zip(&signals) {
                let next = of.next().unwrap_or(Ok(f64::NAN));
                *value = unit * next.map_err(|error| at_fault(path, error))?;
            }
            let (accelerations, others) = sample.split_at(self.channels.len());
            let (place, witness) = others.split_at(usize::from(self.place.is_some()));
            take(&Row {
                accelerations,
                time: None,
                place: place.first().copied().unwrap_or(f64::NAN),
                witness: witness.first().copied().unwrap_or(f64::NAN),
                marked: None,
                number,
            })?;
            progress(number * size / points - (number - 1) * size / points);
        }
        Ok(())
    }
}

/// Begin and step of a signal over even times \[s\].
fn times(signal: &Signal) -> Result<(f64, f64), Refusal> {
    let (line, title) = (signal.function.line, &signal.function.title);
    let refuse = |message: Message| Refusal::new(Some(line), message);
    let uneven = || refuse(say!(times_are_uneven, title));
    let (begin, step) = signal.even.ok_or_else(uneven)?;
    let time = &signal.function.abscissa_axis;
    let second = unit_size(time, Exponents::new(0, 0, 1), 1.0)
        .ok_or_else(|| refuse(say!(times_in_other_unit, title, unit = time.unit.trim())))?;
    Ok((second * begin, second * step))
}

/// SI units in one of a signal's.
fn unit_of(signal: &Signal, exponents: Exponents, units: Option<Units>, what: Message) -> Result<f64, Refusal> {
    let (axis, line) = (&signal.function.numerator, signal.function.line);
    let title = &signal.function.title;
    if !axis.has_unit() && units.is_none() {
        let without = say!(signal_without_unit, title, what);
        return Err(Refusal::new(Some(line), without));
    }
    let per_si = units.map_or(1.0, |units| units.length);
    unit_size(axis, exponents, per_si).ok_or_else(|| {
        let other = say!(signal_with_other_unit, title, what, unit = &axis.unit);
        Refusal::new(Some(line), other)
    })
}

/// What channels are called: their titles where they have different ones, their nodes and directions otherwise.
fn names(channels: &[(Signal, f64)]) -> Vec<String> {
    let titles: Vec<String> = channels.iter().map(|(signal, _)| signal.function.title.clone()).collect();
    let said = |title: &String| !title.is_empty() && !title.eq_ignore_ascii_case("none");
    let mut different = titles.clone();
    different.sort_unstable();
    different.dedup();
    if different.len() == titles.len() && titles.iter().all(said) {
        return titles;
    }
    let of = channels.iter().map(|(signal, _)| {
        let response = &signal.function.response;
        let axis = ["", "x", "y", "z"].get(response.direction.unsigned_abs() as usize);
        format!("node {} {}", response.node, axis.unwrap_or(&"")).trim_end().to_owned()
    });
    of.collect()
}

fn at_fault(path: &Path, error: SignalError) -> CaseError {
    match error {
        SignalError::Read(reason) => unreadable(path, reason),
        SignalError::File(error) => CaseError::data(path, &error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A signal at 1 kHz from a time \[s\] on.
    fn dataset(title: &str, kind: &str, unit: &str, begin: f64, second: (&str, f64)) -> String {
        let values =
            (0..400).map(|row| format!("{:13.5e}{}", f64::from(row) / 50.0, if row % 6 == 5 { "\n" } else { "" }));
        let (time, size) = second;
        let none = "         0    0    0    0 NONE                 NONE                \n";
        format!(
            "    -1\n    58\n{title}\nNONE\nNONE\nNONE\nNONE\n    1         0    0         0 NONE               1   3 NONE               0   0\n\
             {:10}{:10}{:10}{:13.5e}{:13.5e}{:13.5e}\n        17    0    0    0 Time                 {time:<20}\n\
             {kind:>10}    0    0    0 Ordinate             {unit:<20}\n{none}{none}{}\n    -1\n",
            2,
            400,
            1,
            begin / size,
            1e-3 / size,
            0.0,
            values.collect::<String>()
        )
    }

    /// Signals that begin at one time, in whatever unit, are laid on one another; others are refused with both begins.
    #[test]
    fn signals_begin_together() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.uff");
        let found = |begins: [f64; 2], second: (&str, f64)| {
            let left = dataset("left", "12", "m/s^2", begins[0], ("s", 1.0));
            let odometer = dataset("odometer", "8", "m", begins[1], second);
            std::fs::write(&path, left + &odometer).unwrap();
            let found = AxleBoxUniversal::find(&path, &AxleBoxLayout::default());
            found.map(|(_, head)| head.rate).map_err(|error| error.to_string())
        };
        for (begins, second) in
            [([0.0, 0.0], ("s", 1.0)), ([5.0, 5.0], ("s", 1.0)), ([5.0, 5.0], ("ms", 1e-3)), ([0.0, 4e-4], ("s", 1.0))]
        {
            assert_eq!(found(begins, second), Ok(1000.0), "{begins:?}");
        }
        for (begins, says) in [
            ([0.0, 3.0], "\"odometer\" begins at 3 s and \"left\" at 0 s"),
            ([0.0, 1e-3], "\"odometer\" begins at 0.001 s"),
            ([2.5, 0.0], "\"odometer\" begins at 0 s and \"left\" at 2.5 s"),
        ] {
            let refusal = found(begins, ("s", 1.0)).unwrap_err();
            assert!(refusal.contains(says), "{refusal}");
        }
    }
}
