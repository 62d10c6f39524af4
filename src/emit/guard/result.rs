//! The mesh as the rewrite would leave it, read from the mesh as it is.
//!
//! A halfedge without a name keeps its `next` (but for the ends of paths) and its `twin`. Its
//! `vertex` changes if it lies in a fan that moves, its `face` if it lies on a path that moves.
//! Where all undrawn spokes of a vertex move together, comparing the vertex tells; so it is with
//! the paths of a face. Those that part are listed first, and looked up.

use std::cell::Cell;

use super::super::names::Names;
use super::super::routine::{HalfedgeWalk, Statement, Step};
use super::super::term::{Function, Term};
use super::super::walks::{along_path, along_spokes};
use crate::diagram::{Drawing, Kind, LoopKind, NameId, Pointer, Spoke, Type};

/// The failure of walks over pieces of the mesh as it is: they cannot tell of the result.
pub(super) struct Untold;

/// The result of an operation, as far as it can be told.
pub(super) struct Outcome<'d> {
    drawing: &'d Drawing<'d>,
    /// The runs of spokes and the paths whose orbit parts.
    parted: Vec<Parted>,
}

/// Undrawn halfedges that do not go where others of their orbit go.
struct Parted {
    which: Run,
    /// The list that they stand in, and whether anything asks for it.
    list: String,
    is_asked: Cell<bool>,
}

/// Undrawn halfedges that stay together.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Run {
    /// Spokes, by their place in the statement of a vertex of `before`.
    Spokes(NameId, usize),
    Path(NameId),
}

/// Undrawn halfedges, and the vertex or face of `after` that they go to.
pub(super) struct Move {
    /// The vertex or face of `before` that they leave.
    from: NameId,
    /// Which of it; all of them if there is nothing else to tell.
    run: Option<Run>,
    to: NameId,
}

/// Spokes without a name that stay together.
#[derive(Clone, Debug)]
pub(super) enum Piece {
    /// All of a vertex of `before`.
    Star(NameId),
    /// Those at one place of its statement.
    Run { vertex: NameId, at: usize },
}

impl Piece {
    /// A walk over it; over a star it meets the drawn spokes too.
    pub fn walk(&self, drawing: &Drawing, names: &Names, halfedge: String) -> HalfedgeWalk {
        let whole = |vertex: NameId, halfedge: String| {
            let first = names.term(vertex).follow(Pointer::VertexHalfedge);
            HalfedgeWalk {
                halfedge,
                step: Step::Clockwise,
                from: first.clone(),
                until: first,
                around: true,
            }
        };
        match *self {
            Self::Star(vertex) => whole(vertex, halfedge),
            Self::Run { vertex, at } => match drawing.before.star(vertex) {
                Some(star) => along_spokes(drawing, names, vertex, (&star.spokes, at), halfedge),
                None => whole(vertex, halfedge),
            },
        }
    }
}

/// The vertex or face that a halfedge will have.
pub(super) struct FutureElement {
    /// The new ones that it may be, and when it is. No two hold at once.
    pub new: Vec<(Term, NameId)>,
    /// The value where none of them holds.
    pub other: Term,
}

impl FutureElement {
    /// It is another where a condition holds.
    fn unless(&mut self, condition: Term, is_new: bool, to: (NameId, Term)) {
        for (when, _) in &mut self.new {
            *when = condition.clone().not().and(when.clone());
        }
        if is_new {
            self.new.push((condition, to.0));
        } else {
            let other = std::mem::replace(&mut self.other, Term::Bool(false));
            self.other = condition.then(to.1, other);
        }
    }

    /// The condition that it is none of the new ones.
    pub fn is_known(&self) -> Option<Term> {
        let conditions = self.new.iter().map(|(when, _)| when.clone().not());
        conditions.reduce(Term::and)
    }

    /// The condition that it is an element, `term` if it is there already.
    pub fn is(self, element: NameId, term: Option<Term>) -> Term {
        match term {
            Some(term) => {
                let is = self.other.clone().is(term);
                self.is_known().into_iter().fold(is, |is, known| known.and(is))
            }
            None => {
                let new = self.new.into_iter().filter(|(_, to)| *to == element);
                let conditions = new.map(|(when, _)| when);
                conditions.reduce(Term::or).unwrap_or(Term::Bool(false))
            }
        }
    }
}

impl<'d> Outcome<'d> {
    pub fn new(drawing: &'d Drawing<'d>, names: &mut Names) -> Self {
        let mut outcome = Self { drawing, parted: Vec::new() };
        let mut moves = outcome.moves();
        moves.extend(outcome.homes());
        // Those that hardly anything asks for come last, so that names have no gaps.
        moves.sort_by_key(|one| one.from == one.to);
        let runs: Vec<_> = moves.iter().filter_map(|one| one.run).collect();
        for which in runs {
            let wanted = match which {
                Run::Spokes(..) => "leaving",
                Run::Path(_) => "along",
            };
            outcome.parted.push(Parted {
                which,
                list: names.fresh(wanted),
                is_asked: Cell::new(false),
            });
        }
        outcome
    }

