//! What was computed of a profile, as files of comma-separated values.

use std::io::{self, Write};

use riffel::roughness::WavelengthBand;

use super::words::name;
use super::{ProfileAnswer, RailAnswer};

impl ProfileAnswer {
    /// Levels of each rail, the worst first, and behind several rails their energy mean.
    ///
    /// # Errors
    /// Those of the file.
    pub fn spectrum_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["rail", "wavelength_m", "level_db"])?;
        let rails = self.rails.iter();
        let own = rails.map(|rail| (rail.name.as_str(), &rail.analysis.spectrum));
        let mean = (self.rails.len() > 1).then_some(("energy mean", &self.spectrum));
        for (name, spectrum) in own.chain(mean) {
            for level in spectrum.levels() {
                writer.serialize((name, level.band.wavelength(), level.level))?;
            }
        }
        writer.flush()
    }

    /// RMS of each block, the highest moving RMS in it, and where single defects are.
    ///
    /// # Errors
    /// Those of the file.
    pub fn block_csv(&self, file: &mut impl Write) -> io::Result<()> {
        block_csv(&self.rails, file)
    }

    /// What to grind of each rail, the worst first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn grind_csv(&self, file: &mut impl Write) -> io::Result<()> {
        grind_csv(&self.rails, file)
    }
}

/// RMS of each block of some rails, the highest moving RMS in it, and the places of its welds, joints and squats.
pub(crate) fn block_csv<'a>(rails: impl IntoIterator<Item = &'a RailAnswer>, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let mut header = ["rail", "from_m", "to_m"].map(str::to_owned).to_vec();
    for what in ["rms", "moving_rms_max"] {
        header.extend(WavelengthBand::GRINDING.map(|band| {
            let (from, to) = (1e3 * band.from(), 1e3 * band.to());
            format!("{what}_{from:.0}_to_{to:.0}_mm_m")
        }));
    }
    header.push("defects_m".to_owned());
    writer.write_record(&header)?;
    for rail in rails {
        let middles = rail.analysis.defects.iter();
        let middles: Vec<f64> = middles.map(|one| 0.5 * (one.from + one.to)).collect();
        for block in &rail.analysis.blocks {
            let defects = middles.iter().filter(|at| (block.from..block.to).contains(at));
            let defects: Vec<String> = defects.map(|at| format!("{at:.2}")).collect();
            let row = (&rail.name, block.from, block.to, &block.rms, &block.moving_rms_max, defects.join(";"));
            writer.serialize(row)?;
        }
    }
    writer.flush()
}

/// What to grind of some rails.
pub(crate) fn grind_csv<'a>(rails: impl IntoIterator<Item = &'a RailAnswer>, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record(["rail", "from_m", "to_m", "worst_band_mm", "rms_over_limit", "stretch"])?;
    for rail in rails {
        for section in &rail.sections {
            let band = name(&section.band);
            writer.serialize((&rail.name, section.from, section.to, band, section.ratio, section.stretch))?;
        }
    }
    writer.flush()
}
