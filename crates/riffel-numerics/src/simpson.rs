//! Quadrature by Simpson's rule.

/// Places from 0 to 1 with weights that sum to one, for an even number of equal panels: exact for cubics, with an error of
/// (1/panels)⁴/180 of the fourth derivative.
pub fn simpson(panels: usize) -> impl Iterator<Item = (f64, f64)> {
    debug_assert!(panels.is_multiple_of(2) && panels > 0);
    let count = panels as f64;
    (0..=panels).map(move |place| {
        let weight = match place {
            0 => 1.0,
            _ if place == panels => 1.0,
            _ if place % 2 == 1 => 4.0,
            _ => 2.0,
        };
        (place as f64 / count, weight / (3.0 * count))
    })
}