    /// Makes the lists that anything asked for.
    pub fn lists(&self, names: &mut Names) -> Vec<Statement> {
        let mut body = Vec::new();
        for parted in self.parted.iter().filter(|parted| parted.is_asked.get()) {
            let halfedge = names.fresh("h");
            names.release(&halfedge);
            let walk = match parted.which {
                Run::Spokes(vertex, at) => {
                    let piece = Piece::Run { vertex, at };
                    Some(piece.walk(self.drawing, names, halfedge.clone()))
                }
                Run::Path(path) => along_path(self.drawing, names, path, halfedge.clone()),
            };
            body.push(Statement::List {
                ty: Type::Halfedge,
                name: parted.list.clone(),
                items: Vec::new(),
            });
            body.extend(walk.map(|walk| Statement::Walk {
                walk,
                body: vec![Statement::Push {
                    list: parted.list.clone(),
                    item: Term::name(halfedge),
                }],
            }));
        }
        body
    }

    /// The condition that a halfedge is one of those that move, `at` being its vertex or face.
    fn moved(&self, names: &Names, one: &Move, half: &Term, at: &Term) -> Term {
        let list = self.parted.iter().find(|parted| Some(parted.which) == one.run);
        match list {
            Some(parted) => {
                parted.is_asked.set(true);
                let holds = vec![Term::name(&parted.list), half.clone()];
                Term::Call(Function::Holds, holds)
            }
            None => at.clone().is(names.term(one.from)),
        }
    }

    pub fn is_new(&self, name: NameId) -> bool {
        self.drawing.created(name).is_some()
    }

    pub fn is_path(&self, item: NameId) -> bool {
        self.drawing.rule.kind(item) == Kind::Path
    }

    /// The drawn spokes of a vertex of `before`.
    pub fn spokes_before(&self, vertex: NameId) -> Vec<NameId> {
        let drawing = self.drawing;
        let halfedges = drawing.rule.names_of(Kind::Halfedge);
        halfedges
            .filter(|&half| drawing.before.mention(half).is_some())
            .filter(|&half| drawing.origin_before(half) == Some(vertex))
            .collect()
    }

    /// The drawn spokes of a vertex of `after`.
    pub fn spokes_after(&self, vertex: NameId) -> Vec<NameId> {
        let drawing = self.drawing;
        let halfedges = drawing.rule.names_of(Kind::Halfedge);
        halfedges
            .filter(|&half| drawing.after.mention(half).is_some() && drawing.erased(half).is_none())
            .filter(|&half| drawing.origin_after(half) == Some(vertex))
            .collect()
    }

    /// The places to which runs of undrawn spokes of a vertex of `before` goes, by its place in the
    /// statement; `None` if it has no statement: all of them stay.
    fn runs(&self, vertex: NameId) -> Option<Vec<(usize, NameId)>> {
        let star = self.drawing.before.star(vertex)?;
        let spokes = star.spokes.iter().enumerate();
        let runs = spokes.filter_map(|(at, spoke)| match spoke {
            Spoke::Halfedge(_) => None,
            Spoke::Rest(_) => Some((at, vertex)),
            Spoke::Fan(fan) => {
                let to = self.drawing.after.star_of_spoke(fan.name);
                Some((at, to.unwrap_or(vertex)))
            }
        });
        Some(runs.collect())
    }

    /// The undrawn spokes of a vertex of `after`.
    pub fn pieces(&self, vertex: NameId) -> Vec<Piece> {
        let drawing = self.drawing;
        let mut pieces = Vec::new();
        for source in drawing.rule.names_of(Kind::Vertex) {
            if drawing.before.mention(source).is_none() {
                continue;
            }
            match self.runs(source) {
                None if source == vertex && drawing.survives(vertex) => {
                    pieces.push(Piece::Star(vertex));
                }
                None => {}
                Some(runs) => {
                    let here = runs.iter().filter(|(_, to)| *to == vertex);
                    let count = here.clone().count();
                    if count == runs.len() && count > 0 {
                        pieces.push(Piece::Star(source));
                    } else {
                        pieces.extend(here.map(|&(at, _)| Piece::Run { vertex: source, at }));
                    }
                }
            }
        }
        pieces
    }

    /// The undrawn spokes that go to another vertex.
    fn moves(&self) -> Vec<Move> {
        let mut moves = Vec::new();
        for from in self.drawing.rule.names_of(Kind::Vertex) {
            let runs = self.runs(from).unwrap_or_default();
            let part = runs.iter().any(|(_, to)| *to != runs[0].1);
            let count = if part { runs.len() } else { 1 };
            for &(at, to) in runs.iter().take(count).filter(|(_, to)| *to != from) {
                let run = part.then_some(Run::Spokes(from, at));
                moves.push(Move { from, run, to });
            }
        }
        moves
    }

