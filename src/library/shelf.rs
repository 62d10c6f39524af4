//! The files of the library.

/// The prefix of the names of all files of the library.
pub const FOLDER: &str = "std/";

/// A file of the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LibraryFile {
    /// Its name, as `use` writes it: `std/triangle.hedge`.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
}

const FILES: &[LibraryFile] = &[
    LibraryFile { name: "std/triangle.hedge", text: include_str!("std/triangle.hedge") },
    LibraryFile { name: "std/polygon.hedge", text: include_str!("std/polygon.hedge") },
    LibraryFile { name: "std/map.hedge", text: include_str!("std/map.hedge") },
    LibraryFile { name: "std/planar.hedge", text: include_str!("std/planar.hedge") },
    LibraryFile {
        name: "std/planar_triangle.hedge",
        text: include_str!("std/planar_triangle.hedge"),
    },
    LibraryFile { name: "std/planar_quad.hedge", text: include_str!("std/planar_quad.hedge") },
    LibraryFile {
        name: "std/planar_cleanup.hedge",
        text: include_str!("std/planar_cleanup.hedge"),
    },
    LibraryFile { name: "std/sharp.hedge", text: include_str!("std/sharp.hedge") },
    LibraryFile { name: "std/subdivide.hedge", text: include_str!("std/subdivide.hedge") },
    LibraryFile { name: "std/dual.hedge", text: include_str!("std/dual.hedge") },
    LibraryFile { name: "std/remesh.hedge", text: include_str!("std/remesh.hedge") },
    LibraryFile { name: "std/simplify.hedge", text: include_str!("std/simplify.hedge") },
    LibraryFile { name: "std/triangulate.hedge", text: include_str!("std/triangulate.hedge") },
    LibraryFile { name: "std/smooth.hedge", text: include_str!("std/smooth.hedge") },
    LibraryFile { name: "std/random.hedge", text: include_str!("std/random.hedge") },
    LibraryFile { name: "std/repair.hedge", text: include_str!("std/repair.hedge") },
    LibraryFile { name: "std/components.hedge", text: include_str!("std/components.hedge") },
    LibraryFile { name: "std/curvature.hedge", text: include_str!("std/curvature.hedge") },
    LibraryFile { name: "std/delete.hedge", text: include_str!("std/delete.hedge") },
    LibraryFile { name: "std/trim.hedge", text: include_str!("std/trim.hedge") },
    LibraryFile { name: "std/transform.hedge", text: include_str!("std/transform.hedge") },
    LibraryFile { name: "std/distance.hedge", text: include_str!("std/distance.hedge") },
    LibraryFile { name: "std/scotty3d.hedge", text: include_str!("std/scotty3d.hedge") },
];

impl LibraryFile {
    /// Its name without folder and ending: `triangle`.
    pub fn short_name(&self) -> &'static str {
        let inner = self.name.strip_prefix(FOLDER).unwrap_or(self.name);
        inner.split('.').next().unwrap_or(inner)
    }
}

/// The mesh classes for which C++ is emitted: style files.
const TARGETS: &[LibraryFile] =
    &[LibraryFile { name: "std/scotty3d.target", text: include_str!("std/scotty3d.target") }];

/// All targets.
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
