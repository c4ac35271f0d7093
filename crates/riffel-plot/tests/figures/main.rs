//! Whole figures: what is in them, what they survive, that they repeat.

mod lines;
mod pages;

use riffel_plot::{
    Arrangement, BranchLine, LineFigure, LinePanel, LineStyle, MapFigure, MapPanel, Observation, Picture, PlotError,
    RidgeMark, Scale, Series, collisions, constant_frequency_rays,
};
use roxmltree::Document;

fn even(low: f64, high: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| low + (high - low) * k as f64 / (count - 1) as f64).collect()
}

/// A quantity over wavelength and speed.
type Field = Box<dyn Fn(f64, f64) -> f64>;

fn panel(columns: usize, rows: usize, field: impl Fn(f64, f64) -> f64) -> MapPanel {
    let (wavelength_m, speed_m_per_s) = (even(0.020, 0.080, columns), even(5.0, 60.0, rows));
    let values: Vec<f64> =
        speed_m_per_s.iter().flat_map(|&v| wavelength_m.iter().map(|&l| field(l, v)).collect::<Vec<_>>()).collect();
    let ridge = speed_m_per_s
        .iter()
        .map(|&v| RidgeMark {
            wavelength_m: (v / 535.0).clamp(0.020, 0.080),
            speed_m_per_s: v,
            at_edge: !(0.020..0.080).contains(&(v / 535.0)),
        })
        .collect();
    let observation = |wavelength_m: f64, speed_m_per_s: f64, label: &str| Observation {
        wavelength_m,
        speed_m_per_s,
        label: label.to_owned(),
    };
    MapPanel {
        subtitle: "(a) τ = 0.1".to_owned(),
        hover_values: Some(values.iter().map(|value| -1e-8 * value).collect()),
        values,
        value_label: "Re Ŵ₁ [-]".to_owned(),
        ridge,
        best_fit_frequency_hz: Some(537.0),
        rays_hz: constant_frequency_rays((0.020, 0.080), (5.0, 60.0)),
        observations: vec![
            observation(0.04, 20.0, "BR survey (1911)"),
            observation(0.05, 30.0, "Harrison (1979)"),
            observation(0.5, 30.0, "Harrison (1979)"),
            observation(f64::NAN, 30.0, "A & B <1992>"),
        ],
        wavelength_m,
        speed_m_per_s,
        ..MapPanel::default()
    }
}

fn growth(wavelength: f64, speed: f64) -> f64 {
    0.2 - (-((speed / wavelength - 535.0) / 200.0).powi(2)).exp()
}

fn map(panels: Vec<MapPanel>) -> MapFigure {
    MapFigure {
        title: "BR main line, tangent track".to_owned(),
        caption: "Growth where Re Ŵ₁ < 0; μ = 0.4, P₀ = 50 kN, Δ = 31.5 µm, I → ∞, ν ≥ 0, exp(+iωt).".to_owned(),
        panels,
    }
}

fn curves() -> LineFigure {
    let x = even(10.0, 5000.0, 300);
    let series =
        |label: &str, style, y: Vec<f64>| Series { label: label.to_owned(), x: x.clone(), y, style, color: None };
    let magnitude: Vec<f64> = x.iter().map(|f| 1e-6 * f.powf(-1.5)).collect();
    let mut broken = magnitude.clone();
    broken[100] = f64::NAN;
    broken[200] = -1.0;
    let first = LinePanel {
        subtitle: "(a)".to_owned(),
        x_label: "frequency f [Hz]".to_owned(),
        y_label: "|receptance| [m/N]".to_owned(),
        x_scale: Scale::Log,
        y_scale: Scale::Log,
        series: vec![
            series("free beam", LineStyle::Solid, magnitude),
            series("two-layer track", LineStyle::Dashed, broken),
        ],
        ..LinePanel::default()
    };
    let second = LinePanel {
        y_label: "phase [°]".to_owned(),
        y_scale: Scale::Linear,
        y_range: Some((-180.0, 0.0)),
        series: vec![
            series("phase", LineStyle::Dotted, x.iter().map(|f| -f / 10.0).collect()),
            series("measured", LineStyle::Markers, x.iter().map(|f| -f / 20.0).collect()),
        ],
        ..first.clone()
    };
    LineFigure {
        title: "Vertical receptance".to_owned(),
        caption: "m = 56 kg/m.".to_owned(),
        panels: vec![first, second],
        arrangement: Arrangement::SideBySide,
    }
}

fn read(svg: &str) -> Document<'_> {
    Document::parse(svg).expect("the figure is an SVG document")
}

