//! Draws sample figures from invented numbers into the folder given as the argument.

use riffel_plot::{
    Arrangement, LineFigure, LinePanel, LineStyle, MapFigure, MapPanel, Observation, RidgeMark,
    Scale, Series, constant_frequency_rays, png,
};

fn map_panel(subtitle: &str, strength: f64) -> MapPanel {
    let wavelength_m: Vec<f64> = (0..241)
        .map(|k| 0.020 + 0.060 * f64::from(k) / 240.0)
        .collect();
    let speed_m_per_s: Vec<f64> = (0..221)
        .map(|k| 5.0 + 55.0 * f64::from(k) / 220.0)
        .collect();
    let field = |l: f64, v: f64| {
        let f = v / l;
        strength * v / 60.0
            * (0.4 * ((f - 1200.0) / 500.0).tanh() * 0.5 + 0.2
                - 1.3 * (-((f - 535.0) / 220.0f64).powi(2)).exp())
    };
    let values: Vec<f64> = speed_m_per_s
        .iter()
        .flat_map(|&v| wavelength_m.iter().map(move |&l| field(l, v)))
        .collect();
    let ridge = speed_m_per_s
        .iter()
        .map(|&v| {
            let best = wavelength_m
                .iter()
                .copied()
                .min_by(|a, b| field(*a, v).total_cmp(&field(*b, v)))
                .unwrap();
            RidgeMark {
                wavelength_m: best,
                speed_m_per_s: v,
                at_edge: best <= 0.020 || best >= 0.080,
            }
        })
        .collect();
    let observe = |mm: f64, kmh: f64, label: &str| Observation {
        wavelength_m: mm / 1e3,
        speed_m_per_s: kmh / 3.6,
        label: label.to_owned(),
    };
    MapPanel {
        subtitle: subtitle.to_owned(),
        hover_values: Some(values.iter().map(|v| -1e-7 * v).collect()),
        values,
        value_label: "Re Ŵ₁ [-]".to_owned(),
        ridge,
        best_fit_frequency_hz: Some(537.0),
        rays_hz: constant_frequency_rays((0.020, 0.080), (5.0, 60.0)),
        observations: vec![
            observe(42.0, 60.0, "BR survey (1911)"),
            observe(50.0, 80.0, "BR survey (1911)"),
            observe(58.0, 110.0, "BR survey (1911)"),
            observe(45.0, 110.0, "Harrison (1979)"),
            observe(56.0, 150.0, "Harrison (1979)"),
            observe(62.0, 180.0, "Harrison (1979)"),
            observe(31.0, 40.0, "Vancouver SkyTrain (1992)"),
            observe(33.0, 70.0, "Vancouver SkyTrain (1992)"),
        ],
        wavelength_m,
        speed_m_per_s,
        ..MapPanel::default()
    }
}

fn receptance() -> LineFigure {
    let f: Vec<f64> = (0..400)
        .map(|k| 10f64.powf(1.3 + 2.4 * f64::from(k) / 399.0))
        .collect();
    let free = |f: &f64| 2e-6 * f.powf(-1.5);
    let two = |f: &f64| {
        2e-10 / ((1.0 - (f / 90.0).powi(2)).powi(2) + 0.1 * (f / 90.0f64).powi(2)).sqrt()
            + 0.3 * free(f)
    };
    let series = |label: &str, y: Vec<f64>, style| Series {
        label: label.to_owned(),
        x: f.clone(),
        y,
        style,
        color: None,
    };
    LineFigure {
        title: "Vertical direct receptance of the rail".to_owned(),
        caption:
            "m = 56 kg/m, I = 2.35·10⁻⁵ m⁴, V = 27.8 m/s. Displacement over force, both positive \
        downward; time factor exp(+iωt). Invented numbers."
                .to_owned(),
        panels: vec![
            LinePanel {
                x_label: "frequency f [Hz]".to_owned(),
                y_label: "|receptance| [m/N]".to_owned(),
                x_scale: Scale::Log,
                y_scale: Scale::Log,
                series: vec![
                    series(
                        "free beam, moving load",
                        f.iter().map(free).collect(),
                        LineStyle::Solid,
                    ),
                    series(
                        "two-layer track",
                        f.iter().map(two).collect(),
                        LineStyle::Dashed,
                    ),
                ],
                ..LinePanel::default()
            },
            LinePanel {
                x_label: "frequency f [Hz]".to_owned(),
                y_label: "phase [°]".to_owned(),
                x_scale: Scale::Log,
                y_range: Some((-180.0, 0.0)),
                series: vec![
                    series(
                        "free beam, moving load",
                        f.iter().map(|_| -135.0).collect(),
                        LineStyle::Solid,
                    ),
                    series(
                        "two-layer track",
                        f.iter()
                            .map(|f| -(f / 90.0).atan().to_degrees() * 1.5)
                            .collect(),
                        LineStyle::Dashed,
                    ),
                ],
                ..LinePanel::default()
            },
        ],
        arrangement: Arrangement::Stacked,
    }
}

