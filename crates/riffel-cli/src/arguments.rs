//! The command line.

mod asked;
mod axlebox;
mod calibrate;
mod decide;
mod forecast;
mod listed_length;
pub(crate) mod network;
mod noise;
mod number;
mod page;
mod point_in_rail;
mod posterior;
mod roughness;
mod shakedown;
mod simulate;
mod stability;
mod study;

use std::path::{Path, PathBuf};

use clap::{Args, Parser, Subcommand, ValueEnum};
use riffel_answers::paper::Model;
use riffel_case::file::CaseFile;
use riffel_case::{Case, CaseContact, CurvingCase};
use riffel_keys::quantity::{Angle, Dimension, Force, Frequency, Length, Quantity, Ratio, Speed};
use riffel_keys::text_file::is_standard_input;
use riffel_keys::{CaseError, Language};

use crate::error::CliError;
use crate::messages::Verbosity;
use crate::staging::add_input;

pub(crate) use asked::{Asked, within};
pub(crate) use axlebox::AxleBox;
pub(crate) use calibrate::Calibrate;
pub(crate) use decide::Decide;
pub(crate) use forecast::{Compare, Forecast, Ground, HoldArgument, Horizon, Models, Spectra};
pub(crate) use listed_length::ListedLength;
pub(crate) use network::{Judged, Network, NetworkCommand};
pub(crate) use noise::Noise;
pub(crate) use page::Page;
use point_in_rail::PointInRail;
pub(crate) use posterior::Posterior;
pub(crate) use roughness::{Diagnose, DiagnosisArguments, Layout, Report, Roughness, Statistics};
pub(crate) use shakedown::Shakedown;
pub(crate) use simulate::{LengthPair, Simulate};
pub(crate) use stability::Stability;
pub(crate) use study::{Merge, Run, Sensitivity, Study, StudyCommand};

/// Predicts rail corrugation: which wavelengths grow on a track under traffic, how fast, and why.
#[derive(Parser)]
#[command(
    name = "riffel",
    version = env!("RIFFEL_VERSION"),
    after_help = "Example: riffel init case.toml && riffel map case.toml\n\n\
        Exit status: 0 done, 1 a validation check failed or a study to merge or analyse is not whole, 2 bad input or a file that \
        cannot be written, 130 stopped by Ctrl-C."
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,

    /// Print results and errors only: no notes, no progress.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,

    /// Print notes in full.
    #[arg(short, long, global = true)]
    verbose: bool,

    /// Language of results, reports, notes and errors, en or de; help, files of data and JSON are English.
    #[arg(
        long,
        global = true,
        value_name = "LANGUAGE",
        default_value = "en",
        hide_possible_values = true
    )]
    language: Spoken,
}

/// A language of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Spoken {
    /// English.
    En,
    /// German.
    De,
}

impl Arguments {
    /// The language in which it is said.
    pub(crate) fn language(&self) -> Language {
        match self.language {
            Spoken::En => Language::English,
            Spoken::De => Language::German,
        }
    }

