//! The interpreter loop.
//!
//! One `match` over all instructions, with an arm of a few lines each; longer implementations are
//! in files of their own. Registers are never out of range (see the window) and jumps out of the
//! code return, so the loop itself can fail only by a trap.

use super::access::{self, gone};
use super::arithmetic::{balance, direction, divide, fits, key, math, mix, modulo, round};
use super::call::{Frame, MOST_CALLS};
use super::memory::{self, Budget};
use super::observe::Scene;
use super::print::{RealText, WideText, append};
use super::question::ask;
use super::watch::{LONG_FACE, LONG_LIST};
use super::window::{Window, reserve};
use super::{
    Engine, Fault, Inst, List, Machine, Message, Outcome, Phase, Reg, Room, Trap, Triangles, Watch,
};
use super::{attribute, families, lookahead, neighbors, vectors};
use crate::mesh::{Element, ElementKind, Mesh, VertexId, difference, same_up_to_renumbering};

/// The distance up to which coordinates of meshes count as equal.
const NEAR: f64 = 1e-9;

/// The next instruction, and the refusal noted so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    pub(super) at: usize,
    pub(super) noted: Option<(Phase, u16)>,
    /// The number of instructions to execute, if not all.
    pub(super) steps: usize,
}

/// Evaluates to the value, or breaks out of the loop with the message.
macro_rules! or_trap {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(fault) => break Message::from(fault),
        }
    };
}

