//! Whether the loop oscillates without any profile, as data.

use riffel::feedback::Stability;
use serde::Serialize;

/// Oscillations that grow by themselves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct StabilityDocument {
    /// Two for each such oscillation; zero where the loop is stable.
    unstable_roots: usize,
    /// That of the highest; `None` if the loop is stable.
    frequency_hz: Option<f64>,
    /// Of its amplitude in time; `None` if the loop is stable, or the root is not found.
    growth_rate_per_s: Option<f64>,
    /// Each of them, the highest first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    roots: Vec<Root>,
}

/// One oscillation that grows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct Root {
    frequency_hz: f64,
    growth_rate_per_s: f64,
    /// False beyond the range of the track's model.
    counts: bool,
}

/// Stability at one of several speeds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct StabilityAtSpeed {
    speed_m_per_s: f64,
    #[serde(flatten)]
    stability: StabilityDocument,
}

impl StabilityDocument {
    /// Whether an oscillation grows by itself that the track's model reaches.
    pub(crate) fn oscillates(&self) -> bool {
        self.frequency_hz.is_some()
    }
}

impl From<Stability> for StabilityDocument {
    fn from(stability: Stability) -> Self {
        Self {
            unstable_roots: stability.unstable_roots,
            frequency_hz: stability.frequency,
            growth_rate_per_s: stability.growth_rate,
            roots: (stability.roots.iter())
                .map(|root| Root {
                    frequency_hz: root.frequency,
                    growth_rate_per_s: root.growth_rate,
                    counts: root.counts,
                })
                .collect(),
        }
    }
}

impl From<(f64, Stability)> for StabilityAtSpeed {
    fn from((speed_m_per_s, stability): (f64, Stability)) -> Self {
        Self { speed_m_per_s, stability: stability.into() }
    }
}
