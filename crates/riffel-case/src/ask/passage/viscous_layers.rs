//! A causal track in the place of one with loss factors.

use std::f64::consts::TAU;

use crate::Case;

/// The case with dashpots in the layers of its track in place of loss factors, and the mean square of the relative difference
/// of its receptance: each takes as much of a cycle as the loss factor does, ηk = ωc, at the frequency ω at which the layer works,
/// the ballast where rail and sleepers move together and the pad where they move against each other. None of a track
/// whose layers have no loss factor.
///
/// A loss factor is not causal: its structure moves before it is struck. Dashpots are, and passive at every frequency, as
/// the nearest causal receptance need not be.
pub(super) fn with_viscous_layers(case: &Case) -> Option<(Case, f64)> {
    let (support, rail_mass) = (case.track.support?, case.track.rail_mass?);
    let cut_on = support.cut_on_frequencies(rail_mass);
    let (lowest, highest) = (*cut_on.first()?, *cut_on.last()?);
    let track = &case.file.track;
    let layers = [("track.pad", track.pad.as_ref(), highest), ("track.ballast", track.ballast.as_ref(), lowest)];
    let mut overrides = Vec::new();
    for (key, layer, w) in layers {
        let Some(layer) = layer else {
            continue;
        };
        let loss = layer.loss_factor.map_or(0.0, |loss| loss.si());
        if loss > 0.0 {
            let own = layer.damping.map_or(0.0, |damping| damping.si());
            let damping = own + loss * layer.stiffness?.si() / w;
            overrides.push(format!("{key}.damping={damping} N s/m"));
            overrides.push(format!("{key}.loss_factor=0"));
        }
    }
    if overrides.is_empty() {
        return None;
    }
    let viscous = case.with(&overrides[..]).ok()?;
    let share = share_off(&viscous, case);
    Some((viscous, share))
}

/// The largest loss factor of a layer of its track \[-\].
pub(super) fn largest_loss_of_layers(case: &Case) -> f64 {
    let track = &case.file.track;
    let layers = [track.pad.as_ref(), track.ballast.as_ref()];
    let losses = layers.into_iter().flatten().filter_map(|layer| layer.loss_factor);
    losses.map(|loss| loss.si()).fold(0.0, f64::max)
}

/// Mean over ln f of |H′/H − 1|², of the receptance of the track beside that of another case.
fn share_off(case: &Case, other: &Case) -> f64 {
    /// Where corrugation is made \[Hz\].
    const BAND: (f64, f64) = (20.0, 3000.0);
    const STEPS: i32 = 200;
    let off = |step: i32| {
        let share = f64::from(step) / f64::from(STEPS);
        let w = TAU * BAND.0 * (BAND.1 / BAND.0).powf(share);
        let [own, other] = [case, other].map(|case| case.track.receptance.receptance(w, case.speed.max()));
        (own / other - 1.0).norm_sqr()
    };
    (0..=STEPS).map(off).sum::<f64>() / f64::from(STEPS + 1)
}
