//! Recipes for profiles that are made, not measured.

use std::f64::consts::PI;
use std::path::Path;

use riffel::roughness::{ColouredNoise, Dropout, Irregularity, Recipe, Sinusoid};
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile, say};
use serde::Deserialize;

/// `cases/roughness-recipe.toml`, commented: what `--synthesise` makes when it is given no recipe.
pub const DEFAULT_RECIPE: &str = include_str!("../cases/roughness-recipe.toml");

/// One recipe for each rail.
#[derive(Debug, Clone, PartialEq)]
pub struct RecipeFile {
    /// Names and recipes of the rails.
    pub rails: Vec<(String, Recipe)>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RecipeKeys {
    length: Quantity<Length>,
    spacing: Quantity<Length>,
    #[serde(default)]
    seed: u64,
    #[serde(default = "one_rail")]
    rails: Vec<String>,
    noise: Option<NoiseKeys>,
    #[serde(default)]
    sinusoid: Vec<SinusoidKeys>,
    #[serde(default)]
    spike: Vec<SpikeKeys>,
    #[serde(default)]
    pit: Vec<PitKeys>,
    #[serde(default)]
    dropout: Vec<DropoutKeys>,
}

fn one_rail() -> Vec<String> {
    vec!["rail".to_owned()]
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NoiseKeys {
    level_db: f64,
    wavelength: Quantity<Length>,
    slope_db_per_decade: f64,
    #[serde(default = "two_metres")]
    longest: Quantity<Length>,
}

fn two_metres() -> Quantity<Length> {
    Quantity::new(2.0)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SinusoidKeys {
    wavelength: Quantity<Length>,
    amplitude: Quantity<Length>,
    #[serde(default)]
    phase_degrees: f64,
    from: Option<Quantity<Length>>,
    to: Option<Quantity<Length>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SpikeKeys {
    at: Quantity<Length>,
    height: Quantity<Length>,
    width: Quantity<Length>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PitKeys {
    at: Quantity<Length>,
    depth: Quantity<Length>,
    width: Quantity<Length>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DropoutKeys {
    from: Quantity<Length>,
    to: Quantity<Length>,
}

impl RecipeFile {
    /// Read a recipe.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        Self::parse(&path.display().to_string(), &read_keys(path, "recipe")?)
    }

    /// Read a recipe from TOML; `name` is the one shown in errors. Every rail has its own noise, all
    /// else is alike.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = KeyFile::parse(name, text)?;
        let written: RecipeKeys = source.deserialize()?;
        if written.rails.is_empty() {
            return Err(source.invalid("rails", "is empty, but must name at least one rail", ""));
        }
        let length = written.length.si();
        let recipe = Recipe {
            length,
            spacing: written.spacing.si(),
            seed: written.seed,
            sinusoids: written
                .sinusoid
                .iter()
                .map(|wave| Sinusoid {
                    wavelength: wave.wavelength.si(),
                    amplitude: wave.amplitude.si(),
                    phase: wave.phase_degrees * PI / 180.0,
                    from: wave.from.map_or(0.0, |from| from.si()),
                    to: wave.to.map_or(length, |to| to.si()),
                })
                .collect(),
            noise: written.noise.as_ref().map(|noise| ColouredNoise {
                level: noise.level_db,
                wavelength: noise.wavelength.si(),
                slope: noise.slope_db_per_decade,
                longest: noise.longest.si(),
            }),
            spikes: written.spike.iter().map(|spike| irregularity(spike.at, spike.height, spike.width)).collect(),
            pits: written.pit.iter().map(|pit| irregularity(pit.at, pit.depth, pit.width)).collect(),
            dropouts: written
                .dropout
                .iter()
                .map(|dropout| Dropout { from: dropout.from.si(), to: dropout.to.si() })
                .collect(),
        };
        written.check(&source)?;
        // What the generator refuses it refuses for all rails alike; what is left is the number of samples.
        recipe.check().map_err(|error| source.invalid("spacing", error.to_string(), ""))?;
        let seeds = (0..).map(|rail| recipe.seed.wrapping_add(rail));
        let rails = written.rails.iter().zip(seeds).map(|(name, seed)| {
            let recipe = Recipe { seed, ..recipe.clone() };
            (name.clone(), recipe)
        });
        Ok(Self { rails: rails.collect() })
    }
}

impl RecipeKeys {
    /// What must be above zero is so.
    fn check(&self, source: &KeyFile) -> Result<(), CaseError> {
        let mut lengths = vec![("length".to_owned(), self.length), ("spacing".to_owned(), self.spacing)];
        if let Some(noise) = &self.noise {
            lengths.push(("noise.wavelength".to_owned(), noise.wavelength));
            lengths.push(("noise.longest".to_owned(), noise.longest));
        }
        for (index, wave) in self.sinusoid.iter().enumerate() {
            lengths.push((format!("sinusoid[{index}].wavelength"), wave.wavelength));
        }
        for (index, spike) in self.spike.iter().enumerate() {
            lengths.push((format!("spike[{index}].height"), spike.height));
            lengths.push((format!("spike[{index}].width"), spike.width));
        }
        for (index, pit) in self.pit.iter().enumerate() {
            lengths.push((format!("pit[{index}].depth"), pit.depth));
            lengths.push((format!("pit[{index}].width"), pit.width));
        }
        for (key, length) in lengths {
            if length.si() <= 0.0 {
                let rule = say!(is_but_must_be, value = length, rule = say!(greater_than_zero));
                return Err(source.invalid(&key, rule, ""));
            }
        }
        Ok(())
    }
}

fn irregularity(at: Quantity<Length>, height: Quantity<Length>, width: Quantity<Length>) -> Irregularity {
    Irregularity { at: at.si(), height: height.si(), width: width.si() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_recipe_reads() -> Result<(), CaseError> {
        let file = RecipeFile::parse("default", DEFAULT_RECIPE)?;
        assert_eq!(file.rails.len(), 2);
        assert_ne!(file.rails[0].1.seed, file.rails[1].1.seed);
        assert!(file.rails[0].1.heights().is_ok());
        Ok(())
    }

    #[test]
    fn wrong_recipes_are_refused() {
        for (text, part) in [
            ("length = 0\nspacing = 0.001", "`length` is 0 m, but must be greater than zero"),
            (
                "length = 1\nspacing = 0.001\n[[pit]]\nat = 0.5\ndepth = \"-3 um\"\nwidth = 0.01\n",
                "`pit[0].depth` is -3e-6 m",
            ),
            ("length = \"1e9 m\"\nspacing = \"1 mm\"", "`spacing`: length over spacing"),
            ("length = \"10 m\"", "`spacing` is missing"),
            ("length = 1\nspacing = 0.001\nrails = []", "`rails` is empty"),
            ("length = 1\nspacing = 0.001\n[[spike]]\nat = 1\nheight = 1\n", "width"),
        ] {
            let error = RecipeFile::parse("r.toml", text).unwrap_err();
            assert!(error.to_string().contains(part), "{error}");
        }
    }
}
