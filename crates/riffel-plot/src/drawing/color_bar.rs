//! The colour bar of a map: its steps, their values and the name of the quantity.

use super::font::Weight;
use super::picture::{Horizontal, Lettering, Picture, Stroke, Vertical};
use super::sheet_box::SheetBox;
use super::text::{self, TICK_FONT, TITLE_FONT};
use crate::color::Rgb;
use crate::steps::Steps;

/// Height of bar, values and name, pixels.
pub(crate) const HEIGHT: f64 = BAR + 4.0 + TICK_FONT + 5.0 + TITLE_FONT + 3.0;
const BAR: f64 = 10.0;

impl Steps {
    /// Power of ten common to the values; 0 for numbers that read well as they are.
    fn exponent(&self) -> i32 {
        let magnitude = self.least.abs().log10().floor() as i32;
        if (-2..=3).contains(&magnitude) { 0 } else { magnitude }
    }

    /// Value at the boundary `index` in words, with two significant digits of the smallest value at
    /// least, and one decimal more where a step is not a whole number of the last digit.
    pub(crate) fn label(&self, index: usize) -> String {
        let unit = 10f64.powi(self.exponent());
        let magnitude = (self.least.abs() / unit).log10().floor() as i32;
        if index == 0 {
            return "0".to_owned();
        }
        let decimals = (1 - magnitude).clamp(0, 9);
        let step = self.value(1).abs() / unit * 10f64.powi(decimals);
        // Rounded, such steps would look unequal; those of ten digits and more do not.
        let is_uneven = step < 10.0 && (step - step.round()).abs() > 1e-6 * step;
        text::fixed(self.value(index) / unit, (decimals + i32::from(is_uneven)) as usize)
    }

    /// Name of the quantity with the power of ten, if there is one.
    pub(crate) fn title(&self, name: &str) -> String {
        match self.exponent() {
            0 => name.to_owned(),
            exponent => format!("{name}  (×{})", text::power_of_ten(exponent)),
        }
    }
}

/// Draws the bar below a panel from `left` to `right`, its upper edge at `top`. A map without
/// growth has no steps.
pub(crate) fn draw(picture: &mut Picture, (left, right, top): (f64, f64, f64), steps: Option<&Steps>, name: &str) {
    let middle = (left + right) / 2.0;
    let Some(steps) = steps else {
        let style = Lettering::new(TITLE_FONT).anchor(Horizontal::Center, Vertical::Top);
        picture.text("no growth in this window", (middle, top + 4.0), style);
        return;
    };
    let bar = SheetBox { left, top, right, bottom: top + BAR };
    // Numbers ascend from left to right: the smallest value, the strongest growth, stands at the
    // left.
    let at = |index: usize| right - bar.width() * index as f64 / steps.count as f64;
    for index in 0..steps.count {
        picture.rectangle((at(index + 1), bar.top), (at(index), bar.bottom), steps.color(index), 1.0);
    }
    let pen = Stroke::solid(Rgb::INK, 0.7);
    let corners = [(left, bar.top), (right, bar.top), (right, bar.bottom), (left, bar.bottom), (left, bar.top)];
    picture.line(&corners, pen);

    let labels: Vec<String> = (0..=steps.count).map(|index| steps.label(index)).collect();
    let widest = labels.iter().map(|label| text::width(label, TICK_FONT, Weight::Regular)).fold(0.0, f64::max);
    let every = ((widest + 10.0) / (bar.width() / steps.count as f64)).ceil().max(1.0) as usize;
    let every = (every..=steps.count).find(|every| steps.count.is_multiple_of(*every)).unwrap_or(steps.count);
    for (index, label) in labels.iter().enumerate() {
        picture.line(&[(at(index), bar.bottom), (at(index), bar.bottom - 2.5)], pen);
        if index % every == 0 {
            let style = Lettering::new(TICK_FONT).anchor(Horizontal::Center, Vertical::Top);
            picture.text(label, (at(index), bar.bottom + 4.0), style);
        }
    }
    let style = Lettering::new(TITLE_FONT).anchor(Horizontal::Center, Vertical::Top);
    picture.text(&steps.title(name), (middle, bar.bottom + 4.0 + TICK_FONT + 5.0), style)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_equal_steps_run_from_zero_to_the_smallest_value() {
        let steps = Steps { least: -0.5, count: 10 };
        assert_eq!((steps.value(0), steps.value(5), steps.value(10)), (0.0, -0.25, -0.5));
        assert_eq!(steps.growth_levels()[4], 0.2);
        assert!(steps.growth_levels()[0] > 0.0);
    }

    #[test]
    fn values_are_written_short() {
        let steps = |least| Steps::new(Some(least), 10).unwrap();
        assert_eq!((steps(-0.7345).label(10), steps(-0.7345).title("W")), ("−0.735".to_owned(), "W".to_owned()));
        assert_eq!(
            (steps(-4.321e-7).label(10), steps(-4.321e-7).title("W")),
            ("−4.32".to_owned(), "W  (×10⁻⁷)".to_owned())
        );
        assert_eq!(steps(-432.1).label(5), "−216");
        // One digit for each step of 1.5, none for steps of 1.
        assert_eq!((steps(-15.0).label(9), steps(-15.0).label(8)), ("−13.5".to_owned(), "−12.0".to_owned()));
        assert_eq!(steps(-10.0).label(9), "−9");
        assert_eq!(Steps::new(Some(-1.0), 0).unwrap().count, 1);
        assert!(Steps::new(None, 10).is_none());
    }
}
