//! Names of what a folder of results holds.

/// The table of marginals.
pub(crate) const SUMMARY: &str = "summary.csv";
/// The draws, as ArviZ reads them.
pub(crate) const TREE: &str = "posterior.zarr";
/// Its groups.
pub(crate) const GROUPS: [&str; 7] =
    ["posterior", "sample_stats", "prior", "log_likelihood", "posterior_predictive", "observed_data", "constant_data"];
/// The parts of the chains.
pub(crate) const PARTS: &str = "chains";
/// Folders of compared models.
pub(crate) const MODELS: &str = "models";
