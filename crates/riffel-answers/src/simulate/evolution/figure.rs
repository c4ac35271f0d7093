//! Figures of a rail after many wheels.

use riffel_keys::Language;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::{Band, EvolutionAnswer, WornProfile};
use crate::forecast::{per_million, rate_panel, zero};
use crate::parameters;
use crate::roughness::figure::level_panel;

/// Curves of a panel beside the linear loop.
const MOST: usize = 4;

impl EvolutionAnswer {
    /// Levels by wavelength and over passages, growth and drift, beside the linear loop.
    pub(super) fn spectrum_figure(&self) -> LineFigure {
        let bands = &self.bands[..];
        LineFigure::new(
            self.title(),
            format!(
                "One-third-octave levels, growth of the level and shift of the waves along the rail. \
                 The linear loop is taken wave by wave from the rail before any wheel. {}",
                self.parameters()
            ),
            [self.levels(bands), self.over_passages(bands), growth(bands), drift(bands)],
        )
    }

    /// Figure of one stretch of rail at several stages, with the waves of the bands alone.
    pub(super) fn profile_figure(&self) -> LineFigure {
        let stretch = self.stretch();
        let shown = spread(self.profiles.len(), MOST).into_iter();
        LineFigure::new(
            self.title(),
            format!(
                "Part of the rail, with the waves of map.wavelength alone. What is worn off \
                 everywhere is left out. {}",
                self.parameters()
            ),
            shown.map(|index| {
                let subtitle = after(self.profiles[index].passages);
                stretch.panel(&[(index, "")], subtitle)
            }),
        )
        .arranged(Arrangement::Strips)
    }

    /// Every profile that was kept with its levels, beside those before any wheel: for a page with a slider over passages.
    pub(super) fn stage_figures(&self) -> Vec<(String, LineFigure)> {
        let stretch = self.stretch();
        let bands = self.linear.bands();
        let all: Vec<Vec<f64>> = self
            .profiles
            .iter()
            .map(|profile| self.linear.levels(profile, self.spacing))
            .map(|levels| levels.into_iter().map(drawn).collect())
            .collect();
        let (low, high) = all
            .iter()
            .flatten()
            .filter(|level| level.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &level| (low.min(level), high.max(level)));
        let caption = format!(
            "Levels, and part of the rail with the waves of map.wavelength alone. The linear loop is \
             taken wave by wave from the rail before any wheel. {}",
            self.parameters()
        );
        let curve = |label: &str, y: Vec<f64>, style, color| Series {
            label: label.to_owned(),
            style,
            color: Some(color),
            ..over_bands(bands.iter().map(|band| band.band.wavelength()).zip(y))
        };
        let figure = |(index, profile): (usize, &WornProfile)| {
            let linear = bands.iter().map(|band| drawn(band.level(profile.passages)));
            let levels = LinePanel {
                y_range: Some(around(low, high)),
                ..level_panel(
                    vec![
                        curve("before any wheel", all[0].clone(), LineStyle::Dotted, Rgb::BLACK),
                        curve("linear", linear.collect(), LineStyle::Dashed, OKABE_ITO[1]),
                        curve("now", all[index].clone(), LineStyle::Solid, OKABE_ITO[2]),
                    ],
                    Language::English,
                )
            };
            let name = after(profile.passages);
            let figure = LineFigure::new(
                self.title(),
                caption.clone(),
                [levels, stretch.panel(&[(0, "before any wheel"), (index, "now")], String::new())],
            )
            .arranged(Arrangement::Stacked);
            (name, figure)
        };
        self.profiles.iter().enumerate().map(figure).collect()
    }

    /// Place of the largest height before any wheel \[m\], such as a weld.
    fn highest(&self) -> f64 {
        let sizes = self.profiles[0].heights_m.iter().map(|height| height.abs());
        let largest = sizes.enumerate().max_by(|one, other| one.1.total_cmp(&other.1));
        largest.map_or(0.0, |(index, _)| index as f64 * self.spacing)
    }

