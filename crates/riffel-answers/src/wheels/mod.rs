//! The wheels of a vehicle in its curve side by side: which of them grows corrugation, and where.

mod figure;
mod table;

use riffel::forecast::band_lines;
use riffel_case::file::{ContactOfWheel, CurveRail};
use riffel_case::traffic::{UsualTraffic, bands_of};
use riffel_case::{Case, Variant, WheelOfCurve, WheelsOfCurve, ask, wheels_of_curve};
use riffel_curving::{Curve, WheelState};
use riffel_keys::{CaseError, Message, fixed, say};
use riffel_plot::LineFigure;
use serde::Serialize;

use crate::answer::{inputs, titled};
use crate::map::RidgeMap;
use crate::ridge::BranchDocument;
use crate::{Answer, AnswerError, Highest, LineGrowth, Result, ResultFile, Table, WearLimitDocument};

/// Contact angles that differ by no more are one \[rad\]: case files hold them rounded.
const SAME_ANGLE: f64 = 1e-6;

/// Growth under every wheel of a vehicle in its curve.
#[derive(Serialize)]
pub struct WheelsAnswer {
    riffel_version: &'static str,
    /// Case with the wheel that it has itself.
    #[serde(rename = "inputs", serialize_with = "inputs")]
    case: Case,
    /// Above zero to the right.
    pub radius_m: f64,
    /// That of the curve, at which the vehicle is balanced.
    pub speed_m_per_s: f64,
    /// Slowest and fastest trains of the usual traffic of the curve, over which growth is the mean.
    pub speeds_m_per_s: [f64; 2],
    /// Lines of the bands of the map, rising.
    pub wavelength_m: Vec<f64>,
    /// Wheelset by wheelset from the front, the low rail first; of a wheel that stands on two points both, the tread first.
    pub wheels: Vec<WheelAnswer>,
    /// Under which traffic growth is told.
    #[serde(skip)]
    under: Message,
    #[serde(skip)]
    remarks: Vec<Message>,
}

/// One wheel, and what the loop says of it.
#[derive(Serialize)]
pub struct WheelAnswer {
    /// Name of the wheel, "wheelset 1, low rail".
    #[serde(skip)]
    pub name: String,
    /// 1 leads.
    pub wheelset: usize,
    /// Low or high.
    pub rail: CurveRail,
    /// `left` or `right`.
    pub side: &'static str,
    /// Tread, or the flange of a wheel that stands on two points.
    pub contact: ContactOfWheel,
    /// That of the equilibrium, as all up to the share; what the case gives itself is named in `remarks`.
    pub longitudinal_creepage: f64,
    /// In the plane of contact.
    pub lateral_creepage: f64,
    /// About its normal.
    pub spin_1_per_m: f64,
    /// On this contact.
    pub normal_force_n: f64,
    /// From the track.
    pub contact_angle_rad: f64,
    /// |Q|/μP.
    pub tractive_ratio: f64,
    /// Of the normal forces of the wheel, on its other contact, which the loop leaves out.
    pub share_of_second_contact: f64,
    /// Why the loop has no mean state there; null where it has.
    pub not_in_loop: Option<Message>,
    /// At the wavelengths of the answer, in the mean over the traffic; null where the wheel is not in the loop.
    pub growth_rate_per_passage: Option<Vec<f64>>,
    /// The fastest wavelength; null where nothing grows.
    pub highest: Option<Highest>,
    /// For that growth; left out where the wheel is not in the loop.
    #[serde(flatten)]
    pub wear_limit: Option<WearLimitDocument>,
    /// Branches of its map, the strongest first.
    pub branches: Vec<BranchDocument>,
    /// At which it oscillates without any profile at the speed of the curve; null where it does not.
    pub unstable_frequency_hz: Option<f64>,
    /// What the reader should know, of stability at the speed of the curve.
    pub remarks: Vec<Message>,
    /// Its place in the loop, where it has one.
    #[serde(skip)]
    pub in_loop: Option<WheelInLoop>,
}

