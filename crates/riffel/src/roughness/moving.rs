//! Statistics over a window that moves along the profile.

/// Windows whose sums are kept together: what adds up in them stays small.
const CHUNK: usize = 1 << 14;

/// Root mean square of each window of `window` consecutive values; `values.len() − window + 1` of them,
/// none if the window is empty or longer than the values.
///
/// Method: sums of squares from the beginning of every 16384 windows. Relative error of a mean square
/// below 1e-12 of the largest in its chunk. Cost: two additions and a root for each value.
pub fn moving_rms(values: &[f64], window: usize) -> Vec<f64> {
    let Some(windows) = count(values, window) else {
        return Vec::new();
    };
    let mut moving = Vec::with_capacity(windows);
    let mut sums = Vec::with_capacity(CHUNK + window);
    for start in (0..windows).step_by(CHUNK) {
        let end = (start + CHUNK).min(windows);
        sums.clear();
        sums.push(0.0);
        let mut sum = 0.0;
        for value in &values[start..end + window - 1] {
            sum += value * value;
            sums.push(sum);
        }
        moving.extend(
            sums[window..]
                .iter()
                .zip(&sums)
                .map(|(to, from)| ((to - from).max(0.0) / window as f64).sqrt()),
        );
    }
    moving
}

/// Largest less smallest value of each window of `window` consecutive values; as many as
/// [`moving_rms`] gives.
///
/// Method: van Herk, Pattern Recognition Letters 13 (1992) 517, and Gil & Werman (1993): extremes from
/// the beginning and from the end of each stretch of one window, joined where a window straddles two.
/// Exact. Cost: six comparisons for each value, whatever the window.
pub fn moving_peak_to_peak(values: &[f64], window: usize) -> Vec<f64> {
    let Some(windows) = count(values, window) else {
        return Vec::new();
    };
    let mut moving = Vec::with_capacity(windows);
    // Extremes from each place of a stretch to its end.
    let mut tails = vec![(0.0, 0.0); window];
    for stretch in (0..windows).step_by(window) {
        let mut tail = (f64::INFINITY, f64::NEG_INFINITY);
        for (tails, &value) in tails
            .iter_mut()
            .zip(&values[stretch..stretch + window])
            .rev()
        {
            tail = with(tail, value);
            *tails = tail;
        }
        let mut head = (f64::INFINITY, f64::NEG_INFINITY);
        let next = values[stretch + window..].iter();
        moving.push(tails[0].1 - tails[0].0);
        for (&tail, &value) in tails[1..].iter().zip(next) {
            head = with(head, value);
            let (low, high) = with(with(tail, head.0), head.1);
            moving.push(high - low);
        }
    }
    moving.truncate(windows);
    moving
}

fn count(values: &[f64], window: usize) -> Option<usize> {
    let windows = (values.len() + 1).checked_sub(window)?;
    (window > 0 && windows > 0).then_some(windows)
}

/// Smallest and largest with one more value.
fn with((low, high): (f64, f64), value: f64) -> (f64, f64) {
    (
        if value < low { value } else { low },
        if value > high { value } else { high },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn moving_statistics_are_those_of_two_loops(
            values in prop::collection::vec(-1e-4..1e-4f64, 0..300),
            window in 0..80usize,
        ) {
            let rms = moving_rms(&values, window);
            let peaks = moving_peak_to_peak(&values, window);
            let windows: Vec<&[f64]> = match window {
                0 => Vec::new(),
                _ => values.windows(window).collect(),
            };
            prop_assert_eq!(rms.len(), windows.len());
            prop_assert_eq!(peaks.len(), windows.len());
            for ((rms, peak), window) in rms.iter().zip(&peaks).zip(windows) {
                let mut square = 0.0;
                let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
                for &value in window {
                    square += value * value;
                    low = low.min(value);
                    high = high.max(value);
                }
                // Rounding of sums of 300 squares of 1e-8.
                prop_assert!((rms * rms - square / window.len() as f64).abs() < 1e-20);
                prop_assert_eq!(*peak, high - low);
            }
        }
    }

    /// Sums begin anew, so that what lies behind leaves no trace.
    #[test]
    fn a_large_beginning_leaves_no_trace() {
        let mut values = vec![1e-6; 3 * CHUNK];
        values[..100].fill(1.0);
        let moving = moving_rms(&values, 10);
        assert!((moving[2 * CHUNK] / 1e-6 - 1.0).abs() < 1e-9);
    }
}
