//! Whether errors of levels are what they are taken for.

use std::path::Path;

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use riffel_numerics::random_numbers::normal;

use super::*;
use crate::Plan;
use crate::data::differences;

/// The third set with levels of trains beside the track, as a plan in a folder.
fn plan_with_pass_by(folder: &Path, levels: &str) -> Plan {
    crate::fixtures::copy_set("c-all-together", folder);
    std::fs::write(folder.join("pass-by.csv"), levels).unwrap();
    let plan = folder.join("plan.toml");
    let text = std::fs::read_to_string(&plan).unwrap();
    let pass_by = "\n[[data]]\nkind = \"pass-by\"\nfile = \"pass-by.csv\"\nspeed = \"100 km/h\"\n\
                 common_error = 0.2\nset = { \"track.model\" = \"two-layer\" }\n";
    std::fs::write(&plan, text + pass_by).unwrap();
    Plan::read(&plan).unwrap()
}

/// Trains at both ends of six million passages, whose errors are so small that those of the roughness count.
const HEARD: &str = "passages,level_dba,standard_error_db\n0,80,0.1\n6000000,80,0.1\n";

/// Levels are drawn as they come about: a rail with levels of its own, what is missed of its growth, errors of each band, date and
/// place, and what is heard of the true levels. What is then left of the contrasts has the covariance that it is taken to have.
// Long: draws 600 sets of data, by which its bound is scaled.
#[test]
fn what_is_left_of_levels_scatters_as_it_is_taken_to() {
    const DRAWS: usize = 600;
    const MISSED: f64 = 0.2;
    let folder = tempfile::tempdir().unwrap();
    let plan = plan_with_pass_by(folder.path(), HEARD);
    let posterior = &plan.posterior;
    let medians = posterior.parameters().iter();
    let values: Vec<f64> = medians.map(|it| it.prior.quantile(0.5)).collect();
    let trial = posterior.model.trial(&values);
    let mut blocks = posterior.blocks.iter();
    let levels = blocks.find_map(|named| named.block.as_levels()).unwrap();
    let count = levels.contrasts.len();
    let grown = levels.levels(&trial).unwrap();
    // The true levels at the first date, about those that were measured.
    let first = |band: usize| levels.rows.iter().position(|row| row.is_of(band)).unwrap();
    let mut random = Xoshiro256PlusPlus::seed_from_u64(7);
    let covariance = levels.covariance(&[MISSED, 0.0], 1.0);
    let mut found = Matrix::of(count, |_, _| 0.0);
    for _ in 0..DRAWS {
        let of_bands = levels.bands.len();
        let truth: Vec<f64> = (0..of_bands).map(|band| levels.rows[first(band)].level - grown[first(band)]).collect();
        let drawn: Vec<f64> = (0..of_bands).map(|_| MISSED * normal(&mut random)).collect();
        let missed = levels.missed.as_ref().unwrap().times(&drawn);
        let common: Vec<f64> = (0..10).map(|_| normal(&mut random)).collect();
        let mut measured = levels.measured.clone();
        for (row, own) in levels.rows.iter().zip(&grown) {
            let more = |band: usize| missed[band] * row.passages / UNIT;
            let level = match row.place {
                RowPlace::PassBy(site, pass) => {
                    let PassBys { rows, train, common_error, .. } = &measured.pass_bys[site];
                    let speed = rows[pass].speed;
                    let radiation = trial.radiation(row.view, speed, &rows[pass].audible);
                    // Each band as the trolley finds it at the same date.
                    let same = |(other, _): &(&LevelRow, &f64)| {
                        matches!(other.place, RowPlace::Dated(_)) && other.passages == row.passages
                    };
                    let of_bands = levels.rows.iter().zip(&grown).filter(same);
                    let of_bands = of_bands.map(|(other, grown)| {
                        let band = other.bands[0].0;
                        (levels.bands[band], truth[band] + grown + more(band))
                    });
                    let level = train.level(&radiation.unwrap(), speed, of_bands).unwrap();
                    level + common_error * common[9]
                }
                _ => {
                    let band = row.bands[0].0;
                    let shared = match row.place {
                        RowPlace::Run(run, _) => measured.runs[run].common_error * common[8],
                        _ => {
                            let date = levels.dates().iter().position(|it| *it == row.passages);
                            measured.dated.common_error * common[date.unwrap()]
                        }
                    };
                    truth[band] + own + more(band) + shared
                }
            };
            *measured.level_mut(row.place) = level + row.error * normal(&mut random);
        }
        let drawn = Levels::new(&measured).unwrap();
        let left = differences(&drawn.observed(), &drawn.predict(&trial).unwrap());
        for i in 0..count {
            for j in 0..count {
                found.values[i * count + j] += left[i] * left[j] / DRAWS as f64;
            }
        }
    }
    // Sample covariances of 600 draws scatter by √((c_ii c_jj + c_ij²)/600); the largest of 361 stays below five of these.
    for i in 0..count {
        for j in 0..count {
            let (own, other) = (covariance.at(i, i), covariance.at(j, j));
            let scatter = ((own * other + covariance.at(i, j).powi(2)) / DRAWS as f64).sqrt();
            let error = found.at(i, j) - covariance.at(i, j);
            assert!(error.abs() < 5.0 * scatter, "{i} {j}: {} in place of {}", found.at(i, j), covariance.at(i, j));
        }
    }
}
