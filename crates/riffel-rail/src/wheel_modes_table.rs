//! Tables of the modes of wheels: data files with name and source.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use include_dir::{Dir, include_dir};
use riffel_keys::quantity::{Frequency, Length, Quantity};
use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile};
use riffel_noise::{Air, WheelMode, WheelModes};
use serde::Deserialize;

use crate::built_in::built_in;

/// The tables, built into the program; beside them what computes them.
static FILES: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/wheel-modes");

/// What is heard \[Hz\].
const AUDIBLE: [f64; 2] = [20.0, 20_000.0];
/// A wheel of which no part weighs less than a kilogram moves no more \[1/√kg\].
const LARGEST: f64 = 1.0;

/// The tables that come with Riffel, by file, as soon as they are asked for: what modes radiate takes seconds to compute.
static COMPUTED: Mutex<BTreeMap<String, WheelModesTable>> = Mutex::new(BTreeMap::new());

/// Modes of the web and the tyre of a wheel with where they come from.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelModesTable {
    /// Name for the command line.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Where the numbers come from.
    pub source: String,
    /// Rolling radius \[m\].
    pub rolling_radius: f64,
    /// What rings.
    pub modes: WheelModes,
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    name: String,
    title: String,
    source: String,
    rolling_radius: Quantity<Length>,
    tread_width: Quantity<Length>,
    radius: Vec<Quantity<Length>>,
    mode: Vec<ModeKeys>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ModeKeys {
    nodal_diameters: u32,
    frequency: Quantity<Frequency>,
    damping_ratio: f64,
    radial_at_contact: f64,
    radial_of_tread: f64,
    axial: Vec<f64>,
}

