//! Phase 3, reassign: every pointer of every named element.

use super::attribute;
use super::collect::Collected;
use super::operation::Output;
use super::registers::{Home, Registers};
use super::run::Run;
use super::width;
use crate::check::matching::Bound;
use crate::diagram::{Access, Drawing, Edge, Kind, Loop, LoopItem, LoopKind, NameId, Ref, Spoke};
use crate::rewrite::{Cell, ElementField, HalfedgeField, Inst, Reg, Row, Span};

/// Writes phase 3.
pub(super) struct Reassign<'o, 's, 'd, 'r> {
    pub output: &'o mut Output<'s>,
    pub drawing: &'d Drawing<'d>,
    pub registers: Registers,
    pub collected: &'d Collected,
    /// Where the pointers are set.
    pub onto: Onto,
    pub rows: &'r mut Vec<Row>,
}

/// Where pointers are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Onto {
    /// On the mesh.
    Mesh,
    /// On the sheet over the mesh that guards look at.
    Preview,
}

impl Onto {
    /// The same store, there.
    fn aim(self, inst: Inst) -> Inst {
        match (self, inst) {
            (
                Onto::Preview,
                Inst::Store {
                    field,
                    halfedge,
                    value,
                },
            ) => Inst::PreviewStore {
                field,
                halfedge,
                value,
            },
            (Onto::Preview, Inst::StoreHalfedge { of, element, value }) => {
                Inst::PreviewStoreHalfedge { of, element, value }
            }
            (Onto::Preview, Inst::StoreHole { face, hole }) => {
                Inst::PreviewStoreHole { face, hole }
            }
            (
                Onto::Preview,
                Inst::StoreAll {
                    field,
                    buffer,
                    value,
                },
            ) => Inst::PreviewStoreAll {
                field,
                buffer,
                value,
            },
            (
                Onto::Preview,
                Inst::StoreSpan {
                    field,
                    span,
                    index,
                    value,
                },
            ) => Inst::PreviewStoreSpan {
                field,
                span,
                index,
                value,
            },
            (_, inst) => inst,
        }
    }
}

impl Reassign<'_, '_, '_, '_> {
    /// The code of the whole phase. All that is stored has been loaded before the first
    /// store: the selects in between read registers only.
    pub fn emit(mut self) {
        let rule = self.drawing.rule;
        let first = |orbit: &&Loop| rule.is_first(orbit.face.name);
        for orbit in rule.after.loops.iter().filter(first) {
            match orbit.each {
                true => self.orbit_around(orbit),
                false => self.for_each(orbit.face.name, |this| this.orbit(orbit)),
            }
        }
        let first = |edge: &&Edge| rule.is_first(edge.edge.name);
        for edge in rule.after.edges.iter().filter(first) {
            self.for_each(edge.edge.name, |this| this.edge(edge));
        }
        self.outer_origins();
        self.fans();
        self.vertices();
        self.assignments();
    }

    pub(super) fn word(&self, name: NameId) -> &str {
        &self.drawing.rule.name(name).text
    }

    pub(super) fn element(&mut self, name: NameId) -> Reg {
        self.registers.element(&mut self.output.asm, name)
    }

    /// Does something about a name: of a family, for each index.
    pub(super) fn for_each(&mut self, name: NameId, what: impl FnOnce(&mut Self)) {
        let repeated = self.drawing.rule.is_member(name);
        let turns = repeated.then(|| self.registers.begin_turns(&mut self.output.asm));
        what(self);
        if let Some(turns) = turns {
            self.registers.end_turns(&mut self.output.asm, turns);
        }
    }

    pub(super) fn is_path(&self, item: NameId) -> bool {
        self.drawing.rule.kind(item) == Kind::Path
    }

    fn set(&mut self, target: String, value: String, inst: Option<Inst>) {
        self.rows.push(Row::set(target, value, inst.is_some()));
        if let Some(inst) = inst {
            self.output.asm.emit(self.onto.aim(inst));
        }
    }

    /// A row `x.pointer = value`; executed unless nothing changes.
    fn pointer(&mut self, field: HalfedgeField, halfedge: NameId, value: NameId, changed: bool) {
        let pointer = match field {
            HalfedgeField::Next => "next",
            HalfedgeField::Prev => "prev",
            HalfedgeField::Twin => "twin",
            HalfedgeField::Vertex => "vertex",
            HalfedgeField::Edge => "edge",
            HalfedgeField::Face => "face",
        };
        let target = format!("{}.{pointer}", self.word(halfedge));
        let text = self.word(value).to_string();
        let (halfedge, value) = (self.element(halfedge), self.element(value));
        self.set(
            target,
            text,
            changed.then_some(Inst::Store {
                field,
                halfedge,
                value,
            }),
        );
    }

