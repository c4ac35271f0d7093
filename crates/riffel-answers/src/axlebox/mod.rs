//! A rail as the axle boxes of a train felt it.

mod figure;
mod listening;
mod pads;
mod question;
mod wheels;

use std::path::PathBuf;
use std::sync::Arc;

use riffel::axlebox::RunSettings;
use riffel::contact::ContactFilter;
use riffel::roughness::{GrindSettings, RailAnalysis, ThirdOctave, WavelengthBand};
use riffel_case::Case;
use riffel_keys::{CaseError, Message, fixed, number, say};
use riffel_plot::LineFigure;
use riffel_rail::{
    AxleBoxFile, DefectsAre, LimitTable, RunEnd, check_axle_box_levels, defects_in_words, name_in_words,
};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

pub use question::AxleBoxQuestion;
pub use wheels::{WheelMark, WheelMarkKind};

use crate::roughness::{GroundSection, Judged, RailAnswer, Verdict, tables, worst_first};
use crate::{Answer, Result, Rows, Table, parameters};
use listening::{ChannelSoFar, Longest, listen, lower};

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
    /// Settings of [`RunSettings::at_rate`], in blocks of 10 m.
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

impl Serialize for LevelRange {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [lowest, highest] = self.range;
        let mut level = serializer.serialize_struct("LevelRange", 4)?;
        level.serialize_field("wavelength_m", &self.band.wavelength())?;
        level.serialize_field("level_db", &self.level)?;
        level.serialize_field("lowest_db", &lowest)?;
        level.serialize_field("highest_db", &highest)?;
        level.end()
    }
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

impl Serialize for AxleBoxRail {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (of, [slowest, mean, fastest]) = (&self.rail, self.speeds);
        let mut rail = serializer.serialize_struct("AxleBoxRail", 13)?;
        rail.serialize_field("name", &of.name)?;
        rail.serialize_field("length_m", &of.length_m)?;
        rail.serialize_field("lowest_speed_m_per_s", &slowest)?;
        rail.serialize_field("mean_speed_m_per_s", &mean)?;
        rail.serialize_field("highest_speed_m_per_s", &fastest)?;
        rail.serialize_field("shortest_wavelength_m", &self.known.from())?;
        rail.serialize_field("longest_wavelength_m", &self.known.to())?;
        rail.serialize_field("spectrum", &self.levels)?;
        rail.serialize_field("bands", &of.bands)?;
        rail.serialize_field("verdicts", &of.verdicts)?;
        rail.serialize_field("defects", &of.defects)?;
        rail.serialize_field("grind", &GroundSection::of_rail(of).collect::<Vec<_>>())?;
        rail.serialize_field("grind_share_of_length", &of.grind_share_of_length)?;
        rail.end()
    }
}

/// Roughness from axle-box acceleration.
#[derive(Serialize)]
pub struct AxleBoxAnswer {
    riffel_version: &'static str,
    files: Vec<String>,
    /// The channels, the worst first.
    pub rails: Vec<AxleBoxRail>,
    /// What turns with wheels, and is left out of their rails.
    pub wheels: Vec<WheelMark>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
    /// Parameters of the case, for the figure.
    #[serde(skip)]
    parameters: String,
    #[serde(skip)]
    limits: Vec<LimitTable>,
    /// And what the reader should know of the case.
    #[serde(skip)]
    all_remarks: Vec<Message>,
}

