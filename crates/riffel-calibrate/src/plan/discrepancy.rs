//! What a plan says of what the model misses.

use riffel_keys::{CaseError, Message, say};

use super::{Reading, name_of};
use crate::file::{DiscrepancyFile, Kind, SizeFile};
use crate::kernel::Kernel;
use crate::model::{Parameter, Role};
use crate::prior::Prior;

impl Reading<'_> {
    /// What the model misses of some data; its size becomes a parameter where it is unknown.
    pub(super) fn discrepancy(&mut self, index: usize) -> Result<Option<Kernel>, CaseError> {
        let data = &self.file.data[index];
        let Some(written) = &data.discrepancy else {
            self.remarks.push(say!(no_discrepancy, data = name_of(data)));
            return Ok(None);
        };
        let place = |key: &str| format!("data[{index}].discrepancy.{key}");
        let kernel = self.kernel(written, data.kind, &place)?;
        let unit = match data.kind {
            Kind::FrequencyResponse => "Np",
            Kind::DecayRate => "ln",
            Kind::DatedLevels | Kind::DatedProfiles => "dB per 1e6 passages",
            Kind::AxleBox | Kind::PassBy => "dB",
            Kind::Wear => "ln",
        };
        for (key, given, only) in [("unit", &written.unit, unit), ("grows", &written.grows, "with passages")] {
            if let Some(given) = given
                && (given != only || key == "grows" && unit != "dB per 1e6 passages")
            {
                let rule = say!(is_but_for_kind, value = given, only, kind = data.kind.name());
                return Err(self.source.invalid(&place(key), rule, say!(or_leave_it_out)));
            }
        }
        match written.standard_deviation {
            SizeFile::Known(size) if size.is_finite() && size >= 0.0 => {}
            SizeFile::HalfNormal { half_normal } if half_normal.is_finite() && half_normal > 0.0 => {
                self.parameters.push(Parameter {
                    name: format!("{}.discrepancy", name_of(data)),
                    unit: unit.to_owned(),
                    prior: Prior::HalfNormal(half_normal),
                    ends: [0.0, f64::INFINITY],
                    role: Role::Size,
                    in_data: None,
                });
            }
            _ => {
                let rule = say!(size_of_discrepancy);
                return Err(self.source.invalid(&place("standard_deviation"), rule, ""));
            }
        }
        Ok(Some(kernel))
    }

    fn kernel(
        &self,
        written: &DiscrepancyFile,
        kind: Kind,
        place: &impl Fn(&str) -> String,
    ) -> Result<Kernel, CaseError> {
        let wrong = |key: &str, rule: Message| self.source.invalid(&place(key), rule, "");

        match &*written.kind {
            "band" => return Ok(Kernel::Band),
            "gaussian-process" => {}
            other => {
                let rule = say!(this_or_that, this = "band", that = "gaussian-process");
                return Err(wrong("kind", say!(is_name_but_must_be, name = other, rule)));
            }
        }
        let over = match kind {
            Kind::FrequencyResponse | Kind::DecayRate => "ln frequency",
            _ => "ln wavelength",
        };
        if let Some(given) = &written.over
            && given != over
        {
            let rule = say!(is_but_for_kind, value = given, only = over, kind = kind.name());
            return Err(wrong("over", rule));
        }
        let usual = match kind {
            Kind::FrequencyResponse | Kind::DecayRate => ("matern-3/2", 0.5),
            _ => ("exponential", 0.35),
        };
        let length = written.length.unwrap_or(usual.1);
        if !(length.is_finite() && length > 0.0) {
            let rule = say!(is_but_must_be, value = length, rule = say!(greater_than_zero));
            return Err(wrong("length", rule));
        }
        let name = written.kernel.as_deref().unwrap_or(usual.0);
        Kernel::of(name, length).ok_or_else(|| {
            let rule = say!(one_of, names = Kernel::NAMES.join(", "));
            wrong("kernel", say!(is_name_but_must_be, name, rule))
        })
    }
}