    /// The register of the first halfedge from the item at `at` on: its own, or if it is
    /// an empty path, that of what follows.
    pub(super) fn head(&mut self, items: &[NameId], at: usize) -> Reg {
        self.end_of(items, at, 1, Bound::First)
    }

    /// The register of the last halfedge up to the item at `at`.
    pub(super) fn tail(&mut self, items: &[NameId], at: usize) -> Reg {
        self.end_of(items, at, items.len() - 1, Bound::Last)
    }

    fn end_of(
        &mut self,
        items: &[NameId],
        at: usize,
        step: usize,
        end: impl Fn(NameId) -> Bound,
    ) -> Reg {
        let count = items.len();
        let places = (0..count).map(|turn| items[(at + turn * step) % count]);
        let mut ends: Vec<(Reg, Option<Reg>)> = Vec::new();
        for item in places {
            let bound = match self.is_path(item) {
                true => end(item),
                false => Bound::Element(item),
            };
            let asm = &mut self.output.asm;
            let empty = self.registers.is_empty(asm, item);
            ends.push((self.registers.bound(asm, bound), empty));
            if empty.is_none() {
                break;
            }
        }
        let (mut reg, _) = ends.pop().expect("a loop has items");
        while let Some((then, empty)) = ends.pop() {
            let condition = empty.expect("only paths that may be empty lead on");
            let to = self.output.asm.reg();
            self.output.asm.emit(Inst::Select {
                to,
                condition,
                then: reg,
                otherwise: then,
            });
            reg = to;
        }
        reg
    }

    fn orbit(&mut self, orbit: &Loop) {
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        let count = items.len();
        let ends: Vec<_> = (0..count)
            .map(|at| (self.head(&items, at), self.tail(&items, at)))
            .collect();
        for at in 0..count {
            self.item(orbit, at, ends[at].1, ends[(at + 1) % count].0);
        }
        self.face_halfedge(orbit, ends[0].0);
        self.face_kind(orbit);
    }

    /// The pointers of one item, given its end and the beginning of the next.
    pub(super) fn item(&mut self, orbit: &Loop, at: usize, tail: Reg, head: Reg) {
        let drawing = self.drawing;
        let face = orbit.face.name;
        let count = orbit.items.len();
        let item = &orbit.items[at % count];
        let (name, next) = (item.item.name, orbit.items[(at + 1) % count].item.name);
        let same = drawing.before.item_after(name) == Some(next);
        self.link(name, next, tail, head, !same);
        self.lies_in(item, face);
    }

    /// The origin and the face of one item.
    pub(super) fn lies_in(&mut self, item: &LoopItem, face: NameId) {
        let drawing = self.drawing;
        let name = item.item.name;
        if self.is_path(name) {
            self.path_face(name, face);
            return;
        }
        let origin = item.from.name;
        self.pointer(
            HalfedgeField::Vertex,
            name,
            origin,
            drawing.before.loop_origin(name) != Some(origin),
        );
        self.pointer(
            HalfedgeField::Face,
            name,
            face,
            drawing.before.face(name) != Some(face),
        );
    }

    /// `next` of what ends one item, `prev` of what begins the next.
    pub(super) fn link(&mut self, item: NameId, next: NameId, tail: Reg, head: Reg, changed: bool) {
        let last = if self.is_path(item) {
            format!("last({})", self.word(item))
        } else {
            self.word(item).into()
        };
        let first = if self.is_path(next) {
            format!("first({})", self.word(next))
        } else {
            self.word(next).into()
        };
        let (field, other) = (HalfedgeField::Next, HalfedgeField::Prev);
        let store = changed.then_some(Inst::Store {
            field,
            halfedge: tail,
            value: head,
        });
        self.set(format!("{last}.next"), first.clone(), store);
        let store = changed.then_some(Inst::Store {
            field: other,
            halfedge: head,
            value: tail,
        });
        self.set(format!("{first}.prev"), last, store);
    }

    fn path_face(&mut self, path: NameId, face: NameId) {
        let target = format!("face along {}", self.word(path));
        let store = self.store_run(HalfedgeField::Face, path, face);
        self.set(target, self.word(face).into(), store);
    }

