//! Growth maps as files of numbers.

use std::io::{self, Write};
use std::path::Path;

use netcdf3::{DataSet, FileWriter, Version};
use riffel::{Complex64, GrowthMap};

use crate::AnswerError;

/// A quantity of every point of a map.
struct MapOutput {
    /// Its column in the table.
    column: &'static str,
    /// Its variable on the grid.
    variable: &'static str,
    /// What it is.
    long_name: &'static str,
    /// From Ŵ₁ and the growth rate that belongs to Ŵ₁ = 1.
    value: fn(Complex64, f64) -> f64,
}

/// What a map gives at every point, all without dimension. A new output is an entry here.
const OUTPUTS: [MapOutput; 3] = [
    MapOutput {
        column: "normalized_dissipation_re",
        variable: "normalized_dissipation_re",
        long_name: "real part of W1/(mu P0 V xi0), growth where negative",
        value: |dissipation, _| dissipation.re,
    },
    MapOutput {
        column: "normalized_dissipation_im",
        variable: "normalized_dissipation_im",
        long_name: "imaginary part of W1/(mu P0 V xi0)",
        value: |dissipation, _| dissipation.im,
    },
    MapOutput {
        column: "growth_rate_per_passage",
        variable: "growth_rate",
        long_name: "growth rate of the amplitude per passage of a wheel",
        value: |dissipation, rate| rate * dissipation.re,
    },
];

/// One row for each point of the map; `progress` is told of each speed that is written.
///
/// # Errors
/// Those of the file.
pub fn map_csv(map: &GrowthMap, file: &mut impl Write, progress: impl Fn(usize)) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let outputs = OUTPUTS.iter().map(|output| output.column);
    writer.write_record(["wavelength_m", "speed_m_per_s"].into_iter().chain(outputs))?;
    let wavelengths = map.wavelength().values();
    let rate = map.growth_rate_per_dissipation();
    for (speed, row) in map.rows() {
        for (wavelength, &value) in wavelengths.iter().zip(row) {
            writer.serialize((
                wavelength,
                speed,
                OUTPUTS.map(|output| (output.value)(value, rate)),
            ))?;
        }
        progress(1);
    }
    writer.flush()
}

/// The map on its grid as NetCDF-3 with coordinates, units and long names: what `xarray.open_dataset`,
/// MATLAB's `ncread` and Panoply open.
///
/// # Errors
/// [`AnswerError::Grid`].
pub fn map_netcdf(map: &GrowthMap, title: &str, path: &Path) -> Result<(), AnswerError> {
    let wrong = |error: &dyn std::fmt::Debug| AnswerError::Grid(format!("{error:?}"));
    let rate = map.growth_rate_per_dissipation();
    let axes = [
        (
            "wavelength",
            "m",
            "wavelength of the corrugation",
            map.wavelength(),
        ),
        ("speed", "m/s", "speed of the vehicle", map.speed()),
    ];

    let define = || -> Result<DataSet, netcdf3::InvalidDataSet> {
        let mut data_set = DataSet::new();
        data_set.add_global_attr_string("title", title)?;
        data_set.add_global_attr_string("source", concat!("riffel ", env!("CARGO_PKG_VERSION")))?;
        data_set.add_global_attr_string("Conventions", "CF-1.8")?;
        data_set.add_fixed_dim("speed", map.speed().points())?;
        data_set.add_fixed_dim("wavelength", map.wavelength().points())?;
        let mut define = |name: &str, dimensions: &[&str], unit: &str, long_name: &str| {
            data_set.add_var_f64(name, dimensions)?;
            data_set.add_var_attr_string(name, "units", unit)?;
            data_set.add_var_attr_string(name, "long_name", long_name)
        };
        for (name, unit, long_name, _) in axes {
            define(name, &[name], unit, long_name)?;
        }
        for output in &OUTPUTS {
            define(
                output.variable,
                &["speed", "wavelength"],
                "1",
                output.long_name,
            )?;
        }
        Ok(data_set)
    };
    let data_set = define().map_err(|error| wrong(&error))?;
    let write = || -> Result<(), netcdf3::WriteError> {
        let mut writer = FileWriter::create_new(path)?;
        writer.set_def(&data_set, Version::Offset64Bit, 0)?;
        for (name, _, _, axis) in axes {
            writer.write_var_f64(name, &axis.values())?;
        }
        // One at a time: a large map is not held several times over.
        for output in &OUTPUTS {
            let points = map.rows().flat_map(|(_, row)| row);
            let values: Vec<f64> = points.map(|&value| (output.value)(value, rate)).collect();
            writer.write_var_f64(output.variable, &values)?;
        }
        writer.close()
    };
    write().map_err(|error| wrong(&error))
}
