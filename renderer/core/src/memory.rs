//! How much memory a scene may take. What needs more is refused before it is asked of the system, which
//! would end the process.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// What is allowed, in bytes; 0 until someone has asked.
static LIMIT: AtomicU64 = AtomicU64::new(0);

/// What is allowed where the system does not say how much it has.
const UNKNOWN: u64 = 8 << 30;

/// The most bytes that one thing may need: at first three quarters of the memory of the machine.
pub fn limit() -> u64 {
    match LIMIT.load(Relaxed) {
        0 => {
            set_limit(machine().map_or(UNKNOWN, |bytes| bytes / 4 * 3));
            LIMIT.load(Relaxed)
        }
        bytes => bytes,
    }
}

/// Sets the [`limit`] of this process.
pub fn set_limit(bytes: u64) {
    LIMIT.store(bytes.max(1), Relaxed);
}

/// Asks for memory beforehand.
///
/// # Errors
///
/// What is needed and what there is, if it is more than the [`limit`].
pub fn ask(bytes: u64) -> Result<(), String> {
    let limit = limit();
    if bytes <= limit {
        return Ok(());
    }
    Err(format!(
        "needs about {} of memory; there may be {} (--max-memory)",
        amount(bytes),
        amount(limit)
    ))
}

/// An amount of memory as people read it.
fn amount(bytes: u64) -> String {
    const UNITS: [&str; 5] = ["bytes", "kB", "MB", "GB", "TB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1000.0 && unit + 1 < UNITS.len() {
        value /= 1000.0;
        unit += 1;
    }
    if value < 10.0 && unit > 0 {
        format!("{value:.1} {}", UNITS[unit])
    } else {
        format!("{value:.0} {}", UNITS[unit])
    }
}

/// The memory of the machine, where Linux says so.
fn machine() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_readable() {
        for (bytes, text) in
            [(0, "0 bytes"), (999, "999 bytes"), (1500, "1.5 kB"), (u64::MAX, "18446744 TB")]
        {
            assert_eq!(amount(bytes), text);
        }
    }

    #[test]
    fn more_than_there_is_is_refused() {
        assert_eq!(ask(1), Ok(()));
        assert!(ask(u64::MAX).unwrap_err().starts_with("needs about 18446744 TB of memory"));
    }
}
