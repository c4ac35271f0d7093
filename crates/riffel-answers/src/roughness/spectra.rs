//! Spectra that were computed elsewhere: means, limits, change from group to group.

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::{CaseError, Language, Message, Value, fixed, number, say};
use riffel_plot::LineFigure;
use riffel_rail::{LimitTable, Survey, rail_in_words};
use serde::Serialize;

use super::figure;
use super::level::as_levels;
use super::rail::Removed;
use super::verdict::{Judged, Verdict, worst_first};
use crate::number_alone;
use crate::{Answer, Rows, Table};

/// Decibels by which a band stands over both its neighbours to be called a peak.
const PEAK: f64 = 3.0;

/// The means of a group of spectra.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeanSpectra {
    /// Name of the group.
    #[serde(rename = "group")]
    pub name: String,
    /// How many spectra.
    #[serde(rename = "spectra")]
    pub count: usize,
    /// Mean of their energies.
    #[serde(rename = "spectrum", serialize_with = "as_levels")]
    pub energy: Spectrum,
    /// Mean of their levels.
    #[serde(rename = "arithmetic_mean", serialize_with = "as_levels")]
    pub arithmetic: Spectrum,
}

/// Groups of spectra with their means and what follows from them; what is for profiles is null or empty.
#[derive(Serialize)]
pub struct SpectraAnswer {
    pub(super) file: String,
    sample_spacing_m: (),
    length_m: (),
    /// Energy mean over all spectra; each rail is judged by its own.
    #[serde(serialize_with = "as_levels")]
    spectrum: Spectrum,
    bands: [(); 0],
    removed: Removed,
    /// By limit table, the worst rail of a group first; of several dates the latest first.
    pub verdicts: Vec<Verdict>,
    #[serde(serialize_with = "as_levels")]
    arithmetic_mean: Spectrum,
    /// The groups, in the order of the file or of their dates.
    pub groups: Vec<MeanSpectra>,
    /// What peaks do from group to group.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub findings: Vec<Message>,
    /// What was put right in the file.
    warnings: Vec<Message>,
    /// How many of the verdicts are of now: those of the latest of several dates, else all.
    #[serde(skip)]
    of_now: usize,
    /// The column of dates by which groups are told apart, where none was asked for.
    #[serde(skip)]
    dates: Option<String>,
    #[serde(skip)]
    pub(super) limits: Vec<LimitTable>,
}

impl SpectraAnswer {
    /// The spectra of a survey held to limits, in groups by the values of a column if one is given, or else by several dates: the
    /// mean of these is the state of no day.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a column that is not there, or where there is no spectrum.
    pub fn new(survey: &Survey, limits: &[LimitTable], by: Option<&str>) -> Result<Self, CaseError> {
        let dates = survey.column_of_several_dates();
        let by_dates = dates.filter(|_| by.is_none());
        let by = by.or(dates);
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
        let has_dates = by.is_some() && by == dates;
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
        Ok(Self {
            file: survey.path().display().to_string(),
            sample_spacing_m: (),
            length_m: (),
            spectrum: all.energy,
            bands: [],
            removed: Removed::default(),
            verdicts,
            arithmetic_mean: all.arithmetic,
            findings: findings(&groups),
            groups,
            warnings: survey.warnings.clone(),
            of_now,
            dates: by_dates.map(str::to_owned),
            limits: limits.to_vec(),
        })
    }

    /// Verdicts on the rail as it is now: of several dates those of the latest.
    pub fn verdicts_of_now(&self) -> &[Verdict] {
        &self.verdicts[..self.of_now]
    }

    /// How many spectra there are.
    pub fn count(&self) -> usize {
        self.groups.iter().map(|group| group.count).sum()
    }

    /// Means of energies and means of levels of each group with their limits.
    pub(crate) fn figure_in(&self, language: Language) -> LineFigure {
        figure::of_spectra(self, language)
    }

    /// One row for each band: before a reader the energy mean and, behind the stroke, the mean of levels of each group.
    fn table(&self) -> Table {
        let bands = bands(&self.groups);
        let mut columns = vec![
            bands.exact("wavelength_m", |band| band.wavelength()),
            bands.numbers(say!(wavelength_of_band), |band| band.nominal_millimetres()),
        ];
        for group in &self.groups {
            let means = [("energy_mean_db", &group.energy), ("arithmetic_mean_db", &group.arithmetic)];
            columns.extend(
                means.map(|(mean, spectrum)| {
                    bands.exact(&format!("{} {mean}", group.name), |band| spectrum.level(*band))
                }),
            );
            let head = Message::verbatim(format!("{} ({})", group.name, group.count));
            columns.push(bands.shown(
                head,
                |band| match group.energy.level(*band).zip(group.arithmetic.level(*band)) {
                    Some((energy, arithmetic)) => number_alone(format!("{energy:.1} | {arithmetic:.1}")),
                    None => Message::verbatim(""),
                },
            ));
        }
        Table { name: "spectrum", columns }
    }
}

impl Answer for SpectraAnswer {
    fn name(&self) -> &'static str {
        "roughness"
    }

    fn introduction(&self) -> Vec<Message> {
        let spectra = say!(one_third_octave_spectra, count = self.count());
        let read = match &self.dates {
            Some(column) => {
                say!(read_as_spectra_of_dates, spectra, dates = number(self.groups.len()), column)
            }
            None => say!(read_as_spectra, spectra),
        };
        vec![Message::verbatim(&self.file), read, say!(means_of_spectra)]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.table()]
    }

    fn sentences(&self) -> Vec<Message> {
        let verdicts = self.verdicts.iter().map(|verdict| &verdict.sentence);
        verdicts.chain(&self.findings).cloned().collect()
    }

    fn figure(&self) -> LineFigure {
        self.figure_in(Language::English)
    }

    fn remarks(&self) -> &[Message] {
        &self.warnings
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
                (true, Some(group)) => Some(say!(group_and_rail, group, rail = rail_in_words(&rail))),
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
                    say!(peak_falls, wavelength, levels = list)
                } else if all(|pair| pair[1] > pair[0]) {
                    say!(peak_rises, wavelength, levels = list)
                } else {
                    say!(peak_stays, wavelength, levels = list)
                }
            })
        })
        .collect()
}
