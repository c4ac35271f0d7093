//! Results on grids as NetCDF-3: what `xarray.open_dataset`, MATLAB's `ncread` and Panoply open.

use std::path::Path;

use netcdf3::{DataSet, FileWriter, InvalidDataSet, Version, WriteError};

use crate::{AnswerError, Result};

/// A quantity on some axes of a grid; one with the name of its axis is the coordinate of that.
pub(crate) struct Variable<'a> {
    pub(crate) name: &'static str,
    /// Axes, the slowest first.
    pub(crate) axes: &'a [&'static str],
    /// CF convention, "1" without dimension.
    pub(crate) unit: &'a str,
    pub(crate) long_name: &'a str,
    /// NaN where there is none. Asked for when its turn comes, so that only one is held.
    pub(crate) values: Box<dyn Fn() -> Vec<f64> + 'a>,
}

impl<'a> Variable<'a> {
    /// A quantity with its values, asked for when their turn comes.
    pub(crate) fn new(
        name: &'static str,
        axes: &'a [&'static str],
        unit: &'a str,
        long_name: &'a str,
        values: impl Fn() -> Vec<f64> + 'a,
    ) -> Self {
        Self { name, axes, unit, long_name, values: Box::new(values) }
    }
}

/// Quantities on a grid.
pub struct Grid<'a> {
    pub(crate) title: String,
    /// Axes with their numbers of points.
    pub(crate) axes: Vec<(&'static str, usize)>,
    pub(crate) variables: Vec<Variable<'a>>,
}

impl Grid<'_> {
    /// Write it with coordinates, units and long names.
    ///
    /// # Errors
    /// [`AnswerError::Grid`].
    pub fn write(&self, path: &Path) -> Result<()> {
        let Self { title, axes, variables } = self;
        let wrong = |error: &dyn std::fmt::Debug| AnswerError::Grid(format!("{error:?}"));
        let define = || -> Result<DataSet, InvalidDataSet> {
            let mut data_set = DataSet::new();
            data_set.add_global_attr_string("title", title)?;
            data_set.add_global_attr_string("source", concat!("riffel ", env!("CARGO_PKG_VERSION")))?;
            data_set.add_global_attr_string("Conventions", "CF-1.8")?;
            for (name, points) in axes {
                data_set.add_fixed_dim(name, *points)?;
            }
            for variable in variables {
                data_set.add_var_f64(variable.name, variable.axes)?;
                data_set.add_var_attr_string(variable.name, "units", variable.unit)?;
                data_set.add_var_attr_string(variable.name, "long_name", variable.long_name)?;
            }
            Ok(data_set)
        };
        let data_set = define().map_err(|error| wrong(&error))?;
        let write = || -> Result<(), WriteError> {
            let mut writer = FileWriter::create_new(path)?;
            writer.set_def(&data_set, Version::Offset64Bit, 0)?;
            for variable in variables {
                writer.write_var_f64(variable.name, &(variable.values)())?;
            }
            writer.close()
        };
        write().map_err(|error| wrong(&error))
    }
}
