//! Tables of a rail after many wheels.

use std::io::{self, Write};

use super::EvolutionAnswer;

impl EvolutionAnswer {
    /// One row for each stage and band.
    ///
    /// # Errors
    /// Those of the file.
    pub fn bands_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "passages",
            "wavelength_m",
            "level_db",
            "linear_level_db",
            "shift_m",
        ])?;
        let bands = self.bands();
        for (index, stage) in self.stages.iter().enumerate() {
            for band in &bands {
                writer.serialize((
                    stage.passages,
                    band.wavelength_m,
                    band.level_db[index],
                    band.linear_level_db[index],
                    band.shift_m[index],
                ))?;
            }
        }
        writer.flush()
    }

    /// One row for each place, one column for each profile that was kept.
    ///
    /// # Errors
    /// Those of the file.
    pub fn profiles_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let names = self
            .profiles
            .iter()
            .map(|profile| format!("height_after_{}_m", profile.passages));
        writer.write_record(["position_m".to_owned()].into_iter().chain(names))?;
        for index in 0..self.profiles[0].heights_m.len() {
            let heights = self.profiles.iter().map(|profile| profile.heights_m[index]);
            let row = [index as f64 * self.spacing].into_iter().chain(heights);
            writer.serialize(row.collect::<Vec<f64>>())?;
        }
        writer.flush()
    }
}
