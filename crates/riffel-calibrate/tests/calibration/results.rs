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
