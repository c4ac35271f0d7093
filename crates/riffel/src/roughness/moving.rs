//! Statistics over a window that moves along the profile.

/// Windows whose sums follow from one another: few enough for rounding not to add up.
const CHUNK: usize = 1 << 14;

/// Chunks whose sums run side by side.
const ABREAST: usize = 4;

/// Values of a cell whose extremes stand for them in the search of the largest peak-to-peak value.
const CELL: usize = 64;

/// Root mean square of each window of `window` consecutive values; `values.len() − window + 1` of them,
/// none if the window is empty or longer than the values.
///
/// Method: from one window to the next one square comes and one goes; every 16384 windows the sum is made
/// anew. Relative error of a mean square below 4e-12 of the largest among these. Cost: an addition for each
/// value, and a root.
pub fn moving_rms(values: &[f64], window: usize) -> Vec<f64> {
    let mut moving = Vec::with_capacity(count(values, window).unwrap_or(0));
    moving_mean_squares(values, window, |_, squares| {
        moving.extend(squares.iter().map(|square| square.sqrt()));
    });
    moving
}

/// Tell `visit` the mean squares of consecutive windows, some thousand at a time, with the index of the
/// first value of the first window.
///
/// The sums of several chunks run side by side, since each waits for the one before it in its chunk.
pub(super) fn moving_mean_squares(values: &[f64], window: usize, mut visit: impl FnMut(usize, &[f64])) {
    let windows = count(values, window).unwrap_or(0);
    let mut rows = [const { Vec::new() }; ABREAST];
    for start in (0..windows).step_by(ABREAST * CHUNK) {
        let whole = windows - start >= ABREAST * CHUNK;
        if whole {
            let chunks = std::array::from_fn(|chunk| &values[start + chunk * CHUNK..][..CHUNK + window - 1]);
            mean_squares(chunks, window, &mut rows);
            for (chunk, squares) in rows.iter().enumerate() {
                visit(start + chunk * CHUNK, squares);
            }
            continue;
        }
        for start in (start..windows).step_by(CHUNK) {
            let end = (start + CHUNK).min(windows) + window - 1;
            let [row, ..] = &mut rows;
            mean_squares([&values[start..end]], window, std::array::from_mut(row));
            visit(start, row);
        }
    }
}

/// Mean squares of all windows of some chunks of one length.
fn mean_squares<const N: usize>(chunks: [&[f64]; N], window: usize, rows: &mut [Vec<f64>; N]) {
    let scale = (window as f64).recip();
    let mut sums = chunks.map(|chunk| chunk[..window].iter().map(|value| value * value).sum::<f64>());
    let windows = chunks.map(|chunk| chunk.len() + 1 - window)[0];
    let gone = chunks.map(|chunk| &chunk[..windows - 1]);
    let come = chunks.map(|chunk| &chunk[window..][..windows - 1]);
    let mut slots = rows.each_mut().map(|row| {
        row.resize(windows, 0.0);
        &mut row[..windows]
    });
    for (slots, sum) in slots.iter_mut().zip(sums) {
        slots[0] = scale * sum;
    }
    for index in 0..windows - 1 {
        for chunk in 0..N {
            let (gone, come) = (gone[chunk][index], come[chunk][index]);
            sums[chunk] += come * come - gone * gone;
            slots[chunk][index + 1] = scale * sums[chunk].max(0.0);
        }
    }
}

/// Largest less smallest value of each window of `window` consecutive values; as many as
/// [`moving_rms`] gives.
///
/// Method: van Herk, Pattern Recognition Letters 13 (1992) 517, and Gil & Werman (1993): extremes from
/// the beginning and from the end of each stretch of one window, joined where a window straddles two.
/// Exact. Cost: six comparisons for each value, whatever the window.
pub fn moving_peak_to_peak(values: &[f64], window: usize) -> Vec<f64> {
    moving_range(values, window, |value| (value, value))
}