impl Machine {
    /// Runs the code of a call from its start. Drains may run in it only if `OBSERVED`.
    pub(super) fn execute<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        call: super::Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.clear_buffers(&call);
        self.execute_from::<OBSERVED, false>(mesh, call, &mut Place::default(), watch)
    }

    /// Runs the code of a call from a place on; or, if `STEP`, executes `place.steps` instructions,
    /// which neither call a function nor end the code, and sets `place` to where the code
    /// continues.
    pub(super) fn execute_from<const OBSERVED: bool, const STEP: bool>(
        &mut self,
        mesh: &mut Mesh,
        mut call: super::Call<'_>,
        place: &mut Place,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        use Inst::*;
        let mut insts = call.code.insts.as_slice();
        let mut returns: Vec<Frame> = Vec::new();
        let Place { mut at, mut noted, mut steps } = *place;
        let Some(mut w) = Window::at(&mut self.stack, call.base) else {
            return Err(Trap::new(Message::Malformed));
        };
        // The stack may have moved.
        macro_rules! look_again {
            () => {
                match Window::at(&mut self.stack, call.base) {
                    Some(window) => w = window,
                    None => break Message::Malformed,
                }
            };
        }
        macro_rules! buffer {
            ($buffer:expr) => {
                match self.buffers.get_mut(call.buffers + usize::from($buffer)) {
                    Some(buffer) => buffer,
                    None => break Message::Malformed,
                }
            };
        }
        macro_rules! budget {
            () => {
                Budget { buffers: &self.buffers, drains: &self.drains, limit: self.memory }
            };
        }
        macro_rules! make_room {
            ($buffer:expr, $more:expr) => {{
                let at = call.buffers + usize::from($buffer);
                let limit = (&*mesh, &self.drains, self.memory);
                or_trap!(memory::for_list(&mut self.buffers, at, $more, limit));
            }};
        }
        macro_rules! create {
            ($kind:expr) => {{
                let drains = OBSERVED.then_some(&mut self.drains);
                access::create(mesh, $kind, &mut self.created, drains)
            }};
        }
        macro_rules! refuse {
            ($refusal:expr, $otherwise:expr) => {{
                call.note(&mut noted, $refusal);
                at = $otherwise.0 as usize;
            }};
        }
        // The running function returns to its caller.
        macro_rules! come_back {
            () => {
                let Some(back) = returns.pop() else {
                    return Ok(Outcome::Applied { result: None });
                };
                let (base, from, width) = self.given;
                self.pass(base, from, back.base + usize::from(back.to.0), width);
                self.holding -= u32::from(back.holds);
                back.give_back(&mut call);
                (insts, at) = (call.code.insts.as_slice(), back.at);
                look_again!();
            };
        }
        // When a loop has run long enough, native code takes over the rest of the running code.
        macro_rules! go_on_native {
            () => {
                if !STEP && self.engine == Engine::Native && !self.is_dry && call.has_looped() {
                    let place = Place { at, noted, steps: 0 };
                    self.frames += returns.len();
                    let done = self.go_on_native(mesh, call, place, watch);
                    self.frames -= returns.len();
                    match done {
                        // The machine still has to run it.
                        None => look_again!(),
                        Some(Err(trap)) => return Err(trap.through_callers(&call, &returns)),
                        Some(Ok(Outcome::Applied { .. })) if !returns.is_empty() => {
                            come_back!();
                        }
                        Some(outcome) => return outcome,
                    }
                }
            };
        }
        let message = loop {
            let Some(inst) = insts.get(at) else {
                if returns.is_empty() {
                    return Ok(Outcome::Applied { result: None });
                }
                break Message::Malformed;
            };
            at += 1;
            if OBSERVED && self.is_dry && (inst.writes() || matches!(inst, Return { .. })) {
                self.stopped_at = at;
                return Ok(Outcome::Applied { result: None });
            }
            let wants_writes = || !self.drains.is_empty() && inst.is_observed_write();
            if OBSERVED && (self.drains.is_reading() || wants_writes()) {
                let scene = Scene {
                    mesh,
                    w: &w,
                    buffers: self.buffers.get(call.buffers..).unwrap_or_default(),
                    columns: &self.columns,
                };
                self.drains.observe_write(inst, &scene);
                if self.drains.is_reading() {
                    self.drains.observe_read(inst, &scene);
                }
            }
            match *inst {
                // Values.
                Const { to, bits } => w.set_bits(to, bits),
                Copy { to, from } => w.set_bits(to, w.bits(from)),
                CopyVec { to, from } => w.set_vector(to, w.vector(from)),
                Select { to, condition, then, otherwise } => {
                    let from = if w.truth(condition) { then } else { otherwise };
                    w.set_bits(to, w.bits(from));
                }
                Not { to, from } => w.set_truth(to, !w.truth(from)),
                And { to, left, right } => w.set_truth(to, w.truth(left) & w.truth(right)),
                Or { to, left, right } => w.set_truth(to, w.truth(left) | w.truth(right)),
                Equal { to, left, right } => w.set_truth(to, w.bits(left) == w.bits(right)),
                AddInt { to, left, right } => {
                    w.set_int(to, or_trap!(fits(w.int(left).checked_add(w.int(right)))));
                }
                SubInt { to, left, right } => {
                    w.set_int(to, or_trap!(fits(w.int(left).checked_sub(w.int(right)))));
                }
                MulInt { to, left, right } => {
                    w.set_int(to, or_trap!(fits(w.int(left).checked_mul(w.int(right)))));
                }
                DivInt { to, left, right } => {
                    w.set_int(to, or_trap!(divide(w.int(left), w.int(right))));
                }
                ModInt { to, left, right } => {
                    w.set_int(to, or_trap!(modulo(w.int(left), w.int(right))));
                }
                NegInt { to, from } => w.set_int(to, or_trap!(fits(w.int(from).checked_neg()))),
                AbsInt { to, from } => w.set_int(to, or_trap!(fits(w.int(from).checked_abs()))),
                MinInt { to, left, right } => w.set_int(to, w.int(left).min(w.int(right))),
                MaxInt { to, left, right } => w.set_int(to, w.int(left).max(w.int(right))),
                LessInt { to, left, right } => w.set_truth(to, w.int(left) < w.int(right)),
                LessEqualInt { to, left, right } => w.set_truth(to, w.int(left) <= w.int(right)),
                IntToReal { to, from } => w.set_real(to, w.int(from) as f64),
                IntToKey { to, from } => w.set_real(to, or_trap!(key(w.int(from)))),
                RoundReal { to, from } => w.set_int(to, or_trap!(round(w.real(from)))),
                AddReal { to, left, right } => w.set_real(to, w.real(left) + w.real(right)),
                SubReal { to, left, right } => w.set_real(to, w.real(left) - w.real(right)),
                MulReal { to, left, right } => w.set_real(to, w.real(left) * w.real(right)),
                DivReal { to, left, right } => w.set_real(to, w.real(left) / w.real(right)),
                MinReal { to, left, right } => w.set_real(to, w.real(left).min(w.real(right))),
                MaxReal { to, left, right } => w.set_real(to, w.real(left).max(w.real(right))),
                PowReal { to, left, right } => w.set_real(to, w.real(left).powf(w.real(right))),
                Atan2Real { to, left, right } => w.set_real(to, w.real(left).atan2(w.real(right))),
                LessReal { to, left, right } => w.set_truth(to, w.real(left) < w.real(right)),
                LessEqualReal { to, left, right } => w.set_truth(to, w.real(left) <= w.real(right)),
                EqualReal { to, left, right } => w.set_truth(to, w.real(left) == w.real(right)),
                MathReal { math: f, to, from } => w.set_real(to, math(f, w.real(from))),
                AddVec { to, left, right } => w.set_vector(to, w.vector(left) + w.vector(right)),
                SubVec { to, left, right } => w.set_vector(to, w.vector(left) - w.vector(right)),
                MulVec { to, left, right } => w.set_vector(to, w.vector(left) * w.vector(right)),
                NegVec { to, from } => w.set_vector(to, -w.vector(from)),
                ScaleVec { to, left, right } => w.set_vector(to, w.vector(left) * w.real(right)),
                DivVec { to, left, right } => w.set_vector(to, w.vector(left) / w.real(right)),
                MixVec { to, left, right, t } => {
                    w.set_vector(to, mix(w.vector(left), w.vector(right), w.real(t)));
                }
                EqualVec { to, left, right } => w.set_truth(to, w.vector(left) == w.vector(right)),
                Dot { to, left, right } => w.set_real(to, w.vector(left).dot(w.vector(right))),
                Cross { to, left, right } => {
                    w.set_vector(to, w.vector(left).cross(w.vector(right)));
                }
                LengthVec { to, from } => w.set_real(to, w.vector(from).length()),
                Normalize { to, from } => w.set_vector(to, direction(w.vector(from))),
                Balance { to, from } => w.set_vector(to, balance(w.vector(from))),
                CopyWide { to, from, width } => vectors::copy(&mut w, to, from, width),
                Wide { operation, width, to, left, right } => {
                    vectors::lanes(&mut w, operation, width, [to, left, right])
                }
                Matrix { operation, size, to, left, right } => {
                    vectors::matrix(&mut w, operation, size, [to, left, right])
                }

                Random { to } => w.set_real(to, self.random.real()),
                RandomInt { to, below } => {
                    let bound = w.int(below);
                    let chosen = or_trap!(self.chosen_below(bound));
                    look_again!();
                    w.set_int(to, chosen);
                }
                BufferShuffle { buffer } => {
                    let mut slots: List = std::mem::take(buffer!(buffer));
                    self.random.shuffle(&mut slots);
                    *buffer!(buffer) = slots;
                }

                // Loads.
                Load { field, to, halfedge } => {
                    let id = w.id(halfedge);
                    match access::pointer_of(mesh, field, id) {
                        Some(pointer) => w.set_id(to, pointer),
                        None => break gone(ElementKind::Halfedge, id).into(),
                    }
                }
                LoadHalfedge { of, to, element } => {
                    w.set_id(to, or_trap!(access::load_halfedge(mesh, of, w.id(element))));
                }
                LoadHole { to, face } => {
                    w.set_truth(to, mesh.is_hole(or_trap!(access::face(mesh, w.id(face)))));
                }
                LoadPosition { to, vertex } => {
                    let id = w.id(vertex);
                    let Some(position) = mesh.get_position(VertexId(id)) else {
                        break gone(ElementKind::Vertex, id).into();
                    };
                    w.set_vector(to, position);
                }
                LoadAttribute { attribute, to, element } => {
                    let column = or_trap!(attribute::column(&self.columns, attribute));
                    or_trap!(attribute::load(mesh, column, w.id(element), &mut w, to));
                }
                Capacity { kind, to } => w.set_int(to, mesh.capacity(kind) as i64),
                NextLiving { of, element, otherwise } => {
                    match access::next_living(mesh, of, w.bits(element)) {
                        Some(id) => w.set_id(element, id),
                        None => at = otherwise.0 as usize,
                    }
                }
                JumpUnlessLiving { of, element, to } => {
                    if !access::lives(mesh, of, w.id(element)) {
                        at = to.0 as usize;
                    }
                }
                Alive { kind, to, element } => w.set_truth(to, mesh.is_alive(kind, w.id(element))),

                // Questions.
                Ask { question, to, elements: [first, second] } => {
                    or_trap!(ask(mesh, question, &mut w, [to, first, second]))
                }
                Count { kind, to } => w.set_int(to, mesh.count(kind) as i64),
                CountHoles { to } => w.set_int(to, mesh.hole_count() as i64),

                // Jumps.
                Jump { to } => at = to.0 as usize,
                JumpIf { condition, to } => {
                    if w.truth(condition) {
                        at = to.0 as usize;
                    }
                }
                JumpUnless { condition, to } => {
                    if !w.truth(condition) {
                        at = to.0 as usize;
                    }
                }
                JumpUnequal { left, right, to } => {
                    if w.bits(left) != w.bits(right) {
                        at = to.0 as usize;
                    }
                }
                JumpEqual { left, right, to } => {
                    if w.bits(left) == w.bits(right) {
                        at = to.0 as usize;
                    }
                }

                // Matching.
                ExpectEqual { left, right, refusal, otherwise } => {
                    if w.bits(left) != w.bits(right) {
                        refuse!(refusal, otherwise);
                    }
                }
                ExpectDistinct { left, right, refusal, otherwise } => {
                    if w.bits(left) == w.bits(right) {
                        refuse!(refusal, otherwise);
                    }
                }
                Expect { condition, refusal, otherwise } => {
                    if !w.truth(condition) {
                        refuse!(refusal, otherwise);
                    }
                }
                ExpectFinite { vector, refusal, otherwise } => {
                    if !w.vector(vector).is_finite() {
                        refuse!(refusal, otherwise);
                    }
                }
                ExpectRoom { room, refusal, otherwise } => {
                    let Room { vertices, halfedges, edges, faces } = room;
                    let [v, h, e, f] = [vertices, halfedges, edges, faces].map(usize::from);
                    match mesh.can_add(v, h, e, f) {
                        true => or_trap!(memory::for_elements(mesh, [v, h, e, f], &budget!())),
                        false => refuse!(refusal, otherwise),
                    }
                }
                Collect { walk, buffer, from, until, whole } => {
                    let ends = [w.id(from), w.id(until)];
                    if whole || ends[0] != ends[1] {
                        or_trap!(access::collect(mesh, walk, ends, &mut buffer!(buffer).grow()));
                    }
                }
                CollectEars { triangles, buffer, face } => {
                    let face = or_trap!(access::face(mesh, w.id(face)));
                    let order = match triangles {
                        Triangles::BestShape => mesh.ears(face),
                        Triangles::LeastBend => mesh.patch(face),
                    };
                    let is_long = order.len() >= LONG_FACE;
                    buffer!(buffer).grow().extend(order.into_iter().map(|h| u64::from(h.0)));
                    if is_long && watch.tick().is_break() {
                        break Message::Interrupted;
                    }
                }
                Meets { walk, to, from, goal, stop } => {
                    let ends = [w.id(goal), w.id(stop)];
                    w.set_truth(to, or_trap!(access::meets(mesh, walk, w.id(from), ends)));
                }
                NextIndex { buffer, index, otherwise } => {
                    let next = w.int(index).wrapping_add(1);
                    match usize::try_from(next) {
                        Ok(place) if place < buffer!(buffer).len() => w.set_int(index, next),
                        _ => at = otherwise.0 as usize,
                    }
                }
                Member { buffer, index, shift, to } => {
                    let members = buffer!(buffer);
                    let place = or_trap!(families::place(members.len(), w.int(index), shift));
                    w.set_bits(to, members[place]);
                }
                BufferGetWide { buffer, index, width, to } => {
                    let width = usize::from(width);
                    let index = usize::try_from(w.int(index)).unwrap_or(usize::MAX);
                    let start = index.saturating_mul(width);
                    let Some(slots) = buffer!(buffer).get(start..start.saturating_add(width))
                    else {
                        break Message::OutOfRange;
                    };
                    for (part, &bits) in (0..).zip(slots) {
                        w.set_bits(to.part(part), bits);
                    }
                }
                BufferNew { .. } | BufferAppend { .. } | BufferStride { .. } => {
                    let filled = self.fill(mesh, call.buffers, inst);
                    look_again!();
                    or_trap!(filled);
                }
                ExpectAllDistinct { buffer, refusal, otherwise } => {
                    if !families::are_distinct(buffer!(buffer)) {
                        refuse!(refusal, otherwise);
                    }
                }
                ExpectRoomFor { kind, count, refusal, otherwise } => {
                    let count = usize::try_from(w.int(count)).unwrap_or(usize::MAX);
                    match access::has_room(mesh, kind, count) {
                        true => or_trap!(memory::for_kind(mesh, (kind, count), &budget!())),
                        false => refuse!(refusal, otherwise),
                    }
                }
                WalkBegin { walk: _, from, at: place, turns, otherwise } => match w.id(from) {
                    u32::MAX => at = otherwise.0 as usize,
                    from => {
                        w.set_id(place, from);
                        w.set_int(turns, 0);
                    }
                },
                WalkNext { walk, from, at: place, turns, again } => {
                    let next = or_trap!(access::step(mesh, walk, w.id(place)));
                    if next != w.id(from) {
                        let turn = w.int(turns).wrapping_add(1);
                        if turn >= mesh.capacity(ElementKind::Halfedge) as i64 {
                            break Message::from(Fault::Endless);
                        }
                        w.set_id(place, next);
                        w.set_int(turns, turn);
                        at = again.0 as usize;
                    }
                }
                NeighborsBegin { vertex, slots, neighbor, otherwise } => {
                    let lists = self.neighbors.as_deref();
                    match or_trap!(neighbors::begin(mesh, lists, &mut w, [vertex, slots])) {
                        Some(first) => w.set_id(neighbor, first),
                        None => at = otherwise.0 as usize,
                    }
                }
                NeighborsNext { slots, neighbor, again } => {
                    let lists = self.neighbors.as_deref();
                    if let Some(next) = or_trap!(neighbors::next(mesh, lists, &mut w, slots)) {
                        w.set_id(neighbor, next);
                        at = again.0 as usize;
                    }
                }
                MeetsAll { walk, to, buffer } => {
                    let met = or_trap!(families::meets_all(mesh, walk, buffer!(buffer)));
                    w.set_truth(to, met);
                }
                PreviewClear => {
                    self.preview.clear();
                    self.preview.listen(OBSERVED && self.drains.is_reading());
                }
                PreviewNew { to } => w.set_id(to, self.preview.add()),
                PreviewStore { field, halfedge, value } => {
                    let (halfedge, value) = (w.id(halfedge), w.id(value));
                    or_trap!(self.preview.store(mesh, field, halfedge, value));
                }
                PreviewStoreHalfedge { of, element, value } => {
                    let (element, value) = (w.id(element), w.id(value));
                    or_trap!(self.preview.store_halfedge(mesh, of, element, value));
                }
                PreviewStoreHole { face, hole } => {
                    or_trap!(self.preview.store_hole(mesh, w.id(face), hole));
                }
                PreviewStoreAll { field, buffer, value } => {
                    let halfedges = buffer!(buffer);
                    let all = self.preview.store_all(mesh, field, halfedges, w.id(value));
                    or_trap!(all);
                }
                Foresee { condition, to, element, at: place } => {
                    let (element, place) = (w.id(element), w.id(place));
                    let holds = self.preview.foresees(mesh, condition, element, place);
                    w.set_truth(to, or_trap!(holds));
                }
                ForeseeAlong { condition, to, buffer } => {
                    let halfedges = buffer!(buffer);
                    let holds = self.preview.foresees_along(mesh, condition, halfedges);
                    w.set_truth(to, or_trap!(holds));
                }
                PreviewUndo => {
                    self.preview.undo(mesh);
                    if OBSERVED {
                        self.drains.foreseen(mesh, &self.preview.looked());
                    }
                }
                Refuse => {
                    let reason = noted.map(|(_, reason)| reason);
                    return Ok(Outcome::Refused { reason });
                }
                Return { result } => {
                    let result = result.map(|result| w.id(result));
                    return Ok(Outcome::Applied { result });
                }

                // Buffers.
                BufferClear { buffer } => buffer!(buffer).clear(),
                BufferFree { buffer } => *buffer!(buffer) = List::default(),
                BufferPush { buffer, from } => {
                    make_room!(buffer, 1);
                    buffer!(buffer).grow().push(w.bits(from));
                }
                BufferLength { buffer, to } => w.set_int(to, buffer!(buffer).len() as i64),
                BufferGet { buffer, to, index } => {
                    let index = usize::try_from(w.int(index)).unwrap_or(usize::MAX);
                    let Some(&bits) = buffer!(buffer).get(index) else { break Message::OutOfRange };
                    w.set_bits(to, bits);
                }
                BufferNext { buffer, index, to, otherwise } => {
                    let place = w.bits(index);
                    match buffer!(buffer).get(place as usize) {
                        Some(&bits) => {
                            w.set_bits(to, bits);
                            w.set_bits(index, place + 1);
                        }
                        None => at = otherwise.0 as usize,
                    }
                }
                Prefetch { of, buffer, index } => {
                    lookahead::prefetch(mesh, of.kind(), buffer!(buffer), w.bits(index));
                }
                BufferLiving { of, buffer } => {
                    make_room!(buffer, mesh.count(of.kind()));
                    access::collect_living(mesh, of, &mut buffer!(buffer).grow());
                    if mesh.capacity(of.kind()) >= LONG_LIST && watch.tick().is_break() {
                        break Message::Interrupted;
                    }
                }

                // Writes.
                New { kind, to } => w.set_id(to, or_trap!(create!(kind))),
                Store { field, halfedge, value } => {
                    or_trap!(access::store(mesh, field, w.id(halfedge), w.id(value)))
                }
                StoreHalfedge { of, element, value } => {
                    or_trap!(access::store_halfedge(mesh, of, w.id(element), w.id(value)));
                }
                StoreHole { face, hole } => {
                    let f = or_trap!(access::face(mesh, w.id(face)));
                    mesh.set_hole(f, hole);
                }
                StorePosition { vertex, value } => {
                    let (v, position) =
                        or_trap!(access::place(mesh, w.id(vertex), w.vector(value)));
                    mesh.set_position(v, position);
                }
                DeferPosition { buffer, vertex, value } => {
                    let (v, position) =
                        or_trap!(access::place(mesh, w.id(vertex), w.vector(value)));
                    make_room!(buffer, memory::HELD);
                    attribute::hold_position(v, position, &mut buffer!(buffer).grow());
                }
                StoreAttribute { attribute, element, value } => {
                    let column = or_trap!(attribute::column(&self.columns, attribute));
                    or_trap!(attribute::store(mesh, column, w.id(element), &w, value));
                }
                DeferAttribute { buffer, attribute, element, value } => {
                    let column = or_trap!(attribute::column(&self.columns, attribute));
                    let target = (attribute, w.id(element));
                    make_room!(buffer, memory::HELD);
                    let held = &mut buffer!(buffer).grow();
                    or_trap!(attribute::hold(mesh, column, target, &w, value, held));
                }
                WriteDeferred { buffer } => {
                    let held = &mut buffer!(buffer).grow();
                    or_trap!(attribute::release(mesh, &self.columns, held));
                }
                StoreAll { field, buffer, value } => {
                    or_trap!(access::store_all(mesh, field, buffer!(buffer), w.id(value)))
                }
                StoreSpan { field, span, index, value } => {
                    let ends: List = std::mem::take(buffer!(span.ends));
                    let part = families::part(buffer!(span.buffer), &ends, w.int(index), span);
                    or_trap!(access::store_all(mesh, field, or_trap!(part), w.id(value)));
                    *buffer!(span.ends) = ends;
                }
                PreviewStoreSpan { field, span, index, value } => {
                    let ends: List = std::mem::take(buffer!(span.ends));
                    let part = families::part(buffer!(span.buffer), &ends, w.int(index), span);
                    let part = or_trap!(part);
                    or_trap!(self.preview.store_all(mesh, field, part, w.id(value)));
                    *buffer!(span.ends) = ends;
                }
                Erase { kind, element } => or_trap!(access::erase(mesh, kind, w.id(element))),
                Recycle => {
                    if self.holding == 0 && !self.is_beside_others {
                        mesh.recycle();
                    }
                }

                // Drains.
                DrainOpen { of, members } => {
                    let members = match members {
                        Some(buffer) => Some(&**buffer!(buffer)),
                        None => None,
                    };
                    let paths = self.paths.of(&call, at - 1);
                    self.drains.open(mesh, of, members, paths, &self.columns);
                    if budget!().is_passed(mesh) {
                        break Message::NoMemory(self.memory);
                    }
                }
                DrainAllStale => self.drains.make_all_stale(mesh),
                DrainStale { to, otherwise } => {
                    match self.drains.next_stale(mesh, |variable| w.id(variable)) {
                        Some(id) => w.set_id(to, id),
                        None => at = otherwise.0 as usize,
                    }
                }
                DrainKey { key } => {
                    or_trap!(self.drains.set_key(w.real(key)));
                    if self.drains.has_looked() && budget!().is_passed(mesh) {
                        break Message::NoMemory(self.memory);
                    }
                }
                DrainLeast { to, otherwise } => match self.drains.least(mesh) {
                    Some(id) => w.set_id(to, id),
                    None => at = otherwise.0 as usize,
                },
                DrainTake => self.drains.take(),
                DrainClose => self.drains.close(),

                // Calls.
                Call { function, args, to, holds } => {
                    let Some(called) = call.functions.get(usize::from(function)) else {
                        break Message::Malformed;
                    };
                    if self.frames + returns.len() >= MOST_CALLS {
                        break Message::TooDeep;
                    }
                    if !STEP && self.is_native_due(mesh, &call, (function, called)) {
                        self.frames += returns.len();
                        let done = self.call_function(mesh, &call, at - 1, watch);
                        self.frames -= returns.len();
                        match done {
                            Ok(Outcome::Applied { .. }) => {}
                            Ok(refused) => return Ok(refused),
                            Err(trap) => return Err(trap.through_callers(&call, &returns)),
                        }
                        look_again!();
                        continue;
                    }
                    if self.progress.tick(watch).is_break() {
                        break Message::Interrupted;
                    }
                    returns.push(Frame::of(&call, at, to, holds));
                    let base = call.base;
                    call.enter(function, called);
                    self.pass(base, args, call.base, called.params);
                    self.clear_buffers(&call);
                    self.holding += u32::from(holds);
                    (insts, at) = (called.code.insts.as_slice(), 0);
                    look_again!();
                }
                ReturnValue { from, width } => {
                    self.given = (call.base, from, width);
                    come_back!();
                }

                // Operations, progress and output.
                Apply { op, args, applied, result } => {
                    let outcome = match self.call::<OBSERVED>(mesh, &call, [op, args.0], watch) {
                        Ok(outcome) => outcome,
                        Err(trap) => return Err(trap.through_all(&call, at - 1, &returns)),
                    };
                    look_again!();
                    match outcome {
                        Outcome::Applied { result: made } => {
                            w.set_truth(applied, true);
                            if let Some(made) = made {
                                w.set_id(result, made);
                            }
                        }
                        Outcome::Refused { .. } => w.set_truth(applied, false),
                    }
                }
                Try { op, args, to, why } => {
                    let outcome = match self.attempt(mesh, &call, [op, args.0], watch) {
                        Ok(outcome) => outcome,
                        Err(trap) => return Err(trap.through_all(&call, at - 1, &returns)),
                    };
                    let reason = why.then(|| self.reason_of(op, outcome).to_owned());
                    let text = reason.map(|reason| self.interner.number(call.texts, &reason));
                    look_again!();
                    match text {
                        Some(text) => w.set_id(to, text),
                        None => w.set_truth(to, matches!(outcome, Outcome::Applied { .. })),
                    }
                }
                Refused { op } => match call.steps {
                    Some(steps) => {
                        let reason = self.last_refusal.and_then(|(_, reason)| reason);
                        let reason = steps.refusal_of(op, reason);
                        return Ok(Outcome::Refused { reason });
                    }
                    None => break self.must_not_refuse(op),
                },
                Iteration { depth, done, total } => {
                    let (done, total) = (w.int(done), w.int(total));
                    if self.progress.iteration(watch, depth, done, total).is_break() {
                        break Message::Interrupted;
                    }
                    if self.progress.has_polled() && budget!().is_passed(mesh) {
                        break Message::NoMemory(self.memory);
                    }
                    go_on_native!();
                }
                Tick => {
                    if self.progress.tick(watch).is_break() {
                        break Message::Interrupted;
                    }
                    go_on_native!();
                }
                Spread { part, end } => {
                    let frames = self.frames + returns.len();
                    match self.spread(mesh, &call, (part, frames), watch) {
                        Some(Ok(())) => at = end.0 as usize,
                        Some(Err(trap)) => return Err(trap.through_callers(&call, &returns)),
                        None => {}
                    }
                    look_again!();
                }
                Keep { from } => {
                    // Room for all has been reserved.
                    if self.kept.len() == self.kept.capacity() {
                        break Message::NoMemory(self.memory);
                    }
                    self.kept.grow().push(w.bits(from));
                }
                PrintText { text } => match call.texts.get(text as usize) {
                    Some(text) => self.line.push_str(text),
                    None => break Message::Malformed,
                },
                PrintTextOf { from } => match self.interner.text(call.texts, w.id(from)) {
                    Some(text) => self.line.push_str(text),
                    None => break Message::Malformed,
                },
                PrintBool { from } => append(&mut self.line, w.truth(from)),
                PrintInt { from } => append(&mut self.line, w.int(from)),
                PrintReal { from, digits } => {
                    append(&mut self.line, RealText(w.real(from), digits));
                }
                PrintWide { from, size, columns, digits } => append(
                    &mut self.line,
                    WideText(vectors::columns(&w, from, size, columns), digits),
                ),
                ExpectAlive { kind, from } => {
                    or_trap!(access::expect_alive(mesh, kind, w.id(from)))
                }
                PrintElement { kind, from } => {
                    append(&mut self.line, Element { kind, index: w.id(from) });
                }
                PrintEnd => {
                    watch.print(&self.line);
                    self.line.clear();
                }
                PrintReason { op } => {
                    let reason = self.last_reason(op).unwrap_or_default().to_owned();
                    self.line.push_str(&reason);
                    look_again!();
                }
                RefusedFor { op, text, to } => {
                    let reason = self.last_reason(op);
                    let wanted = call.texts.get(text as usize).map(String::as_str);
                    let same = reason.is_some() && reason == wanted;
                    look_again!();
                    w.set_truth(to, same);
                }
                MeshKeep { mesh: number } => match self.meshes.get_mut(usize::from(number)) {
                    Some(kept) => kept.clone_from(mesh),
                    None => break Message::Malformed,
                },
                PrintDifference { mesh: number } => match self.meshes.get(usize::from(number)) {
                    Some(kept) => append(&mut self.line, difference(mesh, kept, NEAR)),
                    None => break Message::Malformed,
                },
                MeshSame { mesh: number, to } => match self.meshes.get(usize::from(number)) {
                    Some(kept) => w.set_truth(to, same_up_to_renumbering(mesh, kept, NEAR)),
                    None => break Message::Malformed,
                },
                FailShowing { text } => {
                    let values = std::mem::take(&mut self.line);
                    break match call.texts.get(text as usize).cloned() {
                        Some(message) => Message::Asserted { message, values },
                        None => Message::Malformed,
                    };
                }
                Fail { text, around } => {
                    let Some(mut text) = call.texts.get(text as usize).cloned() else {
                        break Message::Malformed;
                    };
                    if let Some((kind, element)) = around {
                        append(&mut text, " around ");
                        append(&mut text, Element { kind, index: w.id(element) });
                    }
                    break Message::Failed(text);
                }
            }
            if STEP {
                steps -= 1;
                if steps == 0 {
                    *place = Place { at, noted, steps };
                    return Ok(Outcome::Applied { result: None });
                }
            }
        };
        self.preview.undo(mesh);
        let at = at.saturating_sub(1);
        let trap = Trap { about: self.about(&call, at), ..Trap::new(message) };
        Err(trap.through_all(&call, at, &returns))
    }

    /// Copies slots from a register of one window to the start of another window, for which it
    /// makes room.
    pub(super) fn pass(&mut self, base: usize, from: Reg, to: usize, width: u16) {
        reserve(&mut self.stack, to);
        let start = base + usize::from(from.0);
        let end = self.stack.len().min(start + usize::from(width));
        // For a few slots, a loop is faster than the call of `copy_within`.
        match end.saturating_sub(start) {
            few @ 0..=4 => {
                (0..few).for_each(|part| self.stack[to + part] = self.stack[start + part])
            }
            _ => self.stack.copy_within(start..end, to),
        }
    }

    pub(super) fn clear_buffers(&mut self, call: &super::Call<'_>) {
        let end = call.buffers + usize::from(call.code.buffers);
        if self.buffers.len() < end {
            self.buffers.resize_with(end, List::default);
        }
        self.buffers[call.buffers..end].iter_mut().for_each(List::clear);
    }
}
