//! What asks a program to end: Ctrl-C, SIGTERM, and SIGHUP when a terminal closes.

/// Calls `told` whenever the program is asked to end, on a thread of its own.
///
/// A SIGHUP that whoever started the program has told it to ignore, as `nohup` does, is none of these (on
/// Linux; elsewhere nobody says whether it is ignored). Without the thread a signal ends the program at
/// once, or is lost.
#[cfg(unix)]
pub(super) fn heed(told: impl Fn() + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    let heeded: &[i32] =
        if is_ignored(SIGHUP) { &[SIGINT, SIGTERM] } else { &[SIGINT, SIGTERM, SIGHUP] };
    let Ok(mut signals) = Signals::new(heeded) else { return };
    let listen = move || signals.forever().for_each(|_| told());
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(listen);
}

/// The same where there are no signals but Ctrl-C and its kin.
#[cfg(windows)]
pub(super) fn heed(told: impl Fn() + Send + 'static) {
    let _ = ctrlc::set_handler(told);
}

/// The same where nobody can ask.
#[cfg(not(any(unix, windows)))]
pub(super) fn heed(_: impl Fn() + Send + 'static) {}

/// Whether the program was started with `signal` ignored.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}
