//! A rail as the axle boxes of a train felt it.

mod document;
mod figure;
mod listening;
mod pads;
mod wheels;

use std::io::{self, Write};
use std::path::PathBuf;

use riffel::axlebox::RunSettings;
use riffel::contact::ContactFilter;
use riffel::roughness::{GrindSettings, RailAnalysis, ThirdOctave, WavelengthBand};
use riffel_case::Case;
use riffel_keys::{CaseError, Message, fixed, number, say};
use riffel_plot::LineFigure;
use riffel_rail::{AxleBoxFile, DefectsAre, LimitTable, RunEnd, check_felt, defects_in_words, rail_in_words};

pub use document::AxleBoxDocument;
pub use wheels::{WheelMark, WheelMarkKind};

use crate::AnswerError;
use crate::roughness::{Judged, RailAnswer, Verdict, tables, worst_first};
use listening::{Heard, Longest, listen, lower};

/// What is asked of axle boxes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxleBoxRequest {
    /// Shortest wavelength \[m\].
    pub shortest: f64,
    /// Longest wavelength \[m\].
    pub longest: f64,
    /// Lowest speed at which the train is listened to \[m/s\].
    pub slowest: f64,
    /// Whether roughness is that of the rail, and not what the patch lets through of it.
    pub contact_filter: bool,
    /// Whether welds, joints and squats stay in the levels.
    pub keep_defects: bool,
    /// Length of a block \[m\].
    pub block: f64,
    /// What is ground as one.
    pub grinding: GrindSettings,
}

impl Default for AxleBoxRequest {
    /// As [`RunSettings::at_rate`], in blocks of 10 m.
    fn default() -> Self {
        let run = RunSettings::at_rate(1.0);
        Self {
            shortest: run.shortest,
            longest: run.longest,
            slowest: run.slowest,
            contact_filter: false,
            keep_defects: false,
            block: 10.0,
            grinding: GrindSettings::default(),
        }
    }
}

impl AxleBoxRequest {
    fn run(&self, case: &Case, sampling_rate: f64) -> RunSettings {
        RunSettings {
            sampling_rate,
            shortest: self.shortest,
            longest: self.longest,
            slowest: self.slowest,
            contact_filter: self.contact_filter.then(|| ContactFilter::of(&case.hertz)),
        }
    }
}

/// A band of the level of a one-third octave \[dB re 1 µm\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelRange {
    /// The one-third octave.
    pub band: ThirdOctave,
    /// With pads as in the case.
    pub level: f64,
    /// Lowest and highest with pads of half to twice the stiffness, or those of the case where it has no pads; the lowest without waves
    /// that may be the wheel's.
    pub range: [f64; 2],
}

/// A channel with all that was computed of it.
pub struct AxleBoxRail {
    /// What is judged, as of a trolley's record.
    pub rail: RailAnswer,
    /// Lowest, mean and highest speed \[m/s\].
    pub speeds: [f64; 3],
    /// Wavelengths that are known somewhere.
    pub known: WavelengthBand,
    /// Levels with what unknown pads leave open.
    pub levels: Vec<LevelRange>,
}

