//! Subscripts: which characters of a text stand below its line.
//!
//! A figure writes them in its words as in any plain text: the digits ₀ to ₉, or an underscore between two single
//! letters, `m_w`. They are drawn as what they are, digits and letters that are smaller and lower.

/// Size of a subscript over that of its text.
pub(crate) const SIZE: f64 = 0.72;
/// Depth of its baseline below that of its text, in sizes of the text.
pub(crate) const DEPTH: f64 = 0.18;

/// Characters that stand on one line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) words: String,
    pub(crate) lowered: bool,
}

/// The text as runs, in their order.
pub(crate) fn runs(text: &str) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut push = |character: char, lowered: bool| match runs.last_mut() {
        Some(run) if run.lowered == lowered => run.words.push(character),
        _ => runs.push(Run { words: character.to_string(), lowered }),
    };
    let characters: Vec<char> = text.chars().collect();
    let mut index = 0;
    while let Some(&character) = characters.get(index) {
        if let Some(digit) = digit(character) {
            push(digit, true);
        } else if is_index(&characters, index) {
            index += 1;
            push(characters[index], true);
        } else {
            push(character, false);
        }
        index += 1;
    }
    runs
}

/// The digit that a subscript digit stands for.
fn digit(character: char) -> Option<char> {
    let value = u32::from(character).checked_sub(u32::from('₀'))?;
    char::from_digit(value, 10)
}

/// Whether the character is an underscore between a symbol and its index, both of one letter: `contact.normal_load`
/// and `site_b` have none.
fn is_index(characters: &[char], at: usize) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let letter = |at: usize| characters.get(at).is_some_and(|c| c.is_alphabetic());
    let ends = |at: Option<usize>| at.and_then(|at| characters.get(at)).is_none_or(|&c| !is_part(c));
    characters[at] == '_' && at > 0 && letter(at - 1) && letter(at + 1) && ends(at.checked_sub(2)) && ends(Some(at + 2))
}

/// The words of an element of SVG, already escaped, with their subscripts.
pub(crate) fn svg(escaped: &str) -> String {
    let runs = runs(escaped);
    if !runs.iter().any(|run| run.lowered) {
        return escaped.to_owned();
    }
    let mut words = String::new();
    let mut below = false;
    for run in runs {
        let Run { words: run, lowered } = run;
        words += &match (lowered, below) {
            // A shift is in sizes of the element that is shifted.
            (true, _) => {
                format!("<tspan dy=\"{:.3}em\" font-size=\"{:.0}%\">{run}</tspan>", DEPTH / SIZE, 100.0 * SIZE)
            }
            (false, true) => format!("<tspan dy=\"-{DEPTH:.3}em\">{run}</tspan>"),
            (false, false) => run,
        };
        below = lowered;
    }
    words
}

/// The words of an element of HTML, already escaped, with their subscripts; plotly.js reads the same markup.
pub(crate) fn html(escaped: &str) -> String {
    let element = |run: Run| match run.lowered {
        true => format!("<sub>{}</sub>", run.words),
        false => run.words,
    };
    runs(escaped).into_iter().map(element).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_of_symbols_are_subscripts_and_nothing_else_is() {
        assert_eq!(html("Re Ŵ₁ [-]"), "Re Ŵ<sub>1</sub> [-]");
        assert_eq!(html("C₁₁, m_w = 350 kg"), "C<sub>11</sub>, m<sub>w</sub> = 350 kg");
        assert_eq!(html("S_T"), "S<sub>T</sub>");
        for plain in ["contact.normal_load", "a_bc", "ab_c", "line_2.csv", "_a", "a_", "10⁻⁹ m²", ""] {
            assert_eq!(html(plain), plain);
        }
    }

    #[test]
    fn the_line_goes_on_where_it_was() {
        let svg = svg("P₁/P₀ &lt; 1");
        let shifts: Vec<f64> =
            svg.split("dy=\"").skip(1).map(|rest| rest[..rest.find("em").unwrap()].parse().unwrap()).collect();
        // Down by the size of the subscript, up by that of the text.
        let depth = shifts[0] * SIZE + shifts[1] + shifts[2] * SIZE + shifts[3];
        assert!(shifts.len() == 4 && depth.abs() < 1e-3, "{svg}");
    }
}
