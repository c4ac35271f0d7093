//! The keys of a plan, as written.

use std::collections::BTreeMap;

use riffel_keys::quantity::{Length, Quantity, Ratio, Speed};
use riffel_study::file::{LognormalFile, NormalFile, ParameterFile, TriangularFile, UniformFile};
use serde::Deserialize;
use toml::{Table, Value};

/// A plan: which values of a case are uncertain, and what was measured.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanFile {
    /// What it is, for titles.
    #[serde(default)]
    pub title: Option<String>,
    /// The case file, relative to the plan.
    pub case: String,
    /// The traffic file, relative to the plan; only measurements of growth need one.
    #[serde(default)]
    pub traffic: Option<String>,
    /// Keys of the case that are different throughout.
    #[serde(default)]
    pub set: Table,
    /// How the posterior is sampled.
    #[serde(default)]
    pub sampler: SamplerFile,
    /// What is uncertain.
    #[serde(default)]
    pub parameter: Vec<UncertainFile>,
    /// What was measured.
    #[serde(default)]
    pub data: Vec<DataFile>,
    /// Other models, to be compared by what they predict.
    #[serde(default)]
    pub compare: Vec<CompareFile>,
    /// What is left out to compare them; left out itself, dates, places and kinds of data one after the other.
    #[serde(default)]
    pub hold_out: Option<HoldOutFile>,
    /// What could be done, for `riffel decide`; to leave all as it is needs no entry.
    #[serde(default)]
    pub action: Vec<ActionFile>,
    /// What could be measured first.
    #[serde(default)]
    pub measurement: Vec<MeasurementFile>,
    /// What it costs.
    #[serde(default)]
    pub cost: Option<CostFile>,
}

/// Another model of the same data.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompareFile {
    /// Its name.
    pub title: String,
    /// Keys of the case that differ, for all data.
    #[serde(default)]
    pub set: Table,
    /// Uncertain values that it lacks, by their names in the results: a factor is one, a key has the value of the case.
    #[serde(default)]
    pub without: Vec<String>,
}

/// What is left out: one of these.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HoldOutFile {
    /// A date of the levels: `first`, `last`, or passages since the first.
    #[serde(default)]
    pub date: Option<Value>,
    /// A place of the hammer.
    #[serde(default)]
    pub position: Option<Quantity<Length>>,
    /// Some data, by their name.
    #[serde(default)]
    pub data: Option<String>,
}

/// What could be done.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ActionFile {
    /// Its name; left out, that of the file of changes.
    #[serde(default)]
    pub title: Option<String>,
    /// A file of changes, as for `compare`: its keys are known from then on.
    #[serde(default)]
    pub changes: Option<String>,
    /// Factors of uncertain values, by their names in the results.
    #[serde(default)]
    pub multiplies: BTreeMap<String, f64>,
    /// What it costs at first.
    #[serde(default)]
    pub investment: Option<Value>,
    /// How long that lasts.
    #[serde(default)]
    pub life: Option<Value>,
    /// What it costs each year.
    #[serde(default)]
    pub upkeep: Option<Value>,
    /// Grinding after so many months; left out, when the rise is there.
    #[serde(default)]
    pub grind_every: Option<Value>,
    /// Hours for which it closes the line each year, without those of grinding.
    #[serde(default)]
    pub possession_hours: Option<Value>,
}

/// What could be measured before one decides.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeasurementFile {
    /// Its name.
    #[serde(default)]
    pub title: Option<String>,
    /// Once more what the plan has data of; of dated levels one more date.
    #[serde(default)]
    pub kind: Option<Kind>,
    /// The name of these data, where there are several of the kind.
    #[serde(default)]
    pub name: Option<String>,
    /// Or one uncertain value, by its name in the results.
    #[serde(default)]
    pub key: Option<String>,
    /// Its error: 68 % of measurements lie within value/factor and value·factor.
    #[serde(default)]
    pub factor: Option<f64>,
    /// What it costs.
    pub price: Value,
}

