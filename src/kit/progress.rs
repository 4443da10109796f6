//! Progress on stderr, and the polite way to be stopped.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// A bar with rate and time left on a terminal; elsewhere a plain line every few seconds.
pub struct Progress {
    bar: Option<ProgressBar>,
    name: String,
    started: Instant,
    /// Second in which the last plain line was printed.
    last_line: AtomicU64,
    quiet: bool,
}

/// Steps of the bar: finer than any terminal is wide.
const STEPS: u64 = 10_000;
/// Seconds between plain lines.
const LINE_EVERY: u64 = 5;

/// Does anybody want to see progress?
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verbosity {
    Normal,
    Quiet,
}

impl Progress {
    /// Starts to count from 0 to 1.
    pub fn start(name: &str, verbosity: Verbosity) -> Self {
        let quiet = verbosity == Verbosity::Quiet;
        let dumb = std::env::var_os("TERM").is_some_and(|t| t == "dumb");
        let terminal = std::io::stderr().is_terminal() && !dumb;
        let bar = (terminal && !quiet).then(|| {
            let bar = ProgressBar::with_draw_target(Some(STEPS), ProgressDrawTarget::stderr());
            if let Ok(style) =
                ProgressStyle::with_template("{msg} {wide_bar} {percent}% {elapsed} left {eta}")
            {
                bar.set_style(style);
            }
            bar.set_message(name.to_string());
            bar
        });
        let name = name.to_string();
        Progress { bar, name, started: Instant::now(), last_line: AtomicU64::new(0), quiet }
    }

    /// `share` of the work, in [0,1], is done. May be called from any thread.
    pub fn set(&self, share: f64) {
        if let Some(bar) = &self.bar {
            bar.set_position((share * STEPS as f64) as u64);
            return;
        }
        let seconds = self.started.elapsed().as_secs();
        let last = self.last_line.load(Ordering::Relaxed);
        let due = !self.quiet && seconds >= last + LINE_EVERY;
        if due && self.last_line.compare_exchange(last, seconds, Ordering::Relaxed, Ordering::Relaxed).is_ok()
        {
            let left = if share > 0.0 { seconds as f64 * (1.0 - share) / share } else { f64::INFINITY };
            say(&format!("{}: {:.0} % after {seconds} s, {left:.0} s left\n", self.name, 100.0 * share));
        }
    }

    /// `share` of the work is done, and `what` begins.
    pub fn step(&self, what: &str, share: f64) {
        if let Some(bar) = &self.bar {
            bar.set_message(format!("{}: {what}", self.name));
        }
        self.set(share);
    }

    /// Does something on the terminal that the bar must not overwrite.
    pub fn suspend<T>(&self, work: impl FnOnce() -> T) -> T {
        match &self.bar {
            Some(bar) => bar.suspend(work),
            None => work(),
        }
    }

    /// Takes the bar away.
    pub fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }

    /// Ends with one last line: the time, and what `work` says was done in it.
    pub fn finish(self, work: &str) -> Duration {
        let elapsed = self.started.elapsed();
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
        if !self.quiet {
            say(&format!("{}: {:.2} s, {work}\n", self.name, elapsed.as_secs_f64()));
        }
        elapsed
    }
}

/// Says something on stderr. Whoever closed it does not want to know; that is no reason to fail, as `eprint!` would.
pub fn say(text: &str) {
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// A flag that Ctrl-C sets, so that work can stop and leave nothing half-done; the second Ctrl-C kills.
pub fn stop_flag() -> &'static AtomicBool {
    static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();
    FLAG.get_or_init(|| {
        let flag = Arc::new(AtomicBool::new(false));
        let set = flag.clone();
        // If another handler is installed already, that one decides.
        let _ = ctrlc::set_handler(move || {
            if set.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
        });
        flag
    })
}
