//! A wheelset, a bogie or a vehicle in its curve: shifts, angles of attack, creepages, forces and wear number of each wheel.

mod equilibrium;
mod over_radius;
mod remarks;
mod tables;

use std::cell::OnceCell;

use equilibrium::Equilibrium;
use over_radius::OverRadius;
use riffel_case::CurvingCase;
use riffel_curving::{ContinuationStep, VehicleInCurve, VehicleState, WheelsetState};
use riffel_keys::quantity::Length;
use riffel_keys::{CaseError, Message, Value, fixed, number, say};
use riffel_plot::LineFigure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::answer::titled;
use crate::question::{AsWritten, CaseSource, Client, Question};
use crate::side::side;
use crate::{Answer, AnswerError, Result, Table};

/// A bogie in a curve: creepages, forces and wear number of each wheel, and over the radius.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct CurveQuestion {
    #[serde(flatten)]
    case: CaseSource<CurvingCase>,
    /// Radii of the picture and its table, separated by commas, above zero to the right, each at the lateral acceleration of
    /// the case [default: from a fifth to twenty times that of the case].
    #[schemars(extend("value_name" = "LIST", "separator" = ","))]
    radius: Vec<AsWritten<Length>>,
}

impl CurveQuestion {
    /// The radii that are listed \[m\]; `None` if none are.
    fn radii(&self, case: &CurvingCase) -> Result<Option<Vec<f64>>> {
        let wrong = |value: String, rule: String| AnswerError::argument("--radius", value, rule);
        let listed: Vec<f64> = self.radius.iter().map(AsWritten::si).collect();
        let bare = self.radius.iter().find(|radius| radius.is_bare());
        let with_unit = self.radius.iter().find(|radius| !radius.is_bare());
        if let (Some(bare), Some(_)) = (bare, with_unit) {
            let rule = "a list whose items all have a unit or none; commas part the items, so that 3,800 m are two";
            let value = format!("{} without a unit beside others with one", bare.si());
            return Err(wrong(value, rule.to_owned()));
        }
        if let Some((radius, rule)) = case.radius_that_no_curve_has(&listed) {
            return Err(wrong(format!("{radius} m"), rule));
        }
        Ok((!listed.is_empty()).then_some(listed))
    }
}

impl Question for CurveQuestion {
    const NAME: &'static str = "curve";
    const EXAMPLE: &'static str = "\
        Examples:\n  riffel curve case.toml --set \"curve.radius=300 m\"\n  riffel curve case.toml --radius \"300 m,600 m,1200 m\" --json";

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read(client)?;
        Ok(Box::new(CurveAnswer::new(&case, self.radii(&case)?.as_deref())?))
    }
}

/// The equilibrium of the vehicle of a case: serialised, what `riffel curve --json` prints.
#[derive(Serialize)]
pub struct CurveAnswer {
    /// The one that straight track leads to.
    #[serde(flatten)]
    equilibrium: Equilibrium,
    continuation: Vec<Step>,
    /// Further ones that were found.
    other_equilibria: Vec<Other>,
    #[serde(rename = "remarks")]
    own_remarks: Vec<Message>,
    /// At listed radii.
    #[serde(skip_serializing_if = "Option::is_none")]
    over_radius: Option<OverRadius>,
    /// From a fifth to twenty times that of the case, for files where none are listed.
    #[serde(skip)]
    over_usual_radii: OnceCell<OverRadius>,
    #[serde(skip)]
    vehicle: VehicleInCurve,
    #[serde(skip)]
    title: Option<String>,
    /// Of the case and of the equilibrium.
    #[serde(skip)]
    remarks: Vec<Message>,
}

/// A step of the way from straight track.
#[derive(Serialize)]
struct Step {
    fraction: f64,
    residual: f64,
    iterations: usize,
}

/// Where the wheelsets stand in another equilibrium.
#[derive(Serialize)]
struct Other {
    lateral_shift_m: Vec<f64>,
    yaw_rad: Vec<f64>,
    residual: f64,
}

impl Other {
    fn new(state: &VehicleState) -> Self {
        let of = |value: fn(&WheelsetState) -> f64| state.wheelsets.iter().map(value).collect();
        Self {
            lateral_shift_m: of(|wheelset| wheelset.lateral_shift),
            yaw_rad: of(|wheelset| wheelset.yaw),
            residual: state.residual,
        }
    }
}

