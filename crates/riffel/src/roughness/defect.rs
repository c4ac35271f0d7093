//! Single defects of a rail: welds, joints and squats.

use std::collections::VecDeque;
use std::ops::Range;

use super::{BandPass, Profile, WavelengthBand};

/// Wavelengths between which a defect may stand out \[m\]: all, and parts of them, so that corrugation in one hides no weld in
/// another.
const BANDS: [(f64, f64); 4] = [(0.02, 1.0), (0.02, 0.06), (0.06, 0.2), (0.2, 1.0)];
/// How far around it a defect is compared with the rail \[m\].
const NEIGHBOURS: f64 = 15.0;
/// Standard deviations of the rail around it above which a height is no chance: once in a billion.
const OUTSTANDING: f64 = 6.0;
/// Standard deviations of the rail around it down to which a defect reaches.
const REACHES: f64 = 2.5;
/// Length of calm rail at which it ends \[m\].
const CALM: f64 = 0.1;
/// Length beside a defect in which parts of the wavelengths show the same, and its filters ring \[m\].
const APART: f64 = 0.5;
/// Share of a neighbour's height below which a defect is the ringing of its filter, and that for one within the length of the
/// longest defect.
const RINGING: f64 = 0.1;
const FAR_RINGING: f64 = 0.05;
/// Share of its own height at which a defect ends on a rail so smooth that ringing stands out of it for metres.
const SLIGHT_RINGING: f64 = 0.02;
/// Longest defect \[m\]: a dipped weld has a metre or two.
const LONGEST: f64 = 3.0;
/// Most turns of half its height that a defect has; a wave has more.
const MOST_TURNS: usize = 4;
/// Length from which a defect is a weld or a joint, and below which a squat \[m\] (UIC 712: a squat spreads over some
/// centimetres).
const SHORTEST_WELD: f64 = 0.15;

/// A place where a rail departs from its own roughness once, and not in waves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailDefect {
    /// Where it begins \[m\].
    pub from: f64,
    /// Where it ends \[m\].
    pub to: f64,
    /// Length of it that stands out with all wavelengths together \[m\].
    pub length: f64,
    /// Largest height over the line from its beginning to its end \[m\]; negative for a dip.
    pub height: f64,
}

impl RailDefect {
    /// Whether it is as short as a squat; else it is a weld or a joint.
    pub fn is_short(&self) -> bool {
        self.length < SHORTEST_WELD
    }
}

