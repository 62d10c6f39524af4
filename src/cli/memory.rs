//! Memory that a run may take.

use sysinfo::System;

/// Reads a size in bytes: `500M`, `4G`; without a letter, bytes.
pub fn read(text: &str) -> Result<usize, String> {
    let wrong = || format!("`{text}` is not a size: write a number with K, M, G or T, as `4G`");
    let upper = text.trim().to_ascii_uppercase();
    let number = upper.trim_end_matches('B').trim_end_matches('I');
    let (number, shift) = match number.char_indices().next_back() {
        Some((at, 'K')) => (&number[..at], 10),
        Some((at, 'M')) => (&number[..at], 20),
        Some((at, 'G')) => (&number[..at], 30),
        Some((at, 'T')) => (&number[..at], 40),
        _ => (number, 0),
    };
    let number: f64 = number.trim().parse().map_err(|_| wrong())?;
    let bytes = number * f64::from(shift).exp2();
    if shift == 0 && (1.0..1e6).contains(&bytes) {
        return Err(format!("{text} bytes are too few: write a unit, as `{text}G`"));
    }
    // The cast saturates.
    if bytes >= 1.0 { Ok(bytes as usize) } else { Err(wrong()) }
}

/// Three quarters of the memory of the machine, or of the container that this process is in;
/// `usize::MAX` if that is not known.
pub fn usual() -> usize {
    let Ok(mut system) = System::new() else { return usize::MAX };
    system.refresh_memory();
    let machine = system.total_memory();
    let container = system.cgroup_limits().map(|limits| limits.total_memory);
    let least = [Some(machine), container].into_iter().flatten().filter(|&bytes| bytes > 0).min();
    least.map_or(usize::MAX, |bytes| usize::try_from(bytes / 4 * 3).unwrap_or(usize::MAX))
}
