//! The colour bar of a map: its steps, their values and the name of the quantity.

use plotters::style::text_anchor::{HPos, VPos};

use crate::canvas::{Canvas, Lettering, Stroke};
use crate::color::{Rgb, growth_color};
use crate::error::PlotError;
use crate::sheet_box::SheetBox;
use crate::text::{self, Weight};
use crate::text::{TICK_FONT, TITLE_FONT};

/// Height of bar, values and name, pixels.
pub(crate) const HEIGHT: f64 = BAR + 4.0 + TICK_FONT + 5.0 + TITLE_FONT + 3.0;
const BAR: f64 = 10.0;
/// More steps than this cannot be told apart.
const MOST_STEPS: usize = 50;

/// The equal steps of growth of a map.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Steps {
    /// Smallest value of the map, negative.
    pub(crate) least: f64,
    /// Number of steps from 0 to `least`.
    pub(crate) count: usize,
}

impl Steps {
    /// Value at the boundary `index`, from 0 at 0 to `least` at `count`.
    pub(crate) fn value(&self, index: usize) -> f64 {
        self.least * (index as f64 / self.count as f64)
    }

    /// The steps of a map, none if nothing grows. The count is kept within 1 to [`MOST_STEPS`].
    pub(crate) fn new(least: Option<f64>, count: usize) -> Option<Self> {
        least
            .filter(|least| -least > f64::MIN_POSITIVE)
            .map(|least| Steps {
                least,
                count: count.clamp(1, MOST_STEPS),
            })
    }

    /// Power of ten common to the values; 0 for numbers that read well as they are.
    fn exponent(&self) -> i32 {
        let magnitude = self.least.abs().log10().floor() as i32;
        if (-2..=3).contains(&magnitude) {
            0
        } else {
            magnitude
        }
    }

    /// Value at the boundary `index` in words, with two significant digits of the smallest value at
    /// least.
    pub(crate) fn label(&self, index: usize) -> String {
        let unit = 10f64.powi(self.exponent());
        let magnitude = (self.least.abs() / unit).log10().floor() as i32;
        if index == 0 {
            return "0".to_owned();
        }
        text::fixed(
            self.value(index) / unit,
            (1 - magnitude).clamp(0, 9) as usize,
        )
    }

    /// Name of the quantity with the power of ten, if there is one.
    pub(crate) fn title(&self, name: &str) -> String {
        match self.exponent() {
            0 => name.to_owned(),
            exponent => format!("{name}  (×{})", text::power_of_ten(exponent)),
        }
    }

    /// Colour of the step between the boundaries `index` and `index + 1`.
    pub(crate) fn color(&self, index: usize) -> Rgb {
        growth_color(index as f64 / (self.count.max(2) - 1) as f64)
    }

    /// Values at which regions of growth begin, as positive numbers; the first is just above 0, for
    /// a value of exactly 0 is no growth.
    pub(crate) fn growth_levels(&self) -> Vec<f64> {
        (0..self.count)
            .map(|index| {
                if index == 0 {
                    -self.least * 1e-9
                } else {
                    -self.value(index)
                }
            })
            .collect()
    }
}

/// Draws the bar below a panel from `left` to `right`, its upper edge at `top`. A map without
/// growth has no steps.
pub(crate) fn draw(
    canvas: &mut Canvas<'_>,
    (left, right, top): (f64, f64, f64),
    steps: Option<&Steps>,
    name: &str,
) -> Result<(), PlotError> {
    let middle = (left + right) / 2.0;
    let Some(steps) = steps else {
        let style = Lettering::new(TITLE_FONT).anchor(HPos::Center, VPos::Top);
        return canvas.text("no growth in this window", (middle, top + 4.0), style);
    };
    let bar = SheetBox {
        left,
        top,
        right,
        bottom: top + BAR,
    };
    // Numbers ascend from left to right: the smallest value, the strongest growth, stands at the
    // left.
    let at = |index: usize| right - bar.width() * index as f64 / steps.count as f64;
    for index in 0..steps.count {
        canvas.rectangle(
            (at(index + 1), bar.top),
            (at(index), bar.bottom),
            steps.color(index),
            1.0,
        )?;
    }
    let pen = Stroke::solid(Rgb::INK, 0.7);
    let corners = [
        (left, bar.top),
        (right, bar.top),
        (right, bar.bottom),
        (left, bar.bottom),
        (left, bar.top),
    ];
    canvas.line(&corners, pen)?;

    let labels: Vec<String> = (0..=steps.count).map(|index| steps.label(index)).collect();
    let widest = labels
        .iter()
        .map(|label| text::width(label, TICK_FONT, Weight::Regular))
        .fold(0.0, f64::max);
    let every = ((widest + 10.0) / (bar.width() / steps.count as f64))
        .ceil()
        .max(1.0) as usize;
    let every = (every..=steps.count)
        .find(|every| steps.count.is_multiple_of(*every))
        .unwrap_or(steps.count);
    for (index, label) in labels.iter().enumerate() {
        canvas.line(
            &[(at(index), bar.bottom), (at(index), bar.bottom - 2.5)],
            pen,
        )?;
        if index % every == 0 {
            let style = Lettering::new(TICK_FONT).anchor(HPos::Center, VPos::Top);
            canvas.text(label, (at(index), bar.bottom + 4.0), style)?;
        }
    }
    let style = Lettering::new(TITLE_FONT).anchor(HPos::Center, VPos::Top);
    canvas.text(
        &steps.title(name),
        (middle, bar.bottom + 4.0 + TICK_FONT + 5.0),
        style,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_equal_steps_run_from_zero_to_the_smallest_value() {
        let steps = Steps {
            least: -0.5,
            count: 10,
        };
        assert_eq!(
            (steps.value(0), steps.value(5), steps.value(10)),
            (0.0, -0.25, -0.5)
        );
        assert_eq!(steps.growth_levels()[4], 0.2);
        assert!(steps.growth_levels()[0] > 0.0);
    }

    #[test]
    fn values_are_written_short() {
        let steps = |least| Steps::new(Some(least), 10).unwrap();
        assert_eq!(
            (steps(-0.7345).label(10), steps(-0.7345).title("W")),
            ("−0.73".to_owned(), "W".to_owned())
        );
        assert_eq!(
            (steps(-4.321e-7).label(10), steps(-4.321e-7).title("W")),
            ("−4.3".to_owned(), "W  (×10⁻⁷)".to_owned())
        );
        assert_eq!(steps(-432.1).label(5), "−216");
        assert_eq!(Steps::new(Some(-1.0), 0).unwrap().count, 1);
        assert!(Steps::new(None, 10).is_none());
    }
}
