//! Output files, written completely or not at all.

use std::path::Path;

use super::failure::Failure;
use super::interrupt;
use super::meshes::expect_place;
use super::output::{is_standard, write_stdout};
use crate::mesh::{FileReason, replace_file};

/// Writes a file.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if is_standard(path) {
        return write_stdout(bytes);
    }
    expect_place(path)?;
    expect_waiting(path);
    replace_file(path, |output| output.write_all(bytes).map_err(FileReason::Io))
        .map_err(|reason| Failure::usage(format!("{}: {reason}", path.display())))
}

/// True if two paths lead to the same file.
pub(super) fn is_same(one: &Path, other: &Path) -> bool {
    let [one, other] = [one, other].map(identity);
    one.is_some() && one == other
}

/// The device and the number of a file, which all its names share.
#[cfg(unix)]
fn identity(path: &Path) -> Option<[u64; 2]> {
    use std::os::unix::fs::MetadataExt;
    let file = path.metadata().ok()?;
    Some([file.dev(), file.ino()])
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<std::path::PathBuf> {
    path.canonicalize().ok()
}

/// Lets Ctrl-C end the process at once if a path, such as a pipe, may block until it is read.
/// Called before the path is opened.
pub(super) fn expect_waiting(path: &Path) {
    if path.metadata().is_ok_and(|place| !place.is_file()) {
        interrupt::end_at_once();
    }
}
