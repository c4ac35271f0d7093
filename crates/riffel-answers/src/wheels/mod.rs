//! The wheels of a vehicle in its curve side by side: which of them grows corrugation, and where.

mod document;
mod figure;
mod table;

use std::io::{self, Write};
use std::path::Path;

use riffel::curving::{Curve, WheelState};
use riffel::forecast::band_lines;
use riffel_case::file::{ContactOfWheel, CurveRail};
use riffel_case::traffic::{UsualTraffic, bands_of};
use riffel_case::{Case, Variant, WheelOfCurve, WheelsOfCurve};
use riffel_keys::{CaseError, Message, say};
use riffel_plot::{LineFigure, MapFigure};

pub use document::WheelsDocument;

use crate::map::MapAnswer;
use crate::{AnswerError, Highest, LineGrowth};

/// Contact angles that differ by no more are one \[rad\]: case files hold them rounded.
const SAME_ANGLE: f64 = 1e-6;

/// Growth under every wheel of a vehicle in its curve.
pub struct WheelsAnswer {
    /// The curve.
    pub curve: Curve,
    /// The usual traffic of the curve: growth is the mean over its speeds.
    pub traffic: UsualTraffic,
    /// Wavelengths \[m\] of the bands of the map, rising.
    pub wavelengths: Vec<f64>,
    /// Wheelset by wheelset from the front, the low rail first; of a wheel that stands on two points both, the tread first.
    pub wheels: Vec<WheelAnswer>,
}

/// One wheel, and what the loop says of it.
pub struct WheelAnswer {
    /// As in "wheelset 1, low rail".
    pub name: String,
    /// Its mean state in the equilibrium of the vehicle, told from this contact.
    pub state: WheelState,
    /// Low or high.
    pub rail: CurveRail,
    /// Tread, or the flange of a wheel that stands on two points.
    pub contact: ContactOfWheel,
    /// Growth; where the loop has no mean state there, the sentence that says why.
    pub growth: Result<WheelGrowth, Message>,
}

/// Growth under one wheel.
pub struct WheelGrowth {
    /// The case with the wheel under study.
    pub case: Case,
    /// Its map over wavelength and speed.
    pub map: MapAnswer,
    /// Growth rates per passage \[-\] at the wavelengths of the answer, in the mean over the traffic.
    pub rates: Vec<f64>,
    /// The fastest wavelength; none where nothing grows.
    pub highest: Option<Highest>,
    /// What the reader should know, of stability at the speed of the curve.
    pub remarks: Vec<Message>,
    /// Frequency \[Hz\] at which the loop oscillates without any profile at the speed of the curve, if it does.
    pub unstable: Option<f64>,
}

/// A wheel as its loop has it: where that takes the patch under load, place, angle and spin are not those of the equilibrium.
fn in_loop(mut state: WheelState, case: &Case) -> WheelState {
    let contact = &case.file.contact;
    let Some(angle) = contact.contact_angle.map(|angle| angle.si()) else {
        return state;
    };
    // A lone wheel is always seen as a right one.
    if case.wheelset.is_some() && (angle - state.contact_angle).abs() > SAME_ANGLE {
        state.contact_angle = angle;
        state.tractive_ratio = case.steady.tractive_ratio();
        if let Some(creepage) = contact.creepage {
            state.creepages.spin = creepage.components().spin;
        }
    }
    state
}

impl WheelsAnswer {
    /// All wheels of the vehicle that the case takes its mean state from; `progress` is told of rows of the maps that are done,
    /// [`rows`](Self::rows) of them at most.
    ///
    /// # Errors
    /// [`AnswerError::NoCurve`] for a case without `contact.from`, [`AnswerError::Case`] for a vehicle without equilibrium and
    /// for frequencies at which the case is not known.
    pub fn new(case: &Case, progress: impl Fn(usize) + Sync) -> Result<Self, AnswerError> {
        let found = case.sharing_parts().wheels_of_curve()?;
        let WheelsOfCurve { curve, wheels } = found.ok_or(AnswerError::NoCurve)?;
        let ends = [case.wavelength.min(), case.wavelength.max()];
        case.check_points(ends, [curve.speed; 2])?;
        case.check_window()?;
        // The curve may stand in a file of its own.
        let traffic = UsualTraffic::in_curve(curve.speed);
        let wheels = wheels.into_iter().map(|wheel| {
            let name = wheel.name();
            let WheelOfCurve {
                state,
                rail,
                contact,
                case,
            } = wheel;
            let state = case.as_ref().map_or(state, |case| in_loop(state, case));
            let growth = case.and_then(|case| WheelGrowth::of(case, &curve, &traffic, &progress));
            WheelAnswer {
                name,
                state,
                rail,
                contact,
                growth: growth.map_err(|error| error.message()),
            }
        });
        Ok(Self {
            wheels: wheels.collect(),
            curve,
            traffic,
            wavelengths: band_lines(&bands_of(case)),
        })
    }

