//! The work that requests ask for: a bounded queue in front of as many workers as the machine has
//! processors.

use riffel_keys::say;
use std::collections::HashMap;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use riffel::cancel::run_while;
use serde::{Deserialize, Serialize};
use tokio::sync::{Notify, Semaphore};

use crate::fault::{Fault, Refusal};

/// Requests that may wait for a worker; one more is turned away.
const MOST_WAITING: usize = 128;

/// Time for one request, waiting included.
const TIME_LIMIT: Duration = Duration::from_secs(60);

/// Most requests that wait for work on files, which takes longer.
const MOST_FILES_WAITING: usize = 8;
const FILE_TIME_LIMIT: Duration = Duration::from_secs(600);

/// Pages whose newest request is remembered.
const MOST_PAGES: usize = 1024;

/// The bounded queue.
#[derive(Clone)]
pub(crate) struct Queue {
    workers: Arc<Semaphore>,
    waiting: Arc<AtomicUsize>,
    most_waiting: usize,
    time_limit: Duration,
    closing: Arc<AtomicBool>,
    newest: Arc<Mutex<HashMap<String, CancelToken>>>,
}

/// How far work is; nothing of nothing where it has not said so.
#[derive(Clone, Copy, Default, Deserialize, Serialize)]
pub(crate) struct Progress {
    pub(crate) done: u64,
    pub(crate) of: u64,
}

/// Whether somebody still waits for a result. Work asks now and then and stops if not; it tells here how far it is.
#[derive(Clone, Default)]
pub(crate) struct CancelToken(Arc<Flags>);

#[derive(Default)]
struct Flags {
    dropped: AtomicBool,
    /// Told when it is dropped, where it still waits for a worker.
    gone: Notify,
    /// Where it waits.
    place: Mutex<Option<Place>>,
    closing: Option<Arc<AtomicBool>>,
    progress: Mutex<Progress>,
    /// Order in which requests came, to forget the oldest.
    number: u64,
}

impl CancelToken {
    /// True while the answer is waited for.
    pub(crate) fn is_wanted(&self) -> bool {
        let closing = self.0.closing.as_ref();
        !self.0.dropped.load(Ordering::Relaxed) && !closing.is_some_and(|closing| closing.load(Ordering::Relaxed))
    }

    /// The work is so far.
    pub(crate) fn tell(&self, progress: Progress) {
        let mut told = self.0.progress.lock().unwrap_or_else(PoisonError::into_inner);
        *told = progress;
    }

    fn drop_it(&self) {
        self.0.dropped.store(true, Ordering::Relaxed);
        self.leave();
        self.0.gone.notify_one();
    }

    /// Wait no longer.
    fn leave(&self) {
        self.0.place.lock().unwrap_or_else(PoisonError::into_inner).take();
    }

    /// The result of work that ran to its end, or the reason why it did not.
    fn or_dropped<T>(&self, result: Result<T, Fault>) -> Result<T, Fault> {
        if self.is_wanted() {
            return result;
        }
        Err(Fault::superseded())
    }
}

/// Tells the work that its request is gone: the browser hung up, or time ran out.
struct Waiting(CancelToken);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.drop_it();
    }
}

/// Counts a request among the waiting.
struct Place(Arc<AtomicUsize>);

impl Drop for Place {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

impl Queue {
    /// A queue in front of a number of workers.
    pub(crate) fn new(workers: usize) -> Self {
        Self::with_limits(workers, MOST_WAITING, TIME_LIMIT)
    }

    /// A queue for work on files, one after the other.
    pub(crate) fn for_files() -> Self {
        Self::with_limits(1, MOST_FILES_WAITING, FILE_TIME_LIMIT)
    }

    pub(crate) fn with_limits(workers: usize, most_waiting: usize, time_limit: Duration) -> Self {
        Self {
            workers: Arc::new(Semaphore::new(workers)),
            waiting: Arc::default(),
            most_waiting,
            time_limit,
            closing: Arc::default(),
            newest: Arc::default(),
        }
    }

    /// End all work that is waiting or under way.
    pub(crate) fn close(&self) {
        self.closing.store(true, Ordering::Relaxed);
    }

