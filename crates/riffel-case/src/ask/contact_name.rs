//! What the contacts of a loop on all axes are called.

use riffel::Loop;
use serde::Serialize;

use crate::Case;

/// One of several contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ContactName {
    /// Number of the wheel from the first on, which is 1.
    pub wheel: usize,
    /// Its rail, "left" or "right".
    pub rail: &'static str,
}

impl ContactName {
    /// Of all contacts, in their order.
    pub(crate) fn all(of: &Loop) -> Vec<Self> {
        let mut places: Vec<f64> = Vec::new();
        let contacts = of.contacts().iter().map(|contact| {
            let known = places.iter().position(|&along| along == contact.along);
            let wheel = known.unwrap_or_else(|| {
                places.push(contact.along);
                places.len() - 1
            });
            Self { wheel: 1 + wheel, rail: contact.rail.name() }
        });
        contacts.collect()
    }
}

/// Names of the contacts of a loop on all axes, that under study first; none of a loop of one wheel and one axis.
pub fn contact_names(case: &Case) -> Vec<ContactName> {
    match case.feedback.is_along_one_axis() {
        true => Vec::new(),
        false => ContactName::all(&case.feedback),
    }
}
