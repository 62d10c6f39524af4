//! The groups, objects and materials of faces, as they are written.
//!
//! A face of the file keeps its own. A new one gets those of the face that it was cut from: the
//! face of the file to which its halfedges belonged; if all of these are new, that of its nearest
//! neighbors with halfedges of the file, preferring neighbors that are not across such a halfedge.
//! A face that is cut into many leaves one with such a halfedge in each of its corners, and so do
//! the faces around it: the nearest one lies on the same side of what was an edge of the file.

use super::kept::{MISSING, State};
use super::mesh_file::MeshFile;
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId};

impl MeshFile {
    /// The statements that should be in force at each of the faces, where known. Empty if the file
    /// has no such statements.
    pub(super) fn states_of(&self, faces: &[FaceId]) -> Vec<Option<State>> {
        if self.kept.states.is_empty() {
            return Vec::new();
        }
        let sources = self.sources();
        let state = |f: &FaceId| {
            let place = sources[f.index()];
            (place != MISSING).then(|| self.kept.state(self.file_place(place)))
        };
        faces.iter().map(state).collect()
    }

    /// The numbers of faces without an object, and without a material, that follow one that has it:
    /// in an OBJ file, which cannot take it back, they have it too.
    pub fn overruled_faces(&self) -> [usize; 2] {
        [0, 2].map(|place| {
            let is_missing = |state: &State| state.0[place] == MISSING;
            if self.kept.states.iter().all(|(_, state)| !is_missing(state)) {
                return 0;
            }
            let states = self.states_of(&self.written_numbers().face_order);
            let follow = states.iter().flatten().skip_while(|state| is_missing(state));
            follow.filter(|state| is_missing(state)).count()
        })
    }

    /// For each slot, the face that a face was cut from, by its place among those that were read.
    fn sources(&self) -> Vec<u32> {
        let mut sources = vec![MISSING; self.mesh.capacity(ElementKind::Face)];
        let mut others = Vec::new();
        for f in self.mesh.faces().filter(|&f| !self.mesh.is_hole(f)) {
            match self.source_by_halfedges(f) {
                Some(place) => sources[f.index()] = self.own_place(f).unwrap_or(place),
                None => others.push(f),
            }
        }
        self.spread(&mut sources, others.clone());
        // The faces that are not reachable from halfedges of the file.
        others.retain(|f| sources[f.index()] == MISSING);
        for f in &others {
            sources[f.index()] = self.own_place(*f).unwrap_or(MISSING);
        }
        others.retain(|f| sources[f.index()] == MISSING);
        self.spread(&mut sources, others);
        sources
    }

    fn own_place(&self, f: FaceId) -> Option<u32> {
        self.face_place(f).map(|place| place as u32)
    }

    /// Propagates the sources of faces to their neighbors, breadth first.
    fn spread(&self, sources: &mut [u32], mut faces: Vec<FaceId>) {
        while !faces.is_empty() {
            let found = faces.iter().filter_map(|&f| {
                let source = self.next_source(f, sources)?;
                Some((f, self.own_place(f).unwrap_or(source)))
            });
            let found: Vec<(FaceId, u32)> = found.collect();
            found.iter().for_each(|&(f, place)| sources[f.index()] = place);
            faces = found.iter().flat_map(|&(f, _)| self.across(f).map(|(_, g)| g)).collect();
            faces.retain(|f| sources[f.index()] == MISSING);
            faces.sort_unstable();
            faces.dedup();
        }
    }

    /// The face of the file to which most of the halfedges of a face belonged.
    fn source_by_halfedges(&self, f: FaceId) -> Option<u32> {
        let ends = self.kept.corners.ends();
        let corners = self.mesh.face_halfedges(f).filter_map(|h| self.original_corner(h));
        let mut places: Vec<u32> =
            corners.map(|corner| ends.partition_point(|&end| end <= corner) as u32).collect();
        places.sort_unstable();
        places.chunk_by(|a, b| a == b).max_by_key(|run| run.len()).map(|run| run[0])
    }

    /// The face that a neighbor of a face was cut from.
    fn next_source(&self, f: FaceId, sources: &[u32]) -> Option<u32> {
        let known = self.across(f).filter(|(_, g)| sources[g.index()] != MISSING);
        let nearest = known.min_by_key(|&(h, _)| self.original_corner(h).is_some());
        nearest.map(|(_, g)| sources[g.index()])
    }

    /// The twins of the sides of a face that lie in faces, with these faces.
    fn across(&self, f: FaceId) -> impl Iterator<Item = (HalfedgeId, FaceId)> + '_ {
        let twins = self.mesh.face_halfedges(f).filter_map(|h| self.mesh.get_twin(h));
        let all = twins.filter_map(|twin| Some((twin, self.mesh.get_face(twin)?)));
        all.filter(|&(_, g)| self.mesh.get_is_hole(g) == Some(false))
    }
}
