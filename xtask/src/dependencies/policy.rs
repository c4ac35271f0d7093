//! `deny.toml`, as far as it can be checked without a network.

use std::collections::BTreeMap;
use std::fs;

use cargo_metadata::Package;
use cargo_metadata::semver::VersionReq;
use serde::Deserialize;
use spdx::{Expression, Licensee, ParseMode};

use crate::root;

/// The parts of `deny.toml` that are checked here; cargo-deny checks all of it.
#[derive(Deserialize)]
pub(super) struct Policy {
    licenses: Licenses,
    bans: Bans,
    sources: Sources,
}

#[derive(Deserialize)]
struct Licenses {
    /// Identifiers of SPDX, with an exception where there is one.
    allow: Vec<String>,
}

#[derive(Deserialize)]
struct Bans {
    /// Packages that may be there beside another version of theirs.
    skip: Vec<Named>,
    /// Packages that may not be there.
    deny: Vec<Named>,
}

#[derive(Deserialize)]
struct Named {
    /// A name, or a name and the versions that are meant, as in `name@1.2`.
    #[serde(rename = "crate")]
    spec: String,
    reason: String,
}

impl Named {
    fn is(&self, package: &Package) -> bool {
        let (name, versions) = self.spec.split_once('@').unwrap_or((&self.spec, "*"));
        let versions = VersionReq::parse(versions);
        package.name == name && versions.is_ok_and(|versions| versions.matches(&package.version))
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
struct Sources {
    allow_registry: Vec<String>,
}

impl Policy {
    pub(super) fn read() -> Result<Self, String> {
        let text = fs::read_to_string(root().join("deny.toml"))
            .map_err(|error| format!("cannot read deny.toml: {error}"))?;
        toml::from_str(&text).map_err(|error| format!("deny.toml: {error}"))
    }

    /// What packages break, a sentence each.
    pub(super) fn broken_by(&self, packages: &[Package]) -> Vec<String> {
        let mut broken = Vec::new();
        let mut versions: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for package in packages {
            let name = package.name.as_str();
            let sentence = |what: String| format!("{name} {} {what}", package.version);
            if !self.bans.skip.iter().any(|skipped| skipped.is(package)) {
                let version = package.version.to_string();
                versions.entry(name).or_default().push(version);
            }
            match licence(package) {
                Err(what) => broken.push(sentence(what)),
                Ok(licence) if !self.allows(&licence) => broken.push(sentence(format!(
                    "is licensed under {licence}, which licenses.allow does not cover"
                ))),
                Ok(_) => {}
            }
            let source = package.source.as_ref().map_or("", |source| &source.repr);
            let registry = source.strip_prefix("registry+").unwrap_or(source);
            if !self
                .sources
                .allow_registry
                .iter()
                .any(|allowed| allowed == registry)
            {
                broken.push(sentence(format!(
                    "is from {source}, which sources.allow-registry does not name"
                )));
            }
            if let Some(denied) = self.bans.deny.iter().find(|denied| denied.is(package)) {
                broken.push(sentence(format!("is in bans.deny: {}", denied.reason)));
            }
        }
        for (name, versions) in versions {
            if versions.len() > 1 {
                broken.push(format!(
                    "{name} is there in the versions {}, of which bans.skip names none",
                    versions.join(" and ")
                ));
            }
        }
        broken
    }

    fn allows(&self, licence: &Expression) -> bool {
        let allowed = self.licenses.allow.iter();
        let allowed: Vec<_> = allowed
            .filter_map(|text| Licensee::parse(text).ok())
            .collect();
        licence.evaluate(|asked| allowed.iter().any(|licensee| licensee.satisfies(asked)))
    }
}

/// The licence that a package states, which may use `/` for `OR` as of old.
pub(super) fn licence(package: &Package) -> Result<Expression, String> {
    let Some(text) = &package.license else {
        return Err("states no licence".to_owned());
    };
    Expression::parse_mode(text, ParseMode::LAX)
        .map_err(|error| format!("states a licence that is none, {text}: {}", error.reason))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(name: &str, version: &str, licence: &str, source: &str) -> Package {
        let manifest = serde_json::json!({
            "name": name, "version": version, "license": licence, "source": source,
            "id": name, "dependencies": [], "targets": [], "features": {}, "manifest_path": "Cargo.toml",
        });
        serde_json::from_value(manifest).unwrap()
    }

    #[test]
    fn what_is_not_allowed_is_named() {
        let policy: Policy = toml::from_str(
            r#"
            [licenses]
            allow = ["MIT", "Unicode-3.0", "Apache-2.0 WITH LLVM-exception"]
            [bans]
            skip = [{ crate = "old@1", reason = "" }]
            deny = [{ crate = "tls", reason = "no network" }]
            [sources]
            allow-registry = ["https://index"]
            "#,
        )
        .unwrap();
        let index = "registry+https://index";
        let allowed = [
            package("a", "1.0.0", "MIT/Apache-2.0", index),
            package("b", "1.0.0", "(MIT OR Apache-2.0) AND Unicode-3.0", index),
            package("c", "1.0.0", "Apache-2.0 WITH LLVM-exception", index),
            package("old", "1.0.0", "MIT", index),
            package("old", "2.0.0", "MIT", index),
        ];
        assert_eq!(policy.broken_by(&allowed), [""; 0]);
        let forbidden = [
            package("copyleft", "1.0.0", "GPL-3.0-only", index),
            package("half", "1.0.0", "MIT AND GPL-3.0-only", index),
            package("mirrored", "1.0.0", "MIT", "git+https://elsewhere"),
            package("tls", "1.0.0", "MIT", index),
            package("twice", "1.0.0", "MIT", index),
            package("twice", "2.0.0", "MIT", index),
            package("vague", "1.0.0", "as you like", index),
        ];
        let broken = policy.broken_by(&forbidden);
        let begins = [
            "copyleft 1.0.0 is licensed",
            "half 1.0.0 is licensed",
            "mirrored 1.0.0 is from git",
            "tls 1.0.0 is in bans.deny: no network",
            "vague 1.0.0 states a licence",
            "twice is there in the versions 1.0.0 and 2.0.0",
        ];
        assert_eq!(broken.len(), begins.len(), "{broken:#?}");
        for (sentence, beginning) in broken.iter().zip(begins) {
            assert!(sentence.starts_with(beginning), "{sentence}");
        }
    }
}