impl AxleBoxAnswer {
    /// Runs over a line on the track and under the wheel of a case; `progress` is told of bytes read.
    ///
    /// Channels of one name are one rail, whatever file they are in; a file without an odometer goes on where the one before of the
    /// same channels ended, if its times do. Memory does not grow with the length of the files but by
    /// a row for each block.
    ///
    /// # Errors
    /// [`AnswerError::Case`](crate::AnswerError::Case) for a file that is refused, with its line, or a train that never runs fast enough;
    /// [`AnswerError::Argument`](crate::AnswerError::Argument) for two tables of RMS limits; [`AnswerError::Physics`](crate::AnswerError::Physics) for wavelengths less than an octave
    /// apart.
    pub fn new(
        case: &Case,
        files: &[(PathBuf, Arc<AxleBoxFile>)],
        limits: &[LimitTable],
        request: &AxleBoxRequest,
        progress: &dyn Fn(usize),
    ) -> Result<Self> {
        let mut channels: Vec<ChannelSoFar> = Vec::new();
        let mut remarks = Vec::new();
        let mut ends: Vec<(&[String], RunEnd)> = Vec::new();
        for given in files {
            let (path, file) = given;
            let is_same = |(names, _): &&(&[String], RunEnd)| names.iter().any(|name| file.channels().contains(name));
            let before = ends.iter().rev().find(is_same).map(|(_, end)| *end);
            let read = listen(case, given, limits, request, progress, before, &mut channels)?;
            let (warnings, longest, end) = read;
            ends.push((file.channels(), end));
            if longest.gaps > 0 && channels.iter().all(ChannelSoFar::is_empty) {
                let message = too_short(&longest, &request.run(case, file.rate()), warnings);
                return Err(CaseError::data(path, message).into());
            }
            let said = warnings.into_iter();
            let file = path.display().to_string();
            remarks.extend(said.map(|warning| warning.about(file.as_str())));
        }
        let Some((path, _)) = files.first().filter(|_| channels.iter().all(ChannelSoFar::is_empty)) else {
            return Self::judged(case, files, limits, request, channels, remarks);
        };
        let slow =
            say!(train_is_too_slow, slowest = fixed(3.6 * request.slowest, 1), longest = number(request.longest));
        Err(CaseError::data(path, slow).into())
    }

