//! Changes of a case by its keys, written or typed.

use riffel_keys::CaseError;
use toml::{Table, Value};

use crate::Case;
use crate::file::CaseFile;
use crate::file::setting::Setting;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

/// Changes of a case by its keys, in their order.
#[derive(Debug, Clone, Copy)]
pub enum Changes<'a> {
    /// Overrides `key=value`.
    Overrides(&'a [String]),
    /// Keys with their values.
    Settings(&'a [Setting]),
}

impl<'a> From<&'a [String]> for Changes<'a> {
    fn from(overrides: &'a [String]) -> Self {
        Self::Overrides(overrides)
    }
}

impl<'a> From<&'a [Setting]> for Changes<'a> {
    fn from(settings: &'a [Setting]) -> Self {
        Self::Settings(settings)
    }
}

impl Case {
    /// The case with other values of its keys, in SI. The keys are those of [`file`](Self::file), with presets and
    /// defaults filled in; what `change` leaves alone stays as it was written. A key that becomes `None` is left out,
    /// and filled in again where a preset has it. Of two keys that exclude each other the new one stays.
    ///
    /// ```
    /// use riffel_case::{Case, NOMINAL_CASE};
    /// use riffel_keys::quantity::Quantity;
    ///
    /// let case = Case::parse("nominal", NOMINAL_CASE, &[])?;
    /// let braking = case.edit(|keys| keys.contact.tractive_ratio = Some(Quantity::new(0.8)))?;
    /// assert!(braking.edit(|keys| keys.contact.friction = Quantity::new(-1.0)).is_err());
    /// # Ok::<(), riffel_keys::CaseError>(())
    /// ```
    ///
    /// # Errors
    /// [`CaseError::Changed`] with the key, the value and the rule; others as of [`with`](Self::with).
    pub fn edit(&self, change: impl FnOnce(&mut CaseFile)) -> Result<Self, CaseError> {
        let mut after = self.file.clone();
        change(&mut after);
        let table = |file: &CaseFile| Table::try_from(file).map_err(|error| self.refuse("", error.to_string()));
        let (mut set, mut removed) = (Vec::new(), Vec::new());
        differences("", &table(&self.file)?, &table(&after)?, &mut set, &mut removed);
        let mut text = self.unfilled.clone();
        removed.iter().for_each(|key| text.keys.remove(key));
        text.write(&set)?;
        self.rebuilt(text, Window::Map)
    }

    /// The case with changes after those it was read with. Presets are looked up anew.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn with<'a>(&self, changes: impl Into<Changes<'a>>) -> Result<Self, CaseError> {
        let mut text = self.unfilled.clone();
        match changes.into() {
            Changes::Overrides(overrides) => text.apply(overrides)?,
            Changes::Settings(settings) => text.write(settings)?,
        }
        self.rebuilt(text, Window::Map)
    }
}

impl CaseText {
    /// Give keys values in their order; otherwise as [`apply`](Self::apply).
    pub(crate) fn write(&mut self, settings: &[Setting]) -> Result<(), CaseError> {
        let has_wheelset = self.keys.has("wheelset");
        for (key, value) in settings {
            self.keys.write(key, value.clone())?;
        }
        self.spread_axes();
        self.replace_others(has_wheelset, settings.iter().map(|(key, _)| &**key));
        Ok(())
    }
}

/// The keys that differ in two tables: with their new values, or removed.
fn differences(parent: &str, before: &Table, after: &Table, set: &mut Vec<Setting>, removed: &mut Vec<String>) {
    let path = |key: &str| match parent {
        "" => key.to_owned(),
        parent => format!("{parent}.{key}"),
    };
    removed.extend(before.keys().filter(|key| !after.contains_key(*key)).map(|key| path(key)));
    for (key, value) in after {
        match (before.get(key), value) {
            (Some(Value::Table(before)), Value::Table(after)) => {
                differences(&path(key), before, after, set, removed);
            }
            (Some(before), after) if before == after => {}
            (_, value) => set.push((path(key), value.clone())),
        }
    }
}

#[cfg(test)]
mod tests {
    use riffel_keys::quantity::Quantity;

    use super::*;
    use crate::{METRO_CASE, NOMINAL_CASE};

    fn with(text: &str, overrides: &[&str]) -> Case {
        let overrides: Vec<String> = overrides.iter().map(|key| (*key).to_owned()).collect();
        Case::parse("case", text, &overrides).unwrap()
    }

    /// An edit is the override of the same value, over presets and between keys that exclude each other.
    #[test]
    fn edits_are_overrides_of_the_same_values() {
        let metro = with(METRO_CASE, &[]);
        let softer =
            metro.edit(|keys| keys.track.pad.get_or_insert_default().stiffness = Some(Quantity::new(5e7))).unwrap();
        assert_eq!(softer.file, with(METRO_CASE, &["track.pad.stiffness=50 kN/mm"]).file);
        let creeping = with(NOMINAL_CASE, &[])
            .edit(|keys| {
                keys.contact.creepage = Some(crate::file::Creepage::Longitudinal(Quantity::new(1e-3)));
                keys.title = None;
            })
            .unwrap();
        assert_eq!(creeping.file.contact.tractive_ratio, None);
        assert_eq!(creeping.file.title, None);
        assert_eq!(creeping.steady.creepages.longitudinal, 1e-3);
    }

    #[test]
    fn an_error_names_the_key_that_was_changed() {
        let case = with(NOMINAL_CASE, &["contact.friction=0.3"]);
        let Err(CaseError::Changed { key, message }) = case.edit(|keys| keys.contact.friction = Quantity::new(-2.0))
        else {
            panic!("friction may be negative");
        };
        assert_eq!(key, "contact.friction");
        assert!(message.to_string().starts_with("`contact.friction` is -2"), "{message}");
        let settings = [("contact.friction.left".to_owned(), Value::Float(0.1))];
        assert!(matches!(case.with(&settings[..]), Err(CaseError::Changed { .. })));
    }
}