/// Roughness from axle-box acceleration.
pub struct AxleBoxAnswer {
    /// The files.
    pub files: Vec<PathBuf>,
    /// The channels, the worst first.
    pub rails: Vec<AxleBoxRail>,
    /// What turns with wheels, and is left out of their rails.
    pub wheels: Vec<WheelMark>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

impl AxleBoxAnswer {
    /// Runs over a line on the track and under the wheel of a case; `progress` is told of bytes read.
    ///
    /// Channels of one name are one rail, whatever file they are in; a file without an odometer goes on where the one before of the
    /// same channels ended, if its times do. Memory does not grow with the length of the files but by
    /// a row for each block.
    ///
    /// # Errors
    /// [`AnswerError::Case`] for a file that is refused, with its line, or a train that never runs fast enough;
    /// [`AnswerError::Argument`] for two tables of RMS limits; [`AnswerError::Physics`] for wavelengths less than an octave
    /// apart.
    pub fn new(
        case: &Case,
        files: &[(PathBuf, AxleBoxFile)],
        limits: &[LimitTable],
        request: &AxleBoxRequest,
        progress: &dyn Fn(usize),
    ) -> Result<Self, AnswerError> {
        let mut heard: Vec<Heard> = Vec::new();
        let mut remarks = Vec::new();
        let mut ends: Vec<(&[String], RunEnd)> = Vec::new();
        for given in files {
            let (path, file) = given;
            let is_same = |(names, _): &&(&[String], RunEnd)| names.iter().any(|name| file.channels().contains(name));
            let before = ends.iter().rev().find(is_same).map(|(_, end)| *end);
            let heard_of = listen(case, given, limits, request, progress, before, &mut heard)?;
            let (warnings, longest, end) = heard_of;
            ends.push((file.channels(), end));
            if longest.gaps > 0 && heard.iter().all(Heard::is_empty) {
                let message = too_short(&longest, &request.run(case, file.rate()), warnings);
                return Err(CaseError::data(path, message).into());
            }
            let said = warnings.into_iter();
            let file = path.display().to_string();
            remarks.extend(said.map(|warning| warning.about(file.as_str())));
        }
        let Some((path, _)) = files.first().filter(|_| heard.iter().all(Heard::is_empty)) else {
            return Self::judged(case, files, limits, request, heard, remarks);
        };
        let slow =
            say!(train_is_too_slow, slowest = fixed(3.6 * request.slowest, 1), longest = number(request.longest));
        Err(CaseError::data(path, slow).into())
    }

    fn judged(
        case: &Case,
        files: &[(PathBuf, AxleBoxFile)],
        limits: &[LimitTable],
        request: &AxleBoxRequest,
        heard: Vec<Heard>,
        mut remarks: Vec<Message>,
    ) -> Result<Self, AnswerError> {
        let heard: Vec<Heard> = heard.into_iter().filter(|one| !one.is_empty()).collect();
        let several = heard.len() > 1;
        let (mut rails, mut wheels) = (Vec::new(), Vec::new());
        for channel in heard {
            let (marks, said) = wheels::marks(&channel.name, &channel.wheel);
            wheels.extend(marks);
            remarks.extend(said);
            let (speeds, known, name) = (channel.speeds(), channel.known, channel.name);
            let Some(analysis) = RailAnalysis::joined(channel.parts) else {
                continue;
            };
            let levels = analysis.spectrum.levels();
            let sound = check_felt(&name, levels.iter().map(|level| level.level), known);
            if let (Err(message), Some((path, _))) = (sound, files.first()) {
                return Err(CaseError::data(path, message).into());
            }
            let mut levels = pads::ranges(case, &analysis.spectrum, speeds[1])?;
            for level in &mut levels {
                level.range[0] -= lower(&channel.without, level.band);
            }
            remarks.extend(wheels::bound(&name, &levels, &channel.without));
            let words = several.then(|| rail_in_words(&name));
            let verdicts = Verdict::all(limits, &analysis.spectrum, Some(&analysis)).into_iter();
            rails.push(AxleBoxRail {
                levels,
                speeds,
                known,
                rail: RailAnswer {
                    sections: analysis.grind(&request.grinding),
                    verdicts: verdicts.map(|verdict| verdict.on_rail(&name).of(words.as_ref())).collect(),
                    name,
                    analysis,
                },
            });
        }
        worst_first(&mut rails);
        let are = match request.keep_defects {
            true => DefectsAre::Judged,
            false => DefectsAre::OutOfLevels,
        };
        let defects =
            rails.iter().flat_map(|AxleBoxRail { rail, .. }| defects_in_words(&rail.name, &rail.analysis.defects, are));
        remarks.extend(defects);
        remarks.extend(validity(case, request));
        Ok(Self { files: files.iter().map(|(path, _)| path.clone()).collect(), rails, wheels, remarks })
    }