/// The largest of [`moving_peak_to_peak`]; zero without a window.
///
/// Method: the extremes of cells of 64 values bound from both sides what a window may find; only windows
/// that may exceed the best so far are looked at. Exact. Cost: two comparisons for each value, and few
/// windows more unless the roughness grows steadily.
pub fn largest_peak_to_peak(values: &[f64], window: usize) -> f64 {
    let Some(windows) = count(values, window) else {
        return 0.0;
    };
    let cells: Vec<(f64, f64)> = values.chunks(CELL).map(extremes).collect();
    // Windows that begin in one cell reach into so many.
    let reached = (window + CELL - 2) / CELL + 1;
    // Beyond the last cell there is nothing.
    let mut padded = cells.clone();
    padded.resize(windows.div_ceil(CELL) + reached - 1, NOTHING);
    let bounds = moving_range(&padded, reached, |cell| cell);
    // Whole cells that one window holds; the last cell is whole or the end of the last window.
    let within = moving_range(&cells, window / CELL, |cell| cell);
    let mut best = within.into_iter().fold(0.0, f64::max);
    let mut cell = 0;
    while cell < bounds.len() {
        let run = bounds[cell..].iter().take_while(|bound| **bound > best).count();
        if run > 0 {
            let end = ((cell + run) * CELL).min(windows) + window - 1;
            let found = moving_peak_to_peak(&values[cell * CELL..end], window);
            best = found.into_iter().fold(best, f64::max);
        }
        cell += run + 1;
    }
    best
}

/// Extremes of no values.
const NOTHING: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// Smallest and largest of some values.
fn extremes(values: &[f64]) -> (f64, f64) {
    values.iter().fold(NOTHING, |so_far, &value| joined(so_far, (value, value)))
}

/// Largest less smallest of each window of values or of ranges of values.
fn moving_range<T: Copy>(values: &[T], window: usize, range: impl Fn(T) -> (f64, f64)) -> Vec<f64> {
    let Some(windows) = count(values, window) else {
        return Vec::new();
    };
    let mut moving = Vec::with_capacity(windows);
    // Extremes from each place of a stretch to its end.
    let mut tails = vec![NOTHING; window];
    for stretch in (0..windows).step_by(window) {
        let mut tail = NOTHING;
        for (tails, &value) in tails.iter_mut().zip(&values[stretch..stretch + window]).rev() {
            tail = joined(tail, range(value));
            *tails = tail;
        }
        let mut head = NOTHING;
        let next = values[stretch + window..].iter();
        moving.push(tails[0].1 - tails[0].0);
        for (&tail, &value) in tails[1..].iter().zip(next) {
            head = joined(head, range(value));
            let (low, high) = joined(tail, head);
            moving.push(high - low);
        }
    }
    moving.truncate(windows);
    moving
}

fn count<T>(values: &[T], window: usize) -> Option<usize> {
    let windows = (values.len() + 1).checked_sub(window)?;
    (window > 0 && windows > 0).then_some(windows)
}

/// Smallest and largest of two ranges.
fn joined((low, high): (f64, f64), (lower, higher): (f64, f64)) -> (f64, f64) {
    (if lower < low { lower } else { low }, if higher > high { higher } else { high })
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
            let largest = peaks.iter().copied().fold(0.0, f64::max);
            prop_assert_eq!(largest_peak_to_peak(&values, window), largest);
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

    proptest! {
        /// Windows of several cells, of noise whose size changes.
        #[test]
        fn the_largest_peak_to_peak_value_is_the_largest_of_all(
            noise in prop::collection::vec(-1.0..1.0f64, 1..3000),
            growth in -3.0..3.0f64,
            window in 1..1500usize,
        ) {
            let values: Vec<f64> = noise
                .iter()
                .enumerate()
                .map(|(index, value)| value * (1e-3 * growth * index as f64).exp())
                .collect();
            let all = moving_peak_to_peak(&values, window);
            let largest = all.into_iter().fold(0.0, f64::max);
            prop_assert_eq!(largest_peak_to_peak(&values, window), largest);
        }
    }

    /// Sums begin anew, so that what lies behind leaves no trace.
    #[test]
    fn a_large_beginning_leaves_no_trace() {
        let mut values = vec![1e-6; 6 * CHUNK];
        values[..100].fill(1.0);
        let moving = moving_rms(&values, 10);
        assert_eq!(moving.len(), 6 * CHUNK - 9);
        assert!(moving[CHUNK..].iter().all(|rms| (rms / 1e-6 - 1.0).abs() < 1e-9));
    }
}
