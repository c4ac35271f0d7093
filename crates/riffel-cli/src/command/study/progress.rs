//! How far a study is.

use std::io::{IsTerminal, stderr};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::messages::{is_for_a_program, is_quiet, say, tell_progress};

/// Time from one line to the next where there is no terminal, as in the log of a cluster.
const LINE_EVERY: Duration = Duration::from_secs(10);
/// The same where a program reads it.
const TOLD_EVERY: Duration = Duration::from_millis(300);

/// A bar with rate and time left on a terminal; elsewhere a line every ten seconds, but none where results go to the same place.
pub(in crate::command) struct SampleProgress {
    bar: ProgressBar,
    terminal: bool,
    count: Arc<Count>,
    begun: Instant,
    /// Ends the lines when it goes.
    _lines: Option<Sender<()>>,
}

/// How far it is.
struct Count {
    done: AtomicU64,
    total: AtomicU64,
}

impl SampleProgress {
    pub(in crate::command) fn new(what: &'static str, total: u64) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        let template = format!(
            "{{wide_bar}} {{human_pos}} of {{human_len}} {what}  {{per_sec}}  {{eta}} left"
        );
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style);
        }
        let count = Arc::new(Count {
            done: AtomicU64::new(0),
            total: AtomicU64::new(total),
        });
        let terminal = stderr().is_terminal();
        let lines = (!terminal && !is_among_results()).then(|| {
            let (lines, ends) = channel();
            let count = Arc::clone(&count);
            // On a clock of their own: the first of slow samples takes long as well.
            thread::spawn(move || count.tell(what, &ends));
            lines
        });
        Self {
            bar,
            terminal,
            count,
            begun: Instant::now(),
            _lines: lines,
        }
    }

    /// One more.
    pub(super) fn advance(&self) {
        self.advance_by(1);
    }

    /// Some more.
    pub(in crate::command) fn advance_by(&self, more: u64) {
        self.count.done.fetch_add(more, Ordering::Relaxed);
        if self.terminal {
            self.bar.inc(more);
            if self.bar.is_hidden() && !is_quiet() && self.begun.elapsed() > Duration::from_secs(1)
            {
                self.bar.set_draw_target(ProgressDrawTarget::stderr());
            }
        }
    }

    /// There is more to do than was thought.
    pub(in crate::command) fn lengthen(&self, total: u64) {
        self.count.total.store(total, Ordering::Relaxed);
        self.bar.set_length(total);
    }
}

impl Count {
    /// A line now and then until the other end goes.
    fn tell(&self, what: &str, ends: &Receiver<()>) {
        let begun = Instant::now();
        let every = match is_for_a_program() {
            true => TOLD_EVERY,
            false => LINE_EVERY,
        };
        let goes_on = |every| ends.recv_timeout(every) == Err(RecvTimeoutError::Timeout);
        self.tell_while(goes_on, every, |done, total| {
            if !tell_progress(done, total) {
                say(line(what, [done, total], begun.elapsed()));
            }
        });
    }

    /// Tell how far it is each time that it still goes on after a while.
    fn tell_while(
        &self,
        mut goes_on: impl FnMut(Duration) -> bool,
        every: Duration,
        mut tell: impl FnMut(u64, u64),
    ) {
        while goes_on(every) {
            let [done, total] = [&self.done, &self.total].map(|it| it.load(Ordering::Relaxed));
            tell(done, total.max(done));
        }
    }
}

/// How far work is that has taken so long.
fn line(what: &str, [done, total]: [u64; 2], elapsed: Duration) -> String {
    if done == 0 {
        return format!("0 of {total} {what}");
    }
    let rate = done as f64 / elapsed.as_secs_f64();
    let left = duration((total - done) as f64 / rate);
    format!("{done} of {total} {what}, {rate:.1} a second, {left} left")
}

impl Drop for SampleProgress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Whether standard error goes where standard output goes, as after `2>&1`.
#[cfg(unix)]
fn is_among_results() -> bool {
    use std::fs::File;
    use std::os::fd::{AsFd, BorrowedFd};
    use std::os::unix::fs::MetadataExt;
    let place = |stream: BorrowedFd<'_>| {
        let file = File::from(stream.try_clone_to_owned().ok()?);
        file.metadata().ok().map(|there| (there.dev(), there.ino()))
    };
    place(stderr().as_fd()).is_some_and(|there| place(std::io::stdout().as_fd()) == Some(there))
}

/// Whether standard error goes where standard output goes: not told by the system.
#[cfg(not(unix))]
fn is_among_results() -> bool {
    false
}

/// A time in the units that suit it.
pub(in crate::command) fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 10.0 => format!("{s:.1} s"),
        s if s < 120.0 => format!("{s:.0} s"),
        s if s < 7200.0 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s => format!("{:.1} days", s / 86_400.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    /// On a clock that the test turns: a line after each ten seconds until the work ends, the first before anything is done.
    #[test]
    fn a_line_comes_every_ten_seconds() {
        let count = Count {
            done: AtomicU64::new(0),
            total: AtomicU64::new(100),
        };
        let clock = Cell::new(Duration::ZERO);
        let goes_on = |every: Duration| {
            clock.set(clock.get() + every);
            clock.get() < Duration::from_secs(35)
        };
        let mut told = Vec::new();
        count.tell_while(goes_on, LINE_EVERY, |done, total| {
            let seconds = clock.get().as_secs();
            told.push((seconds, line("draws", [done, total], clock.get())));
            count.done.fetch_add(40, Ordering::Relaxed);
        });
        let expected = [
            (10, "0 of 100 draws"),
            (20, "40 of 100 draws, 2.0 a second, 30 s left"),
            (30, "80 of 100 draws, 2.7 a second, 7.5 s left"),
        ];
        assert_eq!(told, expected.map(|(at, line)| (at, line.to_owned())));
    }
}