    /// Some waves of the band that is highest at the end, about the highest place of the rail.
    fn stretch(&self) -> Stretch {
        /// Waves that are shown.
        const WAVES: f64 = 16.0;
        /// Points of the shortest of them.
        const POINTS: f64 = 10.0;
        let bands = &self.bands;
        let at_end = |band: &Band| band.level_db[band.level_db.len() - 1];
        let leading = bands.iter().max_by(|one, other| at_end(one).total_cmp(&at_end(other)));
        let shown = WAVES * leading.map_or(0.1, |band| band.wavelength_m);
        let shortest = bands.first().map_or(0.01, |band| band.wavelength_m);
        let count = (shown / shortest * POINTS).ceil();
        let begin = self.highest() - 0.5 * shown;
        let places: Vec<f64> =
            (0..=count as usize).map(|index| begin.max(0.0) + shown * index as f64 / count).collect();
        let heights: Vec<Vec<f64>> = self
            .profiles
            .iter()
            .map(|profile| self.linear.heights(profile, self.spacing, &places))
            .map(|heights| heights.iter().map(|height| 1e6 * height).collect())
            .collect();
        let largest = heights.iter().flatten().copied().map(f64::abs);
        Stretch { largest: largest.fold(0.0, f64::max), places, heights }
    }

    /// Of the case, and what passed in the place of its wheel.
    fn parameters(&self) -> String {
        let alone = self.vehicles.len() == 1 && self.vehicles[0].speeds == 1;
        if alone {
            return parameters(&self.run.case);
        }
        let vehicles = self.vehicles.iter().map(|vehicle| {
            format!(
                "{:.1} % {}, {:.1} ± {:.1} km/h, P₀ = {:.1} kN, τ = {:.3} on {:.0} % of its axles",
                100.0 * vehicle.share,
                vehicle.name,
                3.6 * vehicle.speed_m_per_s,
                3.6 * vehicle.speed_deviation_m_per_s,
                1e-3 * vehicle.normal_load_n,
                vehicle.tractive_ratio,
                100.0 * vehicle.traction_share
            )
        });
        let vehicles: Vec<String> = vehicles.collect();
        format!(
            "Traffic: {}. All else, and what a vehicle does not say, is that of the case. {}",
            vehicles.join("; "),
            parameters(&self.run.case)
        )
    }

    /// What the run was, for titles.
    pub(super) fn title(&self) -> String {
        let passages = self.passages;
        let title = self.run.case.file.title.as_deref().unwrap_or("A rail");
        format!(
            "{title}: {} passages at {:.1} km/h{}",
            in_words(passages),
            3.6 * self.speed_m_per_s,
            if self.vehicles.len() > 1 || self.vehicles[0].speeds > 1 { " in the mean" } else { "" }
        )
    }

    /// Levels by wavelength at some stages, and what the linear loop has at the last.
    fn levels(&self, bands: &[Band]) -> LinePanel {
        let curve = |label: String, style, color, of: &dyn Fn(&Band) -> f64| Series {
            label,
            style,
            color: Some(color),
            ..over_bands(bands.iter().map(|band| (band.wavelength_m, drawn(of(band)))))
        };
        let mut series: Vec<Series> = self
            .evenly(MOST)
            .into_iter()
            .enumerate()
            .map(|(number, stage)| {
                let color = OKABE_ITO[1 + number % (OKABE_ITO.len() - 1)];
                curve(after(self.stages.passages[stage]), LineStyle::Solid, color, &|band| band.level_db[stage])
            })
            .collect();
        let last = self.stages.passages.len() - 1;
        let highest = bands.iter().flat_map(|band| &band.level_db);
        let highest = highest.copied().map(drawn).fold(f64::NEG_INFINITY, f64::max);
        let lowest = bands.iter().flat_map(|band| &band.level_db);
        let lowest = lowest.copied().map(drawn).fold(f64::INFINITY, f64::min);
        series.push(curve("linear, at the end".to_owned(), LineStyle::Dashed, Rgb::BLACK, &|band| {
            band.linear_level_db[last]
        }));
        LinePanel { y_range: Some(around(lowest, highest)), ..level_panel(series, Language::English) }
    }

