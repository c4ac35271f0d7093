//! Readings of axle boxes, one after the other, whatever they come from.

use riffel::axlebox::LONGEST_STEP;
use riffel::error::as_typed;
use riffel_keys::{Message, Value, fixed, say};

use super::clock::{Tick, Ticking};
use super::head::{AxleBoxHead, Counting, PlaceBy, Row};
use super::run_end::RunEnd;
use super::sensor::Sensor;
use super::witness::Witness;
use crate::refusal::Refusal;

/// Largest fall of an odometer that is rounding \[m\].
const ROUNDING: f64 = 1e-3;
/// Largest step of an odometer that counts \[m\]: kilometre posts stand closer than what is more.
const LARGEST_COUNT: f64 = 20.0;
/// Faster than any train on rails has run, 574.8 km/h on 3 April 2007 \[m/s\].
const FASTEST: f64 = 160.0;

/// What is known while a run is read.
pub(super) struct Listener<'a> {
    head: &'a AxleBoxHead,
    sensors: Vec<Sensor>,
    /// Where the file before ended.
    before: Option<RunEnd>,
    /// Whether this one goes on from there.
    follows: bool,
    /// Last time \[s\].
    time: Option<f64>,
    /// \[m\].
    pub(super) position: f64,
    /// Last speed \[m/s\].
    speed: Option<f64>,
    /// Last reading of the odometer \[m\].
    odometer: Option<f64>,
    /// Rows since it last rose.
    held: usize,
    /// Reading of the odometer \[m\] at the beginning of the present second, and samples since.
    second: (f64, usize),
    ticking: Option<Ticking>,
    witness: Option<Witness>,
    /// Whether the last row was a sample.
    pub(super) is_there: bool,
    rows: usize,
    leaps: Counted,
    still: Counted,
    jumps: Counted,
    missing: Counted,
    /// The first number that marks a missing value, and how often there is one.
    marked: (f64, Counted),
}

/// How often something was found, and where the first time.
#[derive(Default)]
struct Counted {
    count: usize,
    first: usize,
}

impl Counted {
    fn at(&mut self, number: usize) {
        if self.count == 0 {
            self.first = number;
        }
        self.count += 1;
    }

    fn remark(&self, what: Message, counting: Counting) -> Option<Message> {
        let (count, first) = (self.count, counting.at(self.first));
        match count {
            0 => None,
            1 => Some(say!(found_once, what, at = first)),
            _ => Some(say!(found_often, what, count, at = first)),
        }
    }
}

impl<'a> Listener<'a> {
    pub(super) fn new(head: &'a AxleBoxHead, before: Option<RunEnd>) -> Self {
        let sensors = head.names.iter();
        Self {
            sensors: sensors.map(|name| Sensor::new(name, head.rate, head.counting)).collect(),
            head,
            before: before.filter(|_| head.place != PlaceBy::Odometer),
            follows: false,
            time: None,
            position: 0.0,
            speed: None,
            odometer: None,
            held: 0,
            second: (0.0, 0),
            ticking: head.clock.map(Ticking::new),
            witness: head.witness.map(|by| Witness::new(head.place, by, head.rate)),
            is_there: false,
            rows: 0,
            leaps: Counted::default(),
            still: Counted::default(),
            jumps: Counted::default(),
            missing: Counted::default(),
            marked: (0.0, Counted::default()),
        }
    }

    fn refuse<T>(&self, number: usize, message: Message) -> Result<T, Refusal> {
        Err(self.head.counting.refuse(number, message))
    }

    /// Take in a row; whether there is a gap before what comes next.
    pub(super) fn row(&mut self, row: &Row<'_>) -> Result<bool, Refusal> {
        self.rows += 1;
        if self.rows == 1 {
            self.go_on(row.time);
        }
        self.time = row.time.filter(|time| time.is_finite()).or(self.time);
        let mut there = row.accelerations.iter().all(|value| value.is_finite());
        let (mut leap, mut lost) = (false, 0.0);
        if let (Some(time), Some(ticking)) = (row.time, &mut self.ticking) {
            let before = ticking.last();
            match ticking.tick(time) {
                Tick::Steady => {}
                Tick::Leap => {
                    (leap, lost) = (true, time - before - 1.0 / self.head.rate);
                    self.leaps.at(row.number);
                }
                Tick::Still => {
                    self.still.at(row.number);
                    return Ok(std::mem::take(&mut self.is_there));
                }
                Tick::Back => {
                    let falls = say!(time_falls, before, time);
                    return self.refuse(row.number, falls);
                }
            }
            there &= time.is_finite();
        }
        if let Some(mark) = row.marked {
            if self.marked.1.count == 0 {
                self.marked.0 = mark;
            }
            self.marked.1.at(row.number);
        }
        // The train runs on while samples are lost.
        self.position += lost * self.speed.unwrap_or(0.0);
        let before = self.position;
        there &= match self.head.place {
            PlaceBy::Constant(speed) => self.advance(speed),
            PlaceBy::Speed => self.with_speed(row.place, row.number)?,
            PlaceBy::Odometer => self.with_odometer(row.place, row.number, &mut leap)?,
        };
        if let Some(witness) = &mut self.witness {
            witness.hear(self.position - before, row.witness, leap || !there);
        }
        if !there {
            self.missing.at(row.number);
        } else {
            for (sensor, &acceleration) in self.sensors.iter_mut().zip(row.accelerations) {
                there &= sensor.listen(acceleration, row.number);
            }
        }
        let gap = self.is_there && (leap || !there);
        self.is_there = there;
        Ok(gap)
    }