impl Profile {
    /// Replace every single defect by a straight line between its ends; returns what was replaced, in order.
    ///
    /// A defect is what stands six standard deviations out of the rail 15 m to either side, between wavelengths of 20 mm
    /// and 1 m or in one of three parts of these, is no longer than 3 m and has no more than four turns of half its height: waves
    /// have more. The standard deviation is that of the median, which defects of a tenth of the rail do not move; a squat as long
    /// as the waves of strong corrugation does not stand out. It reaches from its top to where the rail is calm, or to a fiftieth of its
    /// height: beyond, the filter rings, and what stands less than a tenth as high within half a metre of another defect, or a
    /// twentieth within 3 m, is ringing too. None are found where heights are more than 8 mm apart or the profile
    /// is shorter than 4 m. Of a rail that was felt at some wavelengths only, these are looked at, and parts of an octave or more:
    /// what leaks in from others comes and goes with the speed. Cost: four band-passes.
    pub fn bridge_defects(&mut self, known_band: Option<WavelengthBand>) -> Vec<RailDefect> {
        let spacing = self.spacing();
        let ends = known_band.map_or((0.0, f64::INFINITY), |known_band| (known_band.from(), known_band.to()));
        let bands = BANDS.map(|(from, to)| (from.max(ends.0), to.min(ends.1)));
        let bands = bands.into_iter().filter(|(from, to)| 2.0 * from <= *to);
        let bands = bands.flat_map(|(from, to)| WavelengthBand::new(from, to));
        let bands: Vec<_> = bands.filter(|band| band.fits_into(self.length())).collect();
        let Ok(bank) = BandPass::new(spacing, self.heights.len(), &bands) else {
            return Vec::new();
        };
        let filtered = bank.filter(self);
        let Some(all) = filtered.first().map(|waves| Waves::new(waves, spacing)) else {
            return Vec::new();
        };
        // What stands out with all wavelengths together, all that is bridged of it, and the wavelengths that show it.
        let mut places: Vec<([Range<usize>; 2], usize)> =
            all.outstanding().into_iter().map(|place| ([place.clone(), place], 0)).collect();
        let (apart, longest) = ((APART / spacing) as usize, (LONGEST / spacing) as usize);
        let beside =
            |one: &Range<usize>, other: &Range<usize>| one.start < other.end + apart && other.start < one.end + apart;
        for (band, waves) in filtered.iter().enumerate().skip(1) {
            for place in Waves::new(waves, spacing).outstanding() {
                match places.iter_mut().find(|(known, _)| beside(&known[1], &place)) {
                    Some(([_, known], _)) => {
                        let both = known.start.min(place.start)..known.end.max(place.end);
                        if both.len() <= longest {
                            *known = both;
                        }
                    }
                    // The ends of a patch of waves stand out of the longer wavelengths.
                    None if all.is_single(&all.around(all.top(&place))) => {
                        places.push(([place.clone(), place], band));
                    }
                    None => {}
                }
            }
        }
        let height_in = |band: usize, place: &Range<usize>| {
            let heights = filtered[band][place.clone()].iter();
            heights.fold(0.0f64, |most, height| most.max(height.abs()))
        };
        let height = |place: &Range<usize>| height_in(0, place);
        let rings = |([_, place], band): &([Range<usize>; 2], usize)| {
            let mut others = places.iter();
            others.any(|([_, other], _)| {
                let near = place.start < other.end + longest && other.start < place.end + longest;
                let share = || height_in(*band, place) / height_in(*band, other);
                // Of thousands of defects a few are near: the heights of the others are not looked at.
                near && share() < if beside(place, other) { RINGING } else { FAR_RINGING }
            })
        };
        let single = places.iter().filter(|place| !rings(place));
        let mut single: Vec<[Range<usize>; 2]> = single.map(|(place, _)| place.clone()).collect();
        single.sort_by_key(|[_, place]| place.start);
        // What two parts of the wavelengths show at one place is one defect.
        single.dedup_by(|[next_own, next], [own, place]| {
            let both = place.start..place.end.max(next.end);
            let one = next.start < place.end || beside(place, next) && both.len() <= longest;
            if one {
                if height(next) > height(place) {
                    *own = next_own.clone();
                }
                *place = both;
            }
            one
        });
        single
            .into_iter()
            .map(|[own, place]| RailDefect { length: own.len() as f64 * spacing, ..self.bridge(place) })
            .collect()
    }

    /// Replace the heights between two positions \[m\] by a straight line.
    pub(crate) fn bridge_between(&mut self, from: f64, to: f64) {
        let sample = |position: f64| {
            let index = ((position - self.start()) / self.spacing()).round().max(0.0) as usize;
            index.min(self.heights.len() - 1)
        };
        let (first, last) = (sample(from), sample(to));
        self.bridge(first..last + 1);
    }

    /// Replace some samples by a straight line.
    fn bridge(&mut self, samples: Range<usize>) -> RailDefect {
        let (first, last) = (samples.start, samples.end - 1);
        let (left, right) = (self.heights[first], self.heights[last]);
        let mut height = 0.0f64;
        for index in samples.clone() {
            let share = (index - first) as f64 / (last - first).max(1) as f64;
            let line = left + share * (right - left);
            let over = self.heights[index] - line;
            if over.abs() > height.abs() {
                height = over;
            }
            self.heights[index] = line;
        }
        RailDefect {
            from: self.position(first),
            to: self.position(last),
            length: self.position(last) - self.position(first),
            height,
        }
    }
}

/// Filtered heights with how far the rail around them scatters.
struct Waves<'a> {
    heights: &'a [f64],
    spacing: f64,
    deviations: Vec<f64>,
}

impl<'a> Waves<'a> {
    fn new(heights: &'a [f64], spacing: f64) -> Self {
        Self { heights, spacing, deviations: deviations(heights, spacing) }
    }

    fn ratio(&self, index: usize) -> f64 {
        self.heights[index].abs() / self.deviations[index / cell(self.spacing)]
    }

    /// The samples that stand out, and are no waves: the highest of those that hang together, and what else is no ringing of it.
    fn outstanding(&self) -> Vec<Range<usize>> {
        let mut places = Vec::new();
        let mut index = 0;
        while index < self.heights.len() {
            if self.ratio(index) <= OUTSTANDING {
                index += 1;
                continue;
            }
            let whole = self.reach(index, REACHES);
            index = whole.end;
            let least = RINGING * self.heights[self.top(&whole)].abs();
            let mut parts = vec![whole];
            while let Some(part) = parts.pop() {
                let top = self.top(&part);
                if self.heights[top].abs() < least || self.ratio(top) <= OUTSTANDING {
                    continue;
                }
                let around = self.around(top);
                let place = around.start.max(part.start)..around.end.min(part.end);
                // What the record cuts off cannot be told from how a filter begins.
                let cut = place.start == 0 || place.end == self.heights.len();
                if !cut && self.is_single(&place) {
                    places.push(place.clone());
                }
                let rest = [part.start..place.start, place.end..part.end];
                parts.extend(rest.into_iter().filter(|rest| !rest.is_empty()));
            }
        }
        places
    }

