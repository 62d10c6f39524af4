//! Loops over the elements of a collection, for code that does not change the mesh.
//!
//! Collections of the whole mesh are visited by index, those around an element by walking an orbit.
//! A walk takes no more steps than there are halfedges, so a broken mesh cannot make it endless. On
//! a mesh that is not a surface or not simple, an element may occur more than once: as often as the
//! walk meets it.

use super::Scope;
use super::pointer::{first, load};
use crate::diagram::{Around, Collection};
use crate::rewrite::{
    Assembler, ElementField, Elements, HalfedgeField, Inst, Label, Reg, Triangles, Walk,
};
use crate::source::Span;

/// Lowers the body of a loop for the element in the register; a jump to the label continues with
/// the next element.
pub type LoopBody<'a> = dyn FnMut(&mut Assembler, &mut dyn Scope, Reg, Label) + 'a;

/// Appends a loop over a collection, around the element in the register. `iteration` is lowered
/// once.
pub fn each(
    asm: &mut Assembler,
    scope: &mut dyn Scope,
    (collection, base): (&Collection, Option<Reg>),
    span: Span,
    iteration: &mut LoopBody,
) {
    let place = scope.place(span);
    match (collection, base) {
        (Collection::All(of), _) => each_of_mesh(asm, scope, *of, place, iteration),
        (Collection::Around(around, _), Some(base)) => {
            each_around(asm, scope, (*around, base), place, iteration);
        }
        (Collection::Around(..), None) => {}
    }
}

fn each_of_mesh(
    asm: &mut Assembler,
    scope: &mut dyn Scope,
    of: Elements,
    place: u32,
    iteration: &mut LoopBody,
) {
    let (head, next, done) = (asm.label(), asm.label(), asm.label());
    let (zero, one) = (asm.constant_int(0), asm.constant_int(1));
    let element = asm.reg();
    asm.emit(Inst::Copy { to: element, from: zero });
    asm.bind(head);
    asm.emit(Inst::NextLiving { of, element, otherwise: done });
    asm.trap_at(place, Inst::Tick);
    iteration(asm, scope, element, next);
    asm.bind(next);
    asm.emit(Inst::AddInt { to: element, left: element, right: one });
    asm.emit(Inst::Jump { to: head });
    asm.bind(done);
}

/// The value for each halfedge that the walk meets.
#[derive(Clone, Copy)]
pub enum Wanted {
    Itself,
    Pointer(HalfedgeField),
    /// Its face, if that is not a hole.
    Face,
}

fn each_around(
    asm: &mut Assembler,
    scope: &mut dyn Scope,
    (around, base): (Around, Reg),
    place: u32,
    iteration: &mut LoopBody,
) {
    let Some(orbit) = Orbit::of(around) else {
        return each_of_list(asm, scope, (around, base), place, iteration);
    };
    let (walk, element) = orbit.walk(asm, base, place);
    iteration(asm, scope, element, walk.next);
    walk.end(asm, place);
}

/// The orbit that has the elements of a collection.
#[derive(Clone, Copy)]
pub enum Orbit {
    /// The neighbors of a vertex.
    Neighbors,
    /// What each halfedge leads to.
    Halfedges(ElementField, Wanted),
}

/// A loop that walks an orbit, while its body is lowered. The body does not change pointers.
#[derive(Clone, Copy)]
pub struct OrbitWalk {
    /// The instruction that ends an iteration.
    step: Inst,
    /// The start of the next iteration.
    pub next: Label,
    /// The end of the loop.
    pub done: Label,
}

impl Orbit {
    /// The orbit around the element that a collection is around, if it is a single one.
    pub fn of(around: Around) -> Option<Self> {
        use ElementField::{Face, Vertex};
        let (of, wanted) = match around {
            Around::VertexNeighbors => return Some(Self::Neighbors),
            Around::VertexHalfedges => (Vertex, Wanted::Itself),
            Around::VertexEdges => (Vertex, Wanted::Pointer(HalfedgeField::Edge)),
            Around::VertexFaces => (Vertex, Wanted::Face),
            Around::FaceHalfedges => (Face, Wanted::Itself),
            Around::FaceVertices => (Face, Wanted::Pointer(HalfedgeField::Vertex)),
            Around::FaceEdges => (Face, Wanted::Pointer(HalfedgeField::Edge)),
            _ => return None,
        };
        Some(Self::Halfedges(of, wanted))
    }