impl CurveAnswer {
    /// The vehicle of a case in its curve, and in curves of listed radii \[m\], none of them zero, each at the lateral
    /// acceleration of the case.
    ///
    /// # Errors
    /// [`CaseError`] for a key that is missing or has a value that is not allowed, and where no equilibrium is found.
    pub fn new(case: &CurvingCase, radii: Option<&[f64]>) -> Result<Self, CaseError> {
        let mut answer = Self::of_vehicle(case, case.vehicle_in_curve()?)?;
        answer.over_radius = radii.map(|radii| OverRadius::new(&answer.vehicle, Some(radii)));
        Ok(answer)
    }

    /// Answer for the vehicle of the case, which takes most of the time, in its own curve alone.
    ///
    /// # Errors
    /// [`CaseError`] where no equilibrium is found.
    pub fn of_vehicle(case: &CurvingCase, vehicle: VehicleInCurve) -> Result<Self, CaseError> {
        let mut states = case.equilibria(&vehicle)?.into_iter();
        let state = states.next().expect("at least one equilibrium");
        let mut own_remarks = case.remarks_of_profiles()?;
        own_remarks.extend(remarks::of(case, &vehicle, &state));
        let step = |step: &ContinuationStep| Step {
            fraction: step.fraction,
            residual: step.residual,
            iterations: step.iterations,
        };
        Ok(Self {
            equilibrium: Equilibrium::new(&state, vehicle.curve.speed),
            continuation: state.continuation.iter().map(step).collect(),
            other_equilibria: states.map(|other| Other::new(&other)).collect(),
            remarks: case.remarks.iter().chain(&own_remarks).cloned().collect(),
            own_remarks,
            over_radius: None,
            over_usual_radii: OnceCell::new(),
            vehicle,
            title: case.file.title.clone(),
        })
    }

    fn over_radius(&self) -> &OverRadius {
        let usual = || self.over_usual_radii.get_or_init(|| OverRadius::new(&self.vehicle, None));
        self.over_radius.as_ref().unwrap_or_else(usual)
    }

    /// How the equilibrium was found.
    fn residual(&self) -> Message {
        let residual = number(format_args!("{:.0e}", self.equilibrium.residual));
        match self.continuation.len() {
            0 => say!(residual_without_straight_track, residual),
            steps => say!(residual_from_straight_track, residual, steps = number(steps)),
        }
    }

    /// The wheels that stand on two points.
    fn on_two_points(&self) -> impl Iterator<Item = Message> {
        self.equilibrium.wheels.iter().filter_map(|wheel| {
            let [first, second] = [&wheel.forces, &wheel.second_contact.as_ref()?.forces];
            let share = 100.0 * second.normal_force_n / (first.normal_force_n + second.normal_force_n);
            Some(say!(
                wheelset_on_two_points,
                wheelset = number(wheel.wheelset),
                rail = side(wheel.rail),
                share = fixed(share, 0)
            ))
        })
    }

    /// Equilibria beside the one that straight track leads to.
    fn others(&self) -> Message {
        let others = self.other_equilibria.iter().filter_map(|other| {
            let shifts = other.lateral_shift_m.iter().map(|shift| fixed(1e3 * shift, 3));
            let shifts = shifts.reduce(|one, other| say!(both, one, other).into())?;
            Some(say!(shifts_in_millimetres, shifts))
        });
        let shifts = Message::one_after_other(others);
        shifts.map_or_else(|| say!(no_other_equilibrium), |shifts| say!(other_equilibria, shifts = Value::from(shifts)))
    }
}

impl Answer for CurveAnswer {
    fn name(&self) -> &'static str {
        "curve"
    }

    fn introduction(&self) -> Vec<Message> {
        let usual = match self.equilibrium.wheelsets.len() {
            1 => say!(wheelset_in_a_curve),
            2 => say!(bogie_in_a_curve),
            _ => say!(vehicle_in_a_curve),
        };
        vec![
            titled(self.title.as_ref(), usual),
            say!(
                acceleration_and_power,
                acceleration = fixed(self.equilibrium.uncompensated_lateral_acceleration_m_s2, 2),
                power = fixed(self.equilibrium.frictional_power_w, 0)
            ),
        ]
    }

    fn tables(&self) -> Vec<Table> {
        let Equilibrium { wheelsets, wheels, .. } = &self.equilibrium;
        vec![tables::wheelsets(wheelsets), tables::wheels(wheels), self.over_radius().table()]
    }

    fn sentences(&self) -> Vec<Message> {
        [self.residual()].into_iter().chain(self.on_two_points()).chain([self.others()]).collect()
    }

    fn figure(&self) -> LineFigure {
        self.over_radius().figure()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
