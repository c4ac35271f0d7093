//! Where wheels of a vehicle run across the rail.

use std::sync::Arc;

use riffel_keys::{CaseError, Message, fixed, say};

use super::{VehicleRequest, WheelsOfVehicle};
use crate::Case;

/// Where the contact of a wheel runs across the rail.
#[derive(Debug, Clone, Copy)]
pub(super) struct AcrossRail {
    /// From the axis of the rail's profile to the field side \[m\]; `None` if only the distance from the line under study is known.
    outward: Option<f64>,
    /// Share of its passages that cover the line under study.
    pub(super) covering: f64,
}

impl VehicleRequest<'_> {
    /// Where the contact of a wheel runs, if the line under study is one across the rail or contacts are spread.
    ///
    /// Mass that comes off a band comes off that about the place of the wheel.
    pub(super) fn across(&self, wheel: &Case) -> Result<Option<AcrossRail>, CaseError> {
        let own = wheel.hertz.semi_axis_lateral();
        let Some(line) = self.traffic.file.line.measured_line else {
            let spread = self.spreads().lateral_position.is_some();
            return Ok(spread.then(|| AcrossRail { outward: None, covering: self.spreads().covering(own, 0.0) }));
        };
        let Some(outward) = wheel.keys.mean.wheel().and_then(|wheel| wheel.outward) else {
            let message = say!(line_measured_line_needs_profiles_of, name = self.name());
            return Err(self.traffic.source.refuse("line.measured_line", &message));
        };
        let band = wheel.file.wear.band_width.map_or(0.0, |width| 0.5 * width.si());
        Ok(Some(AcrossRail {
            outward: Some(outward),
            covering: self.spreads().covering(own.max(band), line.si() - outward),
        }))
    }

    /// Between which places the wheels run, and how many of them cover the measured line.
    pub(super) fn across_in_words(&self, parts: &[(f64, Arc<WheelsOfVehicle>)]) -> Option<Message> {
        let line = self.traffic.file.line.measured_line?;
        let wheels = || {
            let wheels = parts.iter().flat_map(|(share, part)| part.wheels.iter().map(move |wheel| (share, wheel)));
            wheels.filter_map(|(share, wheel)| Some((share * wheel.share, wheel.across?)))
        };
        let outward = || wheels().filter_map(|(_, across)| across.outward);
        let millimetres = |place: f64| fixed(1e3 * place, 1);
        Some(say!(
            wheels_across_rail,
            vehicle = self.name(),
            innermost = millimetres(outward().fold(f64::INFINITY, f64::min)),
            outermost = millimetres(outward().fold(f64::NEG_INFINITY, f64::max)),
            line = millimetres(line.si()),
            percent = fixed(100.0 * wheels().map(|(share, across)| share * across.covering).sum::<f64>(), 0)
        ))
    }
}