    /// Levels over passages of the bands that are highest at the end.
    fn over_passages(&self, bands: &[Band]) -> LinePanel {
        const BANDS: usize = 4;
        let last = self.stages.passages.len() - 1;
        let mut highest: Vec<&Band> = bands.iter().collect();
        highest.sort_by(|one, other| other.level_db[last].total_cmp(&one.level_db[last]));
        highest.truncate(BANDS);
        highest.sort_by(|one, other| one.wavelength_m.total_cmp(&other.wavelength_m));
        let passages: Vec<f64> = self.stages.passages.iter().map(|passages| *passages as f64).collect();
        let scale = thousands(passages[last]);
        let mut series = Vec::new();
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for (index, band) in highest.into_iter().enumerate() {
            let color = Some(OKABE_ITO[1 + index % (OKABE_ITO.len() - 1)]);
            low = band.level_db.iter().copied().map(drawn).fold(low, f64::min);
            high = band.level_db.iter().copied().map(drawn).fold(high, f64::max);
            let curve = |label: String, y: &[f64], style| Series {
                color,
                ..Series::new(
                    label,
                    passages.iter().map(|passages| passages / scale.0).collect(),
                    y.iter().copied().map(drawn).collect(),
                )
                .styled(style)
            };
            series.push(curve(format!("{:.1} mm", 1e3 * band.wavelength_m), &band.level_db, LineStyle::Solid));
            series.push(curve(String::new(), &band.linear_level_db, LineStyle::Dashed));
        }
        LinePanel {
            y_range: Some(around(low, high)),
            ..LinePanel::new(scale.1.to_owned(), "level [dB re 1 µm], dashed linear", series)
        }
    }

    /// Stages at about equal numbers of passages.
    fn evenly(&self, most: usize) -> Vec<usize> {
        let last = self.passages;
        let mut chosen: Vec<usize> = (0..most)
            .filter_map(|part| {
                let goal = last as f64 * part as f64 / (most - 1) as f64;
                let stages = self.stages.passages.iter().map(|passages| (*passages as f64 - goal).abs());
                let nearest = stages.enumerate().min_by(|one, other| one.1.total_cmp(&other.1));
                nearest.map(|(index, _)| index)
            })
            .collect();
        chosen.dedup();
        chosen
    }
}

/// A stretch of the rail at every profile that was kept.
struct Stretch {
    /// \[m\]
    places: Vec<f64>,
    /// \[µm\]
    heights: Vec<Vec<f64>>,
    /// Largest height of any of them \[µm\].
    largest: f64,
}

impl Stretch {
    /// Profiles by their numbers, each with its name.
    fn panel(&self, shown: &[(usize, &str)], subtitle: String) -> LinePanel {
        let last = shown.len() - 1;
        let series = shown.iter().enumerate().map(|(place, (index, label))| Series {
            color: match place == last {
                true => None,
                false => Some(Rgb::BLACK),
            },
            ..Series::new(*label, self.places.clone(), self.heights[*index].clone()).styled(match place == last {
                true => LineStyle::Solid,
                false => LineStyle::Dotted,
            })
        });
        LinePanel {
            y_range: Some((-1.05 * self.largest, 1.05 * self.largest)),
            ..LinePanel::new("place along the rail x [m]", "height [µm]", series).titled(subtitle)
        }
    }
}

/// At most so many of `count`, the first and the last among them.
fn spread(count: usize, most: usize) -> Vec<usize> {
    let most = most.min(count);
    let mut chosen: Vec<usize> = (0..most).map(|part| part * (count - 1) / (most - 1).max(1)).collect();
    chosen.dedup();
    chosen
}

