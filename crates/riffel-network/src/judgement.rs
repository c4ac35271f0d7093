//! The bands of a store against a limit of RMS.

use std::collections::BTreeSet;

use riffel::roughness::{RmsLimit, WavelengthBand};
use riffel_rail::{Limit, LimitTable};
use serde::Serialize;

use crate::single_places::{LONGEST_PLACE, tells_places};
use crate::store::in_words;
use crate::{NetworkError, Section, Store};

/// How far sections are over a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// Name of the limit table.
    pub limit: String,
    /// Bands of the store.
    pub bands: Vec<WavelengthBand>,
    /// Limit of the RMS in each band \[m\]; `None` if the table says nothing.
    limits: Vec<Option<f64>>,
    /// Share of a section that may be over its limit.
    pub(crate) share: f64,
    /// Length of a cell \[m\].
    resolution: f64,
    /// Whether joints are told from corrugation everywhere.
    tells_places: bool,
    /// How fast lines are expected to grow, by band; of a line without a name every line.
    expected: Vec<(Option<String>, Vec<Option<ExpectedGrowth>>)>,
}

/// How fast the level of a band is expected to grow under the traffic of a line \[dB a year\], with the bands that hold 50 and
/// 80 % of what it may be.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ExpectedGrowth {
    /// Half lies below.
    pub median: f64,
    /// From the quantile of 25 to that of 75 %.
    pub band_50: [f64; 2],
    /// From the quantile of 10 to that of 90 %.
    pub band_80: [f64; 2],
}

/// What makes a section rough.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DefectKind {
    /// It lasts along the rail: grinding takes it off.
    Corrugation,
    /// Joints, single places of at most 2 m that are a rail apart: they are mended one by one.
    Joint,
    /// Welds or squats, single places at any distance.
    Weld,
    /// Nothing any more: its level fell at once, as by grinding, and it is within its limit since.
    Ground,
    /// Joints or corrugation: its cells are too long to tell.
    Unknown,
}

/// A section in one band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SectionInBand {
    pub(crate) band: usize,
    /// RMS that no more than the share allowed exceeds, over its limit: a section is over it where that is above 1.
    pub(crate) ratio: f64,
    /// RMS over limit without single places.
    pub(crate) lasting: f64,
    /// Whether these are told.
    tells_places: bool,
    /// Whether single places are joints.
    joints: bool,
}

impl SectionInBand {
    /// What makes it rough; `None` if it is within its limit.
    pub(crate) fn kind(&self) -> Option<DefectKind> {
        (self.ratio > 1.0).then_some(match (self.lasting > 1.0, self.joints) {
            _ if !self.tells_places => DefectKind::Unknown,
            (true, _) => DefectKind::Corrugation,
            (false, true) => DefectKind::Joint,
            (false, false) => DefectKind::Weld,
        })
    }
}

impl Judgement {
    /// A limit table on the bands of a store.
    ///
    /// # Errors
    /// [`NetworkError::Limit`] for a table of levels, or without a band of the store.
    pub fn new(store: &Store, table: &LimitTable) -> Result<Self, NetworkError> {
        let bands = store.bands()?;
        let wrong = |reason: String| Err(NetworkError::Limit { name: table.name.clone(), reason });
        let Limit::Rms(limit) = &table.limit else {
            return wrong("is one of levels, but a store holds RMS in bands of wavelength".to_owned());
        };
        let limits: Vec<Option<f64>> = bands.iter().map(|band| of_band(limit, band)).collect();
        if limits.iter().all(Option::is_none) {
            let held: Vec<[f64; 2]> = bands.iter().map(|band| [band.from(), band.to()]).collect();
            let held = in_words(&held);
            return wrong(format!("says nothing of the bands of the store, {held}"));
        }
        let resolution = store.resolution()?;
        let surveys = store.surveys()?;
        let rails: Vec<_> = surveys.iter().flat_map(|survey| &survey.rails).collect();
        Ok(Self {
            limit: table.name.clone(),
            bands,
            limits,
            share: limit.share(),
            resolution,
            tells_places: tells_places(resolution) || rails.iter().all(|rail| rail.defects_m.is_some()),
            expected: Vec::new(),
        })
    }