/// A wheel in the loop.
pub struct WheelInLoop {
    /// The case with the wheel under study.
    pub case: Case,
    /// Its map over wavelength and speed.
    pub map: RidgeMap,
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
    pub fn new(case: &Case, progress: impl Fn(usize) + Sync) -> Result<Self> {
        let found = wheels_of_curve(&case.sharing_parts())?;
        let WheelsOfCurve { curve, wheels } = found.ok_or(AnswerError::NoCurve)?;
        let ends = [case.wavelength.min(), case.wavelength.max()];
        case.check_points(ends, [curve.speed; 2])?;
        case.check_window()?;
        // The curve may stand in a file of its own.
        let traffic = UsualTraffic::in_curve(curve.speed);
        let wheels = wheels.into_iter();
        let wheels: Vec<WheelAnswer> =
            wheels.map(|wheel| WheelAnswer::new(wheel, &curve, &traffic, &progress)).collect();
        Ok(Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            case: case.clone(),
            radius_m: curve.radius,
            speed_m_per_s: curve.speed,
            speeds_m_per_s: traffic.speeds,
            wavelength_m: band_lines(&bands_of(case)),
            under: say!(compared_under, traffic = traffic.in_words()),
            remarks: remarks(&wheels),
            wheels,
        })
    }

    /// Rows of all maps of a case whose vehicle has no more than two bogies.
    pub fn rows(case: &Case) -> usize {
        /// Of a vehicle with a body.
        const WHEELS: usize = 8;
        WHEELS * case.speed.points()
    }

    /// The wheels in the loop that carry at least half of the normal forces of their wheel.
    pub fn carrying(&self) -> impl Iterator<Item = (&WheelAnswer, &WheelInLoop)> {
        let wheels = self.wheels.iter();
        let in_loop = wheels.filter_map(|wheel| Some((wheel, wheel.in_loop.as_ref()?)));
        in_loop.filter(|(wheel, _)| wheel.share_of_second_contact <= 0.5)
    }

    /// The wheel under which corrugation grows fastest under the traffic of the curve, on a contact that carries at least half of its
    /// normal forces; `None` if nothing grows.
    pub fn fastest(&self) -> Option<(&WheelAnswer, Highest)> {
        let growing = self.carrying().filter_map(|(wheel, _)| Some((wheel, wheel.highest?)));
        growing.max_by(|(_, one), (_, other)| one.rate.total_cmp(&other.rate))
    }
}

/// What there is to say of wheels in the loop, each sentence once with its wheels, in the order of the first.
fn remarks(wheels: &[WheelAnswer]) -> Vec<Message> {
    let mut said: Vec<(&Message, Vec<&str>)> = Vec::new();
    for wheel in wheels {
        for remark in &wheel.remarks {
            match said.iter_mut().find(|(known, _)| *known == remark) {
                Some((_, names)) => names.push(&wheel.name),
                None => said.push((remark, vec![&wheel.name])),
            }
        }
    }
    let all = wheels.iter().filter(|wheel| wheel.in_loop.is_some()).count();
    let said = said.into_iter().map(|(remark, names)| match names.len() == all {
        true => remark.clone(),
        false => remark.clone().about(names.join("; ")),
    });
    said.collect()
}

impl WheelAnswer {
    fn new(wheel: WheelOfCurve, curve: &Curve, traffic: &UsualTraffic, progress: &(impl Fn(usize) + Sync)) -> Self {
        let name = wheel.name();
        let WheelOfCurve { state, rail, contact, case } = wheel;
        let state = case.as_ref().map_or(state, |case| in_loop(state, case));
        let mut answer = Self {
            name,
            wheelset: state.wheelset,
            rail,
            side: state.rail.name(),
            contact,
            longitudinal_creepage: state.creepages.longitudinal,
            lateral_creepage: state.creepages.lateral,
            spin_1_per_m: state.creepages.spin,
            normal_force_n: state.normal_force,
            contact_angle_rad: state.contact_angle,
            tractive_ratio: state.tractive_ratio,
            share_of_second_contact: state.share_of_second_contact(),
            not_in_loop: None,
            growth_rate_per_passage: None,
            highest: None,
            wear_limit: None,
            branches: Vec::new(),
            unstable_frequency_hz: None,
            remarks: Vec::new(),
            in_loop: None,
        };
        if let Err(error) = case.and_then(|case| answer.grow(case, curve.speed, traffic, progress)) {
            answer.not_in_loop = Some(error.message());
        }
        answer
    }

