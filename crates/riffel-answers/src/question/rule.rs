//! Which keys of a question need or exclude others.

use super::Key;

/// A rule between keys.
#[derive(Debug, Clone, Copy)]
pub enum Rule {
    /// Each of the first keys needs one of the others.
    Needs(&'static [&'static str], &'static [&'static str]),
    /// At least one of these keys is given.
    AnyOf(&'static [&'static str]),
    /// At most one of these keys is given.
    OneOf(&'static [&'static str]),
    /// One of these keys is given, and no other of them.
    JustOneOf(&'static [&'static str]),
    /// The first key is given without any of the others.
    Excludes(&'static str, &'static [&'static str]),
}

impl Rule {
    /// `Ok` if the keys that are given keep to the rule.
    ///
    /// # Errors
    /// The sentence about the first key at fault.
    pub(super) fn check(self, keys: &[Key], is_given: &dyn Fn(&str) -> bool) -> Result<(), String> {
        let option = |name: &str| keys.iter().find(|key| key.name == name).map_or_else(|| name.to_owned(), Key::option);
        let wrong = |name: &str, rule: String| Err(format!("{} {rule}", option(name)));
        let any = |names: &[&str]| names.iter().map(|name| option(name)).collect::<Vec<_>>().join(" or ");
        match self {
            Self::Needs(names, others) if !others.iter().any(|other| is_given(other)) => {
                let needy = names.iter().find(|name| is_given(name));
                needy.map_or(Ok(()), |name| wrong(name, format!("needs {}", any(others))))
            }
            Self::OneOf(names) | Self::JustOneOf(names) if names.iter().filter(|name| is_given(name)).count() > 1 => {
                let given: Vec<&str> = names.iter().copied().filter(|name| is_given(name)).collect();
                wrong(given[0], format!("cannot be used with {}", option(given[1])))
            }
            Self::Excludes(name, others) if is_given(name) => match others.iter().find(|other| is_given(other)) {
                Some(other) => wrong(name, format!("cannot be used with {}", option(other))),
                None => Ok(()),
            },
            Self::AnyOf(names) | Self::JustOneOf(names) if !names.iter().any(|name| is_given(name)) => {
                Err(format!("{} is missing", any(names)))
            }
            _ => Ok(()),
        }
    }
}
