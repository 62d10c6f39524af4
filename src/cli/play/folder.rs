//! The files that the page may open: those of one folder, and the two that it was started with.

use std::fs;
use std::path::{Path, PathBuf};

use super::super::program::is_mesh;
use crate::analysis::{expect_regular, is_program, read_program};
use crate::mesh::{FileReason, replace_file};

/// The most files that are listed.
const MOST_FILES: usize = 2000;

/// The largest mesh file, in bytes.
const LARGEST_MESH: u64 = 4 << 30;

/// A folder, and files that the command line names.
#[derive(Clone, Debug, Default)]
pub(super) struct Folder {
    /// The folder, as an absolute path.
    pub path: PathBuf,
    /// The program and the mesh that the page begins with, by the names that they have here.
    pub program: Option<String>,
    pub mesh: Option<String>,
}

impl Folder {
    /// The given folder; else that of the given program, else that of the given mesh, else the
    /// working folder.
    pub fn of(files: &[PathBuf]) -> Result<Self, String> {
        let [mut folder, mut program, mut mesh] = [const { None::<PathBuf> }; 3];
        for file in files {
            let shown = file.display();
            let path = std::path::absolute(file).ok().filter(|path| path.exists());
            let path =
                path.ok_or_else(|| format!("cannot read `{shown}`: there is no such file"))?;
            let place = match () {
                () if path.is_dir() => &mut folder,
                () if is_program(&path) => &mut program,
                () => &mut mesh,
            };
            if place.replace(path).is_some() {
                return Err("one program and one mesh can be opened, not more".to_owned());
            }
        }
        let beside = |file: &Option<PathBuf>| file.as_ref()?.parent().map(Path::to_owned);
        let path = folder.or_else(|| beside(&program)).or_else(|| beside(&mesh));
        let path = path.map_or_else(std::env::current_dir, Ok);
        let path = path.map_err(|error| format!("the working folder cannot be read: {error}"))?;
        let named = |file: PathBuf| match file.strip_prefix(&path) {
            Ok(inside) => inside.display().to_string(),
            Err(_) => file.display().to_string(),
        };
        Ok(Self { program: program.map(named), mesh: mesh.map(named), path })
    }

    /// The names of programs and of meshes.
    pub fn list(&self) -> [Vec<String>; 2] {
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        let names = entries.filter(|entry| entry.path().is_file());
        let names = names.filter_map(|entry| entry.file_name().into_string().ok());
        let mut names: Vec<String> = names.take(MOST_FILES).collect();
        names.extend(self.program.iter().chain(&self.mesh).cloned());
        names.sort();
        names.dedup();
        let (programs, rest) = names.into_iter().partition(|name| is_program(Path::new(name)));
        let rest: Vec<String> = rest;
        [programs, rest.into_iter().filter(|name| is_mesh(Path::new(name))).collect()]
    }

    /// The text of a program that is listed.
    pub fn program(&self, name: &str) -> Result<String, String> {
        read_program(&self.listed(name)?).map_err(|why| format!("cannot read `{name}`: {why}"))
    }

    /// The bytes of a mesh file that is listed.
    pub fn mesh(&self, name: &str) -> Result<Vec<u8>, String> {
        let path = self.listed(name)?;
        let told = |why: String| format!("cannot read `{name}`: {why}");
        expect_regular(&path, LARGEST_MESH).map_err(told)?;
        fs::read(&path).map_err(|error| told(error.to_string()))
    }

    /// Writes a program: a listed one that still has the text `was`, or one in the folder that is
    /// new, or not there any more.
    pub fn save(&self, name: &str, was: Option<&str>, text: &str) -> Result<(), String> {
        let path = self.listed(name).or_else(|_| self.new_program(name))?;
        let mut text = text.to_owned();
        // A file that somebody has deleted is written again: nothing is lost by that.
        if path.try_exists().unwrap_or(true) {
            let was = was.ok_or_else(|| format!("`{name}` is there already: give another name"))?;
            let now = path.is_file().then(|| read_program(&path).ok()).flatten();
            let now = now.filter(|now| is_alike(now, was)).ok_or_else(|| {
                format!(
                    "`{name}` has been changed elsewhere since it was opened: download this text, \
                     and open the file again"
                )
            })?;
            if now.contains("\r\n") {
                text = text.replace("\r\n", "\n").replace('\n', "\r\n");
            }
        }
        let written =
            replace_file(&path, |file| file.write_all(text.as_bytes()).map_err(FileReason::Io));
        written.map_err(|reason| format!("`{name}` cannot be written: {reason}"))
    }

    /// The path of a program that may be made in the folder.
    fn new_program(&self, name: &str) -> Result<PathBuf, String> {
        let path = self.path.join(name);
        let is_plain = Path::new(name).file_name().is_some_and(|last| last == name);
        match is_plain && is_program(&path) {
            true => Ok(path),
            false => Err("the name of a program ends in `.hedge`, and names no folder".into()),
        }
    }

    /// The path of a listed name; all others are refused.
    fn listed(&self, name: &str) -> Result<PathBuf, String> {
        match self.list().iter().flatten().any(|known| known == name) {
            true => Ok(self.path.join(name)),
            false => Err(format!("there is no `{name}` in {}", self.path.display())),
        }
    }
}

/// True if two texts have the same lines: editors show all line ends as one.
fn is_alike(one: &str, other: &str) -> bool {
    one.lines().eq(other.lines()) && one.ends_with('\n') == other.ends_with('\n')
}
