//! `riffel report`: one page with all sections that there is input for.

use std::fs;

use crate::sandbox::Sandbox;

const SECTIONS: [&str; 12] = [
    "Profile",
    "Moving RMS along the line",
    "Spectrum and limits",
    "Wavelength bands",
    "What to grind",
    "Growth map",
    "Diagnosis",
    "Forecast",
    "What-if",
    "Rolling noise",
    "Inputs and versions",
    "Warnings and limits of the models",
];

/// Headings of the numbered sections in their order.
fn headings(page: &str) -> Vec<String> {
    let parts = page.split("<h2>").skip(1);
    parts.filter_map(|part| part.split_once("</h2>")).map(|(heading, _)| heading.to_owned()).collect()
}

/// Nothing on the page asks for anything outside it, and no script runs.
fn stands_alone(page: &str) {
    for outside in ["http://", "https://", "<script", "<img", "<link", "@import", "url("] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(page.contains("default-src 'none'") && page.contains("@page"));
    assert_eq!(page.matches("<section").count(), page.matches("</section>").count());
    assert_eq!(page.matches("<figure").count(), page.matches("</figure>").count());
}

fn made(sandbox: &Sandbox) {
    let outcome = sandbox.riffel("roughness --synthesise -o profile.csv");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
}

#[test]
fn every_section_is_there() {
    let sandbox = Sandbox::new();
    made(&sandbox);
    fs::write(sandbox.path("site.toml"), "[site]\ntitle = \"Noise at <B>\"\nline = \"U2 & U3\"\n").unwrap();
    fs::write(sandbox.path("soft.toml"), "title = \"softer pads\"\n[track]\npad = { stiffness = \"40 MN/m\" }\n")
        .unwrap();
    let outcome = sandbox.riffel(
        "report cases/bhaskar-track.toml --roughness profile.csv --traffic cases/traffic.toml \
         --speed \"70 km/h\" --with soft.toml --site site.toml --limit-dba 90 -o page.html",
    );
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("page.html")).unwrap();
    stands_alone(&page);
    let expected: Vec<String> = std::iter::once("In brief".to_owned())
        .chain(SECTIONS.iter().enumerate().map(|(index, name)| format!("{} {name}", index + 1)))
        .collect();
    assert_eq!(headings(&page), expected);
    for part in [
        "Noise at &lt;B&gt;",
        "U2 &amp; U3",
        "EN ISO 3095:2013",
        "growth ridge",
        "softer pads",
        "grinding mark",
        "riffel 0.",
        "is heard at <b>",
        "Each alone would save: rail ground to EN ISO 3095:2013",
        "90 dB(A) are not reached",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert_eq!(page.matches("<code>").count(), 5);
    for hash in page.split("<code>").skip(1) {
        let hash = hash.split("</code>").next().unwrap();
        assert!(hash.len() == 64 && hash.bytes().all(|byte| byte.is_ascii_hexdigit()), "{hash}");
    }
}