    /// Begin where the train is by now after the file before, if this one is later.
    fn go_on(&mut self, time: Option<f64>) {
        if let Some(before) = self.before
            && let (Some(ended), Some(time)) = (before.time, time)
            && time > ended
        {
            self.position = before.position + before.speed * (time - ended);
            self.follows = true;
        }
    }

    /// When and where the run ends.
    pub(super) fn end(&self) -> RunEnd {
        RunEnd { time: self.time, position: self.position, speed: self.speed.unwrap_or(0.0) }
    }

    /// One sample further at a speed.
    fn advance(&mut self, speed: f64) -> bool {
        let before = self.speed.unwrap_or(speed);
        self.position += 0.5 * (before + speed) / self.head.rate;
        self.speed = Some(speed);
        true
    }

    fn with_speed(&mut self, speed: f64, number: usize) -> Result<bool, Refusal> {
        if speed.is_nan() {
            return Ok(false);
        }
        if speed < 0.0 {
            return self.refuse(number, say!(speed_is_below_zero, speed = Value::Number(as_typed(speed))));
        }
        if speed > FASTEST {
            let faster = say!(speed_beyond_any_train, speed = fixed(speed, 1), kilometres = fixed(3.6 * speed, 0));
            return self.refuse(number, faster);
        }
        Ok(self.advance(speed))
    }

    fn with_odometer(&mut self, odometer: f64, number: usize, leap: &mut bool) -> Result<bool, Refusal> {
        if odometer.is_nan() {
            return Ok(false);
        }
        let before = self.odometer.unwrap_or(odometer);
        if odometer < before - ROUNDING {
            let falls = say!(odometer_falls, before, odometer);
            return self.refuse(number, falls);
        }
        // It may be read once a second.
        self.held += 1;
        let since = self.held as f64 / self.head.rate;
        let is_run = since <= LONGEST_STEP && odometer - before <= FASTEST * since;
        if odometer > before {
            self.held = 0;
        }
        if odometer > before + LARGEST_COUNT && !is_run && !*leap {
            self.jumps.at(number);
            *leap = true;
        }
        self.position = before.max(odometer);
        self.odometer = Some(self.position);
        let (from, since) = self.second;
        if self.rows == 1 || *leap {
            self.second = (self.position, 0);
        } else if (since as f64) < self.head.rate {
            self.second.1 += 1;
        } else {
            let speed = (self.position - from) * self.head.rate / since as f64;
            if speed > FASTEST {
                let faster = say!(
                    odometer_beyond_any_train,
                    speed = fixed(speed, 1),
                    kilometres = fixed(3.6 * speed, 0),
                    rate = self.head.rate
                );
                return self.refuse(number, faster);
            }
            self.second = (self.position, 0);
        }
        Ok(true)
    }

    /// What is to be said at the end.
    pub(super) fn finish(self) -> Result<Vec<Message>, Refusal> {
        let counting = self.head.counting;
        let found = [
            self.leaps.remark(say!(samples_are_lost), counting),
            self.still.remark(say!(time_is_repeated), counting),
            self.jumps.remark(say!(odometer_leaps, length = fixed(LARGEST_COUNT, 0)), counting),
            self.missing.remark(say!(value_is_missing), counting),
            self.marked.1.remark(say!(number_marks_missing_value, mark = self.marked.0), counting),
        ];
        let mut remarks = self.head.remarks.clone();
        remarks.extend(found.into_iter().flatten());
        if self.before.is_some() && !self.follows {
            remarks.push(say!(times_begin_anew));
        }
        if self.rows == 0 {
            return Err(Refusal::new(None, say!(there_is_no_reading)));
        }
        if self.missing.count == self.rows {
            return Err(counting.refuse(self.missing.first, say!(every_row_lacks_a_value)));
        }
        if let Some(witness) = self.witness {
            remarks.extend(witness.judged()?);
        }
        for sensor in self.sensors {
            remarks.extend(sensor.judged()?);
        }
        Ok(remarks)
    }
}
