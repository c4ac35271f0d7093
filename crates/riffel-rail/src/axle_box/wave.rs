//! WAV files with what axle boxes felt.

use std::path::Path;

use riffel_keys::table::Heading;
use riffel_keys::{CaseError, Message, Value, say};

use super::columns::{channel_name, content};
use super::head::{AxleBoxHead, AxleBoxLayout, Counting, Row, Signals, left_out};
use super::riff::{Wave, WaveError};
use crate::refusal::Refusal;

/// What `--channels` looks like.
const EXAMPLE: &str = "--channels acceleration_left_g=50,acceleration_right_g=50";

/// Which channels of a WAV file hold what.
#[derive(Debug)]
pub(super) struct AxleBoxWave {
    /// Channel and value at full scale \[m/s²\].
    channels: Vec<(usize, f64)>,
    /// Channel and value at full scale of the speed \[m/s\] or the odometer \[m\].
    place: Option<(usize, f64)>,
    /// What else tells the place.
    witness: Option<(usize, f64)>,
}

/// Whether a file is a WAV file by its first bytes, or one of the forms for files of more than 4 GB.
pub(super) fn is_wave(head: &[u8]) -> bool {
    [&b"RIFF"[..], b"RIFX", b"RF64", b"BW64", b"riff"].iter().any(|mark| head.starts_with(mark))
}

impl AxleBoxWave {
    /// Find the channels by what a user says of them.
    pub(super) fn find(path: &Path, layout: &AxleBoxLayout) -> Result<(Self, AxleBoxHead), CaseError> {
        let refuse = |message: Message| CaseError::data(path, message);
        let wave = open(path)?;
        let count = wave.channels;
        if layout.channels.is_empty() {
            return Err(refuse(say!(wav_has_no_units, example = EXAMPLE)));
        }
        if layout.channels.len() != count {
            return Err(refuse(say!(wav_has_other_count, count, named = layout.channels.len())));
        }
        let (mut signals, mut others) = (Signals::default(), Vec::new());
        for (channel, said) in layout.channels.iter().enumerate() {
            let (name, scale) = said.split_once('=').unwrap_or((said, ""));
            let scale = scale.trim().parse::<f64>().ok();
            let scale = scale.filter(|scale| *scale > 0.0 && scale.is_finite());
            let Some(scale) = scale else {
                return Err(refuse(say!(channel_without_scale, channel = said, example = EXAMPLE)));
            };
            let heading = Heading::of_name(name.trim());
            let option = || Value::Key("--channels".to_owned());
            let found = content(&heading, 0).map_err(|message| refuse(message.about(option())))?;
            match found {
                Some(content) => signals.push(channel, content.scaled(scale)),
                None => others.push(left_out(name.trim(), say!(it_is_no_signal))),
            }
        }
        if signals.channels.is_empty() {
            return Err(refuse(say!(no_channel_of_accelerations, example = EXAMPLE)));
        }
        let said = |channel: usize| layout.channels[channel].split('=').next().unwrap_or_default();
        let own_name = |channel: &usize| said(*channel).trim().to_owned();
        let mut remarks = signals.leave_out_others(own_name).map_err(refuse)?;
        remarks.append(&mut others);
        let name = |channel: usize| match channel_name(&Heading::of_name(said(channel).trim()), 0) {
            name if name.starts_with("column ") => format!("channel {}", channel + 1),
            name => name,
        };
        let names = signals.channels.iter().map(|&(channel, _)| name(channel)).collect();
        let Some(places) = signals.place(layout.speed, own_name, &mut remarks) else {
            return Err(refuse(say!(no_channel_of_the_place)));
        };
        let rate = wave.rate;
        if layout.rate.is_some_and(|given| given != rate) {
            return Err(refuse(say!(file_says_its_rate, rate)));
        }
        let head = AxleBoxHead::of_samples(names, rate, &places, remarks);
        let read = Self { channels: signals.channels, place: places.signal, witness: places.witness };
        Ok((read, head))
    }