/// The words of a picture, none of which lacks a glyph, lies over another or leaves the sheet.
fn words_of(picture: &Picture) -> Vec<String> {
    let svg = picture.svg();
    assert_eq!(collisions(&svg), [""; 0]);
    let font = ttf_parser::Face::parse(dejavu::sans::regular(), 0).unwrap();
    let document = read(&svg);
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    let words = texts.map(|text| {
        let pieces = text.descendants().filter(|node| node.is_text());
        let words: String = pieces.filter_map(|piece| piece.text()).collect();
        assert!(words.chars().all(|c| font.glyph_index(c).is_some()), "{words} lacks a glyph");
        words
    });
    let words: Vec<String> = words.collect();
    assert!(!words.is_empty());
    words
}

#[test]
fn map_names_its_axes_rays_and_marks() {
    let words = words_of(&map(vec![panel(61, 56, growth)]).picture().unwrap());
    for expected in [
        "wavelength λ [mm]",
        "speed V [km/h]",
        "speed V [m/s]",
        "Re Ŵ1 [-]",
        "f = 537 Hz",
        "1000 Hz",
        "20",
        "80",
        "200",
        "0",
        "BR survey (1911)",
        "A & B <1992>",
        "(a) τ = 0.1",
    ] {
        assert!(words.iter().any(|word| word == expected), "{expected} is not in {words:?}");
    }
    assert!(!words.iter().any(|word| word.contains("not computed")));
}

#[test]
fn subscripts_are_small_and_low() {
    let svg = map(vec![panel(61, 56, growth)]).picture().unwrap().svg();
    let drawn = &svg[svg.find("</desc>").unwrap()..];
    assert!(drawn.contains("Re Ŵ<tspan") && !drawn.contains('₁'));
    // In words for readers that see no picture they stay plain.
    assert!(svg[..svg.find("</desc>").unwrap()].contains("Re Ŵ₁"));
    let page = map(vec![panel(23, 17, growth)]).html().unwrap();
    let page = &page[page.find("<main>").unwrap()..];
    assert!(page.contains("Ŵ\\u003csub>1\\u003c/sub>") && page.contains("P<sub>0</sub>"));
}

/// Width and height in the header of a PNG file.
fn png_size(bytes: &[u8]) -> (u32, u32) {
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
    (number(16), number(20))
}

#[test]
fn png_has_the_size_of_the_sheet_and_shows_growth_in_blue() {
    let picture = map(vec![panel(61, 56, growth)]).picture().unwrap();
    let svg = picture.svg();
    let document = read(&svg);
    let side = |name, scale: f32| {
        let length: f32 = document.root_element().attribute(name).unwrap().parse().unwrap();
        (length * scale) as u32
    };
    for scale in [1.0f32, 2.0, 3.0] {
        let bytes = picture.png(scale).unwrap();
        assert_eq!(png_size(&bytes), (side("width", scale), side("height", scale)));
    }
    let pixels = tiny_skia::Pixmap::decode_png(&picture.png(1.0).unwrap()).unwrap();
    let share = |test: &dyn Fn(u8, u8, u8) -> bool| {
        let all = pixels.pixels();
        all.iter().filter(|p| test(p.red(), p.green(), p.blue())).count() as f64 / all.len() as f64
    };
    let (white, blue) = (share(&|r, g, b| r > 250 && g > 250 && b > 250), share(&|r, _, b| b > r.saturating_add(40)));
    assert!(white > 0.3 && white < 0.9, "{white}");
    assert!(blue > 0.05 && blue < 0.5, "{blue}");
}

#[test]
fn strange_maps_are_drawn() {
    let holes = |l: f64, v: f64| {
        if (l * 1e3) as i64 % 7 == 3 || v > 55.0 { f64::NAN } else { growth(l, v) }
    };
    let fields: [(&str, Field); 9] = [
        ("not a number", Box::new(|_, _| f64::NAN)),
        ("infinite", Box::new(|_, _| f64::NEG_INFINITY)),
        ("decay everywhere", Box::new(|_, _| 1.0)),
        ("zero", Box::new(|_, _| 0.0)),
        ("equal growth everywhere", Box::new(|_, _| -1.0)),
        ("one cell", Box::new(|l, v| if l < 0.0205 && v < 5.5 { -1e-7 } else { 1.0 })),
        ("tiny", Box::new(|l, v| 1e-310 * growth(l, v))),
        ("huge", Box::new(|l, v| 1e308 * growth(l, v))),
        ("holes", Box::new(holes)),
    ];
    for (name, field) in fields {
        for (columns, rows) in [(2, 2), (23, 17)] {
            let mut bare = panel(columns, rows, &field);
            bare.ridge.clear();
            bare.rays_hz = vec![f64::NAN, -1.0, 0.0, 1e9, 500.0];
            bare.best_fit_frequency_hz = Some(f64::NAN);
            bare.hover_values = None;
            for level_count in [0, 1, 10, usize::MAX] {
                let figure = map(vec![panel(columns, rows, &field), MapPanel { level_count, ..bare.clone() }]);
                let picture = figure.picture();
                let svg = picture.unwrap_or_else(|error| panic!("{name}: {error}")).svg();
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
                read(&svg);
            }
            assert!(map(vec![bare]).html().is_ok(), "{name}");
        }
    }
    let words = words_of(&map(vec![panel(23, 17, |_, _| 1.0)]).picture().unwrap());
    assert!(words.iter().any(|word| word == "no growth in this window"));
    let words = words_of(&map(vec![panel(23, 17, holes)]).picture().unwrap());
    assert!(words.iter().any(|word| word == "not computed"));
}