    /// Judgement with the growth that is expected in each band of a line, or of every line: it stands beside what surveys show, and
    /// in its place where they show nothing.
    ///
    /// # Errors
    /// [`NetworkError::Value`] for a line that the store does not have.
    pub fn expecting(
        mut self,
        store: &Store,
        line: Option<&str>,
        growth: Vec<Option<ExpectedGrowth>>,
    ) -> Result<Self, NetworkError> {
        let lines: BTreeSet<String> = store.surveys()?.into_iter().map(|it| it.line).collect();
        if let Some(line) = line
            && !lines.contains(line)
        {
            let known = lines.iter().map(String::as_str);
            return Err(NetworkError::not_there("the line", line, known));
        }
        self.expected.push((line.map(str::to_owned), growth));
        Ok(self)
    }

    /// What is expected of a band of a line.
    pub(crate) fn expected(&self, line: &str, band: usize) -> Option<ExpectedGrowth> {
        let of_line = |(of, _): &&(Option<String>, _)| of.as_ref().is_none_or(|of| of == line);
        let (_, growth) = self.expected.iter().find(of_line)?;
        growth.get(band).copied().flatten()
    }

    /// Whether anything is expected of a line.
    pub(crate) fn expects(&self, line: &str) -> bool {
        (0..self.bands.len()).any(|band| self.expected(line, band).is_some())
    }

    /// That cells are too long to tell joints from corrugation, and what to do.
    pub fn remark(&self) -> Option<String> {
        (!self.tells_places).then(|| {
            format!(
                "cells of {} m do not tell joints, welds and squats from corrugation: blocks of {LONGEST_PLACE} m or less do, \
                 as of riffel roughness --block \"1 m\", in a new store, and so do surveys with the column defects_m",
                self.resolution
            )
        })
    }

    /// Shortest and longest wavelength of each band \[m\].
    pub fn ends_of_bands(&self) -> Vec<[f64; 2]> {
        (0..self.bands.len()).map(|band| self.ends(band)).collect()
    }

    /// Shortest and longest wavelength of a band \[m\].
    pub(crate) fn ends(&self, band: usize) -> [f64; 2] {
        let band = &self.bands[band];
        [band.from(), band.to()]
    }

    /// A section in each band that is known and has a limit.
    pub(crate) fn bands_of<'a>(&'a self, section: &'a Section) -> impl Iterator<Item = SectionInBand> + 'a {
        let limits = self.limits.iter().enumerate();
        limits.filter_map(|(band, limit)| {
            let limit = (*limit)?;
            let (ratio, lasting) = (section.exceeded[band] / limit, section.lasting[band] / limit);
            ratio.is_finite().then_some(SectionInBand {
                band,
                ratio,
                lasting: if lasting.is_finite() { lasting } else { ratio },
                // Cells that all hold a place tell nothing of what lasts.
                tells_places: section.tells_places && section.lasting[band].is_finite(),
                joints: section.joints[band],
            })
        })
    }

    /// The band that is farthest over its limit by what lasts, or else farthest over it.
    pub(crate) fn worst(&self, section: &Section) -> Option<SectionInBand> {
        let key = |one: &SectionInBand| (one.lasting > 1.0, one.ratio);
        self.bands_of(section).max_by(|one, other| {
            let ((one_lasts, one), (other_lasts, other)) = (key(one), key(other));
            one_lasts.cmp(&other_lasts).then(one.total_cmp(&other))
        })
    }
}

fn of_band(limit: &RmsLimit, band: &WavelengthBand) -> Option<f64> {
    let same = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
    let mut bands = limit.bands().iter();
    let found = bands.find(|(other, _)| same(other.from(), band.from()) && same(other.to(), band.to()));
    found.map(|(_, rms)| *rms)
}
