//! What a folder of results holds, by whatever sampler.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use riffel_calibrate::file::SamplerKind;
use riffel_calibrate::{CalibrationError, Chains, Folder, Plan, finished};
use riffel_study::Stop;
use serde_json::Value;

/// A plan of one parameter in a folder of its own beside the case of three dates, of so many draws that each chain has two parts.
fn small(folder: &Path, kind: &str) -> Plan {
    of_draws(folder, kind, [100, 300])
}

/// Plan of few draws, where files count and not what is drawn.
fn smallest(folder: &Path) -> Plan {
    of_draws(folder, "ensemble", [100, 50])
}

fn of_draws(folder: &Path, kind: &str, [warmup, draws]: [u32; 2]) -> Plan {
    let set = folder.join("set");
    fs::create_dir_all(&set).unwrap();
    for name in ["case.toml", "traffic.toml", "roughness.csv"] {
        fs::copy(crate::folder("b-three-dates").join(name), set.join(name)).unwrap();
    }
    let warmup = if kind == "smc" { String::new() } else { format!("warmup = {warmup}\n") };
    let text = format!(
        "# What we know\ncase = \"case.toml\" # as built\ntraffic = 'traffic.toml'\n\
         [sampler]\nkind = \"{kind}\"\nchains = 2\n{warmup}draws = {draws}\n\
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
// Long: draws the chains of a plan and of its copy.
#[test]
fn the_copy_of_a_plan_runs_where_it_is() {
    let there = tempfile::tempdir().unwrap();
    let plan = smallest(there.path());
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

/// ln of the mean of the likelihood over the prior of the one value of a plan, by the rule of midpoints over 400 shares of the prior.
fn log_evidence(plan: &Plan) -> f64 {
    let prior = &plan.posterior.parameters()[0].prior;
    let likelihoods = (0..400).map(|k| {
        let value = prior.quantile((f64::from(k) + 0.5) / 400.0);
        let blocks = plan.posterior.log_likelihood(&[value]).unwrap();
        blocks.iter().map(|(_, value)| value).sum::<f64>()
    });
    let likelihoods: Vec<f64> = likelihoods.collect();
    let highest = likelihoods.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
    let sum: f64 = likelihoods.iter().map(|it| (it - highest).exp()).sum();
    highest + (sum / 400.0).ln()
}

/// A run whose last parts are lost has the same draws again; every sampler keeps its state, a population its evidence too, which is
/// that of a quadrature to three times the error of two steps of 300 members.
// Long: draws two chains by each of three samplers, of so many draws that they have two parts.
#[test]
fn chains_of_every_sampler_go_on_from_their_parts() {
    for kind in ["nuts", "ensemble", "smc"] {
        let there = tempfile::tempdir().unwrap();
        let plan = small(there.path(), kind);
        let out = there.path().join("out");
        let whole = run(&plan, &out, false);
        assert_eq!(whole.log_evidences.len(), if plan.file.sampler.kind == SamplerKind::Smc { 2 } else { 0 });
        let error = 3.0 * (2.0_f64 / 300.0).sqrt();
        for told in &whole.log_evidences {
            assert!((told - log_evidence(&plan)).abs() < error, "{told}");
        }
        fs::remove_file(out.join("chains/1-1")).unwrap();
        let again = run(&plan, &out, true);
        assert_eq!(whole.summary(&plan), again.summary(&plan), "{kind}");
        assert_eq!(whole.log_evidences, again.log_evidences, "{kind}");
    }
}

/// Chains of a thousand draws that allow no conclusion go on to more, in words too, and a run whose last part is lost has the same
/// draws again; chains of fewer end as they were meant.
// Long: draws a chain that goes on beyond a thousand draws, and its last parts again.
#[test]
fn chains_go_on_until_they_conclude() {
    let there = tempfile::tempdir().unwrap();
    // One chain of set b: too few draws count of its slowest value.
    let text = fs::read_to_string(crate::folder("b-three-dates").join("plan.toml")).unwrap();
    let text = text.replace("chains = 4", "chains = 1").replace("warmup = 1000", "warmup = 200");
    small(there.path(), "nuts");
    let path = there.path().join("set/plan.toml");
    let text = text.split("[[action]]").next().unwrap();
    fs::write(&path, text).unwrap();
    let plan = Plan::read(&path).unwrap();
    let out = there.path().join("out");
    let whole = run(&plan, &out, false);
    let summary = whole.summary(&plan);
    assert!([2000, 4000, 8000, 16_000].contains(&summary.draws), "{}", summary.draws);
    assert!(summary.draws == 16_000 || summary.doubts().is_empty());
    // 1200 draws are five parts, those of a thousand more another four.
    fs::remove_file(out.join("chains/0-6")).unwrap();
    assert_eq!(run(&plan, &out, true).summary(&plan), summary);
    fs::write(&path, text.replace("draws = 1000", "draws = 250")).unwrap();
    let short = Plan::read(&path).unwrap();
    assert_eq!(run(&short, &there.path().join("short"), false).summary(&short).draws, 250);
}

/// All files below a folder, by name, with their bytes.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => folders.push(path),
                false => drop(found.insert(path.clone(), fs::read(&path).unwrap())),
            }
        }
    }
    found
}

fn whole(plan: &Plan, path: &Path, restart: bool) -> Result<(), CalibrationError> {
    let folder = Folder::begin(plan, path, restart)?;
    folder.write_plan(plan)?;
    let chains = folder.run(&|_| {}, &Stop::default())?.unwrap();
    let results = folder.results(plan, &chains, &chains.summary(plan))?;
    results.publish().map(drop)
}

