//! The loop `drain`: elements with keys that are kept current.
//!
//! A drain stores the key of each of its elements. The elements whose keys may have changed are
//! *stale*: at first all, later those that have read what was written since. At the head of each
//! iteration the keys of the stale elements are recomputed; an element whose key changes is put
//! into the queue, whether it was there before or not, and an infinite key keeps it out. So only
//! the time depends on how stale elements are found: the result is as if all keys were recomputed.
//!
//! Stale elements are found by walking back along the [`Paths`] of the key from what was written
//! or, where the key has none, by [`Readers`], which note what each key reads.

use std::sync::Arc;

use super::access::lives;
use super::drain_tables::Tables;
use super::lookahead::Lookahead;
use super::paths::{Candidates, Fields, Paths, WalkBack, Written};
use super::readers::{Place, Readers};
use super::{Elements, Message, Reg};
use crate::mesh::{ColumnId, ElementKind, HalfedgeId, Mesh};

/// The open drains, the innermost last.
#[derive(Debug, Default)]
pub(super) struct Drains {
    all: Vec<Drain>,
    /// The number of drains, from the outermost on, that are not notified of writes, since these
    /// will be undone.
    muted: usize,
    /// The number of keys that have been computed.
    computed: u32,
    /// The number of drains that are computing a key whose reads are noted.
    recording: usize,
    walk: WalkBack,
    /// The empty tables of drains of some elements that have ended, so that the next ones need no
    /// time that grows with the mesh.
    spare: Vec<Tables>,
}

/// The way in which a drain finds the elements whose keys may have changed.
#[derive(Debug)]
enum Changes {
    Noted(Box<Readers>),
    /// By walking back from what was written since the keys were computed.
    Walked {
        paths: Arc<Paths>,
        written: Vec<Written>,
    },
}

/// The number of keys that are computed between two checks of the memory that they take.
const KEYS_PER_LOOK: u32 = 1024;

/// The number of iterations without a changed key after which a drain looks no further ahead, until
/// a key changes.
const MOST_IDLE: u32 = 16;

#[derive(Debug)]
struct Drain {
    of: Elements,
    tables: Tables,
    changes: Changes,
    lookahead: Lookahead,
    /// The number of iterations since a key was computed.
    idle: u32,
    /// The element whose key is being computed.
    reading: Option<u32>,
}

impl Drain {
    /// The memory that the drain takes, in bytes.
    fn bytes(&self) -> usize {
        let changes = match &self.changes {
            Changes::Noted(readers) => readers.bytes(),
            Changes::Walked { written, .. } => written.capacity() * size_of::<Written>(),
        };
        self.tables.bytes() + changes
    }

    fn new(
        of: Elements,
        tables: Tables,
        paths: Option<Arc<Paths>>,
        columns: &[Option<ColumnId>],
    ) -> Self {
        let lookahead = Lookahead::new(paths.as_deref(), columns);
        Self {
            of,
            tables,
            changes: match paths {
                Some(paths) => Changes::Walked { paths, written: Vec::new() },
                None => Changes::Noted(Box::default()),
            },
            reading: None,
            lookahead,
            idle: 0,
        }
    }

    fn touch(&mut self, place: Place) {
        let Self { changes: Changes::Noted(readers), tables, .. } = self else { return };
        readers.take(place, |reader| tables.stale.push(reader));
        readers.take(Place::Whole, |reader| tables.stale.push(reader));
    }

    /// Notes that fields of an element are about to be written.
    fn write(&mut self, mesh: &Mesh, kind: ElementKind, id: u32, fields: Fields) {
        match &mut self.changes {
            Changes::Walked { paths, written } => {
                if paths.concern(kind, fields) {
                    written.push(Written { kind, id, fields });
                }
            }
            Changes::Noted(_) => {
                if let Some(place) = place_of(mesh, kind, id, fields) {
                    self.touch(place);
                }
            }
        }
    }

    fn is_noted(&self) -> bool {
        matches!(self.changes, Changes::Noted(_))
    }

