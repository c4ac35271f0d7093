//! Tables of a rail after many wheels.

use std::io::{self, Write};
use std::path::Path;

use super::{BandDocument, EvolutionAnswer, EvolutionDocument};
use crate::AnswerError;
use crate::netcdf::{Grid, Variable};

impl EvolutionAnswer {
    /// One row for each stage and band.
    ///
    /// # Errors
    /// Those of the file.
    pub fn bands_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["passages", "wavelength_m", "level_db", "linear_level_db", "shift_m"])?;
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
        let names = self.profiles.iter().map(|profile| format!("height_after_{}_passages_m", profile.passages));
        writer.write_record(["position_m".to_owned()].into_iter().chain(names))?;
        for index in 0..self.profiles[0].heights_m.len() {
            let heights = self.profiles.iter().map(|profile| profile.heights_m[index]);
            let row = [index as f64 * self.spacing].into_iter().chain(heights);
            writer.serialize(row.collect::<Vec<f64>>())?;
        }
        writer.flush()
    }

    /// Levels, growth, forces and profiles as NetCDF-3, under the names that Python has.
    ///
    /// # Errors
    /// [`AnswerError::Grid`].
    pub fn netcdf(&self, title: &str, path: &Path) -> Result<(), AnswerError> {
        let document = self.document();
        let axes = vec![
            ("passages", document.stages.passages.len()),
            ("wavelength", document.bands.len()),
            ("profile_passages", self.profiles.len()),
            ("position", self.profiles[0].heights_m.len()),
        ];
        let mut variables = over_passages(&document);
        variables.extend(over_wavelength(&document));
        variables.extend(over_both(&document));
        let count = axes[3].1;
        variables.extend([
            Variable {
                name: "profile_passages",
                axes: &["profile_passages"],
                unit: "1",
                long_name: "wheels so far",
                values: Box::new(|| {
                    let profiles = self.profiles.iter();
                    profiles.map(|profile| profile.passages as f64).collect()
                }),
            },
            Variable {
                name: "position",
                axes: &["position"],
                unit: "m",
                long_name: "position on the ring",
                values: Box::new(move || (0..count).map(|n| n as f64 * self.spacing).collect()),
            },
            Variable {
                name: "height",
                axes: &["profile_passages", "position"],
                unit: "m",
                long_name: "height of the ring, positive upward",
                values: Box::new(|| {
                    let profiles = self.profiles.iter();
                    profiles.flat_map(|profile| profile.heights_m.iter().copied()).collect()
                }),
            },
        ]);
        Grid { title, axes, variables }.write(path)
    }
}

fn over_passages(document: &EvolutionDocument) -> Vec<Variable<'_>> {
    let stages = &document.stages;
    let known = |values: &[Option<f64>]| -> Vec<f64> {
        let values = values.iter();
        values.map(|value| value.unwrap_or(f64::NAN)).collect()
    };
    let of = |name, unit, long_name, values: Vec<f64>| Variable {
        name,
        axes: &["passages"],
        unit,
        long_name,
        values: Box::new(move || values.clone()),
    };
    let passages = stages.passages.iter().map(|passages| *passages as f64);
    let mut variables = vec![
        of("passages", "1", "wheels so far", passages.collect()),
        of("mean_depth", "m", "depth worn off everywhere", stages.mean_depth_m.clone()),
        of(
            "contact_loss_fraction",
            "1",
            "share of the time without contact of the passage before",
            known(&stages.contact_loss_fraction),
        ),
        of("minimum_normal_force", "N", "least normal force of that passage", known(&stages.minimum_normal_force_n)),
        of("maximum_normal_force", "N", "largest normal force of that passage", known(&stages.maximum_normal_force_n)),
    ];
    variables.extend(stages.support_pattern_level_db.as_ref().map(|levels| {
        of("support_pattern_level", DECIBELS, "level of the waves that fit between two supports", levels.clone())
    }));
    variables
}

/// Re 1 µm, in the letters of NetCDF-3.
const DECIBELS: &str = "dB re 1 um";

fn over_wavelength(document: &EvolutionDocument) -> Vec<Variable<'_>> {
    type Of = fn(&BandDocument) -> Option<f64>;
    let of = |(name, unit, long_name, value): (_, _, _, Of)| Variable {
        name,
        axes: &["wavelength"],
        unit,
        long_name,
        values: Box::new(move || {
            let bands = document.bands.iter();
            bands.map(|band| value(band).unwrap_or(f64::NAN)).collect()
        }),
    };
    let variables: [(_, _, _, Of); 7] = [
        ("wavelength", "m", "centre of the one-third octave", |band| Some(band.wavelength_m)),
        ("first_growth_rate", "1", "growth rate per passage, first step", |band| band.first_growth_per_passage),
        ("linear_growth_rate", "1", "growth rate per passage, linear loop", |band| {
            band.first_linear_growth_per_passage
        }),
        ("last_growth_rate", "1", "growth rate per passage, last quarter", |band| band.last_growth_per_passage),
        ("saturation_level", DECIBELS, "level where growth has stopped", |band| band.saturation_level_db),
        ("first_drift", "m", "shift of the waves per passage, first step", |band| band.first_shift_m_per_passage),
        ("linear_drift", "m", "shift of the waves per passage, linear loop", |band| {
            Some(band.linear_shift_m_per_passage)
        }),
    ];
    variables.into_iter().map(of).collect()
}

fn over_both(document: &EvolutionDocument) -> Vec<Variable<'_>> {
    type Of = fn(&BandDocument) -> &[f64];
    let of = |(name, unit, long_name, value): (_, _, _, Of)| Variable {
        name,
        axes: &["passages", "wavelength"],
        unit,
        long_name,
        values: Box::new(move || {
            let stages = 0..document.stages.passages.len();
            let row = |stage: usize| document.bands.iter().map(move |band| value(band)[stage]);
            stages.flat_map(row).collect()
        }),
    };
    let variables: [(_, _, _, Of); 3] = [
        ("level", DECIBELS, "one-third-octave level", |band| &band.level_db),
        ("linear_level", DECIBELS, "level of the linear loop", |band| &band.linear_level_db),
        ("shift", "m", "shift of the waves, in the direction of travel", |band| &band.shift_m),
    ];
    variables.into_iter().map(of).collect()
}