    /// How far the work on a subject is; `None` where none is under way.
    pub(crate) fn progress(&self, subject: &str) -> Option<Progress> {
        let newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
        let cancel = newest.get(subject).filter(|cancel| cancel.is_wanted())?;
        let told = cancel.0.progress.lock();
        Some(*told.unwrap_or_else(PoisonError::into_inner))
    }

    /// Do the work when a worker is free. `subject` names what the answer is for, such as the map of one
    /// page: a newer request for the same drops the older one.
    pub(crate) async fn run<T: Send + 'static>(
        &self,
        subject: Option<String>,
        work: impl FnOnce(&CancelToken) -> Result<T, Fault> + Send + 'static,
    ) -> Result<T, Refusal> {
        let cancel = self.register(subject);
        let waiting = Waiting(cancel.clone());
        let outcome = tokio::time::timeout(self.time_limit, self.wait_and_work(cancel, work)).await;
        drop(waiting);
        let outcome = outcome.unwrap_or_else(|_| {
            Err(Fault::busy(say!(the_answer_took_longer_than_s, seconds = self.time_limit.as_secs_f64())))
        });
        Ok(outcome?)
    }

    async fn wait_and_work<T: Send + 'static>(
        &self,
        cancel: CancelToken,
        work: impl FnOnce(&CancelToken) -> Result<T, Fault> + Send + 'static,
    ) -> Result<T, Fault> {
        let place = Place(self.waiting.clone());
        if self.waiting.fetch_add(1, Ordering::Relaxed) >= self.most_waiting {
            return Err(Fault::busy(say!(too_much_is_being_computed_at)));
        }
        *cancel.0.place.lock().unwrap_or_else(PoisonError::into_inner) = Some(place);
        let worker = tokio::select! {
            worker = self.workers.clone().acquire_owned() => worker,
            // Its place is for the newer one.
            () = cancel.0.gone.notified() => return Err(Fault::superseded()),
        };
        cancel.leave();
        let worker = worker.map_err(|_| Fault::busy(say!(the_program_is_ending)))?;
        let task = tokio::task::spawn_blocking(move || {
            // Given back when the work has really ended, not when its request is given up.
            let _worker = worker;
            let waits = cancel.clone();
            let result = run_while(move || waits.is_wanted(), || work(&cancel));
            cancel.or_dropped(result.unwrap_or_else(|| Err(Fault::superseded())))
        });
        task.await.unwrap_or_else(|_| Err(Fault::defect(say!(the_computation_broke_off))))
    }

    /// A request becomes the newest for its subject, and the one before it is dropped.
    fn register(&self, subject: Option<String>) -> CancelToken {
        static NUMBER: AtomicU64 = AtomicU64::new(0);
        let cancel = CancelToken(Arc::new(Flags {
            closing: Some(self.closing.clone()),
            number: NUMBER.fetch_add(1, Ordering::Relaxed),
            ..Flags::default()
        }));
        if let Some(subject) = subject {
            let mut newest = self.newest.lock().unwrap_or_else(PoisonError::into_inner);
            if newest.len() >= MOST_PAGES && !newest.contains_key(&subject) {
                let oldest = newest.iter().min_by_key(|(_, cancel)| cancel.0.number);
                if let Some(oldest) = oldest.map(|(subject, _)| subject.clone()) {
                    newest.remove(&oldest);
                }
            }
            if let Some(older) = newest.insert(subject, cancel.clone()) {
                older.drop_it();
            }
        }
        cancel
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn one_more_than_may_wait_is_turned_away() {
        let queue = Queue::with_limits(1, 2, TIME_LIMIT);
        let (release, held) = std::sync::mpsc::channel::<()>();
        let busy = tokio::spawn({
            let queue = queue.clone();
            async move { queue.run(None, move |_| Ok(held.recv())).await.is_ok() }
        });
        while queue.workers.available_permits() > 0 {
            tokio::task::yield_now().await;
        }
        let wait = || {
            let queue = queue.clone();
            tokio::spawn(async move { queue.run(None, |_| Ok(())).await.is_ok() })
        };
        let (first, second) = (wait(), wait());
        while queue.waiting.load(Ordering::Relaxed) < 2 {
            tokio::task::yield_now().await;
        }
        assert!(queue.run(None, |_| Ok(())).await.is_err());
        release.send(()).unwrap();
        assert!(busy.await.unwrap() && first.await.unwrap() && second.await.unwrap());
        assert_eq!(queue.waiting.load(Ordering::Relaxed), 0);
    }

    #[tokio::test]
    async fn a_newer_question_takes_the_place_of_the_one_that_waits() {
        let queue = Queue::with_limits(0, 1, TIME_LIMIT);
        let ask = || {
            let queue = queue.clone();
            tokio::spawn(async move { queue.run(Some("map of a".to_owned()), |_| Ok(())).await })
        };
        let mut older = ask();
        while queue.waiting.load(Ordering::Relaxed) < 1 {
            tokio::task::yield_now().await;
        }
        for _ in 0..5 {
            let newer = ask();
            let Refusal(fault) = older.await.unwrap().unwrap_err();
            assert!(fault.message().contains("newer"), "{}", fault.message());
            older = newer;
        }
        while queue.waiting.load(Ordering::Relaxed) < 1 {
            tokio::task::yield_now().await;
        }
        assert!(!older.is_finished(), "the newest still waits");
    }

    #[tokio::test]
    async fn work_under_way_tells_how_far_it_is() {
        let queue = Queue::new(1);
        let (release, held) = std::sync::mpsc::channel::<()>();
        let work = move |cancel: &CancelToken| {
            cancel.tell(Progress { done: 3, of: 8 });
            Ok(held.recv())
        };
        let subject = "remedies of a";
        assert!(queue.progress(subject).is_none());
        let busy = tokio::spawn({
            let queue = queue.clone();
            async move { queue.run(Some(subject.to_owned()), work).await.is_ok() }
        });
        let so_far = loop {
            match queue.progress(subject) {
                Some(Progress { done, of }) if of > 0 => break (done, of),
                _ => tokio::task::yield_now().await,
            }
        };
        assert_eq!(so_far, (3, 8));
        assert!(queue.progress("remedies of b").is_none());
        release.send(()).unwrap();
        assert!(busy.await.unwrap());
        assert!(queue.progress(subject).is_none());
    }

    #[tokio::test]
    async fn a_newer_request_drops_the_older_one_of_its_subject() {
        let queue = Queue::with_limits(2, 2, TIME_LIMIT);
        let (begun, began) = std::sync::mpsc::channel::<()>();
        let older = tokio::spawn({
            let queue = queue.clone();
            async move {
                let work = move |cancel: &CancelToken| {
                    begun.send(()).unwrap();
                    while cancel.is_wanted() {
                        std::thread::yield_now();
                    }
                    Ok(())
                };
                queue.run(Some("map of a".to_owned()), work).await.is_ok()
            }
        });
        while began.try_recv().is_err() {
            tokio::task::yield_now().await;
        }
        let other = queue.run(Some("map of b".to_owned()), |_| Ok(())).await;
        assert!(other.is_ok() && !older.is_finished());
        let newer = queue.run(Some("map of a".to_owned()), |_| Ok(())).await;
        assert!(newer.is_ok() && !older.await.unwrap());
    }

    #[tokio::test]
    async fn what_takes_too_long_is_told_so_and_its_worker_comes_back() {
        let queue = Queue::with_limits(1, 2, Duration::from_millis(20));
        let endless = |cancel: &CancelToken| {
            while cancel.is_wanted() {
                std::thread::yield_now();
            }
            Ok(())
        };
        assert!(queue.run(None, endless).await.is_err());
        while queue.workers.available_permits() == 0 {
            tokio::task::yield_now().await;
        }
    }

    #[tokio::test]
    async fn closing_ends_the_work() {
        let queue = Queue::with_limits(1, 2, TIME_LIMIT);
        let endless = {
            let queue = queue.clone();
            move |cancel: &CancelToken| {
                queue.close();
                while cancel.is_wanted() {
                    std::thread::yield_now();
                }
                Ok(())
            }
        };
        assert!(queue.run(None, endless).await.is_err());
    }

    #[tokio::test]
    async fn work_that_panics_is_an_error_of_its_request_alone() {
        let queue = Queue::with_limits(1, 2, TIME_LIMIT);
        let broken = queue.run(None, |_| -> Result<(), Fault> { panic!("on purpose") });
        assert!(broken.await.is_err());
        assert!(queue.run(None, |_| Ok(())).await.is_ok());
    }
}
