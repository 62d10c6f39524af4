//! Meshes.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError, TryLockError};

use hedgerow::mesh::glam::DVec3;
use hedgerow::mesh::{
    ColumnId, ElementKind, FaceId, Mesh, MeshFile, Polygons, Repair, Repaired, highest_level,
    identical_but_for_scratch, read_bytes, read_mesh, same_up_to_renumbering, shape, validate,
    write_bytes, write_mesh,
};
use hedgerow::{KeptMask, Mark, Op, Program, Session};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use super::array::values;
use super::column::{column, flat};
use super::element::kind;
use super::error::{Kind, in_call, of_file, saying};
use super::pointers::{ends, holes, living, pointers, polygons};
use super::watch::Signals;

/// A mesh, with what it takes to call operations on it.
#[pyclass(frozen, subclass, name = "Mesh", module = "hedgerow._hedgerow")]
pub struct MeshTables {
    state: Mutex<State>,
    /// The masks that were given up while something ran on the mesh.
    dropped: Mutex<Vec<KeptMask>>,
}

/// The state of a mesh.
pub struct State {
    pub session: Session,
    /// The masks that are kept for operations that were asked near something.
    near: Vec<(Op, KeptMask)>,
    /// The other contents of the file that it comes from, if there is one; without the mesh.
    file: Option<MeshFile>,
}

/// A mesh that is in nobody else's hands.
pub type Held<'m> = MutexGuard<'m, State>;

/// A program of nothing, of a mesh that none has been used with yet.
fn no_program() -> &'static Program {
    static NONE: OnceLock<Program> = OnceLock::new();
    NONE.get_or_init(|| Program::parse("nothing.hedge", "").expect("nothing is wrong in it"))
}

impl State {
    fn new(mesh: Mesh) -> Self {
        let mut session = Session::new(no_program(), mesh);
        session.watch(Signals::default());
        Self { session, near: Vec::new(), file: None }
    }

    fn mesh(&self) -> &Mesh {
        self.session.mesh()
    }

    /// The mask that is kept for an operation.
    pub fn near(&mut self, op: &Op) -> Result<KeptMask, hedgerow::Error> {
        let known = self.near.iter().find(|(known, _)| known.is(op));
        match known {
            Some(&(_, mask)) => Ok(mask),
            None => {
                let mask = self.session.keep_mask(op, ())?;
                self.near.push((op.clone(), mask));
                Ok(mask)
            }
        }
    }
}

