//! Sites whose corrugation is published, each predicted from what is published of it and from choices, and held against what was
//! measured.
//!
//! A site is a folder below `field/` with three files: `case.toml`, the case of Riffel; `traffic.toml`, its traffic; `site.toml`,
//! with the choices as distributions and the published outcomes, each with its mark and source. Of every choice samples are drawn
//! together, and each sample is a run of its own; medians and bands are those of the samples. Nothing is fitted.

mod draw;
mod printed;
mod sample;
mod site;

use include_dir::{Dir, include_dir};
use rayon::prelude::*;
use riffel_answers::{AnswerError, Banded};
use riffel_keys::CaseError;
use serde::Serialize;
use toml::Value;

use sample::Sample;
use site::{Outcome, Quantity, Site};

/// Folders of all sites.
static SITES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/field");

/// A measured number \[-\] counts as met within a third of an octave about it, which is how finely spectra are measured.
const THIRD: f64 = 1.122_462_048;

/// Every site, predicted and held against what was measured: what `riffel validate --field --json` prints.
#[derive(Debug, Clone, Serialize)]
pub struct FieldDocument {
    riffel_version: &'static str,
    /// Of the draws.
    pub seed: u64,
    /// The sites, by name.
    pub cases: Vec<SiteDocument>,
    /// Mean of the logarithm of the predicted probability of what was measured, over all published outcomes; null without one.
    pub log_score: Option<f64>,
    /// Share of the published outcomes that lie inside their 80 % bands.
    pub inside_share: Option<f64>,
}

/// What grows, over the samples; null where the case cannot say.
#[derive(Debug, Clone, Serialize)]
pub struct Predicted {
    /// Of the fastest growth.
    pub wavelength_mm: Option<Banded>,
    /// Of the fastest growth.
    pub frequency_hz: Option<Banded>,
    /// Fastest growth of the level.
    pub growth_db_per_million_axles: Option<Banded>,
    /// Null where the axles a day are not known.
    pub growth_db_per_month: Option<Banded>,
    /// Of the rail under study.
    pub mean_wear_mm_per_100_mgt: Option<Banded>,
    /// Samples whose loop oscillates by itself: they have no growth, and no other quantity holds them.
    pub unstable_samples: usize,
    /// At which they do.
    pub unstable_frequency_hz: Option<Banded>,
    /// Share of samples in which nothing grows by 0.1 dB per million axles, of those that have a mean state and are stable.
    pub share_that_decays: Option<f64>,
}

/// A site, predicted and held against what was measured.
#[derive(Debug, Clone, Serialize)]
pub struct SiteDocument {
    /// Its folder.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Samples that have a mean state, unstable ones among them.
    pub samples: usize,
    /// With the wave's own geometry, if the case has it.
    #[serde(flatten)]
    pub predicted: Predicted,
    /// Prediction without the wave's own geometry.
    pub without_wave_geometry: Predicted,
    /// Nothing must grow there.
    pub null_case: bool,
    /// What is published, each beside its prediction.
    pub outcomes: Vec<OutcomeDocument>,
    /// True where all published outcomes lie inside their 80 % bands; null where none is published.
    pub inside: Option<bool>,
    /// What is not known of the site, and why samples were left out.
    pub reason: Option<String>,
}

/// A published outcome beside its prediction.
#[derive(Debug, Clone, Serialize)]
pub struct OutcomeDocument {
    /// In words.
    pub what: String,
    /// A number, or two ends of which one may be open.
    pub measured: Measured,
    /// Of both.
    pub unit: String,
    /// Null where the case cannot say.
    pub predicted: Option<Banded>,
    /// A number: whether it lies in the band of 80 %; two ends: whether the band meets them, and one end whether the median keeps it.
    pub inside: bool,
    /// How well it is known.
    pub mark: String,
    /// Where it is published.
    pub source: String,
    /// Logarithm of the predicted probability.
    pub log_score: f64,
}

/// What was measured.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Measured {
    /// A number.
    Number(f64),
    /// Between two ends; null where one is open.
    Ends([Option<f64>; 2]),
}

/// Every site predicted with so many samples of its choices; `progress` is called after each sample.
///
/// # Errors
/// [`AnswerError`] for a site whose files cannot be read.
pub fn field(samples: usize, seed: u64, progress: &(dyn Fn(usize) + Sync)) -> Result<FieldDocument, AnswerError> {
    let cases: Result<Vec<SiteDocument>, AnswerError> =
        sites()?.iter().map(|site| Ok(SiteDocument::of(site, samples, seed, progress)?)).collect();
    let mut cases = cases?;
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    let outcomes: Vec<&OutcomeDocument> = cases.iter().flat_map(|case| &case.outcomes).collect();
    let count = outcomes.len() as f64;
    let known = |value: f64| (count > 0.0).then_some(value / count);
    let log_score = known(outcomes.iter().map(|outcome| outcome.log_score).sum());
    let inside_share = known(outcomes.iter().filter(|outcome| outcome.inside).count() as f64);
    Ok(FieldDocument { riffel_version: env!("CARGO_PKG_VERSION"), seed, log_score, inside_share, cases })
}

