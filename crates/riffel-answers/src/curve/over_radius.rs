//! A bogie over the radius of the curve.

use std::io::{self, Write};

use riffel::curving::{BogieInCurve, BogieState, Curve, WheelState};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};

use super::document::rail_name;

/// Radii that are computed.
const RADII: usize = 81;
/// Tightest and widest of them over that of the case.
const REACH: [f64; 2] = [0.2, 20.0];

/// The bogie of a case in curves of other radii to the same side, each run through at the speed that has the lateral
/// acceleration of the case.
pub struct OverRadius {
    radius: f64,
    points: Vec<Point>,
}

struct Point {
    curve: Curve,
    /// None where no equilibrium is found.
    state: Option<BogieState>,
}

impl OverRadius {
    pub(super) fn new(bogie: &BogieInCurve) -> Self {
        let radius = bogie.curve.radius.abs();
        let [tightest, widest] = REACH;
        let points = (0..RADII).map(|index| {
            let place = index as f64 / (RADII - 1) as f64;
            let factor = tightest * (widest / tightest).powf(place);
            let curve = Curve {
                radius: factor * bogie.curve.radius,
                speed: factor.sqrt() * bogie.curve.speed,
                ..bogie.curve
            };
            let moved = BogieInCurve {
                curve,
                ..bogie.clone()
            };
            Point {
                curve,
                state: moved.equilibrium().ok(),
            }
        });
        Self {
            radius,
            points: points.collect(),
        }
    }

    /// One row for each radius and wheel; rows without an equilibrium are left out.
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
                writer.serialize((
                    (point.curve.radius, point.curve.speed, wheel.wheelset),
                    rail_name(wheel.rail),
                    [
                        wheelset.lateral_shift,
                        wheelset.yaw,
                        wheelset.angle_of_attack,
                    ],
                    [
                        wheel.creepages.longitudinal,
                        wheel.creepages.lateral,
                        wheel.creepages.spin,
                        wheel.contact_angle,
                        wheel.rolling_radius,
                    ],
                    [
                        wheel.normal_force,
                        wheel.creep_forces.longitudinal,
                        wheel.creep_forces.lateral,
                        wheel.track_lateral_force,
                        wheel.tractive_ratio,
                        wheel.t_gamma,
                    ],
                ))?;
            }
        }
        writer.flush()
    }

    /// Shift, angle of attack, share of friction and wear number over the radius.
    pub fn figure(&self) -> LineFigure {
        LineFigure {
            title: "Bogie in curves".to_owned(),
            caption: format!(
                "Wheelset 1 leads. Each radius at the lateral acceleration of the case, the speed in proportion to \
                 √R; the line stands at the case, R = {:.0} m.",
                self.radius
            ),
            panels: vec![
                self.of_wheelsets("lateral shift y [mm]", |state, index| {
                    1e3 * state.wheelsets[index].lateral_shift
                }),
                self.of_wheelsets("angle of attack [mrad]", |state, index| {
                    1e3 * state.wheelsets[index].angle_of_attack
                }),
                self.of_wheels("|Q|/μP [-]", |wheel| wheel.tractive_ratio),
                self.of_wheels("wear number Tγ [N]", |wheel| wheel.t_gamma),
            ],
            arrangement: Arrangement::Stacked,
        }
    }

    fn of_wheelsets(&self, label: &str, value: impl Fn(&BogieState, usize) -> f64) -> LinePanel {
        let series = (0..2).map(|index| {
            let style = [LineStyle::Solid, LineStyle::Dashed][index];
            self.series(&format!("wheelset {}", index + 1), style, |state| {
                value(state, index)
            })
        });
        self.panel(label, series.collect())
    }

    fn of_wheels(&self, label: &str, value: impl Fn(&WheelState) -> f64) -> LinePanel {
        let series = (0..4).map(|index| {
            let rail = if index % 2 == 0 { "left" } else { "right" };
            let style = [LineStyle::Solid, LineStyle::Dashed][index / 2];
            let label = format!("wheelset {}, {rail}", index / 2 + 1);
            self.series(&label, style, |state| value(&state.wheels[index]))
        });
        self.panel(label, series.collect())
    }

    fn series(&self, label: &str, style: LineStyle, value: impl Fn(&BogieState) -> f64) -> Series {
        let found = self.points.iter().filter_map(|point| {
            let state = point.state.as_ref()?;
            Some((point.curve.radius.abs(), value(state)))
        });
        let (x, y) = found.unzip();
        Series {
            label: label.to_owned(),
            x,
            y,
            style,
            color: None,
        }
    }

    fn panel(&self, label: &str, series: Vec<Series>) -> LinePanel {
        LinePanel {
            x_label: "curve radius |R| [m]".to_owned(),
            y_label: label.to_owned(),
            x_scale: Scale::Log,
            y_scale: Scale::Linear,
            series,
            marks: vec![Mark {
                x: self.radius,
                label: String::new(),
            }],
            ..LinePanel::default()
        }
    }
}
