//! Decisions against brute force.

use std::fs;

use riffel::roughness::{LevelLimit, Spectrum, ThirdOctave};
use riffel_calibrate::{Decision, Folder, Forecast, Plan};
use riffel_study::Stop;
use tempfile::TempDir;

use crate::json;

const DAYS_PER_MONTH: f64 = 365.2425 / 12.0;

/// Costs of three actions, and months as it is.
type Node = ([f64; 3], f64);

/// Costs of three actions, and whether they break a budget, a noise limit and hours of possession.
type Asked = ([f64; 3], [[bool; 3]; 3]);

/// A folder with the case and the traffic of set b, one uncertain value, and some rows of levels.
fn one_value(rows: &str, more: &str) -> TempDir {
    let copy = TempDir::new().unwrap();
    crate::copy_set("b-three-dates", copy.path());
    let head = "passages,wavelength_mm,level_db,standard_error_db\n";
    fs::write(copy.path().join("roughness.csv"), format!("{head}{rows}")).unwrap();
    let plan = "case = \"case.toml\"\ntraffic = \"traffic.toml\"\n\
        [sampler]\nchains = 2\nwarmup = 200\ndraws = 2000\nseed = 3\n\
        [[parameter]]\nkey = \"wear.coefficient\"\nlognormal = { median = 2.5e-9, factor = 2.0 }\n\
        [[data]]\nkind = \"dated-levels\"\nfile = \"roughness.csv\"\n\
        discrepancy = { kind = \"band\", standard_deviation = 0.0 }\n";
    fs::write(copy.path().join("plan.toml"), format!("{plan}{more}")).unwrap();
    copy
}

/// Passages until a band has risen by 6 dB, for a value, and the highest rise after some passages: levels that the model says of many
/// dates, with a line between them.
fn brute_force(plan: &Plan, dates: &[f64], bands: usize, value: f64, after: f64) -> [f64; 2] {
    let rises = plan.posterior.predictions(&[value]).unwrap().concat();
    assert_eq!(rises.len(), dates.len() * bands);
    let highest = |date: usize| {
        let own = &rises[date * bands..(date + 1) * bands];
        own.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    };
    let (mut passages, mut rise) = (0.0, 0.0);
    let mut found = [f64::INFINITY, f64::NAN];
    for (date, at) in dates.iter().enumerate() {
        let slope = (highest(date) - rise) / (at - passages);
        if highest(date) >= 6.0 && rise < 6.0 {
            found[0] = passages + (6.0 - rise) / slope;
        }
        if (passages..*at).contains(&after) {
            found[1] = rise + slope * (after - passages);
        }
        (passages, rise) = (*at, highest(date));
    }
    found
}

