//! A vehicle over the radius of the curve.

use riffel_curving::{Curve, RunningGear, VehicleInCurve};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};
use serde::Serialize;

use super::equilibrium::{Contact, Creep, Equilibrium, Forces, Wheel, Wheelset};
use crate::{Rows, Table};

/// Radii that are computed.
const RADII: usize = 81;
/// Tightest and widest of them over that of the case.
const REACH: [f64; 2] = [0.2, 20.0];

/// The vehicle of a case in curves of other radii, each run through at the speed that has the lateral
/// acceleration of the case.
#[derive(Serialize)]
#[serde(transparent)]
pub(super) struct OverRadius {
    points: Vec<AtRadius>,
    #[serde(skip)]
    radius: f64,
    #[serde(skip)]
    running_gear: RunningGear,
    /// Whether the radii are listed, not a range.
    #[serde(skip)]
    listed: bool,
}

/// The equilibrium at a radius; null where none is found.
#[derive(Serialize)]
struct AtRadius {
    radius_m: f64,
    speed_m_per_s: f64,
    equilibrium: Option<Equilibrium>,
}

/// A contact at a radius.
struct Row<'a> {
    at: &'a AtRadius,
    wheelset: &'a Wheelset,
    wheel: &'a Wheel,
    /// Of the wheel, from one on.
    contact: usize,
    creep: &'a Creep,
    forces: &'a Forces,
}

impl OverRadius {
    /// At radii \[m\]; by default from a fifth to twenty times that of the case, to its side.
    pub(super) fn new(vehicle: &VehicleInCurve, radii: Option<&[f64]>) -> Self {
        let radius = vehicle.curve.radius;
        let [tightest, widest] = REACH;
        let usual = || -> Vec<f64> {
            let place = |index: usize| index as f64 / (RADII - 1) as f64;
            (0..RADII).map(|index| radius * tightest * (widest / tightest).powf(place(index))).collect()
        };
        let listed = radii.is_some();
        let radii = radii.map_or_else(usual, <[f64]>::to_vec);
        let points = radii.into_iter().map(|of_curve| {
            let curve = Curve {
                radius: of_curve,
                speed: (of_curve / radius).abs().sqrt() * vehicle.curve.speed,
                ..vehicle.curve
            };
            let moved = VehicleInCurve { curve, ..vehicle.clone() };
            let state = moved.equilibrium().ok();
            AtRadius {
                radius_m: curve.radius,
                speed_m_per_s: curve.speed,
                equilibrium: state.map(|state| Equilibrium::new(&state, curve.speed)),
            }
        });
        Self { radius: radius.abs(), running_gear: vehicle.running_gear, listed, points: points.collect() }
    }