    fn make_all_stale(&mut self, mesh: &Mesh) {
        if let Changes::Walked { written, .. } = &mut self.changes {
            written.clear();
        }
        self.tables.make_all_stale(mesh, self.of);
    }

    /// The most elements that it may have.
    fn size(&self, mesh: &Mesh) -> usize {
        self.tables.members.as_ref().map_or(mesh.capacity(self.of.kind()), Vec::len)
    }

    /// Makes the elements stale that the walk back from what was written finds. `held` returns the
    /// element that a variable holds.
    fn walk_back(&mut self, mesh: &Mesh, walk: &mut WalkBack, held: impl Fn(Reg) -> u32) {
        let most = self.size(mesh);
        let Changes::Walked { paths, written } = &mut self.changes else { return };
        if written.is_empty() {
            return;
        }
        // After more writes than there are elements, walking back takes longer than recomputing.
        if written.len() > most {
            return self.make_all_stale(mesh);
        }
        let found = walk.candidates(mesh, paths, written, held);
        written.clear();
        match found {
            Candidates::All => self.make_all_stale(mesh),
            Candidates::These(ids) => {
                for &id in ids.iter().rev() {
                    if self.is_member(mesh, id) {
                        self.tables.stale.push(id);
                    }
                }
            }
        }
    }

    fn is_member(&self, mesh: &Mesh, id: u32) -> bool {
        lives(mesh, self.of, id) && self.tables.has(id)
    }
}