    /// The samples about the top of a place, to where the rail is calm or a filter rings.
    fn around(&self, top: usize) -> Range<usize> {
        self.reach(top, REACHES.max(SLIGHT_RINGING * self.ratio(top)))
    }

    /// The samples about one, to where the rail is calm on either side.
    fn reach(&self, at: usize, least: f64) -> Range<usize> {
        reach(at, self.heights.len(), self.spacing, |index| self.ratio(index) > least)
    }

    /// Whether this is too short and turns too seldom for waves.
    fn is_single(&self, samples: &Range<usize>) -> bool {
        samples.len() as f64 * self.spacing <= LONGEST && turns(&self.heights[samples.clone()]) <= MOST_TURNS
    }

    /// The highest sample of a place.
    fn top(&self, place: &Range<usize>) -> usize {
        let by = |a: &usize, b: &usize| self.heights[*a].abs().total_cmp(&self.heights[*b].abs());
        place.clone().max_by(by).unwrap_or(place.start)
    }
}

/// Samples of a cell, a metre, that has one standard deviation.
fn cell(spacing: f64) -> usize {
    (1.0 / spacing).round().max(1.0) as usize
}

/// Standard deviation of the rail around each cell, by the median of the heights without their sign.
fn deviations(waves: &[f64], spacing: f64) -> Vec<f64> {
    /// That of a normal number.
    const MEDIAN: f64 = 0.6745;
    let near = (NEIGHBOURS / spacing) as usize;
    // Every so many samples are enough for a median.
    let step = (0.01 / spacing).ceil().max(1.0) as usize;
    let heights: Vec<f64> = waves.iter().step_by(step).map(|wave| wave.abs()).collect();
    let starts = (0..waves.len()).step_by(cell(spacing));
    let mut middle = Middle::of(&heights);
    starts
        .map(|start| {
            let (from, to) = (start.saturating_sub(near), (start + near).min(waves.len()));
            let median = middle.within(from.div_ceil(step)..to.div_ceil(step));
            (median / MEDIAN).max(f64::MIN_POSITIVE)
        })
        .collect()
}

/// The middle of the numbers in a window that moves on: of those far from the middle before, it is enough to know how many are below.
struct Middle<'a> {
    numbers: &'a [f64],
    window: Range<usize>,
    /// Between which numbers are near.
    ends: (f64, f64),
    below: usize,
    /// Numbers in the window that are near, in their order.
    near: VecDeque<f64>,
    sorted: Vec<f64>,
}

impl<'a> Middle<'a> {
    fn of(numbers: &'a [f64]) -> Self {
        Self { numbers, window: 0..0, ends: (0.0, 0.0), below: 0, near: VecDeque::new(), sorted: Vec::new() }
    }

    fn within(&mut self, window: Range<usize>) -> f64 {
        /// Parts of the middle between which numbers are near.
        const NEAR: (f64, f64) = (0.9, 1.1);
        let (from, to) = self.ends;
        for &number in &self.numbers[self.window.start..window.start] {
            self.below -= usize::from(number < from);
            if from <= number && number <= to {
                self.near.pop_front();
            }
        }
        for &number in &self.numbers[self.window.end..window.end] {
            self.below += usize::from(number < from);
            if from <= number && number <= to {
                self.near.push_back(number);
            }
        }
        self.window = window.clone();
        let place = window.len() / 2;
        self.sorted.clear();
        if (self.below..self.below + self.near.len()).contains(&place) {
            self.sorted.extend(&self.near);
            return middle(&mut self.sorted, place - self.below);
        }
        let numbers = &self.numbers[window];
        self.sorted.extend(numbers);
        let found = middle(&mut self.sorted, place);
        let (from, to) = (NEAR.0 * found, NEAR.1 * found);
        self.ends = (from, to);
        self.below = numbers.iter().filter(|number| **number < from).count();
        let near = numbers.iter().filter(|number| from <= **number && **number <= to);
        self.near.clear();
        self.near.extend(near);
        found
    }
}

/// The number at a place of some in their order.
fn middle(numbers: &mut [f64], place: usize) -> f64 {
    *numbers.select_nth_unstable_by(place, f64::total_cmp).1
}

