//! Plans with usual priors: what is in them, and that they can be run again.

use std::fs;
use std::path::{Path, PathBuf};

use riffel_calibrate::{Folder, Measured, Plan};
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Variant};
use tempfile::TempDir;

use crate::folder;

/// The plan of a case of a set and tables of it, as it would stand in a folder.
fn usual(set: &str, traffic: Option<&str>, tables: &[&str], to: &Path) -> Result<Plan, String> {
    let of_set = |name: &str| folder(set).join(name);
    let tables: Vec<PathBuf> = tables.iter().map(|name| of_set(name)).collect();
    let traffic = traffic.map(of_set);
    let measured = Measured { case: &of_set("case.toml"), traffic: traffic.as_deref(), tables: &tables };
    Plan::usual(&to.join("plan.toml"), &measured).map_err(|error| error.to_string())
}

fn names(plan: &Plan) -> Vec<&str> {
    plan.posterior.parameters().iter().map(|it| &*it.name).collect()
}

/// Only what the case has and the data can touch: a hammer feels no wheel, growth feels all.
#[test]
fn data_make_uncertain_what_they_touch() {
    let to = TempDir::new().unwrap();
    let of_track = [
        "track.pad.stiffness",
        "track.pad.loss_factor",
        "track.ballast.stiffness",
        "track.ballast.loss_factor",
        "track.sleeper.mass",
        "rail.loss_factor",
    ];
    let set = "c-all-together";
    let hammer = usual(set, None, &["hammer.csv"], to.path()).unwrap();
    assert_eq!(names(&hammer), [&of_track[..], &["hammer.discrepancy"]].concat());
    assert!(hammer.remarks[0].to_string().contains("averages is taken as 4"), "{:?}", hammer.remarks);
    let tables = ["roughness.csv", "decay.csv"];
    let both = usual(set, Some("traffic.toml"), &tables, to.path()).unwrap();
    let of_trains = [
        "wheel.mass",
        "contact.friction",
        "contact.transverse_radius",
        "wear.coefficient",
        "vehicle.tractive_ratio",
        "vehicle.traction_share",
        "vehicle.speed.mean",
        "vehicle.speed.standard_deviation",
        "preload_stiffening",
        "roughness.discrepancy",
        "decay.discrepancy",
    ];
    assert_eq!(names(&both), [&of_track[..], &of_trains].concat());
    assert_eq!(both.posterior.data_of("preload_stiffening"), ["roughness"]);
    // Of growth alone a factor of the pad would be the pad.
    let growth = usual(set, Some("traffic.toml"), &tables[..1], to.path()).unwrap();
    assert!(!names(&growth).contains(&"preload_stiffening"));
}

/// Medians and 16 % quantiles are those of the table of usual priors; those of the pad and of the wear coefficient are of the case.
#[test]
fn priors_are_the_usual_ones() {
    let to = TempDir::new().unwrap();
    let tables = ["roughness.csv", "decay.csv"];
    let plan = usual("c-all-together", Some("traffic.toml"), &tables, to.path()).unwrap();
    for (name, median, factor) in [
        ("track.pad.stiffness", 300e6, 2.0),
        ("track.ballast.stiffness", 60e6, 1.8),
        ("track.sleeper.mass", 145.0, 1.05),
        ("wear.coefficient", 2.5e-9, 2.36),
        ("vehicle.speed.standard_deviation", 8.0 / 3.6, 1.5),
        ("preload_stiffening", 1.2, 1.3),
    ] {
        let parameters = plan.posterior.parameters().iter();
        let prior = parameters.clone().find(|it| it.name == name).unwrap().prior;
        assert!((prior.quantile(0.5) / median - 1.0).abs() < 1e-4, "{name}");
        // One standard deviation below the median: Φ(−1) = 0.158655.
        assert!((prior.quantile(0.158_655) * factor / median - 1.0).abs() < 1e-4, "{name}");
    }
}

