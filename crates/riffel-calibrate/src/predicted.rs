//! What was measured beside what might have been measured, over the posterior.

use rayon::prelude::*;
use riffel_study::sensitivity::quantile;
use serde::Serialize;

use crate::chains::Chains;
use crate::data::{Observable, Place};
use crate::draw::{Draw, random};
use crate::plan::Plan;
use crate::posterior::Named;

/// The random numbers of replicas are those of no chain and of no rail.
const STREAM: u64 = u64::MAX - 1;
/// Draws by which data are predicted: a quantile of 5 % is known to a sixth of a standard deviation.
const MOST: usize = 200;

/// Data of one quantity at one position or after the same passages, with what the posterior says of them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Predicted {
    /// The name of the data.
    pub data: String,
    /// What was measured.
    pub measured: Observable,
    /// Position \[m\] or passages, where there are any.
    pub of: Option<f64>,
    /// Frequencies \[Hz\], wavelengths \[m\], or of wear million gross tonnes.
    pub at: Vec<f64>,
    /// Values that were measured.
    pub observed: Vec<f64>,
    /// Below which 5, 50 and 95 % of what might have been measured lie, with errors and with what the model misses.
    pub quantiles: Vec<[f64; 3]>,
}

/// ln likelihood of each datum given all others of its data, and data as they might have been measured, by draw and block.
pub(crate) fn replicas(plan: &Plan, draws: &[&Draw]) -> Vec<Vec<[Vec<f64>; 2]>> {
    let posterior = &plan.posterior;
    let drawn = draws.par_iter().enumerate().map(|(index, draw)| {
        let values = posterior.values(&draw.place);
        let trial = posterior.model.trial(&values);
        let mut random = random(plan.file.sampler.seed, STREAM, index as u64);
        let of_block = |named: &Named| {
            let sizes = named.sizes(&values);
            let predicted = named.block.predict(&trial).ok()?;
            let likelihood = named.block.of_each(&predicted, &sizes)?;
            let replica = named.block.replicate(&predicted, &sizes, &mut random)?;
            Some([likelihood, replica])
        };
        let blocks = posterior.blocks.iter().map(of_block);
        // A draw that was kept has a density.
        let nothing = || [Vec::new(), Vec::new()];
        blocks.map(|block| block.unwrap_or_else(nothing)).collect()
    });
    drawn.collect()
}

impl Chains {
    /// All data with what the posterior says of them.
    pub fn predicted(&self, plan: &Plan) -> Vec<Predicted> {
        let drawn = replicas(plan, &self.evenly(MOST));
        let mut groups: Vec<Predicted> = Vec::new();
        for (block, named) in plan.posterior.blocks.iter().enumerate() {
            let observed = named.block.observed();
            for (datum, place) in named.block.places().into_iter().enumerate() {
                let told = |compared: f64| place.measured.told(compared);
                let replicas = drawn.iter().filter_map(|draw| draw[block][1].get(datum));
                let mut replicas: Vec<f64> = replicas.map(|compared| told(*compared)).collect();
                replicas.sort_by(f64::total_cmp);
                let group = group(&mut groups, &named.names, place);
                group.at.push(place.at);
                group.observed.push(told(observed[datum]));
                group.quantiles.push([0.05, 0.5, 0.95].map(|share| quantile(&replicas, share)));
            }
        }
        groups
    }
}

/// The group of a datum, begun where it is the first of it.
fn group<'a>(groups: &'a mut Vec<Predicted>, names: &[String], place: Place) -> &'a mut Predicted {
    let data = names.join(" + ");
    let is_own = |it: &Predicted| it.data == data && it.measured == place.measured && it.of == place.of;
    let own = groups.iter().position(is_own).unwrap_or_else(|| {
        groups.push(Predicted {
            data,
            measured: place.measured,
            of: place.of,
            at: Vec::new(),
            observed: Vec::new(),
            quantiles: Vec::new(),
        });
        groups.len() - 1
    });
    &mut groups[own]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every datum of every kind stands at its place as it was measured. Draws of the priors, which hold the truth, predict data
    /// widely: of 94 data and 8 of a run a band of 90 % holds all but a tenth.
    #[test]
    fn data_stand_at_their_places_within_what_priors_predict() {
        let plan = crate::fixtures::folder("c-all-together").join("plan.toml");
        let plan = Plan::read(&plan).unwrap();
        let draw = |index: u64| {
            let values = plan.posterior.drawn_from_priors(&mut random(5, 0, index));
            Draw {
                place: plan.posterior.place(&values),
                log_density: 0.0,
                statistics: crate::nuts::Statistics::default(),
                step: 1.0,
            }
        };
        let chains = Chains { draws: vec![(0..40).map(draw).collect()], log_evidences: Vec::new() };
        let groups = chains.predicted(&plan);
        let of = |measured: Observable| {
            let own = groups.iter().filter(move |group| group.measured == measured);
            own.collect::<Vec<&Predicted>>()
        };
        // The first line of hammer.csv, to the eight digits that it has.
        let modulus = of(Observable::ReceptanceMPerN)[0];
        let measured = f64::hypot(5.4545857e-9, 5.8177714e-9);
        assert!((modulus.at[0] / 80.0 - 1.0).abs() < 1e-12 && modulus.of == Some(0.3));
        assert!((modulus.observed[0] / measured - 1.0).abs() < 1e-7);
        let phase = of(Observable::ReceptancePhaseRad)[0];
        assert!((phase.observed[0] - f64::atan2(-5.8177714, 5.4545857)).abs() < 1e-7);
        let decay = of(Observable::DecayRateDbPerM)[0];
        assert!((decay.at[0] - 100.0).abs() < 1e-9 && (decay.observed[0] - 7.770_215_9).abs() < 1e-7);
        let dates = of(Observable::LevelRiseDb);
        assert!(dates.len() == 2 && dates.iter().all(|date| date.at.len() == 8));
        assert_eq!(of(Observable::AxleBoxLevelDb).len(), 1);
        let (mut inside, mut count) = (0, 0);
        for group in &groups {
            assert_eq!(group.at.len(), group.quantiles.len());
            for (observed, [low, middle, high]) in group.observed.iter().zip(&group.quantiles) {
                assert!(low <= middle && middle <= high);
                inside += usize::from((*low..=*high).contains(observed));
                count += 1;
            }
        }
        assert!(10 * inside >= 9 * count, "{inside} of {count}");
    }
}
