//! Chains on data that were simulated from draws of the priors: the values that the data were made of lie anywhere among the draws.
//!
//! Source: Talts, Betancourt, Simpson, Vehtari & Gelman (2018), arXiv 1804.06788; ranks of the ln likelihood too, as by Modrák et al.
//! (2023), Bayesian Analysis 20.

use rayon::prelude::*;
use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::chain::{Chain, random};
use crate::conjugate::U1;
use crate::nuts::uniform;
use crate::posterior::{Named, Posterior};

/// Draws that a value is ranked among.
const DRAWS: usize = 99;
const WARMUP: u64 = 200;
/// Bins of the ranks.
const BINS: usize = 20;

/// Ranks of each value and of the ln likelihood among thinned draws, by replicate; `with_data` makes a posterior of data.
fn ranks(
    posterior: &Posterior,
    replicates: u64,
    thin: usize,
    with_data: &(dyn Fn(&[f64]) -> Posterior + Sync),
) -> Vec<Vec<usize>> {
    let replicate = |index: u64| {
        let mut random = random(17, index, 0);
        let named = &posterior.blocks[0];
        // Values that the case takes.
        let (values, data) = (0..1000)
            .find_map(|_| {
                let parameters = posterior.parameters().iter();
                let values = parameters.map(|it| it.prior.quantile(uniform(&mut random)));
                let values: Vec<f64> = values.collect();
                let predicted = named.block.predict(&posterior.model.trial(&values)).ok()?;
                let sizes = named.sizes(&values);
                let data = named.block.replicate(&predicted, &sizes, &mut random)?;
                Some((values, data))
            })
            .unwrap();
        let posterior = with_data(&data);
        let likelihood = |values: &[f64]| posterior.log_likelihood(values).unwrap()[0].1;
        let mut chain = Chain::begin(&posterior, 23, index, WARMUP).unwrap();
        (0..WARMUP).for_each(|_| drop(chain.draw(&posterior)));
        let truth = [&values[..], &[likelihood(&values)]].concat();
        let mut below = vec![0; truth.len()];
        for _ in 0..DRAWS {
            (1..thin).for_each(|_| drop(chain.draw(&posterior)));
            let drawn = posterior.values(&chain.draw(&posterior).place);
            let drawn = [&drawn[..], &[likelihood(&drawn)]].concat();
            for (below, (drawn, truth)) in below.iter_mut().zip(drawn.iter().zip(&truth)) {
                *below += usize::from(drawn < truth);
            }
        }
        below
    };
    (0..replicates).into_par_iter().map(replicate).collect()
}

/// Ranks are uniform: χ² of 20 bins with p above 0.001 over all values, and intervals of the values hold the truth as often as they
/// say, within `error` of the share; ranks of the ln likelihood are no interval of anything.
fn check(names: &[String], ranks: &[Vec<usize>], error: f64) {
    let count = ranks.len() as f64;
    let expected = count / BINS as f64;
    let distribution = ChiSquared::new(BINS as f64 - 1.0).unwrap();
    for (place, name) in names.iter().enumerate() {
        let mut bins = [0.0; BINS];
        for ranks in ranks {
            bins[ranks[place] * BINS / (DRAWS + 1)] += 1.0;
        }
        let square: f64 = bins
            .iter()
            .map(|it| (it - expected).powi(2) / expected)
            .sum();
        let p = 1.0 - distribution.cdf(square);
        let inside = |share: f64| {
            let side = 0.5 * (1.0 - share) * (DRAWS + 1) as f64;
            let ends = side - 0.5..(DRAWS + 1) as f64 - side - 0.5;
            let is_inside = |ranks: &&Vec<usize>| ends.contains(&(ranks[place] as f64));
            ranks.iter().filter(is_inside).count() as f64 / count
        };
        let shares = [0.5, 0.8, 0.9].map(inside);
        eprintln!("{name}: p = {p:.3}, inside 50, 80, 90 %: {shares:.3?}");
        assert!(p > 0.001 / names.len() as f64, "{name}: {bins:?}");
        if place + 1 == names.len() {
            continue;
        }
        assert!(
            (shares[1] - 0.8).abs() <= 1.25 * error,
            "{name}: {shares:?}"
        );
        assert!((shares[2] - 0.9).abs() <= error, "{name}: {shares:?}");
    }
}

fn names(posterior: &Posterior) -> Vec<String> {
    let names = posterior.parameters().iter().map(|it| it.name.clone());
    names.chain(["ln likelihood".to_owned()]).collect()
}

/// U1, 200 times: 90 % intervals hold the truth in 90 ± 4 %, 80 % ones in 80 ± 5 %.
#[test]
#[ignore = "a minute without optimisation"]
fn the_truth_lies_anywhere_among_draws_of_linear_levels() {
    let u1 = U1::read();
    let posterior = u1.posterior(&[0, 1, 2]);
    let ranks = ranks(&posterior, 200, 5, &|data| u1.posterior_with(data));
    check(&names(&posterior), &ranks, 0.04);
}

/// Set b, 200 times: intervals of 90 % hold the truth within 6.4 %, those of 80 % within 8 %, three standard deviations of so many.
#[test]
#[ignore = "minutes"]
fn the_truth_lies_anywhere_among_draws_of_three_dates() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let plan = root.join("../../validation/calibration/b-three-dates/plan.toml");
    let posterior = crate::Plan::read(&plan).unwrap().posterior;
    let named = &posterior.blocks[0];
    let with_data = |data: &[f64]| Posterior {
        model: posterior.model.clone(),
        blocks: vec![Named {
            names: named.names.clone(),
            block: Box::new(named.block.as_levels().unwrap().with_data(data)),
            sizes: named.sizes.clone(),
            touched_by: named.touched_by.clone(),
        }],
    };
    let ranks = ranks(&posterior, 200, 4, &with_data);
    check(&names(&posterior), &ranks, 0.064);
}