/// Runs of a site beside its own samples: without the wave's geometry, and one for each outcome with other keys.
///
/// # Errors
/// [`AnswerError`] for a site whose files cannot be read.
pub fn runs(samples: usize) -> Result<usize, AnswerError> {
    let sites = sites()?;
    let runs = sites.iter().map(|site| 2 + site.file.outcomes.iter().filter(|outcome| !outcome.set.is_empty()).count());
    Ok(samples * runs.sum::<usize>())
}

fn sites() -> Result<Vec<Site>, AnswerError> {
    let text = |folder: &Dir<'_>, file: &str| {
        let path = folder.path().join(file);
        let found = folder.get_file(&path).and_then(|file| file.contents_utf8());
        found.map(str::to_owned).ok_or_else(|| {
            AnswerError::from(CaseError::data("validation/field", format!("{} is missing", path.display())))
        })
    };
    SITES
        .dirs()
        .map(|folder| {
            let name = folder.path().display().to_string();
            Site::read(&name, &text(folder, "case.toml")?, &text(folder, "traffic.toml")?, &text(folder, "site.toml")?)
        })
        .collect()
}

/// The samples of a site with further keys, those without a mean state with the reason.
fn samples_of(
    site: &Site,
    samples: usize,
    seed: u64,
    set: &[(String, Value)],
    progress: &(dyn Fn(usize) + Sync),
) -> Vec<Result<Sample, CaseError>> {
    (0..samples)
        .into_par_iter()
        .map(|sample| {
            let found = Sample::of(site, seed, sample, set);
            progress(1);
            found
        })
        .collect()
}

/// A sample that has a growth: one with a mean state whose loop is stable.
fn stable(sample: &Result<Sample, CaseError>) -> Option<&Sample> {
    let sample = sample.as_ref().ok()?;
    sample.unstable.is_none().then_some(sample)
}

impl Predicted {
    fn of(samples: &[Result<Sample, CaseError>]) -> Self {
        /// Of what grows in fewer samples no wavelength is told.
        const OFTEN: f64 = 0.5;
        let unstable: Vec<f64> = samples.iter().filter_map(|sample| sample.as_ref().ok()?.unstable).collect();
        let known: Vec<&Sample> = samples.iter().filter_map(stable).collect();
        let growing: Vec<&&Sample> = known.iter().filter(|sample| sample.grows()).collect();
        let grows = growing.len() as f64 >= OFTEN * known.len() as f64;
        let of_growing = |value: &dyn Fn(&Sample) -> f64| match grows {
            true => Banded::of_samples(growing.iter().map(|sample| value(sample)).collect()),
            false => None,
        };
        let of_all = |value: &dyn Fn(&Sample) -> Option<f64>| {
            Banded::of_samples(known.iter().filter_map(|sample| value(sample)).collect())
        };
        Self {
            wavelength_mm: of_growing(&|sample| 1e3 * sample.wavelength),
            frequency_hz: of_growing(&|sample| sample.frequency),
            growth_db_per_million_axles: of_all(&|sample| Some(sample.growth)),
            growth_db_per_month: of_all(&|sample| sample.growth_per_month),
            mean_wear_mm_per_100_mgt: of_all(&|sample| Some(sample.mean_wear)),
            unstable_samples: unstable.len(),
            unstable_frequency_hz: Banded::of_samples(unstable),
            share_that_decays: (!known.is_empty()).then(|| 1.0 - growing.len() as f64 / known.len() as f64),
        }
    }
}

impl SiteDocument {
    fn of(site: &Site, count: usize, seed: u64, progress: &(dyn Fn(usize) + Sync)) -> Result<Self, CaseError> {
        let plain = [("contact.wave_geometry".to_owned(), Value::Boolean(false))];
        let samples = samples_of(site, count, seed, &[], progress);
        let without = samples_of(site, count, seed, &plain, progress);
        let outcomes: Result<Vec<OutcomeDocument>, CaseError> = (site.file.outcomes.iter())
            .map(|outcome| {
                let changed = match outcome.set.is_empty() {
                    true => Vec::new(),
                    false => {
                        let set = riffel_case::settings(&outcome.set);
                        samples_of(site, count, seed, &set, progress)
                    }
                };
                OutcomeDocument::of(outcome, &samples, &changed)
            })
            .collect();
        let outcomes = outcomes?;
        let known = samples.iter().filter(|sample| sample.is_ok()).count();
        let predicted = Predicted::of(&samples);
        let decays = predicted.share_that_decays.unwrap_or(0.0);
        let mut reasons: Vec<String> = site.file.reason.iter().cloned().collect();
        if let Some(error) = samples.iter().find_map(|sample| sample.as_ref().err()) {
            reasons
                .push(format!("{} of {count} samples have no mean state, the first because: {error}", count - known));
        }
        let unstable = predicted.unstable_samples;
        if let Some(frequency) = &predicted.unstable_frequency_hz {
            reasons.push(format!(
                "{unstable} of {count} samples oscillate by themselves, near {:.0} Hz in the median: they have no growth",
                frequency.median
            ));
        }
        if known > unstable && predicted.wavelength_mm.is_none() {
            reasons.push(format!("nothing grows in {:.0} % of the samples", 100.0 * decays));
        }
        Ok(Self {
            name: site.name.clone(),
            title: site.file.title.clone(),
            samples: known,
            without_wave_geometry: Predicted::of(&without),
            predicted,
            null_case: site.file.null_case,
            inside: (!outcomes.is_empty()).then(|| outcomes.iter().all(|outcome| outcome.inside)),
            outcomes,
            reason: (!reasons.is_empty()).then(|| reasons.join("; ")),
        })
    }
}

