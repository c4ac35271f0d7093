//! Roughness as data.

use riffel::roughness::{BandSummary, GrindSection, Spectrum, line_length};
use riffel_keys::Message;
use riffel_rail::{LinePlace, ReaderFormat};
use serde::Serialize;

use super::{ProfileAnswer, RailAnswer, SectionVerdict, Verdict};
use crate::defect_document::DefectDocument;

/// What `riffel roughness --json` prints.
#[derive(Serialize)]
pub struct RoughnessDocument {
    pub(super) file: String,
    pub(super) sample_spacing_m: Option<f64>,
    pub(super) length_m: Option<f64>,
    /// Where there are several rails. Every list has it first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) worst_rail: Option<String>,
    /// Energy mean over all rails or spectra; each rail is judged by its own.
    pub(super) spectrum: Vec<Level>,
    pub(super) bands: Vec<Band>,
    pub(super) removed: Removed,
    pub(super) verdicts: Vec<Verdict>,
    /// Of a profile, each section of each rail, the worst first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) sections: Vec<SectionVerdict>,
    /// What lies along the line, by a table.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) along: Vec<LinePlace>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) grind: Option<Grind>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) rails: Vec<RailDocument>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) arithmetic_mean: Option<Vec<Level>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) groups: Vec<GroupDocument>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) findings: Vec<Message>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) read_as: Option<ReaderFormat>,
    pub(super) warnings: Vec<Message>,
}

/// A level of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Level {
    /// Wavelength of the band.
    pub wavelength_m: f64,
    /// Level re 1 µm.
    pub level_db: f64,
}

#[derive(Serialize)]
pub(crate) struct Band {
    rail: String,
    from_m: f64,
    to_m: f64,
    rms_m: f64,
    peak_to_peak_max_m: f64,
    share_over_limit: Option<f64>,
    limit_rms_m: Option<f64>,
    moving_rms_max_m: f64,
    window_m: f64,
    length_m: f64,
}

/// What was taken out of a profile before it was judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Removed {
    /// Spikes.
    pub spikes: usize,
    /// Pits.
    pub pits: usize,
}

#[derive(Serialize)]
pub(super) struct Grind {
    sections: Vec<Section>,
    /// Length of line where a rail is to be ground.
    total_m: f64,
    /// Of the line that was measured.
    share_of_length: f64,
    merge_m: f64,
    grinding_length_m: f64,
}

#[derive(Serialize)]
struct Section {
    rail: String,
    from_m: f64,
    to_m: f64,
    band_from_m: f64,
    band_to_m: f64,
    rms_over_limit: f64,
    /// Which of the stretches that lie over each other, where places go back.
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<usize>,
}

#[derive(Serialize)]
pub(super) struct RailDocument {
    name: String,
    length_m: f64,
    spectrum: Vec<Level>,
    bands: Vec<Band>,
    removed: Removed,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    defects: Vec<DefectDocument>,
    verdicts: Vec<Verdict>,
    grind_total_m: f64,
    grind_share_of_length: f64,
}

impl RailDocument {
    pub(super) fn new(rail: &RailAnswer) -> Self {
        let analysis = &rail.analysis;
        Self {
            name: rail.name.clone(),
            length_m: analysis.length(),
            spectrum: levels(&analysis.spectrum),
            bands: bands(&rail.name, &analysis.bands),
            removed: Removed { spikes: analysis.spikes, pits: analysis.pits },
            defects: DefectDocument::all(&rail.name, &analysis.defects),
            verdicts: rail.verdicts.clone(),
            grind_total_m: rail.sections.iter().map(GrindSection::length).sum(),
            grind_share_of_length: line_length(analysis.measured_within(&rail.sections)) / analysis.length(),
        }
    }
}

#[derive(Serialize)]
pub(super) struct GroupDocument {
    pub(super) group: String,
    pub(super) spectra: usize,
    pub(super) spectrum: Vec<Level>,
    pub(super) arithmetic_mean: Vec<Level>,
}

/// The levels of a spectrum.
pub(crate) fn levels(spectrum: &Spectrum) -> Vec<Level> {
    let levels = spectrum.levels().iter();
    levels.map(|level| Level { wavelength_m: level.band.wavelength(), level_db: level.level }).collect()
}

pub(crate) fn bands(rail: &str, bands: &[BandSummary]) -> Vec<Band> {
    bands
        .iter()
        .map(|band| Band {
            rail: rail.to_owned(),
            from_m: band.band.from(),
            to_m: band.band.to(),
            rms_m: band.rms,
            peak_to_peak_max_m: band.peak_to_peak_max,
            share_over_limit: band.share_over_limit,
            limit_rms_m: band.limit,
            moving_rms_max_m: band.moving_rms_max,
            window_m: band.window,
            length_m: band.length,
        })
        .collect()
}

impl Grind {
    pub(super) fn new(profile: &ProfileAnswer) -> Self {
        let (total, share) = profile.line_to_grind();
        let sections = profile.sections().into_iter();
        Self {
            sections: sections
                .map(|(rail, section)| Section {
                    rail: rail.name.clone(),
                    from_m: section.from,
                    to_m: section.to,
                    band_from_m: section.band.from(),
                    band_to_m: section.band.to(),
                    rms_over_limit: section.ratio,
                    stretch: rail.analysis.stretch_to_name(section.stretch),
                })
                .collect(),
            total_m: total,
            share_of_length: share,
            merge_m: profile.grinding.merge,
            grinding_length_m: profile.grinding.shortest,
        }
    }
}
