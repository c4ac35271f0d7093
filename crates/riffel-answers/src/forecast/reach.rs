//! When a limit is reached, in every unit that is known.

use riffel::forecast::TrafficGrowth;
use serde::Serialize;

/// When a limit is reached, as documents hold it.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(crate) struct ReachDocument {
    /// after | beyond-linear-range | never; null without a limit.
    limit_reached: Option<&'static str>,
    /// Null unless it is reached within the linear range.
    passages_to_limit: Option<f64>,
    mgt_to_limit: Option<f64>,
    months_to_limit: Option<f64>,
}

impl ReachDocument {
    /// With the months that some passages take, where they are known.
    pub(crate) fn new(
        limit_reached: Option<&'static str>,
        passages: Option<f64>,
        growth: &TrafficGrowth,
        months: impl Fn(f64) -> Option<f64>,
    ) -> Self {
        Self {
            limit_reached,
            passages_to_limit: passages,
            mgt_to_limit: passages.map(|passages| growth.mgt(passages)),
            months_to_limit: passages.and_then(months),
        }
    }
}