/// What grinding and delay cost.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CostFile {
    /// Grinding once.
    pub grinding: Value,
    /// Closing the line for it.
    #[serde(default)]
    pub possession: Option<Value>,
    /// Each month over the limit, where grinding has a fixed interval.
    #[serde(default)]
    pub over_limit: Option<Value>,
    /// Interest of a year; left out, 3 %.
    #[serde(default)]
    pub discount_rate: Option<Quantity<Ratio>>,
    /// How far below the limit grinding leaves each band; left out, "-6 dB".
    #[serde(default)]
    pub from_limit: Option<Value>,
    /// Longest interval, and the years for which a decision holds; left out, "20 a".
    #[serde(default)]
    pub horizon: Option<Value>,
    /// Most that an action may cost a year.
    #[serde(default)]
    pub budget: Option<Value>,
    /// How far above the limit a band may be when grinding comes, and so by how much it may be louder at most.
    #[serde(default)]
    pub noise_limit: Option<Value>,
    /// Most hours for which the line may be closed a year.
    #[serde(default)]
    pub possession_hours: Option<Value>,
    /// Hours for which grinding once closes the line.
    #[serde(default)]
    pub grinding_hours: Option<Value>,
    /// Whether intervals hold what the model misses of growth; left out, they do.
    #[serde(default = "yes")]
    pub growth_discrepancy: bool,
}

fn yes() -> bool {
    true
}

/// How the posterior is sampled.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SamplerFile {
    /// How.
    pub kind: SamplerKind,
    /// Chains that know nothing of each other.
    pub chains: u64,
    /// Draws of each chain that are left out: it finds its steps meanwhile. `smc` has none, and refuses it.
    pub warmup: u64,
    /// Draws of each chain that are kept.
    pub draws: u64,
    /// Number that random choices follow from.
    pub seed: u64,
}

impl Default for SamplerFile {
    fn default() -> Self {
        Self { kind: SamplerKind::Nuts, chains: 4, warmup: 1000, draws: 1000, seed: 0 }
    }
}

/// A way to draw from a posterior.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SamplerKind {
    /// Trajectories along the slopes of the density, which find their own length.
    Nuts,
    /// Walkers that find their steps from each other, without slopes.
    Ensemble,
    /// A population that is led from the priors to the posterior: for several modes, and for the evidence.
    Smc,
}

/// An uncertain value and its prior.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UncertainFile {
    /// A key of the case, or `vehicle.…` of the traffic.
    #[serde(default)]
    pub key: Option<String>,
    /// The vehicle, where the traffic has several; the name of the value, where it has no key.
    #[serde(default)]
    pub name: Option<String>,
    /// The key of the case that it multiplies, in place of `key`.
    #[serde(default)]
    pub multiplies: Option<String>,
    /// Names of the data in which it acts; left out, all.
    #[serde(default)]
    pub in_data: Option<Vec<String>>,
    /// Uniform prior.
    #[serde(default)]
    pub uniform: Option<UniformFile>,
    /// Normal prior.
    #[serde(default)]
    pub normal: Option<NormalFile>,
    /// Lognormal prior.
    #[serde(default)]
    pub lognormal: Option<LognormalFile>,
    /// Triangular prior.
    #[serde(default)]
    pub triangular: Option<TriangularFile>,
}

impl UncertainFile {
    /// Its prior in the words of a study.
    pub(crate) fn prior(&self) -> ParameterFile {
        ParameterFile {
            key: self.key.clone().unwrap_or_default(),
            values: None,
            range: None,
            uniform: self.uniform.clone(),
            normal: self.normal.clone(),
            lognormal: self.lognormal.clone(),
            triangular: self.triangular.clone(),
        }
    }
}

/// What was measured.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DataFile {
    /// Its name in the results; left out, its kind.
    #[serde(default)]
    pub name: Option<String>,
    /// What it is.
    pub kind: Kind,
    /// The table, relative to the plan.
    pub file: String,
    /// Blows or records in the mean of each frequency response.
    #[serde(default)]
    pub averages: Option<f64>,
    /// Standard deviation of ln gain, one for the whole file; left out, 0.03.
    #[serde(default)]
    pub gain_error: Option<f64>,
    /// Degrees of freedom of Student's t; left out, 5.
    #[serde(default)]
    pub student_degrees: Option<f64>,
    /// Standard deviation of a level that all bands of a date or a run share; left out, 0.3 dB and
    /// 0.5 dB; of all that pass one place, left out, 2 dB.
    #[serde(default)]
    pub common_error: Option<Value>,
    /// `flat`: nothing is known of the level of a band before it is measured.
    #[serde(default)]
    pub first_level: Option<String>,
    /// The date of a run: `first`, `last`, or passages.
    #[serde(default)]
    pub at_date: Option<Value>,
    /// Speed of a run, or of the trains that pass where no column says it.
    #[serde(default)]
    pub speed: Option<Quantity<Speed>>,
    /// Wheels on one rail of the trains that pass; left out, 4.
    #[serde(default)]
    pub wheels: Option<u32>,
    /// Length of these trains; left out, 6.6 m for each wheel.
    #[serde(default)]
    pub train_length: Option<Quantity<Length>>,
    /// Distance of the microphone from the middle of the track; left out, 7.5 m.
    #[serde(default)]
    pub distance: Option<Quantity<Length>>,
    /// Its height above the rail; left out, 1.2 m.
    #[serde(default)]
    pub height: Option<Quantity<Length>>,
    /// Roughness of the wheels, by name or file; left out, smooth.
    #[serde(default)]
    pub wheel_roughness: Option<String>,
    /// A file of roughness of the rail, for bands of which the dated levels have none.
    #[serde(default)]
    pub roughness: Option<String>,
    /// The rail of profiles that have several.
    #[serde(default)]
    pub rail: Option<String>,
    /// Which way trains run along the positions of profiles: `rising` or `falling`; left out, only the growth of waves counts, not
    /// how they move.
    #[serde(default)]
    pub travel: Option<String>,
    /// Keys of the case that are different for these data.
    #[serde(default)]
    pub set: Table,
    /// What the model misses.
    #[serde(default)]
    pub discrepancy: Option<DiscrepancyFile>,
}