fn inertia() -> LineFigure {
    let v: Vec<f64> = (0..112).map(|k| 5.0 + 0.5 * f64::from(k)).collect();
    let curve = |label: &str, style, a: f64, gap: bool| Series {
        label: label.to_owned(),
        x: v.clone(),
        y: v.iter()
            .map(|v| {
                if gap && (20.0..25.0).contains(v) {
                    f64::NAN
                } else {
                    a * (v / 60.0).powf(1.2)
                }
            })
            .collect(),
        style,
        color: None,
    };
    LineFigure {
        title: String::new(),
        caption:
            "Left: strongest growth over speed for three tractive ratios. Right: a growth rate \
        with samples. Invented numbers."
                .to_owned(),
        panels: vec![
            LinePanel {
                subtitle: "(a)".to_owned(),
                x_label: "speed V [m/s]".to_owned(),
                y_label: "min Re Ŵ₁ [-]".to_owned(),
                series: vec![
                    curve("τ = 0.1", LineStyle::Solid, -0.2, false),
                    curve("τ = 0.5", LineStyle::Dashed, -0.5, true),
                    curve("τ = 0.95", LineStyle::Dotted, -0.9, false),
                ],
                ..LinePanel::default()
            },
            LinePanel {
                subtitle: "(b)".to_owned(),
                x_label: "speed V [m/s]".to_owned(),
                y_label: "growth rate per passage [-]".to_owned(),
                series: vec![
                    curve("I = 27.77 kg m²", LineStyle::Solid, 3e-9, false),
                    curve(
                        "I → 0, constant tangential force",
                        LineStyle::Dashed,
                        5e-9,
                        false,
                    ),
                    curve("I → ∞, constant creepage", LineStyle::Dotted, -2e-9, false),
                    Series {
                        label: "measured".to_owned(),
                        x: vec![10.0, 20.0, 30.0, 40.0],
                        y: vec![1e-9, 1.2e-9, 2e-9, 3e-9],
                        style: LineStyle::Markers,
                        color: None,
                    },
                ],
                ..LinePanel::default()
            },
        ],
        arrangement: Arrangement::SideBySide,
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::path::PathBuf::from(std::env::args().nth(1).ok_or("which folder?")?);
    std::fs::create_dir_all(&folder)?;
    let caption = "Real part of the first-order dissipation over wavelength and speed, ten equal steps \
        from 0 to the smallest value; growth where Re Ŵ₁ < 0. E = 207 GPa, ν = 0.3, m = 56 \
        kg/m, m_w = 350 kg, μ = 0.4, P₀ = 50 kN, R = 0.46 m, Δ = 31.5 µm. Time factor \
        exp(+iωt), braking positive. Invented numbers.";
    let one = MapFigure {
        title: "BR main line, tangent track".to_owned(),
        caption: caption.to_owned(),
        panels: vec![map_panel("τ = 0.1", 1.0)],
    };
    let mut two = one.clone();
    two.panels = vec![
        map_panel("(a) τ = 0.1", 1.0),
        map_panel("(b) τ = 0.95", 3.4e-4),
    ];
    for k in 0..40 {
        for j in 0..30 {
            two.panels[1].values[(150 + k) * 241 + 200 + j] = f64::NAN;
        }
    }
    for (name, figure) in [("map", &one), ("maps", &two)] {
        let svg = figure.svg()?;
        std::fs::write(folder.join(format!("{name}.png")), png(&svg, 2.0)?)?;
        std::fs::write(folder.join(format!("{name}.svg")), svg)?;
        std::fs::write(folder.join(format!("{name}.html")), figure.html()?)?;
    }
    for (name, figure) in [("receptance", receptance()), ("inertia", inertia())] {
        let svg = figure.svg()?;
        std::fs::write(folder.join(format!("{name}.png")), png(&svg, 2.0)?)?;
        std::fs::write(folder.join(format!("{name}.svg")), svg)?;
        std::fs::write(folder.join(format!("{name}.html")), figure.html()?)?;
    }
    Ok(())
}
