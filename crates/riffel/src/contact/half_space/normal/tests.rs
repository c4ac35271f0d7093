use super::*;
use crate::contact::{ContactBody, EllipticContact};

fn steel() -> ElasticMaterial {
    ElasticMaterial::new(207e9, 0.3).unwrap()
}

fn hertz(r1: f64, r2: f64, load: f64) -> EllipticContact {
    let body = |l, t| ContactBody { material: steel(), longitudinal_curvature: l, lateral_curvature: t };
    EllipticContact::new([body(1.0 / r1, 0.0), body(0.0, 1.0 / r2)], load).unwrap()
}

#[test]
fn explore() {
    for (r1, r2) in [(0.3, 0.3), (0.46, 0.23), (0.46, 0.03)] {
        let h = hertz(r1, r2, 50e3);
        let (a, b) = (h.semi_axis_longitudinal(), h.semi_axis_lateral());
        for n in [12, 16, 24, 32, 48, 64, 96] {
            let grid = ContactGrid::over(n, n, 1.3 * a, 1.3 * b).unwrap();
            let c = NormalContact::new([steel(); 2], grid, |x, y| x * x / (2.0 * r1) + y * y / (2.0 * r2)).unwrap();
            let s = c.under_load(50e3).unwrap();
            let t = c.at_approach(h.approach()).unwrap();
            println!("{r2} n {n} approach {:+.2e} peak {:+.2e} area {:+.2e} steps {} | load {:+.2e} steps {}",
                s.approach() / h.approach() - 1.0, s.peak_pressure() / h.peak_pressure() - 1.0,
                s.contact_area() / (std::f64::consts::PI * a * b) - 1.0, s.steps(), t.load() / 50e3 - 1.0, t.steps());
        }
    }
}
