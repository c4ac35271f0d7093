//! The posteriors of the second implementation.

use std::time::Instant;

use riffel_calibrate::Folder;
use riffel_study::Stop;

use crate::{SETS, SHORT, json, plan};

/// Means within 0.1 standard deviations, standard deviations within 10 %.
#[test]
#[ignore = "minutes without optimisation"]
fn posteriors_are_those_of_the_second_implementation() {
    for set in SETS {
        let plan = plan(set);
        let folder = tempfile::tempdir().unwrap();
        let folder = Folder::begin(&plan, &folder.path().join("out"), false).unwrap();
        let begun = Instant::now();
        let chains = folder.run(&|_| {}, &Stop::default()).unwrap().unwrap();
        let seconds = begun.elapsed().as_secs_f64();
        let summary = chains.summary(&plan);
        let expected = &json(set, "posterior.json")["parameters"];
        eprintln!("{set}: {seconds:.1} s, {} divergences, bfmi {:.2}", summary.divergences, summary.bfmi);
        let mut wrong = Vec::new();
        for marginal in &summary.marginals {
            let short = SHORT.iter().find(|(_, name)| *name == marginal.name).unwrap().0;
            let number = |key: &str| expected[short][key].as_f64().unwrap();
            let (mean, sd) = (number("mean"), number("sd"));
            let far = (marginal.mean - mean) / sd;
            let wide = marginal.standard_deviation / sd - 1.0;
            eprintln!(
                "  {:34} {:+.3} sd  {:+.3}  rhat {:.4} ess {:.0} {:.0} contraction {:.3}",
                marginal.name, far, wide, marginal.rhat, marginal.ess_bulk, marginal.ess_tail, marginal.contraction
            );
            if far.abs() > 0.1 || wide.abs() > 0.1 {
                wrong.push(format!("{}: {far} {wide}", marginal.name));
            }
        }
        assert!(wrong.is_empty(), "{set}: {wrong:?}");
        assert_eq!(summary.doubts(), Vec::<String>::new());
    }
}