    /// The options that every command has, as they are written.
    pub(crate) fn options_of_all(&self) -> impl Iterator<Item = &'static str> {
        let language = match self.language {
            Spoken::En => "--language=en",
            Spoken::De => "--language=de",
        };
        let quiet = self.quiet.then_some("--quiet");
        let verbose = self.verbose.then_some("--verbose");
        [language].into_iter().chain(quiet).chain(verbose)
    }

    /// How much is to be said beside the results.
    pub(crate) fn verbosity(&self) -> Verbosity {
        match (self.quiet, self.verbose) {
            (true, _) => Verbosity::Quiet,
            (false, true) => Verbosity::Verbose,
            (false, false) => Verbosity::Normal,
        }
    }
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Write a commented case file to start from, a traffic file or the plan of a study.
    Init(Init),
    /// The whole loop at one wavelength and speed.
    Point(Point),
    /// Growth over wavelength and speed: picture, page, tables.
    Map(Map),
    /// Receptance of track, wheel and contact over frequency.
    Receptance(Receptance),
    /// The wheelset: natural frequencies with their names, mode shapes, receptances at the contacts.
    Wheelset(Wheelset),
    /// A wheel along a rail in time: large amplitudes, loss of contact.
    Simulate(Simulate),
    /// The contact patch: its size and stiffness, creep curves of all laws, frequency response.
    Contact(Contact),
    /// Profiles of wheels and rails: outline and curvature, or where a wheelset touches its track.
    Profile(Profile),
    /// A bogie in a curve: creepages, forces and wear number of each wheel, and over the radius.
    Curve(Curve),
    /// A measured rail: roughness levels, statistics of wavelength bands, limits, what to grind.
    Roughness(Roughness),
    /// A rail as the axle boxes of a train felt it: roughness from acceleration, limits, what to grind.
    #[command(name = "axlebox")]
    AxleBox(AxleBox),
    /// Many lines and dates: surveys into a store, worst places, growth between dates, a plan of grinding.
    Network(Network),
    /// Dominant wavelengths of a measured rail, and what may have made them.
    Diagnose(Diagnose),
    /// One printable page: roughness, limits, what to grind, growth map, diagnosis, forecast, what-if.
    Report(Report),
    /// What becomes of a measured spectrum under traffic: levels, grinding interval, wear coefficient.
    Forecast(Forecast),
    /// What would help: growth on a case and on variants of it, side by side.
    Compare(Compare),
    /// How loud a train is on a rough rail, and what would make it quieter.
    Noise(Noise),
    /// Limits of shakedown over the friction that is used, and where a contact stands between them along a wave.
    Shakedown(Shakedown),
    /// Where over speed and friction the loop oscillates without any profile, as in squeal, how fast and at what frequency.
    Stability(Stability),
    /// Many cases of one kind: grids, samples of distributions, what matters and how sure it is.
    Study(Study),
    /// What measurements say of the uncertain values of a case.
    Calibrate(Calibrate),
    /// Which action pays, over the posterior of a calibration, and what to measure first.
    Decide(Decide),
    /// Figures 2-8 of Afferrante & Ciavarella (2009), each with its numbers.
    Figures(Figures),
    /// The page: the whole model in a browser on this machine.
    Serve(Serve),
    /// The page as one file, with a case inside: it opens without server and network.
    Page(Page),
    /// List the presets, or show one with the sources of its values.
    Presets(Presets),
    /// Answer a question in JSON on standard input: a command with its options as keys.
    Ask(Ask),
    /// Print the JSON schema of the case file, of the traffic file, of the plan of a study or of a question.
    Schema(Schema),
    /// Print completions of this command line for a shell.
    Completions(Completions),
    /// Print the manual page, or write those of all commands.
    Man(ManPages),
    /// Hold the program against reference numbers and published statements.
    Validate(Validate),
}

/// Where results go.
#[derive(Args, Default)]
pub(crate) struct ResultsArguments {
    /// Folder for the results, made if need be [default: named after the case or file and the command, as in case-map].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Print one JSON document, complex numbers as [re, im]; files are written only with --output.
    #[arg(long)]
    pub(crate) json: bool,
}

/// A case file with overrides.
#[derive(Args)]
pub(crate) struct CaseArguments {
    /// Case file, or - for standard input.
    #[arg(value_name = "CASE")]
    path: PathBuf,

    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

impl CaseArguments {
    /// Whether it is the case of a file without any override.
    pub(crate) fn is_just(&self, path: &Path) -> bool {
        let real = |path: &Path| std::fs::canonicalize(path).ok();
        self.overrides.is_empty() && real(path).is_some() && real(&self.path) == real(path)
    }

    /// A case named elsewhere than on its own place of the command line.
    pub(crate) fn of(path: &Path, overrides: &[String]) -> Self {
        Self {
            path: path.to_owned(),
            overrides: overrides.to_vec(),
        }
    }