    fn rows(&self) -> Vec<Row<'_>> {
        let rows = self.points.iter().flat_map(|at| {
            let found = at.equilibrium.iter();
            found.flat_map(move |found| {
                found.wheels.iter().flat_map(move |wheel| {
                    let contacts = wheel.contacts().enumerate();
                    contacts.map(move |(index, (creep, forces))| Row {
                        at,
                        wheelset: &found.wheelsets[wheel.wheelset - 1],
                        wheel,
                        contact: index + 1,
                        creep,
                        forces,
                    })
                })
            })
        });
        rows.collect()
    }

    /// One row for each radius and contact; a wheel on two points has two. Rows without an equilibrium are left out.
    pub(super) fn table(&self) -> Table {
        let rows = self.rows();
        Table {
            name: "curve",
            columns: vec![
                rows.exact("radius_m", |row| row.at.radius_m),
                rows.exact("speed_m_per_s", |row| row.at.speed_m_per_s),
                rows.names("wheelset", |row| row.wheel.wheelset),
                rows.names("rail", |row| row.wheel.rail),
                rows.names("contact", |row| row.contact),
                rows.exact("lateral_shift_m", |row| row.wheelset.lateral_shift_m),
                rows.exact("yaw_rad", |row| row.wheelset.yaw_rad),
                rows.exact("angle_of_attack_rad", |row| row.wheelset.angle_of_attack_rad),
                rows.exact("longitudinal_creepage", |row| row.creep.longitudinal_creepage),
                rows.exact("lateral_creepage", |row| row.creep.lateral_creepage),
                rows.exact("spin_1_per_m", |row| row.creep.spin_1_per_m),
                rows.exact("contact_angle_rad", |row| row.creep.contact_angle_rad),
                rows.exact("rolling_radius_m", |row| row.creep.rolling_radius_m),
                rows.exact("normal_force_n", |row| row.forces.normal_force_n),
                rows.exact("longitudinal_force_n", |row| row.forces.longitudinal_force_n),
                rows.exact("lateral_force_n", |row| row.forces.lateral_force_n),
                rows.exact("track_lateral_force_n", |row| row.forces.track_lateral_force_n),
                rows.exact("tractive_ratio", |row| row.forces.tractive_ratio),
                rows.exact("t_gamma_n", |row| row.forces.t_gamma_n),
            ],
        }
    }

    /// Shift, angle of attack, share of friction and wear number over the radius: lines, marks for listed radii.
    pub(super) fn figure(&self) -> LineFigure {
        let of_case = match self.listed {
            true => String::new(),
            false => format!("; the line stands at the case, R = {:.0} m", self.radius),
        };
        let leads = match self.running_gear.wheelsets() {
            1 => "",
            _ => "Wheelset 1 leads. ",
        };
        LineFigure::new(
            match self.running_gear {
                RunningGear::Wheelset(_) => "Wheelset in curves",
                RunningGear::Bogie(_) => "Bogie in curves",
                RunningGear::Vehicle { .. } => "Vehicle in curves",
            }
            .to_owned(),
            format!(
                "{leads}Each radius at the lateral acceleration of the case, the speed in proportion to \
                 √R{of_case}."
            ),
            [
                self.of_wheelsets("lateral shift y [mm]", |wheelset| 1e3 * wheelset.lateral_shift_m),
                self.of_wheelsets("angle of attack [mrad]", |wheelset| 1e3 * wheelset.angle_of_attack_rad),
                self.of_wheels("|Q|/μP [-]", share_of_friction),
                self.of_wheels("wear number Tγ [N]", Wheel::whole_t_gamma),
            ],
        )
        .arranged(Arrangement::Stacked)
    }

    fn of_wheelsets(&self, label: &str, value: impl Fn(&Wheelset) -> f64) -> LinePanel {
        let series = (0..self.running_gear.wheelsets()).map(|index| {
            let style = [LineStyle::Solid, LineStyle::Dashed][index % 2];
            self.series(&format!("wheelset {}", index + 1), style, |found| value(&found.wheelsets[index]))
        });
        self.panel(label, series.collect())
    }

    fn of_wheels(&self, label: &str, value: impl Fn(&Wheel) -> f64) -> LinePanel {
        let series = (0..2 * self.running_gear.wheelsets()).map(|index| {
            let rail = if index % 2 == 0 { "left" } else { "right" };
            let style = [LineStyle::Solid, LineStyle::Dashed][index / 2 % 2];
            let label = format!("wheelset {}, {rail}", index / 2 + 1);
            self.series(&label, style, |found| value(&found.wheels[index]))
        });
        self.panel(label, series.collect())
    }

    fn series(&self, label: &str, style: LineStyle, value: impl Fn(&Equilibrium) -> f64) -> Series {
        let at = |point: &AtRadius| {
            let found = point.equilibrium.as_ref();
            (point.radius_m.abs(), found.map_or(f64::NAN, &value))
        };
        let (x, y) = self.points.iter().map(at).unzip();
        let style = match self.listed {
            true => LineStyle::Markers,
            false => style,
        };
        Series::new(label, x, y).styled(style)
    }

    fn panel(&self, label: &str, series: Vec<Series>) -> LinePanel {
        LinePanel {
            marks: match self.listed {
                true => Vec::new(),
                false => vec![Mark { x: self.radius, label: String::new() }],
            },
            ..LinePanel::new("curve radius |R| [m]", label, series).scaled(Scale::Log, Scale::Linear)
        }
    }
}

/// Σ|Q| over Σ μP of the contacts of a wheel, continuous where one takes the load of the other.
fn share_of_friction(wheel: &Wheel) -> f64 {
    let first = &wheel.forces;
    match &wheel.second_contact {
        None => first.tractive_ratio,
        Some(Contact { forces: second, .. }) => {
            (first.tractive_ratio * first.normal_force_n + second.tractive_ratio * second.normal_force_n)
                / (first.normal_force_n + second.normal_force_n)
        }
    }
}
