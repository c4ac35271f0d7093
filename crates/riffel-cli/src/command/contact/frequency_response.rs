//! Responses to small oscillations over wavelength, as a table and as panels.

use std::io::{self, Write};

use riffel::Complex64;
use riffel_case::FrequencyResponse;
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Scale, Series};

use super::line;

pub(super) fn table(response: &FrequencyResponse, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let columns: Vec<(String, &[Complex64])> = response
        .inputs()
        .into_iter()
        .flat_map(|(input, outputs)| {
            let column = |output| format!("{input}_{output}");
            outputs
                .all()
                .map(|(output, _, values)| (column(output), values))
        })
        .collect();
    let mut header = vec!["wavelength_over_semi_axis".to_owned()];
    let parts = |name: &String| ["re", "im"].map(|part| format!("{name}_{part}"));
    header.extend(columns.iter().flat_map(|(name, _)| parts(name)));
    writer.write_record(&header)?;
    for (index, &ratio) in response.ratios.iter().enumerate() {
        let mut row = vec![ratio];
        row.extend(
            columns
                .iter()
                .flat_map(|(_, values)| [values[index].re, values[index].im]),
        );
        writer.serialize(row)?;
    }
    writer.flush()
}

/// Modulus and phase against wavelength.
pub(super) fn panels(response: &FrequencyResponse) -> [LinePanel; 2] {
    // Names stand in the first of the two panels only.
    let panel = |named: bool, value: &dyn Fn(&[Complex64]) -> Vec<f64>| LinePanel {
        x_label: "wavelength λ/a [-]".to_owned(),
        x_scale: Scale::Log,
        series: response
            .inputs()
            .into_iter()
            .zip([LineStyle::Solid, LineStyle::Dashed])
            .flat_map(|((input, outputs), style)| {
                let colors = [OKABE_ITO[0], OKABE_ITO[2], OKABE_ITO[1]];
                let outputs = outputs.all().into_iter().zip(colors);
                outputs.map(move |((_, output, values), color)| {
                    let label = if named {
                        format!("{output} by {input}")
                    } else {
                        String::new()
                    };
                    Series {
                        style,
                        color: Some(color),
                        ..line(&label, &response.ratios, &value(values))
                    }
                })
            })
            .collect(),
        ..LinePanel::default()
    };
    let moduli = |values: &[Complex64]| values.iter().map(|value| value.norm()).collect();
    let largest = response
        .inputs()
        .into_iter()
        .flat_map(|(_, outputs)| outputs.all())
        .flat_map(|(_, _, values)| values)
        .map(|value| value.norm())
        .fold(0.0, f64::max);
    /// Room for the names above the curves, which end at 1.
    const HIGHEST: f64 = 2.4;
    [
        LinePanel {
            subtitle: "response to small oscillations over quasi-static response".to_owned(),
            y_label: "modulus [-]".to_owned(),
            y_range: Some((0.0, HIGHEST.max(1.05 * largest))),
            ..panel(true, &moduli)
        },
        LinePanel {
            y_label: "phase [°]".to_owned(),
            ..panel(false, &|values| phases(&response.ratios, values))
        },
    ]
}

/// Phases \[°\] that pass ±180° without a jump, from zero at long wavelengths.
fn phases(ratios: &[f64], values: &[Complex64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| ratios[b].total_cmp(&ratios[a]));
    let mut phases = vec![0.0; values.len()];
    let mut previous = 0.0;
    for index in order {
        let phase = values[index].arg().to_degrees();
        let turns = ((previous - phase) / 360.0_f64).round();
        previous = phase + 360.0 * turns;
        phases[index] = previous;
    }
    phases
}