    fn judged(
        case: &Case,
        files: &[(PathBuf, Arc<AxleBoxFile>)],
        limits: &[LimitTable],
        request: &AxleBoxRequest,
        channels: Vec<ChannelSoFar>,
        mut remarks: Vec<Message>,
    ) -> Result<Self> {
        let channels: Vec<ChannelSoFar> = channels.into_iter().filter(|one| !one.is_empty()).collect();
        let several = channels.len() > 1;
        let (mut rails, mut wheels) = (Vec::new(), Vec::new());
        for channel in channels {
            let (marks, said) = wheels::marks(&channel.name, &channel.wheel);
            wheels.extend(marks);
            remarks.extend(said);
            let (speeds, known, name) = (channel.speeds(), channel.known, channel.name);
            let Some(analysis) = RailAnalysis::joined(channel.parts) else {
                continue;
            };
            let levels = analysis.spectrum.levels();
            let sound = check_axle_box_levels(&name, levels.iter().map(|level| level.level), known);
            if let (Err(message), Some((path, _))) = (sound, files.first()) {
                return Err(CaseError::data(path, message).into());
            }
            let mut levels = pads::ranges(case, &analysis.spectrum, speeds[1])?;
            for level in &mut levels {
                level.range[0] -= lower(&channel.without, level.band);
            }
            remarks.extend(wheels::bound(&name, &levels, &channel.without));
            rails.push(AxleBoxRail {
                levels,
                speeds,
                known,
                rail: RailAnswer::new(name, analysis, several, limits, &request.grinding),
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
        Ok(Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            files: files.iter().map(|(path, _)| path.display().to_string()).collect(),
            rails,
            wheels,
            all_remarks: remarks.iter().chain(&case.remarks).cloned().collect(),
            remarks,
            parameters: parameters(case),
            limits: limits.to_vec(),
        })
    }

    /// First and last place of all channels \[m\].
    pub fn ends(&self) -> [f64; 2] {
        let stretches = || self.rails.iter().flat_map(|rail| &rail.rail.analysis.stretches);
        let from = stretches().map(|ends| ends.0).fold(f64::INFINITY, f64::min);
        let to = stretches().map(|ends| ends.1).fold(f64::NEG_INFINITY, f64::max);
        [from, to]
    }

    /// What is judged of each.
    fn rails_judged(&self) -> impl Iterator<Item = &RailAnswer> {
        self.rails.iter().map(|rail| &rail.rail)
    }

    fn verdicts(&self) -> Vec<Message> {
        let verdicts = self.rails_judged().flat_map(|rail| &rail.verdicts);
        verdicts.map(|verdict| verdict.sentence.clone()).collect()
    }

    /// Levels of each rail with what unknown pads leave open.
    fn pads(&self) -> Table {
        let rows: Vec<(&RailAnswer, &LevelRange)> =
            self.rails.iter().flat_map(|rail| rail.levels.iter().map(|level| (&rail.rail, level))).collect();
        Table {
            name: "pads",
            columns: vec![
                rows.names("rail", |(rail, _)| &rail.name),
                rows.exact("wavelength_m", |(_, level)| level.band.wavelength()),
                rows.exact("level_db", |(_, level)| level.level),
                rows.exact("lowest_db", |(_, level)| level.range[0]),
                rows.exact("highest_db", |(_, level)| level.range[1]),
                rows.shown(say!(rail_word), |(rail, _)| name_in_words(&rail.name)),
                rows.numbers(say!(wavelength_of_band), |(_, level)| level.band.nominal_millimetres()),
                rows.digits(say!(felt_level_column), 1, |(_, level)| level.level),
                rows.shown(say!(with_pads_column), |(_, level)| {
                    let [low, high] = level.range.map(|end| number(format!("{end:.1}")));
                    say!(from_to, from = low, to = high)
                }),
            ],
        }
    }
}

impl Answer for AxleBoxAnswer {
    fn name(&self) -> &'static str {
        "axlebox"
    }

    fn introduction(&self) -> Vec<Message> {
        let rails = self.rails.iter().map(|rail| {
            let [slowest, _, fastest] = rail.speeds.map(|speed| fixed(3.6 * speed, 0));
            say!(
                rail_is_heard,
                rail = rail.rail.name.as_str(),
                length = fixed(rail.rail.length_m, 1),
                slowest,
                fastest,
                shortest = fixed(1e3 * rail.known.from(), 1),
                longest = fixed(1e3 * rail.known.to(), 0)
            )
        });
        rails.collect()
    }

    /// Levels, which `riffel roughness`, `diagnose` and `forecast` read, first.
    fn tables(&self) -> Vec<Table> {
        let levels = self.rails_judged().map(|rail| (&*rail.name, &rail.analysis.spectrum));
        vec![
            tables::levels(levels),
            self.pads(),
            tables::bands(self.rails_judged()),
            tables::blocks(self.rails_judged()),
            tables::shown_grind(self.rails_judged(), tables::SHOWN),
            tables::grind(self.rails_judged()),
        ]
    }

    fn above(&self, table: &str) -> Vec<Message> {
        match table {
            tables::GRIND => self.verdicts(),
            _ => Vec::new(),
        }
    }

    fn sentences(&self) -> Vec<Message> {
        match self.rails_judged().map(|rail| rail.sections.len()).sum() {
            0 => self.verdicts(),
            sections => tables::more(sections).into_iter().collect(),
        }
    }

    fn figure(&self) -> LineFigure {
        figure::figure(self)
    }

    fn remarks(&self) -> &[Message] {
        &self.all_remarks[..]
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
        return say!(stretch_is_too_slow, length, speed, slowest = fixed(3.6 * run.slowest, 1), said);
    }
    let least = 2.0 * run.lost_at_ends(longest.speed) + 4.0 * run.longest;
    say!(stretch_is_too_short, length, least = fixed(least, 1), speed, longest = number(run.longest), said)
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
