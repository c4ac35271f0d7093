//! What a plan says of trains that are heard.

use riffel::contact::ContactFilter;
use riffel_case::ask;
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{CaseError, Message, Value, say};
use riffel_noise::{FrequencyBand, PassBy, Surroundings};
use riffel_rail::{Survey, WheelRoughness};

use super::{Reading, beside};
use crate::data::{DatedLevels, PassBys, Passage, Train};

/// Wheels on one rail of a train of which nothing is said: a coach.
const WHEELS: u32 = 4;
/// Where ISO 3095 measures: from the middle of the track, and above the rail \[m\].
const RECEIVER: (f64, f64) = (7.5, 1.2);
/// Standard deviation of what all levels of a place share: propagation and radiation \[dB\].
const OF_A_PLACE: f64 = 2.0;

impl Reading<'_> {
    pub(super) fn pass_bys(&mut self, index: usize, dated: &DatedLevels) -> Result<PassBys, CaseError> {
        let common_error = self.decibels(index, OF_A_PLACE)?;
        let view = self.view(index)?;
        let case = &self.views[view].case;
        if let Some(why) = ask::without_decay(case) {
            let rule = say!(is_pass_by_but, why);
            return Err(self.invalid(index, "kind", rule, say!(give_data_another_model)));
        }
        let data = &self.file.data[index];
        let speed = match data.speed {
            Some(speed) => Some(self.positive(index, "speed", speed.si())?),
            None => None,
        };
        let passage = Passage { train: self.train(index, ContactFilter::of(&case.hertz))?, speed };
        let path = beside(self.folder, &data.file);
        let (rows, silent) = PassBys::rows(&path, case, dated, &passage)?;
        if !silent.is_empty() {
            let bands = frequencies(&silent);
            self.remarks.push(say!(silent_bands, file = &data.file, bands));
        }
        if data.wheel_roughness.is_none() {
            self.remarks.push(say!(wheels_taken_as_smooth, file = &data.file));
        }
        Ok(PassBys { view, rows, common_error, train: passage.train })
    }

    fn train(&self, index: usize, filter: ContactFilter) -> Result<Train, CaseError> {
        let data = &self.file.data[index];
        let length = |key: &str, value: Option<Quantity<Length>>, left_out: f64| {
            self.positive(index, key, value.map_or(left_out, |value| value.si()))
        };
        let wheels = f64::from(data.wheels.unwrap_or(WHEELS));
        let wheels = self.positive(index, "wheels", wheels)?;
        let of_coaches = PassBy::LENGTH_PER_WHEEL * wheels;
        let pass = PassBy::new(
            length("distance", data.distance, RECEIVER.0)?,
            length("height", data.height, RECEIVER.1)?,
            wheels,
            length("train_length", data.train_length, of_coaches)?,
            Surroundings::HardGround,
        );
        let pass = pass.map_err(|error| self.invalid(index, "distance", Message::from(&error), ""))?;
        let rest = data.roughness.as_ref();
        let rest = rest.map(|name| Survey::mean_of(&beside(self.folder, name)));
        let wheel = match &data.wheel_roughness {
            Some(name) => {
                let found = WheelRoughness::named_or_in(name, &beside(self.folder, name))?;
                let (_, spectrum) = found.ok_or_else(|| {
                    let known = WheelRoughness::names();
                    let rule = say!(a_file_or_one_of, names = known);
                    let rule = say!(is_name_but_must_be, name, rule);
                    self.invalid(index, "wheel_roughness", rule, "")
                })?;
                Some(spectrum)
            }
            None => None,
        };
        Ok(Train { pass, wheel, rest: rest.transpose()?, filter })
    }
}

/// Bands by their ends, those that follow each other together: "100–250 Hz, 4000 Hz".
fn frequencies(bands: &[FrequencyBand]) -> Value {
    let runs = bands.chunk_by(|one, next| next.index() == one.index() + 1);
    let run = |run: &[FrequencyBand]| match (run.first(), run.last()) {
        (Some(first), Some(last)) if run.len() > 1 => {
            format!("{}–{} Hz", first.nominal(), last.nominal())
        }
        _ => format!("{} Hz", run[0].nominal()),
    };
    runs.map(run).collect()
}
