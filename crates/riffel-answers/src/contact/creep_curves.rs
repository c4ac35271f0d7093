//! Creep curves of all laws.

use riffel::contact::{CreepLaw, Creepages};
use riffel_case::file::CreepLawName;
use riffel_keys::{CaseError, Message, decimal, say};
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Rgb, Series};
use serde::{Serialize, Serializer};

use super::line;
use super::theories::{RollingTheories, refused};
use crate::{Column, Rows, Table};

/// Tractive ratio against creepage by one law.
#[derive(Debug, Clone, PartialEq)]
pub struct CreepCurve {
    /// Name in the case file, and key in documents and tables.
    pub key: &'static str,
    /// Name in figures.
    pub label: &'static str,
    /// Q/μP at each creepage \[-\].
    pub tractive_ratios: Vec<f64>,
}

/// The curves of all laws over the same creepages.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CreepCurves {
    /// Creepages \[-\].
    #[serde(rename = "creepage")]
    pub creepages: Vec<f64>,
    /// Law by law, the exact one last.
    #[serde(rename = "tractive_ratio", serialize_with = "by_law")]
    pub laws: Vec<CreepCurve>,
    /// Creepages that were asked for and are left out, since the exact theory does not converge there.
    #[serde(skip)]
    pub left_out: Vec<f64>,
}

fn by_law<S: Serializer>(laws: &[CreepCurve], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(laws.iter().map(|law| (law.key, &law.tractive_ratios)))
}

impl CreepCurves {
    /// The curves at some creepages \[-\]; `progress` is told of each of them.
    ///
    /// # Errors
    /// [`CaseError::Physics`] where the exact theory converges nowhere, or a creepage is negative.
    pub fn new(theories: &RollingTheories, mut creepages: Vec<f64>, progress: impl Fn()) -> Result<Self, CaseError> {
        let load = theories.hertz.normal_force();
        let mut exact = Vec::with_capacity(creepages.len());
        let mut left_out = Vec::new();
        let mut failure = None;
        let mut before = None;
        for &creepage in &creepages {
            let half_space = &theories.half_space;
            let state = half_space.roll(creepage).or_else(|error| match &before {
                Some(before) => half_space.roll_near(creepage, before),
                None => Err(error),
            });
            progress();
            match state {
                Ok(state) => {
                    exact.push(theories.tractive_ratio(state.tangential_force()));
                    before = Some(state);
                }
                Err(error @ riffel::Error::NotConverged { .. }) => {
                    left_out.push(creepage);
                    failure = Some((creepage, error));
                }
                Err(error) => {
                    return Err(refused(format!("half-space, creepage {creepage}"))(error));
                }
            }
        }
        if let Some((creepage, error)) = failure.filter(|_| exact.is_empty()) {
            return Err(refused(format!("half-space, creepage {creepage}"))(error));
        }
        creepages.retain(|creepage| !left_out.contains(creepage));
        let over = |force: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let ratio = |&creepage| theories.tractive_ratio(force(creepage));
            creepages.iter().map(ratio).collect()
        };
        let by =
            |law: &dyn CreepLaw| over(&|creepage| law.forces(load, Creepages::longitudinal(creepage)).longitudinal);
        let curve = |key, label, tractive_ratios| CreepCurve { key, label, tractive_ratios };
        let laws = theories.laws.laws.iter();
        let mut laws: Vec<CreepCurve> = laws.map(|(entry, law)| curve(entry.name, entry.label, by(&**law))).collect();
        laws.push(curve(CreepLawName::HALF_SPACE.name(), "half-space (exact)", exact));
        Ok(Self { creepages, laws, left_out })
    }
}

/// Style and colour of a law: those of the exact one are its own, the others take theirs in turn.
fn look(law: &CreepCurve, place: usize) -> (LineStyle, Rgb) {
    const LOOKS: [(LineStyle, usize); 7] = [
        (LineStyle::Dashed, 1),
        (LineStyle::Dotted, 6),
        (LineStyle::Dotted, 2),
        (LineStyle::Dashed, 3),
        (LineStyle::Solid, 4),
        (LineStyle::Solid, 5),
        (LineStyle::Dotted, 4),
    ];
    let (style, color) = match law.key {
        key if key == CreepLawName::HALF_SPACE.name() => (LineStyle::Solid, 0),
        _ => LOOKS[place % LOOKS.len()],
    };
    (style, OKABE_ITO[color])
}

