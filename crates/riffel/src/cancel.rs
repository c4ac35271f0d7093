//! Long work that is broken off when nobody waits for it any more.
//!
//! Nothing is passed down for this: [`run_while`] does its work on threads that know whether the result is still wanted, and
//! what computes long asks [`check`] at each of its steps, which ends the work where it stands. On any other thread
//! [`check`] does nothing.
//!
//! ```
//! use riffel::cancel::{check, run_while};
//!
//! assert_eq!(run_while(|| true, || { check(); 42 }), Some(42));
//! assert_eq!(run_while(|| false, || { check(); 42 }), None);
//! ```

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;

type CancelToken = Arc<dyn Fn() -> bool + Send + Sync>;

thread_local! {
    static CANCEL_TOKEN: RefCell<Option<CancelToken>> = const { RefCell::new(None) };
}

/// What unwinds from work that is broken off.
struct BrokenOff;

/// Work, for as long as its result is `wanted`, which is asked often and from several threads; `None` where it was broken off.
///
/// The work has a rayon pool of its own, as large as the current one, which takes some 0.1 ms to start. Work that is broken off unwinds
/// like a panic: a lock that it holds at that step is poisoned.
///
/// # Panics
///
/// If the machine refuses threads, or where the work itself panics.
pub fn run_while<T: Send>(
    wanted: impl Fn() -> bool + Send + Sync + 'static,
    work: impl FnOnce() -> T + Send,
) -> Option<T> {
    let wanted: CancelToken = Arc::new(wanted);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(rayon::current_num_threads())
        .start_handler(move |_| CANCEL_TOKEN.set(Some(wanted.clone())))
        .build()
        .expect("threads to work on");
    match catch_unwind(AssertUnwindSafe(|| pool.install(work))) {
        Ok(result) => Some(result),
        Err(reason) if reason.is::<BrokenOff>() => None,
        Err(panic) => resume_unwind(panic),
    }
}

/// A step of long work, which ends here if nobody waits for it any more.
#[inline]
pub fn check() {
    let is_wanted = CANCEL_TOKEN.with_borrow(|wanted| wanted.as_ref().is_none_or(|wanted| wanted()));
    if !is_wanted {
        resume_unwind(Box::new(BrokenOff));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use rayon::prelude::*;

    use super::*;

    #[test]
    fn work_on_all_its_threads_ends_at_the_next_step() {
        static STEPS: AtomicUsize = AtomicUsize::new(0);
        let wanted = || STEPS.load(Ordering::Relaxed) < 100;
        let work = || {
            (0..1_000_000).into_par_iter().for_each(|_| {
                check();
                STEPS.fetch_add(1, Ordering::Relaxed);
            });
        };
        assert_eq!(run_while(wanted, work), None);
        let steps = STEPS.load(Ordering::Relaxed);
        // Each other thread may be in the middle of a step.
        let most = 100 + rayon::current_num_threads();
        assert!((100..most).contains(&steps), "{steps}");
    }

    #[test]
    #[should_panic(expected = "of its own")]
    fn a_panic_of_the_work_stays_one() {
        run_while(|| true, || panic!("of its own"));
    }

    #[test]
    fn elsewhere_it_does_nothing() {
        check();
    }
}
