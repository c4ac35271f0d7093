//! A table of blocks along the rails of a line: what `riffel roughness` and `riffel axlebox` write as `blocks.csv`.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use jiff::civil::Date;
use riffel::roughness::WavelengthBand;
use riffel_keys::table::label;
use riffel_keys::{CaseError, seal, text_file};
use riffel_rail::{ends_of_dates, is_device_column, is_of_time, is_rail_column};
use serde::Serialize;

use crate::survey_text::SurveyText;

/// Roughest that a band can be \[m\]: what is more is another unit.
const ROUGHEST: f64 = 0.01;
/// Smoothest that the roughest block of a survey can be \[m\]: a tenth of what rails have that were polished for noise.
const SMOOTHEST: f64 = 1e-7;
/// Farthest place \[m\].
pub(crate) const FARTHEST: f64 = 1e8;
/// By how much blocks may overlap that join on \[m\]: places are rounded.
const ROUNDING: f64 = 1e-3;
/// How far the place of a defect may be off its block \[m\]: it is written to a centimetre.
const PLACED: f64 = 0.01;
/// Farthest that the places of a rail go back \[m\]: a kilometre that is too long goes back by less than itself.
pub(crate) const FARTHEST_BACK: f64 = 1e3;
/// Blocks of a stretch, at least: of windows that overlap, and of two rails in one column, every block goes back.
const STRETCH: usize = 2;

/// Where the places of a rail go back, as at the end of a long kilometre: two stretches of it have the same places.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GoesBack {
    /// The rail.
    pub rail: String,
    /// Line of the file.
    pub line: usize,
    /// Where the stretch before ends \[m\].
    pub end_m: f64,
    /// Where the next one begins \[m\].
    pub from_m: f64,
}

/// Names of instruments in a survey, at most: columns of more are what a sensor showed, not which it was.
const MOST_DEVICES: usize = 16;

/// How far the blocks of a rail have come.
struct RailProgress {
    rail: usize,
    /// Where its first block begins \[m\].
    first: f64,
    /// Where the last one ends \[m\].
    end: f64,
    /// Blocks since it last went back.
    blocks: usize,
}

impl RailProgress {
    /// Take the next block; whether it goes back to it.
    fn goes_back(&mut self, name: &str, block: &Block) -> Result<bool, String> {
        let back = self.end - block.from;
        let goes_back = back > ROUNDING;
        let is_again = (block.from - self.first).abs() < block.to - block.from;
        if goes_back && (self.blocks < STRETCH || back > FARTHEST_BACK || is_again) {
            return Err(format!(
                "{name}: the block begins at {:.3} m, before the end of the one above, {:.3} m; blocks of a rail must rise and not \
                 overlap, but for a long kilometre, which goes back by {FARTHEST_BACK} m at most and not to the first block",
                block.from, self.end
            ));
        }
        self.blocks = if goes_back { 1 } else { self.blocks + 1 };
        self.end = block.to;
        Ok(goes_back)
    }
}

/// One block of one rail.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Block {
    /// Number of the rail, in the order in which they come.
    pub(crate) rail: usize,
    /// First place \[m\].
    pub(crate) from: f64,
    /// Last place \[m\].
    pub(crate) to: f64,
    /// RMS in each band \[m\]; NaN where not known.
    pub(crate) rms: Vec<f64>,
    /// Where its welds, joints and squats are \[m\].
    pub(crate) defects: Vec<f64>,
}

/// A survey that was read once, from end to end, and found right.
#[derive(Debug, Clone)]
pub struct SurveyFile {
    path: PathBuf,
    columns: Columns,
    /// SHA-256 of the file.
    pub(crate) sha256: String,
    /// Names of the rails.
    pub(crate) rails: Vec<String>,
    /// Names of the file in whose place there are others.
    pub(crate) renamed: BTreeMap<String, String>,
    /// First and last place \[m\].
    pub(crate) ends: [f64; 2],
    /// Where places go back.
    pub(crate) goes_back: Vec<GoesBack>,
    rows: u64,
    /// First and last date of the blocks, where they have dates.
    pub(crate) dates: Option<[Date; 2]>,
    /// The instruments, where a column names them.
    pub(crate) devices: Vec<String>,
    /// Length that most blocks have, to a millimetre \[m\].
    pub(crate) usual_block: f64,
}