/// The strongest branch carries its frequency as that of the best fit; the next ones their own beside their line.
#[test]
fn branches_are_named() {
    let line = |frequency_hz: f64| BranchLine {
        frequency_hz,
        points: [10.0, 15.0, 20.0].map(|v| (v / frequency_hz, v)).to_vec(),
    };
    let figure = map(vec![MapPanel {
        branches: vec![line(537.0), line(333.0), line(271.0), line(411.0), line(611.0)],
        ..panel(23, 17, growth)
    }]);
    let words = words_of(&figure.picture().unwrap());
    for (label, times) in [("f = 537 Hz", 1), ("333 Hz", 1), ("271 Hz", 1), ("411 Hz", 1), ("611 Hz", 0)] {
        assert_eq!(words.iter().filter(|word| *word == label).count(), times, "{label}");
    }
    assert!(words.iter().any(|word| word == "branches of growth"));
    let html = figure.html().unwrap();
    assert_eq!(html.matches("\"legendgroup\":\"branches of growth\"").count(), 5);
    assert!(html.contains("\\u003cb>333 Hz") && !html.contains("\\u003cb>611 Hz"));
    let bare = words_of(&map(vec![panel(23, 17, growth)]).picture().unwrap());
    assert!(!bare.iter().any(|word| word == "branches of growth"));
}

/// Panels that are compared have one scale: that of the strongest growth of all.
#[test]
fn panels_share_a_scale() {
    let figure = map(vec![panel(23, 17, growth), panel(23, 17, |l, v| 3.0 * growth(l, v)), panel(23, 17, |_, _| 1.0)]);
    let end = figure.panels[1].strongest_growth();
    assert_ne!(figure.panels[0].strongest_growth(), end);
    let shared = figure.with_one_scale();
    assert!(shared.panels.iter().all(|panel| panel.scale_end == end));
    // The colour bars are alike: each label of the second stands under the first too.
    let least = format!("{:.2}", end.unwrap());
    let labels = words_of(&shared.picture().unwrap());
    let of_scale = labels.iter().filter(|label| label.replace('−', "-") == least);
    assert_eq!(of_scale.count(), 3, "{least} {labels:?}");
}

#[test]
fn contradictory_data_are_refused_in_words() {
    let mut short = panel(5, 4, growth);
    short.values.pop();
    let error = map(vec![short]).picture().unwrap_err();
    assert_eq!(error.to_string(), "panel 0: values holds 19 numbers, but 4 speeds × 5 wavelengths need 20");
    let mut order = panel(5, 4, growth);
    order.speed_m_per_s[2] = 1.0;
    assert!(matches!(map(vec![order]).html(), Err(PlotError::GridOrder { index: 2, .. })));
    let mut few = panel(5, 4, growth);
    few.wavelength_m.truncate(1);
    assert!(matches!(map(vec![few]).picture(), Err(PlotError::TooFewGridPoints { found: 1, .. })));
    assert_eq!(map(vec![]).picture(), Err(PlotError::NoPanel));
    let mut lines = curves();
    lines.panels[0].y_range = Some((0.0, 1.0));
    assert!(matches!(lines.picture(), Err(PlotError::AxisRange { axis: "y", .. })));
    let mut lines = curves();
    lines.panels[1].series[0].x.pop();
    assert!(matches!(lines.html(), Err(PlotError::SeriesLength { panel: 1, .. })));
}

#[test]
fn figures_repeat_to_the_byte() {
    let figure = map(vec![panel(61, 56, growth), panel(40, 30, growth)]);
    let picture = figure.picture().unwrap();
    assert_eq!(Ok(&picture), figure.clone().picture().as_ref());
    assert_eq!(figure.html(), figure.clone().html());
    assert_eq!(picture.svg(), picture.svg());
    assert_eq!(picture.png(1.0), picture.png(1.0));
    assert_eq!(curves().picture(), curves().picture());
    assert_eq!(curves().html(), curves().html());
}

#[test]
fn large_grids_stay_light() {
    let wavy = |l: f64, v: f64| (l * 900.0).sin() * (v * 0.9).cos() - 0.1;
    let figure = map(vec![panel(1500, 1200, wavy), panel(1500, 1200, growth)]);
    let svg = figure.picture().unwrap().svg();
    assert!(svg.len() < 2_000_000, "{} bytes", svg.len());
    // plotly.js takes 4.6 MB of it.
    let html = figure.html().unwrap();
    assert!(html.len() < 9_000_000, "{} bytes", html.len());
}