impl MeshTables {
    /// The mesh, unless something runs on it.
    pub fn hold(&self, py: Python<'_>) -> PyResult<Held<'_>> {
        let mut state = match self.state.try_lock() {
            Ok(state) => state,
            Err(TryLockError::Poisoned(state)) => state.into_inner(),
            Err(TryLockError::WouldBlock) => {
                let message = "something runs on this mesh, here or in another thread";
                return Err(saying(py, Kind::Busy, "mesh-busy", message.to_owned()));
            }
        };
        self.dropped().drain(..).for_each(|mask| state.session.drop_mask(mask));
        Ok(state)
    }

    /// Gives a mask up, now or, while something runs on the mesh, when that is done.
    pub fn drop_mask(&self, py: Python<'_>, mask: KeptMask) {
        self.dropped().push(mask);
        // What holds the mesh, if anything, is followed by another that does.
        drop(self.hold(py));
    }

    fn dropped(&self) -> MutexGuard<'_, Vec<KeptMask>> {
        self.dropped.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn of(state: State) -> Self {
        Self { state: Mutex::new(state), dropped: Mutex::default() }
    }

    fn with(mesh: Mesh) -> Self {
        Self::of(State::new(mesh))
    }

    fn no_mesh(py: Python<'_>, error: impl std::fmt::Display) -> PyErr {
        saying(py, Kind::Mesh, "no-mesh", error.to_string())
    }
}

/// The column of an attribute by its name.
pub fn column_of(py: Python<'_>, mesh: &Mesh, of: ElementKind, name: &str) -> PyResult<ColumnId> {
    let found =
        mesh.find_column(of, name).filter(|&id| mesh.column(id).is_some_and(|c| c.is_public()));
    found.ok_or_else(|| {
        let all = mesh.columns(of).map(|(_, column)| column);
        let known: Vec<_> =
            all.filter(|one| one.is_public()).map(|one| format!("`{}`", one.name())).collect();
        let known = match known.is_empty() {
            true => "; there is none".to_owned(),
            false => format!("; there is {}", known.join(", ")),
        };
        let _ = py;
        PyKeyError::new_err(format!("no {of} has an attribute `{name}`{known}"))
    })
}

#[pymethods]
impl MeshTables {
    /// A mesh of polygons: coordinates, corners one after the other, and where each polygon ends.
    #[new]
    #[pyo3(signature = (positions, corners, ends, repair=None))]
    fn new(
        py: Python<'_>,
        positions: PyReadonlyArray1<'_, f64>,
        corners: PyReadonlyArray1<'_, i64>,
        ends: PyReadonlyArray1<'_, i64>,
        repair: Option<f64>,
    ) -> PyResult<Self> {
        let (positions, corners, ends) = (values(&positions)?, values(&corners)?, values(&ends)?);
        let mesh = py.detach(move || {
            let (positions, _) = positions.as_chunks();
            let positions: Vec<DVec3> = positions.iter().copied().map(DVec3::from_array).collect();
            let count = positions.len();
            let corner = |&corner: &i64| {
                u32::try_from(corner).map_err(|_| match corner < 0 {
                    true => format!("there is no vertex {corner}: the first is 0"),
                    false => format!("there is no vertex {corner}: there are {count}"),
                })
            };
            let corners = corners.iter().map(corner).collect::<Result<_, _>>()?;
            let ends = ends.iter().map(|&end| usize::try_from(end).unwrap_or(usize::MAX)).collect();
            let polygons = Polygons::from_parts(corners, ends)
                .ok_or("the ends of the polygons are not in order")?;
            match repair {
                None => Mesh::from_owned_polygons(positions, &polygons),
                Some(merge) => {
                    let merge = (merge >= 0.0).then_some(merge);
                    Repaired::new(positions, polygons, Repair { merge }).map(|made| made.mesh)
                }
            }
            .map_err(|error| error.to_string())
        });
        mesh.map(Self::with).map_err(|error| Self::no_mesh(py, error))
    }

    /// Takes the mesh of another over.
    #[pyo3(name = "_take")]
    fn take(&self, py: Python<'_>, other: &Self) -> PyResult<()> {
        let taken = std::mem::replace(&mut *other.hold(py)?, State::new(Mesh::default()));
        *self.hold(py)? = taken;
        Ok(())
    }

    /// The mesh of a file.
    #[staticmethod]
    #[pyo3(signature = (path, repair=None))]
    #[pyo3(name = "_read")]
    fn read(py: Python<'_>, path: PathBuf, repair: Option<f64>) -> PyResult<Self> {
        let repair = repair.map(|merge| Repair { merge: (merge >= 0.0).then_some(merge) });
        let read = py.detach(|| {
            let mut file = read_mesh(&path, repair)?;
            file.bring_all();
            Ok::<_, hedgerow::mesh::FileError>(file)
        });
        let mut file = read.map_err(|error| of_file(py, &error.reason, error.to_string()))?;
        let mut state = State::new(std::mem::take(&mut file.mesh));
        state.file = Some(file);
        Ok(Self::of(state))
    }

    /// Writes the mesh to a file.
    #[pyo3(name = "_save")]
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let state = self.hold(py)?;
        let mut file = match &state.file {
            Some(file) => file.clone(),
            None => MeshFile::from_mesh(Mesh::default()),
        };
        file.mesh = state.session.copy_mesh();
        drop(state);
        let written = py.detach(|| write_mesh(&path, &file));
        written.map_err(|error| of_file(py, &error.reason, error.to_string()))
    }

