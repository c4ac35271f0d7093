//! Structures that are given with the case, not by it.

use std::sync::Arc;

use riffel::{Complex64, Receptance, receptance::MeasuredReceptance};
use riffel_keys::{CaseError, Remark};

use crate::file::VerticalAxis;
use crate::measurement;
use crate::track::Origin;

/// A vertical receptance that takes the place of the model of the case: a finite-element track, a flexible
/// wheelset, a measurement in memory.
#[derive(Clone)]
pub struct GivenReceptance {
    pub(crate) receptance: Arc<dyn Receptance>,
    /// The same where it is a table.
    pub(crate) table: Option<Arc<MeasuredReceptance>>,
    pub(crate) remarks: Vec<Remark>,
}

impl GivenReceptance {
    /// Any receptance \[m/N\], time factor exp(+iωt), downward.
    pub fn new(receptance: Arc<dyn Receptance>) -> Self {
        Self {
            receptance,
            table: None,
            remarks: Vec::new(),
        }
    }

    /// A frequency response that another program read from a universal file. Displacement, velocity or acceleration
    /// per force; what stands at 0 Hz is left out.
    ///
    /// # Errors
    /// [`CaseError::Data`] for another function, a unit that does not fit, or frequencies with gaps.
    pub fn of_universal(function: &UniversalFunction) -> Result<Self, CaseError> {
        let measured = measurement::of_universal(function).map_err(|error| CaseError::Data {
            path: function.title.clone().into(),
            line: None,
            message: error.message,
            help: None,
        })?;
        Ok(Self::of_table(measured.receptance, measured.remarks))
    }

    /// A table, with a remark where it is not passive.
    pub fn measured(receptance: MeasuredReceptance) -> Self {
        let remarks = measurement::activity(&receptance, measurement::Remedy::Conjugate);
        Self::of_table(receptance, remarks.into_iter().collect())
    }

    fn of_table(receptance: MeasuredReceptance, remarks: Vec<Remark>) -> Self {
        let table = Arc::new(receptance);
        Self {
            receptance: table.clone(),
            table: Some(table),
            remarks,
        }
    }

    /// Where it comes from.
    pub(crate) fn origin(&self) -> Origin {
        self.table.clone().map_or(Origin::Given, Origin::Measured)
    }
}

/// What is given in place of the models of a case.
#[derive(Clone, Default)]
pub(crate) struct Given {
    pub(crate) track: Option<GivenReceptance>,
    pub(crate) wheel: Option<GivenReceptance>,
}

/// A function at a nodal degree of freedom (dataset 58) by the numbers of the format.
#[derive(Debug, Clone, PartialEq)]
pub struct UniversalFunction {
    /// First line of its description.
    pub title: String,
    /// Kind of function: 4 for a frequency response.
    pub function_type: i32,
    /// Load case: 0 for an excitation at one point.
    pub load_case: i32,
    /// Direction of the response: 1 to 3 along x, y, z, negative in the other sense.
    pub response_direction: i32,
    /// Direction of the excitation.
    pub reference_direction: i32,
    /// The axis that is vertical.
    pub vertical_axis: VerticalAxis,
    /// What the abscissa is: 18 for frequency.
    pub abscissa_kind: i32,
    /// What the numerator is, and its unit; SI where there is none.
    pub numerator: (i32, String),
    /// What the denominator is, and its unit.
    pub denominator: (i32, String),
    /// Frequencies \[Hz\].
    pub frequencies: Vec<f64>,
    /// The response at each.
    pub values: Vec<Complex64>,
}
