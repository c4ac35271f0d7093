//! Which keys of a question need or exclude others.

use super::Key;

/// A rule between keys.
#[derive(Debug, Clone, Copy)]
pub enum Rule {
    /// The first key needs one of the others.
    Needs(&'static str, &'static [&'static str]),
    /// One of two keys is given.
    Either(&'static str, &'static str),
    /// At most one of these keys is given.
    OneOf(&'static [&'static str]),
}

impl Rule {
    /// `Ok` if the keys that are given keep to the rule.
    ///
    /// # Errors
    /// The sentence about the first key at fault.
    pub(super) fn check(self, keys: &[Key], is_given: &dyn Fn(&str) -> bool) -> Result<(), String> {
        let option = |name: &str| keys.iter().find(|key| key.name == name).map_or_else(|| name.to_owned(), Key::option);
        let wrong = |name: &str, rule: String| Err(format!("{} {rule}", option(name)));
        match self {
            Self::Needs(name, others) if is_given(name) && !others.iter().any(|other| is_given(other)) => {
                let others = others.iter().map(|other| option(other)).collect::<Vec<_>>();
                wrong(name, format!("needs {}", others.join(" or ")))
            }
            Self::OneOf(names) => {
                let mut given = names.iter().filter(|name| is_given(name));
                match (given.next(), given.next()) {
                    (Some(one), Some(other)) => wrong(one, format!("cannot be used with {}", option(other))),
                    _ => Ok(()),
                }
            }
            Self::Either(one, other) if !is_given(one) && !is_given(other) => {
                wrong(one, format!("or {} is missing", option(other)))
            }
            Self::Needs(..) | Self::Either(..) => Ok(()),
        }
    }
}
