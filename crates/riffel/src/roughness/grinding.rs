//! What to grind: from where to where.

use super::WavelengthBand;

/// A length of rail over a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct GrindSection {
    /// Where it begins \[m\].
    pub from: f64,
    /// Where it ends \[m\].
    pub to: f64,
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

/// Join sections that overlap or lie nearer to each other than `gap` \[m\], whatever their bands, as a
/// grinding train does not stop for a short good length. The worst band gives its name.
pub fn grind_sections(mut sections: Vec<GrindSection>, gap: f64) -> Vec<GrindSection> {
    sections.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut joined: Vec<GrindSection> = Vec::new();
    for section in sections {
        match joined.last_mut() {
            Some(last) if section.from - last.to <= gap => {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_sections_are_ground_together() {
        let [short, long, ..] = WavelengthBand::GRINDING;
        let section = |from, to, band, ratio| GrindSection {
            from,
            to,
            band,
            ratio,
        };
        let joined = grind_sections(
            vec![
                section(50.0, 60.0, long, 1.1),
                section(10.0, 20.0, short, 1.5),
                section(22.0, 24.0, long, 2.0),
                section(12.0, 14.0, long, 1.2),
            ],
            5.0,
        );
        assert_eq!(
            joined,
            [
                section(10.0, 24.0, long, 2.0),
                section(50.0, 60.0, long, 1.1)
            ]
        );
        assert_eq!(joined[0].length(), 14.0);
    }
}