    /// First and last place of all channels \[m\].
    pub fn ends(&self) -> [f64; 2] {
        let stretches = || self.rails.iter().flat_map(|rail| &rail.rail.analysis.stretches);
        let from = stretches().map(|ends| ends.0).fold(f64::INFINITY, f64::min);
        let to = stretches().map(|ends| ends.1).fold(f64::NEG_INFINITY, f64::max);
        [from, to]
    }

    /// Levels with their limit, and the moving RMS along each rail.
    pub fn figure(&self, case: &Case, limits: &[LimitTable]) -> LineFigure {
        figure::figure(self, case, limits)
    }

    /// The answer as data: what `riffel axlebox --json` prints.
    pub fn document(&self) -> AxleBoxDocument<'_> {
        document::document(self)
    }

    /// Levels of each rail, which `riffel roughness`, `diagnose` and `forecast` read.
    ///
    /// # Errors
    /// Those of the file.
    pub fn spectrum_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["rail", "wavelength_m", "level_db"])?;
        for rail in &self.rails {
            for level in &rail.levels {
                writer.serialize((&rail.rail.name, level.band.wavelength(), level.level))?;
            }
        }
        writer.flush()
    }

    /// Levels of each rail with what unknown pads leave open.
    ///
    /// # Errors
    /// Those of the file.
    pub fn pads_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["rail", "wavelength_m", "level_db", "lowest_db", "highest_db"])?;
        for rail in &self.rails {
            for level in &rail.levels {
                let [lowest, highest] = level.range;
                let name = &rail.rail.name;
                writer.serialize((name, level.band.wavelength(), level.level, lowest, highest))?;
            }
        }
        writer.flush()
    }

    /// RMS of each block, and the highest moving RMS in it.
    ///
    /// # Errors
    /// Those of the file.
    pub fn block_csv(&self, file: &mut impl Write) -> io::Result<()> {
        tables::block_csv(self.rails.iter().map(|rail| &rail.rail), file)
    }

    /// What to grind of each rail, the worst first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn grind_csv(&self, file: &mut impl Write) -> io::Result<()> {
        tables::grind_csv(self.rails.iter().map(|rail| &rail.rail), file)
    }
}

impl Judged for AxleBoxRail {
    fn verdicts(&self) -> &[Verdict] {
        &self.rail.verdicts
    }
}

/// Why nothing is heard between gaps.
fn too_short(longest: &Longest, run: &RunSettings, warnings: Vec<Message>) -> Message {
    let (length, speed) = (fixed(longest.length, 1), fixed(3.6 * longest.speed, 1));
    let said = Message::one_after_other(warnings).unwrap_or_else(|| Message::verbatim(""));
    if longest.speed < run.slowest {
        return say!(
            stretch_is_too_slow,
            length = length,
            speed = speed,
            slowest = fixed(3.6 * run.slowest, 1),
            said = said
        );
    }
    let least = 2.0 * run.lost_at_ends(longest.speed) + 4.0 * run.longest;
    say!(
        stretch_is_too_short,
        length = length,
        least = fixed(least, 1),
        speed = speed,
        longest = number(run.longest),
        said = said
    )
}

/// What the model leaves out.
fn validity(case: &Case, request: &AxleBoxRequest) -> Vec<Message> {
    let mut remarks = vec![say!(roughness_of_rail_and_wheel)];
    if !request.contact_filter {
        let patch = 2e3 * case.hertz.semi_axis_longitudinal();
        remarks.push(say!(roughness_through_patch, patch = fixed(patch, 0)));
    }
    if case.file.wheelset.is_some() {
        remarks.push(say!(axle_box_moves_as_wheelset));
    }
    if case.file.train.is_some() {
        remarks.push(say!(waves_of_other_wheels_left_out));
    }
    remarks
}
