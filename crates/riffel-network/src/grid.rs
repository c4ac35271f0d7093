//! Blocks of any length on cells of one length.

use std::collections::VecDeque;

use crate::survey_file::FARTHEST_BACK;

/// A rail on the grid, as blocks come along it.
///
/// Method: the mean square of a cell is that of the blocks over it, weighted with the length they share; a cell counts where
/// half of it or more is known. Energy is kept where blocks are shorter than cells; a block that is longer has its level in
/// each cell of it. Blocks of a long kilometre go back, and what lies over a cell twice counts twice. Memory: the chunks that a block
/// may go back to, and one more.
#[derive(Debug)]
pub(crate) struct Gridded {
    /// Where cell 0 begins \[m\].
    start: f64,
    /// Length of a cell \[m\].
    resolution: f64,
    rows: usize,
    bands: usize,
    /// The first chunk that is held.
    chunk: u64,
    /// Sum of mean square times length \[m² m\], and length \[m\], of each cell and band, chunk by chunk.
    held: VecDeque<Vec<(f64, f64)>>,
    /// Cells known so far, in one band or more.
    pub(crate) measured: u64,
}

impl Gridded {
    pub(crate) fn new(start: f64, resolution: f64, rows: usize, bands: usize) -> Self {
        Self { start, resolution, rows, bands, chunk: 0, held: VecDeque::new(), measured: 0 }
    }

    /// Add a block behind those before, or as far before them as places go back; chunks that no block goes back to are handed out with
    /// their number.
    pub(crate) fn add<E>(
        &mut self,
        from: f64,
        to: f64,
        rms: &[f64],
        mut whole: impl FnMut(u64, Vec<f64>) -> Result<(), E>,
    ) -> Result<(), E> {
        // Ends on the edge of a cell but for rounding are on it.
        let cell = |place: f64| (place - self.start) / self.resolution;
        let (first, last) = ((cell(from) + 1e-6).floor().max(0.0), (cell(to) - 1e-6).ceil());
        let mut index = first as u64;
        let back = FARTHEST_BACK / self.resolution;
        while (index as f64) < last {
            let kept = (index as f64 - back).max(0.0) / self.rows as f64;
            while self.chunk < kept as u64 {
                self.hand_out(&mut whole)?;
            }
            let begins = self.start + index as f64 * self.resolution;
            let length = to.min(begins + self.resolution) - from.max(begins);
            let chunk = (index / self.rows as u64).checked_sub(self.chunk);
            if let Some(chunk) = chunk.filter(|_| length > 0.0) {
                let held = (self.held.len() as u64).max(chunk + 1);
                self.held.resize(held as usize, vec![(0.0, 0.0); self.rows * self.bands]);
                let row = (index % self.rows as u64) as usize * self.bands;
                for (sum, &rms) in self.held[chunk as usize][row..].iter_mut().zip(rms) {
                    if rms.is_finite() {
                        sum.0 += rms * rms * length;
                        sum.1 += length;
                    }
                }
            }
            index += 1;
        }
        Ok(())
    }

    /// The last chunks.
    pub(crate) fn finish<E>(&mut self, mut whole: impl FnMut(u64, Vec<f64>) -> Result<(), E>) -> Result<(), E> {
        while !self.held.is_empty() {
            self.hand_out(&mut whole)?;
        }
        Ok(())
    }

    fn hand_out<E>(&mut self, whole: &mut impl FnMut(u64, Vec<f64>) -> Result<(), E>) -> Result<(), E> {
        let enough = 0.5 * self.resolution * (1.0 - 1e-9);
        let sums = self.held.pop_front().unwrap_or_default();
        let values: Vec<f64> = sums
            .iter()
            .map(|&(square, length)| match length >= enough {
                true => (square / length).sqrt(),
                false => f64::NAN,
            })
            .collect();
        let known = values.chunks(self.bands);
        let known = known.filter(|row| row.iter().any(|value| value.is_finite()));
        let known = known.count() as u64;
        self.measured += known;
        let chunk = self.chunk;
        self.chunk += 1;
        match known {
            // What is not written is missing.
            0 => Ok(()),
            _ => whole(chunk, values),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;

    fn gridded(blocks: &[(f64, f64, f64)]) -> Vec<(u64, Vec<f64>)> {
        let mut grid = Gridded::new(100.0, 2.0, 4, 1);
        let mut chunks = Vec::new();
        let mut keep = |chunk: u64, values: Vec<f64>| {
            chunks.push((chunk, values));
            Ok::<(), Infallible>(())
        };
        for &(from, to, rms) in blocks {
            grid.add(from, to, &[rms], &mut keep).unwrap();
        }
        grid.finish(&mut keep).unwrap();
        chunks
    }

    #[test]
    fn short_blocks_keep_their_energy_and_long_ones_their_level() {
        // 1 m of 3 and 1 m of 4: 12.5; then 5 m of 2 over two cells and a half.
        let chunks = gridded(&[(100.0, 101.0, 3.0), (101.0, 102.0, 4.0), (102.0, 107.0, 2.0)]);
        let (number, values) = &chunks[0];
        assert_eq!(*number, 0);
        assert!((values[0] - 12.5f64.sqrt()).abs() < 1e-12);
        assert_eq!(values[1..], [2.0, 2.0, 2.0]);
        assert_eq!(chunks.len(), 1);
    }

    /// A long kilometre: from 108 m back to 104 m, where both stretches lie, and by more than a chunk.
    #[test]
    fn where_two_stretches_lie_is_their_mean() {
        let chunks = gridded(&[
            (100.0, 104.0, 1.0),
            (104.0, 108.0, 3.0),
            (104.0, 108.0, 4.0),
            (108.0, 126.0, 2.0),
            (102.0, 104.0, 7.0),
        ]);
        assert_eq!(chunks.len(), 4);
        let mean = 12.5f64.sqrt();
        for (value, right) in chunks[0].1.iter().zip([1.0, 5.0, mean, mean]) {
            assert!((value - right).abs() < 1e-12, "{chunks:?}");
        }
    }

    #[test]
    fn what_is_known_to_less_than_half_is_missing() {
        let chunks = gridded(&[(100.0, 100.9, 3.0), (124.0, 126.0, 1.0)]);
        // Chunk 0 knows nothing and is not there, nor are the ones up to 120 m.
        assert_eq!(chunks.len(), 1);
        assert_eq!(chunks[0].0, 3);
        assert_eq!(chunks[0].1[0], 1.0);
        assert!(chunks[0].1[1].is_nan());
    }
}
