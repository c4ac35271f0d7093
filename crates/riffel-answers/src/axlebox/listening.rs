//! A file of accelerations, heard piece by piece.

use std::path::PathBuf;
use std::sync::Arc;

use riffel::axlebox::{AxleBoxTransfer, PatchAverageProfile, Run, WheelPattern};
use riffel::roughness::{AnalysisSettings, RailAnalysis, Spectrum, ThirdOctave, WavelengthBand};
use riffel_case::Case;
use riffel_keys::{CaseError, Message};
use riffel_rail::{AxleBoxFile, AxleBoxReading, LimitTable, RunEnd};

use super::AxleBoxRequest;
use super::wheels::taken_off;
use crate::Result;
use crate::roughness::{limit_levels, rms_limit};

/// What is known of one channel so far.
pub(super) struct ChannelSoFar {
    pub(super) name: String,
    pub(super) parts: Vec<RailAnalysis>,
    /// What turns with the wheel, in pieces with their lengths [m].
    pub(super) wheel: Vec<(f64, WheelPattern)>,
    pub(super) without: Vec<PartWithout>,
    /// Wavelengths that are known somewhere.
    pub(super) known: WavelengthBand,
    slowest: f64,
    fastest: f64,
    /// Speed times length \[m²/s\].
    speed: f64,
    /// \[m\].
    length: f64,
}

/// Levels of a part with and without waves that may be the wheel's.
pub(super) struct PartWithout {
    /// \[m\].
    length: f64,
    there: Spectrum,
    left: Spectrum,
}

/// By how much levels are lower without waves that may be the wheel's \[dB\].
pub(super) fn lower(parts: &[PartWithout], band: ThirdOctave) -> f64 {
    let power = |of: fn(&PartWithout) -> &Spectrum| -> f64 {
        let powers = parts.iter().filter_map(|part| {
            let level = of(part).level(band)?;
            Some(part.length * 10f64.powf(0.1 * level))
        });
        powers.sum()
    };
    let (there, left) = (power(|part| &part.there), power(|part| &part.left));
    match left < there {
        true => 10.0 * (there / left).log10(),
        false => 0.0,
    }
}

