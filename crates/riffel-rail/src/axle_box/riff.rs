//! WAV files: where their samples are, and how they are written.

use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use riffel_keys::{CaseError, Message, say, seal};

/// Size of a chunk that its writer did not know, or that another chunk tells.
const UNKNOWN: u64 = u32::MAX as u64;
/// Sizes of a chunk that goes beyond the end of the file from which it is taken to be unknown: the largest of 31 bits, from which
/// SoX and others take their heads.
const LARGEST: std::ops::RangeInclusive<u64> = 0x7fff_e000..=0x8000_0000;
/// Samples by which a file with fewer bits than its samples have room for shows where they lie.
const LOOKED_AT: usize = 1 << 14;

/// What the head of a WAV file says.
#[derive(Debug, Clone)]
pub(super) struct Wave {
    /// Number of channels.
    pub(super) channels: usize,
    /// Samples a second of each.
    pub(super) rate: f64,
    /// Bytes of a sample of all channels.
    pub(super) width: usize,
    float: bool,
    /// Value of an integer at full scale.
    full: f64,
    /// First byte of the samples, and their number.
    data: u64,
    samples: u64,
}

/// Why a file is not read.
pub(super) enum WaveError {
    /// It cannot be read, or ends early.
    Read,
    /// It is written in another way.
    Form(Message),
}

impl From<io::Error> for WaveError {
    fn from(_: io::Error) -> Self {
        Self::Read
    }
}

/// The format chunk.
struct Format {
    channels: usize,
    rate: f64,
    width: usize,
    /// Bits that a sample has, of those there is room for.
    bits: u32,
    float: bool,
}

impl Wave {
    /// Read the head.
    ///
    /// Chunks of odd length have a byte behind them, which some writers forget. The size of the samples of a file of more
    /// than 4 GB stands in a chunk before (RF64, EBU Tech 3306; BW64, ITU-R BS.2088); a size of nought, of all bits, of all but
    /// those of a head or near 2 GB where the file is shorter is that of a writer who could not go back: the samples go to the
    /// end of the file.
    pub(super) fn open(path: &Path) -> Result<Self, WaveError> {
        let mut file = BufReader::new(seal::open(path)?);
        let end = file.seek(SeekFrom::End(0))?;
        file.rewind()?;
        let form: [u8; 12] = bytes(&mut file)?;
        match (&form[..4], &form[8..]) {
            (b"RIFF" | b"RF64" | b"BW64", b"WAVE") => {}
            _ => return Err(WaveError::Form(say!(no_riff_of_waves))),
        }
        let (mut format, mut long) = (None, None);
        loop {
            let head: [u8; 8] = bytes(&mut file)?;
            let size = number(&head[4..]);
            let start = file.stream_position()?;
            match &head[..4] {
                b"ds64" => {
                    let sizes: [u8; 16] = bytes(&mut file)?;
                    long = Some(number(&sizes[8..]));
                }
                b"fmt " => format = Some(Format::read(&mut file, size)?),
                b"data" => {
                    let format: Format = format.ok_or_else(|| WaveError::Form(say!(samples_before_their_form)))?;
                    let size = match (size, long) {
                        (UNKNOWN, Some(long)) => long,
                        (0 | UNKNOWN, None) => end - start,
                        // All bits but for the head of the file.
                        (size, None) if start + size > end && (size + start >= UNKNOWN || LARGEST.contains(&size)) => {
                            end - start
                        }
                        (size, _) => size,
                    };
                    return Self::new(&format, &mut file, start, size, end);
                }
                _ => {}
            }
            file.seek(SeekFrom::Start(start + size))?;
            let [after]: [u8; 1] = if size % 2 == 1 { bytes(&mut file)? } else { [0] };
            if after != 0 {
                file.seek(SeekFrom::Start(start + size))?;
            }
        }
    }

