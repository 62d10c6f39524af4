//! The C++ compiler.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Whether there is one. In CI there has to be one.
pub fn has_compiler() -> bool {
    let found = Command::new("g++").arg("--version").output().is_ok();
    if !found {
        assert!(std::env::var_os("CI").is_none(), "CI needs g++");
        eprintln!("SKIPPED: there is no g++, so emitted C++ is neither compiled nor run");
    }
    found
}

/// Runs a compiler in a folder; it has to be content.
pub fn compile(folder: &Path, compiler: &str, args: &[&str]) {
    let done = Command::new(compiler).args(args).current_dir(folder).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    let said: String = said.chars().take(4000).collect();
    assert!(done.status.success(), "{compiler} {args:?} says\n{said}");
}

pub fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}
