//! The files that results go to: whole, or not at all.

use std::path::Path;

use super::failure::Failure;
use super::meshes::expect_place;
use crate::mesh::{ObjReason, replace_file};

/// Writes a file.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    expect_place(path)?;
    replace_file(path, |output| {
        output.write_all(bytes).map_err(ObjReason::Io)
    })
    .map_err(|reason| Failure::usage(format!("{}: {reason}", path.display())))
}
