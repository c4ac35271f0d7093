//! How far a study is.

use std::io::{IsTerminal, stderr};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::messages::{is_for_a_program, is_quiet, say, tell_progress};

/// Time from one line to the next where there is no terminal, as in the log of a cluster.
const LINE_EVERY: Duration = Duration::from_secs(60);
/// The same where a program reads it.
const TOLD_EVERY: Duration = Duration::from_millis(300);

/// A bar with rate and time left on a terminal; elsewhere a line a minute, but none where results go to the same place.
pub(in crate::command) struct SampleProgress {
    /// What is counted, as in "samples".
    what: &'static str,
    bar: ProgressBar,
    terminal: bool,
    lines: bool,
    line_every: Duration,
    total: u64,
    done: AtomicU64,
    begun: Instant,
    last_line: Mutex<Instant>,
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
        Self {
            what,
            bar,
            terminal: stderr().is_terminal(),
            lines: !is_among_results(),
            line_every: if is_for_a_program() {
                TOLD_EVERY
            } else {
                LINE_EVERY
            },
            total,
            done: AtomicU64::new(0),
            begun: Instant::now(),
            last_line: Mutex::new(Instant::now()),
        }
    }

    /// One more.
    pub(super) fn advance(&self) {
        self.advance_by(1);
    }

    /// Some more.
    pub(in crate::command) fn advance_by(&self, more: u64) {
        let done = self.done.fetch_add(more, Ordering::Relaxed) + more;
        if self.terminal {
            self.bar.inc(more);
            if self.bar.is_hidden() && !is_quiet() && self.begun.elapsed() > Duration::from_secs(1)
            {
                self.bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            return;
        }
        // A thread that finds the clock taken leaves the line to the one that has it.
        if self.lines
            && let Ok(mut last) = self.last_line.try_lock()
            && last.elapsed() > self.line_every
        {
            *last = Instant::now();
            if tell_progress(done, self.total) {
                return;
            }
            let rate = done as f64 / self.begun.elapsed().as_secs_f64();
            let left = duration((self.total - done) as f64 / rate);
            say(format_args!(
                "{done} of {} {}, {rate:.1} a second, {left} left",
                self.total, self.what
            ));
        }
    }
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
