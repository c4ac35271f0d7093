//! Cells of a survey taken together to sections of a length.

use crate::NetworkError;
use crate::alignment::{Alignment, FARTHEST as FARTHEST_OFF};
use crate::record::{RailRecord, SurveyRecord};
use crate::single_places::{are_joints, single_places, tells_places};
use crate::store::{ROWS, Store};

/// Share of a section that must be known.
const ENOUGH: f64 = 0.5;
/// Share of what is known that single places must leave for what lasts to be told.
const LEFT: f64 = 0.25;
/// Share of a section that may be rougher than what it is judged by, where no limit says another.
const SHARE: f64 = 0.05;
/// A section of a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Number along the line: it begins at so many lengths of a section.
    pub index: i64,
    /// First place \[m\].
    pub from: f64,
    /// Last place \[m\].
    pub to: f64,
    /// RMS in each band \[m\]; NaN where less than half of the section is known.
    pub rms: Vec<f64>,
    /// RMS \[m\] by which it grows: without single places where cells are short enough to tell them.
    pub(crate) growing: Vec<f64>,
    /// RMS \[m\] by which it grows, with the cell before, with the cell behind and with both: a place that an odometer moves over an end is in it then.
    pub(crate) growing_around: Vec<[f64; 3]>,
    /// RMS of its cells in each band \[m\] that no more than a share of them exceed: by this a section is over its limit or
    /// within.
    pub exceeded: Vec<f64>,
    /// RMS without single places: what lasts along the rail.
    pub lasting: Vec<f64>,
    /// Whether single places are told from what lasts: by short cells, or because the survey names them.
    pub(crate) tells_places: bool,
    /// Middles of single places in each band \[m\].
    places: Vec<Vec<f64>>,
    /// Whether single places in each band, with those of the sections beside it, are the joints of rails of one length.
    pub(crate) joints: Vec<bool>,
    /// Middles of the first and the last cell that is known \[m\].
    pub(crate) known: [f64; 2],
}

/// Sections of a rail along a survey, of those lengths on which the network is judged.
///
/// The mean square of a section is that of its cells. Sections begin at whole multiples of their length, so that those of all
/// dates are the same. Memory: a chunk of cells and a row for each section.
#[derive(Debug, Clone, PartialEq)]
pub struct Sections {
    /// The rail.
    pub rail: String,
    /// Along the line; those of which nothing is known are left out.
    pub sections: Vec<Section>,
}

impl Sections {
    /// The sections of a rail of a survey, of some length \[m\].
    ///
    /// # Errors
    /// [`NetworkError::Value`] for a length below a cell of the store; [`NetworkError::Read`], [`NetworkError::Damaged`].
    pub fn of(store: &Store, survey: &SurveyRecord, rail: &RailRecord, length: f64) -> Result<Self, NetworkError> {
        Self::placed(store, survey, rail, length, SHARE, &Alignment::default(), None)
    }

    /// Sections with the share that may be rougher, with places moved to those of another survey, and of cells between two places alone.
    pub(crate) fn placed(
        store: &Store,
        survey: &SurveyRecord,
        rail: &RailRecord,
        length: f64,
        share: f64,
        alignment: &Alignment,
        within: Option<[f64; 2]>,
    ) -> Result<Self, NetworkError> {
        let (resolution, bands) = (store.resolution()?, store.bands()?.len());
        if !(length >= resolution && length.is_finite()) {
            return Err(NetworkError::Value {
                what: "the length of a section",
                value: format!("{length} m"),
                rule: format!("at least a cell of the store, {resolution} m"),
            });
        }
        let mut sections: Vec<Section> = Vec::new();
        let defects = rail.defects_m.iter().flatten();
        let mut cells = Cells {
            resolution,
            share,
            enough: (ENOUGH * (length / resolution).max(1.0)),
            defects: defects.map(|at| at + alignment.at(*at)).collect::<Vec<f64>>(),
            tells_places: tells_places(resolution) || rail.defects_m.is_some(),
            middles: Vec::new(),
            rms: vec![Vec::new(); bands],
            before: vec![f64::NAN; bands],
        };
        cells.defects.sort_by(f64::total_cmp);
        let mut present = i64::MIN;
        for chunk in 0..survey.cells.div_ceil(ROWS) {
            let place = |row: u64| {
                let middle = (chunk * ROWS + row) as f64 + 0.5;
                let place = survey.start_m + middle * resolution;
                place + alignment.at(place)
            };
            let ends = [place(0) - FARTHEST_OFF, place(ROWS) + FARTHEST_OFF];
            if within.is_some_and(|[from, to]| to < ends[0] || from > ends[1]) {
                continue;
            }
            let Some(values) = store.chunk(survey, rail, bands, chunk)? else {
                continue;
            };
            for (row, cell) in values.chunks(bands).enumerate() {
                let middle = place(row as u64);
                if within.is_some_and(|[from, to]| middle < from || middle > to) {
                    continue;
                }
                // A shift that falls from window to window does not lead back.
                let index = ((middle / length).floor() as i64).max(present);
                if index != present {
                    sections.extend(cells.close(present, length, cell));
                    present = index;
                }
                cells.middles.push(middle);
                for (cells, &rms) in cells.rms.iter_mut().zip(cell) {
                    cells.push(rms);
                }
            }
        }
        sections.extend(cells.close(present, length, &vec![f64::NAN; bands]));
        set_joints(&mut sections);
        Ok(Self { rail: rail.name.clone(), sections })
    }
}