impl ChannelSoFar {
    fn new(name: &str, known: WavelengthBand) -> Self {
        Self {
            name: name.to_owned(),
            parts: Vec::new(),
            wheel: Vec::new(),
            without: Vec::new(),
            known,
            slowest: f64::INFINITY,
            fastest: 0.0,
            speed: 0.0,
            length: 0.0,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Lowest, mean and highest speed \[m/s\].
    pub(super) fn speeds(&self) -> [f64; 3] {
        [self.slowest, self.speed / self.length, self.fastest]
    }

    fn add(
        &mut self,
        patch_average: PatchAverageProfile,
        mut wheel: Option<WheelPattern>,
        settings: &AnalysisSettings,
    ) -> Result<(), riffel::Error> {
        let length = patch_average.profile.length();
        let known = patch_average.known;
        // Less than a spectrum needs, four of its longest waves.
        if length < 4.0 * settings.longest_wavelength {
            return Ok(());
        }
        let settings = AnalysisSettings { known_band: Some(known), ..settings.clone() };
        let without = wheel.as_mut().and_then(|found| found.without.take());
        let levels = AnalysisSettings { bands: Vec::new(), section_levels: false, ..settings.clone() };
        let without = without.map(|rail| RailAnalysis::new(vec![rail], &levels, &|| ()));
        let without = without.transpose()?.map(|analysis| analysis.spectrum);
        self.wheel.extend(wheel.map(|found| (length, found)));
        let part = RailAnalysis::new(vec![patch_average.profile], &settings, &|| ())?;
        self.without.push(PartWithout {
            length,
            there: part.spectrum.clone(),
            left: without.unwrap_or_else(|| part.spectrum.clone()),
        });
        self.parts.push(part);
        let [slowest, mean, fastest] = patch_average.speeds;
        self.slowest = self.slowest.min(slowest);
        self.fastest = self.fastest.max(fastest);
        self.speed += mean * length;
        self.length += length;
        let (from, to) = (self.known.from().min(known.from()), self.known.to().max(known.to()));
        self.known = if self.parts.len() == 1 { known } else { WavelengthBand::new(from, to)? };
        Ok(())
    }
}

/// The longest piece of a file between two gaps.
#[derive(Debug, Default, Clone, Copy)]
pub(super) struct Longest {
    /// Where the present piece begins \[m\], and its last position.
    present: Option<(f64, f64)>,
    samples: usize,
    /// \[m\].
    pub(super) length: f64,
    /// Mean speed in it \[m/s\].
    pub(super) speed: f64,
    /// Gaps.
    pub(super) gaps: usize,
}

impl Longest {
    fn hear(&mut self, reading: AxleBoxReading<'_>, rate: f64) {
        match reading {
            AxleBoxReading::Sample(_, position) => {
                let from = self.present.map_or(position, |(from, _)| from);
                self.present = Some((from, position));
                self.samples += 1;
                if position - from > self.length {
                    self.length = position - from;
                    self.speed = self.length * rate / (self.samples.max(2) - 1) as f64;
                }
            }
            AxleBoxReading::Gap => {
                (self.present, self.samples) = (None, 0);
                self.gaps += 1;
            }
        }
    }
}

/// Hear a file, which may go on where another ended; what was found wrong in it, its longest piece, and its end.
pub(super) fn listen(
    case: &Case,
    (path, file): &(PathBuf, Arc<AxleBoxFile>),
    limits: &[LimitTable],
    request: &AxleBoxRequest,
    progress: &dyn Fn(usize),
    before: Option<RunEnd>,
    channels: &mut Vec<ChannelSoFar>,
) -> Result<(Vec<Message>, Longest, RunEnd)> {
    let analysis = AnalysisSettings {
        longest_wavelength: request.longest,
        block: request.block,
        limit: rms_limit(limits)?,
        section_levels: limit_levels(limits),
        without_defects: !request.keep_defects,
        ..AnalysisSettings::default()
    };
    let transfer = AxleBoxTransfer::new(case.places(), case.known_frequencies());
    let settings = request.run(case, file.rate());
    let asked = WavelengthBand::new(request.shortest, request.longest)?;
    let (mut runs, mut places) = (Vec::new(), Vec::new());
    for name in file.channels() {
        let place = channels.iter().position(|one| one.name == *name).unwrap_or_else(|| {
            channels.push(ChannelSoFar::new(name, asked));
            channels.len() - 1
        });
        runs.push(Run::new(&transfer, settings)?);
        places.push(place);
    }
    let at_fault = |error: riffel::Error| CaseError::Physics { input: path.display().to_string(), error };
    let mut take = |finished: Vec<(usize, PatchAverageProfile)>| -> Result<(), riffel::Error> {
        let name = |place: usize| channels[place].name.clone();
        for (place, patch_average, wheel) in taken_off(case, finished, &name)? {
            channels[place].add(patch_average, wheel, &analysis)?;
        }
        Ok(())
    };
    let mut longest = Longest::default();
    let mut visit = |reading: AxleBoxReading<'_>| {
        longest.hear(reading, file.rate());
        match reading {
            AxleBoxReading::Sample(accelerations, position) => {
                if !Run::push_each(&mut runs, accelerations, position).map_err(at_fault)? {
                    return Ok(());
                }
            }
            AxleBoxReading::Gap => {
                for run in &mut runs {
                    run.interrupt().map_err(at_fault)?;
                }
            }
        }
        // Segments of all channels are finished at once, as they have one place.
        let all = places.iter().zip(&mut runs);
        let finished = all.flat_map(|(place, run)| {
            let own = run.finished().into_iter();
            own.map(|patch_average| (*place, patch_average))
        });
        take(finished.collect()).map_err(at_fault)
    };
    let (warnings, end) = file.read(before, &mut visit, progress)?;
    visit(AxleBoxReading::Gap)?;
    // The end is none.
    longest.gaps -= 1;
    Ok((warnings, longest, end))
}