    /// Hand on sample by sample; `progress` is told of bytes done. Memory: a sample.
    pub(super) fn each(
        &self,
        path: &Path,
        take: &mut dyn FnMut(&Row<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(), CaseError> {
        let wave = open(path)?;
        let mut accelerations = vec![0.0; self.channels.len()];
        let mut take = |number: usize, sample: &[f64]| {
            progress(wave.width);
            for (acceleration, (channel, scale)) in accelerations.iter_mut().zip(&self.channels) {
                *acceleration = scale * sample[*channel];
            }
            let of = |signal: Option<(usize, f64)>| signal.map_or(f64::NAN, |(channel, scale)| scale * sample[channel]);
            take(&Row {
                accelerations: &accelerations,
                time: None,
                place: of(self.place),
                witness: of(self.witness),
                marked: None,
                number,
            })
        };
        wave.each(path, &mut take, |error, number| wrong(path, error, Some(number)))
    }
}

fn open(path: &Path) -> Result<Wave, CaseError> {
    Wave::open(path).map_err(|error| wrong(path, error, None))
}

/// What a WAV file lacks.
fn wrong(path: &Path, error: WaveError, sample: Option<usize>) -> CaseError {
    let message = match error {
        WaveError::Read => say!(wav_ends_early),
        WaveError::Form(reason) => say!(wav_of_another_form, reason),
    };
    let refusal = match sample {
        Some(number) => Counting::Samples.refuse(number, message),
        None => Refusal::new(None, message),
    };
    refusal.of(path)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// A file of one channel at 1 kHz: its mark, chunks before the samples, how samples are written, their bytes, and the
    /// size told of them.
    struct Made<'a> {
        mark: &'a [u8; 4],
        before: &'a [u8],
        /// Tag, bytes and bits of a sample; the bits apart from the bytes are told in the long form.
        form: (u16, u16, u16),
        samples: Vec<u8>,
        size: Option<u32>,
    }

    impl Made<'_> {
        fn values(&self) -> Result<Vec<f64>, String> {
            let (tag, width, bits) = self.form;
            let mut form = Vec::new();
            let long = bits != 8 * width;
            let head = [if long { 0xFFFE } else { tag }, 1];
            form.extend(head.iter().flat_map(|value: &u16| value.to_le_bytes()));
            form.extend([1000u32, 1000 * u32::from(width)].iter().flat_map(|value| value.to_le_bytes()));
            form.extend([width, 8 * width].iter().flat_map(|value| value.to_le_bytes()));
            if long {
                form.extend([22, bits, 0, 0, tag].iter().flat_map(|value: &u16| value.to_le_bytes()));
                form.extend([0; 14]);
            }
            let chunk = |name: &[u8], size: u32, content: &[u8]| [name, &size.to_le_bytes()[..], content].concat();
            let size = self.size.unwrap_or(self.samples.len() as u32);
            let bytes = [
                &self.mark[..],
                &u32::MAX.to_le_bytes(),
                b"WAVE",
                self.before,
                &chunk(b"fmt ", form.len() as u32, &form),
                &chunk(b"data", size, &self.samples),
            ]
            .concat();
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("run.wav");
            fs::write(&path, bytes).unwrap();
            let wave = open(&path).map_err(|error| error.to_string())?;
            let mut values = Vec::new();
            let mut take = |_, sample: &[f64]| {
                values.push(sample[0]);
                Ok(())
            };
            let each = wave.each(&path, &mut take, |error, number| wrong(&path, error, Some(number)));
            each.map_err(|error| error.to_string())?;
            Ok(values)
        }
    }