/// Cells of the present section.
struct Cells {
    /// Length of one \[m\].
    resolution: f64,
    /// Share of them that may be rougher than what it is judged by.
    share: f64,
    /// How many must be known.
    enough: f64,
    /// Defects that the survey names along the whole rail, in order \[m\].
    defects: Vec<f64>,
    tells_places: bool,
    /// Their middles \[m\].
    middles: Vec<f64>,
    /// RMS of them, band by band \[m\].
    rms: Vec<Vec<f64>>,
    /// The last cell of the section before.
    before: Vec<f64>,
}

impl Cells {
    /// The section of what was collected, if enough of it is known; collecting begins anew. `behind` is the cell that follows.
    fn close(&mut self, index: i64, length: f64, behind: &[f64]) -> Option<Section> {
        let middles = std::mem::take(&mut self.middles);
        let half = 0.5 * self.resolution;
        let named: Vec<bool> = (middles.iter())
            .map(|middle| {
                let next = self.defects.partition_point(|at| *at < middle - half);
                self.defects.get(next).is_some_and(|at| *at < middle + half)
            })
            .collect();
        let from = index as f64 * length;
        let mut section = Section {
            index,
            from,
            to: from + length,
            rms: Vec::new(),
            growing: Vec::new(),
            growing_around: Vec::new(),
            exceeded: Vec::new(),
            lasting: Vec::new(),
            tells_places: self.tells_places,
            places: Vec::new(),
            joints: Vec::new(),
            known: [f64::INFINITY, f64::NEG_INFINITY],
        };
        let own_places = |from: f64, to: f64| {
            let own = self.defects.iter().copied();
            own.filter(move |at| *at >= from && *at < to)
        };
        let bands = self.rms.iter_mut().zip(&mut self.before).zip(behind);
        for ((cells, before), behind) in bands {
            let cells = std::mem::take(cells);
            let ends = [*before, *behind];
            *before = cells.last().copied().unwrap_or(f64::NAN);
            let of_known = cells.iter().zip(&middles).filter(|(rms, _)| rms.is_finite());
            let known = of_known.clone().count();
            for (_, middle) in of_known {
                section.known = [section.known[0].min(*middle), section.known[1].max(*middle)];
            }
            let found = single_places(&cells, &named, self.resolution);
            let mut lasting = cells.clone();
            let mut places: Vec<f64> = own_places(section.from, section.to).collect();
            for run in found {
                lasting[run.clone()].fill(f64::NAN);
                let middle = 0.5 * (middles[run.start] + middles[run.end - 1]);
                let reach = 0.5 * self.resolution * (run.len() as f64 + 2.0);
                if own_places(middle - reach, middle + reach).next().is_none() {
                    places.push(middle);
                }
            }
            places.sort_by(f64::total_cmp);
            section.places.push(places);
            let is_short = tells_places(self.resolution);
            let growing = if is_short { &lasting } else { &cells };
            let with = |ends: &[f64]| root_mean_square(growing.iter().chain(ends));
            let or_unknown = |value: f64| match known as f64 >= self.enough {
                true => value,
                false => f64::NAN,
            };
            section.rms.push(or_unknown(root_mean_square(cells.iter())));
            section.growing.push(or_unknown(with(&[])));
            section.growing_around.push([with(&ends[..1]), with(&ends[1..]), with(&ends)]);
            let left = lasting.iter().filter(|rms| rms.is_finite()).count();
            if (left as f64) < LEFT * known as f64 {
                lasting.clear();
            }
            section.lasting.push(or_unknown(exceeded(lasting, self.share)));
            section.exceeded.push(or_unknown(exceeded(cells, self.share)));
        }
        let is_known = section.rms.iter().any(|value| value.is_finite());
        is_known.then_some(section)
    }
}

/// Whether single places are joints: a section of 100 m has four of rails of 25 m, and those beside it tell more.
fn set_joints(sections: &mut [Section]) {
    for at in 0..sections.len() {
        let beside = at.saturating_sub(1)..(at + 2).min(sections.len());
        let joints = (0..sections[at].places.len()).map(|band| {
            let beside = sections[beside.clone()].iter();
            let beside = beside.filter(|other| other.index.abs_diff(sections[at].index) <= 1);
            let places: Vec<f64> = beside.flat_map(|other| other.places[band].clone()).collect();
            are_joints(&sections[at].places[band]) || are_joints(&places)
        });
        sections[at].joints = joints.collect();
    }
}

/// Of what is known.
fn root_mean_square<'a>(cells: impl Iterator<Item = &'a f64>) -> f64 {
    let known = cells.filter(|rms| rms.is_finite());
    let (sum, count): (f64, f64) = known.fold((0.0, 0.0), |(sum, count), rms| (sum + rms * rms, count + 1.0));
    (sum / count).sqrt()
}

/// The value that no more than a share of those known exceed: over a limit where more of them are.
fn exceeded(mut cells: Vec<f64>, share: f64) -> f64 {
    cells.retain(|rms| rms.is_finite());
    cells.sort_by(|one, other| other.total_cmp(one));
    let may_exceed = (share * cells.len() as f64 + 1e-9).floor() as usize;
    let at = may_exceed.min(cells.len().saturating_sub(1));
    cells.get(at).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of a metre: of a hundred, five may be over the limit and six may not.
    #[test]
    fn a_share_of_a_section_may_be_rougher() {
        let with = |rough: usize, apart: usize| -> Vec<f64> {
            (0..100).map(|cell| if cell % apart == 7 && cell / apart < rough { 36.0 } else { 2.0 }).collect()
        };
        assert_eq!(exceeded(with(5, 18), 0.05), 2.0);
        assert_eq!(exceeded(with(6, 15), 0.05), 36.0);
        assert!(exceeded(vec![f64::NAN], 0.05).is_nan());
    }
}
