//! `riffel forecast` and `riffel compare`, from the files to the decision.

use std::f64::consts::LN_10;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const NIEDERWANGEN: &str = "validation/reference/sbb-track-noise";
const MEASURED: &str =
    "--spectrum validation/reference/sbb-track-noise/rail_roughness.csv --where laboratory=MBBM";

fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.copy(NIEDERWANGEN);
    sandbox
}

/// One band of 0 dB at 50 mm.
fn one_band(sandbox: &Sandbox, level: f64) {
    let text = format!("wavelength_mm,level_db\n50,{level}\n");
    fs::write(sandbox.path("one.csv"), text).unwrap();
}

#[test]
fn the_forecast_answers_under_the_fixed_names() {
    let sandbox = sandbox();
    let command = format!(
        "forecast cases/nominal.toml {MEASURED} --date-column date --traffic cases/traffic.toml"
    );
    let document = sandbox.json(&format!("{command} --months 6 --json"));
    let passages = number(&document["horizon"]["passages"]);
    assert!((passages / (6000.0 * 365.2425 / 2.0) - 1.0).abs() < 1e-12);
    assert_eq!(document["horizon"]["date"], "2016-04-01");
    let bands = document["bands"].as_array().unwrap();
    assert_eq!(bands.len(), 7);
    let mut first = f64::INFINITY;
    for (place, band) in bands.iter().enumerate() {
        let (now, then) = (
            &document["spectrum_now"][place],
            &document["spectrum_then"][place],
        );
        let rate = &document["growth_rate_per_passage"][place];
        assert_eq!(now["wavelength_m"], rate["wavelength_m"]);
        let change = number(&then["level_db"]) - number(&now["level_db"]);
        let linear = 20.0 / LN_10 * number(&rate["growth_rate_per_passage"]) * passages;
        // The fastest lines of a band take over: never less than its mean rate, at six months little more. What decays stays.
        assert!(
            change >= linear.max(0.0) - 1e-9 && change < linear.max(0.0) + 0.6,
            "{band}: {change} {linear}"
        );
        if let Some(passages) = band["passages_to_limit"].as_f64() {
            first = first.min(passages);
        }
    }
    assert_eq!(number(&document["passages_to_limit"]), first);
    let mgt = first * 14_600.0 * 1e-9;
    assert!((number(&document["mgt_to_limit"]) / mgt - 1.0).abs() < 1e-12);
    assert_eq!(document["bands_left_out"].as_array().unwrap().len(), 18);
    assert_eq!(sandbox.list("."), ["cases", "validation"]);
    let outcome = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(
        outcome.text.contains("grinding interval: EN ISO 3095:2013"),
        "{}",
        outcome.text
    );
    assert_eq!(
        sandbox.list("out"),
        [
            "bands.csv",
            "forecast.html",
            "forecast.png",
            "forecast.svg",
            "growth.csv",
            "summary.json"
        ]
    );
}

/// The 20 mm of Niederwangen fades: no wear coefficient is claimed, and the page says why.
#[test]
fn a_fading_grinding_mark_is_not_fitted() {
    let sandbox = sandbox();
    let command = format!(
        "forecast cases/nominal.toml {MEASURED} --date-column date --traffic cases/traffic.toml --json"
    );
    let document = sandbox.json(&command);
    let fit = &document["wear_fit"];
    assert_eq!(fit["paired"], true);
    assert_eq!(fit["records_earlier"], 8);
    // 2014-03-01 to 2015-10-01.
    assert_eq!(number(&fit["passages_between"]), 579.0 * 6000.0);
    assert!(fit["coefficient_kg_per_j"].is_null());
    assert!(
        fit["verdict"] == "against" || fit["verdict"] == "indistinct",
        "{fit}"
    );
    let mark = &fit["bands"][0];
    assert!((number(&mark["wavelength_m"]) - 0.019_953).abs() < 1e-6);
    assert!((number(&mark["measured_change_db"]) + 6.5).abs() < 0.1);
    let sentences = fit["sentences"].to_string();
    assert!(sentences.contains("no wear coefficient"), "{sentences}");
    assert!(sentences.contains("20 mm fades"), "{sentences}");
}

