//! The files of this computer.

use std::path::Path;

use crate::analysis::Reader;

/// Reads programs from files.
pub(crate) struct Disk;

impl Reader for Disk {
    fn read(&mut self, name: &str) -> Result<String, String> {
        match Path::new(name).exists() {
            true => text_of(Path::new(name)),
            false => Err("there is no such file".to_owned()),
        }
    }

    fn beside(&mut self, name: &str) -> Vec<String> {
        let folder = Path::new(name).parent().unwrap_or(Path::new(""));
        let folder = match folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => folder,
        };
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
        let mut names: Vec<_> = names.filter(|name| name.ends_with(".hedge")).collect();
        names.sort();
        names
    }
}

/// The text of a file, or in words why there is none.
pub(crate) fn text_of(path: &Path) -> Result<String, String> {
    as_text(std::fs::read(path).map_err(|error| error.to_string())?)
}

/// Bytes as text, or in words why they are none.
pub(crate) fn as_text(bytes: Vec<u8>) -> Result<String, String> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        format!("it is not UTF-8 text: see line {line}")
    })?;
    match u32::try_from(text.len()) {
        Ok(_) => Ok(text),
        Err(_) => Err("it is larger than 4 GiB".to_owned()),
    }
}
