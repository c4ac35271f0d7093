//! Names of the columns of tables: plain, so that a program can take them as they are.

/// Names with something to say before a quantity, such as `left_level_db` for a rail called "left" and `level_db`:
/// of lower-case letters, digits and underscores, each once. What a name has of other characters becomes an
/// underscore; umlauts are spelt out. A name of which nothing is left, or that is there already, is told by its
/// number.
pub(crate) fn names<'a>(subjects: impl IntoIterator<Item = &'a str>, quantity: &str) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for (index, subject) in subjects.into_iter().enumerate() {
        let subject = plain(subject);
        let numbered = |number: usize| match &*subject {
            "" => format!("column_{number}_{quantity}"),
            subject => format!("{subject}_{number}_{quantity}"),
        };
        let mut name = match &*subject {
            "" => numbered(index + 1),
            subject => format!("{subject}_{quantity}"),
        };
        let mut number = index + 1;
        while names.contains(&name) {
            name = numbered(number);
            number += 1;
        }
        names.push(name);
    }
    names
}

fn plain(subject: &str) -> String {
    let mut plain = String::new();
    for character in subject.chars().flat_map(char::to_lowercase) {
        match character {
            'a'..='z' | '0'..='9' => plain.push(character),
            'ä' => plain += "ae",
            'ö' => plain += "oe",
            'ü' => plain += "ue",
            'ß' => plain += "ss",
            _ if plain.is_empty() || plain.ends_with('_') => {}
            _ => plain.push('_'),
        }
    }
    plain.trim_end_matches('_').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain_and_each_is_there_once() {
        let subjects = ["soft pads", "Güterzug (40 %)", "右", "soft-pads", "Ŵ₁"];
        assert_eq!(
            names(subjects, "growth_rate_per_passage"),
            [
                "soft_pads_growth_rate_per_passage",
                "gueterzug_40_growth_rate_per_passage",
                "column_3_growth_rate_per_passage",
                "soft_pads_4_growth_rate_per_passage",
                "column_5_growth_rate_per_passage",
            ]
        );
    }
}