/// A rail that grows twice as fast as the model says gives twice the coefficient.
#[test]
fn the_coefficient_of_two_dates_is_found() {
    let sandbox = sandbox();
    let forecast = |arguments: &str| {
        sandbox.json(&format!(
            "forecast cases/nominal.toml --traffic cases/traffic.toml --json {arguments}"
        ))
    };
    let write = |name: &str, document: &Value, key: &str| {
        let mut text = "section,wavelength_m,level_db\n".to_owned();
        for level in document[key].as_array().unwrap() {
            for (section, more) in [("A", 0.4), ("B", -0.1), ("C", -0.2), ("D", 0.3)] {
                let own = number(&level["level_db"]) + more * f64::from(key == "spectrum_then");
                text += &format!("{section},{},{own}\n", level["wavelength_m"]);
            }
        }
        fs::write(sandbox.path(name), text).unwrap();
    };
    let future = forecast(&format!("{MEASURED} --passages 8e6"));
    write("now.csv", &future, "spectrum_now");
    write("then.csv", &future, "spectrum_then");
    let found = forecast("--spectrum then.csv --earlier now.csv --passages-between 4e6");
    let fit = &found["wear_fit"];
    assert_eq!(fit["verdict"], "fitted", "{fit}");
    let interval = &fit["coefficient_interval_kg_per_j"];
    let (low, high) = (number(&interval[0]), number(&interval[1]));
    assert!(low < 5e-9 && 5e-9 < high, "{fit}");
    assert!(
        (number(&fit["coefficient_kg_per_j"]) / 5e-9 - 1.0).abs() < 0.05,
        "{fit}"
    );
}

/// Two profiles are as many records as they have places in common, whose growth tells the coefficient.
#[test]
fn profiles_are_fitted_place_by_place() {
    let sandbox = sandbox();
    // A wave of 63 mm, higher from place to place, on a rough floor that stays as it is.
    let write = |name: &str, from: u32, to: u32, gain: f64| {
        let mut text = "position_m,left_um\n".to_owned();
        let mut floor = 1_u32;
        for sample in from * 1000..to * 1000 {
            let position = f64::from(sample) / 1000.0;
            floor = floor.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let height = 2.0 + (position / 10.0).floor() % 7.0;
            let wave = gain * height * (std::f64::consts::TAU * position / 0.063).cos();
            let rough = f64::from(floor >> 8) / f64::from(1_u32 << 24) - 0.5;
            text += &format!("{position:.3},{:.4}\n", wave + rough);
        }
        fs::write(sandbox.path(name), text).unwrap();
    };
    write("before.csv", 995, 1092, 1.0);
    write("now.csv", 1000, 1100, 1.4);
    let command = "forecast cases/nominal.toml --spectrum now.csv --earlier before.csv --passages-between 4e6 \
                   --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    let fit = &document["wear_fit"];
    assert_eq!(fit["verdict"], "fitted", "{fit}");
    assert_eq!(fit["paired"], true);
    // 1000 to 1090 m.
    assert_eq!(fit["records_earlier"], 9);
    assert_eq!(fit["records_later"], 9);
    let bands = fit["bands"].as_array().unwrap();
    let band = |wavelength: f64| {
        let is = |band: &&Value| (number(&band["wavelength_m"]) / wavelength - 1.0).abs() < 0.01;
        bands.iter().find(is).unwrap()
    };
    let grown = number(&band(0.0631)["measured_change_db"]);
    assert!((grown - 20.0 * 1.4_f64.log10()).abs() < 0.05, "{grown}");
    // Two places are too few, and there is one record of each rail as before.
    write("short.csv", 1000, 1022, 1.4);
    let short = sandbox.json(&command.replace("now.csv", "short.csv"));
    assert_eq!(short["wear_fit"]["records_later"], 1);
}

/// Passages, MGT and months that are the same amount give the same levels.
#[test]
fn the_amount_can_be_said_in_three_ways() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    let then = |horizon: &str| {
        let command = format!(
            "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml --json {horizon}"
        );
        number(&sandbox.json(&command)["spectrum_then"][0]["level_db"])
    };
    let level = then("--passages 1e6");
    assert!(level > 0.0);
    assert!((then("--mgt 14.6") - level).abs() < 1e-9);
    let months = 1e6 / 6000.0 / 365.2425 * 12.0;
    assert!((then(&format!("--months {months}")) - level).abs() < 1e-9);
}