    /// Growth under a traffic, of the case with the wheel under study.
    fn grow(
        &mut self,
        case: Case,
        speed: f64,
        traffic: &UsualTraffic,
        progress: &(impl Fn(usize) + Sync),
    ) -> Result<(), CaseError> {
        let under = LineGrowth::under(&case, &traffic.traffic()?, &Variant::none(""))?;
        let stability = ask::stability(&case, speed);
        let map = RidgeMap::new(&case, progress);
        self.highest = under.fastest.map(|fastest| Highest {
            wavelength: fastest.wavelength_m,
            frequency: speed / fastest.wavelength_m,
            rate: fastest.growth_rate_per_passage,
            at_edge: fastest.at_edge,
        });
        let rate = self.highest.map(|highest| highest.rate);
        self.wear_limit = Some(WearLimitDocument::new(&case, rate));
        self.growth_rate_per_passage = Some(under.curve.iter().map(|[_, rate]| *rate).collect());
        self.branches = map.branches.clone();
        self.unstable_frequency_hz = stability.and_then(|stability| stability.frequency);
        self.remarks = ask::remarks_at(&case, speed);
        self.in_loop = Some(WheelInLoop { case, map });
        Ok(())
    }
}

impl WheelInLoop {
    /// Growth rate per passage on the grid of the map, by speed and wavelength.
    pub fn rates_on_the_grid(&self) -> impl Iterator<Item = f64> + '_ {
        let map = &self.map.map;
        let rate = map.growth_rate_per_dissipation();
        map.rows().flat_map(|(_, row)| row).map(move |value| rate * value.re)
    }
}

impl Answer for WheelsAnswer {
    fn name(&self) -> &'static str {
        "growth"
    }

    fn folder_name(&self) -> Option<&'static str> {
        Some("wheels")
    }

    fn introduction(&self) -> Vec<Message> {
        vec![
            titled(self.case.file.title.as_ref(), say!(wheels_of_a_curve)),
            say!(
                all_wheels_in_the_curve,
                radius = fixed(self.radius_m.abs(), 0),
                speed = fixed(3.6 * self.speed_m_per_s, 0)
            ),
        ]
    }

    fn tables(&self) -> Vec<Table> {
        vec![table::wheels(self), table::growth(self)]
    }

    fn sentences(&self) -> Vec<Message> {
        let under = self.under.clone();
        let fastest = match self.fastest() {
            None => say!(under_no_wheel, under),
            Some((wheel, highest)) => say!(
                fastest_at_wheel,
                under,
                wheel = wheel.name.as_str(),
                rate = format!("{:.2e}", highest.rate),
                wavelength = fixed(1e3 * highest.wavelength, 0),
                frequency = fixed(highest.frequency, 0)
            ),
        };
        let wheels = self.wheels.iter();
        let left_out = wheels.filter_map(|wheel| {
            let reason = wheel.not_in_loop.clone()?;
            Some(say!(wheel_not_in_loop, wheel = wheel.name.as_str(), reason))
        });
        [fastest].into_iter().chain(left_out).collect()
    }

    fn figure(&self) -> LineFigure {
        figure::curves(self)
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let maps = figure::maps(self).map(|maps| ResultFile::Maps("map", maps));
        let own = [ResultFile::Lines(self.name(), self.figure())];
        let tables = self.tables().into_iter().map(ResultFile::Table);
        let files = maps.into_iter().chain(own).chain(tables);
        files.chain([ResultFile::Grid("map", table::grid(self))]).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
