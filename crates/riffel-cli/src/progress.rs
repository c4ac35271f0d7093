//! How far the work is.

use std::io::{IsTerminal, stderr};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use riffel_keys::{Message, fixed, number};

use crate::messages::Voice;

/// Time from one line to the next where there is no terminal, as in the log of a cluster.
const LINE_EVERY: Duration = Duration::from_secs(10);
/// Time from one line to the next if a program reads them.
const TOLD_EVERY: Duration = Duration::from_millis(300);

/// A bar on a terminal once the work has taken a second; elsewhere a line every ten seconds, but none into a pipe that has
/// the results too.
pub(crate) struct Progress {
    bar: ProgressBar,
    count: Arc<Count>,
    /// Ends the lines when it goes.
    _lines: Option<Sender<()>>,
}

/// How far it is.
struct Count {
    what: Message,
    /// Whether what is done is counted in words, as draws are, and not in shares.
    is_in_words: bool,
    done: AtomicU64,
    total: AtomicU64,
}

impl Progress {
    /// Of work that is so long in some unit, of which its share is shown.
    pub(crate) fn new(voice: Voice, what: Message, length: usize) -> Self {
        let template = "{msg} {wide_bar} {percent:>3} %  {elapsed}";
        Self::shown(voice, what, length as u64, false, template)
    }

    /// Of so many draws, samples or the like, with their rate and the time that is left.
    pub(crate) fn counting(voice: Voice, what: Message, total: u64) -> Self {
        let template = "{wide_bar} {human_pos}/{human_len} {msg}  {per_sec}  {eta}";
        Self::shown(voice, what, total, true, template)
    }

    fn shown(voice: Voice, what: Message, total: u64, is_in_words: bool, template: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.set_message(what.text(voice.language));
        let count = Arc::new(Count { what, is_in_words, done: AtomicU64::new(0), total: AtomicU64::new(total) });
        let is_terminal = stderr().is_terminal();
        // On a clock of their own: work in one long step never advances.
        if is_terminal {
            let waiting = bar.clone();
            thread::spawn(move || {
                thread::sleep(Duration::from_secs(1));
                if !waiting.is_finished() && !voice.is_quiet() {
                    waiting.set_draw_target(ProgressDrawTarget::stderr());
                    waiting.enable_steady_tick(Duration::from_secs(1));
                }
            });
        }
        let lines = (!is_terminal && !voice.is_quiet() && !is_among_results()).then(|| {
            let (lines, ends) = channel();
            let count = Arc::clone(&count);
            thread::spawn(move || count.tell(voice, &ends));
            lines
        });
        Self { bar, count, _lines: lines }
    }

    /// Some more is done.
    pub(crate) fn advance(&self, by: usize) {
        self.count.done.fetch_add(by as u64, Ordering::Relaxed);
        self.bar.inc(by as u64);
    }

    /// There is more to do than was thought.
    pub(crate) fn lengthen(&self, total: u64) {
        self.count.total.store(total, Ordering::Relaxed);
        self.bar.set_length(total);
    }
}

impl Count {
    /// A line now and then until the other end goes.
    fn tell(&self, voice: Voice, ends: &Receiver<()>) {
        let begun = Instant::now();
        let every = match voice.is_for_a_program() {
            true => TOLD_EVERY,
            false => LINE_EVERY,
        };
        let goes_on = |every| ends.recv_timeout(every) == Err(RecvTimeoutError::Timeout);
        self.tell_while(goes_on, every, |done, total| {
            if !voice.tell_progress(done, total) {
                voice.say(self.line([done, total], begun.elapsed()));
            }
        });
    }

    /// Tell how far it is each time that it still goes on after a while.
    fn tell_while(&self, mut goes_on: impl FnMut(Duration) -> bool, every: Duration, mut tell: impl FnMut(u64, u64)) {
        while goes_on(every) {
            let [done, total] = [&self.done, &self.total].map(|it| it.load(Ordering::Relaxed));
            tell(done, total.max(done));
        }
    }