/// A kind of measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Receptance of the rail at some places.
    FrequencyResponse,
    /// Track decay rates of EN 15461.
    DecayRate,
    /// Roughness levels at several dates.
    DatedLevels,
    /// Levels of acceleration on an axle box.
    AxleBox,
    /// A-weighted levels beside the track while trains pass.
    PassBy,
    /// Profiles of the same place at several dates.
    DatedProfiles,
    /// Depth worn off the head of the rail under some gross mass.
    Wear,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::FrequencyResponse,
        Self::DecayRate,
        Self::DatedLevels,
        Self::AxleBox,
        Self::PassBy,
        Self::DatedProfiles,
        Self::Wear,
    ];

    /// The columns that its table must have.
    pub fn columns(self) -> &'static [&'static str] {
        match self {
            Self::FrequencyResponse => &["frequency_hz", "receptance_re_m_per_n", "receptance_im_m_per_n"],
            Self::DecayRate => &["frequency_hz", "decay_rate_db_per_m"],
            Self::DatedLevels => &["wavelength_mm", "level_db", "standard_error_db", "passages"],
            Self::AxleBox => &["wavelength_mm", "level_db_re_1_m_per_s2", "standard_error_db"],
            Self::PassBy => &["passages", "level_dba"],
            Self::DatedProfiles => &["passages", "profile"],
            Self::Wear => &["depth_mm", "mgt"],
        }
    }

    /// The columns that its table may have besides.
    pub(crate) fn other_columns(self) -> &'static [&'static str] {
        match self {
            Self::FrequencyResponse => &["position_m", "coherence"],
            Self::DecayRate => &["standard_error_ln", "standard_error_db_per_m", "upper_bound"],
            Self::PassBy => &["speed_km_per_h", "trains", "standard_error_db"],
            Self::Wear => &["factor"],
            Self::DatedLevels | Self::AxleBox | Self::DatedProfiles => &[],
        }
    }

    /// The name in a plan.
    pub fn name(self) -> &'static str {
        match self {
            Self::FrequencyResponse => "frequency-response",
            Self::DecayRate => "decay-rate",
            Self::DatedLevels => "dated-levels",
            Self::AxleBox => "axle-box",
            Self::PassBy => "pass-by",
            Self::DatedProfiles => "dated-profiles",
            Self::Wear => "wear",
        }
    }
}

/// What the model misses, as a Gaussian process.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DiscrepancyFile {
    /// `band`, one number for each datum, or `gaussian-process`.
    pub kind: String,
    /// Over what it is smooth.
    #[serde(default)]
    pub over: Option<String>,
    /// `matern-3/2`, `matern-5/2`, `exponential` or `squared-exponential`.
    #[serde(default)]
    pub kernel: Option<String>,
    /// Its length, of what it is smooth over.
    #[serde(default)]
    pub length: Option<f64>,
    /// Its size: a number, or the scale of a half-normal prior.
    pub standard_deviation: SizeFile,
    /// The unit of its size.
    #[serde(default)]
    pub unit: Option<String>,
    /// `with passages`, for growth.
    #[serde(default)]
    pub grows: Option<String>,
}

/// The size of what the model misses.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(untagged)]
pub enum SizeFile {
    /// Known.
    Known(f64),
    /// Unknown.
    HalfNormal {
        /// Scale of its prior.
        half_normal: f64,
    },
}