    pub(crate) fn read(&self) -> miette::Result<Case> {
        Ok(protected(
            &self.path,
            Case::read(&self.path, &self.overrides)?,
        ))
    }

    /// The contact of the case alone.
    pub(crate) fn read_contact(&self) -> miette::Result<CaseContact> {
        let contact = CaseContact::read(&self.path, &self.overrides)?;
        protect(&self.path, &contact.file);
        Ok(contact)
    }

    /// The tables of curving of the case.
    pub(crate) fn read_curving(&self) -> miette::Result<CurvingCase> {
        Ok(CurvingCase::read(&self.path, &self.overrides)?)
    }

    /// The case with the wheel at another place of the bay.
    pub(crate) fn read_at(&self, position: Option<Quantity<Length>>) -> miette::Result<Case> {
        let Some(position) = position else {
            return self.read();
        };
        let case = Case::read(&self.path, &self.overrides)?;
        match case.edit(|keys| keys.track.position = Some(position)) {
            Err(CaseError::Changed { message, .. }) => Err(CliError::Position { message })?,
            Ok(case) if case.track.support_spacing().is_none() => Err(CliError::Position {
                message: format!(
                    "the track is the same everywhere along the rail with track.model = \"{}\"; choose \
                     one-layer-periodic or two-layer-periodic",
                    case.file.track.model.name()
                ),
            })?,
            case => Ok(protected(&self.path, case?)),
        }
    }

    /// The folder given for results, or one named after the case and what it holds.
    pub(crate) fn folder(&self, given: Option<&Path>, what: &str) -> PathBuf {
        given.map_or_else(
            || PathBuf::from(format!("{}-{what}", stem(&self.path))),
            Path::to_owned,
        )
    }
}

/// What results are named after that are made from a file.
pub(crate) fn stem(path: &Path) -> String {
    if is_standard_input(path) {
        return "stdin".to_owned();
    }
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// The case, whose file of a measured track must not be replaced by results.
fn protected(path: &Path, case: Case) -> Case {
    protect(path, &case.file);
    case
}

fn protect(path: &Path, file: &CaseFile) {
    if let Some(measurement) = &file.track.measurement {
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        add_input(folder.join(&measurement.file));
    }
}

/// The case with a contact that answers from one wavelength \[m\] to another.
pub(crate) fn covering(case: &Case, from: f64, to: f64) -> Result<Case, CliError> {
    // The window was not written by the user.
    case.covering(from, to)
        .map_err(|error| CliError::Wavelength {
            message: error.without_key(),
        })
}

/// The value of an argument that must be above zero, in SI.
pub(crate) fn positive<D: Dimension>(
    argument: &'static str,
    value: Quantity<D>,
) -> Result<f64, CliError> {
    /// Nothing about a railway is smaller or larger in SI.
    const RANGE: [f64; 2] = [1e-12, 1e12];
    let si = value.si();
    if (RANGE[0]..=RANGE[1]).contains(&si) {
        return Ok(si);
    }
    let rule = match si > 0.0 {
        true => format!("between {:e} and {:e} in SI", RANGE[0], RANGE[1]),
        false => "greater than zero".to_owned(),
    };
    Err(CliError::Argument {
        argument,
        value: value.to_string(),
        rule,
    })
}

#[derive(Args)]
#[command(after_help = "Example: riffel init --metro && riffel map metro.toml")]
pub(crate) struct Init {
    /// File to write [default: case.toml, or one named after what it holds, as metro.toml].
    #[arg(value_name = "FILE")]
    pub(crate) path: Option<PathBuf>,

    /// Write the case of a metro on a slab with direct fastenings.
    #[arg(long, group = "kind")]
    pub(crate) metro: bool,

    /// Write the case of a passenger train on a ballasted main line.
    #[arg(long, group = "kind")]
    pub(crate) main_line: bool,

    /// Write the case of a tram on a slab with direct fastenings.
    #[arg(long, group = "kind")]
    pub(crate) tram: bool,

    /// Write the case of laden freight wagons on a ballasted line.
    #[arg(long, group = "kind")]
    pub(crate) freight: bool,

    /// Write a traffic file for `riffel forecast`.
    #[arg(long, group = "kind")]
    pub(crate) traffic: bool,

    /// Write the plan of a study, on a case nominal.toml beside it.
    #[arg(long, group = "kind")]
    pub(crate) study: bool,

    /// Replace the file if it is there.
    #[arg(long)]
    pub(crate) force: bool,
}

#[derive(Args)]
#[command(
    after_help = "Example: riffel point case.toml --wavelength \"55 mm\" --speed \"108 km/h\""
)]
pub(crate) struct Point {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Wavelength, in metres or with its unit.
    #[arg(long, value_name = "LENGTH")]
    pub(crate) wavelength: Asked<Length>,

