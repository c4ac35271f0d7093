//! Levels beside the track as a picture.

use riffel::noise::Part;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::tables::name_of;
use super::{Course, NoiseAnswer};

pub(super) fn figure(answer: &NoiseAnswer) -> LineFigure {
    let mut panels = vec![parts(answer), measures(answer)];
    panels.extend(answer.course.as_ref().map(course));
    LineFigure {
        title: "Rolling noise beside the track".to_owned(),
        caption: format!(
            "Equivalent level over the passage at {:.0} km/h, {} m from the middle of the track and {} m above the rail, \
             re 20 µPa, one-third octaves without weighting. {}",
            3.6 * answer.speed_m_per_s,
            answer.distance_m,
            answer.height_m,
            answer.parameters
        ),
        panels,
        arrangement: Arrangement::Stacked,
    }
}

/// Rail, sleepers, wheel and their sum; that by transfer functions beside it.
fn parts(answer: &NoiseAnswer) -> LinePanel {
    let colors = [OKABE_ITO[1], OKABE_ITO[2], OKABE_ITO[3], Rgb::BLACK];
    let parts = Part::ALL.into_iter().zip(colors);
    let mut series: Vec<Series> = parts
        .filter_map(|(part, color)| {
            let (levels, a_weighted) = answer.level.of(part);
            let label = format!("{} {:.1} dB(A)", name_of(part), a_weighted?);
            let style = LineStyle::Solid;
            Some(curve(&answer.frequency_hz, levels, label, style, color))
        })
        .collect();
    if let Some(levels) = &answer.by_transfer_functions {
        let total = levels.total_dba.unwrap_or(f64::NAN);
        series.push(curve(
            &levels.frequency_hz,
            &levels.total_db,
            format!("by transfer functions {total:.1} dB(A)"),
            LineStyle::Dashed,
            Rgb::BLACK,
        ));
    }
    panel("what radiates", series)
}

/// The sum now and after each measure.
fn measures(answer: &NoiseAnswer) -> LinePanel {
    let (levels, _) = answer.level.of(Part::Total);
    let (label, style) = ("now".to_owned(), LineStyle::Solid);
    let now = curve(&answer.frequency_hz, levels, label, style, Rgb::BLACK);
    let after = answer.measures.iter().enumerate().map(|(place, measure)| {
        // Not −0.0.
        let change = (-10.0 * measure.saved_db).round() / 10.0 + 0.0;
        let label = format!("{}: {change:+.1} dB(A)", measure.title);
        // Black is that of now.
        let color = OKABE_ITO[1 + place % (OKABE_ITO.len() - 1)];
        let levels = measure.levels.levels(Part::Total);
        let frequencies = super::nominal(&measure.levels);
        curve(&frequencies, &levels, label, LineStyle::Dashed, color)
    });
    panel(
        "what would help, each alone",
        std::iter::once(now).chain(after).collect(),
    )
}

fn course(course: &Course) -> LinePanel {
    let mut series = vec![Series {
        label: "total".to_owned(),
        x: course.month.clone(),
        y: course.total_dba.clone(),
        color: Some(Rgb::BLACK),
        ..Series::default()
    }];
    if let (Some(limit), Some(&last)) = (course.limit_dba, course.month.last()) {
        series.push(Series {
            label: "limit".to_owned(),
            x: vec![0.0, last],
            y: vec![limit; 2],
            style: LineStyle::Dashed,
            color: Some(OKABE_ITO[1]),
        });
    }
    LinePanel {
        subtitle: "under traffic".to_owned(),
        x_label: "time [months]".to_owned(),
        y_label: "level [dB(A)]".to_owned(),
        series,
        ..LinePanel::default()
    }
}

fn curve(
    frequencies: &[f64],
    levels: &[Option<f64>],
    label: String,
    style: LineStyle,
    color: Rgb,
) -> Series {
    Series {
        label,
        x: frequencies.to_vec(),
        y: levels
            .iter()
            .map(|level| level.unwrap_or(f64::NAN))
            .collect(),
        style,
        color: Some(color),
    }
}

fn panel(subtitle: &str, series: Vec<Series>) -> LinePanel {
    LinePanel {
        subtitle: subtitle.to_owned(),
        x_label: "frequency f [Hz]".to_owned(),
        y_label: "level [dB]".to_owned(),
        x_scale: Scale::Log,
        series,
        ..LinePanel::default()
    }
}
