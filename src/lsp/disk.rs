//! The files of this computer.

use std::path::Path;

use crate::analysis::Reader;

/// How many entries of the folders of a workspace are looked at: a home folder may be one.
const MOST_ENTRIES: usize = 20_000;

/// Reads the files of this computer.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Disk;

impl Reader for Disk {
    fn read(&mut self, name: &str) -> Result<String, String> {
        let bytes = std::fs::read(name).map_err(|error| match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => error.to_string(),
        })?;
        String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_owned())
    }

    fn beside(&mut self, name: &str) -> Vec<String> {
        let folder = Path::new(name).parent().unwrap_or(Path::new("."));
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
                // A link is not followed: it may lead back.
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

fn is_program(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == "hedge")
}