    /// Sets a pointer of every halfedge of a run, if it was collected.
    fn store_run(&mut self, field: HalfedgeField, run: NameId, value: NameId) -> Option<Inst> {
        let rule = self.drawing.rule;
        let Run { buffer, ends } = self.collected.runs[rule.first_member(run).index()]?;
        let value = self.element(value);
        Some(match (ends, self.registers.index()) {
            (Some(ends), Some(index)) => Inst::StoreSpan {
                field,
                span: Span {
                    buffer,
                    ends,
                    shift: i16::try_from(rule.offset(run)).unwrap_or(0),
                },
                index,
                value,
            },
            _ => Inst::StoreAll {
                field,
                buffer,
                value,
            },
        })
    }

    /// A face keeps its halfedge as long as nothing has left its loop.
    pub(super) fn face_halfedge(&mut self, orbit: &Loop, head: Reg) {
        let drawing = self.drawing;
        let face = orbit.face.name;
        let keeps = drawing.before.loop_of_face(face).is_some_and(|before| {
            before
                .items
                .iter()
                .all(|item| drawing.after.face(item.item.name) == Some(face))
        });
        let first = orbit.items[0].item.name;
        let value = if self.is_path(first) {
            format!("first({})", self.word(first))
        } else {
            self.word(first).into()
        };
        let store = Inst::StoreHalfedge {
            of: ElementField::Face,
            element: self.element(face),
            value: head,
        };
        self.set(
            format!("{}.halfedge", self.word(face)),
            value,
            (!keeps).then_some(store),
        );
    }

    pub(super) fn face_kind(&mut self, orbit: &Loop) {
        let face = orbit.face.name;
        let before = self
            .drawing
            .before
            .loop_of_face(face)
            .map(|before| before.kind);
        if orbit.kind == LoopKind::Any || before == Some(orbit.kind) {
            return;
        }
        let hole = orbit.kind == LoopKind::Hole;
        let store = Inst::StoreHole {
            face: self.element(face),
            hole,
        };
        self.set(
            format!("{}.hole", self.word(face)),
            hole.to_string(),
            Some(store),
        );
    }

    fn edge(&mut self, statement: &Edge) {
        let drawing = self.drawing;
        let edge = statement.edge.name;
        let [left, right] = statement.halfedges.map(|half| half.name);
        for (half, twin) in [(left, right), (right, left)] {
            self.pointer(
                HalfedgeField::Twin,
                half,
                twin,
                drawing.before.twin(half) != Some(twin),
            );
            self.pointer(
                HalfedgeField::Edge,
                half,
                edge,
                drawing.before.edge(half) != Some(edge),
            );
        }
        let keeps = drawing.before.edge_statement(edge).is_some_and(|before| {
            before
                .halfedges
                .iter()
                .all(|half| half.name == left || half.name == right)
        });
        let (element, value) = (self.element(edge), self.element(left));
        let store = Inst::StoreHalfedge {
            of: ElementField::Edge,
            element,
            value,
        };
        let target = format!("{}.halfedge", self.word(edge));
        self.set(target, self.word(left).into(), (!keeps).then_some(store));
    }

    /// Outer halfedges start where their vertex statement, or their drawn twin, says.
    fn outer_origins(&mut self) {
        let drawing = self.drawing;
        for half in drawing.rule.names_of(Kind::Halfedge) {
            let here = drawing.rule.is_first(half) && drawing.after.mention(half).is_some();
            if !drawing.is_outer(half) || !here {
                continue;
            }
            let origin = drawing
                .origin_after(half)
                .expect("a halfedge has an origin");
            let changed = drawing.origin_before(half) != Some(origin);
            self.for_each(half, |this| {
                this.pointer(HalfedgeField::Vertex, half, origin, changed);
            });
        }
    }

    fn fans(&mut self) {
        let drawing = self.drawing;
        for fan in drawing.rule.names_of(Kind::Fan) {
            let Some(vertex) = drawing.after.star_of_spoke(fan) else {
                continue;
            };
            if !drawing.rule.is_first(fan) {
                continue;
            }
            self.for_each(fan, |this| {
                let target = format!("vertex around {}", this.word(fan));
                let store = this.store_run(HalfedgeField::Vertex, fan, vertex);
                this.set(target, this.word(vertex).into(), store);
            });
        }
    }

    /// A vertex keeps its halfedge as long as none of its spokes has left.
    fn vertices(&mut self) {
        let drawing = self.drawing;
        for vertex in drawing.rule.names_of(Kind::Vertex) {
            let drawn = drawing.after.mention(vertex).is_some();
            if !drawn || drawing.erased(vertex).is_some() || !drawing.rule.is_first(vertex) {
                continue;
            }
            self.for_each(vertex, |this| this.vertex(vertex));
        }
    }

