//! A wording with names in braces for its values.

/// A piece of a wording.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Piece<'a> {
    /// What stands as it is.
    Words(&'a str),
    /// The place of a value.
    Value(&'a str),
}

/// A wording in pieces.
#[derive(Debug, Clone)]
pub(crate) struct Wording<'a> {
    pub(crate) pieces: Vec<Piece<'a>>,
    /// Length of its own words [bytes].
    pub(crate) own: usize,
}

impl<'a> Wording<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        let mut pieces = Vec::new();
        let mut rest = text;
        while let Some((before, after)) = rest.split_once('{') {
            // A catalogue whose braces do not close is found by the tests.
            let (name, after) = after.split_once('}').unwrap_or((after, ""));
            if !before.is_empty() {
                pieces.push(Piece::Words(before));
            }
            pieces.push(Piece::Value(name));
            rest = after;
        }
        if !rest.is_empty() {
            pieces.push(Piece::Words(rest));
        }
        let own = pieces.iter().map(|piece| match piece {
            Piece::Words(words) => words.len(),
            Piece::Value(_) => 0,
        });
        Self {
            own: own.sum(),
            pieces,
        }
    }

    /// Whether it has words of its own, and not marks alone.
    pub(crate) fn has_words(&self) -> bool {
        self.pieces.iter().any(|piece| match piece {
            Piece::Words(words) => words.contains(char::is_alphabetic),
            Piece::Value(_) => false,
        })
    }

    /// Of each value, whether it stands in quotation marks.
    pub(crate) fn quoted(&self) -> impl Iterator<Item = bool> {
        let before = std::iter::once(None).chain(self.pieces.iter().map(Some));
        let pairs = before.zip(&self.pieces);
        pairs.filter_map(|(before, piece)| match (before, piece) {
            (_, Piece::Words(_)) => None,
            (Some(Piece::Words(words)), _) => Some(words.ends_with(['"', '`', '\'', '“'])),
            _ => Some(false),
        })
    }

    /// Its names, in their order.
    #[cfg(test)]
    pub(crate) fn names(&self) -> impl Iterator<Item = &'a str> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Value(name) => Some(*name),
            Piece::Words(_) => None,
        })
    }

    /// The values that make the sentence of this wording, the shortest first ones where several do; a value is never empty.
    pub(crate) fn values<'s>(&self, sentence: &'s str) -> Option<Vec<(&'a str, &'s str)>> {
        if !self.may_fit(sentence) {
            return None;
        }
        let mut values = Vec::new();
        let fits = fits(&self.pieces, sentence, &mut values) && !self.swallows(&values);
        fits.then_some(values)
    }

    /// Whether a value has the file or the key before the sentence in it, as in `a.toml: the radius is …` or
    /// `` `contact`: `contact.friction` is … ``.
    fn swallows(&self, values: &[(&str, &str)]) -> bool {
        let begins = match self.pieces[..] {
            // The file or the key itself, whatever it is.
            [Piece::Value(_), Piece::Words(": "), Piece::Value(_)] => false,
            [Piece::Value(name), Piece::Words(_), ..] => !matches!(name, "edition" | "sentence"),
            _ => false,
        };
        let is_prefix = |value: &str| value.contains(": ") || value.ends_with(':');
        let code = self.pieces.windows(2).any(|pair| match pair {
            [Piece::Words(words), Piece::Value(name)] if words.ends_with('`') => values
                .iter()
                .any(|(own, value)| own == name && value.contains('`')),
            _ => false,
        });
        code || (begins && values.first().is_some_and(|(_, value)| is_prefix(value)))
    }

    /// Whether its words stand in a sentence in their order: quick, and false of nearly all.
    fn may_fit(&self, sentence: &str) -> bool {
        if let Some(Piece::Words(words)) = self.pieces.last()
            && !sentence.ends_with(words)
        {
            return false;
        }
        let mut rest = sentence;
        self.pieces
            .iter()
            .enumerate()
            .all(|(place, piece)| match piece {
                Piece::Words(words) => match (place, rest.find(words)) {
                    (0, Some(1..)) | (_, None) => false,
                    (_, Some(at)) => {
                        rest = &rest[at + words.len()..];
                        true
                    }
                },
                Piece::Value(_) => true,
            })
    }

    /// The sentence with values in the place of their names.
    pub(crate) fn filled(&self, value: impl Fn(&str) -> String) -> String {
        let pieces = self.pieces.iter().map(|piece| match piece {
            Piece::Words(words) => (*words).to_owned(),
            Piece::Value(name) => value(name),
        });
        pieces.collect()
    }
}

fn fits<'a, 's>(
    pieces: &[Piece<'a>],
    sentence: &'s str,
    values: &mut Vec<(&'a str, &'s str)>,
) -> bool {
    match pieces {
        [] => sentence.is_empty(),
        [Piece::Words(words), rest @ ..] => match sentence.strip_prefix(words) {
            Some(after) => fits(rest, after, values),
            None => false,
        },
        [Piece::Value(name)] => {
            values.push((name, sentence));
            may_stand(name, sentence)
        }
        [Piece::Value(name), rest @ ..] => {
            let mut ends = sentence.char_indices().skip(1).map(|(end, _)| end);
            let known = values.len();
            ends.any(|end| {
                // Most ends are not followed by the words that must come.
                if let Piece::Words(words) = rest[0]
                    && !sentence[end..].starts_with(words)
                {
                    return false;
                }
                values.truncate(known);
                values.push((name, &sentence[..end]));
                may_stand(name, &sentence[..end]) && fits(rest, &sentence[end..], values)
            })
        }
    }
}

/// Whether a value may have this name; that a sentence is one is for the catalogue to tell.
fn may_stand(name: &str, value: &str) -> bool {
    let number = |c: char| c.is_ascii_digit() || "+-−.,e".contains(c);
    let of_one_sentence = || !value.contains("; ") && sentence_end(value).is_none();
    match name {
        "edition" | "sentence" => !value.is_empty(),
        "name" => !value.is_empty() && !value.contains(' '),
        // What stands before a colon is another's.
        "what" => !value.is_empty() && of_one_sentence() && !value.contains(": "),
        "count" | "number" => {
            value.chars().all(number) && value.contains(|c: char| c.is_ascii_digit())
        }
        _ => !value.is_empty() && of_one_sentence(),
    }
}

/// Where a sentence ends and the next one begins.
pub(crate) fn sentence_end(english: &str) -> Option<[usize; 2]> {
    let mut stops = english.match_indices(". ").map(|(at, _)| at);
    let stop = stops.find(|at| english[at + 2..].starts_with(char::is_uppercase))?;
    Some([stop + 1, stop + 2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_gives_its_values_back() {
        let wording = Wording::new("{a} of {b} mm, {c}");
        assert_eq!(
            wording.values("3 of 4 of 5 mm, x, y"),
            Some(vec![("a", "3"), ("b", "4 of 5"), ("c", "x, y")])
        );
        assert_eq!(wording.values(" of 5 mm, x"), None);
        assert_eq!(wording.values("file: 3 of 5 mm, x"), None);
        assert_eq!(wording.own, " of  mm, ".len());
        assert!(
            Wording::new("{a} \"{b}\" `{c}`")
                .quoted()
                .eq([false, true, true])
        );
        assert_eq!(wording.filled(|name| name.to_uppercase()), "A of B mm, C");
        assert_eq!(
            Wording::new("é{a}é").values("éééé"),
            Some(vec![("a", "éé")])
        );
    }
}
