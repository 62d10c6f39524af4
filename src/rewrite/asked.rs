//! Operations that are repeatedly asked at all elements, with writes to the mesh in between.
//!
//! A write makes the elements stale whose answers may depend on it, and only those are asked again.
//! They are found as the changed keys of a `drain` are: by walking back along the
//! [paths](super::paths) of the question, or, if it has none, by noting the reads of each answer.
//! How they are found affects only the time, not the results.

use std::sync::Arc;

use super::bounded::{Bounded, is_small};
use super::drain::Drains;
use super::engine::CodeKind;
use super::paths::{Candidates, Fields, WalkBack, Written as WrittenFields};
use super::readers::Place;
use super::stale::Stale;
use super::{Call, Elements, HalfedgeField, Machine, Outcome, Plan, Plans, Trap, Watch};
use crate::mesh::{ElementKind, HalfedgeRecord, Mesh, Written};

/// The elements at which an operation is asked, and what each answer depends on.
#[derive(Debug)]
pub struct Asked {
    kind: ElementKind,
    /// The number of slots that have been asked, or are stale.
    slots: usize,
    changes: Changes,
}

#[derive(Debug)]
enum Changes {
    Walked {
        question: Arc<Bounded>,
        attributes: Vec<Used>,
        written: Vec<WrittenFields>,
        stale: Stale,
        walk: WalkBack,
    },
    Noted(Drains),
}

/// An attribute of the program that the operation uses.
#[derive(Debug)]
struct Used {
    kind: ElementKind,
    name: String,
    number: u16,
    /// Whether no answer depends on it as long as its values are small.
    only_counts: bool,
}

impl Asked {
    /// Elements of a kind, none of which has been asked, with the question, if its paths are
    /// bounded, and the attributes that it may read, each with its number.
    pub fn new<'n>(
        kind: ElementKind,
        question: Option<Arc<Bounded>>,
        attributes: impl Iterator<Item = (ElementKind, &'n str, u16)>,
    ) -> Self {
        let changes = match question {
            Some(question) => Changes::Walked {
                attributes: attributes
                    .map(|(kind, name, number)| {
                        let only_counts = question.only_counts(number);
                        Used { kind, name: name.to_owned(), number, only_counts }
                    })
                    .collect(),
                question,
                written: Vec::new(),
                stale: Stale::default(),
                walk: WalkBack::default(),
            },
            None => Changes::Noted(Drains::alone(Elements::of(kind))),
        };
        Self { kind, slots: 0, changes }
    }

    /// Forgets all answers.
    pub fn forget(&mut self) {
        self.slots = 0;
        match &mut self.changes {
            Changes::Walked { written, .. } => written.clear(),
            Changes::Noted(drains) => *drains = Drains::alone(Elements::of(self.kind)),
        }
    }

    /// Forgets the slots that the mesh no longer has: they may later hold other elements.
    pub fn shrink(&mut self, mesh: &Mesh) {
        self.slots = self.slots.min(mesh.capacity(self.kind));
    }

    /// Notes a write, or that a write is about to be undone.
    pub fn note(&mut self, mesh: &Mesh, written: Written<'_>) {
        if written == Written::Column {
            return self.forget();
        }
        match &mut self.changes {
            Changes::Noted(drains) => {
                if let Some(place) = place_of(written) {
                    drains.touch(place);
                }
            }
            Changes::Walked { question, attributes, written: all, .. } => {
                let Some((kind, id, fields)) = fields_of(mesh, attributes, written) else { return };
                if question.paths.concern(kind, fields) {
                    all.push(WrittenFields { kind, id, fields });
                }
            }
        }
        if let Written::Life(kind, id) = written
            && kind == self.kind
            && (id as usize) < self.slots
        {
            self.make_stale(id);
        }
    }

    /// The next slot whose answer is not known. If the slot then gets no answer, the caller has to
    /// make it stale again. `window` has the values of the parameters.
    pub fn next_stale(&mut self, mesh: &Mesh, window: &[u64]) -> Option<u32> {
        let capacity = mesh.capacity(self.kind);
        self.walk_back(mesh, window);
        // The stack is popped from its end, so the slots come in ascending order.
        for slot in (self.slots.min(capacity)..capacity).rev() {
            self.make_stale(slot as u32);
        }
        self.slots = capacity;
        loop {
            let slot = match &mut self.changes {
                Changes::Walked { stale, .. } => stale.pop()?,
                Changes::Noted(drains) => drains.pop_stale()?,
            };
            if (slot as usize) < capacity {
                return Some(slot);
            }
        }
    }

