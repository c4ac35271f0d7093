//! Single defects of a measured rail: welds, joints and squats.

use riffel::diagnosis::CleanRail;
use riffel::roughness::RailDefect;
use riffel_keys::{Message, Value, fixed, say};

use crate::{EarlierRails, Rail, Record, RoughnessFile};

/// What became of the defects of a rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DefectsAre {
    /// They are no part of its spectra.
    LeftOut,
    /// They are no part of levels, but of statistics and of what to grind.
    OutOfLevels,
    /// They are a part of levels and limits.
    Judged,
}

/// Where the defects of a rail are, and what became of them; None without a defect.
pub fn defects_in_words(rail: &str, defects: &[RailDefect], are: DefectsAre) -> Option<Message> {
    /// More are counted.
    const NAMED: usize = 6;
    let places = defects.iter().take(NAMED).map(|defect| {
        let middle = 0.5 * (defect.from + defect.to);
        let height = fixed(1e6 * defect.height, 0);
        say!(defect_at, place = fixed(middle, 1), height)
    });
    let places: Value = places.collect();
    let count = defects.len();
    let found = match count {
        0 => return None,
        1 => say!(one_defect, rail = rail.to_owned(), places),
        2..=NAMED => say!(some_defects, rail = rail.to_owned(), count, places),
        _ => say!(many_defects, rail = rail.to_owned(), count, places, more = count - NAMED),
    };
    Some(match are {
        DefectsAre::LeftOut => say!(defects_left_out, sentence = found),
        DefectsAre::OutOfLevels => say!(defects_out_of_levels, sentence = found),
        DefectsAre::Judged => say!(defects_judged, sentence = found),
    })
}

impl RoughnessFile {
    /// What grows of a rail: without its welds, joints and squats ([`CleanRail::defects`]), which a warning lists. Tables of
    /// levels stay as they are.
    pub fn without_defects(self) -> Self {
        match self {
            Self::Profile(record) => Self::Profile(record.without_defects()),
            table => table,
        }
    }
}

impl Record {
    /// Rail of [`RoughnessFile::without_defects`].
    pub fn without_defects(mut self) -> Self {
        let clean = |rail: &mut Rail| {
            let clean = CleanRail::new(std::mem::take(&mut rail.stretches));
            let said = defects_in_words(&rail.name, clean.defects(), DefectsAre::LeftOut);
            rail.stretches = clean.into_stretches();
            said
        };
        self.warnings.extend(self.rails.iter_mut().filter_map(clean));
        for EarlierRails { date, rails } in &mut self.earlier {
            let said = rails.iter_mut().filter_map(clean);
            self.warnings.extend(said.map(|said| said.about(date.to_string())));
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Layout, Survey};

    /// Two welds raise the level at 160 mm by more than 10 dB; without them it is that of the same rail without welds, but
    /// for the metre in a hundred that was bridged.
    #[test]
    fn welds_are_no_part_of_what_grows() {
        let folder = tempfile::tempdir().unwrap();
        let level = |name: &str, depth: f64, kept: bool| {
            let path = folder.path().join(name);
            let mut text = "position [m],height [um]\n".to_owned();
            let mut random = 12_345u32;
            let mut noise = 0.0;
            for sample in 0..30_000u32 {
                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                noise = 0.9 * noise + f64::from(random >> 16) / 65_536.0 - 0.5;
                let x = 2e-3 * f64::from(sample);
                let dips = [17.0, 41.0].map(|at| (1.0 - (x - at).abs() / 0.1).max(0.0));
                let height = noise - depth * (dips[0] + dips[1]);
                text += &format!("{x:.3},{height:.3}\n");
            }
            std::fs::write(&path, text).unwrap();
            let file = RoughnessFile::read(&path, &Layout::default(), &|_| ()).unwrap();
            let file = if kept { file } else { file.without_defects() };
            let survey = Survey::of(&path, file).unwrap();
            let spectrum = survey.mean();
            let levels = spectrum.levels().iter();
            let near = levels.min_by(|a, b| {
                let far = |one: &riffel::roughness::BandLevel| (one.band.wavelength() - 0.16).abs();
                far(a).total_cmp(&far(b))
            });
            let warnings = survey.warnings.iter().map(ToString::to_string);
            (near.unwrap().level, warnings.collect::<Vec<String>>().join("\n"))
        };
        let (smooth, none) = level("smooth.csv", 0.0, false);
        let (kept, silent) = level("kept.csv", 300.0, true);
        let (clean, listed) = level("clean.csv", 300.0, false);
        assert!(kept > smooth + 10.0, "{kept} {smooth}");
        assert!((clean - smooth).abs() < 1.0, "{clean} {smooth}");
        assert!(!none.contains("weld") && !silent.contains("weld"));
        assert!(listed.contains("2 welds") && listed.contains("17.0 m") && listed.contains("41.0 m"), "{listed}");
    }
}