    fn vertex(&mut self, vertex: NameId) {
        let Some((value, text)) = self.spoke_of(vertex) else {
            return;
        };
        let store = Inst::StoreHalfedge {
            of: ElementField::Vertex,
            element: self.element(vertex),
            value,
        };
        let keeps = self.keeps_its_spokes(vertex);
        self.set(
            format!("{}.halfedge", self.word(vertex)),
            text,
            (!keeps).then_some(store),
        );
    }

    fn keeps_its_spokes(&self, vertex: NameId) -> bool {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let items = rule
            .names_of(Kind::Halfedge)
            .chain(rule.names_of(Kind::Path));
        let fan_stays = |fan: NameId| drawing.after.star_of_spoke(fan) == Some(vertex);
        let stays = |item: NameId| {
            drawing.erased(item).is_none() && drawing.origin_after(item) == Some(vertex)
        };
        let mut spokes = items.filter(|&item| {
            drawing.before.mention(item).is_some() && drawing.origin_before(item) == Some(vertex)
        });
        let mut fans = rule
            .names_of(Kind::Fan)
            .filter(|&fan| drawing.before.star_of_spoke(fan) == Some(vertex));
        drawing.survives(vertex) && spokes.all(stays) && fans.all(fan_stays)
    }

    /// A halfedge that starts at the vertex after: a named spoke, the one listed first; else
    /// the first of a path that cannot be empty; else of one found not to be empty.
    fn spoke_of(&mut self, vertex: NameId) -> Option<(Reg, String)> {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let listed = drawing.after.star(vertex).and_then(|star| {
            star.spokes.iter().find_map(|spoke| match spoke {
                Spoke::Halfedge(Ref { name, .. }) => Some(*name),
                Spoke::Fan(_) | Spoke::Rest(_) => None,
            })
        });
        let starts = |item: &NameId| {
            let drawn = drawing.after.loop_of_item(*item).is_some()
                || drawing.after.pairing(*item).is_some();
            drawn && drawing.origin_after(*item) == Some(vertex)
        };
        if let Some(half) = listed.or_else(|| rule.names_of(Kind::Halfedge).find(starts)) {
            return Some((self.element(half), self.word(half).into()));
        }
        let mut paths: Vec<_> = rule.names_of(Kind::Path).filter(starts).collect();
        paths.sort_by_key(|&path| self.registers.home_of_empty(path).is_some());
        if !paths.is_empty() {
            paths.extend(drawing.paths_where_one(vertex));
        }
        let firsts: Vec<_> = paths
            .iter()
            .map(|&path| format!("first({})", self.word(path)))
            .collect();
        let first = *paths.first()?;
        let certain = self.registers.home_of_empty(first).is_none();
        if rule.is_member(first) && !certain && !rule.is_member(vertex) {
            return Some((
                self.first_around(first),
                format!("first({})", self.word(first)),
            ));
        }
        let reg = self.head(&paths, 0);
        Some((
            reg,
            if certain {
                firsts[0].clone()
            } else {
                firsts.join(" or ")
            },
        ))
    }

    fn assignments(&mut self) {
        let rule = self.drawing.rule;
        for (assignment, &home) in rule.assignments.iter().zip(&self.collected.values) {
            let target = assignment.target.name;
            if !rule.is_first(target) {
                continue;
            }
            let word = rule.attribute(assignment.attribute);
            let text = self.output.words(assignment.value.span);
            self.rows.push(Row {
                cell: Cell::Set {
                    target: format!("{}.{word}", self.word(target)),
                    value: text,
                },
                executed: true,
            });
            self.for_each(target, |this| {
                let value = this.value(home, width(assignment.value.ty));
                let element = this.element(target);
                let store = match assignment.attribute {
                    Access::Position => Inst::StorePosition {
                        vertex: element,
                        value,
                    },
                    Access::Declared(number) => Inst::StoreAttribute {
                        attribute: attribute(number),
                        element,
                        value,
                    },
                };
                this.output.asm.emit(store);
            });
        }
    }

    /// The value of an assignment.
    fn value(&mut self, home: Home, width: u16) -> Reg {
        match (home, self.registers.index()) {
            (Home::Reg(value), _) => value,
            (Home::Member { buffer, .. }, index) => {
                let index = index.unwrap_or_else(|| self.output.asm.constant_int(0));
                let to = self.output.asm.block(width);
                self.output.asm.emit(Inst::BufferGetWide {
                    buffer,
                    index,
                    width,
                    to,
                });
                to
            }
        }
    }
}