/// The samples about one that stands out, to where the rail is calm on either side.
fn reach(at: usize, count: usize, spacing: f64, stands_out: impl Fn(usize) -> bool) -> Range<usize> {
    let calm = (CALM / spacing).round().max(1.0) as usize;
    let limit = (2.0 * LONGEST / spacing) as usize;
    let side = |step: isize| {
        let (mut last, mut index) = (at, at);
        while let Some(next) = index.checked_add_signed(step).filter(|next| *next < count) {
            index = next;
            if stands_out(index) {
                last = index;
            }
            if index.abs_diff(last) > calm || index.abs_diff(at) > limit {
                break;
            }
        }
        last
    };
    side(-1)..side(1) + 1
}

/// Turns of half the largest height and more: changes of sign between them, and the first.
fn turns(waves: &[f64]) -> usize {
    let largest = waves.iter().fold(0.0, |most: f64, wave| most.max(wave.abs()));
    let large = waves.iter().filter(|wave| wave.abs() >= 0.5 * largest);
    let mut signs: Vec<bool> = large.map(|wave| *wave > 0.0).collect();
    signs.dedup();
    signs.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;
    use crate::roughness::{ColouredNoise, Recipe, Sinusoid};

    fn rail(seed: u64, waves: &[(f64, f64, f64, f64)]) -> Vec<f64> {
        let recipe = Recipe {
            length: 120.0,
            spacing: 2e-3,
            seed,
            sinusoids: waves
                .iter()
                .map(|&(wavelength, amplitude, from, to)| Sinusoid { wavelength, amplitude, phase: 0.3, from, to })
                .collect(),
            noise: Some(ColouredNoise { level: 0.0, wavelength: 0.1, slope: 10.0, longest: 3.0 }),
            ..Recipe::default()
        };
        recipe.heights().unwrap()
    }

    /// Versed sines in a rail.
    fn dipped(mut heights: Vec<f64>, dips: &[(f64, f64, f64)]) -> Vec<f64> {
        for &(at, depth, length) in dips {
            for (index, height) in heights.iter_mut().enumerate() {
                let x = (index as f64 * 2e-3 - at) / length;
                if x.abs() < 0.5 {
                    *height -= 0.5 * depth * (1.0 + (std::f64::consts::TAU * x).cos());
                }
            }
        }
        heights
    }

    #[test]
    fn the_middle_of_a_moving_window_is_that_of_its_numbers() {
        // It rises by twelve times, and is the same for a while.
        let number = |index: usize| {
            let mixed = (index * index * 37 % 101) as f64 / 101.0;
            mixed.powi(2) * (1.0 + (index / 300 * 300) as f64 / 80.0)
        };
        let numbers: Vec<f64> = (0..900).map(number).collect();
        let mut moving = Middle::of(&numbers);
        for start in (0..900).step_by(17) {
            let window = start.max(120) - 120..(start + 120).min(900);
            let mut own = numbers[window.clone()].to_vec();
            own.sort_by(f64::total_cmp);
            assert_eq!(moving.within(window), own[own.len() / 2], "{start}");
        }
    }

    #[test]
    fn welds_and_squats_are_found_where_they_are() -> Result<(), Error> {
        let dips = [(30.0, 300e-6, 1.0), (66.0, 150e-6, 0.6), (90.0, 100e-6, 0.08)];
        let mut profile = Profile::new(0.0, 2e-3, dipped(rail(1, &[]), &dips))?;
        let found = profile.bridge_defects(None);
        assert_eq!(found.len(), 3, "{found:?}");
        for (defect, (at, depth, length)) in found.iter().zip(dips) {
            assert!((0.5 * (defect.from + defect.to) - at).abs() < 0.2, "{defect:?}");
            assert!((defect.height / -depth - 1.0).abs() < 0.4, "{defect:?}");
            assert_eq!(defect.is_short(), length < 0.1, "{defect:?}");
        }
        // Nothing of them is left.
        assert!(profile.bridge_defects(None).is_empty());
        Ok(())
    }

    /// Joints, whose kinks all parts of the wavelengths show, are listed once each, with their height.
    #[test]
    fn each_joint_is_one_defect() -> Result<(), Error> {
        for seed in 0..8u32 {
            let joints: Vec<(f64, f64, f64)> = (0..6u32)
                .map(|joint| {
                    let mixed = f64::from((seed * 7 + joint * 5) % 11) / 11.0;
                    let at = 10.0 + 19.3 * f64::from(joint) + mixed;
                    (at, 150e-6 + 350e-6 * mixed, 0.03 + 0.07 * (1.0 - mixed))
                })
                .collect();
            let heights = rail(u64::from(seed), &[]).into_iter().enumerate();
            let heights = heights.map(|(index, height)| {
                let x = index as f64 * 2e-3;
                let dip = |&(at, depth, length): &(f64, f64, f64)| depth * (-(x - at).abs() / length).exp();
                0.6 * height - joints.iter().map(dip).sum::<f64>()
            });
            let found = Profile::new(0.0, 2e-3, heights.collect())?.bridge_defects(None);
            assert_eq!(found.len(), joints.len(), "{seed}: {found:?}");
            for (defect, (at, depth, _)) in found.iter().zip(joints) {
                assert!(defect.from < at && at < defect.to, "{at}: {defect:?}");
                let height = defect.height / -depth;
                assert!((0.6..1.2).contains(&height), "{depth}: {defect:?}");
            }
        }
        Ok(())
    }

    /// Corrugation of 20 µm at 70 mm hides no weld that is longer than its waves.
    #[test]
    fn corrugation_hides_no_weld() -> Result<(), Error> {
        let dips = [(30.0, 300e-6, 0.25), (66.0, 250e-6, 0.4)];
        let heights = dipped(rail(3, &[(0.07, 20e-6, 0.0, 120.0)]), &dips);
        let found = Profile::new(0.0, 2e-3, heights)?.bridge_defects(None);
        assert_eq!(found.len(), 2, "{found:?}");
        for (defect, (at, depth, _)) in found.iter().zip(dips) {
            assert!((0.5 * (defect.from + defect.to) - at).abs() < 0.2, "{defect:?}");
            assert!((defect.height / -depth - 1.0).abs() < 0.4, "{defect:?}");
        }
        Ok(())
    }

    /// Beside welds in strong corrugation no filter's ringing is one more.
    #[test]
    fn ringing_beside_welds_is_no_weld() -> Result<(), Error> {
        let dips = [17.3, 30.0, 52.1, 66.0, 85.4, 104.2].map(|at| (at, 400e-6, 0.35));
        for seed in 0..6 {
            for wave in [0.05, 0.06, 0.075] {
                let heights = dipped(rail(seed, &[(wave, 25e-6, 0.0, 120.0)]), &dips);
                let found = Profile::new(0.0, 2e-3, heights)?.bridge_defects(None);
                assert_eq!(found.len(), dips.len(), "{seed} {wave}: {found:?}");
            }
        }
        Ok(())
    }

    /// A wheel that has felt waves from 115 mm on leaves traces of shorter ones, here of a hundredth of a micrometre: they are no
    /// defects, and a weld is one.
    #[test]
    fn what_was_not_felt_tells_of_no_defect() -> Result<(), Error> {
        let known = WavelengthBand::new(0.115, 1.0)?;
        let kept = WavelengthBand::new(0.115, 2.0)?;
        for seed in 0..8 {
            let whole = Profile::new(0.0, 2e-3, dipped(rail(seed, &[]), &[(60.0, 400e-6, 0.5)]))?;
            let filter = BandPass::new(2e-3, whole.heights().len(), &[kept])?;
            let heights = filter.filter(&whole).swap_remove(0);
            let traces = [(20.0, 1e-8, 0.03), (90.0, 1e-8, 0.03)];
            let mut known_band = Profile::new(0.0, 2e-3, dipped(heights, &traces))?;
            assert!(known_band.clone().bridge_defects(None).len() > 1, "{seed}");
            let found = known_band.bridge_defects(Some(known));
            let [weld] = &found[..] else {
                panic!("{seed}: {found:?}");
            };
            assert!(weld.from < 60.0 && 60.0 < weld.to, "{weld:?}");
        }
        Ok(())
    }

    /// Noise, corrugation all along, and patches of ten waves and more are no defects.
    #[test]
    fn waves_are_no_defects() -> Result<(), Error> {
        for seed in 0..10 {
            for waves in [
                &[][..],
                &[(0.05, 10e-6, 0.0, 120.0)],
                &[(0.05, 60e-6, 40.0, 42.0)],
                &[(0.08, 40e-6, 40.0, 40.8)],
                &[(0.3, 80e-6, 40.0, 60.0)],
            ] {
                let heights = rail(seed, waves);
                let mut profile = Profile::new(0.0, 2e-3, heights.clone())?;
                let found = profile.bridge_defects(None);
                assert!(found.is_empty(), "{waves:?}: {found:?}");
                assert_eq!(profile.heights(), heights);
            }
        }
        Ok(())
    }
}