    /// Rows of all maps of a case whose vehicle has no more than two bogies.
    pub fn rows(case: &Case) -> usize {
        /// Of a vehicle with a body.
        const WHEELS: usize = 8;
        WHEELS * case.speed.points()
    }

    /// The wheels that are in the loop, with their growth.
    pub fn in_loop(&self) -> impl Iterator<Item = (&WheelAnswer, &WheelGrowth)> {
        let wheels = self.wheels.iter();
        wheels.filter_map(|wheel| Some((wheel, wheel.growth.as_ref().ok()?)))
    }

    /// Those of them that carry at least half of the normal forces of their wheel.
    pub fn carrying(&self) -> impl Iterator<Item = (&WheelAnswer, &WheelGrowth)> {
        self.in_loop()
            .filter(|(wheel, _)| wheel.state.share_of_second_contact() <= 0.5)
    }

    /// The wheel under which corrugation grows fastest under the traffic of the curve, on a contact that carries at least half of its
    /// normal forces; none where nothing grows.
    pub fn fastest(&self) -> Option<(&WheelAnswer, Highest)> {
        let wheels = self.carrying();
        let growing = wheels.filter_map(|(wheel, growth)| Some((wheel, growth.highest?)));
        growing.max_by(|(_, one), (_, other)| one.rate.total_cmp(&other.rate))
    }

    /// Under which traffic growth is told.
    pub fn under(&self) -> Message {
        say!(compared_under, traffic = self.traffic.in_words())
    }

    /// What `riffel map --wheels --json` prints.
    pub fn document<'a>(&'a self, case: &'a Case) -> WheelsDocument<'a> {
        document::document(self, case)
    }

    /// Heading and rows for the terminal.
    pub fn table(&self) -> (Vec<&'static str>, Vec<Vec<String>>) {
        table::words(self)
    }

    /// Which wheel grows most, in a sentence.
    pub fn sentence(&self) -> String {
        table::sentence(self)
    }

    /// Maps of decay rates of all wheels in one scale of colours, of one on two points that of the contact that carries most; none
    /// where no wheel is in the loop.
    pub fn map_figure(&self, case: &Case) -> Option<MapFigure> {
        figure::maps(self, case)
    }

    /// Growth over wavelength under the traffic of the curve, a line for each wheel, of one on two points that of the contact that
    /// carries most.
    pub fn curve_figure(&self, case: &Case) -> LineFigure {
        figure::curves(self, case)
    }

    /// One row for each wheel, in SI.
    ///
    /// # Errors
    /// Those of the file.
    pub fn wheels_csv(&self, file: &mut impl Write) -> io::Result<()> {
        table::wheels(self, file)
    }

    /// One row for each wavelength under the traffic of the curve, a column for each wheel in the loop.
    ///
    /// # Errors
    /// Those of the file.
    pub fn growth_csv(&self, file: &mut impl Write) -> io::Result<()> {
        table::growth(self, file)
    }

    /// Growth rates of all wheels on the grid of the map as NetCDF-3: by wheel, speed and wavelength, NaN for a wheel that is
    /// not in the loop.
    ///
    /// # Errors
    /// [`AnswerError::Grid`].
    pub fn netcdf(&self, case: &Case, path: &Path) -> Result<(), AnswerError> {
        table::grid(self, case, path)
    }
}

impl WheelGrowth {
    /// Growth under a traffic.
    fn of(
        case: Case,
        curve: &Curve,
        traffic: &UsualTraffic,
        progress: impl Fn(usize) + Sync,
    ) -> Result<Self, CaseError> {
        let speed = curve.speed;
        let under = LineGrowth::under(&case, &traffic.traffic()?, &Variant::none(""))?;
        let stability = case.stability(speed);
        Ok(Self {
            map: MapAnswer::new(&case, progress),
            highest: under.fastest.map(|fastest| Highest {
                wavelength: fastest.wavelength_m,
                frequency: speed / fastest.wavelength_m,
                rate: fastest.growth_rate_per_passage,
                at_edge: fastest.at_edge,
            }),
            remarks: case.remarks_at(speed),
            unstable: stability.and_then(|stability| stability.frequency),
            rates: under.curve.iter().map(|[_, rate]| *rate).collect(),
            case,
        })
    }

    /// Growth rate per passage on the grid of the map, by speed and wavelength.
    pub fn rates_on_the_grid(&self) -> impl Iterator<Item = f64> + '_ {
        let map = &self.map.map;
        let rate = map.growth_rate_per_dissipation();
        map.rows()
            .flat_map(|(_, row)| row)
            .map(move |value| rate * value.re)
    }
}
