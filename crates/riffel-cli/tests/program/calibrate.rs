//! `riffel calibrate`: what a plan asks for, and what is refused before anything is written.

use std::fs;

use crate::sandbox::Sandbox;

const SET: &str = "validation/calibration/c-all-together";

#[test]
fn a_dry_run_says_which_data_tell_a_key() {
    let sandbox = Sandbox::new();
    sandbox.copy(SET);
    let plan = format!("{SET}/plan.toml");
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o out --dry-run"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for line in [
        "track.pad.stiffness: hammer, decay, growth + axle-box",
        "preload_stiffening: growth + axle-box",
        "hammer.discrepancy: hammer",
    ] {
        assert!(outcome.text.contains(line), "{}", outcome.text);
    }
    assert!(!sandbox.path("out").exists());
    let compared = "\n[[compare]]\ntitle = \"without preload\"\nwithout = [\"preload_stiffening\"]\n";
    let text = fs::read_to_string(sandbox.path(&plan)).unwrap();
    for (hold_out, words) in [
        ("", "hammer, decay, growth + axle-box, date of 0 passages"),
        ("[hold_out]\ndate = \"last\"\n", "to compare them: growth + axle-box, date of"),
    ] {
        fs::write(sandbox.path(&plan), format!("{text}{compared}{hold_out}")).unwrap();
        let outcome = sandbox.riffel(&format!("calibrate {plan} --dry-run"));
        for words in ["models: model of the plan, without preload\n", words] {
            assert!(outcome.text.contains(words), "{words}: {}", outcome.text);
        }
    }
}

#[test]
fn a_case_and_its_tables_make_a_plan() {
    let sandbox = Sandbox::new();
    sandbox.copy(SET);
    let make = format!("calibrate {SET}/case.toml --with {SET}/decay.csv -o out --dry-run");
    let outcome = sandbox.riffel(&make);
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(outcome.text.contains("track.sleeper.mass: decay"), "{}", outcome.text);
    let plan = sandbox.json(&format!("{make} --json"));
    let priors = plan["parameters"].as_array().unwrap();
    let sleeper = priors.iter().find(|one| one["key"] == "track.sleeper.mass");
    assert_eq!(sleeper.unwrap()["prior"]["factor"], 1.05, "{plan}");
    assert_eq!(plan["data"][0]["kind"], "decay-rate");
    // Of a vehicle that says nothing of them all wheels are driven, which its prior holds.
    let set = "validation/calibration/b-three-dates";
    sandbox.copy(set);
    let traffic = fs::read_to_string(sandbox.path(&format!("{set}/traffic.toml"))).unwrap();
    let traffic = traffic.replace("traction_share = 0.5\n", "");
    fs::write(sandbox.path("driven.toml"), traffic).unwrap();
    let plan = sandbox.json(&format!(
        "calibrate {set}/case.toml --with {set}/roughness.csv --traffic driven.toml -o out --dry-run --json"
    ));
    let priors = plan["parameters"].as_array().unwrap();
    let share = priors.iter().find(|one| one["key"] == "vehicle.traction_share");
    assert_eq!(share.unwrap()["prior"], serde_json::json!({ "min": 0.05, "max": 1 }));
    assert!(!sandbox.path("out").exists());
    fs::create_dir(sandbox.path("out")).unwrap();
    fs::write(sandbox.path("out/plan.toml"), "mine").unwrap();
    for (command, words) in [
        (make, "is not the plan with usual priors"),
        (format!("calibrate {SET}/case.toml --with {SET}/case.toml"), "no kind of measurement"),
        (format!("calibrate {SET}/plan.toml --traffic a.toml"), "--with"),
    ] {
        let outcome = sandbox.riffel(&command);
        assert_eq!(outcome.status, Some(2), "{}", outcome.text);
        assert!(outcome.sentence().contains(words), "{words}: {}", outcome.text);
    }
    assert_eq!(fs::read_to_string(sandbox.path("out/plan.toml")).unwrap(), "mine");
}

