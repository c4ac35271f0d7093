//! Pits narrower than a wheel can follow.

use std::ops::Range;

use rayon::prelude::*;

use super::Profile;

/// Radius of the wheel that rolls over a profile \[m\], EN 15610:2009.
pub const WHEEL_RADIUS: f64 = 0.375;

/// Least height at which the wheel passes over a pit that is counted \[m\]: three
/// times the accuracy of 1 µm that Grassie, Saxon & Smith (1999) give for a good instrument.
pub const PIT_DEPTH: f64 = 3e-6;

/// Samples of a block: small enough for the nearest cache, and for the slope of the profile to matter
/// little.
const BLOCK: usize = 1024;

impl Profile {
    /// The height of a wheel's lowest point as it rolls over the profile, in place of the profile; returns
    /// the pits, in samples: where the wheel stays higher over the rail than `pit_depth` \[m\] wherever it
    /// stands.
    ///
    /// r′(ξ) = max over x of r(x) − (R − √(R² − (x − ξ)²)), EN 15610:2009 with R = 0.375 m
    /// ([`WHEEL_RADIUS`]). A smooth profile changes only where its slope or curvature is great: by Rs²/2 at
    /// slope s, not at all where |s| is below half a sample step over R.
    ///
    /// Method: a contact at distance d lifts the wheel only if the profile there is higher by more than
    /// d²/2R. In each block of 1024 samples this bounds d by the range of heights around it; within the
    /// bound every distance is tried, in vector instructions. Exact to rounding. Cost: blocks times
    /// bound, some nanoseconds a sample at 1 mm and 0.1 mm of range; parallel.
    pub fn roll_over(&mut self, radius: f64, pit_depth: f64) -> Vec<Range<usize>> {
        let spacing = self.spacing();
        let reach = ((radius / spacing) as usize).min(self.heights.len() - 1);
        // What the circle has risen at each distance.
        let rise: Vec<f64> = (0..=reach)
            .map(|step| {
                let distance = step as f64 * spacing;
                // R − √(R² − d²), without its cancellation.
                distance * distance / (radius + (radius * radius - distance * distance).max(0.0).sqrt())
            })
            .collect();
        let heights = &self.heights;
        let rolled: Vec<f64> = (0..heights.len().div_ceil(BLOCK))
            .into_par_iter()
            .flat_map_iter(|block| roll_block(heights, block * BLOCK, &rise))
            .collect();
        let lifted = rolled.iter().zip(heights).map(|(wheel, rail)| wheel - rail > pit_depth);
        let pits = runs(lifted)
            .into_par_iter()
            .flat_map_iter(|run| bridged(heights, &rolled, run, &rise, pit_depth))
            // At the ends the wheel stands on one side only.
            .filter(|pit| pit.start > 0 && pit.end < heights.len())
            .collect();
        self.heights = rolled;
        pits
    }
}

fn roll_block(heights: &[f64], start: usize, rise: &[f64]) -> Vec<f64> {
    let end = (start + BLOCK).min(heights.len());
    let mut rolled = heights[start..end].to_vec();
    let bound = bound(heights, start..end, rise);
    for (distance, rise) in rise.iter().enumerate().take(bound + 1).skip(1) {
        // The contact behind, then the contact ahead.
        let first = distance.saturating_sub(start);
        if first < rolled.len() {
            raise(&mut rolled[first..], &heights[start + first - distance..], *rise);
        }
        let ahead = (start + distance).min(heights.len());
        raise(&mut rolled, &heights[ahead..], *rise);
    }
    rolled
}

fn raise(rolled: &mut [f64], contact: &[f64], rise: f64) {
    for (rolled, contact) in rolled.iter_mut().zip(contact) {
        let candidate = contact - rise;
        *rolled = if candidate > *rolled { candidate } else { *rolled };
    }
}

/// Where within a run the wheel passes over the rail without coming nearer than the depth.
fn bridged(heights: &[f64], rolled: &[f64], run: Range<usize>, rise: &[f64], depth: f64) -> Vec<Range<usize>> {
    let around = run.start.saturating_sub(rise.len())..(run.end + rise.len()).min(rolled.len());
    let lowest = rolled[around].iter().copied().fold(f64::INFINITY, f64::min);
    let touched = |place: usize| {
        let level = heights[place] + depth;
        // A wheel further away stands higher over this place than any is low.
        let near = rise.iter().enumerate().take_while(|(_, rise)| lowest + **rise <= level);
        near.into_iter().any(|(distance, rise)| {
            let reaches = |wheel: Option<&f64>| wheel.is_some_and(|wheel| wheel + rise <= level);
            let behind = place.checked_sub(distance).and_then(|place| rolled.get(place));
            reaches(behind) || reaches(rolled.get(place + distance))
        })
    };
    let start = run.start;
    runs(run.map(|place| !touched(place))).into_iter().map(|pit| pit.start + start..pit.end + start).collect()
}

/// The greatest distance at which a contact may lift the wheel within the block.
fn bound(heights: &[f64], block: Range<usize>, rise: &[f64]) -> usize {
    let lowest = heights[block.clone()].iter().copied().fold(f64::INFINITY, f64::min);
    let mut bound = rise.len() - 1;
    loop {
        let around = block.start.saturating_sub(bound)..(block.end + bound).min(heights.len());
        let highest = heights[around].iter().copied().fold(lowest, f64::max);
        // Contacts beyond lie lower than the circle there, wherever in the block the wheel stands.
        let needed = rise.partition_point(|&rise| rise < highest - lowest);
        if needed >= bound {
            return bound;
        }
        bound = needed;
    }
}

