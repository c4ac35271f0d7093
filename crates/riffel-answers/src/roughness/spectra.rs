//! Spectra that were computed elsewhere: means, limits, change from group to group.

use std::io::{self, Write};
use std::path::Path;

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::{CaseError, Language, Message, Value, fixed, number, say};
use riffel_plot::LineFigure;
use riffel_rail::{LimitTable, Survey, rail_in_words};

use super::document::{GroupDocument, Removed, RoughnessDocument, levels};
use super::figure;
use super::verdict::{Judged, Verdict, worst_first};

/// Decibels by which a band stands over both its neighbours to be called a peak.
const PEAK: f64 = 3.0;

/// The means of a group of spectra.
#[derive(Debug, Clone, PartialEq)]
pub struct MeanSpectra {
    /// Name of the group.
    pub name: String,
    /// How many spectra.
    pub count: usize,
    /// Mean of their energies.
    pub energy: Spectrum,
    /// Mean of their levels.
    pub arithmetic: Spectrum,
}

/// Groups of spectra with their means and what follows from them.
pub struct SpectraAnswer {
    /// The groups, in the order of the file or of their dates.
    pub groups: Vec<MeanSpectra>,
    /// Over all spectra.
    all: MeanSpectra,
    /// By limit table, the worst rail of a group first; of several dates the latest first.
    pub verdicts: Vec<Verdict>,
    /// How many of these are of now: those of the latest of several dates, else all.
    of_now: usize,
    /// What peaks do from group to group.
    pub findings: Vec<Message>,
}

impl SpectraAnswer {
    /// The spectra of a survey held to limits, in groups by the values of a column if one is given.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a column that is not there, or where there is no spectrum.
    pub fn new(survey: &Survey, limits: &[LimitTable], by: Option<&str>) -> Result<Self, CaseError> {
        let surveys: Vec<(String, Survey)> = survey
            .groups(by)?
            .into_iter()
            .map(|(name, group)| {
                let name = match by {
                    Some(column) => format!("{column} {name}"),
                    None => name,
                };
                (name, group)
            })
            .collect();
        let mut by_group: Vec<Vec<Verdict>> =
            surveys.iter().map(|(name, group)| verdicts(name, group, limits)).collect();
        let has_dates = by.is_some() && by == survey.column_of_several_dates();
        if has_dates {
            by_group.reverse();
        }
        let of_now = by_group.iter().take(if has_dates { 1 } else { usize::MAX });
        let of_now = of_now.map(Vec::len).sum();
        let verdicts = by_group.into_iter().flatten().collect();
        let groups: Option<Vec<MeanSpectra>> =
            surveys.into_iter().map(|(name, group)| MeanSpectra::of(name, &group.spectra())).collect();
        let all = MeanSpectra::of("all".to_owned(), &survey.spectra());
        let (Some(groups), Some(all)) = (groups, all) else {
            return Err(CaseError::data(survey.path(), "there is no spectrum in the file"));
        };
        Ok(Self { verdicts, of_now, findings: findings(&groups), groups, all })
    }

    /// Verdicts on the rail as it is now: of several dates those of the latest.
    pub fn verdicts_of_now(&self) -> &[Verdict] {
        &self.verdicts[..self.of_now]
    }

    /// How many spectra there are.
    pub fn count(&self) -> usize {
        self.groups.iter().map(|group| group.count).sum()
    }

    /// Bands of all groups, the longest wavelength first.
    pub fn bands(&self) -> Vec<ThirdOctave> {
        bands(&self.groups)
    }

    /// Means of energies and means of levels of each group with their limits.
    pub fn figure(&self, path: &Path, limits: &[LimitTable], language: Language) -> LineFigure {
        figure::of_spectra(path, &self.groups, limits, language)
    }

    /// What was computed as data: what `riffel roughness --json` prints.
    pub fn document(&self, path: &Path) -> RoughnessDocument {
        RoughnessDocument {
            file: path.display().to_string(),
            sample_spacing_m: None,
            length_m: None,
            worst_rail: None,
            spectrum: levels(&self.all.energy),
            bands: Vec::new(),
            removed: Removed { spikes: 0, pits: 0 },
            verdicts: self.verdicts.clone(),
            sections: Vec::new(),
            along: Vec::new(),
            grind: None,
            rails: Vec::new(),
            arithmetic_mean: Some(levels(&self.all.arithmetic)),
            groups: self
                .groups
                .iter()
                .map(|group| GroupDocument {
                    group: group.name.clone(),
                    spectra: group.count,
                    spectrum: levels(&group.energy),
                    arithmetic_mean: levels(&group.arithmetic),
                })
                .collect(),
            findings: self.findings.clone(),
            read_as: None,
            warnings: Vec::new(),
        }
    }