/// One uncertain value, three bands at two dates, three actions: mean costs, chances, regrets and the worth of knowing all are those
/// of a grid over the value, on which each interval is looked up in a long table of levels.
// Long: predicts levels at 60 dates for 241 values of two cases, the independent side of the comparison.
#[test]
fn a_decision_is_that_of_brute_force_on_a_grid() {
    let measured = "0,158,0.0,0.5\n0,126,0.0,0.5\n0,100,0.0,0.5\n\
        2000000,158,2.2,0.5\n2000000,126,2.9,0.5\n2000000,100,1.4,0.5\n";
    let costs = "[cost]\ngrinding = \"9000 EUR\"\nover_limit = \"2000 EUR\"\nhorizon = \"25 months\"\n\
        [[action]]\nchanges = \"friction.toml\"\nupkeep = \"2300 EUR\"\n\
        [[action]]\ntitle = \"every 12 months\"\ngrind_every = \"12 months\"\n\
        [[measurement]]\nkind = \"dated-levels\"\nprice = \"100 EUR\"\n";
    let copy = one_value(measured, costs);
    let plan = Plan::read(&copy.path().join("plan.toml")).unwrap();
    let out = copy.path().join("out");
    let run = Folder::begin(&plan, &out, false).unwrap();
    let chains = run.run(&|_| {}, &Stop::default()).unwrap().unwrap();
    let found = Decision::of(&plan, &chains).unwrap();
    // The same levels as a table of many dates, as the case is and with less friction.
    let dates: Vec<f64> = (1..=60).map(|step| 1e5 * f64::from(step)).collect();
    let row = |passages: f64| {
        let bands = ["158", "126", "100"].map(|band| format!("{passages},{band},0,0.5\n"));
        bands.concat()
    };
    let long: String = std::iter::once(0.0).chain(dates.iter().copied()).map(row).collect();
    let tables = ["", "[set]\ncontact.friction = 0.25\n"].map(|set| {
        let copy = one_value(&long, set);
        Plan::read(&copy.path().join("plan.toml")).unwrap()
    });
    let (mut weights, mut all, mut asked) = (Vec::new(), Vec::new(), Vec::new());
    for step in -120..=120 {
        let z = 2.5e-9f64.ln() + 0.02 * f64::from(step);
        let per_month = 6000.0 * DAYS_PER_MONTH;
        let courses = tables.each_ref().map(|table| brute_force(table, &dates, 3, z.exp(), 24.0 * per_month));
        let [own, treated] = courses.map(|course| course[0] / per_month);
        let loudest = courses[0][1] - 6.0;
        let reactive = |months: f64| 12.0 / months.min(25.0) * 9000.0;
        let over = if own > 25.0 { 0.0 } else { (12.0 - own).max(0.0) };
        let costs = [reactive(own), 2300.0 + reactive(treated), 9000.0 + 2000.0 * over];
        weights.push(plan.posterior.log_density(&[z]).unwrap().exp());
        all.push((costs, own));
        // 7000 EUR a year, 0.5 dB above the limit after 24 months, three hours of 5 each time.
        let over = if own > 25.0 { 0.0 } else { (24.0 - own).max(0.0) };
        let costs = [costs[0], costs[1], 0.5 * (9000.0 + 2000.0 * over)];
        let hours = |months: f64| 12.0 / months.min(25.0) * 5.0;
        let hours = [hours(own), 0.5 + hours(treated), 2.5];
        let highest = [0.0, 0.0, loudest];
        let breaks = [0, 1, 2].map(|place| [costs[place] > 7000.0, highest[place] > 0.5, hours[place] > 3.0]);
        asked.push((costs, breaks));
    }
    let sum: f64 = weights.iter().sum();
    let mean = |of: &dyn Fn(&Node) -> f64| {
        let terms = weights.iter().zip(&all);
        terms.map(|(weight, it)| weight * of(it)).sum::<f64>() / sum
    };
    let least = |costs: &[f64; 3]| costs.iter().copied().fold(f64::INFINITY, f64::min);
    let best = mean(&|(costs, _)| least(costs));
    let mut means = Vec::new();
    for (place, action) in found.actions.iter().enumerate() {
        let cost = mean(&|(costs, _)| costs[place]);
        means.push(cost);
        // 1000 draws that hardly follow from each other: costs scatter by up to a fifth, of which three standard errors are
        // 2 %; 0.05 of a chance.
        assert!((action.mean_cost_per_year / cost - 1.0).abs() < 0.02, "{action:?} {cost}");
        let regret = action.expected_regret_per_year;
        assert!((regret - (cost - best)).abs() < 0.02 * cost, "{action:?} {best}");
        let cheapest = mean(&|(costs, _)| f64::from(u8::from(costs[place] == least(costs))));
        assert!((action.probability_cheapest - cheapest).abs() < 0.05, "{action:?} {cheapest}");
    }
    let never = mean(&|(_, months)| f64::from(u8::from(*months > 25.0)));
    assert!((found.actions[0].months_to_limit.probability_never - never).abs() < 0.05);
    let worth = means.iter().copied().fold(f64::INFINITY, f64::min) - best;
    assert!((found.evpi_per_year - worth).abs() < 0.15 * worth, "{} {worth}", found.evpi_per_year);
    // What an action must hold to: those that break it are no choice any more.
    let more = costs
        .replace(
            "[cost]\n",
            "[cost]\nbudget = \"7000 EUR\"\nnoise_limit = \"0.5 dB\"\npossession_hours = \"3 h\"\ngrinding_hours = \"5 h\"\n",
        )
        .replace("upkeep", "possession_hours = \"0.5 h\"\nupkeep")
        .replace("12 months", "24 months");
    let text = fs::read_to_string(copy.path().join("plan.toml")).unwrap();
    fs::write(copy.path().join("plan.toml"), text.replace(costs, &more)).unwrap();
    let plan = Plan::read(&copy.path().join("plan.toml")).unwrap();
    let held = Decision::of(&plan, &chains).unwrap();
    let mean = |of: &dyn Fn(&Asked) -> f64| {
        let terms = weights.iter().zip(&asked);
        terms.map(|(weight, it)| weight * of(it)).sum::<f64>() / sum
    };
    let share = |place: usize, what: usize| mean(&|(_, breaks)| f64::from(u8::from(breaks[place][what])));
    let means = [0, 1, 2].map(|place| mean(&|(costs, _)| costs[place]));
    let holds = [0, 1, 2].map(|place| (0..3).all(|what| share(place, what) <= 0.05));
    let best = mean(&|(costs, _)| {
        let allowed = costs.iter().zip(holds).filter(|(_, holds)| *holds);
        allowed.map(|(cost, _)| *cost).fold(f64::INFINITY, f64::min)
    });
    let mut unsure = 0;
    for (place, action) in held.actions.iter().enumerate() {
        let found = &action.breaks;
        let found = [found.budget, found.noise_limit, found.possession_hours];
        for (what, found) in found.into_iter().enumerate() {
            let expected = share(place, what);
            assert!((found.unwrap() - expected).abs() < 0.05, "{action:?} {expected}");
            unsure += usize::from((0.1..0.9).contains(&expected));
        }
        assert_eq!(action.breaks.holds(), holds[place]);
        let before = (0..3).filter(|other| (!holds[*other], means[*other]) < (!holds[place], means[place]));
        assert_eq!(action.rank, 1 + before.count(), "{means:?} {holds:?}");
        let regret = action.expected_regret_per_year;
        assert!((regret - (means[place] - best)).abs() < 0.02 * means[place]);
    }
    assert!(holds.contains(&true) && holds.contains(&false) && unsure >= 3, "{holds:?} {unsure}");
    // What breaks it is never told to be the cheapest.
    let cheapest = held.actions.iter().filter(|it| !it.breaks.holds());
    assert!(cheapest.clone().all(|it| it.probability_cheapest == 0.0));
    assert!(cheapest.map(|it| it.rank).min() > Some(holds.iter().filter(|it| **it).count()));
    // There is but one value to know, and a measurement is worth less than to know it.
    let value = found.evppi_per_year[0].per_year;
    assert!((value - found.evpi_per_year).abs() < 0.2 * worth, "{value}");
    // Its worth of 25 months at 3 %, less the price.
    let present = (1.0 - 1.03f64.powf(-25.0 / 12.0)) / 0.03;
    let first = &found.measurements[0];
    assert!((first.net.unwrap() - (present * first.per_year - 100.0)).abs() < 1e-9);
    let measured = found.measurements[0].per_year;
    assert!(measured > 0.0 && measured < found.evpi_per_year, "{measured}");
}

