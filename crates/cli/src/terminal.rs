//! Talking to the person at the terminal: messages on standard error, data on standard output.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::time::{Duration, Instant};
use tremolite::job::Remark;

/// Whether messages may be coloured.
pub fn colour() -> bool {
    std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none()
}

/// Whether another process speaks for this one.
static QUIET: AtomicBool = AtomicBool::new(false);

/// From now on another process speaks for this one.
pub fn be_quiet() {
    QUIET.store(true, Relaxed);
}

fn is_quiet() -> bool {
    QUIET.load(Relaxed)
}

/// A message. A closed standard error is no reason to stop.
pub fn say(message: &str) {
    if !is_quiet() {
        let _ = writeln!(std::io::stderr(), "{message}");
    }
}

/// A message of a process for which another speaks, of what that does not know.
pub fn say_of_rank(message: &str) {
    let _ = match is_quiet() {
        true => writeln!(std::io::stderr(), "of a rank that is not the first: {message}"),
        false => writeln!(std::io::stderr(), "{message}"),
    };
}

/// What is unusual of a case.
pub fn tell(remarks: &[Remark]) {
    remarks.iter().for_each(|remark| say(&remark.render(colour())));
}

/// Sentences of what is unusual.
pub fn warn(sentences: &[String]) {
    sentences.iter().for_each(|sentence| say(&format!("warning: {sentence}")));
}

/// A line of data. A closed pipe (`| head`) ends the output quietly.
pub fn print(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}

/// One line of progress: rewritten in place on a terminal, every tenth of the way elsewhere.
pub struct ProgressLine {
    begin: Instant,
    live: bool,
    tenths: u64,
    width: usize,
}

impl ProgressLine {
    pub fn new() -> Self {
        ProgressLine { begin: Instant::now(), live: std::io::stderr().is_terminal(), tenths: 0, width: 0 }
    }

    /// Shows how far it is: `done` of 1, and some words.
    pub fn show(&mut self, done: f64, words: &str) {
        let left =
            if done > 0.0 { self.begin.elapsed().as_secs_f64() * (1.0 - done) / done } else { f64::NAN };
        if is_quiet() {
            return;
        }
        let text = format!("  {:3.0} %  {words}  {} left", 100.0 * done, duration(left));
        if self.live {
            let pad = self.width.saturating_sub(text.chars().count());
            let _ = write!(std::io::stderr(), "\r{text}{:pad$}", "");
            let _ = std::io::stderr().flush();
            self.width = text.chars().count();
        } else if (10.0 * done) as u64 > self.tenths {
            self.tenths = (10.0 * done) as u64;
            say(&text);
        }
    }

    /// Ends the line.
    pub fn end(&self) {
        if self.live && self.width > 0 {
            let _ = write!(std::io::stderr(), "\r{:1$}\r", "", self.width);
        }
    }
}

/// Seconds for people.
pub fn duration(seconds: f64) -> String {
    if !seconds.is_finite() {
        return "?".into();
    }
    let d = Duration::from_secs_f64(seconds.max(0.0));
    let s = d.as_secs();
    match s {
        0..=9 => format!("{:.1} s", d.as_secs_f64()),
        10..=119 => format!("{s} s"),
        120..=7199 => format!("{} min", (s + 30) / 60),
        _ => format!("{:.1} h", d.as_secs_f64() / 3600.0),
    }
}

/// The size of a message [bytes], as people read it.
pub fn sent(size: f64) -> String {
    if size < 1e7 { format!("{:.1} kB", 1e-3 * size) } else { bytes(size as usize) }
}

/// Bytes for people.
pub fn bytes(bytes: usize) -> String {
    let b = bytes as f64;
    if b < 1e9 { format!("{:.0} MB", (b / 1e6).max(1.0)) } else { format!("{:.1} GB", b / 1e9) }
}
