//! The slip and the patch that the tractions of a rolling contact answer to.

use num_complex::Complex64;

use super::patch::Field;

/// The slip of each step without the unknown tractions \[m\], and what becomes of the patch.
pub(super) struct Forcing {
    pub(super) slip: Field<Complex64>,
    pub(super) deformation: Option<Deformation>,
}

/// A change of the patch, in coordinates that go with it.
pub(super) struct Deformation {
    /// Growth of the bound of each element over the bound \[-\].
    pub(super) bound: Vec<Complex64>,
    /// Growth of the area of each element \[-\].
    pub(super) elements: Vec<Complex64>,
    /// Growth of each step.
    pub(super) steps: Vec<Complex64>,
    /// −ik times the way that each step is displaced along the rail \[-\]: what lies there later is worn later.
    pub(super) displaced: Vec<Complex64>,
    /// −ik times the way of the patch as a whole \[-\]: the share by which it rolls slower than the wheel.
    pub(super) slower: Complex64,
}
