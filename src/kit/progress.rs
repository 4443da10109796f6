//! Progress on stderr, and the polite way to be stopped.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::io::{IsTerminal, Write};
use std::sync::Once;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicU64, Ordering};
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
            let left = |state: &ProgressState, out: &mut dyn std::fmt::Write| {
                let share = state.pos() as f64 / STEPS as f64;
                // A bar that cannot be written to has nobody who looks at it.
                let _ = write!(out, "{}", left(share, state.elapsed()).unwrap_or_default());
            };
            if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent} %  {left}") {
                bar.set_style(style.with_key("left", left));
            }
            bar.set_message(name.to_string());
            bar
        });
        let name = name.to_string();
        Progress { bar, name, started: Instant::now(), last_line: AtomicU64::new(0), quiet }
    }

    /// `share` of the work, in `[0,1]`, is done. May be called from any thread.
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
            let left = left(share, self.started.elapsed()).map(|l| format!(", {l}")).unwrap_or_default();
            let after = in_words(Duration::from_secs(seconds));
            say(&format!("{}: {:.0} % after {after}{left}\n", self.name, (100.0 * share).floor()));
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

/// Work that stops early leaves no bar behind.
impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = self.bar.as_ref().filter(|bar| !bar.is_finished()) {
            bar.finish_and_clear();
        }
    }
}

/// Says something on stderr. Whoever closed it does not want to know; that is no reason to fail, as `eprint!` would.
pub fn say(text: &str) {
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// `47 s left`, if the rest goes on as what was done until now; none before anything was done.
fn left(share: f64, elapsed: Duration) -> Option<String> {
    let left = elapsed.as_secs_f64() * (1.0 - share) / share;
    let left = Duration::try_from_secs_f64(left).ok().filter(|_| share > 0.0)?;
    Some(format!("{} left", in_words(left)))
}

/// A time as a person tells it, in its two largest units: `47 s`, `3 min 20 s`, `5 h 2 min`, `3 days 4 h`.
pub fn in_words(time: Duration) -> String {
    let seconds = time.as_secs().saturating_add(u64::from(time.subsec_nanos() > 0)); // never too little
    let (minutes, hours) = (seconds / 60, seconds / 3600);
    match hours {
        48.. => format!("{} days {} h", hours / 24, hours % 24),
        1.. => format!("{hours} h {} min", minutes % 60),
        0 if minutes > 0 => format!("{minutes} min {} s", seconds % 60),
        0 => format!("{seconds} s"),
    }
}

static STOP: AtomicBool = AtomicBool::new(false);
/// Number of the signal that asked to stop.
static SIGNAL: AtomicU8 = AtomicU8::new(SIGINT);
const SIGINT: u8 = 2;

/// A flag that SIGINT (Ctrl-C), SIGTERM and SIGHUP set, so that work can stop and leave nothing half-done; the second
/// signal ends the program at once. Until this is first called, signals do what they always do.
pub fn stop_flag() -> &'static AtomicBool {
    static LISTENING: Once = Once::new();
    LISTENING.call_once(listen);
    &STOP
}

/// The exit code of a program that a signal stopped: 128 and the signal's number, as shells have it.
pub fn stop_code() -> u8 {
    128 + SIGNAL.load(Ordering::Relaxed)
}

/// Has each signal that asks a program to stop set the flag, but those that whoever started it wants ignored (`nohup`).
#[cfg(unix)]
fn listen() {
    use nix::sys::signal::{SaFlags, SigAction, SigHandler, SigSet, Signal, sigaction};
    extern "C" fn stop(signal: i32) {
        if STOP.swap(true, Ordering::Relaxed) {
            // SAFETY: `_exit` may be called in a signal handler, and ends the process.
            unsafe { nix::libc::_exit(128 + signal) }
        }
        SIGNAL.store(u8::try_from(signal).unwrap_or(SIGINT), Ordering::Relaxed);
    }
    let action = SigAction::new(SigHandler::Handler(stop), SaFlags::SA_RESTART, SigSet::empty());
    for signal in [Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP] {
        // SAFETY: the handler does nothing but set two atomic numbers or call `_exit`, which handlers may do.
        let before = unsafe { sigaction(signal, &action) };
        if let Some(before) = before.ok().filter(|b| matches!(b.handler(), SigHandler::SigIgn)) {
            // SAFETY: what was there before is put back.
            let _ = unsafe { sigaction(signal, &before) };
        }
    }
}

#[cfg(not(unix))]
fn listen() {
    // If another handler is installed already, that one decides.
    let _ = ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(stop_code()));
        }
    });
}