    /// Half, minus a quarter and one bit of 24 above nought, in every form in which they are written.
    #[test]
    fn every_form_has_the_same_values() {
        let bit = 1.0 / f64::from(1 << 23);
        let wanted = [0.5, -0.25, bit];
        let whole = |bits: i32, width: usize, up: u32| -> Vec<u8> {
            let scaled = wanted.iter().map(|value| value * 2f64.powi(bits - 1));
            scaled.flat_map(|value| ((value as i32) << up).to_le_bytes()[..width].to_vec()).collect()
        };
        let floats = wanted.iter().flat_map(|value| (*value as f32).to_le_bytes());
        let doubles = wanted.iter().flat_map(|value| value.to_le_bytes());
        let forms = [
            ("24 bits", (1, 3, 24), whole(24, 3, 0)),
            ("32 bits", (1, 4, 32), whole(32, 4, 0)),
            ("24 bits at the top of 32", (1, 4, 24), whole(24, 4, 8)),
            ("24 bits at the bottom of 32", (1, 4, 24), whole(24, 4, 0)),
            ("floating point of 32", (3, 4, 32), floats.collect()),
            ("floating point of 64", (3, 8, 64), doubles.collect()),
        ];
        for (name, form, samples) in forms {
            let plain = Made { mark: b"RIFF", before: b"", form, samples, size: None };
            assert_eq!(plain.values().unwrap(), wanted, "{name}");
        }
    }

    /// Chunks of odd length with and without the byte behind them, files of more than 4 GB and those whose writer could not
    /// go back.
    #[test]
    fn samples_are_found_behind_any_chunks() {
        let long = [&b"ds64\x1c\0\0\0"[..], &[0; 8], &4u64.to_le_bytes(), &[0; 12]].concat();
        let cases: [(&[u8; 4], &[u8], Option<u32>); 9] = [
            (b"RIFF", b"LIST\x07\0\0\0INFOabc\0", None),
            (b"RIFF", b"LIST\x07\0\0\0INFOabc", None),
            (b"RF64", &long, Some(u32::MAX)),
            (b"BW64", &long, Some(u32::MAX)),
            (b"RIFF", b"", Some(u32::MAX)),
            (b"RIFF", b"", Some(0)),
            (b"RIFF", b"", Some(u32::MAX - 36)),
            (b"RIFF", b"", Some(0x7fff_ffff)),
            (b"RIFF", b"", Some(0x7fff_f000)),
        ];
        for (mark, before, size) in cases {
            let made = Made { mark, before, form: (1, 2, 16), samples: vec![0, 0x40, 0, 0xE0], size };
            assert_eq!(made.values().unwrap(), [0.5, -0.25], "{before:?} {size:?}");
        }
    }

    #[test]
    fn what_is_no_such_file_is_refused() {
        let made = |mark: &'static [u8; 4], form, size| Made { mark, before: b"", form, samples: vec![0, 0x40], size };
        for (refused, says) in [
            (made(b"RIFX", (1, 2, 16), None), "no RIFF or RF64"),
            (made(b"RIFF", (2, 2, 16), None), "floating point"),
            (made(b"RIFF", (1, 2, 16), Some(8)), "ends before its head says"),
        ] {
            let refusal = refused.values().unwrap_err();
            assert!(refusal.contains(says), "{refusal}");
        }
    }

    /// A channel that is no signal, and an odometer beside a speed that is given, are named.
    #[test]
    fn channels_that_are_left_out_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.wav");
        let samples = [0u8; 600];
        let mut bytes = b"RIFF\x80\x02\0\0WAVEfmt \x10\0\0\0\x01\0\x03\0".to_vec();
        bytes.extend([1000u32, 6000].iter().flat_map(|value| value.to_le_bytes()));
        bytes.extend(*b"\x06\0\x10\0data");
        bytes.extend((samples.len() as u32).to_le_bytes());
        bytes.extend(samples);
        fs::write(&path, bytes).unwrap();
        let named = ["acceleration_left_g=50", "pantograph=1", "odometer_m=9"];
        let layout = AxleBoxLayout {
            channels: named.map(str::to_owned).to_vec(),
            speed: Some(20.0),
            ..AxleBoxLayout::default()
        };
        let (_, head) = AxleBoxWave::find(&path, &layout).unwrap();
        let said = Message::one_after_other(head.remarks).unwrap().to_string();
        for part in ["`pantograph` is left out: it is no", "`odometer_m` is left out: places follow"] {
            assert!(said.contains(part), "{part} not in: {said}");
        }
    }
}
