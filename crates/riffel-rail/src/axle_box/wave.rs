//! WAV files with what axle boxes felt.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use hound::{SampleFormat, WavReader};
use riffel_keys::CaseError;
use riffel_keys::table::Heading;

use super::columns::{Content, channel_name, content};
use super::head::{AxleBoxHead, AxleBoxLayout, Counting, Row, Signals};
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
}

/// Whether a file is a WAV file by its first bytes, or one of the forms for files of more than 4 GB.
pub(super) fn is_wave(head: &[u8]) -> bool {
    [&b"RIFF"[..], b"RIFX", b"RF64", b"BW64", b"riff"]
        .iter()
        .any(|mark| head.starts_with(mark))
}

impl AxleBoxWave {
    /// Find the channels by what a user says of them.
    pub(super) fn find(
        path: &Path,
        layout: &AxleBoxLayout,
    ) -> Result<(Self, AxleBoxHead), CaseError> {
        let refuse = |message: String| CaseError::data(path, message);
        let spec = open(path)?.spec();
        let count = usize::from(spec.channels);
        if layout.channels.is_empty() {
            return Err(refuse(format!(
                "a WAV file has no units: name its channels in their order, each with its value at full scale, as in {EXAMPLE}"
            )));
        }
        if layout.channels.len() != count {
            return Err(refuse(format!(
                "the file has {count} channels, but --channels names {}",
                layout.channels.len()
            )));
        }
        let mut names = Vec::new();
        let mut signals = Signals::default();
        for (channel, said) in layout.channels.iter().enumerate() {
            let (name, scale) = said.split_once('=').unwrap_or((said, ""));
            let scale = scale.trim().parse::<f64>().ok();
            let scale = scale.filter(|scale| *scale > 0.0 && scale.is_finite());
            let Some(scale) = scale else {
                return Err(refuse(format!(
                    "--channels has `{said}`, but must give each channel its value at full scale, above zero, as in {EXAMPLE}"
                )));
            };
            let heading = Heading::of_name(name.trim());
            let found =
                content(&heading, 0).map_err(|message| refuse(format!("--channels: {message}")))?;
            if let Some(Content::Acceleration(_)) = found {
                names.push(match channel_name(&heading, 0) {
                    name if name.starts_with("column ") => format!("channel {}", channel + 1),
                    name => name,
                });
            }
            if let Some(content) = found {
                signals.push(channel, content.scaled(scale));
            }
        }
        if signals.channels.is_empty() {
            return Err(refuse(format!(
                "--channels names no acceleration, as in {EXAMPLE}"
            )));
        }
        let Some((place, by)) = signals.place(layout.speed) else {
            return Err(refuse(
                "no channel is the speed or an odometer; name it, as in speed_km_per_h=300, or give the speed by \
                 --speed where it was constant"
                    .to_owned(),
            ));
        };
        let rate = f64::from(spec.sample_rate);
        if layout.rate.is_some_and(|given| given != rate) {
            return Err(refuse(format!(
                "the file says {rate} samples a second; leave out --rate"
            )));
        }
        let head = AxleBoxHead {
            names,
            rate,
            place: by,
            counting: Counting::Samples,
            remarks: Vec::new(),
        };
        let channels = signals.channels;
        Ok((Self { channels, place }, head))
    }

    /// Hand on sample by sample; `progress` is told of bytes done. Memory: a sample.
    pub(super) fn each(
        &self,
        path: &Path,
        take: &mut dyn FnMut(&Row<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(), CaseError> {
        let reader = open(path)?;
        let spec = reader.spec();
        let count = usize::from(spec.channels);
        let width = count * usize::from(spec.bits_per_sample.div_ceil(8));
        let full = 2f64.powi(i32::from(spec.bits_per_sample) - 1);
        let mut values: Box<dyn Iterator<Item = hound::Result<f64>>> = match spec.sample_format {
            SampleFormat::Int => Box::new(
                reader
                    .into_samples::<i32>()
                    .map(move |value| Ok(f64::from(value?) / full)),
            ),
            SampleFormat::Float => Box::new(
                reader
                    .into_samples::<f32>()
                    .map(|value| Ok(f64::from(value?))),
            ),
        };
        let mut sample = vec![0.0; count];
        let mut accelerations = vec![0.0; self.channels.len()];
        for number in 1.. {
            for (channel, place) in sample.iter_mut().enumerate() {
                match values.next() {
                    None if channel == 0 => return Ok(()),
                    None => {}
                    Some(value) => {
                        *place = value.map_err(|error| wrong(path, &error, Some(number)))?;
                    }
                }
            }
            progress(width);
            for (acceleration, (channel, scale)) in accelerations.iter_mut().zip(&self.channels) {
                *acceleration = scale * sample[*channel];
            }
            take(&Row {
                accelerations: &accelerations,
                time: None,
                place: self
                    .place
                    .map_or(f64::NAN, |(channel, scale)| scale * sample[channel]),
                marked: None,
                number,
            })?;
        }
        Ok(())
    }
}

fn open(path: &Path) -> Result<WavReader<BufReader<File>>, CaseError> {
    WavReader::open(path).map_err(|error| wrong(path, &error, None))
}

/// What a WAV file lacks.
fn wrong(path: &Path, error: &hound::Error, sample: Option<usize>) -> CaseError {
    let at = sample.map_or_else(String::new, |number| format!("sample {number}: "));
    let message = match error {
        hound::Error::IoError(_) => {
            format!("{at}the WAV file ends before its head says, or cannot be read")
        }
        hound::Error::FormatError(what) => format!(
            "{at}no WAV file that is read here ({what}): integers of 8 to 32 bits or floating point of 32, at most 4 GB; longer \
             runs as text in columns or as a universal file"
        ),
        other => format!("{at}no WAV file that is read here: {other}"),
    };
    Refusal::new(None, message).of(path)
}