/// Levels of two bands that the model makes itself; with too few simulations or draws it is said.
// Long: calibrates twenty simulated sets of data, as few as may be asked for.
#[test]
fn simulated_data_hold_the_truth_as_often_as_is_said() {
    let sandbox = Sandbox::new();
    let set = "validation/calibration/b-three-dates";
    sandbox.copy(set);
    let plan = format!("{set}/plan.toml");
    fs::write(
        sandbox.path(&format!("{set}/roughness.csv")),
        "passages,wavelength_mm,level_db,standard_error_db\n\
         0,158.48932,0,0.2\n0,125.89254,0,0.2\n2000000,158.48932,2.2,0.2\n2000000,125.89254,2.9,0.2\n",
    )
    .unwrap();
    let text = "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
        [sampler]\nchains = 1\nwarmup = 100\ndraws = 198\n\
        [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }\n\
        [[data]]\nkind = \"dated-levels\"\nfile = \"roughness.csv\"\n\
        discrepancy = { kind = \"band\", standard_deviation = 0.1 }\n";
    fs::write(sandbox.path(&plan), text).unwrap();
    let outcome = sandbox.riffel(&format!("calibrate check {plan} --runs 20 -o ranks"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for words in
        ["wear.coefficient", "ln likelihood", "passages to the limit", "in 20 simulations the truth lies anywhere"]
    {
        assert!(outcome.text.contains(words), "{words}: {}", outcome.text);
    }
    let document = fs::read(sandbox.path("ranks/ranks.json")).unwrap();
    let document: serde_json::Value = serde_json::from_slice(&document).unwrap();
    assert_eq!(document["values"][0]["ranks"].as_array().unwrap().len(), 20);
    let of = [0, 1, 2].map(|place| document["values"][place]["of"].clone());
    let parameter = serde_json::json!({ "parameter": "wear.coefficient" });
    assert_eq!(of, [parameter, "log-likelihood".into(), "passages-to-limit".into()]);
    assert!(sandbox.path("ranks/ranks.png").exists());
    for (draws, runs, words) in
        [("198", 19, "--runs is 19, but must be an integer from 20 on"), ("98", 20, "sampler.draws is 98")]
    {
        fs::write(sandbox.path(&plan), text.replace("198", draws)).unwrap();
        let outcome = sandbox.riffel(&format!("calibrate check {plan} --runs {runs}"));
        assert_eq!(outcome.status, Some(2), "{}", outcome.text);
        assert!(outcome.sentence().contains(words), "{}", outcome.text);
    }
}

#[test]
fn what_is_wrong_is_said_and_other_files_stay() {
    let sandbox = Sandbox::new();
    sandbox.copy(SET);
    let plan = format!("{SET}/plan.toml");
    fs::create_dir(sandbox.path("mine")).unwrap();
    fs::write(sandbox.path("mine/notes.txt"), "keep").unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o mine"));
    assert_eq!(outcome.status, Some(2));
    assert!(outcome.sentence().contains("mine is not empty and holds no calibration"));
    let text = fs::read_to_string(sandbox.path(&plan)).unwrap();
    fs::write(sandbox.path(&plan), text.replacen("300 MN/m", "300 kg", 1)).unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o out"));
    assert_eq!(outcome.status, Some(2));
    assert!(outcome.sentence().contains("300 kg"), "{}", outcome.text);
    assert!(!sandbox.path("out").exists());
}

/// Two values that growth holds as a product, levels at two dates: from the chains to the forecast and the decision.
// Long: asks five commands over 200 draws of a calibration each.
#[test]
fn chains_lead_to_a_forecast_and_a_decision() {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/calibration/b-three-dates");
    let set = "validation/calibration/b-three-dates";
    fs::write(
        sandbox.path(&format!("{set}/roughness.csv")),
        "passages,wavelength_mm,level_db,standard_error_db\n\
         0,158.48932,0,0.02\n0,125.89254,0,0.02\n2000000,158.48932,2.2,0.02\n2000000,125.89254,2.9,0.02\n",
    )
    .unwrap();
    let head = "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
        [sampler]\nchains = 2\nwarmup = 150\ndraws = 200\n\
        [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }\n\
        [[parameter]]\nkey = \"vehicle.traction_share\"\nuniform = { min = 0.05, max = 0.95 }\n\
        [[data]]\nkind = \"dated-levels\"\nfile = \"roughness.csv\"\ncommon_error = 0.01\n\
        discrepancy = { kind = \"band\", standard_deviation = 0.1 }\n";
    let plan = format!("{set}/two.toml");
    fs::write(sandbox.path(&plan), head).unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o out"));
    assert!(outcome.status < Some(2), "{}", outcome.text);
    for words in [
        "the data tell wear.coefficient and vehicle.traction_share only together, as a product of powers",
        "months to the limit (EN ISO 3095:2013, Figure 2): ",
    ] {
        assert!(outcome.text.contains(words), "{words}: {}", outcome.text);
    }
    for name in ["posterior.png", "forecast.png", "correlations.csv"] {
        assert!(sandbox.path(&format!("out/{name}")).exists(), "{name}");
    }
    let told = fs::read_to_string(sandbox.path("out/identifiability.csv")).unwrap();
    let by: Vec<&str> = told.lines().skip(1).map(|line| line.split(',').nth(1).unwrap()).collect();
    assert_eq!(by, ["data", "prior"], "{told}");
    // Densities of data given the others, one for each draw and contrast.
    let array = fs::read_to_string(sandbox.path("out/posterior.zarr/log_likelihood/dated-levels/zarr.json"));
    let array: serde_json::Value = serde_json::from_str(&array.unwrap()).unwrap();
    assert_eq!(array["shape"], serde_json::json!([2, 200, 2]));
    // The document of the same chains has what the table has.
    let outcome = sandbox.riffel(&format!("calibrate {plan} -o out --restart --json -q"));
    // Doubts stand behind it.
    let documents = serde_json::Deserializer::from_str(&outcome.text);
    let document = documents.into_iter::<serde_json::Value>().next();
    let document = document.unwrap().unwrap();
    let summary = fs::read_to_string(sandbox.path("out/summary.csv")).unwrap();
    for (line, value) in summary.lines().skip(1).zip(document["parameters"].as_array().unwrap()) {
        let cells: Vec<&str> = line.split(',').collect();
        let median: f64 = cells[6].parse().unwrap();
        let own = value["quantiles"][2].as_f64().unwrap();
        assert_eq!(value["name"], cells[0]);
        // Nine digits of the table.
        assert!((own / median - 1.0).abs() < 1e-8, "{own} {median}");
        assert_eq!(value["may_be_written_back"], false, "told together only");
    }
    assert_eq!(document["is_conclusive"], outcome.status == Some(0));
    assert_eq!(document["data"][0]["measured"], "level_rise_db");
    // The same forecast on demand; another limit, other months.
    let forecast = sandbox.json(&format!("forecast {set}/case.toml --posterior out --json -q"));
    let level = |key: &str, place: usize| forecast["bands"][1][key][place].as_f64().unwrap();
    assert!((level("level_now_db", 2) - 2.9).abs() < 0.1, "{forecast}");
    assert!(level("level_then_db", 0) > level("level_now_db", 4), "{forecast}");
    for (arguments, words) in [
        (format!("{set}/case.toml --posterior out --set contact.friction=0.3"), "without --set"),
        (format!("{set}/case.toml --posterior out --months 0"), "must be above zero and at most 12000"),
        (format!("{set}/case.toml --posterior out --traffic {set}/traffic.toml"), "cannot be used with"),
        (format!("{set}/case.toml --posterior {set}"), "holds no calibration"),
    ] {
        let outcome = sandbox.riffel(&format!("forecast {arguments}"));
        assert_eq!(outcome.status, Some(2), "{}", outcome.text);
        assert!(outcome.sentence().contains(words), "{}", outcome.text);
    }
    over_the_calibration(&sandbox, set);
    // Actions may come later; data may not.
    let outcome = sandbox.riffel("decide out");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.sentence().contains("`cost` is missing"), "{}", outcome.text);
    let costs = "[cost]\ngrinding = \"9000 EUR\"\n[[action]]\nchanges = \"friction.toml\"\nupkeep = \"100 EUR\"\n";
    fs::write(sandbox.path(&plan), format!("{head}{costs}")).unwrap();
    let decision = sandbox.json("decide out --json -q");
    // A third less friction for next to nothing is the cheapest everywhere, and nothing is worth knowing.
    assert_eq!(decision["actions"][1]["probability_cheapest"], 1.0, "{decision}");
    assert_eq!(decision["evpi_per_year"], 0.0);
    let outcome = sandbox.riffel("decide out");
    assert!(outcome.text.contains("cheapest in the mean: friction"), "{}", outcome.text);
    assert!(sandbox.path("out/decision.png").exists());
    // A factor that leads beyond what can be computed.
    let more = costs.replace(
        "changes = \"friction.toml\"",
        "title = \"all driven\"\nmultiplies = { \"vehicle.traction_share\" = 20 }",
    );
    fs::write(sandbox.path(&plan), format!("{head}{more}")).unwrap();
    let outcome = sandbox.riffel("decide out");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    for words in ["\"all driven\"", "`vehicle.traction_share` becomes", "must be between 0 and 1"] {
        assert!(outcome.sentence().contains(words), "{words}: {}", outcome.text);
    }
    fs::write(sandbox.path(&plan), head.replace("0.95", "0.9")).unwrap();
    let outcome = sandbox.riffel("decide out");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.sentence().contains("another plan"), "{}", outcome.text);
}

