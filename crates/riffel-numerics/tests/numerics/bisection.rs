use riffel_numerics::bisection::{bisection, fallible_bisection};

/// √2 from both sides, to neighbouring numbers, and no farther than asked for.
#[test]
fn a_square_root_lies_between_two_numbers() {
    let mut calls = 0;
    let [low, high] = bisection([1.0, 2.0], 0.0, |x| {
        calls += 1;
        x * x > 2.0
    });
    assert!(low * low <= 2.0 && high * high > 2.0 && high == low.next_up());
    assert_eq!(calls, 52);
    assert_eq!(bisection([2.0, 1.0], 0.0, |x| x * x <= 2.0), [high, low]);
    let [low, high] = bisection([1.0, 2.0], 0.1, |x| x * x > 2.0);
    assert_eq!([low, high], [1.375, 1.4375]);
}

/// Without a number beside it that is near to zero, too.
#[test]
fn zero_is_found() {
    let mut calls = 0;
    let [low, high] = bisection([-1.0, 2.0], 0.0, |x| {
        calls += 1;
        x > 0.0
    });
    assert!(low <= 0.0 && high > 0.0 && high - low < 3e-30 && calls == 100);
}

#[test]
fn an_error_ends_the_search() {
    let mut calls = 0;
    let found = fallible_bisection([0.0, 8.0], 0.0, |x| {
        calls += 1;
        if x < 1.5 { Err(x) } else { Ok(true) }
    });
    assert_eq!((found, calls), (Err(1.0), 3));
}
