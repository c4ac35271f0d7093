//! Flow by load without a threshold.

/// h = βP per passage (Carson & Johnson 1971, recalled): troughs deepen wherever the load is highest in them, below P2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// β \[m/N\].
    pub depth_per_force: f64,
}
