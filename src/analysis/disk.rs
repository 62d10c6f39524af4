//! Program files on disk.
//!
//! Used files may come from someone else, and their paths may lead anywhere. So only regular files
//! are opened (a pipe or a device could block the reader indefinitely), only if their names are
//! those of programs, and only up to a maximum size.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::files::Reader;

/// The most folder entries of a workspace that are visited: the workspace may be a home folder.
const MOST_ENTRIES: usize = 20_000;

/// The largest program, in bytes: 64 MiB.
const LARGEST_PROGRAM: u64 = 64 << 20;

/// Reads files from disk.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Reader for Disk {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let path = Path::new(name);
        expect_regular(path, LARGEST_PROGRAM)?;
        if !is_program(path) {
            return Err("the name of a program ends in `.hedge`".to_owned());
        }
        read_program(path)
    }

    fn identity(&mut self, name: &str) -> String {
        let path = Path::new(name).canonicalize();
        path.map_or_else(|_| name.to_owned(), |path| path.display().to_string())
    }

    fn beside(&mut self, name: &str) -> Vec<String> {
        let folder = Path::new(name).parent().unwrap_or(Path::new(""));
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let programs = entries.map(|entry| entry.path()).filter(|path| is_program(path));
        let mut names: Vec<_> = programs.map(|path| path.display().to_string()).collect();
        names.sort();
        names
    }

    fn under(&mut self, folder: &str) -> Vec<String> {
        let mut names = Vec::new();
        let mut looked_at = 0;
        let mut open = vec![Path::new(folder).to_owned()];
        while let Some(folder) = open.pop() {
            for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
                looked_at += 1;
                if looked_at > MOST_ENTRIES {
                    return names;
                }
                let path = entry.path();
                // Symbolic links are not followed: they may form a cycle.
                if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                    let name = entry.file_name();
                    let is_built = name == "target" || name == "node_modules";
                    if !is_built && !name.as_encoded_bytes().starts_with(b".") {
                        open.push(path);
                    }
                } else if is_program(&path) {
                    names.push(path.display().to_string().replace('\\', "/"));
                }
            }
        }
        names
    }
}

/// True if a name is that of a program.
pub fn is_program(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("hedge"))
}

/// Checks that a path leads to a regular file of at most `most` bytes.
pub fn expect_regular(path: &Path, most: u64) -> Result<(), String> {
    let about = std::fs::metadata(path).map_err(|error| why(&error))?;
    if about.is_dir() {
        return Err("it is a folder".to_owned());
    }
    if !about.is_file() {
        return Err("it is not a regular file".to_owned());
    }
    if about.len() > most {
        return Err(too_large(most));
    }
    Ok(())
}

/// Reads the text of a program from whatever the path leads to: the user has named it.
pub fn read_program(path: &Path) -> Result<String, String> {
    let mut bytes = Vec::new();
    let read =
        File::open(path).and_then(|file| file.take(LARGEST_PROGRAM + 1).read_to_end(&mut bytes));
    read.map_err(|error| why(&error))?;
    program_text(bytes)
}

/// The bytes of a program as text.
///
/// # Errors
/// The reason, in words: too large, or not UTF-8.
pub fn program_text(bytes: Vec<u8>) -> Result<String, String> {
    if bytes.len() as u64 > LARGEST_PROGRAM {
        return Err(too_large(LARGEST_PROGRAM));
    }
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        format!("it is not UTF-8 text: see line {line}")
    })
}

fn too_large(most: u64) -> String {
    format!("it is larger than {} MiB", most >> 20)
}

fn why(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => error.to_string(),
    }
}
