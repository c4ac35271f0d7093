//! Whether chains tell the same, and how many independent draws theirs are worth.
//!
//! Source: Vehtari, Gelman, Simpson, Carpenter & Bürkner (2021), *Rank-normalization, folding, and localization: an improved R̂*,
//! Bayesian Analysis 16; autocorrelations are summed as by Geyer (1992).

use riffel_numerics::normal_distribution;
use riffel_study::sensitivity::quantile;

/// R̂ of rank-normalised split chains: the larger of that of the draws and that of their distances from the median. NaN where a
/// chain has fewer than four draws or stands still.
pub fn rhat(chains: &[Vec<f64>]) -> f64 {
    let halves = split(chains);
    let middle = quantile(&sorted(chains), 0.5);
    let folded: Vec<Vec<f64>> = halves.iter().map(|chain| chain.iter().map(|x| (x - middle).abs()).collect()).collect();
    let ratio = |chains: &[Vec<f64>]| {
        let Moments { within, overall, .. } = Moments::of(chains);
        (overall / within).sqrt()
    };
    ratio(&rank_normalised(&halves)).max(ratio(&rank_normalised(&folded)))
}

/// Effective draws for the middle of a distribution.
pub fn ess_bulk(chains: &[Vec<f64>]) -> f64 {
    ess(&rank_normalised(&split(chains)))
}

/// Effective draws for its tails: the fewer of those for the quantiles of 5 and 95 %.
pub fn ess_tail(chains: &[Vec<f64>]) -> f64 {
    let all = sorted(chains);
    let of = |share: f64| {
        let at = quantile(&all, share);
        let below: Vec<Vec<f64>> =
            split(chains).iter().map(|chain| chain.iter().map(|x| f64::from(u8::from(*x <= at))).collect()).collect();
        ess(&below)
    };
    of(0.05).min(of(0.95))
}

/// The draws of all chains in order.
pub fn sorted(chains: &[Vec<f64>]) -> Vec<f64> {
    let mut all = chains.concat();
    all.sort_by(f64::total_cmp);
    all
}

/// Each chain in two halves; of an odd number of draws the one in the middle is left out.
fn split(chains: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let halves = chains.iter().flat_map(|chain| {
        let half = chain.len() / 2;
        [chain[..half].to_vec(), chain[chain.len() - half..].to_vec()]
    });
    halves.collect()
}

/// Normal scores of the ranks (r − 3/8)/(S + 1/4), those of equal draws the mean.
fn rank_normalised(chains: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let all = chains.concat();
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|one, other| all[*one].total_cmp(&all[*other]));
    let mut scores = vec![0.0; all.len()];
    let mut begin = 0;
    while begin < order.len() {
        let same = |place: &&usize| all[**place] == all[order[begin]];
        let end = begin + order[begin..].iter().take_while(same).count().max(1);
        let rank = 0.5 * (begin + 1 + end) as f64;
        let share = (rank - 0.375) / (all.len() as f64 + 0.25);
        let score = normal_distribution::quantile(share);
        order[begin..end].iter().for_each(|place| scores[*place] = score);
        begin = end;
    }
    let length = chains.first().map_or(1, Vec::len).max(1);
    scores.chunks(length).map(<[f64]>::to_vec).collect()
}

/// Variances within chains and of all.
struct Moments {
    means: Vec<f64>,
    /// Mean of the variances of the chains.
    within: f64,
    /// Estimate of the variance of the distribution.
    overall: f64,
}

impl Moments {
    fn of(chains: &[Vec<f64>]) -> Self {
        let (count, length) = (chains.len() as f64, chains[0].len() as f64);
        let means: Vec<f64> = chains.iter().map(|chain| chain.iter().sum::<f64>() / length).collect();
        let scatter = |values: &[f64], mean: f64| values.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
        let variances = chains.iter().zip(&means).map(|(chain, mean)| scatter(chain, *mean));
        let within = variances.sum::<f64>() / (count * (length - 1.0));
        let between = scatter(&means, means.iter().sum::<f64>() / count) / (count - 1.0).max(1.0);
        Self { means, within, overall: within * (length - 1.0) / length + between }
    }
}

/// Effective draws of chains of equal length.
fn ess(chains: &[Vec<f64>]) -> f64 {
    let length = chains[0].len();
    let all = (chains.len() * length) as f64;
    let moments = Moments::of(chains);
    if moments.overall <= 0.0 || !moments.overall.is_finite() {
        return f64::NAN;
    }
    let correlation = |lag: usize| {
        let terms = chains.iter().zip(&moments.means).map(|(chain, mean)| {
            let pairs = chain.iter().zip(&chain[lag..]);
            pairs.map(|(x, y)| (x - mean) * (y - mean)).sum::<f64>() / length as f64
        });
        let covariance = terms.sum::<f64>() / chains.len() as f64;
        1.0 - (moments.within - covariance) / moments.overall
    };
    // Sums of pairs, positive and falling.
    let mut sum = 0.0;
    let mut last = f64::INFINITY;
    let mut lone = 0.0;
    let mut lag = 0;
    while lag + 1 < length {
        let pair = match lag {
            0 => 1.0 + correlation(1),
            lag => correlation(lag) + correlation(lag + 1),
        };
        if pair < 0.0 {
            // The autocorrelation before the first that is negative with the next counts once, as in Stan.
            lone = correlation(lag).max(0.0);
            break;
        }
        last = last.min(pair);
        sum += last;
        lag += 2;
    }
    let time = (2.0 * sum - 1.0 + lone).max(1.0 / all.log10());
    all / time
}

#[cfg(test)]
mod tests {
    use riffel_numerics::random_numbers::normal;

    use super::*;
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::SeedableRng;

    /// Chains x ← φx + √(1 − φ²)ε: (1 − φ)/(1 + φ) of their draws count, to the error of an estimate over 40 000 draws.
    #[test]
    fn autoregressive_chains_have_their_number() {
        for phi in [0.0, 0.5, 0.9] {
            let chains: Vec<Vec<f64>> = (0..4)
                .map(|seed| {
                    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
                    let mut x = normal(&mut random);
                    (0..10_000)
                        .map(|_| {
                            x = phi * x + f64::sqrt(1.0 - phi * phi) * normal(&mut random);
                            x
                        })
                        .collect()
                })
                .collect();
            let expected = 40_000.0 * (1.0 - phi) / (1.0 + phi);
            assert!((ess_bulk(&chains) / expected - 1.0).abs() < 0.1, "{}", ess_bulk(&chains));
            assert!(rhat(&chains) < 1.005);
            assert!(ess_tail(&chains) > 0.5 * expected);
            let mut apart = chains.clone();
            apart[2].iter_mut().for_each(|x| *x += 1.0);
            assert!(rhat(&apart) > 1.05);
            // One chain that is wider than the others has the same median.
            let mut wide = chains;
            wide[1].iter_mut().for_each(|x| *x *= 2.0);
            assert!(rhat(&wide) > 1.02);
        }
    }
}