/// `decide.json`: mean costs to 3 %, the worth of knowing to three standard errors: that of 1000 draws is 9 a year (seven seeds), and
/// the reference has as many.
pub(crate) fn check_three_dates(plan: &Plan, chains: &riffel_calibrate::Chains) {
    let found = Decision::of(plan, chains).unwrap();
    let expected = json("b-three-dates", "decide.json");
    for (action, name) in found.actions.iter().zip(["as_it_is", "soft_pads", "friction", "speed_spread"]) {
        let cost = 1e3 * expected["actions"][name]["mean_cost"].as_f64().unwrap();
        assert!((action.mean_cost_per_year / cost - 1.0).abs() < 0.03, "{action:?}");
    }
    // The levels of the date that was held out, 6e6 axles: those of 400 draws of the second implementation.
    let months = 2.5e6 / 6000.0 / DAYS_PER_MONTH;
    let held_out = &json("b-three-dates", "posterior.json")["heldout"];
    let limit = [(ThirdOctave::centred(0.1).unwrap(), 0.0)];
    let limit = LevelLimit::new(Spectrum::new(limit).unwrap());
    let forecast = Forecast::of(plan, chains, &limit, months).unwrap();
    for (band, found) in forecast.bands.iter().enumerate() {
        for (share, level) in ["0.05", "0.25", "0.5", "0.75", "0.95"].iter().zip(found.level_then_db) {
            let expected = held_out["level_db"][share][band].as_f64().unwrap();
            assert!((level - expected).abs() < 0.4, "{found:?} {share} {expected}");
        }
    }
    const THREE_ERRORS: f64 = 38.0;
    let evpi = 1e3 * expected["evpi"].as_f64().unwrap();
    assert!((found.evpi_per_year - evpi).abs() < THREE_ERRORS, "{}", found.evpi_per_year);
    let speed = found.evppi_per_year.iter().find(|it| it.title == "vehicle.speed.standard_deviation");
    let evppi = 1e3 * expected["evppi"]["Vs"].as_f64().unwrap();
    assert!((speed.unwrap().per_year - evppi).abs() < THREE_ERRORS, "{speed:?}");
}

