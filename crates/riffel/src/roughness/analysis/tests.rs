use super::*;

fn wave(samples: usize, amplitude: impl Fn(usize) -> f64) -> Profile {
    let phase = |i: usize| std::f64::consts::TAU * i as f64 * 1e-3 / 0.055;
    let heights = (0..samples).map(|i| amplitude(i) * phase(i).sin()).collect();
    Profile::new(100.0, 1e-3, heights).unwrap()
}

/// 12 µm from 130.03 m to 150.05 m, whole waves, of a rail of 1 µm: over the limit of 7 µm as long as 68 % of the window
/// of 1 m is corrugated, where the moving RMS is 0.707 × 12 µm × √share; to a wavelength.
#[test]
fn corrugation_is_found_where_it_is() -> Result<(), Error> {
    let profile = wave(100_000, |i| if (30_030..50_050).contains(&i) { 12e-6 } else { 1e-6 });
    let limit = RmsLimit::new(vec![(WavelengthBand::GRINDING[1], 7e-6)], 0.05)?;
    let settings = AnalysisSettings { limit: Some(limit), ..AnalysisSettings::default() };
    let analysis = RailAnalysis::new(vec![profile], &settings, &|| ())?;
    assert_eq!(analysis.bands.len(), 4);
    let band = &analysis.bands[1];
    assert!((band.moving_rms_max / (12e-6 / 2f64.sqrt()) - 1.0).abs() < 0.02);
    // Its sudden ends ring.
    assert!((band.peak_to_peak_max / 24e-6 - 1.0).abs() < 0.12, "{band:?}");
    let [over] = &analysis.over_limit[..] else {
        panic!("{:?}", analysis.over_limit);
    };
    assert!((over.from - 130.21).abs() < 0.06 && (over.to - 149.87).abs() < 0.06, "{over:?}");
    assert!((band.share_over_limit.unwrap() - over.length() / 100.0).abs() < 1e-9);
    // Half a metre on either side of a gap of 2 m: one piece of grinding, of which the gap is no part.
    let mut torn = analysis.clone();
    torn.stretches = vec![(100.0, 130.0), (132.0, 200.0)];
    torn.over_limit = [(129.5, 130.0), (132.0, 132.5)]
        .map(|(from, to)| GrindSection { stretch: 1, from, to, ..over.clone() })
        .to_vec();
    let ground = torn.grind(&GrindSettings::default());
    assert_eq!(ground.len(), 1);
    assert_eq!((ground[0].from, ground[0].to), (120.0, 142.0));
    let measured = torn.measured_within(&ground);
    assert_eq!(measured, [(1, 120.0, 130.0), (1, 132.0, 142.0)]);
    assert_eq!(torn.length(), 98.0);
    assert_eq!(analysis.blocks.len(), 10);
    let highest = |block: usize| analysis.blocks[block].moving_rms_max[1].unwrap();
    assert!((highest(3) / (12e-6 / 2f64.sqrt()) - 1.0).abs() < 0.02);
    assert!(highest(0) < 0.8e-6);
    assert!((analysis.blocks[3].rms[1].unwrap() / (12e-6 / 2f64.sqrt()) - 1.0).abs() < 0.02);
    assert_eq!((analysis.spikes, analysis.pits), (0, 0));
    Ok(())
}

#[test]
fn short_stretches_have_fewer_bands() -> Result<(), Error> {
    let settings = AnalysisSettings::default();
    let analysis = RailAnalysis::new(vec![wave(2500, |_| 3e-6)], &settings, &|| ())?;
    assert_eq!(analysis.bands.len(), 3);
    assert_eq!(analysis.blocks[0].rms[3], None);
    assert_eq!(analysis.bands[0].share_over_limit, None);
    Ok(())
}