#[derive(Debug, Clone)]
struct Columns {
    rail: Option<usize>,
    from: (usize, f64),
    to: (usize, f64),
    /// Column and unit of each band.
    bands: Vec<(WavelengthBand, usize, f64)>,
    defects: Option<usize>,
}

/// What takes a block, the name of its rail, and whether it goes back there.
type TakeBlock<'a, E> = &'a mut dyn FnMut(&Block, &str, Option<GoesBack>) -> Result<(), E>;

impl SurveyFile {
    /// Read a file once: a head with `rail`, or another word for it, `from_m`, `to_m` (or `_km`) and a column `rms_30_to_100_mm_m` (or `_um`) for each
    /// band of wavelength, and a row for each block; empty cells are not known. `defects_m` may say where welds, joints and squats are,
    /// parted by semicolons. Memory: a row, and a count for each length of block.
    ///
    /// # Errors
    /// [`CaseError::Read`] if it cannot be read, [`CaseError::Data`] with the line: a column that is missing, a number that is
    /// none, below zero or more than 10 mm, a survey that is nowhere above 0.1 µm, a block that ends before it begins, blocks of a rail that overlap or fall, but for a long kilometre.
    pub fn check(path: &Path) -> Result<Self, CaseError> {
        text_file::check_is_read_twice(path).map_err(|reason| CaseError::Read {
            what: "file",
            path: path.to_owned(),
            reason,
        })?;
        let mut first = Vec::new();
        let read = seal::open(path).and_then(|file| file.take(4096).read_to_end(&mut first));
        read.map_err(|reason| CaseError::Read { what: "file", path: path.to_owned(), reason })?;
        if first.contains(&0)
            && let Err(binary) = text_file::Encoding::of(&first)
        {
            return Err(at(path, binary.line, binary));
        }
        let head = reader(path)?.headers().map_err(|error| csv_error(path, &error))?.clone();
        let columns = Columns::of(&head).map_err(|message| at(path, 1, message))?;
        let mut survey = Self {
            path: path.to_owned(),
            columns,
            sha256: String::new(),
            rails: Vec::new(),
            renamed: BTreeMap::new(),
            ends: [f64::INFINITY, f64::NEG_INFINITY],
            goes_back: Vec::new(),
            rows: 0,
            dates: dates_of(path, &head)?,
            devices: devices_of(path, &head)?,
            usual_block: 1.0,
        };
        let (mut ends, mut rows, mut rails) = (survey.ends, 0, Vec::new());
        // Blocks by their length in millimetres.
        let mut lengths: HashMap<u64, u64> = HashMap::new();
        let mut roughest = f64::NEG_INFINITY;
        let mut goes_back = Vec::new();
        let sha256 = survey.each_hashed(
            &mut |block, name, back| {
                goes_back.extend(back);
                roughest = block.rms.iter().copied().fold(roughest, f64::max);
                let length = (1e3 * (block.to - block.from)).round().max(1.0);
                *lengths.entry(length as u64).or_default() += 1;
                if block.rail == rails.len() {
                    rails.push(name.to_owned());
                }
                ends = [ends[0].min(block.from), ends[1].max(block.to)];
                rows += 1;
                Ok::<(), CaseError>(())
            },
            &|_| (),
        )?;
        if rows == 0 {
            return Err(at(path, 1, "there is no block below the head".to_owned()));
        }
        if roughest == f64::NEG_INFINITY {
            let message = "no block has an RMS in any band: such a survey would hide the one before it";
            return Err(at(path, 1, message.to_owned()));
        }
        if roughest > 0.0 && roughest < SMOOTHEST {
            let message = format!(
                "no block has an RMS above {:.1e} µm, but rails polished for noise have 1 µm; is the unit right?",
                1e6 * roughest
            );
            return Err(at(path, 1, message));
        }
        let usual = lengths.iter().max_by_key(|(length, count)| (**count, std::cmp::Reverse(**length)));
        survey.usual_block = usual.map_or(1.0, |(length, _)| 1e-3 * *length as f64);
        (survey.ends, survey.rows, survey.rails) = (ends, rows, rails);
        (survey.sha256, survey.goes_back) = (sha256, goes_back);
        Ok(survey)
    }

