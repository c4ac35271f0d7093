//! What to grind: from where to where.

use super::WavelengthBand;

/// A length of rail over a limit.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct GrindSection {
    /// Where it begins \[m\].
    pub from: f64,
    /// Where it ends \[m\].
    pub to: f64,
    /// On which of the [stretches that lie over each other](stretch_numbers) it is, from 1.
    pub stretch: usize,
    /// The band that is worst against its limit.
    pub band: WavelengthBand,
    /// Moving RMS of that band over its limit, at worst \[-\].
    pub ratio: f64,
}

impl GrindSection {
    /// Its length \[m\].
    pub fn length(&self) -> f64 {
        self.to - self.from
    }
}

/// What one piece of grinding is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrindSettings {
    /// Good length \[m\] up to which two sections are ground as one.
    pub merge: f64,
    /// Shortest length that is ground \[m\].
    pub shortest: f64,
}

impl Default for GrindSettings {
    /// 10 m each, Riffel's choice: a grinding train works at 5–10 km/h and takes four to seven seconds for
    /// 10 m, about as long as its stones need to be lowered or raised. A shorter section cannot be ground on
    /// its own, and a shorter good length is not worth the stop.
    fn default() -> Self {
        Self { merge: 10.0, shortest: 10.0 }
    }
}

/// How far \[m\] a stretch may begin before the end of the one before it: what rounded places and the last step leave.
const ROUNDED: f64 = 0.1;

/// The number of each stretch, from 1, in the order of travel \[m\].
///
/// Where places go back, as at a long kilometre, the rail has two stretches at the same places, and the next number begins. A gap does
/// not begin one.
#[must_use]
pub fn stretch_numbers(stretches: &[(f64, f64)]) -> Vec<usize> {
    let (mut number, mut reached) = (1, f64::NEG_INFINITY);
    let numbers = stretches.iter().map(|&(from, to)| {
        if from < reached - ROUNDED {
            number += 1;
        }
        reached = to;
        number
    });
    numbers.collect()
}

/// What to grind of one rail, given where its bands are over their limits and where its stretches without
/// gaps begin and end \[m\], in the order of travel.
///
/// A section shorter than the shortest is widened to either side, at the end of a stretch to one side; it
/// never reaches beyond its stretch. Sections that then overlap or lie no further apart than the good length to be
/// merged become one, whatever their bands, and also across a gap of the record: the worst band gives its
/// name. Sections of two [numbers](stretch_numbers) are two pieces of rail and stay apart.
pub fn grind_sections(
    mut sections: Vec<GrindSection>,
    stretches: &[(f64, f64)],
    settings: &GrindSettings,
) -> Vec<GrindSection> {
    let numbers = stretch_numbers(stretches);
    for section in &mut sections {
        let middle = 0.5 * (section.from + section.to);
        let own = stretches
            .iter()
            .zip(&numbers)
            .find(|((from, to), number)| **number == section.stretch && (*from..=*to).contains(&middle));
        if let Some((&(from, to), _)) = own {
            widen(section, settings.shortest.min(to - from), from, to);
        }
    }
    sections.sort_by(|a, b| (a.stretch.cmp(&b.stretch)).then(a.from.total_cmp(&b.from)));
    let mut joined: Vec<GrindSection> = Vec::new();
    for section in sections {
        match joined.last_mut() {
            Some(last) if section.stretch == last.stretch && section.from - last.to <= settings.merge => {
                last.to = last.to.max(section.to);
                if section.ratio > last.ratio {
                    last.ratio = section.ratio;
                    last.band = section.band;
                }
            }
            _ => joined.push(section),
        }
    }
    joined
}

/// Make a section at least `shortest` long, within `from` and `to` \[m\].
fn widen(section: &mut GrindSection, shortest: f64, from: f64, to: f64) {
    let lacking = shortest - section.length();
    if lacking > 0.0 {
        // Not `clamp`: rounding may put the one end before the other.
        section.from = (section.from - 0.5 * lacking).min(to - shortest).max(from);
        section.to = section.from + shortest;
    }
}