    /// One row for each band, two columns for each group.
    ///
    /// # Errors
    /// Those of the file.
    pub fn spectrum_csv(&self, file: &mut impl Write) -> io::Result<()> {
        mean_table(&self.groups, file)
    }
}

impl MeanSpectra {
    fn of(name: String, spectra: &[Spectrum]) -> Option<Self> {
        Some(Self {
            name,
            count: spectra.len(),
            energy: Spectrum::energy_mean(spectra)?,
            arithmetic: Spectrum::arithmetic_mean(spectra)?,
        })
    }
}

/// The energy mean of a rail with what is said of it.
struct RailOfGroup {
    verdicts: Vec<Verdict>,
}

impl Judged for RailOfGroup {
    fn verdicts(&self) -> &[Verdict] {
        &self.verdicts
    }
}

/// Each rail of a group judged by its own energy mean, the worst first.
fn verdicts(group: &str, survey: &Survey, limits: &[LimitTable]) -> Vec<Verdict> {
    let rails = survey.by_rail();
    let several = rails.len() > 1;
    let named = survey.rail_column().is_some();
    let mut judged: Vec<RailOfGroup> = rails
        .into_iter()
        .map(|(rail, spectra)| {
            let group = Some(group).filter(|group| *group != "all");
            let subject = match (several, group) {
                (false, group) => group.map(Message::verbatim),
                (true, None) => Some(rail_in_words(&rail)),
                (true, Some(group)) => Some(say!(group_and_rail, group = group, rail = rail_in_words(&rail))),
            };
            let verdicts = Verdict::all(limits, &spectra.mean(), None).into_iter();
            let verdicts = verdicts.map(|verdict| verdict.of(subject.as_ref()));
            RailOfGroup {
                verdicts: verdicts.map(|verdict| if named { verdict.on_rail(&rail) } else { verdict }).collect(),
            }
        })
        .collect();
    worst_first(&mut judged);
    judged.into_iter().flat_map(|rail| rail.verdicts).collect()
}

/// Bands of all groups, the longest wavelength first.
fn bands(groups: &[MeanSpectra]) -> Vec<ThirdOctave> {
    let levels = groups.iter().flat_map(|group| group.energy.levels());
    let mut bands: Vec<ThirdOctave> = levels.map(|level| level.band).collect();
    bands.sort();
    bands.dedup();
    bands.reverse();
    bands
}

/// What peaks of the first group do from group to group.
fn findings(groups: &[MeanSpectra]) -> Vec<Message> {
    let [first, _, ..] = groups else {
        return Vec::new();
    };
    let peak = |band: &ThirdOctave| {
        let level = |by: i32| first.arithmetic.level(ThirdOctave::new(band.index() + by));
        let higher = |other: f64| level(0).is_some_and(|own| own > other + PEAK);
        level(-1).is_some_and(higher) && level(1).is_some_and(higher)
    };
    bands(groups)
        .iter()
        .filter(|band| peak(band))
        .filter_map(|band| {
            let levels: Vec<f64> = groups.iter().filter_map(|group| group.arithmetic.level(*band)).collect();
            let all = |holds: fn(&[f64]) -> bool| levels.windows(2).all(holds);
            let list: Value = levels.iter().map(|level| fixed(*level, 1)).collect();
            let wavelength = number(band.nominal_millimetres());
            (levels.len() == groups.len()).then(|| {
                if all(|pair| pair[1] < pair[0]) {
                    say!(peak_falls, wavelength = wavelength, levels = list)
                } else if all(|pair| pair[1] > pair[0]) {
                    say!(peak_rises, wavelength = wavelength, levels = list)
                } else {
                    say!(peak_stays, wavelength = wavelength, levels = list)
                }
            })
        })
        .collect()
}

fn mean_table(groups: &[MeanSpectra], file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = vec!["wavelength_m".to_owned()];
    header.extend(
        groups
            .iter()
            .flat_map(|group| ["energy_mean_db", "arithmetic_mean_db"].map(|mean| format!("{} {mean}", group.name))),
    );
    writer.write_record(&header)?;
    for band in bands(groups) {
        let mut row = vec![Some(band.wavelength())];
        row.extend(groups.iter().flat_map(|group| [group.energy.level(band), group.arithmetic.level(band)]));
        writer.serialize(row)?;
    }
    writer.flush()
}