    /// Whether it says where welds, joints and squats are.
    pub(crate) fn has_defects(&self) -> bool {
        self.columns.defects.is_some()
    }

    /// The survey with other names for some of its rails.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a rail that is not in the file.
    pub fn rename(mut self, names: BTreeMap<String, String>) -> Result<Self, CaseError> {
        for (old, new) in &names {
            let Some(rail) = self.rails.iter().position(|rail| rail == old) else {
                let there = self.rails.join(", ");
                let message = format!("there is no rail \"{old}\" in the file; there are {there}");
                return Err(CaseError::data(&self.path, message));
            };
            self.rails[rail].clone_from(new);
        }
        self.renamed = names;
        Ok(self)
    }

    /// The bands, as the head names them.
    pub fn bands(&self) -> Vec<WavelengthBand> {
        self.columns.bands.iter().map(|(band, ..)| *band).collect()
    }

    /// Blocks of all rails.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The name of the file, without its folder.
    pub(crate) fn name(&self) -> String {
        self.path
            .file_name()
            .map_or_else(|| self.path.display().to_string(), |name| name.to_string_lossy().into_owned())
    }

    /// Hand on block by block; `progress` is told of blocks done.
    pub(crate) fn each<E: From<CaseError>>(
        &self,
        take: &mut dyn FnMut(&Block) -> Result<(), E>,
        progress: &dyn Fn(usize),
    ) -> Result<(), E> {
        if self.each_hashed(&mut |block, _, _| take(block), progress)? == self.sha256 {
            return Ok(());
        }
        let message = "the file has changed since it was checked: let the program that writes it come to its end";
        Err(CaseError::data(&self.path, message).into())
    }

    /// Hand on block by block with the name of the rail and whether it goes back there; the SHA-256 of what was read.
    fn each_hashed<E: From<CaseError>>(&self, take: TakeBlock<'_, E>, progress: &dyn Fn(usize)) -> Result<String, E> {
        let path = &self.path;
        let mut reader = reader(path)?;
        let mut record = csv::ByteRecord::new();
        let mut rails: HashMap<Vec<u8>, RailProgress> = HashMap::new();
        loop {
            let read = reader.read_byte_record(&mut record);
            if !read.map_err(|error| csv_error(path, &error))? {
                return Ok(reader.into_inner().sha256());
            }
            let line = record.position().map_or(0, csv::Position::line) as usize;
            let wrong = |message: String| at(path, line, message);
            let name =
                self.columns.rail.map_or(&b"rail"[..], |column| record.get(column).unwrap_or_default().trim_ascii());
            let Ok(text) = str::from_utf8(name) else {
                let shown = String::from_utf8_lossy(name);
                let message =
                    format!("the name of the rail, \"{shown}\", is not in UTF-8; save the table in that encoding");
                return Err(wrong(message).into());
            };
            let text = text.to_owned();
            if text.is_empty() {
                return Err(wrong("the rail has no name".to_owned()).into());
            }
            let next = rails.len();
            let known = rails.get(name);
            let rail = known.map_or(next, |course| course.rail);
            let block = self.columns.block(&record, rail).map_err(&wrong)?;
            let course = rails.entry(name.to_vec()).or_insert(RailProgress {
                rail,
                first: block.from,
                end: f64::NEG_INFINITY,
                blocks: 0,
            });
            let end_m = course.end;
            let goes_back = course.goes_back(&text, &block).map_err(&wrong)?;
            let goes_back = goes_back.then(|| GoesBack { rail: text.clone(), line, end_m, from_m: block.from });
            take(&block, &text, goes_back)?;
            progress(1);
        }
    }
}

