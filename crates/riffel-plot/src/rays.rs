//! Rays of constant frequency, V = fλ, across a window of wavelength and speed.

/// A window of wavelength (m) and speed (m/s).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Window {
    pub(crate) wavelength_m: (f64, f64),
    pub(crate) speed_m_per_s: (f64, f64),
}

impl Window {
    /// The part of the ray V = fλ inside the window: its points (λ, V) of lowest and of highest
    /// speed.
    pub(crate) fn ray(&self, frequency_hz: f64) -> Option<[(f64, f64); 2]> {
        if !(frequency_hz.is_finite() && frequency_hz > 0.0) {
            return None;
        }
        let from = self.wavelength_m.0.max(self.speed_m_per_s.0 / frequency_hz);
        let to = self.wavelength_m.1.min(self.speed_m_per_s.1 / frequency_hz);
        (from < to).then_some([(from, frequency_hz * from), (to, frequency_hz * to)])
    }

    /// Length of the ray in the window drawn as a unit square.
    fn ray_length(&self, frequency_hz: f64) -> f64 {
        let width = self.wavelength_m.1 - self.wavelength_m.0;
        let height = self.speed_m_per_s.1 - self.speed_m_per_s.0;
        self.ray(frequency_hz).map_or(0.0, |[from, to]| ((to.0 - from.0) / width).hypot((to.1 - from.1) / height))
    }
}

/// Multiples of the powers of ten, preferred first, from which the frequencies of rays are chosen.
const SERIES: [&[f64]; 5] = [
    &[1.0, 2.0, 5.0],
    &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0],
    &[1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0],
    &[1.0, 3.0],
    &[1.0],
];

/// Rays fewer than this leave the window without a scale of frequency.
const FEWEST: usize = 4;
/// Rays more than this crowd the window.
const MOST: usize = 7;
/// A ray shorter than this share of a side only cuts a corner.
const SHORTEST: f64 = 0.12;

/// Round frequencies (Hz) whose rays V = fλ cross a window of wavelength (m) and speed (m/s), in
/// ascending order.
///
/// The series 1, 2, 5 × 10ⁿ is taken if four to seven of its rays cross the window by more than a
/// corner, else a finer or coarser series. A window that is empty or not positive has no rays.
pub fn constant_frequency_rays(wavelength_range_m: (f64, f64), speed_range_m_per_s: (f64, f64)) -> Vec<f64> {
    let window = Window { wavelength_m: wavelength_range_m, speed_m_per_s: speed_range_m_per_s };
    let valid = |(low, high): (f64, f64)| low.is_finite() && high.is_finite() && 0.0 < low && low < high;
    if !valid(wavelength_range_m) || !valid(speed_range_m_per_s) {
        return Vec::new();
    }
    let lowest = speed_range_m_per_s.0 / wavelength_range_m.1;
    let highest = speed_range_m_per_s.1 / wavelength_range_m.0;
    let mut best: Vec<f64> = Vec::new();
    for series in SERIES {
        let rays = crossing(&window, series, lowest, highest);
        if (FEWEST..=MOST).contains(&rays.len()) {
            return rays;
        }
        // A window over many decades: every other ray of the coarsest series.
        best = rays;
    }
    if best.len() > MOST {
        let every = best.len().div_ceil(MOST);
        return best.into_iter().step_by(every).collect();
    }
    // A narrow window: equal steps.
    let step = crate::scale::nice_step(highest - lowest, 6);
    let first = (lowest / step).ceil();
    (0..=MOST)
        .map(|k| (first + k as f64) * step)
        .filter(|&frequency| window.ray_length(frequency) > SHORTEST)
        .take(MOST)
        .collect()
}

fn crossing(window: &Window, series: &[f64], lowest: f64, highest: f64) -> Vec<f64> {
    let decades = lowest.log10().floor() as i32..=highest.log10().ceil() as i32;
    decades
        .flat_map(|n| series.iter().map(move |factor| round_to_three_digits(factor * 10f64.powi(n))))
        .filter(|&frequency| window.ray_length(frequency) > SHORTEST)
        .collect()
}

/// Removes the rounding error of a product with a power of ten.
fn round_to_three_digits(frequency: f64) -> f64 {
    let unit = 10f64.powi(frequency.log10().floor() as i32 - 2);
    (frequency / unit).round() * unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_pitch_window_has_the_round_frequencies() {
        assert_eq!(constant_frequency_rays((0.020, 0.080), (5.0, 60.0)), [100.0, 200.0, 500.0, 1000.0, 2000.0]);
    }

    #[test]
    fn any_window_has_four_to_seven_rays() {
        for (wavelengths, speeds) in [
            ((0.02, 0.08), (5.0, 60.0)),
            ((0.02, 0.3), (10.0, 40.0)),
            ((0.03, 0.05), (20.0, 30.0)),
            ((0.001, 3.0), (0.1, 100.0)),
            ((0.0400, 0.0401), (20.0, 20.1)),
            ((1e-6, 10.0), (1e-3, 1e3)),
        ] {
            let rays = constant_frequency_rays(wavelengths, speeds);
            assert!((4..=7).contains(&rays.len()), "{wavelengths:?} {speeds:?}: {rays:?}");
            assert!(rays.windows(2).all(|pair| pair[1] > pair[0]));
        }
    }

    #[test]
    fn empty_windows_have_no_rays() {
        assert!(constant_frequency_rays((0.08, 0.02), (5.0, 60.0)).is_empty());
        assert!(constant_frequency_rays((0.0, 0.02), (5.0, 60.0)).is_empty());
        assert!(constant_frequency_rays((0.02, 0.08), (f64::NAN, 60.0)).is_empty());
    }

    #[test]
    fn rays_end_on_the_border() {
        let window = Window { wavelength_m: (0.02, 0.08), speed_m_per_s: (5.0, 60.0) };
        let [from, to] = window.ray(500.0).unwrap();
        assert_eq!((from, to), ((0.02, 10.0), (0.08, 40.0)));
        assert!(window.ray(1e5).is_none() && window.ray(f64::NAN).is_none() && window.ray(-1.0).is_none());
    }
}