    /// A small mesh of a name: `cube`, `icosphere`, `grid` …
    #[staticmethod]
    #[pyo3(name = "_shape")]
    fn shape(py: Python<'_>, name: &str, sizes: Vec<u32>) -> PyResult<Self> {
        let wrong = || PyValueError::new_err(format!("`{name}` cannot be of sizes {sizes:?}"));
        let small = sizes.iter().map(|&size| u64::from(size) + 1).product::<u64>() < 1 << 24;
        let made = match (name, sizes.as_slice()) {
            ("tetrahedron", []) => shape::tetrahedron(),
            ("cube", []) => shape::cube(),
            ("octahedron", []) => shape::octahedron(),
            ("icosahedron", []) => shape::icosahedron(),
            ("icosphere", &[k]) if k <= 9 => py.detach(|| shape::icosphere(k)),
            ("grid", &[n, m]) if n > 0 && m > 0 && small => py.detach(|| shape::grid(n, m)),
            ("triangle_grid", &[n, m]) if n > 0 && m > 0 && small => {
                py.detach(|| shape::triangle_grid(n, m))
            }
            ("torus", &[n, m]) if n > 2 && m > 2 && small => py.detach(|| shape::torus(n, m)),
            ("triangle_torus", &[n, m]) if n > 2 && m > 2 && small => {
                py.detach(|| shape::triangle_torus(n, m))
            }
            _ => return Err(wrong()),
        };
        Ok(Self::with(made))
    }

    /// The number of living elements of a kind; holes are not counted among faces.
    #[pyo3(name = "_count")]
    fn count(&self, py: Python<'_>, of: &str) -> PyResult<usize> {
        Ok(self.hold(py)?.mesh().count(kind(of)?))
    }

    /// The number of slots of a kind, living or dead.
    #[pyo3(name = "_capacity")]
    fn capacity(&self, py: Python<'_>, of: &str) -> PyResult<usize> {
        Ok(self.hold(py)?.mesh().capacity(kind(of)?))
    }

    #[pyo3(name = "_hole_count")]
    fn hole_count(&self, py: Python<'_>) -> PyResult<usize> {
        Ok(self.hold(py)?.mesh().hole_count())
    }

    /// Whether a number is that of a living element; a hole is no face.
    #[pyo3(name = "_is_alive")]
    fn is_alive(&self, py: Python<'_>, of: &str, number: i64) -> PyResult<bool> {
        let (state, kind) = (self.hold(py)?, kind(of)?);
        let mesh = state.mesh();
        Ok(u32::try_from(number).is_ok_and(|number| match kind {
            ElementKind::Face => mesh.get_is_hole(FaceId(number)) == Some(false),
            _ => mesh.is_alive(kind, number),
        }))
    }

