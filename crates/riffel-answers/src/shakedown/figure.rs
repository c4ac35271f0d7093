//! The map of shakedown with the orbit of the operating point.

use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Series};

use super::{LimitRow, ShakedownAnswer};

/// Highest p₀/k drawn.
const TOP: f64 = 7.0;

pub(super) fn figure(answer: &ShakedownAnswer) -> LineFigure {
    let panels = std::iter::once(map(answer)).chain(along_wave(answer));
    let caption = format!(
        "Largest contact pressure over the shear yield of {:.0} MPa, and the limits of repeated \
             loading over the friction that is used, a/b = {:.2}. Elastic: first yield by von Mises in full \
             slip. Line: shakedown of line contact. Surface: 1/f. Below: of the ellipse without friction, an upper bound.{}",
        1e-6 * answer.shear_yield_pa,
        answer.a_over_b,
        match answer.amplitude_m {
            Some(amplitude) => format!(
                " The orbit is that of the operating point over a wave of the amplitude {:.1} \
                     µm, from the crest through the trough.",
                1e6 * amplitude
            ),
            None => String::new(),
        }
    );
    LineFigure::new("Shakedown of the rail", caption, panels).arranged(Arrangement::Stacked)
}

fn map(answer: &ShakedownAnswer) -> LinePanel {
    let mut rows = answer.map.clone();
    rows.sort_by(|one, other| one.utilised_friction.total_cmp(&other.utilised_friction));
    let limit = |label: &str, color: Rgb, style: LineStyle, of: fn(&LimitRow) -> Option<f64>| {
        let places = rows.iter().filter_map(|row| Some((row.utilised_friction, of(row)?)));
        let (x, y) = places.filter(|(_, y)| *y <= TOP).unzip();
        Series::new(label, x, y).styled(style).colored(color)
    };
    let mut series = vec![
        limit("elastic", OKABE_ITO[1], LineStyle::Dashed, |row| Some(row.elastic)),
        limit("line", OKABE_ITO[2], LineStyle::Solid, |row| Some(row.line)),
        limit("surface", OKABE_ITO[3], LineStyle::Solid, |row| row.surface),
        limit("below the surface", OKABE_ITO[4], LineStyle::Dashed, |row| Some(row.subsurface)),
    ];
    if let Some(points) = &answer.along_wave {
        let around = points.iter().chain(points.first());
        let (x, y) = around.map(|point| (point.utilised_friction, point.p0_over_k)).unzip();
        series.push(Series::new("along the wave", x, y).colored(Rgb::BLACK));
        for (label, degrees) in [("crest", 0.0), ("trough", 180.0)] {
            let at = points.iter().filter(|point| point.phase_deg == degrees);
            let (x, y) = at.map(|point| (point.utilised_friction, point.p0_over_k)).unzip();
            let color = if degrees == 0.0 { OKABE_ITO[5] } else { OKABE_ITO[6] };
            series.push(Series::new(label, x, y).styled(LineStyle::Markers).colored(color));
        }
    }
    series.push(
        Series::new("mean state", vec![answer.mean.utilised_friction], vec![answer.mean.p0_over_k])
            .styled(LineStyle::Markers)
            .colored(Rgb::BLACK),
    );
    LinePanel { y_range: Some((0.0, TOP)), ..LinePanel::new("utilised friction |Q|/P", "p₀/k", series) }
}

/// Demand and profile over the phase.
fn along_wave(answer: &ShakedownAnswer) -> Option<LinePanel> {
    let points = answer.along_wave.as_ref()?;
    let phase: Vec<f64> = points.iter().map(|point| point.phase_deg).collect();
    let amplitude = answer.amplitude_m?;
    let series = [
        ("demand", Rgb::BLACK, LineStyle::Solid, points.iter().map(|point| point.demand).collect()),
        (
            "profile over its amplitude",
            OKABE_ITO[1],
            LineStyle::Dashed,
            points.iter().map(|point| point.profile_m / amplitude).collect::<Vec<f64>>(),
        ),
    ];
    let series =
        series.map(|(label, color, style, y)| Series::new(label, phase.clone(), y).styled(style).colored(color));
    Some(LinePanel::new("phase of the profile / °", "demand", series.to_vec()).titled("over the wave"))
}
