//! Every picture and table the program writes: words that stand clear of each other, plain heads of columns.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::sandbox::Sandbox;

/// A record of two rails from a chainage \[m\] on: corrugation of 50 mm all along, of 120 mm in its second half.
fn record(sandbox: &Sandbox, name: &str, chainage: f64, length: f64, step: f64) {
    let mut text = "chainage_m,left Höhe_um,right_um\n".to_owned();
    for index in 0..(length / step) as u32 {
        let along = f64::from(index) * step;
        let wave = |wavelength: f64| (std::f64::consts::TAU * along / wavelength).sin();
        let height = 3.0 * wave(0.05) + if along > 0.5 * length { 10.0 * wave(0.12) } else { wave(0.31) };
        let right = 0.5 * height + wave(0.7);
        writeln!(text, "{:.4},{height:.3},{right:.3}", chainage + along).unwrap();
    }
    fs::write(sandbox.path(name), text).unwrap();
}

/// The files with an extension in a folder and below it, by name.
fn files(folder: &Path, extension: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|known| known == extension) {
            found.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
        }
    }
    found
}

// Long: runs thirteen commands with all their pictures.
#[test]
fn words_stand_clear_and_heads_are_plain_in_all_that_is_written() {
    let sandbox = Sandbox::new();
    record(&sandbox, "chainage.csv", 12_400.1, 60.0, 0.001);
    record(&sandbox, "line.csv", 98_000.0, 1200.0, 0.01);
    record(&sandbox, "short.csv", 0.0, 10.0, 0.001);
    let small = "--set map.wavelength.points=31 --set map.speed.points=21";
    let periodic = "cases/discrete-supports.toml";
    let plan = fs::read_to_string(sandbox.path("cases/sensitivity.toml")).unwrap();
    let plan = plan.replace("samples = 512", "samples = 8").replace("nominal.toml", "cases/nominal.toml");
    fs::write(sandbox.path("sensitivity.toml"), plan).unwrap();
    fs::write(
        sandbox.path("variant.toml"),
        "title = \"Zwischenlagen, weich (80 MN/m) und ein Name, der länger ist als jedes Bild breit\"\n\
         [track]\npad = { stiffness = \"80 MN/m\" }\n",
    )
    .unwrap();
    for command in [
        &*format!("map {periodic} --bay -o bay {small}"),
        &format!("map cases/nominal.toml -o map {small}"),
        &format!("receptance {periodic} -o receptance --points 100"),
        &format!("receptance {periodic} -o narrow --from 420 --to 560 --points 50"),
        "contact cases/nominal.toml -o contact --ratio 4,16 --set contact.grid=24",
        "roughness chainage.csv -o chainage",
        "roughness line.csv -o line",
        "roughness short.csv -o short",
        &format!("diagnose {periodic} --roughness chainage.csv -o diagnosis {small}"),
        &format!("forecast {periodic} --spectrum chainage.csv --traffic cases/traffic.toml -o forecast {small}"),
        &format!(
            "compare {periodic} --with variant.toml --with cases/friction-management.toml --speed \"100 km/h\" -o compare {small}"
        ),
        "study sensitivity.toml -o study",
        "study sensitivity study",
    ] {
        let outcome = sandbox.riffel(command);
        assert_eq!(outcome.status, Some(0), "{command}: {}", outcome.text);
    }
    let pictures = files(&sandbox.path(""), "svg");
    assert!(pictures.len() >= 14, "{} pictures", pictures.len());
    for (name, svg) in pictures {
        assert_eq!(riffel_plot::collisions(&svg), [""; 0], "{name}");
    }
    let tables = files(&sandbox.path(""), "csv");
    let inputs = sandbox.path("cases").display().to_string();
    let written = tables.iter().filter(|(name, _)| {
        !name.starts_with(&inputs)
            && !name.ends_with("chainage.csv")
            && !name.ends_with("line.csv")
            && !name.ends_with("short.csv")
    });
    let plain = |head: &str| !head.is_empty() && head.chars().all(|c| matches!(c, 'a'..='z' | '0'..='9' | '_'));
    let mut count = 0;
    for (name, table) in written {
        let heads: Vec<&str> = table.lines().next().unwrap_or_default().split(',').collect();
        assert!(heads.iter().all(|head| plain(head)), "{name}: {heads:?}");
        count += 1;
    }
    assert!(count >= 14, "{count} tables");
}

#[test]
fn chainage_is_drawn_in_kilometres_and_short_records_in_metres() {
    let sandbox = Sandbox::new();
    record(&sandbox, "chainage.csv", 12_400.1, 60.0, 0.001);
    record(&sandbox, "short.csv", 0.0, 30.0, 0.001);
    sandbox.riffel("roughness chainage.csv -o chainage");
    sandbox.riffel("roughness short.csv -o short");
    let picture = |folder: &str| fs::read_to_string(sandbox.path(&format!("{folder}/roughness.svg"))).unwrap();
    let words = |svg: &str| svg.split(['<', '>']).map(str::to_owned).collect::<Vec<_>>();
    let chainage = words(&picture("chainage"));
    for expected in ["position along the rail [km]", "12.42", "12.44"] {
        assert!(chainage.iter().any(|word| word == expected), "{expected} is not in {chainage:?}");
    }
    let short = words(&picture("short"));
    for expected in ["position along the rail [m]", "10", "20"] {
        assert!(short.iter().any(|word| word == expected), "{expected} is not in {short:?}");
    }
}
