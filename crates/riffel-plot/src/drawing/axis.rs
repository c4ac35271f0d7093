//! An axis: where a value lies on the sheet, and which values are marked on it.

use super::font::Weight;
use super::text::{self, TICK_FONT};
use crate::scale::{Scale, nice_step};

/// A marked value of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    /// Words beside the tick; a minor tick has none.
    pub(crate) label: Option<String>,
}

/// The ticks of an axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Ticks {
    pub(crate) ticks: Vec<Tick>,
    /// The labels are to be multiplied by ten to this power.
    pub(crate) exponent: i32,
}

impl Ticks {
    /// The names of rows at their middles, in rows from the top.
    pub(crate) fn of_rows<'a>(names: impl Iterator<Item = &'a str>) -> Self {
        let tick = |(index, name): (usize, &str)| Tick { value: index as f64 + 0.5, label: Some(name.to_owned()) };
        Self { ticks: names.enumerate().map(tick).collect(), exponent: 0 }
    }

    /// An axis title with the power of ten, if there is one.
    pub(crate) fn title(&self, title: &str) -> String {
        if self.exponent == 0 {
            title.to_owned()
        } else {
            format!("{title}  (×{})", text::power_of_ten(self.exponent))
        }
    }

    /// Labels of the major ticks.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &str> {
        self.ticks.iter().filter_map(|tick| tick.label.as_deref())
    }
}

/// An axis from `low` at the sheet position `start` to `high` at `end`, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axis {
    pub(crate) scale: Scale,
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) start: f64,
    pub(crate) end: f64,
}

impl Axis {
    /// An axis of equal steps over a range, between two sheet positions.
    pub(crate) fn linear((low, high): (f64, f64), (start, end): (f64, f64)) -> Self {
        Axis { scale: Scale::Linear, low, high, start, end }
    }

    /// Sheet position of a value, pixels.
    pub(crate) fn at(&self, value: f64) -> f64 {
        let fraction = match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Log => (value / self.low).ln() / (self.high / self.low).ln(),
        };
        self.start + fraction * (self.end - self.start)
    }

    /// Ticks of which at most about `count` carry a label, and no two labels of which touch: the first set that has
    /// room, from the richest to the poorest. `direction` is that of the axis.
    pub(crate) fn ticks(&self, count: usize, direction: Direction) -> Ticks {
        self.first_with_room(self.candidates(count), direction)
    }

    /// Ticks of an angle in degrees, at divisions of a full turn.
    pub(crate) fn degree_ticks(&self, count: usize, direction: Direction) -> Ticks {
        let span = self.high - self.low;
        match self.scale {
            Scale::Linear if degree_step(span, count).is_some() => {
                let steps = (1..=count.max(1)).rev().filter_map(|count| degree_step(span, count));
                let ticks = steps.map(|step| linear_ticks(self.low, self.high, step));
                self.first_with_room(ticks.collect(), direction)
            }
            _ => self.ticks(count, direction),
        }
    }

    /// Sets of ticks, from the richest to the poorest.
    fn candidates(&self, count: usize) -> Vec<Ticks> {
        let linear = || {
            (1..=count.max(1))
                .rev()
                .map(|count| linear_ticks(self.low, self.high, nice_step(self.high - self.low, count)))
        };
        match self.scale {
            Scale::Linear => linear().collect(),
            Scale::Log => {
                let of_decades = log_ticks(self.low, self.high, count);
                // Between two decades there may be nothing but steps.
                let bare = of_decades.first().is_none_or(|most| most.labels().count() < 2);
                let steps = linear().filter(|_| bare);
                steps.chain(of_decades.clone()).collect()
            }
        }
    }

    fn first_with_room(&self, candidates: Vec<Ticks>, direction: Direction) -> Ticks {
        let last = candidates.len() - 1;
        candidates
            .into_iter()
            .enumerate()
            .find(|(index, ticks)| *index == last || self.have_room(ticks, direction))
            .map_or_else(Ticks::default, |(_, ticks)| ticks)
    }

    /// Whether the labels stand clear of each other.
    fn have_room(&self, ticks: &Ticks, direction: Direction) -> bool {
        let labelled = ticks.ticks.iter().filter_map(|tick| {
            let label = tick.label.as_deref()?;
            Some((self.at(tick.value), 0.5 * direction.room(label)))
        });
        let labelled: Vec<(f64, f64)> = labelled.collect();
        labelled.windows(2).all(|pair| (pair[1].0 - pair[0].0).abs() >= pair[0].1 + pair[1].1)
    }
}

