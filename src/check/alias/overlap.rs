//! The ways in which two statements can describe one loop.
//!
//! Both go around the same cycle, so each halfedge of one is a halfedge of the other or lies on
//! one of its paths, and where two paths run side by side they share a piece:
//!
//! ```text
//!   a P          with P all but a             a s d t
//!   d Q          with Q all but d       =>    P is s d t,  Q is t a s
//! ```

use std::collections::BTreeSet;

use crate::diagram::{Kind, Loop, LoopItem, Name, NameId, Ref, Role, Rule};

/// One way in which two statements can describe one loop.
#[derive(Clone, Debug)]
pub(super) struct Overlap {
    /// The loop.
    pub items: Vec<LoopItem>,
    /// The names of the pieces, which follow those of the rule.
    pub pieces: Vec<Name>,
    /// For each path, its pieces and halfedges, in order.
    pub runs: Vec<(NameId, Vec<LoopItem>)>,
    /// The names that are one: halfedges, and vertices where both statements have a border.
    pub same: Vec<[NameId; 2]>,
}

/// The greatest number of ways that are examined.
const MOST: usize = 200;

/// All ways in which two loops can be one; `None` if nothing says where one begins in the
/// other, or there are too many.
pub(super) fn overlaps(rule: &Rule, one: &Loop, other: &Loop) -> Option<Vec<Overlap>> {
    let is_path = |item: &LoopItem| rule.kind(item.item.name) == Kind::Path;
    let (left, right) = if one.items.iter().all(is_path) { (other, one) } else { (one, other) };
    let anchor = left.items.iter().position(|item| !is_path(item))?;
    let count = left.items.len();
    let left: Vec<_> = (0..count).map(|at| left.items[(anchor + at) % count]).collect();
    let mut found = Vec::new();
    let count = right.items.len();
    for begin in 0..count {
        let item = right.items[begin];
        let others = (1..count).map(|at| Part::whole(right.items[(begin + at) % count]));
        let mut search = Search {
            rule,
            left: left[1..].iter().map(|&item| Part::whole(item)).collect(),
            right: Vec::new(),
            state: State::default(),
            found: Vec::new(),
        };
        search.state.items.push(left[0]);
        if is_path(&item) {
            let tail = Part { item, is_tail: true, is_head: false };
            let head = Part { is_tail: false, is_head: true, ..tail };
            search.right.push(tail);
            search.right.extend(others);
            search.right.push(head);
            search.state.inside[1] = true;
            search.state.tail.push(left[0]);
        } else {
            search.right.extend(others);
            let [x, y] = [left[0], item];
            search.state.same.push([x.item.name, y.item.name]);
            search.state.same.push([x.from.name, y.from.name]);
        }
        search.step();
        found.extend(search.found);
        if found.len() > MOST {
            return None;
        }
    }
    let mut seen = BTreeSet::new();
    found.retain(|overlap| {
        let mut key: Vec<[u32; 2]> = Vec::new();
        for (path, items) in &overlap.runs {
            key.push([u32::MAX, path.0]);
            key.extend(items.iter().map(|item| [item.item.name.0, item.from.name.0]));
        }
        key.extend(overlap.same.iter().map(|pair| pair.map(|name| name.0)));
        seen.insert(key)
    });
    Some(found)
}

/// An item of a loop, or the part of a path before or behind the place where reading begins.
#[derive(Clone, Copy)]
struct Part {
    item: LoopItem,
    is_tail: bool,
    is_head: bool,
}

impl Part {
    fn whole(item: LoopItem) -> Self {
        Self { item, is_tail: false, is_head: false }
    }
}

/// The state of reading both loops, and what has been found.
#[derive(Clone, Default)]
struct State {
    at: [usize; 2],
    /// True if the path that is read has begun.
    inside: [bool; 2],
    items: Vec<LoopItem>,
    pieces: usize,
    /// The items so far of the path that is read.
    open: [Vec<LoopItem>; 2],
    /// The items that were read first, if reading began inside a path: they are its end.
    tail: Vec<LoopItem>,
    runs: Vec<(NameId, Vec<LoopItem>)>,
    same: Vec<[NameId; 2]>,
}

struct Search<'a> {
    rule: &'a Rule,
    left: Vec<Part>,
    right: Vec<Part>,
    state: State,
    found: Vec<Overlap>,
}

