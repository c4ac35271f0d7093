//! Why the rows by load of `frequency_response_lateral.csv` are withdrawn: two of three arguments. The third, the slope that
//! similarity asks for, is in `responses_about_lateral_creepage`.

use serde_json::Value;

use crate::sandbox::{Sandbox, number, root};

/// Without Poisson's effect a point that is loaded along the surface gives way along that load alone, the same in every direction:
/// what a contact that creeps across the rail answers to its load is what one that creeps along it does, whatever its ellipse.
/// 1e-6: the solver's.
#[test]
fn without_poissons_effect_the_direction_does_not_matter() {
    let sandbox = Sandbox::new();
    let responses = |direction: &str, force: &str| -> Vec<[f64; 2]> {
        let document = sandbox.json(&format!(
            "contact cases/nominal.toml --set contact.hertz=exact --set contact.response=non-steady --set contact.grid=20 --set \
             steel.poisson_ratio=0 --creepage 0.001 --ratio 3,8,1e6 --json --set 'contact.creepage={{ {direction} = 0.00083 }}'"
        ));
        let response = &document["frequency_response"]["load"];
        let of = |output: &str| -> Vec<[f64; 2]> {
            let values = response[output].as_array().unwrap();
            let parts = |value: &Value| [number(&value[0]), number(&value[1])];
            values.iter().map(parts).collect()
        };
        [of(force), of("dissipation")].concat()
    };
    let along = responses("longitudinal", "longitudinal_force");
    let across = responses("lateral", "lateral_force");
    for (index, (along, across)) in along.iter().zip(&across).enumerate() {
        let size = along[0].hypot(along[1]);
        let off = (along[0] - across[0]).hypot(along[1] - across[1]);
        assert!(size > 0.0 && off < 1e-6 * size, "{index}: {along:?} {across:?}");
    }
}

/// Under a load that oscillates by a share, the leading edge moves by a third of that share of the semi-axis, a ∝ ∛P: the grids of
/// the table, on which it can move by whole elements only, do not follow it.
#[test]
fn the_edge_moves_by_less_than_an_element() {
    let path = root().join("validation/reference/contact/frequency_response_lateral.csv");
    let table = std::fs::read_to_string(path).unwrap();
    let mut rows = 0;
    for row in table.lines().filter(|row| row.starts_with("lateral,P,")) {
        let note = row.rsplit(',').next().unwrap();
        let said = |key: &str| note.split(key).nth(1).unwrap().split(' ').next().unwrap();
        let share: f64 = said("amp=").parse().unwrap();
        for elements in said("N=").split(';') {
            let elements: f64 = elements.parse().unwrap();
            let moved = share / 3.0 / (2.0 / elements);
            assert!((0.2..0.6).contains(&moved), "{row}: {moved}");
        }
        rows += 1;
    }
    assert!(rows > 0);
}
