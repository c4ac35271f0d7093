//! Levels beside the track as a picture.

use riffel_case::Case;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::{Course, NoiseAnswer, Part, PassByLevels};
use crate::parameters;

pub(super) fn figure(answer: &NoiseAnswer, case: &Case) -> LineFigure {
    let train = &answer.request.train;
    let mut panels = vec![parts(answer), measures(answer)];
    panels.extend(answer.course.as_ref().map(course));
    LineFigure {
        title: "Rolling noise beside the track".to_owned(),
        caption: format!(
            "Equivalent level over the passage at {:.0} km/h, {} m from the middle of the track and {} m above the rail, \
             re 20 µPa, one-third octaves without weighting. {}",
            3.6 * answer.request.speed,
            train.distance,
            train.height,
            parameters(case)
        ),
        panels,
        arrangement: Arrangement::Stacked,
    }
}

/// Rail, sleepers, wheel and their sum; that by transfer functions beside it.
fn parts(answer: &NoiseAnswer) -> LinePanel {
    let styles = [
        (Part::Rail, OKABE_ITO[1]),
        (Part::Sleepers, OKABE_ITO[2]),
        (Part::Wheel, OKABE_ITO[3]),
        (Part::Total, Rgb::BLACK),
    ];
    let mut series: Vec<Series> = styles
        .iter()
        .map(|(part, color)| {
            let level = answer.levels.a_weighted(*part);
            let label = format!("{} {level:.1} dB(A)", part.name());
            curve(&answer.levels, *part, label, LineStyle::Solid, *color)
        })
        .filter(|series| series.y.iter().any(|level| level.is_finite()))
        .collect();
    if let Some(levels) = &answer.by_transfer {
        let label = format!(
            "by transfer functions {:.1} dB(A)",
            levels.a_weighted(Part::Total)
        );
        series.push(curve(
            levels,
            Part::Total,
            label,
            LineStyle::Dashed,
            Rgb::BLACK,
        ));
    }
    panel("what radiates", series)
}

/// The sum now and after each measure.
fn measures(answer: &NoiseAnswer) -> LinePanel {
    let now = curve(
        &answer.levels,
        Part::Total,
        "now".to_owned(),
        LineStyle::Solid,
        Rgb::BLACK,
    );
    let after = answer.measures.iter().enumerate().map(|(place, measure)| {
        // Not −0.0.
        let change = (-10.0 * measure.saved).round() / 10.0 + 0.0;
        let label = format!("{}: {change:+.1} dB(A)", measure.title);
        // Black is that of now.
        let color = OKABE_ITO[1 + place % (OKABE_ITO.len() - 1)];
        curve(
            &measure.levels,
            Part::Total,
            label,
            LineStyle::Dashed,
            color,
        )
    });
    panel(
        "what would help, each alone",
        std::iter::once(now).chain(after).collect(),
    )
}

fn course(course: &Course) -> LinePanel {
    let mut series = vec![Series {
        label: "total".to_owned(),
        x: course.months.clone(),
        y: course.levels.clone(),
        color: Some(Rgb::BLACK),
        ..Series::default()
    }];
    if let (Some(limit), Some(&last)) = (course.limit, course.months.last()) {
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

fn curve(levels: &PassByLevels, part: Part, label: String, style: LineStyle, color: Rgb) -> Series {
    let bands = levels.bands();
    Series {
        label,
        x: bands.iter().map(|band| band.band.centre()).collect(),
        y: bands
            .iter()
            .map(|band| band.level(part).unwrap_or(f64::NAN))
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