/// A population tells the evidence; the copy of its plan beside the results, read from there, has the same results elsewhere.
// Long: draws two populations twice, by the plan and by its copy.
#[test]
fn a_population_tells_the_evidence_and_its_plan_can_be_moved() {
    let sandbox = Sandbox::new();
    let set = "validation/calibration/b-three-dates";
    sandbox.copy(set);
    let plan = "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
        [sampler]\nkind = \"smc\"\nchains = 2\ndraws = 60\n\
        [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }\n\
        [[data]]\nkind = \"dated-levels\"\nfile = \"roughness.csv\"\n\
        discrepancy = { kind = \"band\", standard_deviation = 1.0 }\n";
    fs::write(sandbox.path(&format!("{set}/smc.toml")), plan).unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {set}/smc.toml -o out"));
    assert!(outcome.status < Some(2), "{}", outcome.text);
    for words in ["ln evidence -", "by 2 runs; it moves with the width of the priors"] {
        assert!(outcome.text.contains(words), "{words}: {}", outcome.text);
    }
    let outcome = sandbox.riffel("calibrate out/plan.toml -o elsewhere/again");
    assert!(outcome.status < Some(2), "{}", outcome.text);
    let csv = |folder: &str| fs::read(sandbox.path(&format!("{folder}/summary.csv"))).unwrap();
    assert_eq!(csv("out"), csv("elsewhere/again"));
}

