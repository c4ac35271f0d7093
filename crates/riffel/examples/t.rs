use riffel::*;
use std::sync::Arc;
use std::time::Instant;
fn main() {
    let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
    let hertz = HertzContact::new(steel, 0.46, 0.23, 50e3).unwrap();
    let contact = Carter3d::from_tractive_ratio(hertz, 0.4, 0.1).unwrap();
    let rail = EulerBernoulliBeam::new(steel, 2.35e-5, 56.0).unwrap();
    let inertia = RigidInertia::reduced_inertia(350.0, 0.46);
    let mut f = FeedbackLoop {
        track: Arc::new(FreeBeam::new(rail)),
        wheel: Arc::new(RigidMass::new(350.0).unwrap()),
        contact_stiffness: hertz.stiffness(),
        contact: Arc::new(contact),
        rotation: Arc::new(RigidInertia::new(inertia, 0.46).unwrap()),
        rolling_radius: 0.46,
        place_of_wear: PlaceOfWear::new(DissipationPhase::Lag, hertz.semi_axis_longitudinal(), 0.1),
        wear: EnergyWear::new(2.5e-9, 7850.0, hertz.semi_axis_lateral()).unwrap(),
        amplitude: 31.5e-6,
    };
    println!("{:?}", f.at(0.025, 10.0));
    for name in ["free", "moving", "two"] {
        match name {
            "moving" => f.track = Arc::new(MovingBeam::new(rail, 0.0).unwrap()),
            "two" => {
                f.track = Arc::new(
                    TwoLayerTrack::new(
                        rail,
                        Layer::new(80e6 / 0.7, 20e3 / 0.7).unwrap(),
                        110.0 / 0.7,
                        Layer::new(60e6 / 0.7, 30e3 / 0.7).unwrap(),
                    )
                    .unwrap(),
                )
            }
            _ => (),
        };
        for n in [101usize, 1001, 3163] {
            for threads in [1, 2] {
                let pool = rayon::ThreadPoolBuilder::new()
                    .num_threads(threads)
                    .build()
                    .unwrap();
                let mut best = f64::MAX;
                for _ in 0..7 {
                    let t = Instant::now();
                    let m = pool.install(|| {
                        GrowthMap::compute(
                            &f,
                            Axis::new(0.02, 0.08, n).unwrap(),
                            Axis::new(5.0, 60.0, n).unwrap(),
                            |_| (),
                        )
                    });
                    best = best.min(t.elapsed().as_secs_f64());
                    std::hint::black_box(m);
                }
                println!(
                    "{name} {n} threads {threads}: {:.2} ns/pt",
                    best * 1e9 / (n * n) as f64
                );
                if n == 1001 && threads == 1 {
                    let t = Instant::now();
                    let r = Ridge::search(
                        &f,
                        Axis::new(0.02, 0.08, n).unwrap(),
                        Axis::new(5.0, 60.0, n).unwrap(),
                    );
                    println!(
                        "ridge {:.2}ns/pt {:?}",
                        t.elapsed().as_secs_f64() * 1e9 / (n * n) as f64,
                        r.best_fit_frequency()
                    );
                }
            }
        }
    }
}
