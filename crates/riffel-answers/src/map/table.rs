//! Growth maps as files of numbers.

use std::io::{self, Write};
use std::path::Path;

use netcdf3::{DataSet, FileWriter, Version};
use riffel::GrowthMap;

use crate::AnswerError;

/// One row for each point of the map; `progress` is told of each speed that is written.
///
/// # Errors
/// Those of the file.
pub fn map_csv(map: &GrowthMap, file: &mut impl Write, progress: impl Fn(usize)) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record([
        "wavelength_m",
        "speed_m_per_s",
        "normalized_dissipation_re",
        "normalized_dissipation_im",
        "growth_rate_per_passage",
    ])?;
    let wavelengths = map.wavelength().values();
    let rate = map.growth_rate_per_dissipation();
    for (speed, row) in map.rows() {
        for (wavelength, value) in wavelengths.iter().zip(row) {
            writer.serialize((wavelength, speed, value.re, value.im, rate * value.re))?;
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
    let grid = ["speed", "wavelength"];
    // Name, dimensions, unit, long name.
    let variables: [(&str, &[&str], &str, &str); 5] = [
        (
            "wavelength",
            &grid[1..],
            "m",
            "wavelength of the corrugation",
        ),
        ("speed", &grid[..1], "m/s", "speed of the vehicle"),
        (
            "normalized_dissipation_re",
            &grid,
            "1",
            "real part of W1/(mu P0 V xi0), growth where negative",
        ),
        (
            "normalized_dissipation_im",
            &grid,
            "1",
            "imaginary part of W1/(mu P0 V xi0)",
        ),
        (
            "growth_rate",
            &grid,
            "1",
            "growth rate of the amplitude per passage of a wheel",
        ),
    ];
    // One at a time: a large map is not held several times over.
    let values = |name: &str| -> Vec<f64> {
        let part = |part: &dyn Fn(&riffel::Complex64) -> f64| {
            map.rows().flat_map(|(_, row)| row).map(part).collect()
        };
        match name {
            "wavelength" => map.wavelength().values(),
            "speed" => map.speed().values(),
            "normalized_dissipation_re" => part(&|value| value.re),
            "normalized_dissipation_im" => part(&|value| value.im),
            _ => part(&|value| rate * value.re),
        }
    };

    let define = || -> Result<DataSet, netcdf3::InvalidDataSet> {
        let mut data_set = DataSet::new();
        data_set.add_global_attr_string("title", title)?;
        data_set.add_global_attr_string("source", concat!("riffel ", env!("CARGO_PKG_VERSION")))?;
        data_set.add_global_attr_string("Conventions", "CF-1.8")?;
        data_set.add_fixed_dim("speed", map.speed().points())?;
        data_set.add_fixed_dim("wavelength", map.wavelength().points())?;
        for (name, dimensions, units, long_name) in &variables {
            data_set.add_var_f64(name, dimensions)?;
            data_set.add_var_attr_string(name, "units", units)?;
            data_set.add_var_attr_string(name, "long_name", long_name)?;
        }
        Ok(data_set)
    };
    let data_set = define().map_err(|error| wrong(&error))?;
    let write = || -> Result<(), netcdf3::WriteError> {
        let mut writer = FileWriter::create_new(path)?;
        writer.set_def(&data_set, Version::Offset64Bit, 0)?;
        for (name, ..) in &variables {
            writer.write_var_f64(name, &values(name))?;
        }
        writer.close()
    };
    write().map_err(|error| wrong(&error))
}
