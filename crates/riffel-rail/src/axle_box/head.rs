//! What is known of a run before its first reading, and its readings.

use std::path::Path;

use riffel_keys::{CaseError, Message, say};

use super::clock::Clock;
use super::columns::Content;
use crate::no_rail::why_no_rail;
use crate::refusal::Refusal;

/// What a user says of a file of axle-box acceleration.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AxleBoxLayout {
    /// Samples per second \[Hz\], in place of a column of times.
    pub rate: Option<f64>,
    /// Speed of the train \[m/s\], in place of a column.
    pub speed: Option<f64>,
    /// Channels of a WAV file in their order, each as a column is called, and its value at full scale:
    /// `acceleration_left_g=50`.
    pub channels: Vec<String>,
}

/// What is known before the first reading.
#[derive(Debug)]
pub(super) struct AxleBoxHead {
    /// Of the channels.
    pub(super) names: Vec<String>,
    /// Samples per second \[Hz\].
    pub(super) rate: f64,
    /// That of the times, where they are read.
    pub(super) clock: Option<Clock>,
    pub(super) place: PlaceBy,
    /// What else tells the place, against which the first is held.
    pub(super) witness: Option<PlaceBy>,
    pub(super) counting: Counting,
    /// What is to be said of the channels.
    pub(super) remarks: Vec<Message>,
}

impl AxleBoxHead {
    /// Of signals at even times.
    pub(super) fn of_samples<S>(names: Vec<String>, rate: f64, places: &Places<S>, remarks: Vec<Message>) -> Self {
        Self {
            names,
            rate,
            clock: None,
            place: places.by,
            witness: places.witness_by,
            counting: Counting::Samples,
            remarks,
        }
    }
}

/// How a run tells where the train is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PlaceBy {
    Odometer,
    Speed,
    /// \[m/s\].
    Constant(f64),
}

/// How readings are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Counting {
    Lines,
    Samples,
}

impl Counting {
    pub(super) fn at(self, number: usize) -> Message {
        match self {
            Self::Lines => say!(at_line, number),
            Self::Samples => say!(at_sample, number),
        }
    }

    pub(super) fn refuse(self, number: usize, message: impl Into<Message>) -> Refusal {
        match self {
            Self::Lines => Refusal::new(Some(number), message),
            Self::Samples => Refusal::new(None, message.into().about(self.at(number))),
        }
    }
}

/// One reading, in SI; what is missing is NaN.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<'a> {
    /// Of every channel \[m/s²\].
    pub(super) accelerations: &'a [f64],
    /// \[s\]; `None` if there are no times.
    pub(super) time: Option<f64>,
    /// Speed \[m/s\] or odometer \[m\], whichever the file tells the place by.
    pub(super) place: f64,
    /// Place by what else the file tells it by.
    pub(super) witness: f64,
    /// A number that marks a missing value.
    pub(super) marked: Option<f64>,
    /// Line of the file or number of the sample, from 1.
    pub(super) number: usize,
}

/// Where a file has its channels and the place, each with the SI units in one of its own.
#[derive(Debug)]
pub(super) struct Signals<T> {
    pub(super) channels: Vec<(T, f64)>,
    pub(super) speed: Option<(T, f64)>,
    pub(super) odometer: Option<(T, f64)>,
    pub(super) time: Option<(T, f64)>,
    /// What is of the kind of one before it, and no channel.
    pub(super) seconds: Vec<T>,
}

impl<T> Default for Signals<T> {
    fn default() -> Self {
        Self { channels: Vec::new(), speed: None, odometer: None, time: None, seconds: Vec::new() }
    }
}

impl<T> Signals<T> {
    /// Take in what a signal is, of channels every one, of others the first.
    pub(super) fn push(&mut self, signal: T, content: Content) {
        let (place, unit) = match content {
            Content::Acceleration(unit) => return self.channels.push((signal, unit)),
            Content::Speed(unit) => (&mut self.speed, unit),
            Content::Odometer(unit) => (&mut self.odometer, unit),
            Content::Time(unit) => (&mut self.time, unit),
        };
        match place {
            Some(_) => self.seconds.push(signal),
            None => *place = Some((signal, unit)),
        }
    }

    /// Leave out the channels that tell nothing of the rail by `name`, and the second of each other kind; a sentence on each.
    ///
    /// # Errors
    /// These sentences, where no channel is left.
    pub(super) fn leave_out_others(&mut self, name: impl Fn(&T) -> String) -> Result<Vec<Message>, Message> {
        let names: Vec<String> = self.channels.iter().map(|(signal, _)| name(signal)).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let why = why_no_rail(&names);
        let mut kept = why.iter().map(Option::is_none);
        self.channels.retain(|_| kept.next().unwrap_or(true));
        let others = names.iter().zip(why);
        let others = others.filter_map(|(name, why)| Some(left_out(name, why?)));
        let seconds = self.seconds.drain(..);
        let seconds = seconds.map(|signal| left_out(&name(&signal), say!(it_is_second)));
        let said: Vec<Message> = others.chain(seconds).collect();
        if !self.channels.is_empty() {
            return Ok(said);
        }
        Message::one_after_other(said).map_or_else(|| Ok(Vec::new()), Err)
    }

    /// What the place is told by: a speed that is given, before an odometer, before speeds; None without any. `remarks` are told of
    /// signals that a given speed takes the place of, by `name`.
    pub(super) fn place(
        &mut self,
        given: Option<f64>,
        name: impl Fn(&T) -> String,
        remarks: &mut Vec<Message>,
    ) -> Option<Places<T>> {
        let (odometer, speed) = (self.odometer.take(), self.speed.take());
        if given.is_some() {
            let told = odometer.iter().chain(&speed);
            remarks.extend(told.map(|(signal, _)| left_out(&name(signal), say!(speed_tells_the_place))));
        }
        let odometer = odometer.map(|signal| (signal, PlaceBy::Odometer));
        let speed = speed.map(|signal| (signal, PlaceBy::Speed));
        let mut told = match given {
            Some(_) => [speed, odometer],
            None => [odometer, speed],
        }
        .into_iter()
        .flatten();
        let (signal, by) = match given {
            Some(speed) => (None, PlaceBy::Constant(speed)),
            None => told.next().map(|(signal, by)| (Some(signal), by))?,
        };
        let (witness, witness_by) = told.next().unzip();
        Some(Places { signal, by, witness, witness_by })
    }
}

/// That a channel is left out, and why.
pub(super) fn left_out(name: &str, reason: Message) -> Message {
    let channel = format!("`{name}`");
    say!(channel_left_out, channel, reason)
}

/// What tells the place, and what else does, each with the SI units in one of its own.
#[derive(Debug)]
pub(super) struct Places<T> {
    /// None for a speed that is given.
    pub(super) signal: Option<(T, f64)>,
    pub(super) by: PlaceBy,
    pub(super) witness: Option<(T, f64)>,
    pub(super) witness_by: Option<PlaceBy>,
}

pub(super) fn unreadable(path: &Path, reason: std::io::Error) -> CaseError {
    CaseError::Read { what: "file", path: path.to_owned(), reason }
}