/// One row for each sample.
pub(super) fn table(curves: &CreepCurves) -> Table {
    let laws = curves.laws.iter();
    let laws = laws.map(|law| Column::exact(&law.key.replace('-', "_"), law.tractive_ratios.iter().copied()));
    let creepages = curves.creepages.exact("creepage", |&value| value);
    Table { name: "creep-curve", columns: [creepages].into_iter().chain(laws).collect() }
}

/// A few of them for a reader.
pub(super) fn shown(curves: &CreepCurves) -> Table {
    const ROWS: usize = 8;
    let count = curves.creepages.len();
    let shown = count.min(ROWS);
    let places: Vec<usize> = (1..=shown).map(|place| place * count / shown - 1).collect();
    let column = |head: Message, cell: &dyn Fn(usize) -> String| places.numbers(head, |&place| cell(place));
    let creepages =
        column(say!(creepage_column), &|place| format!("{} %", decimal(100.0 * curves.creepages[place], 4)));
    let laws = curves.laws.iter();
    let laws = laws.map(|law| column(Message::verbatim(law.key), &|place| decimal(law.tractive_ratios[place], 4)));
    Table { name: "creep-curve", columns: [creepages].into_iter().chain(laws).collect() }
}

pub(super) fn panel(curves: &CreepCurves, patch: &RollingTheories) -> LinePanel {
    const TO_PERCENT: f64 = 100.0;
    // Every law begins at the origin.
    let from_origin = |values: &[f64], factor: f64| -> Vec<f64> {
        let values = values.iter().map(|value| factor * value);
        std::iter::once(0.0).chain(values).collect()
    };
    let percent = from_origin(&curves.creepages, TO_PERCENT);
    let laws = curves.laws.iter().enumerate().map(|(place, law)| {
        let (style, color) = look(law, place);
        Series { style, color: Some(color), ..line(law.label, &percent, &from_origin(&law.tractive_ratios, 1.0)) }
    });
    let mean_state = patch.along_rail().then(|| {
        Series::new(
            "mean state",
            vec![TO_PERCENT * patch.state.creepage()],
            vec![patch.tractive_ratio(patch.state.tangential_force())],
        )
        .styled(LineStyle::Markers)
        .colored(OKABE_ITO[0])
    });
    LinePanel {
        y_range: Some((0.0, 1.08)),
        ..LinePanel::new("creepage ξ [%]", "tractive ratio Q/μP [-]", laws.chain(mean_state)).titled(
            match patch.along_rail() {
                true => "steady rolling".to_owned(),
                false => "steady rolling, longitudinal creepage alone".to_owned(),
            },
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_case::{Case, CaseContact, NOMINAL_CASE};

    /// However many laws the catalogue has, each is drawn, the exact one in a look of its own.
    #[test]
    fn every_law_has_a_curve() -> Result<(), CaseError> {
        let coarse = ["contact.grid=16".to_owned()];
        let theories =
            CaseContact::of(&Case::parse("nominal", NOMINAL_CASE, &coarse)?).and_then(RollingTheories::new)?;
        let mut curves = CreepCurves::new(&theories, vec![1e-3, 2e-3], || ())?;
        assert_eq!(curves.laws.len(), riffel::contact::CREEP_LAWS.len() + 1);
        let more = curves.laws[..3].to_vec();
        curves.laws.splice(0..0, more);
        let series = panel(&curves, &theories).series;
        assert_eq!(series.len(), curves.laws.len() + 1);
        for (law, drawn) in curves.laws.iter().zip(&series) {
            assert_eq!(law.label, drawn.label);
            let black = drawn.color == Some(OKABE_ITO[0]);
            assert_eq!(black, law.key == CreepLawName::HALF_SPACE.name(), "{}", law.key);
        }
        Ok(())
    }
}