/// The evidence of one difference of levels, of which growth is linear in the wear over its normal prior: the density of a normal
/// distribution about the growth of the mean, with the variances of both. Each of two steps of 800 members errs by 1/√800; to
/// four errors of both.
// Long: draws two populations of 400 members, as many as its bound is of.
#[test]
fn the_evidence_of_a_linear_problem_is_in_the_document() {
    let sandbox = Sandbox::new();
    let set = "validation/calibration/b-three-dates";
    sandbox.copy(set);
    let write = |level: f64| {
        let levels =
            format!("passages,wavelength_mm,level_db,standard_error_db\n0,125,0,0.1\n10000000,125,{level},0.1\n");
        fs::write(sandbox.path(&format!("{set}/two.csv")), levels).unwrap();
    };
    write(0.0);
    let [mean, deviation] = [2.5e-9, 0.1e-9];
    let plan = format!(
        "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
        [sampler]\nkind = \"smc\"\nchains = 2\ndraws = 400\n\
        [[parameter]]\nkey = \"wear.coefficient\"\nnormal = {{ mean = {mean}, standard_deviation = {deviation} }}\n\
        [[data]]\nkind = \"dated-levels\"\nfile = \"two.csv\"\n"
    );
    let path = sandbox.path(&format!("{set}/linear.toml"));
    fs::write(&path, plan).unwrap();
    let read = || riffel_calibrate::Plan::read(&path).unwrap().posterior;
    let growth = |value| read().predictions(&[value]).unwrap()[0][0];
    let (low, middle, high) = (mean - deviation, mean, mean + deviation);
    let [of_low, of_middle, of_high] = [low, middle, high].map(growth);
    let slope = 0.5 * (of_high - of_low);
    assert!((of_high - of_middle - slope).abs() < 0.03 * slope, "{slope}");
    let level = of_middle + slope;
    write(level);
    let posterior = read();
    let likelihood = |value| posterior.log_likelihood(&[value]).unwrap()[0].1;
    let squares = [of_low, of_high].map(|of| (level - of).powi(2));
    let variance = 0.5 * (squares[0] - squares[1]) / (likelihood(high) - likelihood(low));
    let both = variance + slope * slope;
    let expected = -0.5 * ((std::f64::consts::TAU * both).ln() + slope * slope / both);
    assert!(slope * slope > variance, "{slope} {variance}");
    let document = sandbox.json(&format!("calibrate {set}/linear.toml -o out --json"));
    let told = document["log_evidence"]["value"].as_f64().unwrap();
    assert!((told - expected).abs() < 4.0 * (2.0_f64 / 800.0).sqrt(), "{told} {expected}");
}

