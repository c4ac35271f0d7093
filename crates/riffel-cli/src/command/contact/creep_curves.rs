//! Creep curves of all laws.

use std::io::{self, Write};

use riffel::{CreepLaw, Creepages};
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Rgb, Series};

use super::patch::Patch;
use super::{line, refused};
use crate::error::CliError;
use crate::output::Progress;

/// Tractive ratio against creepage by one law.
pub(super) struct CreepCurve {
    /// Name in the case file, and key in documents and tables.
    pub(super) key: &'static str,
    /// Name in the figure.
    pub(super) label: &'static str,
    pub(super) style: LineStyle,
    pub(super) color: Rgb,
    pub(super) tractive_ratios: Vec<f64>,
}

pub(super) struct CreepCurves {
    pub(super) creepages: Vec<f64>,
    pub(super) laws: Vec<CreepCurve>,
}

impl CreepCurves {
    pub(super) fn new(
        patch: &Patch,
        creepages: Vec<f64>,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let load = patch.hertz.normal_force();
        let mut exact = Vec::with_capacity(creepages.len());
        for &creepage in &creepages {
            let state = patch.half_space.roll(creepage);
            let state = state.map_err(refused(format!("half-space, creepage {creepage}")))?;
            exact.push(patch.tractive_ratio(state.tangential_force()));
            progress.advance(1);
        }
        let over = |force: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let ratio = |&creepage| patch.tractive_ratio(force(creepage));
            creepages.iter().map(ratio).collect()
        };
        let by = |law: &dyn CreepLaw| {
            over(&|creepage| {
                law.forces(load, Creepages::longitudinal(creepage))
                    .longitudinal
            })
        };
        let curve = |key, label, style, color: usize, tractive_ratios| CreepCurve {
            key,
            label,
            style,
            color: OKABE_ITO[color],
            tractive_ratios,
        };
        use LineStyle::{Dashed, Dotted, Solid};
        let laws = &patch.laws;
        let carter = over(&|creepage| patch.carter.tangential_force(load, creepage));
        let laws = vec![
            curve("carter-3d", "Carter 3D (paper)", Dashed, 1, carter),
            curve("carter-2d", "Carter 2D", Dotted, 6, by(&*laws.carter_2d)),
            curve(
                "johnson-vermeulen",
                "Johnson–Vermeulen",
                Dotted,
                2,
                by(&*laws.johnson_vermeulen),
            ),
            curve(
                "shen-hedrick-elkins",
                "Shen–Hedrick–Elkins",
                Dashed,
                3,
                by(&*laws.shen_hedrick_elkins),
            ),
            curve("polach", "Polach", Solid, 4, by(&*laws.polach)),
            curve("fastsim", "FASTSIM", Solid, 5, by(&*laws.fastsim)),
            curve("half-space", "half-space (exact)", Solid, 0, exact),
        ];
        Ok(Self { creepages, laws })
    }

    pub(super) fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = vec!["creepage".to_owned()];
        header.extend(self.laws.iter().map(|law| law.key.replace('-', "_")));
        writer.write_record(&header)?;
        for (index, &creepage) in self.creepages.iter().enumerate() {
            let mut row = vec![creepage];
            row.extend(self.laws.iter().map(|law| law.tractive_ratios[index]));
            writer.serialize(row)?;
        }
        writer.flush()
    }

    pub(super) fn panel(&self, patch: &Patch) -> LinePanel {
        const TO_PERCENT: f64 = 100.0;
        // Every law begins at the origin.
        let from_origin = |values: &[f64], factor: f64| -> Vec<f64> {
            let values = values.iter().map(|value| factor * value);
            std::iter::once(0.0).chain(values).collect()
        };
        let percent = from_origin(&self.creepages, TO_PERCENT);
        let laws = self.laws.iter().map(|law| Series {
            style: law.style,
            color: Some(law.color),
            ..line(law.label, &percent, &from_origin(&law.tractive_ratios, 1.0))
        });
        let mean_state = Series {
            label: "mean state".to_owned(),
            x: vec![TO_PERCENT * patch.state.creepage()],
            y: vec![patch.tractive_ratio(patch.state.tangential_force())],
            style: LineStyle::Markers,
            color: Some(OKABE_ITO[0]),
        };
        LinePanel {
            subtitle: "steady rolling".to_owned(),
            x_label: "creepage ξ [%]".to_owned(),
            y_label: "tractive ratio Q/μP [-]".to_owned(),
            y_range: Some((0.0, 1.08)),
            series: laws.chain([mean_state]).collect(),
            ..LinePanel::default()
        }
    }
}
