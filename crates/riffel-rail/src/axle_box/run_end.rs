//! The end of a run.

/// When and where a run ended, so that the next file can go on from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunEnd {
    /// \[s\]; `None` if there are no times.
    pub time: Option<f64>,
    /// \[m\].
    pub position: f64,
    /// \[m/s\].
    pub speed: f64,
}
