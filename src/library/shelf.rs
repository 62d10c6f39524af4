//! The files of the library.

/// The prefix of the names of all files of the library.
pub const FOLDER: &str = "std/";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LibraryFile {
    /// Its name, as `use` writes it: `std/triangle.hedge`.
    pub name: &'static str,
    pub text: &'static str,
}

/// Files of the library: the names, and the texts beside this file.
macro_rules! files {
    ($($name:literal),* $(,)?) => {
        &[$(LibraryFile { name: $name, text: include_str!($name) }),*]
    };
}

const FILES: &[LibraryFile] = files![
    "std/triangle.hedge",
    "std/polygon.hedge",
    "std/map.hedge",
    "std/planar.hedge",
    "std/planar_triangle.hedge",
    "std/planar_quad.hedge",
    "std/planar_cleanup.hedge",
    "std/sharp.hedge",
    "std/subdivide.hedge",
    "std/dual.hedge",
    "std/remesh.hedge",
    "std/simplify.hedge",
    "std/triangulate.hedge",
    "std/smooth.hedge",
    "std/random.hedge",
    "std/repair.hedge",
    "std/components.hedge",
    "std/curvature.hedge",
    "std/delete.hedge",
    "std/trim.hedge",
    "std/transform.hedge",
    "std/distance.hedge",
    "std/scotty3d.hedge",
];

impl LibraryFile {
    /// Its name without folder and ending: `triangle`.
    pub fn short_name(&self) -> &'static str {
        let inner = self.name.strip_prefix(FOLDER).unwrap_or(self.name);
        inner.split('.').next().unwrap_or(inner)
    }
}

/// The mesh classes for which C++ is emitted: style files.
const TARGETS: &[LibraryFile] = files!["std/scotty3d.target"];

pub fn targets() -> impl Iterator<Item = LibraryFile> {
    TARGETS.iter().copied()
}

/// The target with the given name: `std/scotty3d.target`, or `scotty3d` for short.
pub fn target(name: &str) -> Option<LibraryFile> {
    let inner = name.strip_prefix(FOLDER).unwrap_or(name);
    let short = inner.strip_suffix(".target").unwrap_or(inner);
    targets().find(|target| target.short_name() == short)
}

/// All files, in the recommended reading order.
pub fn files() -> impl Iterator<Item = LibraryFile> {
    FILES.iter().copied()
}

/// The file with the given name: `std/triangle.hedge`, or `std/triangle` or `triangle` for short.
pub fn file(name: &str) -> Option<LibraryFile> {
    files().find(|file| {
        let shorter = file.name.strip_suffix(".hedge").unwrap_or(file.name);
        let shortest = shorter.strip_prefix(FOLDER).unwrap_or(shorter);
        [file.name, shorter, shortest].contains(&name)
    })
}

/// The name of a file that is not of the library, even where its folder has the name of the library.
pub fn outside(name: String) -> String {
    if name.starts_with(FOLDER) { format!("./{name}") } else { name }
}