    /// The value that a halfedge will have instead of what it has: as moves tell.
    fn told(&self, names: &Names, half: &Term, at: Pointer, moves: Vec<Move>) -> FutureElement {
        let has = half.clone().follow(at);
        let mut told = FutureElement { new: Vec::new(), other: has.clone() };
        for one in moves.into_iter().filter(|one| one.from != one.to) {
            let moved = self.moved(names, &one, half, &has);
            told.unless(moved, self.is_new(one.to), (one.to, names.term(one.to)));
        }
        told
    }

    /// The start of a halfedge that no loop of `after` draws will start.
    pub fn origin(&self, names: &Names, half: Term) -> FutureElement {
        self.told(names, &half, Pointer::Vertex, self.moves())
    }

    /// The same, if it can be compared with any other: no new vertex is there to compare with.
    pub fn known_origin(&self, names: &Names, half: Term) -> Result<Term, Untold> {
        let told = self.origin(names, half);
        match told.new.is_empty() {
            true => Ok(told.other),
            false => Err(Untold),
        }
    }

    /// The end of an undrawn spoke: where its twin starts. The twin can be drawn.
    pub fn end(&self, names: &Names, spoke: Term) -> FutureElement {
        let drawing = self.drawing;
        let twin = spoke.follow(Pointer::Twin);
        let mut told = self.origin(names, twin.clone());
        let moves = self.moves();
        for half in drawing.rule.names_of(Kind::Halfedge) {
            let twin_is_undrawn = drawing.before.loop_of_item(half).is_some()
                && drawing.before.pairing(half).is_none();
            let (Some(before), Some(after)) =
                (drawing.origin_before(half), drawing.origin_after(half))
            else {
                continue;
            };
            // Those of a run are not drawn.
            let mut whole = moves.iter().filter(|one| one.run.is_none());
            let moved = whole.find(|one| one.from == before);
            if !twin_is_undrawn || moved.map_or(before, |one| one.to) == after {
                continue;
            }
            let is_it = twin.clone().is(names.term(half));
            told.unless(is_it, self.is_new(after), (after, names.term(after)));
        }
        told
    }

    /// The paths, and the loops of `after` that they go to.
    fn homes(&self) -> Vec<Move> {
        let mut homes = Vec::new();
        for orbit in &self.drawing.rule.before.loops {
            let from = orbit.face.name;
            let items = orbit.items.iter().map(|item| item.item.name);
            let paths = items.filter(|&item| self.is_path(item));
            let paths: Vec<_> =
                paths.filter_map(|path| Some((path, self.drawing.after.face(path)?))).collect();
            let part = paths.iter().any(|(_, to)| *to != paths[0].1);
            let count = if part { paths.len() } else { 1 };
            homes.extend(paths.into_iter().take(count).map(|(path, to)| Move {
                from,
                run: part.then_some(Run::Path(path)),
                to,
            }));
        }
        homes
    }

    /// The face of a halfedge that is not drawn in a loop.
    pub fn face(&self, names: &Names, half: Term) -> FutureElement {
        self.told(names, &half, Pointer::Face, self.homes())
    }

    /// The condition that a halfedge that is not drawn in a loop will lie in a hole.
    pub fn hole(&self, names: &Names, half: Term) -> Term {
        let drawing = self.drawing;
        let face = half.clone().follow(Pointer::Face);
        let mut term = face.clone().hole();
        for one in self.homes() {
            let Move { from, to, .. } = one;
            let kind = |orbit: Option<&crate::diagram::Loop>| orbit.map(|orbit| orbit.kind);
            let (before, after) =
                (kind(drawing.before.loop_of_face(from)), kind(drawing.after.loop_of_face(to)));
            let same = before == after && (before != Some(LoopKind::Any) || from == to);
            if same {
                continue;
            }
            let holds = match after {
                Some(LoopKind::Hole) => Term::Bool(true),
                Some(LoopKind::Face) => Term::Bool(false),
                _ => names.term(to).hole(),
            };
            let moved = self.moved(names, &one, &half, &face);
            term = match holds {
                Term::Bool(true) => moved.or(term),
                Term::Bool(false) => moved.not().and(term),
                holds => moved.then(holds, term),
            };
        }
        term
    }

    /// True if no spoke moves, and no drawn edge of `before` joins two vertices that stay: then an
    /// edge between them is one that is not drawn.
    pub fn is_only_undrawn(&self, v: NameId, w: NameId) -> bool {
        let drawing = self.drawing;
        let stay = drawing.survives(v) && drawing.survives(w);
        let nothing_moves = self.moves().is_empty();
        let halfedges = || {
            let halfedges = drawing.rule.names_of(Kind::Halfedge);
            halfedges.filter(|&half| drawing.before.mention(half).is_some())
        };
        let origins_stay = halfedges().all(|half| {
            drawing.before.pairing(half).is_some()
                || drawing.origin_before(half) == drawing.origin_after(half)
        });
        let mut ends =
            halfedges().map(|half| (drawing.origin_before(half), drawing.target_before(half)));
        let drawn = ends.any(|ends| ends == (Some(v), Some(w)) || ends == (Some(w), Some(v)));
        stay && nothing_moves && origins_stay && !drawn
    }
}