    /// The level of the mesh: `map`, `surface` or `simple`.
    fn level(&self, py: Python<'_>) -> PyResult<&'static str> {
        let state = self.hold(py)?;
        let mesh = state.mesh();
        let level = py.detach(|| highest_level(mesh));
        Ok(level.map_or("map", |level| level.name()))
    }

    /// The fault of the tables, if there is one.
    #[pyo3(name = "_invalid")]
    fn invalid(&self, py: Python<'_>) -> PyResult<Option<String>> {
        let state = self.hold(py)?;
        let mesh = state.mesh();
        Ok(py.detach(|| validate(mesh)).err().map(|error| error.to_string()))
    }

    /// The coordinates of all slots of vertices, flat; or of the living ones alone.
    #[pyo3(name = "_positions")]
    fn positions<'py>(&self, py: Python<'py>, living: bool) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let state = self.hold(py)?;
        let mesh = state.mesh();
        let all = py.detach(|| {
            let positions = mesh.positions();
            match living && mesh.vertex_count() < positions.len() {
                true => mesh.vertices().flat_map(|v| mesh.position(v).to_array()).collect(),
                false => positions.iter().flat_map(DVec3::to_array).collect(),
            }
        });
        Ok(PyArray1::from_vec(py, all))
    }

    /// Puts all slots of vertices elsewhere.
    #[pyo3(name = "_set_positions")]
    fn set_positions(&self, py: Python<'_>, positions: PyReadonlyArray1<'_, f64>) -> PyResult<()> {
        let positions = values(&positions)?;
        let mut state = self.hold(py)?;
        let session = &mut state.session;
        let done = py.detach(move || {
            let positions: Vec<_> =
                positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
            session.set_positions(&positions)
        });
        done.map_err(|error| in_call(py, &error))
    }

    /// The corners of all faces and where each ends.
    #[allow(clippy::type_complexity)]
    #[pyo3(name = "_polygons")]
    fn polygons<'py>(
        &self,
        py: Python<'py>,
        numbered: bool,
    ) -> PyResult<(Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>)> {
        let state = self.hold(py)?;
        let mesh = state.mesh();
        let (corners, ends) = py.detach(|| polygons(mesh, numbered));
        Ok((PyArray1::from_vec(py, corners), PyArray1::from_vec(py, ends)))
    }

    /// A pointer of all slots of a kind.
    #[pyo3(name = "_pointers")]
    fn pointers<'py>(
        &self,
        py: Python<'py>,
        of: &str,
        name: &str,
    ) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let state = self.hold(py)?;
        let (mesh, kind) = (state.mesh(), kind(of)?);
        let all = py.detach(|| pointers(mesh, kind, name))?;
        Ok(PyArray1::from_vec(py, all))
    }

    #[pyo3(name = "_living")]
    fn living<'py>(&self, py: Python<'py>, of: &str) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let state = self.hold(py)?;
        let (mesh, kind) = (state.mesh(), kind(of)?);
        Ok(PyArray1::from_vec(py, py.detach(|| living(mesh, kind))))
    }

    #[pyo3(name = "_holes")]
    fn holes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let state = self.hold(py)?;
        let mesh = state.mesh();
        Ok(PyArray1::from_vec(py, py.detach(|| holes(mesh))))
    }

    #[pyo3(name = "_ends")]
    fn ends<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let state = self.hold(py)?;
        let mesh = state.mesh();
        Ok(PyArray1::from_vec(py, py.detach(|| ends(mesh))))
    }

    /// The attributes of a kind: names and types.
    #[pyo3(name = "_attributes")]
    fn attributes<'py>(&self, py: Python<'py>, of: &str) -> PyResult<Bound<'py, PyDict>> {
        let state = self.hold(py)?;
        let all = PyDict::new(py);
        for (_, column) in state.mesh().columns(kind(of)?) {
            if column.is_public() {
                all.set_item(column.name(), column.attribute_type().name())?;
            }
        }
        Ok(all)
    }

    /// The values of an attribute, flat, and the name of their type.
    #[pyo3(name = "_attribute")]
    fn attribute<'py>(
        &self,
        py: Python<'py>,
        of: &str,
        name: &str,
    ) -> PyResult<(Bound<'py, PyAny>, &'static str)> {
        let state = self.hold(py)?;
        let id = column_of(py, state.mesh(), kind(of)?, name)?;
        let column = state.mesh().column(id).expect("it has been found");
        Ok(flat(py, column.data()))
    }

    #[pyo3(name = "_set_attribute")]
    fn set_attribute(
        &self,
        py: Python<'_>,
        of: &str,
        name: &str,
        array: &Bound<'_, PyAny>,
        ty: &str,
    ) -> PyResult<()> {
        let can_be_in_name = |c: char| c.is_alphanumeric() || c == '_';
        if name.is_empty()
            || !name.chars().all(can_be_in_name)
            || name.starts_with(|c: char| c.is_numeric())
        {
            let message = format!("`{name}` cannot be the name of an attribute");
            return Err(saying(py, Kind::Argument, "wrong-argument", message));
        }
        if name == "position" {
            let message = "positions are no attribute: set `mesh.positions`".to_owned();
            return Err(saying(py, Kind::Argument, "wrong-argument", message));
        }
        let values = column(array, ty)?;
        let mut state = self.hold(py)?;
        let done = state.session.set_attribute(kind(of)?, name, values);
        done.map_err(|error| in_call(py, &error))
    }

    #[pyo3(name = "_remove_attribute")]
    fn remove_attribute(&self, py: Python<'_>, of: &str, name: &str) -> PyResult<()> {
        let mut state = self.hold(py)?;
        let kind = kind(of)?;
        column_of(py, state.mesh(), kind, name)?;
        state.session.remove_attribute(kind, name);
        Ok(())
    }

    /// Says that nobody has numbers of erased elements any more.
    fn recycle(&self, py: Python<'_>) -> PyResult<()> {
        self.hold(py)?.session.recycle();
        Ok(())
    }

    /// Another one that is equal, whose random numbers go on as here.
    #[pyo3(name = "_copied")]
    fn copied(&self, py: Python<'_>) -> PyResult<Self> {
        let mut state = self.hold(py)?;
        let file = state.file.clone();
        let session = &mut state.session;
        let mut session = py.detach(move || session.copy());
        session.watch(Signals::default());
        Ok(Self::of(State { session, near: Vec::new(), file }))
    }

    /// The same mesh with numbers without gaps.
    #[pyo3(name = "_compacted")]
    fn compacted(&self, py: Python<'_>) -> PyResult<Self> {
        let mut state = self.hold(py)?;
        let session = &mut state.session;
        Ok(Self::with(py.detach(move || session.copy_mesh().compacted())))
    }

    /// All of the mesh as bytes.
    #[pyo3(name = "_packed")]
    fn packed<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let mut state = self.hold(py)?;
        let session = &mut state.session;
        let bytes = py.detach(move || write_bytes(&session.copy_mesh()));
        Ok(PyBytes::new(py, &bytes))
    }

    /// The mesh of bytes.
    #[staticmethod]
    #[pyo3(name = "_unpacked")]
    fn unpacked(py: Python<'_>, bytes: &[u8]) -> PyResult<Self> {
        // Nobody writes to `bytes`, which is of the type that cannot be written.
        let mesh = py.detach(|| read_bytes(bytes));
        mesh.map(Self::with).map_err(|error| Self::no_mesh(py, error))
    }

    /// Whether the same numbers live in both, and all tables, positions and attributes agree.
    #[pyo3(name = "_is_identical")]
    fn is_identical(&self, py: Python<'_>, other: &Self) -> PyResult<bool> {
        if std::ptr::eq(self, other) {
            return Ok(true);
        }
        let (ours, theirs) = (self.hold(py)?, other.hold(py)?);
        let (ours, theirs) = (ours.mesh(), theirs.mesh());
        Ok(py.detach(|| identical_but_for_scratch(ours, theirs)))
    }

    /// Whether both are the same but for the numbers of elements.
    #[pyo3(name = "_is_same")]
    fn is_same(&self, py: Python<'_>, other: &Self, tolerance: f64) -> PyResult<bool> {
        if std::ptr::eq(self, other) {
            return Ok(true);
        }
        let (ours, theirs) = (self.hold(py)?, other.hold(py)?);
        let (ours, theirs) = (ours.mesh(), theirs.mesh());
        Ok(py.detach(|| same_up_to_renumbering(ours, theirs, tolerance)))
    }
}

impl MeshTables {
    /// Marks the state of the mesh.
    pub fn mark(&self, py: Python<'_>) -> PyResult<Mark> {
        Ok(self.hold(py)?.session.mark())
    }

    /// Ends a mark and all later ones; `keeps` tells whether what was done since stays. Returns
    /// false, and does nothing, if the mark has ended before.
    pub fn end_mark(&self, py: Python<'_>, mark: Mark, keeps: bool) -> PyResult<bool> {
        let mut state = self.hold(py)?;
        let session = &mut state.session;
        let done = py.detach(|| if keeps { session.keep(mark) } else { session.undo(mark) });
        Ok(done.is_ok())
    }
}