/// Direction of an axis on the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Direction {
    Across,
    Upright,
}

impl Direction {
    /// Room that a label of a tick takes along the axis, with what keeps it from its neighbours, pixels.
    fn room(self, label: &str) -> f64 {
        const BETWEEN_WORDS: f64 = 8.0;
        const BETWEEN_LINES: f64 = 1.5;
        match self {
            Direction::Across => text::width(label, TICK_FONT, Weight::Regular) + BETWEEN_WORDS,
            Direction::Upright => TICK_FONT + BETWEEN_LINES,
        }
    }
}

/// Smallest customary division of a turn that needs at most `count` intervals for `span` degrees.
pub(crate) fn degree_step(span: f64, count: usize) -> Option<f64> {
    [5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0].into_iter().find(|step| step * count.max(1) as f64 >= span)
}

/// More ticks than this would mean a step lost in rounding.
const MOST_TICKS: usize = 100;

fn linear_ticks(low: f64, high: f64, step: f64) -> Ticks {
    let largest = low.abs().max(high.abs());
    // Plain numbers from 0.001 to 99999, a common power of ten outside.
    let magnitude = largest.log10().floor() as i32;
    let exponent = if (-2..=4).contains(&magnitude) { 0 } else { magnitude };
    let unit = 10f64.powi(exponent);
    let decimals = (exponent - (step * (1.0 + 1e-9)).log10().floor() as i32).clamp(0, 15) as usize;
    let first = (low / step - 1e-9).ceil();
    let last = (high / step + 1e-9).floor();
    let mut ticks = Vec::new();
    let mut index = first;
    while index <= last && ticks.len() < MOST_TICKS {
        let value = index * step;
        ticks.push(Tick { value, label: Some(text::fixed(value / unit, decimals)) });
        index += 1.0;
    }
    Ticks { ticks, exponent }
}

