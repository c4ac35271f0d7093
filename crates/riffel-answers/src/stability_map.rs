//! Where over speed and friction the loop oscillates without any profile, how fast and at what frequency.

use rayon::prelude::*;
use riffel::feedback::Stability;
use riffel_case::{Case, ask};
use riffel_keys::quantity::{Quantity, Ratio};
use riffel_keys::{CaseError, Message, fixed, say, shown_speed};
use riffel_plot::{LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Series};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::question::{CaseSource, Client, Question};
use crate::stress::contour;
use crate::{Answer, AnswerError, Column, Result, Rows, Table};

/// Speeds over the range of the map.
const SPEEDS: usize = 31;
/// Ratio of two frequencies above which oscillations are of two branches.
const APART: f64 = 1.12;
/// Growth \[1/s\] of which lines are drawn.
const LEVELS: [f64; 4] = [1.0, 10.0, 100.0, 1000.0];

/// Where over speed and friction the loop oscillates without any profile, as in squeal, how fast and at what frequency.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct StabilityQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Friction coefficients, separated by commas [default: 23, from 0.05 to 0.6].
    #[schemars(extend("value_name" = "LIST", "separator" = ","))]
    friction: Vec<Quantity<Ratio>>,
}

impl Question for StabilityQuestion {
    const NAME: &'static str = "stability";
    const EXAMPLE: &'static str = "\
        Example: riffel stability case.toml --friction 0.1,0.2,0.3,0.4,0.5 --set 'map.speed={min=\"20 km/h\",max=\"80 km/h\"}'\n\n\
        Each friction has the mean state of its own; the speeds are those of map.speed.";

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read(client)?;
        let friction = match self.friction.is_empty() {
            true => StabilityMap::frictions(),
            false => self.friction.iter().map(Quantity::si).collect(),
        };
        let step = client.begin(say!(progress_stability), friction.len());
        Ok(Box::new(StabilityMap::new(&case, &friction, &step)?))
    }
}

/// The loop over speed and friction.
#[derive(Debug, Serialize)]
pub struct StabilityMap {
    #[serde(skip)]
    title: Option<String>,
    /// Speeds of the map of the case.
    pub speeds_m_per_s: Vec<f64>,
    /// Friction coefficients.
    pub friction: Vec<f64>,
    /// By friction, then by speed.
    pub points: Vec<StabilityPoint>,
    /// Oscillations of nearly one frequency, the fastest first.
    pub branches: Vec<StabilityBranch>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

/// The loop at one speed and friction.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct StabilityPoint {
    speed_m_per_s: f64,
    friction: f64,
    /// Two for each oscillation that grows; `None` if it cannot be told.
    unstable_roots: Option<usize>,
    /// Of the highest such oscillation.
    frequency_hz: Option<f64>,
    /// Of its amplitude in time.
    growth_rate_per_s: Option<f64>,
}

/// An oscillation that grows at some points of the map.
#[derive(Debug, Clone, Serialize)]
pub struct StabilityBranch {
    /// Lowest frequency.
    pub frequency_min_hz: f64,
    /// Highest frequency.
    pub frequency_max_hz: f64,
    /// Least friction at which it grows.
    pub friction_min: f64,
    /// Fastest growth.
    pub growth_rate_per_s: Option<f64>,
    /// Where it grows fastest.
    pub speed_m_per_s: f64,
    /// Where it grows fastest.
    pub at_friction: f64,
}

impl StabilityMap {
    /// The loop of a case at the speeds of its map and at some frictions, each with the mean state of its own;
    /// `progress` is told of each friction.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for fewer than two frictions; [`AnswerError::Case`] for one that the case refuses.
    pub fn new(case: &Case, friction: &[f64], progress: &(dyn Fn(usize) + Sync)) -> Result<Self> {
        let mut friction = friction.to_vec();
        friction.sort_by(f64::total_cmp);
        friction.dedup();
        if friction.len() < 2 {
            return Err(AnswerError::argument(
                "--friction",
                friction.iter().map(f64::to_string).collect::<String>(),
                "two different values or more",
            ));
        }
        let (slowest, fastest) = (case.speed.min(), case.speed.max());
        let speeds: Vec<f64> =
            (0..SPEEDS).map(|step| slowest + (fastest - slowest) * step as f64 / (SPEEDS - 1) as f64).collect();
        let rows = friction.par_iter().map(|&friction| {
            let edit = || case.edit(|keys| keys.contact.friction = Quantity::new(friction));
            let own = match edit() {
                Err(wrong @ CaseError::Changed { .. }) => return Err(wrong.into()),
                // A mean state that is not found, as in a curve that is too tight for so little friction.
                own => own.ok(),
            };
            let of = |&speed: &f64| {
                let found = own.as_ref().and_then(|own| ask::stability(own, speed));
                StabilityPoint::new(speed, friction, found)
            };
            let row: Vec<StabilityPoint> = speeds.par_iter().map(of).collect();
            progress(1);
            Ok::<_, AnswerError>((row, own.is_none().then_some(friction)))
        });
        let rows = rows.collect::<Result<Vec<_>, _>>()?;
        let without: Vec<String> =
            rows.iter().filter_map(|row| row.1).map(|friction| format!("{friction:.3}")).collect();
        let points: Vec<StabilityPoint> = rows.into_iter().flat_map(|row| row.0).collect();
        let mut remarks = Vec::new();
        if case.feedback.is_along_one_axis() {
            remarks.push(say!(stability_of_one_axis));
        } else {
            let unknown = points.iter().filter(|point| point.unstable_roots.is_none());
            let unknown = unknown.count();
            let unknown = unknown - without.len() * SPEEDS;
            remarks.extend((unknown > 0).then(|| say!(stability_unknown, points = unknown)));
            let without = (!without.is_empty()).then(|| without.join(", "));
            remarks.extend(without.map(|friction| say!(no_mean_state, friction)));
        }
        Ok(Self {
            title: case.file.title.clone(),
            branches: StabilityBranch::of(&points),
            speeds_m_per_s: speeds,
            friction,
            points,
            remarks,
        })
    }

