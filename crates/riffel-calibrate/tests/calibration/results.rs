//! What a folder of results holds, by whatever sampler.

use std::fs;
use std::path::Path;

use riffel_calibrate::file::SamplerKind;
use riffel_calibrate::{Chains, Folder, Plan};
use riffel_study::Stop;

/// A plan of one parameter in a folder of its own beside the case of three dates.
fn small(folder: &Path, kind: &str) -> Plan {
    let set = folder.join("set");
    fs::create_dir_all(&set).unwrap();
    for name in ["case.toml", "traffic.toml", "roughness.csv"] {
        fs::copy(crate::folder("b-three-dates").join(name), set.join(name)).unwrap();
    }
    let warmup = if kind == "smc" { "" } else { "warmup = 100\n" };
    let text = format!(
        "# What we know\ncase = \"case.toml\" # as built\ntraffic = 'traffic.toml'\n\
         [sampler]\nkind = \"{kind}\"\nchains = 2\n{warmup}draws = 300\n\
         [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = {{ median = 2.5e-9, factor = 2.0 }}\n\
         [[data]]\nkind = \"dated-levels\"\nfile = \"roughness.csv\"\n\
         discrepancy = {{ kind = \"band\", standard_deviation = 1.0 }}\n"
    );
    fs::write(set.join("plan.toml"), text).unwrap();
    Plan::read(&set.join("plan.toml")).unwrap()
}

fn run(plan: &Plan, path: &Path, restart: bool) -> Chains {
    let folder = Folder::begin(plan, path, restart).unwrap();
    folder.write_plan(plan).unwrap();
    folder.run(&|_| {}, &Stop::default()).unwrap().unwrap()
}

/// The copy of a plan beside its results names its files from there: read from a third folder it gives the same draws, and all that
/// is not the name of a file stays.
#[test]
fn the_copy_of_a_plan_runs_where_it_is() {
    let there = tempfile::tempdir().unwrap();
    let plan = small(there.path(), "ensemble");
    let out = there.path().join("results/of/today");
    let own = run(&plan, &out, false).summary(&plan).csv();
    let text = fs::read_to_string(out.join("plan.toml")).unwrap();
    for line in [
        "# What we know",
        "case = \"../../../set/case.toml\" # as built",
        "traffic = \"../../../set/traffic.toml\"",
        "file = \"../../../set/roughness.csv\"",
    ] {
        assert!(text.lines().any(|it| it == line), "{line}: {text}");
    }
    let copy = Plan::read(&out.join("plan.toml")).unwrap();
    let third = there.path().join("third");
    assert_eq!(run(&copy, &third, false).summary(&copy).csv(), own);
}

/// A run whose last parts are lost has the same draws again; every sampler keeps its state, a population its evidence too.
#[test]
fn chains_of_every_sampler_go_on_from_their_parts() {
    for kind in ["nuts", "ensemble", "smc"] {
        let there = tempfile::tempdir().unwrap();
        let plan = small(there.path(), kind);
        let out = there.path().join("out");
        let whole = run(&plan, &out, false);
        assert_eq!(
            whole.log_evidences.len(),
            if plan.file.sampler.kind == SamplerKind::Smc {
                2
            } else {
                0
            }
        );
        fs::remove_file(out.join("chains/1-1")).unwrap();
        let again = run(&plan, &out, true);
        assert_eq!(whole.summary(&plan), again.summary(&plan), "{kind}");
        assert_eq!(whole.log_evidences, again.log_evidences, "{kind}");
    }
}

/// Chains of a thousand draws that allow no conclusion go on to more, in words too, and a run whose last part is lost has the same
/// draws again; chains of fewer end as they were meant.
#[test]
fn chains_go_on_until_they_conclude() {
    let there = tempfile::tempdir().unwrap();
    // One chain of set b: too few draws count of its slowest value.
    let text = fs::read_to_string(crate::folder("b-three-dates").join("plan.toml")).unwrap();
    let text = text
        .replace("chains = 4", "chains = 1")
        .replace("warmup = 1000", "warmup = 200");
    small(there.path(), "nuts");
    let path = there.path().join("set/plan.toml");
    let text = text.split("[[action]]").next().unwrap();
    fs::write(&path, text).unwrap();
    let plan = Plan::read(&path).unwrap();
    let out = there.path().join("out");
    let whole = run(&plan, &out, false);
    let summary = whole.summary(&plan);
    assert!(
        summary.draws == 2000 || summary.draws == 4000,
        "{}",
        summary.draws
    );
    assert!(summary.draws == 4000 || summary.doubts().is_empty());
    // 1200 draws are five parts, those of a thousand more another four.
    fs::remove_file(out.join("chains/0-6")).unwrap();
    assert_eq!(run(&plan, &out, true).summary(&plan), summary);
    fs::write(&path, text.replace("draws = 1000", "draws = 250")).unwrap();
    let short = Plan::read(&path).unwrap();
    assert_eq!(
        run(&short, &there.path().join("short"), false)
            .summary(&short)
            .draws,
        250
    );
}
