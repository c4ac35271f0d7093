//! What was computed of a profile, as files of comma-separated values.

use std::io::{self, Write};

use riffel::roughness::WavelengthBand;

use super::{Report, name};

impl Report {
    pub(super) fn spectrum_table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = vec!["wavelength_m".to_owned(), "level_db".to_owned()];
        header.extend(
            self.rails
                .iter()
                .map(|(name, _)| format!("{name} level_db")),
        );
        writer.write_record(&header)?;
        for level in self.spectrum.levels() {
            let mut row = vec![Some(level.band.wavelength()), Some(level.level)];
            row.extend(
                self.rails
                    .iter()
                    .map(|(_, rail)| rail.spectrum.level(level.band)),
            );
            writer.serialize(row)?;
        }
        writer.flush()
    }

    pub(super) fn block_table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = ["rail", "from_m", "to_m"].map(str::to_owned).to_vec();
        header.extend(WavelengthBand::GRINDING.map(|band| format!("rms_m {} mm", name(&band))));
        writer.write_record(&header)?;
        for (name, rail) in &self.rails {
            for block in &rail.blocks {
                writer.serialize((name, block.from, block.to, &block.rms))?;
            }
        }
        writer.flush()
    }

    pub(super) fn grind_table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["from_m", "to_m", "worst_band_mm", "rms_over_limit"])?;
        for section in &self.sections {
            writer.serialize((section.from, section.to, name(&section.band), section.ratio))?;
        }
        writer.flush()
    }
}
