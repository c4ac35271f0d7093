//! Figures of lines.

use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};

use super::{curves, even, read, words_of};

#[test]
fn curves_name_their_series_and_decades() {
    let words = words_of(&curves().picture().unwrap());
    for expected in ["frequency f [Hz]", "free beam", "two-layer track", "measured", "10⁻⁹", "100", "−90", "(a)"]
    {
        assert!(words.iter().any(|word| word == expected), "{expected} is not in {words:?}");
    }
}

#[test]
fn words_of_any_length_and_scale_stand_clear_of_each_other() {
    let long =
        "a name much longer than anyone would write into a file of cases, line 12, track_1_left_rail_of_the_section ";
    let arrangements = [Arrangement::SideBySide, Arrangement::Stacked, Arrangement::Strips];
    let mut arrangements = arrangements.into_iter().cycle();
    for (low, high) in
        [(0.44, 8.2), (3.1, 2040.0), (12_400.1, 12_412.1), (12.400_1, 12.412_1), (1e-13, 1e-3), (51.0, 58.0)]
    {
        for scale in [Scale::Linear, Scale::Log] {
            let x = even(low, high, 50);
            let series =
                |label: &str, y: Vec<f64>| Series { label: label.to_owned(), x: x.clone(), y, ..Series::default() };
            let mark = |share: f64, label: &str| Mark { x: low + share * (high - low), label: label.to_owned() };
            let panel = LinePanel {
                subtitle: long.trim().to_owned(),
                x_label: "position along the rail [km]".to_owned(),
                y_label: "growth rate per passage over all wheels [-]".to_owned(),
                x_scale: scale,
                y_scale: scale,
                series: vec![series("P₁/P₀", x.clone()), series(&long.repeat(2), x.iter().rev().copied().collect())],
                marks: vec![
                    mark(0.3, "P₂ 51 Hz"),
                    mark(0.31, "full-track"),
                    mark(0.33, "rail on pad"),
                    mark(1.0, "end"),
                ],
                ..LinePanel::default()
            };
            let figure = LineFigure {
                title: long.repeat(2),
                caption: format!("{}: m_w = 350 kg", "file_name".repeat(30)),
                panels: vec![panel.clone(), LinePanel { subtitle: String::new(), ..panel }],
                arrangement: arrangements.next().unwrap(),
            };
            let words = words_of(&figure.picture().unwrap());
            for expected in ["P1/P0", "P2 51 Hz", "full-track", "rail on pad", "end"] {
                assert!(words.iter().any(|word| word == expected), "{expected} is not in {words:?}");
            }
        }
    }
}

#[test]
fn a_series_without_samples_has_no_name() {
    let series =
        |label: &str, y: f64| Series { label: label.to_owned(), x: vec![1.0, 2.0], y: vec![y; 2], ..Series::default() };
    let panel = LinePanel { series: vec![series("30 mm", 1.0), series("10 mm", f64::NAN)], ..LinePanel::default() };
    let figure = LineFigure { panels: vec![panel], ..LineFigure::default() };
    let words = words_of(&figure.picture().unwrap());
    assert!(words.contains(&"30 mm".to_owned()) && !words.contains(&"10 mm".to_owned()));
}

#[test]
fn missing_sample_breaks_the_line() {
    let line = |y: Vec<f64>| LineFigure {
        panels: vec![LinePanel {
            series: vec![Series { x: even(0.0, 4.0, 5), y, ..Series::default() }],
            y_range: Some((0.0, 3.0)),
            ..LinePanel::default()
        }],
        ..LineFigure::default()
    };
    let pieces = |figure: LineFigure| {
        let svg = figure.picture().unwrap().svg();
        svg.matches("stroke-width=\"1.4\"").count()
    };
    assert_eq!(pieces(line(vec![1.0, 2.0, 1.0, 2.0, 1.0])), 1);
    assert_eq!(pieces(line(vec![1.0, 2.0, f64::NAN, 2.0, 1.0])), 2);
    // A line that leaves the frame and returns is cut in two as well.
    assert_eq!(pieces(line(vec![1.0, 2.0, 99.0, 2.0, 1.0])), 2);
}

#[test]
fn strange_curves_are_drawn() {
    for y in [vec![], vec![f64::NAN; 3], vec![0.0; 3], vec![-1.0, 1.0, f64::INFINITY], vec![1e308, -1e308, 1e-308]] {
        for scale in [Scale::Linear, Scale::Log] {
            for style in [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted, LineStyle::Markers] {
                let x = (0..y.len()).map(|k| k as f64).collect();
                let series = Series { x, y: y.clone(), style, ..Series::default() };
                let panel = LinePanel { y_scale: scale, x_scale: scale, series: vec![series], ..LinePanel::default() };
                for arrangement in [Arrangement::SideBySide, Arrangement::Stacked] {
                    let panels = vec![panel.clone(), LinePanel::default(), LinePanel::default()];
                    let figure = LineFigure { panels, arrangement, ..LineFigure::default() };
                    read(&figure.picture().unwrap().svg());
                    assert!(figure.html().is_ok());
                }
            }
        }
    }
}
