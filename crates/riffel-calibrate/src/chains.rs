//! The draws of a calibration.

use crate::draw::Draw;

/// The draws of all chains behind their warm-up.
pub struct Chains {
    pub(crate) draws: Vec<Vec<Draw>>,
    /// ln of the evidence as each of them tells it, if they do.
    pub log_evidences: Vec<f64>,
}

impl Chains {
    /// Draws that lie evenly in all chains, so many at most.
    pub(crate) fn evenly(&self, most: usize) -> Vec<&Draw> {
        let all: Vec<&Draw> = self.draws.iter().flatten().collect();
        let count = all.len().min(most);
        (0..count).map(|index| all[index * all.len() / count]).collect()
    }
}
