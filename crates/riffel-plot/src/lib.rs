//! Figures of rail corrugation: growth maps over wavelength and speed, and curves.
//!
//! The crate draws and does nothing else. It takes plain numbers in SI units, knows no physics,
//! reads and writes no files, and hands back text and bytes: SVG, PNG, and pages of HTML that show
//! the numbers under the pointer and load nothing from a network. Identical data give identical
//! bytes, on every machine: the font is compiled in.
//!
//! A map keeps the sign of the quantity it is given. Corrugation grows where the value is negative,
//! and only there the map is coloured, darker where growth is stronger:
//!
//! ```
//! use riffel_plot::{DEFAULT_PNG_SCALE, MapFigure, MapPanel, constant_frequency_rays};
//!
//! let wavelength_m: Vec<f64> = (0..31).map(|k| 0.020 + 0.002 * f64::from(k)).collect();
//! let speed_m_per_s: Vec<f64> = (0..28).map(|k| 5.0 + 2.0 * f64::from(k)).collect();
//! // A stand-in for physics: strongest growth at 500 Hz, decay far from it.
//! let values = speed_m_per_s
//!     .iter()
//!     .flat_map(|v| wavelength_m.iter().map(move |l| 0.2 - (-((v / l - 500.0) / 200.0).powi(2)).exp()))
//!     .collect();
//! let figure = MapFigure {
//!     title: "An invented track".to_owned(),
//!     caption: "Growth where Re Ŵ₁ < 0.".to_owned(),
//!     panels: vec![MapPanel {
//!         values,
//!         value_label: "Re Ŵ₁ [-]".to_owned(),
//!         best_fit_frequency_hz: Some(500.0),
//!         rays_hz: constant_frequency_rays((0.020, 0.080), (5.0, 59.0)),
//!         wavelength_m,
//!         speed_m_per_s,
//!         ..MapPanel::default()
//!     }],
//! };
//! let picture = figure.picture()?;
//! assert!(picture.svg().starts_with("<svg"));
//! assert!(picture.png(DEFAULT_PNG_SCALE)?.starts_with(b"\x89PNG"));
//! # Ok::<(), riffel_plot::PlotError>(())
//! ```
//!
//! Lengths on the sheet are pixels of CSS, 96 per inch: a map of one panel is 146 mm wide with
//! labels of 9 and 10 points, one of two panels 196 mm.
//!
//! Built for WebAssembly the crate holds figures as data alone: a browser draws them.

#![cfg_attr(target_family = "wasm", expect(dead_code, reason = "drawing alone asks this of figures"))]

mod bar_figure;
mod chainage;
mod color;
#[cfg(not(target_family = "wasm"))]
mod drawing;
mod error;
mod grid;
mod line_figure;
mod map_figure;
mod map_words;
#[cfg(not(target_family = "wasm"))]
mod page;
mod rays;
mod scale;
mod steps;
mod strip_figure;

pub use bar_figure::{Bar, BarArrangement, BarFigure, BarPanel, BarSeries};
pub use chainage::ChainageUnit;
pub use color::{OKABE_ITO, Rgb};
#[cfg(not(target_family = "wasm"))]
pub use drawing::{DEFAULT_PNG_SCALE, Picture, collisions};
pub use error::PlotError;
pub use line_figure::{Area, Arrangement, LineFigure, LinePanel, LineStyle, Mark, Series};
pub use map_figure::{BranchLine, MapFigure, MapPanel, Observation, RidgeMark};
pub use map_words::MapWords;
#[cfg(not(target_family = "wasm"))]
pub use page::{html_of_stages, plotly_js};
pub use rays::constant_frequency_rays;
pub use scale::Scale;
pub use strip_figure::{Strip, StripClass, StripFigure, StripPanel, StripRow};