    /// Speed, in m/s or with its unit.
    #[arg(long, value_name = "SPEED")]
    pub(crate) speed: Asked<Speed>,

    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) position: Option<Quantity<Length>>,

    /// What the growth rate answers to: its derivative by every quantity of the case, by wavelength and speed.
    #[arg(long)]
    pub(crate) sensitivity: bool,

    /// On discrete supports: growth of the wave together with N neighbours on each side, 1/λ ± n/d, which the passing of
    /// supports makes of it; 3 is usual.
    #[arg(long, value_name = "N")]
    pub(crate) neighbours: Option<usize>,

    /// On discrete supports: growth along a stretch whose supports stand at drawn distances, normal about that of the case with
    /// this standard deviation, at most a quarter of it, and cut at three; 1 to 5 cm are usual.
    #[arg(long, value_name = "LENGTH")]
    pub(crate) spacing_deviation: Option<Quantity<Length>>,

    /// Supports of that stretch, 8 to 200 [default: 60].
    #[arg(long, value_name = "N", requires = "spacing_deviation")]
    pub(crate) supports: Option<usize>,

    /// Seed of the draw [default: 1].
    #[arg(long, value_name = "N", requires = "spacing_deviation")]
    pub(crate) seed: Option<u64>,

    /// Print one JSON document; complex numbers as [re, im].
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args)]
#[command(after_help = "Example: riffel map case.toml -o results --set contact.friction=0.3")]
pub(crate) struct Map {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Measured corrugation to draw on the map: a table with the columns wavelength, speed and label,
    /// values in SI, with their units, or with those in the head, as in wavelength_mm.
    #[arg(long, value_name = "CSV")]
    pub(crate) observations: Option<PathBuf>,

    /// Traffic file, for growth under the traffic [default: the usual traffic of a line of this kind].
    #[arg(long, value_name = "FILE", conflicts_with_all = ["wheels", "posterior"])]
    pub(crate) traffic: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) posterior: Posterior,

    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) position: Option<Quantity<Length>>,

    /// Growth over the bay between two supports as well: maps over a support, in mid-span and of the
    /// mean, and the curve of growth against position.
    #[arg(long)]
    pub(crate) bay: bool,

    /// Every wheel of the vehicle in its curve instead, side by side: maps in one scale, growth at the speed of the curve, and a
    /// table of mean states. Needs contact.from.
    #[arg(long, conflicts_with_all = ["bay", "observations"])]
    pub(crate) wheels: bool,

    /// Wavelength of the curve over the bay [default: where the mean grows fastest].
    #[arg(long, value_name = "LENGTH", requires = "bay", requires = "speed")]
    pub(crate) wavelength: Option<Asked<Length>>,

    /// Speed of the curve over the bay.
    #[arg(long, value_name = "SPEED", requires = "bay", requires = "wavelength")]
    pub(crate) speed: Option<Asked<Speed>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