    /// The frictions that are looked at where none are asked for.
    pub fn frictions() -> Vec<f64> {
        (2..=24).map(|step| 0.025 * f64::from(step)).collect()
    }
}

impl StabilityPoint {
    fn new(speed: f64, friction: f64, found: Option<Stability>) -> Self {
        Self {
            speed_m_per_s: speed,
            friction,
            unstable_roots: found.as_ref().map(|found| found.unstable_roots),
            frequency_hz: found.as_ref().and_then(|found| found.frequency),
            growth_rate_per_s: found.and_then(|found| found.growth_rate),
        }
    }
}

impl StabilityBranch {
    /// The points that oscillate, parted where their frequencies are apart.
    fn of(points: &[StabilityPoint]) -> Vec<Self> {
        let growing = points.iter().filter_map(|point| Some((point.frequency_hz?, point)));
        let mut growing: Vec<(f64, &StabilityPoint)> = growing.collect();
        growing.sort_by(|one, other| one.0.total_cmp(&other.0));
        let parts = growing.chunk_by(|one, other| other.0 <= APART * one.0);
        let mut branches: Vec<Self> = parts.map(Self::of_part).collect();
        branches.sort_by(|one, other| {
            other.growth_rate_per_s.partial_cmp(&one.growth_rate_per_s).unwrap_or(std::cmp::Ordering::Equal)
        });
        branches
    }

    fn of_part(part: &[(f64, &StabilityPoint)]) -> Self {
        /// Rates that are one: roots are found to a part in a million, and with constant friction have no speed.
        const SAME: f64 = 1e-6;
        let rate = |point: &StabilityPoint| point.growth_rate_per_s.unwrap_or(0.0);
        let fastest = part.iter().map(|(_, point)| *point);
        let fastest = fastest.fold(part[0].1, |best, point| {
            let same = (rate(point) - rate(best)).abs() <= SAME * rate(best);
            if same && point.speed_m_per_s > best.speed_m_per_s || !same && rate(point) > rate(best) {
                point
            } else {
                best
            }
        });
        let frictions = part.iter().map(|(_, point)| point.friction);
        Self {
            frequency_min_hz: part[0].0,
            frequency_max_hz: part[part.len() - 1].0,
            friction_min: frictions.fold(f64::INFINITY, f64::min),
            growth_rate_per_s: fastest.growth_rate_per_s,
            speed_m_per_s: fastest.speed_m_per_s,
            at_friction: fastest.friction,
        }
    }

    fn holds(&self, frequency: Option<f64>) -> bool {
        frequency.is_some_and(|frequency| (self.frequency_min_hz..=self.frequency_max_hz).contains(&frequency))
    }

    /// Its frequencies: "412 Hz" or "398–430 Hz".
    fn name(&self) -> String {
        let ends = [self.frequency_min_hz, self.frequency_max_hz].map(|end| format!("{end:.0}"));
        match ends[0] == ends[1] {
            true => format!("{} Hz", ends[0]),
            false => format!("{} Hz", ends.join("–")),
        }
    }
}

