//! Stick, slip and tractions of the mean state as a picture.

use riffel::contact::ContactElement;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Series};

use super::{RollingTheories, line, parameters};
use crate::{Rows, Table};

const TO_MILLIMETRES: f64 = 1e3;
const TO_MEGAPASCALS: f64 = 1e-6;

pub(super) fn figure(patch: &RollingTheories) -> LineFigure {
    /// Height of a panel over its width, so that the ellipse keeps its shape.
    const HEIGHT_OVER_WIDTH: f64 = 200.0 / 450.0;
    const AIR: f64 = 1.12;
    let [a, b] = semi_axes(patch);
    let half_width = AIR * a.max(b / HEIGHT_OVER_WIDTH);
    let x_range = Some((-half_width, half_width));
    let half_height = half_width * HEIGHT_OVER_WIDTH;
    let x_label = "x along the rail, in the direction of rolling [mm]".to_owned();
    let highest = TO_MEGAPASCALS * patch.friction * patch.hertz.peak_pressure();
    LineFigure::new(
        "Contact patch in steady rolling",
        format!("Half-space theory; material enters on the right, at x = +a. {}", parameters(patch)),
        [
            LinePanel {
                x_range,
                y_range: Some((0.0, 1.25 * highest)),
                ..LinePanel::new(x_label.clone(), "traction [MPa]", tractions(patch))
                    .titled("tractions on the centre line")
            },
            LinePanel {
                x_range,
                y_range: Some((-half_height, half_height)),
                ..LinePanel::new(x_label, "y across the rail [mm]", stick_and_slip(patch))
                    .titled("where the surfaces stick and slip")
            },
        ],
    )
    .arranged(Arrangement::Stacked)
}

/// Semi-axes along and across the rail \[mm\].
fn semi_axes(patch: &RollingTheories) -> [f64; 2] {
    let hertz = &patch.hertz;
    [hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral()].map(|axis| TO_MILLIMETRES * axis)
}

/// Bound and traction of the row of elements beside the centre line.
fn tractions(patch: &RollingTheories) -> Vec<Series> {
    let [a, _] = semi_axes(patch);
    // The number of rows is even: the one just beside the centre line.
    let beside = patch.elements().map(|element| element.centre.1).filter(|&y| y > 0.0).fold(f64::INFINITY, f64::min);
    let row: Vec<ContactElement> = patch.elements().filter(|element| element.centre.1 == beside).collect();
    // On the edge of the patch the pressure vanishes.
    let x: Vec<f64> = row.iter().map(|element| TO_MILLIMETRES * element.centre.0).chain([-a, a]).collect();
    let stress = |label, style, value: fn(&ContactElement) -> f64| {
        let y: Vec<f64> = row.iter().map(|element| TO_MEGAPASCALS * value(element)).chain([0.0, 0.0]).collect();
        Series { style, ..line(label, &x, &y) }
    };

    // Along the rail, or of both components.
    let traction: fn(&ContactElement) -> f64 = match patch.along_rail() {
        true => |element| element.traction.0,
        false => |element| element.traction.0.hypot(element.traction.1),
    };
    vec![stress("bound μp", LineStyle::Dashed, |element| element.bound), stress("traction", LineStyle::Solid, traction)]
}

/// The elements that stick and those that slip, and the outline of the patch.
fn stick_and_slip(patch: &RollingTheories) -> Vec<Series> {
    /// Elements over a diameter that can be told apart.
    const MOST_MARKS: u64 = 40;
    /// Number of marks from which a zone is wide.
    const WIDE_ZONE: usize = 150;
    let [a, b] = semi_axes(patch);
    let outline: (Vec<f64>, Vec<f64>) = (0..=180)
        .map(|step| std::f64::consts::TAU * f64::from(step) / 180.0)
        .map(|angle| (a * angle.cos(), b * angle.sin()))
        .unzip();
    let rows = distinct(patch.elements().map(|element| element.centre.1));
    let columns = distinct(patch.elements().map(|element| element.centre.0));
    let every = patch.contact.file.contact.grid.div_ceil(MOST_MARKS) as usize;
    let marks = |label: &str, slips: bool, color: usize| {
        // A wide zone is legible with fewer marks.
        let zone = patch.elements().filter(|element| element.slips == slips);
        let every = if zone.count() > WIDE_ZONE * every * every { 2 * every } else { every };
        let shown = |places: &[f64], place: f64| {
            places.binary_search_by(|other| other.total_cmp(&place)).is_ok_and(|index| index % every == every / 2)
        };
        let (x, y) = patch
            .elements()
            .filter(|element| element.slips == slips)
            .map(|element| element.centre)
            .filter(|&(x, y)| shown(&columns, x) && shown(&rows, y))
            .map(|(x, y)| (TO_MILLIMETRES * x, TO_MILLIMETRES * y))
            .unzip();
        Series::new(label, x, y).styled(LineStyle::Markers).colored(OKABE_ITO[color])
    };
    vec![marks("stick", false, 1), marks("slip", true, 2), Series::new("", outline.0, outline.1).colored(OKABE_ITO[0])]
}

/// Values in ascending order, each once.
pub(super) fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// The elements of the patch, one row for each.
pub(super) fn table(patch: &RollingTheories) -> Table {
    let elements: Vec<ContactElement> = patch.elements().collect();
    Table {
        name: "patch",
        columns: vec![
            elements.exact("x_m", |element| element.centre.0),
            elements.exact("y_m", |element| element.centre.1),
            elements.exact("traction_longitudinal_pa", |element| element.traction.0),
            elements.exact("traction_lateral_pa", |element| element.traction.1),
            elements.exact("bound_pa", |element| element.bound),
            elements.names("slips", |element| element.slips),
        ],
    }
}
