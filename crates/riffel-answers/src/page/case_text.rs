//! A case as the page sends it, read within limits.

use riffel::contact::HalfSpace;
use riffel_case::Case;
use riffel_case::file::ContactDynamics;
use riffel_keys::say;
use serde::Deserialize;

use crate::page::Fault;

/// Largest case, as text, in bytes.
pub const LARGEST_CASE: usize = 64 * 1024;

/// Most points of a map on the page; the program computes larger ones.
const MOST_MAP_POINTS: u64 = 250_000;

/// Finest grid of a non-steady contact on the page, the default: its table takes about a second.
const FINEST_GRID: u64 = HalfSpace::DEFAULT_ELEMENTS as u64;

/// A case as the page holds it.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CaseText {
    /// The text of a case file.
    Toml(String),
    /// Keys as JSON, quantities with their units in strings.
    Keys(toml::Table),
}

impl CaseText {
    /// The case as TOML.
    ///
    /// # Errors
    /// A [`Fault`] for a case that cannot be written, or is larger than [`LARGEST_CASE`].
    pub fn toml(&self) -> Result<String, Fault> {
        let text = match self {
            Self::Toml(text) => text.clone(),
            Self::Keys(keys) => {
                toml::to_string(keys).map_err(|error| Fault::bad(format!("the case cannot be written: {error}")))?
            }
        };
        if text.len() > LARGEST_CASE {
            return Err(Fault::refused(
                Fault::TOO_LARGE,
                say!(the_case_is_larger_than_kib, size = LARGEST_CASE / 1024),
                "",
            ));
        }
        Ok(text)
    }

    /// The case, checked, within what the page computes. It opens no file.
    ///
    /// # Errors
    /// A [`Fault`] with the key, the value and the rule.
    pub fn read(&self) -> Result<Case, Fault> {
        let text = self.toml()?;
        check_grid(&text)?;
        let case = Case::parse_sealed("case.toml", &text)?;
        let map = &case.file.map;
        let points = map.wavelength.points * map.speed.points;
        if points > MOST_MAP_POINTS {
            let larger =
                if map.wavelength.points < map.speed.points { "map.speed.points" } else { "map.wavelength.points" };
            return Err(Fault::of_key(
                larger,
                say!(map_points_are_more_than_the, points = points, most_map_points = MOST_MAP_POINTS),
                say!(lower_points_on_the_page),
            ));
        }
        Ok(case)
    }
}

/// Refuse what would take minutes before it is begun.
fn check_grid(text: &str) -> Result<(), Fault> {
    #[derive(Deserialize)]
    struct File {
        contact: Contact,
    }
    #[derive(Deserialize)]
    struct Contact {
        response: ContactDynamics,
        grid: u64,
    }
    // What does not read as this has the defaults, or a fault that the reader of the case names.
    match toml::from_str::<File>(text) {
        Ok(File { contact }) if contact.grid > FINEST_GRID && contact.response == ContactDynamics::NonSteady => {
            Err(Fault::of_key(
                "contact.grid",
                say!(contact_grid_is_but_the_page, grid = contact.grid, finest_grid = FINEST_GRID),
                say!(the_program_itself_goes_further),
            ))
        }
        _ => Ok(()),
    }
}