/// The small plan with another number of its random choices.
fn with_seed(plan: &Plan, seed: u64) -> Plan {
    let path = plan.inputs[0].with_file_name(format!("seed-{seed}.toml"));
    let text = fs::read_to_string(&plan.inputs[0]).unwrap();
    let text = text.replacen("\n[[parameter]]", &format!("\nseed = {seed}\n[[parameter]]"), 1);
    fs::write(&path, text).unwrap();
    Plan::read(&path).unwrap()
}

/// Chains of another plan are refused, and nothing is touched; with a restart they are replaced, but for what somebody has put beside
/// them, which stays and can be opened.
// Long: draws the chains of two plans, and each a second time.
#[test]
fn chains_of_another_plan_are_replaced_on_demand_and_no_file_of_others() {
    let there = tempfile::tempdir().unwrap();
    let one = smallest(there.path());
    let two = with_seed(&one, 2);
    let out = there.path().join("out");
    whole(&one, &out, false).unwrap();
    let tree = out.join("posterior.zarr");
    let group = r#"{"zarr_format":3,"node_type":"group","attributes":{"mine":1}}"#;
    let mine = [
        (tree.join("my_diagnostics/zarr.json"), group),
        (tree.join("posterior/my_group/zarr.json"), group),
        (tree.join("notes.txt"), "mine"),
        (out.join("chains/notes.txt"), "mine"),
        (out.join("notes.txt"), "mine"),
    ];
    for (path, text) in &mine {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    let before = files(&out);
    let refusal = whole(&two, &out, false);
    assert!(matches!(refusal, Err(CalibrationError::OtherPlan { .. })));
    assert!(files(&out) == before);
    // Drawn anew for their own plan, they are what they were.
    whole(&one, &out, false).unwrap();
    whole(&two, &out, true).unwrap();
    let alone = there.path().join("alone");
    whole(&two, &alone, false).unwrap();
    let own = |folder: &Path, name: &str| fs::read(folder.join(name)).unwrap();
    for name in ["summary.csv", "chains/1-0", "posterior.zarr/posterior/wear.coefficient/c/0/0"] {
        assert!(own(&out, name) == own(&alone, name), "{name}");
        assert!(before[&out.join(name)] != own(&out, name), "{name}");
    }
    for (path, text) in &mine {
        assert_eq!(fs::read_to_string(path).unwrap(), *text, "{path:?}");
    }
    assert_eq!(files(&out).len(), files(&alone).len() + mine.len());
    let document = |name: &str| -> Value {
        let metadata: Value = serde_json::from_slice(&own(&tree, name)).unwrap();
        metadata["consolidated_metadata"]["metadata"].clone()
    };
    let root = document("zarr.json");
    assert_eq!(root["my_diagnostics"]["attributes"]["mine"], 1);
    assert_eq!(root["posterior/my_group"]["attributes"]["mine"], 1);
    assert_eq!(root["posterior"]["node_type"], "group");
    assert_eq!(document("posterior/zarr.json")["my_group"]["attributes"]["mine"], 1);
}

/// Draws are believed for the plan that stands inside them: neither another tree, nor other parts of chains, nor a tree that is not
/// whole, are taken for those of the record.
// Long: draws the chains of two plans.
#[test]
fn draws_say_of_which_plan_they_are() {
    let there = tempfile::tempdir().unwrap();
    let one = smallest(there.path());
    let two = with_seed(&one, 2);
    let [out, other] = ["out", "other"].map(|name| there.path().join(name));
    whole(&one, &out, false).unwrap();
    whole(&two, &other, false).unwrap();
    assert!(finished(&out, None).is_ok());
    for name in ["posterior.zarr/zarr.json", "chains/1-0", "calibration.json"] {
        let [own, others] = [&out, &other].map(|folder| fs::read(folder.join(name)).unwrap());
        fs::write(out.join(name), others).unwrap();
        let plan = Some(one.inputs[0].as_path());
        let refusal = finished(&out, plan).err();
        assert!(
            matches!(
                (name, refusal),
                ("posterior.zarr/zarr.json", Some(CalibrationError::OtherDraws { .. }))
                    | ("chains/1-0", Some(CalibrationError::Unfinished { .. }))
                    | ("calibration.json", Some(CalibrationError::OtherPlan { .. }))
            ),
            "{name}"
        );
        fs::write(out.join(name), own).unwrap();
    }
    assert!(finished(&out, None).is_ok());
    fs::remove_file(out.join("posterior.zarr/zarr.json")).unwrap();
    let refusal = finished(&out, None);
    assert!(matches!(refusal, Err(CalibrationError::Unfinished { .. })));
}

/// One run at a time draws in a folder, and none through a link.
#[test]
fn a_folder_in_use_is_not_drawn_into() {
    let there = tempfile::tempdir().unwrap();
    let plan = small(there.path(), "ensemble");
    let out = there.path().join("out");
    let held = Folder::begin(&plan, &out, false).unwrap();
    for other in [&plan, &with_seed(&plan, 2)] {
        let refusal = Folder::begin(other, &out, true);
        assert!(matches!(refusal, Err(CalibrationError::InUse { .. })));
    }
    drop(held);
    drop(Folder::begin(&plan, &out, false).unwrap());
    assert_eq!(fs::read_dir(&out).unwrap().count(), 1);
    #[cfg(unix)]
    for name in ["chains", "posterior.zarr", "models", "in-use.lock"] {
        let link = out.join(name);
        std::os::unix::fs::symlink("../set", &link).unwrap();
        let refusal = Folder::begin(&plan, &out, false).err().unwrap();
        assert!(refusal.to_string().contains("is a link"), "{refusal}");
        fs::remove_file(link).unwrap();
    }
}
