//! Rows of axle-box acceleration, one after the other.

use crate::axle_box_file::{AxleBoxFile, PlaceBy};
use crate::refusal::Refusal;
use crate::sensor::Sensor;
use crate::{number, rows};

/// Largest fall of an odometer that is rounding \[m\].
const ROUNDING: f64 = 1e-3;

/// What is known while a file is read.
pub(super) struct Reader<'a> {
    file: &'a AxleBoxFile,
    sensors: Vec<Sensor>,
    /// \[m/s²\].
    pub(super) accelerations: Vec<f64>,
    /// \[m\].
    pub(super) position: f64,
    /// Last speed \[m/s\].
    speed: Option<f64>,
    /// Last reading of the odometer \[m\].
    odometer: Option<f64>,
    time: Option<f64>,
    /// Whether the last row was a sample.
    pub(super) is_there: bool,
    rows: usize,
    leaps: Counted,
    missing: Counted,
}

/// How often something was found, and the line of the first time.
#[derive(Default)]
struct Counted {
    count: usize,
    first: usize,
}

impl Counted {
    fn at(&mut self, line: usize) {
        if self.count == 0 {
            self.first = line;
        }
        self.count += 1;
    }

    fn remark(&self, what: &str) -> Option<String> {
        let (count, first) = (self.count, self.first);
        match count {
            0 => None,
            1 => Some(format!("{what} once, at line {first}")),
            _ => Some(format!("{what} {count} times; the first is line {first}")),
        }
    }
}

impl<'a> Reader<'a> {
    pub(super) fn new(file: &'a AxleBoxFile) -> Self {
        Self {
            file,
            sensors: file
                .names
                .iter()
                .map(|name| Sensor::new(name, file.rate))
                .collect(),
            accelerations: vec![0.0; file.channels.len()],
            position: 0.0,
            speed: None,
            odometer: None,
            time: None,
            is_there: false,
            rows: 0,
            leaps: Counted::default(),
            missing: Counted::default(),
        }
    }

    /// Take in a row; whether there is a gap before what comes next.
    pub(super) fn row(&mut self, bytes: &[u8], line: usize) -> Result<bool, Refusal> {
        let cells = rows::cells(bytes, self.file.delimiter);
        let decimal = self.file.decimal.byte();
        let value = |column: usize| {
            let cell = cells.get(column).ok_or_else(|| {
                let message = format!("has {} columns, but its head has more", cells.len());
                Refusal::new(Some(line), message)
            })?;
            if cell.is_empty() {
                return Ok(f64::NAN);
            }
            number::parse(cell, decimal).ok_or_else(|| {
                let shown = String::from_utf8_lossy(cell);
                let message = format!("column {} is \"{shown}\", not a number", column + 1);
                Refusal::new(Some(line), message)
            })
        };
        self.rows += 1;
        let mut there = true;
        for (index, &(column, unit)) in self.file.channels.iter().enumerate() {
            let acceleration = unit * value(column)?;
            self.accelerations[index] = acceleration;
            there &= acceleration.is_finite();
        }
        let mut leap = false;
        if let Some((column, unit)) = self.file.time {
            let time = unit * value(column)?;
            if let Some(before) = self.time {
                let steps = (time - before) * self.file.rate;
                if steps <= 0.0 {
                    let message = format!("the time falls from {before} s to {time} s");
                    return Err(Refusal::new(Some(line), message));
                }
                leap = steps > 1.5;
            }
            there &= time.is_finite();
            self.time = Some(time).filter(|time| time.is_finite()).or(self.time);
        }
        there &= match self.file.place {
            PlaceBy::Constant(speed) => self.advance(speed),
            PlaceBy::Speed(column, unit) => self.with_speed(unit * value(column)?, line)?,
            PlaceBy::Odometer(column, unit) => self.with_odometer(unit * value(column)?, line)?,
        };
        if leap {
            self.leaps.at(line);
        }
        if !there {
            self.missing.at(line);
        } else {
            for (sensor, &acceleration) in self.sensors.iter_mut().zip(&self.accelerations) {
                there &= sensor.listen(acceleration, line);
            }
        }
        let gap = self.is_there && (leap || !there);
        self.is_there = there;
        Ok(gap)
    }

    /// One sample further at a speed.
    fn advance(&mut self, speed: f64) -> bool {
        let before = self.speed.unwrap_or(speed);
        self.position += 0.5 * (before + speed) / self.file.rate;
        self.speed = Some(speed);
        true
    }

    fn with_speed(&mut self, speed: f64, line: usize) -> Result<bool, Refusal> {
        if speed.is_nan() {
            return Ok(false);
        }
        if speed < 0.0 {
            let message = format!("the speed is {speed} m/s, but must be zero or greater");
            return Err(Refusal::new(Some(line), message));
        }
        Ok(self.advance(speed))
    }

    fn with_odometer(&mut self, odometer: f64, line: usize) -> Result<bool, Refusal> {
        if odometer.is_nan() {
            return Ok(false);
        }
        if let Some(before) = self.odometer
            && odometer < before - ROUNDING
        {
            let message = format!(
                "the odometer falls from {before} m to {odometer} m, but must rise; where chainage falls along the \
                 run, give the speed in its stead"
            );
            return Err(Refusal::new(Some(line), message));
        }
        self.position = self
            .odometer
            .map_or(odometer, |before| before.max(odometer));
        self.odometer = Some(self.position);
        Ok(true)
    }

    /// What is to be said at the end.
    pub(super) fn finish(self) -> Result<Vec<String>, Refusal> {
        let mut remarks: Vec<String> = [
            self.leaps.remark("the time leaps"),
            self.missing.remark("a value is missing"),
        ]
        .into_iter()
        .flatten()
        .collect();
        if self.missing.count == self.rows {
            let message = "every row lacks a value that is needed";
            return Err(Refusal::new(Some(self.file.header_lines + 1), message));
        }
        for sensor in self.sensors {
            remarks.extend(sensor.judged()?);
        }
        Ok(remarks)
    }
}
