//! What is said of data that lie far from what all others say.

use riffel_calibrate::{Observable, Outlying};
use riffel_keys::{Message, fixed, say, significant};

/// A sentence on a datum.
pub(crate) fn in_words(outlying: &Outlying) -> Message {
    let (datum, data) = (datum(outlying), &outlying.data);
    let deviations = fixed(outlying.deviations.abs(), 1);
    match outlying.deviations > 0.0 {
        true => say!(outlying_above, datum, data, deviations),
        false => say!(outlying_below, datum, data, deviations),
    }
}

fn datum(outlying: &Outlying) -> Message {
    let Outlying { at, of, .. } = *outlying;
    let (hertz, millimetres) = (|| significant(at, 4), || significant(1e3 * at, 3));
    let million = |passages: f64| significant(1e-6 * passages, 2);
    let passages = || million(of.unwrap_or(0.0));
    let at_position = |datum: Message| match of {
        Some(position) => say!(at_position, datum, position = significant(position, 3)),
        None => datum,
    };
    match outlying.measured {
        Observable::ReceptanceMPerN => at_position(say!(datum_receptance, at = hertz())),
        Observable::ReceptancePhaseRad => at_position(say!(datum_phase, at = hertz())),
        Observable::DecayRateDbPerM => say!(datum_decay_rate, at = hertz()),
        Observable::LevelRiseDb => {
            say!(datum_level, at = millimetres(), passages = passages())
        }
        Observable::AxleBoxLevelDb => say!(datum_axle_box, at = millimetres()),
        Observable::PassByLevelDb => say!(datum_pass_by, passages = million(at)),
        Observable::WearMPer100Mgt => say!(datum_wear, mgt = significant(at, 3)),
        Observable::WaveGrowthNp => {
            say!(datum_growth, at = millimetres(), passages = passages())
        }
        Observable::WaveDriftRad => {
            say!(datum_drift, at = millimetres(), passages = passages())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_datum_is_named_with_its_place() {
        let of = |measured, at, of, deviations| {
            let outlying = Outlying { data: "d".to_owned(), measured, at, of, deviations };
            in_words(&outlying).to_string()
        };
        let level = of(Observable::LevelRiseDb, 0.158_489, Some(6e6), 5.25);
        assert!(level.starts_with("the level of 158 mm after 6"), "{level}");
        assert!(level.contains("(d) lies 5.2 standard deviations above"), "{level}");
        let blow = of(Observable::ReceptanceMPerN, 80.0, Some(0.3), -3.1);
        assert!(blow.starts_with("|H| at 80") && blow.contains(" Hz, 0.3"), "{blow}");
        assert!(blow.contains("3.1 standard deviations below"), "{blow}");
        let train = of(Observable::PassByLevelDb, 2.5e6, None, 4.0);
        assert!(train.contains("beside the track after 2.5 million"), "{train}");
    }
}
