//! Levels beside the track as a picture.

use riffel_keys::{Language, Message, number, say, shown_speed};
use riffel_noise::Part;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::since::lower_bound_up_to;
use super::tables::name_of;
use super::{LevelTrend, NoiseAnswer, at_least};

pub(super) fn figure(answer: &NoiseAnswer, parameters: &str, language: Language) -> LineFigure {
    let mut panels = vec![parts(answer, language), measures(answer, language)];
    panels.extend(answer.course.as_ref().map(|it| course(it, language)));
    LineFigure::new(
        say!(noise_beside_the_track).text(language),
        say!(
            caption_of_noise,
            speed = shown_speed(answer.speed_m_per_s, 0),
            distance = number(answer.distance_m),
            height = number(answer.height_m),
            parameters
        )
        .text(language),
        panels,
    )
    .arranged(Arrangement::Stacked)
}

/// Rail, sleepers, wheel and their sum; that by transfer functions beside it.
fn parts(answer: &NoiseAnswer, language: Language) -> LinePanel {
    let colors = [OKABE_ITO[1], OKABE_ITO[2], OKABE_ITO[3], Rgb::BLACK];
    let parts = Part::ALL.into_iter().zip(colors);
    let mut series: Vec<Series> = parts
        .filter_map(|(part, color)| {
            let (levels, a_weighted) = answer.level.of(part);
            let level = at_least(a_weighted?, answer.lower_bound_up_to_hz);
            let label = say!(part_and_level, part = name_of(part), level).text(language);
            let style = LineStyle::Solid;
            Some(curve(&answer.frequency_hz, levels, label, style, color))
        })
        .collect();
    if let Some(since) = &answer.since {
        let level = at_least(since.before_dba, lower_bound_up_to(&since.frequency_hz));
        let label = say!(part_and_level, part = say!(noise_before), level);
        let (label, style) = (label.text(language), LineStyle::Dotted);
        let levels = &since.before_db;
        series.push(curve(&since.frequency_hz, levels, label, style, Rgb::BLACK));
    }
    if let Some(levels) = &answer.by_transfer_functions {
        let total = levels.total_dba.unwrap_or(f64::NAN);
        series.push(curve(
            &levels.frequency_hz,
            &levels.total_db,
            say!(
                part_and_level,
                part = say!(by_transfer_functions),
                level = at_least(total, lower_bound_up_to(&levels.frequency_hz))
            )
            .text(language),
            LineStyle::Dashed,
            Rgb::BLACK,
        ));
    }
    panel(say!(what_radiates), series, language)
}

/// The sum now and after each measure.
fn measures(answer: &NoiseAnswer, language: Language) -> LinePanel {
    let (levels, _) = answer.level.of(Part::Total);
    let (label, style) = (say!(now).text(language), LineStyle::Solid);
    let now = curve(&answer.frequency_hz, levels, label, style, Rgb::BLACK);
    let after = answer.measures.iter().enumerate().map(|(place, measure)| {
        // Not −0.0.
        let change = (-10.0 * measure.saved_db).round() / 10.0 + 0.0;
        let change = number(format_args!("{change:+.1}"));
        let change = say!(level_a_weighted, level = change);
        let label = change.about(measure.title.clone()).text(language);
        // Black is that of now.
        let color = OKABE_ITO[1 + place % (OKABE_ITO.len() - 1)];
        let levels = measure.levels.levels(Part::Total);
        let frequencies = super::nominal(&measure.levels);
        curve(&frequencies, &levels, label, LineStyle::Dashed, color)
    });
    panel(say!(what_would_help), std::iter::once(now).chain(after).collect(), language)
}

fn course(course: &LevelTrend, language: Language) -> LinePanel {
    let mut series = vec![
        Series::new(say!(noise_of_all).text(language), course.month.clone(), course.total_dba.clone())
            .colored(Rgb::BLACK),
    ];
    if let (Some(limit), Some(&last)) = (course.limit_dba, course.month.last()) {
        series.push(
            Series::new(say!(limit_word).text(language), vec![0.0, last], vec![limit; 2])
                .styled(LineStyle::Dashed)
                .colored(OKABE_ITO[1]),
        );
    }
    LinePanel::new(say!(time_axis_in_months).text(language), say!(level_axis_a_weighted).text(language), series)
        .titled(say!(under_traffic).text(language))
}

fn curve(frequencies: &[f64], levels: &[Option<f64>], label: String, style: LineStyle, color: Rgb) -> Series {
    Series::new(label, frequencies.to_vec(), levels.iter().map(|level| level.unwrap_or(f64::NAN)).collect())
        .styled(style)
        .colored(color)
}

fn panel(subtitle: Message, series: Vec<Series>, language: Language) -> LinePanel {
    LinePanel::new(say!(frequency_axis).text(language), say!(level_axis_in_decibels).text(language), series)
        .titled(subtitle.text(language))
        .scaled(Scale::Log, Scale::Linear)
}
