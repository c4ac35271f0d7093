//! Tables and grid of a rail after many wheels.

use super::{Band, EvolutionAnswer, Stages};
use crate::netcdf::{Grid, Variable};
use crate::{Column, Rows, Table};

impl EvolutionAnswer {
    /// One row for each stage and band.
    pub(super) fn bands_table(&self) -> Table {
        let stages = self.stages.passages.iter().enumerate();
        let rows: Vec<(usize, u64, &Band)> =
            stages.flat_map(|(stage, passages)| self.bands.iter().map(move |band| (stage, *passages, band))).collect();
        Table {
            name: "bands",
            columns: vec![
                rows.names("passages", |(_, passages, _)| passages),
                rows.exact("wavelength_m", |(.., band)| band.wavelength_m),
                rows.exact("level_db", |(stage, _, band)| band.level_db[*stage]),
                rows.exact("linear_level_db", |(stage, _, band)| band.linear_level_db[*stage]),
                rows.exact("shift_m", |(stage, _, band)| band.shift_m[*stage]),
            ],
        }
    }

    /// One row for each place, one column for each profile that was kept.
    pub(super) fn profiles_table(&self) -> Table {
        let places = (0..self.profiles[0].heights_m.len()).map(|index| index as f64 * self.spacing);
        let profiles = self.profiles.iter().map(|profile| {
            let name = format!("height_after_{}_passages_m", profile.passages);
            profile.heights_m.exact(&name, |&value| value)
        });
        let places = Column::exact("position_m", places);
        Table { name: "profile", columns: [places].into_iter().chain(profiles).collect() }
    }

    /// Levels, growth, forces and profiles, under the names that Python has.
    pub(super) fn grid(&self) -> Grid<'_> {
        let axes = vec![
            ("passages", self.stages.passages.len()),
            ("wavelength", self.bands.len()),
            ("profile_passages", self.profiles.len()),
            ("position", self.profiles[0].heights_m.len()),
        ];
        let mut variables = over_passages(&self.stages);
        variables.extend(over_wavelength(&self.bands));
        variables.extend(over_both(&self.bands));
        let count = axes[3].1;
        variables.extend([
            Variable::new("profile_passages", &["profile_passages"], "1", "wheels so far", || {
                let profiles = self.profiles.iter();
                profiles.map(|profile| profile.passages as f64).collect()
            }),
            Variable::new("position", &["position"], "m", "position on the ring", move || {
                (0..count).map(|n| n as f64 * self.spacing).collect()
            }),
            Variable::new(
                "height",
                &["profile_passages", "position"],
                "m",
                "height of the ring, positive upward",
                || {
                    let profiles = self.profiles.iter();
                    profiles.flat_map(|profile| profile.heights_m.iter().copied()).collect()
                },
            ),
        ]);
        Grid { title: self.title(), axes, variables }
    }
}

fn over_passages(stages: &Stages) -> Vec<Variable<'_>> {
    let known = |values: &[Option<f64>]| -> Vec<f64> {
        let values = values.iter();
        values.map(|value| value.unwrap_or(f64::NAN)).collect()
    };
    let of = |name, unit, long_name, values: Vec<f64>| {
        Variable::new(name, &["passages"], unit, long_name, move || values.clone())
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

fn over_wavelength(bands: &[Band]) -> Vec<Variable<'_>> {
    type Of = fn(&Band) -> Option<f64>;
    let of = |(name, unit, long_name, value): (_, _, _, Of)| {
        Variable::new(name, &["wavelength"], unit, long_name, move || {
            bands.iter().map(|band| value(band).unwrap_or(f64::NAN)).collect()
        })
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

fn over_both(bands: &[Band]) -> Vec<Variable<'_>> {
    type Of = fn(&Band) -> &[f64];
    let of = |(name, unit, long_name, value): (_, _, _, Of)| {
        Variable::new(name, &["passages", "wavelength"], unit, long_name, move || {
            let stages = 0..bands.first().map_or(0, |band| value(band).len());
            let row = |stage: usize| bands.iter().map(move |band| value(band)[stage]);
            stages.flat_map(row).collect()
        })
    };
    let variables: [(_, _, _, Of); 3] = [
        ("level", DECIBELS, "one-third-octave level", |band| &band.level_db),
        ("linear_level", DECIBELS, "level of the linear loop", |band| &band.linear_level_db),
        ("shift", "m", "shift of the waves, in the direction of travel", |band| &band.shift_m),
    ];
    variables.into_iter().map(of).collect()
}
