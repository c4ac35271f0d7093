//! Narrow upward spikes: dirt on the rail, not its shape.

use std::ops::Range;

use super::Profile;

/// What is a spike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpikeCriterion {
    /// Second derivative below which a peak is looked at \[1/m\].
    pub curvature: f64,
    /// Slope below which the edge of a spike is reached \[-\].
    pub edge_slope: f64,
    /// Length a \[m\]: a peak of height h and width w is a spike if h > w²/a.
    pub length: f64,
}

impl SpikeCriterion {
    /// EN 15610:2009: −10⁷ µm/m², 5·10³ µm/m, 3 m.
    pub const EN_15610: Self = Self { curvature: -10.0, edge_slope: 5e-3, length: 3.0 };
}

impl Profile {
    /// Replace every spike by a straight line between its edges; returns where, in samples, edges
    /// included, spikes that overlap as one.
    ///
    /// A peak whose slope changes sign and whose second difference is below the curvature of the
    /// criterion is followed down both sides until the slope is slight. Its height h is that over the
    /// line between these edges, its width w their distance; it is a spike if h > w²/a. Removal is
    /// repeated until no spike is left. Source: EN 15610:2009. A top of equal samples, as a sensor at its
    /// end leaves, counts as one peak. Cost: one pass, some two nanoseconds a sample.
    pub fn remove_spikes(&mut self, criterion: SpikeCriterion) -> Vec<Range<usize>> {
        let spacing = self.spacing();
        let bend = criterion.curvature * spacing * spacing;
        let slight = criterion.edge_slope * spacing;
        let heights = &mut self.heights;
        let mut removed: Vec<Range<usize>> = Vec::new();
        let mut index = 1;
        while index + 1 < heights.len() {
            let spike = Peak::at(heights, index, bend).map(|peak| peak.sides(heights, slight)).filter(|spike| {
                let width = (spike.end - 1 - spike.start) as f64 * spacing;
                height(heights, spike, index) > width * width / criterion.length
            });
            match spike {
                None => index += 1,
                Some(spike) => {
                    flatten(&mut heights[spike.clone()]);
                    // What was beside the spike may now be a peak itself.
                    index = spike.start.saturating_sub(1).max(1);
                    removed.push(spike);
                }
            }
        }
        merged(removed)
    }
}

/// First and last sample of a top whose samples are equal.
struct Peak {
    first: usize,
    last: usize,
}

impl Peak {
    /// The peak that begins here, if the profile bends down enough.
    fn at(heights: &[f64], first: usize, bend: f64) -> Option<Self> {
        let rise = heights[first] - heights[first - 1];
        let next = heights[first + 1] - heights[first];
        if rise <= 0.0 || next > 0.0 {
            return None;
        }
        let mut last = first;
        while last + 1 < heights.len() && heights[last + 1] == heights[first] {
            last += 1;
        }
        let fall = heights.get(last + 1)? - heights[last];
        (fall < 0.0 && fall - rise < bend).then_some(Self { first, last })
    }

    /// The peak with its sides, down to where they are no longer steep.
    fn sides(&self, heights: &[f64], slight: f64) -> Range<usize> {
        let (mut start, mut end) = (self.first, self.last);
        while start > 0 && heights[start] - heights[start - 1] >= slight {
            start -= 1;
        }
        while end + 1 < heights.len() && heights[end] - heights[end + 1] >= slight {
            end += 1;
        }
        start..end + 1
    }
}

/// Height of a sample above the straight line between the edges.
fn height(heights: &[f64], spike: &Range<usize>, top: usize) -> f64 {
    let last = spike.end - 1;
    if last == spike.start {
        return 0.0;
    }
    let share = (top - spike.start) as f64 / (last - spike.start) as f64;
    heights[top] - (heights[spike.start] + share * (heights[last] - heights[spike.start]))
}

/// A straight line from the first sample to the last.
fn flatten(heights: &mut [f64]) {
    let last = heights.len() - 1;
    let (from, to) = (heights[0], heights[last]);
    for (index, height) in heights.iter_mut().enumerate().take(last).skip(1) {
        *height = from + index as f64 / last as f64 * (to - from);
    }
}

/// Ranges in order, those that overlap as one.
fn merged(mut ranges: Vec<Range<usize>>) -> Vec<Range<usize>> {
    ranges.sort_by_key(|range| range.start);
    let mut merged: Vec<Range<usize>> = Vec::new();
    for range in ranges {
        match merged.last_mut() {
            // An edge that two share is one sample.
            Some(before) if range.start + 1 < before.end => before.end = before.end.max(range.end),
            _ => merged.push(range),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;

    fn wave(amplitude: f64, wavelength: f64) -> Vec<f64> {
        let phase = |i: usize| std::f64::consts::TAU * i as f64 * 1e-3 / wavelength;
        (0..4000).map(|i| amplitude * phase(i).sin()).collect()
    }

    /// Triangles of 40 µm over 3 mm to either side, single samples, and a flat top of 2 mm.
    #[test]
    fn spikes_go_and_leave_the_profile_around_them() -> Result<(), Error> {
        let clean = wave(3e-6, 0.05);
        let mut dirty = clean.clone();
        for (at, height, half_width) in [(500, 40e-6, 3), (1500, 500e-6, 1), (2500, 20e-6, 1)] {
            for side in -half_width..=half_width {
                let share = 1.0 - f64::from(i32::abs(side)) / f64::from(half_width);
                dirty[(at + side) as usize] += height * share;
            }
        }
        let top = dirty[3200];
        (3200..3202).for_each(|index| dirty[index] = top + 30e-6);
        let mut profile = Profile::new(0.0, 1e-3, dirty)?;
        let removed = profile.remove_spikes(SpikeCriterion::EN_15610);
        assert_eq!(removed.len(), 4, "{removed:?}");
        // A straight line over 6 mm of a wave of 50 mm: A (k w)²/8 = 0.21 µm.
        for (found, expected) in profile.heights().iter().zip(&clean) {
            assert!((found - expected).abs() < 0.25e-6);
        }
        Ok(())
    }

    #[test]
    fn waves_steps_and_pits_are_no_spikes() -> Result<(), Error> {
        let mut step = vec![0.0; 4000];
        step[2000..].fill(50e-6);
        let mut pit = vec![0.0; 4000];
        pit[2000..2005].fill(-50e-6);
        for heights in [wave(3e-6, 0.01), wave(50e-6, 0.05), step, pit] {
            let mut profile = Profile::new(0.0, 1e-3, heights.clone())?;
            assert_eq!(profile.remove_spikes(SpikeCriterion::EN_15610), []);
            assert_eq!(profile.heights(), heights);
        }
        Ok(())
    }

    /// A height just below w²/a stays, one just above goes.
    #[test]
    fn the_criterion_divides_where_it_says() -> Result<(), Error> {
        // A triangle of 4 mm: w²/a = 5.33 µm; its slope must be steep enough to be followed.
        for (height, count) in [(5.2e-6, 0), (5.5e-6, 1)] {
            let mut heights = vec![0.0; 100];
            // One side sudden, so that the bend is sharp.
            heights[50] = 2.0 * height;
            heights[49] = height;
            heights[51] = height;
            let mut profile = Profile::new(0.0, 1e-3, heights)?;
            // Height 2h over width 4 mm.
            let removed = profile.remove_spikes(SpikeCriterion { length: 1.5, ..SpikeCriterion::EN_15610 });
            assert_eq!(removed.len(), count, "{height}");
        }
        Ok(())
    }
}
