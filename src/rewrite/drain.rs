//! The loops `drain`: elements with keys that are kept current.
//!
//! A drain knows the key of each of its elements. Those whose keys may have changed are
//! *stale*: at first all, later those that have read what was written since. At the head of
//! each turn the keys of the stale ones are computed anew; an element whose key changes comes
//! into the queue, whether it was there before or not, and an infinite key keeps it out. So
//! nothing depends on how stale ones are found, but the time: it is as if all keys were
//! computed anew.

use super::access::lives;
use super::queue::Queue;
use super::readers::{Place, Readers};
use super::{Elements, Message};
use crate::mesh::{ElementKind, HalfedgeId, Mesh};

/// The drains that run, the innermost last.
#[derive(Debug, Default)]
pub(super) struct Drains {
    all: Vec<Drain>,
    /// The first so many of them are not told what is written, since it will be undone.
    quiet: usize,
}

#[derive(Debug)]
struct Drain {
    of: Elements,
    /// By number whether an element belongs to it; `None` for all that there are, also those
    /// that are born meanwhile.
    members: Option<Vec<bool>>,
    /// By number; not a number where none is known.
    keys: Vec<f64>,
    queue: Queue,
    stale: Vec<u32>,
    is_stale: Vec<bool>,
    readers: Readers,
    /// The element whose key is being computed.
    reading: Option<u32>,
}

impl Drain {
    fn make_stale(&mut self, id: u32) {
        let index = id as usize;
        if self.is_stale.len() <= index {
            self.is_stale.resize(index + 1, false);
        }
        if !std::mem::replace(&mut self.is_stale[index], true) {
            self.stale.push(id);
        }
    }

    fn touch(&mut self, place: Place) {
        let Self { readers, stale, is_stale, .. } = self;
        let mut make_stale = |reader: u32| {
            // Whoever reads has been stale before.
            if !std::mem::replace(&mut is_stale[reader as usize], true) {
                stale.push(reader);
            }
        };
        readers.take(place, &mut make_stale);
        readers.take(Place::Whole, &mut make_stale);
    }

    /// Forgets an element that is gone; another may have its number later.
    fn forget(&mut self, id: u32) {
        if (id as usize) < self.keys.len() {
            self.queue.remove(id, &self.keys);
            self.keys[id as usize] = f64::NAN;
        }
    }

    fn is_member(&self, mesh: &Mesh, id: u32) -> bool {
        let member = |members: &Vec<bool>| members.get(id as usize) == Some(&true);
        lives(mesh, self.of, id) && self.members.as_ref().is_none_or(member)
    }
}

impl Drains {
    /// Ends all.
    pub(super) fn clear(&mut self) {
        self.all.clear();
        self.quiet = 0;
    }

    /// From here on those that are open are not told what is written. Gives how many were not.
    pub(super) fn hush(&mut self) -> usize {
        std::mem::replace(&mut self.quiet, self.all.len())
    }

    /// Ends that.
    pub(super) fn unhush(&mut self, quiet: usize) {
        self.quiet = quiet;
    }

    /// Those that are told what is written.
    fn told(&mut self) -> &mut [Drain] {
        self.all.get_mut(self.quiet..).unwrap_or_default()
    }

    /// How many are open.
    pub(super) fn open_ones(&self) -> usize {
        self.all.len()
    }

    /// Ends all but so many.
    pub(super) fn leave(&mut self, open: usize) {
        self.all.truncate(open);
    }

    /// Begins a drain of all elements of the mesh, or of some.
    pub(super) fn open(&mut self, mesh: &Mesh, of: Elements, some: Option<&[u64]>) {
        let capacity = mesh.capacity(of.kind());
        let members = some.map(|some| {
            let mut members = vec![false; capacity];
            for &id in some {
                if let Some(member) = members.get_mut(id as usize) {
                    *member = true;
                }
            }
            members
        });
        self.all.push(Drain {
            of,
            members,
            keys: Vec::new(),
            queue: Queue::default(),
            stale: Vec::new(),
            is_stale: Vec::new(),
            readers: Readers::default(),
            reading: None,
        });
        self.make_all_stale(mesh);
    }

    /// Ends the innermost.
    pub(super) fn close(&mut self) {
        self.all.pop();
    }

    /// Makes all elements of the innermost stale.
    pub(super) fn make_all_stale(&mut self, mesh: &Mesh) {
        if let Some(drain) = self.all.last_mut() {
            // The stale ones are taken from the end.
            for id in (0..mesh.capacity(drain.of.kind()) as u32).rev() {
                if drain.is_member(mesh, id) {
                    drain.make_stale(id);
                }
            }
        }
    }