impl Drains {
    /// The memory that the drains take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.all.iter().map(Drain::bytes).chain(self.spare.iter().map(Tables::bytes)).sum()
    }

    /// Whether the memory is to be checked now, after the last key.
    #[inline]
    pub(super) fn has_looked(&self) -> bool {
        self.computed.is_multiple_of(KEYS_PER_LOOK)
    }

    /// Closes all drains.
    pub(super) fn clear(&mut self) {
        self.all.clear();
        self.spare.clear();
        self.muted = 0;
        self.recording = 0;
    }

    /// Stops notifying the open drains of writes. Returns the number that were not notified before,
    /// for [`unmute`](Self::unmute).
    pub(super) fn mute(&mut self) -> usize {
        std::mem::replace(&mut self.muted, self.all.len())
    }

    /// Ends what [`mute`](Self::mute) has begun, given the number that it returned.
    pub(super) fn unmute(&mut self, muted: usize) {
        self.muted = muted;
    }

    /// The drains that are notified of writes.
    fn notified(&mut self) -> &mut [Drain] {
        self.all.get_mut(self.muted..).unwrap_or_default()
    }

    /// By kind, the fields of whose writes the drains are to be notified.
    #[cfg(feature = "native")]
    pub(super) fn listens(&self) -> [Fields; 4] {
        let mut all = [Fields::NONE; 4];
        for drain in self.all.get(self.muted..).unwrap_or_default() {
            let read = match &drain.changes {
                Changes::Noted(_) => [Fields::ALL; 4],
                Changes::Walked { paths, .. } => paths.all_read(),
            };
            all.iter_mut().zip(read).for_each(|(all, read)| all.add(read));
        }
        all
    }

    /// The number of open drains.
    pub(super) fn open_ones(&self) -> usize {
        self.all.len()
    }

    /// Closes all but the outermost `open` drains.
    pub(super) fn leave(&mut self, open: usize) {
        for Drain { mut tables, .. } in self.all.drain(open.min(self.all.len())..) {
            if tables.members.is_some() {
                tables.clear();
                self.spare.push(tables);
            }
        }
        self.count_recording();
    }

    fn count_recording(&mut self) {
        let is_recording = |drain: &&Drain| drain.reading.is_some() && drain.is_noted();
        self.recording = self.all.iter().filter(is_recording).count();
    }

    /// A single drain that notes reads, for questions outside of any loop.
    pub(super) fn alone(of: Elements) -> Self {
        Self { all: vec![Drain::new(of, Tables::default(), None, &[])], ..Self::default() }
    }

    /// Makes an element of the innermost drain stale.
    pub(super) fn make_stale(&mut self, id: u32) {
        if let Some(drain) = self.all.last_mut() {
            drain.tables.stale.push(id);
        }
    }

    /// Removes and returns the next stale element, living or not.
    pub(super) fn pop_stale(&mut self) -> Option<u32> {
        self.all.last_mut()?.tables.stale.pop()
    }

    /// Begins to note reads for an element of the innermost drain; `None` ends that.
    pub(super) fn read_for_element(&mut self, id: Option<u32>) {
        if let Some(drain) = self.all.last_mut() {
            drain.reading = id;
        }
        self.count_recording();
    }

    /// Opens a drain of all elements of the mesh, or of some, with the paths of its key, if it has
    /// any.
    pub(super) fn open(
        &mut self,
        mesh: &Mesh,
        of: Elements,
        some: Option<&[u64]>,
        paths: Option<Arc<Paths>>,
        columns: &[Option<ColumnId>],
    ) {
        let mut tables = Tables::default();
        if let Some(some) = some {
            tables = self.spare.pop().unwrap_or_default();
            tables.take(some, mesh.capacity(of.kind()));
        }
        self.all.push(Drain::new(of, tables, paths, columns));
        self.make_all_stale(mesh);
    }

    /// Closes the innermost drain.
    pub(super) fn close(&mut self) {
        self.leave(self.all.len().saturating_sub(1));
    }

    /// Makes all elements of the innermost drain stale.
    pub(super) fn make_all_stale(&mut self, mesh: &Mesh) {
        if let Some(drain) = self.all.last_mut() {
            drain.make_all_stale(mesh);
        }
    }

    /// The next element whose key is to be computed; if the drain notes reads, those that follow
    /// are noted for it. `held` returns the element that a variable holds.
    pub(super) fn next_stale(&mut self, mesh: &Mesh, held: impl Fn(Reg) -> u32) -> Option<u32> {
        let drain = self.all.last_mut()?;
        drain.walk_back(mesh, &mut self.walk, held);
        while let Some(id) = drain.tables.stale.pop() {
            let Tables { queue, stale, .. } = &drain.tables;
            stale.soon().for_each(|next| queue.prefetch_around(next));
            if drain.is_member(mesh, id) {
                drain.reading = Some(id);
                self.recording += usize::from(drain.is_noted());
                return Some(id);
            }
            drain.tables.queue.forget(id);
        }
        None
    }

    /// Whether there is a single drain, and its keys can be computed without noting reads.
    pub(super) fn takes_keys(&self) -> bool {
        matches!(self.all.as_slice(), [drain] if !drain.is_noted())
    }

    /// Sets the keys of elements of the innermost drain, each after its element. They stay stale.
    pub(super) fn set_keys(&mut self, all: &[u64]) -> Result<(), Message> {
        for pair in all.as_chunks::<2>().0 {
            if let Some(drain) = self.all.last_mut() {
                drain.reading = Some(pair[0] as u32);
            }
            self.set_key(f64::from_bits(pair[1]))?;
        }
        Ok(())
    }

    /// Makes no element of the innermost drain stale.
    pub(super) fn make_none_stale(&mut self) {
        if let Some(drain) = self.all.last_mut() {
            drain.tables.stale = Default::default();
        }
    }

    /// Sets the key of the element whose key is being computed.
    pub(super) fn set_key(&mut self, key: f64) -> Result<(), Message> {
        let Some(drain) = self.all.last_mut() else { return Err(Message::Malformed) };
        let Some(id) = drain.reading.take() else { return Err(Message::Malformed) };
        self.recording -= usize::from(drain.is_noted());
        if key.is_nan() {
            drain.reading = Some(id);
            return Err(Message::KeyNotANumber);
        }
        self.computed = self.computed.wrapping_add(1);
        drain.tables.queue.set(id, key);
        drain.idle = 0;
        Ok(())
    }

    /// The element whose key is being computed.
    pub(super) fn in_progress(&self) -> Option<(ElementKind, u32)> {
        let drain = self.all.last()?;
        Some((drain.of.kind(), drain.reading?))
    }

    /// The element of the innermost drain with the least key.
    pub(super) fn least(&mut self, mesh: &Mesh) -> Option<u32> {
        let Drain { of, tables, lookahead, idle, .. } = self.all.last_mut()?;
        let Tables { queue, stale, .. } = tables;
        // Where no key changes, the surroundings of elements are hardly used.
        if *idle < MOST_IDLE {
            *idle += 1;
            lookahead.look(mesh, *of, queue, stale);
        }
        queue.least()
    }

    /// Removes that element from the queue.
    pub(super) fn take(&mut self) {
        if let Some(drain) = self.all.last_mut()
            && let Some(id) = drain.tables.queue.least()
        {
            drain.tables.queue.remove(id);
        }
    }

    /// Whether a key is being computed whose reads are noted.
    #[inline]
    pub(super) fn is_reading(&self) -> bool {
        self.recording > 0
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Notes that a place is read.
    pub(super) fn read(&mut self, place: Place) {
        for drain in &mut self.all {
            if let (Some(reader), Changes::Noted(readers)) = (drain.reading, &mut drain.changes) {
                readers.note(place, reader);
            }
        }
    }

    /// Notifies the drains that a place is about to be written.
    pub(super) fn touch(&mut self, place: Place) {
        for drain in self.notified() {
            drain.touch(place);
        }
    }

    /// Notifies the drains that fields of an element are about to be written.
    pub(super) fn write(&mut self, mesh: &Mesh, kind: ElementKind, id: u32, fields: Fields) {
        for drain in self.notified() {
            drain.write(mesh, kind, id, fields);
        }
    }

    /// Notifies the drains of a new element. It has no key, whatever element had its number before,
    /// and belongs only to drains of all elements.
    pub(super) fn created(&mut self, mesh: &Mesh, kind: ElementKind, id: u32) {
        for drain in self.notified() {
            match drain.is_noted() {
                true => drain.touch(Place::Whole),
                false => drain.write(mesh, kind, id, Fields::ALL),
            }
            if drain.of.kind() != kind {
                continue;
            }
            drain.tables.created(id);
        }
    }

    /// Notifies the drains that a face is about to become a hole, or a hole a face.
    pub(super) fn flipped(&mut self, mesh: &Mesh, face: u32) {
        self.write(mesh, ElementKind::Face, face, Fields::HOLE);
        for drain in self.notified() {
            if drain.of.kind() == ElementKind::Face && drain.tables.members.is_none() {
                drain.tables.stale.push(face);
            }
        }
    }

    /// Notifies the drains that an element is about to be erased. Its key is kept until the next
    /// iteration, since after a rollback the element exists again.
    pub(super) fn erased(&mut self, mesh: &Mesh, kind: ElementKind, id: u32) {
        for drain in self.notified() {
            drain.write(mesh, kind, id, Fields::ALL);
            if drain.is_noted() {
                drain.write(mesh, kind, id, Fields::FIRST);
                drain.write(mesh, kind, id, Fields::ATTRIBUTES);
            }
            if drain.of.kind() == kind {
                drain.tables.stale.push(id);
            }
        }
    }
}

/// The place of some fields of an element.
fn place_of(mesh: &Mesh, kind: ElementKind, id: u32, fields: Fields) -> Option<Place> {
    let place = match fields {
        Fields::FIRST => Place::first_of(kind, id),
        _ if fields.are_attributes() => Place::attributes_of(kind, id),
        _ => Place::of(kind, id),
    };
    existing(mesh, place)
}

/// A place; `None` if it is a halfedge that does not exist.
pub(super) fn existing(mesh: &Mesh, place: Place) -> Option<Place> {
    match place {
        Place::Halfedge(id) if !mesh.halfedge_alive(HalfedgeId(id)) => None,
        _ => Some(place),
    }
}
