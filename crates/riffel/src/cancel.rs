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
use std::sync::{Arc, Mutex, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

type CancelToken = Arc<dyn Fn() -> bool + Send + Sync>;

thread_local! {
    static CANCEL_TOKEN: RefCell<Option<CancelToken>> = const { RefCell::new(None) };
}

/// What unwinds from work that is broken off.
struct BrokenOff;

/// Work, for as long as its result is `wanted`, which is asked often and from several threads; `None` where it was broken off.
///
/// The work has a rayon pool of its own, as large as the current one; pools are kept for the next work. Work that is broken off unwinds
/// like a panic: a lock that it holds at that step is poisoned.
///
/// # Panics
///
/// If the machine refuses threads, or where the work itself panics.
pub fn run_while<T: Send>(
    wanted: impl Fn() -> bool + Send + Sync + 'static,
    work: impl FnOnce() -> T + Send,
) -> Option<T> {
    let threads = Threads::that_ask(Arc::new(wanted));
    unless_broken_off(|| threads.pool().install(work))
}

/// Work as in [`run_while`], beside which this thread does something else, whose result is returned when both have ended.
///
/// # Panics
///
/// If the machine refuses threads, or where the work itself panics.
pub fn run_beside<T>(
    wanted: impl Fn() -> bool + Send + Sync + 'static,
    work: impl FnOnce() + Send,
    meanwhile: impl FnOnce() -> T,
) -> T {
    let threads = Threads::that_ask(Arc::new(wanted));
    threads.pool().in_place_scope(|scope| {
        scope.spawn(|_| _ = unless_broken_off(work));
        meanwhile()
    })
}

/// The result of work; `None` where it was broken off.
fn unless_broken_off<T>(work: impl FnOnce() -> T) -> Option<T> {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(result) => Some(result),
        Err(reason) if reason.is::<BrokenOff>() => None,
        Err(panic) => resume_unwind(panic),
    }
}

/// Pools that are not at work: to start one takes longer than to compute a small map.
static IDLE: Mutex<Vec<ThreadPool>> = Mutex::new(Vec::new());

/// Threads that know whether their work is wanted.
struct Threads(Option<ThreadPool>);

impl Threads {
    /// Number of threads is that of the current pool.
    fn that_ask(wanted: CancelToken) -> Self {
        let count = rayon::current_num_threads();
        let kept = {
            let mut idle = IDLE.lock().unwrap_or_else(PoisonError::into_inner);
            let place = idle.iter().position(|pool| pool.current_num_threads() == count);
            place.map(|place| idle.swap_remove(place))
        };
        let start = || ThreadPoolBuilder::new().num_threads(count).build().expect("threads to work on");
        let pool = kept.unwrap_or_else(start);
        pool.broadcast(|_| CANCEL_TOKEN.set(Some(wanted.clone())));
        Self(Some(pool))
    }

    fn pool(&self) -> &ThreadPool {
        self.0.as_ref().expect("a pool until the end")
    }
}

impl Drop for Threads {
    fn drop(&mut self) {
        if let Some(pool) = self.0.take() {
            pool.spawn_broadcast(|_| CANCEL_TOKEN.set(None));
            IDLE.lock().unwrap_or_else(PoisonError::into_inner).push(pool);
        }
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

    /// The pool of work that was broken off works on when it is wanted again.
    #[test]
    fn a_kept_pool_asks_anew() {
        for wanted in [true, false, true] {
            let work = || {
                check();
                rayon::current_num_threads()
            };
            assert_eq!(run_while(move || wanted, work), wanted.then(rayon::current_num_threads));
        }
    }

    #[test]
    fn beside_work_this_thread_does_something_else() {
        let done = AtomicUsize::new(0);
        let work = || _ = done.fetch_add(1, Ordering::Relaxed);
        assert_eq!(run_beside(|| true, work, || 7), 7);
        assert_eq!(done.load(Ordering::Relaxed), 1);
        let broken_off = || {
            check();
            done.fetch_add(1, Ordering::Relaxed);
        };
        run_beside(|| false, broken_off, || ());
        assert_eq!(done.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn elsewhere_it_does_nothing() {
        check();
    }
}
