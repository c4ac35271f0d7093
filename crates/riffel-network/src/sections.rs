//! Cells of a survey taken together to sections of a length.

use crate::NetworkError;
use crate::alignment::Alignment;
use crate::record::{RailRecord, SurveyRecord};
use crate::store::{ROWS, Store};

/// Share of a section that must be known.
const ENOUGH: f64 = 0.5;
/// Share of a section that may be rougher than what it is judged by, where no limit says another.
const SHARE: f64 = 0.05;
/// Longest single place, as a joint, a weld or a squat has it \[m\]: corrugation of the shortest waves lasts for tens of them.
pub(crate) const LONGEST_PLACE: f64 = 2.0;
/// How far it stands out of its section.
const STANDS_OUT: f64 = 2.0;

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
    /// The same with the cell before, with the cell behind and with both: a place that an odometer moves over an end is in it then.
    pub(crate) rms_around: Vec<[f64; 3]>,
    /// RMS of its cells in each band \[m\] that no more than a share of them exceed: by this a section is over its limit or
    /// within.
    pub exceeded: Vec<f64>,
    /// The same without single places, of at most 2 m and twice as rough as the section: what lasts along the rail.
    pub lasting: Vec<f64>,
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
    pub fn of(
        store: &Store,
        survey: &SurveyRecord,
        rail: &RailRecord,
        length: f64,
    ) -> Result<Self, NetworkError> {
        Self::placed(store, survey, rail, length, SHARE, &Alignment::default())
    }

    /// The same with the share that may be rougher, and with places moved to those of another survey.
    pub(crate) fn placed(
        store: &Store,
        survey: &SurveyRecord,
        rail: &RailRecord,
        length: f64,
        share: f64,
        alignment: &Alignment,
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
        // Cells of the present section, band by band.
        let mut cells: Vec<Vec<f64>> = vec![Vec::new(); bands];
        let mut present = i64::MIN;
        let enough = ENOUGH * (length / resolution).max(1.0);
        // The last cell of the section before.
        let mut before: Vec<f64> = vec![f64::NAN; bands];
        let mut close = |index: i64, cells: &mut [Vec<f64>], behind: &[f64]| {
            let of = |value: &dyn Fn(&[f64]) -> f64| -> Vec<f64> {
                let bands = cells.iter();
                bands
                    .map(|cells| {
                        let known = cells.iter().filter(|rms| rms.is_finite()).count();
                        match known as f64 >= enough {
                            true => value(cells),
                            false => f64::NAN,
                        }
                    })
                    .collect()
            };
            let rms = of(&|cells| root_mean_square(cells.iter()));
            let ends = before.iter().zip(behind);
            let with_ends = cells.iter().zip(ends).map(|(cells, (before, behind))| {
                let with =
                    |ends: &[&f64]| root_mean_square(cells.iter().chain(ends.iter().copied()));
                [with(&[before]), with(&[behind]), with(&[before, behind])]
            });
            let rms_around = with_ends.collect();
            if rms.iter().any(|value| value.is_finite()) {
                let from = index as f64 * length;
                sections.push(Section {
                    index,
                    from,
                    to: from + length,
                    rms,
                    rms_around,
                    exceeded: of(&|cells| exceeded(cells.to_vec(), share)),
                    lasting: of(&|cells| exceeded(lasting(cells, resolution), share)),
                });
            }
            for (before, cells) in before.iter_mut().zip(cells) {
                *before = cells.last().copied().unwrap_or(f64::NAN);
                cells.clear();
            }
        };
        for chunk in 0..survey.cells.div_ceil(ROWS) {
            let Some(values) = store.chunk(survey, rail, bands, chunk)? else {
                continue;
            };
            for (row, cell) in values.chunks(bands).enumerate() {
                let middle = (chunk * ROWS + row as u64) as f64 + 0.5;
                let place = survey.start_m + middle * resolution;
                // A shift that falls from window to window does not lead back.
                let index = ((place + alignment.at(place)) / length).floor() as i64;
                let index = index.max(present);
                if index != present {
                    if present != i64::MIN {
                        close(present, &mut cells, cell);
                    }
                    present = index;
                }
                for (cells, &rms) in cells.iter_mut().zip(cell) {
                    cells.push(rms);
                }
            }
        }
        if present != i64::MIN {
            close(present, &mut cells, &vec![f64::NAN; bands]);
        }
        Ok(Self {
            rail: rail.name.clone(),
            sections,
        })
    }
}

/// Of what is known.
fn root_mean_square<'a>(cells: impl Iterator<Item = &'a f64>) -> f64 {
    let known = cells.filter(|rms| rms.is_finite());
    let (sum, count): (f64, f64) = known.fold((0.0, 0.0), |(sum, count), rms| {
        (sum + rms * rms, count + 1.0)
    });
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

/// Cells without those of single places, where cells are short enough to tell them.
fn lasting(cells: &[f64], resolution: f64) -> Vec<f64> {
    let mut sorted: Vec<f64> = cells
        .iter()
        .copied()
        .filter(|rms| rms.is_finite())
        .collect();
    sorted.sort_by(f64::total_cmp);
    let usual = sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN);
    let longest = (LONGEST_PLACE / resolution * (1.0 + 1e-9)).floor() as usize;
    let stands_out = |rms: &f64| *rms > STANDS_OUT * usual;
    let runs = cells.chunk_by(|one, other| stands_out(one) == stands_out(other));
    let kept = runs.filter(|run| run.len() > longest || !run.first().is_some_and(stands_out));
    kept.flatten().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of a metre: of a hundred, five may be over the limit and six may not; joints do not last, corrugation of 3 m does.
    #[test]
    fn a_share_of_a_section_may_be_rougher() {
        let with = |rough: usize, apart: usize| -> Vec<f64> {
            (0..100)
                .map(|cell| {
                    if cell % apart == 7 && cell / apart < rough {
                        36.0
                    } else {
                        2.0
                    }
                })
                .collect()
        };
        assert_eq!(exceeded(with(5, 18), 0.05), 2.0);
        assert_eq!(exceeded(with(6, 15), 0.05), 36.0);
        let long: Vec<f64> = (0..100)
            .map(|cell| if cell % 20 < 3 { 36.0 } else { 2.0 })
            .collect();
        assert_eq!(exceeded(lasting(&with(6, 15), 1.0), 0.05), 2.0);
        assert_eq!(exceeded(lasting(&long, 1.0), 0.05), 36.0);
        // A cell of 10 m tells no joint.
        assert_eq!(lasting(&with(6, 15), 10.0).len(), 100);
        assert!(exceeded(vec![f64::NAN], 0.05).is_nan());
    }
}