impl OutcomeDocument {
    fn of(
        outcome: &Outcome,
        samples: &[Result<Sample, CaseError>],
        changed: &[Result<Sample, CaseError>],
    ) -> Result<Self, CaseError> {
        let measured = Measured::read(&outcome.measured)?;
        let mut values = Vec::new();
        for (place, sample) in samples.iter().enumerate() {
            let Some(sample) = stable(sample) else {
                continue;
            };
            let grows = sample.grows();
            values.extend(match outcome.quantity {
                Quantity::Wavelength => grows.then_some(1e3 * sample.wavelength),
                Quantity::ShorterWavelength => grows.then_some(1e3 * sample.strongest[0]),
                Quantity::LongerWavelength => grows.then_some(1e3 * sample.strongest[1]),
                Quantity::Frequency => grows.then_some(sample.frequency),
                Quantity::Growth => Some(sample.growth),
                Quantity::GrowthPerMonth => sample.growth_per_month,
                Quantity::Ratio => {
                    changed.get(place).and_then(stable).filter(|_| grows).map(|changed| changed.growth / sample.growth)
                }
            });
        }
        let met = values.iter().filter(|value| measured.is_met_by(**value)).count();
        // Half a sample beside those drawn: what was not seen in n samples is not impossible.
        let log_score = ((met as f64 + 0.5) / (values.len() as f64 + 1.0)).ln();
        let predicted = Banded::of_samples(values);
        Ok(Self {
            what: outcome.what.clone(),
            measured,
            unit: outcome.unit.clone(),
            inside: predicted.is_some_and(|predicted| measured.is_inside(&predicted)),
            predicted,
            mark: outcome.mark.clone(),
            source: outcome.source.clone(),
            log_score,
        })
    }
}

impl Measured {
    fn read(value: &Value) -> Result<Self, CaseError> {
        let number = |value: &Value| match value {
            Value::Float(number) => Some(*number),
            Value::Integer(number) => Some(*number as f64),
            _ => None,
        };
        match value {
            Value::Array(ends) if ends.len() == 2 => Ok(Self::Ends([number(&ends[0]), number(&ends[1])])),
            other => number(other).map(Self::Number).ok_or_else(|| {
                let message = "`measured` of an outcome must be a number or two ends, of which one may be \"\"";
                CaseError::data("site.toml", message.to_owned())
            }),
        }
    }

    /// Whether a predicted value is what was measured.
    fn is_met_by(self, value: f64) -> bool {
        match self {
            Self::Number(measured) => (measured / THIRD..=measured * THIRD).contains(&value),
            Self::Ends([low, high]) => low.is_none_or(|low| value >= low) && high.is_none_or(|high| value <= high),
        }
    }

    fn is_inside(self, predicted: &Banded) -> bool {
        let [low, high] = predicted.band_80;
        match self {
            Self::Number(measured) => (low..=high).contains(&measured),
            Self::Ends([Some(from), Some(to)]) => low <= to && high >= from,
            Self::Ends(_) => self.is_met_by(predicted.median),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Banded = Banded { median: 2.0, band_50: [1.5, 3.0], band_80: [1.0, 4.0] };

    #[test]
    fn numbers_and_ends_are_held_against_bands() {
        assert!(Measured::Number(1.0).is_inside(&BAND));
        assert!(!Measured::Number(0.99).is_inside(&BAND));
        assert!(Measured::Ends([Some(3.9), Some(9.0)]).is_inside(&BAND));
        assert!(!Measured::Ends([Some(4.1), Some(9.0)]).is_inside(&BAND));
        assert!(Measured::Ends([None, Some(2.0)]).is_inside(&BAND));
        assert!(!Measured::Ends([Some(2.1), None]).is_inside(&BAND));
        assert!(Measured::Number(50.0).is_met_by(55.0) && !Measured::Number(50.0).is_met_by(57.0));
    }

    /// Every site is read, and two samples of each are alike whenever they are drawn.
    // Long: computes growth at all sites of the field, twice.
    #[test]
    fn every_site_can_be_run() {
        let one = field(2, 1, &|_| ()).unwrap();
        let other = field(2, 1, &|_| ()).unwrap();
        assert_eq!(serde_json::to_string(&one).unwrap(), serde_json::to_string(&other).unwrap());
        assert!(one.cases.len() >= 10, "{}", one.cases.len());
        for site in &one.cases {
            assert!(site.samples > 0, "{}: {:?}", site.name, site.reason);
        }
        assert!(one.cases.iter().any(|site| site.null_case));
    }
}