/// Length of line \[m\] that some lengths cover, given by the [number of their stretch](stretch_numbers) and their ends; what two rails
/// share counts once, and each of two stretches at the same places counts.
pub fn line_length(ends: impl IntoIterator<Item = (usize, f64, f64)>) -> f64 {
    let mut ends: Vec<(usize, f64, f64)> = ends.into_iter().collect();
    ends.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let (mut length, mut own, mut reached) = (0.0, 0, f64::NEG_INFINITY);
    for (stretch, from, to) in ends {
        if stretch != own {
            (own, reached) = (stretch, f64::NEG_INFINITY);
        }
        length += (to - from.max(reached)).max(0.0);
        reached = reached.max(to);
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SHORT: WavelengthBand = WavelengthBand::GRINDING[0];
    const LONG: WavelengthBand = WavelengthBand::GRINDING[1];

    fn section(from: f64, to: f64, band: WavelengthBand, ratio: f64) -> GrindSection {
        GrindSection { from, to, stretch: 1, band, ratio }
    }

    fn settings(merge: f64, shortest: f64) -> GrindSettings {
        GrindSettings { merge, shortest }
    }

    #[test]
    fn near_sections_are_ground_together() {
        let joined = grind_sections(
            vec![
                section(50.0, 60.0, LONG, 1.1),
                section(10.0, 20.0, SHORT, 1.5),
                section(22.0, 24.0, LONG, 2.0),
                section(12.0, 14.0, LONG, 1.2),
            ],
            &[(0.0, 100.0)],
            &settings(5.0, 0.0),
        );
        assert_eq!(joined, [section(10.0, 24.0, LONG, 2.0), section(50.0, 60.0, LONG, 1.1)]);
        assert_eq!(joined[0].length(), 14.0);
    }

    /// Half a metre in the middle, at either end, and on a stretch that is shorter than what is ground.
    #[test]
    fn short_sections_are_widened_on_the_rail() {
        let spot = |from: f64| section(from, from + 0.5, LONG, 1.2);
        let ground = grind_sections(
            vec![spot(50.0), spot(0.2), spot(99.4), spot(203.0)],
            &[(0.0, 100.0), (200.0, 204.0)],
            &settings(10.0, 10.0),
        );
        let ends: Vec<(f64, f64)> = ground.iter().map(|one| (one.from, one.to)).collect();
        assert_eq!(ends, [(0.0, 10.0), (45.25, 55.25), (90.0, 100.0), (200.0, 204.0)]);
    }

    #[test]
    fn line_counts_once_what_two_rails_need() {
        let both_rails = [(1, 50.0, 60.0), (1, 0.0, 20.0), (1, 10.0, 30.0)];
        assert_eq!(line_length(both_rails), 40.0);
        assert_eq!(line_length([(1, 0.0, 20.0), (2, 10.0, 30.0)]), 40.0);
        assert_eq!(line_length([]), 0.0);
    }

    /// From 40 m back to 20 m, a gap, and back by rounding alone.
    #[test]
    fn stretches_at_the_same_places_are_two_pieces_of_rail() {
        let stretches = [(0.0, 40.0), (20.0, 60.0), (65.0, 90.0), (89.99, 99.0)];
        assert_eq!(stretch_numbers(&stretches), [1, 2, 2, 2]);
        let second = GrindSection { stretch: 2, ..section(21.0, 24.0, LONG, 2.0) };
        let over = vec![second, section(36.0, 40.0, LONG, 1.5)];
        let ground = grind_sections(over, &stretches, &settings(10.0, 10.0));
        let found: Vec<_> = (ground.iter()).map(|one| (one.stretch, one.from, one.to, one.ratio)).collect();
        assert_eq!(found, [(1, 30.0, 40.0, 1.5), (2, 20.0, 30.0, 2.0)]);
    }

    proptest! {
        /// All that is over the limit is ground, no piece is too short or too near to the next, and none
        /// reaches beyond the rail.
        #[test]
        fn everything_over_the_limit_is_ground(
            spots in prop::collection::vec((0.0..990.0f64, 0.01..10.0f64), 0..30),
            merge in 0.0..20.0f64,
            shortest in 0.0..30.0f64,
        ) {
            let over: Vec<GrindSection> = spots
                .iter()
                .map(|(from, length)| section(*from, from + length, LONG, 1.5))
                .collect();
            let ground = grind_sections(over.clone(), &[(0.0, 1000.0)], &settings(merge, shortest));
            for one in &over {
                prop_assert!(ground.iter().any(|all| all.from <= one.from + 1e-9 && one.to <= all.to + 1e-9));
            }
            for one in &ground {
                prop_assert!(one.length() >= shortest - 1e-9 && one.from >= 0.0 && one.to <= 1000.0);
            }
            prop_assert!(ground.windows(2).all(|pair| pair[1].from - pair[0].to > merge));
        }
    }
}