    fn new(format: &Format, file: &mut (impl Read + Seek), start: u64, size: u64, end: u64) -> Result<Self, WaveError> {
        let mut wave = Self {
            channels: format.channels,
            rate: format.rate,
            width: format.width,
            float: format.float,
            full: 1.0,
            data: start,
            samples: size / format.width as u64,
        };
        let room = 8 * (format.width / format.channels) as u32;
        wave.full = 2f64.powi(room as i32 - 1);
        if !format.float && format.bits < room {
            // Bits stand at the top of their room. Some writers have them at the bottom: no number then is larger than its
            // bits allow, and the bits below are used.
            let looked = wave.samples.min((LOOKED_AT / wave.channels).max(1) as u64);
            let looked = looked.min((end - start) / wave.width as u64);
            let mut raw = vec![0; looked as usize * wave.width];
            file.read_exact(&mut raw)?;
            let least = 2f64.powi((room - format.bits) as i32);
            let largest = 2f64.powi(format.bits as i32 - 1);
            let values = || raw.chunks_exact(wave.width / wave.channels).map(integer);
            if values().any(|value| value % least != 0.0) && values().all(|value| value.abs() <= largest) {
                wave.full = largest;
            }
        }
        Ok(wave)
    }

    /// Each sample of all channels, full scale being one; ends with the first error.
    pub(super) fn each(
        &self,
        path: &Path,
        mut take: impl FnMut(usize, &[f64]) -> Result<(), CaseError>,
        wrong: impl Fn(WaveError, usize) -> CaseError,
    ) -> Result<(), CaseError> {
        let opened = seal::open(path).and_then(|mut file| {
            file.seek(SeekFrom::Start(self.data))?;
            Ok(BufReader::with_capacity(1 << 18, file))
        });
        let mut file = opened.map_err(|error| wrong(error.into(), 1))?;
        let mut raw = vec![0; self.width];
        let mut values = vec![0.0; self.channels];
        for number in 1..=self.samples as usize {
            file.read_exact(&mut raw).map_err(|error| wrong(error.into(), number))?;
            let parts = raw.chunks_exact(self.width / self.channels);
            for (value, part) in values.iter_mut().zip(parts) {
                *value = match (self.float, part) {
                    (true, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
                    (true, &[a, b, c, d, e, f, g, h]) => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
                    _ => integer(part) / self.full,
                };
            }
            take(number, &values)?;
        }
        Ok(())
    }
}

impl Format {
    fn read(file: &mut impl Read, size: u64) -> Result<Self, WaveError> {
        /// Format whose tag stands further behind.
        const EXTENSIBLE: u64 = 0xFFFE;
        let mut own = [0; 26];
        let known = (size as usize).min(own.len());
        if known < 16 {
            return Err(WaveError::Form(say!(form_is_cut_short)));
        }
        file.read_exact(&mut own[..known])?;
        let (tag, channels) = (number(&own[..2]), number(&own[2..4]) as usize);
        let (width, bits) = (number(&own[12..14]) as usize, number(&own[14..16]));
        let (tag, bits) = match (tag == EXTENSIBLE && known == own.len(), number(&own[18..20])) {
            (false, _) => (tag, bits),
            (true, 0) => (number(&own[24..]), bits),
            (true, valid) => (number(&own[24..]), valid),
        };
        let whole = channels > 0 && width > 0 && width.is_multiple_of(channels);
        let room = if whole { width / channels } else { 0 };
        let float = match (tag, room) {
            (1, 1..=4) => false,
            (3, 4 | 8) => true,
            _ => return Err(WaveError::Form(say!(samples_of_other_kind))),
        };
        Ok(Self { channels, rate: number(&own[4..8]) as f64, width, bits: bits as u32, float })
    }
}

fn bytes<const N: usize>(file: &mut impl Read) -> io::Result<[u8; N]> {
    let mut bytes = [0; N];
    file.read_exact(&mut bytes)?;
    Ok(bytes)
}

/// An unsigned number of up to eight bytes, the lowest first.
fn number(bytes: &[u8]) -> u64 {
    bytes.iter().rev().fold(0, |sum, byte| sum << 8 | u64::from(*byte))
}

/// A signed number of up to four bytes; of a single one, from 128 on.
fn integer(bytes: &[u8]) -> f64 {
    if let [byte] = bytes {
        return f64::from(*byte) - 128.0;
    }
    let unused = 64 - 8 * bytes.len() as u32;
    ((number(bytes) << unused) as i64 >> unused) as f64
}
