//! Inputs to begin with: the files of the project that are of the kind a target reads, and the examples of the book.

use std::fs;
use std::path::{Path, PathBuf};

use super::Target;
use crate::root;

/// Longest file that is taken, bytes: mutations of long files take long and say no more.
const LONGEST: u64 = 20_000;

/// The inputs of a target.
pub(super) fn seeds(target: Target) -> Result<Vec<Vec<u8>>, String> {
    let mut seeds = Vec::new();
    for (folder, extensions) in places(target) {
        for path in files(&root().join(folder))? {
            let extension = path.extension().unwrap_or_default().to_string_lossy();
            let short = fs::metadata(&path).is_ok_and(|data| data.len() <= LONGEST);
            if extensions.contains(&&*extension) && short {
                seeds.push(read(&path)?);
            }
        }
    }
    let language = match target {
        Target::Roughness | Target::Receptance => "text",
        _ => "toml",
    };
    for page in files(&root().join("docs/src"))? {
        if page.extension().is_some_and(|extension| extension == "md") {
            let text = String::from_utf8_lossy(&read(&page)?).into_owned();
            seeds.extend(examples(&text, language));
        }
    }
    if target == Target::Roughness {
        seeds.extend(profiles());
    }
    Ok(seeds)
}

/// Folders of a target, and the extensions of its files there.
fn places(target: Target) -> Vec<(&'static str, &'static [&'static str])> {
    match target {
        Target::Case | Target::Traffic | Target::Plan | Target::Program => {
            vec![("cases", &["toml"])]
        }
        Target::Roughness => vec![("validation/reference/sbb-track-noise", &["csv"])],
        Target::Receptance => vec![
            ("crates/riffel-case/tests/universal-files", &["uff", "csv"]),
            ("validation/reference/receptance", &["csv"]),
        ],
    }
}

/// Profiles as instruments write them: a header or none, points or commas, one rail or two.
fn profiles() -> Vec<Vec<u8>> {
    let profile = |header: &str, separator: &str, comma: bool, first: f64| {
        let mut text = header.to_owned();
        for index in 0..60 {
            let height = (0.4 * f64::from(index)).sin() * 8.0;
            let row = format!(
                "{:.3}{separator}{height:.2}\n",
                first + 0.001 * f64::from(index)
            );
            text += &if comma { row.replace('.', ",") } else { row };
        }
        text.into_bytes()
    };
    vec![
        profile("position_m,height_um\n", ",", false, 0.0),
        profile("Kilometrierung [m];Höhe [µm]\n", ";", true, 12_400.0),
        profile("# heights in mm\n", "\t", false, 0.0),
        profile("", " ", false, 5.0),
        b"wavelength_mm,level_db\n63,-3.1\n50,2.0\n40,4.4\n31.5,0.2\n25,-6\n".to_vec(),
    ]
}

/// The fenced blocks of a page in a language.
fn examples(page: &str, language: &str) -> Vec<Vec<u8>> {
    let fence = format!("\n```{language}");
    let blocks = page.split(&fence).skip(1);
    let blocks = blocks.filter_map(|block| {
        let (_, block) = block.split_once('\n')?;
        let (block, _) = block.split_once("\n```")?;
        Some(format!("{block}\n").into_bytes())
    });
    blocks.collect()
}

fn files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let refused = |reason: std::io::Error| format!("cannot read {}: {reason}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(refused)? {
        files.push(entry.map_err(refused)?.path());
    }
    files.sort();
    Ok(files)
}

pub(super) fn read(path: &Path) -> Result<Vec<u8>, String> {
    fs::read(path).map_err(|reason| format!("cannot read {}: {reason}", path.display()))
}
