//! Cases with the values of draws.

use riffel::roughness::ThirdOctave;
use riffel_case::Variant;
use riffel_case::traffic::bands_of;

use crate::{json, plan, values};

/// The level of each band rises under the traffic of a case with the values of a draw as the plan predicts it: traffic takes its
/// mean over speeds otherwise, to 0.3 % of the largest rise.
#[test]
fn a_case_of_a_draw_grows_as_its_plan_predicts() {
    let set = "b-three-dates";
    let plan = plan(set);
    let points = json(set, "likelihood_points.json");
    for point in points["points"].as_array().unwrap() {
        let values = values(&plan, &point["values"]);
        let drawn = plan.with_values(&values).unwrap();
        let bands = bands_of(&drawn.case);
        let traffic = drawn.traffic.unwrap();
        let on = traffic.on(&drawn.case, &bands, &Variant::none(""), &|_| ());
        let growth = on.unwrap().growth;
        let lines: Vec<(f64, f64)> = (growth.wavelengths().into_iter()).zip(growth.rates().iter().copied()).collect();
        let rise = |band: &ThirdOctave, passages: f64| {
            let (shortest, longest) = band.wavelength_range();
            let inside = lines.iter().filter(|(line, _)| (shortest..longest).contains(line));
            let energies: Vec<f64> = inside.map(|(_, rate)| (2.0 * rate * passages).exp()).collect();
            assert_eq!(energies.len(), 16);
            10.0 * (energies.iter().sum::<f64>() / 16.0).log10()
        };
        // Dates of the levels after the first; longer waves first.
        let expected = [1.5e6, 3.5e6].map(|passages| {
            let bands = bands.iter().rev();
            bands.map(|band| rise(band, passages)).collect::<Vec<f64>>()
        });
        let (expected, predicted) = (expected.concat(), plan.posterior.predictions(&values).unwrap().concat());
        assert_eq!(predicted.len(), expected.len());
        let largest = predicted.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        assert!(largest > 0.1);
        for (expected, predicted) in expected.iter().zip(&predicted) {
            let error = (expected - predicted).abs();
            assert!(error < 3e-3 * largest, "{expected} {predicted}");
        }
    }
}