/// Growth by wavelength, at the beginning and at the end.
fn growth(bands: &[Band]) -> LinePanel {
    let wavelengths: Vec<f64> = bands.iter().map(|band| 1e3 * band.wavelength_m).collect();
    let curve = |label: &str, style, color, of: fn(&Band) -> Option<f64>| Series {
        label: label.to_owned(),
        style,
        color: Some(color),
        ..over_bands(bands.iter().map(|band| (band.wavelength_m, of(band).map_or(f64::NAN, per_million))))
    };
    rate_panel(
        vec![
            curve("first step", LineStyle::Solid, OKABE_ITO[1], |band| band.first_growth_per_passage),
            curve("last quarter", LineStyle::Solid, OKABE_ITO[2], |band| band.last_growth_per_passage),
            curve("linear, first step", LineStyle::Markers, Rgb::BLACK, |band| band.first_linear_growth_per_passage),
            zero(&wavelengths),
        ],
        Language::English,
    )
}

/// How fast waves move along the rail.
fn drift(bands: &[Band]) -> LinePanel {
    let wavelengths: Vec<f64> = bands.iter().map(|band| 1e3 * band.wavelength_m).collect();
    let curve = |label: &str, style, color, of: &dyn Fn(&Band) -> f64| Series {
        label: label.to_owned(),
        style,
        color: Some(color),
        // [m] in a passage are [mm] in a thousand, and a thousand of them in a million.
        ..over_bands(bands.iter().map(|band| (band.wavelength_m, 1e9 * of(band))))
    };
    LinePanel::new(
        "wavelength λ [mm]",
        "drift [mm per 10⁶ passages]",
        [
            curve("first step", LineStyle::Solid, OKABE_ITO[1], &|band| {
                band.first_shift_m_per_passage.unwrap_or(f64::NAN)
            }),
            curve("linear", LineStyle::Markers, Rgb::BLACK, &|band| band.linear_shift_m_per_passage),
            zero(&wavelengths),
        ],
    )
    .scaled(Scale::Log, Scale::Linear)
}

/// A curve over bands by their wavelengths \[m\], broken where one is left out.
fn over_bands(values: impl Iterator<Item = (f64, f64)>) -> Series {
    /// Ratio of two wavelengths that are not neighbours.
    const GAP: f64 = 1.4;
    let mut series = Series::default();
    let mut before = f64::INFINITY;
    for (wavelength, value) in values {
        if wavelength > GAP * before {
            series.x.push(1e3 * (wavelength * before).sqrt());
            series.y.push(f64::NAN);
        }
        before = wavelength;
        series.x.push(1e3 * wavelength);
        series.y.push(value);
    }
    series
}

/// A range of levels with room above and below \[dB\].
fn around(low: f64, high: f64) -> (f64, f64) {
    const ROOM: f64 = 5.0;
    (low - ROOM, high + ROOM)
}

/// A divisor for numbers of passages, and the name of the axis.
fn thousands(most: f64) -> (f64, &'static str) {
    match most {
        most if most >= 3e6 => (1e6, "passages [10⁶]"),
        most if most >= 3e3 => (1e3, "passages [10³]"),
        _ => (1.0, "passages"),
    }
}

/// A stage in words.
fn after(passages: u64) -> String {
    match passages {
        0 => "before any wheel".to_owned(),
        passages => format!("after {}", in_words(passages)),
    }
}

/// A number of passages in words.
fn in_words(passages: u64) -> String {
    match passages as f64 {
        many if many >= 1e6 => format!("{:.1} million", 1e-6 * many),
        many if many >= 1e4 => format!("{:.0} thousand", 1e-3 * many),
        few => few.to_string(),
    }
}

/// A level worth drawing; less is rounding.
fn drawn(level: f64) -> f64 {
    const LEAST: f64 = -100.0;
    match level {
        level if level > LEAST => level,
        _ => f64::NAN,
    }
}