/// Growth is what the levels say, 2.9 dB in two million axles, whatever command tells it; the whole case is taken, for no other.
fn over_the_calibration(sandbox: &Sandbox, set: &str) {
    let case = format!("{set}/case.toml");
    let number = |document: &serde_json::Value, name: &str, key: &str| {
        let numbers = document["over_posterior"]["numbers"].as_array().unwrap();
        let found = numbers.iter().find(|it| it["name"] == name);
        found.unwrap_or_else(|| panic!("{name}: {document}"))[key].clone()
    };
    let map = sandbox.json(&format!("map {case} --posterior out --json -q"));
    let passages = number(&map, "under_traffic.fastest.doubling_passages", "median");
    // The fastest line of the fastest band grows somewhat faster than its band.
    let of_band = 2e6 * 20.0 * 2f64.log10() / 2.9;
    let share = passages.as_f64().unwrap() / of_band;
    assert!((0.7..1.0).contains(&share), "{share}");
    fs::write(sandbox.path("now.csv"), "wavelength_mm,level_db\n158,4\n126,3\n100,2\n").unwrap();
    let compare = format!("compare {case} --with {set}/friction.toml --posterior out --spectrum now.csv");
    let outcome = sandbox.riffel(&format!("{compare} -o c"));
    for words in [
        "\"friction treatment\": over 200 draws of the calibration growth changes by",
        "and is less in 100 % of them",
        "months to the limit (90 %)",
    ] {
        assert!(outcome.text.contains(words), "{words}: {}", outcome.text);
    }
    // At a given tractive ratio growth goes with the square of friction, so that every draw has the change of the case.
    let told = fs::read_to_string(sandbox.path("c/posterior.csv")).unwrap();
    let median = |name: &str| {
        let line = told.lines().find(|line| line.starts_with(name)).unwrap();
        line.split(',').nth(4).unwrap().parse::<f64>().unwrap()
    };
    let rate = |title: &str| median(&format!("outcomes[{title}].fastest_growth_rate_per_passage"));
    let summary = fs::read_to_string(sandbox.path("c/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    let change = summary["outcomes"][1]["change_of_fastest_growth"].as_f64().unwrap();
    let found = rate("friction treatment") / rate("as it is") - 1.0;
    assert!((found - change).abs() < 1e-6, "{found} {change}");
    let noise = format!("noise {case} --roughness now.csv --speed \"110 km/h\" --posterior out");
    let outcome = sandbox.riffel(&format!("{noise} -o n"));
    assert!(outcome.text.contains("under the traffic"), "{}", outcome.text);
    assert!(sandbox.path("n/posterior.csv").exists());
    let report = format!("report {case} --roughness now.csv --traffic {set}/traffic.toml --posterior out -o r.html");
    assert_eq!(sandbox.riffel(&report).status, Some(0));
    let page = fs::read_to_string(sandbox.path("r.html")).unwrap();
    for words in ["Forecast over the calibration", "200 draws of the calibration"] {
        assert!(page.contains(words), "{words}");
    }
    for (command, words) in [
        (format!("map {case} --posterior out --set contact.friction=0.3"), "without --set"),
        (format!("map {case} --posterior {set}"), "holds no calibration"),
        (format!("{noise} --traffic {set}/traffic.toml"), "cannot be used with"),
        (format!("{compare} --speed 30"), "cannot be used with"),
        ("map cases/nominal.toml --posterior out".to_owned(), "of the case that is named"),
    ] {
        let outcome = sandbox.riffel(&command);
        assert_eq!(outcome.status, Some(2), "{command}: {}", outcome.text);
        assert!(outcome.sentence().contains(words), "{words}: {}", outcome.text);
    }
}

/// Levels that grow as the model says, the last of three dates left out: a model without growth predicts worse, one that has the
/// share of driven wheels from the case is not told apart, for growth holds only its product with the wear coefficient.
// Long: draws the chains of three models.
#[test]
fn models_are_compared_by_what_they_predict() {
    let sandbox = Sandbox::new();
    let set = "validation/calibration/b-three-dates";
    sandbox.copy(set);
    fs::write(
        sandbox.path(&format!("{set}/roughness.csv")),
        "passages,wavelength_mm,level_db,standard_error_db\n\
         0,158.48932,0,0.2\n0,125.89254,0,0.2\n2000000,158.48932,2.2,0.2\n2000000,125.89254,2.9,0.2\n\
         4000000,158.48932,4.6,0.2\n4000000,125.89254,6.0,0.2\n",
    )
    .unwrap();
    let plan = "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
        [sampler]\nchains = 2\nwarmup = 100\ndraws = 150\n\
        [hold_out]\ndate = \"last\"\n\
        [[compare]]\ntitle = \"no growth\"\nwithout = [\"wear.coefficient\"]\nset = { \"wear.coefficient\" = 2.5e-11 }\n\
        [[compare]]\ntitle = \"share known\"\nwithout = [\"vehicle.traction_share\"]\n\
        [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }\n\
        [[parameter]]\nkey = \"vehicle.traction_share\"\nuniform = { min = 0.05, max = 0.95 }\n\
        [[data]]\nkind = \"dated-levels\"\nfile = \"roughness.csv\"\n\
        discrepancy = { kind = \"band\", standard_deviation = 0.1 }\n";
    fs::write(sandbox.path(&format!("{set}/plan.toml")), plan).unwrap();
    let outcome = sandbox.riffel(&format!("calibrate {set}/plan.toml -o out"));
    assert!(outcome.status < Some(2), "{}", outcome.text);
    let table = fs::read_to_string(sandbox.path("out/models.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|it| *it == name).unwrap();
    let verdict = |model: &str| {
        let row = rows.iter().find(|row| row[0] == model).unwrap();
        row[column("verdict")]
    };
    assert_eq!(verdict("no growth"), "worse", "{table}");
    for model in ["model of the plan", "share known"] {
        // One of the two has the larger sum, which makes it no winner.
        assert_eq!(verdict(model), "not told apart", "{table}");
        let row = rows.iter().find(|row| row[0] == model).unwrap();
        assert_eq!(row[column("inside_90_percent")], "100.000000", "{table}");
    }
    for words in [
        "no growth predicts worse than",
        "are not told apart: ln density differs by",
        "date of 4000000 passages was left out: another date",
    ] {
        assert!(outcome.text.contains(words), "{words}: {}", outcome.text);
    }
    let document = fs::read(sandbox.path("out/models.json")).unwrap();
    let document: serde_json::Value = serde_json::from_slice(&document).unwrap();
    let score = &document["models"][0]["scores"][0];
    assert_eq!(score["held_out"]["date"], 4e6, "{score}");
    assert!(sandbox.path("out/models.png").exists());
    // Chains that are there are not drawn again, and give the same.
    let again = sandbox.riffel(&format!("calibrate {set}/plan.toml -o out --restart"));
    assert!(again.status < Some(2), "{}", again.text);
    assert_eq!(fs::read_to_string(sandbox.path("out/models.csv")).unwrap(), table);
}
