//! A rail judged piece by piece.

use super::{GrindSection, RailAnalysis, RmsLimit, Spectrum, WavelengthBand, stretch_numbers};

/// Length on which a rail is judged \[m\]: the verdict on a place does not depend on how far the record goes on.
///
/// Acceptance of grinding counts the share of a length over a limit. Over a whole record 240 m of corrugation in 18 km are
/// 1.3 %; over 100 m, a length that is ground or not, they are what they are.
pub const JUDGED_LENGTH: f64 = 100.0;

/// A section in the band that is over its limit on the largest share of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct JudgedSection {
    /// On which of the [stretches that lie over each other](stretch_numbers) it is, from 1.
    pub stretch: usize,
    /// First place \[m\].
    pub from: f64,
    /// Last place \[m\].
    pub to: f64,
    /// The band.
    pub band: WavelengthBand,
    /// Share of the length measured over the limit \[-\].
    pub share: f64,
    /// Highest moving RMS over its limit \[-\]; 1 where it is nowhere over it.
    pub ratio: f64,
}

/// The levels of a section.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct SectionSpectrum {
    /// On which of the [stretches that lie over each other](stretch_numbers) it is, from 1.
    pub stretch: usize,
    /// First place \[m\].
    pub from: f64,
    /// Last place \[m\].
    pub to: f64,
    /// Its levels.
    pub spectrum: Spectrum,
}

impl JudgedSection {
    /// Whether more of the length is over a limit than it allows: the one definition, by which a network is judged, too.
    pub fn is_over(&self, limit: &RmsLimit) -> bool {
        self.share > limit.share()
    }
}

impl RailAnalysis {
    /// The sections of the rail, those with the largest share over the limit first.
    #[must_use]
    pub fn judged_sections(&self) -> Vec<JudgedSection> {
        let pieces = pieces(&self.stretches);
        // Those of a band on a stretch do not overlap.
        let with_limit = self.bands.iter().filter(|band| band.limit.is_some());
        let bands: Vec<(WavelengthBand, Vec<&GrindSection>)> = with_limit
            .map(|summary| {
                let own = self.over_limit.iter().filter(|one| one.band == summary.band);
                let mut own: Vec<&GrindSection> = own.collect();
                own.sort_by(|one, other| (one.stretch.cmp(&other.stretch)).then(one.from.total_cmp(&other.from)));
                (summary.band, own)
            })
            .collect();
        let judged = pieces.iter().filter_map(|piece| {
            let &Piece { stretch, from, to, .. } = piece;
            let of_band = bands.iter().map(|(band, over)| {
                let first = over.partition_point(|one| (one.stretch, one.to) <= (stretch, from));
                let over = over[first..].iter();
                let over = over.take_while(|one| one.stretch == stretch && one.from < to);
                let (sum, ratio) = over.fold((0.0, 1.0f64), |(sum, ratio), one| {
                    (sum + one.to.min(to) - one.from.max(from), ratio.max(one.ratio))
                });
                JudgedSection { stretch, from, to, band: *band, share: sum / piece.measured, ratio }
            });
            of_band.max_by(|one, other| by_share(other, one))
        });
        let mut judged: Vec<JudgedSection> = judged.collect();
        judged.sort_by(by_share);
        judged
    }
}

/// A section to be judged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// On which of the stretches that lie over each other it is.
    pub(super) stretch: usize,
    /// Where it begins and ends \[m\].
    pub(super) from: f64,
    pub(super) to: f64,
    /// Length of it that was measured \[m\].
    measured: f64,
}

/// Where sections begin and end.
///
/// They begin at whole hundreds of metres, as the posts beside a line do. One of which less than half was measured is judged with the
/// one before it, the first with the one behind. Where places go back, a section ends and another begins.
pub(super) fn pieces(stretches: &[(f64, f64)]) -> Vec<Piece> {
    let numbered: Vec<_> = stretch_numbers(stretches).into_iter().zip(stretches).collect();
    let parts = numbered.chunk_by(|one, other| one.0 == other.0);
    parts.flat_map(pieces_of).collect()
}

/// The sections of stretches of one number.
fn pieces_of(stretches: &[(usize, &(f64, f64))]) -> Vec<Piece> {
    let ends = stretches.iter().map(|(number, ends)| (*number, **ends));
    let ends = ends.reduce(|(number, one), (_, other)| (number, (one.0.min(other.0), one.1.max(other.1))));
    let Some((stretch, (first, last))) = ends else {
        return Vec::new();
    };
    let measured = |from: f64, to: f64| -> f64 {
        let own = |(_, (low, high)): &(usize, &(f64, f64))| (high.min(to) - low.max(from)).max(0.0);
        stretches.iter().map(own).sum()
    };
    let mut pieces: Vec<Piece> = Vec::new();
    let mut from = first;
    while from < last {
        let to = ((from / JUDGED_LENGTH + 1e-9).floor() + 1.0) * JUDGED_LENGTH;
        let to = to.min(last);
        let own = measured(from, to);
        match pieces.last_mut() {
            Some(piece) if own < 0.5 * JUDGED_LENGTH || piece.measured < 0.5 * JUDGED_LENGTH => {
                piece.to = to;
                piece.measured += own;
            }
            _ => pieces.push(Piece { stretch, from, to, measured: own }),
        }
        from = to;
    }
    pieces
}