#[derive(Args)]
#[command(after_help = "Example: riffel receptance case.toml --from \"50 Hz\" --to \"2 kHz\"")]
pub(crate) struct Receptance {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Lowest frequency, in Hz or with its unit [default: 20 Hz, or the lowest measured].
    #[arg(long, value_name = "FREQUENCY")]
    pub(crate) from: Option<Asked<Frequency>>,

    /// Highest frequency, in Hz or with its unit [default: 5 kHz, or the highest measured].
    #[arg(long, value_name = "FREQUENCY")]
    pub(crate) to: Option<Asked<Frequency>>,

    /// Number of frequencies, equally spaced in their logarithm.
    #[arg(long, value_name = "N", default_value_t = 600, value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    pub(crate) points: u32,

    /// Speed of the load, in m/s or with its unit [default: the highest of the map].
    #[arg(long, value_name = "SPEED")]
    pub(crate) speed: Option<Asked<Speed>>,

    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) position: Option<Quantity<Length>>,

    /// Direction of force and displacement; wheel and contact are vertical only.
    #[arg(long, value_enum, default_value_t = DirectionArgument::Vertical)]
    pub(crate) direction: DirectionArgument,

    /// Matrices of track and wheel along all axes x, y, z of the track, at the contact under study.
    #[arg(long, conflicts_with = "direction")]
    pub(crate) matrix: bool,

    /// Frequencies of --matrix, separated by commas, in Hz or with their unit, in place of --from, --to and --points.
    #[arg(long, value_name = "LIST", value_delimiter = ',', requires = "matrix", conflicts_with_all = ["from", "to", "points"])]
    pub(crate) frequencies: Vec<Asked<Frequency>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

#[derive(Args)]
#[command(after_help = "Example: riffel wheelset case.toml --frequencies 80,250,\"1 kHz\" --json")]
pub(crate) struct Wheelset {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Frequencies of the receptances, separated by commas, in Hz or with their unit [default: 600 from 20 Hz to
    /// 2 kHz].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) frequencies: Vec<Asked<Frequency>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

/// Direction of force and displacement.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DirectionArgument {
    /// Downward.
    Vertical,
    /// Across the track.
    Lateral,
    /// Along the rail.
    Longitudinal,
}

#[derive(Args)]
#[command(
    after_help = "Example: riffel contact case.toml --ratio 4,8,16 --set contact.hertz=exact"
)]
pub(crate) struct Contact {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Creepages of the creep curves, as ratios or with %, separated by commas [default: 40, to 1.2
    /// times that of full slip].
    #[arg(long, value_name = "CREEPAGES", value_delimiter = ',')]
    pub(crate) creepage: Vec<Quantity<Ratio>>,

    /// Wavelengths of the frequency response in semi-axes λ/a, separated by commas [default: 61, from 2
    /// to 100].
    #[arg(long, value_name = "RATIOS", value_delimiter = ',')]
    pub(crate) ratio: Vec<Quantity<Ratio>>,

    /// Stress in the rail under the mean state, at the surface and below, in place of creep curves and responses.
    #[arg(long, conflicts_with_all = ["creepage", "ratio"])]
    pub(crate) stress: bool,

    /// Stress at a point too, x/a, y/b, z/a with z into the rail, as --stress-at=-0.8,0,0.1; may be repeated.
    #[arg(long, value_name = "X,Y,Z", requires = "stress")]
    pub(crate) stress_at: Vec<PointInRail>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

/// By what a profile is laid on the nominal one.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Alignment {
    /// A wheel by its flange back and the tip of its flange.
    Flange,
    /// A rail by its field side, which wheels do not touch.
    FieldSide,
    /// By nothing.
    AsWritten,
}

/// How coordinates of profiles stand.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Orientation {
    /// As the shape tells.
    Found,
    /// x to the field side, y upward.
    AsWritten,
    /// x to the gauge side.
    Mirrored,
    /// y downward.
    UpsideDown,
    /// x to the gauge side, y downward.
    Turned,
}

