//! Spectra that were computed elsewhere: means, limits, change from group to group.

use std::io::{self, Write};

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::CaseError;
use riffel_rail::{LimitTable, Survey};

use super::document::{Document, GroupDocument, Removed, levels};
use super::verdict::{Judged, Verdict, rail_in_words, worst_first};
use super::{figure, folder};
use crate::arguments::Roughness;
use crate::error::CliError;
use crate::output::{json, print, table};
use crate::staging::Staging;

/// Decibels by which a band stands over both its neighbours to be called a peak.
const PEAK: f64 = 3.0;

/// Name, energy mean and arithmetic mean of a group.
pub(crate) type Group = (String, Spectrum, Spectrum);

/// Groups of spectra with their means and what follows from them.
pub(crate) struct Means {
    pub(crate) groups: Vec<Group>,
    pub(crate) counts: Vec<usize>,
    /// Means over all spectra.
    pub(crate) energy: Spectrum,
    arithmetic: Spectrum,
    pub(crate) verdicts: Vec<Verdict>,
    pub(crate) findings: Vec<String>,
}

impl Means {
    pub(crate) fn new(
        survey: &Survey,
        limits: &[LimitTable],
        by: Option<&str>,
    ) -> Result<Self, CaseError> {
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
        let verdicts = surveys
            .iter()
            .flat_map(|(name, group)| verdicts(name, group, limits));
        let verdicts = verdicts.collect();
        let groups = surveys
            .into_iter()
            .map(|(name, group)| (name, group.spectra()))
            .collect::<Vec<_>>();
        let all = survey.spectra();
        let counts: Vec<usize> = groups.iter().map(|group| group.1.len()).collect();
        let means: Option<Vec<Group>> = groups
            .into_iter()
            .map(|(name, spectra)| {
                let energy = Spectrum::energy_mean(&spectra)?;
                Some((name, energy, Spectrum::arithmetic_mean(&spectra)?))
            })
            .collect();
        let (Some(groups), Some(energy), Some(arithmetic)) = (
            means,
            Spectrum::energy_mean(&all),
            Spectrum::arithmetic_mean(&all),
        ) else {
            return Err(CaseError::data(
                survey.path(),
                "there is no spectrum in the file",
            ));
        };
        Ok(Self {
            verdicts,
            findings: findings(&groups),
            groups,
            counts,
            energy,
            arithmetic,
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
            let group = if group == "all" { "" } else { group };
            let name = match (several, group) {
                (false, group) => group.to_owned(),
                (true, "") => rail_in_words(&rail),
                (true, group) => format!("{group}, {}", rail_in_words(&rail)),
            };
            let verdicts = Verdict::all(limits, &spectra.mean(), &[]).into_iter();
            let verdicts = verdicts.map(|verdict| verdict.of(&name));
            RailOfGroup {
                verdicts: verdicts
                    .map(|verdict| {
                        if named {
                            verdict.on_rail(&rail)
                        } else {
                            verdict
                        }
                    })
                    .collect(),
            }
        })
        .collect();
    worst_first(&mut judged);
    judged.into_iter().flat_map(|rail| rail.verdicts).collect()
}

pub(super) fn run(
    survey: Survey,
    limits: &[LimitTable],
    arguments: &Roughness,
) -> miette::Result<()> {
    let of_profiles = [
        ("--longest", arguments.statistics.longest),
        ("--window", arguments.statistics.window),
    ];
    for (argument, value) in of_profiles {
        if let Some(value) = value {
            Err(CliError::Argument {
                argument,
                value: value.to_string(),
                rule: format!(
                    "left out: it is for profiles, and {} is a table of spectra",
                    survey.path().display()
                ),
            })?;
        }
    }
    let survey = survey.choose(&arguments.choose)?;
    let path = survey.path();
    let Means {
        groups: means,
        counts,
        energy,
        arithmetic,
        verdicts,
        findings,
    } = Means::new(&survey, limits, arguments.by.as_deref())?;
    let document = Document {
        file: path.display().to_string(),
        sample_spacing_m: None,
        length_m: None,
        worst_rail: None,
        spectrum: levels(&energy),
        bands: Vec::new(),
        removed: Removed { spikes: 0, pits: 0 },
        verdicts: verdicts.clone(),
        grind: None,
        rails: Vec::new(),
        arithmetic_mean: Some(levels(&arithmetic)),
        groups: means
            .iter()
            .zip(&counts)
            .map(|((name, energy, arithmetic), &count)| GroupDocument {
                group: name.clone(),
                spectra: count,
                spectrum: levels(energy),
                arithmetic_mean: levels(arithmetic),
            })
            .collect(),
        findings: findings.clone(),
        read_as: None,
        warnings: Vec::new(),
    };
    let document = json(&document);
    if arguments.json {
        print(&document)?;
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = folder(path, arguments.output.as_deref());
    let mut staging = Staging::new("roughness", &folder)?;
    staging.write_figure("roughness", &figure::of_spectra(path, &means, limits))?;
    staging.write_with("spectrum.csv", |file| mean_table(&means, file))?;
    staging.write("summary.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let mut text = format!("{}\n", path.display());
        text += &format!(
            "read as: {} one-third-octave spectra\n",
            counts.iter().sum::<usize>()
        );
        text += &readable(&means, &counts);
        for line in verdicts
            .iter()
            .map(|verdict| &verdict.sentence)
            .chain(&findings)
        {
            text += &format!("{line}\n");
        }
        print(&format!(
            "{text}{}: {}\n",
            folder.display(),
            files.join(" ")
        ))?;
    }
    Ok(())
}

/// Bands of all groups, the longest wavelength first.
fn bands(groups: &[Group]) -> Vec<ThirdOctave> {
    let levels = groups.iter().flat_map(|group| group.1.levels());
    let mut bands: Vec<ThirdOctave> = levels.map(|level| level.band).collect();
    bands.sort();
    bands.dedup();
    bands.reverse();
    bands
}

/// Energy mean and, behind the stroke, mean of levels of each group.
fn readable(groups: &[Group], counts: &[usize]) -> String {
    let mut header = vec!["wavelength mm".to_owned()];
    let names = groups.iter().zip(counts);
    header.extend(names.map(|(group, count)| format!("{} ({count})", group.0)));
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let mut rows = table(&header);
    for band in bands(groups) {
        let mut row = vec![format!("{}", band.nominal_millimetres())];
        row.extend(groups.iter().map(|(_, energy, arithmetic)| {
            match energy.level(band).zip(arithmetic.level(band)) {
                Some((energy, arithmetic)) => format!("{energy:.1} | {arithmetic:.1}"),
                None => String::new(),
            }
        }));
        rows.add_row(row);
    }
    format!(
        "levels in dB re 1 µm: mean of energies | mean of levels, over so many spectra\n{rows}\n"
    )
}

/// What peaks of the first group do from group to group.
fn findings(groups: &[Group]) -> Vec<String> {
    let [first, _, ..] = groups else {
        return Vec::new();
    };
    let peak = |band: &ThirdOctave| {
        let level = |by: i32| first.2.level(ThirdOctave::new(band.index() + by));
        let higher = |other: f64| level(0).is_some_and(|own| own > other + PEAK);
        level(-1).is_some_and(higher) && level(1).is_some_and(higher)
    };
    bands(groups)
        .iter()
        .filter(|band| peak(band))
        .filter_map(|band| {
            let levels: Vec<f64> = groups.iter().filter_map(|group| group.2.level(*band)).collect();
            let list: Vec<String> = levels.iter().map(|level| format!("{level:.1}")).collect();
            let all = |holds: fn(&[f64]) -> bool| levels.windows(2).all(holds);
            let what = if all(|pair| pair[1] < pair[0]) {
                "falls every time: a fixed wavelength that fades, as a grinding mark does, and not growing \
                 corrugation"
            } else if all(|pair| pair[1] > pair[0]) {
                "rises every time: it grows under traffic"
            } else {
                "neither rises nor falls every time"
            };
            let wavelength = band.nominal_millimetres();
            (levels.len() == groups.len()).then(|| {
                format!("the peak at {wavelength} mm, {} dB re 1 µm, {what}", list.join(", "))
            })
        })
        .collect()
}

fn mean_table(groups: &[Group], file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = vec!["wavelength_m".to_owned()];
    header.extend(groups.iter().flat_map(|group| {
        ["energy_mean_db", "arithmetic_mean_db"].map(|mean| format!("{} {mean}", group.0))
    }));
    writer.write_record(&header)?;
    for band in bands(groups) {
        let mut row = vec![Some(band.wavelength())];
        row.extend(
            groups
                .iter()
                .flat_map(|group| [group.1.level(band), group.2.level(band)]),
        );
        writer.serialize(row)?;
    }
    writer.flush()
}
