//! The usual traffic of a line, which stands in until that of the line itself is given.

use riffel::forecast::band_lines;
use riffel_keys::{CaseError, Message, fixed, say, shown_speeds, significant};

use super::wheel_on_case::window;
use super::{Line, Traffic, TrafficFile, Vehicle, WHEEL_OF_THE_CASE, bands_of};
use crate::Case;
use crate::parts::window::Window;

/// A kind of line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// Passenger trains on a main line.
    MainLine,
    /// Goods trains of up to 25 t on an axle.
    Freight,
    /// Goods trains of more.
    HeavyHaul,
    /// A metro.
    Metro,
    /// A tramway.
    Tram,
    /// A curve, whatever runs through it.
    Curve,
}

/// The speeds of a line and how many axles run on it. Their load is that of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UsualTraffic {
    /// What the line is.
    pub line: LineKind,
    /// Slowest and fastest train \[m/s\]; all between are as common.
    pub speeds: [f64; 2],
    /// Axles a day, each a passage of one wheel over each rail.
    pub passages_per_day: f64,
}

impl LineKind {
    /// Its name for a program.
    pub fn name(self) -> &'static str {
        match self {
            Self::MainLine => "main-line",
            Self::Freight => "freight",
            Self::HeavyHaul => "heavy-haul",
            Self::Metro => "metro",
            Self::Tram => "tram",
            Self::Curve => "curve",
        }
    }

    /// Its name in a sentence: "the usual traffic of a metro".
    pub fn usual_traffic(self) -> Message {
        match self {
            Self::MainLine => say!(traffic_of_main_line),
            Self::Freight => say!(traffic_of_freight_line),
            Self::HeavyHaul => say!(traffic_of_heavy_haul),
            Self::Metro => say!(traffic_of_metro),
            Self::Tram => say!(traffic_of_tram),
            Self::Curve => say!(traffic_of_curve),
        }
    }

    /// What a case speaks of: its curve, its vehicle, or else its wheel and load.
    fn of(case: &Case) -> Self {
        /// Wheels of trams are some 600 mm across when new, of metros 700 mm and more \[m\].
        const LARGEST_TRAM_WHEEL: f64 = 0.34;
        /// Half of 25 t, the heaviest axle of European lines (EN 15528, class E) \[N\].
        const HEAVIEST_FREIGHT: f64 = 123e3;
        /// Half of 18 t: passenger coaches and multiple units are lighter \[N\].
        const HEAVIEST_COACH: f64 = 88e3;
        let file = &case.file;
        // A wheel that slides across the rail stands in a curve.
        if case.is_in_curve() || case.steady.creepages.lateral != 0.0 {
            return Self::Curve;
        }
        let load = case.steady.normal_force;
        let wheelset = file.wheelset.as_ref().and_then(|it| it.preset.as_deref());
        match file.vehicle.as_deref().or(wheelset).unwrap_or_default() {
            vehicle if vehicle.starts_with("metro") => Self::Metro,
            "tram" => Self::Tram,
            vehicle if vehicle.starts_with("freight") && load <= HEAVIEST_FREIGHT => Self::Freight,
            // A locomotive is heavy on any line.
            "locomotive" | "electric-locomotive" => Self::MainLine,
            _ if load > HEAVIEST_FREIGHT => Self::HeavyHaul,
            _ if load > HEAVIEST_COACH => Self::Freight,
            _ if file.wheel.rolling_radius.si() <= LARGEST_TRAM_WHEEL => Self::Tram,
            _ => Self::MainLine,
        }
    }
}

impl UsualTraffic {
    /// Chosen: what such lines run, in whole numbers. In a curve all trains run within a tenth of its speed, or of the middle of the
    /// map where the case does not say it.
    pub fn of(case: &Case) -> Self {
        let line = LineKind::of(case);
        let (km_per_h, passages_per_day) = match line {
            LineKind::MainLine => ([80.0, 140.0], 6000.0),
            LineKind::Freight => ([60.0, 100.0], 3000.0),
            LineKind::HeavyHaul => ([40.0, 70.0], 5000.0),
            LineKind::Metro => ([40.0, 70.0], 6000.0),
            LineKind::Tram => ([20.0, 50.0], 2400.0),
            LineKind::Curve => {
                let curve = case.file.curve.as_ref();
                let middle = case.speed.min().midpoint(case.speed.max());
                return Self::in_curve(curve.map_or(middle, |curve| curve.speed.si()));
            }
        };
        Self { line, speeds: km_per_h.map(|speed| speed / 3.6), passages_per_day }
    }

    /// That of a curve at which a vehicle is balanced at a speed \[m/s\].
    pub fn in_curve(speed: f64) -> Self {
        Self { line: LineKind::Curve, speeds: [0.9 * speed, 1.1 * speed], passages_per_day: 6000.0 }
    }

    /// The wheel of the case at these speeds.
    ///
    /// # Errors
    /// [`CaseError`] for speeds that are none.
    pub fn traffic(&self) -> Result<Traffic, CaseError> {
        let vehicle = Vehicle::named(WHEEL_OF_THE_CASE).at_even_speeds(self.speeds);
        let file = TrafficFile {
            title: None,
            line: Line { passages_per_day: Some(self.passages_per_day), ..Line::default() },
            vehicle: vec![vehicle],
        };
        Traffic::of_keys("the usual traffic", &file)
    }

    /// The case over the lines of its bands and these speeds, wearing as was measured: what growth under the traffic is told from.
    ///
    /// # Errors
    /// Errors of [`Traffic::on`].
    pub fn case_under(&self, case: &Case) -> Result<Case, CaseError> {
        let traffic = self.traffic()?;
        let case = traffic.wearing_as_measured(case)?;
        let window = window(&case, &band_lines(&bands_of(&case)), &traffic.speeds()[0]);
        case.rebuilt(case.text_with(&[&window])?, Window::Traffic)
    }

    /// What it is: "the usual traffic of a metro (40–70 km/h, 6000 axles a day)".
    pub fn in_words(&self) -> Message {
        traffic_at_speeds(self.line.usual_traffic(), self.speeds, Some(self.passages_per_day))
    }
}

/// A traffic with its slowest and fastest trains \[m/s\], and its axles a day where they are known.
pub fn traffic_at_speeds(traffic: Message, speeds: [f64; 2], per_day: Option<f64>) -> Message {
    let speeds = shown_speeds(speeds);
    match per_day {
        Some(per_day) => say!(
            traffic_at_speeds_a_day,
            traffic,
            speeds,
            axles = match per_day < 10.0 {
                true => significant(per_day, 2),
                false => fixed(per_day, 0),
            }
        ),
        None => say!(traffic_at_speeds, traffic, speeds),
    }
}
