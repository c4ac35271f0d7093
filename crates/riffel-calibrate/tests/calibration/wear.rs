//! Wear of the head beside the loop: what it says of the coefficient, and what is refused.

use std::f64::consts::PI;
use std::fs;

use riffel_calibrate::Plan;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Variant};
use tempfile::TempDir;

/// A plan of the second set with one table of wear, and whether there is a traffic.
fn plan(to: &TempDir, table: &str, traffic: bool) -> Result<Plan, String> {
    crate::copy_set("b-three-dates", to.path());
    fs::write(to.path().join("wear.csv"), table).unwrap();
    let traffic = if traffic { "traffic = \"traffic.toml\"\n" } else { "" };
    let text = format!(
        "case = \"case.toml\"\n{traffic}\
         [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = {{ median = 2.5e-9, factor = 2.0 }}\n\
         [[data]]\nkind = \"wear\"\nfile = \"wear.csv\"\n"
    );
    let path = to.path().join("plan.toml");
    fs::write(&path, text).unwrap();
    Plan::read(&path).map_err(|error| error.to_string())
}

/// Depths that are known within factors (80 %) are normal in ln of the coefficient: the density has a closed form, with the wear of the traffic as a forecast has it.
#[test]
fn measured_wear_is_normal_in_the_coefficient() {
    const ROWS: [(f64, f64, f64); 2] = [(1.2, 100.0, 1.5), (0.3, 40.0, 2.0)];
    const MEDIAN: f64 = 2.5e-9;
    let to = TempDir::new().unwrap();
    let rows = ROWS.map(|(depth, mgt, factor)| format!("{depth},{mgt},{factor}\n"));
    let plan = plan(&to, &format!("depth_mm,mgt,factor\n{}", rows.concat()), true).unwrap();
    let case = Case::read(&to.path().join("case.toml"), &[]).unwrap();
    let traffic = Traffic::read(&to.path().join("traffic.toml")).unwrap();
    let on = traffic.on(&case, &bands_of(&case), &Variant::none(""), &|_| ());
    let depth = on.unwrap().growth.mean_wear().depth_per_100_mgt();
    for coefficient in [0.7e-9, 2.5e-9, 4e-9] {
        let expected = (depth * coefficient / MEDIAN).ln();
        let predicted = plan.posterior.predictions(&[coefficient]).unwrap();
        for found in &predicted[0] {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        let terms = ROWS.map(|(depth, mgt, factor)| {
            let error = factor.ln() / 1.281_551_565_544_6;
            let beside = ((1e-3 * depth * 100.0 / mgt).ln() - expected) / error;
            -0.5 * beside * beside - error.ln() - 0.5 * (2.0 * PI).ln()
        });
        let parts = plan.posterior.log_likelihood(&[coefficient]).unwrap();
        let density: f64 = terms.iter().sum();
        assert!((parts[0].1 - density).abs() < 1e-9, "{parts:?} {density}");
        // Of second order in the step.
        let place = plan.posterior.place(&[coefficient])[0];
        let at = |place: f64| plan.posterior.log_density(&[place]).unwrap();
        let slope = (at(place + 1e-4) - at(place - 1e-4)) / 2e-4;
        let found = plan.posterior.at(&[place]).unwrap().gradient[0];
        assert!((found - slope).abs() < 1e-4 * slope.abs().max(1.0), "{found} {slope}");
    }
}

#[test]
fn wear_that_is_none_is_refused() {
    let to = TempDir::new().unwrap();
    for (table, traffic, rule) in [
        ("depth_mm,mgt\n0,100\n", true, "`depth_mm` is 0, but must be greater than zero"),
        ("depth_mm,mgt\n1.2,-5\n", true, "`mgt` is -5, but must be greater than zero"),
        ("depth_mm,mgt,factor\n1.2,100,0.5\n", true, "`factor` is 0.5, but must be one or more"),
        ("depth_mm,mgt,factor\n1.2,100,1\n", true, "errors"),
        ("depth_mm,mgt\n1.2,100\n1.2,100\n", true, "line 2"),
        ("depth_mm\n1.2\n", true, "depth_mm, mgt"),
        ("depth_mm,mgt\n1.2,100\n", false, "traffic"),
    ] {
        let refused = plan(&to, table, traffic).err().unwrap();
        assert!(refused.contains(rule), "{refused}");
    }
}

/// In a curve the wheels of an axle share its load unevenly: tonnes are counted by the axle, as a forecast counts them, whichever rail
/// was measured.
#[test]
fn tonnes_in_a_curve_are_those_of_the_axle() {
    let to = TempDir::new().unwrap();
    let write = |name: &str, text: &str| fs::write(to.path().join(name), text).unwrap();
    write("wear.csv", "depth_mm,mgt,factor\n1.2,100,1.5\n");
    write(
        "traffic.toml",
        "[line]\nmgt_per_year = 12\n[[vehicle]]\nname = \"metro\"\nshare = \"100 %\"\n\
         speed = { mean = \"45 km/h\", standard_deviation = \"2 km/h\" }\n",
    );
    write(
        "plan.toml",
        "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
         [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }\n\
         [[data]]\nkind = \"wear\"\nfile = \"wear.csv\"\n",
    );
    let curve = include_str!("../../../riffel-case/cases/metro-curve.toml");
    let mut passages = Vec::new();
    for rail in ["low", "high"] {
        write("case.toml", &curve.replace("rail = \"low\" }", &format!("rail = \"{rail}\" }}")));
        let plan = Plan::read(&to.path().join("plan.toml")).unwrap();
        let case = Case::read(&to.path().join("case.toml"), &[]).unwrap();
        let traffic = Traffic::read(&to.path().join("traffic.toml")).unwrap();
        let on = traffic.on(&case, &bands_of(&case), &Variant::none(""), &|_| ()).unwrap();
        let coefficient = case.number("wear.coefficient").unwrap();
        let found = plan.posterior.predictions(&[coefficient]).unwrap()[0][0];
        let expected = on.growth.mean_wear().depth_per_100_mgt().ln();
        assert!((found - expected).abs() < 1e-12, "{rail}: {found} {expected}");
        passages.push(plan.passages_per_day.unwrap());
    }
    assert_eq!(passages[0], passages[1]);
}
