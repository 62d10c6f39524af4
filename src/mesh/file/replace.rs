//! Atomic writing of a file.
//!
//! The text goes to a new file in the same folder, which replaces the old one when it is complete.
//! So the new file belongs to who writes it, and other hard links to the old one still lead there.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::error::FileReason;

/// Writes a file completely or not at all. `write` writes its contents.
///
/// # Errors
/// [`FileReason::NoFolder`], [`FileReason::ClosedFolder`], [`FileReason::ReadOnly`],
/// [`FileReason::Io`], and the errors of `write`; the old file, if there was one, is unchanged.
pub fn replace_file(
    path: &Path,
    write: impl Fn(&mut dyn Write) -> Result<(), FileReason>,
) -> Result<(), FileReason> {
    replace_file_unless(path, &|| false, write)
}

/// As [`replace_file`], unless `stops` is true at some time before the old file is replaced: it is
/// asked at intervals.
///
/// # Errors
/// As for [`replace_file`]; [`FileReason::Io`] if it was stopped.
pub(super) fn replace_file_unless(
    path: &Path,
    stops: &dyn Fn() -> bool,
    write: impl Fn(&mut dyn Write) -> Result<(), FileReason>,
) -> Result<(), FileReason> {
    // A device or a pipe cannot be replaced, only written to. The target of a link to a pipe need
    // not be a path: `/dev/stdout`.
    if fs::metadata(path).is_ok_and(|old| !old.is_file()) {
        let file = fs::OpenOptions::new().write(true).open(path).map_err(FileReason::Io)?;
        let mut output = BufWriter::new(file);
        write(&mut output)?;
        return output.flush().map_err(FileReason::Io);
    }
    let (target, mut file) = begin(path)?;
    {
        let output = Unless { output: file.as_file_mut(), stops };
        let mut output = BufWriter::with_capacity(1 << 16, output);
        write(&mut output)?;
        output.flush().map_err(FileReason::Io)?;
    }
    // The name must refer to the complete text even if the power fails right after.
    file.as_file().sync_all().map_err(FileReason::Io)?;
    if stops() {
        return Err(FileReason::Io(stopped()));
    }
    if let Ok(old) = fs::metadata(&target) {
        file.as_file().set_permissions(old.permissions()).map_err(FileReason::Io)?;
    }
    file.persist(&target).map_err(|failed| FileReason::Io(failed.error))?;
    Ok(())
}

/// An output that fails from when it is to stop.
struct Unless<'o> {
    output: &'o mut fs::File,
    stops: &'o dyn Fn() -> bool,
}

impl Write for Unless<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if (self.stops)() { Err(stopped()) } else { self.output.write(bytes) }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.output.flush()
    }
}

/// The error for an output that was stopped. One of the kind `Interrupted` would be tried again.
fn stopped() -> io::Error {
    io::Error::other("interrupted")
}

/// Checks that a file may be written: the new one that would replace it is made, and removed.
///
/// # Errors
/// As for [`replace_file`].
pub fn expect_writable(path: &Path) -> Result<(), FileReason> {
    match fs::metadata(path) {
        Ok(old) if !old.is_file() => Ok(()),
        _ => begin(path).map(drop),
    }
}

/// The file that a path leads to, through links, and a new one in the same folder.
fn begin(path: &Path) -> Result<(PathBuf, NamedTempFile), FileReason> {
    let target = followed(path).map_err(FileReason::Io)?;
    expect_unprotected(&target)?;
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let name = || folder.display().to_string();
    if !folder.is_dir() {
        return Err(FileReason::NoFolder(name()));
    }
    match new_file(folder) {
        Ok(file) => Ok((target, file)),
        Err(error) => Err(FileReason::ClosedFolder { folder: name(), error }),
    }
}

/// Checks that a file may be written, if it exists. A protected file could be replaced all the
/// same, which its owner does not want.
fn expect_unprotected(path: &Path) -> Result<(), FileReason> {
    let Some(old) = fs::metadata(path).ok().filter(fs::Metadata::is_file) else { return Ok(()) };
    if old.permissions().readonly() {
        return Err(FileReason::ReadOnly);
    }
    match fs::OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => Err(FileReason::ReadOnly),
        Err(error) => Err(FileReason::Io(error)),
        Ok(_) => Ok(()),
    }
}

/// Follows the symbolic links from `path`, whether the target exists or not.
fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut at = path.to_owned();
    // Linux follows as many links.
    for _ in 0..40 {
        match fs::read_link(&at) {
            // A relative link is relative to the folder of the link.
            Ok(link) => at = at.parent().unwrap_or(Path::new("")).join(link),
            Err(_) => return Ok(at),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// A temporary file with the permissions of an ordinary new file: the umask of the process applies
/// to the mode.
#[cfg(unix)]
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    tempfile::Builder::new()
        .prefix(".hedgerow-")
        .permissions(fs::Permissions::from_mode(0o666))
        .tempfile_in(folder)
}

#[cfg(not(unix))]
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    tempfile::Builder::new().prefix(".hedgerow-").tempfile_in(folder)
}
