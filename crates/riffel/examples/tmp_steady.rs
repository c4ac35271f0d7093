use riffel::contact::*;
use riffel::*;
fn main() {
    let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
    let hertz = HertzContact::new(steel, 0.46, 0.23, 50e3).unwrap();
    let n: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    let half = HalfSpace::new(hertz, 0.4, n).unwrap();
    for c in std::env::args().skip(2) {
        let c: f64 = c.parse().unwrap();
        eprintln!("creepage {c}");
        match half.roll(c) {
            Ok(s) => eprintln!("ok {}", s.tangential_force() / 20e3),
            Err(e) => eprintln!("{e}"),
        }
    }
}
