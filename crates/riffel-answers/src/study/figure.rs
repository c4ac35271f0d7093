//! Figures of a study.

use riffel_plot::{Area, Bar, BarArrangement, BarFigure, BarPanel, BarSeries, LineFigure, LinePanel, Rgb, Series};
use riffel_study::Study;
use riffel_study::sensitivity::{Bands, Tornado};

use super::Analysis;
use super::tables::with_unit;

const BLUE: Rgb = Rgb(0, 114, 178);
const SKY: Rgb = Rgb(86, 180, 233);
const VERMILION: Rgb = Rgb(213, 94, 0);
/// 5 to 95 % and 25 to 75 %.
const LIGHT: [Rgb; 2] = [Rgb(216, 232, 243), Rgb(164, 203, 228)];

fn title(study: &Study) -> &str {
    study.plan.file.title.as_deref().unwrap_or("Study")
}

/// What an output is, in a few words.
fn words(analysis: &Analysis) -> String {
    let band = analysis.name.strip_prefix(&analysis.variable.name).unwrap_or_default();
    let description = analysis.variable.description.split(',').next().unwrap_or_default();
    format!("{description}{band}")
}

fn unit(analysis: &Analysis) -> &'static str {
    match analysis.variable.unit {
        "1" => "-",
        unit => unit,
    }
}

/// First-order and total indices with their intervals.
pub(super) fn indices(study: &Study, analyses: &[Analysis]) -> BarFigure {
    let rows: Vec<String> = study.parameters().iter().map(|p| p.key.key.clone()).collect();
    let found = analyses.iter().filter_map(|analysis| Some((analysis, analysis.indices.as_ref()?)));
    let panels = found.clone().map(|(analysis, indices)| {
        let series = |label: &str, color, total: bool| BarSeries {
            label: label.to_owned(),
            color: Some(color),
            bars: indices
                .parameters
                .iter()
                .map(|parameter| if total { parameter.total } else { parameter.first })
                .map(|estimate| Bar {
                    value: estimate.value,
                    interval: Some((estimate.low, estimate.high)),
                    note: String::new(),
                })
                .collect(),
        };
        BarPanel {
            subtitle: words(analysis),
            x_label: "share of the variance [-]".to_owned(),
            rows: rows.clone(),
            series: vec![series("first order S", BLUE, false), series("total S_T", SKY, true)],
            ..BarPanel::default()
        }
    });
    let base_samples = found.clone().map(|(_, indices)| indices.base_samples).max().unwrap_or(0);
    BarFigure {
        title: format!("What matters: {}", title(study)),
        caption: format!(
            "Sobol indices, estimators of Saltelli et al. (2010) and Jansen (1999), {base_samples} base \
             samples; whiskers: bootstrap intervals."
        ),
        panels: panels.collect(),
    }
}

/// Each parameter alone, the widest swing on top; none if the medians fail.
pub(super) fn tornado(study: &Study, analyses: &[Analysis], tornado: &Tornado) -> Option<BarFigure> {
    let middle = tornado.middle.as_ref().ok()?;
    let panels: Vec<BarPanel> = analyses
        .iter()
        .filter(|analysis| middle[analysis.place].is_finite())
        .map(|analysis| {
            let at =
                |outputs: &Result<Vec<f64>, String>| outputs.as_ref().map_or(f64::NAN, |values| values[analysis.place]);
            let mut order: Vec<usize> = (0..tornado.swings.len()).collect();
            let width = |index: usize| {
                let [low, high] = tornado.swings[index].outputs.each_ref().map(at);
                (high - low).abs()
            };
            order.sort_by(|&a, &b| width(b).total_cmp(&width(a)));
            let series = |label: &str, color, end: usize| BarSeries {
                label: label.to_owned(),
                color: Some(color),
                bars: order
                    .iter()
                    .map(|&index| Bar {
                        value: at(&tornado.swings[index].outputs[end]),
                        interval: None,
                        note: with_unit(&study.parameters()[index], &tornado.swings[index].values[end]),
                    })
                    .collect(),
            };
            BarPanel {
                subtitle: words(analysis),
                x_label: format!("{} [{}]", analysis.variable.name.replace('_', " "), unit(analysis)),
                base: middle[analysis.place],
                rows: order.iter().map(|&index| study.parameters()[index].key.key.clone()).collect(),
                series: vec![series("10 % quantile", SKY, 0), series("90 % quantile", VERMILION, 1)],
                arrangement: BarArrangement::OnOneLine,
                ..BarPanel::default()
            }
        })
        .collect();
    (!panels.is_empty()).then(|| BarFigure {
        title: format!("One at a time: {}", title(study)),
        caption: "Each parameter from its 10 % to its 90 % quantile, all others at their median.".to_owned(),
        panels,
    })
}

/// Growth against wavelength over the samples.
pub(super) fn bands(study: &Study, bands: &Bands) -> LineFigure {
    let x: Vec<f64> = study.outputs().wavelengths().iter().map(|wavelength| 1e3 * wavelength).collect();
    let area = |label: &str, low: usize, high: usize, color| Area {
        label: label.to_owned(),
        x: x.clone(),
        low: bands.curves[low].clone(),
        high: bands.curves[high].clone(),
        color,
    };
    let zero = Series::new("", vec![x[0], x[x.len() - 1]], vec![0.0, 0.0]).colored(Rgb::BLACK);
    let speeds = study.outputs().speeds();
    LineFigure::new(
        title(study).to_owned(),
        format!(
            "{} samples ({}); growth rate per passage in the mean over {} speeds from {:.0} to {:.0} \
             km/h. Corrugation grows where the rate is positive.",
            bands.samples,
            study.plan.file.design.method.name(),
            speeds.len(),
            3.6 * speeds[0],
            3.6 * speeds[speeds.len() - 1],
        ),
        [LinePanel {
            x_range: Some((x[0], x[x.len() - 1])),
            areas: vec![area("5 to 95 %", 0, 4, LIGHT[0]), area("25 to 75 %", 1, 3, LIGHT[1])],
            ..LinePanel::new(
                "wavelength λ [mm]",
                "growth rate per passage [-]",
                [zero, Series::new("median", x.clone(), bands.curves[2].clone()).colored(BLUE)],
            )
        }],
    )
}