/// The wear of a rail that was measured is the prior of its coefficient: what gives it under the traffic, 80 % within its factor.
#[test]
fn measured_wear_is_the_prior_of_the_coefficient() {
    let to = TempDir::new().unwrap();
    let set = folder("c-all-together");
    let text = fs::read_to_string(set.join("case.toml")).unwrap();
    let given = "coefficient = 2.5e-9";
    let path = to.path().join("case.toml");
    let measured = text.replace(given, "measured = \"1.2 mm / 100 MGT\"");
    assert_ne!(measured, text);
    fs::write(&path, measured).unwrap();
    let (traffic, roughness) = (set.join("traffic.toml"), set.join("roughness.csv"));
    let plan = Plan::usual(
        &to.path().join("plan.toml"),
        &Measured { case: &path, traffic: Some(&traffic), tables: &[roughness] },
    );
    let plan = plan.unwrap_or_else(|error| panic!("{error}"));
    let case = Case::read(&set.join("case.toml"), &[]).unwrap();
    let on = Traffic::read(&traffic).unwrap();
    let on = on.on(&case, &bands_of(&case), &Variant::none(""), &|_| ()).unwrap();
    let right = 2.5e-9 * 1.2e-3 / on.growth.mean_wear().depth_per_100_mgt();
    let parameters = plan.posterior.parameters().iter();
    let wear = parameters.clone().find(|it| it.name == "wear.coefficient");
    let prior = wear.unwrap().prior;
    // Plans have four digits.
    assert!((prior.quantile(0.5) / right - 1.0).abs() < 1e-3);
    assert!((prior.quantile(0.9) / prior.quantile(0.5) / 1.5 - 1.0).abs() < 1e-3);
}

/// A plan that is written is read from its folder as the same plan; one that was changed is not replaced.
#[test]
fn a_plan_can_be_run_again_and_is_not_replaced() {
    let above = TempDir::new().unwrap();
    let to = above.path().join("new").join("below");
    let make = || usual("a-hammer-and-decay", None, &["decay.csv"], &to);
    let plan = make().unwrap();
    assert!(!to.exists());
    Folder::begin(&plan, &to, false).unwrap().write_plan(&plan).unwrap();
    let path = to.join("plan.toml");
    let again = Plan::read(&path).unwrap();
    assert_eq!(names(&again), names(&plan));
    let middle: Vec<f64> = plan.posterior.parameters().iter().map(|it| it.prior.quantile(0.5)).collect();
    assert_eq!(again.posterior.log_likelihood(&middle), plan.posterior.log_likelihood(&middle));
    assert_eq!(make().unwrap().text, plan.text);
    // The chains of both are the same.
    Folder::begin(&again, &to, true).unwrap();
    fs::write(&path, plan.text.replace("factor = 1.05", "factor = 1.1")).unwrap();
    let error = make().err().unwrap();
    assert!(error.contains("is there already and is not the plan with usual priors"), "{error}");
    assert!(fs::read_to_string(&path).unwrap().contains("factor = 1.1 "));
}

#[test]
fn tables_that_tell_no_kind_are_refused() {
    let to = TempDir::new().unwrap();
    for (tables, words) in [
        (["plan.toml"], "from which no kind of measurement follows"),
        (["axlebox.csv"], "whose speed no column says"),
        (["roughness.csv"], "no traffic that made them grow"),
    ] {
        let error = usual("c-all-together", None, &tables, to.path()).err().unwrap();
        assert!(error.contains(words) && error.contains(tables[0]), "{error}");
    }
}

/// Trains that are heard bring their speed in a column, and touch what the levels do; without it, and without levels, they are no
/// data.
#[test]
fn trains_that_are_heard_have_a_usual_plan() {
    let to = TempDir::new().unwrap();
    let pass_by = to.path().join("heard.csv");
    let set = folder("b-three-dates");
    let of_set = |name: &str| set.join(name);
    let plan = |table: &str, levels: bool| {
        fs::write(&pass_by, table).unwrap();
        let levels = levels.then(|| of_set("roughness.csv"));
        let tables: Vec<PathBuf> = levels.into_iter().chain([pass_by.clone()]).collect();
        let measured = Measured { case: &of_set("case.toml"), traffic: Some(&of_set("traffic.toml")), tables: &tables };
        Plan::usual(&to.path().join("plan.toml"), &measured).map_err(|error| error.to_string())
    };
    let table = "passages,level_dba,speed_km_per_h\n0,80,110\n3500000,84,110\n";
    let read = plan(table, true).unwrap();
    assert_eq!(read.posterior.data_of("wheel.mass"), ["roughness + heard"]);
    let own = read.text.split("kind = \"pass-by\"").nth(1).unwrap();
    assert!(own.contains("heard.csv") && !own.contains("discrepancy"), "{own}");
    let error = |plan: Result<Plan, String>| plan.map(|_| ()).unwrap_err();
    let slow = error(plan("passages,level_dba\n0,80\n", true));
    assert!(slow.contains("speed_km_per_h"), "{slow}");
    let alone = error(plan(table, false));
    assert!(alone.contains("dated-levels"), "{alone}");
}
