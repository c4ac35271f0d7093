use super::*;

/// A text column under a head that no list has tells records apart where positions repeat or go back without it; a remark
/// on rows does not.
#[test]
fn words_tell_records_apart_where_positions_go_back() {
    let row = |word: &str, n: i32| format!("{word};{:.3};{}.5\n", 0.001 * f64::from(n), n % 7);
    let one_by_one: String = ["vas", "oikea"].iter().flat_map(|word| (0..200).map(|n| row(word, n))).collect();
    let in_turn: String = (0..200).flat_map(|n| ["vas", "oikea"].map(|word| row(word, n))).collect();
    let remarks: String = (0..400).map(|n| row(if n % 90 > 80 { "hitsi" } else { "ok" }, n)).collect();
    let labels = |rows: &str| format(&format!("kisko;x [m];z [um]\n{rows}")).labels;
    assert_eq!(labels(&one_by_one), [1]);
    assert_eq!(labels(&in_turn), [1]);
    assert_eq!(labels(&remarks), [0; 0]);
}

fn format(text: &str) -> ReaderFormat {
    let table = Table::find(text.as_bytes()).unwrap();
    let layout = Layout::default();
    let format = ProfileTable::new(&table, text.as_bytes(), &layout).format();
    format.unwrap()
}

#[test]
fn units_come_from_the_header_or_the_step() {
    let units = |header: &str, step: &str| {
        let rows: String = (0..20).map(|row| format!("{row}{step};{row}.5\n")).collect();
        let format = format(&(header.to_owned() + &rows));
        let position = format.position.unwrap();
        (position.unit, format.rails[0].unit.clone())
    };
    assert_eq!(units("km;Hoehe (mm)\n", "e-6"), ("km".into(), "mm".into()));
    assert_eq!(units("", "e-6"), ("km".into(), "um".into()));
    assert_eq!(units("", "e-3"), ("m".into(), "um".into()));
    assert_eq!(units("", ""), ("mm".into(), "um".into()));
}

#[test]
fn other_columns_are_left_out() {
    let rows: String = (0..30).map(|n| format!("{n},2014-07-01,{},{}.5\n", 0.001 * f64::from(n), n)).collect();
    let format = format(&format!("index,date,chainage_m,left rail um\n{rows}"));
    assert_eq!(format.position.unwrap().column, 3);
    assert_eq!(format.rails.len(), 1);
    assert_eq!((&format.rails[0].name[..], &format.labels[..]), ("left rail", &[2][..]));
}

/// Other channels of a trolley are no rails, and what is computed of rails is none beside them.
#[test]
fn other_channels_are_no_rails() {
    let rails = |head: &str| {
        let rows: String =
            (0..60).map(|n| format!("{:.3},{}.5,{}.25,{}.5\n", 0.001 * f64::from(n), n % 7, n % 5, n % 3)).collect();
        let format = format(&format!("{head}\n{rows}"));
        let rails: Vec<usize> = format.rails.iter().map(|rail| rail.column).collect();
        rails
    };
    for (head, wanted) in [
        ("x_m,left_um,temp_degC,alt_m", &[2][..]),
        ("x_m,left_um,crosslevel,twist3m", &[2]),
        ("x_m,left_um,right_um,acc_g", &[2, 3]),
        ("x_m,left_um,right_um,mean_um", &[2, 3]),
        ("x_m,left_um,tilt_deg,diff_um", &[2]),
        ("x_m,left mean um,right mean um,humidity_pct", &[2, 3]),
    ] {
        assert_eq!(rails(head), wanted, "{head}");
    }
}

#[test]
fn only_heights_are_rails() {
    let rows: String = (0..300)
        .map(|n| format!("{n},{:.3},{}.5,{}.25,0.1,{}\n", 0.001 * f64::from(n), n % 7, n % 5, n / 150))
        .collect();
    let format = format(&format!(",x_m,left [um],cant [mm],ISO 3095 [um],run\n{rows}"));
    assert_eq!(format.position.unwrap().column, 2);
    let rails: Vec<usize> = format.rails.iter().map(|rail| rail.column).collect();
    assert_eq!((&rails[..], &format.labels[..]), (&[3][..], &[6][..]));
}