#[derive(Args)]
#[command(
    after_help = "Examples:\n  riffel profile S1002 60E1\n  riffel profile wheel.whl --against S1002\n  riffel profile case.toml --wheelset --yaw \"5 mrad\" --lateral-shift \"-3 mm,0 mm,3 mm\"\n  riffel profile case.toml --wheelset --load \"60 kN\""
)]
pub(crate) struct Profile {
    /// Nominal names, or files: two columns x, y, or of MiniProf, Simpack or Vampire; with --wheelset a case file.
    #[arg(value_name = "FILE", required = true)]
    pub(crate) files: Vec<PathBuf>,

    /// Wear against a nominal profile or an earlier file.
    #[arg(long, value_name = "NAME", conflicts_with = "wheelset")]
    pub(crate) against: Option<String>,

    /// By what profiles are laid on the nominal one [default: flange of wheels, field-side of rails].
    #[arg(long, value_enum, value_name = "PART", requires = "against")]
    pub(crate) align: Option<Alignment>,

    /// Inclination of the rail in its coordinates, as in 1:40 [default: none].
    #[arg(long, value_name = "SLOPE", requires = "against")]
    pub(crate) inclination: Option<String>,

    /// Depth below the nominal crown at which wear of the gauge face is measured [default: 14 mm].
    #[arg(long, value_name = "LENGTH", requires = "against")]
    pub(crate) gauge_height: Option<Quantity<Length>>,

    /// How coordinates of files stand [default: as-written in columns, found in other formats].
    #[arg(long, value_enum, value_name = "WAY", conflicts_with = "wheelset")]
    pub(crate) orientation: Option<Orientation>,

    /// Smooth the points of files, which scatter with this standard deviation across the profile.
    #[arg(long, value_name = "LENGTH", conflicts_with = "wheelset")]
    pub(crate) scatter: Option<Quantity<Length>>,

    /// Where the wheelset of a case touches its track, and its equivalent conicity.
    #[arg(long)]
    pub(crate) wheelset: bool,

    /// Yaw of the wheelset, in rad or with its unit.
    #[arg(long, value_name = "ANGLE", requires = "wheelset")]
    pub(crate) yaw: Option<Quantity<Angle>>,

    /// Lateral shifts, separated by commas, in metres or with their unit [default: from -10 mm to 10 mm every 0.1 mm].
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        requires = "wheelset"
    )]
    pub(crate) lateral_shift: Vec<Quantity<Length>>,

    /// Normal force on each wheel, in N or with its unit: patch, pressure and stiffness of both contacts, at the shift 0 or those
    /// of --lateral-shift.
    #[arg(long, value_name = "FORCE", requires = "wheelset")]
    pub(crate) load: Option<Quantity<Force>>,

    /// Override a value of the case, as in --set "profiles.gauge=1432 mm"; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "wheelset")]
    pub(crate) overrides: Vec<String>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

#[derive(Args)]
#[command(
    after_help = "Examples:\n  riffel curve case.toml --set \"curve.radius=300 m\"\n  riffel curve case.toml --radius \"300 m,600 m,1200 m\" --json"
)]
pub(crate) struct Curve {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Radii of the picture and its table, separated by commas, above zero to the right, each at the lateral acceleration of
    /// the case [default: from a fifth to twenty times that of the case].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) radius: Vec<ListedLength>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

#[derive(Args)]
#[command(after_help = "Example: riffel schema --traffic > traffic.schema.json")]
pub(crate) struct Schema {
    /// That of the traffic file.
    #[arg(long, conflicts_with = "study")]
    pub(crate) traffic: bool,

    /// That of the plan of a study.
    #[arg(long)]
    pub(crate) study: bool,