impl Columns {
    fn of(head: &csv::StringRecord) -> Result<Self, String> {
        let find = |name: &str| head.iter().position(|column| column.trim() == name);
        let place = |name: &str| {
            let metres = find(&format!("{name}_m")).map(|column| (column, 1.0));
            metres.or_else(|| find(&format!("{name}_km")).map(|column| (column, 1e3))).ok_or_else(|| match head.len() {
                1 => "has one column; commas divide the columns of a survey, as in blocks.csv of `riffel axlebox`"
                    .to_owned(),
                _ => format!(
                    "there is no column {name}_m or {name}_km; blocks.csv of `riffel axlebox` has what is needed"
                ),
            })
        };
        let (from, to) = (place("from")?, place("to")?);
        let mut bands = Vec::new();
        for (column, name) in head.iter().enumerate() {
            if let Some(rest) = name.trim().strip_prefix("rms_") {
                let (band, unit) = band_of(rest).ok_or_else(|| {
                    format!(
                        "column `{name}` has no band and unit known here; call it as in rms_30_to_100_mm_m or \
                         rms_30_to_100_mm_um"
                    )
                })?;
                let same = |(other, ..): &(WavelengthBand, usize, f64)| *other == band;
                if bands.iter().any(same) {
                    return Err(format!("column `{name}` is of a band that another column has already"));
                }
                bands.push((band, column, unit));
            }
        }
        // Columns are found by name: their order means nothing.
        bands.sort_by(|(one, ..), (other, ..)| {
            (one.from(), one.to()).partial_cmp(&(other.from(), other.to())).expect("bands have finite ends")
        });
        if bands.is_empty() {
            return Err("there is no column of RMS in a band, as rms_30_to_100_mm_m".to_owned());
        }
        Ok(Self {
            rail: find("rail").or_else(|| head.iter().position(is_rail_column)),
            from,
            to,
            bands,
            defects: find("defects_m"),
        })
    }

    fn block(&self, record: &csv::ByteRecord, rail: usize) -> Result<Block, String> {
        let value = |column: usize, unit: f64| -> Result<f64, String> {
            let cell = record.get(column).unwrap_or_default().trim_ascii();
            if cell.is_empty() {
                return Ok(f64::NAN);
            }
            let number = str::from_utf8(cell).ok().and_then(|text| text.parse::<f64>().ok());
            number.map(|number| unit * number).ok_or_else(|| {
                let shown = String::from_utf8_lossy(cell);
                format!("column {} is \"{shown}\", not a number", column + 1)
            })
        };
        let (from, to) = (value(self.from.0, self.from.1)?, value(self.to.0, self.to.1)?);
        if !(to > from && from.abs() < FARTHEST && to.abs() < FARTHEST) {
            return Err(format!("the block runs from {from} m to {to} m, but must end after it begins"));
        }
        let mut rms = Vec::with_capacity(self.bands.len());
        for (band, column, unit) in &self.bands {
            let found = value(*column, *unit)?;
            if !found.is_nan() && !(0.0..=ROUGHEST).contains(&found) {
                return Err(format!(
                    "the RMS between {:.0} and {:.0} mm is {found} m, but must be between 0 and 10 mm; is its unit right?",
                    1e3 * band.from(),
                    1e3 * band.to()
                ));
            }
            rms.push(found);
        }
        let defects = match self.defects {
            Some(column) => defects(record.get(column).unwrap_or_default(), [from, to])?,
            None => Vec::new(),
        };
        Ok(Block { rail, from, to, rms, defects })
    }
}

