//! One rail of a record, with what is said of it.

use riffel::roughness::{GrindSection, GrindSettings, RailAnalysis, line_length};
use riffel_rail::{LimitTable, rail_in_words};
use serde::Serialize;

use super::band::{Band, bands};
use super::level::{Level, levels};
use super::verdict::{Judged, Verdict};
use crate::defect::Defect;

/// What was taken out of a profile before it was judged.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Removed {
    /// Spikes.
    pub spikes: usize,
    /// Pits.
    pub pits: usize,
}

/// A rail with what is said of it.
#[derive(Serialize)]
pub struct RailAnswer {
    /// Its name.
    pub name: String,
    pub(crate) length_m: f64,
    spectrum: Vec<Level>,
    pub(crate) bands: Vec<Band>,
    removed: Removed,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) defects: Vec<Defect>,
    /// By limit table; sentences name the rail where there are several.
    pub verdicts: Vec<Verdict>,
    grind_total_m: f64,
    pub(crate) grind_share_of_length: f64,
    /// What was computed of it.
    #[serde(skip)]
    pub analysis: RailAnalysis,
    /// What to grind of it.
    #[serde(skip)]
    pub sections: Vec<GrindSection>,
}

impl RailAnswer {
    /// One rail, or one of several, held to limits.
    pub(crate) fn new(
        name: String,
        analysis: RailAnalysis,
        is_of_several: bool,
        limits: &[LimitTable],
        grinding: &GrindSettings,
    ) -> Self {
        let words = is_of_several.then(|| rail_in_words(&name));
        let verdicts = Verdict::all(limits, &analysis.spectrum, Some(&analysis)).into_iter();
        let sections = analysis.grind(grinding);
        Self {
            length_m: analysis.length(),
            spectrum: levels(&analysis.spectrum),
            bands: bands(&name, &analysis.bands),
            removed: Removed { spikes: analysis.spikes, pits: analysis.pits },
            defects: Defect::all(&name, &analysis.defects),
            verdicts: verdicts.map(|verdict| verdict.on_rail(&name).of(words.as_ref())).collect(),
            grind_total_m: sections.iter().map(GrindSection::length).sum(),
            grind_share_of_length: line_length(analysis.measured_within(&sections)) / analysis.length(),
            sections,
            name,
            analysis,
        }
    }
}

impl Judged for RailAnswer {
    fn verdicts(&self) -> &[Verdict] {
        &self.verdicts
    }
}
