//! Creep curves of all laws, as a table and a panel.

use std::io::{self, Write};

use riffel_case::{CreepCurves, RollingTheories};
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Series};

use super::line;

/// Style and colour of each law.
const LOOKS: [(LineStyle, usize); 7] = [
    (LineStyle::Dashed, 1),
    (LineStyle::Dotted, 6),
    (LineStyle::Dotted, 2),
    (LineStyle::Dashed, 3),
    (LineStyle::Solid, 4),
    (LineStyle::Solid, 5),
    (LineStyle::Solid, 0),
];

pub(super) fn table(curves: &CreepCurves, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = vec!["creepage".to_owned()];
    header.extend(curves.laws.iter().map(|law| law.key.replace('-', "_")));
    writer.write_record(&header)?;
    for (index, &creepage) in curves.creepages.iter().enumerate() {
        let mut row = vec![creepage];
        row.extend(curves.laws.iter().map(|law| law.tractive_ratios[index]));
        writer.serialize(row)?;
    }
    writer.flush()
}

pub(super) fn panel(curves: &CreepCurves, patch: &RollingTheories) -> LinePanel {
    const TO_PERCENT: f64 = 100.0;
    // Every law begins at the origin.
    let from_origin = |values: &[f64], factor: f64| -> Vec<f64> {
        let values = values.iter().map(|value| factor * value);
        std::iter::once(0.0).chain(values).collect()
    };
    let percent = from_origin(&curves.creepages, TO_PERCENT);
    let laws = curves
        .laws
        .iter()
        .zip(LOOKS)
        .map(|(law, (style, color))| Series {
            style,
            color: Some(OKABE_ITO[color]),
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