impl Answer for StabilityMap {
    fn name(&self) -> &'static str {
        "stability"
    }

    fn introduction(&self) -> Vec<Message> {
        self.title.clone().map(Message::verbatim).into_iter().collect()
    }

    fn tables(&self) -> Vec<Table> {
        let branches = &self.branches;
        let points = &self.points;
        let in_file = |name: &str, of: fn(&StabilityPoint) -> Option<f64>| Column {
            head: None,
            ..points.fixed(name, Message::verbatim(name), 0, of)
        };
        let mut tables = vec![
            Table {
                name: "branches",
                columns: vec![
                    branches.fixed("frequency_min_hz", say!(branch_from), 0, |it| Some(it.frequency_min_hz)),
                    branches.fixed("frequency_max_hz", say!(branch_to), 0, |it| Some(it.frequency_max_hz)),
                    branches.fixed("friction_min", say!(least_friction), 3, |it| Some(it.friction_min)),
                    branches.fixed("growth_rate_per_s", say!(fastest_growth_in_time), 1, |it| it.growth_rate_per_s),
                    branches.fixed("speed_km_per_h", say!(at_speed_column), 0, |it| Some(3.6 * it.speed_m_per_s)),
                    branches.fixed("at_friction", say!(at_friction_column), 3, |it| Some(it.at_friction)),
                ],
            },
            Table {
                name: "stability",
                columns: vec![
                    in_file("speed_m_per_s", |it| Some(it.speed_m_per_s)),
                    in_file("friction", |it| Some(it.friction)),
                    in_file("unstable_roots", |it| Some(it.unstable_roots? as f64)),
                    in_file("frequency_hz", |it| it.frequency_hz),
                    in_file("growth_rate_per_s", |it| it.growth_rate_per_s),
                ],
            },
        ];
        if self.branches.is_empty() {
            tables.remove(0);
        }
        tables
    }

    fn sentences(&self) -> Vec<Message> {
        let least = self.branches.iter().map(|branch| branch.friction_min);
        let least = least.fold(f64::INFINITY, f64::min);
        let lowest = self.friction[0];
        let (slowest, fastest) = (self.speeds_m_per_s[0], self.speeds_m_per_s[SPEEDS - 1]);
        let [slowest, fastest] = [slowest, fastest].map(|speed| shown_speed(speed, 0));
        let highest = fixed(self.friction[self.friction.len() - 1], 3);
        vec![if least.is_infinite() {
            say!(stable_everywhere, slowest, fastest, highest)
        } else if least <= lowest {
            say!(unstable_from_the_least, least = fixed(least, 3), slowest, fastest)
        } else {
            let stable = self.friction.iter().copied().filter(|it| *it < least);
            say!(
                unstable_from,
                stable = fixed(stable.fold(0.0, f64::max), 3),
                least = fixed(least, 3),
                slowest,
                fastest
            )
        }]
    }

    fn figure(&self) -> LineFigure {
        let x: Vec<f64> = self.speeds_m_per_s.iter().map(|speed| 3.6 * speed).collect();
        let line = |label: String, values: &[f64], level: f64, style: LineStyle, color: Rgb| {
            let (x, y) = contour(&x, &self.friction, values, level);
            Series::new(label, x, y).styled(style).colored(color)
        };
        let mut series = Vec::new();
        for (branch, color) in self.branches.iter().zip(OKABE_ITO.iter().cycle().skip(1)) {
            let own = |point: &StabilityPoint| branch.holds(point.frequency_hz);
            let values = |of: &dyn Fn(&StabilityPoint) -> f64| self.points.iter().map(of).collect::<Vec<f64>>();
            let inside = values(&|point| if own(point) { 1.0 } else { -1.0 });
            series.push(line(branch.name(), &inside, 0.0, LineStyle::Solid, *color));
            let growth = values(&|point| match own(point) {
                true => point.growth_rate_per_s.unwrap_or(0.0),
                false => f64::NAN,
            });
            let styles = [LineStyle::Dotted, LineStyle::Dashed];
            for (level, style) in LEVELS.iter().zip(styles.iter().cycle()) {
                let drawn = line(format!("{level:.0}/s"), &growth, *level, *style, *color);
                series.extend((!drawn.x.is_empty()).then_some(drawn));
            }
            let at = Series::new(
                format!("{:.1}/s", branch.growth_rate_per_s.unwrap_or(0.0)),
                vec![3.6 * branch.speed_m_per_s],
                vec![branch.at_friction],
            )
            .styled(LineStyle::Markers)
            .colored(*color);
            series.extend(branch.growth_rate_per_s.map(|_| at));
        }
        let ends = |values: &[f64]| Some((values[0], values[values.len() - 1]));
        LineFigure::new(
            say!(stability_title).to_string(),
            say!(stability_caption).to_string(),
            [LinePanel {
                x_range: ends(&x),
                y_range: ends(&self.friction),
                ..LinePanel::new("speed [km/h]", "friction coefficient [-]", series)
            }],
        )
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two oscillations, 400 and 412 Hz, are one branch; 900 Hz is another and grows faster.
    #[test]
    fn frequencies_make_branches() {
        let point = |frequency: f64, friction: f64, growth: f64| StabilityPoint {
            speed_m_per_s: 10.0 * friction,
            friction,
            unstable_roots: Some(2),
            frequency_hz: Some(frequency),
            growth_rate_per_s: Some(growth),
        };
        let stable = StabilityPoint {
            unstable_roots: Some(0),
            frequency_hz: None,
            growth_rate_per_s: None,
            ..point(0.0, 0.1, 0.0)
        };
        let found =
            StabilityBranch::of(&[point(412.0, 0.3, 2.0), stable, point(400.0, 0.4, 5.0), point(900.0, 0.5, 7.0)]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert_eq!((found[0].name(), found[0].friction_min), ("900 Hz".to_owned(), 0.5));
        assert_eq!((found[1].name(), found[1].friction_min, found[1].at_friction), ("400–412 Hz".to_owned(), 0.3, 0.4));
        assert!(StabilityBranch::of(&[stable]).is_empty());
    }
}