/// Ticks of an axis of decades, the labels from the most to the fewest.
fn log_ticks(low: f64, high: f64, count: usize) -> Vec<Ticks> {
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let inside = |value: f64| value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
    let decades = (first..=last).filter(|&n| inside(10f64.powi(n))).count();
    let every = decades.div_ceil(count.max(1)).max(1) as i32;
    let plain = first >= -2 && last <= 5;
    // Few decades leave room for labels between them, many ask for gaps.
    let between: &[&[u32]] = match decades {
        0 | 1 => &[&[1, 2, 3, 4, 5, 6, 7, 8, 9], &[1, 2, 3, 4, 5, 7], &[1, 2, 5], &[1]],
        2 if count >= 5 => &[&[1, 2, 5], &[1]],
        _ => &[&[1]],
    };
    let gaps = (every..=every.max(decades as i32)).skip(1).map(|every| (&[1][..], every));
    let choices = between.iter().map(|factors| (*factors, every)).chain(gaps);
    let ticks = |(factors, every): (&[u32], i32)| {
        let mut ticks = Vec::new();
        for n in first..=last {
            for factor in 1..10u32 {
                let value = f64::from(factor) * 10f64.powi(n);
                if !inside(value) || (factor > 1 && every > 1) {
                    continue;
                }
                let labelled = factors.contains(&factor) && n.rem_euclid(every) == 0;
                let label = labelled.then(|| match (plain, factor) {
                    (true, _) => text::fixed(value, (-n).max(0) as usize),
                    (false, 1) => text::power_of_ten(n),
                    (false, _) => format!("{factor}·{}", text::power_of_ten(n)),
                });
                ticks.push(Tick { value, label });
            }
        }
        Ticks { ticks, exponent: 0 }
    };
    choices.map(ticks).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, low: f64, high: f64, count: usize) -> Vec<String> {
        let axis = Axis { scale, ..Axis::linear((low, high), (0.0, 400.0)) };
        axis.ticks(count, Direction::Across).labels().map(str::to_owned).collect()
    }

    #[test]
    fn linear_labels_are_short() {
        assert_eq!(labels(Scale::Linear, 20.0, 80.0, 6), ["20", "30", "40", "50", "60", "70", "80"]);
        assert_eq!(labels(Scale::Linear, 18.0, 216.0, 5), ["50", "100", "150", "200"]);
        assert_eq!(
            labels(Scale::Linear, -0.25, 0.05, 6),
            ["−0.25", "−0.20", "−0.15", "−0.10", "−0.05", "0.00", "0.05"]
        );
    }

    #[test]
    fn angles_divide_a_turn() {
        let axis = Axis::linear((-180.0, 0.0), (0.0, 400.0));
        assert_eq!(
            axis.degree_ticks(6, Direction::Across).labels().collect::<Vec<_>>(),
            ["−180", "−150", "−120", "−90", "−60", "−30", "0"]
        );
        assert_eq!(
            axis.degree_ticks(4, Direction::Across).labels().collect::<Vec<_>>(),
            ["−180", "−135", "−90", "−45", "0"]
        );
    }

    #[test]
    fn tiny_numbers_share_a_power_of_ten() {
        let axis = Axis::linear((0.0, 3e-9), (0.0, 400.0));
        let ticks = axis.ticks(3, Direction::Across);
        assert_eq!(ticks.exponent, -9);
        assert_eq!(ticks.labels().collect::<Vec<_>>(), ["0", "1", "2", "3"]);
        assert_eq!(ticks.title("growth"), "growth  (×10⁻⁹)");
    }

    #[test]
    fn decades_carry_powers() {
        assert_eq!(labels(Scale::Log, 1e-11, 1e-8, 6), ["10⁻¹¹", "10⁻¹⁰", "10⁻⁹", "10⁻⁸"]);
        assert_eq!(labels(Scale::Log, 10.0, 5000.0, 3), ["10", "100", "1000"]);
        assert_eq!(labels(Scale::Log, 1e-30, 1.0, 4).len(), 4);
    }

    #[test]
    fn labels_never_touch_on_any_scale() {
        for (low, high) in [(0.44, 8.2), (1.0, 9.0), (52.0, 58.0), (3.0, 2500.0), (1e-12, 1e4), (12.4001, 12.4123)] {
            for scale in [Scale::Linear, Scale::Log] {
                for (length, direction) in [
                    (60.0, Direction::Upright),
                    (200.0, Direction::Upright),
                    (110.0, Direction::Across),
                    (450.0, Direction::Across),
                ] {
                    let axis = Axis { scale, ..Axis::linear((low, high), (0.0, length)) };
                    let ticks = axis.ticks(10, direction);
                    assert!(axis.have_room(&ticks, direction), "{scale:?} {low} {high} {length}: {ticks:?}");
                    assert!(
                        length < 200.0 || ticks.labels().count() >= 2,
                        "{scale:?} {low} {high} {length}: {ticks:?}"
                    );
                }
            }
        }
        // Half a decade between two powers of ten.
        assert_eq!(labels(Scale::Log, 52.0, 58.0, 6), ["52", "53", "54", "55", "56", "57", "58"]);
    }

    #[test]
    fn ranges_are_never_empty() {
        for scale in [Scale::Linear, Scale::Log] {
            for values in [&[][..], &[0.0], &[5.0], &[-5.0], &[f64::NAN, f64::INFINITY], &[3.0, 3.0], &[-1.0, 2.0]] {
                let (low, high) = scale.with_air(scale.range_of(values.iter().copied()));
                assert!(low < high && scale.admits(low) && scale.admits(high), "{scale:?} {values:?}: {low} {high}");
            }
        }
    }

    #[test]
    fn positions_are_exact_at_the_ends_and_the_middle() {
        let axis = Axis { scale: Scale::Log, ..Axis::linear((1.0, 100.0), (200.0, 0.0)) };
        assert!((axis.at(1.0) - 200.0).abs() < 1e-12);
        assert!((axis.at(10.0) - 100.0).abs() < 1e-12);
        assert!((axis.at(100.0)).abs() < 1e-12);
    }
}