    /// Begins a loop over the orbit around the element in the register; returns the register of the
    /// element that is visited.
    pub fn walk(self, asm: &mut Assembler, base: Reg, place: u32) -> (OrbitWalk, Reg) {
        let [again, next, done] = [(); 3].map(|()| asm.label());
        // An isolated vertex has nothing around it.
        let (element, step) = match self {
            Self::Neighbors => {
                let (vertex, slots, neighbor) = (base, asm.block(3), asm.reg());
                let begin = Inst::NeighborsBegin { vertex, slots, neighbor, otherwise: done };
                asm.trap_at(place, begin);
                asm.bind(again);
                (neighbor, Inst::NeighborsNext { slots, neighbor, again })
            }
            Self::Halfedges(of, wanted) => {
                let (from, at, turns) = (asm.reg(), asm.reg(), asm.reg());
                first(asm, place, of, [from, base]);
                let walk = if of == ElementField::Vertex { Walk::Star } else { Walk::Loop };
                asm.emit(Inst::WalkBegin { walk, from, at, turns, otherwise: done });
                asm.bind(again);
                let element = match wanted {
                    Wanted::Itself => at,
                    _ => {
                        let to = asm.reg();
                        asm.emit(Inst::Copy { to, from: at });
                        make(asm, place, wanted, to, next)
                    }
                };
                (element, Inst::WalkNext { walk, from, at, turns, again })
            }
        };
        (OrbitWalk { step, next, done }, element)
    }
}

impl OrbitWalk {
    /// Ends the loop.
    pub fn end(self, asm: &mut Assembler, place: u32) {
        asm.bind(self.next);
        asm.trap_at(place, self.step);
        asm.bind(self.done);
    }
}

/// Appends the loop for elements that are first put into a buffer.
fn each_of_list(
    asm: &mut Assembler,
    scope: &mut dyn Scope,
    (around, base): (Around, Reg),
    place: u32,
    iteration: &mut LoopBody,
) {
    let buffer = asm.buffer();
    asm.emit(Inst::BufferClear { buffer });
    let Some(wanted) = list(asm, (around, base), place, buffer) else { return };
    let (head, done) = (asm.label(), asm.label());
    let (index, halfedge) = (asm.reg(), asm.reg());
    let from = asm.constant_int(0);
    asm.emit(Inst::Copy { to: index, from });
    asm.bind(head);
    asm.emit(Inst::BufferNext { buffer, index, to: halfedge, otherwise: done });
    let element = make(asm, place, wanted, halfedge, head);
    iteration(asm, scope, element, head);
    asm.emit(Inst::Jump { to: head });
    asm.bind(done);
}

/// Fills the buffer with the corners of a face that can be cut off, or with the halfedges of an
/// edge. `None` for other collections.
fn list(
    asm: &mut Assembler,
    (around, base): (Around, Reg),
    place: u32,
    buffer: u16,
) -> Option<Wanted> {
    let mark = asm.mark();
    let wanted = match around {
        Around::FaceEars | Around::FacePatch => {
            let triangles = match around {
                Around::FacePatch => Triangles::LeastBend,
                _ => Triangles::BestShape,
            };
            asm.trap_at(place, Inst::CollectEars { triangles, buffer, face: base });
            Wanted::Itself
        }
        Around::EdgeVertices | Around::EdgeFaces => {
            let from = asm.reg();
            first(asm, place, ElementField::Edge, [from, base]);
            asm.emit(Inst::BufferPush { buffer, from });
            load(asm, place, HalfedgeField::Twin, [from, from]);
            asm.emit(Inst::BufferPush { buffer, from });
            match around {
                Around::EdgeFaces => Wanted::Face,
                _ => Wanted::Pointer(HalfedgeField::Vertex),
            }
        }
        _ => return None,
    };
    asm.release(mark);
    Some(wanted)
}

fn make(asm: &mut Assembler, place: u32, wanted: Wanted, halfedge: Reg, next: Label) -> Reg {
    match wanted {
        Wanted::Itself => {}
        Wanted::Pointer(field) => load(asm, place, field, [halfedge, halfedge]),
        Wanted::Face => {
            load(asm, place, HalfedgeField::Face, [halfedge, halfedge]);
            asm.emit(Inst::JumpUnlessLiving { of: Elements::Faces, element: halfedge, to: next });
        }
    }
    halfedge
}