/// Levels that the model made of a wear coefficient of 3e-9 kg/J, good to 0.01 dB, at two dates: at a third that nobody measured
/// their forecast is what the model made, and the limit that they have there is reached then.
// Long: draws the chains of a calibration.
#[test]
fn a_forecast_finds_the_levels_that_were_made() {
    const BANDS: [&str; 3] = ["158", "126", "100"];
    const DATES: [f64; 3] = [0.0, 2e6, 4e6];
    let levels = |dates: &[f64], rise: &dyn Fn(usize, usize) -> f64| -> String {
        let rows = dates.iter().enumerate().flat_map(|(date, passages)| {
            let bands = BANDS.iter().enumerate();
            bands.map(move |(band, name)| format!("{passages},{name},{},0.01\n", rise(date, band)))
        });
        rows.collect()
    };
    let all = one_value(&levels(&DATES, &|_, _| 0.0), "");
    let all = Plan::read(&all.path().join("plan.toml")).unwrap();
    let rises = all.posterior.predictions(&[3e-9]).unwrap().concat();
    let truth = |date: usize, band: usize| match date {
        0 => -5.0,
        date => -5.0 + rises[(date - 1) * 3 + band],
    };
    let copy = one_value(&levels(&DATES[..2], &truth), "");
    let plan = Plan::read(&copy.path().join("plan.toml")).unwrap();
    let folder = Folder::begin(&plan, &copy.path().join("out"), false).unwrap();
    let chains = folder.run(&|_| {}, &Stop::default()).unwrap().unwrap();
    let limit = (0..3).map(|band| {
        let centre = ThirdOctave::centred(1e-3 * BANDS[band].parse::<f64>().unwrap()).unwrap();
        (centre, truth(2, band))
    });
    let limit = LevelLimit::new(Spectrum::new(limit).unwrap());
    let months = 2e6 / 6000.0 / DAYS_PER_MONTH;
    let found = Forecast::of(&plan, &chains, &limit, 2.0 * months).unwrap();
    assert_eq!(found.passages_now, 2e6);
    for (band, forecast) in found.bands.iter().enumerate() {
        assert!((forecast.level_now_db[2] - truth(1, band)).abs() < 0.05, "{forecast:?}");
        let reached = forecast.months_to_limit.as_ref().unwrap().quantiles;
        let [low, .., high] = reached.map(Option::unwrap);
        // The common error of a date, 0.3 dB, and a second one are in it: 0.4 dB of some 3 dB.
        assert!(low < months && months < high, "{reached:?} {months}");
    }
    let then = Forecast::of(&plan, &chains, &limit, months).unwrap();
    for (band, forecast) in then.bands.iter().enumerate() {
        assert!((forecast.level_then_db[2] - truth(2, band)).abs() < 0.3, "{forecast:?}");
        assert!(forecast.level_then_db[0] < forecast.level_then_db[1]);
    }
    // A limit that is far off is not reached, and one that is passed was reached.
    let far = |by: f64| {
        let bands = limit.spectrum().levels().iter();
        let moved = bands.map(|level| (level.band, level.level + by));
        let limit = LevelLimit::new(Spectrum::new(moved).unwrap());
        Forecast::of(&plan, &chains, &limit, months).unwrap().months_to_limit
    };
    assert_eq!(far(50.0).quantiles, [None; 5]);
    assert_eq!(far(50.0).probability_never, 1.0);
    assert_eq!(far(-50.0).quantiles, [Some(0.0); 5]);
}

/// To measure a value well is worth as much as to know it and no more; an interval beyond the horizon is refused.
#[test]
fn a_measured_value_is_worth_no_more_than_a_known_one() {
    let rows = "0,158,0.0,0.5\n0,126,0.0,0.5\n0,100,0.0,0.5\n\
        2000000,158,2.2,0.5\n2000000,126,2.9,0.5\n2000000,100,1.4,0.5\n";
    let costs = |every: &str| {
        format!(
            "[cost]\ngrinding = \"9000 EUR\"\nover_limit = \"2000 EUR\"\nhorizon = \"25 months\"\n\
             [[action]]\ntitle = \"often\"\ngrind_every = \"{every}\"\n\
             [[measurement]]\nkey = \"wear.coefficient\"\nfactor = 1.0001\nprice = \"100 EUR\"\n"
        )
    };
    let copy = one_value(rows, &costs("12 months"));
    let plan = Plan::read(&copy.path().join("plan.toml")).unwrap();
    let run = Folder::begin(&plan, &copy.path().join("out"), false).unwrap();
    let chains = run.run(&|_| {}, &Stop::default()).unwrap().unwrap();
    let found = Decision::of(&plan, &chains).unwrap();
    let (known, measured) = (&found.evppi_per_year[0], &found.measurements[0]);
    assert!(measured.per_year <= known.per_year, "{known:?} {measured:?}");
    assert!(measured.per_year > 0.0, "{measured:?}");
    let copy = one_value(rows, &costs("48 months"));
    let refused = Plan::read(&copy.path().join("plan.toml")).map(|_| ());
    let refused = refused.unwrap_err().to_string();
    assert!(
        refused.contains(
            "`action[0].grind_every` is \"48 months\", but must be at most as long as cost.horizon, 25 months"
        ),
        "{refused}"
    );
}