/// How long each remedy lasts after grinding stands in the brief, and a remedy that cannot act is named as such.
// Long: writes reports with their remedies.
#[test]
fn remedies_are_compared_after_grinding() {
    let sandbox = Sandbox::new();
    made(&sandbox);
    let command = "report cases/nominal.toml --roughness profile.csv --traffic cases/traffic.toml \
                   --with cases/soft-pads.toml --with cases/friction-management.toml";
    let brief = |arguments: &str| {
        let outcome = sandbox.riffel(&format!("{command} {arguments}"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
        let page = fs::read_to_string(sandbox.path("report.html")).unwrap();
        stands_alone(&page);
        let brief = page.split("</ul>").next().unwrap().to_owned();
        (page, brief)
    };
    let (page, ground) = brief("--from-limit \"-6 dB\" --hold force");
    let from = "From 6 dB below EN ISO 3095:2013, Figure 2 the limit";
    assert!(ground.contains(from) && ground.contains("months as it is"), "{ground}");
    assert!(ground.contains("(held: force)"), "{ground}");
    assert!(ground.contains("Without any effect: \u{201c}soft pads\u{201d}"), "{ground}");
    assert!(page.contains("cannot act") && page.contains("rail without supports"));
    let (_, now) = brief("");
    assert!(now.contains("--from-limit says how long"), "{now}");
    assert!(now.contains("(held: ratio)"), "{now}");
}

/// The forecast of a rail measured twice goes by its own growth, whatever the coefficient; all else by the one that its change tells.
#[test]
fn the_wear_coefficient_is_fitted_to_an_earlier_record() {
    let sandbox = Sandbox::new();
    let shape = [(0.08, 4.0), (0.063, 6.0), (0.05, 9.0)];
    let write = |name: &str, grown: f64| {
        let mut text = "section,wavelength_m,level_db\n".to_owned();
        for (section, more) in [("A", 0.4), ("B", -0.1), ("C", -0.2), ("D", 0.3)] {
            for (wavelength, level) in shape {
                // Two decibels more of the wavelength that the model says grows most.
                let level = level + grown * (2.0 + more);
                text += &format!("{section},{wavelength},{level}\n");
            }
        }
        fs::write(sandbox.path(name), text).unwrap();
    };
    write("now.csv", 1.0);
    write("before.csv", 0.0);
    let report = |arguments: &str| {
        let command = "report cases/nominal.toml --roughness now.csv --traffic cases/traffic.toml";
        let outcome = sandbox.riffel(&format!("{command} {arguments}"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
        fs::read_to_string(sandbox.path("report.html")).unwrap()
    };
    let table = |page: &str| {
        let (_, section) = page.split_once(" Forecast</h2>").unwrap();
        let (_, table) = section.split_once("<table").unwrap();
        table.split_once("</table>").unwrap().0.to_owned()
    };
    let uncertain = "uncertain by a factor of three";
    let dated = report("--earlier before.csv --dates 2025-05-01,2026-05-01");
    let kept = report("--earlier before.csv --dates 2025-05-01,2026-05-01 --keep-coefficient");
    assert!(!kept.contains("growth goes by the wear coefficient of this rail"));
    assert!(kept.contains("wear coefficient"), "the fit is told");
    assert!(dated.contains("growth goes by the wear coefficient of this rail"), "{dated}");
    assert!(!dated.contains(uncertain));
    // 365 days of 6000 passages.
    let counted = report("--earlier before.csv --passages-between 2.19e6");
    let untouched = report("");
    for same in [&kept, &counted] {
        assert_eq!(table(&dated), table(same));
    }
    assert_ne!(table(&dated), table(&untouched));
    assert!(untouched.contains(uncertain));
    // Without the traffic since then there is no fit, and the report says why.
    let undated = report("--earlier before.csv");
    assert_eq!(table(&undated), table(&untouched));
    assert!(undated.contains("the axle passages since then are not known"));
    let outcome = sandbox
        .riffel("report cases/nominal.toml --roughness now.csv --traffic cases/traffic.toml --passages-between 1e6");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("--passages-between is 1000000, but must be left out"), "{}", outcome.text);
}

/// What has no input is one sentence at the end, and no empty section.
#[test]
fn what_is_missing_is_said_once() {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/reference/sbb-track-noise");
    let file = "validation/reference/sbb-track-noise/rail_roughness.csv";
    let outcome = sandbox.riffel(&format!(
        "report cases/discrete-supports.toml --roughness {file} --where laboratory=MBBM --speed \"136 km/h\""
    ));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("report.html")).unwrap();
    stands_alone(&page);
    assert_eq!(
        headings(&page),
        [
            "In brief",
            "1 Spectrum and limits",
            "2 Growth map",
            "3 Diagnosis",
            "4 Rolling noise",
            "5 Inputs and versions",
            "6 Warnings and limits of the models",
            "Not in this report"
        ]
    );
    for part in [
        "a fading grinding mark and not growing corrugation",
        "Profile: the record is a table of levels",
        "Forecast: no traffic was given",
        "What-if: no variant was given",
        // sha256sum of the file.
        "572a16865d394d5e02df5452bd6160750377d225b04d67ebbe61f4f960576737",
    ] {
        assert!(page.contains(part), "{part}");
    }
    let outcome = sandbox.riffel(&format!("report --roughness {file} -o without.html"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("without.html")).unwrap();
    assert!(page.contains("Diagnosis: no case was given."));
    assert!(!page.contains("Growth map</h2>"));
}

/// Without roughness a report is on the case: its map, and what would help.
#[test]
fn a_case_alone_has_a_report() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel("report cases/nominal.toml --with cases/soft-pads.toml");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("report.html")).unwrap();
    stands_alone(&page);
    assert_eq!(
        headings(&page),
        [
            "In brief",
            "1 Growth map",
            "2 What-if",
            "3 Inputs and versions",
            "4 Warnings and limits of the models",
            "Not in this report"
        ]
    );
    for part in [
        "grows fastest under the usual traffic of a main line (80–140 km/h, 6000 axles a day)",
        " mm leads and doubles in ",
        "Diagnosis: no roughness was given.",
        "cases/soft-pads.toml",
        "the rail has no support",
    ] {
        assert!(page.contains(part), "{part}");
    }
    // Limits are those of levels that nobody has measured.
    assert!(!page.contains("to the limit") && !page.contains("Measured wavelengths"));
}

/// Forecast and what-if take the spectra that the other sections show: the same rows of a table, and at the
/// latest date of these; the same profile, whatever it takes to read it.
// Long: writes reports of a table and of a profile.
#[test]
fn all_sections_are_of_the_same_record() {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/reference/sbb-track-noise");
    let outlook = "--traffic cases/traffic.toml --with cases/soft-pads.toml";
    // ACCON measured in 2014 and never again.
    let table = "validation/reference/sbb-track-noise/rail_roughness.csv --where laboratory=ACCON";
    let outcome = sandbox.riffel(&format!("report cases/nominal.toml --roughness {table} {outlook} -o table.html"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("table.html")).unwrap();
    assert!(headings(&page).iter().any(|name| name.ends_with("Forecast")));
    // Heights alone.
    made(&sandbox);
    let profile = fs::read_to_string(sandbox.path("profile.csv")).unwrap();
    let heights: Vec<&str> = profile.lines().skip(1).filter_map(|line| line.split(',').nth(1)).collect();
    fs::write(sandbox.path("heights.txt"), heights.join("\n")).unwrap();
    let outcome = sandbox.riffel(&format!(
        "report cases/nominal.toml --roughness heights.txt --spacing \"1 mm\" {outlook} -o heights.html"
    ));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("heights.html")).unwrap();
    assert!(headings(&page).iter().any(|name| name.ends_with("What-if")));
}

// Long: starts the program 17 times.
#[test]
fn bad_input_is_refused_and_leaves_nothing() {
    let sandbox = Sandbox::new();
    made(&sandbox);
    fs::write(sandbox.path("site.toml"), "[site]\nlien = \"U2\"\n").unwrap();
    for (arguments, part) in [
        ("cases/nominal.toml --roughness missing.csv", "missing.csv"),
        ("cases/missing.toml --roughness profile.csv", "missing.toml"),
        ("cases/nominal.toml --roughness profile.csv --site site.toml", "lien"),
        ("cases/nominal.toml --roughness profile.csv --limit none", "no limit table"),
        ("cases/nominal.toml --roughness profile.csv --traffic missing.toml", "missing.toml"),
        ("--roughness profile.csv --with soft.toml", "CASE"),
        ("", "--roughness or <CASE> is missing"),
        ("cases/nominal.toml --speed \"80 km/h\"", "--roughness"),
        // What is asked for and cannot be told is not left out.
        ("cases/nominal.toml --wheel-modes straight-web-920", "--wheel-modes needs --roughness"),
        ("cases/bhaskar-track.toml --roughness profile.csv --wheel-modes none", "none: no wheel has this name"),
        (
            "cases/nominal.toml --roughness profile.csv --wheel-modes straight-web-920",
            "--wheel-modes is straight-web-920, but must be left out: the rail of track.model",
        ),
        (
            "cases/bhaskar-track.toml --roughness profile.csv --wheel-roughness none",
            "--wheel-roughness is \"none\", but must be",
        ),
        ("cases/nominal.toml --roughness profile.csv --from-limit -3", "--from-limit needs --traffic or --with"),
        ("--roughness profile.csv --traffic cases/traffic.toml", "--traffic needs <CASE>"),
        ("--roughness profile.csv --torsion 40", "--torsion needs <CASE>"),
        (
            "cases/nominal.toml --with cases/soft-pads.toml --limit grassie-1999",
            "--limit is grassie-1999, but must be a limit of levels where there is a --with",
        ),
        ("cases/nominal.toml --roughness profile.csv -o no/such/folder.html", "cannot write"),
    ] {
        let outcome = sandbox.riffel(&format!("report {arguments}"));
        let words = outcome.text.split_whitespace().filter(|word| *word != "│");
        let sentence = words.collect::<Vec<_>>().join(" ");
        assert_eq!(outcome.status, Some(2), "{arguments}: {sentence}");
        assert!(sentence.contains(part), "{arguments}: {sentence}");
    }
    assert_eq!(sandbox.list("."), ["cases", "profile.csv", "site.toml"]);
}

/// The level of a report is that of `riffel noise` for the same rail and speed.
#[test]
fn noise_is_that_of_its_own_command() {
    let sandbox = Sandbox::new();
    made(&sandbox);
    let rail = "cases/bhaskar-track.toml --roughness profile.csv --speed \"70 km/h\"";
    let outcome = sandbox.riffel(&format!("report {rail}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("report.html")).unwrap();
    let noise = sandbox.json(&format!("noise {rail} --json"));
    let level = noise["level"]["total_dba"].as_f64().unwrap();
    assert!(page.contains(&format!("<b>{level:.1} dB(A)</b>")), "{level}");
}

/// Without a table of costs none is told; with one, whole shifts. The strip map has a bar for what is to be ground.
#[test]
fn a_cost_is_told_where_it_is_given() {
    let sandbox = Sandbox::new();
    made(&sandbox);
    let cost = "[cost]\ncurrency = \"CHF\"\ngrinding_shift = 7000\nlength_a_shift = \"10 km\"\n";
    fs::write(sandbox.path("site.toml"), cost).unwrap();
    for (option, told) in [("", false), ("--site site.toml", true)] {
        let outcome = sandbox.riffel(&format!("report --roughness profile.csv {option} -o report.html"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
        let page = fs::read_to_string(sandbox.path("report.html")).unwrap();
        assert_eq!(page.contains("takes 1 grinding shift and 7000 CHF."), told);
        let brief = page.split("</section>").next().unwrap();
        assert!(brief.contains("fill=\"#c8442c\"") && brief.contains("The line: red"));
        stands_alone(&page);
    }
    fs::write(sandbox.path("site.toml"), cost.replace("7000", "-7000")).unwrap();
    let outcome = sandbox.riffel("report --roughness profile.csv --site site.toml -o report.html");
    assert_eq!(outcome.status, Some(2));
    assert!(outcome.text.contains("`cost.grinding_shift` is -7000, but must be greater than zero"), "{}", outcome.text);
}

/// The words of a page with all parts, but for what stays as somebody wrote it: inputs, published sources, and names in
/// quotation marks.
fn own_words(page: &str) -> Vec<String> {
    let body = page.split_once("</style>").unwrap().1;
    let (before, inputs) = body.split_once("Eingaben und Versionen").unwrap();
    let after = inputs.split_once("</section>").unwrap().1;
    let text = [before, after].concat();
    let lines = text.split('<').filter_map(|part| part.split_once('>'));
    let quoted = |line: &str| {
        let line = line.replace("&quot;", "\"").replace(['„', '“'], "\"");
        line.split('"').step_by(2).collect::<String>()
    };
    let is_own = |line: &&str| {
        let sources = ["Values of EN ISO 3095", "S. L. Grassie", "Shock and Vibration"];
        !sources.iter().any(|source| line.contains(source))
    };
    let lines = lines.map(|(_, line)| line).filter(is_own);
    lines.map(quoted).collect()
}

/// A German report says nothing in English, and its numbers have a comma.
#[test]
fn a_german_report_is_german() {
    // Without which English gets nowhere, and which German does not have.
    const ENGLISH: &str = "the of and is are at from with by on not over under after which that must no rail rails wheel \
                           wheels track speed force level growth limit left right now length wavelength sleepers pads";
    let sandbox = Sandbox::new();
    made(&sandbox);
    let cost = "[cost]\ncurrency = \"EUR\"\ngrinding_shift = 7000\nlength_a_shift = \"1 km\"\n";
    fs::write(sandbox.path("site.toml"), format!("[site]\nline = \"U2\"\n{cost}")).unwrap();
    let soft = "title = \"weich\"\n[track]\npad = { stiffness = \"40 MN/m\" }\n";
    fs::write(sandbox.path("soft.toml"), soft).unwrap();
    let traffic = fs::read_to_string(sandbox.path("cases/traffic.toml")).unwrap();
    let traffic = traffic.replace("Mixed traffic of a main line", "Mischverkehr");
    fs::write(sandbox.path("traffic.toml"), traffic).unwrap();
    let outcome = sandbox.riffel(
        "--language de report cases/bhaskar-track.toml --roughness profile.csv --traffic traffic.toml \
         --speed \"70 km/h\" --with soft.toml --site site.toml --limit-dba 90 -o page.html",
    );
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let page = fs::read_to_string(sandbox.path("page.html")).unwrap();
    stands_alone(&page);
    assert!(page.starts_with("<!DOCTYPE html>\n<html lang=\"de\">"));
    let words = own_words(&page);
    let english: Vec<&str> = ENGLISH.split_whitespace().collect();
    let is_english = |line: &&String| {
        let mut words = line.split(|c: char| !c.is_alphanumeric() && !"._-".contains(c));
        words.any(|word| english.contains(&word))
    };
    let found: Vec<&String> = words.iter().filter(is_english).collect();
    assert!(found.is_empty(), "{found:#?}");
    for part in ["In Kürze", "12 Warnungen und Grenzen der Modelle", "zu hören mit <b>"] {
        assert!(page.contains(part), "{part}");
    }
    // As of levels in tables and figures; dates and versions have points of their own.
    let has_point = |line: &&String| {
        let digits = line.as_bytes().windows(3);
        let mut points = digits.filter(|at| at[1] == b'.' && at[0].is_ascii_digit() && at[2].is_ascii_digit());
        points.next().is_some()
    };
    let points: Vec<&String> = words.iter().filter(has_point).collect();
    assert!(points.is_empty(), "{points:#?}");
}