/// A profile is analysed, its rails averaged; a rough one is beyond the linear range.
#[test]
fn a_profile_can_be_forecast() {
    let sandbox = sandbox();
    sandbox.riffel("roughness --synthesise -o made.csv");
    let command =
        "forecast cases/nominal.toml --spectrum made.csv --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    assert_eq!(document["inputs"]["records"], 2);
    assert!(document["wear_fit"].is_null());
    one_band(&sandbox, 40.0);
    let command =
        "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    assert_eq!(number(&document["passages_to_limit"]), 0.0);
    assert_eq!(document["bands"][0]["beyond_linear_range"], true);
    assert!(
        document["findings"]
            .to_string()
            .contains("beyond the linear range now")
    );
}

#[test]
fn variants_are_compared() {
    let sandbox = sandbox();
    fs::write(
        sandbox.path("dry.toml"),
        "title = \"dry\"\n[contact]\nfriction = 0.6\ntractive_ratio = 0.2\n",
    )
    .unwrap();
    fs::write(sandbox.path("slow.toml"), "[speed]\nfactor = 0.7\n").unwrap();
    let command = "compare cases/nominal.toml --with dry.toml --with slow.toml";
    let alone = sandbox.json(&format!("{command} --speed \"108 km/h\" --json"));
    let outcomes = alone["outcomes"].as_array().unwrap();
    let titles: Vec<&str> = outcomes
        .iter()
        .filter_map(|o| o["title"].as_str())
        .collect();
    assert_eq!(titles, ["as it is", "dry", "slow"]);
    // The ridge of the nominal case: 537 Hz, at 70 % of the speed 70 % of the wavelength.
    let wavelength = |index: usize| number(&outcomes[index]["fastest_wavelength_m"]);
    assert!((30.0 / wavelength(0) - 537.0).abs() < 15.0);
    assert!((wavelength(2) / wavelength(0) - 0.7).abs() < 0.02);
    assert!(number(&outcomes[1]["change_of_fastest_growth"]) > 0.5);
    assert_eq!(outcomes[0]["fastest_at_edge"], false);
    assert!(alone["spectrum_now"].is_null() && outcomes[0]["passages_to_limit"].is_null());
    let measured = "--where campaign=4 --traffic cases/traffic.toml -o out";
    let outcome = sandbox.riffel(&format!("{command} {MEASURED} {measured}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let text = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    let to_limit = |index: usize| number(&document["outcomes"][index]["passages_to_limit"]);
    assert!(to_limit(1) < to_limit(0));
    assert!(sandbox.list("out").contains(&"compare.png".to_owned()));
}

/// 68 dB is 3.5 mm: nothing is forecast where the wheel has left the rail, in table, JSON and files alike.
#[test]
fn a_forecast_ends_where_the_wheel_leaves_the_rail() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    let command = "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml";
    let near = sandbox.json(&format!("{command} --passages 1e6 --json"));
    let end = number(&near["valid_to_passages"]);
    assert_eq!(near["valid_to_passages"], near["linear_range"]["passages"]);
    assert!(number(&near["spectrum_then"][0]["level_db"]) > 0.0);
    assert!(
        (number(&near["valid_to_months"]) * 6000.0 * 365.2425 / 12.0 / end - 1.0).abs() < 1e-12
    );
    let far = sandbox.json(&format!(
        "{command} --passages {} -o far --json",
        10.0 * end
    ));
    assert!(far["spectrum_then"][0]["level_db"].is_null());
    assert!(far["bands"][0]["level_then_db"].is_null());
    assert_eq!(far["valid_to_passages"], near["valid_to_passages"]);
    let rows = fs::read_to_string(sandbox.path("far/bands.csv")).unwrap();
    let (header, row) = rows.split_once('\n').unwrap();
    let place = header
        .split(',')
        .position(|name| name == "level_then_db")
        .unwrap();
    assert_eq!(row.split(',').nth(place), Some(""), "{rows}");
    let picture = fs::read_to_string(sandbox.path("far/forecast.svg")).unwrap();
    assert!(picture.contains("where the forecast ends"));
    // A limit of a millimetre is never seen: neither a date nor "never".
    fs::write(
        sandbox.path("high.toml"),
        "name = \"high\"\ntitle = \"t\"\nedition = \"a millimetre\"\nsource = \"invented\"\n\
         [[level]]\nwavelength = \"50 mm\"\nlevel_db = 60.0\n",
    )
    .unwrap();
    let high = sandbox.json(&format!("{command} --limit high.toml --json"));
    assert_eq!(high["limit_reached"], "beyond-linear-range");
    assert!(high["passages_to_limit"].is_null() && high["date_of_limit"].is_null());
    let text = sandbox.riffel(&format!(
        "{command} --limit high.toml --passages {} -o far",
        2.0 * end
    ));
    assert_eq!(
        text.text.matches(" beyond the linear range").count(),
        2,
        "{}",
        text.text
    );
    assert!(
        text.text
            .contains("is not reached before the wheel leaves the rail"),
        "{}",
        text.text
    );
}

/// A rail 6 dB below the limit reaches it after the months that 6 dB of growth take.
#[test]
fn the_interval_of_a_rail_that_will_be_ground() {
    let sandbox = sandbox();
    let command = "forecast cases/nominal.toml --traffic cases/traffic.toml";
    let ground = sandbox.json(&format!("{command} --from-limit \"-6 dB\" --json"));
    assert_eq!(
        ground["inputs"]["ground"],
        "6 dB below EN ISO 3095:2013, Figure 2"
    );
    assert!(ground["inputs"]["spectrum"].is_null());
    let bands = ground["bands"].as_array().unwrap();
    assert_eq!(bands.len(), 7);
    for band in bands {
        let below = number(&band["limit_db"]) - number(&band["level_now_db"]);
        assert!((below - 6.0).abs() < 1e-9, "{band}");
    }
    let months = number(&ground["months_to_limit"]);
    let rates = bands
        .iter()
        .map(|band| number(&band["growth_rate_per_passage"]));
    let fastest = rates.fold(0.0, f64::max);
    // By the mean rate of the fastest band; its fastest lines are sooner there.
    let by_mean = 6.0 * LN_10 / 20.0 / fastest / (6000.0 * 365.2425 / 12.0);
    assert!(
        months > 0.8 * by_mean && months <= by_mean,
        "{months} {by_mean}"
    );
    let nearer = sandbox.json(&format!("{command} --from-limit=-3dB --json"));
    assert!(number(&nearer["months_to_limit"]) < 0.6 * months);
    // The same levels from a file are the same rail.
    let rows = bands
        .iter()
        .map(|band| format!("{},{}\n", band["wavelength_m"], band["level_now_db"]));
    let text = format!("wavelength_m,level_db\n{}", rows.collect::<String>());
    fs::write(sandbox.path("ground.csv"), text).unwrap();
    let file = sandbox.json(&format!("{command} --ground ground.csv --json"));
    assert!((number(&file["months_to_limit"]) / months - 1.0).abs() < 1e-9);
    let text = sandbox.riffel(&format!("{command} --from-limit \"-6 dB\""));
    let sentence = "grinding interval from 6 dB below EN ISO 3095:2013, Figure 2";
    assert!(text.text.contains(sentence), "{}", text.text);
    fs::write(
        sandbox.path("damp.toml"),
        "title = \"damp\"\n[wear]\ncoefficient = 1.25e-9\n",
    )
    .unwrap();
    let compare =
        "compare cases/nominal.toml --with damp.toml --traffic cases/traffic.toml --from-limit -6";
    let compared = sandbox.json(&format!("{compare} --json"));
    let of = |index: usize| number(&compared["outcomes"][index]["months_to_limit"]);
    assert!((of(0) / months - 1.0).abs() < 1e-12);
    // Half the wear, twice the time.
    assert!((of(1) / of(0) - 2.0).abs() < 1e-9);
    let text = sandbox.riffel(compare).text;
    assert!(text.contains("months to limit"), "{text}");
}

#[test]
fn what_cannot_act_is_not_given_as_no_change() {
    let sandbox = sandbox();
    let compare = "compare cases/nominal.toml --with cases/soft-pads.toml";
    let compared = sandbox.json(&format!("{compare} --json"));
    let pads = &compared["outcomes"][1];
    assert_eq!(pads["acts"], false);
    assert!(pads["change_of_fastest_growth"].is_null());
    let text = sandbox.riffel(compare).text;
    assert!(
        text.contains("cannot act") && !text.contains("+0 %") && !text.contains("-0 %"),
        "{text}"
    );
    let sentence = "track.model = \"free-beam\" is a rail without supports";
    assert!(
        text.contains(sentence)
            && pads["no_effect"]
                .to_string()
                .contains("rail without supports"),
        "{text}"
    );
    // The values of the case itself, and one key of two.
    fs::write(
        sandbox.path("same.toml"),
        "title = \"same\"\n[contact]\nfriction = 0.4\n",
    )
    .unwrap();
    fs::write(
        sandbox.path("both.toml"),
        "title = \"both\"\n[wheel]\nmass = \"300 kg\"\n[track]\npad = { stiffness = \"80 MN/m\", damping = \"9 kNs/m\" }\n",
    )
    .unwrap();
    let compare = "compare cases/nominal.toml --with same.toml --with both.toml";
    let compared = sandbox.json(&format!("{compare} --json"));
    assert_eq!(compared["outcomes"][1]["acts"], false);
    assert_eq!(compared["outcomes"][2]["acts"], true);
    assert!(compared["outcomes"][2]["change_of_fastest_growth"].is_number());
    let text = sandbox.riffel(compare).text;
    assert!(text.contains("changes nothing"), "{text}");
    assert!(
        text.contains("`track.pad.stiffness`") && text.contains("` have no effect, for"),
        "{text}"
    );
    // On a track with pads they act.
    let pads = "compare cases/discrete-supports.toml --with cases/soft-pads.toml --json";
    let acts = sandbox.json(pads);
    assert!(acts["outcomes"][1]["acts"] == true && acts["outcomes"][1]["no_effect"].is_null());
}

/// The three mean states that less friction can leave as it was, each held against a file that gives it by number.
#[test]
fn what_friction_leaves_as_it_was_is_said() {
    let sandbox = sandbox();
    let write = |name: &str, rest: &str| {
        let text = format!("title = \"{name}\"\n[contact]\nfriction = 0.25\n{rest}");
        fs::write(sandbox.path(&format!("{name}.toml")), text).unwrap();
    };
    write("less", "");
    // Q₀ = 0.1 · 0.4 P₀ = 0.16 · 0.25 P₀.
    write("force", "tractive_ratio = 0.16\n");
    write("ratio", "tractive_ratio = 0.1\n");
    let point = sandbox.json("point cases/nominal.toml --wavelength 0.05 --speed 30 --json");
    write("creepage", &format!("creepage = {}\n", point["creepage"]));
    let rate = |arguments: &str| {
        let compared = sandbox.json(&format!("compare cases/nominal.toml {arguments} --json"));
        let outcome = &compared["outcomes"][1];
        (
            number(&outcome["fastest_growth_rate_per_passage"]),
            outcome["hold"].clone(),
        )
    };
    let mut rates = Vec::new();
    for hold in ["force", "ratio", "creepage"] {
        let (held, name) = rate(&format!("--with less.toml --hold {hold}"));
        let (given, of_file) = rate(&format!("--with {hold}.toml"));
        assert_eq!(name, hold);
        assert!(of_file.is_null());
        assert!((held / given - 1.0).abs() < 1e-9, "{hold}: {held} {given}");
        rates.push(held);
    }
    assert!(rates[0] > 1.2 * rates[1], "{rates:?}");
    assert_eq!(rate("--with less.toml"), (rates[1], "ratio".into()));
    // The case gives the creepage: that is what stays.
    let by_creepage = format!(
        "--with less.toml --set contact.creepage={}",
        point["creepage"]
    );
    assert_eq!(rate(&by_creepage).1, "creepage");
    let text = sandbox
        .riffel("compare cases/nominal.toml --with less.toml")
        .text;
    assert!(text.contains("held") && text.contains("ratio"), "{text}");
    assert!(text.contains("\"less\" keeps the tractive ratio"), "{text}");
    let asked = sandbox.riffel("compare cases/nominal.toml --with less.toml --hold ratio");
    assert!(!asked.text.contains("keeps the tractive ratio"));
    // Wet leaves: the force asked for is more than friction can carry.
    fs::write(
        sandbox.path("wet.toml"),
        "title = \"wet\"\n[contact]\nfriction = 0.03\n",
    )
    .unwrap();
    let outcome = sandbox.riffel("compare cases/nominal.toml --with wet.toml --hold force");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    let text = outcome.text.replace("\n  │ ", " ");
    assert!(text.contains("2.000 kN on a wheel is 1.33 times"), "{text}");
    assert!(text.contains("--hold ratio"), "{text}");
    let wet = sandbox.riffel("compare cases/nominal.toml --with wet.toml");
    assert_eq!(wet.status, Some(0), "{}", wet.text);
}

/// Without a speed and a traffic a comparison is under the usual traffic of the line, as the map is.
#[test]
fn a_comparison_is_under_the_traffic_that_the_map_names() {
    let sandbox = Sandbox::new();
    let map = sandbox.json("map cases/metro.toml --json");
    let compared = sandbox.json("compare cases/metro.toml --with cases/soft-pads.toml --json");
    let [fastest, own] = [&map["under_traffic"]["fastest"], &compared["outcomes"][0]];
    assert_eq!(own["fastest_wavelength_m"], fastest["wavelength_m"]);
    assert_eq!(
        own["fastest_growth_rate_per_passage"],
        fastest["growth_rate_per_passage"]
    );
    let words = "under the usual traffic of a metro (40–70 km/h, 6000 axles a day)";
    assert_eq!(compared["speeds"], words);
    // Numbers between zero and minus one keep their sign in German.
    let printed = |language: &str| {
        let compare = "compare cases/metro.toml --with cases/soft-pads.toml";
        sandbox
            .riffel(&format!("--language {language} {compare}"))
            .text
    };
    let minus = |text: &str| text.matches(" -0").count();
    assert!(minus(&printed("en")) > 0);
    assert_eq!(minus(&printed("en")), minus(&printed("de")));
}

/// A metro curve: with τ = 0.5 on every axle the amplitude doubles within weeks, which no railway has reported.
#[test]
fn growth_faster_than_ever_reported_is_remarked() {
    let sandbox = sandbox();
    one_band(&sandbox, -10.0);
    let vehicle = |name: &str, more: &str| {
        let text = format!(
            "[line]\npassages_per_day = 10000\n[[vehicle]]\nname = \"metro\"\nshare = 1\n\
             speed = {{ mean = \"60 km/h\" }}\ntractive_ratio = 0.5\n{more}"
        );
        fs::write(sandbox.path(name), text).unwrap();
    };
    vehicle("all.toml", "");
    vehicle("part.toml", "traction_share = \"5 %\"\n");
    let forecast = |traffic: &str| {
        sandbox.json(&format!(
            "forecast cases/nominal.toml --spectrum one.csv --traffic {traffic} --json"
        ))
    };
    let (all, part) = (forecast("all.toml"), forecast("part.toml"));
    let rate = |document: &Value| number(&document["bands"][0]["growth_rate_per_passage"]);
    assert!((rate(&part) / rate(&all) - 0.05).abs() < 1e-12);
    let remarks = |document: &Value| document["remarks"].to_string();
    assert!(
        remarks(&all).contains("Torstensson & Nielsen 2009"),
        "{}",
        remarks(&all)
    );
    assert!(
        !remarks(&part).contains("Torstensson"),
        "{}",
        remarks(&part)
    );
    vehicle("much.toml", "traction_share = 1.5\n");
    let outcome =
        sandbox.riffel("forecast cases/nominal.toml --spectrum one.csv --traffic much.toml");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(
        outcome
            .text
            .contains("traction_share` is 1.5, but must be between 0 and 1"),
        "{}",
        outcome.text
    );
}

#[test]
fn bad_input_is_answered_with_a_sentence() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    fs::write(sandbox.path("long.csv"), "wavelength_mm,level_db\n1000,3\n").unwrap();
    fs::write(sandbox.path("nothing.toml"), "title = \"no change\"\n").unwrap();
    fs::write(
        sandbox.path("quiet.toml"),
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\n",
    )
    .unwrap();
    let forecast = "forecast cases/nominal.toml --traffic cases/traffic.toml";
    for (arguments, part) in [
        (
            format!("{forecast} --spectrum none.csv"),
            "cannot read the file none.csv",
        ),
        (
            format!("{forecast} --spectrum long.csv"),
            "map.wavelength of the case",
        ),
        (
            format!("{forecast} --spectrum one.csv --limit grassie-1999"),
            "one-third-octave levels",
        ),
        (
            format!("{forecast} --spectrum one.csv --limit none"),
            "no limit table",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages -1"),
            "must be above zero and at most 1000000000000",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages 2,5e6"),
            "no separators of thousands",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages 1 --mgt 1"),
            "cannot be used with",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages-between 1e6"),
            "no earlier measurement",
        ),
        (
            format!("{forecast} --spectrum one.csv --earlier one.csv"),
            "--passages-between",
        ),
        (
            format!("{forecast} --spectrum one.csv --date-column date"),
            "no column \"date\"",
        ),
        (
            format!("{forecast} --spectrum one.csv --date 2026-02-30"),
            "--date",
        ),
        (
            "forecast cases/nominal.toml --traffic none.toml --spectrum one.csv".to_owned(),
            "cannot read the traffic file",
        ),
        (
            "forecast cases/nominal.toml --traffic quiet.toml --spectrum one.csv".to_owned(),
            "passages_per_day",
        ),
        (
            "compare cases/nominal.toml --with none.toml".to_owned(),
            "cannot read the file of changes",
        ),
        (
            "compare cases/nominal.toml --with nothing.toml".to_owned(),
            "changes nothing",
        ),
        ("compare cases/nominal.toml".to_owned(), "--with"),
        (
            "forecast cases/nominal.toml --traffic cases/nominal.toml --spectrum one.csv"
                .to_owned(),
            "this is a case file, with its table [wheel], and no traffic file",
        ),
        (
            "forecast cases/traffic.toml --traffic cases/traffic.toml --spectrum one.csv"
                .to_owned(),
            "this is a traffic file, with its [[vehicle]], and no case file",
        ),
        (
            format!("{forecast} --from-limit \"6 dB\""),
            "below the limit",
        ),
        (format!("{forecast} --from-limit -6mm"), "below the limit"),
        (
            format!("{forecast} --ground iso-3095-2013"),
            "smoother than --limit",
        ),
        (
            format!("{forecast} --ground grassie-1999"),
            "one-third-octave levels",
        ),
        (format!("{forecast} --ground none.csv"), "none.csv"),
        (
            format!("{forecast} --spectrum one.csv --from-limit -6"),
            "cannot be used with",
        ),
        (forecast.to_owned(), "--spectrum"),
        (
            "compare cases/nominal.toml --with nothing.toml --hold torque".to_owned(),
            "invalid value 'torque'",
        ),
    ] {
        let outcome = sandbox.riffel(&arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        let text = outcome.text.replace("\n  │ ", " ");
        assert!(text.contains(part), "{arguments}: {text}");
    }
    let left = [
        "cases",
        "long.csv",
        "nothing.toml",
        "one.csv",
        "quiet.toml",
        "validation",
    ];
    assert_eq!(sandbox.list("."), left);
}

#[test]
fn a_traffic_file_to_start_from_is_written() {
    let sandbox = sandbox();
    one_band(&sandbox, -10.0);
    let outcome = sandbox.riffel("init --traffic mine.toml");
    assert!(
        outcome.text.contains("--traffic mine.toml"),
        "{}",
        outcome.text
    );
    let command = "forecast cases/nominal.toml --spectrum one.csv --traffic mine.toml --json";
    assert!(sandbox.json(command)["passages_to_limit"].is_number());
    let schema = sandbox.json("schema --traffic");
    assert!(schema["properties"]["vehicle"].is_object());
}

/// What was measured on several dates is now at its latest, and no mean of years.
#[test]
fn now_is_the_latest_date() {
    let sandbox = Sandbox::new();
    let text = "rail,date,80 mm,63 mm,50 mm,40 mm\n\
                L,2026-01-15,1,1,14,1\n\
                L,2024-01-15,1,1,0,1\n\
                R,2026-01-14,1,1,3,1\n\
                R,2024-01-15,1,1,0,1\n";
    fs::write(sandbox.path("dated.csv"), text).unwrap();
    let document = sandbox.json(
        "forecast cases/nominal.toml --spectrum dated.csv --traffic cases/traffic.toml --json",
    );
    let at_50 = |rail: &Value| {
        let bands = rail["bands"].as_array().unwrap();
        let near = |row: &&Value| (number(&row["wavelength_m"]) - 0.05).abs() < 1e-3;
        number(&bands.iter().find(near).unwrap()["level_now_db"])
    };
    let rails: Vec<f64> = document["rails"]
        .as_array()
        .unwrap()
        .iter()
        .map(at_50)
        .collect();
    // The mean of one level passes through its energy.
    let is = |found: f64, level: f64| (found - level).abs() < 1e-9;
    assert!(is(rails[0], 14.0) && is(rails[1], 3.0), "{rails:?}");
    assert!(
        document["remarks"]
            .to_string()
            .contains("now is the latest of each rail, 2026-01-15")
    );
    // Nor does a limit hold for a mean of years.
    let document = sandbox.json("roughness dated.csv --json");
    let groups = document["groups"].as_array().unwrap();
    let names: Vec<&str> = groups
        .iter()
        .map(|group| group["group"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        ["date 2024-01-15", "date 2026-01-14", "date 2026-01-15"]
    );
}

/// One record of each date gives a best fit and no claim; levels that stay have not fallen.
#[test]
fn two_records_claim_no_coefficient() {
    let sandbox = Sandbox::new();
    let sentence = |change: f64| {
        let rows = [("2025-01-15", 0.0), ("2026-01-15", change)].map(|(date, change)| {
            let levels =
                [80.0, 63.0, 50.0, 40.0].map(|length| format!("{date},{length},{change}\n"));
            levels.concat()
        });
        let text = format!("date,wavelength_mm,level_db\n{}", rows.concat());
        fs::write(sandbox.path("dated.csv"), text).unwrap();
        let document = sandbox.json(
            "forecast cases/nominal.toml --spectrum dated.csv --date-column date \
             --traffic cases/traffic.toml --json",
        );
        document["findings"].to_string() + &document["wear_fit"].to_string()
    };
    let grown = sentence(3.0);
    assert!(grown.contains("no wear coefficient is claimed"), "{grown}");
    let same = sentence(0.0);
    assert!(
        same.contains("have not moved") && !same.contains("have fallen"),
        "{same}"
    );
    let fallen = sentence(-3.0);
    assert!(fallen.contains("have fallen"), "{fallen}");
}

/// Two welds are no roughness that grows: forecast and noise leave them out and say so, unless they are kept.
#[test]
fn welds_do_not_grow() {
    let sandbox = Sandbox::new();
    let mut text = "position [m],height [um]\n".to_owned();
    let mut random = 1u32;
    for sample in 0..30_000u32 {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let x = 2e-3 * f64::from(sample);
        let noise = f64::from(random >> 16) / 65_536.0 - 0.5;
        let slow = 2.0 * (x / 0.11).sin() * (x / 0.7).cos();
        let dips = [17.0, 41.0].map(|at| (1.0 - (x - at).abs() / 0.1).max(0.0));
        text += &format!("{x:.3},{:.3}\n", noise + slow - 300.0 * (dips[0] + dips[1]));
    }
    fs::write(sandbox.path("welds.csv"), text).unwrap();
    let level = |kept: &str| {
        let document = sandbox.json(&format!(
            "forecast cases/metro.toml --traffic cases/traffic.toml --spectrum welds.csv --json {kept}"
        ));
        let bands = document["bands"].as_array().unwrap();
        let near = |band: &&Value| (number(&band["wavelength_m"]) - 0.16).abs() < 0.01;
        number(&bands.iter().find(near).unwrap()["level_now_db"])
    };
    assert!(level("--keep-defects") > level("") + 6.0);
    let outcome =
        sandbox.riffel("noise cases/metro.toml --speed \"80 km/h\" --roughness welds.csv");
    assert!(
        outcome
            .text
            .contains("2 welds, joints or squats: 17.0 m (-299 µm), 41.0 m (-300 µm)"),
        "{}",
        outcome.text
    );
}