    fn walk_back(&mut self, mesh: &Mesh, window: &[u64]) {
        let Changes::Walked { question, written, stale, walk, .. } = &mut self.changes else {
            return;
        };
        if written.is_empty() {
            return;
        }
        let held = |variable: super::Reg| {
            let slot = window.get(usize::from(variable.0));
            slot.map_or(u32::MAX, |&slot| slot as u32)
        };
        // If more was written than there are elements, walking takes longer than asking all.
        let found = match written.len() > mesh.capacity(self.kind) {
            true => Candidates::All,
            false => walk.candidates(mesh, &question.paths, written, held),
        };
        match found {
            Candidates::All => self.slots = 0,
            Candidates::These(ids) => ids.iter().for_each(|&id| stale.push(id)),
        }
        written.clear();
    }

    /// Makes a slot stale: its answer is not known.
    pub fn make_stale(&mut self, slot: u32) {
        match &mut self.changes {
            Changes::Walked { stale, .. } => stale.push(slot),
            Changes::Noted(drains) => drains.make_stale(slot),
        }
    }
}

/// The element in which something was written, and its fields.
fn fields_of(
    mesh: &Mesh,
    attributes: &[Used],
    written: Written<'_>,
) -> Option<(ElementKind, u32, Fields)> {
    Some(match written {
        Written::Pointers(halfedge, was) => {
            let fields = mesh.get_halfedge(halfedge).map_or(Fields::ALL, |now| changed(was, now));
            (ElementKind::Halfedge, halfedge.0, fields)
        }
        Written::Halfedge(kind, id) => (kind, id, Fields::FIRST),
        Written::Value(ElementKind::Face, id) => (ElementKind::Face, id, Fields::HOLE),
        Written::Value(kind, id) => (kind, id, Fields::POSITION),
        Written::Attribute(column, id, was) => {
            let name = mesh.column(column)?.name();
            let is_it = |used: &&Used| used.kind == column.kind && used.name == name;
            let used = attributes.iter().find(is_it)?;
            let are_small = || is_small(was) && mesh.value(column, id).is_some_and(is_small);
            if used.only_counts && are_small() {
                return None;
            }
            (column.kind, id, Fields::attribute(used.number))
        }
        Written::Life(kind, id) => (kind, id, Fields::ALL),
        // No answer has read a slot that did not exist.
        Written::Grown(_) | Written::Column => return None,
    })
}

/// The pointers of a halfedge that have changed.
fn changed(was: &HalfedgeRecord, now: &HalfedgeRecord) -> Fields {
    let mut fields = Fields::NONE;
    let pointers = was.pointers().into_iter().zip(now.pointers());
    for (field, (was, now)) in HalfedgeField::ALL.into_iter().zip(pointers) {
        if was != now {
            fields.add(Fields::pointer(field));
        }
    }
    fields
}

/// The place that was written, for looking up its readers.
fn place_of(written: Written<'_>) -> Option<Place> {
    Some(match written {
        Written::Pointers(halfedge, _) => Place::Halfedge(halfedge.0),
        Written::Halfedge(kind, id) => Place::first_of(kind, id),
        Written::Value(kind, id) | Written::Life(kind, id) => Place::of(kind, id),
        Written::Attribute(column, id, _) => Place::attributes_of(column.kind, id),
        Written::Grown(_) => Place::Whole,
        Written::Column => return None,
    })
}

impl Machine {
    /// Asks as [`Machine::ask`] does, at the element in a slot of `asked`: the reads of the answer
    /// are noted if the question has no paths.
    pub fn ask_again(
        &mut self,
        mesh: &mut Mesh,
        (plan, args): (&Plan, &[u64]),
        (asked, slot): (&mut Asked, u32),
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start_watched(mesh, args, watch)?;
        let plans = Plans::clone(&self.plans);
        let drains = match &mut asked.changes {
            Changes::Noted(drains) => drains,
            Changes::Walked { question, .. } => {
                let call =
                    Call { code: &question.code, kind: CodeKind::Dry, ..Call::of(plan, &plans) };
                return match self.run_native(mesh, call, watch) {
                    Some(outcome) => outcome,
                    None => self.execute::<false>(mesh, call, watch),
                };
            }
        };
        drains.read_for_element(Some(slot));
        std::mem::swap(&mut self.drains, drains);
        let outcome = self.consider(mesh, plan, Call::of(plan, &plans), watch);
        std::mem::swap(&mut self.drains, drains);
        drains.read_for_element(None);
        outcome
    }
}
