//! The files of this computer.

use std::path::Path;

use crate::analysis::Reader;

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
        let programs = entries.map(|entry| entry.path()).filter(|path| {
            let extension = path.extension();
            extension.is_some_and(|extension| extension == "hedge")
        });
        let mut names: Vec<_> = programs.map(|path| path.display().to_string()).collect();
        names.sort();
        names
    }
}