    /// How far work is that has taken so long.
    fn line(&self, [done, total]: [u64; 2], elapsed: Duration) -> Message {
        let rate = done as f64 / elapsed.as_secs_f64();
        let left = || duration((total - done) as f64 / rate);
        let what = &self.what;
        match (self.is_in_words, done) {
            (true, 0) => riffel_keys::say!(nothing_done, total = number(total), what),
            (true, _) => riffel_keys::say!(
                so_many_done,
                done = number(done),
                total = number(total),
                what,
                rate = fixed(rate, 1),
                left = left()
            ),
            (false, 0) => riffel_keys::say!(share_done, what, percent = number(0)),
            (false, _) => riffel_keys::say!(
                share_done_and_left,
                what,
                percent = fixed(100.0 * done as f64 / total as f64, 0),
                left = left()
            ),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Whether standard error goes into the pipe into which standard output goes, where somebody reads both as one; a file that has both, as
/// after `> log 2>&1`, is a log.
#[cfg(unix)]
fn is_among_results() -> bool {
    use std::fs::File;
    use std::os::fd::{AsFd, BorrowedFd};
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let pipe = |stream: BorrowedFd<'_>| {
        let file = File::from(stream.try_clone_to_owned().ok()?);
        let there = file.metadata().ok()?;
        there.file_type().is_fifo().then(|| (there.dev(), there.ino()))
    };
    pipe(stderr().as_fd()).is_some_and(|there| pipe(std::io::stdout().as_fd()) == Some(there))
}

/// Whether standard error goes where standard output goes: not told by the system.
#[cfg(not(unix))]
fn is_among_results() -> bool {
    false
}

/// A time in the units that suit it.
pub(crate) fn duration(seconds: f64) -> Message {
    match seconds {
        s if s < 120.0 => {
            let digits = usize::from(s < 10.0);
            riffel_keys::say!(so_many_seconds, time = fixed(s, digits))
        }
        s if s < 7200.0 => riffel_keys::say!(so_many_minutes, time = fixed(s / 60.0, 0)),
        s if s < 172_800.0 => riffel_keys::say!(so_many_hours, time = fixed(s / 3600.0, 1)),
        s => riffel_keys::say!(so_many_days, time = fixed(s / 86_400.0, 1)),
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use riffel_keys::Language;

    use super::*;

    fn count(is_in_words: bool) -> Count {
        Count {
            what: match is_in_words {
                true => riffel_keys::say!(progress_draws),
                false => riffel_keys::say!(progress_listening),
            },
            is_in_words,
            done: AtomicU64::new(0),
            total: AtomicU64::new(100),
        }
    }

    /// On a clock that the test turns: a line after each ten seconds until the work ends, the first before anything is done.
    fn told(is_in_words: bool, language: Language) -> Vec<(u64, String)> {
        let count = count(is_in_words);
        let clock = Cell::new(Duration::ZERO);
        let goes_on = |every: Duration| {
            clock.set(clock.get() + every);
            clock.get() < Duration::from_secs(35)
        };
        let mut told = Vec::new();
        count.tell_while(goes_on, LINE_EVERY, |done, total| {
            let seconds = clock.get().as_secs();
            let line = count.line([done, total], clock.get());
            told.push((seconds, line.text(language)));
            count.done.fetch_add(40, Ordering::Relaxed);
        });
        told
    }

    #[test]
    fn a_line_comes_every_ten_seconds() {
        let at = |lines: [&str; 3]| [10, 20, 30].into_iter().zip(lines.map(str::to_owned));
        let expected = at([
            "0 of 100 draws",
            "40 of 100 draws, 2.0 a second, 30 s left",
            "80 of 100 draws, 2.7 a second, 7.5 s left",
        ]);
        assert_eq!(told(true, Language::English), expected.collect::<Vec<_>>());
        let expected = at(["listening: 0 %", "listening: 40 %, 30 s left", "listening: 80 %, 7.5 s left"]);
        assert_eq!(told(false, Language::English), expected.collect::<Vec<_>>());
        let expected = at(["Abhören: 0 %", "Abhören: 40 %, noch 30 s", "Abhören: 80 %, noch 7,5 s"]);
        assert_eq!(told(false, Language::German), expected.collect::<Vec<_>>());
    }
}