/// Ranges of consecutive true values.
pub(super) fn runs(flags: impl Iterator<Item = bool>) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (index, _) in flags.enumerate().filter(|(_, flag)| *flag) {
        match runs.last_mut() {
            Some(run) if run.end == index => run.end += 1,
            _ => runs.push(index..index + 1),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;
    use proptest::prelude::*;

    /// The formula as printed, over all distances.
    fn as_printed(heights: &[f64], spacing: f64, radius: f64) -> Vec<f64> {
        let height = |at: usize| {
            heights.iter().enumerate().map(move |(index, height)| {
                let distance = at.abs_diff(index) as f64 * spacing;
                if distance > radius {
                    return f64::NEG_INFINITY;
                }
                height - (radius - (radius * radius - distance * distance).sqrt())
            })
        };
        (0..heights.len()).map(|at| height(at).fold(f64::NEG_INFINITY, f64::max)).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        /// Random profiles with slopes, steps and spikes up to a millimetre, over the ends of blocks.
        #[test]
        fn blocks_find_what_the_formula_says(
            heights in prop::collection::vec(-1e-3..1e-3f64, 2..1400),
            slope in -0.3..0.3f64,
            quiet in 0.0..1.0f64,
        ) {
            let heights: Vec<f64> = heights
                .iter()
                .enumerate()
                .map(|(index, height)| quiet.powi(4) * height + slope * 1e-3 * index as f64)
                .collect();
            let expected = as_printed(&heights, 1e-3, WHEEL_RADIUS);
            let mut profile = Profile::new(0.0, 1e-3, heights).unwrap();
            profile.roll_over(WHEEL_RADIUS, PIT_DEPTH);
            for (found, expected) in profile.heights().iter().zip(&expected) {
                // The printed root cancels: 1e-16 of R.
                prop_assert!((found - expected).abs() < 1e-15);
            }
        }
    }

    /// A step in the next block lifts the wheel already over the flat rail before it.
    #[test]
    fn a_step_lifts_the_wheel_from_afar() -> Result<(), Error> {
        let mut heights = vec![0.0; 2 * BLOCK];
        heights[BLOCK + 10..].fill(1e-3);
        let expected = as_printed(&heights, 1e-3, WHEEL_RADIUS);
        let mut profile = Profile::new(0.0, 1e-3, heights)?;
        profile.roll_over(WHEEL_RADIUS, PIT_DEPTH);
        for (found, expected) in profile.heights().iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-15);
        }
        // 11 mm before it: 1 mm − d²/2R.
        assert!((profile.heights()[BLOCK - 1] - (1e-3 - 0.011f64.powi(2) / 0.75)).abs() < 1e-7);
        Ok(())
    }

    /// A pit 100 µm deep and 10 mm wide becomes the sag of the wheel across it, w²/8R.
    #[test]
    fn a_pit_is_bridged_by_the_wheel() -> Result<(), Error> {
        let mut heights = vec![0.0; 4000];
        heights[2001..2010].fill(-100e-6);
        let mut profile = Profile::new(0.0, 1e-3, heights)?;
        let pits = profile.roll_over(WHEEL_RADIUS, PIT_DEPTH);
        assert_eq!(pits.len(), 1);
        assert_eq!(pits[0], 2001..2010);
        let sag = 0.010f64.powi(2) / (8.0 * WHEEL_RADIUS);
        let deepest = profile.heights().iter().copied().fold(0.0, f64::min);
        // The wheel rests on both edges, 5 mm from the middle.
        assert!((deepest + sag).abs() < 1e-8, "{deepest} {sag}");
        Ok(())
    }

    #[test]
    fn a_wave_that_the_wheel_can_follow_stays() -> Result<(), Error> {
        // Slope Ak below half a step over R, 1.3e-3.
        let phase = |i: usize| std::f64::consts::TAU * i as f64 * 1e-3 / 0.0316;
        let heights: Vec<f64> = (0..4000).map(|i| 5e-6 * phase(i).sin()).collect();
        let mut profile = Profile::new(0.0, 1e-3, heights.clone())?;
        assert_eq!(profile.roll_over(WHEEL_RADIUS, PIT_DEPTH), []);
        assert_eq!(profile.heights(), heights);
        Ok(())
    }

    /// Steep corrugation lifts the middle of the wheel by Rs²/2 = 1.04 µm, but the wheel touches all of it.
    #[test]
    fn a_steep_wave_has_no_pits() -> Result<(), Error> {
        let phase = |i: usize| std::f64::consts::TAU * i as f64 * 1e-3 / 0.04;
        let heights: Vec<f64> = (0..4000).map(|i| 15e-6 * phase(i).sin()).collect();
        let mut profile = Profile::new(0.0, 1e-3, heights.clone())?;
        assert_eq!(profile.roll_over(WHEEL_RADIUS, PIT_DEPTH), []);
        let lifted = profile.heights().iter().zip(&heights);
        assert!(lifted.map(|(wheel, rail)| wheel - rail).fold(0.0, f64::max) > 1e-6);
        Ok(())
    }
}