    /// The next element whose key is to be computed; from here on what is read is noted.
    pub(super) fn next_stale(&mut self, mesh: &Mesh) -> Option<u32> {
        let drain = self.all.last_mut()?;
        while let Some(id) = drain.stale.pop() {
            drain.is_stale[id as usize] = false;
            if drain.is_member(mesh, id) {
                drain.reading = Some(id);
                return Some(id);
            }
            drain.forget(id);
        }
        None
    }

    /// Sets the key of that element.
    pub(super) fn set_key(&mut self, key: f64) -> Result<(), Message> {
        let Some(drain) = self.all.last_mut() else {
            return Err(Message::Malformed);
        };
        let Some(id) = drain.reading.take() else {
            return Err(Message::Malformed);
        };
        if key.is_nan() {
            return Err(Message::KeyNotANumber);
        }
        let index = id as usize;
        if drain.keys.len() <= index {
            drain.keys.resize(index + 1, f64::NAN);
        }
        if drain.keys[index] == key {
            return Ok(());
        }
        match key == f64::INFINITY {
            true => {
                drain.queue.remove(id, &drain.keys);
                drain.keys[index] = key;
            }
            false => {
                drain.keys[index] = key;
                drain.queue.put(id, &drain.keys);
            }
        }
        Ok(())
    }

    /// The element with the least key.
    pub(super) fn least(&self) -> Option<u32> {
        self.all.last()?.queue.least()
    }

    /// Takes that element out of the queue.
    pub(super) fn take(&mut self) {
        if let Some(drain) = self.all.last_mut()
            && let Some(id) = drain.queue.least()
        {
            drain.queue.remove(id, &drain.keys);
        }
    }

    /// Whether a key is being computed, so that reads are to be noted.
    #[inline]
    pub(super) fn is_reading(&self) -> bool {
        self.all.iter().any(|drain| drain.reading.is_some())
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Something at a place is read.
    pub(super) fn read(&mut self, place: Place) {
        for drain in &mut self.all {
            if let Some(reader) = drain.reading {
                drain.readers.note(place, reader);
            }
        }
    }

    /// Something at a place is about to be written.
    pub(super) fn touch(&mut self, place: Place) {
        for drain in self.told() {
            drain.touch(place);
        }
    }

    /// An element has been created. It has no key, whatever had its number before, and
    /// belongs only to drains of all elements.
    pub(super) fn born(&mut self, kind: ElementKind, id: u32) {
        for drain in self.told() {
            drain.touch(Place::Whole);
            if drain.of.kind() != kind {
                continue;
            }
            drain.forget(id);
            match drain.members.as_mut().map(|all| all.get_mut(id as usize)) {
                None => drain.make_stale(id),
                Some(Some(member)) => *member = false,
                Some(None) => {}
            }
        }
    }

    /// A face is about to become a hole, or a hole a face.
    pub(super) fn turned(&mut self, face: u32) {
        self.touch(Place::Face(face));
        for drain in self.told() {
            if drain.of.kind() == ElementKind::Face && drain.members.is_none() {
                drain.make_stale(face);
            }
        }
    }

    /// An element is about to be erased. Its key is known until the next turn, for what is
    /// rolled back lives again.
    pub(super) fn erased(&mut self, mesh: &Mesh, kind: ElementKind, id: u32) {
        if let Some(place) = place(mesh, kind, id) {
            self.touch(place);
        }
        match kind {
            ElementKind::Vertex => self.touch(Place::VertexHalfedge(id)),
            ElementKind::Face => self.touch(Place::FaceHalfedge(id)),
            ElementKind::Edge | ElementKind::Halfedge => {}
        }
        for drain in self.told() {
            if drain.of.kind() == kind {
                drain.make_stale(id);
            }
        }
    }
}

/// Where an element lies; a halfedge at its edge. `None` for a halfedge that does not live or
/// has no edge yet.
pub(super) fn place(mesh: &Mesh, kind: ElementKind, id: u32) -> Option<Place> {
    match kind {
        ElementKind::Vertex => Some(Place::Vertex(id)),
        ElementKind::Edge => Some(Place::Edge(id)),
        ElementKind::Face => Some(Place::Face(id)),
        ElementKind::Halfedge => {
            let edge = mesh.get_halfedge(HalfedgeId(id))?.edge;
            (!edge.is_none()).then_some(Place::Edge(edge.0))
        }
    }
}