/// Places of the defects of a block \[m\], parted by semicolons.
fn defects(cell: &[u8], [from, to]: [f64; 2]) -> Result<Vec<f64>, String> {
    let text = String::from_utf8_lossy(cell);
    let places = text.split(';').map(str::trim);
    let places = places.filter(|place| !place.is_empty()).map(|place| {
        let within = |at: &f64| (from - PLACED..=to + PLACED).contains(at);
        place.parse().ok().filter(within).ok_or_else(|| {
            format!("defects_m is \"{place}\", but must be a place in its block, from {from} m to {to} m")
        })
    });
    places.collect()
}

/// First and last date of the blocks, if a column has dates.
fn dates_of(path: &Path, head: &csv::StringRecord) -> Result<Option<[Date; 2]>, CaseError> {
    let Some((column, name)) = head.iter().enumerate().find(|(_, name)| is_of_time(name)) else {
        return Ok(None);
    };
    let lines = cells_of(path, column)?;
    let cells: Vec<String> = lines.keys().cloned().collect();
    ends_of_dates(name, &cells).map_err(|(place, message)| at(path, lines[&cells[place]], message))
}

/// The instruments that measured the blocks, a maker's name with the number of the one that was used.
fn devices_of(path: &Path, head: &csv::StringRecord) -> Result<Vec<String>, CaseError> {
    let mut devices: BTreeSet<String> = BTreeSet::new();
    let columns = head.iter().enumerate();
    for (column, _) in columns.filter(|(_, name)| is_device_column(name)) {
        let cells = cells_of(path, column)?.into_keys();
        let own: Vec<String> = cells.filter(|cell| !cell.is_empty()).collect();
        if own.len() <= MOST_DEVICES {
            devices.extend(own);
        }
    }
    Ok(devices.into_iter().collect())
}

/// What a column has in its cells, with the line where it first comes.
fn cells_of(path: &Path, column: usize) -> Result<BTreeMap<String, usize>, CaseError> {
    let mut lines: BTreeMap<String, usize> = BTreeMap::new();
    for record in reader(path)?.byte_records() {
        let record = record.map_err(|error| csv_error(path, &error))?;
        let line = record.position().map_or(0, csv::Position::line) as usize;
        let cell = label(record.get(column).unwrap_or_default());
        lines.entry(cell).or_insert(line);
    }
    Ok(lines)
}

/// `30_to_100_mm_um`: the band, and the unit of the RMS in metres.
fn band_of(name: &str) -> Option<(WavelengthBand, f64)> {
    let (from, rest) = name.split_once("_to_")?;
    let (to, unit) = rest.split_once("_mm_")?;
    let unit = match unit {
        "m" => 1.0,
        "um" => 1e-6,
        "mm" => 1e-3,
        _ => return None,
    };
    let millimetres = |text: &str| text.parse::<f64>().ok().map(|value| 1e-3 * value);
    let band = WavelengthBand::new(millimetres(from)?, millimetres(to)?).ok()?;
    Some((band, unit))
}

fn reader(path: &Path) -> Result<csv::Reader<SurveyText<File>>, CaseError> {
    let file = seal::open(path).map_err(|reason| CaseError::Read { what: "file", path: path.to_owned(), reason })?;
    Ok(csv::ReaderBuilder::new().comment(Some(b'#')).buffer_capacity(1 << 20).from_reader(SurveyText::new(file)))
}

fn csv_error(path: &Path, error: &csv::Error) -> CaseError {
    let line = error.position().map_or(1, csv::Position::line);
    match error.kind() {
        csv::ErrorKind::Io(reason) => CaseError::Read {
            what: "file",
            path: path.to_owned(),
            reason: io::Error::new(reason.kind(), reason.to_string()),
        },
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            let message = format!("has {len} columns, but the head has {expected_len}");
            at(path, line as usize, message)
        }
        _ => at(path, line as usize, error.to_string()),
    }
}

fn at(path: &Path, line: usize, message: impl Into<riffel_keys::Message>) -> CaseError {
    CaseError::Data { path: path.to_owned(), line: Some(line), message: message.into(), help: None }
}