impl Search<'_> {
    fn part(&self, side: usize) -> Option<Part> {
        let parts = [&self.left, &self.right][side];
        parts.get(self.state.at[side]).copied()
    }

    fn is_run(&self, part: Part) -> bool {
        self.rule.kind(part.item.item.name) == Kind::Path
    }

    /// The origin of the next item of both, if a statement has a border here.
    fn from(&mut self) -> Option<Ref> {
        let border = |side: usize| {
            let part = self.part(side)?;
            (!self.state.inside[side]).then_some(part.item.from)
        };
        match [border(0), border(1)] {
            [Some(x), Some(y)] => {
                self.state.same.push([x.name, y.name]);
                Some(x)
            }
            [x, y] => x.or(y),
        }
    }

    fn then(&mut self, change: impl FnOnce(&mut Self)) {
        let state = self.state.clone();
        change(self);
        self.step();
        self.state = state;
    }

    /// Continues in every possible way.
    fn step(&mut self) {
        if self.found.len() > MOST {
            return;
        }
        let (left, right) = (self.part(0), self.part(1));
        let runs = [left, right].map(|part| part.is_some_and(|part| self.is_run(part)));
        match (left, right) {
            (None, None) => return self.end(),
            (Some(x), Some(y)) if runs == [false, false] => self.then(|this| {
                if let Some(from) = this.from() {
                    let [x, y] = [x.item.item, y.item.item];
                    this.state.same.push([x.name, y.name]);
                    this.state.items.push(LoopItem { from, item: x });
                    this.state.at[0] += 1;
                    this.state.at[1] += 1;
                }
            }),
            (Some(_), Some(_)) if runs == [true, true] && self.state.inside != [true, true] => {
                self.then(Self::share_a_piece);
            }
            _ => {}
        }
        for (run, half) in [(0, 1), (1, 0)] {
            let halfedge = [left, right][half].filter(|_| !runs[half]);
            if let (true, Some(part)) = (runs[run], halfedge) {
                self.then(|this| {
                    if let Some(from) = this.from() {
                        let item = LoopItem { from, ..part.item };
                        this.state.items.push(item);
                        this.state.open[run].push(item);
                        this.state.inside[run] = true;
                        this.state.at[half] += 1;
                    }
                });
            }
        }
        for side in [0, 1] {
            // A path that shares nothing with another one is empty only where none begins.
            let begun = self.state.inside[side] || !runs[1 - side];
            if runs[side] && begun {
                self.then(|this| this.end_run(side));
            }
        }
    }

    fn share_a_piece(&mut self) {
        let Some(from) = self.from() else { return };
        let number = self.rule.names.len() + self.state.pieces;
        let span = self.left[self.state.at[0]].item.item.span;
        let item = Ref::plain(NameId(number as u32), span);
        let piece = LoopItem { from, item };
        self.state.pieces += 1;
        self.state.items.push(piece);
        for side in [0, 1] {
            self.state.open[side].push(piece);
            self.state.inside[side] = true;
        }
    }

    fn end_run(&mut self, side: usize) {
        let Some(part) = self.part(side) else { return };
        if !self.state.inside[side] {
            // What follows an empty path starts where it does.
            let parts = [&self.left, &self.right][side];
            let next = parts.get(self.state.at[side] + 1).map(|next| next.item.from);
            let next = next.unwrap_or(self.state.items[0].from);
            self.state.same.push([part.item.from.name, next.name]);
            self.from();
        }
        let items = std::mem::take(&mut self.state.open[side]);
        self.state.inside[side] = false;
        self.state.at[side] += 1;
        if part.is_tail {
            self.state.tail.extend(items);
        } else if part.is_head {
            let tail = std::mem::take(&mut self.state.tail);
            let whole = items.into_iter().chain(tail).collect();
            self.state.runs.push((part.item.item.name, whole));
        } else {
            self.state.runs.push((part.item.item.name, items));
        }
    }

    fn end(&mut self) {
        let State { items, pieces, runs, same, .. } = self.state.clone();
        let span = items[0].item.span;
        let pieces = (0..pieces).map(|_| Name {
            text: "a piece of a path".into(),
            kind: Kind::Path,
            named: false,
            role: Role::Single,
            span,
        });
        self.found.push(Overlap { items, pieces: pieces.collect(), runs, same });
    }
}
