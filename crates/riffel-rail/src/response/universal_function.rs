//! A function of a universal file that another program read.

use riffel::Complex64;

use super::keys::VerticalAxis;

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
