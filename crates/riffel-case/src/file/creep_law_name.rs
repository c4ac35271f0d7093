//! The name of a creep law in a case file.

use std::borrow::Cow;
use std::sync::LazyLock;

use riffel::contact::{CREEP_LAWS, CreepLawEntry};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// Steady creep law: one of the catalogue of the physics, or the exact theory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CreepLawName(&'static str);

/// All names, the exact theory last.
static NAMES: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    let names = CREEP_LAWS.iter().map(|entry| entry.name);
    names.chain([CreepLawName::HALF_SPACE.0]).collect()
});

impl CreepLawName {
    /// The paper's, equation (5).
    pub const CARTER_3D: Self = Self("carter-3d");
    /// Shen, Hedrick and Elkins (1983).
    pub const SHEN_HEDRICK_ELKINS: Self = Self("shen-hedrick-elkins");
    /// Polach (2000), with the parameters of `polach`.
    pub const POLACH: Self = Self("polach");
    /// Kalker's exact theory.
    pub const HALF_SPACE: Self = Self("half-space");

    /// The law of this name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let known = NAMES.iter().find(|known| **known == name);
        known.map(|known| Self(known))
    }

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        self.0
    }

    /// The law in the catalogue; none for the exact theory, which is no formula.
    pub(crate) fn entry(self) -> Option<&'static CreepLawEntry> {
        CREEP_LAWS.iter().find(|entry| entry.name == self.0)
    }
}

impl Serialize for CreepLawName {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0)
    }
}

impl<'de> Deserialize<'de> for CreepLawName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        Self::named(&name).ok_or_else(|| de::Error::unknown_variant(&name, &NAMES))
    }
}

impl JsonSchema for CreepLawName {
    fn schema_name() -> Cow<'static, str> {
        "CreepLawName".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let described = |name: &str, description: &str| json_schema!({ "description": description, "type": "string", "const": name });
        let laws = CREEP_LAWS.iter();
        let mut laws: Vec<Schema> = laws.map(|entry| described(entry.name, entry.description)).collect();
        laws.push(described(Self::HALF_SPACE.0, "Kalker's exact theory."));
        json_schema!({ "description": "Steady creep law.", "oneOf": laws })
    }
}
