//! A vehicle over the radius of the curve.

use std::io::{self, Write};

use riffel::contact::{CreepForces, Creepages};
use riffel::curving::{Curve, RunningGear, VehicleInCurve, VehicleState, WheelState};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};

use super::document::{AtRadius, Equilibrium};

/// Radii that are computed.
const RADII: usize = 81;
/// Tightest and widest of them over that of the case.
const REACH: [f64; 2] = [0.2, 20.0];

/// The vehicle of a case in curves of other radii, each run through at the speed that has the lateral
/// acceleration of the case.
pub struct OverRadius {
    radius: f64,
    running_gear: RunningGear,
    /// Whether the radii are listed, not a range.
    listed: bool,
    points: Vec<Point>,
}

struct Point {
    curve: Curve,
    /// None where no equilibrium is found.
    state: Option<VehicleState>,
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
            Point { curve, state: moved.equilibrium().ok() }
        });
        Self { radius: radius.abs(), running_gear: vehicle.running_gear, listed, points: points.collect() }
    }

    /// The equilibrium at each radius.
    pub(super) fn document(&self) -> Vec<AtRadius> {
        let points = self.points.iter();
        points
            .map(|point| AtRadius {
                radius_m: point.curve.radius,
                speed_m_per_s: point.curve.speed,
                equilibrium: point.state.as_ref().map(|state| Equilibrium::new(state, point.curve.speed)),
            })
            .collect()
    }

    /// One row for each radius and contact; a wheel on two points has two. Rows without an equilibrium are left out.
    ///
    /// # Errors
    /// Those of the file.
    pub fn csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "radius_m",
            "speed_m_per_s",
            "wheelset",
            "rail",
            "contact",
            "lateral_shift_m",
            "yaw_rad",
            "angle_of_attack_rad",
            "longitudinal_creepage",
            "lateral_creepage",
            "spin_1_per_m",
            "contact_angle_rad",
            "rolling_radius_m",
            "normal_force_n",
            "longitudinal_force_n",
            "lateral_force_n",
            "track_lateral_force_n",
            "tractive_ratio",
            "t_gamma_n",
        ])?;
        for point in &self.points {
            let Some(state) = &point.state else {
                continue;
            };
            for wheel in &state.wheels {
                let wheelset = &state.wheelsets[wheel.wheelset - 1];
                let mut row =
                    |contact: usize, creepages: Creepages, place: [f64; 2], forces: CreepForces, rest: [f64; 4]| {
                        let [normal_force, track_lateral_force, tractive_ratio, t_gamma] = rest;
                        writer.serialize((
                            (point.curve.radius, point.curve.speed, wheel.wheelset),
                            (wheel.rail.name(), contact),
                            [wheelset.lateral_shift, wheelset.yaw, wheelset.angle_of_attack],
                            [creepages.longitudinal, creepages.lateral, creepages.spin],
                            place,
                            [normal_force, forces.longitudinal, forces.lateral],
                            [track_lateral_force, tractive_ratio, t_gamma],
                        ))
                    };
                row(
                    1,
                    wheel.creepages,
                    [wheel.contact_angle, wheel.rolling_radius],
                    wheel.creep_forces,
                    [wheel.normal_force, wheel.track_lateral_force, wheel.tractive_ratio, wheel.t_gamma],
                )?;
                if let Some(second) = &wheel.second_contact {
                    row(
                        2,
                        second.creepages,
                        [second.contact_angle, second.rolling_radius],
                        second.creep_forces,
                        [second.normal_force, second.track_lateral_force, second.tractive_ratio, second.t_gamma],
                    )?;
                }
            }
        }
        writer.flush()
    }

    /// Shift, angle of attack, share of friction and wear number over the radius: lines, marks for listed radii.
    pub fn figure(&self) -> LineFigure {
        let of_case = match self.listed {
            true => String::new(),
            false => format!("; the line stands at the case, R = {:.0} m", self.radius),
        };
        let leads = match self.running_gear.wheelsets() {
            1 => "",
            _ => "Wheelset 1 leads. ",
        };
        LineFigure {
            title: match self.running_gear {
                RunningGear::Wheelset(_) => "Wheelset in curves",
                RunningGear::Bogie(_) => "Bogie in curves",
                RunningGear::Vehicle { .. } => "Vehicle in curves",
            }
            .to_owned(),
            caption: format!(
                "{leads}Each radius at the lateral acceleration of the case, the speed in proportion to \
                 √R{of_case}."
            ),
            panels: vec![
                self.of_wheelsets("lateral shift y [mm]", |state, index| 1e3 * state.wheelsets[index].lateral_shift),
                self.of_wheelsets("angle of attack [mrad]", |state, index| {
                    1e3 * state.wheelsets[index].angle_of_attack
                }),
                self.of_wheels("|Q|/μP [-]", share_of_friction),
                self.of_wheels("wear number Tγ [N]", WheelState::whole_t_gamma),
            ],
            arrangement: Arrangement::Stacked,
        }
    }

    fn of_wheelsets(&self, label: &str, value: impl Fn(&VehicleState, usize) -> f64) -> LinePanel {
        let series = (0..self.running_gear.wheelsets()).map(|index| {
            let style = [LineStyle::Solid, LineStyle::Dashed][index % 2];
            self.series(&format!("wheelset {}", index + 1), style, |state| value(state, index))
        });
        self.panel(label, series.collect())
    }

    fn of_wheels(&self, label: &str, value: impl Fn(&WheelState) -> f64) -> LinePanel {
        let series = (0..2 * self.running_gear.wheelsets()).map(|index| {
            let rail = if index % 2 == 0 { "left" } else { "right" };
            let style = [LineStyle::Solid, LineStyle::Dashed][index / 2 % 2];
            let label = format!("wheelset {}, {rail}", index / 2 + 1);
            self.series(&label, style, |state| value(&state.wheels[index]))
        });
        self.panel(label, series.collect())
    }

    fn series(&self, label: &str, style: LineStyle, value: impl Fn(&VehicleState) -> f64) -> Series {
        let at = |point: &Point| {
            let state = point.state.as_ref();
            (point.curve.radius.abs(), state.map_or(f64::NAN, &value))
        };
        let (x, y) = self.points.iter().map(at).unzip();
        let style = match self.listed {
            true => LineStyle::Markers,
            false => style,
        };
        Series { label: label.to_owned(), x, y, style, color: None }
    }

    fn panel(&self, label: &str, series: Vec<Series>) -> LinePanel {
        LinePanel {
            x_label: "curve radius |R| [m]".to_owned(),
            y_label: label.to_owned(),
            x_scale: Scale::Log,
            y_scale: Scale::Linear,
            series,
            marks: match self.listed {
                true => Vec::new(),
                false => vec![Mark { x: self.radius, label: String::new() }],
            },
            ..LinePanel::default()
        }
    }
}

/// Σ|Q| over Σ μP of the contacts of a wheel, continuous where one takes the load of the other.
fn share_of_friction(wheel: &WheelState) -> f64 {
    match &wheel.second_contact {
        None => wheel.tractive_ratio,
        Some(second) => {
            (wheel.tractive_ratio * wheel.normal_force + second.tractive_ratio * second.normal_force)
                / (wheel.normal_force + second.normal_force)
        }
    }
}
