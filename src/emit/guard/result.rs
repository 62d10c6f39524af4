//! The mesh as the rewrite would leave it, read from the mesh as it is.
//!
//! A halfedge without a name keeps its `next` (but for the ends of paths) and its `twin`. Its
//! `vertex` changes if it lies in a fan that moves, its `face` if it lies on a path that moves.
//! Where all undrawn spokes of a vertex move together, comparing the vertex tells; so it is with
//! the paths of a face.

use super::super::NotEmitted;
use super::super::names::Names;
use super::super::routine::{Step, Walk};
use super::super::term::Term;
use super::super::walks::along_spokes;
use crate::diagram::{Drawing, Kind, LoopKind, NameId, Pointer, Spoke};

/// What can be told of the result.
pub(super) struct Outcome<'d> {
    drawing: &'d Drawing<'d>,
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
    pub fn walk(&self, drawing: &Drawing, names: &Names, halfedge: String) -> Walk {
        let whole = |vertex: NameId, halfedge: String| {
            let first = names.term(vertex).follow(Pointer::VertexHalfedge);
            Walk {
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

impl<'d> Outcome<'d> {
    pub fn new(drawing: &'d Drawing<'d>) -> Self {
        Self { drawing }
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

    /// Where each run of undrawn spokes of a vertex of `before` goes, by its place in the
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

    /// The vertices whose undrawn spokes all go to another one, and which that is.
    pub fn moves(&self) -> Result<Vec<(NameId, NameId)>, NotEmitted> {
        let mut moves = Vec::new();
        for source in self.drawing.rule.names_of(Kind::Vertex) {
            let runs = self.runs(source).unwrap_or_default();
            let Some(&(_, to)) = runs.iter().find(|(_, to)| *to != source) else {
                continue;
            };
            if runs.iter().any(|&(_, other)| other != to) {
                return Err(self.parted(source));
            }
            if self.is_new(to) {
                return Err(self.too_new(to));
            }
            moves.push((source, to));
        }
        Ok(moves)
    }

    fn parted(&self, vertex: NameId) -> NotEmitted {
        let rule = self.drawing.rule;
        let span = rule.guard.map_or(rule.span, |(_, span)| span);
        NotEmitted::new(
            format!(
                "a guard that follows the spokes of {} to several vertices",
                rule.quoted(vertex)
            ),
            span,
        )
    }

    /// A test would have to compare an element that there is not yet.
    pub fn too_new(&self, name: NameId) -> NotEmitted {
        let rule = self.drawing.rule;
        let span = rule.guard.map_or(rule.span, |(_, span)| span);
        NotEmitted::new(
            format!(
                "a guard that compares the new {} with what is there",
                rule.quoted(name)
            ),
            span,
        )
    }

    /// Where a halfedge that no loop of `after` draws will start.
    pub fn origin(&self, names: &Names, half: Term) -> Result<Term, NotEmitted> {
        let vertex = half.follow(Pointer::Vertex);
        let moves = self.moves()?;
        Ok(moves.into_iter().fold(vertex.clone(), |term, (from, to)| {
            let moved = vertex.clone().is(names.term(from));
            moved.then(names.term(to), term)
        }))
    }

    /// Where an undrawn spoke will end: where its twin starts. The twin can be drawn.
    pub fn end(&self, names: &Names, spoke: Term) -> Result<Term, NotEmitted> {
        let drawing = self.drawing;
        let twin = spoke.follow(Pointer::Twin);
        let mut term = self.origin(names, twin.clone())?;
        let moves = self.moves()?;
        for half in drawing.rule.names_of(Kind::Halfedge) {
            let twin_is_undrawn = drawing.before.loop_of_item(half).is_some()
                && drawing.before.pairing(half).is_none();
            let (Some(before), Some(after)) =
                (drawing.origin_before(half), drawing.origin_after(half))
            else {
                continue;
            };
            let moved = moves.iter().find(|(from, _)| *from == before);
            if !twin_is_undrawn || moved.map_or(before, |&(_, to)| to) == after {
                continue;
            }
            if self.is_new(after) {
                return Err(self.too_new(after));
            }
            let is_it = twin.clone().is(names.term(half));
            term = is_it.then(names.term(after), term);
        }
        Ok(term)
    }

    /// For each face of `before` with paths, the loop of `after` that they go to.
    fn homes(&self) -> Result<Vec<(NameId, NameId)>, NotEmitted> {
        let drawing = self.drawing;
        let mut homes = Vec::new();
        for orbit in &drawing.rule.before.loops {
            let items = orbit.items.iter().map(|item| item.item.name);
            let mut paths = items.filter(|&item| self.is_path(item));
            let home = |path: NameId| drawing.after.face(path);
            let Some(first) = paths.next().and_then(home) else {
                continue;
            };
            if paths.any(|path| home(path) != Some(first)) {
                let rule = drawing.rule;
                let span = rule.guard.map_or(rule.span, |(_, span)| span);
                let face = rule.quoted(orbit.face.name);
                let what = format!("a guard that follows the paths of {face} to several faces");
                return Err(NotEmitted::new(what, span));
            }
            homes.push((orbit.face.name, first));
        }
        Ok(homes)
    }

    /// The face of a halfedge that is not drawn in a loop.
    pub fn face(&self, names: &Names, half: Term) -> Result<Term, NotEmitted> {
        let face = half.follow(Pointer::Face);
        let mut term = face.clone();
        for (from, to) in self.homes()?.into_iter().filter(|(from, to)| from != to) {
            if self.is_new(to) {
                return Err(self.too_new(to));
            }
            let moved = face.clone().is(names.term(from));
            term = moved.then(names.term(to), term);
        }
        Ok(term)
    }

    /// Whether a halfedge that is not drawn in a loop will lie in a hole.
    pub fn hole(&self, names: &Names, half: Term) -> Result<Term, NotEmitted> {
        let drawing = self.drawing;
        let face = half.follow(Pointer::Face);
        let mut term = face.clone().hole();
        for (from, to) in self.homes()? {
            let kind = |orbit: Option<&crate::diagram::Loop>| orbit.map(|orbit| orbit.kind);
            let (before, after) = (
                kind(drawing.before.loop_of_face(from)),
                kind(drawing.after.loop_of_face(to)),
            );
            let same = before == after && (before != Some(LoopKind::Any) || from == to);
            if same {
                continue;
            }
            let holds = match after {
                Some(LoopKind::Hole) => Term::Bool(true),
                Some(LoopKind::Face) => Term::Bool(false),
                _ => names.term(to).hole(),
            };
            let moved = face.clone().is(names.term(from));
            term = match holds {
                Term::Bool(true) => moved.or(term),
                Term::Bool(false) => moved.not().and(term),
                holds => moved.then(holds, term),
            };
        }
        Ok(term)
    }

    /// Whether no spoke moves, and no drawn edge of `before` joins two vertices that stay: then
    /// an edge between them is one that is not drawn.
    pub fn is_only_undrawn(&self, v: NameId, w: NameId) -> bool {
        let drawing = self.drawing;
        let stay = drawing.survives(v) && drawing.survives(w);
        let nothing_moves = self.moves().is_ok_and(|moves| moves.is_empty());
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