    /// That of a question which `riffel ask` answers: a command of the program.
    #[arg(long, value_name = "NAME", num_args = 1..=2, conflicts_with_all = ["traffic", "study"])]
    pub(crate) question: Vec<String>,
}

#[derive(Args)]
#[command(
    after_help = "Example: echo '{\"case\": \"case.toml\", \"wavelength\": \"56 mm\", \"speed\": 30}' | riffel ask point\n\n\
        The keys are the options of the command without dashes, with _ between words; a case, a traffic or a table of \
        columns may stand in place of its file. The answer is that of --json; notes and errors are lines of JSON on \
        standard error."
)]
pub(crate) struct Ask {
    /// The command, such as noise or network worst.
    #[arg(value_name = "NAME", required = true, num_args = 1..=2)]
    pub(crate) name: Vec<String>,
}

#[derive(Args)]
#[command(after_help = "Examples: riffel validate hertz wheelset; riffel validate --field --json")]
pub(crate) struct Validate {
    /// Only the checks with one of these words in their names, which are those of the tests.
    #[arg(value_name = "WORD", conflicts_with = "field")]
    pub(crate) words: Vec<String>,

    /// Predict sites whose corrugation is published, and hold the predictions against what was measured.
    #[arg(long)]
    pub(crate) field: bool,

    /// Print a JSON document of the sites.
    #[arg(long, requires = "field")]
    pub(crate) json: bool,

    /// Samples of the choices of each site, 1 to 100000.
    #[arg(long, value_name = "N", requires = "field", default_value_t = 16,
          value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(crate) samples: u32,

    /// Seed of the samples.
    #[arg(long, value_name = "S", requires = "field", default_value_t = 1)]
    pub(crate) seed: u64,
}

#[derive(Args)]
#[command(after_help = "Example: riffel figures --model non-steady -o figures")]
pub(crate) struct Figures {
    /// Folder for the figures, made if need be.
    #[arg(short, long, value_name = "DIR", default_value = "figures")]
    pub(crate) output: PathBuf,

    /// How the contact answers to oscillations.
    #[arg(long, value_enum, default_value_t = ModelArgument::QuasiStatic)]
    pub(crate) model: ModelArgument,
}

/// How the contact answers to oscillations.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ModelArgument {
    /// At once, by the paper's creep law: the figures as printed.
    QuasiStatic,
    /// By a spring and a dashpot in series, with the paper's creep law.
    SpringDashpot,
    /// By the exact theory of non-steady rolling.
    NonSteady,
}

impl From<ModelArgument> for Model {
    fn from(argument: ModelArgument) -> Self {
        match argument {
            ModelArgument::QuasiStatic => Self::QuasiStatic,
            ModelArgument::SpringDashpot => Self::SpringDashpot,
            ModelArgument::NonSteady => Self::NonSteady,
        }
    }
}

#[derive(Args)]
#[command(after_help = "Example: riffel serve --open")]
pub(crate) struct Serve {
    /// Port to listen on; 0 takes any that is free.
    #[arg(long, value_name = "N", default_value_t = 8311)]
    pub(crate) port: u16,

    /// Show the page in the browser.
    #[arg(long)]
    pub(crate) open: bool,

    /// Address to listen on. Any but 127.0.0.1 lets other machines use this one: there is no password.
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    pub(crate) address: std::net::IpAddr,
}

#[derive(Args)]
#[command(after_help = "Example: riffel presets BS113A")]
pub(crate) struct Presets {
    /// Preset to show.
    #[arg(value_name = "NAME")]
    pub(crate) name: Option<String>,

    /// Print one JSON document: each value as written and in SI, with its unit and its source.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  \
        riffel completions bash > ~/.local/share/bash-completion/completions/riffel\n  \
        riffel completions zsh > ~/.zfunc/_riffel\n  \
        riffel completions fish > ~/.config/fish/completions/riffel.fish")]
pub(crate) struct Completions {
    /// The shell.
    #[arg(value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Args)]
#[command(after_help = "Example: riffel man -o ~/.local/share/man/man1 && man riffel-map")]
pub(crate) struct ManPages {
    /// Folder for the pages of all commands, made if need be [default: the first page, on standard output].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}