/// The largest share first, and of equal ones the roughest.
fn by_share(one: &JudgedSection, other: &JudgedSection) -> std::cmp::Ordering {
    let shares = other.share.total_cmp(&one.share);
    shares.then(other.ratio.total_cmp(&one.ratio))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::{AnalysisSettings, Profile};

    const BAND: WavelengthBand = WavelengthBand::GRINDING[1];

    /// A rail from a place on, over its limit at some places.
    fn rail(from: f64, to: f64, over: &[(f64, f64)]) -> RailAnalysis {
        let heights = (0..4000).map(|n| 1e-6 * (f64::from(n) * 0.1).sin()).collect();
        let profile = Profile::new(0.0, 1e-3, heights).unwrap();
        let limit = RmsLimit::new(vec![(BAND, 4e-6)], 0.05).unwrap();
        let settings = AnalysisSettings { limit: Some(limit), bands: vec![BAND], ..AnalysisSettings::default() };
        let mut analysis = RailAnalysis::new(vec![profile], &settings, &|| ()).unwrap();
        analysis.stretches = vec![(from, to)];
        let sections = over.iter().map(|&(from, to)| GrindSection { from, to, stretch: 1, band: BAND, ratio: 4.9 });
        analysis.over_limit = sections.collect();
        analysis
    }

    fn limit() -> RmsLimit {
        RmsLimit::new(vec![(BAND, 4e-6)], 0.05).unwrap()
    }

    /// 240 m at 4.9 times the limit are over it however long the record is, and 4 m in each hundred nowhere.
    #[test]
    fn the_verdict_does_not_depend_on_where_the_record_ends() {
        for end in [5_400.0, 6_000.0, 18_000.0] {
            let found = rail(0.0, end, &[(5_100.0, 5_340.0)]).judged_sections();
            let over = found.iter().filter(|one| one.is_over(&limit()));
            let places: Vec<(f64, f64)> = over.map(|one| (one.from, one.share)).collect();
            assert_eq!(places, [(5_100.0, 1.0), (5_200.0, 1.0), (5_300.0, 0.4)]);
            assert_eq!((found.len() as f64, found[0].ratio), (end / 100.0, 4.9));
        }
        let each: Vec<(f64, f64)> = (0..180).map(|n| (100.0 * f64::from(n), 100.0 * f64::from(n) + 4.0)).collect();
        let found = rail(0.0, 18_000.0, &each).judged_sections();
        assert!(found.iter().all(|one| !one.is_over(&limit())));
    }

    /// Ends of less than half a section belong to their neighbours; a short record is one section.
    #[test]
    fn short_ends_are_judged_with_their_neighbours() {
        let found = rail(970.0, 1_240.0, &[(970.0, 1_000.0)]).judged_sections();
        let mut places: Vec<[f64; 2]> = found.iter().map(|one| [one.from, one.to]).collect();
        places.sort_by(|one, other| one[0].total_cmp(&other[0]));
        assert_eq!(places, [[970.0, 1_100.0], [1_100.0, 1_240.0]]);
        assert!((found[0].share - 30.0 / 130.0).abs() < 1e-12);
        let short = rail(13.0, 27.0, &[(13.0, 14.0)]).judged_sections();
        assert_eq!(short.len(), 1);
        assert!((short[0].share - 1.0 / 14.0).abs() < 1e-12);
    }

    /// A long kilometre from 150 m back to 90 m: the wave behind it is judged on its own stretch alone.
    #[test]
    fn stretches_at_the_same_places_are_judged_apart() {
        let mut long = rail(0.0, 150.0, &[(100.0, 130.0)]);
        long.stretches.push((90.0, 300.0));
        long.over_limit[0].stretch = 2;
        let mut found = long.judged_sections();
        found.sort_by(|one, other| one.from.total_cmp(&other.from));
        let found: Vec<_> = (found.iter()).map(|one| (one.stretch, one.from, one.to, one.share)).collect();
        let expected =
            [(1, 0.0, 100.0, 0.0), (2, 90.0, 200.0, 30.0 / 110.0), (1, 100.0, 150.0, 0.0), (2, 200.0, 300.0, 0.0)];
        assert_eq!(found, expected);
    }
}