impl WheelModesTable {
    /// A table of the given name, or in the given file if the name ends in `.toml`.
    ///
    /// # Errors
    /// [`CaseError`] for a name that is not known, or with the key and the line of the file.
    pub fn find(name: &str) -> Result<Self, CaseError> {
        let known = built_in(
            &FILES,
            |name, text| Some((Self::name(name, text)?, (name.to_owned(), text.to_owned()))),
            |(name, _)| name,
        );
        let path = Path::new(name);
        if let Some((_, (file, text))) = known.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)) {
            let mut computed = COMPUTED.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(table) = computed.get(file) {
                return Ok(table.clone());
            }
            let table = Self::parse(file, text)?;
            computed.insert(file.clone(), table.clone());
            return Ok(table);
        }
        if path.extension().is_some_and(|extension| extension == "toml") {
            return Self::parse(name, &read_keys(path, "table of wheel modes")?);
        }
        let names: Vec<&str> = known.iter().map(|(name, _)| name.as_str()).collect();
        Err(CaseError::data(
            path,
            format!("no wheel has this name; there are {}, or a file that ends in .toml", names.join(", ")),
        ))
    }

    /// The name of a table, if a file is one.
    fn name(file: &str, text: &str) -> Option<String> {
        let keys: Keys = KeyFile::parse(file, text).ok()?.deserialize().ok()?;
        Some(keys.name)
    }

    /// Read a table from TOML; `name` is the one shown in errors.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = KeyFile::parse(name, text)?;
        let written: Keys = source.deserialize()?;
        if written.mode.is_empty() {
            return Err(source.invalid("mode", "a wheel without a mode does not ring", ""));
        }
        let radii: Vec<f64> = written.radius.iter().map(Quantity::si).collect();
        let rolling_radius = written.rolling_radius.si();
        let width = written.tread_width.si();
        let widest = radii.iter().copied().fold(0.0, f64::max);
        let refused = |key: &str, value: f64, rule: &str| {
            let rule = format!("is {value}, but must be {rule}");
            Err(source.invalid(key, &rule, ""))
        };
        if !(0.15..=1.0).contains(&rolling_radius) {
            return refused("rolling_radius", rolling_radius, "between 0.15 and 1 m");
        }
        if !(0.03..=0.3).contains(&width) {
            return refused("tread_width", width, "between 0.03 and 0.3 m");
        }
        if !(0.8..=1.2).contains(&(widest / rolling_radius)) {
            let rule = "radii of which the largest is that of the tread, within a fifth";
            return refused("radius", widest, rule);
        }
        for mode in &written.mode {
            let [lowest, highest] = AUDIBLE;
            let frequency = mode.frequency.si();
            if !(lowest..=highest).contains(&frequency) {
                return refused("mode", frequency, "of a frequency between 20 and 20000 Hz");
            }
            let displacements = [mode.radial_at_contact, mode.radial_of_tread];
            let all = mode.axial.iter().chain(&displacements);
            if let Some(value) = all.copied().find(|value| value.is_nan() || value.abs() > LARGEST) {
                let rule = "of displacements up to 1/√kg, those of a generalised mass of 1 kg";
                return refused("mode", value, rule);
            }
        }
        let modes = written.mode.into_iter().map(|mode| WheelMode {
            nodal_diameters: mode.nodal_diameters,
            frequency: mode.frequency.si(),
            damping_ratio: mode.damping_ratio,
            radial_at_contact: mode.radial_at_contact,
            radial_of_tread: mode.radial_of_tread,
            axial: mode.axial,
        });
        let modes: Vec<WheelMode> = modes.collect();
        let modes = WheelModes::new(rolling_radius, width, &radii, &modes, &Air::default())
            .map_err(|error| source.invalid("mode", error.to_string(), ""))?;
        Ok(Self { name: written.name, title: written.title, source: written.source, rolling_radius, modes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wheel_that_comes_with_riffel_rings() -> Result<(), CaseError> {
        let table = WheelModesTable::find("Straight-Web-920")?;
        assert_eq!(table.rolling_radius, 0.46);
        assert!(table.source.contains("wheel_modes.py"));
        let unknown = WheelModesTable::find("curved-web").unwrap_err();
        assert!(unknown.to_string().contains("straight-web-920"), "{unknown}");
        Ok(())
    }

    #[test]
    fn wrong_modes_are_refused_with_their_key() {
        let head = "name = \"n\"\ntitle = \"t\"\nsource = \"s\"\nrolling_radius = \"460 mm\"\n\
                    tread_width = \"135 mm\"\nradius = [\"200 mm\", \"460 mm\"]\n";
        let mode = "[[mode]]\nnodal_diameters = 2\nfrequency = \"2 kHz\"\ndamping_ratio = 1e-4\n\
                    radial_at_contact = 0.05\nradial_of_tread = 0.05\naxial = [0.0, 0.05]\n";
        let whole = format!("{head}{mode}");
        assert!(WheelModesTable::parse("w.toml", &whole).is_ok());
        for (from, to, part) in [
            ("1e-4", "1.0", "damping ratio"),
            ("[0.0, 0.05]", "[0.0]", "finite displacement"),
            ("\"200 mm\", \"460 mm\"", "\"460 mm\", \"200 mm\"", "increase"),
            ("2 kHz", "2 mm", "mm"),
            ("2 kHz", "2 MHz", "between 20 and 20000 Hz"),
            ("\"460 mm\"\ntread", "\"460\"\ntread", "`rolling_radius` is 460, but"),
            ("135 mm", "135 cm", "`tread_width` is 1.35, but"),
            ("\"200 mm\", \"460 mm\"", "\"200 mm\", \"260 mm\"", "`radius` is 0.26, but"),
            ("contact = 0.05", "contact = 45.7", "`mode` is 45.7, but"),
            ("nodal_diameters = 2", "nodal_diameters = -2", "-2"),
            (mode, "mode = []\n", "does not ring"),
        ] {
            let text = whole.replace(from, to);
            let error = WheelModesTable::parse("w.toml", &text).unwrap_err();
            assert!(error.to_string().contains(part), "{error}");
        }
    }
}
